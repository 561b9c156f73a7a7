//! Requests of scripts: one JSON object in, one out.
//!
//! ```json
//! {"id":"ch2/e8-springs-parallel-series","set":{"k1":"200 N/m"},"want":["k_par"]}
//! ```

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value as Json, json};

use super::Solution;
use crate::bank::{Catalogue, ParameterError, Template};
use crate::expr::Precise;
use crate::instance::{Instance, InstanceError};
use crate::quantity::Trace;
use crate::seed::Seed;
use crate::unit::Decimal;

/// What a script asks for.
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
    /// Times in seconds, for functions of time.
    #[serde(default)]
    pub at: Vec<Json>,
    /// The answers; all if absent.
    #[serde(default)]
    pub want: Option<Vec<String>>,
    /// Any value, returned.
    #[serde(default)]
    pub tag: Option<Json>,
}

/// Why a request has no answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Refusal {
    /// `json`, `unknown-item`, `unknown-parameter`, `unknown-answer`, `unit`, `domain` or `limit`.
    pub code: &'static str,
    /// What is wrong.
    pub message: String,
}

/// Longest line that is read.
pub const LONGEST_LINE: usize = 1 << 20;
/// Most times in one request.
const MOST_TIMES: usize = 100_000;

impl Refusal {
    /// A refusal with this code.
    pub fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self {
            code,
            message: message.into(),
        }
    }
}

/// Answers one line; the reply has no line break.
pub fn answer(catalogue: &Catalogue, line: &str) -> String {
    let reply = read(line).map_or_else(|refused| refused, |request| reply(catalogue, &request));
    Json::Object(reply).to_string()
}

/// The request in a line, or the reply that refuses it, with identity and tag where they could be read.
pub(crate) fn read<T: DeserializeOwned>(line: &str) -> Result<T, Map<String, Json>> {
    let (refusal, parts) = if line.len() > LONGEST_LINE {
        let message = format!("the line has more than {LONGEST_LINE} bytes");
        (Refusal::new("limit", message), Json::Null)
    } else {
        let error = match serde_json::from_str(line) {
            Ok(request) => return Ok(request),
            Err(error) => error.to_string(),
        };
        let parts = serde_json::from_str(line).unwrap_or(Json::Null);
        let message = match parts {
            Json::Null | Json::Object(_) => error.replace(" at line 1 column ", " at column "),
            _ => "a request is one JSON object".to_owned(),
        };
        (Refusal::new("json", message), parts)
    };
    let is_plain = |value: &&Json| !value.is_object() && !value.is_array();
    let known = ["id", "tag"].into_iter().filter_map(|key| {
        let value = parts.get(key).filter(is_plain)?;
        Some((key.to_owned(), value.clone()))
    });
    let error = ("error".to_owned(), json!(refusal));
    Err(known.chain([error]).collect())
}

/// Answers one request.
pub fn reply(catalogue: &Catalogue, request: &Request) -> Map<String, Json> {
    reply_traced(catalogue, request).0
}

/// Answers one request, and tells what was computed for it.
pub fn reply_traced(
    catalogue: &Catalogue,
    request: &Request,
) -> (Map<String, Json>, Option<Trace>) {
    let mut reply = Map::new();
    reply.insert("id".to_owned(), request.id.clone().into());
    if let Some(tag) = &request.tag {
        reply.insert("tag".to_owned(), tag.clone());
    }
    match solve(catalogue, request) {
        Ok((parameters, answers, trace)) => {
            reply.insert("parameters".to_owned(), Json::Object(parameters));
            reply.insert("answers".to_owned(), Json::Object(answers));
            (reply, Some(trace))
        }
        Err(refusal) => {
            reply.insert("error".to_owned(), json!(refusal));
            (reply, None)
        }
    }
}

type Objects = (Map<String, Json>, Map<String, Json>, Trace);

