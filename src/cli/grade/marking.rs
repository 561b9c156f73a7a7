//! Marking one sheet.

use std::collections::BTreeSet;

use vibank::answer::{Credit, Doubt};
use vibank::bank::Template;
use vibank::grade::{Feedback, Grade, QuestionFeedback, Responses, Sheet};
use vibank::message::Language;
use vibank::numerics::Rational;
use vibank::worksheet::{Absence, Marks, QuestionEntry, Scored, Student, VariantEntry, Void};

use super::answered::{self, Answered};
use super::decisions::{Corrected, Decisions};
use super::items::Items;
use super::manifest::solution_of;
use super::outcome::{Fraction, QuestionOutcome, SheetOutcome, Standing, sum};
use super::part::MarkedPart;
use crate::cli::Failure;

/// What all sheets of a run are marked with.
pub(crate) struct Marker<'a> {
    pub(crate) items: &'a Items<'a>,
    /// Items whose keys were corrected.
    pub(crate) corrected: &'a Corrected,
    pub(crate) decimal: char,
    /// In which students are spoken to.
    pub(crate) language: Language,
    pub(crate) doubt: Doubt,
    pub(crate) other_form: Option<Credit>,
    /// What becomes of the points of a sheet.
    pub(crate) marks: &'a Marks,
    pub(crate) responses: &'a Responses,
    pub(crate) decisions: &'a Decisions,
    /// Whether responses to work on paper are the points that a person gave: in the report of a platform they are what
    /// students wrote.
    pub(crate) takes_points: bool,
}

