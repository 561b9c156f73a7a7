//! The answers of all variants, item by item: a line a part, a column a variant.
//!
//! What all variants share stands first and once. The rest is grouped by the item that asks it, so that whoever marks a
//! question finds all variants of it on one page, however many there are.

use serde::Serialize;

use super::layouts::OutputError;
use super::pages::{Pages, Run};
use crate::scene::Scene;
use crate::worksheet::{Sheet, headings};

/// The answers of some variants.
#[derive(Clone, Debug, Default)]
pub struct KeyTable {
    items: Vec<ItemKeys>,
    /// How many variants were added.
    count: usize,
}

/// The answers of one variant, question by question.
#[derive(Clone, Debug, Default)]
pub struct KeyRow {
    /// Code of the variant.
    pub(crate) code: String,
    /// In the order of the sheet.
    pub(crate) questions: Vec<QuestionKeys>,
}

/// The answers to one question of a variant.
#[derive(Clone, Debug, Default)]
pub(crate) struct QuestionKeys {
    /// Its place on the sheet.
    pub(crate) number: usize,
    /// The item that asks it.
    pub(crate) item: String,
    /// Numbers of the parts.
    pub(crate) parts: Vec<String>,
    /// The answers, written.
    pub(crate) cells: Vec<String>,
    /// Letters of each answer.
    pub(crate) widths: Vec<usize>,
}

/// The answers of all variants that have an item at the same place.
#[derive(Clone, Debug)]
struct ItemKeys {
    variants: Vec<KeyColumn>,
}

/// The answers of a variant to a question.
#[derive(Clone, Debug)]
struct KeyColumn {
    code: String,
    keys: QuestionKeys,
}

/// As many variants as fit side by side; or all of them, with what they share.
#[derive(Serialize)]
pub(crate) struct Panel<'a> {
    codes: Vec<&'a str>,
    lines: Vec<KeyLine<'a>>,
}

/// The answers to a part.
#[derive(Serialize)]
struct KeyLine<'a> {
    part: &'a str,
    /// The answer that all variants of the panel have.
    same: &'a str,
    /// Whether the answers are so wide that each takes a line of its own.
    wide: bool,
    /// One for each variant.
    cells: Vec<Cell<'a>>,
}

/// The answer of a variant.
#[derive(Serialize)]
struct Cell<'a> {
    code: &'a str,
    text: &'a str,
}

/// Letters that fit side by side on a page.
const PANEL_WIDTH: usize = 84;

/// Letters of an answer that stands beside those of other variants.
const CELL_WIDTH: usize = 26;

/// Variants side by side at most.
const PANEL_LENGTH: usize = 6;

impl KeyTable {
    /// Adds a variant.
    pub fn add(&mut self, row: KeyRow) {
        self.count += 1;
        for keys in row.questions {
            let column = KeyColumn {
                code: row.code.clone(),
                keys,
            };
            match self.items.iter_mut().find(|item| item.asks(&column.keys)) {
                Some(item) => item.variants.push(column),
                None => self.items.push(ItemKeys {
                    variants: vec![column],
                }),
            }
        }
    }

    /// What all variants share, under the heading `all`, then the answers item by item.
    pub(crate) fn panels<'a>(&'a self, all: &'a str) -> Vec<Panel<'a>> {
        let mut items: Vec<&ItemKeys> = self.items.iter().collect();
        // What only some variants are asked comes up late, and stands at its place on the sheet all the same.
        items.sort_by_key(|item| item.number());
        let is_shared = |item: &ItemKeys, part: usize| {
            self.count > 1 && item.variants.len() == self.count && item.is_same(part)
        };
        let shared = items.iter().flat_map(|item| {
            let parts = item.parts().filter(|part| is_shared(item, *part));
            parts.map(|part| KeyLine::of(&item.variants[..1], part, Some(all)))
        });
        let shared: Vec<KeyLine<'a>> = shared.collect();
        let mut panels = Vec::new();
        if !shared.is_empty() {
            panels.push(Panel {
                codes: vec![all],
                lines: shared,
            });
        }
        for item in items {
            let own: Vec<usize> = item
                .parts()
                .filter(|part| !is_shared(item, *part))
                .collect();
            if !own.is_empty() {
                panels.extend(item.panels(&own));
            }
        }
        panels
    }
}

