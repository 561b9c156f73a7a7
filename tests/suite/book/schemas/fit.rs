//! A reader of JSON schemas, as far as ours go.

use serde_json::Value;

use super::required;

/// Whether a value is as a schema wants it, as far as our schemas use the language.
pub(super) fn fits(root: &Value, schema: &Value, value: &Value) -> Result<(), String> {
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
                    fits(root, own, field).map_err(|fault| format!("{key}: {fault}"))?;
                }
                (None, Value::Bool(false)) => return Err(format!("`{key}` is unknown")),
                (None, other) => {
                    fits(root, other, field).map_err(|fault| format!("{key}: {fault}"))?;
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
