//! Plain text for the terminal.
//!
//! Control characters are left out, so that no text can steer the terminal.

use super::fill::InMath;
use super::{Block, Fill, Fills, Inline, Step};
use crate::math::Math;

/// The blocks as plain text, parted by empty lines.
pub(crate) fn of(blocks: &[Block], fills: &dyn Fills) -> String {
    let mut out = String::new();
    PlainWriter {
        out: &mut out,
        fills,
        indent: String::new(),
    }
    .blocks(blocks, false);
    out
}

struct PlainWriter<'a> {
    out: &'a mut String,
    fills: &'a dyn Fills,
    /// What stands before each line of a quotation or list item.
    indent: String,
}

impl PlainWriter<'_> {
    fn blocks(&mut self, blocks: &[Block], tight: bool) {
        for (number, block) in blocks.iter().enumerate() {
            if number > 0 {
                self.line();
                if !tight {
                    self.line();
                }
            }
            self.block(block);
        }
    }

    fn line(&mut self) {
        let end = self.out.trim_end_matches(' ').len();
        self.out.truncate(end);
        self.out.push('\n');
        self.out.push_str(&self.indent);
    }

    fn indented(&mut self, by: &str, write: impl FnOnce(&mut Self)) {
        let length = self.indent.len();
        self.indent.push_str(by);
        write(self);
        self.indent.truncate(length);
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Paragraph(content) | Block::Heading { content, .. } => self.inlines(content),
            Block::List {
                start,
                tight,
                items,
            } => self.list(*start, *tight, items),
            Block::Table { head, rows, .. } => {
                self.table_row(head);
                for row in rows {
                    self.line();
                    self.table_row(row);
                }
            }
            Block::Display(math) => {
                self.out.push_str("    ");
                self.math(math);
            }
            Block::Code(text) => {
                for (number, line) in text.lines().enumerate() {
                    if number > 0 {
                        self.line();
                    }
                    self.out.push_str("    ");
                    self.words(line);
                }
            }
            Block::Quote(blocks) => {
                self.out.push_str("> ");
                self.indented("> ", |writer| writer.blocks(blocks, false));
            }
            Block::Figure(hole) => self.hole(*hole),
            Block::Rule => self.out.push_str("---"),
        }
    }

    fn list(&mut self, start: Option<u64>, tight: bool, items: &[Vec<Block>]) {
        for (number, item) in items.iter().enumerate() {
            if number > 0 {
                self.line();
            }
            let mark = match start {
                Some(start) => format!("{}. ", start.saturating_add(number as u64)),
                None => "- ".to_owned(),
            };
            self.out.push_str(&mark);
            self.indented(&" ".repeat(mark.len()), |writer| writer.blocks(item, tight));
        }
    }

    fn table_row(&mut self, cells: &[Vec<Inline>]) {
        for (number, cell) in cells.iter().enumerate() {
            if number > 0 {
                self.out.push_str(" | ");
            }
            self.inlines(cell);
        }
    }

    fn inlines(&mut self, content: &[Inline]) {
        for inline in content {
            match inline {
                Inline::Text(words) | Inline::Code(words) => self.words(words),
                Inline::Emphasis(content) | Inline::Strong(content) => self.inlines(content),
                Inline::Link { to, content } => {
                    self.inlines(content);
                    self.out.push_str(" (");
                    self.words(to);
                    self.out.push(')');
                }
                Inline::Math(math) => self.math(math),
                Inline::Hole(hole) => self.hole(*hole),
                Inline::Break => self.line(),
            }
        }
    }

    fn words(&mut self, words: &str) {
        self.out
            .extend(words.chars().filter(|char| !char.is_control()));
    }

    fn math(&mut self, math: &Math) {
        math.write_plain(self.out, &InMath(self.fills));
    }

    fn steps(&mut self, steps: &[Step]) {
        for (number, step) in steps.iter().enumerate() {
            if number > 0 {
                self.line();
            }
            if !step.words.is_empty() {
                self.inlines(&step.words);
                self.line();
            }
            let left = |line: &[Math; 2]| {
                let mut out = String::new();
                line[0].write_plain(&mut out, &InMath(self.fills));
                out
            };
            let left: Vec<String> = step.lines.iter().map(left).collect();
            let widest = left.iter().map(|left| left.chars().count()).max();
            for (number, (left, [_, right])) in left.iter().zip(&step.lines).enumerate() {
                if number > 0 {
                    self.line();
                }
                self.out.push_str("    ");
                if let Some(widest) = widest.filter(|widest| *widest > 0) {
                    let missing = widest - left.chars().count();
                    self.out.push_str(&" ".repeat(missing));
                    self.out.push_str(left);
                    self.out.push(' ');
                }
                self.math(right);
            }
        }
    }

    fn hole(&mut self, hole: u32) {
        match self.fills.fill(hole) {
            Some(Fill::Math(Math::Text(words))) => self.words(words),
            Some(Fill::Math(math)) => self.math(math),
            Some(Fill::Figure(text)) => self.words(text),
            Some(Fill::Steps(steps)) => self.steps(steps),
            None => self.out.push('□'),
        }
    }
}
