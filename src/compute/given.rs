//! What a request gives, read without a tree of its text.
//!
//! Lists of numbers are the bulk of long requests: they become lists of numbers at once.

use std::borrow::Cow;
use std::fmt;

use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor,
};

/// A JSON value, texts borrowed where they hold no escapes.
#[derive(Debug)]
pub(crate) enum GivenValue<'a> {
    /// `null`, which is as good as absent.
    Null,
    /// A number that binary64 holds as it is written, or next to it.
    Number(f64),
    /// A text, or an integer too long for binary64, as it is written.
    Text(Cow<'a, str>),
    /// A list of numbers alone.
    Numbers(Vec<f64>),
    /// A list of lists of numbers alone, all of the same length, one after the other.
    Table { entries: Vec<f64>, width: usize },
    /// A list of anything else.
    List(Vec<GivenValue<'a>>),
    /// An object; of equal keys the last counts.
    Object(Object<'a>),
    /// `true` or `false`.
    Truth,
}

/// The members of an object as they came.
#[derive(Debug, Default)]
pub(crate) struct Object<'a> {
    members: Vec<(Cow<'a, str>, GivenValue<'a>)>,
}

impl<'a> Object<'a> {
    pub(crate) fn of(members: Vec<(Cow<'a, str>, GivenValue<'a>)>) -> Self {
        Self { members }
    }

    pub(crate) fn get(&self, name: &str) -> Option<&GivenValue<'a>> {
        let mut members = self.members.iter().rev();
        members.find(|(key, _)| key == name).map(|(_, value)| value)
    }

    pub(crate) fn keys(&self) -> impl Iterator<Item = &str> {
        self.members.iter().map(|(key, _)| key.as_ref())
    }
}

/// The members of a line that is a request; `Other` for JSON that is not an object.
#[derive(Debug)]
pub(crate) enum RequestLine<'a> {
    Request {
        /// What is given back with the reply.
        id: serde_json::Value,
        rest: Object<'a>,
    },
    Other,
}

struct OfValue;

impl<'a> Visitor<'a> for OfValue {
    type Value = GivenValue<'a>;

    fn expecting(&self, text: &mut fmt::Formatter) -> fmt::Result {
        text.write_str("any JSON")
    }

    fn visit_unit<E>(self) -> Result<GivenValue<'a>, E> {
        Ok(GivenValue::Null)
    }

    fn visit_bool<E>(self, _: bool) -> Result<GivenValue<'a>, E> {
        Ok(GivenValue::Truth)
    }

    fn visit_f64<E>(self, number: f64) -> Result<GivenValue<'a>, E> {
        Ok(GivenValue::Number(number))
    }

    fn visit_u64<E>(self, number: u64) -> Result<GivenValue<'a>, E> {
        Ok(integer(number, number <= MAX_EXACT))
    }

    fn visit_i64<E>(self, number: i64) -> Result<GivenValue<'a>, E> {
        Ok(integer(number, number.unsigned_abs() <= MAX_EXACT))
    }

    fn visit_borrowed_str<E>(self, text: &'a str) -> Result<GivenValue<'a>, E> {
        Ok(GivenValue::Text(text.into()))
    }

    fn visit_str<E>(self, text: &str) -> Result<GivenValue<'a>, E> {
        Ok(GivenValue::Text(text.to_owned().into()))
    }

    fn visit_seq<A: SeqAccess<'a>>(self, mut entries: A) -> Result<GivenValue<'a>, A::Error> {
        let mut list = GivenEntries::default();
        while let Some(other) = entries.next_element_seed(&mut list)? {
            if let Some(other) = other {
                list.split().push(other);
            }
        }
        Ok(list.into_value())
    }

    fn visit_map<A: MapAccess<'a>>(self, mut entries: A) -> Result<GivenValue<'a>, A::Error> {
        let mut members = Vec::new();
        while let Some((ObjectKey(key), value)) = entries.next_entry()? {
            members.push((key, value));
        }
        Ok(GivenValue::Object(Object::of(members)))
    }
}

/// Integers up to this are binary64 numbers.
const MAX_EXACT: u64 = 1 << f64::MANTISSA_DIGITS;

impl<'a> Deserialize<'a> for GivenValue<'a> {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OfValue)
    }
}

/// A list while it is read: numbers, or rows of equal length, go to one vector as long as nothing else has come.
#[derive(Default)]
struct GivenEntries<'a> {
    numbers: Vec<f64>,
    /// Length of the rows; none while there are plain numbers.
    width: Option<usize>,
    /// All entries, once they are neither.
    list: Option<Vec<GivenValue<'a>>>,
}

