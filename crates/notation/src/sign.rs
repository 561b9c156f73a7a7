//! The table of signs: each with its LaTeX command and its words.

use super::Class;
use super::Class::{Binary, Closing, Large, Opening, Ordinary, Punctuation, Relation};

/// A sign that has a command.
pub struct Sign {
    /// The character.
    pub char: char,
    /// What it is to its neighbours; a letter among the signs is `Ordinary`.
    pub class: Class,
    /// Its LaTeX, a command or the character itself.
    pub latex: &'static str,
    /// How it is read aloud.
    pub words: &'static str,
}

impl Sign {
    /// The sign of a character.
    pub fn of(char: char) -> Option<&'static Self> {
        // Most of what is looked up is none: letters and digits of formulas.
        let mut signs = SIGNS.iter().filter(|_| !char.is_ascii_alphanumeric());
        signs.find(|sign| sign.char == char)
    }
}

const fn sign(char: char, class: Class, latex: &'static str, words: &'static str) -> Sign {
    Sign {
        char,
        class,
        latex,
        words,
    }
}

/// Signs other than Greek letters, the frequent ones first.
pub const SIGNS: &[Sign] = &[
    sign('=', Relation, "=", "equals"),
    sign('+', Binary, "+", "plus"),
    sign('−', Binary, "-", "minus"),
    sign('⋅', Binary, r"\cdot", "times"),
    sign('(', Opening, "(", "open paren"),
    sign(')', Closing, ")", "close paren"),
    sign(',', Punctuation, ",", "comma"),
    sign('′', Ordinary, r"\prime", "prime"),
    sign('/', Ordinary, "/", "over"),
    sign('×', Binary, r"\times", "times"),
    sign('[', Opening, "[", "open bracket"),
    sign(']', Closing, "]", "close bracket"),
    sign('{', Opening, r"\{", "open brace"),
    sign('}', Closing, r"\}", "close brace"),
    sign('<', Relation, "<", "is less than"),
    sign('>', Relation, ">", "is greater than"),
    sign('≤', Relation, r"\le", "is at most"),
    sign('≥', Relation, r"\ge", "is at least"),
    sign('≠', Relation, r"\ne", "is not equal to"),
    sign('≈', Relation, r"\approx", "is approximately"),
    sign('|', Ordinary, "|", "bar"),
    sign(';', Punctuation, ";", "semicolon"),
    sign(':', Relation, ":", "colon"),
    sign('.', Ordinary, ".", "point"),
    sign('!', Ordinary, "!", "factorial"),
    sign('?', Ordinary, "?", "question mark"),
    sign('∗', Binary, "*", "star"),
    sign('±', Binary, r"\pm", "plus or minus"),
    sign('∓', Binary, r"\mp", "minus or plus"),
    sign('÷', Binary, r"\div", "divided by"),
    sign('∘', Binary, r"\circ", "composed with"),
    sign('°', Ordinary, r"{}^\circ", "degrees"),
    sign('∞', Ordinary, r"\infty", "infinity"),
    sign('∂', Ordinary, r"\partial", "partial"),
    sign('∇', Ordinary, r"\nabla", "nabla"),
    sign('ℓ', Ordinary, r"\ell", "ell"),
    sign('ℏ', Ordinary, r"\hbar", "h bar"),
    sign('ı', Ordinary, r"\imath", "i"),
    sign('ȷ', Ordinary, r"\jmath", "j"),
    sign('ℜ', Ordinary, r"\Re", "real part"),
    sign('ℑ', Ordinary, r"\Im", "imaginary part"),
    sign('≡', Relation, r"\equiv", "is identical to"),
    sign('∼', Relation, r"\sim", "is similar to"),
    sign('≃', Relation, r"\simeq", "is asymptotically equal to"),
    sign('≅', Relation, r"\cong", "is congruent to"),
    sign('∝', Relation, r"\propto", "is proportional to"),
    sign('≪', Relation, r"\ll", "is much less than"),
    sign('≫', Relation, r"\gg", "is much greater than"),
    sign('≔', Relation, r"\coloneqq", "is defined as"),
    sign('≐', Relation, r"\doteq", "equals approximately"),
    sign('≲', Relation, r"\lesssim", "is less than about"),
    sign('≳', Relation, r"\gtrsim", "is greater than about"),
    sign('→', Relation, r"\to", "to"),
    sign('←', Relation, r"\leftarrow", "left arrow"),
    sign('↔', Relation, r"\leftrightarrow", "left right arrow"),
    sign('⇒', Relation, r"\Rightarrow", "implies"),
    sign('⇐', Relation, r"\Leftarrow", "is implied by"),
    sign('⇔', Relation, r"\Leftrightarrow", "if and only if"),
    sign('⟶', Relation, r"\longrightarrow", "to"),
    sign('⟹', Relation, r"\implies", "implies"),
    sign('⟺', Relation, r"\iff", "if and only if"),
    sign('↦', Relation, r"\mapsto", "maps to"),
    sign('↑', Relation, r"\uparrow", "up arrow"),
    sign('↓', Relation, r"\downarrow", "down arrow"),
    sign('⇌', Relation, r"\rightleftharpoons", "in equilibrium with"),
    sign('∈', Relation, r"\in", "in"),
    sign('∉', Relation, r"\notin", "not in"),
    sign('∋', Relation, r"\ni", "contains"),
    sign('⊂', Relation, r"\subset", "is a subset of"),
    sign('⊆', Relation, r"\subseteq", "is a subset of or equals"),
    sign('∪', Binary, r"\cup", "union"),
    sign('∩', Binary, r"\cap", "intersection"),
    sign('∖', Binary, r"\setminus", "without"),
    sign('∧', Binary, r"\wedge", "and"),
    sign('∨', Binary, r"\vee", "or"),
    sign('¬', Ordinary, r"\neg", "not"),
    sign('∀', Ordinary, r"\forall", "for all"),
    sign('∃', Ordinary, r"\exists", "there is"),
    sign('∅', Ordinary, r"\emptyset", "the empty set"),
    sign('∴', Relation, r"\therefore", "therefore"),
    sign('∵', Relation, r"\because", "because"),
    sign('⊥', Ordinary, r"\bot", "perpendicular"),
    sign('⟂', Relation, r"\perp", "is perpendicular to"),
    sign('∥', Relation, r"\parallel", "is parallel to"),
    sign('∣', Relation, r"\mid", "such that"),
    sign('∠', Ordinary, r"\angle", "angle"),
    sign('⊕', Binary, r"\oplus", "circled plus"),
    sign('⊗', Binary, r"\otimes", "tensor product"),
    sign('⋆', Binary, r"\star", "star"),
    sign('†', Ordinary, r"\dagger", "dagger"),
    sign('…', Ordinary, r"\ldots", "and so on"),
    sign('⋯', Ordinary, r"\cdots", "and so on"),
    sign('⋮', Ordinary, r"\vdots", "and so on"),
    sign('⋱', Ordinary, r"\ddots", "and so on"),
    sign('△', Ordinary, r"\triangle", "triangle"),
    sign('□', Ordinary, r"\square", "blank"),
    sign('∙', Binary, r"\bullet", "bullet"),
    sign('⟨', Opening, r"\langle", "open angle bracket"),
    sign('⟩', Closing, r"\rangle", "close angle bracket"),
    sign('⌊', Opening, r"\lfloor", "open floor"),
    sign('⌋', Closing, r"\rfloor", "close floor"),
    sign('⌈', Opening, r"\lceil", "open ceiling"),
    sign('⌉', Closing, r"\rceil", "close ceiling"),
    sign('‖', Ordinary, r"\|", "double bar"),
    sign('∑', Large, r"\sum", "the sum"),
    sign('∏', Large, r"\prod", "the product"),
    sign('∫', Large, r"\int", "the integral"),
    sign('∬', Large, r"\iint", "the double integral"),
    sign('∭', Large, r"\iiint", "the triple integral"),
    sign('∮', Large, r"\oint", "the contour integral"),
    sign('⋃', Large, r"\bigcup", "the union"),
    sign('⋂', Large, r"\bigcap", "the intersection"),
    sign('%', Ordinary, r"\%", "percent"),
    sign('&', Ordinary, r"\&", "and"),
    sign('#', Ordinary, r"\#", "number"),
    sign('$', Ordinary, r"\$", "dollar"),
    sign('_', Ordinary, r"\_", "underscore"),
];

/// Greek letters by the name of their LaTeX command.
pub const GREEK: &[(&str, char)] = &[
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ϵ'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'ϕ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("varepsilon", 'ε'),
    ("vartheta", 'ϑ'),
    ("varkappa", 'ϰ'),
    ("varrho", 'ϱ'),
    ("varsigma", 'ς'),
    ("varphi", 'φ'),
    ("varpi", 'ϖ'),
    // A letter of its own in Unicode, a name like the Greek ones.
    ("ell", 'ℓ'),
];

/// The name of the command of a Greek letter.
pub fn greek_name(letter: char) -> Option<&'static str> {
    if letter.is_ascii() {
        return None;
    }
    let letter = if letter == '\u{b5}' { 'μ' } else { letter };
    GREEK
        .iter()
        .find(|(_, greek)| *greek == letter)
        .map(|(name, _)| *name)
}
