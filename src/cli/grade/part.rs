//! Marking one part of a sheet, by its answer and by what was decided about it.

use vibank::answer::{AnswerKind, Credit, Criterion, Marking, Verdict};
use vibank::grade::{self, Comment, PartFeedback, rounded};
use vibank::message::{ByHand, Language};
use vibank::numerics::Rational;
use vibank::solution::Solution;
use vibank::worksheet::Void;

use super::answered::Answered;
use super::decisions::{Accepted, Decision};
use super::hand::PartRubric;
use super::marking::Marker;
use super::outcome::{Fraction, PartOutcome};

/// What came out for a part, and what is reported to its student.
pub(crate) struct MarkedPart {
    pub(crate) outcome: PartOutcome,
    pub(crate) feedback: PartFeedback,
}

/// What a part is worth so far, and what is said about it.
struct PartStanding {
    verdict: Verdict,
    credit: Rational,
    points: Rational,
    reasons: Vec<String>,
    remarks: Vec<Comment>,
    /// Why it is open, for the teacher.
    why: Option<String>,
    /// The numbers of the decisions that were carried out.
    carried_out: Vec<usize>,
}

/// What a person gave for a part: the points, if it is marked, and what is reported to the student.
struct AwardedPoints {
    points: Option<Rational>,
    remarks: Vec<Comment>,
    /// Why it is open, for the teacher.
    why: Option<String>,
}

impl MarkedPart {
    /// What came out for a part, and what is reported to its student.
    pub(crate) fn of(
        marker: &Marker<'_>,
        solution: &Solution<'_>,
        number: usize,
        part: &Answered<'_>,
        marking: Marking,
    ) -> Self {
        let answer = &solution.template().parts[part.place].answer;
        let mut standing = if part.is_by_hand {
            PartStanding::by_hand(marker, number, part, answer.rubric())
        } else {
            PartStanding {
                verdict: marking.verdict,
                credit: marking.credit.share(),
                points: grade::of_marking(&marking, part.max),
                reasons: marking
                    .reasons()
                    .iter()
                    .map(|reason| reason.code())
                    .collect(),
                remarks: grade::remarks(solution, part.place, &marking, marker.language),
                why: None,
                carried_out: part.ruling.numbers.clone(),
            }
        };
        if part.is_undecided() {
            standing.leave_open(marker.language);
        }
        standing.accept(solution, part, marker.language);
        if answer.kind() == AnswerKind::Choice {
            standing.charge(marker, part.max);
        }
        standing.settle(part, marker.language);
        standing.void(part, marker.language);
        // A key that was corrected has its remarks as any.
        let is_decided = part.ruling.settled.is_some()
            || part.ruling.void.is_some()
            || standing.carried_out.len() > part.ruling.numbers.len();
        // The page says the verdict itmarker.
        let is_plain = marking.remarks.is_empty()
            && !is_decided
            && !part.is_by_hand
            && !part.is_undecided()
            && standing.points >= Rational::ZERO;
        let other = matches!(standing.verdict, Verdict::Wrong)
            .then(|| grade::pattern(solution, part.place, &marking))
            .flatten();
        let outcome = standing.outcome(solution, number, part, &marking, other);
        let feedback = PartFeedback {
            letter: part.entry.letter.clone(),
            verdict: standing.verdict,
            points: standing.points,
            max: part.max,
            // Points are no answer of the student.
            response: if part.is_by_hand && marker.takes_points {
                String::new()
            } else {
                part.given.to_owned()
            },
            reading: marking.reading.map(|reading| reading.math),
            remarks: if is_plain {
                Vec::new()
            } else {
                standing.remarks
            },
        };
        Self { outcome, feedback }
    }

    /// Changes what the part is worth.
    pub(crate) fn scale(&mut self, factor: Rational) {
        let scaled = |points: Rational| points.checked_mul(factor).unwrap_or(points);
        let (outcome, feedback) = (&mut self.outcome, &mut self.feedback);
        feedback.points = scaled(feedback.points);
        feedback.max = scaled(feedback.max);
        outcome.points = Fraction(feedback.points);
        outcome.max = Fraction(feedback.max);
    }
}

