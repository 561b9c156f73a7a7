//! The JSON schemas: tables of the reference that are made from them, and that they say what is read.

mod fit;
mod specimen;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use serde_json::Value;
use vibank::answer::AnswerKind;
use vibank::bank::embedded;

use fit::fits;
use specimen::{PLACES, read_at};

const ITEM: &str = include_str!("../../../../templates/schema/item.json");
const BLUEPRINT: &str = include_str!("../../../../templates/schema/blueprint.json");

fn schema(text: &str) -> Value {
    serde_json::from_str(text).expect("a schema is JSON")
}

/// The keys of a table: `item /properties/item`, a schema and a place in it.
pub(super) fn table(argument: &str) -> String {
    let (name, place) = argument.split_once(' ').unwrap_or((argument, ""));
    let schema = schema(match name {
        "item" => ITEM,
        "blueprint" => BLUEPRINT,
        _ => panic!("there is no schema `{name}`"),
    });
    let table = schema
        .pointer(place)
        .unwrap_or_else(|| panic!("`{name}` has nothing at {place}"));
    let required = required(table);
    let mut out = String::from("| key | value | meaning |\n| --- | --- | --- |\n");
    for (key, value) in table["properties"].as_object().expect("it has keys") {
        let is_required = required.contains(key.as_str());
        let default = value
            .get("default")
            .map(|value| format!("; default {}", word(value)));
        let _ = writeln!(
            out,
            "| `{key}`{} | {}{} | {} |",
            if is_required { "\u{a0}**!**" } else { "" },
            described(value),
            default.unwrap_or_default(),
            value["description"]
                .as_str()
                .unwrap_or_default()
                .replace('|', "\\|")
        );
    }
    out
}

fn required(table: &Value) -> BTreeSet<&str> {
    let names = table["required"].as_array().into_iter().flatten();
    names.filter_map(Value::as_str).collect()
}

fn word(value: &Value) -> String {
    match value {
        Value::String(word) => format!("`\"{word}\"`"),
        other => format!("`{other}`"),
    }
}

/// What a key holds, in words.
fn described(schema: &Value) -> String {
    let all = |key: &str, between: &str| {
        let pieces = schema[key].as_array().into_iter().flatten();
        pieces.map(described).collect::<Vec<_>>().join(between)
    };
    if let Some(name) = schema["$ref"].as_str() {
        return name.rsplit('/').next().unwrap_or(name).to_owned();
    }
    if let Some(words) = schema["enum"].as_array() {
        return words.iter().map(word).collect::<Vec<_>>().join(" ");
    }
    if schema.get("allOf").is_some() && schema.get("type").is_none() {
        return all("allOf", ", ");
    }
    if schema.get("anyOf").is_some() {
        return all("anyOf", " or ");
    }
    let bounds = (schema["minimum"].as_i64(), schema["maximum"].as_i64());
    match (schema["type"].as_str(), bounds) {
        (Some("array"), _) => match (schema.get("items"), schema["maxItems"].as_u64()) {
            (Some(items), Some(2)) => format!("two, each {}", described(items)),
            (Some(items), _) => format!("array of {}", described(items)),
            (None, _) => "array".to_owned(),
        },
        (Some("object"), _) => match schema.get("additionalProperties") {
            Some(value @ Value::Object(fields)) if !fields.is_empty() => {
                format!("names → {}", described(value))
            }
            Some(Value::Object(_)) => "names → value".to_owned(),
            _ => "table".to_owned(),
        },
        (Some("boolean"), _) => "boolean".to_owned(),
        (Some("integer"), (Some(low), Some(high))) => format!("{low} to {high}"),
        (Some("integer"), (Some(low), None)) => format!("integer from {low}"),
        (Some(name), _) => name.to_owned(),
        (None, _) => "value".to_owned(),
    }
}

fn keys(schema: &Value) -> BTreeSet<String> {
    let keys = schema["properties"].as_object().expect("it has keys");
    keys.keys().cloned().collect()
}

#[test]
fn the_schema_of_items_has_the_keys_that_are_read() {
    let schema = schema(ITEM);
    let mut faults = Vec::new();
    for (place, pointer) in PLACES {
        let stated = keys(schema.pointer(pointer).expect(pointer));
        let read = read_at(place);
        // Plots and parts are one table in the schema, with the keys of all their kinds.
        let is_one_of_several =
            ["curves", "shapes", "phasors", "numeric", "group", "blank"].contains(&place);
        if stated != read && !(is_one_of_several && stated.is_superset(&read)) {
            faults.push(format!("{place}: {stated:?} stated, {read:?} read"));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    let plot = keys(&schema["properties"]["plots"]["additionalProperties"]);
    assert_eq!(
        plot,
        &(&read_at("curves") | &read_at("shapes")) | &read_at("phasors")
    );
    // A blank is a part, and has no blanks.
    let part = read_at("blank");
    assert_eq!(
        &part | &BTreeSet::from(["blank".to_owned()]),
        read_at("numeric")
    );
}

#[test]
fn the_schema_says_which_kinds_of_answers_a_key_is_for() {
    let part = &schema(ITEM)["properties"]["part"]["items"];
    let kinds: Vec<&str> = AnswerKind::ALL.iter().map(|kind| kind.name()).collect();
    assert_eq!(
        part["properties"]["kind"]["enum"],
        serde_json::json!(kinds),
        "all kinds, in their order"
    );
    let mut knowing: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    for kind in &kinds {
        for key in read_at(kind) {
            knowing.entry(key).or_default().insert(kind);
        }
    }
    let read: BTreeSet<String> = knowing.keys().cloned().collect();
    assert_eq!(&read | &read_at("group"), keys(part));
    for (key, knowing) in knowing {
        if knowing.len() == kinds.len() || key == "key" {
            continue;
        }
        let words = part["properties"][&key]["description"].as_str().unwrap();
        let named = kinds
            .iter()
            .filter(|kind| words.contains(&format!("`{kind}`")));
        assert_eq!(named.copied().collect::<BTreeSet<_>>(), knowing, "{key}");
    }
}

#[test]
fn the_items_of_the_bank_fit_their_schema_and_broken_ones_do_not() {
    let schema = schema(ITEM);
    let fit = |text: &str| -> Result<(), String> {
        let item: Value = toml::from_str(text).map_err(|error| error.to_string())?;
        fits(&schema, &schema, &item)
    };
    let items = embedded()
        .into_iter()
        .filter(|(path, _)| path.starts_with("ch") && !path.ends_with("_chapter.toml"));
    let mut count = 0;
    for (path, text) in items {
        count += 1;
        assert_eq!(fit(text), Ok(()), "{path}");
    }
    assert!(count > 100, "{count} items");
    assert_eq!(
        fit(include_str!("../../../../templates/new/item.toml")),
        Ok(())
    );
    assert_eq!(
        fit(include_str!("../../../fixtures/kinds/item.toml")),
        Ok(())
    );
    for broken in [
        "unknown-key",
        "missing-key",
        "wrong-kind",
        "allow",
        "answer-kind",
    ] {
        let text = std::fs::read_to_string(format!("tests/fixtures/invalid/bank-{broken}.toml"));
        assert!(fit(&text.unwrap()).is_err(), "{broken}");
    }
}
