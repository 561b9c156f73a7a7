//! Bare numerical requests: one JSON object in, one JSON object out.
//!
//! ```text
//! {"id": 1, "task": "log_decrement", "params": {"x1": 8, "xn1": "1", "n": 3, "Td": 0.5}}
//! {"id": 1, "result": {"delta": 0.6931471805599453, ...}}
//! {"id": 2, "error": {"code": "unknown_task", "message": "there is no task `lag`; there are ..."}}
//! ```
//!
//! Numbers are JSON numbers or decimals in strings, read as the nearest binary64; answers are the shortest decimals that
//! read back to the same binary64. Where a list of times is allowed, what depends on time is a list. What does not exist
//! is `null`, and so is what belongs to the system and leaves the range of numbers; a motion that leaves it is an error.
//! Units are those of SI, angles are in radians.
//!
//! A task is a file with a `Task` and a line in the list below. Requests are untrusted: lengths are bounded, unknown
//! keys are refused.

mod coulomb_stop;
mod error;
mod forced_response;
mod free_response;
mod given;
mod log_decrement;
mod modal_response;
mod modes;
mod network;
mod parameters;
mod pendulum_motion;
mod pendulum_period;
mod plain;
mod reply;
mod resonance_bandwidth;
mod steady_amplitude_phase;

pub use error::RequestError;

use serde::Deserialize;

use given::{GivenValue, Object, RequestLine};
use parameters::Parameters;
use reply::ResultReply;

/// A kind of request.
trait Task: Sync {
    /// The name that a request gives under `task`.
    fn name(&self) -> &'static str;

    /// The keys that it may give under `params`.
    fn keys(&self) -> &'static [&'static str];

    /// The result for checked parameters.
    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError>;
}

static TASKS: &[&dyn Task] = &[
    &coulomb_stop::CoulombStop,
    &forced_response::ForcedResponse,
    &free_response::FreeResponse,
    &log_decrement::LogDecrement,
    &modal_response::ModalResponse,
    &modes::NaturalModes,
    &pendulum_motion::PendulumMotion,
    &pendulum_period::PendulumPeriod,
    &resonance_bandwidth::ResonanceBandwidth,
    &steady_amplitude_phase::SteadyAmplitudePhase,
];

/// The longest line that is read, in bytes.
pub const MAX_LINE_LENGTH: usize = 4 << 20;

