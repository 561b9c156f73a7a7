//! Questions of one's own: items that stand in a blueprint, and in no bank.
//!
//! `[[question]]` with a statement and parts holds what an item file holds, with a shorter head: what a file has under
//! `[item]` stands beside the statement, statement and solution are plain texts, a part needs no `id`, and the key of a
//! number may be a fixed value, `20 rad/s`. Here its tree is brought into the form of an item file, so that everything
//! after it knows one form alone.

use crate::expr::Expr;
use crate::source::{Data, Entry, Span, Value};
use crate::unit::Quantity;

/// What a question says that an item file has under `[item]`.
const HEAD: [&str; 7] = [
    "title",
    "level",
    "topics",
    "minutes",
    "digits",
    "other_form",
    "notes",
];

/// What a question has as an item file has it.
const BODY: [&str; 12] = [
    "parameters",
    "symbols",
    "constraints",
    "model",
    "models",
    "quantities",
    "figure",
    "plots",
    "check",
    "statement",
    "solution",
    "part",
];

/// Guards that are lifted, as under `[item]`, or findings of `check` that are in order, as in an item file.
const ALLOW: &str = "allow";

/// The keys of a question of a blueprint that belong to its item.
pub(crate) fn question_keys() -> impl Iterator<Item = &'static str> {
    HEAD.into_iter().chain(BODY).chain([ALLOW])
}

/// The tree of an item, where the file has that or one question of a blueprint.
pub(crate) fn in_form(tree: Value) -> Value {
    match only_question(&tree) {
        Some(question) => Value {
            data: Data::Table(item(question)),
            span: question.span,
        },
        None => tree,
    }
}

/// The question of a file that has nothing else.
fn only_question(tree: &Value) -> Option<&Value> {
    let Data::Table(entries) = &tree.data else {
        return None;
    };
    let [Entry { key, value, .. }] = &entries[..] else {
        return None;
    };
    match &value.data {
        Data::List(questions) if key == "question" => match &questions[..] {
            [question] => Some(question),
            _ => None,
        },
        _ => None,
    }
}

/// The entries of an item file that says what a question says. What the blueprint reads of it is left out.
fn item(question: &Value) -> Vec<Entry> {
    let Data::Table(entries) = &question.data else {
        return Vec::new();
    };
    let mut head = vec![said("source", "by hand".to_owned(), question.span)];
    let mut body = Vec::new();
    for entry in entries {
        let mut entry = entry.clone();
        match entry.key.as_str() {
            "statement" | "solution" => entry.value = with_text(entry.value),
            "part" => parts(&mut entry.value),
            ALLOW if has_words(&entry.value) => {
                head.push(entry);
                continue;
            }
            key if HEAD.contains(&key) => {
                head.push(entry);
                continue;
            }
            key if BODY.contains(&key) || key == ALLOW => {}
            _ => continue,
        }
        body.push(entry);
    }
    body.push(Entry {
        key: "item".to_owned(),
        span: question.span,
        value: Value {
            data: Data::Table(head),
            span: question.span,
        },
    });
    body
}

/// A text as the table that holds it; anything else as it is.
fn with_text(value: Value) -> Value {
    let span = value.span;
    match value.data {
        Data::Text(_) => Value {
            data: Data::Table(vec![Entry {
                key: "text".to_owned(),
                span,
                value,
            }]),
            span,
        },
        _ => value,
    }
}

fn has_words(value: &Value) -> bool {
    match &value.data {
        Data::Text(_) => true,
        Data::List(items) => items.iter().any(|item| matches!(item.data, Data::Text(_))),
        _ => false,
    }
}

/// Gives an identity to each part and blank that has none, and units to fixed values.
fn parts(list: &mut Value) {
    for (place, entries) in tables(list).enumerate() {
        let number = place + 1;
        let blanks = entries.iter_mut().find(|entry| entry.key == "blank");
        if let Some(blanks) = blanks {
            for (place, blank) in tables(&mut blanks.value).enumerate() {
                part(blank, &format!("blank_{}", place + 1));
            }
            identify(entries, &format!("part_{number}"));
        } else {
            part(entries, &format!("part_{number}"));
        }
    }
}

fn part(entries: &mut Vec<Entry>, usual_id: &str) {
    let text = |key: &str| {
        let mut found = entries.iter().filter(|entry| entry.key == key);
        match found.next().map(|entry| &entry.value.data) {
            Some(Data::Text(text)) => Some(text.clone()),
            _ => None,
        }
    };
    let key = text("key").unwrap_or_default();
    if !is_name(&key) {
        identify(entries, usual_id);
    }
    let is_number = match entries.iter().find(|entry| entry.key == "kind") {
        Some(kind) => matches!(&kind.value.data, Data::Text(kind) if kind == "numeric"),
        None => true,
    };
    if is_number {
        fix(entries, "key");
        let mistakes = entries.iter_mut().find(|entry| entry.key == "mistakes");
        if let Some(mistakes) = mistakes {
            tables(&mut mistakes.value).for_each(|mistake| fix(mistake, "answer"));
        }
    }
}

/// Whether a key is the name of a quantity, by which its part is known then.
fn is_name(key: &str) -> bool {
    let mut letters = key.chars();
    letters
        .next()
        .is_some_and(|first| first.is_ascii_alphabetic())
        && letters.all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
}

fn identify(entries: &mut Vec<Entry>, id: &str) {
    if entries.iter().all(|entry| entry.key != "id") {
        entries.push(said("id", id.to_owned(), Span::NONE));
    }
}

/// Writes a fixed value as the formula language does, `20 rad/s` as `20[rad/s]`, with its unit beside it.
pub(crate) fn fix(entries: &mut Vec<Entry>, key: &str) {
    let Some(entry) = entries.iter_mut().find(|entry| entry.key == key) else {
        return;
    };
    let Data::Text(text) = &mut entry.value.data else {
        return;
    };
    let Some((number, unit)) = fixed(text) else {
        return;
    };
    let span = entry.value.span;
    *text = format!("{number}[{unit}]");
    if entries.iter().all(|entry| entry.key != "unit") {
        entries.push(said("unit", unit, span));
    }
}

/// Number and unit of a text that is a quantity and no formula.
fn fixed(text: &str) -> Option<(String, String)> {
    let (number, unit) = text.trim().split_once(char::is_whitespace)?;
    let (number, unit) = (number.to_owned(), unit.trim().to_owned());
    // What is a formula as well stays one.
    let is_fixed = Expr::read(text).is_err()
        && Quantity::parse(text).is_ok()
        && Expr::read(&format!("{number}[{unit}]")).is_ok();
    is_fixed.then_some((number, unit))
}

/// The tables of a list.
fn tables(list: &mut Value) -> impl Iterator<Item = &mut Vec<Entry>> {
    let items = match &mut list.data {
        Data::List(items) => &mut items[..],
        _ => &mut [],
    };
    items.iter_mut().filter_map(|item| match &mut item.data {
        Data::Table(entries) => Some(entries),
        _ => None,
    })
}

/// An entry that the question leaves unsaid.
fn said(key: &str, text: String, span: Span) -> Entry {
    Entry {
        key: key.to_owned(),
        span,
        value: Value {
            data: Data::Text(text),
            span,
        },
    }
}
