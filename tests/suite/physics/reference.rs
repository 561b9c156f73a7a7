//! Reference values of 50 digits, and the table of the errors against them.

use serde::Deserialize;
use serde_json::{Map, Value, json};
use vibank::compute;
use vibank::numerics::{Dd, ExactNumber};

/// A line of a file in `tests/fixtures/references`.
#[derive(Deserialize)]
pub(super) struct Case {
    pub(super) task: String,
    pub(super) params: Map<String, Value>,
    pub(super) result: Map<String, Value>,
}

impl Case {
    pub(super) fn read(text: &str) -> Vec<Self> {
        text.lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect()
    }

    /// What the request of this case is answered.
    pub(super) fn answer(&self) -> Map<String, Value> {
        let request = json!({ "id": 0, "task": self.task, "params": self.params });
        let reply: Value = serde_json::from_str(&compute::answer(&request.to_string())).unwrap();
        reply["result"]
            .as_object()
            .unwrap_or_else(|| panic!("{reply} to {request}"))
            .clone()
    }

    /// A parameter as binary64; 0 if it is absent.
    pub(super) fn number(&self, name: &str) -> f64 {
        match self.params.get(name) {
            None => 0.0,
            Some(Value::String(text)) => text.parse().unwrap(),
            Some(value) => value.as_f64().unwrap(),
        }
    }

    /// A parameter that is a list.
    pub(super) fn numbers(&self, name: &str) -> Vec<f64> {
        let list = self.params[name].as_array().unwrap();
        list.iter().map(|value| value.as_f64().unwrap()).collect()
    }

    /// A result.
    pub(super) fn expected(&self, name: &str) -> Dd {
        read(&self.result[name])
    }

    /// A result that is a list.
    pub(super) fn expected_list(&self, name: &str) -> Vec<Dd> {
        self.result[name]
            .as_array()
            .unwrap()
            .iter()
            .map(read)
            .collect()
    }
}

/// The leading digits of a decimal, as many as a double-double holds.
pub(super) fn read(value: &Value) -> Dd {
    const DIGITS: usize = 36;
    let text = value.as_str().unwrap();
    let (mantissa, exponent) = text.split_once('e').map_or((text, ""), |(mantissa, _)| {
        (mantissa, &text[mantissa.len()..])
    });
    let first = mantissa
        .find(|c: char| c.is_ascii_digit() && c != '0')
        .unwrap_or(0);
    let end = mantissa
        .len()
        .min(first + DIGITS)
        .max(mantissa.find('.').unwrap_or(mantissa.len()));
    match ExactNumber::from_decimal(&format!("{}{exponent}", &mantissa[..end])) {
        Some(number) => number.to_dd(),
        None => Dd::from(text.parse::<f64>().unwrap()),
    }
}

/// The error of a value, in units of the last place of the expected one.
pub(super) fn ulps(value: f64, expected: Dd) -> f64 {
    let next = f64::from_bits(expected.hi().abs().to_bits() + 1);
    (expected - value).hi().abs() / (next - expected.hi().abs())
}

/// Worst errors by quantity, each with its target.
#[derive(Default)]
pub(crate) struct Accuracy {
    rows: Vec<Row>,
}

/// The errors of one quantity.
pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) cases: usize,
    /// The error that comes closest to its target, or passes it.
    pub(crate) worst: f64,
    pub(crate) target: f64,
    pub(crate) at: String,
}

impl Accuracy {
    /// Counts one error of a quantity.
    pub(crate) fn record(
        &mut self,
        name: &str,
        error: f64,
        target: f64,
        at: impl FnOnce() -> String,
    ) {
        let index = self.rows.iter().position(|row| row.name == name);
        let row = match index {
            Some(index) => &mut self.rows[index],
            None => {
                self.rows.push(Row {
                    name: name.to_owned(),
                    cases: 0,
                    worst: 0.0,
                    target,
                    at: String::new(),
                });
                self.rows.last_mut().unwrap()
            }
        };
        row.cases += 1;
        // An error that is no number is worse than any, and stays: nothing is greater than it.
        let is_worse = error / target > row.worst / row.target || error.is_nan();
        if is_worse || row.cases == 1 {
            (row.worst, row.target, row.at) = (error, target, at());
        }
    }

    /// The table, a row for each quantity.
    pub(crate) fn rows(self) -> Vec<Row> {
        self.rows
    }
}

impl Row {
    /// Whether no error passes its target.
    pub(crate) fn is_met(&self) -> bool {
        self.worst <= self.target
    }
}
