//! What of an item reads responses, and nothing from which a key could be computed: names, symbols, units and kinds.
//!
//! A page on which an exam is answered has to say how a response is read, and must not know whether it is right. So it
//! carries an item in which each quantity is a constant of the right form and dimension, each model has the coordinates
//! and a placeholder for its energies, and each part asks for one of these constants. There is no formula of the item in
//! it, no text, no datum, no tolerance and no mistake.

use std::fmt::Write as _;

use super::catalogue::Catalogue;
use super::{Compiled, Part, Template, Units, own};
use crate::answer::AnswerKind;
use crate::expr::{Expr, Field, Kind, Name, Shape, Type};
use crate::quantity::NodeId;
use crate::source::{Data, Entry, Problems, Value, toml};
use crate::unit::Unit;

/// The keys of a part that say how a response to it is read.
const READING: [&str; 15] = [
    "kind",
    "id",
    "unit",
    "bound",
    "form",
    "in",
    "without",
    "unknowns",
    "components",
    "constants",
    "variable",
    "ordered",
    "mode",
    "normalization",
    "shuffle",
];
/// The same where options are chosen.
const CHOOSING: [&str; 2] = ["several", "ranking"];

/// A compiled item that reads responses to these parts and knows no key, where what is asked can be parted from it.
pub(crate) fn of(item: &Template, places: &[usize]) -> Option<Compiled> {
    let tree = own::in_form(toml::read(&item.source, &Problems::default()));
    let file = table(&tree);
    let text = Stripping { item, file }.text(places)?;
    let path = format!("{}.toml", item.id);
    let catalogue = Catalogue::of_items([(path.as_str(), text.as_str())]);
    let template = catalogue.find(item.id.as_str())?;
    Some(Compiled::of(template))
}

/// An item that is stripped.
struct Stripping<'t> {
    item: &'t Template,
    /// What its file states, in the form of an item file where it is a question of a blueprint.
    file: &'t [Entry],
}

