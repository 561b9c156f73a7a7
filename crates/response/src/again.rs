//! Other ways to read an answer, where nothing can be read of all that was typed: less of it, or its words as numbers.

use super::reworded::{Reworded, of_spoken_numbers};
use super::words::CORRECTIONS;
use super::{Passage, aside, determinant, sides};

/// What is read in place of a text; none where it has nothing of the kind.
type Rereading = fn(&str) -> Option<Reworded>;

/// The ways, in the order in which they are tried. What comes out of one is an answer where it is right, so that no way
/// makes a wrong one of what could not be read.
const WAYS: [Rereading; 11] = [
    // What is said after an answer, where it holds or where it comes from, does not change it.
    |text| {
        let before = aside::before(text)?;
        Some(Reworded::from(before).under(aside::conditions(&text[before.len()..])))
    },
    // The same of each of several equations.
    aside::between,
    // A law names what both of its sides are: `ΣF = m x'' = -k x`.
    |text| sides::without_names(text).map(Reworded::of),
    // Nor do words before it that describe it; a comma after them may also part two answers, so that they come later.
    |text| aside::behind(text).map(Reworded::from),
    // Where it comes from may be said before it in formulas, too.
    |text| {
        let [said, formula] = aside::explained(text)?;
        Some(Reworded::from(formula).behind(said))
    },
    // What steps lead to is the answer: `½ k (2x)² = ½ (4k) x² → 4k`.
    |text| Some(Reworded::from(Passage::of(text).concluded()?.text())),
    // So is the last of several equations: those before it have letters that are eliminated.
    |text| last_equation(text).map(Reworded::from),
    // `|a b; c d| = 0`
    |text| determinant::of_bars(text).map(Reworded::of),
    // `at 10 rad/s`
    |text| text.strip_prefix("at ").map(Reworded::from),
    // What is corrected is no answer.
    |text| corrected(text).map(Reworded::from),
    // Last, since `two` and `half` count things in what is said beside an answer, too.
    of_spoken_numbers,
];

/// What may be read in place of a text, by each way that it allows.
pub(crate) fn read_again(text: &str) -> impl Iterator<Item = Reworded> {
    WAYS.iter().filter_map(move |way| way(text))
}

/// The last of several equations, each of which ends at a semicolon, a line or a sentence; none where one before it has
/// the same left side, and says otherwise.
fn last_equation(text: &str) -> Option<&str> {
    let mut ends = ["\n", ";", ". "].iter();
    let (before, last) = ends.find_map(|end| text.trim_end().rsplit_once(end))?;
    let (left, _) = last.split_once('=')?;
    let mut others = before.split(['\n', ';', ',']);
    let says_otherwise = |own: &str| own.split('=').next().map(str::trim) == Some(left.trim());
    let are_equations = before.contains('=') && !others.any(says_otherwise);
    are_equations.then_some(last.trim())
}

/// What comes after the last word with which an answer is corrected, `5 m -> sorry, 6 m`.
fn corrected(text: &str) -> Option<&str> {
    let behind = CORRECTIONS.iter().filter_map(|word| {
        let (before, behind) = text.rsplit_once(word)?;
        (!before.trim().is_empty()).then_some(behind.trim())
    });
    behind.min_by_key(|behind| behind.len())
}
