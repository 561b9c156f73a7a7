//! From the table `[figure]` to a figure, with all findings at once.

use std::sync::OnceLock;

use super::FigureLabel;
use super::element::{self, Element, Holds, Role, Takes};
use super::error::FigureError;
use super::formula::{self, Amount, FigureNames, FigurePair};
use super::free::{Acting, FreeReader};
use super::motion::motion;
use super::outline::Side;
use super::part::{LineStyle, Setting};
use super::schematic::{DeclaredLabel, ElementPlace, Figure, Item, KeyValue, Labels, Local};
use crate::diagnostic::{Diagnose, Finding};
use crate::expr::{Expr, Kind, Name, Scope};
use crate::math::Math;
use crate::source::{Data, Table, Text, Value as Node, nearest};
use crate::unit::Dimension;

/// The item whose figure is read.
pub trait Subject {
    /// Its names.
    fn scope(&self) -> &dyn Scope;

    /// A formula in its symbols.
    fn typeset(&self, formula: &Expr) -> Math;

    /// The bodies of its model, for free-body diagrams.
    fn bodies(&self) -> Vec<Acting> {
        Vec::new()
    }

    /// The coordinates of its model with their dimensions, in order, for figures that move.
    fn coordinates(&self) -> Vec<(Name, Dimension)> {
        Vec::new()
    }

    /// A formula with the coordinates of its model in place of the kinematic names.
    fn in_coordinates(&self, formula: &Expr) -> Expr {
        formula.clone()
    }
}

/// Most elements of a figure, and most names.
const MAX_COUNT: usize = 300;

pub(crate) struct FigureReader<'a, 's> {
    pub(crate) table: &'a Table<'s>,
    pub(crate) item: &'a dyn Subject,
    pub(crate) names: FigureNames,
    pub(crate) findings: Vec<Finding>,
    /// Points whose bodies are referred to, with what is wanted and the text that does.
    wanted: Vec<(u32, bool, Text)>,
}

impl<'a, 's> FigureReader<'a, 's> {
    pub(crate) fn new(table: &'a Table<'s>, item: &'a dyn Subject) -> Self {
        Self {
            table,
            item,
            names: FigureNames::default(),
            findings: Vec::new(),
            wanted: Vec::new(),
        }
    }

    /// The figure, and what is wrong with it.
    pub(crate) fn figure(mut self) -> (Figure, Vec<Finding>) {
        let table = self.table;
        let alt = table.text("alt").map(|text| text.value);
        let labels = self.word(table, "labels", &["symbol", "value", "both"]);
        let locals = self.locals();
        let elements = table.value("elements");
        let rows = elements.map_or(&[][..], |value| table.items("elements", value));
        let items: Vec<Item> = rows
            .iter()
            .take(MAX_COUNT)
            .filter_map(|row| self.element(row))
            .collect();
        let free = FreeReader::new(&mut self, &items).diagrams(rows);
        self.hold_wanted(&items);
        // What it takes is counted apart: a figure that stands still does not pay for its motion.
        let taken = self.names.taken();
        let motion = motion(&mut self);
        let mut order: Vec<usize> = (0..items.len()).collect();
        crate::numerics::sort_by_key(&mut order, |place| items[*place].kind.layer());
        let figure = Figure {
            alt,
            labels: match labels {
                Some("value") => Labels::Value,
                Some("both") => Labels::Both,
                _ => Labels::Symbol,
            },
            locals,
            taken,
            slots: self.names.slots(),
            items,
            order,
            free,
            motion,
            alike: OnceLock::new(),
        };
        (figure, self.findings)
    }

    fn locals(&mut self) -> Vec<(u32, Local)> {
        let mut locals = Vec::new();
        let table = self.table;
        if let Some(inner) = table.table("where") {
            for entry in inner.entries().iter().take(MAX_COUNT) {
                let amount = inner
                    .as_formula(&entry.key, &entry.value)
                    .and_then(|text| self.amount(&text));
                let slot = self.names.add(&entry.key, false);
                locals.extend(amount.map(|amount| (slot, Local::Number(amount))));
            }
        }
        if let Some(inner) = table.table("points") {
            for entry in inner.entries().iter().take(MAX_COUNT) {
                let pair = self.pair(&inner, &entry.key, &entry.value);
                let slot = self.names.add(&entry.key, true);
                locals.extend(pair.map(|pair| (slot, Local::Point(pair))));
            }
        }
        locals
    }

