//! `vibank list`

use rayon::prelude::*;
use serde_json::json;
use vibank::bank::{Catalogue, ItemId, Template};

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

/// What the list has of an item.
struct Row {
    id: ItemId,
    level: u8,
    minutes: u32,
    title: String,
    /// For programs, where the list is for them.
    entry: Option<serde_json::Value>,
}

impl Row {
    fn of(item: &Template, format: Format) -> Self {
        Self {
            id: item.id.clone(),
            level: item.about.level,
            minutes: item.minutes(),
            title: item.about.title.clone(),
            entry: matches!(format, Format::Json).then(|| entry(item)),
        }
    }
}

/// The rows of the items that pass the filter, and the number of errors in all of them.
///
/// Each item is read, looked at and dropped, so that a large bank takes no more memory than its rows.
fn rows(catalogue: &Catalogue, arguments: &Arguments) -> (Vec<Row>, usize) {
    let ids: Vec<&ItemId> = catalogue.ids().collect();
    let looked = ids.par_iter().map(|id| {
        let (item, findings) = catalogue.read_apart(id);
        let item = item.filter(|item| arguments.filter.wants(item));
        let row = item.map(|item| Row::of(&item, arguments.format));
        (row, bank::errors(&findings))
    });
    let looked: Vec<(Option<Row>, usize)> = looked.collect();
    let errors = looked.iter().map(|(_, errors)| errors).sum();
    (
        looked.into_iter().filter_map(|(row, _)| row).collect(),
        errors,
    )
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (catalogue, findings) = arguments.bank.unread()?;
    let (items, errors) = rows(&catalogue, arguments);
    bank::warn(bank::errors(&findings) + errors);
    if let Format::Json = arguments.format {
        let entries = items.into_iter().filter_map(|row| row.entry);
        println!("{}", serde_json::Value::Array(entries.collect()));
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
        if let Some(failure) = arguments.filter.unknown(&catalogue) {
            return Err(failure);
        }
        eprintln!("no item fits all of this");
    }
    Ok(Outcome::Done)
}

fn entry(item: &Template) -> serde_json::Value {
    json!({
        "id": item.id,
        "revision": item.revision,
        "title": item.about.title,
        "source": item.about.source,
        "topics": item.about.topics.iter().map(|topic| &topic.value).collect::<Vec<_>>(),
        "level": item.about.level,
        "minutes": item.minutes(),
        "parts": item.parts.iter().map(|part| json!({ "id": part.id, "kind": part.answer.kind().name() })).collect::<Vec<_>>(),
        "instances": item.instances(),
    })
}
