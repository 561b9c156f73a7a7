//! How sheets are printed for a class: in which order, with what between them, under which names.

use super::blueprint::Faults;
use super::seat::Seat;
use super::sheet::Student;
use crate::source::Table;

/// In which order sheets are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PrintOrder {
    /// As the class list has them.
    #[default]
    Class,
    /// By group, in each as the class list has them.
    Group,
    /// By room, in each as the class list has them.
    Room,
    /// By room, in each by seat.
    Seat,
}

/// After what the files of sheets are named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FileNames {
    /// The code of the variant.
    #[default]
    Code,
    /// The place in the class list, the `id` and the name.
    Student,
}

/// The table `[print]` of a blueprint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printing {
    /// In which order sheets are printed.
    pub order: PrintOrder,
    /// Whether each sheet begins on a new leaf of paper that is printed on both sides.
    pub duplex: bool,
    /// Whether a page with its name stands before each group or room.
    pub separators: bool,
    /// After what the files of single sheets are named.
    pub files: FileNames,
}

impl Printing {
    pub(crate) fn read(table: &Table<'_>, faults: &mut Faults<'_>) -> Self {
        let orders = [PrintOrder::Class, PrintOrder::Group, PrintOrder::Seat];
        let printing = Self {
            order: faults.word(table, "order", &["class", "group", "seat"], &orders),
            duplex: table.boolean("duplex").unwrap_or(true),
            separators: table.boolean("separators").unwrap_or(false),
            files: faults.word(
                table,
                "files",
                &["code", "student"],
                &[FileNames::Code, FileNames::Student],
            ),
        };
        table.finish_ref();
        printing
    }
}

/// Sheets that are printed one after the other, such as those of a room.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// What they have in common.
    pub whose: Whose,
    /// Their places in the run.
    pub places: Vec<usize>,
}

/// What the sheets of a section have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Whose {
    /// Nothing.
    All,
    /// This group; empty where the class list names none.
    Group(String),
    /// This room; empty where the class list names none.
    Room(String),
    /// They are nobody's.
    Spare,
}

impl PrintOrder {
    /// The order that takes apart what a class list takes apart: rooms, else groups.
    pub fn of_list(students: &[Student]) -> Self {
        if students.iter().any(|student| !student.room.is_empty()) {
            Self::Room
        } else {
            Self::Group
        }
    }

    /// The places of `count` sheets of a run in this order, of which the first ones are for these students and the others
    /// for nobody.
    ///
    /// Groups and rooms stand in the order in which the list names them first; who has no seat comes after those who have
    /// one.
    ///
    /// ```
    /// use vibank::worksheet::{PrintOrder, Student, Whose};
    /// let student = |group: &str| Student { group: group.to_owned(), ..Student::default() };
    /// let students = [student("B"), student("A"), student("B")];
    /// let sections = PrintOrder::Group.sections(&students, 4);
    /// assert_eq!(sections[0].whose, Whose::Group("B".to_owned()));
    /// let places: Vec<_> = sections.iter().map(|section| section.places.clone()).collect();
    /// assert_eq!(places, [vec![0, 2], vec![1], vec![3]]);
    /// ```
    pub fn sections(self, students: &[Student], count: usize) -> Vec<Section> {
        let mut sections: Vec<Section> = Vec::new();
        for (place, student) in students.iter().enumerate() {
            let whose = self.whose(student);
            match sections.iter_mut().find(|section| section.whose == whose) {
                Some(section) => section.places.push(place),
                None => sections.push(Section {
                    whose,
                    places: vec![place],
                }),
            }
        }
        if self == Self::Seat {
            for section in &mut sections {
                section.places.sort_by_key(|place| {
                    let seat = Seat::read(&students[*place].seat);
                    (seat.is_none(), seat)
                });
            }
        }
        if students.len() < count {
            let whose = if students.is_empty() {
                Whose::All
            } else {
                Whose::Spare
            };
            let places = (students.len()..count).collect();
            sections.push(Section { whose, places });
        }
        sections
    }

    fn whose(self, student: &Student) -> Whose {
        match self {
            Self::Class => Whose::All,
            Self::Group => Whose::Group(student.group.clone()),
            Self::Room | Self::Seat => Whose::Room(student.room.clone()),
        }
    }
}

/// The usual size of large print in points, which the American Printing House for the Blind takes for the least.
const LARGE: u8 = 18;

/// The smallest and the largest size of type in points that a sheet is printed in.
const SIZES: std::ops::RangeInclusive<u8> = 8..=36;

/// Words that say that somebody has no large print.
const NO: [&str; 9] = ["", "-", "–", "0", "no", "n", "false", "non", "nein"];

/// A size of type that no sheet is printed in.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{found}` is not a size of type")]
pub struct TypeSizeError {
    /// What was found.
    pub found: String,
}

