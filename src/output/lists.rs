//! Lists for the room: who attends, who sits where with which sheet; and the pages between the sheets of rooms.

use serde::Serialize;

use super::layouts::OutputError;
use super::pages::{Pages, Run};
use super::words::Words;
use crate::worksheet::{Section, Student, Whose};

/// What a list is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// To be signed by those who attend.
    Attendance,
    /// To hand out sheets by: seats and codes.
    Seating,
}

impl List {
    /// All lists.
    pub const ALL: [Self; 2] = [Self::Attendance, Self::Seating];

    /// The name of its layout and of its file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Attendance => "attendance",
            Self::Seating => "seating",
        }
    }

    /// What the program calls it when it lists the files that it wrote.
    pub fn description(self) -> &'static str {
        match self {
            Self::Attendance => "attendance list",
            Self::Seating => "seats and codes",
        }
    }

    pub(crate) fn title(self, words: &Words) -> &str {
        match self {
            Self::Attendance => &words.attendance_list,
            Self::Seating => &words.seating_list,
        }
    }
}

/// Whose sheets a run has, and with which codes, by place.
#[derive(Clone, Copy, Debug)]
pub struct Roll<'a> {
    /// The students; further sheets are nobody's.
    pub students: &'a [Student],
    /// The code of each sheet.
    pub codes: &'a [String],
}

/// What layouts see of a list.
#[derive(Serialize)]
struct ListView<'a> {
    run: &'a Run,
    subtitle: &'a str,
    has_groups: bool,
    has_notes: bool,
    sections: Vec<SectionView>,
}

/// What layouts see of the sheets of a room or a group.
#[derive(Serialize)]
struct SectionView {
    /// Whose they are; empty where they are all.
    name: String,
    is_spare: bool,
    /// How many there are, in words.
    count: String,
    rows: Vec<RowView>,
}

#[derive(Default, Serialize)]
struct RowView {
    /// Its place in the class list, from 1.
    number: usize,
    seat: String,
    name: String,
    student: String,
    group: String,
    code: String,
    /// What is granted to the student.
    note: String,
}

/// A list of these sections.
///
/// # Errors
///
/// [`OutputError::Page`].
pub fn list_page(
    pages: &Pages,
    list: List,
    sections: &[Section],
    roll: Roll<'_>,
) -> Result<String, OutputError> {
    let sections = sections
        .iter()
        .map(|section| section_view(pages, section, roll));
    let sections: Vec<SectionView> = sections.collect();
    let rows = || sections.iter().flat_map(|section| &section.rows);
    let view = ListView {
        run: &pages.run,
        subtitle: pages.list_title(list),
        has_groups: rows().any(|row| !row.group.is_empty()),
        has_notes: rows().any(|row| !row.note.is_empty()),
        sections,
    };
    pages.layouts.fill(list.name(), &view)
}

/// The page that stands before the sheets of a section.
///
/// # Errors
///
/// [`OutputError::Page`].
pub fn separator_page(
    pages: &Pages,
    section: &Section,
    roll: Roll<'_>,
) -> Result<String, OutputError> {
    #[derive(Serialize)]
    struct SeparatorPage<'a> {
        run: &'a Run,
        section: SectionView,
    }
    let section = section_view(pages, section, roll);
    let run = &pages.run;
    pages
        .layouts
        .fill("separator", &SeparatorPage { run, section })
}

fn section_view(pages: &Pages, section: &Section, roll: Roll<'_>) -> SectionView {
    let count = section.places.len();
    SectionView {
        name: name_of(pages, &section.whose),
        is_spare: section.whose == Whose::Spare,
        count: pages.run.words.sheets(count),
        rows: section
            .places
            .iter()
            .map(|place| row_view(pages, *place, &section.whose, roll))
            .collect(),
    }
}

/// Whose the sheets of a section are.
fn name_of(pages: &Pages, whose: &Whose) -> String {
    let words = pages.run.words;
    let named = |what: &str, none: &str, name: &str| match pages.run.plain_name(name) {
        "" => none.to_owned(),
        // A class list may say `Group 3` or `3`.
        name if name.to_lowercase().contains(&what.to_lowercase()) => name.to_owned(),
        name => format!("{what} {name}"),
    };
    let name = match whose {
        Whose::All => String::new(),
        Whose::Group(name) => named(&words.group, &words.no_group, name),
        Whose::Room(name) => named(&words.room, &words.no_room, name),
        Whose::Spare => words.spare_sheets.clone(),
    };
    pages.placed(&name)
}

fn row_view(pages: &Pages, place: usize, whose: &Whose, roll: Roll<'_>) -> RowView {
    let number = place + 1;
    let code = roll.codes.get(place).cloned().unwrap_or_default();
    let Some(student) = roll.students.get(place) else {
        return RowView {
            number,
            code,
            ..RowView::default()
        };
    };
    let is_group = matches!(whose, Whose::Group(_));
    let phrases = pages.run.words;
    let large = student.type_size.map(|size| phrases.large_print(size));
    let extra = Some(&student.extra_time).filter(|time| !time.is_empty());
    let extra = extra.map(|time| format!("{} {}", phrases.extra_time, pages.run.plain_name(time)));
    let notes: Vec<String> = large.into_iter().chain(extra).collect();
    RowView {
        number,
        code,
        seat: pages.placed(pages.run.plain_name(&student.seat)),
        name: pages.placed(pages.run.name(&student.name, &student.id)),
        student: pages.placed(pages.run.plain_name(&student.id)),
        group: if is_group {
            String::new()
        } else {
            pages.placed(pages.run.plain_name(&student.group))
        },
        note: pages.placed(&notes.join("; ")),
    }
}