impl<'a> GivenEntries<'a> {
    /// The entries one by one.
    fn split(&mut self) -> &mut Vec<GivenValue<'a>> {
        let numbers = std::mem::take(&mut self.numbers);
        let width = self.width.take();
        self.list.get_or_insert_with(|| match width {
            Some(width) => {
                let rows = numbers.chunks_exact(width);
                rows.map(|row| GivenValue::Numbers(row.to_vec())).collect()
            }
            None => numbers.into_iter().map(GivenValue::Number).collect(),
        })
    }

    fn into_value(self) -> GivenValue<'a> {
        match (self.list, self.width) {
            (Some(list), _) => GivenValue::List(list),
            (None, Some(width)) => GivenValue::Table {
                entries: self.numbers,
                width,
            },
            (None, None) => GivenValue::Numbers(self.numbers),
        }
    }
}

/// Takes in one entry; gives back what is neither a number nor a row that fits.
impl<'a> DeserializeSeed<'a> for &mut GivenEntries<'a> {
    type Value = Option<GivenValue<'a>>;

    fn deserialize<D: Deserializer<'a>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'a> Visitor<'a> for &mut GivenEntries<'a> {
    type Value = Option<GivenValue<'a>>;

    fn expecting(&self, text: &mut fmt::Formatter) -> fmt::Result {
        OfValue.expecting(text)
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Self::Value, E> {
        if self.list.is_some() || self.width.is_some() {
            return Ok(Some(GivenValue::Number(number)));
        }
        self.numbers.push(number);
        Ok(None)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Self::Value, E> {
        match integer(number, number <= MAX_EXACT) {
            GivenValue::Number(number) => self.visit_f64(number),
            other => Ok(Some(other)),
        }
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Self::Value, E> {
        match integer(number, number.unsigned_abs() <= MAX_EXACT) {
            GivenValue::Number(number) => self.visit_f64(number),
            other => Ok(Some(other)),
        }
    }

    fn visit_unit<E: Error>(self) -> Result<Self::Value, E> {
        OfValue.visit_unit().map(Some)
    }

    fn visit_bool<E: Error>(self, truth: bool) -> Result<Self::Value, E> {
        OfValue.visit_bool(truth).map(Some)
    }

    fn visit_borrowed_str<E: Error>(self, text: &'a str) -> Result<Self::Value, E> {
        OfValue.visit_borrowed_str(text).map(Some)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        OfValue.visit_str(text).map(Some)
    }

    fn visit_map<A: MapAccess<'a>>(self, entries: A) -> Result<Self::Value, A::Error> {
        OfValue.visit_map(entries).map(Some)
    }

    fn visit_seq<A: SeqAccess<'a>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
        let may_be_table = self.list.is_none() && (self.width.is_some() || self.numbers.is_empty());
        if !may_be_table {
            return OfValue.visit_seq(entries).map(Some);
        }
        // The row goes to the end of the table; where it does not fit it is taken out again.
        let start = self.numbers.len();
        let mut row = GivenEntries {
            numbers: std::mem::take(&mut self.numbers),
            ..GivenEntries::default()
        };
        let mut other = None;
        while other.is_none() {
            match entries.next_element_seed(&mut row)? {
                Some(entry) => other = entry,
                None => break,
            }
        }
        self.numbers = std::mem::take(&mut row.numbers);
        let width = self.numbers.len() - start;
        let is_row = other.is_none() && row.width.is_none() && width > 0;
        if is_row && self.width.is_none_or(|known| known == width) {
            self.width = Some(width);
            return Ok(None);
        }
        row.numbers = self.numbers.split_off(start);
        if let Some(other) = other {
            row.split().push(other);
            while let Some(entry) = entries.next_element()? {
                row.split().push(entry);
            }
        }
        Ok(Some(row.into_value()))
    }
}

/// An integer, as a number if binary64 holds it.
fn integer<'a>(number: impl ToString + Into<i128>, is_short: bool) -> GivenValue<'a> {
    if is_short {
        GivenValue::Number(number.into() as f64)
    } else {
        GivenValue::Text(number.to_string().into())
    }
}

struct ObjectKey<'a>(Cow<'a, str>);

impl<'a> Deserialize<'a> for ObjectKey<'a> {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        struct OfKey;

        impl<'a> Visitor<'a> for OfKey {
            type Value = ObjectKey<'a>;

            fn expecting(&self, text: &mut fmt::Formatter) -> fmt::Result {
                text.write_str("a key")
            }

            fn visit_borrowed_str<E>(self, text: &'a str) -> Result<ObjectKey<'a>, E> {
                Ok(ObjectKey(text.into()))
            }

            fn visit_str<E>(self, text: &str) -> Result<ObjectKey<'a>, E> {
                Ok(ObjectKey(text.to_owned().into()))
            }
        }

        deserializer.deserialize_str(OfKey)
    }
}