impl Stripping<'_> {
    /// The text of its file.
    fn text(&self, places: &[usize]) -> Option<String> {
        // Texts that an item must have say nothing here.
        let mut out = String::from("[item]\ntitle = \"-\"\nsource = \"-\"\n");
        let _ = writeln!(out, "digits = {}", self.item.about.digits);
        out.push_str("[statement]\ntext = \"-\"\n");
        section(&mut out, "parameters", &self.data());
        let symbols = entry(self.file, "symbols").map(table).unwrap_or_default();
        let symbols: Vec<(String, String)> = symbols
            .iter()
            .map(|own| (own.key.clone(), free_name(&own.value)))
            .collect();
        section(&mut out, "symbols", &symbols);
        let quantities = entry(self.file, "quantities")
            .map(table)
            .unwrap_or_default();
        let quantities: Option<Vec<(String, String)>> = quantities
            .iter()
            .map(|own| Some((own.key.clone(), self.quantity(own)?)))
            .collect();
        section(&mut out, "quantities", &quantities?);
        let main = entry(self.file, "model");
        if let Some(model) = main {
            section(&mut out, "model", &placeholder(model, None));
        }
        for own in entry(self.file, "models").map(table).unwrap_or_default() {
            let name = format!("models.{}", quoted(&own.key));
            section(&mut out, &name, &placeholder(&own.value, main));
        }
        let parts = items(self.file, "part");
        for place in places {
            let part = &self.item.parts[*place];
            let keys = self.part_keys(part, parts)?;
            section(&mut out, "[part]", &keys);
        }
        Some(out)
    }

    /// The data, each one of its unit.
    fn data(&self) -> Vec<(String, String)> {
        entry(self.file, "parameters")
            .map(table)
            .unwrap_or_default()
            .iter()
            .filter_map(|own| {
                let (_, parameter) = self.item.parameter(&own.key)?;
                let mut keys = vec![("value", quoted(&amount(&parameter.unit)))];
                if let Some(symbol) = text(table(&own.value), "symbol") {
                    keys.push(("symbol", quoted(symbol)));
                }
                Some((own.key.clone(), inline(&keys)))
            })
            .collect()
    }

    /// A quantity as a constant of its form and dimension, or as a function of the same names.
    fn quantity(&self, stated: &Entry) -> Option<String> {
        let node = self.item.graph.find(&Name::new(stated.key.as_str()))?;
        let own = table(&stated.value);
        let constant = self.constant(node)?;
        let mut keys = vec![("formula", quoted(&constant))];
        for key in ["unit", "symbol"] {
            if let Some(value) = entry(own, key) {
                keys.push((key, written(value)));
            }
        }
        if own.is_empty() {
            return Some(quoted(&constant));
        }
        Some(inline(&keys))
    }

    /// A constant in place of the value of a node, times what varies with the names on which it depends.
    fn constant(&self, node: NodeId) -> Option<String> {
        let kind = self.item.graph.kind(node)?;
        let units = self.item.info(node).and_then(|info| info.units.as_ref());
        let mut varying = String::new();
        // Whether a number alone is read depends on whether the key has letters.
        let letter = self.item.graph.parameters(node).first().copied();
        if let Some(letter) = letter.and_then(|letter| self.item.info(letter)) {
            let _ = write!(varying, "*{0}/{0}", letter.name);
        }
        for name in self.item.graph.variables(node) {
            let _ = write!(varying, "*cos({name}/{})", one(&self.unit_of(&name)?));
        }
        literal(kind, units, &varying)
    }

    /// The unit of a free name: the time, a symbol or a coordinate.
    fn unit_of(&self, name: &Name) -> Option<Unit> {
        if name.as_str() == "t" {
            return Unit::parse("s").ok();
        }
        let models = entry(self.file, "models").map(table).unwrap_or_default();
        let models = models.iter().map(|own| &own.value);
        let coordinates = entry(self.file, "model").into_iter().chain(models);
        let coordinates = coordinates.filter_map(|model| entry(table(model), "coordinates"));
        let mut all = entry(self.file, "symbols").into_iter().chain(coordinates);
        let found = all.find_map(|names| entry(table(names), name.as_str()))?;
        let unit = match &found.data {
            Data::Text(unit) => unit.as_str(),
            _ => text(table(found), "unit")?,
        };
        Unit::parse(unit).ok()
    }

    /// The keys of a part that say how a response is read, and a constant for what it asks.
    fn part_keys(&self, part: &Part, parts: &[Value]) -> Option<Vec<(String, String)>> {
        let stated = find(parts, part)?;
        let kind = part.answer.kind();
        let mut keys: Vec<(String, String)> = Vec::new();
        let mut put = |key: &str, value: String| keys.push((key.to_owned(), value));
        // Its words may stand beside an answer.
        let is_said = |char: &char| char.is_alphabetic() || " -'".contains(*char);
        let ask = entry(stated, "ask").and_then(|ask| match &ask.data {
            Data::Text(text) => Some(text.chars().filter(is_said).collect::<String>()),
            _ => None,
        });
        put("ask", quoted(&ask.unwrap_or_default()));
        for key in READING {
            // What a choice or work on paper does not know it does not take.
            let is_known = match kind {
                AnswerKind::Choice => matches!(key, "kind" | "shuffle"),
                AnswerKind::Work => key == "kind",
                _ => key != "shuffle",
            };
            let value = entry(stated, key).filter(|_| is_known && key != "id");
            if let Some(value) = value {
                put(key, written(value));
            }
        }
        // A blank of a group is a part of its own.
        put("id", quoted(&part.id.replace('.', "__")));
        match kind {
            AnswerKind::Choice => {
                for key in CHOOSING {
                    if let Some(value) = entry(stated, key) {
                        put(key, written(value));
                    }
                }
                let options = part.answer.options().iter().map(|option| {
                    let keys = [
                        ("id", quoted(&option.id)),
                        ("text", quoted(&option.text.plain(&Vec::new()))),
                        // All are alike, so that this says nothing.
                        ("right", "true".to_owned()),
                    ];
                    inline(&keys)
                });
                let options: Vec<String> = options.collect();
                put("options", format!("[{}]", options.join(", ")));
            }
            AnswerKind::Work => {
                put("rubric", "[{ points = 1, text = \"-\" }]".to_owned());
            }
            AnswerKind::Equation => {
                let unknown = items(stated, "unknowns");
                let unknown = unknown.first().and_then(|value| as_text(value));
                let unknown = unknown.map(str::to_owned).or_else(|| self.coordinate())?;
                put("key", quoted(&format!("{unknown} = 0")));
            }
            AnswerKind::Interval => {
                let variable = text(stated, "variable")?;
                let unit = self.unit_of_name(variable)?;
                // What goes without saying is cut from what is typed, too, where the item says it in numbers.
                let within = text(stated, "within").filter(|within| {
                    let mut words = within.split(|letter: char| !letter.is_alphanumeric());
                    words.all(|word| !self.item.graph.names().any(|name| name.as_str() == word))
                });
                if let Some(within) = within {
                    put("within", quoted(within));
                }
                // What is asked here is a letter of later answers.
                let ends = self.ends(stated);
                let key = match &ends[..] {
                    [] => format!("[{}, inf)", one(&unit)),
                    [end] => format!("[{end}, inf)"),
                    [first, second, ..] => format!("[{first}, {second}]"),
                };
                put("key", quoted(&key));
            }
            AnswerKind::Function if entry(stated, "constants").is_some() => {
                put("key", quoted(text(stated, "key")?));
            }
            _ => {
                let (key, unit) = self.key(part, stated)?;
                put("key", quoted(&key));
                let unit =
                    unit.filter(|_| kind == AnswerKind::Numeric && entry(stated, "unit").is_none());
                if let Some(unit) = unit {
                    put("unit", quoted(&unit.to_string()));
                }
                if kind == AnswerKind::Function {
                    let variable = text(stated, "variable").unwrap_or("t");
                    let unit = self.unit_of_name(variable)?;
                    put("span", format!("[\"0\", {}]", quoted(&one(&unit))));
                }
            }
        }
        Some(keys)
    }

    /// What a part asks: the name of a quantity, a list of such names, or a constant; and its unit.
    fn key(&self, part: &Part, stated: &[Entry]) -> Option<(String, Option<Unit>)> {
        let keys = part.answer.keys();
        let node = *keys.first()?;
        let unit = part.answer.unit();
        let named = text(stated, "key").map(str::trim);
        let named = named.filter(|key| self.item.graph.find(&Name::new(*key)).is_some());
        if let Some(name) = named {
            return Some((name.to_owned(), unit));
        }
        let listed = match self.item.graph.expr(node).map(Expr::kind) {
            Some(Kind::Array(entries)) => entries
                .iter()
                .map(|entry| match entry.kind() {
                    Kind::Name(name) if self.item.graph.find(name).is_some() => {
                        Some(name.to_string())
                    }
                    _ => None,
                })
                .collect::<Option<Vec<String>>>(),
            _ => None,
        };
        if let Some(names) = listed {
            return Some((format!("[{}]", names.join(", ")), unit));
        }
        if part.answer.kind() == AnswerKind::Function {
            let variable = text(stated, "variable").unwrap_or("t");
            let scale = one(&self.unit_of_name(variable)?);
            let kind = self.item.graph.kind(node)?;
            let varying = format!("*cos({variable}/{scale})");
            return Some((literal(kind, None, &varying)?, unit));
        }
        Some((self.constant(node)?, unit))
    }

    /// The quantities that the ends of an interval name.
    fn ends(&self, stated: &[Entry]) -> Vec<String> {
        let alone = text(stated, "key").into_iter();
        let all = alone.chain(items(stated, "key").iter().filter_map(as_text));
        let words = all.flat_map(|key| key.split(['[', ']', '(', ')', ',']));
        let mut names: Vec<String> = Vec::new();
        for word in words.map(str::trim) {
            let is_name = self.item.graph.find(&Name::new(word)).is_some();
            if is_name && !names.iter().any(|known| known == word) {
                names.push(word.to_owned());
            }
        }
        names
    }

    /// The unit of a name: a datum, a quantity or what is free.
    fn unit_of_name(&self, name: &str) -> Option<Unit> {
        let own = Name::new(name);
        if let Some((_, parameter)) = self.item.parameter(name) {
            return Some(parameter.unit);
        }
        let info = self
            .item
            .graph
            .find(&own)
            .and_then(|node| self.item.info(node));
        match info.and_then(|info| info.units.as_ref()) {
            Some(Units::One(unit)) => Some(*unit),
            Some(Units::Each(_)) => None,
            None => self.unit_of(&own),
        }
    }

    /// The first coordinate of its models.
    fn coordinate(&self) -> Option<String> {
        let model = entry(self.file, "model")?;
        let coordinates = entry(table(model), "coordinates")?;
        Some(table(coordinates).first()?.key.clone())
    }
}

