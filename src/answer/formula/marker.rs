//! Reads formulas, and marks them: by their dimension, then by their values.

use std::sync::Arc;

use super::Setup;
use super::slip::slip;
use super::solved::solved;
use super::values::has_values;
use crate::answer::equality::{Comparable, Comparison, Condition, Points};
use crate::answer::recalled::Recalled;
use crate::answer::rounded::{rounding, settle_rounded, with_fractions};
use crate::answer::settle::{Candidate, settle_by_rule};
use crate::answer::{
    Answered, Close, Credit, Doubt, Echo, Key, Marker, Marking, Misfit, Nature, Note, Reading,
    Reason, Remark, Slip, Trial, Unreadable, Verdict, Why,
};
use crate::expr::{Expr, Field, Substitution};
use crate::math::symbol;
use crate::numerics::SortedMap;
use crate::response::{
    BeforeUnit, E_FOR_EPSILON, L_FOR_ELL, Manner, Passage, Stated, Trouble, Typed, TypedError,
};
use crate::unit::{DecimalMark, Unit};

/// A prepared key.
pub(crate) struct Prepared {
    pub(crate) setup: Arc<Setup>,
    pub(crate) key: Arc<Comparable>,
    pub(crate) points: Arc<Points>,
    pub(crate) mistakes: Vec<Mistake>,
    pub(crate) recalled: Option<Arc<Recalled>>,
    /// The data of the instance, by input.
    pub(crate) data: Vec<Option<f64>>,
    pub(crate) mark: DecimalMark,
    pub(crate) doubt: Doubt,
}

pub(crate) struct Mistake {
    pub(crate) number: usize,
    pub(crate) formula: Arc<Comparable>,
    pub(crate) credit: Credit,
}

/// A reading of a response.
struct Read {
    expr: Expr,
    /// What is wrong with its dimension.
    misfit: Option<Misfit>,
}

impl Prepared {
    /// The marking of a formula alone, without a unit after it.
    fn mark_alone(&self, response: Passage<'_>) -> Result<Marking, TypedError> {
        let mut readings = self.readings(response)?.into_iter();
        let Some(first) = readings.next() else {
            return Ok(Marking::unreadable(Why::Incomparable));
        };
        let is_number = first.expr.names().free.is_empty() && !first.expr.is_zero();
        let is_number = is_number || first.misfit.is_some() && self.is_number(response);
        if self.has_names() && is_number {
            return Ok(Marking::unreadable(Why::FormulaNotNumber));
        }
        let candidate = |read: Read| Candidate {
            shown: self.setup.lexicon.written(&read.expr),
            marking: self.judged(&read),
        };
        let written = || self.setup.lexicon.written(&first.expr);
        let marking = self.judged(&first);
        let mut marking = settle_by_rule(self.doubt, marking, written, readings.map(candidate));
        if is_rounded(&marking) {
            if let Some(right) = self.before_rounding(response) {
                return Ok(right);
            }
            if !self.contradicts_itself(response) {
                marking = self.settle_rounded(&first).unwrap_or(marking);
            }
        }
        Ok(match (marking.verdict, &marking.reading) {
            (Verdict::Right, Some(reading)) if self.contradicts_itself(response) => {
                Marking::wrong(reading.clone(), Remark::from(Slip::UnequalSides))
            }
            _ => marking,
        })
    }

    /// The marking of a formula that is the key but for the rounding of its numbers: `0.0833 M l²`, `0.765 √(k/m)`.
    fn settle_rounded(&self, Read { expr, misfit }: &Read) -> Option<Marking> {
        let rounding = rounding(expr)?;
        let typed = self.comparable(expr)?;
        let is_factor = matches!(
            self.points.compare(&self.key, &typed),
            Comparison::Different { ratio: Some(ratio), .. } if (ratio - 1.0).abs() <= rounding
        );
        let is_key = |expr: &Expr| {
            let exact = self.comparable(expr);
            exact.is_some_and(|exact| self.points.compare(&self.key, &exact) == Comparison::Same)
        };
        let exact = || with_fractions(std::slice::from_ref(expr));
        let is_right = misfit.is_none()
            && (is_factor || exact().is_some_and(|exact| exact.iter().all(is_key)));
        is_right.then(|| settle_rounded(self.doubt, rounding, Marking::right(self.reading(expr))))
    }

