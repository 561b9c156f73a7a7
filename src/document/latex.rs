//! LaTeX for the layouts of pages that are edited further.
//!
//! Words are escaped; letters and signs that plain LaTeX does not have are set as mathematics. A
//! figure is `\figureblock` with the [name](picture_name) of a file beside the page.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use super::fill::InMath;
use super::{Alignment, Block, Fill, Fills, Inline, Step};
use crate::math::{Display, Math, Sign, greek_name, is_invisible};

/// The blocks in LaTeX, parted by empty lines.
pub(crate) fn of(blocks: &[Block], fills: &dyn Fills) -> String {
    let mut out = String::new();
    LatexWriter {
        out: &mut out,
        fills,
    }
    .blocks(blocks);
    out
}

/// The name of the file of a figure: the same picture has the same name.
pub(crate) fn picture_name(svg: &str) -> String {
    let mut name = String::from("figure-");
    // Sixty-four bits tell the figures of any run apart, and keep names short.
    for byte in &Sha256::digest(svg.as_bytes())[..8] {
        // Writing to a string cannot fail.
        let _ = write!(name, "{byte:02x}");
    }
    name
}

/// Appends words so that they mean themselves.
pub(crate) fn write_words(out: &mut String, words: &str) {
    let mut before = ' ';
    let mut rest = words.chars().filter(|char| !is_invisible(*char)).peekable();
    while let Some(char) = rest.next() {
        // An accent on its own comes after its letter, and its command before.
        let marks = std::iter::from_fn(|| rest.next_if(|mark| is_combining(*mark)));
        let accents: Vec<&str> = marks.filter_map(accent).collect();
        for accent in accents.iter().rev() {
            out.push_str(accent);
            out.push('{');
        }
        match char {
            // Without a letter there is nothing to accent.
            char if is_combining(char) => {}
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(char);
            }
            '\\' => out.push_str(r"\textbackslash{}"),
            '^' => out.push_str(r"\textasciicircum{}"),
            '~' => out.push_str(r"\textasciitilde{}"),
            '"' => out.push_str(r"\textquotedbl{}"),
            '<' => out.push_str(r"\textless{}"),
            '>' => out.push_str(r"\textgreater{}"),
            // Two of these would become one other sign.
            '-' | '`' | '\'' | ',' if char == before => {
                out.push_str("{}");
                out.push(char);
            }
            '\u{a0}' => out.push('~'),
            char if char.is_control() => out.push(' '),
            char => sign(out, char),
        }
        accents.iter().for_each(|_| out.push('}'));
        before = char;
    }
}

fn is_combining(char: char) -> bool {
    matches!(char, '\u{300}'..='\u{36f}')
}

/// The command of an accent; one that LaTeX does not have is dropped.
fn accent(mark: char) -> Option<&'static str> {
    Some(match mark {
        '\u{300}' => r"\`",
        '\u{301}' => r"\'",
        '\u{302}' => r"\^",
        '\u{303}' => r"\~",
        '\u{304}' => r"\=",
        '\u{306}' => r"\u",
        '\u{307}' => r"\.",
        '\u{308}' => r#"\""#,
        '\u{30a}' => r"\r",
        '\u{30b}' => r"\H",
        '\u{30c}' => r"\v",
        '\u{323}' => r"\d",
        '\u{327}' => r"\c",
        '\u{328}' => r"\k",
        '\u{331}' => r"\b",
        _ => return None,
    })
}

/// A character; what no text font of LaTeX has becomes mathematics.
fn sign(out: &mut String, char: char) {
    let is_in_fonts = char.is_ascii() || "–—‘’“”…°²³µ·×±".contains(char);
    let command = match Sign::of(char) {
        Some(sign) if !is_in_fonts => Some(sign.latex.to_owned()),
        _ => greek_name(char).map(|name| format!("\\{name}")),
    };
    match command {
        Some(command) => {
            out.push_str(r"\ensuremath{");
            out.push_str(&command);
            out.push('}');
        }
        None => out.push(char),
    }
}

struct LatexWriter<'a> {
    out: &'a mut String,
    fills: &'a dyn Fills,
}

