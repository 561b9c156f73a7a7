//! Requests of scripts: one JSON object in, one out.
//!
//! ```json
//! {"id":"ch2/e8-springs-parallel-series","set":{"k1":"200 N/m"},"want":["k_par"]}
//! ```

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value as Json, json};

use super::{Entry, Session, Solution};
use crate::bank::{ParameterError, Template};
use crate::expr::Precise;
use crate::instance::{Instance, InstanceError};
use crate::quantity::Trace;
use crate::seed::Seed;
use crate::unit::Decimal;

/// What a script asks for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SolveRequest {
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

/// The answers to a request, or why there are none.
#[derive(Clone, Debug, Serialize)]
pub struct SolveReply {
    /// The item.
    pub id: String,
    /// The tag of the request.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tag: Option<Json>,
    /// Either of them.
    #[serde(flatten)]
    pub outcome: SolveOutcome,
}

/// Answers, or a refusal.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum SolveOutcome {
    /// The answers.
    Solved(Solved),
    /// Why there are none.
    Refused {
        /// Its code and what is wrong.
        error: Refusal,
    },
}

/// What was solved, and for which data.
#[derive(Clone, Debug, Serialize)]
pub struct Solved {
    /// The data by name, in the order of the item.
    #[serde(serialize_with = "as_object")]
    pub parameters: Vec<(String, SolvedDatum)>,
    /// The answers by identity, in the order of the request or the item.
    #[serde(serialize_with = "as_object")]
    pub answers: Vec<(String, Entry)>,
}

/// A datum of the item, as a program gets it.
#[derive(Clone, Debug, Serialize)]
pub struct SolvedDatum {
    /// Its value in its unit.
    pub value: f64,
    /// Its unit; `1` for a pure number.
    pub unit: String,
    /// Its value in SI units.
    pub si: f64,
}

/// Pairs as an object that keeps their order.
fn as_object<S: Serializer, T: Serialize>(
    pairs: &[(String, T)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(name, value)| (name, value)))
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
pub const MAX_LINE_LENGTH: usize = 1 << 20;
/// Most times in one request.
const MAX_TIMES: usize = 100_000;

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
pub fn answer(session: &mut Session<'_>, line: &str) -> String {
    match read(line) {
        Ok(request) => {
            let (reply, _) = reply(session, request);
            serde_json::to_string(&reply).expect("a reply is plain data")
        }
        Err(refused) => Json::Object(refused).to_string(),
    }
}

/// The request in a line, or the reply that refuses it, with identity and tag where they could be read.
pub(crate) fn read<T: DeserializeOwned>(line: &str) -> Result<T, Map<String, Json>> {
    let (refusal, parts) = if line.len() > MAX_LINE_LENGTH {
        let message = format!("the line has more than {MAX_LINE_LENGTH} bytes");
        (Refusal::new("limit", message), Json::Null)
    } else {
        // A list would be read as the values of a request in the order of its fields.
        let is_object = line.trim_start().starts_with('{');
        let message = match serde_json::from_str(line) {
            Ok(request) if is_object => return Ok(request),
            Err(error) if is_object => error
                .to_string()
                .replace(" at line 1 column ", " at column "),
            _ => "a request is one JSON object".to_owned(),
        };
        let parts = serde_json::from_str(line).unwrap_or(Json::Null);
        (Refusal::new("json", message), parts)
    };
    let known = ["id", "tag"].into_iter().filter_map(|key| {
        let value = parts
            .get(key)
            .filter(|value| !value.is_object() && !value.is_array())?;
        Some((key.to_owned(), value.clone()))
    });
    let error = ("error".to_owned(), json!(refusal));
    Err(known.chain([error]).collect())
}

/// Answers one request, and says what was computed for it.
pub fn reply(session: &mut Session<'_>, request: SolveRequest) -> (SolveReply, Option<Trace>) {
    let (outcome, trace) = match solve(session, &request) {
        Ok((solved, trace)) => (SolveOutcome::Solved(solved), Some(trace)),
        Err(error) => (SolveOutcome::Refused { error }, None),
    };
    let reply = SolveReply {
        id: request.id,
        tag: request.tag,
        outcome,
    };
    (reply, trace)
}

fn solve(session: &mut Session<'_>, request: &SolveRequest) -> Result<(Solved, Trace), Refusal> {
    let template = session.find(&request.id)?;
    let at = times(&request.at)?;
    let (doubt, mark) = Default::default();
    let solution = session.solution(template, request.seed, &request.set, doubt, mark)?;
    let mut answers: Vec<(String, Entry)> = Vec::new();
    match &request.want {
        Some(ids) => {
            for id in ids {
                if answers.iter().any(|(known, _)| known == id) {
                    continue;
                }
                let entry = solution.entry(id, &at);
                let entry = entry.ok_or_else(|| unknown_answer(template, id))?;
                answers.push((id.clone(), entry));
            }
        }
        None => {
            for id in template.answer_ids() {
                answers.extend(solution.entry(id, &at).map(|entry| (id.to_owned(), entry)));
            }
        }
    }
    let solved = Solved {
        parameters: parameters(&solution),
        answers,
    };
    Ok((solved, solution.trace()))
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
    if at.len() > MAX_TIMES {
        return Err(Refusal::new(
            "limit",
            format!("more than {MAX_TIMES} times"),
        ));
    }
    at.iter()
        .map(|value| {
            let decimal = Decimal::parse(&text_of("at", value)?)
                .map_err(|error| Refusal::new("json", format!("`at`: {error}")))?;
            let (high, low) = decimal.to_pair();
            Ok(Precise::new(high, low, 0.0))
        })
        .collect()
}

fn parameters(solution: &Solution<'_>) -> Vec<(String, SolvedDatum)> {
    let template = solution.template();
    let values = template.parameters.iter().zip(solution.instance().values());
    values
        .map(|(parameter, value)| {
            let given = SolvedDatum {
                value: value.value.to_f64(),
                unit: unit_text(&value.unit),
                si: parameter.si_pair(value).0,
            };
            (parameter.name.to_string(), given)
        })
        .collect()
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
