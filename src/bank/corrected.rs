//! An item with another key than its file states: what is marked when a key was found to be wrong after the sheets were
//! handed out.

use super::own;
use super::read::{self, Parsers};
use super::{Part, Template};
use crate::answer::AnswerKind;
use crate::diagnostic::Finding;
use crate::source::{Data, Entry, Problems, Span, Value, toml};

/// Why an item cannot have another key.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CorrectionError {
    /// Work on paper has no key, or the part is not in the item.
    #[error("part `{0}` has no key that could be corrected")]
    NoKey(String),
    /// The options that are right are listed by their ids.
    #[error("the right options of part `{part}` are among {options}")]
    Options {
        /// Identifier of the part whose key is corrected.
        part: String,
        /// The ids of its options.
        options: String,
    },
    /// The item cannot be read with this key.
    #[error("part `{part}` cannot have this key: {reason}")]
    Key {
        /// Identifier of the part that cannot be corrected.
        part: String,
        /// What is wrong first.
        reason: String,
    },
}

/// The item with the keys of several parts, each named once.
pub(crate) fn with_keys(
    template: &Template,
    keys: &[(&str, &Value)],
) -> Result<Template, CorrectionError> {
    let problems = Problems::default();
    let mut tree = own::in_form(toml::read(&template.source, &problems));
    for (part, key) in keys {
        correct(template, &mut tree, part, key)?;
    }
    let parts: Vec<&str> = keys.iter().map(|(part, _)| *part).collect();
    read_again(template, &tree, &parts.join("`, `"))
}

fn correct(
    template: &Template,
    tree: &mut Value,
    part: &str,
    key: &Value,
) -> Result<(), CorrectionError> {
    let no_key = || CorrectionError::NoKey(part.to_owned());
    let own = template.part(part).ok_or_else(no_key)?;
    let table = find(tree, own).ok_or_else(no_key)?;
    match own.answer.kind() {
        AnswerKind::Work => return Err(no_key()),
        AnswerKind::Choice => {
            let options = own.answer.options().iter().map(|option| option.id.as_str());
            let options: Vec<&str> = options.collect();
            let right = right(key, &options).ok_or_else(|| CorrectionError::Options {
                part: part.to_owned(),
                options: options.join(", "),
            })?;
            choose(table, &right);
        }
        _ => {
            set(table, "key", unplaced(key).data);
            // As such a question may state a fixed value.
            if template.id.is_own() && own.answer.kind() == AnswerKind::Numeric {
                own::fix(table, "key");
            }
            // A quantity had a unit, which a formula in its place has not.
            let unit = own
                .answer
                .unit()
                .filter(|_| own.answer.kind() == AnswerKind::Numeric);
            if let Some(unit) = unit.filter(|_| text(table, "unit").is_none()) {
                set(table, "unit", Data::Text(unit.to_string()));
            }
            rename(table, own);
        }
    }
    Ok(())
}

fn read_again(template: &Template, tree: &Value, part: &str) -> Result<Template, CorrectionError> {
    let item = read::Item {
        id: template.id.clone(),
        revision: template.revision,
        source: &template.source,
        tree,
        topics: None,
    };
    let (corrected, findings) = read::item(item, &Problems::default(), &mut Parsers);
    corrected.ok_or_else(|| CorrectionError::Key {
        part: part.to_owned(),
        reason: reason(&findings),
    })
}

/// What is wrong first, with its way out.
fn reason(findings: &[Finding]) -> String {
    let Some(first) = findings.first() else {
        return String::new();
    };
    match &first.help {
        Some(help) => format!("{} ({help})", first.message),
        None => first.message.clone(),
    }
}

type Entries = Vec<Entry>;

