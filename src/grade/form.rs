//! Answers in another form than the one that is asked: a value for a formula, a formula for a value, or both in one
//! statement, `ω = sqrt(k/m) = 15.81 rad/s`.

use super::Sheet;
use super::typed::TypedResponse;
use crate::answer::{
    AnswerKind, Answered, Close, Credit, Marker, Marking, Naming, Note, Reason, Remark, Slip,
    Verdict, Why, are_one_value,
};
use crate::expr::{Expr, Kind, Precise, Program, Slots, Workspace};
use crate::numerics::Rational;
use crate::response::Passage;
use crate::solution::Solution;
use crate::unit::DecimalMark;

/// The marking of a response that its own kind hands back, if it says something in the other form: of a statement in
/// both forms the one that is asked counts, and a right answer in the other form alone has its share.
pub(crate) fn otherwise(
    solution: &Solution<'_>,
    place: usize,
    response: &TypedResponse<'_>,
    first: &Marking,
    sheet: &Sheet<'_>,
) -> Option<Marking> {
    if response.is_too_long() || is_of_another(first) {
        return None;
    }
    // Letters of the question may all be units, too: in `2*pi*sqrt(l/g)` a litre and a gram.
    let is_misfit = first.verdict == Verdict::Wrong && first.reasons().contains(&Reason::Dimension);
    let is_open = is_misfit || first.verdict == Verdict::Unreadable && !is_doubtful(first);
    let part = &solution.template().parts[place];
    part.answer.other_form()?;
    // The sides of an equation are no forms of one value, and the value that was read counts, whatever the steps before it
    // are.
    let may_have_both = !matches!(
        part.answer.kind(),
        AnswerKind::Equation | AnswerKind::Numeric
    );
    let own = solution.marker(place).ok()?;
    let is_known = || {
        let known = own.recalled();
        known.is_some_and(|known| known.has(response.typed()))
    };
    if !is_open && (!may_have_both || is_known()) {
        return None;
    }
    let folded = part.naming.named(response.folded().ok()?.clone()).ok()?;
    let typed = folded.passage();
    let sides = typed.statement();
    // A key in the other form is prepared only where it may decide.
    if sides.len() < 2 && !is_open {
        return None;
    }
    let other = solution.other_marker(place)?;
    let forms = Forms {
        own,
        other,
        naming: &part.naming,
        mark: solution.mark(),
    };
    let marking = match part.answer.kind() {
        AnswerKind::Numeric => forms.value(solution, sides),
        // The sides of an equation are no forms of one value.
        AnswerKind::Equation => None,
        _ => forms.formula(sides),
    };
    if marking.is_some() {
        return marking;
    }
    if !is_open {
        return None;
    }
    let marking = other.mark(typed);
    let reading = marking.reading.clone().filter(|_| is_right(&marking))?;
    // A zero is right in letters whatever unit it has.
    let formula = || reading.answered.formula();
    if is_misfit && formula().is_none_or(|formula| formula.names().free.is_empty()) {
        return None;
    }
    match share(solution, place, sheet).filter(|credit| *credit > Credit::NONE) {
        Some(credit) => {
            let note = match part.answer.kind() {
                AnswerKind::Equation => Note::WithValues,
                _ => Note::OtherForm,
            };
            Some(Marking::read(reading, credit, Remark::from(note)))
        }
        None => is_misfit.then(|| Marking::unreadable(Why::Letters)),
    }
}

/// Whether a response says nothing in another form than the one that is asked.
pub(crate) fn is_in_one(
    solution: &Solution<'_>,
    place: usize,
    response: &TypedResponse<'_>,
) -> bool {
    let part = &solution.template().parts[place];
    if part.answer.kind() == AnswerKind::Equation {
        return true;
    }
    let folded = response.folded().ok().cloned();
    let folded = folded.and_then(|folded| part.naming.named(folded).ok());
    folded.is_some_and(|folded| folded.passage().statement().len() < 2)
}

