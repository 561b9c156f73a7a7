//! Which items of the bank are meant.

use std::collections::BTreeSet;
use std::path::Path;

use vibank::bank::{Catalogue, ItemId, Listing, Template};
use vibank::source::nearest;

use super::{Failure, bank};

/// What a command is given in the place of a blueprint.
pub(crate) enum Given<'a> {
    /// The path of a blueprint.
    Blueprint(&'a Path),
    /// A word that names items.
    Word(&'a str),
}

impl<'a> Given<'a> {
    /// A blueprint is a file, and its name ends with `.toml`; anything else may be the name of an item.
    pub(crate) fn of(given: &'a Path) -> Self {
        let is_blueprint =
            given.exists() || given.extension().is_some_and(|ending| ending == "toml");
        match given.to_str() {
            Some(word) if !is_blueprint => Self::Word(word),
            _ => Self::Blueprint(given),
        }
    }
}

/// Items by chapter, topic, level and kind of answer.
#[derive(clap::Args)]
pub(crate) struct Filter {
    /// Items of this chapter, such as ch3.
    #[arg(long)]
    chapter: Option<String>,
    /// Items with this topic.
    #[arg(long)]
    topic: Option<String>,
    /// Items of this level, 1 to 3.
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=3))]
    level: Option<u8>,
    /// Items with a part of this kind, such as numeric.
    #[arg(long)]
    kind: Option<String>,
}

impl Filter {
    /// Whether nothing is stated.
    pub(crate) fn is_open(&self) -> bool {
        self.chapter.is_none()
            && self.topic.is_none()
            && self.level.is_none()
            && self.kind.is_none()
    }

    /// Whether an item passes.
    pub(crate) fn wants(&self, item: &Listing) -> bool {
        self.marks(item)
            .into_iter()
            .all(|(_, wanted, found)| wanted.is_none_or(|wanted| has(&found, wanted)))
            && self.level.is_none_or(|level| level == item.level)
    }

    /// The items of a catalogue that pass, all of which are read.
    ///
    /// # Errors
    ///
    /// Why none does.
    pub(crate) fn items<'c>(&self, catalogue: &'c Catalogue) -> Result<Vec<&'c Template>, Failure> {
        bank::read_all(catalogue);
        let all: Vec<(&Template, Listing)> = catalogue
            .items()
            .map(|item| (item, Listing::of(item)))
            .collect();
        let wanted = all.iter().filter(|(_, row)| self.wants(row));
        let wanted: Vec<&Template> = wanted.map(|(item, _)| *item).collect();
        if wanted.is_empty() {
            let rows: Vec<Listing> = all.into_iter().map(|(_, row)| row).collect();
            return Err(self.refusal(&rows));
        }
        Ok(wanted)
    }

    /// The items that a word names, all of which are read; those that pass where there is none.
    ///
    /// # Errors
    ///
    /// Why there is none.
    pub(crate) fn items_of<'c>(
        &self,
        word: Option<&str>,
        catalogue: &'c Catalogue,
    ) -> Result<Vec<&'c Template>, Failure> {
        let Some(word) = word else {
            return self.items(catalogue);
        };
        if let Some(item) = catalogue.find(word) {
            return Ok(vec![item]);
        }
        bank::read_all(catalogue);
        let all: Vec<Listing> = catalogue.items().map(Listing::of).collect();
        let named = self.named(word, &all, catalogue)?.into_iter();
        Ok(named.filter_map(|id| catalogue.find(id.as_str())).collect())
    }

    /// The items among these that a word names and that pass: those of a chapter or a topic, and those in whose title or
    /// identity it stands. An empty word names all.
    ///
    /// # Errors
    ///
    /// Why there is none.
    pub(crate) fn named(
        &self,
        word: &str,
        all: &[Listing],
        catalogue: &Catalogue,
    ) -> Result<Vec<ItemId>, Failure> {
        let items = all.iter();
        let items: Vec<ItemId> = items
            .filter(|item| self.wants(item) && is_named(item, word))
            .map(|item| item.id.clone())
            .collect();
        if !items.is_empty() {
            return Ok(items);
        }
        if word.is_empty() || self.unknown(all).is_some() {
            return Err(self.refusal(all));
        }
        if catalogue.has(word) {
            let failure = Failure::new(format!("there is something wrong with the item `{word}`"));
            return Err(failure.help(format!("`vibank check {word}` shows what it is")));
        }
        let failure = Failure::new(format!("no item fits `{word}`"));
        Err(match catalogue.nearest(word) {
            Some(near) => failure.help(format!("did you mean `{near}`?")),
            None => failure.help("`vibank list` shows all items, chapters and topics"),
        })
    }

    /// Why no item passes.
    pub(crate) fn refusal(&self, all: &[Listing]) -> Failure {
        self.unknown(all).unwrap_or_else(|| {
            Failure::new("no item fits all of this")
                .help("`vibank list` shows all items, chapters and topics")
        })
    }

    /// A wanted word that fits no item of the bank, with what would.
    pub(crate) fn unknown(&self, all: &[Listing]) -> Option<Failure> {
        let all: Vec<_> = all.iter().map(|item| self.marks(item)).collect();
        (0..all.first()?.len()).find_map(|at| {
            let (name, wanted, _) = all[0][at];
            let wanted = wanted?;
            let found: BTreeSet<&str> = all.iter().flat_map(|marks| marks[at].2.clone()).collect();
            let known: Vec<&str> = found.into_iter().collect();
            if has(&known, wanted) {
                return None;
            }
            let help = match nearest(wanted, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("the bank has {}", known.join(", ")),
            };
            Some(Failure::new(format!("no item has the {name} `{wanted}`")).help(help))
        })
    }

    /// What is wanted of the chapter, the topics and the kinds of an item, beside what it has.
    fn marks<'a>(
        &'a self,
        item: &'a Listing,
    ) -> [(&'static str, Option<&'a String>, Vec<&'a str>); 3] {
        let topics = item.topics.iter().map(String::as_str);
        let kinds = item.parts.iter().map(|part| part.kind.as_str());
        [
            ("chapter", self.chapter.as_ref(), vec![item.id.chapter()]),
            ("topic", self.topic.as_ref(), topics.collect()),
            ("kind", self.kind.as_ref(), kinds.collect()),
        ]
    }
}

/// Whether a word names the chapter or a topic of an item, or stands in its title or identity.
fn is_named(item: &Listing, word: &str) -> bool {
    let word = word.to_lowercase();
    item.id.chapter() == word
        || item.topics.iter().any(|topic| topic.to_lowercase() == word)
        || item.title.to_lowercase().contains(&word)
        || !item.id.chapter().contains(&word) && item.id.as_str().contains(&word)
}

fn has(found: &[&str], wanted: &str) -> bool {
    found.iter().any(|found| found.eq_ignore_ascii_case(wanted))
}
