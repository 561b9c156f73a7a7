//! Typed fields out of JSON that a program of the same version has written: compiled items, and the requests of a page.
//!
//! What serde derives reads each type by code of its own, which would be a fifteenth of the grader in the browser. Here a
//! value is read once for all types, and each takes its fields out of it.
//!
//! ```
//! use vibank_source::{Fields, FromJson, Misfit};
//!
//! let mut fields = Fields::of(serde_json::json!({ "name": "x", "count": 2 })).unwrap();
//! assert_eq!(fields.take::<String>("name").as_deref(), Ok("x"));
//! assert_eq!(fields.take::<bool>("count"), Err(Misfit::Expected("true or false")));
//! assert_eq!(fields.take::<String>("title"), Err(Misfit::Missing("title")));
//! assert_eq!(fields.optional::<bool>("flag"), Ok(None));
//! assert_eq!(Vec::<u8>::from_json(serde_json::json!([1, 2])), Ok(vec![1, 2]));
//! ```

use serde_json::{Map, Value as Json};

/// JSON of another form than a type is written in.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Misfit {
    /// Something else stands here.
    #[error("expected {0}")]
    Expected(&'static str),
    /// An unknown name.
    #[error("expected {expected}, found `{found}`")]
    Unknown {
        /// The known ones.
        expected: &'static str,
        /// The name.
        found: String,
    },
    /// A field is not there.
    #[error("missing field `{0}`")]
    Missing(&'static str),
}

/// A type that is read from JSON.
pub trait FromJson: Sized {
    /// Reads it.
    ///
    /// # Errors
    ///
    /// [`Misfit`]: what was expected first.
    fn from_json(json: Json) -> Result<Self, Misfit>;

    /// Reads it from a text.
    ///
    /// # Errors
    ///
    /// [`Misfit`] where the text is no JSON, or that of something else.
    fn from_text(text: &str) -> Result<Self, Misfit> {
        // What serde_json says of a text would be a thousandth of the grader in the browser.
        let json = serde_json::from_str(text).map_err(|_| Misfit::Expected("JSON"))?;
        Self::from_json(json)
    }
}

/// The fields of an object, which are taken out by their names.
pub struct Fields(Map<String, Json>);

impl Fields {
    /// Those of an object.
    ///
    /// # Errors
    ///
    /// [`Misfit`] where the JSON is not such a value.
    pub fn of(json: Json) -> Result<Self, Misfit> {
        match json {
            Json::Object(fields) => Ok(Self(fields)),
            _ => Err(Misfit::Expected("an object")),
        }
    }

    /// A field that has to be there.
    ///
    /// # Errors
    ///
    /// [`Misfit`] where it is not, or is of another type.
    pub fn take<T: FromJson>(&mut self, name: &'static str) -> Result<T, Misfit> {
        let field = self.0.swap_remove(name);
        T::from_json(field.ok_or(Misfit::Missing(name))?)
    }

    /// A field that may be absent.
    ///
    /// # Errors
    ///
    /// [`Misfit`] where it is of another type.
    pub fn optional<T: FromJson>(&mut self, name: &str) -> Result<Option<T>, Misfit> {
        self.0.swap_remove(name).map(T::from_json).transpose()
    }

    /// Ends the reading of a form without further fields.
    ///
    /// # Errors
    ///
    /// [`Misfit`] where some were not taken.
    pub fn finish(self) -> Result<(), Misfit> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(Misfit::Expected("no further fields"))
        }
    }
}

/// A variant of an enum: its name, and what it holds. One without fields is its name alone.
///
/// # Errors
///
/// [`Misfit`] where it is neither a text nor an object of one field.
pub fn variant(json: Json) -> Result<(String, Json), Misfit> {
    match json {
        Json::String(name) => Ok((name, Json::Null)),
        Json::Object(fields) if fields.len() == 1 => {
            fields.into_iter().next().ok_or(Misfit::Expected("a field"))
        }
        _ => Err(Misfit::Expected("a variant")),
    }
}

fn integer(json: &Json) -> Result<i64, Misfit> {
    json.as_i64().ok_or(Misfit::Expected("an integer"))
}

macro_rules! integers {
    ($($integer:ty)+) => {$(
        impl FromJson for $integer {
            fn from_json(json: Json) -> Result<Self, Misfit> {
                Self::try_from(integer(&json)?).map_err(|_| Misfit::Expected("a smaller integer"))
            }
        }
    )+};
}

integers!(u8 i16 u32 usize);

impl FromJson for u64 {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        json.as_u64().ok_or(Misfit::Expected("an integer"))
    }
}

impl FromJson for Map<String, Json> {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        Fields::of(json).map(|fields| fields.0)
    }
}

impl FromJson for f64 {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        json.as_f64().ok_or(Misfit::Expected("a number"))
    }
}

impl FromJson for bool {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        json.as_bool().ok_or(Misfit::Expected("true or false"))
    }
}

impl FromJson for String {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        match json {
            Json::String(text) => Ok(text),
            _ => Err(Misfit::Expected("a text")),
        }
    }
}

impl FromJson for char {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let text = String::from_json(json)?;
        let mut letters = text.chars();
        match (letters.next(), letters.next()) {
            (Some(letter), None) => Ok(letter),
            _ => Err(Misfit::Expected("one character")),
        }
    }
}

impl FromJson for (String, String) {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let pair: [String; 2] = Vec::from_json(json)?
            .try_into()
            .map_err(|_| Misfit::Expected("two texts"))?;
        Ok(pair.into())
    }
}

impl<T: FromJson> FromJson for Box<T> {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        T::from_json(json).map(Self::new)
    }
}

impl<T: FromJson> FromJson for Vec<T> {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let Json::Array(items) = json else {
            return Err(Misfit::Expected("a list"));
        };
        let mut list = Self::with_capacity(items.len());
        for item in items {
            list.push(T::from_json(item)?);
        }
        Ok(list)
    }
}

/// Names the variants of an enum without fields, by which they are written and read.
#[macro_export]
macro_rules! named {
    ($type:ty, $expected:literal, { $($name:literal => $variant:ident),+ $(,)? }) => {
        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, writer: S) -> Result<S::Ok, S::Error> {
                writer.serialize_str(match self {
                    $(<$type>::$variant => $name,)+
                })
            }
        }

        impl $crate::FromJson for $type {
            fn from_json(json: serde_json::Value) -> Result<Self, $crate::Misfit> {
                let found = String::from_json(json)?;
                let names = [$(($name, <$type>::$variant)),+];
                match names.into_iter().find(|(name, _)| *name == found) {
                    Some((_, variant)) => Ok(variant),
                    None => Err($crate::Misfit::Unknown { expected: $expected, found }),
                }
            }
        }

        $crate::deserialize!($type);
    };
}

/// Lets serde read types by [`FromJson`].
#[macro_export]
macro_rules! deserialize {
    ($($type:ty),+) => {$(
        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(reader: D) -> Result<Self, D::Error> {
                let json = serde_json::Value::deserialize(reader)?;
                $crate::FromJson::from_json(json).map_err(serde::de::Error::custom)
            }
        }
    )+};
}
