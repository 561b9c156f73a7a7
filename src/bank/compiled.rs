//! Compiled items: all that makes a template, without the parsers of TOML, Markdown and LaTeX.
//!
//! A compiled item is the tree of its file in which each text stands as the number of the document
//! that was made of it. Building a template from it takes the same way as from a file, so that it is
//! the same template: the formulas are read again, the texts are taken as they are.
//! What only a bank's author needs is left out: known results, notes, and sources of figures in words.

use serde::Serialize;
use serde_json::Value as Json;

use super::read;
use super::{ItemId, Revision, Template};
use crate::document::Document;
use crate::math::Math;
use crate::source::{Fields, FromJson, Misfit, Problems, Source, Value, deserialize};

/// An item, compiled. Its JSON is what a self-check page carries; it belongs to one version of the
/// program and is not a format to keep.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Compiled {
    /// Its identity.
    pub id: ItemId,
    /// The text of the file it was compiled from.
    pub revision: Revision,
    #[serde(rename = "tree")]
    tree: Value,
    #[serde(rename = "texts")]
    documents: Vec<Document>,
    symbols: Vec<Math>,
}

/// A compiled item that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{item}` is not a compiled item of this version: {reason}")]
pub struct CompiledError {
    /// The identity that the compiled item claims.
    pub item: String,
    /// What is wrong first.
    pub reason: String,
}

impl Compiled {
    /// Compiles the file of a template.
    ///
    /// ```
    /// use vibank::bank::{Catalogue, Compiled, embedded};
    /// let (catalogue, _) = Catalogue::load(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// let json = serde_json::to_string(&Compiled::of(item)).unwrap();
    /// let again: Compiled = serde_json::from_str(&json).unwrap();
    /// assert_eq!(again.template().unwrap().parts.len(), item.parts.len());
    /// ```
    #[cfg(feature = "render")]
    pub fn of(template: &Template) -> Self {
        let problems = Problems::default();
        let tree = crate::source::toml::read(&template.source, &problems);
        let mut tree = super::own::in_form(tree);
        let mut noted = read::Noting::default();
        let item = read::Item {
            id: template.id.clone(),
            revision: template.revision,
            source: &template.source,
            tree: &tree,
            topics: None,
        };
        // The template was read before: there is nothing new to find.
        let _ = read::item(item, &problems, &mut noted);
        noting::strip(&mut tree);
        let (documents, symbols) = noting::number(&mut tree, noted);
        Self {
            id: template.id.clone(),
            revision: template.revision,
            tree,
            documents,
            symbols,
        }
    }

    /// The same without the texts under these keys, such as `solution` and `feedback`.
    #[cfg(feature = "render")]
    #[must_use]
    pub fn silenced(&self, keys: &[&str]) -> Self {
        let mut silenced = self.clone();
        for place in noting::texts_under(&self.tree, keys) {
            if let Some(document) = silenced.documents.get_mut(place) {
                *document = Document::default();
            }
        }
        silenced
    }

    /// The template.
    ///
    /// # Errors
    ///
    /// [`CompiledError`]: something in it has another form than this version of the program gives it.
    pub fn template(&self) -> Result<Template, CompiledError> {
        let source = Source::new(format!("{}.toml", self.id), "");
        let item = read::Item {
            id: self.id.clone(),
            revision: self.revision,
            source: &source,
            tree: &self.tree,
            topics: None,
        };
        let mut texts = read::Stored {
            documents: &self.documents,
            symbols: &self.symbols,
        };
        let (template, findings) = read::item(item, &Problems::default(), &mut texts);
        template.ok_or_else(|| CompiledError {
            item: self.id.to_string(),
            reason: findings
                .first()
                .map(|finding| finding.message.clone())
                .unwrap_or_default(),
        })
    }
}

deserialize!(Compiled);

impl FromJson for Compiled {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        Ok(Self {
            id: fields.take("id")?,
            revision: fields.take("revision")?,
            tree: fields.take("tree")?,
            documents: fields.take("texts")?,
            symbols: fields.take("symbols")?,
        })
    }
}

#[cfg(feature = "render")]
mod noting {
    //! From the tree of a file to that of a compiled item.

    use std::collections::BTreeMap;

    use super::read::Noting;
    use crate::document::Document;
    use crate::math::Math;
    use crate::source::{Data, Span, Value};

    /// Leaves out what only an author needs.
    pub(crate) fn strip(tree: &mut Value) {
        let Data::Table(entries) = &mut tree.data else {
            return;
        };
        entries.retain(|entry| entry.key != "check" && entry.key != "allow");
        let about = entries.iter_mut().find(|entry| entry.key == "item");
        if let Some(Data::Table(entries)) = about.map(|entry| &mut entry.value.data) {
            entries.retain(|entry| entry.key != "notes");
        }
    }

    /// The numbers of the texts under these keys.
    pub(crate) fn texts_under(tree: &Value, keys: &[&str]) -> Vec<usize> {
        let mut found = Vec::new();
        let mut open = vec![(tree, false)];
        while let Some((value, is_under)) = open.pop() {
            match &value.data {
                Data::Text(number) if is_under => found.extend(number.parse::<usize>()),
                Data::List(items) => open.extend(items.iter().map(|item| (item, is_under))),
                Data::Table(entries) => open.extend(entries.iter().map(|entry| {
                    let is_key = keys.contains(&entry.key.as_str());
                    (&entry.value, is_under || is_key)
                })),
                _ => {}
            }
        }
        found
    }

    /// Puts numbers in place of the texts that were noted.
    pub(crate) fn number(tree: &mut Value, noted: Noting) -> (Vec<Document>, Vec<Math>) {
        let mut kept = Kept {
            noted: noted.documents.into_iter().collect(),
            symbols_noted: noted.symbols.into_iter().collect(),
            documents: Vec::new(),
            symbols: Vec::new(),
        };
        kept.walk(tree);
        (kept.documents, kept.symbols)
    }

    struct Kept {
        noted: BTreeMap<Span, Document>,
        symbols_noted: BTreeMap<Span, Math>,
        documents: Vec<Document>,
        symbols: Vec<Math>,
    }

    impl Kept {
        fn walk(&mut self, value: &mut Value) {
            match &mut value.data {
                Data::Text(text) => {
                    if let Some(document) = self.noted.remove(&value.span) {
                        *text = self.documents.len().to_string();
                        self.documents.push(document);
                    } else if let Some(symbol) = self.symbols_noted.remove(&value.span) {
                        *text = self.symbols.len().to_string();
                        self.symbols.push(symbol);
                    }
                }
                Data::List(items) => items.iter_mut().for_each(|item| self.walk(item)),
                Data::Table(entries) => entries
                    .iter_mut()
                    .for_each(|entry| self.walk(&mut entry.value)),
                Data::Boolean(_) | Data::Number { .. } => {}
            }
        }
    }
}
