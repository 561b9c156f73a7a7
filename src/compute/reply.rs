//! Writing the result of a request.

use super::error::RequestError;
use super::parameters::Times;
use crate::vibration::State;

/// A result in the making, as JSON. Numbers that are not finite are found when it is finished.
#[derive(Default)]
pub(crate) struct ResultReply {
    /// The members of the object so far.
    text: String,
    /// The first result that is not a finite number.
    overflow: Option<&'static str>,
}

/// Bytes of a number with its comma.
// The longest, `-2.2250738585072014e-308`, has 24.
const MAX_NUMBER_LENGTH: usize = 26;

impl ResultReply {
    /// Adds a number.
    pub(crate) fn number(mut self, name: &'static str, value: f64) -> Self {
        self.key(name);
        self.value(name, value);
        self
    }

    /// Adds an integer, or `null` where there is none.
    pub(crate) fn count(mut self, name: &'static str, value: Option<u64>) -> Self {
        self.key(name);
        let text = value.map_or_else(|| "null".to_owned(), |value| value.to_string());
        self.text.push_str(&text);
        self
    }

    /// Adds a number, or `null` where there is none or it leaves the range of numbers.
    pub(crate) fn optional(mut self, name: &'static str, value: Option<f64>) -> Self {
        self.key(name);
        self.value_or_null(value);
        self
    }

    /// Adds a word, which needs no escapes.
    pub(crate) fn word(mut self, name: &'static str, word: &str) -> Self {
        self.key(name);
        self.text.push('"');
        self.text.push_str(word);
        self.text.push('"');
        self
    }

    /// Adds a list of numbers.
    pub(crate) fn list(
        mut self,
        name: &'static str,
        values: impl IntoIterator<Item = f64>,
    ) -> Self {
        self.key(name);
        self.values(name, values);
        self
    }

    /// Adds a list of numbers, `null` where there is none.
    pub(crate) fn optional_list(
        mut self,
        name: &'static str,
        values: impl IntoIterator<Item = Option<f64>>,
    ) -> Self {
        self.key(name);
        self.text.push('[');
        for (i, value) in values.into_iter().enumerate() {
            self.separate(i);
            self.value_or_null(value);
        }
        self.text.push(']');
        self
    }

    /// Adds a list of vectors.
    pub(crate) fn vectors<'v>(
        mut self,
        name: &'static str,
        vectors: impl IntoIterator<Item = &'v [f64]>,
    ) -> Self {
        self.key(name);
        let vectors: Vec<&[f64]> = vectors.into_iter().collect();
        // At once: a text of a million bytes is moved as often as it grows.
        let count: usize = vectors.iter().map(|vector| vector.len()).sum();
        self.text.reserve(MAX_NUMBER_LENGTH * count);
        self.text.push('[');
        for (i, vector) in vectors.into_iter().enumerate() {
            self.separate(i);
            self.values(name, vector.iter().copied());
        }
        self.text.push(']');
        self
    }

    /// Adds position and velocity at each of the times.
    pub(crate) fn states(
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

    /// The members of the object, unless a number left its range.
    pub(crate) fn finish(self) -> Result<String, RequestError> {
        match self.overflow {
            Some(name) => Err(RequestError::NotFinite { name }),
            None => Ok(self.text),
        }
    }

    fn key(&mut self, name: &str) {
        self.separate(self.text.len());
        self.text.push('"');
        self.text.push_str(name);
        self.text.push_str("\":");
    }

    /// A comma before all but the first.
    fn separate(&mut self, position: usize) {
        if position > 0 {
            self.text.push(',');
        }
    }

    fn values(&mut self, name: &'static str, values: impl IntoIterator<Item = f64>) {
        let values = values.into_iter();
        self.text.reserve(MAX_NUMBER_LENGTH * values.size_hint().0);
        self.text.push('[');
        for (i, value) in values.enumerate() {
            self.separate(i);
            self.value(name, value);
        }
        self.text.push(']');
    }

    fn value_or_null(&mut self, value: Option<f64>) {
        match value.filter(|value| value.is_finite()) {
            Some(value) => self.value("", value),
            None => self.text.push_str("null"),
        }
    }

    /// The shortest decimal that reads back to the same number.
    fn value(&mut self, name: &'static str, value: f64) {
        if value.is_finite() {
            self.text.push_str(zmij::Buffer::new().format_finite(value));
        } else {
            self.overflow.get_or_insert(name);
        }
    }
}
