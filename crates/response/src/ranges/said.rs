//! Ranges in words: `from 0.2 to 0.5 m`, `0.2 or more`, and the words around ranges in signs.

use super::marks::{Mark, Marked};
use super::{Bounding, Condition, Group, Said};
use crate::signs::is_digit;
use crate::surroundings::behind_word;
use crate::wording::is_symbol;
use crate::words::{CONDITIONS, ENDS, INSIDE, LIMITS, ONWARDS, RANGES, UNBOUNDED, VERBS, WITHIN};
use crate::{Passage, Wording};

/// A text without the words after it that say of the ends of a range whether they are left out, and what they say.
pub(crate) fn without_said_ends(text: &str) -> (&str, Option<bool>) {
    let end = text.trim_end_matches(['.', ' ']);
    let bare = end.strip_suffix(')').unwrap_or(end);
    let said = ENDS.iter().find_map(|(words, is_out)| {
        let before = bare.strip_suffix(words)?;
        let before = if bare.len() < end.len() {
            // `39.2 mm (39.2 excluded)`
            let (before, again) = before.rsplit_once('(')?;
            let is_again = |word: &str| word == again.trim_end();
            (again.is_empty() || before.split(' ').any(is_again)).then_some(before)?
        } else {
            before.strip_suffix([' ', ','])?
        };
        Some((before.trim_end_matches([' ', ',']), Some(*is_out)))
    });
    said.unwrap_or((text, None))
}

/// What comes after words for a condition, and after words of the question before those: `for all μ ≥ 0.2`,
/// `it stays if μ ≥ 0.2`.
pub(crate) fn condition_said<'t>(text: &'t str, asked: &Wording) -> &'t str {
    let joint = [" if ", " when ", " for "].iter().find_map(|word| {
        let (before, behind) = text.split_once(word)?;
        asked.covers(before).then_some(behind)
    });
    let text = joint.unwrap_or(text).trim_start();
    let said = CONDITIONS.iter().find_map(|word| behind_word(text, word));
    let said = said.unwrap_or(text);
    // `every stiffness < 250 N/m`
    let named = said.split_at(said.find(['<', '>', '≤', '≥']).unwrap_or_default());
    let is_named = !named.0.split_whitespace().any(is_symbol) && asked.covers(named.0);
    if is_named { named.1 } else { said }
}

/// Ranges in words that joints part, where no sign says what the values are.
pub(crate) fn in_words<'t>(text: &'t str, marks: &[Marked]) -> Option<Vec<Group<'t>>> {
    if text.contains(['<', '>', '≤', '≥', '[', ']', '∈']) {
        return None;
    }
    if let Some(said) = onwards(text) {
        return Some(vec![group(text, said)]);
    }
    let (mut groups, mut start) = (Vec::new(), 0);
    let ends = marks.iter().filter(|own| match own.mark {
        Mark::Or => true,
        // `between 1 and 2 and from 4 to 5`
        Mark::And => {
            let (before, behind) = (&text[..own.at.start], &text[own.at.end..]);
            behind.trim_start().starts_with("from ")
                || [before, behind].iter().all(|own| own.contains(" to "))
        }
        _ => false,
    });
    let ends = ends.map(|own| own.at.clone());
    for joint in ends.chain(std::iter::once(text.len()..text.len())) {
        let own = text[start..joint.start].trim();
        groups.push(group(own, range(own)?));
        start = joint.end;
    }
    Some(groups)
}

fn group<'t>(typed: &'t str, said: Said<'t>) -> Group<'t> {
    let units = Vec::new();
    Group {
        typed: Passage::of(typed),
        is_common: false,
        conditions: vec![Condition { units, said }],
    }
}

