//! `vibank practice [ITEM]`

mod log;
mod session;

use std::hash::{BuildHasher, RandomState};
use std::io::IsTerminal;
use std::path::PathBuf;

use vibank::answer::Doubt;
use vibank::bank::{Catalogue, ItemId, Template};
use vibank::instance::Instance;
use vibank::seed::{Seed, Streams};
use vibank::solution::Solution;
use vibank::suitability;

use self::log::Log;
use self::session::{Session, SessionEnd};
use super::bank::{self, BankArgument};
use super::doubt::doubt;
use super::filter::Filter;
use super::screen::Screen;
use super::{Failure, Outcome};

/// Practise in the terminal: an exercise with numbers of its own, feedback on each answer, hints, worked solutions.
///
/// Type an answer as you would write it. `?` gives a hint, `!` shows the answer, `>` passes on, `quit` ends.
/// Nothing is kept unless `--log` asks for it. Answers can also come from a pipe, one a line.
///
/// Example: vibank practice ch3 --level 1
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// An item, a chapter, a topic, or a word of a title; all items if left out.
    item: Option<String>,
    #[command(flatten)]
    filter: Filter,
    /// Repeat the session of this seed.
    #[arg(short, long)]
    seed: Option<u64>,
    /// What becomes of an answer with two readings of which one is right.
    #[arg(long, value_name = "POLICY", default_value = "ask", value_parser = doubt())]
    doubt: Doubt,
    /// Stop after this many exercises.
    #[arg(long, value_name = "COUNT")]
    count: Option<usize>,
    /// Append what was answered, one JSON object a line.
    #[arg(long, value_name = "FILE")]
    log: Option<PathBuf>,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (catalogue, findings) = arguments.bank.unread()?;
    let items = chosen(arguments, &catalogue, bank::errors(&findings))?;
    let seed = arguments
        .seed
        .unwrap_or_else(|| RandomState::new().hash_one("vibank practice") % 1_000_000);
    let mut session = Session::begin(Screen::of_stdout(), Log::open(arguments.log.as_deref())?);
    session.welcome(items.len(), seed);
    let is_typed = std::io::stdin().is_terminal();
    // From a pipe one round through the items is enough; who types goes on as long as they like.
    let rounds = if is_typed { u64::MAX } else { 1 };
    let streams = Streams::of(Seed::new(seed), "practice");
    let (mut number, most) = (0_u64, arguments.count.unwrap_or(usize::MAX) as u64);
    'rounds: for round in 0..rounds {
        for at in streams
            .named(&format!("round {round}"))
            .permutation(items.len())
        {
            if number == most {
                break 'rounds;
            }
            let item = catalogue.find(items[at].as_str());
            let item =
                item.ok_or_else(|| Failure::new(format!("`{}` cannot be used", items[at])))?;
            let solution = instance(item, seed, number)?.settling(arguments.doubt);
            if let SessionEnd::Session = session.exercise(&solution)? {
                break 'rounds;
            }
            number += 1;
        }
    }
    session.finish();
    Ok(Outcome::Done)
}

/// The items that are meant, in the order of the bank; errors in the bank are reported, with those that are known.
fn chosen(
    arguments: &Arguments,
    catalogue: &Catalogue,
    errors: usize,
) -> Result<Vec<ItemId>, Failure> {
    let wanted = arguments.item.as_deref().unwrap_or_default();
    if let Some(item) = catalogue.find(wanted) {
        return Ok(vec![item.id.clone()]);
    }
    let (all, further) = bank::listings(catalogue);
    bank::warn(errors + further);
    arguments.filter.named(wanted, &all, catalogue)
}

/// The first suitable instance for an exercise of a session.
fn instance(template: &Template, seed: u64, number: u64) -> Result<Solution<'_>, Failure> {
    // An item that is suitable at all is so within a few draws; the bound ends the search where it never is.
    const MAX_TRIES: u64 = 200;
    let stream = Streams::of(Seed::new(seed), template.id.as_str());
    let mut seeds = stream.named(&format!("exercise {number}"));
    let parts: Vec<usize> = (0..template.parts.len()).collect();
    let mut next_best = None;
    for _ in 0..MAX_TRIES {
        // Seeds that are short to type again in `vibank show --seed`.
        let seed = Seed::new(seeds.below(1_000_000));
        let instance = Instance::draw(template, seed).map_err(Failure::of)?;
        let solution = Solution::of(instance);
        match suitability::judge(&solution, &parts) {
            Ok(()) if suitability::judge_methods(&solution, &parts).is_ok() => {
                return Ok(Solution::of(solution.instance().clone()));
            }
            Ok(()) => next_best = Some(solution),
            Err(_) => next_best = next_best.or(Some(solution)),
        }
    }
    next_best.ok_or_else(|| Failure::new(format!("`{}` has no suitable data", template.id)))
}
