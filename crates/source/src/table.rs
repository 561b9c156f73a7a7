//! The reader that takes typed fields out of a table.

use std::cell::RefCell;

use super::{Data, Entry, Problem, Source, Span, Text, Value};

/// What a reader notices on its way through a file; tables share it.
#[derive(Debug, Default)]
pub struct Problems {
    noted: RefCell<Vec<Problem>>,
    /// The keys that the table of the whole file may have.
    of_file: RefCell<Vec<&'static str>>,
}

/// A table that is being read: it notices wrong kinds and, in the end, keys that nobody asked for.
#[derive(Debug)]
pub struct Table<'s> {
    source: &'s Source,
    problems: &'s Problems,
    name: String,
    span: Span,
    entries: &'s [Entry],
    asked: RefCell<Vec<&'static str>>,
}

impl Problems {
    /// Notes one.
    pub fn add(&self, problem: Problem) {
        self.noted.borrow_mut().push(problem);
    }

    /// All that were noted, and none is left.
    pub fn take(&self) -> Vec<Problem> {
        let of_file = self.of_file.take();
        let mut noted = self.noted.take();
        for problem in &mut noted {
            if let Problem::Unknown {
                table,
                key,
                is_of_file,
                ..
            } = problem
            {
                *is_of_file &= !table.is_empty() && of_file.contains(&key.as_str());
            }
        }
        noted
    }

    fn kind(&self, key: &str, expected: &'static str, value: &Value) {
        let found = value.data.describe().to_owned();
        self.add(Problem::Kind {
            key: key.to_owned(),
            expected,
            found,
            span: value.span,
        });
    }
}

/// About how many keys are asked for that are not there.
const USUAL_OTHERS: usize = 8;

impl<'s> Table<'s> {
    /// The table `value`, called `name` in messages; `None`, and a problem, where it is not a table.
    pub fn of(
        source: &'s Source,
        problems: &'s Problems,
        name: &str,
        value: &'s Value,
    ) -> Option<Self> {
        let Data::Table(entries) = &value.data else {
            problems.kind(name, "a table", value);
            return None;
        };
        let name = name.to_owned();
        Some(Self {
            source,
            problems,
            name,
            span: value.span,
            entries,
            asked: RefCell::new(Vec::with_capacity(entries.len() + USUAL_OTHERS)),
        })
    }

