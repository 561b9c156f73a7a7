//! A sheet: the questions of one variant, before any format.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::marks::Best;
#[cfg(feature = "render")]
use crate::bank::Space;
use crate::bank::{Group, Part, Template};
use crate::numerics::Rational;
use crate::seed::Variant;
use crate::solution::Solution;

/// The questions of one variant.
pub struct Sheet<'c> {
    /// Its seed, printed as its code.
    pub variant: Variant,
    /// For whom it is, if there is a class list.
    pub student: Option<Student>,
    /// Its questions in order.
    pub questions: Vec<SheetQuestion<'c>>,
    /// The points that can be reached without bonus, where the best questions count by these.
    pub points: Rational,
    /// How many questions count, where not all do.
    pub best: Vec<Best>,
}

/// One question of a sheet.
pub struct SheetQuestion<'c> {
    /// Its number, from 1.
    pub number: usize,
    /// Its place in the plan, from 0; the same in every variant.
    pub place: usize,
    /// Its data and keys.
    pub solution: Solution<'c>,
    /// The parts that are asked, as places in the item.
    pub parts: Vec<usize>,
    /// Their points.
    pub points: Vec<Rational>,
    /// Whether they are beyond those of the sheet.
    pub bonus: bool,
    /// Its section, of which the best questions may count; empty if it is in none.
    pub section: String,
    /// Room for work at them.
    #[cfg(feature = "render")]
    pub spaces: Vec<Space>,
}

/// A row of a class list.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Student {
    /// Identity, such as a matriculation number.
    pub id: String,
    /// Name; may be empty.
    pub name: String,
    /// Group; may be empty.
    pub group: String,
    /// Room in which the seat is; may be empty.
    pub room: String,
    /// Seat, as row and place, `C7` or `3-7`; may be empty.
    pub seat: String,
    /// The size of type in points, where it is not the usual one.
    pub type_size: Option<u8>,
    /// What is granted beyond the duration, as it is printed; may be empty.
    pub extra_time: String,
    /// All columns of the class list.
    pub columns: BTreeMap<String, String>,
}

impl SheetQuestion<'_> {
    /// The points of the blanks of a group.
    pub fn points_of(&self, group: &Group) -> Rational {
        let parts = &self.solution.template().parts;
        let of_group = self.parts.iter().zip(&self.points);
        let of_group = of_group.filter(|(place, _)| parts[**place].is_in(&group.id));
        let points: Vec<Rational> = of_group.map(|(_, points)| *points).collect();
        Rational::sum(&points).unwrap_or(Rational::ZERO)
    }

    /// The expected working time in minutes: that of its item, or its parts' share of it.
    pub fn minutes(&self) -> u32 {
        let item = self.solution.template();
        let all: u32 = item.parts.iter().map(|part| part.answer.minutes()).sum();
        let asked: u32 = self
            .parts
            .iter()
            .map(|place| item.parts[*place].answer.minutes())
            .sum();
        if all == 0 || asked == all {
            return item.minutes();
        }
        (item.minutes() * asked).div_ceil(all)
    }

    /// The points of all its parts.
    pub fn total(&self) -> Rational {
        self.points.iter().fold(Rational::ZERO, |sum, points| {
            sum.checked_add(*points).unwrap_or(sum)
        })
    }
}

/// What a part is called where it is printed.
#[derive(Clone, Debug)]
pub struct Heading<'t> {
    /// `b`, or `b2` for the second blank of a group.
    pub letter: String,
    /// The group to which it belongs.
    pub group: Option<&'t Group>,
    /// Whether it is the first blank of its group, so that the text of the group comes before it.
    pub opens: bool,
}

impl<'t> Heading<'t> {
    /// The group that is printed before this part, and its letter.
    pub fn opened(&self) -> Option<(&str, &'t Group)> {
        self.group
            .filter(|_| self.opens)
            .map(|group| (self.group_letter(), group))
    }

    /// The letter of its group.
    pub(crate) fn group_letter(&self) -> &str {
        self.letter
            .trim_end_matches(|char: char| char.is_ascii_digit())
    }
}

/// What the parts of an item are called that are asked, given as places in it: a group has a letter, its blanks have
/// numbers.
///
/// ```
/// # #[cfg(feature = "render")] {
/// use vibank::bank::{Catalogue, embedded};
/// use vibank::worksheet::headings;
/// let (catalogue, _) = Catalogue::open(embedded());
/// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
/// assert_eq!(headings(item, &[1])[0].letter, "a");
/// # }
/// ```
pub fn headings<'t>(template: &'t Template, places: &[usize]) -> Vec<Heading<'t>> {
    let parts: Vec<&Part> = places.iter().map(|place| &template.parts[*place]).collect();
    let mut headings = Vec::new();
    for (at, blanks) in parts.chunk_by(|a, b| is_one_group(a, b)).enumerate() {
        let letter = letter(at);
        let group = blanks[0].group.as_deref();
        headings.extend((1..=blanks.len()).map(|number| Heading {
            letter: match group {
                Some(_) => format!("{letter}{number}"),
                None => letter.clone(),
            },
            group,
            opens: group.is_some() && number == 1,
        }));
    }
    headings
}

/// Whether two parts are blanks of one group.
pub(crate) fn is_one_group(a: &Part, b: &Part) -> bool {
    match (&a.group, &b.group) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        _ => false,
    }
}

/// The letter of the question, or of the option, at a place, from 0: a, b, …, z, aa, ab, ….
pub fn letter(place: usize) -> String {
    let last = char::from(b'a' + (place % 26) as u8);
    match place / 26 {
        0 => last.to_string(),
        more => format!("{}{last}", letter(more - 1)),
    }
}
