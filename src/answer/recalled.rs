//! Right answers in letters, recalled when the next one types the same.
//!
//! Whether a formula or an equation is right is no matter of the data on a sheet ([`equality`](super::equality)): what was
//! right for one student is right for the next one whose data have the same signs, with the same reading. So nothing
//! is read or compared for it again. Only what is right without a remark is kept: all else may depend on the data, and on
//! earlier answers.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::equality::Signs;
use super::{Context, Doubt, Marking, Verdict};
use crate::numerics::SortedMap;
use crate::unit::DecimalMark;

/// Grounds for which a part keeps answers: a class has the signs of its data and a few sets of mistakes.
const MAX_GROUNDS: usize = 16;
/// Answers that are kept: a class types the formula of a part in some dozens of spellings.
const MAX_KEPT: usize = 64;
/// The longest answer that is kept, in bytes: with its reading it takes some tens of times as many.
const MAX_LENGTH: usize = 200;

/// What a verdict rests on, besides what was typed.
#[derive(Debug, PartialEq)]
struct Grounds {
    signs: Signs,
    /// The numbers of the mistakes that are such for the data.
    mistakes: Vec<usize>,
    mark: DecimalMark,
    doubt: Doubt,
}

/// The right answers to a part.
#[derive(Debug, Default)]
pub(crate) struct RightAnswers(Mutex<Vec<(Grounds, Arc<Recalled>)>>);

/// The right answers to a part on the same grounds, with their markings.
#[derive(Debug, Default)]
pub struct Recalled(Mutex<SortedMap<String, Marking>>);

impl RightAnswers {
    /// Those for these data; none where formulas of a student stand in for the key.
    pub(crate) fn on(&self, signs: Signs, context: &Context<'_>) -> Option<Arc<Recalled>> {
        // In a page one person answers.
        if cfg!(not(feature = "render")) || !context.standing.is_empty() {
            return None;
        }
        let mistakes = context.mistakes.iter().map(|own| own.number);
        let grounds = Grounds {
            signs,
            mistakes: mistakes.collect(),
            mark: context.mark,
            doubt: context.doubt,
        };
        // A panic elsewhere leaves the answers as they were: each is added whole.
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = kept.iter().find(|(own, _)| *own == grounds) {
            return Some(Arc::clone(known));
        }
        let known = (kept.len() < MAX_GROUNDS).then(Arc::<Recalled>::default)?;
        kept.push((grounds, Arc::clone(&known)));
        Some(known)
    }
}

impl Recalled {
    /// The marking of what was typed, if it is known.
    pub(crate) fn get(&self, typed: &str) -> Option<Marking> {
        self.kept().get(typed).cloned()
    }

    /// Whether what was typed is known.
    pub(crate) fn has(&self, typed: &str) -> bool {
        self.kept().get(typed).is_some()
    }

    /// Keeps the marking of what was typed, if it is right without a remark and `has_one_form`: what is said in letters
    /// and as a value is compared for each of the data.
    pub(crate) fn keep(&self, typed: &str, marking: &Marking, has_one_form: impl Fn() -> bool) {
        let is_plain = marking.verdict == Verdict::Right && marking.remarks.is_empty();
        if !is_plain || typed.len() > MAX_LENGTH || !has_one_form() {
            return;
        }
        let mut kept = self.kept();
        if kept.len() < MAX_KEPT {
            kept.insert(typed.to_owned(), marking.clone());
        }
    }

    fn kept(&self) -> MutexGuard<'_, SortedMap<String, Marking>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