    /// The file in which it stands.
    pub fn source(&self) -> &'s Source {
        self.source
    }

    /// Where problems are noted.
    pub fn problems(&self) -> &'s Problems {
        self.problems
    }

    /// How messages call it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it begins.
    pub fn span(&self) -> Span {
        self.span
    }

    /// All keys and values, for tables whose keys are names; nothing is unknown then.
    pub fn entries(&self) -> &'s [Entry] {
        self.entries
    }

    /// The entry of a key, whatever its kind.
    pub fn entry(&self, key: &'static str) -> Option<&'s Entry> {
        self.asked.borrow_mut().push(key);
        self.entries.iter().find(|entry| entry.key == key)
    }

    /// The value of a key, whatever its kind.
    pub fn value(&self, key: &'static str) -> Option<&'s Value> {
        self.entry(key).map(|entry| &entry.value)
    }

    /// Whether the key is there.
    pub fn has(&self, key: &'static str) -> bool {
        self.value(key).is_some()
    }

    /// The text under a key; nothing where it is missing, and a problem is noted where it is something else.
    pub fn text(&self, key: &'static str) -> Option<Text> {
        self.value(key).and_then(|value| self.as_text(key, value))
    }

    /// A text that has to be there and to say something.
    pub fn required_text(&self, key: &'static str) -> Option<Text> {
        let text = self.as_text(key, self.required(key)?)?;
        if text.value.trim().is_empty() {
            let span = text.span;
            self.problems.add(Problem::Blank { key, span });
            return None;
        }
        Some(text)
    }

    /// A value that has to be there, whatever its kind.
    pub fn required(&self, key: &'static str) -> Option<&'s Value> {
        let value = self.value(key);
        if value.is_none() {
            self.problems.add(Problem::Missing {
                table: self.name.clone(),
                key,
                span: self.span,
            });
        }
        value
    }

    /// Texts; also one text that stands alone.
    pub fn texts(&self, key: &'static str) -> Vec<Text> {
        match self.value(key) {
            None => Vec::new(),
            Some(
                value @ Value {
                    data: Data::Text(_),
                    ..
                },
            ) => self.as_text(key, value).into_iter().collect(),
            Some(value) => self
                .items(key, value)
                .iter()
                .filter_map(|item| self.as_text(key, item))
                .collect(),
        }
    }

    /// `true` or `false`.
    pub fn boolean(&self, key: &'static str) -> Option<bool> {
        let value = self.value(key)?;
        match value.data {
            Data::Boolean(boolean) => Some(boolean),
            _ => self.wrong(key, "true or false", value),
        }
    }

    /// The finite number under a key; nothing where it is missing, and a problem is noted where it is something else.
    pub fn number(&self, key: &'static str) -> Option<f64> {
        self.as_number(key, self.value(key)?)
    }

    /// A value of this table as a number.
    pub fn as_number(&self, key: &str, value: &Value) -> Option<f64> {
        let number = match &value.data {
            Data::Number { number } => binary(number).filter(|number| number.is_finite()),
            _ => None,
        };
        let expected = match &value.data {
            Data::Number { .. } => "a finite number",
            _ => "a number",
        };
        number.or_else(|| self.out_of_range(key, expected, value))
    }

    /// A value of this table as a number of a range, which `expected` says in words.
    pub fn as_number_in(
        &self,
        key: &str,
        value: &Value,
        expected: &'static str,
        range: std::ops::RangeInclusive<f64>,
    ) -> Option<f64> {
        let number = match &value.data {
            Data::Number { number } => binary(number).filter(|number| range.contains(number)),
            _ => None,
        };
        number.or_else(|| self.out_of_range(key, expected, value))
    }

    /// An integer of a range.
    pub fn integer(
        &self,
        key: &'static str,
        expected: &'static str,
        range: std::ops::RangeInclusive<i64>,
    ) -> Option<i64> {
        let value = self.value(key)?;
        let integer = match &value.data {
            Data::Number { number } => number.parse().ok().filter(|number| range.contains(number)),
            _ => None,
        };
        integer.or_else(|| self.out_of_range(key, expected, value))
    }

    /// Notes a value that is not a number, or a number that cannot be taken, which is then quoted.
    fn out_of_range<T>(&self, key: &str, expected: &'static str, value: &Value) -> Option<T> {
        let found = match &value.data {
            Data::Number { number } => format!("`{number}`"),
            other => other.describe().to_owned(),
        };
        self.problems.add(Problem::Kind {
            key: key.to_owned(),
            expected,
            found,
            span: value.span,
        });
        None
    }

    /// The table under a key; nothing where it is missing, and a problem is noted where it is something else.
    pub fn table(&self, key: &'static str) -> Option<Table<'s>> {
        let value = self.value(key)?;
        Table::of(self.source, self.problems, &self.inner(key), value)
    }

    /// A table that has to be there.
    pub fn required_table(&self, key: &'static str) -> Option<Table<'s>> {
        let value = self.required(key)?;
        Table::of(self.source, self.problems, &self.inner(key), value)
    }

    /// An array of tables.
    pub fn tables(&self, key: &'static str) -> Vec<Table<'s>> {
        let Some(value) = self.value(key) else {
            return Vec::new();
        };
        let name = self.inner(key);
        let items = self.items(key, value).iter();
        items
            .filter_map(|item| Table::of(self.source, self.problems, &name, item))
            .collect()
    }

    /// The items of an array.
    pub fn items(&self, key: &str, value: &'s Value) -> &'s [Value] {
        match &value.data {
            Data::List(items) => items,
            _ => {
                self.problems.kind(key, "an array", value);
                &[]
            }
        }
    }

    /// A value as text.
    pub fn as_text(&self, key: &str, value: &'s Value) -> Option<Text> {
        match &value.data {
            Data::Text(text) => Some(Text {
                value: text.clone(),
                span: value.span,
            }),
            _ => self.wrong(key, "a text", value),
        }
    }

    /// A value as texts: one text, or an array of them.
    pub fn as_texts(&self, key: &str, value: &'s Value) -> Vec<Text> {
        match &value.data {
            Data::List(items) => {
                let texts = items.iter().map(|item| self.as_text(key, item));
                texts.flatten().collect()
            }
            _ => self.as_text(key, value).into_iter().collect(),
        }
    }

    /// A value as the text of a formula: a text, or a number that stands for itself.
    pub fn as_formula(&self, key: &str, value: &'s Value) -> Option<Text> {
        match &value.data {
            Data::Text(text) => Some(Text {
                value: text.clone(),
                span: value.span,
            }),
            Data::Number { number } => Some(Text {
                value: number.clone(),
                span: value.span,
            }),
            _ => self.wrong(key, "a formula", value),
        }
    }

    /// Notes that a value is of the wrong kind.
    pub fn wrong<T>(&self, key: &str, expected: &'static str, value: &Value) -> Option<T> {
        self.problems.kind(key, expected, value);
        None
    }

    /// Notes every key that was not asked for.
    pub fn finish(self) {
        self.finish_ref();
    }

    /// Notes every key that was not asked for so far.
    pub fn finish_ref(&self) {
        let asked = self.asked.borrow();
        if self.name.is_empty() {
            self.problems.of_file.borrow_mut().extend(&*asked);
        }
        let is_asked = |entry: &&Entry| asked.contains(&entry.key.as_str());
        for entry in self.entries.iter().filter(|entry| !is_asked(entry)) {
            let mut known = Vec::new();
            for key in &*asked {
                if let Err(at) = known.binary_search(key) {
                    known.insert(at, *key);
                }
            }
            let (table, key) = (self.name.clone(), entry.key.clone());
            self.problems.add(Problem::Unknown {
                table,
                key,
                known,
                // Whether the file has it shows when all is read. A table has a header of its own.
                is_of_file: !matches!(entry.value.data, Data::Table(_)),
                span: entry.span,
            });
        }
    }

    fn inner(&self, key: &str) -> String {
        if self.name.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.name)
        }
    }
}

/// The binary number nearest to a decimal one of TOML. The reader of JSON is in the grader of the page as it is, as long as
/// any value is read, not a number alone; that of the standard library would bring a table of ten kilobytes.
fn binary(number: &str) -> Option<f64> {
    let number: serde_json::Value =
        serde_json::from_str(number.strip_prefix('+').unwrap_or(number)).ok()?;
    number.as_f64()
}
