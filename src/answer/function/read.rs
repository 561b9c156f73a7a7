//! Reads a function: with numbers in SI units, with units, or in letters.

use std::cell::Cell;

use super::marker::{Prepared, Response};
use super::slip::without_waves;
use crate::answer::numeric::quantity;
use crate::answer::trial::typed as typed_number;
use crate::answer::{Answered, Reading, Unreadable, Why};
use crate::expr::{Expr, Function, Kind};
use crate::math::Math;
use crate::numerics::Rational;
use crate::response::{
    Folded, FunctionPiece, Lexicon, Manner, Measured, Passage, Reworded, Trouble, Typed,
    TypedError, ValueTrouble,
};
use crate::unit::{DecimalMark, Unit};

/// The function that a response is, with its letters as other statements define them.
pub(crate) fn read(key: &Prepared<'_>, response: Passage<'_>) -> Result<Response, Unreadable> {
    alone(key, response).or_else(|why| defined(key, response).ok_or(why))
}

/// The function of a response whose other statements say what its letters are: `A cos(5 t + φ), A = 0.2, φ = 1.3`.
fn defined(key: &Prepared<'_>, response: Passage<'_>) -> Option<Response> {
    /// More letters than anybody defines: each is read in each of the ways.
    const MAX_OTHERS: usize = 24;
    let setup = &key.setup;
    let has_unit = Cell::new(false);
    let measure = |value: Passage<'_>| {
        let quantity = quantity(value, DecimalMark::Point).ok()?;
        has_unit.set(has_unit.get() || Some(quantity.unit.dimension()) == setup.kind.dimension());
        Rational::from_decimal(&typed_number(quantity.si()))
            .map(|si| Expr::derived(Kind::Number(si)))
    };
    let stated = response
        .stated(|label| setup.labels.is_own(label))
        .ok()
        .filter(|stated| (1..=MAX_OTHERS).contains(&stated.count_of_others()))?
        .measured_by(&measure);
    let formula = |lexicon: &Lexicon| {
        let typed = stated.formula(lexicon, Manner::REAL).ok()?;
        let mut read = bare(key, of_right_dimension(key, typed));
        if has_unit.get() {
            // Then the others are in SI units.
            read.units.truncate(1);
            read.values.truncate(1);
        }
        Some(read)
    };
    let measured = |lexicon| of_measured(key, setup.unit?, stated.measured(lexicon).ok()?).ok();
    // What the response says of all its letters counts, be it otherwise than the question.
    let numbers = &setup.of_numbers;
    let read = formula(numbers).or_else(|| measured(numbers));
    let (read, lexicon) = match read {
        Some(read) => (read, numbers),
        None => (formula(&setup.lexicon)?, &setup.lexicon),
    };
    let forms = stated.other_forms(lexicon, Manner::REAL).into_iter();
    let mut values = forms.map(|form| key.values_of(&of_right_dimension(key, form)));
    let is_it = !adds_angle(key, &read.expr)
        && values.all(|own| own.is_some_and(|values| key.fits(&read.values, &values)));
    is_it.then_some(read)
}

/// The function that a response is: the last form of it that was typed, which the others have to equal.
fn alone(key: &Prepared<'_>, response: Passage<'_>) -> Result<Response, Unreadable> {
    let labels = &key.setup.labels;
    let setup = &key.setup;
    let is_free = setup.lexicon.reads("tau").is_none();
    let renamed = response
        .of_own_variable(&setup.variable)
        .filter(|_| is_free);
    let response = renamed.as_ref().map_or(response, Reworded::passage);
    let pieces = response.function_pieces();
    let (first, others) = match &pieces[..] {
        [] => (response, &[][..]),
        [one] => (labels.asked(one.formula)?, &[][..]),
        [first, ..] => (first.formula, &pieces[1..]),
    };
    let (last, forms) = labels.forms(first)?;
    let mut read = function(key, last)?;
    if let (Some(FunctionPiece { condition, .. }), false) = (pieces.first(), others.is_empty()) {
        read = by_pieces(key, read, *condition, others)?;
    }
    if let [
        FunctionPiece {
            condition: Some(condition),
            ..
        },
    ] = &pieces[..]
        && is_mostly_excluded(key, *condition)
    {
        return Err(Unreadable::at(*condition, Why::OutsideOfSpan));
    }
    let is_same = |form: &Expr| {
        let values = key.values_of(form);
        values.is_some_and(|values| key.fits(&read.values, &values))
    };
    if !forms.iter().all(is_same) {
        read.contradiction = Some(Why::UnequalFunctions(last.into()).into());
    }
    Ok(read)
}

