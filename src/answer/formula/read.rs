//! Reads the formula of a response, and the unit that may come after it all the same.

use super::marker::Prepared;
use crate::answer::equality::Comparison;
use crate::answer::{Marking, Misfit, Note, Unreadable, Verdict, Why};
use crate::expr::{Expr, Field};
use crate::response::{BeforeUnit, Manner, Passage, Stated, Trouble, Typed, TypedError};
use crate::unit::Unit;

impl Prepared {
    /// The readings of a formula. Where all is real, the imaginary unit may stand in what comes out real, `|1 + iζ|`.
    pub(crate) fn read(&self, response: Passage<'_>) -> Result<Typed<Expr>, TypedError> {
        let stated = self.stated(response)?;
        self.in_manner(|manner| {
            let formula = stated.formula(&self.setup.lexicon, manner);
            match formula {
                // `½ I θ'² = ½ m l² θ'²`, each side of which is the answer.
                Err(error) if error.trouble == Trouble::Unsolved => {
                    self.equal_forms(&stated, manner).ok_or(error)
                }
                formula => formula,
            }
        })
    }

    /// The statements of a response.
    fn stated<'t>(&self, response: Passage<'t>) -> Result<Stated<'t>, TypedError> {
        response.stated(|label| self.setup.naming.is_of_asked(label))
    }

    /// The other sides of the equals signs of a response, each in its readings.
    pub(crate) fn other_forms(&self, response: Passage<'_>) -> Vec<Typed<Expr>> {
        let stated = self.stated(response);
        stated.map_or_else(
            |_| Vec::new(),
            |stated| stated.other_forms(&self.setup.lexicon, self.manner()),
        )
    }

    /// The last of the sides of a statement without a symbol, if all of them are the same.
    fn equal_forms(&self, stated: &Stated<'_>, manner: Manner) -> Option<Typed<Expr>> {
        let mut forms = stated.all_forms(&self.setup.lexicon, manner).ok()?;
        let fits = |expr: &Expr| self.misfit(expr).is_none();
        let last = forms.pop()?.fitting(fits);
        let own = self.comparable(&last)?;
        let is_same = |form: Typed<Expr>| {
            let form = self.comparable(&form.fitting(fits));
            form.is_some_and(|form| self.points.compare(&own, &form) == Comparison::Same)
        };
        let typed = Typed {
            value: last,
            others: Vec::new(),
        };
        forms.into_iter().all(is_same).then_some(typed)
    }

    /// The last side of a statement that begins with steps in letters of one's own, `F_R/k = μ m g/k`; none of them is
    /// what is asked, as in `ω² = k/m`.
    pub(crate) fn behind_own_steps(&self, response: Passage<'_>) -> Option<Typed<Expr>> {
        let stated = self.stated(response).ok()?;
        let pieces = stated.pieces();
        let (last, steps) = pieces.split_last()?;
        let read = |side: &Passage<'_>| side.formula(&self.setup.lexicon, self.manner());
        let has_asked = |side: &Passage<'_>| self.setup.naming.has_asked(*side);
        let are_own = steps.first().is_some_and(|first| read(first).is_err());
        if !are_own || steps.iter().any(has_asked) {
            return None;
        }
        read(last).ok()
    }

    /// What is read in the manner of the key.
    fn in_manner(
        &self,
        read: impl Fn(Manner) -> Result<Typed<Expr>, TypedError>,
    ) -> Result<Typed<Expr>, TypedError> {
        let own = self.manner();
        let is_real = |typed: &Typed<Expr>| {
            let found = typed.value.check(&self.setup.meaning);
            found.is_ok_and(|found| found.field() == Field::Real)
        };
        match read(own) {
            Err(error) if !own.has_imaginary_unit => {
                read(Manner::COMPLEX).ok().filter(is_real).ok_or(error)
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
    pub(crate) fn has_names(&self) -> bool {
        !self.setup.shown.names().free.is_empty()
    }

    /// What is wrong with the dimension of a formula.
    pub(crate) fn misfit(&self, typed: &Expr) -> Option<Misfit> {
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
    pub(crate) fn before_unit<'t>(&self, response: Passage<'t>) -> Option<BeforeUnit<'t>> {
        let has_names = self.has_names();
        let reads = |cut: &BeforeUnit<'_>| {
            let typed = self.read(cut.formula);
            typed.is_ok_and(|typed| !has_names || !typed.value.names().free.is_empty())
        };
        response.before_units().find(reads)
    }

    /// The marking of a formula before a unit: one in which it comes out is passed over, another one handed back.
    pub(crate) fn mark_before_unit(&self, response: Passage<'_>) -> Option<Marking> {
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
    pub(crate) fn right_before_unit(&self, response: Passage<'_>) -> Option<Marking> {
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
}