impl Marker<'_> {
    /// What came out for a sheet, and what is reported to its student.
    pub(crate) fn sheet(
        &self,
        variant: &VariantEntry,
    ) -> Result<(SheetOutcome, Feedback), Failure> {
        let (mut parts, mut feedback, mut questions) = (Vec::new(), Vec::new(), Vec::new());
        let mut scored = Vec::new();
        // A sheet of which a person marks everything waits for that.
        let (mut is_touched, mut is_marked) = (false, false);
        for question in &variant.questions {
            let (marked, is_own) = self.question(&variant.code, question)?;
            is_touched |= is_own;
            is_marked |= marked.iter().any(|part| !part.outcome.by_hand);
            let standing = self.standing(&marked);
            scored.push(Scored {
                points: standing.points.0,
                open: standing.open.0,
                max: standing.max.0,
                bonus: question.bonus,
                section: &question.section,
            });
            questions.push(QuestionOutcome {
                number: question.number,
                standing,
            });
            let mut own = QuestionFeedback {
                number: question.number,
                title: self.item(question)?.about.title.clone(),
                points: standing.points.0,
                open: standing.open.0,
                max: standing.max.0,
                parts: Vec::new(),
            };
            for part in marked {
                parts.push(part.outcome);
                own.parts.push(part.feedback);
            }
            feedback.push(own);
        }
        let total = self.marks.total(&scored);
        let worth = self.marks.worth(&total);
        let outcome = SheetOutcome {
            code: variant.code.clone(),
            student: variant.student.clone().unwrap_or_default(),
            spare: variant.student.is_none(),
            unanswered: variant.student.is_some() && is_marked && !is_touched,
            parts,
            questions,
            total: Standing::of_total(&total),
        };
        let feedback = Feedback {
            code: outcome.code.clone(),
            name: outcome.column("name").to_owned(),
            student: outcome.column("id").to_owned(),
            type_size: Student::read_type_size(outcome.column("large_print")).unwrap_or_default(),
            points: total.points,
            open: total.open,
            max: total.max,
            grade: match worth.grades[..] {
                [grade] if !self.is_absent(&outcome) => Some(grade.to_owned()),
                _ => None,
            },
            questions: feedback,
        };
        Ok((outcome, feedback))
    }

    /// Whether the student of a sheet was absent: what a course platform reports was answered by somebody.
    pub(crate) fn is_absent(&self, sheet: &SheetOutcome) -> bool {
        sheet.unanswered && self.takes_points && self.marks.absent == Absence::LeftOut
    }

    /// The item of a question as it was handed out.
    fn item(&self, question: &QuestionEntry) -> Result<&Template, Failure> {
        self.items.find(&question.item, question.revision)
    }

    /// The parts of a question, marked by what was decided; each that is otherwise without it says so. And whether anybody
    /// has answered one of them.
    fn question(
        &self,
        code: &str,
        question: &QuestionEntry,
    ) -> Result<(Vec<MarkedPart>, bool), Failure> {
        let template = self.item(question)?;
        let answered = answered::parts(self, code, question, template)?;
        let is_touched = answered.iter().any(Answered::is_touched);
        if answered.iter().all(|part| part.ruling.is_empty()) {
            let marked = self.marked(template, question, &answered)?;
            return Ok((marked, is_touched));
        }
        let plain: Vec<Answered<'_>> = answered.iter().map(Answered::plain).collect();
        let before = self.marked(template, question, &plain)?;
        let key = (question.item.clone(), question.revision);
        let now = self.corrected.get(&key).unwrap_or(template);
        let mut marked = self.marked(now, question, &answered)?;
        rescale(&mut marked, &answered);
        let voided = |wanted: &dyn Fn(Void) -> bool| {
            let parts = answered.iter();
            let parts = parts.filter(|part| part.ruling.void.is_some_and(|(_, own)| wanted(own)));
            let numbers = parts.flat_map(|part| part.ruling.numbers.iter().copied());
            numbers.collect::<BTreeSet<usize>>()
        };
        let shared = voided(&|own| own == Void::Rescaled);
        let void = voided(&|_| true);
        let all = marked.iter().flat_map(|part| &part.outcome.decisions);
        let carried: BTreeSet<usize> = all.copied().filter(|own| !void.contains(own)).collect();
        for (part, before) in marked.iter_mut().zip(&before) {
            let outcome = &mut part.outcome;
            let before = Standing::of(&before.outcome);
            if before == Standing::of(outcome) {
                outcome.decisions.clear();
                continue;
            }
            outcome.before = Some(before);
            // What no decision is about follows from one about another part: the points of one that is void, or a value
            // that was carried on.
            if outcome.decisions.is_empty() {
                let is_scaled = before.max != outcome.max;
                let from = if is_scaled { &shared } else { &carried };
                outcome.decisions = from.iter().copied().collect();
            }
        }
        Ok((marked, is_touched))
    }

    fn marked(
        &self,
        template: &Template,
        question: &QuestionEntry,
        answered: &[Answered<'_>],
    ) -> Result<Vec<MarkedPart>, Failure> {
        let solution = solution_of(template, question, self.decimal, self.doubt)?;
        let responses = answered.iter().map(|part| {
            let response = if part.is_by_hand { "" } else { part.response() };
            (part.place, response)
        });
        let asked: Vec<usize> = answered.iter().map(|part| part.place).collect();
        let sheet = Sheet {
            asked: &asked,
            other_form: self.other_form,
        };
        let mut grade = Grade::mark_on(&solution, &sheet, responses);
        let parts = answered.iter().map(|part| {
            let marking = grade.take(part.place).expect("its response was marked");
            MarkedPart::of(self, &solution, question.number, part, marking)
        });
        Ok(parts.collect())
    }

    /// What a question came to: not below zero, unless that is asked for.
    fn standing(&self, parts: &[MarkedPart]) -> Standing {
        let parts = parts.iter().map(|part| Standing::of(&part.outcome));
        let parts: Vec<Standing> = parts.collect();
        let all = |value: fn(&Standing) -> Rational| sum(parts.iter().map(value));
        let least = all(|part| part.points.0);
        let most = sum([least, all(|part| part.open.0)].into_iter());
        let floor = |points: Rational| {
            if self.marks.below_zero {
                points
            } else {
                points.max(Rational::ZERO)
            }
        };
        let (least, most) = (floor(least), floor(most));
        Standing {
            points: Fraction(least),
            open: Fraction(most.checked_sub(least).unwrap_or(Rational::ZERO)),
            max: Fraction(all(|part| part.max.0)),
        }
    }
}

/// Takes away the points of parts that do not count, and gives those that are to be shared to the other parts.
fn rescale(marked: &mut [MarkedPart], answered: &[Answered<'_>]) {
    let of = |wanted: Void| {
        let parts = answered
            .iter()
            .filter(|part| part.ruling.void.map(|(_, void)| void) == Some(wanted));
        sum(parts.map(|part| part.max))
    };
    let shared = of(Void::Rescaled);
    let kept = sum(answered.iter().map(|part| part.max))
        .checked_sub(of(Void::LeftOut))
        .and_then(|kept| Some((kept, kept.checked_sub(shared)?)));
    let factor = kept.and_then(|(kept, rest)| kept.checked_div(rest));
    let factor = factor.unwrap_or(Rational::ONE);
    for (part, answered) in marked.iter_mut().zip(answered) {
        match answered.ruling.void.map(|(_, void)| void) {
            Some(Void::Rescaled | Void::LeftOut) => part.scale(Rational::ZERO),
            _ if !shared.is_zero() => part.scale(factor),
            _ => {}
        }
    }
}
