//! The tree of a bank file, with the place of every key and value.

use serde::Serialize;
use serde_json::Value as Json;

use super::json::{Fields, FromJson, Misfit, variant};
use super::{Span, Text};

/// A value as it stands in a file.
///
/// Its JSON is that of compiled items; it keeps no places.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Value {
    /// The text, number, truth, list or table that it holds.
    pub data: Data,
    /// Where it stands; quotes and brackets included.
    #[serde(skip)]
    pub span: Span,
}

/// What a value is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub enum Data {
    /// `true` or `false`.
    #[serde(rename = "b")]
    Boolean(bool),
    /// A string of TOML or JSON.
    #[serde(rename = "s")]
    Text(String),
    /// An array.
    #[serde(rename = "l")]
    List(Vec<Value>),
    /// A table, inline or under a header.
    #[serde(rename = "t")]
    Table(Vec<Entry>),
    /// A number, kept as it was written.
    #[serde(rename = "n")]
    Number {
        /// Its digits.
        #[serde(rename = "d")]
        number: String,
    },
}

/// One key of a table and its value, in file order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Entry {
    /// The key, without quotes.
    #[serde(rename = "k")]
    pub key: String,
    /// Where the key stands.
    #[serde(skip)]
    pub span: Span,
    /// The value after the equals sign.
    #[serde(rename = "v")]
    pub value: Value,
}

impl Entry {
    /// The key as a text, with its place in the file.
    pub fn name(&self) -> Text {
        Text {
            value: self.key.clone(),
            span: self.span,
        }
    }
}

impl Data {
    /// What it is, in words for a message.
    pub fn describe(&self) -> &'static str {
        match self {
            Self::Boolean(_) => "a boolean",
            Self::Text(_) => "a text",
            Self::List(_) => "an array",
            Self::Table(_) => "a table",
            Self::Number { .. } => "a number",
        }
    }
}

crate::deserialize!(Value);

impl FromJson for Value {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let (name, held) = variant(json)?;
        let data = match name.as_str() {
            "b" => Data::Boolean(bool::from_json(held)?),
            "s" => Data::Text(String::from_json(held)?),
            "l" => Data::List(Vec::from_json(held)?),
            "t" => Data::Table(Vec::from_json(held)?),
            "n" => Data::Number {
                number: Fields::of(held)?.take("d")?,
            },
            _ => return Err(Misfit::Expected("a value of a bank file")),
        };
        Ok(Self {
            data,
            span: Span::default(),
        })
    }
}

impl FromJson for Entry {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        Ok(Self {
            key: fields.take("k")?,
            span: Span::default(),
            value: fields.take("v")?,
        })
    }
}