/// `0.2 or more`, `from 0.2 on`, `x from 0.2 to infinity`, `max. 0.2`, `x must be 0.2 or less`.
fn onwards(text: &str) -> Option<Said<'_>> {
    let chain = |lead, is_less, bound| Said::Chain {
        sides: vec![Passage::of(lead), Passage::of(bound)],
        signs: vec![Bounding {
            is_less,
            is_open: false,
        }],
    };
    let from = text.split_once("from ").and_then(|(lead, bound)| {
        let bound = UNBOUNDED.iter().find_map(|end| bound.strip_suffix(end))?;
        Some(chain(lead, false, bound))
    });
    // `x must be 0.2`; `is` has become an equals sign.
    let parted = |bound| {
        let verbs = VERBS.iter().map(|verb| format!(" {verb} "));
        let mut signs = verbs.chain(["=".to_owned()]);
        signs
            .find_map(|sign| str::split_once(bound, &sign))
            .unwrap_or(("", bound))
    };
    let mut limits = LIMITS.iter().filter_map(|(word, is_less)| {
        let bound = behind_word(text, word)?;
        let is_number = bound.trim_start().starts_with(is_digit);
        is_number.then(|| chain("", *is_less, bound))
    });
    let either_way = || {
        let bound = text.rsplit_once(':').map_or(text, |(_, bound)| bound);
        // `x = ±3 mm` is two values.
        let bound = bound.trim();
        let bare = INSIDE.iter().find_map(|words| bound.strip_suffix(words));
        let mut words = WITHIN.iter();
        let bare = bare.or_else(|| words.find_map(|word| behind_word(bound, word)));
        let bound = bare.unwrap_or(bound).trim().strip_prefix('±');
        let bound = bound.filter(|bound| !bound.contains(['±', '=']))?;
        Some(Said::Within {
            bound: Passage::of(bound),
            open: None,
        })
    };
    let mut onwards = ONWARDS.iter().filter_map(|(words, is_less)| {
        let (lead, bound) = parted(text.strip_suffix(words)?);
        Some(chain(lead, *is_less, bound))
    });
    from.or_else(|| onwards.next())
        .or_else(|| limits.next())
        .or_else(either_way)
}

/// `from 0.2 to 0.5 m`, `x between 0.2 and 0.5`, `0.2 … 0.5` and `0.2-0.5`.
fn range(text: &str) -> Option<Said<'_>> {
    const SIGNS: [&str; 4] = [" to ", "…", "...", ".."];
    let in_words = RANGES.iter().find_map(|(word, join)| {
        let (lead, ends) = text.split_once(word)?;
        let (low, high) = ends.split_once(join)?;
        Some((lead, low, high))
    });
    let in_signs = || {
        let (lead, ends) = text.rsplit_once(['=', ':']).unwrap_or(("", text));
        let is_value = |end: &str| {
            let unsigned = end.trim().trim_start_matches(['-', '+']);
            unsigned.starts_with(|first: char| first.is_ascii_digit() || first == '.')
        };
        let joined = SIGNS.iter().find_map(|sign| ends.split_once(sign));
        let (low, high) = joined.or_else(|| dashed(ends.trim()))?;
        (is_value(low) && is_value(high)).then_some((lead, low, high))
    };
    let (lead, low, high) = in_words.or_else(in_signs)?;
    // `from 0.2 (excluded) to 0.5 (included)`
    let ends = [low, high].map(without_said_ends);
    let open = match ends.map(|(_, is_out)| is_out) {
        [None, None] => None,
        // Where one end is left out the other belongs to it; of one that is kept it says nothing.
        [Some(false), None] | [None, Some(false)] => return None,
        said => Some(said.map(|is_out| is_out == Some(true))),
    };
    let lead = lead.trim().trim_end_matches(['=', ':']);
    let mut verbs = VERBS.iter();
    let lead = Passage::of(
        verbs
            .find_map(|verb| lead.strip_suffix(verb))
            .unwrap_or(lead),
    );
    Some(Said::Interval {
        subject: Some(lead).filter(|lead| !lead.is_empty()),
        ends: ends.map(|(end, _)| Passage::of(end)),
        open,
    })
}

/// The values around a dash, `0.2 m-0.5 m`, which is no sign of an exponent.
fn dashed(text: &str) -> Option<(&str, &str)> {
    let (at, dash) = text.match_indices('-').find(|(at, _)| {
        let before = text[..*at].trim_end();
        let is_exponent = before.strip_suffix(['e', 'E']).is_some_and(|before| {
            before.ends_with(|last: char| last.is_ascii_digit() || last == '.')
        });
        before.ends_with(char::is_alphanumeric) && !is_exponent
    })?;
    Some((&text[..at], &text[at + dash.len()..]))
}
