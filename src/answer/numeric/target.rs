//! Numbers that are right, and how far from them is right, too.

use crate::numerics::Dd;

/// A typed number in SI units, to about 106 bits.
pub(crate) type Typed = Dd;

/// A number that is right, and how far from it is right, too; all in SI units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub(crate) value: f64,
    /// Bound on its own error.
    pub(crate) bound: f64,
    pub(crate) half: f64,
}

impl Target {
    /// Whether a number is right. The comparison is made with twice the digits, so that a response
    /// on the boundary is inside, whatever the rounding of decimals to binary does.
    pub(crate) fn accepts(&self, typed: Typed, modulo: Option<f64>) -> bool {
        self.distance(typed, modulo) <= self.half + self.slack()
    }

    pub(crate) fn distance(&self, typed: Typed, modulo: Option<f64>) -> f64 {
        let difference = (typed - Dd::from(self.value)).hi();
        match modulo {
            None => difference.abs(),
            Some(period) => (difference - period * (difference / period).round()).abs(),
        }
    }

    /// What rounding of the key and of its tolerance may take away.
    pub(crate) fn slack(&self) -> f64 {
        self.bound + 4.0 * f64::EPSILON * (self.value.abs() + self.half)
    }
}

/// The greatest number of typed values that can be paired with targets; in order, or in any.
pub(crate) fn pair(
    targets: &[Target],
    typed: &[Typed],
    modulo: Option<f64>,
    is_ordered: bool,
) -> usize {
    if is_ordered {
        return targets
            .iter()
            .zip(typed)
            .filter(|(target, typed)| target.accepts(**typed, modulo))
            .count();
    }
    let mut owner: Vec<Option<usize>> = vec![None; typed.len()];
    (0..targets.len())
        .filter(|target| {
            augment(
                *target,
                targets,
                typed,
                modulo,
                &mut owner,
                &mut vec![false; typed.len()],
            )
        })
        .count()
}

/// Finds a typed value for a target, moving earlier pairs where that makes room.
fn augment(
    target: usize,
    targets: &[Target],
    typed: &[Typed],
    modulo: Option<f64>,
    owner: &mut [Option<usize>],
    seen: &mut [bool],
) -> bool {
    for place in 0..typed.len() {
        if seen[place] || !targets[target].accepts(typed[place], modulo) {
            continue;
        }
        seen[place] = true;
        let is_free = match owner[place] {
            None => true,
            Some(other) => augment(other, targets, typed, modulo, owner, seen),
        };
        if is_free {
            owner[place] = Some(target);
            return true;
        }
    }
    false
}
