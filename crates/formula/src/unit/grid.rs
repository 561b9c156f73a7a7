//! Grids: the values from which a parameter is drawn.

use thiserror::Error;

use super::decimal::Decimal;

/// The decimals `lo, lo + step, ..., hi`, all exact and with the same number of decimals.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::{Decimal, Grid};
///
/// let decimal = |text| Decimal::parse(text).unwrap();
/// let grid = Grid::new(decimal("0.5"), decimal("2"), decimal("0.25")).unwrap();
/// assert_eq!(grid.len(), 7);
/// assert_eq!(grid.value(2).unwrap().to_string(), "1.00");
/// assert_eq!(grid.value(7), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Grid {
    lo: Decimal,
    step: Decimal,
    last: u64,
}

/// Why there is no such grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GridError {
    /// A step has to go up.
    #[error("the step `{step}` is not positive")]
    Step {
        /// The distance of neighbouring values.
        step: Decimal,
    },
    /// The end comes before the beginning.
    #[error("the range ends at `{hi}`, before it begins at `{lo}`")]
    Empty {
        /// The beginning.
        lo: Decimal,
        /// The end.
        hi: Decimal,
    },
    /// The end is not reached.
    #[error("steps of `{step}` from `{lo}` do not reach `{hi}`")]
    Missed {
        /// The beginning.
        lo: Decimal,
        /// The end.
        hi: Decimal,
        /// The distance of neighbouring values.
        step: Decimal,
    },
    /// More values than can be counted, or more digits than are exact.
    #[error("the grid has too many values or digits")]
    TooFine,
}

impl Grid {
    /// The grid from `lo` to `hi` in steps of `step`.
    ///
    /// # Errors
    ///
    /// If the step is not positive, the end comes before the beginning or is not reached in whole steps, or
    /// there are 2⁵³ values or more.
    pub fn new(lo: Decimal, hi: Decimal, step: Decimal) -> Result<Self, GridError> {
        if step <= Decimal::ZERO {
            return Err(GridError::Step { step });
        }
        if hi < lo {
            return Err(GridError::Empty { lo, hi });
        }
        let decimals = lo.decimals().max(step.decimals());
        let lo_on_grid = lo.with_decimals(decimals).ok_or(GridError::TooFine)?;
        let width = hi.checked_sub(lo).ok_or(GridError::TooFine)?;
        let last = width
            .whole_ratio(step)
            .ok_or(GridError::Missed { lo, hi, step })?;
        let grid = Self {
            lo: lo_on_grid,
            step,
            last,
        };
        if last >= 1 << 53 || grid.value(last).is_none() {
            return Err(GridError::TooFine);
        }
        Ok(grid)
    }

    /// How many values it has: at least one.
    #[expect(clippy::len_without_is_empty, reason = "a grid is never empty")]
    pub const fn len(&self) -> u64 {
        self.last + 1
    }

    /// The value at a place, counted from 0.
    pub fn value(&self, place: u64) -> Option<Decimal> {
        if place > self.last {
            return None;
        }
        let value = self.lo.checked_add(self.step.checked_mul(place.into())?)?;
        value.with_decimals(self.lo.decimals())
    }

    /// Where a value stands on the grid, if it does.
    ///
    /// ```
    /// use vibank_formula::unit::{Decimal, Grid};
    ///
    /// let decimal = |text| Decimal::parse(text).unwrap();
    /// let grid = Grid::new(decimal("1"), decimal("3"), decimal("0.1")).unwrap();
    /// assert_eq!(grid.place(decimal("1.3")), Some(3));
    /// assert_eq!(grid.place(decimal("1.35")), None);
    /// ```
    pub fn place(&self, value: Decimal) -> Option<u64> {
        value
            .checked_sub(self.lo)
            .filter(|above| !above.is_negative())?
            .whole_ratio(self.step)
            .filter(|&place| place <= self.last)
    }
}
