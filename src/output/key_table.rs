//! The answers of all variants on one page: a line a part, a column a variant.

use serde::Serialize;

/// The answers of all variants.
#[derive(Clone, Debug, Default)]
pub struct KeyTable {
    blocks: Vec<Block>,
}

/// The answers of one variant, part by part.
#[derive(Clone, Debug, Default)]
pub struct KeyRow {
    /// Code of the variant.
    pub(super) code: String,
    /// Numbers of the parts.
    pub(super) parts: Vec<String>,
    /// The answers, written.
    pub(super) cells: Vec<String>,
    /// Letters of each answer.
    pub(super) widths: Vec<usize>,
}

/// Variants that ask the same parts.
#[derive(Clone, Debug)]
struct Block {
    variants: Vec<KeyRow>,
}

/// As many variants as fit side by side.
#[derive(Serialize)]
pub(super) struct Panel<'a> {
    codes: Vec<&'a str>,
    lines: Vec<Line<'a>>,
}

/// The answers to a part.
#[derive(Serialize)]
struct Line<'a> {
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
    /// Adds a variant; those with the same parts stand side by side.
    pub fn add(&mut self, row: KeyRow) {
        let fits = |block: &&mut Block| block.variants[0].parts == row.parts;
        match self.blocks.iter_mut().find(fits) {
            Some(block) => block.variants.push(row),
            None => self.blocks.push(Block {
                variants: vec![row],
            }),
        }
    }

    pub(super) fn panels(&self) -> Vec<Panel<'_>> {
        self.blocks.iter().flat_map(Block::panels).collect()
    }
}

impl Block {
    fn panels(&self) -> Vec<Panel<'_>> {
        let differing = self.differing();
        let width = |variant: &KeyRow| {
            let cells = differing.iter().map(|part| variant.widths[*part]);
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
            panels.push(Panel::of(panel));
            rest = later;
        }
        panels
    }

    /// The parts whose answers differ; the others take a line of their own, however wide.
    fn differing(&self) -> Vec<usize> {
        let differs = |part: &usize| {
            let first = &self.variants[0].cells[*part];
            self.variants.iter().any(|row| row.cells[*part] != *first)
        };
        (0..self.variants[0].parts.len()).filter(differs).collect()
    }
}

impl<'a> Panel<'a> {
    fn of(variants: &'a [KeyRow]) -> Self {
        let line = |(place, part): (usize, &'a String)| {
            let first = &variants[0].cells[place];
            let is_same =
                variants.len() > 1 && variants.iter().all(|row| row.cells[place] == *first);
            let is_wide = variants.iter().any(|row| row.widths[place] > CELL_WIDTH);
            let cell = |row: &'a KeyRow| Cell {
                code: &row.code,
                text: &row.cells[place],
            };
            Line {
                part,
                same: if is_same { first } else { "" },
                wide: variants.len() > 1 && is_wide,
                cells: variants.iter().map(cell).collect(),
            }
        };
        Panel {
            codes: variants.iter().map(|row| row.code.as_str()).collect(),
            lines: variants[0].parts.iter().enumerate().map(line).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(code: &str, cells: &[&str]) -> KeyRow {
        KeyRow {
            code: code.to_owned(),
            parts: (1..=cells.len()).map(|part| format!("{part}a")).collect(),
            cells: cells.iter().map(|cell| (*cell).to_owned()).collect(),
            widths: cells.iter().map(|cell| cell.len()).collect(),
        }
    }

    /// A wide answer does not push variants apart: it takes a line of its own.
    #[test]
    fn variants_stand_side_by_side_as_far_as_they_fit() {
        let equation = "m x'' + c x' + k x = 0 ".repeat(8);
        let mut table = KeyTable::default();
        for (code, answer) in [("A", "1 m"), ("B", "2 m"), ("C", "3 m")] {
            table.add(row(code, &[&equation, answer]));
        }
        let panels = table.panels();
        assert_eq!(panels.len(), 1);
        assert_eq!(panels[0].codes, ["A", "B", "C"]);
        assert_eq!(panels[0].lines[0].same, equation);
        assert_eq!(panels[0].lines[1].same, "");
        let texts = panels[0].lines[1].cells.iter().map(|cell| cell.text);
        assert_eq!(texts.collect::<Vec<_>>(), ["1 m", "2 m", "3 m"]);

        table.add(row("D", &["another", "4 m"]));
        let panels = table.panels();
        assert_eq!(panels.len(), 1);
        assert!(panels[0].lines[0].wide && !panels[0].lines[1].wide);
        table.add(row("E", &["of fewer parts"]));
        assert_eq!(table.panels().len(), 2);
        for code in ["F", "G", "H", "I"] {
            table.add(row(code, &["another", "5 m"]));
        }
        assert_eq!(table.panels().len(), 3);
    }
}
