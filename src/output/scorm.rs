//! SCORM packages: the self-check page with a manifest and an adapter to the platform, in one archive.
//!
//! SCORM 1.2 (ADL 2001) and SCORM 2004 4th edition (ADL 2009). An archive has fixed times: the same page gives the same
//! bytes.

use serde::Serialize;
use tera::{Context, Tera};

use super::layouts::{self, OutputError};
use super::page;
use crate::bank::Compiled;
use crate::course::{Package, Room, archive};
use crate::worksheet::Practice;

/// A version of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scorm {
    /// SCORM 1.2.
    V12,
    /// SCORM 2004, 4th edition.
    V2004,
}

/// What a package says of itself, to its page and to programs.
#[derive(Serialize)]
struct Described<'p> {
    version: &'static str,
    /// Characters of state.
    room: usize,
    #[serde(flatten)]
    package: &'p Package,
}

/// What only programs read of it.
#[derive(Serialize)]
struct Stored<'p> {
    #[serde(flatten)]
    described: Described<'p>,
    practice: &'p Practice,
}

/// The file of a package that programs read.
pub const DESCRIPTION: &str = "vibank.json";

impl Scorm {
    /// Its name on the command line and in the page.
    pub fn name(self) -> &'static str {
        match self {
            Self::V12 => "1.2",
            Self::V2004 => "2004",
        }
    }

    /// The state that it keeps for a package.
    pub fn room(self) -> Room {
        let (standard, characters) = match self {
            Self::V12 => ("SCORM 1.2", 4_096),
            Self::V2004 => ("SCORM 2004", 64_000),
        };
        Room {
            standard,
            characters,
        }
    }
}

/// The archive of a package.
///
/// # Errors
///
/// [`OutputError`] if a layout cannot be filled.
pub fn scorm(
    practice: &Practice,
    items: &[Compiled],
    package: &Package,
    version: Scorm,
) -> Result<Vec<u8>, OutputError> {
    let described = Described {
        version: version.name(),
        room: version.room().characters,
        package,
    };
    let course = json(&described);
    let page = page::in_course(practice, items, &course)?;
    let stored = json(&Stored {
        described,
        practice,
    });
    let files = [
        ("imsmanifest.xml", manifest(practice, package, version)?),
        ("index.html", page),
        (DESCRIPTION, stored),
    ];
    let files = files.iter().map(|(name, text)| (*name, text.as_bytes()));
    archive(files).map_err(|error| OutputError::page("scorm", error))
}

fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("plain data, with texts as keys")
}

fn manifest(practice: &Practice, package: &Package, version: Scorm) -> Result<String, OutputError> {
    let layout = format!("imsmanifest-{}.xml", version.name());
    let mut tera = Tera::default();
    tera.autoescape_on(vec![".xml"]);
    tera.add_raw_template(&layout, layouts::text(&format!("page/{layout}")))
        .map_err(|error| OutputError::page(&layout, error))?;
    let mut context = Context::new();
    context.insert("id", &package.id);
    context.insert("title", &practice.title);
    context.insert("description", DESCRIPTION);
    tera.render(&layout, &context)
        .map_err(|error| OutputError::page(&layout, error))
}
