//! What a run depends on, as digests: same digest, same bytes.

use sha2::{Digest, Sha256};
use vibank::bank::Catalogue;
use vibank::worksheet::{Plan, Student};

use super::format::Format;
use crate::cli::files;
use crate::cli::shard::Shard;

/// The version of the program, as manifests have it.
pub(crate) const PROGRAM: &str = concat!("vibank ", env!("CARGO_PKG_VERSION"));

/// Digests of what a run depends on.
pub(crate) struct Stamp {
    /// Everything: program, blueprint, class list, secret, bank, layouts, what is made.
    pub(crate) inputs: String,
    /// What pages depend on beside the entry of their sheet in the manifest: program, layouts, what
    /// the blueprint says of pages, what is made.
    pub(crate) look: String,
}

impl Stamp {
    /// The stamp of a plan that is written in these formats.
    pub(crate) fn of(
        plan: &Plan<'_>,
        students: &[Student],
        catalogue: &Catalogue,
        formats: &[Format],
    ) -> Self {
        let mut look = Fields::default();
        look.add(PROGRAM);
        for format in formats {
            look.add(&format.description());
        }
        for planned in &plan.questions {
            let spaces = (planned.usual_space, planned.space, &planned.part_space);
            look.add(&format!("{spaces:?}"));
        }
        let look = look.digest();
        let mut inputs = Fields::default();
        inputs.add(&look);
        inputs.add(&plan.blueprint.source.text);
        inputs.add(&catalogue.digest());
        // A keyed code tells that the secret is the same, and nothing else of it.
        inputs.add(&plan.variant(0, 0).to_string());
        for student in students {
            for (column, value) in &student.columns {
                inputs.add(column);
                inputs.add(value);
            }
        }
        Self {
            inputs: inputs.digest(),
            look,
        }
    }

    /// The stamp of one part of the run.
    pub(crate) fn for_run(
        mut self,
        is_split: bool,
        shard: Shard,
        has_pseudonyms: bool,
        first: Option<&str>,
    ) -> Self {
        let mut inputs = Fields::default();
        inputs.add(&self.inputs);
        inputs.add(&format!("{is_split} {shard}"));
        if has_pseudonyms {
            inputs.add("pseudonyms");
        }
        if let Some(first) = first {
            inputs.add("make-up");
            inputs.add(first);
        }
        self.inputs = inputs.digest();
        self
    }
}

/// Texts that are hashed one after the other, each preceded by its length.
#[derive(Default)]
struct Fields(Sha256);

impl Fields {
    fn add(&mut self, text: &str) {
        self.0.update((text.len() as u64).to_be_bytes());
        self.0.update(text);
    }

    fn digest(self) -> String {
        files::hexadecimal(self.0)
    }
}
