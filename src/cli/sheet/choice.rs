//! Which formats a run makes: those of the blueprint, as far as there is a press for them.

use std::path::Path;
use std::sync::Arc;

use vibank::output;
use vibank::worksheet::{Blueprint, Student};

use crate::cli::Failure;
use crate::cli::faces::Faces;
use crate::cli::press::{Missing, Press};
use crate::cli::shard::Shard;

/// The formats of a run.
pub(crate) struct FormatChoice {
    /// Those that are made, by name.
    pub(crate) made: Vec<String>,
    /// What prints, where a format needs it.
    pub(crate) press: Option<Arc<Press>>,
    /// Fonts for names that the press lacks.
    pub(crate) faces: Faces,
    /// Named formats that are left out, since there is no press.
    pub(crate) skipped: Vec<String>,
    /// Why there is none.
    missing: Option<Missing>,
}

impl FormatChoice {
    /// The formats of a blueprint. Where it names none, HTML, and PDF where there is a press.
    ///
    /// # Errors
    ///
    /// Where a part of a run does not say its formats: machines with and without a press would make different parts.
    pub(crate) fn of(blueprint: &Blueprint, shard: Shard) -> Result<Self, Failure> {
        let mut made: Vec<String> = Vec::new();
        for format in &blueprint.formats {
            if !made.contains(&format.value) {
                made.push(format.value.clone());
            }
        }
        if !blueprint.names_formats {
            if !shard.is_whole() {
                let message = "the parts of a run need `formats` in the blueprint";
                return Err(Failure::new(message)
                    .help("name them, such as `formats = [\"pdf\", \"html\"]`: machines differ in whether they can print"));
            }
            made.push("pdf".to_owned());
        }
        let needs_press =
            |name: &String| output::writer(name).is_some_and(|writer| writer.needs_press());
        let mut choice = Self {
            press: None,
            faces: Faces::default(),
            skipped: Vec::new(),
            missing: None,
            made,
        };
        if choice.made.iter().any(needs_press) {
            match Press::find() {
                Ok(press) => choice.press = Some(Arc::new(press)),
                Err(missing) => {
                    choice.missing = Some(missing);
                    choice.made.retain(|name| !needs_press(name));
                    let named = blueprint.formats.iter().map(|format| &format.value);
                    choice.skipped = named.filter(|name| needs_press(name)).cloned().collect();
                }
            }
        }
        Ok(choice)
    }

    /// The same with fonts for the names of these students, which `folder` may hold.
    pub(crate) fn with_names(
        mut self,
        students: &[Student],
        folder: Option<&Path>,
    ) -> Result<Self, Failure> {
        let binds = |name: &String| output::writer(name).is_some_and(|writer| writer.is_bound());
        if self.made.iter().any(binds) {
            self.faces = Faces::of(students, folder)?;
        }
        Ok(self)
    }

    /// What there is to say of formats that are left out: a failure where they were named, else a line.
    pub(crate) fn remark(&self) -> Option<Result<String, Failure>> {
        let missing = self.missing.as_ref()?;
        if !self.skipped.is_empty() {
            let names = self.skipped.join(" and ");
            return Some(Err(missing.failure(&names)));
        }
        Some(Ok(match missing {
            Missing::Nowhere => format!("for PDF files too, {}", Missing::WAY_OUT),
            Missing::Unusable { .. } => missing.failure("PDF files").to_string(),
        }))
    }

    /// Endings of files that this run would renew if it had a press.
    pub(crate) fn kept(&self) -> Vec<&'static str> {
        let printed = output::WRITERS.iter().filter(|writer| writer.needs_press());
        let endings = printed.map(|writer| writer.extension());
        endings.filter(|_| self.missing.is_some()).collect()
    }
}