    fn element(&mut self, row: &'s Node) -> Option<Item> {
        let outer = self.table;
        let table = Table::of(outer.source(), outer.problems(), "figure.elements", row)?;
        let Some(first) = table.entries().first() else {
            self.find(&FigureError::Empty { span: row.span });
            return None;
        };
        let Some(kind) = element::kind(&first.key) else {
            self.find(&FigureError::Kind {
                found: first.key.clone(),
                span: first.span,
            });
            return None;
        };
        let value = table.value(kind.name())?;
        let mut settings = Vec::new();
        let mut symbol = None;
        let from = match kind.takes() {
            Takes::Label => table.required("from"),
            Takes::PointOrLabel => table.value("from"),
            _ => None,
        };
        let ends = match (kind.takes(), from) {
            (Takes::Label | Takes::PointOrLabel, Some(from)) => {
                symbol = table.as_text(kind.name(), value);
                self.place(&table, "from", from).map(|place| vec![place])
            }
            (Takes::Label, None) => None,
            (Takes::PointAndDegrees, _) => {
                self.centre_and_degrees(kind, &table, value, &mut settings)
            }
            (Takes::Point | Takes::PointOrLabel, _) => self
                .place(&table, kind.name(), value)
                .map(|place| vec![place]),
            (takes, _) => self.places(kind, takes, &table, value),
        };
        for key in kind.keys() {
            let is_place = key.name == "from" && matches!(key.holds, Holds::Point);
            if !is_place && let Some(setting) = self.setting(&table, key) {
                settings.push((key.name, setting));
            }
        }
        let label = table
            .text("label")
            .map(|text| (text, false))
            .or(symbol.map(|text| (text, kind.takes() == Takes::Label)))
            .and_then(|(text, is_symbol)| self.written(&text, is_symbol));
        let usual = kind.usual_label();
        let label = label.or_else(|| {
            (!usual.is_empty()).then(|| DeclaredLabel {
                label: FigureLabel::words(usual),
                math: Math::text(usual),
                name: None,
            })
        });
        let at = self
            .word(&table, "at", &Side::WORDS)
            .and_then(Side::of_word);
        let style = self
            .word(&table, "style", &LineStyle::WORDS)
            .and_then(LineStyle::of_word);
        let id = table.text("id").map(|text| text.value);
        table.finish();
        Some(Item {
            kind,
            id,
            ends: ends?,
            settings,
            label,
            at,
            style: style.unwrap_or_default(),
        })
    }

    fn places(
        &mut self,
        kind: &'static dyn Element,
        takes: Takes,
        table: &Table<'s>,
        value: &'s Node,
    ) -> Option<Vec<ElementPlace>> {
        let fits = |count: usize| match takes {
            Takes::Two => count == 2,
            Takes::Three => count == 3,
            _ => (2..=MAX_COUNT).contains(&count),
        };
        match &value.data {
            Data::List(items) if fits(items.len()) => items
                .iter()
                .map(|item| self.place(table, kind.name(), item))
                .collect(),
            data => {
                let found = match data {
                    Data::List(items) => format!("an array of {}", items.len()),
                    other => other.describe().to_owned(),
                };
                self.find(&FigureError::Place {
                    kind: kind.name(),
                    expected: takes.describe(),
                    found,
                    span: value.span,
                });
                None
            }
        }
    }

