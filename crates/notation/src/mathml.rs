//! MathML Core from the tree, as browsers set it well.
//!
//! Spaces between symbols are written out after the rules of TeX, since browsers know them for
//! single operators only; inside scripts there are none.

use std::fmt::Write;

use super::alphabet::styled;
use super::script::Bearer;
use super::{Accent, Atom, Class, Empty, Holes, Math, Size, Style, TableKind, Voice, spoken};

/// Whether a formula stands in a line or on its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Display {
    /// In a line of text.
    Inline,
    /// On its own, at full size.
    Block,
}

/// The style sheet that the MathML relies on.
///
/// A page names the embedded font `Vibank Math`; others may come after it.
pub const STYLE: &str = "\
math{font-family:\"Vibank Math\",\"New Computer Modern Math\",\"Latin Modern Math\",\"STIX Two Math\",\"Cambria Math\",math}\
.tie{white-space:nowrap}\
math .acc{math-depth:inherit}\
math .vec{math-depth:add(1)}\
math .bar{border-top:.05em solid;padding-top:.15em}\
math .matrix mtd:first-child{padding-left:0}\
math .matrix mtd:last-child{padding-right:0}\
math .cases mtd{text-align:left;text-align:-webkit-left}\
math .aligned mtd{padding:.35ex 0}\
math .aligned mtd:nth-child(odd){text-align:right;text-align:-webkit-right}\
math .aligned mtd:nth-child(even){text-align:left;text-align:-webkit-left}\
math .aligned mtd:nth-child(odd):not(:first-child){padding-left:2em}\
.steps{display:grid;grid-template-columns:max-content auto;justify-content:start;margin:.5em 0 .7em 1em;row-gap:.3em}\
.steps>math[display]{display:grid;grid-column:1/-1;grid-template-columns:subgrid;align-items:baseline;margin:0;overflow:visible;break-inside:avoid}\
.steps>math>mrow:first-child{justify-self:end}\
.steps>math>mrow:last-child{justify-self:start}\
@media screen and (max-width:36em){.steps{margin-left:0;overflow-x:auto;overflow-y:hidden}}";

/// Appends a `math` element with its words as `alttext`.
pub(crate) fn write(
    math: &Math,
    out: &mut String,
    display: Display,
    holes: &dyn Holes,
    voice: &'static Voice,
) {
    out.push_str("<math");
    if display == Display::Block {
        out.push_str(" display=\"block\"");
    }
    out.push_str(" alttext=\"");
    let words = out.len();
    spoken::write(math, out, holes, voice);
    escape_from(out, words);
    out.push_str("\">");
    MathmlWriter::new(out, holes).math(math);
    out.push_str("</math>");
}

/// Appends a line of a derivation, `left` and a relation with what follows, as one `math` element whose two halves
/// the style sheet aligns with those of the lines around it.
pub fn write_line(
    out: &mut String,
    left: &Math,
    right: &Math,
    holes: &dyn Holes,
    voice: &'static Voice,
) {
    out.push_str("<math display=\"block\" alttext=\"");
    let words = out.len();
    spoken::write(left, out, holes, voice);
    if out.len() > words {
        out.push(' ');
    }
    spoken::write(right, out, holes, voice);
    escape_from(out, words);
    out.push_str("\">");
    let mut writer = MathmlWriter::new(out, holes);
    for half in [left, right] {
        writer.out.push_str("<mrow>");
        writer.math(half);
        writer.out.push_str("</mrow>");
    }
    out.push_str("</math>");
}

/// Appends text as HTML content or attribute value.
pub fn escape(out: &mut String, text: &str) {
    let mut rest = text;
    while let Some(at) = rest.bytes().position(is_markup) {
        out.push_str(&rest[..at]);
        out.push_str(match rest.as_bytes()[at] {
            b'&' => "&amp;",
            b'<' => "&lt;",
            b'>' => "&gt;",
            b'"' => "&quot;",
            _ => "&#39;",
        });
        rest = &rest[at + 1..];
    }
    out.push_str(rest);
}

/// Whether a byte is a sign that markup would take for its own.
fn is_markup(byte: u8) -> bool {
    matches!(byte, b'&' | b'<' | b'>' | b'"' | b'\'')
}

/// Escapes what has been written since a place, which mostly needs nothing.
fn escape_from(out: &mut String, start: usize) {
    if out[start..].bytes().any(is_markup) {
        let text = out.split_off(start);
        escape(out, &text);
    }
}

struct MathmlWriter<'a> {
    out: &'a mut String,
    holes: &'a dyn Holes,
    /// The atom before the next one in this row.
    before: Atom,
    in_script: bool,
}

