//! Reference values of fifty digits, printed by `references.py`.

use serde::Deserialize;
use serde_json::{Map, Value};
use vibank::numerics::{Dd, ExactNumber};

const LINES: &str = include_str!("references.jsonl");

/// A line of the table: values of a task at some arguments.
#[derive(Deserialize)]
pub(crate) struct Case {
    pub(crate) task: String,
    pub(crate) case: String,
    /// The small number of a sweep.
    pub(crate) parameter: Option<f64>,
    data: Map<String, Value>,
    pub(crate) at: Vec<f64>,
    values: Vec<String>,
}

impl Case {
    /// The cases of a task.
    pub(crate) fn of(task: &str) -> impl Iterator<Item = Self> {
        LINES
            .lines()
            .map(|line| serde_json::from_str::<Self>(line).expect("the table is JSON"))
            .filter(move |case| case.task == task)
    }

    /// A number that is given.
    pub(crate) fn number(&self, name: &str) -> f64 {
        self.data[name].as_f64().expect("it is a number")
    }

    /// A number that is given as it is written.
    pub(crate) fn exact(&self, name: &str) -> ExactNumber {
        let text = self.data[name].as_str().expect("it is a text");
        ExactNumber::from_decimal(text).expect("it is a decimal")
    }

    /// The values to about thirty digits.
    pub(crate) fn values(&self) -> Vec<Dd> {
        self.values.iter().map(|digits| read(digits)).collect()
    }
}

/// The leading digits of a decimal, as many as a double-double holds.
fn read(text: &str) -> Dd {
    const DIGITS: usize = 34;
    let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
    let first = mantissa.find(|c| ('1'..='9').contains(&c)).unwrap_or(0);
    let point = mantissa.find('.').unwrap_or(mantissa.len());
    let end = mantissa.len().min((first + DIGITS).max(point));
    ExactNumber::from_decimal(&format!("{}{exponent}", &mantissa[..end]))
        .map_or(Dd::NAN, ExactNumber::to_dd)
}
