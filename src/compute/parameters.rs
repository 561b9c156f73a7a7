//! Reading the parameters of a request.

use std::borrow::Cow;

use super::error::{RequestError, excerpt};
use super::given::{GivenValue, Object};
use crate::numerics::ExactNumber;
use crate::vibration::Oscillator;
use crate::vibration::State;

/// The longest list that is read.
pub(crate) const MAX_LIST_LENGTH: usize = 200_000;

/// The parameters of a request, with no key that the task does not know.
pub(crate) struct Parameters<'a> {
    values: &'a Object<'a>,
}

/// A time or a list of them.
pub(crate) enum Times {
    /// A single time: results are numbers.
    One(f64),
    /// A list: results are lists.
    Many(Vec<f64>),
}

impl Times {
    /// All times in order.
    pub(crate) fn as_slice(&self) -> &[f64] {
        match self {
            Self::One(time) => std::slice::from_ref(time),
            Self::Many(times) => times,
        }
    }
}

impl<'a> Parameters<'a> {
    pub(crate) fn of(
        values: &'a Object<'a>,
        keys: &'static [&'static str],
    ) -> Result<Self, RequestError> {
        refuse_unknown(values, keys)?;
        Ok(Self { values })
    }

    /// Whether a parameter was given; `null` is as good as absent.
    pub(crate) fn has(&self, name: &str) -> bool {
        let value = self.values.get(name);
        value.is_some_and(|value| !matches!(value, GivenValue::Null))
    }

    /// A number that has to be given.
    pub(crate) fn number(&self, name: &'static str) -> Result<f64, RequestError> {
        number(self.value(name)?).ok_or(RequestError::NotANumber {
            name,
            expected: A_NUMBER,
        })
    }

    /// A number, if it was given.
    pub(crate) fn optional_number(&self, name: &'static str) -> Result<Option<f64>, RequestError> {
        if self.has(name) {
            self.number(name).map(Some)
        } else {
            Ok(None)
        }
    }

    /// A number as it was written.
    pub(crate) fn exact(&self, name: &'static str) -> Result<ExactNumber, RequestError> {
        exact(self.value(name)?).ok_or(RequestError::NotANumber {
            name,
            expected: A_NUMBER,
        })
    }

    /// An integer from one up.
    pub(crate) fn count(&self, name: &'static str) -> Result<u64, RequestError> {
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

    /// An integer from zero up, if it was given.
    pub(crate) fn optional_index(&self, name: &'static str) -> Result<Option<usize>, RequestError> {
        let value = self.optional_number(name)?;
        let is_index = |value: f64| value == value.trunc() && (0.0..=1e9).contains(&value);
        match value {
            Some(value) if !is_index(value) => Err(RequestError::NotANumber {
                name,
                expected: "an integer from 0 up",
            }),
            value => Ok(value.map(|value| value as usize)),
        }
    }

    /// A number or a list of numbers.
    pub(crate) fn times(&self, name: &'static str) -> Result<Times, RequestError> {
        match self.value(name)? {
            GivenValue::List(_) | GivenValue::Numbers(_) | GivenValue::Table { .. } => {
                self.list(name).map(Times::Many)
            }
            _ => self.number(name).map(Times::One),
        }
    }

    /// A list of numbers.
    pub(crate) fn list(&self, name: &'static str) -> Result<Vec<f64>, RequestError> {
        const EXPECTED: &str = "a list of finite numbers, or of decimals in strings";
        let value = self.value(name)?;
        check_length(name, value)?;
        let list = numbers(value).ok_or(RequestError::NotANumber {
            name,
            expected: EXPECTED,
        })?;
        Ok(list.into_owned())
    }

    /// A list of lists of numbers, of bounded length; `None` for an entry that is not one.
    pub(crate) fn lists(
        &self,
        name: &'static str,
        expected: &'static str,
    ) -> Result<Vec<Option<Cow<'a, [f64]>>>, RequestError> {
        let value = self.value(name)?;
        check_length(name, value)?;
        match value {
            GivenValue::List(entries) => Ok(entries.iter().map(numbers).collect()),
            GivenValue::Numbers(entries) => Ok(vec![None; entries.len()]),
            GivenValue::Table { entries, width } => {
                let rows = entries.chunks_exact(*width);
                Ok(rows.map(|row| Some(Cow::Borrowed(row))).collect())
            }
            _ => Err(RequestError::NotANumber { name, expected }),
        }
    }

    /// The oscillator of `m`, `c` and `k`.
    pub(crate) fn oscillator(&self) -> Result<Oscillator, RequestError> {
        Oscillator::new(self.number("m")?, self.number("c")?, self.number("k")?)
            .map_err(RequestError::domain)
    }

    /// The initial state of `x0` and `v0`.
    pub(crate) fn initial_state(&self) -> Result<State, RequestError> {
        Ok(State {
            position: self.number("x0")?,
            velocity: self.number("v0")?,
        })
    }

    fn value(&self, name: &'static str) -> Result<&'a GivenValue<'a>, RequestError> {
        self.values
            .get(name)
            .ok_or(RequestError::MissingParameter { name })
    }
}

