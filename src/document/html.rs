//! HTML fragments with MathML, or with TeX where a course platform typesets that.
//!
//! All words are escaped; the only markup that passes through is that of a [`Fill::Figure`].

use std::fmt::Write;

use super::fill::InMath;
use super::{Alignment, Block, Fill, Fills, Inline, Step};
use crate::math::{Display, Empty, Holes, Math, Voice, escape, write_mathml_line};

/// How formulas stand in HTML.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Formulas {
    /// As MathML, which browsers typeset.
    #[default]
    MathMl,
    /// As MathML that says about how wide it is, `--w`, so that a style sheet can keep it within its page.
    Measured,
    /// As TeX between `\(` and `\)`, or `\[` and `\]`, which MathJax and filters of platforms typeset.
    Tex,
}

/// Em that any page has room for.
const NARROW: f64 = 6.0;

impl Formulas {
    /// Appends a formula, which is heard in a voice.
    pub fn write(self, out: &mut String, math: &Math, display: Display, voice: &'static Voice) {
        self.write_with(out, math, display, &Empty, voice);
    }

    /// Whether it is TeX, which the core without texts does not write.
    fn is_tex(self) -> bool {
        cfg!(feature = "render") && self == Self::Tex
    }

    /// An attribute with the width of what may be too wide for a page in large print.
    fn measure(self, width: impl Fn() -> f64) -> Option<String> {
        let width = Some(width).filter(|_| self == Self::Measured)?();
        (width > NARROW).then(|| format!(" style=\"--w:{}\"", width.ceil()))
    }

    fn write_with(
        self,
        out: &mut String,
        math: &Math,
        display: Display,
        holes: &dyn Holes,
        voice: &'static Voice,
    ) {
        if !self.is_tex() {
            let from = out.len();
            math.write_mathml(out, display, holes, voice);
            if let Some(measure) = self.measure(|| math.width(holes)) {
                out.insert_str(from + "<math".len(), &measure);
            }
            return;
        }
        let [open, close] = match display {
            Display::Inline => ["\\(", "\\)"],
            Display::Block => ["\\[", "\\]"],
        };
        let mut tex = String::new();
        math.write_latex(&mut tex, holes);
        out.push_str(open);
        escape(out, &tex);
        out.push_str(close);
    }
}

/// Appends the blocks, each on a line of its own.
pub(crate) fn write(
    out: &mut String,
    blocks: &[Block],
    fills: &dyn Fills,
    formulas: Formulas,
    voice: &'static Voice,
) {
    HtmlWriter::new(out, fills, formulas, voice).blocks(blocks);
}

/// Appends the words of a text of one paragraph without an element around them; a text of any other shape is written
/// whole.
pub(crate) fn write_line(
    out: &mut String,
    blocks: &[Block],
    fills: &dyn Fills,
    formulas: Formulas,
    voice: &'static Voice,
) {
    let mut writer = HtmlWriter::new(out, fills, formulas, voice);
    match blocks {
        [Block::Paragraph(content)] => writer.inlines(content),
        blocks => writer.blocks(blocks),
    }
}

struct HtmlWriter<'a> {
    out: &'a mut String,
    fills: &'a dyn Fills,
    formulas: Formulas,
    voice: &'static Voice,
}

impl<'a> HtmlWriter<'a> {
    fn new(
        out: &'a mut String,
        fills: &'a dyn Fills,
        formulas: Formulas,
        voice: &'static Voice,
    ) -> Self {
        Self {
            out,
            fills,
            formulas,
            voice,
        }
    }

