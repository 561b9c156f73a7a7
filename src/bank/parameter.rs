//! The data of an item: what can be drawn, and what a value may be.

use std::sync::Arc;

use crate::diagnostic::{Code, Diagnose, Label};
use crate::expr::Name;
use crate::math::Math;
use crate::source::Span;
use crate::unit::{self, Decimal, Quantity, Range, Unit};

/// A datum of an item.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name in formulas.
    pub name: Name,
    /// What it is, in words.
    pub title: Option<Arc<str>>,
    /// How the parameter is printed.
    pub symbol: Arc<Math>,
    /// The value of the source, used when nothing is drawn or set.
    pub value: Quantity,
    /// The unit in which values are given.
    pub unit: Unit,
    /// What can be drawn; a constant has none.
    pub grid: Option<Grid>,
    /// Which signs it may have.
    pub domain: Domain,
}

/// The decimals lo, lo + step, … up to hi.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    lo: Decimal,
    step: Decimal,
    count: u64,
}

/// Which signs a parameter may have: that of its range, or of its value where it is a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// No restriction beyond the range.
    Any,
}

/// What is wrong with a parameter, or with a value for it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// The text cannot be read as a quantity or range.
    #[error("{0}")]
    Quantity(unit::Error),
    /// Units of different dimensions.
    #[error("`{name}` is in {expected}, this is in {found}")]
    Dimension {
        /// The parameter.
        name: Name,
        /// The dimension of its value.
        expected: String,
        /// The dimension found.
        found: String,
    },
    /// A range without a step.
    #[error("`{0}` has a range but no step")]
    NoStep(Name),
    /// A step that leads nowhere.
    #[error("the step of `{0}` has to be positive and in a unit of its own range")]
    Step(Name),
    /// More values than a grid may have.
    #[error("the range of `{0}` has more than {MAX_VALUES} values")]
    TooMany(Name),
    /// A sign that it may not have.
    #[error("`{name}` has to be {domain}, this is {found}")]
    Domain {
        /// The parameter.
        name: Name,
        /// What it has to be.
        domain: Domain,
        /// The value.
        found: String,
    },
}

/// No grid has more values.
const MAX_VALUES: u64 = 1_000_000_000;

/// A place on a grid, of which there are fewer than [`MAX_VALUES`].
fn place(index: u64) -> Decimal {
    Decimal::from(u32::try_from(index).unwrap_or(u32::MAX))
}

impl Grid {
    /// The grid of a range.
    pub fn new(lo: Decimal, hi: Decimal, step: Decimal) -> Option<Self> {
        if step <= Decimal::ZERO || hi < lo {
            return None;
        }
        let decimals = lo.decimals().max(step.decimals());
        let (lo, step) = (lo.with_decimals(decimals)?, step.with_decimals(decimals)?);
        let nearly = ((hi.to_f64() - lo.to_f64()) / step.to_f64()).round();
        if !(0.0..1e9).contains(&nearly) {
            return None;
        }
        // The quotient in binary is off by at most one: the last value is decided on the decimals.
        let at = |index: u64| lo.checked_add(step.checked_mul(place(index))?);
        let mut last = nearly as u64;
        while last > 0 && at(last)? > hi {
            last -= 1;
        }
        while at(last + 1)? <= hi {
            last += 1;
        }
        Some(Self {
            lo,
            step,
            count: last + 1,
        })
    }

    /// Whether all its values are integers.
    pub fn is_integer(&self) -> bool {
        [self.lo, self.step]
            .iter()
            .all(|own| own.to_f64().fract() == 0.0)
    }

    /// How many values it has.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The value at a place, from 0.
    pub fn at(&self, index: u64) -> Decimal {
        let steps = self.step.checked_mul(place(index));
        steps
            .and_then(|steps| self.lo.checked_add(steps))
            .expect("the last value was formed when the grid was made")
    }
}

impl Domain {
    /// The domain of values from `lo` on.
    fn from(lo: &Decimal) -> Self {
        if lo.is_negative() {
            Self::Any
        } else if lo.is_zero() {
            Self::NonNegative
        } else {
            Self::Positive
        }
    }

    /// Whether a value of this sign belongs to it.
    pub fn contains(self, value: &Decimal) -> bool {
        match self {
            Self::Any => true,
            Self::NonNegative => !value.is_negative(),
            Self::Positive => !value.is_negative() && !value.is_zero(),
        }
    }
}

/// The texts of a parameter's table.
pub(crate) struct Texts<'t> {
    pub(crate) value: &'t str,
    pub(crate) range: Option<&'t str>,
    pub(crate) step: Option<&'t str>,
}