impl AwardedPoints {
    /// What a person gave for work on paper.
    fn given(
        marker: &Marker<'_>,
        number: usize,
        part: &Answered<'_>,
        criteria: &[Criterion],
    ) -> Self {
        let sheet = PartRubric::of(criteria, part.max, marker.decimal);
        let unmarked = marker.language.by_hand(&ByHand::Open);
        let open = |why: String| Self {
            points: None,
            remarks: vec![Comment::sentence(&unmarked)],
            why: Some(why),
        };
        let text = if marker.takes_points || part.is_read() {
            part.response()
        } else {
            ""
        };
        match sheet.read(text) {
            Ok(Some(hand)) => Self {
                points: Some(hand.points),
                remarks: sheet.comments(&hand, marker.language),
                why: None,
            },
            Ok(None) => open(unmarked.clone()),
            Err(why) => {
                let row = part
                    .line
                    .map_or_else(String::new, |line| format!("row {line}, "));
                open(format!("{row}part {number}{}: {why}", part.entry.letter))
            }
        }
    }
}

impl PartStanding {
    /// What a person has marked.
    fn by_hand(
        marker: &Marker<'_>,
        number: usize,
        part: &Answered<'_>,
        criteria: &[Criterion],
    ) -> Self {
        let given = AwardedPoints::given(marker, number, part, criteria);
        let reason = if given.points.is_some() {
            "by-hand"
        } else {
            "open"
        };
        let (verdict, credit) = match given.points {
            Some(points) => worth(points, part.max),
            None => (Verdict::Unreadable, Rational::ZERO),
        };
        Self {
            verdict,
            credit,
            points: given.points.unwrap_or(Rational::ZERO),
            reasons: vec![reason.to_owned()],
            remarks: given.remarks,
            why: given.why,
            carried_out: part.ruling.numbers.clone(),
        }
    }

    /// Takes off what a wrong choice costs; where nothing is decided yet, it may still turn out to be wrong.
    fn charge(&mut self, marker: &Marker<'_>, max: Rational) {
        let penalty = marker.marks.penalty(max);
        if penalty.is_zero() {
            return;
        }
        match self.verdict {
            Verdict::Unreadable => self.points = -penalty,
            Verdict::Wrong => {
                self.points = -penalty;
                self.credit = self.points.checked_div(max).unwrap_or(Rational::ZERO);
                self.reasons.push("negative".to_owned());
                let points = rounded(penalty).replace('.', &marker.decimal.to_string());
                let is_one = marker.language.is_singular(penalty.to_f64());
                let words = marker.language.by_hand(&ByHand::Charged { points, is_one });
                self.remarks.push(Comment::sentence(&words));
            }
            _ => {}
        }
    }

    fn leave_open(&mut self, language: Language) {
        self.verdict = Verdict::Unreadable;
        self.reasons = vec!["unreadable".to_owned()];
        self.remarks = vec![Comment::sentence(&language.by_hand(&ByHand::Unclear))];
    }

    /// Gives what was decided for an answer that is accepted beside the key.
    fn accept(&mut self, solution: &Solution<'_>, part: &Answered<'_>, language: Language) {
        let response = part.response();
        if response.is_empty() || part.is_undecided() {
            return;
        }
        for Accepted {
            number,
            decision,
            texts,
            credit,
        } in &part.ruling.accepted
        {
            let is_accepted = |text: &String| is_same(solution, part.place, response, text);
            if credit.share() <= self.credit || !texts.iter().any(is_accepted) {
                continue;
            }
            self.credit = credit.share();
            self.verdict = credit.verdict();
            self.points = credit.share().checked_mul(part.max).unwrap_or(part.max);
            self.carried_out.push(*number);
            self.reasons.insert(0, "accepted".to_owned());
            self.why = None;
            self.remarks = vec![match &decision.feedback {
                Some(words) => Comment::words(words),
                None if *credit == Credit::FULL => {
                    Comment::sentence(&language.by_hand(&ByHand::Accepted))
                }
                None => Comment::sentence(&language.by_hand(&ByHand::Shared)),
            }];
        }
    }