/// Whether a condition excludes more than half of the span, `t < 0`; a bound that is rounded excludes less, and what
/// is said of anything else but the variable excludes nothing.
fn is_mostly_excluded(key: &Prepared<'_>, condition: Passage<'_>) -> bool {
    let excluded = || {
        let holds = condition
            .comparison(&key.setup.lexicon, Manner::REAL)
            .ok()?;
        let marked = Kind::If(holds, Expr::number(1), Expr::number(0));
        let values = key.values_of(&Expr::derived(marked))?;
        let excluded = values.iter().filter(|value| **value == 0.0).count();
        Some(2 * excluded > values.len())
    };
    excluded().unwrap_or(false)
}

/// The function that is each of the pieces where its condition holds, the last one everywhere else.
fn by_pieces(
    key: &Prepared<'_>,
    first: Response,
    holds: Option<Passage<'_>>,
    others: &[FunctionPiece<'_>],
) -> Result<Response, Unreadable> {
    let lexicon = &key.setup.lexicon;
    let Some((next, rest)) = others.split_first() else {
        return Ok(first);
    };
    let otherwise = function(key, next.formula)?;
    let otherwise = by_pieces(key, otherwise, next.condition, rest)?;
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
        .map_err(|error| Unreadable::typed(&error, condition))?;
    let expr = Expr::derived(Kind::If(holds, first.expr, otherwise.expr));
    Ok(Response {
        reading: Reading {
            math: expr.typeset(lexicon),
            text: expr.to_string(),
            answered: Answered::Function(expr.clone(), None),
        },
        values: key.values_in(&expr, &first.units).unwrap_or_default(),
        units: first.units,
        expr,
        others: Vec::new(),
        contradiction: None,
    })
}

/// A formula of real numbers, or one of complex numbers that is real: `Re(A e^(iωt))`, a sum of conjugate ones.
fn of_real_numbers(key: &Prepared<'_>, typed: Passage<'_>) -> Result<Typed<Expr>, TypedError> {
    let lexicon = &key.setup.lexicon;
    let read = typed.formula(lexicon, Manner::REAL);
    if read.is_ok() || !typed.may_be_complex() {
        return read;
    }
    let complex = typed.formula(lexicon, Manner::COMPLEX).ok();
    let real = complex.and_then(|typed| with_real_values(key, typed.value));
    real.map_or(read, |value| {
        Ok(Typed {
            value,
            others: Vec::new(),
        })
    })
}

/// A formula with the imaginary unit in it as one of real values, if it has such.
fn with_real_values(key: &Prepared<'_>, expr: Expr) -> Option<Expr> {
    // What a sum of conjugate terms leaves of its imaginary part in binary64 stays far below this.
    const ROUNDING: f64 = 1e-9;
    if key.values_of(&expr).is_some() {
        return Some(expr);
    }
    let part = |function| Expr::derived(Kind::Call(function, vec![expr.clone()]));
    let real = part(Function::Re);
    let (own, rest) = (key.values_of(&real)?, key.values_of(&part(Function::Im))?);
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    (largest(&rest) <= ROUNDING * largest(&own)).then_some(real)
}

/// Whether letters are names or units is decided by the dimension, not by what is right.
fn function(key: &Prepared<'_>, typed: Passage<'_>) -> Result<Response, Unreadable> {
    match of_real_numbers(key, typed) {
        Err(error) => with_unit(key, typed)
            .or_else(|| with_rates(key, typed).map(Ok))
            .unwrap_or_else(|| Err(Unreadable::typed(&error, typed))),
        Ok(read) => {
            let all = read.clone();
            let expr = of_right_dimension(key, read);
            // A function of numbers is read with its units only where its letters may be some.
            let as_printed = || {
                let printed = expr.to_string();
                let printed = Folded::of(&printed).ok()?;
                (!has_dimension(key, &expr)).then(|| with_unit(key, printed.passage()))?
            };
            // `0.5 mcos(5t)` parts its letters when it is printed.
            let with_unit = || with_unit(key, typed).or_else(as_printed);
            let unit = key.has_data(&expr).then(with_unit).flatten();
            // Of `0.5 cos 2t m` nobody means a mass beside the number in the argument.
            let is_of_waves = || !key.has_data(&without_waves(&expr));
            match unit {
                Some(Ok(read)) if is_of_waves() && !read.units.contains(&Unit::ONE) => Ok(read),
                Some(Ok(_)) if has_dimension(key, &expr) => Err(Why::UnitOrQuantity.into()),
                Some(read) if !has_dimension(key, &expr) => read,
                _ if adds_angle(key, &expr) => Err(Why::AngleAdded.into()),
                _ => Ok(Response {
                    others: other_readings(key, all, &expr),
                    ..bare(key, expr)
                }),
            }
        }
    }
}

/// The readings of a text beside the one that was taken which make as much sense as it does.
fn other_readings(key: &Prepared<'_>, typed: Typed<Expr>, taken: &Expr) -> Vec<Expr> {
    let is_sound = makes_sense(key, taken);
    let all = [typed.value].into_iter().chain(typed.others);
    let fitting = all.filter(|expr| {
        expr != taken
            && key.dimension_trouble(expr).is_none()
            && fits_in_steps(key, expr)
            && (!is_sound || makes_sense(key, expr))
    });
    fitting.collect()
}

/// Whether a formula in letters of the question has the dimension of the key, down to what stands in its waves.
fn makes_sense(key: &Prepared<'_>, expr: &Expr) -> bool {
    let found = expr.check(&key.setup.meaning).ok();
    let dimension = found.and_then(|kind| kind.dimension());
    key.has_data(expr) && dimension.is_some() && dimension == key.setup.kind.dimension()
}

/// Where a text leaves several readings, the one of the right dimension.
fn of_right_dimension(key: &Prepared<'_>, typed: Typed<Expr>) -> Expr {
    // `q0 cos t/√(LC)` makes sense in one way only.
    if !makes_sense(key, &typed.value)
        && let Some(other) = typed.others.iter().find(|other| makes_sense(key, other))
    {
        return other.clone();
    }
    // Where numbers stand for data, steps may go against the dimensions; that speaks for no other reading.
    let Typed { value, mut others } = typed;
    others.retain(|other| fits_in_steps(key, other));
    Typed { value, others }.fitting(|expr| key.dimension_trouble(expr).is_none())
}

/// Whether no step of a formula with letters of the question goes against the dimensions.
fn fits_in_steps(key: &Prepared<'_>, expr: &Expr) -> bool {
    !key.has_data(expr) || expr.check(&key.setup.meaning).is_ok()
}

/// Numbers without data beside them may be in the unit that is asked for.
pub(crate) fn bare(key: &Prepared<'_>, expr: Expr) -> Response {
    let setup = &key.setup;
    let shown = setup.unit.filter(|_| !key.has_data(&without_waves(&expr)));
    let units: Vec<Unit> = [Unit::ONE].into_iter().chain(shown).collect();
    Response {
        reading: Reading {
            math: expr.typeset(&setup.lexicon),
            text: expr.to_string(),
            answered: Answered::Function(expr.clone(), None),
        },
        values: key.values_in(&expr, &units).unwrap_or_default(),
        units,
        expr,
        others: Vec::new(),
        contradiction: None,
    }
}

/// A function of numbers with a unit, after each of its terms or after the whole, or in its arguments alone.
fn with_unit(key: &Prepared<'_>, typed: Passage<'_>) -> Option<Result<Response, Unreadable>> {
    let setup = &key.setup;
    let own = setup.unit?;
    // Letters of the question in its waves do not matter: `13.5 mJ sin²(ω t)`.
    let of_letters = || {
        let read = measured(key, typed, &setup.lexicon).ok()?;
        let is_of_numbers = !key.has_data(&without_waves(&read.value.formula));
        (is_of_numbers && read.value.unit.is_some()).then_some(read)
    };
    let read = measured(key, typed, &setup.of_numbers);
    let read = match read.or_else(|error| of_letters().ok_or(error)) {
        Ok(read) => read,
        Err(error) => {
            let has_no_common = matches!(
                error.trouble,
                Trouble::Value(ValueTrouble::UnitOfOne | ValueTrouble::Units)
            );
            if error.trouble == Trouble::Value(ValueTrouble::UnitOfArgument) {
                return Some(Err(Why::UnitOfArgument.into()));
            }
            return has_no_common.then(|| Err(Why::UnitOfTerms.into()));
        }
    };
    Some(of_measured(key, own, read))
}

/// A function of numbers with units, the unit of which has to be like the one that is asked.
fn of_measured(
    key: &Prepared<'_>,
    own: Unit,
    read: Typed<Measured>,
) -> Result<Response, Unreadable> {
    let setup = &key.setup;
    let is_own = |unit: &Unit| unit.dimension() == own.dimension();
    let Measured { formula, unit } = read.fitting(|own| own.unit.as_ref().is_none_or(is_own));
    let Some(unit) = unit else {
        return Ok(bare(key, formula));
    };
    if !is_own(&unit) {
        return Err(Why::UnitOfFunction(own).into());
    }
    let units = vec![unit];
    Ok(Response {
        reading: Reading {
            math: Math::row([
                formula.typeset(&setup.lexicon),
                Math::thin_space(),
                unit.math(),
            ]),
            text: format!("({formula}) {}", unit.text()),
            answered: Answered::Function(formula.clone(), Some(unit)),
        },
        values: key.values_in(&formula, &units).unwrap_or_default(),
        units,
        expr: formula,
        others: Vec::new(),
        contradiction: None,
    })
}

/// A function in letters with units in its arguments, `x0 e^(-0.75 s⁻¹ t)`.
fn with_rates(key: &Prepared<'_>, typed: Passage<'_>) -> Option<Response> {
    let read = measured(key, typed, &key.setup.lexicon).ok()?;
    let is_bare = read.value.unit.is_none();
    is_bare.then(|| bare(key, read.value.formula))
}

/// The function with units that a passage is, if it has real values.
fn measured(
    key: &Prepared<'_>,
    typed: Passage<'_>,
    lexicon: &Lexicon,
) -> Result<Typed<Measured>, TypedError> {
    let real = typed.measured(lexicon, false);
    if real.is_ok() || !typed.may_be_complex() {
        return real;
    }
    let complex = typed.measured(lexicon, true).ok();
    let value = complex.and_then(|typed| {
        let Measured { formula, unit } = typed.value;
        let formula = with_real_values(key, formula)?;
        Some(Measured { formula, unit })
    });
    value.map_or(real, |value| {
        Ok(Typed {
            value,
            others: Vec::new(),
        })
    })
}

/// Whether a function with letters can have the dimension of the key, apart from what stands in its waves.
fn has_dimension(key: &Prepared<'_>, expr: &Expr) -> bool {
    let found = without_waves(expr).check(&key.setup.meaning).ok();
    let dimension = found.and_then(|kind| kind.dimension());
    dimension.is_some_and(|found| found.is_pure() || Some(found) == key.setup.kind.dimension())
}

/// Whether degrees are added to what is not an angle: `cos 5 t + 30°`.
fn adds_angle(key: &Prepared<'_>, expr: &Expr) -> bool {
    let mut has_degrees = false;
    without_waves(expr).walk(&mut |node| {
        has_degrees |= matches!(node.kind(), Kind::Measure(..));
    });
    let key = key.setup.kind.dimension();
    has_degrees && key.is_some_and(|dimension| !dimension.is_pure())
}
