//! Markdown events folded into blocks.

use std::iter::Peekable;
use std::ops::Range;

use pulldown_cmark::{Alignment as Column, Event, OffsetIter, Options, Parser, Tag, TagEnd};

use super::lint::Lint;
use super::mask::Masked;
use super::{TextError, TextReading};
use crate::document::{Alignment, Block, Document, Inline};
use crate::math::holes::{LITERAL, hole, is_private};
use crate::math::{Math, read_all};
use crate::source::Span;

/// The longest text that is read, in bytes.
const LENGTH: usize = 1 << 16;
/// How deep lists, quotations and emphasis may stand in each other.
const DEPTH: usize = 8;
/// Errors of a text that are kept: finding the place of each in its file walks through the text, and nobody reads more.
const MAX_ERRORS: usize = 101;

/// Reads a text.
pub(crate) fn read(text: &str) -> TextReading {
    if text.len() > LENGTH {
        return TextReading {
            document: Document::default(),
            errors: vec![TextError::TooLong {
                length: text.len(),
                limit: LENGTH,
                span: Span::new(0, text.len()),
            }],
        };
    }
    let mut masked = Masked::of(text);
    let source = std::mem::take(&mut masked.text);
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES;
    let mut reader = TextReader {
        events: Parser::new_ext(&source, options)
            .into_offset_iter()
            .peekable(),
        source: &source,
        errors: std::mem::take(&mut masked.errors),
        masked,
        depth: 0,
        in_cell: false,
        lint: Lint::default(),
    };
    let blocks = reader.blocks().1;
    let mut errors = reader.errors;
    errors.sort_by_key(TextError::span);
    errors.truncate(MAX_ERRORS);
    TextReading {
        document: Document::of(blocks, reader.masked.placeholders),
        errors,
    }
}

struct TextReader<'a> {
    events: Peekable<OffsetIter<'a>>,
    /// The masked text.
    source: &'a str,
    masked: Masked,
    errors: Vec<TextError>,
    depth: usize,
    in_cell: bool,
    lint: Lint,
}

