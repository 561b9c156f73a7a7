//! What was handed in: the form of a run, or attempts at a platform, each of which becomes a sheet.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use rayon::prelude::*;
use vibank::bank::Catalogue;
use vibank::grade::Responses;
use vibank::message::Language;
use vibank::worksheet::{Manifest, Marks, VariantEntry};

use super::Arguments;
use super::decisions::{Corrected, Decisions};
use super::items::Items;
use super::manifest::{Sheets, manifest};
use super::marking::Marker;
use crate::cli::platform::{self, KnownQuestions, Report, Which};
use crate::cli::shard::Shard;
use crate::cli::{Failure, counted, files, package, responses};

/// What is marked.
pub(crate) struct Handed {
    pub(crate) responses: Responses,
    /// What is wrong with single rows.
    pub(crate) faults: Vec<String>,
    /// The names of the files that pages have saved, by the code of their sheets.
    pub(crate) names: BTreeMap<String, String>,
    /// The attempts, where they are not the sheets of a manifest.
    attempts: Option<Attempts>,
}

/// Attempts as sheets.
struct Attempts {
    head: Manifest,
    sheets: Vec<VariantEntry>,
}

/// Archives begin like this.
const PACKED: &[u8] = b"PK";

impl Handed {
    pub(crate) fn read(
        arguments: &Arguments,
        catalogue: &Catalogue,
        decisions: &Decisions,
    ) -> Result<Self, Failure> {
        match responses::read(&arguments.responses)? {
            responses::Handed::Rows(responses, faults) => Ok(Self::typed(responses, faults)),
            responses::Handed::Saved(saved) => Ok(Self {
                names: saved.names(),
                ..Self::typed(saved.responses, saved.faults)
            }),
            responses::Handed::Scan(scan) => {
                let sheets = manifest(&arguments.manifest)?.variants;
                let (responses, faults) = scan.taken(&sheets);
                Ok(Self::typed(responses, faults))
            }
            responses::Handed::Report(report) => {
                Self::reported(report, arguments, catalogue, decisions)
            }
        }
    }

    /// What a teacher, a student or a scanner has put into a file.
    fn typed(responses: Responses, faults: Vec<String>) -> Self {
        Self {
            responses,
            faults,
            names: BTreeMap::new(),
            attempts: None,
        }
    }

    fn reported(
        report: Report,
        arguments: &Arguments,
        catalogue: &Catalogue,
        decisions: &Decisions,
    ) -> Result<Self, Failure> {
        let path = &arguments.manifest;
        let is_package = files::read_bytes(path)?.starts_with(PACKED);
        let package = is_package.then(|| package::read(path, catalogue));
        let package = package.transpose()?;
        let head = match &package {
            Some(package) => package.manifest(catalogue),
            None => manifest(path)?,
        };
        let known = match &package {
            Some(package) => KnownQuestions::Package(package),
            None => KnownQuestions::of(&head),
        };
        let kept = std::slice::from_ref(&head.items);
        let items = Items::of(kept, catalogue, arguments.accept_revisions);
        let which = arguments.attempt;
        let (attempts, faults) = platform::taken(report, &known, which, &|question| {
            items.find(&question.item, question.revision)
        })?;
        let count = attempts.len();
        let points = if which == Which::Best {
            let sheets = Sheets::of_attempts(path, &head, Vec::new());
            let marker = Marker {
                items: &items,
                corrected: &Corrected::new(),
                marks: &Marks::default(),
                decimal: sheets.decimal,
                language: Language::of(&head.language).unwrap_or_default(),
                doubt: sheets.doubt,
                other_form: sheets.other_form,
                responses: &platform::responses(&attempts),
                decisions,
                takes_points: false,
            };
            attempts
                .par_iter()
                .map(|taken| Ok(marker.sheet(&taken.entry)?.0.points()))
                .collect::<Result<Vec<_>, Failure>>()?
        } else {
            Vec::new()
        };
        let attempts = which.choose(attempts, &points);
        if attempts.len() < count {
            println!(
                "{count} attempts of {}; of several the {} counts (`--attempt`)",
                counted(attempts.len(), "student"),
                which.name()
            );
        }
        Ok(Self {
            responses: platform::responses(&attempts),
            faults,
            names: BTreeMap::new(),
            attempts: Some(Attempts {
                head,
                sheets: attempts.into_iter().map(|taken| taken.entry).collect(),
            }),
        })
    }

    /// Whether a teacher typed it, so that it holds the points for work on paper.
    pub(crate) fn is_typed(&self) -> bool {
        self.attempts.is_none() && self.names.is_empty()
    }

    /// The places of the sheets that a part of a run marks, of sheets with these codes and so many parts each: the parts of
    /// the run cost about the same.
    pub(crate) fn share(&self, shard: Shard, sheets: &[(String, usize)]) -> Range<usize> {
        /// What it costs to mark an answer, where a part that nobody answered costs one: on 1000 sheets of 50 parts an
        /// answer took 2.8 times as long as the rest of its part.
        const ANSWER: usize = 3;
        shard.share_of(
            &sheets
                .iter()
                .map(|(code, parts)| (1 + parts + ANSWER * self.responses.answers(code)) as u64)
                .collect::<Vec<_>>(),
        )
    }

    /// The sheets that are marked.
    pub(crate) fn sheets(&self, manifest: &Path) -> Result<Sheets, Failure> {
        match &self.attempts {
            Some(attempts) => Ok(Sheets::of_attempts(
                manifest,
                &attempts.head,
                attempts.sheets.clone(),
            )),
            None => Sheets::open(manifest, &self.responses.codes()),
        }
    }
}
