//! Numbers with units as people type them.

use crate::unit::{DecimalMark, Quantity};

/// The quantity that a response is, after a symbol and an equals sign that may stand before it.
///
/// # Errors
///
/// A sentence that says what cannot be read and what to type instead.
pub(crate) fn quantity(response: &str, mark: DecimalMark) -> Result<Quantity, String> {
    let value = after_equals(response);
    Quantity::read(value, mark).map_err(|error| {
        let place = value
            .get(error.span.clone())
            .filter(|place| !place.is_empty() && *place != value);
        let mut message = match place {
            Some(place) => format!("At `{place}`: {error}."),
            None => format!("{}.", capital(&error.to_string())),
        };
        if let Some(help) = error.help() {
            message.push(' ');
            message.push_str(&capital(&help));
            message.push('.');
        } else {
            message
                .push_str(" Type a number and its unit, for example `15.8 rad/s` or `1.6e-2 m`.");
        }
        message
    })
}

/// The items of a list; a unit at the end of the last one serves for all that have none.
pub(super) fn list(response: &str, mark: DecimalMark) -> Result<Vec<Quantity>, String> {
    const MOST_ITEMS: usize = 100;
    let inner = after_equals(response)
        .trim_matches(|sign: char| sign.is_whitespace() || "[](){}".contains(sign));
    let pieces = separated(inner, mark);
    if pieces.len() > MOST_ITEMS {
        return Err(format!("A list has at most {MOST_ITEMS} numbers."));
    }
    let mut items = pieces
        .into_iter()
        .map(|piece| quantity(piece, mark))
        .collect::<Result<Vec<_>, _>>()?;
    if let Some(unit) = items.last().map(|last| last.unit) {
        items
            .iter_mut()
            .filter(|item| item.unit.is_one())
            .for_each(|item| item.unit = unit);
    }
    Ok(items)
}

/// What stands behind the last equals sign.
fn after_equals(response: &str) -> &str {
    response
        .rsplit(['=', '≈'])
        .next()
        .unwrap_or(response)
        .trim()
}

/// Cut at semicolons, at the word `and`, or at commas that cannot be decimal signs.
fn separated(text: &str, mark: DecimalMark) -> Vec<&str> {
    if text.contains(';') {
        return text
            .split(';')
            .map(str::trim)
            .filter(|piece| !piece.is_empty())
            .collect();
    }
    let by_comma = |piece: &'static str| move |text| str::split(text, piece).collect::<Vec<&str>>();
    let pieces: Vec<&str> = text
        .split(" and ")
        .flat_map(|piece| piece.split(" or "))
        .collect();
    let cut = match mark {
        DecimalMark::Comma => by_comma(", "),
        DecimalMark::Point => by_comma(","),
    };
    pieces
        .into_iter()
        .flat_map(cut)
        .map(str::trim)
        .filter(|piece| !piece.is_empty())
        .collect()
}

fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}
