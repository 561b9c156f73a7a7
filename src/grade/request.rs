//! Marking of single responses for other programs: one JSON object in, one out.
//!
//! ```json
//! {"id":"ch2/e8-springs-parallel-series","set":{"k1":"200 N/m"},"part":"k_par","response":"500 N/m"}
//! {"id":"ch4/p3-base-excited-relative","part":"omega_n","response":"1.095 rad/s","earlier":{"k_eq":"k1*k2/(k1 + k2)"}}
//! ```

use serde::Deserialize;
use serde_json::{Map, Value as Json, json};

use super::{Grade, remarks};
use crate::bank::{Catalogue, Template};
use crate::solution::Solution;
use crate::solution::request::{Refusal, find, instance, read};

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
    /// Responses to other parts, by part: earlier ones for follow-through, equations that are asked beside this one.
    #[serde(default)]
    pub earlier: Map<String, Json>,
    /// Any value, returned.
    #[serde(default)]
    pub tag: Option<Json>,
}

/// Answers one line; the reply has no line break.
pub fn answer(catalogue: &Catalogue, line: &str) -> String {
    let reply = read(line).map_or_else(
        |refused| refused,
        |request: Request| {
            let mut reply = marked(catalogue, &request)
                .unwrap_or_else(|refusal| Map::from_iter([("error".to_owned(), json!(refusal))]));
            if let Some(tag) = request.tag {
                reply.insert("tag".to_owned(), tag);
            }
            reply
        },
    );
    Json::Object(reply).to_string()
}

fn marked(catalogue: &Catalogue, request: &Request) -> Result<Map<String, Json>, Refusal> {
    let template = find(catalogue, &request.id)?;
    let place = place(template, &request.part)?;
    let mut responses = vec![(place, request.response.as_str())];
    for (part, response) in &request.earlier {
        let response = response.as_str().ok_or_else(|| {
            Refusal::new(
                "json",
                format!("the earlier response to `{part}` is no text"),
            )
        })?;
        let earlier = self::place(template, part)?;
        if earlier == place {
            let message = format!("`{part}` is the part that is marked, not an earlier one");
            return Err(Refusal::new("json", message));
        }
        responses.push((earlier, response));
    }
    let solution = Solution::of(instance(template, request.seed, &request.set)?);
    let grade = Grade::mark(&solution, responses);
    let marking = grade.part(place).expect("its response was marked");
    let feedback = remarks(&solution, place, marking);
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
        (
            "si".to_owned(),
            json!(reading.map(|reading| reading.answered.si())),
        ),
        (
            "reasons".to_owned(),
            marking
                .reasons()
                .iter()
                .map(|reason| Json::from(reason.code()))
                .collect(),
        ),
        ("feedback".to_owned(), json!(feedback)),
    ]))
}

/// The place of a part in its item.
fn place(template: &Template, part: &str) -> Result<usize, Refusal> {
    let found = template.parts.iter().position(|own| own.id == part);
    found.ok_or_else(|| {
        let ids = template.parts.iter().map(|own| own.id.as_str());
        let near = crate::source::nearest(part, ids)
            .map(|near| format!(", did you mean `{near}`?"))
            .unwrap_or_default();
        let message = format!("`{}` has no part `{part}`{near}", template.id);
        Refusal::new("unknown-answer", message)
    })
}
