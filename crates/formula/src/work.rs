//! Units of work: what a calculation may cost, counted so that a bound is the same on every machine.
//!
//! A unit is about one step of a program in binary64, or one product of two terms of a formula: some ten
//! nanoseconds. Whoever takes input that nobody has looked over opens a budget ([`within`]); what loops or grows
//! spends from it ([`spend`]) and stops when it is used up. Budgets nest: an inner one never holds more than is left
//! of the outer one. A budget belongs to its thread, since it would otherwise have to pass through each function
//! between a file and the products of its formulas; where none is open, nothing is bounded here.

use std::cell::{Cell, RefCell};

/// The budget of a thread is used up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exhausted;

/// What a task gave, and what it cost.
#[derive(Clone, Copy, Debug)]
pub struct Spent<T> {
    /// What the task gave.
    pub value: T,
    /// The units that it took.
    pub units: u64,
    /// Whether it asked for more than it had; its result is then not complete.
    pub is_exhausted: bool,
}

#[derive(Clone, Copy)]
struct Budget {
    left: u64,
    is_exhausted: bool,
    /// Whether what is kept beyond its task is paid by the budget around it.
    is_for_one: bool,
}

thread_local! {
    static BUDGET: Cell<Budget> = const { Cell::new(Budget { left: u64::MAX, is_exhausted: false, is_for_one: false }) };
    /// Those around it, the outermost first.
    static OUTER: RefCell<Vec<Budget>> = const { RefCell::new(Vec::new()) };
}

/// Runs a task that may take this many units of work.
///
/// ```
/// use vibank_formula::work::{Exhausted, spend, within};
/// let task = within(100, || (spend(60), spend(60), spend(1)));
/// // What is used up stays so: what came out is incomplete, and cheap operations would only hide that.
/// assert_eq!(task.value, (Ok(()), Err(Exhausted), Err(Exhausted)));
/// assert!(task.is_exhausted);
/// ```
pub fn within<T>(units: u64, task: impl FnOnce() -> T) -> Spent<T> {
    open(units, false, task)
}

/// The same for one of many tasks that share what they compute: that is done [`aside`].
pub fn for_one<T>(units: u64, task: impl FnOnce() -> T) -> Spent<T> {
    open(units, true, task)
}

fn open<T>(units: u64, is_for_one: bool, task: impl FnOnce() -> T) -> Spent<T> {
    let outer = BUDGET.get();
    let limit = units.min(outer.left);
    OUTER.with_borrow_mut(|budgets| budgets.push(outer));
    let scope = BudgetScope { limit };
    BUDGET.set(Budget {
        left: limit,
        is_exhausted: false,
        is_for_one,
    });
    let value = task();
    let inner = BUDGET.get();
    drop(scope);
    Spent {
        value,
        units: limit - inner.left,
        is_exhausted: inner.is_exhausted,
    }
}

/// Computes what is kept beyond one of many tasks: the budget around that of the task pays for it, so that it does not
/// depend on which task was first. Elsewhere the open budget pays.
///
/// ```
/// use vibank_formula::work::{aside, for_one, spend, within};
/// let one = for_one(10, || (aside(|| spend(100)), spend(11)));
/// assert!(one.value.0.is_ok() && one.value.1.is_err());
/// assert!(within(10, || aside(|| spend(100))).value.is_err());
/// ```
pub fn aside<T>(task: impl FnOnce() -> T) -> T {
    if !BUDGET.get().is_for_one {
        return task();
    }
    let Some(outer) = OUTER.with_borrow_mut(Vec::pop) else {
        return task();
    };
    let inner = BUDGET.replace(outer);
    let _scope = Aside { inner };
    task()
}

/// Takes units from the budget that is open.
///
/// # Errors
///
/// Where it holds less, or was used up before.
#[inline]
pub fn spend(units: u64) -> Result<(), Exhausted> {
    let budget = BUDGET.get();
    match budget.left.checked_sub(units) {
        Some(left) if !budget.is_exhausted => {
            BUDGET.set(Budget { left, ..budget });
            Ok(())
        }
        _ => {
            BUDGET.set(Budget {
                left: 0,
                is_exhausted: true,
                ..budget
            });
            Err(Exhausted)
        }
    }
}