impl ItemKeys {
    /// Whether it is where these answers belong.
    fn asks(&self, keys: &QuestionKeys) -> bool {
        let own = &self.variants[0].keys;
        (own.number, &own.item, &own.parts) == (keys.number, &keys.item, &keys.parts)
    }

    fn number(&self) -> usize {
        self.variants[0].keys.number
    }

    fn parts(&self) -> std::ops::Range<usize> {
        0..self.variants[0].keys.parts.len()
    }

    /// Whether all its variants have the same answer to a part.
    fn is_same(&self, part: usize) -> bool {
        let first = &self.variants[0].keys.cells[part];
        self.variants
            .iter()
            .all(|own| own.keys.cells[part] == *first)
    }

    /// Panels with these of its parts.
    fn panels(&self, parts: &[usize]) -> Vec<Panel<'_>> {
        let differing: Vec<usize> = parts
            .iter()
            .copied()
            .filter(|part| !self.is_same(*part))
            .collect();
        let width = |variant: &KeyColumn| {
            let cells = differing.iter().map(|part| variant.keys.widths[*part]);
            let cells = cells.filter(|width| *width <= CELL_WIDTH);
            cells.max().unwrap_or(0).max(variant.code.len() + 2) + 3
        };
        let mut panels = Vec::new();
        let mut rest = self.variants.as_slice();
        while !rest.is_empty() {
            let mut used = 0;
            let fitting = rest.iter().take(PANEL_LENGTH).take_while(|variant| {
                used += width(variant);
                used <= PANEL_WIDTH
            });
            let (panel, later) = rest.split_at(fitting.count().max(1));
            panels.push(Panel {
                codes: panel.iter().map(|own| own.code.as_str()).collect(),
                lines: parts
                    .iter()
                    .map(|part| KeyLine::of(panel, *part, None))
                    .collect(),
            });
            rest = later;
        }
        panels
    }
}

impl<'a> KeyLine<'a> {
    /// The answers of variants to a part; with `heading` the one that all have.
    fn of(variants: &'a [KeyColumn], part: usize, heading: Option<&'a str>) -> Self {
        let first = &variants[0].keys;
        let is_same = variants.len() > 1
            && variants
                .iter()
                .all(|own| own.keys.cells[part] == first.cells[part]);
        let is_wide = variants
            .iter()
            .any(|own| own.keys.widths[part] > CELL_WIDTH);
        KeyLine {
            part: &first.parts[part],
            same: if is_same { &first.cells[part] } else { "" },
            wide: variants.len() > 1 && is_wide,
            cells: variants
                .iter()
                .map(|own| Cell {
                    code: heading.unwrap_or(&own.code),
                    text: &own.keys.cells[part],
                })
                .collect(),
        }
    }
}

/// The answers of a sheet, for the table of all variants.
pub fn key_row(pages: &Pages, sheet: &Sheet<'_>) -> KeyRow {
    let code = sheet.variant.to_string();
    let words = pages.run.words;
    let phrase = |text: &str| (pages.writer.words(text), text.chars().count());
    let mut questions = Vec::new();
    for question in &sheet.questions {
        let scene = Scene::of(&question.solution, pages.run.data).spoken(pages.run.spoken());
        let template = question.solution.template();
        let mut keys = QuestionKeys {
            number: question.number,
            item: template.id.to_string(),
            ..QuestionKeys::default()
        };
        let headings = headings(template, &question.parts);
        for (heading, place) in headings.iter().zip(&question.parts) {
            let (cell, width) = match scene.key(*place) {
                Ok(Some(key)) => (
                    pages.writer.math(&key, pages.run.voice()),
                    key.plain().chars().count(),
                ),
                Ok(None) => phrase(&words.in_the_solution),
                Err(_) if template.parts[*place].answer.kind().is_by_hand() => {
                    phrase(&words.by_hand)
                }
                Err(_) => (pages.writer.words("–"), 1),
            };
            let part = format!("{}{}", question.number, heading.letter);
            keys.parts.push(part);
            keys.cells.push(cell);
            keys.widths.push(width);
        }
        questions.push(keys);
    }
    KeyRow { code, questions }
}