impl LatexWriter<'_> {
    fn blocks(&mut self, blocks: &[Block]) {
        for (number, block) in blocks.iter().enumerate() {
            // A formula on its own belongs to the paragraph before it.
            if number > 0 {
                let is_close = matches!(block, Block::Display(_));
                self.out.push_str(if is_close { "\n" } else { "\n\n" });
            }
            self.block(block);
        }
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Paragraph(content) => self.inlines(content),
            // The headings of a page are its questions; those inside a text stay below them.
            Block::Heading { content, .. } => self.around(r"\subsubsection*", content),
            Block::List { start, items, .. } => self.list(*start, items),
            Block::Table {
                columns,
                head,
                rows,
            } => self.table(columns, head, rows),
            Block::Display(math) => self.math(math, Display::Block),
            Block::Code(text) => self.code(text),
            Block::Quote(blocks) => self.environment("quote", |writer| writer.blocks(blocks)),
            Block::Figure(hole) => self.hole(*hole),
            Block::Rule => self.out.push_str(r"\noindent\rule{\linewidth}{.4pt}"),
        }
    }

    fn environment(&mut self, name: &str, write: impl FnOnce(&mut Self)) {
        self.out.push_str("\\begin{");
        self.out.push_str(name);
        self.out.push_str("}\n");
        write(self);
        self.out.push_str("\n\\end{");
        self.out.push_str(name);
        self.out.push('}');
    }

    /// The number is set by hand where it does not begin at one.
    fn list(&mut self, start: Option<u64>, items: &[Vec<Block>]) {
        let name = if start.is_some() {
            "enumerate"
        } else {
            "itemize"
        };
        self.environment(name, |writer| {
            for (number, item) in items.iter().enumerate() {
                writer
                    .out
                    .push_str(if number > 0 { "\n\\item" } else { "\\item" });
                match start {
                    Some(first) if first != 1 => {
                        let _ = write!(writer.out, "[{}.] ", first.saturating_add(number as u64));
                    }
                    // An item that begins with a bracket would be read as its own label.
                    _ => writer.out.push_str("{} "),
                }
                writer.blocks(item);
            }
        });
    }

    fn table(&mut self, columns: &[Alignment], head: &[Vec<Inline>], rows: &[Vec<Vec<Inline>>]) {
        self.out.push_str("\\begin{center}\\begin{tabular}{");
        for column in columns {
            self.out.push(match column {
                Alignment::None | Alignment::Left => 'l',
                Alignment::Centre => 'c',
                Alignment::Right => 'r',
            });
        }
        self.out.push_str("}\n\\toprule\n");
        self.row(head, columns.len());
        self.out.push_str("\\midrule\n");
        for row in rows {
            self.row(row, columns.len());
        }
        self.out
            .push_str("\\bottomrule\n\\end{tabular}\\end{center}");
    }

    fn row(&mut self, cells: &[Vec<Inline>], columns: usize) {
        for column in 0..columns {
            if column > 0 {
                self.out.push_str(" & ");
            }
            self.inlines(cells.get(column).map_or(&[][..], Vec::as_slice));
        }
        // A bracket or an asterisk at the beginning of the next row would be read as an argument.
        self.out.push_str(" \\\\{}\n");
    }

    /// Lines of code, escaped: no text can end a verbatim block before its time.
    fn code(&mut self, text: &str) {
        self.environment("quote", |writer| {
            writer.out.push_str(r"\ttfamily{}");
            for (number, line) in text.lines().enumerate() {
                if number > 0 {
                    writer.out.push_str("\\newline{}");
                }
                write_words(writer.out, &line.replace(' ', "\u{a0}"));
            }
        });
    }

    fn inlines(&mut self, content: &[Inline]) {
        for inline in content {
            self.inline(inline);
        }
    }

    fn inline(&mut self, inline: &Inline) {
        match inline {
            Inline::Text(words) => write_words(self.out, words),
            Inline::Emphasis(content) => self.around(r"\emph", content),
            Inline::Strong(content) => self.around(r"\textbf", content),
            Inline::Code(text) => {
                self.out.push_str(r"\texttt{");
                write_words(self.out, text);
                self.out.push('}');
            }
            Inline::Link { to, content } => {
                self.inlines(content);
                self.out.push_str(r"\footnote{\texttt{");
                write_words(self.out, to);
                self.out.push_str("}}");
            }
            Inline::Math(math) => self.math(math, Display::Inline),
            Inline::Hole(hole) => self.hole(*hole),
            Inline::Break => self.out.push_str("\\newline{}"),
        }
    }

    fn around(&mut self, command: &str, content: &[Inline]) {
        self.out.push_str(command);
        self.out.push('{');
        self.inlines(content);
        self.out.push('}');
    }

    fn math(&mut self, math: &Math, display: Display) {
        let (open, close) = match display {
            Display::Inline => ("$", "$"),
            Display::Block => ("\\[", "\\]"),
        };
        self.out.push_str(open);
        math.write_latex(self.out, &InMath(self.fills));
        let end = self.out.trim_end_matches(' ').len();
        self.out.truncate(end);
        // The blank that was trimmed belonged to `\ `, which would escape the closing sign.
        if self.out.ends_with('\\') {
            self.out.push(' ');
        }
        self.out.push_str(close);
    }

    fn steps(&mut self, steps: &[Step]) {
        for (number, step) in steps.iter().enumerate() {
            if number > 0 {
                self.out.push_str("\n\n");
            }
            self.inlines(&step.words);
            self.out.push('\n');
            self.math(&step.aligned(), Display::Block);
        }
    }

    fn hole(&mut self, hole: u32) {
        match self.fills.fill(hole) {
            Some(Fill::Math(Math::Text(words))) => write_words(self.out, words),
            Some(Fill::Math(math)) => self.math(math, Display::Inline),
            Some(Fill::Figure("")) => {}
            Some(Fill::Figure(svg)) => {
                self.out.push_str(r"\figureblock{");
                self.out.push_str(&picture_name(svg));
                self.out.push('}');
            }
            Some(Fill::Steps(steps)) => self.steps(steps),
            None => write_words(self.out, "□"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::write_words;

    fn words(words: &str) -> String {
        let mut out = String::new();
        write_words(&mut out, words);
        out
    }

    #[test]
    fn accents_on_their_own_become_commands() {
        assert_eq!(words("Ze\u{301}lie"), r"Z\'{e}lie");
        assert_eq!(words("a\u{323}\u{302}"), r"\^{\d{a}}");
        // An accent that LaTeX does not have, and one without a letter.
        assert_eq!(words("x\u{337}y"), "xy");
        assert_eq!(words("\u{301}a"), "a");
    }

    #[test]
    fn characters_without_ink_are_dropped() {
        assert_eq!(words("a\u{202e}b\u{200b}c\u{feff}_"), r"abc\_");
    }
}
