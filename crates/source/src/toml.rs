//! From TOML to the tree of values.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Data, Entry, Problem, Problems, Source, Span, Value};

/// Reads a whole file; what cannot be read is noted, the rest is kept.
pub fn read(source: &Source, problems: &Problems) -> Value {
    let (table, errors) = DeTable::parse_recoverable(&source.text);
    for error in errors {
        let span = error.span().map_or(Span::NONE, Span::from);
        problems.add(Problem::Syntax {
            message: error.message().to_owned(),
            span,
        });
    }
    let span = Span::from(table.span());
    Value {
        data: Data::Table(entries(table.get_ref())),
        span,
    }
}

fn entries(table: &DeTable<'_>) -> Vec<Entry> {
    table
        .iter()
        .map(|(key, value)| Entry {
            key: std::borrow::Cow::<str>::to_string(key.get_ref()),
            span: key.span().into(),
            value: convert(value),
        })
        .collect()
}

fn convert(value: &Spanned<DeValue<'_>>) -> Value {
    let data = match value.get_ref() {
        DeValue::String(text) => Data::Text(text.to_string()),
        DeValue::Integer(integer) => Data::Number {
            number: integer.to_string(),
        },
        DeValue::Float(float) => Data::Number {
            number: float.to_string(),
        },
        DeValue::Boolean(boolean) => Data::Boolean(*boolean),
        // Dates have no place in a bank; as texts they are refused where a text is not due.
        DeValue::Datetime(date) => Data::Text(date.to_string()),
        DeValue::Array(items) => Data::List(items.iter().map(convert).collect()),
        DeValue::Table(table) => Data::Table(entries(table)),
    };
    Value {
        data,
        span: value.span().into(),
    }
}