impl TextReader<'_> {
    fn span(&self, range: Range<usize>) -> Span {
        self.masked.span(range)
    }

    /// Blocks up to the end of what holds them, and whether some of the words stood without a
    /// paragraph around them.
    fn blocks(&mut self) -> (bool, Vec<Block>) {
        let mut blocks = Vec::new();
        let mut is_tight = false;
        while let Some((event, _)) = self.events.peek() {
            match event {
                Event::End(_) => {
                    self.events.next();
                    break;
                }
                event if is_inline(event) => {
                    is_tight = true;
                    self.paragraph(&mut blocks);
                }
                _ => self.block(&mut blocks),
            }
        }
        (is_tight, blocks)
    }

    fn block(&mut self, blocks: &mut Vec<Block>) {
        let Some((event, range)) = self.events.next() else {
            return;
        };
        match event {
            Event::Rule => blocks.push(Block::Rule),
            Event::Start(tag) => {
                if self.depth == DEPTH {
                    return self.too_deep(range);
                }
                self.depth += 1;
                self.container(tag, range, blocks);
                self.depth -= 1;
            }
            Event::Html(_) => self.html(range),
            _ => {}
        }
    }

    fn too_deep(&mut self, range: Range<usize>) {
        let span = self.span(range);
        self.errors.push(TextError::TooDeep { span });
        self.skip();
    }

    /// Passes over what is open, up to its end.
    fn skip(&mut self) {
        let mut depth = 1;
        while depth > 0 {
            match self.events.next() {
                Some((Event::Start(_), _)) => depth += 1,
                Some((Event::End(_), _)) => depth -= 1,
                Some(_) => {}
                None => return,
            }
        }
    }

    fn html(&mut self, range: Range<usize>) {
        let span = self.span(range);
        self.errors.push(TextError::Html { span });
    }

    /// A block whose start has been taken, with its end.
    fn container(&mut self, tag: Tag<'_>, range: Range<usize>, blocks: &mut Vec<Block>) {
        match tag {
            Tag::Paragraph => {
                self.paragraph(blocks);
                self.events.next();
            }
            Tag::Heading { level, .. } => {
                let content = self.inlines();
                blocks.push(Block::Heading {
                    level: level as u8,
                    content,
                });
            }
            Tag::BlockQuote(_) => {
                let inner = self.blocks().1;
                blocks.push(Block::Quote(inner));
            }
            Tag::List(start) => self.list(start, blocks),
            Tag::CodeBlock(_) => {
                let code = self.code_block();
                blocks.push(Block::Code(code));
            }
            Tag::Table(columns) => self.table(&columns, blocks),
            Tag::HtmlBlock => {
                self.html(range);
                self.skip();
            }
            _ => self.skip(),
        }
    }

    /// Words up to the end of a paragraph, which is left; a formula on its own parts them.
    fn paragraph(&mut self, blocks: &mut Vec<Block>) {
        let mut content = Vec::new();
        let mut place = None;
        while let Some((event, range)) = self.events.next_if(|(event, _)| is_inline(event)) {
            place.get_or_insert(range.clone());
            if let Event::DisplayMath(latex) = event {
                self.close_paragraph(&mut content, place.take(), blocks);
                if let Some(math) = self.math(&latex, range, 2) {
                    blocks.push(Block::Display(math));
                }
            } else {
                self.inline(event, range, &mut content);
            }
        }
        self.close_paragraph(&mut content, place, blocks);
    }

    fn close_paragraph(
        &mut self,
        content: &mut Vec<Inline>,
        place: Option<Range<usize>>,
        blocks: &mut Vec<Block>,
    ) {
        trim(content);
        let mut content = std::mem::take(content);
        if let [Inline::Hole(hole)] = content.as_slice()
            && self.is_block(*hole)
        {
            blocks.push(Block::Figure(*hole));
            return;
        }
        if place.is_some() && !content.is_empty() {
            self.refuse_figures(&mut content);
            blocks.push(Block::Paragraph(content));
        }
    }

    fn is_block(&self, hole: u32) -> bool {
        self.masked
            .placeholders
            .get(hole as usize)
            .is_some_and(crate::document::Placeholder::is_block)
    }

    /// A figure or derivation stands in a paragraph of its own.
    fn refuse_figures(&mut self, content: &mut Vec<Inline>) {
        let figures: Vec<u32> = content
            .iter()
            .filter_map(|inline| match inline {
                Inline::Hole(hole) if self.is_block(*hole) => Some(*hole),
                _ => None,
            })
            .collect();
        for hole in &figures {
            self.misplaced(
                *hole,
                "the words of a paragraph if it is a figure or a derivation",
            );
        }
        content.retain(|inline| !matches!(inline, Inline::Hole(hole) if figures.contains(hole)));
    }

    fn misplaced(&mut self, hole: u32, place: &'static str) {
        if let Some(placeholder) = self.masked.placeholders.get(hole as usize) {
            let span = placeholder.span;
            self.errors
                .push(TextError::MisplacedPlaceholder { place, span });
        }
    }

    fn list(&mut self, start: Option<u64>, blocks: &mut Vec<Block>) {
        let mut items = Vec::new();
        let mut tight = false;
        while let Some((event, _)) = self.events.next() {
            match event {
                Event::Start(Tag::Item) => {
                    let (is_tight, item) = self.blocks();
                    tight |= is_tight;
                    items.push(item);
                }
                Event::End(_) => break,
                _ => {}
            }
        }
        blocks.push(Block::List {
            start,
            tight,
            items,
        });
    }

    fn code_block(&mut self) -> String {
        let mut code = String::new();
        for (event, _) in self.events.by_ref() {
            match event {
                Event::End(TagEnd::CodeBlock) => break,
                Event::Text(text) => code.push_str(&text),
                _ => {}
            }
        }
        self.literal(&code)
    }

    /// Code, in which nothing is a placeholder.
    fn literal(&mut self, code: &str) -> String {
        for hole in code.chars().filter_map(hole) {
            self.misplaced(hole, "code");
        }
        unmask(code)
    }

    fn table(&mut self, columns: &[Column], blocks: &mut Vec<Block>) {
        let mut rows = Vec::new();
        self.in_cell = true;
        while let Some((event, _)) = self.events.next() {
            match event {
                Event::Start(Tag::TableHead | Tag::TableRow) => rows.push(Vec::new()),
                Event::Start(Tag::TableCell) => {
                    let mut cell = self.inlines();
                    self.refuse_figures(&mut cell);
                    if let Some(row) = rows.last_mut() {
                        row.push(cell);
                    }
                }
                Event::End(TagEnd::Table) => break,
                _ => {}
            }
        }
        self.in_cell = false;
        let mut rows = rows.into_iter();
        blocks.push(Block::Table {
            columns: columns.iter().map(|column| alignment(*column)).collect(),
            head: rows.next().unwrap_or_default(),
            rows: rows.collect(),
        });
    }

    /// Words up to the end of what holds them, which is taken.
    fn inlines(&mut self) -> Vec<Inline> {
        let mut content = Vec::new();
        while let Some((event, range)) = self.events.next() {
            if let Event::End(_) = event {
                break;
            }
            self.inline(event, range, &mut content);
        }
        trim(&mut content);
        self.refuse_figures(&mut content);
        content
    }

    fn inline(&mut self, event: Event<'_>, range: Range<usize>, content: &mut Vec<Inline>) {
        match event {
            Event::Text(text) => {
                self.look_over(range);
                words(&text, content);
            }
            Event::Code(text) => {
                let code = self.literal(&text);
                content.push(Inline::Code(code));
            }
            Event::InlineMath(latex) => {
                content.extend(self.math(&latex, range, 1).map(Inline::Math));
            }
            Event::DisplayMath(latex) => {
                content.extend(self.math(&latex, range, 2).map(Inline::Math));
            }
            Event::InlineHtml(_) | Event::Html(_) => self.html(range),
            Event::SoftBreak => words(" ", content),
            Event::HardBreak => content.push(Inline::Break),
            Event::Start(tag) => {
                if self.depth == DEPTH {
                    return self.too_deep(range);
                }
                self.depth += 1;
                self.span_of_words(tag, range, content);
                self.depth -= 1;
            }
            _ => {}
        }
    }

    fn span_of_words(&mut self, tag: Tag<'_>, range: Range<usize>, content: &mut Vec<Inline>) {
        match tag {
            Tag::Emphasis => content.push(Inline::Emphasis(self.inlines())),
            Tag::Strong => content.push(Inline::Strong(self.inlines())),
            Tag::Link { dest_url, .. } => {
                let inner = self.inlines();
                self.link(&dest_url, range, inner, content);
            }
            Tag::Image { .. } => {
                let span = self.span(range);
                self.errors.push(TextError::Image { span });
                self.skip();
            }
            _ => self.skip(),
        }
    }

    fn link(
        &mut self,
        to: &str,
        range: Range<usize>,
        inner: Vec<Inline>,
        content: &mut Vec<Inline>,
    ) {
        let mut holes = to.chars().filter_map(hole).peekable();
        if holes.peek().is_some() {
            holes.for_each(|hole| self.misplaced(hole, "the target of a link"));
        } else if leads_to_a_page(to) {
            content.push(Inline::Link {
                to: unmask(to),
                content: inner,
            });
        } else {
            let to = unmask(to).chars().take(80).collect();
            let span = self.span(range);
            self.errors.push(TextError::Link { to, span });
        }
    }

    fn look_over(&mut self, range: Range<usize>) {
        let error = self.lint.stray_math(self.source, self.in_cell, range);
        if let Some(error) = error {
            let span = self.span(error.span().range());
            self.errors.push(error.at(span));
        }
    }

    /// A formula between `fence` dollar signs on each side.
    fn math(&mut self, latex: &str, range: Range<usize>, fence: usize) -> Option<Math> {
        for hole in latex.chars().filter_map(hole) {
            if self.is_block(hole) {
                self.misplaced(hole, "a formula if it is a figure or a derivation");
            }
            if let Some(placeholder) = self.masked.placeholders.get_mut(hole as usize) {
                placeholder.in_math = true;
            }
        }
        let inside = range.start + fence..range.end.saturating_sub(fence).max(range.start + fence);
        let is_verbatim = self.source.get(inside.clone()) == Some(latex);
        match read_all(latex) {
            Ok(math) => return Some(math),
            Err(errors) => {
                for error in errors {
                    let local = error.span().range();
                    let place = if is_verbatim {
                        inside.start + local.start..inside.start + local.end
                    } else {
                        range.clone()
                    };
                    let span = self.span(place);
                    self.errors.push(error.at(span).into());
                }
            }
        }
        None
    }
}

