//! What a student reads about a sheet, and what a teacher reads about all sheets, as pages.

use std::borrow::Cow;

use serde::Serialize;

use super::layouts::OutputError;
use super::pages::{Pages, Run};
use super::words::filled;
use crate::answer::Verdict;
use crate::grade::{Comment, Feedback, PartFeedback, QuestionFeedback};
use crate::numerics::Rational;
use crate::scene::Shown;

#[derive(Serialize)]
struct FeedbackPage<'a> {
    run: &'a Run,
    sheet: SheetView,
}

#[derive(Serialize)]
struct SheetView {
    code: String,
    name: String,
    student: String,
    type_size: Option<u8>,
    total: String,
    questions: Vec<FeedbackQuestionView>,
}

#[derive(Serialize)]
struct FeedbackQuestionView {
    number: usize,
    title: String,
    points: String,
    parts: Vec<FeedbackPartView>,
}

#[derive(Serialize)]
struct FeedbackPartView {
    letter: String,
    /// Name of the verdict, for the style.
    verdict: &'static str,
    /// The verdict in words.
    words: &'static str,
    points: String,
    response: String,
    reading: String,
    remarks: Vec<String>,
}

impl Pages {
    /// The page of a student's feedback.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn feedback(&self, feedback: &Feedback) -> Result<String, OutputError> {
        let sheet = SheetView {
            code: feedback.code.clone(),
            name: self.placed(self.run.name(&feedback.name, &feedback.student)),
            student: self.placed(self.run.plain_name(&feedback.student)),
            type_size: feedback.type_size,
            total: self.total(feedback),
            questions: feedback
                .questions
                .iter()
                .map(|question| self.answered(question))
                .collect(),
        };
        let run = &self.run;
        self.layouts.fill("feedback", &FeedbackPage { run, sheet })
    }

    fn answered(&self, question: &QuestionFeedback) -> FeedbackQuestionView {
        FeedbackQuestionView {
            number: question.number,
            title: self.placed(&question.title),
            points: self.reached(question.points, question.open, question.max),
            parts: question
                .parts
                .iter()
                .map(|part| self.marked(part))
                .collect(),
        }
    }

    fn marked(&self, part: &PartFeedback) -> FeedbackPartView {
        let remark = |remark: &Comment| {
            let shown = Shown {
                document: Cow::Borrowed(&remark.document),
                fillings: remark.fillings.clone(),
            };
            self.writer.texts(&[shown], self.run.voice())
        };
        FeedbackPartView {
            letter: part.letter.clone(),
            verdict: part.verdict.name(),
            words: match part.verdict {
                Verdict::Unreadable => self.run.spoken().undecided(),
                verdict => self.run.spoken().heading(verdict),
            },
            points: match part.verdict {
                Verdict::Unreadable => self.run.words.reached("?", &self.points(part.max)),
                _ => self.reached(part.points, Rational::ZERO, part.max),
            },
            response: self.placed(&part.response),
            reading: part.reading.as_ref().map_or_else(String::new, |reading| {
                self.writer.math(reading, self.run.voice())
            }),
            remarks: part.remarks.iter().map(remark).collect(),
        }
    }

    /// What the sheet came to, with its grade.
    fn total(&self, feedback: &Feedback) -> String {
        let reached = self.reached(feedback.points, feedback.open, feedback.max);
        match &feedback.grade {
            Some(grade) => {
                let grade = self.placed(grade);
                let values = [("reached", reached.as_str()), ("grade", grade.as_str())];
                filled(&self.run.words.graded, &values)
            }
            None => reached,
        }
    }

    /// `2.5 of 4 points`, or `2.5 + ?1 of 4 points` where one of them is not decided yet.
    fn reached(&self, points: Rational, open: Rational, max: Rational) -> String {
        let reached = self.run.marked(&crate::grade::standing(points, open));
        self.run.words.reached(&reached, &self.points(max))
    }
}