impl Student {
    /// The size of type that a cell of a class list asks for: a number of points, or any word but a no for 18 points.
    ///
    /// # Errors
    ///
    /// A number that is not from 8 to 36.
    ///
    /// ```
    /// use vibank::worksheet::Student;
    /// assert_eq!(Student::read_type_size("yes"), Ok(Some(18)));
    /// assert_eq!(Student::read_type_size("24 pt"), Ok(Some(24)));
    /// assert_eq!(Student::read_type_size("no"), Ok(None));
    /// assert!(Student::read_type_size("140").is_err());
    /// ```
    pub fn read_type_size(cell: &str) -> Result<Option<u8>, TypeSizeError> {
        let cell = cell.trim().to_lowercase();
        if NO.contains(&cell.as_str()) {
            return Ok(None);
        }
        if !cell.starts_with(|sign: char| sign.is_ascii_digit()) {
            return Ok(Some(LARGE));
        }
        let number = cell.trim_end_matches("pt").trim_end();
        let size = number.parse().ok().filter(|size| SIZES.contains(size));
        size.map(Some).ok_or(TypeSizeError { found: cell })
    }

    /// Whether the seat is one whose neighbours are known: a row and a place, or a number.
    pub fn has_place(&self) -> bool {
        Seat::read(&self.seat).is_some()
    }
}

/// Most letters of an `id` or a name that become part of the name of a file.
const MAX_LENGTH: usize = 40;

/// The name of the files of a sheet, without folder and ending: its place in the class list, the `id` and the name, or the
/// code where it is nobody's.
///
/// Letters and digits of all scripts stay, everything else becomes a hyphen, so that each file system takes it.
///
/// ```
/// use vibank::worksheet::{Student, file_stem};
/// let student = Student { id: "s/1234".into(), name: "Müller, Anna".into(), ..Student::default() };
/// assert_eq!(file_stem(11, 300, Some(&student), "XM2-9SB-THF"), "012-s-1234-Müller-Anna");
/// assert_eq!(file_stem(300, 300, None, "XM2-9SB-THF"), "301-spare-XM2-9SB-THF");
/// ```
pub fn file_stem(place: usize, count: usize, student: Option<&Student>, code: &str) -> String {
    /// A class of up to 999 has its files in order.
    const DIGITS: usize = 3;
    let digits = count.to_string().len().max(DIGITS);
    let number = format!("{:0digits$}", place + 1);
    let Some(student) = student else {
        return format!("{number}-spare-{code}");
    };
    let words = [number, plain(&student.id), plain(&student.name)];
    let words = words.into_iter().filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}

/// The letters and digits of a text, with hyphens between its words.
fn plain(text: &str) -> String {
    let words = text.split(|sign: char| {
        !(sign.is_alphanumeric() || matches!(sign, '_' | '\u{300}'..='\u{36f}'))
    });
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let plain: String = words.join("-").chars().take(MAX_LENGTH).collect();
    plain.trim_end_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn student(room: &str, seat: &str) -> Student {
        Student {
            room: room.to_owned(),
            seat: seat.to_owned(),
            ..Student::default()
        }
    }

    #[test]
    fn sheets_by_seat_stand_room_by_room_and_row_by_row() {
        let students = [
            student("Z", "B2"),
            student("A", "A10"),
            student("Z", ""),
            student("A", "A9"),
            student("Z", "A1"),
        ];
        let sections = PrintOrder::Seat.sections(&students, 7);
        let shown: Vec<_> = sections
            .iter()
            .map(|section| (section.whose.clone(), section.places.as_slice()))
            .collect();
        assert_eq!(
            shown,
            [
                (Whose::Room("Z".to_owned()), &[4, 0, 2][..]),
                (Whose::Room("A".to_owned()), &[3, 1]),
                (Whose::Spare, &[5, 6]),
            ]
        );
    }

    #[test]
    fn each_sheet_is_printed_once_in_every_order() {
        let students: Vec<Student> = (0..50)
            .map(|at| student(["X", "", "Y"][at * 7 % 3], &format!("{}-{}", at % 4, at)))
            .collect();
        for order in [
            PrintOrder::Class,
            PrintOrder::Group,
            PrintOrder::Room,
            PrintOrder::Seat,
        ] {
            for (students, count) in [(&students[..], 53), (&students[..], 50), (&[], 4)] {
                let sections = order.sections(students, count);
                let mut places: Vec<usize> = sections
                    .into_iter()
                    .flat_map(|section| section.places)
                    .collect();
                places.sort_unstable();
                assert_eq!(places, (0..count).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn names_of_files_hold_nothing_that_a_file_system_refuses() {
        let names = [
            "../../etc/passwd",
            "a\\b:c*?\"<>|",
            "CON",
            "...",
            "王明",
            "x\0\n\ty",
            &"ü".repeat(500),
            "  ",
        ];
        for name in names {
            let student = Student {
                id: name.to_owned(),
                name: name.to_owned(),
                ..Student::default()
            };
            let stem = file_stem(0, 1, Some(&student), "code");
            assert!(stem.starts_with("001"), "{stem}");
            assert!(stem.len() <= 200 && !stem.ends_with('-'), "{stem}");
            let is_plain = |sign: char| sign.is_alphanumeric() || "-_".contains(sign);
            assert!(stem.chars().all(is_plain), "{stem}");
        }
    }
}
