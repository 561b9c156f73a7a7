//! The files of a run: one for all sheets of a format and kind, or one for each sheet.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;
use vibank::message::Language;
use vibank::output::{self, KeyRow, KeyTable, Kind, Pages, Run};
use vibank::worksheet::{Fairness, FileStamp, Plan, Sheet, Student, VariantEntry};

use super::choice::FormatChoice;
use super::key_book;
use super::ledger::Mark;
use crate::cli::Failure;
use crate::cli::files;
use crate::cli::folder::{Draft, Folder, Left};
use crate::cli::press::{Press, Printed};
use crate::cli::shard::Shard;
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
    pages: Pages,
    /// Where the format needs one.
    press: Option<Arc<Press>>,
    /// Files of fonts for names, and the same as the manifest has them.
    fonts: Vec<String>,
    stamps: Vec<FileStamp>,
    /// What is made, with what stands before its first page.
    kinds: Vec<(Kind, String)>,
    /// What stands before the table with the answers of all variants, if it is made.
    table: Option<String>,
    end: String,
    /// Whether each sheet is a file of its own.
    is_split: bool,
    /// The figures that are files of their own and were written, with their digests.
    pictures: Mutex<BTreeMap<String, String>>,
}

/// The digest of a file that could not be printed. No file has it, so that the next run tries again.
pub(crate) const UNPRINTED: &str = "";

/// What one sheet gives in one format.
pub(crate) enum Written {
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
    text: Vec<u8>,
    /// The files that were written, with their digests.
    files: BTreeMap<String, String>,
    /// Files that could not be printed, and why.
    unprinted: Vec<String>,
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
    let format = |name: &String| {
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
    };
    choice.made.iter().map(format).collect()
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
    ) -> Result<Written, Failure> {
        let laid = match self {
            Self::Json(language) => {
                let line = format!("{}\n", output::json(sheet, *language));
                return Ok(Written::Line(line));
            }
            Self::Workbook(Some(language)) => {
                return Ok(Written::Line(key_book::line(sheet, *language)));
            }
            Self::Workbook(None) => return Ok(Written::Nothing),
            Self::Pages(laid) => laid,
        };
        let row = laid.table.as_ref().map(|_| laid.pages.key_row(sheet));
        if is_kept && laid.is_split {
            return Ok(Written::Kept(row));
        }
        let kinds = laid.kinds.iter();
        let leaves = kinds.map(|(kind, begin)| laid.leaf(*kind, begin, sheet, stem, out));
        Ok(Written::Pages(leaves.collect::<Result<_, _>>()?, row))
    }
}

impl Laid {
    fn of(
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
        let mut kinds = vec![Kind::Sheet];
        kinds.extend(blueprint.keys.each.then_some(Kind::Key));
        kinds.extend(blueprint.solutions.then_some(Kind::Solutions));
        let begin = |kind| Ok((kind, pages.begin(pages.subtitle(kind))?));
        let kinds = kinds.into_iter().map(begin).collect::<Result<_, _>>();
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
        kind: Kind,
        begin: &str,
        sheet: &Sheet<'_>,
        stem: &str,
        out: &Folder,
    ) -> Result<Leaf, Failure> {
        let page = self.pages.page(kind, sheet).map_err(unfilled)?;
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

    /// How its pages are filled.
    pub(crate) fn pages(&self) -> &Pages {
        &self.pages
    }

    /// What stands after the last page of a file.
    pub(crate) fn end(&self) -> &str {
        &self.end
    }

    /// The file of a finished text.
    pub(crate) fn bind(&self, text: String) -> Printed {
        match &self.press {
            Some(press) if self.pages.writer().is_bound() => press.page(text, &self.fonts),
            _ => Ok(text.into_bytes()),
        }
    }

    /// Writes a figure that is a file of its own, once: its name says what is in it. Its digest is told.
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

/// Writes the page that tells a teacher how alike the variants are: as HTML, unless Markdown alone is made.
pub(crate) fn write_fairness(
    plan: &Plan<'_>,
    layouts: Option<&Path>,
    fairness: &Fairness,
    out: &Folder,
) -> Result<Finished, Failure> {
    let mut formats = plan.blueprint.formats.iter();
    let is_markdown = formats.all(|format| ["md", "json", XLSX].contains(&&*format.value));
    let name = if is_markdown { "md" } else { "html" };
    let laid = Laid::of(name, plan, None, &[], layouts, true)?;
    let what = "how alike the variants are";
    let page = laid.pages.fairness(fairness).map_err(unfilled)?;
    let begin = laid.pages.begin("fairness").map_err(unfilled)?;
    let whole = format!("{begin}{page}{}", laid.end);
    let file = format!("fairness.{name}");
    let digest = out.write(&file, whole.as_bytes())?;
    Ok(Finished::one(file, digest, what))
}

/// What the page with all keys is called.
const TABLE: &str = "answers of all variants";

/// Ends a piece of a table of keys in the draft of its text, where no other control sign stands.
const PIECE_END: &str = "\u{c}";

pub(crate) fn unfilled(error: output::OutputError) -> Failure {
    Failure::new(error.to_string())
}

/// The files of a run, while it lasts.
pub(crate) struct Outputs<'f> {
    formats: Vec<Files<'f>>,
}

/// The files of one format.
enum Files<'f> {
    Pages {
        laid: &'f Laid,
        /// One for each kind; none where each sheet has its own.
        streams: Vec<Option<Stream>>,
        table: Option<Stream>,
    },
    Json(Stream),
    Workbook(Option<Stream>),
}

