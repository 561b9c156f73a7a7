//! What `[print]` of a blueprint asks for: one file for the printer with all sheets, and lists for the room.
//!
//! It is made when all sheets are there, in an order of its own, so each sheet is drawn once more; memory holds the sheets
//! of one piece for each thread, however many there are.

use std::collections::BTreeMap;

use rayon::prelude::*;
use vibank::output::{List, PageKind, Roll, list_page, separator_page};
use vibank::seed::Variant;
use vibank::worksheet::{Plan, PrintOrder, Printing, Section, Sheet, Student};

use super::format::{Format, Laid, UNPRINTED, unfilled};
use super::make::refuse;
use crate::cli::Failure;
use crate::cli::folder::Folder;

/// Where it is written to.
pub(crate) const FOLDER: &str = "print";

/// Sheets of a piece: a class is one file, and what the press holds of a piece does not grow with the run.
const PIECE: usize = 64;

/// What is printed of a run.
pub(crate) struct PrintJob<'a, 'c> {
    pub(crate) plan: &'a Plan<'c>,
    pub(crate) printing: &'a Printing,
    /// Those that are named; none where the run has pseudonyms.
    pub(crate) students: &'a [Student],
    pub(crate) variants: &'a [Variant],
    pub(crate) formats: &'a [Format],
    pub(crate) out: &'a Folder,
}

/// The files that were made.
#[derive(Default)]
pub(crate) struct Prints {
    /// With their digests.
    pub(crate) files: BTreeMap<String, String>,
    /// What to report of them, each with what it is.
    pub(crate) shown: Vec<(String, &'static str)>,
    /// Those that could not be printed, and why.
    pub(crate) unprinted: Vec<String>,
}

/// Something that is printed.
#[derive(Clone, Copy)]
enum Leaf<'s> {
    Separator(&'s Section),
    Sheet(usize),
}

impl PrintJob<'_, '_> {
    /// Makes the files of each format that is printed.
    pub(crate) fn make(&self) -> Result<Prints, Failure> {
        let codes: Vec<String> = self.variants.iter().map(ToString::to_string).collect();
        let roll = Roll {
            students: self.students,
            codes: &codes,
        };
        let mut prints = Prints::default();
        for laid in self.formats.iter().filter_map(Format::printed) {
            self.sheets(laid, roll, &mut prints)?;
            if !self.students.is_empty() {
                self.lists(laid, roll, &mut prints)?;
            }
        }
        Ok(prints)
    }

    /// The sections of the file for the printer.
    fn sections(&self, roll: Roll<'_>) -> Vec<Section> {
        let count = self.variants.len();
        let mut sections = self.printing.order.sections(self.students, count);
        if self.students.is_empty() {
            // The order of a class list would tell whose the pseudonyms are.
            for section in &mut sections {
                section.places.sort_by_key(|place| &roll.codes[*place]);
            }
        }
        sections
    }

