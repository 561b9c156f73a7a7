//! What a manifest holds, seen before anything is marked.

use std::collections::{BTreeMap, BTreeSet};

use vibank::bank::{Catalogue, ItemId, Revision};
use vibank::report::order;
use vibank::worksheet::{HandedOut, QuestionEntry, Student};

use super::items::Items;
use super::manifest::Sheets;
use super::tables::Column;
use crate::cli::Failure;

/// What a manifest holds.
pub(crate) struct Census<'c> {
    /// The items that the sheets are marked with.
    pub(crate) items: Items<'c>,
    /// The sheets in their order: the code of each, and how many parts it has.
    pub(crate) sheets: Vec<(String, usize)>,
    /// All parts, in the order of the sheets.
    pub(crate) columns: Vec<Column>,
    /// Whether a person marks some of them.
    pub(crate) has_hand: bool,
    /// What decisions may name.
    pub(crate) handed_out: HandedOut,
    /// The items and texts of them that are on sheets.
    pub(crate) used: BTreeSet<(ItemId, Revision)>,
    /// The students by `id` and name.
    pub(crate) students: Vec<Student>,
    /// The columns of the class list.
    pub(crate) known_by: BTreeSet<String>,
    /// Items whose text in the bank is another one than when the sheets were made.
    pub(crate) changed: Vec<String>,
}

impl<'c> Census<'c> {
    /// Looks through all sheets; items that nobody has any more are refused.
    pub(crate) fn take(
        sheets: &mut Sheets,
        catalogue: &'c Catalogue,
        accepts: bool,
    ) -> Result<Self, Failure> {
        let mut census = Self {
            items: Items::of(&[], catalogue, accepts),
            sheets: Vec::new(),
            columns: Vec::new(),
            has_hand: false,
            handed_out: HandedOut::default(),
            used: BTreeSet::new(),
            students: Vec::new(),
            known_by: BTreeSet::new(),
            changed: Vec::new(),
        };
        let mut columns = BTreeSet::new();
        let mut used = BTreeMap::<_, BTreeSet<String>>::new();
        loop {
            let chunk = sheets.chunk(super::CHUNK)?;
            if chunk.is_empty() {
                break;
            }
            census.sheets.extend(chunk.iter().map(|variant| {
                let parts = variant
                    .questions
                    .iter()
                    .map(|question| question.parts.len());
                (variant.code.clone(), parts.sum())
            }));
            for variant in &chunk {
                if !census.handed_out.codes.insert(variant.code.clone()) {
                    let code = &variant.code;
                    let failure = Failure::new(format!("the manifest has the sheet {code} twice"));
                    return Err(failure.help("give the `manifest.json` as `vibank sheet` wrote it"));
                }
            }
            for student in chunk.iter().filter_map(|variant| variant.student.as_ref()) {
                if census.known_by.len() < student.len() {
                    census.known_by.extend(student.keys().cloned());
                }
                census.students.push(Student {
                    id: student.get("id").cloned().unwrap_or_default(),
                    name: student.get("name").cloned().unwrap_or_default(),
                    ..Student::default()
                });
            }
            for question in chunk.iter().flat_map(|variant| &variant.questions) {
                for part in &question.parts {
                    columns.insert((question.number, part.letter.clone()));
                }
                columns.insert((question.number, String::new()));
                census.note(question);
                let parts = used.entry((question.item.clone(), question.revision));
                let ids = question.parts.iter().map(|part| part.id.clone());
                parts.or_default().extend(ids);
            }
        }
        census.columns = columns.into_iter().collect();
        census
            .columns
            .sort_by(|(a, first), (b, second)| (a, order(first)).cmp(&(b, order(second))));
        census.items = Items::of(&sheets.items, catalogue, accepts);
        for ((item, revision), parts) in &used {
            let template = census.items.find(item, *revision)?;
            let mut parts = parts.iter().filter_map(|id| template.part(id));
            census.has_hand |= parts.any(|part| part.answer.kind().is_by_hand());
            census.used.insert((item.clone(), *revision));
            if census.items.has_moved_on(item, *revision) {
                census.changed.push(item.to_string());
            }
        }
        Ok(census)
    }

    /// Notes what decisions may name of a question.
    fn note(&mut self, question: &QuestionEntry) {
        let item = question.item.to_string();
        self.handed_out
            .questions
            .entry(question.number)
            .or_default()
            .insert(item.clone());
        let parts = question.parts.iter();
        let parts = parts.map(|part| (part.id.clone(), part.letter.clone()));
        let together = self.handed_out.parts.entry(item).or_default();
        together.insert(parts.collect());
    }
}
