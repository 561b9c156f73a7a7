//! Reads a function: with numbers in SI units, with units, or in letters.

use super::marker::{Prepared, Response};
use super::slip::without_waves;
use super::units::{contains_letter, measured, without_rates, without_words};
use crate::answer::{Answered, Reading, Unreadable, Why};
use crate::expr::{Expr, Function, Kind};
use crate::math::Math;
use crate::response::{self, FunctionPiece, Manner, Side, Typed, TypedError, function_pieces};
use crate::unit::Unit;

impl Prepared<'_> {
    /// The function that a response is: the last form of it that was typed, which the others have to equal.
    pub(crate) fn read(&self, response: &str) -> Result<Response, Unreadable> {
        let labels = &self.setup.labels;
        let renamed = self.of_own_variable(response);
        let response = renamed.as_deref().unwrap_or(response);
        let pieces = function_pieces(response);
        let (first, others) = match &pieces[..] {
            [] => (response, &[][..]),
            [one] => (labels.asked(one.formula.typed())?, &[][..]),
            [first, ..] => (first.formula.typed(), &pieces[1..]),
        };
        let (last, forms) = labels.forms(first)?;
        let mut read = self.function(last.trim())?;
        if let (Some(FunctionPiece { condition, .. }), false) = (pieces.first(), others.is_empty())
        {
            read = self.by_pieces(read, *condition, others)?;
        }
        if let [
            FunctionPiece {
                condition: Some(condition),
                ..
            },
        ] = &pieces[..]
            && self.is_mostly_excluded(*condition)
        {
            return Err(Unreadable::at(condition.typed(), Why::OutsideOfSpan));
        }
        for form in &forms {
            let same = self
                .values_of(form)
                .is_some_and(|values| self.fits(&read.values, &values));
            if !same {
                return Err(Why::UnequalFunctions(last.trim().to_owned()).into());
            }
        }
        Ok(read)
    }

    /// A function of another name for the time, `x(τ) = … τ …`, with its own name for it.
    fn of_own_variable(&self, response: &str) -> Option<String> {
        const OTHERS: [&str; 3] = ["\\tau", "tau", "τ"];
        let setup = &self.setup;
        let (label, formula) = response.split_once('=')?;
        let (_, argument) = label.trim().strip_suffix(')')?.split_once('(')?;
        let other = OTHERS.iter().find(|other| **other == argument.trim())?;
        let variable = setup.variable.as_str();
        let is_free = setup.lexicon.reads("tau").is_none() && !contains_letter(formula, variable);
        (is_free && formula.contains(other)).then(|| response.replace(other, variable))
    }

    /// Whether a condition excludes more than half of the span, `t < 0`; a bound that is rounded excludes less, and what
    /// is said of anything else but the variable excludes nothing.
    fn is_mostly_excluded(&self, condition: Side<'_>) -> bool {
        let excluded = || {
            let holds = condition
                .comparison(&self.setup.lexicon, Manner::REAL)
                .ok()?;
            let marked = Kind::If(holds, Expr::number(1), Expr::number(0));
            let values = self.values_of(&Expr::derived(marked))?;
            let excluded = values.iter().filter(|value| **value == 0.0).count();
            Some(2 * excluded > values.len())
        };
        excluded().unwrap_or(false)
    }

    /// The function that is each of the pieces where its condition holds, the last one everywhere else.
    fn by_pieces(
        &self,
        first: Response,
        holds: Option<Side<'_>>,
        others: &[FunctionPiece<'_>],
    ) -> Result<Response, Unreadable> {
        let lexicon = &self.setup.lexicon;
        let Some((next, rest)) = others.split_first() else {
            return Ok(first);
        };
        let otherwise = self.function(next.formula.typed())?;
        let otherwise = self.by_pieces(otherwise, next.condition, rest)?;
        let are_alike = first.units.len() == otherwise.units.len()
            && first
                .units
                .iter()
                .zip(&otherwise.units)
                .all(|(own, other)| own.to_si(1.0).total_cmp(&other.to_si(1.0)).is_eq());
        if !are_alike {
            return Err(Why::UnitOfTerms.into());
        }
        let condition = holds.unwrap_or_default();
        let holds = condition
            .comparison(lexicon, Manner::REAL)
            .map_err(|error| Unreadable::typed(&error, condition.typed()))?;
        let expr = Expr::derived(Kind::If(holds, first.expr, otherwise.expr));
        Ok(Response {
            reading: Reading {
                math: expr.typeset(lexicon),
                text: expr.to_string(),
                answered: Answered::Function(expr.clone(), None),
            },
            values: self.values_in(&expr, &first.units).unwrap_or_default(),
            units: first.units,
            expr,
        })
    }

    /// A formula of real numbers, or one of complex numbers that is real: `Re(A e^(iωt))`, a sum of conjugate ones.
    fn formula(&self, text: &str) -> Result<Typed<Expr>, TypedError> {
        let lexicon = &self.setup.lexicon;
        let read = response::formula(text, lexicon, Manner::REAL);
        if read.is_ok() || !text.contains(['i', 'j', 'I']) {
            return read;
        }
        let complex = response::formula(text, lexicon, Manner::COMPLEX).ok();
        let real = complex.and_then(|typed| self.real(typed.value));
        real.map_or(read, |value| {
            Ok(Typed {
                value,
                others: Vec::new(),
            })
        })
    }

    /// A formula with the imaginary unit in it as one of real values, if it has such.
    fn real(&self, expr: Expr) -> Option<Expr> {
        // What a sum of conjugate terms leaves of its imaginary part in binary64 stays far below this.
        const ROUNDING: f64 = 1e-9;
        if self.values_of(&expr).is_some() {
            return Some(expr);
        }
        let part = |function| Expr::derived(Kind::Call(function, vec![expr.clone()]));
        let real = part(Function::Re);
        let (own, rest) = (self.values_of(&real)?, self.values_of(&part(Function::Im))?);
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        (largest(&rest) <= ROUNDING * largest(&own)).then_some(real)
    }

    /// Whether letters are names or units is decided by the dimension, not by what is right.
    fn function(&self, text: &str) -> Result<Response, Unreadable> {
        let setup = &self.setup;
        let plain = without_words(text);
        let text = plain.as_deref().unwrap_or(text);
        let has_seconds = setup.lexicon.reads("s").is_none();
        let bare = has_seconds.then(|| without_rates(text, setup.variable.as_str()));
        let text = bare.as_ref().and_then(Option::as_deref).unwrap_or(text);
        match self.formula(text) {
            Err(error) => self
                .with_unit(text)
                .unwrap_or_else(|| Err(Unreadable::typed(&error, text))),
            Ok(typed) => {
                let expr = self.of_right_dimension(typed);
                let unit = self.with_unit(text).filter(|_| self.has_data(&expr));
                match unit {
                    Some(Ok(_)) if self.has_dimension(&expr) => Err(Why::UnitOrQuantity.into()),
                    Some(read) if !self.has_dimension(&expr) => read,
                    _ if self.adds_angle(&expr) => Err(Why::AngleAdded.into()),
                    _ => Ok(self.bare(expr)),
                }
            }
        }
    }

    /// Where a text leaves several readings, the one of the right dimension.
    fn of_right_dimension(&self, typed: Typed<Expr>) -> Expr {
        typed.fitting(|expr| self.dimension_trouble(expr).is_none())
    }

    /// Numbers without data may be in the unit that is asked for.
    fn bare(&self, expr: Expr) -> Response {
        let setup = &self.setup;
        let shown = setup.unit.filter(|_| !self.has_data(&expr));
        let units: Vec<Unit> = [Unit::ONE].into_iter().chain(shown).collect();
        Response {
            reading: Reading {
                math: expr.typeset(&setup.lexicon),
                text: expr.to_string(),
                answered: Answered::Function(expr.clone(), None),
            },
            values: self.values_in(&expr, &units).unwrap_or_default(),
            units,
            expr,
        }
    }

    /// A function of numbers with a unit, after each of its terms or after the whole.
    fn with_unit(&self, text: &str) -> Option<Result<Response, Unreadable>> {
        let setup = &self.setup;
        let own = setup.unit?;
        let variable = setup.variable.as_str();
        let bare = |text: &str| {
            let typed = self.formula(text).ok()?;
            (!self.has_data(&typed.value)).then_some(typed.value)
        };
        let terms = measured(text, variable, |unit| unit.dimension() == own.dimension());
        let has_some = terms.is_some();
        let by_terms = terms.and_then(|found| {
            let (once, twice) = (bare(&found.bare)?, bare(&found.doubled)?);
            let (values, doubled) = (self.values_of(&once)?, self.values_of(&twice)?);
            let mut pairs = values.iter().zip(&doubled);
            // With all units doubled the function doubles only if each of its terms has one.
            let is_whole = pairs.all(|(value, doubled)| {
                (2.0 * value - doubled).abs() <= 1e-9 * doubled.abs().max(value.abs())
            });
            is_whole.then_some((once, found.unit))
        });
        let found = by_terms.or_else(|| {
            let mut cuts = response::with_unit(text)
                .filter(|(formula, _)| !contains_letter(&text[formula.len()..], variable));
            cuts.find_map(|(formula, unit)| Some((bare(formula)?, unit)))
        });
        let Some((expr, unit)) = found else {
            return has_some.then(|| Err(Why::UnitOfTerms.into()));
        };
        if unit.dimension() != own.dimension() {
            return Some(Err(Why::UnitOfFunction(own).into()));
        }
        let units = vec![unit];
        Some(Ok(Response {
            reading: Reading {
                math: Math::row([
                    expr.typeset(&setup.lexicon),
                    Math::thin_space(),
                    unit.math(),
                ]),
                text: format!("({expr}) {}", unit.text()),
                answered: Answered::Function(expr.clone(), Some(unit)),
            },
            values: self.values_in(&expr, &units).unwrap_or_default(),
            units,
            expr,
        }))
    }

    /// Whether a function with letters can have the dimension of the key, apart from what stands in its waves.
    fn has_dimension(&self, expr: &Expr) -> bool {
        let found = without_waves(expr).check(&self.setup.meaning).ok();
        let dimension = found.and_then(|kind| kind.dimension());
        dimension.is_some_and(|found| found.is_pure() || Some(found) == self.setup.kind.dimension())
    }

    /// Whether degrees are added to what is not an angle: `cos 5 t + 30°`.
    fn adds_angle(&self, expr: &Expr) -> bool {
        let mut has_degrees = false;
        without_waves(expr).walk(&mut |node| {
            has_degrees |= matches!(node.kind(), Kind::Measure(..));
        });
        let key = self.setup.kind.dimension();
        has_degrees && key.is_some_and(|dimension| !dimension.is_pure())
    }
}