/// A model with these coordinates, of which the energies are placeholders.
fn placeholder(model: &Value, like: Option<&Value>) -> Vec<(String, String)> {
    let own = entry(table(model), "coordinates");
    let coordinates = own.or_else(|| like.and_then(|like| entry(table(like), "coordinates")));
    let coordinates = coordinates.map(table).unwrap_or_default();
    let names: Vec<String> = coordinates
        .iter()
        .map(|own| format!("{} = {}", quoted(&own.key), free_name(&own.value)))
        .collect();
    let energy = |velocity: &str, time: &str| {
        let terms = coordinates.iter().map(|own| {
            let unit = match &own.value.data {
                Data::Text(unit) => unit.as_str(),
                _ => text(table(&own.value), "unit").unwrap_or("1"),
            };
            let unit = Unit::parse(unit).unwrap_or(Unit::ONE);
            format!("1[J]*({}{velocity}{time}/{})^2", own.key, one(&unit))
        });
        quoted(&terms.collect::<Vec<_>>().join(" + "))
    };
    vec![
        (
            "coordinates".to_owned(),
            format!("{{ {} }}", names.join(", ")),
        ),
        ("kinetic".to_owned(), energy("'", "*1[s]")),
        ("potential".to_owned(), energy("", "")),
    ]
}

