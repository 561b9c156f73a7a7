//! What was answered, for those who ask that it be kept.

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::Path;

use serde_json::json;
use vibank::answer::Marking;
use vibank::instance::Instance;

use crate::cli::Failure;
use crate::cli::files::unwritable;

/// A log, or none.
pub(crate) struct Log(Option<File>);

impl Log {
    /// Opens the file to append to.
    pub(crate) fn open(path: Option<&Path>) -> Result<Self, Failure> {
        path.map(|path| {
            let file = OpenOptions::new().append(true).create(true).open(path);
            file.map_err(unwritable(path))
        })
        .transpose()
        .map(Self)
    }

    /// Notes an answer.
    pub(crate) fn note(
        &mut self,
        instance: &Instance<'_>,
        part: &str,
        response: &str,
        marking: &Marking,
        hints: usize,
    ) -> Result<(), Failure> {
        let Some(file) = &mut self.0 else {
            return Ok(());
        };
        let template = instance.template();
        let entry = json!({
            "item": template.id,
            "revision": template.revision,
            "seed": instance.seed(),
            "part": part,
            "response": response,
            "verdict": marking.verdict,
            "credit": marking.credit,
            "reasons": marking.reasons().iter().map(|reason| reason.code()).collect::<Vec<_>>(),
            "hints": hints,
        });
        writeln!(file, "{entry}")
            .map_err(|error| Failure::new(format!("cannot write the log: {error}")))
    }
}
