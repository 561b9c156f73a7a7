//! Sums inside of atoms: what stands under a root or in the brackets of a function.

use std::cmp::Ordering;
use std::ops::Deref;
use std::sync::Arc;

use super::term::Polynomial;

/// A sum inside of an atom, shared by all its copies.
#[derive(Clone, Debug)]
pub(crate) struct Inner(Arc<Nested>);

#[derive(Debug)]
struct Nested {
    sum: Polynomial,
    /// How many atoms stand in each other at most: comparing two sums may look into all of them.
    depth: u32,
}

impl Inner {
    pub(crate) fn depth(&self) -> u32 {
        self.0.depth
    }

    /// The same for all copies, and for no other sum while one of them lives.
    pub(crate) fn address(&self) -> *const Polynomial {
        &raw const self.0.sum
    }
}

impl From<Polynomial> for Inner {
    fn from(sum: Polynomial) -> Self {
        let atoms = sum.0.keys().flat_map(|monomial| &monomial.0);
        let depth = atoms.map(|(atom, _)| atom.depth()).max().unwrap_or(0);
        Self(Arc::new(Nested { sum, depth }))
    }
}

impl Deref for Inner {
    type Target = Polynomial;

    fn deref(&self) -> &Polynomial {
        &self.0.sum
    }
}

impl PartialEq for Inner {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.0.depth == other.0.depth && **self == **other
    }
}

impl Eq for Inner {}

impl PartialOrd for Inner {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Inner {
    fn cmp(&self, other: &Self) -> Ordering {
        if Arc::ptr_eq(&self.0, &other.0) {
            return Ordering::Equal;
        }
        (**self).cmp(&**other)
    }
}
