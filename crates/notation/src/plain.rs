//! Plain Unicode text from the tree, for terminals and messages.

use super::script::Bearer;
use super::{Accent, Class, Empty, Holes, Math, TableKind};

/// Appends a line of Unicode text.
pub(crate) fn write(math: &Math, out: &mut String, holes: &dyn Holes) {
    let start = out.len();
    let mut writer = PlainWriter {
        out,
        holes,
        start,
        ends_loosely: false,
        after_fraction: false,
    };
    writer.math(math);
    let end = out.trim_end_matches(' ').len().max(start);
    out.truncate(end);
}

struct PlainWriter<'a> {
    out: &'a mut String,
    holes: &'a dyn Holes,
    /// Where this formula begins.
    start: usize,
    /// Whether a letter set right after what was written would read as part of it.
    ends_loosely: bool,
    /// Whether a fraction has just ended, after which a bracket would read as part of it.
    after_fraction: bool,
}

impl PlainWriter<'_> {
    fn math(&mut self, math: &Math) {
        match math {
            Math::Row(pieces) => pieces.iter().for_each(|piece| self.math(piece)),
            Math::Identifier { text, .. } => self.operand(text, text.chars().nth(1).is_some()),
            Math::Number(digits) => {
                self.apart(true);
                self.push(&digits.replace('-', "−"));
            }
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => {
                self.apart(true);
                self.push(name);
                self.ends_loosely = true;
            }
            Math::Text(words) if self.out.ends_with(' ') => self.push(words.trim_start()),
            Math::Text(words) => self.push(words),
            Math::Space(width) => {
                if *width > 2 {
                    self.blank();
                }
            }
            Math::Fraction {
                numerator,
                denominator,
                ..
            } => {
                self.apart(true);
                self.enclosed(numerator);
                self.push("/");
                self.enclosed(denominator);
                self.ends_loosely = true;
                self.after_fraction = true;
            }
            Math::Root { radicand, degree } => self.root(radicand, degree.as_deref()),
            Math::Script { base, sub, sup } => self.script(base, sub.as_deref(), sup.as_deref()),
            Math::Stack { base, under, over } => {
                self.stack(base, under.as_deref(), over.as_deref());
            }
            Math::Accent { base, accent } => self.accent(base, *accent),
            Math::Fence {
                open, close, body, ..
            } => self.fence(open, close, body),
            Math::Table { rows, kind } => self.table(rows, *kind),
            Math::Hole(hole) => match self.holes.filling(*hole) {
                Some(Math::Hole(_)) | None => self.operand("□", false),
                Some(filling) => {
                    let holes = std::mem::replace(&mut self.holes, &Empty);
                    self.math(filling);
                    self.holes = holes;
                }
            },
        }
    }

    fn push(&mut self, text: &str) {
        self.out.push_str(text);
        self.ends_loosely = false;
        self.after_fraction = false;
    }

    /// A blank, unless there is one or nothing before it.
    fn blank(&mut self) {
        if self.out.len() > self.start && !self.out.ends_with([' ', '(', '[', '{']) {
            self.out.push(' ');
        }
        self.ends_loosely = false;
    }

    /// Keeps the next operand apart from one that it would run into.
    fn apart(&mut self, is_long: bool) {
        let written = &self.out[self.start..];
        if self.ends_loosely
            || is_long && written.ends_with(|c: char| c.is_alphanumeric() || c == ')')
        {
            self.blank();
        }
    }

    fn operand(&mut self, text: &str, is_long: bool) {
        self.apart(is_long);
        self.push(text);
        self.ends_loosely = is_long;
    }

    fn operator(&mut self, text: &str, class: Class) {
        let text = if text == "-" { "−" } else { text };
        match class {
            Class::Binary if matches!(text, "⋅" | "·") => self.push("·"),
            Class::Binary if matches!(text, "/" | "∘") => self.push(text),
            Class::Binary | Class::Relation => {
                self.blank();
                self.push(text);
                self.out.push(' ');
            }
            Class::Punctuation => {
                self.push(text);
                self.out.push(' ');
            }
            Class::Opening => {
                if self.after_fraction || self.ends_loosely && self.out.ends_with(')') {
                    self.blank();
                }
                self.push(text);
            }
            Class::Prefix | Class::Large => {
                self.apart(false);
                self.push(text);
            }
            Class::Closing | Class::Ordinary => self.push(text),
        }
    }

    fn enclosed(&mut self, math: &Math) {
        let filled = math.filled(self.holes);
        let is_simple = match filled {
            Math::Row(pieces) => pieces.is_empty(),
            Math::Fraction { .. } => false,
            _ => true,
        };
        if is_simple {
            return self.math(math);
        }
        self.push("(");
        self.math(math);
        self.push(")");
    }

    fn root(&mut self, radicand: &Math, degree: Option<&Math>) {
        self.apart(false);
        if let Some(degree) = degree {
            let start = self.out.len();
            self.math(degree);
            if !self.raise(start) {
                self.group(start, false);
            }
        }
        self.push("√");
        let is_single = matches!(radicand.filled(self.holes), Math::Number(_));
        if is_single {
            return self.math(radicand);
        }
        self.push("(");
        self.math(radicand);
        self.push(")");
    }

    fn script(&mut self, base: &Math, sub: Option<&Math>, sup: Option<&Math>) {
        let holes = self.holes;
        let bearer = Bearer::of(base, sub, sup, holes);
        let start = self.out.len();
        self.bearer(bearer.base);
        let blank = self.out.len() > start && self.out.ends_with(' ');
        if blank {
            self.out.pop();
        }
        // A letter right after `sin²` or `ω_n` would read as part of it, after `x²` it does not.
        let is_function = matches!(bearer.base, Math::Function(_));
        let is_large = matches!(
            bearer.base,
            Math::Operator {
                class: Class::Large,
                ..
            }
        );
        let mut is_loose = true;
        if let Some(sub) = bearer.sub {
            self.push("_");
            let start = self.out.len();
            self.math(sub);
            // A sign alone, as in `k_∥`, has no blanks around it.
            let written = self.out.split_off(start);
            self.out.push_str(written.trim_matches(' '));
            if is_large || !self.lower(start) {
                self.group(start, true);
            }
        }
        if let Some(sup) = bearer.sup {
            self.ends_loosely = false;
            let start = self.out.len();
            self.math(sup);
            if self.out[start..].starts_with(' ') {
                self.out.remove(start);
            }
            let is_raised = !is_large && self.raise(start);
            if !is_raised {
                self.group(start, false);
                self.out.insert(start, '^');
            }
            is_loose = is_function || !is_raised;
        }
        if blank {
            self.out.push(' ');
        }
        self.ends_loosely = is_loose && !blank;
    }

    fn bearer(&mut self, base: &Math) {
        let is_compound = matches!(
            base,
            Math::Row(_) | Math::Fraction { .. } | Math::Script { .. } | Math::Stack { .. }
        );
        if !is_compound {
            return self.math(base);
        }
        self.apart(false);
        self.push("(");
        self.math(base);
        self.push(")");
    }

    /// What is set below and above is written like scripts; a brace is left out.
    fn stack(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        match (
            under.filter(|mark| !mark.is_brace()),
            over.filter(|mark| !mark.is_brace()),
        ) {
            (None, None) => self.math(base),
            (under, over) => self.script(base, under, over),
        }
    }

    /// Puts what was written since a place into parentheses if it is more than a number, a
    /// character or, where words may stand, a word.
    fn group(&mut self, start: usize, may_be_word: bool) {
        let written = &self.out[start..];
        let is_plain = written.chars().nth(1).is_none()
            || written
                .chars()
                .all(|c| c.is_ascii_digit() || may_be_word && c.is_alphanumeric());
        if is_plain && !written.is_empty() {
            return;
        }
        self.out.insert(start, '(');
        self.out.push(')');
    }

    /// Turns what was written since the sign of a subscript into subscript characters, if they exist.
    fn lower(&mut self, start: usize) -> bool {
        /// A longer word reads better in full size.
        const MAX_LENGTH: usize = 3;
        let lowered: Option<String> = self.out[start..].chars().map(subscript).collect();
        match lowered {
            Some(lowered) if (1..=MAX_LENGTH).contains(&lowered.chars().count()) => {
                self.out.truncate(start - 1);
                self.out.push_str(&lowered);
                true
            }
            _ => false,
        }
    }

    /// Turns what was written since a place into superscript characters, if they exist.
    fn raise(&mut self, start: usize) -> bool {
        let raised: Option<String> = self.out[start..]
            .chars()
            .filter(|c| *c != ' ')
            .map(superscript)
            .collect();
        match raised {
            Some(raised) if !raised.is_empty() => {
                self.out.truncate(start);
                self.out.push_str(&raised);
                true
            }
            _ => false,
        }
    }

    /// A combining mark after a single letter, a word after anything longer.
    fn accent(&mut self, base: &Math, accent: Accent) {
        let start = self.out.len();
        self.math(base);
        let (mark, word) = match accent {
            Accent::Dot => ('\u{307}', "dot"),
            Accent::DoubleDot => ('\u{308}', "ddot"),
            Accent::TripleDot => ('\u{20db}', "dddot"),
            Accent::Hat => ('\u{302}', "hat"),
            Accent::Tilde => ('\u{303}', "tilde"),
            Accent::Bar => ('\u{304}', "bar"),
            Accent::Vector => ('\u{20d7}', "vec"),
        };
        // Over nothing it must not fall on the letter before, which somebody else wrote.
        if self.out[start..].trim_start().chars().count() == 1 {
            if let Some(letter) = self.out.pop() {
                match composed(letter, mark) {
                    Some(letter) => self.out.push(letter),
                    None => self.out.extend([letter, mark]),
                }
            }
            self.ends_loosely = false;
            return;
        }
        let runs_on = self.out[self.start..start].ends_with(char::is_alphanumeric);
        let apart = if runs_on { " " } else { "" };
        self.out.insert_str(start, &format!("{apart}{word}("));
        self.out.push(')');
    }

    fn fence(&mut self, open: &str, close: &str, body: &Math) {
        // A table brings its own brackets.
        if matches!(body, Math::Table { .. }) && matches!(open, "(" | "[") {
            return self.math(body);
        }
        self.operator(open, Class::Opening);
        self.math(body);
        self.push(close);
    }

    fn table(&mut self, rows: &[Vec<Math>], kind: TableKind) {
        let (open, between, cells, close) = match kind {
            TableKind::Matrix => ("[", ", ", ", ", "]"),
            TableKind::Cases => ("", "; ", ", ", ""),
            TableKind::Aligned => ("", "; ", "", ""),
        };
        let is_column = rows.iter().all(|row| row.len() < 2);
        self.push(open);
        for (number, row) in rows.iter().enumerate() {
            let before = self.out.len();
            if number > 0 {
                self.push(between);
            }
            if !is_column {
                self.push(open);
            }
            for (column, cell) in row.iter().enumerate() {
                if column > 0 {
                    self.push(cells);
                }
                self.math(cell);
            }
            if !is_column {
                self.push(close);
            }
            if number > 0 && kind == TableKind::Aligned {
                let first = row.first().map(|cell| cell.plain());
                let is_open = row.len() > 1 && first.is_some_and(|own| own.trim().is_empty());
                self.join(before, between, is_open);
            }
        }
        self.push(close);
    }

    /// Has a row that goes on with the relation of the one before, `a = b` and `= c` below it, come after it as one
    /// chain; also one without a left side that goes on within a sum or product.
    fn join(&mut self, before: usize, between: &str, is_open: bool) {
        const RELATIONS: [char; 8] = ['=', '≈', '<', '>', '≤', '≥', '≡', '⇒'];
        const OPERATORS: [char; 5] = ['+', '−', '±', '·', '⋅'];
        let row = &self.out[before + between.len()..];
        let text = row.trim_start();
        if text.starts_with(RELATIONS) || is_open && text.starts_with(OPERATORS) {
            let end = self.out.len() - text.len();
            self.out.replace_range(before..end, " ");
        }
    }
}

