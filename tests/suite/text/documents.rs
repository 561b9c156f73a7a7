//! Texts as items have them, and what can be wrong with them.

use vibank::diagnostic::Diagnose;
use vibank::document::{Document, Filling, Form, TextReading};
use vibank::math::{Math, Voice, symbol};

fn read(text: &str) -> Document {
    let TextReading { document, errors } = Document::read(text);
    assert_eq!(errors, [], "{text}");
    document
}

fn kilograms() -> Math {
    Math::row([Math::number("2.0"), Math::thin_space(), Math::upright("kg")])
}

const STATEMENT: &str = "\
A block of mass << m.given >> hangs on a *spring*; $x$ is **measured** from rest.

1. Its law is
   $$m\\ddot x + k x = << F.formula >>$$
   with $<< omega_n.symbol >>^2 = k/m$.
2. See [the notes](https://example.org/a?b=1&c=2).

<< figure >>

| quantity | value |
|:--|--:|
| mass | << m >> |
";

fn fills() -> Vec<Filling> {
    vec![
        Filling::Math(Math::row([symbol("m"), Math::relation("="), kilograms()])),
        Filling::Math(Math::row([
            symbol("F_0"),
            Math::function("sin"),
            symbol("Omega"),
            symbol("t"),
        ])),
        Filling::Math(symbol("omega_n")),
        Filling::Figure("<svg></svg>".to_owned()),
        Filling::Math(kilograms()),
    ]
}

#[test]
fn a_text_lists_what_it_demands() {
    let document = read(STATEMENT);
    let demand: Vec<_> = document
        .placeholders()
        .iter()
        .map(|p| {
            (
                p.path.as_str(),
                p.form,
                p.in_math,
                &STATEMENT[p.span.range()],
            )
        })
        .collect();
    assert_eq!(
        demand,
        [
            ("m", Form::Given, false, "<< m.given >>"),
            ("F", Form::Formula, true, "<< F.formula >>"),
            ("omega_n", Form::Symbol, true, "<< omega_n.symbol >>"),
            ("figure", Form::Value, false, "<< figure >>"),
            ("m", Form::Value, false, "<< m >>"),
        ]
    );
    for path in [
        "model.equation",
        "model.equation.x1",
        "models.sliding.motion.x",
        "plots.response",
    ] {
        let document = read(&format!("<< {path} >>"));
        assert_eq!(document.placeholders()[0].path, path);
        assert_eq!(document.placeholders()[0].form, Form::Value);
    }
    assert_eq!(
        read("<<model.M.symbol>>").placeholders()[0].form,
        Form::Symbol
    );
}

#[test]
fn a_text_is_written_in_each_notation() {
    let document = read(STATEMENT);
    assert_eq!(
        document.markdown(&fills()),
        "\
A block of mass $m = 2.0\\,\\mathrm{kg}$ hangs on a *spring*; $x$ is **measured** from rest.

1. Its law is
   $$m\\ddot{x} + kx = F_0\\sin\\Omega t$$
   with $\\omega_n^2 = k/m$.
2. See [the notes](<https://example.org/a?b=1&c=2>).

<svg></svg>

| quantity | value |
| :-- | --: |
| mass | $2.0\\,\\mathrm{kg}$ |"
    );
    assert_eq!(
        document.plain(&fills()),
        "\
A block of mass m = 2.0 kg hangs on a spring; x is measured from rest.

1. Its law is
       mẍ + kx = F₀ sin Ωt
   with ωₙ² = k/m.
2. See the notes (https://example.org/a?b=1&c=2).

<svg></svg>

quantity | value
mass | 2.0 kg"
    );
    let html = document.html(&fills(), Voice::ENGLISH);
    assert!(html.contains("<svg></svg>"));
    assert!(html.contains("<a href=\"https://example.org/a?b=1&amp;c=2\">the notes</a>"));
    assert!(html.contains("<td style=\"text-align:right\"><math alttext=\"2.0 kg\"><mn>2.0</mn>"));
    assert!(html.contains("<msubsup><mi>ω</mi><mi>n</mi><mn>2</mn></msubsup>"));
}

#[test]
fn a_formula_stays_on_the_line_of_its_punctuation() {
    let text = "Over ($r$), in the $x$-direction, $y$ and $z$.";
    let html = read(text).html(&Vec::<Filling>::new(), Voice::ENGLISH);
    assert!(html.contains("Over <span class=\"tie\">(<math"), "{html}");
    for after in ["),", "-direction,", "."] {
        assert!(html.contains(&format!("</math>{after}</span>")), "{html}");
    }
    assert!(
        html.contains(" <math alttext=\"y\"><mi>y</mi></math> and "),
        "{html}"
    );
}

#[test]
fn markdown_reads_back_as_the_same_text() {
    for text in [
        "One *two* **three** `four` $x^2$.\n\n- a\n- b\n\n> q\n\n---\n\n```\ncode\n```",
        "# Title\n\n1. a\n\n   b\n2. c",
        "\\<<m>> \\* \\$5 \\[a\\] \\_ \\# \\<b\\> 2\\. a_b \\| \\~ &amp;amp;",
        "| a | b |\n| --- | :-: |\n| $\\lvert x\\rvert$ | $\\begin{pmatrix} 1 \\\\ 2 \\end{pmatrix}$ |",
    ] {
        let document = read(text);
        let markdown = document.markdown(&Vec::<Filling>::new());
        assert_eq!(read(&markdown), document, "{text}\n---\n{markdown}");
    }
}

#[test]
fn a_compiled_text_reads_back() {
    let document = read(STATEMENT);
    let json = serde_json::to_string(&document).unwrap();
    let again: Document = serde_json::from_str(&json).unwrap();
    assert_eq!(
        again.html(&fills(), Voice::ENGLISH),
        document.html(&fills(), Voice::ENGLISH)
    );
    assert_eq!(serde_json::to_string(&again).unwrap(), json);
    assert!(json.len() < 4 * STATEMENT.len(), "{}", json.len());
}

#[test]
fn appended_texts_keep_their_holes_apart() {
    let mut document = read("<< a >>");
    document.append(read("- $x = << b >>$"));
    let fills = vec![Filling::words("A"), Filling::Math(Math::number("2"))];
    assert_eq!(document.plain(&fills), "A\n\n- x = 2");
}

/// Each with what it points at and a word of its message.
const WRONG: &[(&str, &str, &str)] = &[
    (r"The root $\sqr{k}$.", r"\sqr", "unknown command"),
    (r"a $\frac{k}{m$ b", "{", "not balanced"),
    (r"a $k}$ b", "}", "not balanced"),
    (r"a $\left( x$ b", r"\left", "not balanced"),
    (
        r"$\begin{gather}x\end{gather}$",
        r"\begin{gather}",
        "unknown environment",
    ),
    ("mass << m.symbl >> of", "symbl", "unknown form"),
    ("mass << m of it", "<< m of it", "not closed"),
    ("mass << 2*m >> of", "2*m", "not a name"),
    ("a $ x $ b", "$", "blank inside"),
    (r"a \(x\) b", r"\(", "does not begin a formula"),
    ("a $$x\n\ny$$ b", "$$", "empty line"),
    ("| a |\n|---|\n| $|x|$ |", "$", "bar"),
    (r"$x \text{ if $y$}$", "$", "dollar"),
    (r"a $x \text{ if $y b", r"\text{ if ", "dollar"),
    ("costs 5 $ a piece", "$", "no formula"),
    ("a <b>c</b>", "<b>", "HTML"),
    ("<div>\nx\n</div>", "<div>\nx\n</div>", "HTML"),
    ("[a](javascript:alert)", "[a](javascript:alert)", "link"),
    ("![a](b.png)", "![a](b.png)", "image"),
    ("see << figure >> here", "<< figure >>", "cannot stand in"),
    ("`<< m >>`", "<< m >>", "cannot stand in"),
    ("[a](https://x.org/<< m >>)", "<< m >>", "cannot stand in"),
    ("a\u{1b}[31mb", "\u{1b}", "U+001B"),
    ("a \u{e000} b", "\u{e000}", "U+E000"),
    ("$50%$", "%", "cannot stand here"),
    ("$x ä y$", "ä", "cannot stand here"),
    ("$a & b$", "&", "cannot stand here"),
    (r"$x^a^b$", r"x^a^b", "superscript"),
    ("x << a >> y $\\foo$", r"\foo", "unknown command"),
];

#[test]
fn what_is_wrong_is_pointed_at() {
    for (text, place, message) in WRONG {
        let errors = Document::read(text).errors;
        let found: Vec<_> = errors
            .iter()
            .map(|error| (&text[error.span().range()], error.to_string()))
            .collect();
        assert!(
            found
                .iter()
                .any(|(at, said)| at == place && said.contains(message)),
            "{text:?}: {found:?}"
        );
        assert!(errors.iter().all(|error| !error.labels().is_empty()));
    }
}

#[test]
fn what_is_fine_is_not_complained_of() {
    for text in [
        r"It costs \$5 and $x$.",
        "The interval [0, 1) and (0, 1].",
        r"A backslash \\ and \*stars\*.",
        r"$\text{50\,\%}$".replace(r"\,", " ").as_str(),
        "$k$-th, **$z$**, \"$s$\", -$t$-",
        "$$<< model.M >>\\ddot{\\mathbf x} = << model.F.number >>$$",
        "a < b and b > c",
        "<https://example.org>",
        "$a \\<< b$ and c \\<< d",
    ] {
        read(text);
    }
}

#[test]
fn a_filled_base_keeps_its_meaning() {
    let fills = vec![Filling::Math(kilograms())];
    let document = read("$<< m >>^2$");
    assert_eq!(document.plain(&fills), "(2.0 kg)²");
    assert_eq!(
        document.markdown(&fills),
        r"$\left(2.0\,\mathrm{kg}\right)^2$"
    );
}

#[test]
fn a_chain_on_several_lines_is_one_chain_in_a_terminal() {
    let chain = "\\begin{aligned} a &= b \\\\ &= c \\\\ d &= e \\end{aligned}";
    let math = vibank::document::read_math(chain).expect("it can be read");
    assert_eq!(math.plain(), "a = b = c; d = e");
    let sum = "\\begin{aligned} a &= b \\\\ &\\quad {} - c \\\\ -d &= e \\end{aligned}";
    let math = vibank::document::read_math(sum).expect("it can be read");
    assert_eq!(math.plain(), "a = b − c; −d = e");
}
