//! Marking of single responses for other programs: one JSON object in, one out.
//!
//! ```json
//! {"id":"ch2/e8-springs-parallel-series","set":{"k1":"200 N/m"},"part":"k_par","response":"500 N/m"}
//! ```

use serde::Deserialize;
use serde_json::{Map, Value as Json, json};

use super::{Said, mark, said};
use crate::bank::Catalogue;
use crate::scene::{Data, Scene};
use crate::solution::Solution;
use crate::solution::request::{LONGEST_LINE, Refusal, find, instance};

/// A response to be marked.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The item.
    pub id: String,
    /// Values of parameters.
    #[serde(default)]
    pub set: Map<String, Json>,
    /// Draws what is not set.
    #[serde(default)]
    pub seed: Option<u64>,
    /// The part.
    pub part: String,
    /// What was answered.
    pub response: String,
    /// Responses to earlier parts, by part.
    #[serde(default)]
    pub earlier: Map<String, Json>,
    /// Any value, returned.
    #[serde(default)]
    pub tag: Option<Json>,
}

/// Answers one line; the reply has no line break.
pub fn answer(catalogue: &Catalogue, line: &str) -> String {
    let request = if line.len() > LONGEST_LINE {
        Err(Refusal::new(
            "limit",
            format!("the line has more than {LONGEST_LINE} bytes"),
        ))
    } else {
        serde_json::from_str::<Request>(line)
            .map_err(|error| Refusal::new("json", error.to_string()))
    };
    let reply = match request {
        Ok(request) => {
            let mut reply = match marked(catalogue, &request) {
                Ok(reply) => reply,
                Err(refusal) => Map::from_iter([("error".to_owned(), json!(refusal))]),
            };
            if let Some(tag) = request.tag {
                reply.insert("tag".to_owned(), tag);
            }
            reply
        }
        Err(refusal) => Map::from_iter([("error".to_owned(), json!(refusal))]),
    };
    Json::Object(reply).to_string()
}

fn marked(catalogue: &Catalogue, request: &Request) -> Result<Map<String, Json>, Refusal> {
    let template = find(catalogue, &request.id)?;
    let place = template
        .parts
        .iter()
        .position(|part| part.id == request.part)
        .ok_or_else(|| {
            let ids = template.parts.iter().map(|part| part.id.as_str());
            let near = crate::source::nearest(&request.part, ids)
                .map(|near| format!(", did you mean `{near}`?"));
            Refusal::new(
                "unknown-answer",
                format!(
                    "`{}` has no part `{}`{}",
                    template.id,
                    request.part,
                    near.unwrap_or_default()
                ),
            )
        })?;
    let solution = Solution::of(instance(template, request.seed, &request.set)?);
    let marking = mark(&solution, place, &request.response);
    let feedback: Vec<String> = said(&solution, place, &marking)
        .iter()
        .map(|said| plain(&solution, said))
        .collect();
    let reading = marking.reading.as_ref();
    Ok(Map::from_iter([
        ("verdict".to_owned(), json!(marking.verdict)),
        ("credit".to_owned(), json!(marking.credit)),
        (
            "reading".to_owned(),
            json!(reading.map(|reading| reading.math.latex())),
        ),
        (
            "text".to_owned(),
            json!(reading.map(|reading| &reading.text)),
        ),
        ("si".to_owned(), json!(reading.map(|reading| &reading.si))),
        (
            "reasons".to_owned(),
            marking
                .reasons
                .iter()
                .map(|reason| Json::from(reason.code()))
                .collect(),
        ),
        ("feedback".to_owned(), feedback.into()),
    ]))
}

/// A piece of feedback as plain text.
pub fn plain(solution: &Solution<'_>, said: &Said<'_>) -> String {
    match said {
        Said::Words(words) => words.clone(),
        Said::Document(document) => document.plain(&Vec::new()),
        Said::Passage(passage) => {
            let shown = Scene::of(solution, Data::Both).passage(passage);
            shown
                .iter()
                .map(|piece| piece.document.plain(&piece.fillings))
                .collect::<Vec<_>>()
                .join("\n")
        }
    }
}
