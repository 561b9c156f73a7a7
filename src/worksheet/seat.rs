//! Seats of a room: who sits beside whom.

/// A seat: a row and a place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Seat {
    row: u32,
    place: u32,
}

impl Seat {
    /// Reads a seat as class lists have it: `3-7`, `C7`, or `12` where there is one row.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        let mut parts = text
            .split(|char: char| !char.is_ascii_alphanumeric())
            .filter(|part| !part.is_empty());
        let (first, second) = (parts.next()?, parts.next());
        if parts.next().is_some() {
            return None;
        }
        match second {
            Some(place) => Some(Self {
                row: row(first)?,
                place: place.parse().ok()?,
            }),
            None => {
                let digits = first.find(|char: char| char.is_ascii_digit())?;
                let (letters, place) = first.split_at(digits);
                let row = if letters.is_empty() { 0 } else { row(letters)? };
                let place = place.parse().ok()?;
                Some(Self { row, place })
            }
        }
    }

    /// The seats from which one can see it: itself, beside, before, behind and across a corner.
    pub(crate) fn around(self) -> impl Iterator<Item = Self> + Clone {
        let near = |number: u32| number.saturating_sub(1)..=number.saturating_add(1);
        near(self.row).flat_map(move |row| near(self.place).map(move |place| Self { row, place }))
    }
}

/// A row by number or by letter.
fn row(text: &str) -> Option<u32> {
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) if letter.is_ascii_alphabetic() => {
            Some(u32::from(letter.to_ascii_uppercase()) - u32::from('A') + 1)
        }
        _ => text.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::Seat;

    #[test]
    fn seats_are_read_as_class_lists_have_them() {
        for text in ["3-7", "C7", " c 7 ", "3/7", "3.7"] {
            assert_eq!(Seat::read(text), Some(Seat { row: 3, place: 7 }), "{text}");
        }
        assert_eq!(Seat::read("12"), Some(Seat { row: 0, place: 12 }));
        for text in ["", "-", "window", "1-2-3", "C", "99999999999-1"] {
            assert_eq!(Seat::read(text), None, "{text}");
        }
    }

    #[test]
    fn neighbours_sit_within_one_row_and_one_place() {
        let beside = |a, b| {
            let seat = |text| Seat::read(text).expect("it is a seat");
            seat(a).around().any(|near| near == seat(b))
        };
        assert!(beside("B3", "B4") && beside("B3", "A4") && beside("5", "6"));
        assert!(!beside("B3", "B5") && !beside("B3", "D3") && !beside("5", "7"));
    }
}
