//! Marking one sheet.

use vibank::answer::{Credit, Doubt, Verdict};
use vibank::bank::Template;
use vibank::grade::{
    self, Comment, Feedback, Grade, PartFeedback, Place, QuestionFeedback, Responses, Sheet,
};
use vibank::numerics::Rational;
use vibank::solution::Solution;
use vibank::worksheet::{PartEntry, QuestionEntry, VariantEntry};

use super::items::Items;
use super::manifest::solution;
use super::outcome::{Fraction, Outcome, PartOutcome, sum};
use super::overrides::{Override, Overrides};
use super::undecided::Alike;
use crate::cli::Failure;

/// What all sheets of a run are marked with.
pub(super) struct Marker<'a> {
    pub(super) items: &'a Items<'a>,
    pub(super) decimal: char,
    pub(super) doubt: Doubt,
    pub(super) other_form: Option<Credit>,
    pub(super) responses: &'a Responses,
    pub(super) overrides: &'a Overrides,
}

/// A part as it was handed out and answered.
struct Answered<'a> {
    entry: &'a PartEntry,
    /// Its place in the item.
    place: usize,
    max: Rational,
    given: &'a str,
    /// Whether `given` is what the file holds, which does not say what was answered.
    is_open: bool,
    decision: Option<&'a Override>,
}

impl<'a> Answered<'a> {
    /// What is marked.
    fn response(&self) -> &'a str {
        let read = self
            .decision
            .and_then(|decision| decision.response.as_deref());
        read.unwrap_or(if self.is_open { "" } else { self.given })
    }

    /// Whether nobody has said yet what was answered.
    fn is_undecided(&self) -> bool {
        let is_settled =
            |decision: &Override| decision.response.is_some() || decision.points.is_some();
        self.is_open && !self.decision.is_some_and(is_settled)
    }
}

impl Marker<'_> {
    /// What came out for a sheet, and what its student is told.
    pub(super) fn sheet(&self, variant: &VariantEntry) -> Result<(Outcome, Feedback), Failure> {
        let (mut parts, mut questions) = (Vec::new(), Vec::new());
        for question in &variant.questions {
            let (outcomes, feedback) = self.question(&variant.code, question)?;
            parts.extend(outcomes);
            questions.push(feedback);
        }
        let outcome = Outcome {
            code: variant.code.clone(),
            student: variant.student.clone().unwrap_or_default(),
            parts,
        };
        let feedback = Feedback {
            code: outcome.code.clone(),
            name: outcome.column("name").to_owned(),
            student: outcome.column("id").to_owned(),
            points: outcome.points(),
            max: outcome.max(),
            questions,
        };
        Ok((outcome, feedback))
    }

    fn question(
        &self,
        code: &str,
        question: &QuestionEntry,
    ) -> Result<(Vec<PartOutcome>, QuestionFeedback), Failure> {
        let solution = solution(self.items, question, self.decimal, self.doubt)?;
        let answered = self.answered(code, question, solution.template())?;
        let responses = answered.iter().map(|part| (part.place, part.response()));
        let asked: Vec<usize> = answered.iter().map(|part| part.place).collect();
        let sheet = Sheet {
            asked: &asked,
            other_form: self.other_form,
        };
        let grade = Grade::mark_on(&solution, &sheet, responses);
        let (mut outcomes, mut parts) = (Vec::new(), Vec::new());
        for part in &answered {
            let (outcome, feedback) = marked(&solution, question.number, part, &grade);
            outcomes.push(outcome);
            parts.push(feedback);
        }
        let feedback = QuestionFeedback {
            number: question.number,
            title: solution.template().about.title.clone(),
            points: sum(parts.iter().map(|part| part.points)),
            max: sum(parts.iter().map(|part| part.max)),
            parts,
        };
        Ok((outcomes, feedback))
    }

    fn answered<'q>(
        &'q self,
        code: &str,
        question: &'q QuestionEntry,
        template: &Template,
    ) -> Result<Vec<Answered<'q>>, Failure> {
        let place = |entry: &PartEntry| {
            let found = template.place(&entry.id);
            found.ok_or_else(|| {
                let id = &entry.id;
                Failure::new(format!("`{}` has no part `{id}` any more", template.id))
            })
        };
        let places = question
            .parts
            .iter()
            .map(place)
            .collect::<Result<Vec<_>, _>>()?;
        let parts = question.parts.iter().zip(places);
        let answered = parts.map(|(entry, place)| {
            let at = Place {
                code: code.to_owned(),
                question: question.number,
                part: entry.letter.clone(),
            };
            let open = self.responses.open(&at);
            let given = open.or_else(|| self.responses.get(&at)).unwrap_or_default();
            let alike = Alike::new(template.id.as_str(), &entry.id, given);
            Answered {
                entry,
                place,
                max: exact(entry.points),
                given,
                is_open: open.is_some(),
                decision: self.overrides.find(&at, &alike),
            }
        });
        Ok(answered.collect())
    }
}

