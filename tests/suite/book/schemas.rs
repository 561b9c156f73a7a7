//! The JSON schemas: tables of the reference that are made from them, and that they say what is read.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use serde_json::Value;
use vibank::answer::KINDS;
use vibank::bank::{Catalogue, embedded};

const ITEM: &str = include_str!("../../../templates/schema/item.json");
const BLUEPRINT: &str = include_str!("../../../templates/schema/blueprint.json");

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
        let default = value.get("default").map(|value| format!("; default {}", word(value)));
        let _ = writeln!(
            out,
            "| `{key}`{} | {}{} | {} |",
            if is_required { " **!**" } else { "" },
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

/// An item with a place, `@NAME@`, in each table that has keys of its own.
const SPECIMEN: &str = r#"
@top@
[item]
title = "T"
source = "S"
@item@
[parameters]
m = { value = "1 kg" @parameter@ }
k = { value = "1 N/m" }
[symbols]
om = { unit = "rad/s" @symbol@ }
[model]
coordinates = { x = { unit = "m" @coordinate@ }, y = { unit = "m" } }
kinetic = "1/2*m*x'^2 + 1/2*m*y'^2"
potential = "1/2*k*x^2 + 1/2*k*y^2"
friction = { x = { kinetic = "1[N]" @friction@ } }
@model@
[models.b]
like = "model"
@models@
[quantities]
w = { formula = "sqrt(k/m)", unit = "rad/s" @quantity@ }
[statement]
text = "X"
@statement@
[solution]
text = "X"
@solution@
[figure]
elements = []
@figure@
[plots.p]
x = { variable = "t", range = ["0[s]", "1[s]"], unit = "s" @abscissa@ }
y = { unit = "1" @ordinate@ }
curves = [{ y = "t/1[s]" @curve@ }]
marks = [{ at = ["0[s]", "1"] @mark@ }]
@curves@
[plots.q]
kind = "mode-shapes"
@shapes@
[[part]]
key = "w"
ask = "Y"
mistakes = [{ answer = "k/m", feedback = "F" @mistake@ }]
@numeric@
[[part]]
id = "b"
key = "2"
ask = "Y"
kind = "integer"
@integer@
[[part]]
id = "c"
key = "sqrt(k/m)"
ask = "Y"
kind = "formula"
@formula@
[[part]]
id = "d"
key = "model.equation.x"
ask = "Y"
kind = "equation"
@equation@
[[part]]
id = "f"
key = "model.K"
ask = "Y"
kind = "matrix"
@matrix@
[[part]]
id = "h"
key = "[1, 1]"
ask = "Y"
kind = "mode-shape"
mode = 1
@mode-shape@
[[part]]
id = "l"
key = "cos(w*t)"
ask = "Y"
kind = "function"
@function@
[[part]]
id = "n"
key = "[0, 1]"
variable = "om"
ask = "Y"
kind = "interval"
@interval@
[[part]]
id = "o"
ask = "Y"
kind = "choice"
options = [{ id = "a", text = "A", right = true @option@ }, { id = "b", text = "B" }]
@choice@
[[check]]
source = "S"
expect = { w = "1 rad/s" }
@check@
"#;

/// Where the schema has the keys of a table of the specimen; parts are looked at apart.
const PLACES: [(&str, &str); 22] = [
    ("top", ""),
    ("item", "/properties/item"),
    (
        "parameter",
        "/properties/parameters/additionalProperties/anyOf/1",
    ),
    ("symbol", "/properties/symbols/additionalProperties/anyOf/1"),
    (
        "coordinate",
        "/properties/model/properties/coordinates/additionalProperties",
    ),
    (
        "friction",
        "/properties/model/properties/friction/additionalProperties/anyOf/1",
    ),
    ("model", "/properties/model"),
    ("models", "/properties/models/additionalProperties"),
    (
        "quantity",
        "/properties/quantities/additionalProperties/anyOf/1",
    ),
    ("statement", "/properties/statement"),
    ("solution", "/properties/solution"),
    ("figure", "/properties/figure"),
    (
        "abscissa",
        "/properties/plots/additionalProperties/properties/x",
    ),
    (
        "ordinate",
        "/properties/plots/additionalProperties/properties/y",
    ),
    (
        "curve",
        "/properties/plots/additionalProperties/properties/curves/items",
    ),
    (
        "mark",
        "/properties/plots/additionalProperties/properties/marks/items",
    ),
    ("curves", "/properties/plots/additionalProperties"),
    ("shapes", "/properties/plots/additionalProperties"),
    (
        "mistake",
        "/properties/part/items/properties/mistakes/items",
    ),
    ("option", "/properties/part/items/properties/options/items"),
    ("check", "/properties/check/items"),
    ("numeric", "/properties/part/items"),
];

/// The keys that the reader knows at a place of the specimen, as its finding lists them.
fn read_at(place: &str) -> BTreeSet<String> {
    let pieces: Vec<&str> = SPECIMEN.split('@').collect();
    assert!(
        pieces.iter().skip(1).step_by(2).any(|name| *name == place),
        "{place}"
    );
    let marked = pieces.iter().enumerate().map(|(number, piece)| {
        let is_within = pieces
            .get(number + 1)
            .is_some_and(|next| next.starts_with(" }"));
        match (number % 2, *piece == place) {
            (0, _) => piece,
            (_, false) => "",
            (_, true) if is_within => ", qqqqqqqq = 1",
            (_, true) => "qqqqqqqq = 1",
        }
    });
    let text: String = marked.collect();
    let files = embedded()
        .into_iter()
        .filter(|(path, _)| ["bank.toml", "ch2/_chapter.toml"].contains(path));
    let (_, findings) = Catalogue::load(files.chain([("ch2/specimen.toml", text.as_str())]));
    let help = findings
        .iter()
        .filter_map(|finding| finding.help.as_deref())
        .find_map(|help| help.strip_prefix("the keys are "))
        .unwrap_or_else(|| panic!("{place}: {findings:?}"));
    help.split(", ").map(str::to_owned).collect()
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
        let is_one_of_several = ["curves", "shapes", "numeric"].contains(&place);
        if stated != read && !(is_one_of_several && stated.is_superset(&read)) {
            faults.push(format!("{place}: {stated:?} stated, {read:?} read"));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    let plot = keys(&schema["properties"]["plots"]["additionalProperties"]);
    assert_eq!(plot, &read_at("curves") | &read_at("shapes"));
}

#[test]
fn the_schema_says_which_kinds_of_answers_a_key_is_for() {
    let part = &schema(ITEM)["properties"]["part"]["items"];
    let kinds: Vec<&str> = KINDS.iter().map(|kind| kind.name()).collect();
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
    assert_eq!(read, keys(part));
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

/// Whether a value is as a schema wants it, as far as our schemas use the language.
fn fits(root: &Value, schema: &Value, value: &Value) -> Result<(), String> {
    if let Some(name) = schema["$ref"].as_str() {
        let place = name.strip_prefix('#').expect("a place in the same schema");
        return fits(root, root.pointer(place).expect(place), value);
    }
    let each = |key: &str| schema[key].as_array().into_iter().flatten();
    each("allOf").try_for_each(|one| fits(root, one, value))?;
    if schema.get("anyOf").is_some() && !each("anyOf").any(|one| fits(root, one, value).is_ok()) {
        return Err(format!("{value} is none of several"));
    }
    if schema.get("enum").is_some() && !each("enum").any(|one| one == value)
        || schema.get("const").is_some_and(|one| one != value)
    {
        return Err(format!("{value} is another word"));
    }
    let kinds: Vec<&str> = match &schema["type"] {
        Value::String(kind) => vec![kind],
        Value::Array(kinds) => kinds.iter().filter_map(Value::as_str).collect(),
        _ => Vec::new(),
    };
    let is_kind = |kind: &&str| match *kind {
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "boolean" => value.is_boolean(),
        "array" => value.is_array(),
        _ => value.is_object(),
    };
    if !kinds.is_empty() && !kinds.iter().any(is_kind) {
        return Err(format!("{value} is no {kinds:?}"));
    }
    if let Some(number) = value.as_f64() {
        let is_within = schema["minimum"].as_f64().is_none_or(|low| low <= number)
            && schema["maximum"].as_f64().is_none_or(|high| number <= high);
        if !is_within {
            return Err(format!("{value} is out of range"));
        }
    }
    if let Some(fields) = value.as_object() {
        for name in required(schema) {
            if !fields.contains_key(name) {
                return Err(format!("`{name}` is missing"));
            }
        }
        for (key, field) in fields {
            match (
                schema["properties"].get(key),
                &schema["additionalProperties"],
            ) {
                (Some(own), _) => {
                    fits(root, own, field).map_err(|fault| format!("{key}: {fault}"))?
                }
                (None, Value::Bool(false)) => return Err(format!("`{key}` is unknown")),
                (None, other) => {
                    fits(root, other, field).map_err(|fault| format!("{key}: {fault}"))?
                }
            }
        }
    }
    if let (Some(items), Some(list)) = (schema.get("items"), value.as_array()) {
        list.iter().try_for_each(|item| fits(root, items, item))?;
        let count = list.len() as u64;
        if schema["minItems"]
            .as_u64()
            .is_some_and(|least| count < least)
            || schema["maxItems"].as_u64().is_some_and(|most| count > most)
        {
            return Err(format!("{count} items"));
        }
    }
    if let Some(condition) = schema.get("if") {
        let branch = if fits(root, condition, value).is_ok() {
            "then"
        } else {
            "else"
        };
        if let Some(branch) = schema.get(branch) {
            fits(root, branch, value)?;
        }
    }
    Ok(())
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
        fit(include_str!("../../../templates/new/item.toml")),
        Ok(())
    );
    assert_eq!(fit(include_str!("../../fixtures/kinds/item.toml")), Ok(()));
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