impl<'a> MathmlWriter<'a> {
    /// A writer at the start of a row.
    fn new(out: &'a mut String, holes: &'a dyn Holes) -> Self {
        Self {
            out,
            holes,
            before: Atom::Edge,
            in_script: false,
        }
    }

    /// The pieces of a tree, in the row that is open.
    fn math(&mut self, math: &Math) {
        match math {
            Math::Row(pieces) => return pieces.iter().for_each(|piece| self.math(piece)),
            Math::Hole(hole) if self.holes.filling(*hole).is_some() => {
                return self.filling(math.filled(self.holes));
            }
            _ => {}
        }
        let atom = Atom::of(math, self.holes).unwrap_or(Atom::Ordinary);
        let (left, right) = match delimiters(math) {
            None => (atom, atom),
            // TeX has a space there, which nobody wants.
            Some(true) if self.before == Atom::Operator => (Atom::Opening, Atom::Inner),
            Some(true) => (Atom::Inner, Atom::Inner),
            Some(false) => (Atom::Opening, Atom::Closing),
        };
        if !self.in_script && self.before.is_thinly_spaced_from(left) {
            self.out.push_str("<mspace width=\".1667em\"></mspace>");
        }
        self.piece(math);
        self.before = right;
    }

    fn filling(&mut self, filling: &Math) {
        if let Math::Hole(_) = filling {
            return self.blank();
        }
        let holes = std::mem::replace(&mut self.holes, &Empty);
        self.math(filling);
        self.holes = holes;
    }

    fn blank(&mut self) {
        self.out.push_str("<mi>□</mi>");
        self.before = Atom::Ordinary;
    }

    fn piece(&mut self, math: &Math) {
        match math {
            Math::Row(_) => self.math(math),
            Math::Hole(_) => self.blank(),
            Math::Identifier { text, style } => self.identifier(text, *style),
            Math::Number(digits) => self.number(digits),
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => {
                self.element("mo", " form=\"prefix\" lspace=\"0\" rspace=\"0\"", name);
            }
            Math::Text(words) => self.text(words),
            Math::Space(width) => self.space(*width),
            Math::Fraction {
                numerator,
                denominator,
                bar,
                size,
            } => self.fraction(numerator, denominator, *bar, *size),
            Math::Root { radicand, degree } => self.root(radicand, degree.as_deref()),
            Math::Script { base, sub, sup } => self.script(base, sub.as_deref(), sup.as_deref()),
            Math::Stack { base, under, over } => {
                self.around(base, under.as_deref(), over.as_deref());
            }
            Math::Accent { base, accent } => self.accent(base, *accent),
            Math::Fence {
                open,
                close,
                body,
                stretchy,
            } => self.fence(open, close, body, *stretchy),
            Math::Table { rows, kind } => self.table(rows, *kind),
        }
    }

    fn element(&mut self, tag: &str, attributes: &str, text: &str) {
        self.open(tag, attributes);
        escape(self.out, text);
        self.close(tag);
    }

    fn open(&mut self, tag: &str, attributes: &str) {
        self.out.push('<');
        self.out.push_str(tag);
        self.out.push_str(attributes);
        self.out.push('>');
    }

    fn close(&mut self, tag: &str) {
        self.out.push_str("</");
        self.out.push_str(tag);
        self.out.push('>');
    }

    /// A tree as a row of its own, without an element around it.
    fn row(&mut self, math: &Math) {
        let before = std::mem::replace(&mut self.before, Atom::Edge);
        self.math(math);
        self.before = before;
    }

    /// A tree as exactly one element.
    fn one(&mut self, math: &Math) {
        let is_one = !matches!(math.filled(self.holes), Math::Row(pieces) if pieces.len() != 1)
            && !matches!(math, Math::Row(_));
        if is_one {
            return self.row(math);
        }
        self.open("mrow", "");
        self.row(math);
        self.close("mrow");
    }

    fn script_of(&mut self, math: &Math) {
        let in_script = std::mem::replace(&mut self.in_script, true);
        self.one(math);
        self.in_script = in_script;
    }

    fn identifier(&mut self, text: &str, style: Style) {
        let mut chars = text.chars();
        let single = chars.next().filter(|_| chars.next().is_none());
        match (style, single) {
            // Capital Greek is upright in LaTeX, and so is what has no italic form.
            (Style::Default, Some(letter)) if !('Α'..='Ω').contains(&letter) => {
                self.element("mi", "", text);
            }
            (Style::Default | Style::Upright, Some(_)) => {
                self.element("mi", " mathvariant=\"normal\"", text);
            }
            (Style::Default | Style::Upright, None) => self.element("mi", "", text),
            _ => {
                self.open("mi", "");
                for char in text.chars() {
                    match styled(char, style) {
                        Some(letter) => self.out.push(letter),
                        None => escape(self.out, char.encode_utf8(&mut [0; 4])),
                    }
                }
                self.close("mi");
            }
        }
    }

