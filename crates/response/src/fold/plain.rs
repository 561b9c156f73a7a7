//! What a response is as a whole: plain already, made of cells or of numbers between bars.

use super::spoken::begins_operation;
use super::words::{begins_words, is_shouted};
use crate::signs::{RUNS, TURNS, is_digit, is_minus};
use crate::surroundings::{answer_in, enumeration};
use crate::words::{EQUATIONS, LISTS, NUMBERS, ROOTS};

/// Whether nothing is to be folded: printable ASCII without commands, dollars, marks and runs of signs.
pub(crate) fn is_plain(typed: &str) -> bool {
    let bytes = typed.as_bytes();
    let mut may_run = false;
    let is_kept_all = bytes.iter().enumerate().all(|(at, byte)| {
        may_run |= b"=*&{".contains(byte);
        (b' '..=b'~').contains(byte) && !b"$\\`~|".contains(byte) && !begins_sign(&bytes[at..])
    });
    is_kept_all
        && !(may_run && (RUNS.iter().any(|(run, _)| typed.contains(run)) || typed.contains("*^")))
        && !TURNS.iter().any(|(turn, _)| typed.contains(turn))
        && !typed
            .match_indices('(')
            .any(|(at, _)| is_called(&typed[..at]))
        && !typed
            .split([' ', '('])
            .any(|word| begins_words(word) || begins_operation(word))
        && !is_shouted(typed)
        && !typed.contains("/sqrt(kg)")
        && answer_in(typed).len() == typed.len()
        && enumeration(typed).is_empty()
}

/// Whether a sign of several characters begins here that is folded, or is none of a plain response.
// In one pass over the bytes: a search for each of them takes longer than all the rest of a plain response.
fn begins_sign(rest: &[u8]) -> bool {
    matches!(
        rest,
        [b'.', b'.', ..]
            | [b'-', b'>' | b'+', ..]
            | [b'+', b'-', ..]
            | [b'+', b'/', b'-', ..]
            | [b'-', b'/', b'+', ..]
            | [b'_', b']' | b'C' | b'_' | b'(', ..]
            | [b'C', b'[', ..]
            | [b'S', b'u', b'b', b's', b'c', ..]
            | [b'D', b'e', b'r', b'i', ..]
            | [b'>' | b'<', b' ', b'=', ..]
            | [b' ' | b'.', b'1', b'0', b'^', ..]
            | [b' ', b'E', b' ', ..]
            | [b'(', b'i', b'n', b' ', ..]
    )
}

/// Whether what stands before a bracket is a call of which the fold knows.
fn is_called(before: &str) -> bool {
    [ROOTS, NUMBERS, LISTS, EQUATIONS]
        .iter()
        .any(|names| names.iter().any(|name| before.ends_with(name)))
}

/// Whether tabs part the cells of several rows, as spreadsheets copy them.
pub(crate) fn has_cells(typed: &str) -> bool {
    let mut rows = typed.trim().lines();
    typed.trim().contains('\n') && rows.all(|row| row.trim().is_empty() || row.contains('\t'))
}

/// Whether bars part statements, `ω1 = 5 rad/s | ω2 = 6 rad/s`.
fn has_barred_statements(typed: &str) -> bool {
    let mut pieces = typed.split(" | ");
    pieces.clone().count() > 1 && pieces.all(|piece| piece.contains('=') && !piece.contains('|'))
}

/// Whether all bars stand between numbers, `(1 | -0.5)`, as schools write vectors, or between statements.
pub(crate) fn has_barred_numbers(typed: &str) -> bool {
    if has_barred_statements(typed) {
        return true;
    }
    let mut bars = typed.match_indices('|');
    typed.contains('|')
        && !typed.contains(['<', '>', '≤', '≥'])
        && bars.all(|(at, _)| {
            let behind = typed[at + 1..].trim_start();
            let unsigned = behind.strip_prefix(is_minus).unwrap_or(behind);
            typed[..at].trim_end().ends_with(is_digit)
                && unsigned.starts_with(|char| is_digit(char) || char == '.')
        })
}
