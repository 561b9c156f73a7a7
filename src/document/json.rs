//! Texts out of JSON, as compiled items hold them.

use serde_json::Value as Json;

use super::{Alignment, Block, Document, Form, Inline, Placeholder};
use crate::source::{Fields, FromJson, Misfit, Span, deserialize, named, variant};

deserialize!(Document);

impl FromJson for Document {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        Ok(Self {
            blocks: fields.take("b")?,
            placeholders: fields.optional("p")?.unwrap_or_default(),
        })
    }
}

impl FromJson for Block {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let (name, held) = variant(json)?;
        Ok(match name.as_str() {
            "p" => Self::Paragraph(Vec::from_json(held)?),
            "h" => {
                let mut fields = Fields::of(held)?;
                Self::Heading {
                    level: fields.take("l")?,
                    content: fields.take("c")?,
                }
            }
            "l" => {
                let mut fields = Fields::of(held)?;
                Self::List {
                    start: fields.optional("n")?,
                    tight: fields.take("t")?,
                    items: fields.take("i")?,
                }
            }
            "t" => {
                let mut fields = Fields::of(held)?;
                Self::Table {
                    columns: fields.take("a")?,
                    head: fields.take("h")?,
                    rows: fields.take("r")?,
                }
            }
            "m" => Self::Display(FromJson::from_json(held)?),
            "c" => Self::Code(String::from_json(held)?),
            "q" => Self::Quote(Vec::from_json(held)?),
            "f" => Self::Figure(u32::from_json(held)?),
            "r" => Self::Rule,
            _ => return Err(Misfit::Expected("a block of text")),
        })
    }
}

impl FromJson for Inline {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let (name, held) = variant(json)?;
        Ok(match name.as_str() {
            "t" => Self::Text(String::from_json(held)?),
            "e" => Self::Emphasis(Vec::from_json(held)?),
            "s" => Self::Strong(Vec::from_json(held)?),
            "c" => Self::Code(String::from_json(held)?),
            "l" => {
                let mut fields = Fields::of(held)?;
                Self::Link {
                    to: fields.take("u")?,
                    content: fields.take("c")?,
                }
            }
            "m" => Self::Math(FromJson::from_json(held)?),
            "h" => Self::Hole(u32::from_json(held)?),
            "b" => Self::Break,
            _ => return Err(Misfit::Expected("a piece of a line")),
        })
    }
}

impl FromJson for Placeholder {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        Ok(Self {
            path: fields.take("n")?,
            form: fields.optional("f")?.unwrap_or_default(),
            in_math: fields.optional("m")?.unwrap_or_default(),
            span: Span::NONE,
        })
    }
}

named!(Alignment, "the alignment of a column", {
    "n" => None,
    "l" => Left,
    "c" => Centre,
    "r" => Right,
});

named!(Form, "the form of a value", {
    "value" => Value,
    "given" => Given,
    "symbol" => Symbol,
    "name" => Name,
    "number" => Number,
    "unit" => Unit,
    "formula" => Formula,
    "substituted" => Substituted,
    "equation" => Equation,
    "worked" => Worked,
});