/// Points as the manifest states them: decimals, as they were handed out.
fn exact(points: f64) -> Rational {
    Rational::from_decimal(&points.to_string()).unwrap_or(Rational::ZERO)
}

fn marked(
    solution: &Solution<'_>,
    number: usize,
    part: &Answered<'_>,
    grade: &Grade,
) -> (PartOutcome, PartFeedback) {
    let marking = grade.part(part.place).expect("its response was marked");
    let mut remarks = grade::remarks(solution, part.place, marking);
    let mut reasons: Vec<String> = marking
        .reasons()
        .iter()
        .map(|reason| reason.code())
        .collect();
    let (mut verdict, mut credit) = (marking.verdict, marking.credit.share());
    let mut points = grade::of_marking(marking, part.max);
    if part.is_undecided() {
        verdict = Verdict::Unreadable;
        reasons = vec!["unreadable".to_owned()];
        remarks = vec![Comment::sentence(
            "The file of responses does not say clearly what was answered here.",
        )];
    }
    if let Some(decision) = part.decision {
        reasons.insert(0, "override".to_owned());
        if let Some(settled) = decision.points {
            points = settled;
            credit = settled.checked_div(part.max).unwrap_or(Rational::ZERO);
            verdict = match Credit::new(credit) {
                Some(credit) => credit.verdict(),
                None => Verdict::Right,
            };
            remarks.clear();
        }
        remarks.splice(0..0, said(decision));
    }
    let other = matches!(verdict, Verdict::Wrong)
        .then(|| grade::pattern(solution, part.place, marking))
        .flatten();
    let outcome = PartOutcome {
        question: number,
        letter: part.entry.letter.clone(),
        item: solution.template().id.to_string(),
        id: part.entry.id.clone(),
        response: part.given.to_owned(),
        reading: marking
            .reading
            .as_ref()
            .map_or_else(String::new, |reading| reading.math.latex()),
        verdict,
        credit: Fraction(credit),
        points: Fraction(points),
        max: Fraction(part.max),
        reasons,
        feedback: remarks
            .iter()
            .map(Comment::plain)
            .collect::<Vec<_>>()
            .join(" "),
        other,
    };
    let feedback = PartFeedback {
        letter: part.entry.letter.clone(),
        verdict,
        points,
        max: part.max,
        response: part.given.to_owned(),
        reading: marking.reading.as_ref().map(|reading| reading.math.clone()),
        // The page says the verdict itself.
        remarks: if marking.remarks.is_empty() && part.decision.is_none() && !part.is_undecided() {
            Vec::new()
        } else {
            remarks
        },
    };
    (outcome, feedback)
}

/// What a student is told of a teacher's decision.
fn said(decision: &Override) -> Vec<Comment> {
    let mut said = Vec::new();
    if let Some(response) = &decision.response {
        said.push(Comment::sentence(
            "Your teacher read your answer as it was meant:",
        ));
        said.push(Comment::code(response));
    }
    match &decision.feedback {
        Some(words) => said.push(Comment::words(words)),
        None if decision.points.is_some() => {
            said.push(Comment::sentence("Marked by your teacher."));
        }
        None => {}
    }
    said
}