/// Work in pieces, each of which adds to what the next ones may take: many pieces may cost much, a few may not.
///
/// ```
/// use vibank_formula::work::{Allowance, spend};
/// let mut allowance = Allowance::new(50, 10);
/// // The pieces take 30 each, and 10 are added before each.
/// let pieces = (1..).take_while(|_| allowance.take(|| spend(30)).is_some());
/// assert_eq!(pieces.count(), 2);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    left: u64,
    each: u64,
}

impl Allowance {
    /// Units for all pieces together, and units that each piece adds.
    pub const fn new(first: u64, each: u64) -> Self {
        Self { left: first, each }
    }

    /// What this many pieces may take together, none having been run yet.
    pub fn after(&self, pieces: u64) -> u64 {
        self.left.saturating_add(pieces.saturating_mul(self.each))
    }

    /// Runs a piece; `None` where it asks for more than is left, so that what it gave is not complete.
    pub fn take<T>(&mut self, piece: impl FnOnce() -> T) -> Option<T> {
        self.left += self.each;
        let spent = within(self.left, piece);
        self.left -= spent.units;
        (!spent.is_exhausted).then_some(spent.value)
    }
}

/// Gives the outer budget back, less what was spent, also where the task panics.
struct BudgetScope {
    limit: u64,
}

impl Drop for BudgetScope {
    fn drop(&mut self) {
        let inner = BUDGET.get();
        let outer = OUTER.with_borrow_mut(Vec::pop).unwrap_or(inner);
        // Without an outer budget nothing is counted; what was spent aside was taken from it already.
        let left = match outer.left {
            u64::MAX => u64::MAX,
            left => left.saturating_sub(self.limit - inner.left),
        };
        // Who held all that was left used up the outer one too.
        let is_exhausted = inner.is_exhausted && left == 0;
        BUDGET.set(Budget {
            left,
            is_exhausted: outer.is_exhausted || is_exhausted,
            ..outer
        });
    }
}

/// Gives the inner budget back, also where the task panics.
struct Aside {
    inner: Budget,
}

impl Drop for Aside {
    fn drop(&mut self) {
        let outer = BUDGET.replace(self.inner);
        OUTER.with_borrow_mut(|budgets| budgets.push(outer));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inner_budget_takes_from_the_outer_one() {
        let outer = within(100, || {
            let inner = within(1_000, || spend(70).and_then(|()| spend(70)));
            (inner.units, inner.is_exhausted, spend(1))
        });
        // The inner one held the 100 of the outer one, and used them up.
        assert_eq!(outer.value, (100, true, Err(Exhausted)));
        assert_eq!(outer.units, 100);
        let outer = within(100, || within(100, || spend(101)).is_exhausted);
        assert!(outer.value && outer.is_exhausted);
        let outer = within(100, || within(50, || spend(51)).is_exhausted);
        assert!(outer.value && !outer.is_exhausted && outer.units == 50);
    }

    #[test]
    fn what_is_done_aside_is_paid_by_the_outer_budget() {
        let outer = within(100, || {
            let inner = for_one(50, || (aside(|| spend(70)), spend(20)));
            (inner.value, inner.units, spend(10), spend(1))
        });
        let exhausted = Err(Exhausted);
        assert_eq!(outer.value, ((Ok(()), Ok(())), 20, Ok(()), exhausted));
        let outer = within(100, || for_one(50, || aside(|| spend(101))).value);
        assert!(outer.value.is_err() && outer.is_exhausted);
        assert_eq!(aside(|| spend(1)), Ok(()));
    }

    #[test]
    fn a_budget_ends_with_its_task() {
        assert!(within(10, || spend(11)).is_exhausted);
        assert_eq!(spend(u64::MAX - 1), Ok(()));
    }
}
