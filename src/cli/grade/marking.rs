//! Marking one sheet.

use vibank::answer::{Credit, Criterion, Doubt, Verdict};
use vibank::bank::Template;
use vibank::grade::{
    self, Comment, Feedback, Grade, PartFeedback, Place, QuestionFeedback, Responses, Sheet,
};
use vibank::message::{ByHand, Language};
use vibank::numerics::Rational;
use vibank::solution::Solution;
use vibank::worksheet::{PartEntry, QuestionEntry, VariantEntry};

use super::hand;
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
    /// In which students are spoken to.
    pub(super) language: Language,
    pub(super) doubt: Doubt,
    pub(super) other_form: Option<Credit>,
    pub(super) responses: &'a Responses,
    pub(super) overrides: &'a Overrides,
    /// Whether responses to work on paper are the points that a person gave: in the report of a platform they are what
    /// students wrote.
    pub(super) takes_points: bool,
}

/// A part as it was handed out and answered.
struct Answered<'a> {
    entry: &'a PartEntry,
    /// Its place in the item.
    place: usize,
    max: Rational,
    is_by_hand: bool,
    given: &'a str,
    /// Whether `given` is what the file holds, which does not say what was answered.
    is_open: bool,
    decision: Option<&'a Override>,
    /// The line of the file that says it.
    line: Option<usize>,
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
        let responses = answered.iter().map(|part| {
            let response = if part.is_by_hand { "" } else { part.response() };
            (part.place, response)
        });
        let asked: Vec<usize> = answered.iter().map(|part| part.place).collect();
        let sheet = Sheet {
            asked: &asked,
            other_form: self.other_form,
        };
        let grade = Grade::mark_on(&solution, &sheet, responses);
        let (mut outcomes, mut parts) = (Vec::new(), Vec::new());
        for part in &answered {
            let (outcome, feedback) = self.marked(&solution, question.number, part, &grade);
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

    /// What a person gave for work on paper.
    fn given(&self, number: usize, part: &Answered<'_>, criteria: &[Criterion]) -> Given {
        let sheet = hand::Sheet::of(criteria, part.max, self.decimal);
        let unmarked = self.language.by_hand(&ByHand::Open);
        let open = |why: String| Given {
            points: None,
            remarks: vec![Comment::sentence(&unmarked)],
            why: Some(why),
        };
        let is_decided = part
            .decision
            .is_some_and(|decision| decision.response.is_some());
        let text = if self.takes_points || is_decided {
            part.response()
        } else {
            ""
        };
        match sheet.read(text) {
            Ok(Some(hand)) => Given {
                points: Some(hand.points),
                remarks: sheet.told(&hand, self.language),
                why: None,
            },
            Ok(None) => open("This part has not been marked yet.".to_owned()),
            Err(why) => {
                let row = part
                    .line
                    .map_or_else(String::new, |line| format!("row {line}, "));
                open(format!("{row}part {number}{}: {why}", part.entry.letter))
            }
        }
    }

    /// What came out for a part, and what its student is told.
    fn marked(
        &self,
        solution: &Solution<'_>,
        number: usize,
        part: &Answered<'_>,
        grade: &Grade,
    ) -> (PartOutcome, PartFeedback) {
        let marking = grade.part(part.place).expect("its response was marked");
        let mut remarks = grade::remarks(solution, part.place, marking, self.language);
        let mut reasons: Vec<String> = marking
            .reasons()
            .iter()
            .map(|reason| reason.code())
            .collect();
        let (mut verdict, mut credit) = (marking.verdict, marking.credit.share());
        let mut points = grade::of_marking(marking, part.max);
        let criteria = solution.template().parts[part.place].answer.rubric();
        let by_hand = part.is_by_hand;
        let mut why = None;
        if by_hand {
            let given = self.given(number, part, criteria);
            remarks = given.remarks;
            why = given.why;
            reasons = vec![
                if given.points.is_some() {
                    "by-hand"
                } else {
                    "open"
                }
                .to_owned(),
            ];
            points = given.points.unwrap_or(Rational::ZERO);
            (verdict, credit) = match given.points {
                Some(points) => worth(points, part.max),
                None => (Verdict::Unreadable, Rational::ZERO),
            };
        }
        if part.is_undecided() {
            verdict = Verdict::Unreadable;
            reasons = vec!["unreadable".to_owned()];
            let unclear = self.language.by_hand(&ByHand::Unclear);
            remarks = vec![Comment::sentence(&unclear)];
        }
        if let Some(decision) = part.decision {
            reasons.insert(0, "override".to_owned());
            if let Some(settled) = decision.points {
                points = settled;
                (verdict, credit) = worth(settled, part.max);
                remarks.clear();
            }
            remarks.splice(0..0, said(decision, self.language));
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
            feedback: why.unwrap_or_else(|| {
                let plain: Vec<String> = remarks.iter().map(Comment::plain).collect();
                plain.join(" ")
            }),
            by_hand,
            other,
        };
        let feedback = PartFeedback {
            letter: part.entry.letter.clone(),
            verdict,
            points,
            max: part.max,
            // Points are no answer of the student.
            response: if by_hand && self.takes_points {
                String::new()
            } else {
                part.given.to_owned()
            },
            reading: marking.reading.as_ref().map(|reading| reading.math.clone()),
            // The page says the verdict itself.
            remarks: if marking.remarks.is_empty()
                && part.decision.is_none()
                && !by_hand
                && !part.is_undecided()
            {
                Vec::new()
            } else {
                remarks
            },
        };
        (outcome, feedback)
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
                is_by_hand: template.parts[place].answer.kind().is_by_hand(),
                given,
                is_open: open.is_some(),
                decision: self.overrides.find(&at, &alike),
                line: self.responses.line(&at),
            }
        });
        Ok(answered.collect())
    }
}

/// What a person gave for a part: the points, if it is marked, and what the student is told.
struct Given {
    points: Option<Rational>,
    remarks: Vec<Comment>,
    /// Why it is open, for the teacher.
    why: Option<String>,
}

/// What points out of so many amount to.
fn worth(points: Rational, max: Rational) -> (Verdict, Rational) {
    let credit = points.checked_div(max).unwrap_or(Rational::ZERO);
    let verdict = Credit::new(credit).map_or(Verdict::Right, Credit::verdict);
    (verdict, credit)
}

/// Points as the manifest states them: decimals, as they were handed out.
fn exact(points: f64) -> Rational {
    Rational::from_decimal(&points.to_string()).unwrap_or(Rational::ZERO)
}

/// What a student is told of a teacher's decision.
fn said(decision: &Override, language: Language) -> Vec<Comment> {
    let mut said = Vec::new();
    if let Some(response) = &decision.response {
        said.push(Comment::sentence(&language.by_hand(&ByHand::ReadAs)));
        said.push(Comment::code(response));
    }
    match &decision.feedback {
        Some(words) => said.push(Comment::words(words)),
        None if decision.points.is_some() => {
            said.push(Comment::sentence(&language.by_hand(&ByHand::Marked)));
        }
        None => {}
    }
    said
}
