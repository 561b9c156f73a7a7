//! Mathematics out of JSON, as compiled items and formulas of pages hold it.

use serde_json::Value as Json;

use super::{Accent, Class, Math, Size, Style, TableKind};
use vibank_source::{Fields, FromJson, Misfit, deserialize, named, variant};

deserialize!(Math);

impl FromJson for Math {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let (name, held) = variant(json)?;
        // Those of one value; the others have fields.
        match name.as_str() {
            "r" => return Vec::from_json(held).map(Self::Row),
            "n" => return String::from_json(held).map(Self::Number),
            "f" => return String::from_json(held).map(Self::Function),
            "t" => return String::from_json(held).map(Self::Text),
            "s" => return i16::from_json(held).map(Self::Space),
            "h" => return u32::from_json(held).map(Self::Hole),
            _ => {}
        }
        let mut fields = Fields::of(held)?;
        Ok(match name.as_str() {
            "i" => Self::Identifier {
                text: fields.take("t")?,
                style: fields.optional("s")?.unwrap_or_default(),
            },
            "o" => Self::Operator {
                text: fields.take("t")?,
                class: fields.take("c")?,
            },
            "q" => Self::Fraction {
                numerator: fields.take("n")?,
                denominator: fields.take("d")?,
                bar: fields.optional("b")?.unwrap_or(true),
                size: fields.optional("s")?.unwrap_or_default(),
            },
            "v" => Self::Root {
                radicand: fields.take("r")?,
                degree: fields.optional("d")?,
            },
            "x" => Self::Script {
                base: fields.take("b")?,
                sub: fields.optional("d")?,
                sup: fields.optional("u")?,
            },
            "u" => Self::Stack {
                base: fields.take("b")?,
                under: fields.optional("d")?,
                over: fields.optional("u")?,
            },
            "a" => Self::Accent {
                base: fields.take("b")?,
                accent: fields.take("a")?,
            },
            "p" => Self::Fence {
                open: fields.take("o")?,
                close: fields.take("c")?,
                body: fields.take("b")?,
                stretchy: fields.take("s")?,
            },
            "m" => Self::Table {
                rows: fields.take("r")?,
                kind: fields.take("k")?,
            },
            _ => return Err(Misfit::Expected("a formula")),
        })
    }
}

named!(Style, "the style of a letter", {
    "Default" => Default,
    "Upright" => Upright,
    "Bold" => Bold,
    "BoldItalic" => BoldItalic,
    "Script" => Script,
    "Double" => Double,
});

named!(Class, "the class of an operator", {
    "Binary" => Binary,
    "Prefix" => Prefix,
    "Relation" => Relation,
    "Punctuation" => Punctuation,
    "Opening" => Opening,
    "Closing" => Closing,
    "Ordinary" => Ordinary,
    "Large" => Large,
});

named!(Size, "the size of a fraction", {
    "Auto" => Auto,
    "Display" => Display,
    "Text" => Text,
});

named!(Accent, "an accent", {
    "Dot" => Dot,
    "DoubleDot" => DoubleDot,
    "TripleDot" => TripleDot,
    "Hat" => Hat,
    "Tilde" => Tilde,
    "Bar" => Bar,
    "Vector" => Vector,
});

named!(TableKind, "the kind of a table", {
    "Matrix" => Matrix,
    "Cases" => Cases,
    "Aligned" => Aligned,
});