    fn centre_and_degrees(
        &mut self,
        kind: &'static dyn Element,
        table: &Table<'s>,
        value: &'s Node,
        settings: &mut Vec<(&'static str, KeyValue)>,
    ) -> Option<Vec<ElementPlace>> {
        if let Data::List(items) = &value.data
            && let [centre, degrees] = items.as_slice()
        {
            let text = table.as_formula(kind.name(), degrees)?;
            settings.push(("degrees", KeyValue::Number(self.amount(&text)?)));
            return Some(vec![self.place(table, kind.name(), centre)?]);
        }
        self.find(&FigureError::Place {
            kind: kind.name(),
            expected: kind.takes().describe(),
            found: value.data.describe().to_owned(),
            span: value.span,
        });
        None
    }

    fn setting(&mut self, table: &Table<'s>, key: &element::ElementKey) -> Option<KeyValue> {
        let value = || table.value(key.name);
        match key.holds {
            Holds::Flag => table
                .boolean(key.name)
                .map(|flag| KeyValue::Known(Setting::Flag(flag))),
            Holds::Word(words) => self
                .word(table, key.name, words)
                .map(|word| KeyValue::Known(Setting::Word(word))),
            Holds::Number => {
                let text = table.as_formula(key.name, value()?)?;
                self.amount(&text).map(KeyValue::Number)
            }
            Holds::Vector => self.pair(table, key.name, value()?).map(KeyValue::Vector),
            Holds::Point => self.place(table, key.name, value()?).map(KeyValue::Point),
        }
    }

    /// A point: by its name, a side of the body there, a pulley that is passed, or a formula.
    pub(crate) fn place(
        &mut self,
        table: &Table<'s>,
        key: &str,
        value: &'s Node,
    ) -> Option<ElementPlace> {
        let Data::Text(written) = &value.data else {
            return self.pair(table, key, value).map(ElementPlace::Free);
        };
        let text = table.as_text(key, value)?;
        let (words, written) = (written.split_whitespace(), written.trim());
        if let Some(slot) = self.names.point(written) {
            return Some(ElementPlace::Named(slot));
        }
        if let [name, sense @ ("cw" | "ccw")] = words.collect::<Vec<_>>()[..] {
            let slot = self.named(name, &text)?;
            self.wanted.push((slot, true, text));
            return Some(ElementPlace::Pass(slot, sense == "ccw"));
        }
        if let Some((name, side)) = written.split_once('.')
            && is_name(name)
            && is_name(side)
        {
            let slot = self.named(name, &text)?;
            let Some(side) = Side::of_body(side) else {
                self.find(&FigureError::Word {
                    key: "side of a body",
                    found: side.to_owned(),
                    known: Side::BODY.to_vec(),
                    span: text.span,
                });
                return None;
            };
            self.wanted.push((slot, false, text));
            return Some(ElementPlace::Side(slot, side));
        }
        self.pair(table, key, value).map(ElementPlace::Free)
    }

    pub(crate) fn named(&mut self, name: &str, text: &Text) -> Option<u32> {
        let slot = self.names.point(name);
        if slot.is_none() {
            self.find(&FigureError::Point {
                found: name.to_owned(),
                nearest: nearest(name, self.names.points()).map(str::to_owned),
                span: text.span,
            });
        }
        slot
    }

    /// Two numbers, `[x, y]`, or a formula for both.
    pub(crate) fn pair(
        &mut self,
        table: &Table<'s>,
        key: &str,
        value: &'s Node,
    ) -> Option<FigurePair> {
        if let Data::List(items) = &value.data
            && let [x, y] = items.as_slice()
        {
            let x = table.as_formula(key, x).and_then(|text| self.amount(&text));
            let y = table.as_formula(key, y).and_then(|text| self.amount(&text));
            return Some(match (x?, y?) {
                (Amount::Fixed(x), Amount::Fixed(y)) => FigurePair::Fixed(super::Point::new(x, y)),
                (x, y) => FigurePair::Each(Box::new([x, y])),
            });
        }
        if let Data::Text(_) = value.data {
            let text = table.as_text(key, value)?;
            let (source, findings) = (table.source(), &mut self.findings);
            let local = formula::LocalScope {
                names: &self.names,
                item: self.item.scope(),
            };
            return local.pair(&text, &mut |error, text| {
                findings.push(Finding::within(error, source, text));
            });
        }
        table.wrong(key, "a point, `[x, y]` or a formula", value)
    }

    pub(crate) fn amount(&mut self, text: &Text) -> Option<Amount> {
        let (source, findings) = (self.table.source(), &mut self.findings);
        let local = formula::LocalScope {
            names: &self.names,
            item: self.item.scope(),
        };
        local.amount(text, &mut |error, text| {
            findings.push(Finding::within(error, source, text));
        })
    }

    /// A label: a formula in the symbols of the item, or words between single quotes.
    pub(crate) fn written(&mut self, text: &Text, is_symbol: bool) -> Option<DeclaredLabel> {
        let words = text
            .value
            .strip_prefix('\'')
            .and_then(|rest| rest.strip_suffix('\''));
        if let Some(words) = words {
            return Some(DeclaredLabel {
                label: FigureLabel::words(words),
                math: Math::text(words),
                name: None,
            });
        }
        let expr = match Expr::read(&text.value) {
            Ok(expr) => expr,
            Err(error) => {
                self.find_in(&error, text);
                return None;
            }
        };
        // What a coordinate moves may have no name in the item.
        let is_known = is_symbol && matches!(expr.kind(), Kind::Name(_));
        if !is_known && let Err(errors) = expr.check(self.item.scope()) {
            errors.iter().for_each(|error| self.find_in(error, text));
            return None;
        }
        let math = self.item.typeset(&expr);
        let name = match expr.kind() {
            Kind::Name(name) => Some(name.clone()),
            _ => None,
        };
        Some(DeclaredLabel {
            label: FigureLabel::of(&math),
            math,
            name,
        })
    }

    pub(crate) fn word(
        &mut self,
        table: &Table<'s>,
        key: &'static str,
        known: &[&'static str],
    ) -> Option<&'static str> {
        let text = table.text(key)?;
        let word = known.iter().copied().find(|word| *word == text.value);
        if word.is_none() {
            self.find(&FigureError::Word {
                key,
                found: text.value,
                known: known.to_vec(),
                span: text.span,
            });
        }
        word
    }

    /// Sides and passes need a body.
    fn hold_wanted(&mut self, items: &[Item]) {
        for (slot, is_pass, text) in std::mem::take(&mut self.wanted) {
            let is_there = items.iter().any(|item| {
                matches!(item.kind.role(), Role::Body(_))
                    && matches!(item.ends.first(), Some(ElementPlace::Named(known)) if *known == slot)
            });
            let found = text
                .value
                .split([' ', '.'])
                .next()
                .unwrap_or_default()
                .to_owned();
            let span = text.span;
            match (is_there, is_pass) {
                (true, _) => {}
                (false, true) => self.find(&FigureError::NoPulley { found, span }),
                (false, false) => self.find(&FigureError::NoBody { found, span }),
            }
        }
    }

    /// Notes an error whose places count in the file.
    pub(crate) fn find(&mut self, error: &FigureError) {
        self.findings.push(Finding::of(error, self.table.source()));
    }

    /// Notes an error whose places count in a text.
    pub(crate) fn find_in(&mut self, error: &dyn Diagnose, text: &Text) {
        self.findings
            .push(Finding::within(error, self.table.source(), text));
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|letter: char| letter.is_ascii_alphabetic())
        && word
            .chars()
            .all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
}