/// The table of a part in the tree of its file.
fn find<'t>(tree: &'t mut Value, part: &Part) -> Option<&'t mut Entries> {
    let (group, id) = match &part.group {
        Some(group) => (
            Some(group.id.as_str()),
            part.id.strip_prefix(&format!("{}.", group.id))?,
        ),
        None => (None, part.id.as_str()),
    };
    let Data::Table(entries) = &mut tree.data else {
        return None;
    };
    let mut parts = items(entries, "part")?;
    match group {
        None => parts.find(|table| identity(table) == Some(id)),
        Some(group) => {
            let own = parts.find(|table| text(table, "id") == Some(group))?;
            items(own, "blank")?.find(|table| identity(table) == Some(id))
        }
    }
}

/// The tables of an array.
fn items<'t>(
    entries: &'t mut Entries,
    key: &str,
) -> Option<impl Iterator<Item = &'t mut Entries> + use<'t>> {
    let entry = entries.iter_mut().find(|entry| entry.key == key)?;
    let Data::List(list) = &mut entry.value.data else {
        return None;
    };
    Some(list.iter_mut().filter_map(|item| match &mut item.data {
        Data::Table(entries) => Some(entries),
        _ => None,
    }))
}

fn text<'t>(entries: &'t Entries, key: &str) -> Option<&'t str> {
    let entry = entries.iter().find(|entry| entry.key == key)?;
    match &entry.value.data {
        Data::Text(text) => Some(text),
        _ => None,
    }
}

/// What a part is called: its `id`, else its key.
fn identity(table: &Entries) -> Option<&str> {
    text(table, "id").or_else(|| text(table, "key"))
}

fn set(table: &mut Entries, key: &str, data: Data) {
    let span = Span::NONE;
    let value = Value { data, span };
    match table.iter_mut().find(|entry| entry.key == key) {
        Some(entry) => entry.value = value,
        None => table.push(Entry {
            key: key.to_owned(),
            span,
            value,
        }),
    }
}

/// Gives a part a name that no quantity has, and its own as one that it had: a part may bear the name of a quantity only
/// if that is its key.
fn rename(table: &mut Entries, part: &Part) {
    let own = part.id.rsplit('.').next().unwrap_or(&part.id);
    let mut was = part.was.clone();
    was.push(part.id.clone());
    let texts = was.into_iter().map(|id| Value {
        data: Data::Text(id),
        span: Span::NONE,
    });
    set(table, "was", Data::List(texts.collect()));
    set(table, "id", Data::Text(format!("{own}_as_corrected")));
}

/// The options that are right, by their ids.
fn right(key: &Value, options: &[&str]) -> Option<Vec<String>> {
    let id = |value: &Value| match &value.data {
        Data::Text(id) if options.contains(&id.as_str()) => Some(id.clone()),
        _ => None,
    };
    match &key.data {
        Data::List(ids) => ids.iter().map(id).collect(),
        _ => Some(vec![id(key)?]),
    }
}

/// Makes these options of a choice the right ones; of a ranking, the right order.
fn choose(table: &mut Entries, right: &[String]) {
    for option in items(table, "options").into_iter().flatten() {
        let is_right = text(option, "id").is_some_and(|id| right.iter().any(|own| own == id));
        set(option, "right", Data::Boolean(is_right));
    }
    let is_ranking = table
        .iter()
        .any(|entry| entry.key == "ranking" && entry.value.data == Data::Boolean(true));
    let options = table.iter_mut().find(|entry| entry.key == "options");
    if let Some(Data::List(list)) = options.map(|entry| &mut entry.value.data)
        && is_ranking
    {
        list.sort_by_key(|value| {
            let Data::Table(option) = &value.data else {
                return usize::MAX;
            };
            let id = text(option, "id").unwrap_or_default();
            right.iter().position(|own| own == id).unwrap_or(usize::MAX)
        });
    }
}

/// The value without its places, which are those of another file.
fn unplaced(value: &Value) -> Value {
    let data = match &value.data {
        Data::List(items) => Data::List(items.iter().map(unplaced).collect()),
        Data::Table(entries) => Data::Table(
            entries
                .iter()
                .map(|entry| Entry {
                    key: entry.key.clone(),
                    span: Span::NONE,
                    value: unplaced(&entry.value),
                })
                .collect(),
        ),
        other => other.clone(),
    };
    Value {
        data,
        span: Span::NONE,
    }
}
