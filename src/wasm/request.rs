//! What a page asks, and the replies.

use std::rc::Rc;

use serde::Deserialize;
use serde_json::{Map, Value as Json, json};

use super::Grader;
use super::question::{asked, figure, html, options, shape};
use crate::bank::{Passage, Template};
use crate::grade::{self, Grade};
use crate::math::Display;
use crate::seed::Variant;
use crate::solution::Solution;
use crate::worksheet::letter;

/// One request.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum Request {
    /// A variant that is fit to be asked.
    Choose { question: usize, from: u64 },
    /// The statement and what is asked.
    Show { question: usize, code: String },
    /// How a response is read.
    Read {
        question: usize,
        code: String,
        part: String,
        response: String,
    },
    /// The marks of a response.
    Mark {
        question: usize,
        code: String,
        part: String,
        response: String,
        #[serde(default)]
        earlier: Map<String, Json>,
    },
    /// One hint.
    Hint {
        question: usize,
        code: String,
        part: String,
        number: usize,
    },
    /// The key and the worked solution of a part.
    Solve {
        question: usize,
        code: String,
        part: String,
    },
}

/// An instance of a question that is being asked about.
struct Asked<'g> {
    grader: &'g Grader,
    solution: Rc<Solution<'static>>,
    /// The parts that are asked, as places in the item.
    parts: Vec<usize>,
}

impl Grader {
    pub(super) fn reply(&self, request: &Request) -> Result<Json, String> {
        match request {
            Request::Choose { question, from } => {
                let variant = self.choose(*question, *from)?;
                Ok(json!({ "code": variant.to_string() }))
            }
            Request::Show { question, code } => Ok(self.asked(*question, code)?.show()),
            Request::Read {
                question,
                code,
                part,
                response,
            } => self.asked(*question, code)?.read(part, response),
            Request::Mark {
                question,
                code,
                part,
                response,
                earlier,
            } => self.asked(*question, code)?.mark(part, response, earlier),
            Request::Hint {
                question,
                code,
                part,
                number,
            } => self.asked(*question, code)?.hint(part, *number),
            Request::Solve {
                question,
                code,
                part,
            } => self.asked(*question, code)?.solve(part),
        }
    }

    fn asked(&self, number: usize, code: &str) -> Result<Asked<'_>, String> {
        let variant: Variant = code.parse().map_err(|error| format!("`{code}`: {error}"))?;
        let solution = self.solution(number, variant)?;
        let parts = asked(self.question(number)?.0, &solution);
        Ok(Asked {
            grader: self,
            solution,
            parts,
        })
    }
}

impl Asked<'_> {
    fn template(&self) -> &'static Template {
        self.solution.template()
    }

    /// The place of a part in the item.
    fn place(&self, id: &str) -> Result<usize, String> {
        let parts = &self.template().parts;
        let place = self.parts.iter().find(|place| parts[**place].id == id);
        place
            .copied()
            .ok_or_else(|| format!("`{id}` is not asked here"))
    }

    fn texts(&self, passage: &'static Passage) -> String {
        html(&self.grader.scene(&self.solution).passage(passage))
    }

    fn show(&self) -> Json {
        let template = self.template();
        let parts = self.parts.iter().enumerate();
        let parts: Vec<Json> = parts.map(|(at, place)| self.part(at, *place)).collect();
        json!({
            "identity": self.solution.instance().identity(),
            "statement": self.texts(&template.statement) + &self.figure(),
            "parts": parts,
        })
    }

    /// The figure after the statement, where the statement does not place it itself.
    fn figure(&self) -> String {
        let template = self.template();
        if template.statement.places_figure() {
            return String::new();
        }
        let picture = self.grader.scene(&self.solution).picture();
        picture.map_or_else(String::new, |picture| figure(&picture, &template.caption))
    }

    fn part(&self, at: usize, place: usize) -> Json {
        let part = &self.template().parts[place];
        let scene = self.grader.scene(&self.solution);
        let unit = part.answer.unit().filter(|unit| !unit.is_one());
        let (rows, columns) = shape(part, self.template()).unzip();
        json!({
            "id": part.id,
            "letter": letter(at),
            "kind": part.answer.kind().name(),
            "ask": self.texts(&part.ask),
            "lead": scene.lead(place).map(|math| math.mathml(Display::Inline)),
            "unit": unit.map(|unit| unit.math().mathml(Display::Inline)),
            "hints": part.hints.len(),
            "choosing": part.answer.choosing().map(|choosing| choosing.name()),
            "options": options(&self.solution, place),
            "rows": rows,
            "columns": columns,
        })
    }

    fn read(&self, id: &str, response: &str) -> Result<Json, String> {
        let marking = grade::mark(&self.solution, self.place(id)?, response);
        Ok(match marking.reading {
            Some(reading) => json!({ "reading": reading.math.mathml(Display::Inline) }),
            None => json!({ "problem": self.feedback(self.place(id)?, &marking) }),
        })
    }

    fn mark(&self, id: &str, response: &str, earlier: &Map<String, Json>) -> Result<Json, String> {
        let place = self.place(id)?;
        let mut responses = vec![(place, response)];
        for (part, response) in earlier {
            if let (Ok(before), Some(response)) = (self.place(part), response.as_str())
                && before < place
            {
                responses.push((before, response));
            }
        }
        let grade = Grade::mark(&self.solution, responses);
        let marking = grade.part(place).ok_or("the part was not marked")?;
        let reasons: Vec<String> = marking
            .reasons()
            .iter()
            .map(|reason| reason.code())
            .collect();
        let reading = marking.reading.as_ref();
        Ok(json!({
            "verdict": marking.verdict,
            "credit": marking.credit,
            "reading": reading.map(|reading| reading.math.mathml(Display::Inline)),
            "si": reading.map(|reading| reading.answered.si()),
            "reasons": reasons,
            "feedback": self.feedback(place, marking),
        }))
    }

    fn feedback(&self, place: usize, marking: &crate::answer::Marking) -> String {
        let remarks = grade::remarks(&self.solution, place, marking);
        let html = |remark: &grade::Comment| remark.document.html(&remark.fillings);
        remarks.iter().map(html).collect()
    }

    fn hint(&self, id: &str, number: usize) -> Result<Json, String> {
        let part = &self.template().parts[self.place(id)?];
        let hint = part.hints.get(number);
        let hint = hint.ok_or_else(|| format!("`{id}` has no hint {number}"))?;
        Ok(json!({ "html": self.texts(hint) }))
    }

    fn solve(&self, id: &str) -> Result<Json, String> {
        let place = self.place(id)?;
        let key = self.solution.marker(place).map(|marker| marker.key());
        let key = key.map_err(|absent| absent.to_string())?;
        let part = &self.template().parts[place];
        let right = match &key.value {
            crate::answer::KeyValue::Options { ids, .. } => ids.clone(),
            _ => Vec::new(),
        };
        // What comes before the solutions of the parts stands with the first of them.
        let before = if self.parts.first() == Some(&place) {
            self.texts(&self.template().solution)
        } else {
            String::new()
        };
        Ok(json!({
            "key": key.math.mathml(Display::Inline),
            "right": right,
            "html": before + &self.texts(&part.solution),
        }))
    }
}