    fn number(&mut self, digits: &str) {
        self.open("mn", "");
        let start = self.out.len();
        escape(self.out, digits);
        if self.out[start..].contains('-') {
            let digits = self.out.split_off(start).replace('-', "−");
            self.out.push_str(&digits);
        }
        self.close("mn");
    }

    fn operator(&mut self, text: &str, class: Class) {
        let text = if text == "-" { "−" } else { text };
        let attributes = match class {
            Class::Binary | Class::Relation | Class::Punctuation if self.in_script => {
                " lspace=\"0\" rspace=\"0\""
            }
            Class::Binary => " form=\"infix\" lspace=\".2222em\" rspace=\".2222em\"",
            Class::Relation => " form=\"infix\" lspace=\".2778em\" rspace=\".2778em\"",
            Class::Prefix | Class::Large => " form=\"prefix\" lspace=\"0\" rspace=\"0\"",
            Class::Punctuation => " lspace=\"0\" rspace=\".1667em\"",
            Class::Opening => " form=\"prefix\" stretchy=\"false\"",
            Class::Closing => " form=\"postfix\" stretchy=\"false\"",
            Class::Ordinary if is_letter_like(text) => return self.element("mi", "", text),
            Class::Ordinary => " lspace=\"0\" rspace=\"0\" stretchy=\"false\"",
        };
        self.element("mo", attributes, text);
    }

    /// Words, whose outer blanks the browser would drop.
    fn text(&mut self, words: &str) {
        let inner = words.trim_matches(' ');
        self.open("mtext", "");
        if words.starts_with(' ') {
            self.out.push('\u{a0}');
        }
        escape(self.out, inner);
        if words.ends_with(' ') && !inner.is_empty() {
            self.out.push('\u{a0}');
        }
        self.close("mtext");
    }

    fn space(&mut self, width: i16) {
        let parts = i32::from(width) * 10_000 / 18;
        let (sign, size) = (if width < 0 { "-" } else { "" }, parts.unsigned_abs());
        let (ems, rest) = (size / 10_000, size % 10_000);
        // Writing to a string cannot fail.
        let _ = write!(
            self.out,
            "<mspace width=\"{sign}{ems}.{rest:04}em\"></mspace>"
        );
    }

    fn fraction(&mut self, numerator: &Math, denominator: &Math, bar: bool, size: Size) {
        let style = match size {
            Size::Auto => None,
            Size::Display => Some(" displaystyle=\"true\" scriptlevel=\"0\""),
            Size::Text => Some(" displaystyle=\"false\" scriptlevel=\"0\""),
        };
        if let Some(style) = style {
            self.open("mstyle", style);
        }
        self.open("mfrac", if bar { "" } else { " linethickness=\"0\"" });
        self.one(numerator);
        self.one(denominator);
        self.close("mfrac");
        if style.is_some() {
            self.close("mstyle");
        }
    }

    fn root(&mut self, radicand: &Math, degree: Option<&Math>) {
        let Some(degree) = degree else {
            self.open("msqrt", "");
            self.row(radicand);
            return self.close("msqrt");
        };
        self.open("mroot", "");
        self.one(radicand);
        self.script_of(degree);
        self.close("mroot");
    }

    fn script(&mut self, base: &Math, sub: Option<&Math>, sup: Option<&Math>) {
        let holes = self.holes;
        let bearer = Bearer::of(base, sub, sup, holes);
        if has_movable_limits(bearer.base) {
            return self.around(bearer.base, bearer.sub, bearer.sup);
        }
        let tag = match (bearer.sub, bearer.sup) {
            (Some(_), Some(_)) => "msubsup",
            (Some(_), None) => "msub",
            (None, _) => "msup",
        };
        self.open(tag, "");
        if bearer.needs_parentheses {
            self.open("mrow", "");
            self.operator("(", Class::Opening);
            self.row(base);
            self.operator(")", Class::Closing);
            self.close("mrow");
        } else {
            self.one(bearer.base);
        }
        for script in [bearer.sub, bearer.sup].into_iter().flatten() {
            self.script_of(script);
        }
        if let (None, None) = (bearer.sub, bearer.sup) {
            self.out.push_str("<mrow></mrow>");
        }
        self.close(tag);
    }