    /// What was decided about this mark alone.
    fn settle(&mut self, part: &Answered<'_>, language: Language) {
        let Some(decision) = part.ruling.settled else {
            return;
        };
        self.reasons.insert(0, "override".to_owned());
        if let Some(points) = decision.points() {
            self.points = points;
            (self.verdict, self.credit) = worth(points, part.max);
            self.remarks.clear();
        }
        self.remarks.splice(0..0, said(decision, language));
    }

    /// A part that does not count as it was answered.
    fn void(&mut self, part: &Answered<'_>, language: Language) {
        let Some((decision, void)) = part.ruling.void else {
            return;
        };
        self.reasons.insert(0, "void".to_owned());
        self.why = None;
        let words = match void {
            Void::FullMarks => {
                self.points = part.max;
                (self.verdict, self.credit) = (Verdict::Right, Rational::ONE);
                ByHand::FullMarks
            }
            Void::Rescaled => ByHand::Rescaled,
            Void::LeftOut => ByHand::LeftOut,
        };
        if self.verdict == Verdict::Unreadable {
            // There is nothing left to be decided.
            self.verdict = Verdict::Missing;
            self.points = Rational::ZERO;
        }
        self.remarks = vec![match &decision.feedback {
            Some(words) => Comment::words(words),
            None => Comment::sentence(&language.by_hand(&words)),
        }];
    }

    /// Takes what tables show; the remarks stay.
    fn outcome(
        &mut self,
        solution: &Solution<'_>,
        number: usize,
        part: &Answered<'_>,
        marking: &Marking,
        other: Option<String>,
    ) -> PartOutcome {
        let plain: Vec<String> = self.remarks.iter().map(Comment::plain).collect();
        PartOutcome {
            question: number,
            letter: part.entry.letter.clone(),
            item: solution.template().id.to_string(),
            id: part.entry.id.clone(),
            response: part.given.to_owned(),
            reading: marking
                .reading
                .as_ref()
                .map_or_else(String::new, |reading| reading.math.latex()),
            verdict: self.verdict,
            credit: Fraction(self.credit),
            points: Fraction(self.points),
            max: Fraction(part.max),
            reasons: std::mem::take(&mut self.reasons),
            feedback: self.why.take().unwrap_or_else(|| plain.join(" ")),
            by_hand: part.is_by_hand,
            other,
            before: None,
            decisions: std::mem::take(&mut self.carried_out),
        }
    }
}

/// Whether an answer is one that is accepted: as it is typed, blanks aside, or as it is read.
fn is_same(solution: &Solution<'_>, place: usize, response: &str, accepted: &str) -> bool {
    /// How far numbers of the same reading are apart that were typed in different units.
    const ROUNDING: f64 = 1e-9;
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    if words(response) == words(accepted) {
        return true;
    }
    let read = |text: &str| Some(grade::echo(solution, place, text).ok()?.reading);
    let Some((own, other)) = read(response).zip(read(accepted)) else {
        return false;
    };
    let numbers = (own.answered.si(), other.answered.si());
    if numbers.0.is_empty() || numbers.0.len() != numbers.1.len() {
        return own.text == other.text;
    }
    let mut pairs = numbers.0.iter().zip(&numbers.1);
    pairs.all(|(own, other)| (own - other).abs() <= ROUNDING * other.abs())
}

/// What points out of this many amount to.
fn worth(points: Rational, max: Rational) -> (Verdict, Rational) {
    let credit = points.checked_div(max).unwrap_or(Rational::ZERO);
    let verdict = Credit::new(credit).map_or(Verdict::Right, Credit::verdict);
    (verdict, credit)
}

/// What is reported to a student of a teacher's decision.
fn said(decision: &Decision, language: Language) -> Vec<Comment> {
    let mut said = Vec::new();
    if let Some(response) = decision.response() {
        said.push(Comment::sentence(&language.by_hand(&ByHand::ReadAs)));
        said.push(Comment::code(response));
    }
    match &decision.feedback {
        Some(words) => said.push(Comment::words(words)),
        None if decision.points().is_some() => {
            said.push(Comment::sentence(&language.by_hand(&ByHand::Marked)));
        }
        None => {}
    }
    said
}