    fn blocks(&mut self, blocks: &[Block]) {
        for block in blocks {
            self.block(block);
            self.out.push('\n');
        }
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Paragraph(content) => self.element("p", content),
            Block::Heading { level, content } => {
                let level = (*level).clamp(1, 6);
                self.element(
                    ["h1", "h2", "h3", "h4", "h5", "h6"][level as usize - 1],
                    content,
                );
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
                self.out.push_str("<pre><code>");
                escape(self.out, text);
                self.out.push_str("</code></pre>");
            }
            Block::Quote(blocks) => {
                self.out.push_str("<blockquote>\n");
                self.blocks(blocks);
                self.out.push_str("</blockquote>");
            }
            Block::Figure(hole) => self.hole(*hole),
            Block::Rule => self.out.push_str("<hr>"),
        }
    }

    fn element(&mut self, tag: &str, content: &[Inline]) {
        self.open(tag);
        self.inlines(content);
        self.close(tag);
    }

    fn open(&mut self, tag: &str) {
        self.out.push('<');
        self.out.push_str(tag);
        self.out.push('>');
    }

    fn close(&mut self, tag: &str) {
        self.out.push_str("</");
        self.out.push_str(tag);
        self.out.push('>');
    }

    fn list(&mut self, start: Option<u64>, tight: bool, items: &[Vec<Block>]) {
        let tag = if start.is_some() { "ol" } else { "ul" };
        match start {
            Some(start) if start != 1 => {
                // Writing to a string cannot fail.
                let _ = write!(self.out, "<ol start=\"{start}\">");
            }
            _ => self.open(tag),
        }
        for item in items {
            self.open("li");
            for block in item {
                match block {
                    Block::Paragraph(content) if tight => self.inlines(content),
                    block => self.block(block),
                }
            }
            self.close("li");
        }
        self.close(tag);
    }

    fn table(&mut self, columns: &[Alignment], head: &[Vec<Inline>], rows: &[Vec<Vec<Inline>>]) {
        self.out.push_str("<table><thead>");
        self.table_row("th", columns, head);
        self.out.push_str("</thead><tbody>");
        for row in rows {
            self.table_row("td", columns, row);
        }
        self.out.push_str("</tbody></table>");
    }

    fn table_row(&mut self, tag: &str, columns: &[Alignment], cells: &[Vec<Inline>]) {
        self.open("tr");
        for (number, cell) in cells.iter().enumerate() {
            self.out.push('<');
            self.out.push_str(tag);
            self.out.push_str(match columns.get(number) {
                Some(Alignment::Left) => " style=\"text-align:left\">",
                Some(Alignment::Centre) => " style=\"text-align:center\">",
                Some(Alignment::Right) => " style=\"text-align:right\">",
                Some(Alignment::None) | None => ">",
            });
            self.inlines(cell);
            self.close(tag);
        }
        self.close("tr");
    }

    fn inlines(&mut self, content: &[Inline]) {
        let mut tied = 0;
        for (place, inline) in content.iter().enumerate() {
            let from = self.out.len();
            match inline {
                Inline::Text(words) => escape(self.out, &words[tied..]),
                other => self.inline(other),
            }
            tied = 0;
            if self.out[from..].ends_with("</math>") {
                tied = self.tie(from, content.get(place + 1));
            }
        }
    }

    /// Keeps a formula that begins at `from` on one line with the bracket before it and with what
    /// follows up to the next space: browsers break lines there. Tells how much of the next text is
    /// written with it.
    fn tie(&mut self, from: usize, next: Option<&Inline>) -> usize {
        let after = match next {
            Some(Inline::Text(words)) => words.split(char::is_whitespace).next().unwrap_or(""),
            _ => "",
        };
        let bracket = usize::from(self.out[..from].ends_with(['(', '[']));
        if after.is_empty() && bracket == 0 {
            return 0;
        }
        self.out.insert_str(from - bracket, "<span class=\"tie\">");
        escape(self.out, after);
        self.out.push_str("</span>");
        after.len()
    }

    fn inline(&mut self, inline: &Inline) {
        match inline {
            Inline::Text(words) => escape(self.out, words),
            Inline::Emphasis(content) => self.element("em", content),
            Inline::Strong(content) => self.element("strong", content),
            Inline::Code(text) => {
                self.open("code");
                escape(self.out, text);
                self.close("code");
            }
            Inline::Link { to, content } => {
                self.out.push_str("<a href=\"");
                escape(self.out, to);
                self.out.push_str("\">");
                self.inlines(content);
                self.close("a");
            }
            Inline::Math(math) => self.math(math, Display::Inline),
            Inline::Hole(hole) => self.hole(*hole),
            Inline::Break => self.out.push_str("<br>"),
        }
    }

    /// Each line is a formula of its own, so that it is heard by itself; the style sheet aligns them.
    fn steps(&mut self, steps: &[Step]) {
        for (number, step) in steps.iter().enumerate() {
            if number > 0 {
                self.out.push('\n');
            }
            if !step.words.is_empty() {
                self.element("p", &step.words);
            }
            if self.formulas.is_tex() {
                self.math(&step.aligned(), Display::Block);
                continue;
            }
            let width = |side: usize| {
                let lines = step.lines.iter();
                let widths = lines.map(|line| line[side].width(&InMath(self.fills)));
                widths.fold(0.0, f64::max)
            };
            let measure = self.formulas.measure(|| width(0) + width(1));
            let measure = measure.unwrap_or_default();
            let _ = write!(self.out, "<div class=\"steps\"{measure}>");
            for [left, right] in &step.lines {
                write_mathml_line(self.out, left, right, &InMath(self.fills), self.voice);
            }
            self.out.push_str("</div>");
        }
    }

    fn math(&mut self, math: &Math, display: Display) {
        let holes = InMath(self.fills);
        self.formulas
            .write_with(self.out, math, display, &holes, self.voice);
    }

    fn hole(&mut self, hole: u32) {
        match self.fills.fill(hole) {
            Some(Fill::Math(Math::Text(words))) => escape(self.out, words),
            Some(Fill::Math(math)) => self.math(math, Display::Inline),
            Some(Fill::Figure(markup)) => self.out.push_str(markup),
            Some(Fill::Steps(steps)) => self.steps(steps),
            None => self.out.push('□'),
        }
    }
}