/// Letters that have a character of their own with a mark: the mark, the letters, the characters.
const COMPOSED: &[(char, &str, &str)] = &[
    (
        '\u{307}',
        "abcdefghmnoprstwxyzABCDEFGHIMNOPRSTWXYZ",
        "ȧḃċḋėḟġḣṁṅȯṗṙṡṫẇẋẏżȦḂĊḊĖḞĠḢİṀṄȮṖṘṠṪẆẊẎŻ",
    ),
    ('\u{308}', "aehiotuwxyAEHIOUWXY", "äëḧïöẗüẅẍÿÄËḦÏÖÜẄẌŸ"),
    (
        '\u{302}',
        "aceghijosuwyzACEGHIJOSUWYZ",
        "âĉêĝĥîĵôŝûŵŷẑÂĈÊĜĤÎĴÔŜÛŴŶẐ",
    ),
    ('\u{303}', "aeinouvyAEINOUVY", "ãẽĩñõũṽỹÃẼĨÑÕŨṼỸ"),
    ('\u{304}', "aegiouyAEGIOUY", "āēḡīōūȳĀĒḠĪŌŪȲ"),
];

/// The letter with its mark as one character, as most fonts have it.
fn composed(letter: char, mark: char) -> Option<char> {
    let (_, letters, characters) = COMPOSED.iter().find(|(own, ..)| *own == mark)?;
    let place = letters.chars().position(|own| own == letter)?;
    characters.chars().nth(place)
}

/// The lowered form of a digit or letter.
fn subscript(char: char) -> Option<char> {
    const LETTERS: &str = "aehijklmnoprstuvx";
    const LOWERED: &str = "ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
    if let Some(digit) = char.to_digit(10) {
        return char::from_u32('₀' as u32 + digit);
    }
    LOWERED.chars().nth(LETTERS.find(char)?)
}

/// The raised form of a character.
fn superscript(char: char) -> Option<char> {
    Some(match char {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4'..='9' => char::from_u32('⁴' as u32 + (char as u32 - '4' as u32))?,
        '+' => '⁺',
        '−' => '⁻',
        '=' => '⁼',
        '(' => '⁽',
        ')' => '⁾',
        'n' => 'ⁿ',
        'i' => 'ⁱ',
        '′' => '′',
        '∘' => '°',
        'T' => 'ᵀ',
        _ => return None,
    })
}