/// The page with the answers of some variants: what they share first, then item by item.
///
/// # Errors
///
/// [`OutputError::Page`].
pub fn key_table_page(pages: &Pages, table: &KeyTable) -> Result<String, OutputError> {
    #[derive(Serialize)]
    struct KeyTablePage<'a> {
        run: &'a Run,
        panels: Vec<Panel<'a>>,
    }
    let all = pages.placed(&pages.run.words.all_sheets);
    let panels = table.panels(&all);
    let run = &pages.run;
    pages
        .layouts
        .fill("keytable", &KeyTablePage { run, panels })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn question(number: usize, item: &str, cells: &[&str]) -> QuestionKeys {
        let part = |place: usize| format!("{number}{}", char::from(b'a' + place as u8));
        QuestionKeys {
            number,
            item: item.to_owned(),
            parts: (0..cells.len()).map(part).collect(),
            cells: cells.iter().map(|cell| (*cell).to_owned()).collect(),
            widths: cells.iter().map(|cell| cell.len()).collect(),
        }
    }

    fn row(code: &str, questions: Vec<QuestionKeys>) -> KeyRow {
        KeyRow {
            code: code.to_owned(),
            questions,
        }
    }

    /// The parts of a panel with their answers, those of several variants with a bar between them.
    fn lines(panel: &Panel<'_>) -> Vec<String> {
        let line = |line: &KeyLine<'_>| {
            let cells: Vec<&str> = line.cells.iter().map(|cell| cell.text).collect();
            format!("{} {}", line.part, cells.join("|"))
        };
        panel.lines.iter().map(line).collect()
    }

    /// A wide answer does not push variants apart: it takes a line of its own.
    #[test]
    fn variants_stand_side_by_side_as_far_as_they_fit() {
        let equation = "m x'' + c x' + k x = 0 ".repeat(8);
        let mut table = KeyTable::default();
        for (code, answer) in [("A", "1 m"), ("B", "2 m"), ("C", "3 m")] {
            table.add(row(code, vec![question(1, "e1", &[&equation, answer])]));
        }
        let panels = table.panels("All");
        assert_eq!(panels.len(), 2);
        assert_eq!(panels[0].codes, ["All"]);
        assert_eq!(lines(&panels[0]), [format!("1a {equation}")]);
        assert_eq!(panels[1].codes, ["A", "B", "C"]);
        assert_eq!(lines(&panels[1]), ["1b 1 m|2 m|3 m"]);

        table.add(row("D", vec![question(1, "e1", &["another", "4 m"])]));
        let panels = table.panels("All");
        assert_eq!(panels.len(), 1);
        assert!(panels[0].lines[0].wide && !panels[0].lines[1].wide);
        for code in ["F", "G", "H", "I"] {
            table.add(row(code, vec![question(1, "e1", &["another", "5 m"])]));
        }
        assert_eq!(table.panels("All").len(), 2);
    }

    #[test]
    fn what_all_share_comes_first_and_the_rest_item_by_item() {
        let mut table = KeyTable::default();
        // Of the second question some have one item, some another.
        table.add(row(
            "A",
            vec![
                question(1, "e1", &["yes", "1 m"]),
                question(2, "e2", &["no"]),
                question(3, "e4", &["7 s"]),
            ],
        ));
        table.add(row(
            "B",
            vec![
                question(1, "e1", &["yes", "2 m"]),
                question(2, "e3", &["no"]),
                question(3, "e4", &["8 s"]),
            ],
        ));
        table.add(row(
            "C",
            vec![
                question(1, "e1", &["yes", "3 m"]),
                question(2, "e3", &["no"]),
                question(3, "e4", &["9 s"]),
            ],
        ));
        let panels = table.panels("All");
        let found: Vec<_> = panels
            .iter()
            .map(|panel| (panel.codes.join(" "), lines(panel)))
            .collect();
        let panel = |codes: &str, line: &str| (codes.to_owned(), vec![line.to_owned()]);
        assert_eq!(
            found,
            [
                panel("All", "1a yes"),
                panel("A B C", "1b 1 m|2 m|3 m"),
                panel("A", "2a no"),
                panel("B C", "2a no|no"),
                panel("A B C", "3a 7 s|8 s|9 s"),
            ]
        );
        assert_eq!(panels[3].lines[0].same, "no");
    }

    /// Of one variant nothing is shared.
    #[test]
    fn a_single_variant_has_its_code() {
        let mut table = KeyTable::default();
        table.add(row("A", vec![question(1, "e1", &["yes", "1 m"])]));
        let panels = table.panels("All");
        assert_eq!(panels[0].codes, ["A"]);
        assert_eq!(lines(&panels[0]), ["1a yes", "1b 1 m"]);
    }
}
