//! A sheet of a blueprint with its key and its solutions, and what a teacher adds up.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use serde::Serialize;
use vibank::bank::Catalogue;
use vibank::diagnostic::Finding;
use vibank::output::{self, PageKind, Pages, Run};
use vibank::source::Source;
use vibank::worksheet::{
    Audience, Blueprint, Choice, Chooser, Plan, Sheet, SheetQuestion, Student, headings,
};

use super::duration;
use crate::cli::bank;
use crate::cli::report::Reporter;
use crate::cli::sheet::{secret, students};
use crate::cli::{Failure, counted, file_kind, files};

/// A sheet, made.
pub(crate) struct Made {
    pub(crate) summary: Summary,
    panes: [(PageKind, String); 3],
}

/// What is shown above the panes.
#[derive(Serialize)]
pub(crate) struct Summary {
    title: String,
    /// How many sheets the run has.
    count: usize,
    code: String,
    student: Option<String>,
    /// As it is printed, and in minutes where these are known.
    duration: String,
    duration_minutes: Option<f64>,
    minutes: u32,
    points: String,
    questions: Vec<Question>,
}

#[derive(Serialize)]
struct Question {
    number: usize,
    title: String,
    item: String,
    points: String,
    minutes: u32,
    parts: Vec<PreviewPart>,
}

#[derive(Serialize)]
struct PreviewPart {
    letter: String,
    kind: &'static str,
    points: String,
}

/// Why there is none.
pub(crate) enum Trouble {
    Findings(Vec<Finding>),
    Failure(Failure),
}

impl Made {
    /// The sheet at a place of the run that the blueprint would make.
    pub(crate) fn of(
        path: &Path,
        (catalogue, findings): &(Catalogue, Vec<Finding>),
        place: usize,
    ) -> Result<Self, Trouble> {
        let source = file_kind::blueprint(path)?;
        let blueprint = Blueprint::read(&source)?;
        if bank::errors(findings) > 0 {
            return Err(findings.clone().into());
        }
        let mut choices = blueprint.questions.iter().map(|question| &question.choice);
        if choices.any(|choice| matches!(choice, Choice::Pick { .. })) {
            bank::read_all(catalogue);
        }
        let plan = Plan::of(&blueprint, catalogue, secret(&blueprint)?);
        let plan = plan.map_err(|findings| with_items(findings, &blueprint, catalogue))?;
        let folder = path.parent().unwrap_or(Path::new("."));
        let students = students(&blueprint, folder)?;
        let count = match blueprint.audience {
            Audience::Variants(count) => count,
            Audience::Students(_) => students.len() + blueprint.spares,
        };
        let place = place.min(count.saturating_sub(1));
        let sheet = sheet(&plan, &students, place)?;
        let writer = output::writer("html").expect("HTML is a format");
        let run = Run::of(&blueprint, writer).with_formulas(&plan.formulas, writer);
        let pages = Pages::new(writer, run, &[])?;
        let pane = |kind| {
            let begin = pages.begin(pages.subtitle(kind))?;
            let page = pages.page(kind, &sheet)?;
            Ok::<_, output::OutputError>((kind, format!("{begin}{}{}", page.text, pages.end()?)))
        };
        let panes = [
            pane(PageKind::Sheet)?,
            pane(PageKind::Key)?,
            pane(PageKind::Solutions)?,
        ];
        let summary = Summary::of(&plan, &sheet, count, &pages);
        Ok(Self { summary, panes })
    }

    /// The page of this name.
    pub(crate) fn pane(&self, name: &str) -> Option<&str> {
        let (_, text) = self.panes.iter().find(|(kind, _)| kind.name() == name)?;
        Some(text)
    }

    /// What a terminal says of it.
    pub(crate) fn line(&self) -> String {
        let Summary {
            questions,
            points,
            minutes,
            duration,
            ..
        } = &self.summary;
        let of = if duration.is_empty() {
            String::new()
        } else {
            format!(" of {duration}")
        };
        let questions = counted(questions.len(), "question");
        let minutes = counted(*minutes as usize, "minute");
        format!("{questions}, {points}, {minutes}{of}")
    }
}