    /// Below and above, or at the side of an operator with movable limits in a line.
    fn around(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        let tag = match (under, over) {
            (Some(_), Some(_)) => "munderover",
            (Some(_), None) => "munder",
            (None, Some(_)) => "mover",
            (None, None) => return self.one(base),
        };
        self.open(tag, "");
        match base {
            Math::Operator {
                text,
                class: Class::Large,
            } => self.element(
                "mo",
                " form=\"prefix\" movablelimits=\"true\" lspace=\"0\" rspace=\"0\"",
                text,
            ),
            Math::Function(name) => self.element(
                "mo",
                " form=\"prefix\" movablelimits=\"true\" lspace=\"0\" rspace=\"0\"",
                name,
            ),
            base => self.one(base),
        }
        for mark in [under, over].into_iter().flatten() {
            match mark {
                Math::Operator { text, .. } if matches!(text.as_str(), "⏟" | "⏞") => {
                    self.element("mo", " stretchy=\"true\"", text);
                }
                mark => self.script_of(mark),
            }
        }
        self.close(tag);
    }

    /// Spacing accents without the attribute `accent`, at the size of the base: with it, or with
    /// combining marks, browsers set the dots onto the letter or beside it.
    fn accent(&mut self, base: &Math, accent: Accent) {
        let is_wide = !is_letter(base.filled(self.holes));
        if accent == Accent::Bar && is_wide {
            self.open("mrow", " class=\"bar\"");
            self.row(base);
            return self.close("mrow");
        }
        let (attributes, sign) = match accent {
            Accent::Dot => (ACCENT, "˙"),
            Accent::DoubleDot => (ACCENT, "¨"),
            Accent::TripleDot => (ACCENT, "˙˙˙"),
            Accent::Hat => (ACCENT, "ˆ"),
            Accent::Tilde => (ACCENT, "˜"),
            Accent::Bar => (ACCENT, "¯"),
            Accent::Vector if is_wide => (" stretchy=\"true\"", "→"),
            Accent::Vector => (" class=\"vec\" stretchy=\"false\"", "→"),
        };
        self.open("mover", "");
        self.one(base);
        self.element("mo", attributes, sign);
        self.close("mover");
    }

    fn fence(&mut self, open: &str, close: &str, body: &Math, stretchy: bool) {
        let (prefix, postfix) = if stretchy {
            (
                " form=\"prefix\" stretchy=\"true\" lspace=\"0\" rspace=\"0\"",
                " form=\"postfix\" stretchy=\"true\" lspace=\"0\" rspace=\"0\"",
            )
        } else {
            (
                " form=\"prefix\" stretchy=\"false\"",
                " form=\"postfix\" stretchy=\"false\"",
            )
        };
        self.open("mrow", "");
        if !open.is_empty() {
            self.element("mo", prefix, open);
        }
        self.one(body);
        if !close.is_empty() {
            self.element("mo", postfix, close);
        }
        self.close("mrow");
    }

    fn table(&mut self, rows: &[Vec<Math>], kind: TableKind) {
        self.open(
            "mtable",
            match kind {
                TableKind::Matrix => " class=\"matrix\"",
                TableKind::Cases => " class=\"cases\"",
                TableKind::Aligned => " class=\"aligned\" displaystyle=\"true\"",
            },
        );
        for row in rows {
            self.open("mtr", "");
            for cell in row {
                self.open("mtd", "");
                self.row(cell);
                self.close("mtd");
            }
            self.close("mtr");
        }
        self.close("mtable");
    }
}

/// Whether the delimiters at both sides of a tree grow, if it has them.
fn delimiters(math: &Math) -> Option<bool> {
    match math {
        Math::Fence { stretchy, .. } => Some(*stretchy),
        Math::Script { base, .. } => delimiters(base),
        _ => None,
    }
}

/// An accent at the size of its base.
const ACCENT: &str = " class=\"acc\" stretchy=\"false\"";

/// Whether an accent over this is as wide as the accent's own sign.
fn is_letter(base: &Math) -> bool {
    matches!(base, Math::Identifier { text, .. } if text.chars().nth(1).is_none())
}

/// Marks that are spaced and slanted like letters.
fn is_letter_like(text: &str) -> bool {
    matches!(text, "∞" | "∂" | "∇" | "∅" | "□" | "°" | "%")
}

/// Limits of these stand below and above in display, at the side in a line.
fn has_movable_limits(base: &Math) -> bool {
    match base {
        Math::Operator {
            text,
            class: Class::Large,
        } => !"∫∬∭∮".contains(text.as_str()),
        Math::Function(name) => {
            matches!(name.as_str(), "lim" | "max" | "min" | "sup" | "inf" | "gcd")
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests;