/// The reply to one line: a JSON object with the request's `id` and a `result` or an `error`.
///
/// # Examples
///
/// ```
/// use vibank::compute::answer;
///
/// let reply = answer(r#"{"id":"a","task":"resonance_bandwidth","params":{"m":1,"c":0.5,"k":"4"}}"#);
/// assert!(reply.starts_with(r#"{"id":"a","result":{"omega_r":1.968501968"#));
/// let reply = answer(r#"{"id":"b","task":"resonance_bandwidth","params":{"m":1,"c":0.5}}"#);
/// assert_eq!(reply, r#"{"id":"b","error":{"code":"missing_parameter","message":"the parameter `k` is missing"}}"#);
/// ```
pub fn answer(line: &str) -> String {
    let (id, result) = match read(line) {
        Ok((id, request)) => (id, solve(&request)),
        Err(error) => (id_of(line), Err(error)),
    };
    match result {
        Ok(mut reply) => {
            reply.insert_str(0, &format!(r#"{{"id":{id},"result":{{"#));
            reply.push_str("}}");
            reply
        }
        Err(error) => {
            let error = serde_json::to_string(&error).expect("an error is plain data");
            format!(r#"{{"id":{id},"error":{error}}}"#)
        }
    }
}

/// The names of all tasks, in alphabetical order.
pub fn tasks() -> impl Iterator<Item = &'static str> {
    TASKS.iter().map(|task| task.name())
}

fn read(line: &str) -> Result<(serde_json::Value, Object<'_>), RequestError> {
    if line.len() > MAX_LINE_LENGTH {
        return Err(RequestError::LineTooLong { bytes: line.len() });
    }
    if let Some(request) = plain::request(line) {
        return Ok(request);
    }
    match serde_json::from_str(line) {
        Ok(RequestLine::Request { id, rest }) => Ok((id, rest)),
        Ok(RequestLine::Other) => Err(RequestError::NotAnObject),
        Err(error) => Err(RequestError::NotJson {
            reason: error.to_string(),
        }),
    }
}

/// The id of a line that holds a number beyond the range of numbers and so cannot be read as a whole.
fn id_of(line: &str) -> serde_json::Value {
    #[derive(Deserialize)]
    struct Identified {
        #[serde(default)]
        id: serde_json::Value,
    }
    let is_short = line.len() <= MAX_LINE_LENGTH;
    let identified = is_short.then(|| serde_json::from_str::<Identified>(line).ok());
    identified
        .flatten()
        .map_or(serde_json::Value::Null, |request| request.id)
}

fn solve(request: &Object) -> Result<String, RequestError> {
    parameters::refuse_unknown(request, &["id", "task", "params"])?;
    let Some(GivenValue::Text(name)) = request.get("task") else {
        return Err(RequestError::NoTask);
    };
    let task = TASKS.iter().find(|task| task.name() == name);
    let task = task.ok_or_else(|| RequestError::UnknownTask {
        name: error::excerpt(name),
    })?;
    let parameters = match request.get("params") {
        Some(GivenValue::Object(parameters)) => Parameters::of(parameters, task.keys())?,
        _ => return Err(RequestError::NoParameters),
    };
    task.solve(&parameters)?.finish()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    fn code(line: &str) -> String {
        let reply: Value = serde_json::from_str(&answer(line)).unwrap();
        reply["error"]["code"].as_str().unwrap_or("none").to_owned()
    }

    fn code_of(task: &str, parameters: &str) -> String {
        code(&format!(
            r#"{{"id":1,"task":"{task}","params":{parameters}}}"#
        ))
    }

    #[test]
    fn tasks_are_listed_in_order() {
        assert!(TASKS.is_sorted_by_key(|task| task.name()));
    }

    #[test]
    fn what_is_no_request_is_refused() {
        for (line, expected) in [
            ("", "not_json"),
            ("{", "not_json"),
            ("1e400", "not_json"),
            ("[]", "not_an_object"),
            ("{}", "no_task"),
            (r#"{"task":"free_response"}"#, "no_parameters"),
            (r#"{"task":"lag","params":{}}"#, "unknown_task"),
            (
                r#"{"task":"free_response","params":{},"extra":1}"#,
                "unknown_key",
            ),
        ] {
            assert_eq!(code(line), expected, "{line}");
        }
        assert_eq!(code(&"[".repeat(100_000)), "not_json");
        assert_eq!(code(&" ".repeat(MAX_LINE_LENGTH + 1)), "line_too_long");
    }

    #[test]
    fn numbers_out_of_range_keep_the_id() {
        let reply = answer(r#"{"id":"p7","task":"free_response","params":{"m":1e400}}"#);
        assert!(
            reply.starts_with(r#"{"id":"p7","error":{"code":"not_json""#),
            "{reply}"
        );
    }

    #[test]
    fn bad_parameters_are_refused() {
        for (parameters, expected) in [
            (r#"{"m":1,"c":1}"#, "missing_parameter"),
            (r#"{"m":1,"c":1,"k":1,"q":1}"#, "unknown_key"),
            (r#"{"m":1,"c":1,"k":null}"#, "not_a_number"),
            (r#"{"m":1,"c":1,"k":"NaN"}"#, "not_a_number"),
            (r#"{"m":1,"c":1,"k":"inf"}"#, "not_a_number"),
            (r#"{"m":1,"c":1,"k":"1e400"}"#, "not_a_number"),
            (r#"{"m":1,"c":1,"k":" 1"}"#, "not_a_number"),
            (r#"{"m":1,"c":1,"k":[1]}"#, "not_a_number"),
            (r#"{"m":1,"c":1,"k":-1}"#, "out_of_domain"),
            (r#"{"m":0,"c":1,"k":1}"#, "out_of_domain"),
        ] {
            assert_eq!(
                code_of("resonance_bandwidth", parameters),
                expected,
                "{parameters}"
            );
        }
    }

    #[test]
    fn lists_of_times_give_lists() {
        let reply = answer(
            r#"{"id":1,"task":"free_response","params":{"m":1,"c":0,"k":1,"x0":"0.5","v0":0,"t":[0,0]}}"#,
        );
        let reply: Value = serde_json::from_str(&reply).unwrap();
        assert_eq!(reply["result"]["x"], json!([0.5, 0.5]));
        assert_eq!(reply["result"]["r_slow"], Value::Null);
        assert_eq!(reply["result"]["regime"], "undamped");
        let times = vec!["0"; parameters::MAX_LIST_LENGTH + 1].join(",");
        let parameters = format!(r#"{{"m":1,"c":0,"k":1,"x0":1,"v0":0,"t":[{times}]}}"#);
        assert_eq!(code_of("free_response", &parameters), "too_many");
    }

    #[test]
    fn results_beyond_the_range_of_numbers_are_errors() {
        let parameters = r#"{"m":1,"c":0,"k":1e-300,"x0":0,"v0":1e308,"t":1e10}"#;
        assert_eq!(code_of("free_response", parameters), "not_finite");
        let line = r#"{"id":1,"task":"free_response","params":{"m":1e-300,"c":1e10,"k":1e-10,"x0":1,"v0":0,"t":1e19}}"#;
        let reply: Value = serde_json::from_str(&answer(line)).unwrap();
        assert_eq!(reply["result"]["r_fast"], Value::Null);
        assert!((reply["result"]["r_slow"].as_f64().unwrap() / -1e-20 - 1.0).abs() < 4e-16);
    }
}