    /// The marking of a formula before its form with rounded numbers, `√(2k/m) ≈ 1.414 √(k/m)`, if it is right and all
    /// other sides are the same or its rounded forms.
    fn before_rounding(&self, response: Passage<'_>) -> Option<Marking> {
        let sides = response.sides(&self.setup.lexicon).ok()?;
        let (_, before) = sides.split_last()?;
        let mut right = None;
        for side in before {
            let read = self.readings(*side).ok()?.into_iter();
            let mut marked = read.map(|read| self.judged(&read));
            let marking =
                marked.find(|marking| marking.verdict == Verdict::Right || is_rounded(marking))?;
            if marking.verdict == Verdict::Right {
                right = Some(marking);
            }
        }
        right
    }

    /// The marking of a statement that begins with steps in letters of one's own, if it is right.
    fn right_behind_steps(&self, response: Passage<'_>) -> Option<Marking> {
        let typed = self.behind_own_steps(response)?;
        self.right_of([typed.value].into_iter().chain(typed.others))
    }

    /// The marking of the last of several statements, if it is right and none of them is named as what is asked:
    /// `F = k x, m g = k x, x = m g/k`.
    fn right_in_last(&self, response: Passage<'_>) -> Option<Marking> {
        let stated = self.stated(response).ok()?;
        let is_asked = |label| self.setup.naming.is_of_asked(label);
        let last = stated.last_of_others()?;
        if stated.label().is_some_and(is_asked) || self.setup.naming.check(last).is_err() {
            return None;
        }
        let marking = self.mark_alone(last).ok()?;
        (marking.verdict == Verdict::Right).then_some(marking)
    }

    /// The marking of a formula with a letter for another one that it is alike, `L` for the length ℓ where the item has
    /// another L, if it is right.
    fn right_with(&self, custom: [&str; 2], response: Passage<'_>) -> Option<Marking> {
        let lexicon = &self.setup.lexicon;
        let [other, meant] = lexicon.stand_in(custom)?;
        let put = Substitution::new().with(other.clone(), Expr::name(meant));
        let stated = self.stated(response).ok()?;
        let lexicon = lexicon.with(&other, symbol(other.as_str()));
        let typed = stated.formula(&lexicon, self.manner()).ok()?;
        let all = [typed.value].into_iter().chain(typed.others);
        let all = all.filter(|expr| expr.names().uses(&other));
        self.right_of(all.filter_map(|expr| put.apply(&expr).ok()))
    }

    /// The marking of a statement of a multiple, the square or the reciprocal of what is asked, `2λ = c/m`, `ω_n² = k/m`,
    /// `1/k = 1/k1 + 1/k2`, if what is asked follows right from it.
    fn right_if_solved(&self, response: Passage<'_>) -> Option<Marking> {
        let naming = &self.setup.naming;
        let stated = self.stated(response).ok()?;
        let pieces = stated.pieces();
        let [first, last] = pieces[..] else {
            return None;
        };
        let left = naming.letters(first)?;
        let typed = last.formula(&self.setup.lexicon, self.manner()).ok()?;
        let all = [typed.value].into_iter().chain(typed.others);
        let solved = all.filter_map(|right| solved(&left, right, &|name| naming.is_asked(name)));
        self.right_of(solved)
    }

    /// The marking of the first of these formulas that is right.
    fn right_of(&self, mut all: impl Iterator<Item = Expr>) -> Option<Marking> {
        all.find_map(|expr| {
            let read = Read {
                misfit: self.misfit(&expr),
                expr,
            };
            Some(self.judged(&read)).filter(|marking| marking.verdict == Verdict::Right)
        })
    }

