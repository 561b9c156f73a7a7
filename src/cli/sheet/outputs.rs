//! The files of a run: one for all sheets of a format and kind, or one for each sheet.

use std::collections::BTreeMap;
use std::path::Path;

use rayon::prelude::*;
use vibank::output::{KeyTable, PageKind, WRITERS, fairness_page, has_layout, key_table_page};
use vibank::worksheet::{Fairness, Plan, VariantEntry};

use super::format::{Format, Laid, UNPRINTED, WrittenSheet, unfilled};
use super::key_book;
use super::ledger::RunMark;
use crate::cli::Failure;
use crate::cli::folder::{Draft, Folder, Left};
use crate::cli::shard::Shard;
use crate::cli::table::workbook::XLSX;

/// Writes the page that tells a teacher how alike the variants are: in the first format of pages that is made, or as HTML
/// where one of those that are made has no layout for it.
pub(crate) fn write_fairness(
    plan: &Plan<'_>,
    layouts: Option<&Path>,
    fairness: &Fairness,
    out: &Folder,
) -> Result<Finished, Failure> {
    let formats = &plan.blueprint.formats;
    let is_made = |name: &str| formats.iter().any(|format| format.value == name);
    let mut made = WRITERS.iter().filter(|writer| is_made(writer.name()));
    let name = match made.clone().next() {
        Some(first) if made.all(|writer| has_layout(*writer, "fairness")) => first.name(),
        Some(_) => "html",
        None => "md",
    };
    let laid = Laid::of(name, plan, None, &[], layouts, true)?;
    let what = "how alike the variants are";
    let page = fairness_page(&laid.pages, fairness).map_err(unfilled)?;
    let subtitle = laid.pages.fairness_subtitle();
    let begin = laid.pages.begin(subtitle).map_err(unfilled)?;
    let whole = format!("{begin}{page}{}", laid.end);
    let file = format!("fairness.{name}");
    let digest = out.write(&file, whole.as_bytes())?;
    Ok(Finished::one(file, digest, what))
}

/// What the page with all keys is called.
const TABLE: &str = "answers of all variants";

/// Ends a piece of a table of keys in the draft of its text, where no other control sign stands.
const PIECE_END: &str = "\u{c}";

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
        mark: &RunMark,
    ) -> Result<Self, Failure> {
        Ok(Self {
            formats: formats
                .iter()
                .map(|format| {
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
                    let stream = |(kind, begin): &(PageKind, String)| {
                        let name = shard.named(kind.folder(), laid.extension());
                        (!laid.is_split)
                            .then(|| Stream::open(out, name, begin, mark))
                            .transpose()
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
                })
                .collect::<Result<_, _>>()?,
        })
    }

    /// Keeps what a sheet gives, by format, and notes its files in `entry`; what could not be printed is added to
    /// `unprinted`.
    pub(crate) fn add(
        &mut self,
        written: Vec<WrittenSheet>,
        entry: &mut VariantEntry,
        tables: &mut [KeyTable],
        unprinted: &mut Vec<String>,
    ) -> Result<(), Failure> {
        let formats = self.formats.iter_mut().zip(written).zip(tables);
        for ((files, written), collected) in formats {
            match (files, written) {
                (Files::Json(stream), WrittenSheet::Line(line)) => {
                    stream.add(line.as_bytes(), entry)?;
                }
                (Files::Workbook(Some(stream)), WrittenSheet::Line(line)) => {
                    stream.draft.write(line.as_bytes())?;
                }
                (Files::Pages { streams, .. }, WrittenSheet::Pages(leaves, row)) => {
                    row.into_iter().for_each(|row| collected.add(row));
                    for (stream, leaf) in streams.iter_mut().zip(leaves) {
                        entry.files.extend(leaf.files);
                        unprinted.extend(leaf.unprinted);
                        if let Some(stream) = stream {
                            stream.add(&leaf.text, entry)?;
                        }
                    }
                }
                (_, WrittenSheet::Kept(row)) => row.into_iter().for_each(|row| collected.add(row)),
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
                let page = key_table_page(&laid.pages, collected).map_err(unfilled)?;
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
                    finished.push(
                        stream.finish("", "one sheet a line, with its key; keep it to yourself")?,
                    );
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
    fn open(out: &Folder, name: String, begin: &str, mark: &RunMark) -> Result<Self, Failure> {
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
        let printed = pieces.par_iter().enumerate().map(|(at, piece)| {
            let name = match pieces.len() {
                1 => self.name.clone(),
                _ => format!("{stem}-{:0digits$}.{extension}", at + 1),
            };
            match laid.bind(format!("{begin}{piece}{}", laid.end)) {
                Ok(bytes) => Ok((out.write(&name, &bytes)?, name, None)),
                Err(why) => {
                    let line = format!("`{name}` could not be printed: {why}");
                    Ok((UNPRINTED.to_owned(), name, Some(line)))
                }
            }
        });
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