/// What a response that its own kind hands back stands for in later parts: the value in place of a formula, or the
/// formula in place of a value, that it is in the other form.
pub(crate) fn standing(
    solution: &Solution<'_>,
    place: usize,
    response: &TypedResponse<'_>,
    marking: &Marking,
) -> Option<Marking> {
    let is_open = marking.verdict == Verdict::Unreadable && !response.is_too_long();
    if !is_open || is_doubtful(marking) || is_of_another(marking) {
        return None;
    }
    let naming = &solution.template().parts[place].naming;
    let folded = naming.named(response.folded().ok()?.clone()).ok()?;
    let other = solution.other_marker(place)?.mark(folded.passage());
    other.reading.is_some().then_some(other)
}

/// The most sides of a statement in both forms, each of which is marked: a derivation has a few.
const MAX_SIDES: usize = 12;

/// What marks a statement with sides in both forms.
struct Forms<'s> {
    own: &'s dyn Marker,
    other: &'s dyn Marker,
    naming: &'s Naming,
    mark: DecimalMark,
}

/// A side by its marking as the form that is asked for and as the other one.
struct FormedSide<'t> {
    typed: Passage<'t>,
    own: Marking,
    other: Marking,
}

impl Forms<'_> {
    fn marked<'t>(&self, typed: Passage<'t>) -> FormedSide<'t> {
        FormedSide {
            typed,
            own: self.own.mark(typed),
            other: self.other.mark(typed),
        }
    }

    /// The sides of a statement without the symbol of what is asked for, and whether that or another letter stood before
    /// the first equals sign.
    fn unnamed<'t>(&self, mut sides: Vec<Passage<'t>>) -> (Vec<FormedSide<'t>>, bool) {
        // What is asked may stand before the first equals sign, whatever else its letter means.
        let mut is_led = sides.len() > 1 && self.naming.is_of_asked(sides[0]);
        if is_led {
            sides.remove(0);
        }
        if sides.len() > MAX_SIDES + 1 {
            return (Vec::new(), is_led);
        }
        let mut marked: Vec<FormedSide<'t>> =
            sides.into_iter().map(|side| self.marked(side)).collect();
        let is_letter = |side: &FormedSide<'_>| {
            let is_it = |marking: &Marking| {
                let reading = marking.reading.as_ref();
                reading.is_none_or(|reading| is_name(&reading.text))
            };
            // `2 x` is no name.
            let is_made_of_names = self
                .naming
                .letters(side.typed)
                .is_some_and(|formula| !matches!(formula.kind(), Kind::Name(_) | Kind::Prime(..)));
            side.typed.is_symbol() && !is_made_of_names && is_it(&side.own) && is_it(&side.other)
        };
        if marked.len() > 1 && !is_led && is_letter(&marked[0]) {
            marked.remove(0);
            is_led = true;
        } else if marked.len() > 1 && marked.last().is_some_and(is_letter) {
            // Or after the last one: `15.8 rad/s = ω`.
            marked.pop();
        }
        (marked, is_led)
    }

    /// The marking of a statement where a formula is asked for: that of its last side in letters, if all others agree
    /// with it.
    fn formula(&self, sides: Vec<Passage<'_>>) -> Option<Marking> {
        let (mut marked, _) = self.unnamed(sides);
        let is_in_form = |side: &FormedSide<'_>| side.own.reading.is_some();
        // In `4π² m/T² = 4π² m/t²` letters stand that the item does not have, and no teslas.
        let is_of_letters = |side: &FormedSide<'_>| {
            !is_in_form(side)
                && side.other.reasons().contains(&Reason::Dimension)
                && side.typed.is_of_free_letters()
        };
        let mut steps = marked.iter().rposition(is_in_form).unwrap_or(0);
        marked.retain(|side| {
            let is_step = steps > 0;
            steps = steps.saturating_sub(1);
            !(is_step && is_of_letters(side))
        });
        if !(2..=MAX_SIDES).contains(&marked.len())
            || marked
                .iter()
                .any(|side| side.own.reading.is_none() && side.other.reading.is_none())
        {
            return None;
        }
        let in_form = marked.iter().filter(|side| is_in_form(side)).count();
        if in_form == 0 || in_form == marked.len() {
            return None;
        }
        // The exact form counts before its rounded one: `√2 x0 ≈ 1.41 x0 = 0.2 m`.
        let is_exact = |side: &&FormedSide<'_>| is_in_form(side) && !is_rounded(&side.own);
        let exact = marked.iter().rfind(is_exact);
        let counts = &exact
            .or_else(|| marked.iter().rfind(|side| is_in_form(side)))?
            .own;
        // Bare numbers before a value with its unit are in SI units, or in those of the sheet.
        let value = marked.iter().rfind(|side| !is_in_form(side))?;
        let is_value = |side: &FormedSide<'_>| {
            is_right(&side.other) || self.is_one_value(side.typed, value.typed)
        };
        let agrees = is_right(&value.other)
            && marked.iter().all(|side| {
                if is_in_form(side) {
                    is_right(&side.own) || is_rounded(&side.own)
                } else {
                    is_value(side)
                }
            });
        if !is_right(counts) || agrees {
            return Some(counts.clone());
        }
        let reading = counts.reading.clone()?;
        Some(Marking::wrong(reading, Remark::from(Slip::UnequalSides)))
    }

    /// The marking of a statement where a value is asked for: that of its last number, which the steps in letters need
    /// not agree with, since letters of a textbook and data that were substituted stand in them. Numbers that contradict
    /// each other are handed back, and so is what begins with letters that are something else.
    fn value(&self, solution: &Solution<'_>, sides: Vec<Passage<'_>>) -> Option<Marking> {
        let (marked, is_led) = self.unnamed(sides);
        if !(2..=MAX_SIDES).contains(&marked.len()) {
            return None;
        }
        let letters = |side: &FormedSide<'_>| {
            let read = side.other.reading.as_ref();
            read.and_then(|reading| reading.answered.formula())
                .filter(|own| !own.names().free.is_empty())
                .or_else(|| self.naming.letters(side.typed))
        };
        let is_number = |side: &FormedSide<'_>| {
            let is_misfit = side.own.reasons().contains(&Reason::Dimension);
            // Arithmetic without a unit may be in SI units.
            (side.own.reading.is_some() || is_doubtful(&side.own))
                && !(is_misfit && (letters(side).is_some() || side.typed.is_of_free_letters()))
        };
        let value = marked.iter().rfind(|side| is_number(side))?;
        for (at, side) in marked.iter().enumerate() {
            if is_number(side) {
                // `8.94 = 1.42 Hz` is one value in two units, where rad/s is asked for.
                let are_right = is_right(&side.own) && is_right(&value.own);
                if !are_right && !self.is_one_value(side.typed, value.typed) {
                    let (one, other) = (side.typed.short(), value.typed.short());
                    return Some(Marking::unreadable(Why::UnequalSides(one, other)));
                }
                continue;
            }
            let formula = letters(side);
            // `-arctan(∞) = -π/2`
            if formula.is_none() && is_right(&side.other) {
                continue;
            }
            if formula.is_none() && (at == 0 && !is_led || !side.typed.is_of_free_letters()) {
                return None;
            }
            let is_first = at == 0 && !is_led;
            // `2 ω = 10 rad/s` is of another quantity, whatever the value is.
            let is_it = || match &formula {
                Some(formula) if self.naming.is_of_key(formula) => false,
                Some(formula) => is_right(&side.other) || comes_to(solution, formula, &value.own),
                None => false,
            };
            if is_first && !is_it() {
                return None;
            }
        }
        Some(value.own.clone())
    }

    /// Whether two numbers agree.
    fn is_one_value(&self, one: Passage<'_>, other: Passage<'_>) -> bool {
        one == other || are_one_value(one, other, self.mark)
    }
}