    /// The readings of a formula, the conventional one first: those of the right dimension, if one has it.
    fn readings(&self, response: Passage<'_>) -> Result<Vec<Read>, TypedError> {
        Ok(self.readings_of(self.read(response)?))
    }

    fn readings_of(&self, typed: Typed<Expr>) -> Vec<Read> {
        let all = [typed.value].into_iter().chain(typed.others);
        let mut all: Vec<Read> = all
            .map(|expr| Read {
                misfit: self.misfit(&expr),
                expr,
            })
            .collect();
        if all.iter().any(|read| read.misfit.is_none()) {
            all.retain(|read| read.misfit.is_none());
        } else {
            all.truncate(1);
        }
        all
    }

    fn reading(&self, expr: &Expr) -> Reading {
        Reading {
            math: expr.typeset(&self.setup.lexicon),
            text: expr.to_string(),
            answered: Answered::Formula(expr.clone()),
        }
    }

    /// The marking of a reading by what it comes to.
    fn judged(&self, Read { expr, misfit }: &Read) -> Marking {
        let setup = &self.setup;
        let reading = self.reading(expr);
        let Some(typed) = self.comparable(expr) else {
            return Marking::unreadable(Why::Incomparable);
        };
        // Steps may go against the dimensions where the whole does not: `ln(x0) - ln(x1)`.
        let is_of_dimension = misfit.is_none() || expr.check(&setup.meaning).is_err();
        let comparison = if is_of_dimension {
            self.points.compare(&self.key, &typed)
        } else {
            Comparison::Undefined
        };
        if comparison == Comparison::Same {
            let remark = misfit.clone().map(|misfit| Note::RightBut(misfit).into());
            return Marking::read(reading, Credit::FULL, remark);
        }
        if let Some(mistake) = self.mistake(&typed) {
            return Marking::mistake(reading, mistake.number, mistake.credit);
        }
        if let Some(misfit) = misfit {
            if has_values(self, expr, &typed) {
                return Marking::unreadable(Why::ValuesForLetters);
            }
            return Marking::wrong(reading, Remark::from(misfit.clone()));
        }
        if comparison == Comparison::Undecided {
            return Marking::unreadable(Why::DigitsLost);
        }
        let slip = slip(&comparison, expr, setup.kind.dimension());
        Marking::wrong(reading, slip.map(Remark::from))
    }

    fn comparable(&self, expr: &Expr) -> Option<Comparable> {
        Comparable::of(&self.setup.meaning, expr, &SortedMap::new()).ok()
    }

    /// The named mistake that a formula is.
    fn mistake(&self, typed: &Comparable) -> Option<&Mistake> {
        let is_it =
            |mistake: &&Mistake| self.points.compare(&mistake.formula, typed) == Comparison::Same;
        self.mistakes.iter().find(is_it)
    }

    /// Whether another side of the equals signs is a formula that is not the same as the last one.
    fn contradicts_itself(&self, response: Passage<'_>) -> bool {
        self.other_forms(response).into_iter().any(|typed| {
            let mut readings = [typed.value].into_iter().chain(typed.others);
            readings.all(|expr| {
                let other = self.comparable(&expr);
                other
                    .is_some_and(|other| self.points.compare(&self.key, &other) != Comparison::Same)
            })
        })
    }

    /// The readings of a formula. Where all is real, the imaginary unit may stand in what comes out real, `|1 + iζ|`.
    fn read(&self, response: Passage<'_>) -> Result<Typed<Expr>, TypedError> {
        self.read_where(response, &|forms| self.are_same(forms))
    }

    /// The same, of several sides that stand for themselves where these are `alike`.
    fn read_where(
        &self,
        response: Passage<'_>,
        alike: &dyn Fn(&[Expr]) -> bool,
    ) -> Result<Typed<Expr>, TypedError> {
        let stated = self.stated(response)?;
        self.in_manner(|manner| {
            let formula = stated.formula(&self.setup.lexicon, manner);
            match formula {
                // `½ I θ'² = ½ m l² θ'²`, each side of which is the answer.
                Err(error) if error.trouble == Trouble::Unsolved => {
                    self.last_form(&stated, manner, alike).ok_or(error)
                }
                formula => formula,
            }
        })
    }