fn is_inline(event: &Event<'_>) -> bool {
    match event {
        Event::Text(_)
        | Event::Code(_)
        | Event::InlineMath(_)
        | Event::DisplayMath(_)
        | Event::InlineHtml(_)
        | Event::SoftBreak
        | Event::HardBreak => true,
        Event::Start(tag) => matches!(
            tag,
            Tag::Emphasis | Tag::Strong | Tag::Link { .. } | Tag::Image { .. }
        ),
        _ => false,
    }
}

/// Appends words, joined to those before, their holes beside them.
fn words(text: &str, content: &mut Vec<Inline>) {
    let mut rest = text;
    while !rest.is_empty() {
        let end = rest.find(is_private).unwrap_or(rest.len());
        join(&rest[..end], content);
        rest = &rest[end..];
        let mut masked = rest.chars();
        if let Some(char) = masked.next() {
            rest = masked.as_str();
            match hole(char) {
                Some(hole) => content.push(Inline::Hole(hole)),
                None if char == LITERAL => join("<<", content),
                None => join(char.encode_utf8(&mut [0; 4]), content),
            }
        }
    }
}

/// Appends words without holes.
fn join(words: &str, content: &mut Vec<Inline>) {
    match content.last_mut() {
        _ if words.is_empty() => {}
        Some(Inline::Text(before)) => before.push_str(words),
        _ => content.push(Inline::Text(words.to_owned())),
    }
}