/// Whether a formula has the value that was typed, for the data of the sheet.
fn comes_to(solution: &Solution<'_>, formula: &Expr, typed: &Marking) -> bool {
    // Of two values rounded to three figures.
    const SHARE: f64 = 0.01;
    let free = formula.names().free;
    let names: Vec<&str> = free.iter().map(|own| own.name.as_str()).collect();
    let graph = &solution.template().graph;
    let values = free.iter().map(|own| {
        let node = graph.find(&own.name).filter(|_| own.order == 0)?;
        solution.evaluation().real(node).ok().map(Precise::exact)
    });
    let Some(values) = values.collect::<Option<Vec<Precise>>>() else {
        return false;
    };
    let program = Program::compile(formula, &Slots(&names));
    let own = program.ok().and_then(|program| {
        let own = program.evaluate_real(&values[..], &mut Workspace::default());
        own.ok()
    });
    let typed = typed.reading.as_ref().map(|reading| &reading.answered);
    match (own, typed) {
        (Some(own), Some(Answered::Number { si, .. })) => {
            (own - si).abs() <= SHARE * own.abs().max(si.abs())
        }
        _ => false,
    }
}

/// Whether it was handed back since it can be read in two ways.
pub(crate) fn is_doubtful(marking: &Marking) -> bool {
    marking.remarks.iter().any(|remark| {
        let why = match remark {
            Remark::Unreadable(unreadable) => &*unreadable.why,
            _ => return false,
        };
        matches!(
            why,
            Why::TwoReadings(..)
                | Why::CommaOfThree { .. }
                | Why::RoundedNumbers
                | Why::Figures { .. }
        )
    })
}