    /// The statements of a response.
    fn stated<'t>(&self, response: Passage<'t>) -> Result<Stated<'t>, TypedError> {
        response.stated(|label| self.setup.naming.is_of_asked(label))
    }

    /// The other sides of the equals signs of a response, each in its readings. A letter that the item has in the other
    /// case alone is another one: `4π² m/T²` where it has t.
    fn other_forms(&self, response: Passage<'_>) -> Vec<Typed<Expr>> {
        let manner = Manner {
            is_in_any_case: false,
            ..self.manner()
        };
        let stated = self.stated(response);
        stated.map_or_else(
            |_| Vec::new(),
            |stated| stated.other_forms(&self.setup.lexicon, manner),
        )
    }

    /// The last of the sides of a statement without a symbol, if all of them have the dimension that is asked and are
    /// `alike`.
    fn last_form(
        &self,
        stated: &Stated<'_>,
        manner: Manner,
        alike: &dyn Fn(&[Expr]) -> bool,
    ) -> Option<Typed<Expr>> {
        let forms = stated.all_forms(&self.setup.lexicon, manner).ok()?;
        let fits = |expr: &Expr| self.misfit(expr).is_none();
        let forms: Vec<Expr> = forms.into_iter().map(|form| form.fitting(fits)).collect();
        let last = forms
            .last()
            .filter(|_| forms.iter().all(fits) && alike(&forms))?;
        Some(Typed {
            value: last.clone(),
            others: Vec::new(),
        })
    }

    /// Whether all of some formulas are the same.
    fn are_same(&self, forms: &[Expr]) -> bool {
        let mut all = forms.iter().map(|form| self.comparable(form));
        let Some(Some(first)) = all.next() else {
            return false;
        };
        all.all(|own| own.is_some_and(|own| self.points.compare(&first, &own) == Comparison::Same))
    }

    /// The last side of a statement that begins with steps in letters of one's own, `F_R/k = μ m g/k`; none of them is
    /// what is asked, as in `ω² = k/m`.
    fn behind_own_steps(&self, response: Passage<'_>) -> Option<Typed<Expr>> {
        let stated = self.stated(response).ok()?;
        let pieces = stated.pieces();
        let (last, steps) = pieces.split_last()?;
        let read = |side: &Passage<'_>| side.formula(&self.setup.lexicon, self.manner());
        let has_asked = |side: &Passage<'_>| self.setup.naming.may_have_asked(*side);
        let last = read(last).ok()?;
        let is_same = |own: Typed<Expr>| self.are_same(&[own.value, last.value.clone()]);
        // `m + I/R^2 = m + m/2 = 3m/2`: the answer itself is no multiple of what is asked.
        let is_of_asked = |side: &Passage<'_>| has_asked(side) && !read(side).is_ok_and(is_same);
        let is_in_own_letters = read(steps.first()?).is_err();
        (is_in_own_letters && !steps.iter().any(is_of_asked)).then_some(last)
    }

    /// What is read in the manner of the key.
    fn in_manner(
        &self,
        read: impl Fn(Manner) -> Result<Typed<Expr>, TypedError>,
    ) -> Result<Typed<Expr>, TypedError> {
        let own = self.manner();
        match read(own) {
            Err(error) if !own.has_imaginary_unit => {
                let real = read(Manner::COMPLEX).ok().filter(|typed| {
                    let found = typed.value.check(&self.setup.meaning);
                    found.is_ok_and(|found| found.field() == Field::Real)
                });
                real.ok_or(error)
            }
            read => read,
        }
    }

    /// The manner in which the key and its mistakes are written.
    fn manner(&self) -> Manner {
        let is_complex = self.setup.kind.field() == Field::Complex
            || self
                .mistakes
                .iter()
                .any(|mistake| mistake.formula.is_complex());
        let manner = if is_complex {
            Manner::COMPLEX
        } else {
            Manner::REAL
        };
        manner.in_any_case()
    }

    /// Whether names stand in the key.
    fn has_names(&self) -> bool {
        !self.setup.shown.names().free.is_empty()
    }

    /// What is wrong with the dimension of a formula.
    fn misfit(&self, typed: &Expr) -> Option<Misfit> {
        let setup = &self.setup;
        let found = match typed.check(&setup.meaning) {
            Err(errors) => {
                return Some(Misfit::Step {
                    entry: None,
                    error: errors.first().cloned(),
                });
            }
            Ok(found) => found,
        };
        let fits = match (setup.kind.dimension(), found.dimension()) {
            (Some(key), Some(typed)) => key == typed,
            _ => true,
        };
        let found = found.dimension().filter(|_| !fits)?;
        Some(Misfit::Comes {
            entry: None,
            found,
            unit: self.unit(),
            asked: setup.kind.dimension(),
        })
    }

    /// The unit of the key, if it has one.
    fn unit(&self) -> Option<Unit> {
        self.setup.unit.filter(|unit| !unit.is_one())
    }

    /// A formula and the unit that comes after it all the same, `sqrt(k/m) rad/s`.
    fn before_unit<'t>(&self, response: Passage<'t>) -> Option<BeforeUnit<'t>> {
        let has_names = self.has_names();
        response.before_units().find(|cut| {
            let typed = self.read(cut.formula);
            typed.is_ok_and(|typed| !has_names || !typed.value.names().free.is_empty())
        })
    }

    /// The marking of a formula before a unit: one in which it comes out is passed over, another one handed back.
    fn mark_before_unit(&self, response: Passage<'_>) -> Option<Marking> {
        let cut = self.before_unit(response)?;
        let BeforeUnit { unit, typed, .. } = cut;
        if !self.has_dimension(&unit) {
            // `x0/C` is more likely a letter that is not known.
            return cut
                .is_spaced
                .then(|| Marking::unreadable(Unreadable::at(typed, Why::UnitBehindLetters)));
        }
        if !self.is_own(&unit) {
            let own = Why::UnitComesOut(self.unit());
            return Some(Marking::unreadable(Unreadable::at(typed, own)));
        }
        let mut marking = self.mark_alone(cut.formula).ok()?;
        if self.has_names() && marking.reading.is_some() {
            let note = Note::LettersCarryUnits(typed.into());
            marking.remarks.push(note.into());
        }
        Some(marking)
    }

    /// The marking of a formula with a unit that is read as letters, `mg/k m`, if the formula alone is right.
    fn right_before_unit(&self, response: Passage<'_>) -> Option<Marking> {
        let cut = self.before_unit(response)?;
        let is_right = self.has_dimension(&cut.unit)
            && self
                .mark_alone(cut.formula)
                .is_ok_and(|marking| marking.verdict == Verdict::Right);
        is_right.then(|| self.mark_before_unit(response)).flatten()
    }

    fn has_dimension(&self, unit: &Unit) -> bool {
        let own = self.setup.kind.dimension();
        own.is_none_or(|own| own == unit.dimension())
    }

    /// Whether a formula in SI units comes out in this one: rad/s or 1/s, but not Hz where rad/s is asked.
    fn is_own(&self, unit: &Unit) -> bool {
        let conversion = self.setup.unit.map(|own| unit.conversion(&own));
        match conversion {
            Some(Ok(conversion)) => conversion.apply(1.0) == 1.0,
            _ => unit.to_si(1.0) == 1.0 && !unit.counts_cycles(),
        }
    }

    /// Whether a response is a number in the unit of the key.
    fn is_number(&self, response: Passage<'_>) -> bool {
        crate::answer::numeric::quantity(response, self.mark)
            .is_ok_and(|quantity| Some(quantity.unit.dimension()) == self.setup.kind.dimension())
    }
}