/// A symbol or coordinate: its unit, and its symbol where it states one.
fn free_name(value: &Value) -> String {
    let own = table(value);
    let keys = ["unit", "symbol"].map(|key| Some((key, quoted(text(own, key)?))));
    match &value.data {
        Data::Text(unit) => quoted(unit),
        _ => inline(&keys.into_iter().flatten().collect::<Vec<_>>()),
    }
}

/// A constant of a type.
fn literal(kind: &Type, units: Option<&Units>, varying: &str) -> Option<String> {
    let unit = |place: usize| match units {
        Some(Units::One(unit)) => Some(*unit),
        Some(Units::Each(units)) => units.get(place).copied(),
        None => match kind.entry(place) {
            Some(dimension) => Unit::parse(&dimension.describe()).ok(),
            None => Some(Unit::ONE),
        },
    };
    let entry = |place: usize| {
        let one = one(&unit(place)?);
        Some(match kind.field() {
            Field::Boolean => "1 > 0".to_owned(),
            Field::Real => format!("{one}{varying}"),
            Field::Complex => format!("({one} + {one}*i){varying}"),
        })
    };
    let row = |from: usize, count: usize| {
        let entries: Option<Vec<String>> = (from..from + count).map(entry).collect();
        Some(format!("[{}]", entries?.join(", ")))
    };
    match kind.shape() {
        Shape::Scalar => entry(0),
        Shape::Vector(length) => row(0, length),
        Shape::Matrix(rows, columns) => {
            let rows: Option<Vec<String>> =
                (0..rows).map(|at| row(at * columns, columns)).collect();
            Some(format!("[{}]", rows?.join(", ")))
        }
    }
}

/// One of a unit, as formulas write it.
fn one(unit: &Unit) -> String {
    match unit.to_string().as_str() {
        "" | "1" => "1".to_owned(),
        unit => format!("1[{unit}]"),
    }
}

/// The same as data are written.
fn amount(unit: &Unit) -> String {
    match unit.to_string().as_str() {
        "" | "1" => "1".to_owned(),
        unit => format!("1 {unit}"),
    }
}

/// The table of a part in its file.
fn find<'t>(parts: &'t [Value], part: &Part) -> Option<&'t [Entry]> {
    let of = |parts: &'t [Value], id: &str| {
        let mut tables = parts.iter().map(table);
        tables.find(|own| {
            let stated = text(own, "id").or_else(|| text(own, "key"));
            stated == Some(id)
        })
    };
    match &part.group {
        None => of(parts, &part.id),
        Some(group) => {
            let own = of(parts, &group.id)?;
            of(
                items(own, "blank"),
                part.id.strip_prefix(&format!("{}.", group.id))?,
            )
        }
    }
}

fn table(value: &Value) -> &[Entry] {
    match &value.data {
        Data::Table(entries) => entries,
        _ => &[],
    }
}

fn entry<'t>(entries: &'t [Entry], key: &str) -> Option<&'t Value> {
    let found = entries.iter().find(|entry| entry.key == key)?;
    Some(&found.value)
}

fn items<'t>(entries: &'t [Entry], key: &str) -> &'t [Value] {
    match entry(entries, key).map(|value| &value.data) {
        Some(Data::List(items)) => items,
        _ => &[],
    }
}

fn text<'t>(entries: &'t [Entry], key: &str) -> Option<&'t str> {
    as_text(entry(entries, key)?)
}

fn as_text(value: &Value) -> Option<&str> {
    match &value.data {
        Data::Text(text) => Some(text),
        _ => None,
    }
}

/// A table under a header; nothing for an empty one.
fn section(out: &mut String, name: &str, keys: &[(String, String)]) {
    if keys.is_empty() {
        return;
    }
    let _ = writeln!(out, "[{name}]");
    for (key, value) in keys {
        let _ = writeln!(out, "{} = {value}", quoted(key));
    }
}

fn inline(keys: &[(&str, String)]) -> String {
    let keys: Vec<String> = keys
        .iter()
        .map(|(key, value)| format!("{key} = {value}"))
        .collect();
    format!("{{ {} }}", keys.join(", "))
}

/// A value as a file states it.
fn written(value: &Value) -> String {
    match &value.data {
        Data::Boolean(boolean) => boolean.to_string(),
        Data::Text(text) => quoted(text),
        Data::Number { number } => number.clone(),
        Data::List(items) => {
            let items: Vec<String> = items.iter().map(written).collect();
            format!("[{}]", items.join(", "))
        }
        Data::Table(entries) => {
            let keys: Vec<String> = entries
                .iter()
                .map(|entry| format!("{} = {}", quoted(&entry.key), written(&entry.value)))
                .collect();
            format!("{{ {} }}", keys.join(", "))
        }
    }
}

/// A text between quotes, its escapes those of TOML.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => {
                out.push('\\');
                out.push(letter);
            }
            letter if letter.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(letter));
            }
            letter => out.push(letter),
        }
    }
    out.push('"');
    out
}
