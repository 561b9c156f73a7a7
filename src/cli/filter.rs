//! Which items of the bank are meant.

use std::collections::BTreeSet;

use vibank::bank::{Catalogue, Listing, Template};
use vibank::source::nearest;

use super::{Failure, bank};

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
        let is_wanted = |(_, wanted, found): (&str, Option<&String>, Vec<&str>)| {
            wanted.is_none_or(|wanted| has(&found, wanted))
        };
        self.marks(item).into_iter().all(is_wanted)
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

fn has(found: &[&str], wanted: &str) -> bool {
    found.iter().any(|found| found.eq_ignore_ascii_case(wanted))
}
