//! The course as one book for print: chapters of text with figures, plots and worked examples of the bank.
//!
//! All pictures and examples are made of the data in the items' files.

use std::borrow::Cow;

use serde::Serialize;

use super::chapter::{self, ChapterError, ChapterPiece};
use super::layouts::OutputError;
use super::pages::{PageKind, Pages, Run};
use super::view::{QuestionView, View};
use crate::bank::{Catalogue, Space, Template};
use crate::document::{Block, Document, Filling, Inline, TextError};
use crate::instance::Instance;
use crate::numerics::Rational;
use crate::scene::{Data, Scene, Undrawn};
use crate::solution::Solution;
use crate::worksheet::SheetQuestion;

/// Why a chapter cannot be printed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TextbookError {
    /// A text that cannot be set.
    #[error("line {line}: {error}")]
    Text {
        /// From 1.
        line: usize,
        /// What is wrong with it.
        error: TextError,
    },
    /// A line of its own that cannot be read.
    #[error(transparent)]
    Chapter(#[from] ChapterError),
    /// A line that asks for what there is not.
    #[error("line {line}: {message}")]
    Line {
        /// From 1.
        line: usize,
        /// What is wrong with it, and what was expected.
        message: String,
    },
    /// The layout.
    #[error(transparent)]
    Output(#[from] OutputError),
}

#[derive(Serialize)]
struct ChapterView {
    /// The words of its title.
    title: String,
    pieces: Vec<PieceView>,
}

#[derive(Default, Serialize)]
struct PieceView {
    /// The level of a heading, from 2.
    level: Option<u8>,
    /// Its words, a text, or the words under a picture.
    text: String,
    picture: String,
    question: Option<QuestionView>,
}

#[derive(Serialize)]
struct CoursePage<'a> {
    run: &'a Run,
    chapters: Vec<ChapterView>,
}

/// The chapters of a course, each a text, as the body of one file.
///
/// # Errors
///
/// [`TextbookError`], with the place of the chapter.
pub fn textbook_body(
    pages: &Pages,
    chapters: &[&str],
    catalogue: &Catalogue,
) -> Result<String, (usize, TextbookError)> {
    let chapters = chapters.iter().enumerate();
    let chapters = chapters
        .map(|(place, text)| chapter(pages, text, catalogue).map_err(|error| (place, error)))
        .collect::<Result<_, _>>()?;
    let content = CoursePage {
        run: &pages.run,
        chapters,
    };
    let filled = pages.layouts.fill("course", &content);
    filled.map_err(|error| (0, error.into()))
}

fn chapter(pages: &Pages, text: &str, catalogue: &Catalogue) -> Result<ChapterView, TextbookError> {
    let mut title = String::new();
    let (mut pieces, mut examples) = (Vec::new(), 0);
    for (line, piece) in chapter::pieces(text)? {
        let view = match piece {
            ChapterPiece::Heading(1, text) => {
                title = on_one_line(pages, line, text)?;
                continue;
            }
            ChapterPiece::Heading(level, text) => PieceView {
                level: Some(level),
                text: on_one_line(pages, line, text)?,
                ..PieceView::default()
            },
            ChapterPiece::Text(text) => PieceView {
                text: set(pages, line, text)?,
                ..PieceView::default()
            },
            ChapterPiece::Picture { item, plot, words } => {
                let template = known(catalogue, line, item)?;
                let id = pages
                    .writer
                    .line(&Document::sentence(&format!("`{item}`")), pages.run.voice());
                PieceView {
                    picture: picture(pages, line, template, plot)?,
                    text: format!("{} ({id})", on_one_line(pages, line, words)?),
                    ..PieceView::default()
                }
            }
            ChapterPiece::Example(item) => {
                examples += 1;
                PieceView {
                    question: Some(example(pages, examples, known(catalogue, line, item)?)),
                    ..PieceView::default()
                }
            }
        };
        pieces.push(view);
    }
    Ok(ChapterView { title, pieces })
}

/// A text of some blocks, written.
fn set(pages: &Pages, line: usize, text: &str) -> Result<String, TextbookError> {
    let document = read(line, text)?;
    let shown = crate::scene::Shown {
        document: Cow::Borrowed(&document),
        fillings: Vec::<Filling>::new(),
    };
    Ok(pages.writer.texts(&[shown], pages.run.voice()))
}

