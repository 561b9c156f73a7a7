//! A sheet: the questions of one variant, before any format.

use std::collections::BTreeMap;

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
    /// Seat, as row and place, `C7` or `3-7`; may be empty.
    pub seat: String,
    /// All columns of the class list.
    pub columns: BTreeMap<String, String>,
}

impl Sheet<'_> {
    /// The points of all questions.
    pub fn points(&self) -> Rational {
        let all = self.questions.iter().map(SheetQuestion::total);
        all.fold(Rational::ZERO, |sum, points| {
            sum.checked_add(points).unwrap_or(sum)
        })
    }
}

impl SheetQuestion<'_> {
    /// The points of all its parts.
    pub fn total(&self) -> Rational {
        self.points.iter().fold(Rational::ZERO, |sum, points| {
            sum.checked_add(*points).unwrap_or(sum)
        })
    }
}

/// The letter of the part at a place, from 0: a, b, …, z, aa, ab, ….
pub fn letter(place: usize) -> String {
    let last = char::from(b'a' + (place % 26) as u8);
    match place / 26 {
        0 => last.to_string(),
        more => format!("{}{last}", letter(more - 1)),
    }
}
