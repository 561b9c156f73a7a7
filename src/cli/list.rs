//! `vibank list`

use serde_json::json;
use vibank::bank::Template;

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
    let catalogue = arguments.bank.catalogue()?;
    bank::read_all(&catalogue);
    let items: Vec<&Template> = catalogue
        .items()
        .filter(|item| arguments.filter.wants(item))
        .collect();
    if let Format::Json = arguments.format {
        let entries: Vec<_> = items.iter().map(|item| entry(item)).collect();
        println!("{}", serde_json::Value::Array(entries));
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
        let stars = "*".repeat(usize::from(item.about.level));
        println!(
            "  {:<width$} {stars:<3}  {:>3} min  {}",
            item.id.as_str(),
            item.minutes(),
            item.about.title
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
