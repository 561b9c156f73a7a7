//! The manifest of an export: what was asked under which code, so that answers that come back can be marked.

use std::collections::BTreeMap;

use vibank::answer::Doubt;
use vibank::bank::Catalogue;
use vibank::worksheet::{Blueprint, Manifest, Sheet, SheetQuestion, VariantEntry};

use crate::cli::record;

/// The questions of an export as they are written.
pub(crate) struct Record {
    manifest: Manifest,
    /// By code: variants of different items may share one.
    variants: BTreeMap<String, VariantEntry>,
}

impl Record {
    /// Of questions that no blueprint names.
    pub(crate) fn new(catalogue: &Catalogue) -> Self {
        Self {
            manifest: record::without_sheets(catalogue),
            variants: BTreeMap::new(),
        }
    }

    /// Of the questions of a blueprint.
    pub(crate) fn of(catalogue: &Catalogue, blueprint: &Blueprint, is_keyed: bool) -> Self {
        let mut record = Self::new(catalogue);
        let manifest = &mut record.manifest;
        manifest.title.clone_from(&blueprint.title);
        manifest.data = blueprint.data;
        manifest.language.clone_from(&blueprint.language.value);
        manifest.decimal = blueprint.decimal;
        manifest.doubt = blueprint.doubt.unwrap_or(Doubt::Benefit);
        manifest.other_form = blueprint.other_form.map(|share| share.share().to_f64());
        manifest.csv = blueprint.csv;
        manifest.keyed = is_keyed;
        record
    }

    /// Adds a question under its number in the whole export.
    pub(crate) fn add(&mut self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>, number: usize) {
        let template = question.solution.template();
        self.manifest
            .items
            .entry(template.id.to_string())
            .or_insert_with(|| template.source.text.to_string());
        let mut entry = record::entry(sheet);
        entry
            .questions
            .retain(|entry| entry.number == question.number);
        for entry in &mut entry.questions {
            entry.number = number;
        }
        match self.variants.get_mut(&entry.code) {
            Some(known) => known.questions.extend(entry.questions),
            None => {
                self.variants.insert(entry.code.clone(), entry);
            }
        }
    }

    /// The text of the manifest.
    pub(crate) fn finish(mut self) -> String {
        self.manifest.variants = self.variants.into_values().collect();
        record::written(self.manifest)
    }
}
