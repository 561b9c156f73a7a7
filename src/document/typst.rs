//! Typst markup for the layouts of printed pages.
//!
//! Words are quoted strings of Typst's code mode, so nothing that stands in a text can be read as
//! Typst. A figure is a call of `picture(words, markup)`, in a text inside of `figure-block`; the layouts define both.

use super::fill::InMath;
use super::{Alignment, Block, Fill, Fills, Inline, Step};
use crate::math::{Display, Math, Voice, quote};

/// The blocks in Typst, parted by empty lines.
pub(crate) fn of(blocks: &[Block], fills: &dyn Fills, voice: &'static Voice) -> String {
    let mut out = String::new();
    TypstWriter {
        out: &mut out,
        fills,
        voice,
    }
    .blocks(blocks);
    out
}

struct TypstWriter<'a> {
    out: &'a mut String,
    fills: &'a dyn Fills,
    voice: &'static Voice,
}

impl TypstWriter<'_> {
    fn blocks(&mut self, blocks: &[Block]) {
        for (number, block) in blocks.iter().enumerate() {
            if number > 0 {
                self.out.push_str("\n\n");
            }
            match block {
                // What announces the next block does not end a page.
                Block::Paragraph(content)
                    if number + 1 < blocks.len() && is_announcement(content) =>
                {
                    self.sticky(content);
                }
                _ => self.block(block),
            }
        }
    }

    /// On the page of what follows.
    fn sticky(&mut self, content: &[Inline]) {
        self.out.push_str("#block(sticky:true)[");
        self.inlines(content);
        self.out.push(']');
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Paragraph(content) => self.inlines(content),
            // The headings of a page are its questions; those inside a text stay below them.
            Block::Heading { content, .. } => {
                self.out.push_str("#block(sticky:true)[");
                self.around("strong", content);
                self.out.push(']');
            }
            Block::List {
                start,
                tight,
                items,
            } => self.list(*start, *tight, items),
            Block::Table {
                columns,
                head,
                rows,
            } => self.table(columns, head, rows),
            Block::Display(math) => self.math(math, Display::Block),
            Block::Code(text) => {
                self.out.push_str("#raw(block:true,");
                quote(self.out, text);
                self.out.push(')');
            }
            Block::Quote(blocks) => {
                self.out.push_str("#quote(block:true)[");
                self.blocks(blocks);
                self.out.push(']');
            }
            Block::Figure(hole) => self.hole(*hole),
            Block::Rule => self
                .out
                // A line on the page is nothing to be read aloud.
                .push_str("#pdf.artifact(line(length:100%,stroke:.5pt))"),
        }
    }

    fn list(&mut self, start: Option<u64>, tight: bool, items: &[Vec<Block>]) {
        match start {
            Some(start) => self
                .out
                .push_str(&format!("#enum(start:{start},tight:{tight}")),
            None => self.out.push_str(&format!("#list(tight:{tight}")),
        }
        for item in items {
            self.out.push_str(",[");
            self.blocks(item);
            self.out.push(']');
        }
        self.out.push(')');
    }

    fn table(&mut self, columns: &[Alignment], head: &[Vec<Inline>], rows: &[Vec<Vec<Inline>>]) {
        self.out
            .push_str(&format!("#table(columns:{},align:(", columns.len().max(1)));
        for column in columns {
            self.out.push_str(match column {
                Alignment::None | Alignment::Left => "left,",
                Alignment::Centre => "center,",
                Alignment::Right => "right,",
            });
        }
        self.out.push_str("),table.header(");
        self.cells(head, columns.len());
        self.out.push_str("),");
        for row in rows {
            self.cells(row, columns.len());
        }
        self.out.push(')');
    }

    fn cells(&mut self, cells: &[Vec<Inline>], columns: usize) {
        for column in 0..columns {
            self.out.push('[');
            self.inlines(cells.get(column).map_or(&[][..], Vec::as_slice));
            self.out.push_str("],");
        }
    }

    fn inlines(&mut self, content: &[Inline]) {
        for inline in content {
            self.inline(inline);
        }
    }

    fn inline(&mut self, inline: &Inline) {
        match inline {
            Inline::Text(words) => self.words(words),
            Inline::Emphasis(content) => self.around("emph", content),
            Inline::Strong(content) => self.around("strong", content),
            Inline::Code(text) => {
                self.out.push_str("#raw(");
                quote(self.out, text);
                self.out.push(')');
            }
            Inline::Link { to, content } => {
                self.out.push_str("#link(");
                quote(self.out, to);
                self.out.push_str(")[");
                self.inlines(content);
                self.out.push(']');
            }
            Inline::Math(math) => self.math(math, Display::Inline),
            Inline::Hole(hole) => self.hole(*hole),
            Inline::Break => self.out.push_str("#linebreak()"),
        }
    }

    fn around(&mut self, function: &str, content: &[Inline]) {
        self.out.push('#');
        self.out.push_str(function);
        self.out.push('[');
        self.inlines(content);
        self.out.push(']');
    }

    fn words(&mut self, words: &str) {
        self.out.push('#');
        quote(self.out, &words.replace(['\n', '\r'], " "));
    }

    fn math(&mut self, math: &Math, display: Display) {
        math.write_typst(self.out, display, &InMath(self.fills), self.voice);
    }

    fn steps(&mut self, steps: &[Step]) {
        for (number, step) in steps.iter().enumerate() {
            if number > 0 {
                self.out.push_str("\n\n");
            }
            if !step.words.is_empty() {
                self.sticky(&step.words);
                self.out.push_str("\n\n");
            }
            self.math(&step.aligned(), Display::Block);
        }
    }

    fn hole(&mut self, hole: u32) {
        match self.fills.fill(hole) {
            Some(Fill::Math(Math::Text(words))) => self.words(words),
            Some(Fill::Math(math)) => self.math(math, Display::Inline),
            Some(Fill::Figure("")) => {}
            Some(Fill::Figure(svg)) => {
                self.out.push_str("#figure-block(");
                write_picture(self.out, svg);
                self.out.push(')');
            }
            Some(Fill::Steps(steps)) => self.steps(steps),
            None => self.words("□"),
        }
    }
}