/// Takes blanks off both ends.
fn trim(content: &mut Vec<Inline>) {
    if let Some(Inline::Text(words)) = content.first_mut() {
        let blanks = words.len() - words.trim_start().len();
        words.drain(..blanks);
    }
    if let Some(Inline::Text(words)) = content.last_mut() {
        words.truncate(words.trim_end().len());
    }
    content.retain(|inline| !matches!(inline, Inline::Text(words) if words.is_empty()));
}

/// Text without the characters of the mask.
fn unmask(text: &str) -> String {
    text.replace(LITERAL, "<<").replace(is_private, "")
}

fn leads_to_a_page(to: &str) -> bool {
    let is_whole = ["https://", "http://"].iter().any(|scheme| {
        to.get(..scheme.len())
            .is_some_and(|start| start.eq_ignore_ascii_case(scheme))
    });
    let head = &to[..to.find(['/', '?', '#']).unwrap_or(to.len())];
    let is_relative = !to.starts_with("//") && !to.starts_with('\\') && !head.contains(':');
    (is_whole || is_relative) && !to.chars().any(|c| c.is_control() || c.is_whitespace())
}

fn alignment(column: Column) -> Alignment {
    match column {
        Column::None => Alignment::None,
        Column::Left => Alignment::Left,
        Column::Center => Alignment::Centre,
        Column::Right => Alignment::Right,
    }
}
