//! Marking of single responses for other programs: one JSON object in, one out.
//!
//! ```json
//! {"id":"ch2/e8-springs-parallel-series","set":{"k1":"200 N/m"},"part":"k_par","response":"500 N/m"}
//! {"id":"ch4/p3-base-excited-relative","part":"omega_n","response":"1.095 rad/s","earlier":{"k_eq":"k1*k2/(k1 + k2)"}}
//! ```

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value as Json};

use super::{Comment, Grade, remarks};
use crate::answer::{Credit, Doubt, Reason, Verdict};
use crate::bank::Template;
use crate::math::Math;
use crate::message::Language;
use crate::solution::Session;
use crate::solution::request::{Refusal, read};
use crate::unit::DecimalMark;

/// A response to be marked.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkRequest {
    /// The item.
    pub id: String,
    /// Values of parameters.
    #[serde(default)]
    pub set: Map<String, Json>,
    /// Draws what is not set.
    #[serde(default)]
    pub seed: Option<u64>,
    /// The part of the item that is answered, by its id.
    pub part: String,
    /// What was answered.
    pub response: String,
    /// Responses to other parts, by part: earlier ones for follow-through, equations that are asked beside this one.
    #[serde(default)]
    pub earlier: Map<String, Json>,
    /// What becomes of it where it has two readings with different verdicts; if absent whoever answers is asked.
    #[serde(default)]
    pub doubt: Doubt,
    /// The decimal sign of whoever answers; with a comma, `1,250` is no doubt.
    #[serde(default, deserialize_with = "decimal")]
    pub decimal: DecimalMark,
    /// Any value, returned.
    #[serde(default)]
    pub tag: Option<Json>,
}

/// What became of a response, or why there is no mark.
#[derive(Clone, Debug, Serialize)]
pub struct MarkReply {
    /// Either of them.
    #[serde(flatten)]
    pub outcome: MarkOutcome,
    /// The tag of the request.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tag: Option<Json>,
}

/// A mark, or a refusal.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum MarkOutcome {
    /// The mark.
    Marked(Marked),
    /// Why there is none.
    Refused {
        /// Its code and what is wrong.
        error: Refusal,
    },
}

/// The mark of a response.
#[derive(Clone, Debug, Serialize)]
pub struct Marked {
    /// How it fared.
    pub verdict: Verdict,
    /// The share of the points.
    pub credit: Credit,
    /// How it was read; written as LaTeX.
    #[serde(serialize_with = "as_latex")]
    pub reading: Option<Math>,
    /// The same in the formula language.
    pub text: Option<String>,
    /// Its numbers in SI units.
    pub si: Option<Vec<f64>>,
    /// The codes of the reasons, the main one first.
    pub reasons: Vec<String>,
    /// What is said about it.
    pub feedback: Vec<Comment>,
}

/// Typeset mathematics as a text of LaTeX.
#[allow(clippy::ref_option, reason = "the signature that serde asks for")]
fn as_latex<S: Serializer>(math: &Option<Math>, serializer: S) -> Result<S::Ok, S::Error> {
    math.as_ref().map(Math::latex).serialize(serializer)
}

/// Answers one line; the reply has no line break.
pub fn answer(session: &mut Session<'_>, line: &str) -> String {
    match read(line) {
        Ok(request) => {
            let reply = reply(session, request);
            serde_json::to_string(&reply).expect("a reply is plain data")
        }
        Err(refused) => Json::Object(refused).to_string(),
    }
}

/// Answers one request.
pub fn reply(session: &mut Session<'_>, request: MarkRequest) -> MarkReply {
    let outcome = match marked(session, &request) {
        Ok(marked) => MarkOutcome::Marked(marked),
        Err(error) => MarkOutcome::Refused { error },
    };
    MarkReply {
        outcome,
        tag: request.tag,
    }
}

fn marked(session: &mut Session<'_>, request: &MarkRequest) -> Result<Marked, Refusal> {
    let template = session.find(&request.id)?;
    let place = place(template, &request.part)?;
    let mut responses = vec![(place, request.response.as_str())];
    for (part, response) in &request.earlier {
        let response = response.as_str().ok_or_else(|| {
            Refusal::new(
                "json",
                format!("the earlier response to `{part}` is not text"),
            )
        })?;
        let earlier = self::place(template, part)?;
        if earlier == place {
            let message = format!("`{part}` is the part that is marked, not an earlier one");
            return Err(Refusal::new("json", message));
        }
        responses.push((earlier, response));
    }
    let (set, doubt, mark) = (&request.set, request.doubt, request.decimal);
    let solution = session.solution(template, request.seed, set, doubt, mark)?;
    let grade = Grade::mark(&solution, responses);
    let marking = grade.part(place).expect("its response was marked");
    let reading = marking.reading.as_ref();
    Ok(Marked {
        verdict: marking.verdict,
        credit: marking.credit,
        reading: reading.map(|reading| reading.math.clone()),
        text: reading.map(|reading| reading.text.clone()),
        si: reading.map(|reading| reading.answered.si()),
        reasons: marking.reasons().iter().map(Reason::code).collect(),
        feedback: remarks(&solution, place, marking, Language::default()),
    })
}

/// A decimal sign.
fn decimal<'de, D: Deserializer<'de>>(deserializer: D) -> Result<DecimalMark, D::Error> {
    let sign = char::deserialize(deserializer)?;
    DecimalMark::of_char(sign)
        .ok_or_else(|| D::Error::custom(format!("`decimal` is \".\" or \",\", not \"{sign}\"")))
}

/// The place of a part in its item.
fn place(template: &Template, part: &str) -> Result<usize, Refusal> {
    template.place(part).ok_or_else(|| {
        let was = template.parts.iter().flat_map(|own| &own.was);
        let ids = template.parts.iter().map(|own| &own.id).chain(was);
        let near = crate::source::nearest(part, ids.map(String::as_str))
            .map(|near| format!(", did you mean `{near}`?"))
            .unwrap_or_default();
        let message = format!("`{}` has no part `{part}`{near}", template.id);
        Refusal::new("unknown-answer", message)
    })
}