/// Whether a paragraph ends with a colon.
fn is_announcement(content: &[Inline]) -> bool {
    matches!(content.last(), Some(Inline::Text(words)) if words.trim_end().ends_with(':'))
}

/// Appends the call that sets a figure with its words, which are those of its `title` and `desc`.
///
/// The drawing goes without them and without its identity, which is that of a sheet: one that looks alike on all sheets
/// is read once by the press.
pub(crate) fn write_picture(out: &mut String, svg: &str) {
    let mut drawing = svg.to_owned();
    let words: Vec<String> = ["title", "desc"]
        .iter()
        .filter_map(|name| take_element(&mut drawing, name))
        .map(|words| unescaped(&words))
        .collect();
    take_between(&mut drawing, " aria-labelledby=\"", "\"");
    out.push_str("picture(");
    quote(out, &words.join(". "));
    out.push(',');
    quote(out, &drawing);
    out.push(')');
}

/// Takes the first element of this name out; what stood in it.
fn take_element(svg: &mut String, name: &str) -> Option<String> {
    let element = take_between(svg, &format!("<{name}"), &format!("</{name}>"))?;
    let (_, words) = element.split_once('>')?;
    Some(words.to_owned())
}

/// Takes out the first place that begins and ends so; what stood between.
fn take_between(text: &mut String, begin: &str, end: &str) -> Option<String> {
    let from = text.find(begin)?;
    let inner = from + begin.len();
    let length = text[inner..].find(end)?;
    let between = text[inner..inner + length].to_owned();
    text.replace_range(from..inner + length + end.len(), "");
    Some(between)
}

/// The characters that our writers of markup escape.
fn unescaped(words: &str) -> String {
    words
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&#39;", "'")
        .replace("&amp;", "&")
}
