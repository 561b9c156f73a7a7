//! What of a class list is taken as it stands, though it may not be meant: said once, with the lines.

use std::collections::BTreeMap;

use vibank::worksheet::Student;

/// What stands out among the students of a list.
#[derive(Debug, Default)]
pub(crate) struct Notes {
    /// By room and seat, who has it first.
    seats: BTreeMap<(String, String), (String, usize)>,
    shared: Vec<String>,
    nowhere: Vec<String>,
    formats: Vec<String>,
}

/// How many of a kind are named.
const MAX_NAMED: usize = 3;

impl Notes {
    pub(crate) fn look_at(&mut self, student: &Student, line: usize) {
        let Student { id, seat, room, .. } = student;
        if !seat.is_empty() {
            let own = (room.to_lowercase(), seat.to_lowercase());
            match self.seats.get(&own) {
                Some((first, at)) => self.shared.push(format!(
                    "`{seat}` of `{first}` (line {at}) and `{id}` (line {line})"
                )),
                None => {
                    self.seats.insert(own, (id.clone(), line));
                }
            }
            if !student.has_place() {
                self.nowhere
                    .push(format!("`{seat}` of `{id}` (line {line})"));
            }
        }
        let format = student.columns.get("format");
        let format = format.map_or("", |format| format.trim());
        if !["", "paper", "screen"].contains(&format.to_lowercase().as_str()) {
            self.formats
                .push(format!("`{format}` of `{id}` (line {line})"));
        }
    }

    pub(crate) fn print(&self, list: &str) {
        for line in self.lines() {
            eprintln!("`{list}`: {line}");
        }
    }

    fn lines(&self) -> Vec<String> {
        let kinds = [
            ("seats that two students have", &self.shared, ""),
            (
                "seats that are no row and place, such as C7 or 3-7, so that no neighbours are known",
                &self.nowhere,
                "",
            ),
            (
                "words under `format`",
                &self.formats,
                "; they are taken for `paper`, and `screen` is the other one",
            ),
        ];
        let kinds = kinds.into_iter().filter(|(_, found, _)| !found.is_empty());
        kinds
            .map(|(what, found, end)| {
                let named = &found[..found.len().min(MAX_NAMED)];
                let others = match found.len() - named.len() {
                    0 => String::new(),
                    count => format!(" and {count} more"),
                };
                format!("{what}: {}{others}{end}", named.join(", "))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_out_is_said_with_its_lines() {
        let mut notes = Notes::default();
        for (line, (id, room, seat, format)) in (2..).zip([
            ("s1", "", "A1", ""),
            ("s2", "", "a1", "Screen"),
            ("s3", "Hall", "A1", "paper"),
            ("s4", "", "window", "tablet"),
            ("s5", "", "", ""),
        ]) {
            let student = Student {
                id: id.to_owned(),
                room: room.to_owned(),
                seat: seat.to_owned(),
                columns: [("format".to_owned(), format.to_owned())].into(),
                ..Student::default()
            };
            notes.look_at(&student, line);
        }
        let lines = notes.lines();
        assert_eq!(
            lines[0],
            "seats that two students have: `a1` of `s1` (line 2) and `s2` (line 3)"
        );
        assert!(lines[1].ends_with("known: `window` of `s4` (line 5)"));
        assert!(lines[2].starts_with("words under `format`: `tablet` of `s4` (line 5); they"));
        assert_eq!(lines.len(), 3);
        assert!(Notes::default().lines().is_empty());
    }
}
