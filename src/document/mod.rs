//! The texts of items as trees with holes, compiled once and written many times.
//!
//! A text is Markdown with LaTeX math and placeholders `<< name.form >>`. It is read once, at load,
//! into a [`Document`]; each placeholder becomes a hole with a number, and the list of
//! [`Placeholder`]s is what the text demands. To write a document the caller gives a [`Fill`] for
//! each hole. Reading needs the parsers behind the feature `render`; the tree, its JSON and its
//! writers do not, so that a page can carry compiled texts and no parser.
//!
//! Deliberately absent: arithmetic, conditions, loops, raw HTML, images.

mod fill;
mod html;
mod json;
mod latex;
mod markdown;
mod placeholder;
mod plain;
#[cfg(feature = "render")]
mod read;
mod typst;

pub use fill::{Fill, Filling, Fills, Step};
pub use html::Formulas;
#[cfg(feature = "render")]
pub(crate) use latex::{picture_name, write_words as latex_words};
pub use placeholder::{Form, Placeholder};
#[cfg(feature = "render")]
pub(crate) use read::read_bare;
#[cfg(feature = "render")]
pub use read::{TextError, TextReading, read_math};
#[cfg(feature = "render")]
pub(crate) use typst::write_picture;

use serde::Serialize;

use crate::math::{Math, Voice};

/// A text, compiled.
///
/// Its JSON is the compiled form of item texts.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Document {
    #[serde(rename = "b")]
    blocks: Vec<Block>,
    #[serde(rename = "p", skip_serializing_if = "Vec::is_empty")]
    placeholders: Vec<Placeholder>,
}

/// A piece of a text that stands on lines of its own.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub enum Block {
    /// Running text.
    #[serde(rename = "p")]
    Paragraph(Vec<Inline>),
    /// A title of a section within the text.
    #[serde(rename = "h")]
    Heading {
        /// From 1, the highest, to 6.
        #[serde(rename = "l")]
        level: u8,
        /// Its words.
        #[serde(rename = "c")]
        content: Vec<Inline>,
    },
    /// Items with bullets, or numbered from a start.
    #[serde(rename = "l")]
    List {
        /// The first number, if the items are numbered.
        #[serde(rename = "n", skip_serializing_if = "Option::is_none")]
        start: Option<u64>,
        /// Whether the items stand close together.
        #[serde(rename = "t")]
        tight: bool,
        /// The blocks of each item.
        #[serde(rename = "i")]
        items: Vec<Vec<Block>>,
    },
    /// A head, rows of cells, and how each column is aligned.
    #[serde(rename = "t")]
    Table {
        /// How the columns are aligned.
        #[serde(rename = "a")]
        columns: Vec<Alignment>,
        /// The cells of the head.
        #[serde(rename = "h")]
        head: Vec<Vec<Inline>>,
        /// The cells below, by row.
        #[serde(rename = "r")]
        rows: Vec<Vec<Vec<Inline>>>,
    },
    /// A formula on its own.
    #[serde(rename = "m")]
    Display(Math),
    /// Lines of code, as they are.
    #[serde(rename = "c")]
    Code(String),
    /// A quotation.
    #[serde(rename = "q")]
    Quote(Vec<Block>),
    /// The place of a figure, a plot or a derivation, a hole.
    #[serde(rename = "f")]
    Figure(u32),
    /// A rule across the page.
    #[serde(rename = "r")]
    Rule,
}

/// A piece of a line.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub enum Inline {
    /// Words.
    #[serde(rename = "t")]
    Text(String),
    /// Emphasized.
    #[serde(rename = "e")]
    Emphasis(Vec<Inline>),
    /// Strongly emphasized.
    #[serde(rename = "s")]
    Strong(Vec<Inline>),
    /// Text in a fixed-width face, written as it stands.
    #[serde(rename = "c")]
    Code(String),
    /// Text that leads to an address.
    #[serde(rename = "l")]
    Link {
        /// Where it leads: `http`, `https` or relative.
        #[serde(rename = "u")]
        to: String,
        /// Its words.
        #[serde(rename = "c")]
        content: Vec<Inline>,
    },
    /// A formula in the line.
    #[serde(rename = "m")]
    Math(Math),
    /// A placeholder outside of formulas.
    #[serde(rename = "h")]
    Hole(u32),
    /// A line break.
    #[serde(rename = "b")]
    Break,
}

/// How a column of a table is aligned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Alignment {
    /// As the page has it.
    #[default]
    None,
    /// Flush left.
    Left,
    /// Centred.
    Centre,
    /// Flush right.
    Right,
}

impl Document {
    /// The document of these blocks, whose holes are numbered as `placeholders` are.
    pub fn of(blocks: Vec<Block>, placeholders: Vec<Placeholder>) -> Self {
        Self {
            blocks,
            placeholders,
        }
    }

    /// Reads a text. Length and nesting are bounded.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::document::{Document, Filling};
    /// use vibank::math::Math;
    ///
    /// let reading = Document::read("A block of mass << m >> with $\\omega_n = << omega_n >>$.");
    /// assert!(reading.errors.is_empty());
    /// let demand: Vec<_> = reading.document.placeholders().iter().map(|p| &p.path).collect();
    /// assert_eq!(demand, ["m", "omega_n"]);
    /// let fills = vec![Filling::Math(Math::number("2.0")), Filling::Math(Math::number("3.0"))];
    /// assert_eq!(reading.document.plain(&fills), "A block of mass 2.0 with ωₙ = 3.0.");
    /// ```
    #[cfg(feature = "render")]
    pub fn read(text: &str) -> TextReading {
        read::read(text)
    }