/// Refuses a list that is too long.
fn check_length(name: &'static str, value: &GivenValue) -> Result<(), RequestError> {
    let count = match value {
        GivenValue::List(entries) => entries.len(),
        GivenValue::Numbers(entries) => entries.len(),
        GivenValue::Table { entries, width } => entries.len() / width,
        _ => 0,
    };
    if count > MAX_LIST_LENGTH {
        return Err(RequestError::TooMany {
            name,
            count,
            most: MAX_LIST_LENGTH,
        });
    }
    Ok(())
}

const A_NUMBER: &str = "a finite number, or a decimal in a string";

/// A finite number, or a decimal in a string.
fn number(value: &GivenValue) -> Option<f64> {
    match value {
        GivenValue::Number(number) => Some(*number),
        GivenValue::Text(text) => nearest(text),
        _ => None,
    }
}

/// The same as it was written: a number has the shortest decimal.
fn exact(value: &GivenValue) -> Option<ExactNumber> {
    match value {
        GivenValue::Number(number) => {
            exact_decimal(&serde_json::Number::from_f64(*number)?.to_string())
        }
        GivenValue::Text(text) => exact_decimal(text),
        _ => None,
    }
}

/// A list of numbers.
fn numbers<'a>(value: &'a GivenValue) -> Option<Cow<'a, [f64]>> {
    match value {
        GivenValue::Numbers(numbers) => Some(Cow::Borrowed(numbers)),
        GivenValue::List(entries) => entries
            .iter()
            .map(number)
            .collect::<Option<_>>()
            .map(Cow::Owned),
        _ => None,
    }
}

/// The binary64 next to a decimal such as `-12.50`, `.5` or `1e-4`.
fn nearest(text: &str) -> Option<f64> {
    // Nobody writes a longer number, and the reader would go through all of it.
    const MAX_LENGTH: usize = 400;
    let value = text
        .parse::<f64>()
        .ok()
        .filter(|_| text.len() <= MAX_LENGTH);
    value.filter(|value| value.is_finite())
}

/// A decimal as it was written; one too long for that as the nearest binary64.
fn exact_decimal(text: &str) -> Option<ExactNumber> {
    let value = nearest(text)?;
    ExactNumber::from_decimal(text).or_else(|| ExactNumber::from_f64(value))
}

/// Refuses an object with a key that nobody reads.
pub(crate) fn refuse_unknown(
    object: &Object,
    known: &'static [&'static str],
) -> Result<(), RequestError> {
    match object.keys().find(|key| !known.contains(key)) {
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
    fn decimals_are_kept_as_they_are_written() {
        let tenth = ExactNumber::from_decimal("0.1").unwrap();
        let three = ExactNumber::from(3_u64);
        for text in ["0.3", r#""0.3""#, r#""+3e-1""#, "3e-1"] {
            let value = serde_json::from_str(text).unwrap();
            assert_eq!(number(&value), Some(0.3));
            assert_eq!(
                sign_of_sum(&[&[exact(&value).unwrap()], &[-three, tenth]]),
                Ordering::Equal,
                "{text}"
            );
        }
    }

    #[test]
    fn numbers_of_seventeen_digits_are_the_nearest() {
        let value: GivenValue = serde_json::from_str("0.10000000000000001").unwrap();
        assert_eq!(number(&value), Some(0.1));
        let value: GivenValue =
            serde_json::from_str("7.0420557077594588669468784357561207962098443483187940792729e28")
                .unwrap();
        assert_eq!(number(&value), Some(7.042_055_707_759_459e28));
    }

    #[test]
    fn words_are_no_numbers() {
        for text in ["", "nan", "infinity", "0x10", "1_000", "1,5", "--1", "e5"] {
            assert!(nearest(text).is_none(), "{text}");
        }
    }
}
