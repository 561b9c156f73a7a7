//! What a student is told about a sheet, and what a teacher is told about all sheets, as pages.

use serde::Serialize;

use super::layouts::OutputError;
use super::pages::{Pages, Run};
use crate::grade::{Comment, Feedback, PartFeedback, QuestionFeedback};
use crate::message::Language;
use crate::numerics::Rational;
use crate::scene::Shown;

#[derive(Serialize)]
struct Page<'a> {
    run: &'a Run,
    sheet: SheetView,
}

#[derive(Serialize)]
struct SheetView {
    code: String,
    name: String,
    student: String,
    total: String,
    questions: Vec<QuestionView>,
}

#[derive(Serialize)]
struct QuestionView {
    number: usize,
    title: String,
    points: String,
    parts: Vec<PartView>,
}

#[derive(Serialize)]
struct PartView {
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
            name: self.placed(&feedback.name),
            student: self.placed(&feedback.student),
            total: self.reached(feedback.points, feedback.max),
            questions: feedback
                .questions
                .iter()
                .map(|question| self.answered(question))
                .collect(),
        };
        let run = &self.run;
        self.layouts.fill("feedback", &Page { run, sheet })
    }

    fn answered(&self, question: &QuestionFeedback) -> QuestionView {
        QuestionView {
            number: question.number,
            title: self.placed(&question.title),
            points: self.reached(question.points, question.max),
            parts: question
                .parts
                .iter()
                .map(|part| self.marked(part))
                .collect(),
        }
    }

    fn marked(&self, part: &PartFeedback) -> PartView {
        let remark = |remark: &Comment| {
            self.writer.texts(&[Shown {
                document: &remark.document,
                fillings: remark.fillings.clone(),
            }])
        };
        PartView {
            letter: part.letter.clone(),
            verdict: part.verdict.name(),
            words: Language::default().heading(part.verdict),
            points: self.reached(part.points, part.max),
            response: self.placed(&part.response),
            reading: part
                .reading
                .as_ref()
                .map_or_else(String::new, |reading| self.writer.math(reading)),
            remarks: part.remarks.iter().map(remark).collect(),
        }
    }

    /// `2.5 of 4 points`.
    fn reached(&self, points: Rational, max: Rational) -> String {
        format!("{} of {}", self.run.number(points), self.points(max))
    }
}
