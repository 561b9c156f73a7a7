//! Reading the parameters of a request.

use serde_json::{Map, Value};

use super::error::{RequestError, excerpt};
use crate::numerics::ExactNumber;
use crate::vibration::Oscillator;
use crate::vibration::State;

/// The longest list that is read.
pub(super) const LONGEST_LIST: usize = 200_000;

/// The parameters of a request, with no key that the task does not know.
pub(super) struct Parameters<'a> {
    values: &'a Map<String, Value>,
}

/// A time or a list of them.
pub(super) enum Times {
    /// A single time: results are numbers.
    One(f64),
    /// A list: results are lists.
    Many(Vec<f64>),
}

impl Times {
    /// All times in order.
    pub(super) fn as_slice(&self) -> &[f64] {
        match self {
            Self::One(time) => std::slice::from_ref(time),
            Self::Many(times) => times,
        }
    }
}

/// A number as it was written, and the nearest binary64.
#[derive(Clone, Copy)]
pub(super) struct Given {
    pub(super) value: f64,
    pub(super) exact: ExactNumber,
}

impl<'a> Parameters<'a> {
    pub(super) fn of(
        values: &'a Map<String, Value>,
        keys: &'static [&'static str],
    ) -> Result<Self, RequestError> {
        refuse_unknown(values, keys)?;
        Ok(Self { values })
    }

    /// Whether a parameter was given; `null` is as good as absent.
    pub(super) fn has(&self, name: &str) -> bool {
        self.values.get(name).is_some_and(|value| !value.is_null())
    }

    /// A number.
    pub(super) fn number(&self, name: &'static str) -> Result<f64, RequestError> {
        self.given(name).map(|given| given.value)
    }

    /// A number, if it was given.
    pub(super) fn optional_number(&self, name: &'static str) -> Result<Option<f64>, RequestError> {
        if self.has(name) {
            self.number(name).map(Some)
        } else {
            Ok(None)
        }
    }

    /// A number with its decimal.
    pub(super) fn given(&self, name: &'static str) -> Result<Given, RequestError> {
        const EXPECTED: &str = "a finite number, or a decimal in a string";
        number(self.value(name)?).ok_or(RequestError::NotANumber {
            name,
            expected: EXPECTED,
        })
    }

    /// A whole number from one up.
    pub(super) fn count(&self, name: &'static str) -> Result<u64, RequestError> {
        const EXPECTED: &str = "an integer from 1 to 9007199254740992";
        let value = self.number(name)?;
        let is_count = value == value.trunc() && (1.0..=9_007_199_254_740_992.0).contains(&value);
        if is_count {
            Ok(value as u64)
        } else {
            Err(RequestError::NotANumber {
                name,
                expected: EXPECTED,
            })
        }
    }

    /// A number or a list of numbers.
    pub(super) fn times(&self, name: &'static str) -> Result<Times, RequestError> {
        match self.value(name)? {
            Value::Array(_) => self.list(name).map(Times::Many),
            _ => self.number(name).map(Times::One),
        }
    }

    /// A list of numbers.
    pub(super) fn list(&self, name: &'static str) -> Result<Vec<f64>, RequestError> {
        const EXPECTED: &str = "a list of finite numbers, or of decimals in strings";
        let wrong = || RequestError::NotANumber {
            name,
            expected: EXPECTED,
        };
        let entries = self.entries(name, EXPECTED)?;
        entries
            .iter()
            .map(|entry| number(entry).map(|given| given.value).ok_or_else(wrong))
            .collect()
    }

    /// A list of values, of bounded length.
    pub(super) fn entries(
        &self,
        name: &'static str,
        expected: &'static str,
    ) -> Result<&'a [Value], RequestError> {
        match self.value(name)? {
            Value::Array(entries) if entries.len() > LONGEST_LIST => Err(RequestError::TooMany {
                name,
                count: entries.len(),
                most: LONGEST_LIST,
            }),
            Value::Array(entries) => Ok(entries),
            _ => Err(RequestError::NotANumber { name, expected }),
        }
    }

    /// The oscillator of `m`, `c` and `k`.
    pub(super) fn oscillator(&self) -> Result<Oscillator, RequestError> {
        Oscillator::new(self.number("m")?, self.number("c")?, self.number("k")?)
            .map_err(RequestError::domain)
    }

    /// The initial state of `x0` and `v0`.
    pub(super) fn initial_state(&self) -> Result<State, RequestError> {
        Ok(State {
            position: self.number("x0")?,
            velocity: self.number("v0")?,
        })
    }

    fn value(&self, name: &'static str) -> Result<&'a Value, RequestError> {
        self.values
            .get(name)
            .ok_or(RequestError::MissingParameter { name })
    }
}

/// A finite number, or a decimal in a string.
pub(super) fn number(value: &Value) -> Option<Given> {
    match value {
        Value::Number(number) => decimal(&number.to_string()),
        Value::String(text) => decimal(text),
        _ => None,
    }
}

/// A decimal such as `-12.50`, `.5` or `1e-4`, as it was written and as the nearest binary64.
fn decimal(text: &str) -> Option<Given> {
    const LONGEST: usize = 400;
    let is_decimal = text.len() <= LONGEST
        && text
            .bytes()
            .all(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E'));
    let value = text
        .parse::<f64>()
        .ok()
        .filter(|value| is_decimal && value.is_finite())?;
    let exact = ExactNumber::from_decimal(text).or_else(|| ExactNumber::from_f64(value))?;
    Some(Given { value, exact })
}

/// Refuses an object with a key that nobody reads.
pub(super) fn refuse_unknown(
    object: &Map<String, Value>,
    known: &'static [&'static str],
) -> Result<(), RequestError> {
    match object.keys().find(|key| !known.contains(&key.as_str())) {
        Some(key) => Err(RequestError::UnknownKey {
            key: excerpt(key),
            known,
        }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cmp::Ordering;

    use crate::numerics::sign_of_sum;

    #[test]
    fn decimals_are_kept_beside_the_nearest_number() {
        let given = |text: &str| number(&serde_json::from_str(text).unwrap()).unwrap();
        for text in ["0.3", r#""0.3""#, r#""+3e-1""#, "3e-1"] {
            let (given, tenth) = (given(text), ExactNumber::from_decimal("0.1").unwrap());
            assert_eq!(given.value, 0.3);
            let three = ExactNumber::from(3_u64);
            assert_eq!(
                sign_of_sum(&[&[given.exact], &[-three, tenth]]),
                Ordering::Equal,
                "{text}"
            );
        }
    }

    #[test]
    fn numbers_of_seventeen_digits_are_the_nearest() {
        let value: Value = serde_json::from_str("0.10000000000000001").unwrap();
        assert_eq!(number(&value).unwrap().value, 0.1);
        let value: Value =
            serde_json::from_str("7.0420557077594588669468784357561207962098443483187940792729e28")
                .unwrap();
        assert_eq!(number(&value).unwrap().value, 7.042_055_707_759_459e28);
    }

    #[test]
    fn words_are_no_numbers() {
        for text in ["", "nan", "infinity", "0x10", "1_000", "1,5", "--1", "e5"] {
            assert!(decimal(text).is_none(), "{text}");
        }
    }
}
