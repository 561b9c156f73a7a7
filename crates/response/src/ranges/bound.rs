//! A bound that is the answer: `k ≤ 251 N/m` where the largest stiffness is asked.

use super::Passage;
use super::marks::{Mark, marks};
use vibank_source::Span;

/// The bound of a quantity that is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AskedBound {
    /// The smallest value.
    Lower,
    /// The largest value.
    Upper,
}

impl AskedBound {
    /// Where it stands in a text that says of a quantity of such a name that it lies on the side which the bound allows:
    /// `k ≤ 251`, `251 ≥ k`, `0 < k ≤ 251`, and `≤ 251` without a name.
    pub(crate) fn place(self, text: &str, is_name: impl Fn(Passage<'_>) -> bool) -> Option<Span> {
        let marks = marks(text);
        let signs = marks.iter().filter_map(|own| match own.mark {
            Mark::Sign(sign) => Some((sign, &own.at)),
            _ => None,
        });
        let signs: Vec<_> = signs.collect();
        let ((sign, at), start) = match signs[..] {
            [only] => (only, 0),
            // What is positive anyway.
            [(zero, lower), upper] if zero.is_less && text[..lower.start].trim() == "0" => {
                (upper, lower.end)
            }
            _ => return None,
        };
        let [before, behind] = [Span::new(start, at.start), Span::new(at.end, text.len())];
        let is_subject = |side: Span| is_name(Passage::of(text[side.range()].trim()));
        let is_left_out = text[before.range()].trim().is_empty();
        let (bound, is_upper) = if is_left_out || is_subject(before) {
            (behind, sign.is_less)
        } else if is_subject(behind) {
            (before, !sign.is_less)
        } else {
            return None;
        };
        (is_upper == (self == Self::Upper)).then_some(bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(bound: AskedBound, text: &str) -> Option<&str> {
        let is_name = |side: Passage<'_>| side.is("k");
        bound.place(text, is_name).map(|at| text[at.range()].trim())
    }

    #[test]
    fn a_bound_stands_on_the_side_that_is_asked() {
        for text in ["k ≤ 251", "k < 251", "251 ≥ k", "0 < k ≤ 251", "≤ 251"] {
            assert_eq!(found(AskedBound::Upper, text), Some("251"), "{text}");
            assert_eq!(found(AskedBound::Lower, text), None, "{text}");
        }
        assert_eq!(found(AskedBound::Lower, "k > m g/l"), Some("m g/l"));
        for text in [
            "251",
            "c ≤ 251",
            "1 < k ≤ 251",
            "251 > k > 0",
            "k ≤ 1 ≤ 2 ≤ 3",
        ] {
            assert_eq!(found(AskedBound::Upper, text), None, "{text}");
        }
    }
}