/// A file that grows with each sheet.
struct Stream {
    name: String,
    draft: Draft,
}

impl<'f> Outputs<'f> {
    /// The files of a run that goes on at `mark`.
    pub(crate) fn open(
        formats: &'f [Format],
        out: &Folder,
        shard: Shard,
        mark: &Mark,
    ) -> Result<Self, Failure> {
        let open = |format: &'f Format| {
            let laid = match format {
                Format::Json(_) => {
                    let name = shard.named("sheets", "jsonl");
                    return Ok(Files::Json(Stream::open(out, name, "", mark)?));
                }
                Format::Workbook(language) => {
                    let name = shard.named("key-table", XLSX);
                    let open = || Stream::open(out, name, "", mark);
                    return Ok(Files::Workbook(language.map(|_| open()).transpose()?));
                }
                Format::Pages(laid) => laid,
            };
            let stream = |(kind, begin): &(Kind, String)| {
                let name = shard.named(kind.folder(), laid.extension());
                let open = || Stream::open(out, name, begin, mark);
                (!laid.is_split).then(open).transpose()
            };
            let table = laid.table.as_ref().map(|begin| {
                let name = shard.named("key-table", laid.extension());
                // What a press prints is bound in pieces, each with its own beginning.
                let is_bound = laid.pages.writer().is_bound();
                Stream::open(out, name, if is_bound { "" } else { begin }, mark)
            });
            Ok(Files::Pages {
                laid,
                streams: laid.kinds.iter().map(stream).collect::<Result<_, _>>()?,
                table: table.transpose()?,
            })
        };
        Ok(Self {
            formats: formats.iter().map(open).collect::<Result<_, _>>()?,
        })
    }

    /// Keeps what a sheet gives, by format, and notes its files in `entry`; what could not be printed is added to
    /// `unprinted`.
    pub(crate) fn add(
        &mut self,
        written: Vec<Written>,
        entry: &mut VariantEntry,
        tables: &mut [KeyTable],
        unprinted: &mut Vec<String>,
    ) -> Result<(), Failure> {
        let formats = self.formats.iter_mut().zip(written).zip(tables);
        for ((files, written), collected) in formats {
            match (files, written) {
                (Files::Json(stream), Written::Line(line)) => {
                    stream.add(line.as_bytes(), entry)?;
                }
                (Files::Workbook(Some(stream)), Written::Line(line)) => {
                    stream.draft.write(line.as_bytes())?;
                }
                (Files::Pages { streams, .. }, Written::Pages(leaves, row)) => {
                    row.into_iter().for_each(|row| collected.add(row));
                    for (stream, leaf) in streams.iter_mut().zip(leaves) {
                        entry.files.extend(leaf.files);
                        unprinted.extend(leaf.unprinted);
                        if let Some(stream) = stream {
                            stream.add(&leaf.text, entry)?;
                        }
                    }
                }
                (_, Written::Kept(row)) => row.into_iter().for_each(|row| collected.add(row)),
                // A format gives what it keeps; a workbook that is not made, nothing.
                (Files::Json(_) | Files::Workbook(_) | Files::Pages { .. }, _) => {}
            }
        }
        Ok(())
    }

    /// Empty tables of keys, one for each format.
    pub(crate) fn tables(&self) -> Vec<KeyTable> {
        self.formats.iter().map(|_| KeyTable::default()).collect()
    }

    /// Writes the tables of keys of some sheets, which are a piece of those that a press prints.
    pub(crate) fn add_tables(&mut self, tables: &[KeyTable]) -> Result<(), Failure> {
        for (files, collected) in self.formats.iter_mut().zip(tables) {
            if let Files::Pages {
                laid,
                table: Some(stream),
                ..
            } = files
            {
                let page = laid.pages.key_table(collected).map_err(unfilled)?;
                stream.draft.write(page.as_bytes())?;
                if laid.pages.writer().is_bound() {
                    stream.draft.write(PIECE_END.as_bytes())?;
                }
            }
        }
        Ok(())
    }

    /// Hands everything to the system; what a later run would go on with.
    pub(crate) fn flush(&mut self) -> Result<BTreeMap<String, Left>, Failure> {
        let mut left = BTreeMap::new();
        for stream in self.formats.iter_mut().flat_map(Files::streams) {
            left.insert(stream.name.clone(), stream.draft.flush()?);
        }
        Ok(left)
    }

    /// Completes the files: each with what it is, and with its digest where it belongs to the whole run.
    pub(crate) fn finish(
        self,
        out: &Folder,
        unprinted: &mut Vec<String>,
    ) -> Result<Vec<Finished>, Failure> {
        let mut finished = Vec::new();
        for files in self.formats {
            let (laid, streams, table) = match files {
                Files::Json(stream) => {
                    finished.push(stream.finish("", "one sheet a line")?);
                    continue;
                }
                Files::Workbook(stream) => {
                    finished.extend(stream.map(|stream| stream.book(out)).transpose()?);
                    continue;
                }
                Files::Pages {
                    laid,
                    streams,
                    table,
                } => (laid, streams, table),
            };
            for ((kind, _), stream) in laid.kinds.iter().zip(streams) {
                let what = kind.title();
                finished.push(match stream {
                    Some(stream) => stream.finish(&laid.end, what)?,
                    None => Finished {
                        name: format!("{}/*.{}", kind.folder(), laid.extension()),
                        digests: Vec::new(),
                        what,
                    },
                });
            }
            if let Some(table) = table {
                let begin = laid.table.as_deref().unwrap_or_default();
                finished.push(if laid.pages.writer().is_bound() {
                    table.bind(laid, begin, out, unprinted)?
                } else {
                    table.finish(&laid.end, TABLE)?
                });
            }
        }
        Ok(finished)
    }
}

