//! Which items of the bank are meant.

use vibank::bank::Template;

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
    pub(crate) fn wants(&self, item: &Template) -> bool {
        fn fits<'a>(wanted: Option<&String>, found: impl IntoIterator<Item = &'a str>) -> bool {
            wanted.is_none_or(|wanted| {
                found
                    .into_iter()
                    .any(|found| found.eq_ignore_ascii_case(wanted))
            })
        }
        fits(self.chapter.as_ref(), [item.id.chapter()])
            && fits(
                self.topic.as_ref(),
                item.about.topics.iter().map(|topic| topic.value.as_str()),
            )
            && self.level.is_none_or(|level| level == item.about.level)
            && fits(
                self.kind.as_ref(),
                item.parts.iter().map(|part| part.answer.kind().name()),
            )
    }
}
