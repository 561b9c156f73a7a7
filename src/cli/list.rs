//! `vibank list`

use vibank::bank::Listing;

use super::bank::{self, BankArgument};
use super::filter::Filter;
use super::{Failure, Format, Outcome};

/// List the items of the bank, by chapter, topic, level and kind of answer.
///
/// Example: vibank list --chapter ch3 --topic "Coulomb friction" --level 2
#[derive(clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    filter: Filter,
    #[command(flatten)]
    bank: BankArgument,
    /// How the list is printed.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (catalogue, findings) = arguments.bank.unread()?;
    let (all, errors) = bank::listings(&catalogue);
    bank::warn(bank::errors(&findings) + errors);
    let items = all.iter().filter(|item| arguments.filter.wants(item));
    let items: Vec<&Listing> = items.collect();
    if let Format::Json = arguments.format {
        println!(
            "{}",
            serde_json::to_string(&items).expect("rows are plain data")
        );
        return Ok(Outcome::Done);
    }
    let widest = items.iter().map(|item| item.id.as_str().len()).max();
    let width = widest.unwrap_or_default();
    let mut chapter = "";
    for item in &items {
        if item.id.chapter() != chapter {
            chapter = item.id.chapter();
            let title = catalogue
                .chapters
                .iter()
                .find(|known| known.folder == chapter)
                .map_or("", |known| &known.title);
            println!(
                "{}{chapter}  {title}",
                if item.id == items[0].id { "" } else { "\n" }
            );
        }
        let stars = "*".repeat(usize::from(item.level));
        println!(
            "  {:<width$} {stars:<3}  {:>3} min  {}",
            item.id.as_str(),
            item.minutes,
            item.title
        );
    }
    if items.is_empty() {
        if let Some(failure) = arguments.filter.unknown(&all) {
            return Err(failure);
        }
        eprintln!(
            "{}",
            if all.is_empty() {
                "the bank has no items"
            } else {
                "no item fits all of this"
            }
        );
    }
    Ok(Outcome::Done)
}
