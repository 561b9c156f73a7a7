//! Requests that come one after the other: what was solved for one is kept for the next.

use std::collections::BTreeMap;
use std::rc::Rc;

use serde_json::{Map, Value as Json};

use super::Solution;
use super::request::{Refusal, instance};
use crate::answer::Doubt;
use crate::bank::{Catalogue, Template};
use crate::unit::DecimalMark;

/// Solutions that are kept. One with all its parts prepared takes up to half a megabyte, so that these are the whole bank
/// for one set of data, and no more than some fifty megabytes.
const MAX_KEPT: usize = 128;
/// Longest data, as they were set, of a solution that is kept.
const MAX_DATA_LENGTH: usize = 4096;

/// Answers requests about the items of a bank, and keeps the solutions that were asked for lately.
///
/// ```
/// # #[cfg(feature = "render")] {
/// use vibank::bank::{Catalogue, embedded};
/// use vibank::grade;
/// use vibank::solution::Session;
///
/// let (catalogue, _) = Catalogue::load(embedded());
/// let mut session = Session::new(&catalogue);
/// let line = r#"{"id":"ch2/e8-springs-parallel-series","part":"k_par","response":"k2 + k1"}"#;
/// assert!(grade::request::answer(&mut session, line).starts_with(r#"{"verdict":"right""#));
/// # }
/// ```
pub struct Session<'c> {
    catalogue: &'c Catalogue,
    kept: BTreeMap<SessionKey, KeptSolution<'c>>,
    /// Requests so far.
    count: u64,
    /// Whether the last item that was asked for does not exist; then the next one is not searched for either.
    is_lost: bool,
}

/// What makes a solution: the item, the seed, what is set as it was written, how doubts are settled, and the decimal sign.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct SessionKey {
    item: String,
    seed: Option<u64>,
    set: String,
    doubt: Doubt,
    mark: char,
}

struct KeptSolution<'c> {
    solution: Rc<Solution<'c>>,
    /// The request that asked for it last.
    last: u64,
}

impl<'c> Session<'c> {
    /// A session with a bank; nothing is solved yet.
    pub fn new(catalogue: &'c Catalogue) -> Self {
        Self {
            catalogue,
            kept: BTreeMap::new(),
            count: 0,
            is_lost: false,
        }
    }

    /// An item.
    ///
    /// # Errors
    ///
    /// A refusal; the first of several in a row names the nearest item.
    pub(crate) fn find(&mut self, id: &str) -> Result<&'c Template, Refusal> {
        let found = self.catalogue.find(id);
        let is_first = !std::mem::replace(&mut self.is_lost, found.is_none());
        found.ok_or_else(|| {
            if self.catalogue.has(id) {
                let message = format!("the item `{id}` has findings that `vibank check` shows");
                return Refusal::new("unknown-item", message);
            }
            let near = self.catalogue.nearest(id).filter(|_| is_first);
            let near = near.map(|near| format!(", did you mean `{near}`?"));
            let near = near.unwrap_or_default();
            Refusal::new("unknown-item", format!("there is no item `{id}`{near}"))
        })
    }

    /// The solution of an item for the data of a request.
    ///
    /// # Errors
    ///
    /// What is wrong with the data.
    pub(crate) fn solution(
        &mut self,
        template: &'c Template,
        seed: Option<u64>,
        set: &Map<String, Json>,
        doubt: Doubt,
        mark: DecimalMark,
    ) -> Result<Rc<Solution<'c>>, Refusal> {
        self.count += 1;
        let data = SessionKey {
            item: template.id.to_string(),
            seed,
            set: if set.is_empty() {
                String::new()
            } else {
                Json::Object(set.clone()).to_string()
            },
            doubt,
            mark: mark.char(),
        };
        if let Some(kept) = self.kept.get_mut(&data) {
            kept.last = self.count;
            return Ok(Rc::clone(&kept.solution));
        }
        let solution = Solution::with_mark(instance(template, seed, set)?, mark).settling(doubt);
        let solution = Rc::new(solution);
        if data.set.len() <= MAX_DATA_LENGTH {
            self.keep(data, Rc::clone(&solution));
        }
        Ok(solution)
    }

    /// Keeps a solution in place of the one that was not asked for for longest.
    fn keep(&mut self, data: SessionKey, solution: Rc<Solution<'c>>) {
        if self.kept.len() >= MAX_KEPT {
            let oldest = self.kept.values().map(|kept| kept.last).min();
            self.kept.retain(|_, kept| Some(kept.last) != oldest);
        }
        let last = self.count;
        self.kept.insert(data, KeptSolution { solution, last });
    }
}

#[cfg(all(test, feature = "render"))]
mod tests {
    use super::*;
    use crate::bank::embedded;

    #[test]
    fn a_solution_is_kept_by_item_seed_and_data_and_their_number_is_bounded() {
        let (catalogue, _) = Catalogue::open(embedded());
        let mut session = Session::new(&catalogue);
        let template = session
            .find("ch2/e8-springs-parallel-series")
            .expect("an item");
        let none = Map::new();
        let mut of = |seed, set: &Map<String, Json>| {
            let solution = session.solution(template, seed, set, Doubt::Ask, DecimalMark::Point);
            solution.expect("a solution")
        };
        let first = of(Some(1), &none);
        assert!(Rc::ptr_eq(&first, &of(Some(1), &none)));
        assert!(!Rc::ptr_eq(&first, &of(Some(2), &none)));
        let set = Map::from_iter([("k1".to_owned(), Json::from("200 N/m"))]);
        assert!(!Rc::ptr_eq(&first, &of(Some(1), &set)));
        for seed in 2..1000 {
            of(Some(seed), &none);
        }
        assert!(!Rc::ptr_eq(&first, &of(Some(1), &none)));
        assert_eq!(session.kept.len(), MAX_KEPT);
    }

    #[test]
    fn the_nearest_item_is_named_once_in_a_row() {
        let (catalogue, _) = Catalogue::open(embedded());
        let mut session = Session::new(&catalogue);
        let mut words = |id| {
            let refusal = session.find(id).err();
            refusal.map(|refusal| refusal.message).unwrap_or_default()
        };
        let typo = "ch2/e8-springs-paralel-series";
        assert!(words(typo).contains("did you mean"));
        assert!(!words(typo).contains("did you mean"));
        assert_eq!(words("ch2/e8-springs-parallel-series"), "");
        assert!(words(typo).contains("did you mean"));
    }
}
