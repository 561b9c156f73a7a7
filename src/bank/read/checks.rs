//! Known results.

use super::{ItemError, ItemReader};
use crate::bank::template::{Check, Expected, Part};
use crate::expr::{Name, Precise};
use crate::source::{Table, Text, nearest};
use crate::unit::{Quantity, Unit};

pub(crate) fn read<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    parts: &[Part],
) -> Vec<Check> {
    table
        .tables("check")
        .into_iter()
        .map(|own| check(reader, own, parts))
        .collect()
}

fn check<'s>(reader: &mut ItemReader<'s>, table: Table<'s>, parts: &[Part]) -> Check {
    let source = table
        .required_text("source")
        .map(|text| text.value)
        .unwrap_or_default();
    let given = table
        .table("given")
        .map(|own| given(reader, &own))
        .unwrap_or_default();
    let at = table.texts("at");
    let at = at.iter().filter_map(|text| time(reader, text)).collect();
    let expect = table
        .required_table("expect")
        .map(|own| expect(reader, &own, parts))
        .unwrap_or_default();
    table.finish();
    Check {
        source,
        given,
        at,
        expect,
    }
}

fn given<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Vec<(usize, Quantity)> {
    let mut given = Vec::new();
    for entry in table.entries() {
        let Some(text) = table.as_formula(&entry.key, &entry.value) else {
            continue;
        };
        let found = reader
            .parameters
            .iter()
            .position(|parameter| parameter.name.as_str() == entry.key);
        let Some(place) = found else {
            let names = reader
                .parameters
                .iter()
                .map(|parameter| parameter.name.as_str());
            let nearest = nearest(&entry.key, names).map(str::to_owned);
            let text = entry.name();
            reader.find(
                &ItemError::Parameter {
                    found: entry.key.clone(),
                    nearest,
                },
                &text,
            );
            continue;
        };
        match reader.parameters[place].set(&text.value) {
            Ok(quantity) => given.push((place, quantity)),
            Err(error) => reader.find(&error, &text),
        }
    }
    given
}

fn time(reader: &mut ItemReader<'_>, text: &Text) -> Option<Precise> {
    let second = Unit::parse("s").expect("the second is a unit");
    match Quantity::parse(&text.value) {
        Ok(time) if time.conversion(&second).is_ok() => {
            let (high, low) = time.si_pair();
            Some(Precise::new(high, low, 0.0))
        }
        Ok(time) => {
            let found = time.unit.dimension().describe();
            let (name, declared) = ("at".to_owned(), "s".to_owned());
            reader.find(
                &ItemError::DeclaredUnit {
                    name,
                    declared,
                    found,
                },
                text,
            );
            None
        }
        Err(error) => {
            reader.find(&ItemError::Unit(error), text);
            None
        }
    }
}

fn expect<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>, parts: &[Part]) -> Vec<Expected> {
    let mut expected = Vec::new();
    for entry in table.entries() {
        let Some(response) = table.as_formula(&entry.key, &entry.value) else {
            continue;
        };
        let id = entry.name();
        let is_known = parts.iter().any(|part| part.has_id(&entry.key))
            || reader.graph.find(&Name::new(entry.key.as_str())).is_some();
        if is_known {
            expected.push(Expected { id, response });
        } else {
            let names = reader
                .graph
                .names()
                .map(Name::as_str)
                .chain(parts.iter().map(|part| part.id.as_str()));
            let nearest = nearest(&entry.key, names).map(str::to_owned);
            reader.find(
                &ItemError::Expected {
                    found: entry.key.clone(),
                    nearest,
                },
                &id,
            );
        }
    }
    expected
}
