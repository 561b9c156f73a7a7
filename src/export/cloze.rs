//! Blanks of a cloze question: `{2:NUMERICAL:=20:0.2~%0%3.18:0.03#a cycle is not an angle}`.
//!
//! Notation: <https://docs.moodle.org/en/Embedded_Answers_(Cloze)_question_type>. The first alternative that fits
//! counts, so that they stand in the order of the grader. A typed unit is ignored by the platform: `20 Hz` is right
//! where 20 rad/s is asked.

use crate::answer::{Band, Credit};

/// One alternative of a blank.
pub(crate) struct Alternative {
    /// What is typed or chosen, as it is written in the notation.
    answer: String,
    credit: Credit,
    /// As HTML; may be empty.
    feedback: String,
}

impl Alternative {
    /// A range of numbers.
    pub(crate) fn range(band: &Band, feedback: String) -> Self {
        let [value, half] = [band.value, band.half].map(number);
        Self {
            answer: if band.half > 0.0 {
                format!("{value}:{half}")
            } else {
                format!("{value}:0")
            },
            credit: band.credit,
            feedback,
        }
    }

    /// An option, as HTML.
    pub(crate) fn option(text: &str, is_right: bool) -> Self {
        Self {
            answer: escaped(text),
            credit: if is_right { Credit::FULL } else { Credit::NONE },
            feedback: String::new(),
        }
    }
}

/// A blank for a number.
pub(crate) fn numerical(weight: u64, alternatives: &[Alternative]) -> String {
    blank(weight, "NUMERICAL", alternatives)
}

/// One of several options, as radio buttons below each other.
pub(crate) fn choice(weight: u64, alternatives: &[Alternative]) -> String {
    blank(weight, "MULTICHOICE_V", alternatives)
}

fn blank(weight: u64, kind: &str, alternatives: &[Alternative]) -> String {
    let written: Vec<String> = alternatives.iter().map(Alternative::write).collect();
    format!("{{{weight}:{kind}:{}}}", written.join("~"))
}

impl Alternative {
    fn write(&self) -> String {
        let share = if self.credit == Credit::FULL {
            "=".to_owned()
        } else {
            format!("%{}%", percent(self.credit))
        };
        let feedback = if self.feedback.is_empty() {
            String::new()
        } else {
            format!("#{}", escaped(&self.feedback))
        };
        format!("{share}{}{feedback}", self.answer)
    }
}

/// Whole percents are all that the notation has.
pub(crate) fn percent(credit: Credit) -> f64 {
    (100.0 * credit.share().to_f64()).round()
}

/// A number as the platform reads it: the shortest digits that give it back, with a power of ten where it is very
/// large or small.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-4..1e15).contains(&size) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// HTML within a blank: what means something there is written as an entity, line breaks as spaces. The reader of the
/// notation decodes entities once, so that those of the words are written twice over.
fn escaped(html: &str) -> String {
    // After its entities the platform takes `\}` for a brace, so that TeX would lose it.
    let html = html.trim();
    let html = html.replace("\\}", "\\rbrace ").replace("\\{", "\\lbrace ");
    let html = super::moodle::spaced(&html).replace('&', "&amp;");
    let mut out = String::with_capacity(html.len());
    for sign in html.chars() {
        match sign {
            '~' | '#' | '\\' | '}' | '{' | '/' | '"' => {
                out.push_str(&format!("&#{};", u32::from(sign)));
            }
            '\n' | '\r' => out.push(' '),
            _ => out.push(sign),
        }
    }
    out
}