/// Whether it was handed back since it is of another quantity, or is taken back, whatever form it has.
fn is_of_another(marking: &Marking) -> bool {
    marking.remarks.iter().any(|remark| {
        matches!(remark, Remark::Unreadable(unreadable) if matches!(*unreadable.why, Why::OtherQuantity | Why::Withdrawn))
    })
}

/// Whether it is the key but for rounded numbers in a formula.
fn is_rounded(marking: &Marking) -> bool {
    let near = Remark::from(Slip::Near(Close::RoundedFormula));
    marking.remarks.contains(&near)
}

/// Whether it is the key, though it may lack a unit or figures.
fn is_right(marking: &Marking) -> bool {
    marking.credit > Credit::NONE && marking.reasons().contains(&Reason::Matches)
}

/// Whether a formula is one name.
fn is_name(formula: &str) -> bool {
    formula.starts_with(char::is_alphabetic)
        && formula
            .chars()
            .all(|char| char.is_alphanumeric() || char == '_')
}

/// What the other form is worth; nothing where another part that is asked has the same key. An equation with the values
/// of the sheet says what one in letters says, while a value does not show the formula.
fn share(solution: &Solution<'_>, place: usize, sheet: &Sheet<'_>) -> Option<Credit> {
    let template = solution.template();
    let key = |at: usize| {
        let keys = template.parts[at].answer.keys();
        let [key] = keys[..] else {
            return None;
        };
        let dimension = template.graph.kind(key)?.dimension();
        Some((solution.evaluation().real(key).ok()?, dimension))
    };
    // An equation is no value that another part may ask for.
    let is_asked_again = || {
        let own = key(place)?;
        let is_same = |at: &usize| {
            key(*at).is_some_and(|(value, dimension)| {
                // Both values are computed from the same data, and neither was rounded by a person.
                const SAME: f64 = 1e-12;
                dimension == own.1 && (value - own.0).abs() <= SAME * own.0.abs()
            })
        };
        let mut others = sheet.asked.iter().filter(|at| **at != place);
        Some(others.any(is_same))
    };
    let is_equation = template.parts[place].answer.kind() == AnswerKind::Equation;
    if !is_equation && is_asked_again()? {
        return None;
    }
    let usual = if is_equation {
        Some(Credit::FULL)
    } else {
        Rational::new(1, 2).and_then(Credit::new)
    };
    sheet.other_form.or(template.about.other_form).or(usual)
}
