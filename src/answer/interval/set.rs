//! Sets of numbers made of intervals.

use std::fmt::Write as _;

use crate::answer::Bounds;
use crate::math::Math;
use crate::unit::{DecimalMark, Quantity};

/// An end of an interval, in SI units; infinite where there is no bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct End {
    pub(crate) value: f64,
    pub(crate) is_open: bool,
}

/// An interval by its lower and upper end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SetPiece(pub(crate) [End; 2]);

/// Intervals without common points, ascending.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Set(pub(crate) Vec<SetPiece>);

impl End {
    /// No bound below (0) or above (1).
    pub(crate) fn none(place: usize) -> Self {
        let value = if place == 0 {
            f64::NEG_INFINITY
        } else {
            f64::INFINITY
        };
        Self {
            value,
            is_open: true,
        }
    }

    /// Its distance from zero; 0 for none.
    pub(crate) fn size(&self) -> f64 {
        if self.value.is_finite() {
            self.value.abs()
        } else {
            0.0
        }
    }

    /// Whether both are none, or lie within a half-width.
    pub(crate) fn is_near(&self, other: &Self, half: f64) -> bool {
        if !self.value.is_finite() || !other.value.is_finite() {
            return self.value == other.value;
        }
        (self.value - other.value).abs() <= half + 1e-12 * self.value.abs()
    }
}

impl SetPiece {
    /// What both have in common, if that is more than nothing.
    fn common(&self, other: &Self) -> Option<Self> {
        let tighter = |a: End, b: End, is_lower: bool| {
            if a.value == b.value {
                return End {
                    value: a.value,
                    is_open: a.is_open || b.is_open,
                };
            }
            if (a.value > b.value) == is_lower {
                a
            } else {
                b
            }
        };
        let low = tighter(self.0[0], other.0[0], true);
        let high = tighter(self.0[1], other.0[1], false);
        let is_something =
            low.value < high.value || low.value == high.value && !low.is_open && !high.is_open;
        is_something.then_some(Self([low, high]))
    }

    /// Whether the union with a piece that begins later has no gap.
    fn touches(&self, later: &Self) -> bool {
        let (end, start) = (self.0[1], later.0[0]);
        start.value < end.value || start.value == end.value && !(start.is_open && end.is_open)
    }
}

impl Set {
    /// The union of intervals.
    pub(crate) fn of(mut pieces: Vec<SetPiece>) -> Self {
        pieces.retain(|piece| piece.common(piece).is_some());
        crate::numerics::sort_by(&mut pieces, |a, b| {
            a.0[0]
                .value
                .total_cmp(&b.0[0].value)
                .then(a.0[0].is_open.cmp(&b.0[0].is_open))
        });
        let mut joined: Vec<SetPiece> = Vec::new();
        for piece in pieces {
            match joined.last_mut() {
                Some(last) if last.touches(&piece) => {
                    let (own, other) = (last.0[1], piece.0[1]);
                    let is_further =
                        other.value > own.value || other.value == own.value && !other.is_open;
                    if is_further {
                        last.0[1] = other;
                    }
                }
                _ => joined.push(piece),
            }
        }
        Self(joined)
    }

    /// What lies within an interval.
    pub(crate) fn cut(self, within: Option<&SetPiece>) -> Self {
        match within {
            None => self,
            Some(within) => Self(
                self.0
                    .iter()
                    .filter_map(|piece| piece.common(within))
                    .collect(),
            ),
        }
    }

    /// What both have in common.
    pub(crate) fn common(&self, other: &Self) -> Self {
        let pairs = self
            .0
            .iter()
            .flat_map(|a| other.0.iter().filter_map(|b| a.common(b)));
        Self::of(pairs.collect())
    }

    /// The ends of its pieces, as programs get them.
    pub(crate) fn bounds(&self) -> Vec<Bounds> {
        let bound = |end: End| end.value.is_finite().then_some(end.value);
        let bounds = |piece: &SetPiece| (piece.0.map(bound), piece.0.map(|end| end.is_open));
        self.0.iter().map(bounds).collect()
    }

    /// Whether both are one set but for the rounding of three figures.
    pub(crate) fn is_same_as(&self, other: &Self) -> bool {
        const SHARE: f64 = 0.01;
        let pieces = self.0.iter().zip(&other.0);
        let mut ends = pieces.flat_map(|(own, other)| own.0.iter().zip(&other.0));
        self.0.len() == other.0.len()
            && ends.all(|(own, other)| own.is_near(other, SHARE * own.size()))
            && self.has_ends_of(other)
    }

    /// Whether the ends of both are open alike.
    pub(crate) fn has_ends_of(&self, other: &Self) -> bool {
        let [own, other] = [self, other].map(|set| {
            set.0
                .iter()
                .flat_map(|piece| piece.0.map(|end| end.is_open))
        });
        own.eq(other)
    }

    /// As inequalities, typeset and as text.
    pub(crate) fn typeset(
        &self,
        symbol: &Math,
        name: &str,
        mark: DecimalMark,
        number: &dyn Fn(&End) -> Quantity,
    ) -> (Math, String) {
        let (mut row, mut text) = (Vec::new(), String::new());
        if self.0.is_empty() {
            return (Math::text("no value"), "none".to_owned());
        }
        for SetPiece([low, high]) in &self.0 {
            if !row.is_empty() {
                row.push(Math::text(" or "));
                text.push_str(" or ");
            }
            if low.value.is_finite() {
                let quantity = number(low);
                let (sign, plain) = if low.is_open {
                    ("<", "<")
                } else {
                    ("≤", "<=")
                };
                // One bound comes after the symbol, two around it.
                if high.value.is_finite() {
                    row.extend([quantity.math(mark), Math::relation(sign)]);
                    let _ = write!(text, "{quantity} {plain} ");
                } else {
                    let (sign, plain) = if low.is_open {
                        (">", ">")
                    } else {
                        ("≥", ">=")
                    };
                    row.extend([symbol.clone(), Math::relation(sign), quantity.math(mark)]);
                    let _ = write!(text, "{name} {plain} {quantity}");
                    continue;
                }
            }
            row.push(symbol.clone());
            text.push_str(name);
            if high.value.is_finite() {
                let quantity = number(high);
                let (sign, plain) = if high.is_open {
                    ("<", "<")
                } else {
                    ("≤", "<=")
                };
                row.extend([Math::relation(sign), quantity.math(mark)]);
                let _ = write!(text, " {plain} {quantity}");
            } else {
                row.push(Math::text(" any"));
                text.push_str(" any");
            }
        }
        (Math::row(row), text)
    }
}
