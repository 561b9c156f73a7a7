//! The file of decisions, `decisions.toml`.

use std::path::{Path, PathBuf};

use vibank::diagnostic::Finding;
use vibank::source::Source;
use vibank::worksheet::{self, HandedOut, Subject};

use super::table::settle;
use super::{Decision, Decisions, Effect};
use crate::cli::grade::undecided::AlikeAnswers;
use crate::cli::{Failure, bank, files};

/// The name of the file that stands beside a manifest.
const NAME: &str = "decisions.toml";

/// The file about a run: the one that is named, else the one beside its manifest, if there is one.
pub(crate) fn find(named: Option<&Path>, manifest: &Path) -> Option<PathBuf> {
    let beside = manifest.with_file_name(NAME);
    named
        .map(Path::to_owned)
        .or_else(|| beside.is_file().then_some(beside))
}

/// Reads a file of decisions, as far as it says nothing of what was handed out.
pub(crate) fn read(path: &Path) -> Result<worksheet::Decisions, Failure> {
    let name = path.display().to_string();
    let source = Source::new(name, files::read(path)?);
    worksheet::Decisions::read(&source).map_err(|findings| refuse(&findings))
}

/// Adds the decisions of a file, each about a part that was handed out.
///
/// What is decided for a second time is reported, by file and line.
pub(crate) fn add(
    decisions: &mut Decisions,
    file: &worksheet::Decisions,
    handed_out: &HandedOut,
) -> Result<Vec<String>, Failure> {
    let subjects = file.subjects(handed_out);
    let subjects = subjects.map_err(|findings| refuse(&findings))?;
    let mut faults = Vec::new();
    for (subject, stated) in subjects.into_iter().zip(&file.decisions) {
        let (place, fault) = keep(decisions, subject, stated, &file.source);
        faults.extend(fault.map(|fault| format!("{place}: {fault}")));
    }
    decisions.marks.clone_from(&file.marks);
    Ok(faults)
}

fn keep(
    decisions: &mut Decisions,
    subject: Subject,
    stated: &worksheet::Decision,
    source: &Source,
) -> (String, Option<String>) {
    let Subject { sheet, item, part } = &subject;
    let given = stated.given.as_ref().map(|given| &*given.value);
    let effect = match &stated.effect {
        worksheet::Effect::Void(void) => Effect::Void(*void),
        worksheet::Effect::Accept(texts, credit) => Effect::Accept(texts.clone(), *credit),
        worksheet::Effect::Key(key) => Effect::Key(key.value.clone()),
        worksheet::Effect::Read(response) => Effect::Settle {
            response: Some(response.clone()),
            points: None,
        },
        worksheet::Effect::Points(points) => Effect::Settle {
            response: None,
            points: Some(*points),
        },
    };
    let whose = sheet.as_ref();
    let whose = whose.map_or_else(String::new, |code| format!(" of sheet {code}"));
    let where_given = given.map_or_else(String::new, |given| format!(", where `{given}`"));
    let place = format!("{}, line {}", source.path, stated.line);
    let decision = Decision {
        place: place.clone(),
        subject: format!("`{part}` of `{item}`{whose}{where_given}"),
        words: stated.words(),
        who: stated.who.clone(),
        why: stated.why.clone(),
        feedback: stated.feedback.clone(),
        unknown: match given {
            Some(_) => format!("nobody gave this answer to part `{part}` of `{item}`"),
            None => format!("no part `{part}` of `{item}` was handed out{whose}"),
        },
        part: format!("`{part}`"),
        is_claimed: false,
        exceeded: None,
        effect,
    };
    if !matches!(decision.effect, Effect::Settle { .. }) {
        let number = decisions.all.len();
        decisions.all.push(decision);
        let own = decisions.rules.entry((item.clone(), part.clone()));
        own.or_default().push((subject.sheet, number));
        return (place, None);
    }
    let kept = match given {
        Some(given) => {
            let alike = AlikeAnswers::new(item, part, given);
            settle(&mut decisions.all, &mut decisions.alike, alike, decision)
        }
        None if sheet.is_some() => {
            settle(&mut decisions.all, &mut decisions.parts, subject, decision)
        }
        None => {
            let name = (subject.item, subject.part);
            settle(&mut decisions.all, &mut decisions.items, name, decision)
        }
    };
    (place, kept.err())
}

/// Prints findings; the failure that follows counts them.
fn refuse(findings: &[Finding]) -> Failure {
    bank::print(findings);
    let count = findings.len();
    Failure::new(format!(
        "{count} finding{}",
        if count == 1 { "" } else { "s" }
    ))
}
