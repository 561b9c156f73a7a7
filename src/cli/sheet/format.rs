//! The formats of a run: how a sheet is written in each.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use vibank::message::Language;
use vibank::output::{self, KeyRow, PageKind, Pages, Run};
use vibank::worksheet::{FileStamp, Plan, Sheet, Student};

use super::choice::FormatChoice;
use super::key_book;
use crate::cli::Failure;
use crate::cli::files;
use crate::cli::folder::Folder;
use crate::cli::press::{Press, Printed};
use crate::cli::table::workbook::{self, XLSX};

/// How sheets are written in one format.
pub(crate) enum Format {
    /// By page layouts.
    Pages(Box<Laid>),
    /// One line of JSON for each sheet, with answer lines and keys in the language of the sheets.
    Json(Language),
    /// A workbook with the answers of all sheets, one in a row; nothing where the table of keys is not made.
    Workbook(Option<Language>),
}

/// A format with page layouts.
pub(crate) struct Laid {
    /// How its pages are filled.
    pub(crate) pages: Pages,
    /// Where the format needs one.
    pub(crate) press: Option<Arc<Press>>,
    /// Files of fonts for names, and the same as the manifest has them.
    pub(crate) fonts: Vec<String>,
    pub(crate) stamps: Vec<FileStamp>,
    /// What is made, with what stands before its first page.
    pub(crate) kinds: Vec<(PageKind, String)>,
    /// What stands before the table with the answers of all variants, if it is made.
    pub(crate) table: Option<String>,
    /// What stands after the last page of a file.
    pub(crate) end: String,
    /// Whether each sheet is a file of its own.
    pub(crate) is_split: bool,
    /// The figures that are files of their own and were written, with their digests.
    pub(crate) pictures: Mutex<BTreeMap<String, String>>,
}

/// The digest of a file that could not be printed. No file has it, so that the next run tries again.
pub(crate) const UNPRINTED: &str = "";

/// What one sheet gives in one format.
pub(crate) enum WrittenSheet {
    /// Its pages, and a row of the table of keys.
    Pages(Vec<Leaf>, Option<KeyRow>),
    /// Its files are there already; the row of the table.
    Kept(Option<KeyRow>),
    /// A line of JSON.
    Line(String),
    /// The workbook has no table of keys.
    Nothing,
}

/// A page: for the file of its kind, or written to one of its own.
pub(crate) struct Leaf {
    pub(crate) text: Vec<u8>,
    /// The files that were written, with their digests.
    pub(crate) files: BTreeMap<String, String>,
    /// Files that could not be printed, and why.
    pub(crate) unprinted: Vec<String>,
}

/// The formats that are made, for pages that name these students; `layouts` is a folder of the user.
pub(crate) fn formats(
    plan: &Plan<'_>,
    choice: &FormatChoice,
    students: &[Student],
    layouts: Option<&Path>,
    is_split: bool,
) -> Result<Vec<Format>, Failure> {
    if let Some(folder) = layouts.filter(|folder| !folder.is_dir()) {
        return Err(
            Failure::new(format!("there is no folder `{}`", folder.display()))
                .help("give the folder that holds your layouts as `FORMAT/worksheet.EXT`"),
        );
    }
    let language = Language::of(&plan.blueprint.language.value).unwrap_or_default();
    let formats = choice.made.iter().map(|name| {
        if name == "json" {
            return Ok(Format::Json(language));
        }
        if name == XLSX {
            return if workbook::IS_BUILT_IN {
                Ok(Format::Workbook(
                    plan.blueprint.keys.table.then_some(language),
                ))
            } else {
                Err(workbook::missing())
            };
        }
        let laid = Laid::of(name, plan, Some(choice), students, layouts, is_split)?;
        Ok(Format::Pages(Box::new(laid)))
    });
    formats.collect()
}

