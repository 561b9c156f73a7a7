//! Answers in another form than the one that is asked: a value for a formula, a formula for a value, or both in one
//! statement, `ω = sqrt(k/m) = 15.81 rad/s`.

use super::Sheet;
use super::typed::TypedResponse;
use crate::answer::{Credit, Marker, Marking, Naming, Note, Reason, Remark, Slip, Verdict, Why};
use crate::numerics::Rational;
use crate::response::Passage;
use crate::solution::Solution;

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
    let folded = part.naming.named(response.folded().ok()?.clone()).ok()?;
    let typed = folded.passage();
    let sides = typed.statement();
    // A key in the other form is prepared only where it may decide.
    if sides.len() < 2 && !is_open {
        return None;
    }
    let other = solution.other_marker(place)?;
    let own = solution.marker(place).ok()?;
    if let Some(marking) = statement(own, other, &part.naming, sides) {
        return Some(marking);
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
            let note = Remark::from(Note::OtherForm);
            Some(Marking::read(reading, credit, note))
        }
        None => is_misfit.then(|| Marking::unreadable(Why::Letters)),
    }
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

/// The marking of a statement with sides in both forms: that of its last side in the form that is asked, if all others
/// agree with it.
fn statement(
    own: &dyn Marker,
    other: &dyn Marker,
    naming: &Naming,
    mut sides: Vec<Passage<'_>>,
) -> Option<Marking> {
    // What is asked may stand before the first equals sign, whatever else its letter means.
    let is_led = sides.len() > 1 && naming.is_of_asked(sides[0]);
    if is_led {
        sides.remove(0);
    }
    if sides.len() < 2 {
        return None;
    }
    let mark = |side: Passage<'_>| (own.mark(side), other.mark(side));
    let is_letter = |marking: &Marking| {
        let reading = marking.reading.as_ref();
        reading.is_none_or(|reading| is_name(&reading.text))
    };
    let are_letters = |side: Passage<'_>| {
        let (own, other) = mark(side);
        is_letter(&own) && is_letter(&other)
    };
    if !is_led && sides[0].is_symbol() && are_letters(sides[0]) {
        sides.remove(0);
    } else if let Some(last) = sides.last().copied().filter(|side| side.is_symbol()) {
        // Or after the last one: `15.8 rad/s = ω`.
        if are_letters(last) {
            sides.pop();
        }
    }
    if sides.len() > MAX_SIDES {
        return None;
    }
    let mut marked: Vec<(Marking, Marking)> = Vec::with_capacity(sides.len());
    for side in sides {
        let (own, other) = mark(side);
        if own.reading.is_none() && other.reading.is_none() {
            return None;
        }
        marked.push((own, other));
    }
    let is_in_form = |(own, _): &&(Marking, Marking)| own.reading.is_some();
    let in_form = marked.iter().filter(is_in_form).count();
    if in_form == 0 || in_form == marked.len() {
        return None;
    }
    let (counts, _) = marked.iter().rfind(is_in_form)?;
    let agrees = marked.iter().all(|(own, other)| {
        if own.reading.is_some() {
            is_right(own)
        } else {
            is_right(other)
        }
    });
    if !is_right(counts) || agrees {
        return Some(counts.clone());
    }
    let reading = counts.reading.clone()?;
    Some(Marking::wrong(reading, Remark::from(Slip::UnequalSides)))
}

/// Whether it was handed back since it can be read in two ways.
fn is_doubtful(marking: &Marking) -> bool {
    marking.remarks.iter().any(|remark| {
        let why = match remark {
            Remark::Unreadable(unreadable) => &*unreadable.why,
            _ => return false,
        };
        matches!(why, Why::TwoReadings(..) | Why::CommaOfThree { .. })
    })
}

/// Whether it was handed back since it is of another quantity, or is taken back, whatever form it has.
fn is_of_another(marking: &Marking) -> bool {
    marking.remarks.iter().any(|remark| {
        matches!(remark, Remark::Unreadable(unreadable) if matches!(*unreadable.why, Why::OtherQuantity | Why::Withdrawn))
    })
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

/// What the other form is worth; nothing where another part that is asked has the same key.
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
    let own = key(place)?;
    let is_alike = |(value, dimension): (f64, _)| {
        // Both values are computed from the same data, and neither was rounded by a person.
        const SAME: f64 = 1e-12;
        dimension == own.1 && (value - own.0).abs() <= SAME * own.0.abs()
    };
    let is_asked_again = |at: &usize| *at != place && key(*at).is_some_and(is_alike);
    if sheet.asked.iter().any(is_asked_again) {
        return None;
    }
    let half = || Rational::new(1, 2).and_then(Credit::new);
    sheet.other_form.or(template.about.other_form).or_else(half)
}