/// Whether a formula is the key but for rounded numbers.
fn is_rounded(marking: &Marking) -> bool {
    let near = Remark::from(Slip::Near(Close::RoundedFormula));
    marking.remarks.contains(&near)
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![Trial::new(Nature::Unreadable, "sqrt(")];
        let text = self.setup.shown.to_string();
        // Cases and numbers with units cannot be typed.
        let is_typable = !text.contains("if ") && !text.contains('[');
        if !is_typable || !self.setup.shown.names().paths.is_empty() {
            return trials;
        }
        trials.extend([
            Trial::new(Nature::Right, text.as_str()),
            Trial::new(Nature::Borderline, format!("2*({text})/2")),
            Trial::new(Nature::Unreadable, format!("({text}")),
            Trial::new(Nature::Unreadable, format!("({text})*unheard_of")),
        ]);
        if !self.setup.shown.is_zero() {
            trials.push(Trial::new(Nature::Wrong, format!("1.000001*({text})")));
            trials.push(Trial::new(Nature::Wrong, format!("-({text})")));
        }
        if self
            .setup
            .kind
            .dimension()
            .is_some_and(|dimension| !dimension.is_pure())
        {
            trials.push(Trial::new(Nature::WrongUnit, format!("({text})^2")));
        }
        trials
    }

    fn key(&self) -> Key {
        Key::clone(self.setup.printed())
    }

    fn recalled(&self) -> Option<&Recalled> {
        self.recalled.as_deref()
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let unread = |error: TypedError| Unreadable::typed(&error, response);
        // Whether sides are the same may tell of a key that an earlier part asks for.
        let readings = |own: Passage<'_>| Ok(self.readings_of(self.read_where(own, &|_| true)?));
        let readings = match readings(response) {
            Ok(readings) => readings,
            Err(error) => {
                let cut = self.before_unit(response).ok_or_else(|| unread(error))?;
                readings(cut.formula).map_err(unread)?
            }
        };
        let readings = readings.iter().map(|read| self.reading(&read.expr));
        Echo::of(readings).ok_or_else(|| Why::Incomparable.into())
    }

    fn may_hold(&self, condition: Passage<'_>) -> bool {
        let (meaning, lexicon) = (&self.setup.meaning, &self.setup.lexicon);
        let read = condition.comparison(lexicon, self.manner());
        read.is_ok_and(|own| self.points.meet(&Condition::of(meaning, &[own])))
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        match self.mark_alone(response) {
            Ok(marking) if marking.reasons().contains(&Reason::Dimension) => {
                let other = self.right_before_unit(response);
                let other = other.or_else(|| self.right_in_last(response));
                other
                    .or_else(|| self.right_with(L_FOR_ELL, response))
                    .unwrap_or(marking)
            }
            Ok(marking) if marking.verdict == Verdict::Wrong => {
                self.right_with(E_FOR_EPSILON, response).unwrap_or(marking)
            }
            Ok(marking) => marking,
            Err(error)
                if error.trouble == Trouble::Unsolved
                    && let Some(marking) = self
                        .right_behind_steps(response)
                        .or_else(|| self.right_if_solved(response)) =>
            {
                marking
            }
            Err(error)
                if matches!(error.trouble, Trouble::NotAllowed(_))
                    && let Some(marking) = self.right_with(L_FOR_ELL, response) =>
            {
                marking
            }
            // No unit makes it shorter by much, and each that is tried would be read as far.
            Err(error) if matches!(error.trouble, Trouble::TooDeep | Trouble::TooLong) => {
                Marking::unreadable(Unreadable::typed(&error, response))
            }
            Err(error) => self.mark_before_unit(response).unwrap_or_else(|| {
                let is_unknown = matches!(error.trouble, Trouble::Unknown { .. } | Trouble::Unit);
                let is_number = is_unknown && self.has_names() && self.is_number(response);
                if is_number {
                    Marking::unreadable(Why::FormulaNotNumber)
                } else {
                    Marking::unreadable(Unreadable::typed(&error, response))
                }
            }),
        }
    }
}