impl Format {
    /// All that its pages depend on beside the sheet.
    pub(crate) fn description(&self) -> String {
        match self {
            Self::Json(_) => "json".to_owned(),
            Self::Workbook(_) => XLSX.to_owned(),
            Self::Pages(laid) => {
                let begins = laid.kinds.iter().map(|(_, begin)| begin.as_str());
                let begins: String = begins.chain(laid.table.as_deref()).collect();
                let press = laid.press.as_ref().map_or("", |press| press.digest());
                let fonts = laid.stamps.iter().map(|stamp| stamp.digest.as_str());
                let fonts: String = fonts.collect();
                format!(
                    "{}{begins}{}{press}{fonts}",
                    laid.pages.description(),
                    laid.end
                )
            }
        }
    }

    /// Its pages, where they are for paper.
    pub(crate) fn printed(&self) -> Option<&Laid> {
        match self {
            Self::Pages(laid) if laid.pages.is_for_paper() => Some(laid),
            _ => None,
        }
    }

    /// Whether each sheet is a file of its own.
    pub(crate) fn is_split(&self) -> bool {
        matches!(self, Self::Pages(laid) if laid.is_split)
    }

    /// What a sheet gives, with files of this name where it has its own; with `is_kept` these are there already.
    pub(crate) fn write(
        &self,
        sheet: &Sheet<'_>,
        stem: &str,
        is_kept: bool,
        out: &Folder,
    ) -> Result<WrittenSheet, Failure> {
        let laid = match self {
            Self::Json(language) => {
                let line = format!("{}\n", output::json(sheet, *language));
                return Ok(WrittenSheet::Line(line));
            }
            Self::Workbook(Some(language)) => {
                return Ok(WrittenSheet::Line(key_book::line(sheet, *language)));
            }
            Self::Workbook(None) => return Ok(WrittenSheet::Nothing),
            Self::Pages(laid) => laid,
        };
        let row = laid
            .table
            .as_ref()
            .map(|_| output::key_row(&laid.pages, sheet));
        if is_kept && laid.is_split {
            return Ok(WrittenSheet::Kept(row));
        }
        let kinds = laid.kinds.iter();
        let keys = row.as_ref();
        let leaves = kinds.map(|(kind, begin)| laid.leaf(*kind, begin, sheet, keys, stem, out));
        Ok(WrittenSheet::Pages(leaves.collect::<Result<_, _>>()?, row))
    }
}

impl Laid {
    pub(crate) fn of(
        name: &str,
        plan: &Plan<'_>,
        choice: Option<&FormatChoice>,
        students: &[Student],
        layouts: Option<&Path>,
        is_split: bool,
    ) -> Result<Self, Failure> {
        let writer =
            output::writer(name).ok_or_else(|| Failure::unknown_format(name, &["json", XLSX]))?;
        let own = own_layouts(layouts, writer.name())?;
        let blueprint = plan.blueprint;
        let mut run = Run::of(blueprint, writer).with_formulas(&plan.formulas, writer);
        let faces = choice
            .filter(|_| writer.is_bound())
            .map(|choice| choice.faces.clone());
        let faces = faces.unwrap_or_default();
        run = run.with_names(faces.names).with_seats(students);
        let press = choice.and_then(|choice| choice.press.as_ref());
        let pages = Pages::new(writer, run, &own).map_err(unfilled)?;
        let mut kinds = vec![PageKind::Sheet];
        kinds.extend(blueprint.keys.each.then_some(PageKind::Key));
        kinds.extend(blueprint.solutions.then_some(PageKind::Solutions));
        let kinds = kinds
            .into_iter()
            .map(|kind| Ok((kind, pages.begin(pages.subtitle(kind))?)))
            .collect::<Result<_, _>>();
        let table = blueprint
            .keys
            .table
            .then(|| pages.begin(pages.table_subtitle()))
            .transpose();
        Ok(Self {
            kinds: kinds.map_err(unfilled)?,
            table: table.map_err(unfilled)?,
            end: pages.end().map_err(unfilled)?,
            is_split: is_split || writer.is_bound(),
            pictures: Mutex::default(),
            press: press.filter(|_| writer.needs_press()).cloned(),
            fonts: faces.paths,
            stamps: faces.stamps,
            pages,
        })
    }