/// A file that is complete, or several.
pub(crate) struct Finished {
    /// What to report of it: its name, or a pattern of several.
    pub(crate) name: String,
    /// Files of the whole run, with their digests.
    pub(crate) digests: Vec<(String, String)>,
    pub(crate) what: &'static str,
}

impl Files<'_> {
    fn streams(&mut self) -> Vec<&mut Stream> {
        match self {
            Self::Json(stream) => vec![stream],
            Self::Workbook(stream) => stream.iter_mut().collect(),
            Self::Pages { streams, table, .. } => {
                streams.iter_mut().flatten().chain(table).collect()
            }
        }
    }
}

impl Stream {
    /// The file of this name, with its beginning where it is new.
    fn open(out: &Folder, name: String, begin: &str, mark: &Mark) -> Result<Self, Failure> {
        let mut draft = out.go_on(&name, mark.left(&name))?;
        if draft.length() == 0 {
            draft.write(begin.as_bytes())?;
        }
        Ok(Self { name, draft })
    }

    /// Adds the page of a sheet, and notes in its entry where it stands.
    fn add(&mut self, page: &[u8], entry: &mut VariantEntry) -> Result<(), Failure> {
        let place = (self.draft.length(), page.len() as u64);
        entry.pages.insert(self.name.clone(), place);
        self.draft.write(page)
    }

    fn finish(mut self, end: &str, what: &'static str) -> Result<Finished, Failure> {
        self.draft.write(end.as_bytes())?;
        Ok(Finished::one(self.name, self.draft.finish()?, what))
    }

    /// The table of keys as a workbook.
    fn book(self, out: &Folder) -> Result<Finished, Failure> {
        let lines = self.draft.take()?;
        let digest = out.write(&self.name, &key_book::bound(&lines)?)?;
        Ok(Finished::one(self.name, digest, TABLE))
    }

    /// The tables of keys of a format whose finished text is not yet the file: a file for each piece, since what a
    /// press holds grows with what it prints at once.
    fn bind(
        self,
        laid: &Laid,
        begin: &str,
        out: &Folder,
        unprinted: &mut Vec<String>,
    ) -> Result<Finished, Failure> {
        let text = self.draft.take()?;
        let pieces = text.strip_suffix(PIECE_END).unwrap_or(&text);
        let pieces: Vec<&str> = pieces.split(PIECE_END).collect();
        let (stem, extension) = self.name.rsplit_once('.').unwrap_or((&self.name, ""));
        let digits = pieces.len().to_string().len();
        let named = |at: usize| match pieces.len() {
            1 => self.name.clone(),
            _ => format!("{stem}-{:0digits$}.{extension}", at + 1),
        };
        let print = |(at, piece): (usize, &&str)| {
            let name = named(at);
            match laid.bind(format!("{begin}{piece}{}", laid.end)) {
                Ok(bytes) => Ok((out.write(&name, &bytes)?, name, None)),
                Err(why) => {
                    let line = format!("`{name}` could not be printed: {why}");
                    Ok((UNPRINTED.to_owned(), name, Some(line)))
                }
            }
        };
        let printed = pieces.par_iter().enumerate().map(print);
        let printed: Vec<_> = printed.collect::<Result<_, Failure>>()?;
        let mut digests = Vec::new();
        for (digest, name, line) in printed {
            digests.push((name, digest));
            unprinted.extend(line);
        }
        let name = match pieces.len() {
            1 => self.name,
            _ => format!("{stem}-*.{extension}"),
        };
        Ok(Finished {
            name,
            digests,
            what: TABLE,
        })
    }
}

impl Finished {
    fn one(name: String, digest: String, what: &'static str) -> Self {
        Self {
            digests: vec![(name.clone(), digest)],
            name,
            what,
        }
    }
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