fn solve(catalogue: &Catalogue, request: &Request) -> Result<Objects, Refusal> {
    let template = find(catalogue, &request.id)?;
    let at = times(&request.at)?;
    let solution = Solution::of(instance(template, request.seed, &request.set)?);
    let mut answers = Map::new();
    match &request.want {
        Some(ids) => {
            for id in ids {
                if answers.contains_key(id) {
                    continue;
                }
                let entry = solution
                    .entry(id, &at)
                    .ok_or_else(|| unknown_answer(template, id))?;
                answers.insert(id.clone(), entry);
            }
        }
        None => {
            for id in template.answer_ids() {
                answers.extend(solution.entry(id, &at).map(|entry| (id.to_owned(), entry)));
            }
        }
    }
    Ok((parameters(&solution), answers, solution.trace()))
}

/// The item of a request.
///
/// # Errors
///
/// A refusal with the nearest known item.
pub fn find<'c>(catalogue: &'c Catalogue, id: &str) -> Result<&'c Template, Refusal> {
    catalogue.find(id).ok_or_else(|| {
        if catalogue.ids().any(|own| own.as_str() == id) {
            let message = format!("the item `{id}` has findings that `vibank check` shows");
            return Refusal::new("unknown-item", message);
        }
        let near = catalogue
            .nearest(id)
            .map(|near| format!(", did you mean `{near}`?"))
            .unwrap_or_default();
        Refusal::new("unknown-item", format!("there is no item `{id}`{near}"))
    })
}

/// The instance of a request.
///
/// # Errors
///
/// What is wrong with its values.
pub fn instance<'t>(
    template: &'t Template,
    seed: Option<u64>,
    set: &Map<String, Json>,
) -> Result<Instance<'t>, Refusal> {
    let set = set
        .iter()
        .map(|(name, value)| Ok((name.clone(), text_of(name, value)?)))
        .collect::<Result<Vec<_>, Refusal>>()?;
    let borrowed: Vec<(&str, &str)> = set
        .iter()
        .map(|(name, text)| (name.as_str(), text.as_str()))
        .collect();
    Instance::of(template, seed.map(Seed::new), &borrowed).map_err(|error| {
        let code = match &error {
            InstanceError::UnknownParameter { .. } => "unknown-parameter",
            InstanceError::Value {
                error: ParameterError::Quantity(_) | ParameterError::Dimension { .. },
                ..
            } => "unit",
            InstanceError::Value { .. } => "domain",
            InstanceError::Constraints { .. } => "limit",
        };
        Refusal::new(code, error.to_string())
    })
}

fn text_of(name: &str, value: &Json) -> Result<String, Refusal> {
    match value {
        Json::String(text) => Ok(text.clone()),
        Json::Number(number) => Ok(number.to_string()),
        _ => Err(Refusal::new(
            "json",
            format!("`{name}` is neither a number nor a quantity"),
        )),
    }
}

fn times(at: &[Json]) -> Result<Vec<Precise>, Refusal> {
    if at.len() > MOST_TIMES {
        return Err(Refusal::new(
            "limit",
            format!("more than {MOST_TIMES} times"),
        ));
    }
    let time = |value: &Json| {
        let decimal = Decimal::parse(&text_of("at", value)?)
            .map_err(|error| Refusal::new("json", format!("`at`: {error}")))?;
        let (high, low) = decimal.to_pair();
        Ok(Precise::new(high, low, 0.0))
    };
    at.iter().map(time).collect()
}

fn parameters(solution: &Solution<'_>) -> Map<String, Json> {
    let template = solution.template();
    let values = template.parameters.iter().zip(solution.instance().values());
    let entry = |(parameter, value): (&crate::bank::Parameter, &crate::unit::Quantity)| {
        let (si, _) = parameter.si_pair(value);
        let shown =
            json!({ "value": value.value.to_f64(), "unit": unit_text(&value.unit), "si": si });
        (parameter.name.to_string(), shown)
    };
    values.map(entry).collect()
}

fn unit_text(unit: &crate::unit::Unit) -> String {
    if unit.is_one() {
        "1".to_owned()
    } else {
        unit.to_string()
    }
}

fn unknown_answer(template: &Template, id: &str) -> Refusal {
    let ids = template.answer_ids();
    let near = crate::source::nearest(id, ids.iter().copied())
        .map(|near| format!(", did you mean `{near}`?"));
    Refusal::new(
        "unknown-answer",
        format!(
            "`{}` has no answer `{id}`{}",
            template.id,
            near.unwrap_or_default()
        ),
    )
}
