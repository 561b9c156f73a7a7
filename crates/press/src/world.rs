//! What Typst sees of the world: one source text, the embedded fonts and those of the job, no other file, no clock.
//!
//! All contact with Typst is in this file. A text can read no file, fetch nothing and not tell the
//! time, so the same text gives the same bytes.

use std::sync::{Arc, Mutex, PoisonError};

use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World, WorldExt};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

/// A tagged PDF that keeps to PDF/UA-1, or what Typst says is wrong with the text.
///
/// `fonts` are files of further fonts that it may fall back on.
pub(crate) fn accessible(text: String, fonts: &[String]) -> Result<Vec<u8>, String> {
    let standards =
        PdfStandards::new(&[PdfStandard::Ua_1]).map_err(|error| error.message().to_string())?;
    pdf(text, fonts, |options| options.standards = standards)
}

/// A PDF of one picture, to be placed in another document, which has the words for it.
pub(crate) fn picture(text: String) -> Result<Vec<u8>, String> {
    pdf(text, &[], |options| options.tagged = false)
}

fn pdf(
    text: String,
    fonts: &[String],
    choose: impl FnOnce(&mut PdfOptions),
) -> Result<Vec<u8>, String> {
    let mut options = PdfOptions {
        ident: Smart::Custom(text.clone()),
        ..PdfOptions::default()
    };
    choose(&mut options);
    let shelf = shelf(fonts)?;
    let desk = Desk::with(&shelf, text);
    let document = typst::compile::<PagedDocument>(&desk).output;
    let bytes = document.and_then(|document| typst_pdf::pdf(&document, &options));
    forget_the_unused();
    bytes.map_err(|errors| desk.explain(&errors))
}

/// Drops what Typst keeps and none of the last texts has used, which would grow without end.
fn forget_the_unused() {
    /// A sheet, its key and its solutions have figures and words in common, with each other and with those of the next.
    const TEXTS: usize = 3;
    comemo::evict(TEXTS);
}

/// What does not change from text to text.
struct Shelf {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
    main: FileId,
}

/// The shelf with these fonts besides the embedded ones. One is kept: a run has the same fonts from page to page.
fn shelf(fonts: &[String]) -> Result<Arc<Shelf>, String> {
    static KEPT: Mutex<Option<(Vec<String>, Arc<Shelf>)>> = Mutex::new(None);
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((same, shelf)) = &*kept
        && same == fonts
    {
        return Ok(Arc::clone(shelf));
    }
    let shelf = Arc::new(Shelf::with(fonts)?);
    *kept = Some((fonts.to_vec(), Arc::clone(&shelf)));
    Ok(shelf)
}

impl Shelf {
    fn with(files: &[String]) -> Result<Self, String> {
        let mut fonts: Vec<Font> = typst_assets::fonts()
            .flat_map(|data| Font::iter(Bytes::new(data)))
            .collect();
        for file in files {
            let data = std::fs::read(file)
                .map_err(|error| format!("cannot read the font `{file}`: {error}"))?;
            fonts.extend(Font::iter(Bytes::new(data)));
        }
        let path = VirtualPath::new("main.typ").expect("a plain relative path");
        Ok(Self {
            library: LazyHash::new(Library::default()),
            book: LazyHash::new(FontBook::from_fonts(&fonts)),
            fonts,
            main: FileId::new(RootedPath::new(VirtualRoot::Project, path)),
        })
    }
}

/// One text on the desk, all else on the shelf.
struct Desk<'s> {
    shelf: &'s Shelf,
    source: Source,
}

impl<'s> Desk<'s> {
    fn with(shelf: &'s Shelf, text: String) -> Self {
        Self {
            shelf,
            source: Source::new(shelf.main, text),
        }
    }

    /// The messages of Typst, each with its line.
    fn explain(&self, errors: &[SourceDiagnostic]) -> String {
        let explained = errors.iter().map(|error| {
            let place = self.range(error.span);
            let line = place.and_then(|range| self.source.lines().byte_to_line(range.start));
            match line {
                Some(line) => format!("{} in line {}", error.message, line + 1),
                None => error.message.to_string(),
            }
        });
        explained.collect::<Vec<_>>().join("; ")
    }
}

impl World for Desk<'_> {
    fn library(&self) -> &LazyHash<Library> {
        &self.shelf.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &self.shelf.book
    }

    fn main(&self) -> FileId {
        self.shelf.main
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        if id == self.shelf.main {
            Ok(self.source.clone())
        } else {
            Err(missing(id))
        }
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        Err(missing(id))
    }

    fn font(&self, index: usize) -> Option<Font> {
        self.shelf.fonts.get(index).cloned()
    }

    fn today(&self, _: Option<Duration>) -> Option<Datetime> {
        None
    }
}

fn missing(id: FileId) -> FileError {
    FileError::NotFound(id.vpath().get_without_slash().into())
}
