//! What is shown of a response while it is typed: how it is read, and nothing of the key.

use super::{Marking, Reading, Remark, Unreadable, Why};
use crate::math::Math;

/// How a response is read: by its conventional reading, and by the next one where there is a doubt.
///
/// It follows from the text, the symbols and what is asked, so that nobody learns from it whether a response is right.
#[derive(Clone, Debug, PartialEq)]
pub struct Echo {
    /// The conventional reading.
    pub reading: Reading,
    /// The other one, typeset.
    pub other: Option<Math>,
}

impl Echo {
    /// The echo of readings, the conventional one first.
    pub(crate) fn of(readings: impl IntoIterator<Item = Reading>) -> Option<Self> {
        let mut readings = readings.into_iter();
        let reading = readings.next()?;
        let other = readings.find(|other| other.text != reading.text);
        Some(Self {
            reading,
            other: other.map(|other| other.math),
        })
    }

    /// The echo of a response that can be read in one way.
    pub(crate) fn of_reading(reading: Reading) -> Self {
        Self {
            reading,
            other: None,
        }
    }

    /// The echo of a response by its marking, for kinds that read it in one way only.
    ///
    /// # Errors
    ///
    /// Why it cannot be read.
    pub(crate) fn of_marking(marking: Marking) -> Result<Self, Unreadable> {
        let why = marking.remarks.into_iter().find_map(|remark| match remark {
            Remark::Unreadable(why) => Some(why),
            _ => None,
        });
        match marking.reading {
            Some(reading) => Ok(Self::of_reading(reading)),
            None => Err(why.unwrap_or_else(|| Unreadable::of(Why::Form))),
        }
    }
}