struct OfLine;

impl<'a> Visitor<'a> for OfLine {
    type Value = RequestLine<'a>;

    fn expecting(&self, text: &mut fmt::Formatter) -> fmt::Result {
        text.write_str("a request")
    }

    fn visit_unit<E>(self) -> Result<RequestLine<'a>, E> {
        Ok(RequestLine::Other)
    }

    fn visit_bool<E>(self, _: bool) -> Result<RequestLine<'a>, E> {
        Ok(RequestLine::Other)
    }

    fn visit_f64<E>(self, _: f64) -> Result<RequestLine<'a>, E> {
        Ok(RequestLine::Other)
    }

    fn visit_u64<E>(self, _: u64) -> Result<RequestLine<'a>, E> {
        Ok(RequestLine::Other)
    }

    fn visit_i64<E>(self, _: i64) -> Result<RequestLine<'a>, E> {
        Ok(RequestLine::Other)
    }

    fn visit_str<E>(self, _: &str) -> Result<RequestLine<'a>, E> {
        Ok(RequestLine::Other)
    }

    fn visit_seq<A: SeqAccess<'a>>(self, mut entries: A) -> Result<RequestLine<'a>, A::Error> {
        while entries.next_element::<IgnoredAny>()?.is_some() {}
        Ok(RequestLine::Other)
    }

    fn visit_map<A: MapAccess<'a>>(self, mut entries: A) -> Result<RequestLine<'a>, A::Error> {
        let mut id = serde_json::Value::Null;
        let mut members = Vec::new();
        while let Some(ObjectKey(key)) = entries.next_key()? {
            if key == "id" {
                id = entries.next_value()?;
            } else {
                members.push((key, entries.next_value()?));
            }
        }
        let rest = Object::of(members);
        Ok(RequestLine::Request { id, rest })
    }
}

impl<'a> Deserialize<'a> for RequestLine<'a> {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OfLine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> GivenValue<'_> {
        serde_json::from_str(text).unwrap()
    }

    #[test]
    fn lists_of_numbers_are_lists_of_numbers() {
        assert!(
            matches!(value("[1,2.5,-3]"), GivenValue::Numbers(list) if list == [1.0, 2.5, -3.0])
        );
        let GivenValue::List(list) = value(r#"[1,"2",[3]]"#) else {
            panic!("a mixed list");
        };
        assert!(matches!(list[0], GivenValue::Number(1.0)));
        assert!(matches!(&list[1], GivenValue::Text(text) if text == "2"));
        assert!(matches!(&list[2], GivenValue::Numbers(list) if *list == [3.0]));
    }

    #[test]
    fn rows_of_equal_length_are_a_table() {
        let GivenValue::Table { entries, width } = value("[[1,2],[3,4],[5,6]]") else {
            panic!("a table");
        };
        assert_eq!(
            (entries.as_slice(), width),
            ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0].as_slice(), 2)
        );
        for (text, shown) in [
            ("[[1,2],[3]]", "List([Numbers([1.0, 2.0]), Numbers([3.0])])"),
            (
                "[[1],[\"2\"],[3]]",
                r#"List([Numbers([1.0]), List([Text("2")]), Numbers([3.0])])"#,
            ),
            (
                "[[1],[2,null,3],4]",
                "List([Numbers([1.0]), List([Number(2.0), Null, Number(3.0)]), Number(4.0)])",
            ),
            ("[[],[1]]", "List([Numbers([]), Numbers([1.0])])"),
            ("[[1],2]", "List([Numbers([1.0]), Number(2.0)])"),
            ("[1,[2]]", "List([Number(1.0), Numbers([2.0])])"),
            (
                "[[[1]],[[2]]]",
                "List([Table { entries: [1.0], width: 1 }, Table { entries: [2.0], width: 1 }])",
            ),
        ] {
            assert_eq!(format!("{:?}", value(text)), shown, "{text}");
        }
    }

    #[test]
    fn integers_beyond_binary64_keep_their_digits() {
        assert!(matches!(value("9007199254740992"), GivenValue::Number(_)));
        let text = "9007199254740993";
        assert!(matches!(value(text), GivenValue::Text(digits) if digits == text));
    }

    #[test]
    fn the_last_of_equal_keys_counts() {
        let GivenValue::Object(object) = value(r#"{"a":1,"\u0061":2}"#) else {
            panic!("an object");
        };
        assert!(matches!(object.get("a"), Some(GivenValue::Number(2.0))));
    }
}