    pub(crate) fn extension(&self) -> &'static str {
        self.pages.writer().extension()
    }

    fn leaf(
        &self,
        kind: PageKind,
        begin: &str,
        sheet: &Sheet<'_>,
        keys: Option<&KeyRow>,
        stem: &str,
        out: &Folder,
    ) -> Result<Leaf, Failure> {
        let page = self.pages.page_with(kind, sheet, keys).map_err(unfilled)?;
        let (mut files, mut unprinted) = (BTreeMap::new(), Vec::new());
        for (name, svg) in &page.pictures {
            let digest = self.place(name, svg, out, &mut unprinted)?;
            files.insert(name.clone(), digest);
        }
        if !self.is_split {
            return Ok(Leaf {
                text: page.text.into_bytes(),
                files,
                unprinted,
            });
        }
        let whole = format!("{begin}{}{}", page.text, self.end);
        let inside = format!("{}/{stem}.{}", kind.folder(), self.extension());
        let bytes = match self.bind(whole) {
            Ok(bytes) => bytes,
            Err(why) => {
                unprinted.push(format!("`{inside}` could not be printed: {why}"));
                files.insert(inside, UNPRINTED.to_owned());
                return Ok(Leaf {
                    text: Vec::new(),
                    files,
                    unprinted,
                });
            }
        };
        let digest = out.write(&inside, &bytes)?;
        files.insert(inside, digest);
        Ok(Leaf {
            text: Vec::new(),
            files,
            unprinted,
        })
    }

    /// The file of a finished text.
    pub(crate) fn bind(&self, text: String) -> Printed {
        match &self.press {
            Some(press) if self.pages.writer().is_bound() => press.page(text, &self.fonts),
            _ => Ok(text.into_bytes()),
        }
    }

    /// Writes a figure that is a file of its own, once: its name says what is in it. Returns its digest.
    ///
    /// Nothing is held while it is drawn: what draws hands work to the same threads, and they may come here again.
    fn place(
        &self,
        name: &str,
        svg: &str,
        out: &Folder,
        unprinted: &mut Vec<String>,
    ) -> Result<String, Failure> {
        if let Some(digest) = self.placed().get(name) {
            return Ok(digest.clone());
        }
        let printed = self.press.as_ref().map(|press| press.figure(svg));
        let bytes = match printed {
            Some(Ok(bytes)) => bytes,
            Some(Err(why)) => {
                unprinted.push(format!("`{name}` could not be printed: {why}"));
                return Ok(UNPRINTED.to_owned());
            }
            None => return Ok(UNPRINTED.to_owned()),
        };
        let mut placed = self.placed();
        if let Some(digest) = placed.get(name) {
            return Ok(digest.clone());
        }
        let digest = out.write(name, &bytes)?;
        placed.insert(name.to_owned(), digest.clone());
        Ok(digest)
    }

    fn placed(&self) -> MutexGuard<'_, BTreeMap<String, String>> {
        self.pictures.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

pub(crate) fn unfilled(error: output::OutputError) -> Failure {
    Failure::of(error)
}

/// The layouts of one format in a folder of the user.
fn own_layouts(folder: Option<&Path>, format: &str) -> Result<Vec<(String, String)>, Failure> {
    let inside = folder.map(|folder| folder.join(format));
    let entries = inside.and_then(|inside| std::fs::read_dir(inside).ok());
    let mut layouts = Vec::new();
    for entry in entries.into_iter().flatten().flatten() {
        if entry.path().is_file() {
            let name = entry.file_name().to_string_lossy().into_owned();
            layouts.push((name, files::read(&entry.path())?));
        }
    }
    layouts.sort();
    Ok(layouts)
}