    /// A sentence of our own; what stands between back-ticks is code.
    ///
    /// ```
    /// use vibank::{document::Document, math::Voice};
    ///
    /// let sentence = Document::sentence("Write `5 m`, not `5 <b>`.");
    /// assert_eq!(sentence.html(&Vec::new(), Voice::ENGLISH).trim(), "<p>Write <code>5 m</code>, not <code>5 &lt;b&gt;</code>.</p>");
    /// assert_eq!(sentence.plain(&Vec::new()), "Write 5 m, not 5 <b>.");
    /// ```
    pub fn sentence(words: &str) -> Self {
        let mut content = Vec::new();
        for (place, piece) in words.split('`').enumerate() {
            // An odd number of back-ticks leaves the last one as it is.
            let is_code = place % 2 == 1 && words.split('`').count() > place + 1;
            match piece {
                "" => {}
                code if is_code => content.push(Inline::Code(code.to_owned())),
                words if place % 2 == 1 => content.push(Inline::Text(format!("`{words}"))),
                words => content.push(Inline::Text(words.to_owned())),
            }
        }
        Self::of(vec![Block::Paragraph(content)], Vec::new())
    }

    /// Its blocks, in order.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// What it demands, hole by hole.
    pub fn placeholders(&self) -> &[Placeholder] {
        &self.placeholders
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// As an HTML fragment, whose formulas are heard in a voice.
    pub fn html(&self, fills: &dyn Fills, voice: &'static Voice) -> String {
        let mut out = String::new();
        self.write_html(&mut out, fills, voice);
        out
    }

    /// Appends an HTML fragment.
    pub fn write_html(&self, out: &mut String, fills: &dyn Fills, voice: &'static Voice) {
        self.write_html_with(out, fills, Formulas::MathMl, voice);
    }

    /// Appends an HTML fragment with its formulas as they are wanted.
    pub(crate) fn write_html_with(
        &self,
        out: &mut String,
        fills: &dyn Fills,
        formulas: Formulas,
        voice: &'static Voice,
    ) {
        html::write(out, &self.blocks, fills, formulas, voice);
    }

    /// Appends the words of its first paragraph without an element around them, for a heading or
    /// a cell; a text of any other shape is written whole.
    pub(crate) fn write_html_line(
        &self,
        out: &mut String,
        fills: &dyn Fills,
        voice: &'static Voice,
    ) {
        self.write_html_line_with(out, fills, Formulas::MathMl, voice);
    }

    /// As `write_html_line`, with its formulas as they are wanted.
    pub fn write_html_line_with(
        &self,
        out: &mut String,
        fills: &dyn Fills,
        formulas: Formulas,
        voice: &'static Voice,
    ) {
        html::write_line(out, &self.blocks, fills, formulas, voice);
    }

    /// Writes the text in LaTeX, its holes filled.
    pub fn latex(&self, fills: &dyn Fills) -> String {
        latex::of(&self.blocks, fills)
    }

    /// As Typst markup, whose formulas are heard in a voice.
    pub fn typst(&self, fills: &dyn Fills, voice: &'static Voice) -> String {
        typst::of(&self.blocks, fills, voice)
    }

    /// Writes the text in Markdown, with formulas between dollar signs, its holes filled.
    pub fn markdown(&self, fills: &dyn Fills) -> String {
        markdown::of(&self.blocks, fills)
    }

    /// As plain text.
    pub fn plain(&self, fills: &dyn Fills) -> String {
        plain::of(&self.blocks, fills)
    }

    /// Writes the decimals within its formulas with another sign.
    pub fn set_decimal_sign(&mut self, sign: &str) {
        for block in &mut self.blocks {
            block.for_each_inset(&mut |inset| match inset {
                Inset::Math(math) => math.set_decimal_sign(sign),
                Inset::Hole(_) => {}
            });
        }
    }

    /// Appends another document: its holes come after those that are here.
    pub fn append(&mut self, other: Document) {
        let offset = self.placeholders.len() as u32;
        let mut blocks = other.blocks;
        for block in &mut blocks {
            block.for_each_inset(&mut |inset| match inset {
                Inset::Math(math) => math.shift_holes(offset),
                Inset::Hole(hole) => *hole += offset,
            });
        }
        self.blocks.append(&mut blocks);
        self.placeholders.extend(other.placeholders);
    }
}

/// What is not words.
enum Inset<'d> {
    Math(&'d mut Math),
    Hole(&'d mut u32),
}

impl Block {
    /// Visits the formulas, and the holes outside of them.
    fn for_each_inset(&mut self, visit: &mut dyn FnMut(Inset<'_>)) {
        match self {
            Self::Paragraph(content) | Self::Heading { content, .. } => {
                Inline::for_each_inset(content, visit);
            }
            Self::List { items, .. } => {
                for block in items.iter_mut().flatten() {
                    block.for_each_inset(visit);
                }
            }
            Self::Table { head, rows, .. } => {
                for cell in head.iter_mut().chain(rows.iter_mut().flatten()) {
                    Inline::for_each_inset(cell, visit);
                }
            }
            Self::Quote(blocks) => {
                for block in blocks {
                    block.for_each_inset(visit);
                }
            }
            Self::Display(math) => visit(Inset::Math(math)),
            Self::Figure(hole) => visit(Inset::Hole(hole)),
            Self::Code(_) | Self::Rule => {}
        }
    }
}

impl Inline {
    fn for_each_inset(content: &mut [Self], visit: &mut dyn FnMut(Inset<'_>)) {
        for inline in content {
            match inline {
                Self::Emphasis(content) | Self::Strong(content) | Self::Link { content, .. } => {
                    Self::for_each_inset(content, visit);
                }
                Self::Math(math) => visit(Inset::Math(math)),
                Self::Hole(hole) => visit(Inset::Hole(hole)),
                Self::Text(_) | Self::Code(_) | Self::Break => {}
            }
        }
    }
}