/// Words on one line, or a heading without its rank, written.
fn on_one_line(pages: &Pages, line: usize, words: &str) -> Result<String, TextbookError> {
    let mut blocks = read(line, words)?.blocks().to_vec();
    for block in &mut blocks {
        if let Block::Heading { content, .. } = block {
            *block = Block::Paragraph(std::mem::take(content));
        }
    }
    Ok(pages
        .writer
        .line(&Document::of(blocks, Vec::new()), pages.run.voice()))
}

fn picture(
    pages: &Pages,
    line: usize,
    template: &Template,
    plot: Option<&str>,
) -> Result<String, TextbookError> {
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both).spoken(pages.run.spoken());
    let fail = |message: String| TextbookError::Line { line, message };
    let svg = match plot {
        Some(name) => {
            let picture = scene.plot(name);
            let picture = picture.map_err(|error: Undrawn| fail(error.to_string()))?;
            picture.svg("plot", &pages.run.spoken())
        }
        None => scene
            .picture()
            .ok_or_else(|| fail(format!("`{}` has no figure", template.id)))?
            .svg
            .clone(),
    };
    Ok(pages.writer.figure(&svg))
}

/// An item with the data of its file and its worked solution.
fn example(pages: &Pages, number: usize, template: &Template) -> QuestionView {
    let solution = Solution::of(Instance::of_source(template));
    let parts = (0..template.parts.len()).filter(|place| solution.asks(*place));
    let parts: Vec<usize> = parts.collect();
    let question = SheetQuestion {
        number,
        place: number,
        points: vec![Rational::ZERO; parts.len()],
        spaces: vec![Space::None; parts.len()],
        bonus: false,
        section: String::new(),
        parts,
        solution,
    };
    View::new(pages.writer, &pages.run, PageKind::Solutions).example(&question)
}

fn known<'c>(
    catalogue: &'c Catalogue,
    line: usize,
    item: &str,
) -> Result<&'c Template, TextbookError> {
    catalogue.find(item).ok_or_else(|| TextbookError::Line {
        line,
        message: format!("there is no item `{item}` in the bank"),
    })
}

/// A text whose lines begin at `line`.
fn read(line: usize, text: &str) -> Result<Document, TextbookError> {
    let reading = Document::read(text);
    if let Some(error) = reading.errors.into_iter().next() {
        let before = text.get(..error.span().range().start).unwrap_or_default();
        let line = line + before.matches('\n').count();
        return Err(TextbookError::Text { line, error });
    }
    let blocks = reading.document.blocks().iter().cloned().map(for_paper);
    Ok(Document::of(blocks.collect(), Vec::new()))
}

/// A block whose links are words: where they lead to an exercise, with its name after.
fn for_paper(block: Block) -> Block {
    match block {
        Block::Paragraph(content) => Block::Paragraph(unlinked(content)),
        Block::Heading { level, content } => Block::Heading {
            level,
            content: unlinked(content),
        },
        Block::List {
            start,
            tight,
            items,
        } => Block::List {
            start,
            tight,
            items: items
                .into_iter()
                .map(|blocks| blocks.into_iter().map(for_paper).collect())
                .collect(),
        },
        Block::Table {
            columns,
            head,
            rows,
        } => Block::Table {
            columns,
            head: head.into_iter().map(unlinked).collect(),
            rows: rows
                .into_iter()
                .map(|row| row.into_iter().map(unlinked).collect())
                .collect(),
        },
        Block::Quote(blocks) => Block::Quote(blocks.into_iter().map(for_paper).collect()),
        other => other,
    }
}

fn unlinked(content: Vec<Inline>) -> Vec<Inline> {
    let mut out = Vec::with_capacity(content.len());
    for inline in content {
        let Inline::Link { to, content } = inline else {
            out.push(inline);
            continue;
        };
        if to.contains("://") {
            out.push(Inline::Link { to, content });
            continue;
        }
        out.extend(content);
        if let Some(item) = exercise(&to) {
            out.extend([
                Inline::Text(" (".to_owned()),
                Inline::Code(item),
                Inline::Text(")".to_owned()),
            ]);
        }
    }
    out
}

/// The item that a link to the pages of exercises leads to: `../exercises/ch1.md#t2-…`.
fn exercise(to: &str) -> Option<String> {
    let (chapter, slug) = to.strip_prefix("../exercises/")?.split_once(".md#")?;
    Some(format!("{chapter}/{slug}"))
}