    /// The file for the printer; several, where there are many sheets and the format comes from a press.
    fn sheets(&self, laid: &Laid, roll: Roll<'_>, prints: &mut Prints) -> Result<(), Failure> {
        let sections = self.sections(roll);
        let mut leaves = Vec::new();
        for section in &sections {
            leaves.extend(self.printing.separators.then_some(Leaf::Separator(section)));
            leaves.extend(section.places.iter().map(|place| Leaf::Sheet(*place)));
        }
        let begin = laid.pages.begin("").map_err(unfilled)?;
        if !laid.pages.writer().is_bound() {
            return self.one_file(laid, &begin, &leaves, roll, prints);
        }
        let pieces: Vec<&[Leaf<'_>]> = leaves.chunks(PIECE).collect();
        let digits = pieces.len().to_string().len();
        let name = |at: usize| match pieces.len() {
            1 => format!("{FOLDER}/sheets.pdf"),
            _ => format!("{FOLDER}/sheets-{:0digits$}.pdf", at + 1),
        };
        let printed: Vec<_> = pieces
            .par_iter()
            .enumerate()
            .map(|(at, piece)| {
                let texts = piece.iter().map(|leaf| self.leaf(laid, *leaf, roll));
                let texts = texts.collect::<Result<Vec<_>, _>>()?;
                let text = format!("{begin}{}{}", texts.concat(), laid.end);
                let name = name(at);
                Ok::<_, Failure>(match laid.bind(text) {
                    Ok(bytes) => {
                        let digest = self.out.write(&name, &bytes)?;
                        (name, digest, None)
                    }
                    Err(why) => {
                        let line = format!("`{name}` could not be printed: {why}");
                        (name, UNPRINTED.to_owned(), Some(line))
                    }
                })
            })
            .collect::<Result<_, _>>()?;
        let shown = match pieces.len() {
            1 => name(0),
            _ => format!("{FOLDER}/sheets-*.pdf"),
        };
        prints.shown.push((shown, "all sheets, for the printer"));
        for (name, digest, line) in printed {
            prints.files.insert(name, digest);
            prints.unprinted.extend(line);
        }
        Ok(())
    }

    /// A file that grows piece by piece.
    fn one_file(
        &self,
        laid: &Laid,
        begin: &str,
        leaves: &[Leaf<'_>],
        roll: Roll<'_>,
        prints: &mut Prints,
    ) -> Result<(), Failure> {
        let name = format!("{FOLDER}/sheets.{}", laid.extension());
        let mut draft = self.out.begin(&name)?;
        draft.write(begin.as_bytes())?;
        for piece in leaves.chunks(PIECE) {
            let texts = piece.par_iter().map(|leaf| self.leaf(laid, *leaf, roll));
            for text in texts.collect::<Result<Vec<_>, _>>()? {
                draft.write(text.as_bytes())?;
            }
        }
        draft.write(laid.end.as_bytes())?;
        prints.files.insert(name.clone(), draft.finish()?);
        prints.shown.push((name, "all sheets, for the printer"));
        Ok(())
    }

    /// A sheet, or the page before some, as it stands among others.
    fn leaf(&self, laid: &Laid, leaf: Leaf<'_>, roll: Roll<'_>) -> Result<String, Failure> {
        let pages = &laid.pages;
        let text = match leaf {
            Leaf::Separator(section) => separator_page(pages, section, roll),
            Leaf::Sheet(place) => {
                let student = self.students.get(place).cloned();
                let sheet = Sheet::draw(self.plan, self.variants[place], student);
                let sheet = sheet.map_err(|error| refuse(&error))?;
                pages.page(PageKind::Sheet, &sheet).map(|page| page.text)
            }
        };
        let text = text.map_err(unfilled)?;
        pages.among(&text, self.printing.duplex).map_err(unfilled)
    }

    /// The lists for each room, or else each group.
    fn lists(&self, laid: &Laid, roll: Roll<'_>, prints: &mut Prints) -> Result<(), Failure> {
        let count = self.variants.len();
        for list in List::ALL {
            let order = match (list, PrintOrder::of_list(self.students)) {
                (List::Seating, PrintOrder::Room) => PrintOrder::Seat,
                (_, order) => order,
            };
            let sections = order.sections(self.students, count);
            let begin = laid
                .pages
                .begin(laid.pages.list_title(list))
                .map_err(unfilled)?;
            let page = list_page(&laid.pages, list, &sections, roll).map_err(unfilled)?;
            let name = format!("{FOLDER}/{}.{}", list.name(), laid.extension());
            let digest = match laid.bind(format!("{begin}{page}{}", laid.end)) {
                Ok(bytes) => self.out.write(&name, &bytes)?,
                Err(why) => {
                    prints
                        .unprinted
                        .push(format!("`{name}` could not be printed: {why}"));
                    UNPRINTED.to_owned()
                }
            };
            prints.files.insert(name.clone(), digest);
            prints.shown.push((name, list.description()));
        }
        Ok(())
    }
}
