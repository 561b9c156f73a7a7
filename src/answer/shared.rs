//! What is the same for all data of a part: compiled when it is first asked for, and then shared by all instances.

use std::sync::{Arc, Mutex, PoisonError};

use crate::numerics::SortedMap;

/// Values by number, each made once; a value that cannot be made is not tried again.
#[derive(Debug)]
pub(crate) struct Shared<T>(Mutex<SortedMap<usize, Option<Arc<T>>>>);

/// The number of what belongs to a key.
pub(crate) const KEY: usize = 0;

/// The number of what belongs to a named mistake.
pub(crate) fn of_mistake(number: usize) -> usize {
    number + 1
}

impl<T> Default for Shared<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> Shared<T> {
    /// The value of this number.
    pub(crate) fn get(&self, number: usize, make: impl FnOnce() -> Option<T>) -> Option<Arc<T>> {
        // A panic elsewhere leaves the values as they were: each is put in whole.
        let mut values = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let value = values.get_or_insert_with(number, || make().map(Arc::new));
        value.clone()
    }
}