/// Which of the texts an error is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ParameterField {
    Value,
    Range,
    Step,
}

impl Parameter {
    /// Whether it is an integer by its meaning, such as a number of cycles: a pure number that is drawn from integers.
    pub fn is_integer(&self) -> bool {
        self.unit.is_one() && self.grid.is_some_and(|grid| grid.is_integer())
    }

    /// A parameter from its texts; each error names the text it is about.
    pub(crate) fn of(
        name: &Name,
        title: Option<Arc<str>>,
        symbol: Arc<Math>,
        texts: &Texts<'_>,
    ) -> Result<Self, (ParameterField, ParameterError)> {
        let of = |field| move |error| (field, ParameterError::Quantity(error));
        let value = Quantity::parse(texts.value).map_err(of(ParameterField::Value))?;
        let Some(range) = texts.range else {
            let domain = Domain::from(&value.value);
            return Ok(Self {
                name: name.clone(),
                title,
                symbol,
                value,
                unit: value.unit,
                grid: None,
                domain,
            });
        };
        let range = Range::parse(range).map_err(of(ParameterField::Range))?;
        let step = texts
            .step
            .ok_or_else(|| (ParameterField::Range, ParameterError::NoStep(name.clone())))?;
        let step = step_of(name, step, &range).map_err(|error| (ParameterField::Step, error))?;
        let unit = range.unit();
        if value.conversion(&unit).is_err() {
            return Err((ParameterField::Value, mismatch(name, &unit, &value.unit)));
        }
        let (lo, hi) = (range.lo().value, range.hi().value);
        let grid = Grid::new(lo, hi, step).filter(|grid| grid.count() <= MAX_VALUES);
        let grid =
            grid.ok_or_else(|| (ParameterField::Step, ParameterError::TooMany(name.clone())))?;
        let domain = Domain::from(&lo);
        Ok(Self {
            name: name.clone(),
            title,
            symbol,
            value,
            unit,
            grid: Some(grid),
            domain,
        })
    }

    /// A value that somebody sets: a quantity, or a bare decimal in SI units.
    ///
    /// # Errors
    ///
    /// If it cannot be read, has another dimension, or a sign that the parameter may not have.
    pub fn set(&self, text: &str) -> Result<Quantity, ParameterError> {
        let read = Quantity::parse(text.trim()).map_err(ParameterError::Quantity)?;
        let quantity = if read.unit.is_one() {
            Quantity::new(read.value, self.unit.coherent())
        } else {
            read
        };
        if quantity.conversion(&self.unit).is_err() {
            return Err(mismatch(&self.name, &self.unit, &quantity.unit));
        }
        if !self.domain.contains(&quantity.value) {
            let (name, domain) = (self.name.clone(), self.domain);
            return Err(ParameterError::Domain {
                name,
                domain,
                found: quantity.to_string(),
            });
        }
        Ok(quantity)
    }

    /// The SI value of a quantity given for it, as the sum of two numbers.
    pub fn si_pair(&self, quantity: &Quantity) -> (f64, f64) {
        match quantity.conversion(&self.unit) {
            Ok(conversion) => conversion.apply_pair(&quantity.value),
            Err(_) => quantity.si_pair(),
        }
    }
}

fn mismatch(name: &Name, expected: &Unit, found: &Unit) -> ParameterError {
    ParameterError::Dimension {
        name: name.clone(),
        expected: expected.dimension().describe(),
        found: found.dimension().describe(),
    }
}

/// The step as a decimal in the unit of the range; its unit may be left out.
fn step_of(name: &Name, text: &str, range: &Range) -> Result<Decimal, ParameterError> {
    let step = Quantity::parse(text).map_err(ParameterError::Quantity)?;
    if step.unit != range.unit() && !step.unit.is_one() || step.value <= Decimal::ZERO {
        return Err(ParameterError::Step(name.clone()));
    }
    Ok(step.value)
}

impl Diagnose for ParameterError {
    fn code(&self) -> Code {
        match self {
            Self::Quantity(_) => Code::QUANTITY,
            Self::Dimension { .. } => Code::DIMENSION,
            _ => Code::PARAMETER,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let span = match self {
            Self::Quantity(error) => error.span.clone().into(),
            _ => Span::NONE,
        };
        vec![Label {
            span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::Quantity(error) => error.help(),
            Self::NoStep(_) => Some("add `step`, which also fixes the decimals printed".to_owned()),
            Self::TooMany(_) => Some("take a larger step".to_owned()),
            _ => None,
        }
    }
}

impl std::fmt::Display for Domain {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Positive => "positive",
            Self::NonNegative => "zero or positive",
            Self::Any => "any number",
        })
    }
}
