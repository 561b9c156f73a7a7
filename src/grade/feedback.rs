//! What a student is told, as a tree that any format can write.

use serde::Serialize;

use crate::answer::{Marking, Remark, Verdict};
use crate::document::{Block, Document, Filling, Inline};
use crate::math::Math;
use crate::message::Language;
use crate::numerics::Rational;
use crate::scene::{Data, Scene};
use crate::solution::Solution;

/// A text with what fills its holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Comment {
    /// The text.
    pub document: Document,
    /// What fills its holes, in order.
    pub fillings: Vec<Filling>,
}

/// What a student is told about a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Feedback {
    /// Code of the sheet.
    pub code: String,
    /// Name; may be empty.
    pub name: String,
    /// Identity; may be empty.
    pub student: String,
    /// The size of type in points, where it is not the usual one.
    pub type_size: Option<u8>,
    /// Points reached.
    pub points: Rational,
    /// Points that nobody has decided yet.
    pub open: Rational,
    /// Points of the sheet.
    pub max: Rational,
    /// The grade, where there is a scale and it is decided.
    pub grade: Option<String>,
    /// The questions in the order of the sheet.
    pub questions: Vec<QuestionFeedback>,
}

/// What a student is told about a question.
#[derive(Clone, Debug, PartialEq)]
pub struct QuestionFeedback {
    /// The number that is printed before the question.
    pub number: usize,
    /// Title of the item.
    pub title: String,
    /// Points reached.
    pub points: Rational,
    /// Points that nobody has decided yet.
    pub open: Rational,
    /// Points of the question.
    pub max: Rational,
    /// The parts that are asked, in their order.
    pub parts: Vec<PartFeedback>,
}

/// What a student is told about a part.
#[derive(Clone, Debug, PartialEq)]
pub struct PartFeedback {
    /// The letter that is printed before the part; empty where there is one part.
    pub letter: String,
    /// How the answer fared.
    pub verdict: Verdict,
    /// Points reached.
    pub points: Rational,
    /// Points of the part.
    pub max: Rational,
    /// What was handed in, as it is; empty if nothing.
    pub response: String,
    /// How it was read.
    pub reading: Option<Math>,
    /// What is said about it.
    pub remarks: Vec<Comment>,
}

impl Comment {
    /// A sentence of our own; what stands between back-ticks is code.
    pub fn sentence(words: &str) -> Self {
        Self::from(Document::sentence(words))
    }

    /// Some words of others, as they are.
    pub fn words(words: &str) -> Self {
        let content = vec![Inline::Text(words.to_owned())];
        Document::of(vec![Block::Paragraph(content)], Vec::new()).into()
    }

    /// What somebody typed, as it is.
    pub fn code(typed: &str) -> Self {
        let content = vec![Inline::Code(typed.to_owned())];
        Document::of(vec![Block::Paragraph(content)], Vec::new()).into()
    }

    /// As plain text; in a sentence of our own, code stands between back-ticks.
    pub fn plain(&self) -> String {
        let [Block::Paragraph(content)] = self.document.blocks() else {
            return self.document.plain(&self.fillings);
        };
        let pieces = content.iter().map(|inline| match inline {
            Inline::Text(words) => Some(words.clone()),
            Inline::Code(code) => Some(format!("`{code}`")),
            _ => None,
        });
        match pieces.collect::<Option<String>>() {
            Some(words) => words.replace(char::is_control, " "),
            None => self.document.plain(&self.fillings),
        }
    }
}

impl From<Document> for Comment {
    fn from(document: Document) -> Self {
        Self {
            document,
            fillings: Vec::new(),
        }
    }
}

impl Serialize for Comment {
    /// As plain text, for programs.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.plain())
    }
}

/// What is said about a response, with the texts of the item that its marking names: at least one comment.
pub fn remarks(
    solution: &Solution<'_>,
    place: usize,
    marking: &Marking,
    language: Language,
) -> Vec<Comment> {
    let mistakes = &solution.template().parts[place].mistakes;
    let scene = Scene::of(solution, Data::Both).spoken(language);
    let mut comments = Vec::new();
    for remark in &marking.remarks {
        if let Remark::Mistake(number) = remark {
            let shown = mistakes
                .get(*number)
                .map(|mistake| scene.passage(&mistake.feedback));
            comments.extend(shown.into_iter().flatten().map(|shown| Comment {
                document: shown.document.into_owned(),
                fillings: shown.fillings,
            }));
        }
        comments.extend(language.say(remark).map(Comment::from));
    }
    if comments.is_empty() {
        comments.push(language.verdict(marking.verdict).into());
    }
    comments
}
