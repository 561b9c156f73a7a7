//! Building the result of a request.

use serde_json::{Map, Value};

use super::error::RequestError;
use super::parameters::Times;
use crate::vibration::State;

/// A result in the making. Numbers that are not finite are found when it is finished.
#[derive(Default)]
pub(super) struct Reply {
    object: Map<String, Value>,
    /// The first result that is no finite number.
    overflow: Option<&'static str>,
}

impl Reply {
    /// Adds a number.
    pub(super) fn number(mut self, name: &'static str, value: f64) -> Self {
        let value = self.checked(name, value);
        self.insert(name, value)
    }

    /// Adds a number, or `null` where there is none or it leaves the range of numbers.
    pub(super) fn optional(self, name: &'static str, value: Option<f64>) -> Self {
        match value.filter(|value| value.is_finite()) {
            Some(value) => self.number(name, value),
            None => self.insert(name, Value::Null),
        }
    }

    /// Adds a text.
    pub(super) fn text(self, name: &'static str, value: &str) -> Self {
        self.insert(name, Value::from(value))
    }

    /// Adds a list of numbers.
    pub(super) fn list(
        mut self,
        name: &'static str,
        values: impl IntoIterator<Item = f64>,
    ) -> Self {
        let values: Vec<Value> = values
            .into_iter()
            .map(|value| self.checked(name, value))
            .collect();
        self.insert(name, Value::from(values))
    }

    /// Adds position and velocity at each of the times.
    pub(super) fn states(
        self,
        [position, velocity]: [&'static str; 2],
        times: &Times,
        state: impl Fn(f64) -> State,
    ) -> Self {
        match times {
            Times::One(time) => {
                let state = state(*time);
                self.number(position, state.position)
                    .number(velocity, state.velocity)
            }
            Times::Many(times) => {
                let states: Vec<State> = times.iter().map(|&time| state(time)).collect();
                self.list(position, states.iter().map(|state| state.position))
                    .list(velocity, states.iter().map(|state| state.velocity))
            }
        }
    }

    /// Adds any value.
    pub(super) fn insert(mut self, name: &'static str, value: Value) -> Self {
        self.object.insert(name.to_owned(), value);
        self
    }

    /// The object, unless a number left its range.
    pub(super) fn into_object(self) -> Result<Map<String, Value>, RequestError> {
        match self.overflow {
            Some(name) => Err(RequestError::NotFinite { name }),
            None => Ok(self.object),
        }
    }

    fn checked(&mut self, name: &'static str, value: f64) -> Value {
        if !value.is_finite() {
            self.overflow.get_or_insert(name);
        }
        Value::from(value)
    }
}
