//! Markdown with LaTeX math between dollar signs.

use super::fill::InMath;
use super::{Alignment, Block, Fill, Fills, Inline, Step};
use crate::math::Math;

/// The blocks in Markdown, parted by empty lines.
pub(crate) fn of(blocks: &[Block], fills: &dyn Fills) -> String {
    let mut out = String::new();
    MarkdownWriter {
        out: &mut out,
        fills,
        indent: String::new(),
        in_cell: false,
    }
    .blocks(blocks);
    out
}

struct MarkdownWriter<'a> {
    out: &'a mut String,
    fills: &'a dyn Fills,
    /// What stands before each line of a quotation or list item.
    indent: String,
    in_cell: bool,
}

impl MarkdownWriter<'_> {
    fn blocks(&mut self, blocks: &[Block]) {
        for (number, block) in blocks.iter().enumerate() {
            if number > 0 {
                self.line();
                self.line();
            }
            self.block(block);
        }
    }

    /// Begins a new line.
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
            Block::Paragraph(content) => self.paragraph(content),
            Block::Heading { level, content } => {
                for _ in 0..(*level).clamp(1, 6) {
                    self.out.push('#');
                }
                self.out.push(' ');
                self.inlines(content);
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
            Block::Display(math) => self.math(math, "$$"),
            Block::Code(text) => self.code_block(text),
            Block::Quote(blocks) => {
                self.out.push_str("> ");
                self.indented("> ", |writer| writer.blocks(blocks));
            }
            Block::Figure(hole) => self.hole(*hole),
            Block::Rule => self.out.push_str("---"),
        }
    }

    /// A paragraph, whose first characters must not read as the mark of another block.
    fn paragraph(&mut self, content: &[Inline]) {
        let start = self.out.len();
        self.inlines(content);
        let written = &self.out[start..];
        let digits = written.len()
            - written
                .trim_start_matches(|c: char| c.is_ascii_digit())
                .len();
        if written.starts_with(['+', '-', '=', ':']) {
            self.out.insert(start, '\\');
        } else if digits > 0 && written[digits..].starts_with(['.', ')']) {
            self.out.insert(start + digits, '\\');
        }
    }

    fn list(&mut self, start: Option<u64>, tight: bool, items: &[Vec<Block>]) {
        for (number, item) in items.iter().enumerate() {
            if number > 0 {
                self.line();
                if !tight {
                    self.line();
                }
            }
            let mark = match start {
                Some(start) => format!("{}. ", start.saturating_add(number as u64)),
                None => "- ".to_owned(),
            };
            self.out.push_str(&mark);
            self.indented(&" ".repeat(mark.len()), |writer| {
                for (number, block) in item.iter().enumerate() {
                    if number > 0 {
                        writer.line();
                        if !tight {
                            writer.line();
                        }
                    }
                    writer.block(block);
                }
            });
        }
    }

    fn table(&mut self, columns: &[Alignment], head: &[Vec<Inline>], rows: &[Vec<Vec<Inline>>]) {
        self.in_cell = true;
        self.table_row(head);
        self.line();
        for column in columns {
            self.out.push_str(match column {
                Alignment::None => "| --- ",
                Alignment::Left => "| :-- ",
                Alignment::Centre => "| :-: ",
                Alignment::Right => "| --: ",
            });
        }
        self.out.push('|');
        for row in rows {
            self.line();
            self.table_row(row);
        }
        self.in_cell = false;
    }

    fn table_row(&mut self, cells: &[Vec<Inline>]) {
        for cell in cells {
            self.out.push_str("| ");
            self.inlines(cell);
            self.out.push(' ');
        }
        self.out.push('|');
    }

    /// Code between fences longer than any in it.
    fn code_block(&mut self, text: &str) {
        let fence = "`".repeat(longest_run(text, '`').max(2) + 1);
        self.out.push_str(&fence);
        for line in text.lines() {
            self.line();
            self.out.push_str(line);
        }
        self.line();
        self.out.push_str(&fence);
    }

    fn inlines(&mut self, content: &[Inline]) {
        for inline in content {
            self.inline(inline);
        }
    }

    fn inline(&mut self, inline: &Inline) {
        match inline {
            Inline::Text(words) => self.words(words),
            Inline::Emphasis(content) => self.marked("*", content),
            Inline::Strong(content) => self.marked("**", content),
            Inline::Code(text) => {
                let fence = "`".repeat(longest_run(text, '`') + 1);
                let pad = if text.starts_with('`') || text.ends_with('`') {
                    " "
                } else {
                    ""
                };
                for part in [fence.as_str(), pad, text, pad, fence.as_str()] {
                    self.out.push_str(part);
                }
            }
            Inline::Link { to, content } => {
                self.out.push('[');
                self.inlines(content);
                self.out.push_str("](<");
                for char in to.chars().filter(|c| !matches!(c, '<' | '>' | '\n')) {
                    self.out.push(char);
                }
                self.out.push_str(">)");
            }
            Inline::Math(math) => self.math(math, "$"),
            Inline::Hole(hole) => self.hole(*hole),
            Inline::Break => {
                self.out.push('\\');
                self.line();
            }
        }
    }

    fn marked(&mut self, mark: &str, content: &[Inline]) {
        self.out.push_str(mark);
        self.inlines(content);
        self.out.push_str(mark);
    }

    fn words(&mut self, words: &str) {
        for char in words.chars() {
            match char {
                '\n' | '\r' => self.out.push(' '),
                '\\' | '`' | '*' | '[' | ']' | '<' | '>' | '#' | '$' | '|' | '~' | '&' => {
                    self.out.push('\\');
                    self.out.push(char);
                }
                '_' => self.out.push_str("\\_"),
                char if char.is_control() => {}
                char => self.out.push(char),
            }
        }
    }

    /// A formula; in a cell its bars are written as commands, since a bar would end the cell.
    fn math(&mut self, math: &Math, mark: &str) {
        let start = self.out.len();
        self.out.push_str(mark);
        math.write_latex(self.out, &InMath(self.fills));
        let end = self.out.trim_end_matches(' ').len();
        self.out.truncate(end);
        self.out.push_str(mark);
        if self.in_cell && self.out[start..].contains('|') {
            let latex = self.out.split_off(start);
            let latex = latex.replace("\\|", "\\Vert ").replace('|', "\\vert ");
            self.out.push_str(&latex);
        }
    }

    fn steps(&mut self, steps: &[Step]) {
        for (number, step) in steps.iter().enumerate() {
            if number > 0 {
                self.line();
                self.line();
            }
            if !step.words.is_empty() {
                self.paragraph(&step.words);
                self.line();
                self.line();
            }
            self.math(&step.aligned(), "$$");
        }
    }

    fn hole(&mut self, hole: u32) {
        match self.fills.fill(hole) {
            Some(Fill::Math(Math::Text(words))) => self.words(words),
            Some(Fill::Math(math)) => self.math(math, "$"),
            Some(Fill::Figure(markup)) => self.out.push_str(markup),
            Some(Fill::Steps(steps)) => self.steps(steps),
            None => self.out.push('□'),
        }
    }
}

/// The longest run of a character.
fn longest_run(text: &str, mark: char) -> usize {
    text.split(|char| char != mark)
        .map(str::len)
        .max()
        .unwrap_or(0)
}
