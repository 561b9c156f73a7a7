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

/// The page of a student's feedback.
///
/// # Errors
///
/// [`OutputError::Page`].
pub fn feedback_page(pages: &Pages, feedback: &Feedback) -> Result<String, OutputError> {
    let sheet = SheetView {
        code: feedback.code.clone(),
        name: pages.placed(pages.run.name(&feedback.name, &feedback.student)),
        student: pages.placed(pages.run.plain_name(&feedback.student)),
        type_size: feedback.type_size,
        total: total(pages, feedback),
        questions: feedback
            .questions
            .iter()
            .map(|question| answered(pages, question))
            .collect(),
    };
    let run = &pages.run;
    pages.layouts.fill("feedback", &FeedbackPage { run, sheet })
}

fn answered(pages: &Pages, question: &QuestionFeedback) -> FeedbackQuestionView {
    FeedbackQuestionView {
        number: question.number,
        title: pages.placed(&question.title),
        points: reached(pages, question.points, question.open, question.max),
        parts: question
            .parts
            .iter()
            .map(|part| marked(pages, part))
            .collect(),
    }
}

fn marked(pages: &Pages, part: &PartFeedback) -> FeedbackPartView {
    let remark = |remark: &Comment| {
        let shown = Shown {
            document: Cow::Borrowed(&remark.document),
            fillings: remark.fillings.clone(),
        };
        pages.writer.texts(&[shown], pages.run.voice())
    };
    FeedbackPartView {
        letter: part.letter.clone(),
        verdict: part.verdict.name(),
        words: match part.verdict {
            Verdict::Unreadable => pages.run.spoken().undecided(),
            verdict => pages.run.spoken().heading(verdict),
        },
        points: match part.verdict {
            Verdict::Unreadable => pages.run.words.reached("?", &pages.points(part.max)),
            _ => reached(pages, part.points, Rational::ZERO, part.max),
        },
        response: pages.placed(&part.response),
        reading: part.reading.as_ref().map_or_else(String::new, |reading| {
            pages.writer.math(reading, pages.run.voice())
        }),
        remarks: part.remarks.iter().map(remark).collect(),
    }
}

/// What the sheet came to, with its grade.
fn total(pages: &Pages, feedback: &Feedback) -> String {
    let reached = reached(pages, feedback.points, feedback.open, feedback.max);
    match &feedback.grade {
        Some(grade) => {
            let grade = pages.placed(grade);
            let values = [("reached", reached.as_str()), ("grade", grade.as_str())];
            filled(&pages.run.words.graded, &values)
        }
        None => reached,
    }
}

/// `2.5 of 4 points`, or `2.5 + ?1 of 4 points` where one of them is not decided yet.
fn reached(pages: &Pages, points: Rational, open: Rational, max: Rational) -> String {
    let reached = pages.run.marked(&crate::grade::standing(points, open));
    pages.run.words.reached(&reached, &pages.points(max))
}