impl Summary {
    fn of(plan: &Plan<'_>, sheet: &Sheet<'_>, count: usize, pages: &Pages) -> Self {
        let blueprint = plan.blueprint;
        let questions = sheet.questions.iter();
        let student = sheet.student.as_ref();
        Self {
            title: blueprint.title.clone(),
            count,
            code: sheet.variant.to_string(),
            student: student.map(|own| [&*own.id, &*own.name].join(" ").trim_end().to_owned()),
            duration: blueprint.duration.clone(),
            duration_minutes: duration::minutes(&blueprint.duration),
            minutes: questions.clone().map(SheetQuestion::minutes).sum(),
            points: pages.points(sheet.points),
            questions: questions.map(|own| Question::of(own, pages)).collect(),
        }
    }
}

impl Question {
    fn of(question: &SheetQuestion<'_>, pages: &Pages) -> Self {
        let template = question.solution.template();
        let called = headings(template, &question.parts).into_iter();
        let asked = called.zip(question.parts.iter().zip(&question.points));
        let parts = asked.map(|(heading, (place, points))| PreviewPart {
            letter: heading.letter,
            kind: template.parts[*place].answer.kind().name(),
            points: pages.points(*points),
        });
        Self {
            number: question.number,
            title: template.about.title.clone(),
            item: template.id.to_string(),
            points: pages.points(question.total()),
            minutes: question.minutes(),
            parts: parts.collect(),
        }
    }
}

/// The sheet at a place of the run.
///
/// Without a class list those before it are chosen first, as a run does. Who gives way to whom in a class list is left
/// out: a whole class would have to be chosen for it.
fn sheet<'c>(plan: &Plan<'c>, students: &[Student], place: usize) -> Result<Sheet<'c>, Trouble> {
    let refuse = |error: vibank::worksheet::SheetError| {
        Failure::of(error).help("loosen the constraints of the item, or fix other data with `set`")
    };
    let mut chooser = Chooser::new(plan, students, BTreeMap::new());
    let first = if students.is_empty() { 0 } else { place };
    for index in first..=place {
        let mut from = 0;
        loop {
            let candidate = chooser.propose(index as u64, from).map_err(refuse)?;
            if chooser.take(&candidate) {
                break;
            }
            from = candidate.next_attempt();
        }
    }
    let variant = chooser.taken().last().expect("one was taken");
    let student = students.get(place).cloned();
    Ok(Sheet::draw(plan, variant, student).map_err(refuse)?)
}

/// Findings about a blueprint, and about the items that it names.
fn with_items(mut findings: Vec<Finding>, blueprint: &Blueprint, catalogue: &Catalogue) -> Trouble {
    let named = blueprint
        .questions
        .iter()
        .filter_map(|own| match &own.choice {
            Choice::Item(item) => Some(item.value.as_str()),
            _ => None,
        });
    let named: Vec<&str> = named.collect();
    findings.extend(catalogue.findings_among(|id| named.contains(&id.as_str())));
    findings.into()
}

/// The files that a blueprint names, which stand beside it.
pub(crate) fn beside(path: &Path) -> Vec<PathBuf> {
    let Ok(text) = files::read(path) else {
        return Vec::new();
    };
    let Ok(blueprint) = Blueprint::read(&Source::new(path.display().to_string(), text)) else {
        return Vec::new();
    };
    let list = match &blueprint.audience {
        Audience::Students(list) => Some(list),
        Audience::Variants(_) => None,
    };
    let named = list.into_iter().chain(&blueprint.secret);
    named.map(|name| path.with_file_name(&name.value)).collect()
}

impl From<Vec<Finding>> for Trouble {
    fn from(findings: Vec<Finding>) -> Self {
        Self::Findings(findings)
    }
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

impl From<output::OutputError> for Trouble {
    fn from(error: output::OutputError) -> Self {
        Self::Failure(Failure::of(error))
    }
}

impl fmt::Display for Trouble {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Findings(findings) => {
                let reporter = Reporter::plain();
                let mut findings = findings.iter();
                findings.try_for_each(|own| writeln!(formatter, "{}\n", reporter.draw(own)))
            }
            Self::Failure(failure) => failure.fmt(formatter),
        }
    }
}
