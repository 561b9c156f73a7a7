//! A template: an item as it was read, from which instances are drawn.

use std::sync::{Arc, OnceLock};

use super::plot::Plot;
use super::{About, ItemId, Parameter, Passage, Revision};
#[cfg(feature = "render")]
use super::{Compiled, CorrectionError, corrected, load::read_text, stripped};
use crate::answer::{Answer, Blank, Drawn, Naming};
#[cfg(feature = "render")]
use crate::diagnostic::Finding;
use crate::document::Document;
use crate::expr::{Expr, Kind as Node, Name, Precise};
use crate::figure::Figure;
use crate::math::Math;
use crate::numerics::{Rational, SortedMap};
use crate::quantity::{Datum, Graph, Method, NodeId};
use crate::source::Source;
#[cfg(feature = "render")]
use crate::source::Value;
use crate::unit::{Quantity, Unit};

/// An item as it was read: what can be drawn, asked, answered and shown.
#[derive(Debug)]
pub struct Template {
    /// Its identity.
    pub id: ItemId,
    /// The text it was read from.
    pub revision: Revision,
    /// What it says of itself.
    pub about: About,
    /// Its file.
    pub source: Source,
    /// Its data.
    pub parameters: Vec<Parameter>,
    /// What a draw has to keep to.
    pub constraints: Vec<Constraint>,
    /// Everything in it that has a value.
    pub graph: Graph,
    /// What is known of named nodes beyond their value.
    pub quantities: SortedMap<NodeId, QuantityInfo>,
    /// Symbols of coordinates and other free names, where the item states them.
    pub symbols: SortedMap<Name, Arc<Math>>,
    /// Plots, by name.
    pub plots: Vec<Plot>,
    /// What is given.
    pub statement: Passage,
    /// What comes before the solutions of the parts.
    pub solution: Passage,
    /// For the teacher.
    pub notes: Passage,
    /// Its schematic.
    pub figure: Option<Figure>,
    /// What is written under the schematic.
    pub caption: Document,
    /// What is asked.
    pub parts: Vec<Part>,
    /// Known results.
    pub checks: Vec<Check>,
    /// Findings of `check` that are in order here.
    pub allowed: Vec<Allowed>,
    /// The standard wrong methods of each part, once they were asked for.
    pub(crate) methods: OnceLock<Vec<Vec<Method>>>,
    /// The points at which formulas are compared, as far as they were drawn.
    pub(crate) drawn: Drawn,
}

/// A finding of `check` that is in order in an item, with the reason.
#[derive(Clone, Debug)]
pub struct Allowed {
    /// The name of the rule.
    pub rule: crate::source::Text,
    /// The part to which it is confined.
    pub part: Option<String>,
    /// Why it is in order.
    pub reason: String,
}

/// A condition that every draw keeps.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Its name, for messages.
    pub name: String,
    /// The condition.
    pub node: NodeId,
}

/// What is known of a parameter or quantity beyond its value.
#[derive(Clone, Debug)]
pub struct QuantityInfo {
    /// Its name in formulas.
    pub name: Name,
    /// What it is, in words.
    pub title: Option<Arc<str>>,
    /// How the quantity is printed.
    pub symbol: Arc<Math>,
    /// Its units; an abbreviation has none.
    pub units: Option<Units>,
    /// Significant figures in which it is printed.
    pub digits: u8,
    /// The independent second route.
    pub verify: Option<NodeId>,
    /// The place of a parameter in the list of data.
    pub parameter: Option<usize>,
}

/// The unit of all entries of a quantity, or one for each, by rows.
#[derive(Clone, Debug, PartialEq)]
pub enum Units {
    /// The same for all.
    One(Unit),
    /// One for each entry.
    Each(Vec<Unit>),
}

/// One thing that is asked.
#[derive(Debug)]
pub struct Part {
    /// Its identity in the item; of a blank, `group.blank`.
    pub id: String,
    /// The identities that it had in earlier versions of the item.
    pub was: Vec<String>,
    /// The group of small questions to which it belongs.
    pub group: Option<Arc<Group>>,
    /// The question.
    pub ask: Passage,
    /// The kind of answer with its key, tolerance and mistakes.
    pub answer: Box<dyn Answer>,
    /// What its answer line says, once it was asked for: the same for all data.
    pub(crate) blank: OnceLock<Blank>,
    /// What may stand before an equals sign of a response.
    pub(crate) naming: Naming,
    /// Its weight; the weights of the blanks of a group add up to that of the group.
    pub points: Rational,
    /// It is asked only if this holds.
    pub when: Option<NodeId>,
    /// From a nudge to the way; those of its group come first.
    pub hints: Vec<Passage>,
    /// The worked solution.
    pub solution: Passage,
    /// Room for work on paper, where the item speaks of it.
    #[cfg(feature = "render")]
    pub space: Option<super::Space>,
    /// Known wrong, or also acceptable, answers.
    pub mistakes: Vec<Mistake>,
}

/// Small questions that are asked together and count as one.
#[derive(Debug)]
pub struct Group {
    /// Its identity in the item.
    pub id: String,
    /// What its blanks have in common.
    pub text: Passage,
    /// Hints for all of them.
    pub hints: Vec<Passage>,
    /// What comes before their worked solutions.
    pub solution: Passage,
}

impl Part {
    /// What its answer line says.
    pub fn blank(&self) -> &Blank {
        self.blank.get_or_init(|| self.answer.blank())
    }

    /// Whether this names it: its identity, that of its group, or one that it had.
    pub fn is_named(&self, name: &str) -> bool {
        self.has_id(name) || self.is_in(name)
    }

    /// Whether this is its identity, or one that it had.
    pub fn has_id(&self, id: &str) -> bool {
        self.id == id || self.was.iter().any(|was| was == id)
    }

    /// Whether it belongs to the group of this identity.
    pub(crate) fn is_in(&self, group: &str) -> bool {
        self.group.as_ref().is_some_and(|own| own.id == group)
    }

    /// The hints that are its own, and not its group's.
    pub fn own_hints(&self) -> &[Passage] {
        let shared = self.group.as_ref().map_or(0, |group| group.hints.len());
        self.hints.get(shared..).unwrap_or_default()
    }

    /// Its worked solution, after that of its group.
    pub fn worked(&self) -> impl Iterator<Item = &Passage> {
        let shared = self.group.iter().map(|group| &group.solution);
        let all = shared.chain(std::iter::once(&self.solution));
        all.filter(|passage| !passage.is_empty())
    }
}

/// A known wrong, or also acceptable, answer.
#[derive(Debug)]
pub struct Mistake {
    /// What it gives.
    pub answer: MistakeAnswer,
    /// What is said about it.
    pub feedback: Passage,
    /// Its share of the points.
    pub credit: crate::answer::Credit,
    /// The unit in which it is given, where it has another dimension than the part.
    pub unit: Option<Unit>,
    /// The data for which it is a mistake.
    pub when: Option<NodeId>,
}

/// What a mistake gives.
#[derive(Debug)]
pub enum MistakeAnswer {
    /// These formulas.
    Formulas(Vec<NodeId>),
    /// The key with these quantities replaced.
    Replaced(Vec<(NodeId, NodeId)>),
}

/// A known result of an item.
#[derive(Clone, Debug)]
pub struct Check {
    /// Where it comes from.
    pub source: String,
    /// Data that are not at their value.
    pub given: Vec<(usize, Quantity)>,
    /// Times, for functions.
    pub at: Vec<Precise>,
    /// What has to come out, by quantity or part.
    pub expect: Vec<Expected>,
}

/// One expected result.
#[derive(Clone, Debug)]
pub struct Expected {
    /// The quantity or part.
    pub id: crate::source::Text,
    /// A response that has to be right.
    pub response: crate::source::Text,
}

impl Template {
    /// The part of this identity, or the one that had it once.
    pub fn part(&self, id: &str) -> Option<&Part> {
        self.parts.get(self.place(id)?)
    }

    /// The place of the part of this identity, or of the one that had it once.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::bank::{Catalogue, embedded};
    /// let (catalogue, _) = Catalogue::open(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// assert_eq!(item.place(&item.parts[1].id), Some(1));
    /// # }
    /// ```
    pub fn place(&self, id: &str) -> Option<usize> {
        self.parts.iter().position(|part| part.has_id(id))
    }

    /// What a list of parts may name: parts, and groups of blanks.
    #[cfg(feature = "render")]
    pub(crate) fn part_names(&self) -> impl Iterator<Item = &str> {
        let groups = self.parts.iter().filter_map(|part| part.group.as_deref());
        let parts = self.parts.iter().map(|part| part.id.as_str());
        parts.chain(groups.map(|group| group.id.as_str()))
    }

    /// How many questions it asks, where a group counts as one.
    pub fn questions(&self) -> usize {
        let is_later = |pair: &&[Part]| match (&pair[0].group, &pair[1].group) {
            (Some(before), Some(own)) => Arc::ptr_eq(before, own),
            _ => false,
        };
        self.parts.len() - self.parts.windows(2).filter(is_later).count()
    }

    /// All texts that placeholders stand in, in the order in which they are shown.
    pub fn passages(&self) -> impl Iterator<Item = &Passage> {
        let parts = self.parts.iter().flat_map(|part| {
            let feedback = part.mistakes.iter().map(|mistake| &mistake.feedback);
            let shared = part.group.iter().flat_map(|own| [&own.text, &own.solution]);
            let texts = shared.chain([&part.ask]).chain(&part.hints);
            texts.chain(std::iter::once(&part.solution)).chain(feedback)
        });
        [&self.statement, &self.solution, &self.notes]
            .into_iter()
            .chain(parts)
    }

    /// The parameter of this name and its place.
    pub fn parameter(&self, name: &str) -> Option<(usize, &Parameter)> {
        self.parameters
            .iter()
            .enumerate()
            .find(|(_, parameter)| parameter.name.as_str() == name)
    }

    /// The standard wrong methods of a part: those to its key on the way from what other parts ask for.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::bank::{Catalogue, embedded};
    /// let (catalogue, _) = Catalogue::load(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// assert!(!item.methods(0).is_empty());
    /// # }
    /// ```
    pub fn methods(&self, place: usize) -> &[Method] {
        let all = self.methods.get_or_init(|| {
            let places = 0..self.parts.len();
            places.map(|place| self.methods_of(place)).collect()
        });
        all.get(place).map_or(&[], Vec::as_slice)
    }

    fn methods_of(&self, place: usize) -> Vec<Method> {
        let keys = self.parts[place].answer.keys();
        let [key] = keys[..] else {
            return Vec::new();
        };
        let others = self.parts.iter().enumerate();
        let others = others.filter(|(other, _)| *other != place);
        let asked = others.flat_map(|(_, part)| part.answer.keys());
        let asked: Vec<NodeId> = asked.flat_map(|key| self.listed(key)).collect();
        let is_hidden = |node| self.info(node).is_none_or(|info| info.units.is_none());
        Method::all(&self.graph, key, &asked, is_hidden, |node| self.datum(node))
    }

    /// A key, and the quantities that it lists.
    fn listed(&self, key: NodeId) -> Vec<NodeId> {
        let entries = match self.graph.expr(key).map(Expr::kind) {
            Some(Node::Array(entries)) => &entries[..],
            _ => &[],
        };
        let named = entries.iter().filter_map(|entry| match entry.kind() {
            Node::Name(name) => self.graph.find(name),
            _ => None,
        });
        std::iter::once(key).chain(named).collect()
    }

    /// What is known of a datum as far as it can be mistaken.
    fn datum(&self, node: NodeId) -> Datum {
        let info = self.info(node);
        let place = info.and_then(|info| info.parameter);
        let Some(parameter) = place.and_then(|place| self.parameters.get(place)) else {
            return Datum::default();
        };
        let unit = parameter.unit;
        let title = info.and_then(|info| info.title.as_deref()).unwrap_or("");
        let title = title.to_ascii_lowercase();
        let gravity = Unit::parse("m/s^2").is_ok_and(|own| own.dimension() == unit.dimension());
        let is_length = Unit::parse("m").is_ok_and(|own| own.dimension() == unit.dimension());
        Datum {
            scale: unit.to_si(1.0),
            is_angle: matches!(unit.text().as_str(), "°" | "deg" | "rad"),
            is_gravity: gravity && parameter.name.as_str() == "g",
            is_radius: is_length && title.contains("radius"),
            is_diameter: is_length && title.contains("diameter"),
        }
    }

    /// What is known of a named node.
    pub fn info(&self, node: NodeId) -> Option<&QuantityInfo> {
        self.quantities.get(&node)
    }

    /// Everything that can be answered: quantities with a unit, and parts, each once, in the order of the item.
    pub(crate) fn answer_ids(&self) -> Vec<&str> {
        let named = self.quantities.values().filter(|info| {
            info.units.is_some()
                && info.parameter.is_none()
                && self.graph.find(&info.name).is_some()
        });
        let mut ids: Vec<&str> = named.map(|info| info.name.as_str()).collect();
        for part in &self.parts {
            if !ids.contains(&part.id.as_str()) {
                ids.push(&part.id);
            }
        }
        ids
    }

    /// How many instances the grids of the parameters allow; saturates.
    pub fn instances(&self) -> u64 {
        self.parameters
            .iter()
            .filter_map(|parameter| parameter.grid.map(|grid| grid.count()))
            .fold(1, u64::saturating_mul)
    }

    /// The expected working time in minutes.
    pub fn minutes(&self) -> u32 {
        self.about
            .minutes
            .unwrap_or_else(|| self.parts.iter().map(|part| part.answer.minutes()).sum())
    }
}

/// What needs the text of the item.
#[cfg(feature = "render")]
impl Template {
    /// Reads the text of one `[[question]]` of a blueprint: its item, or what is wrong with it, in places of that text.
    ///
    /// ```
    /// use vibank::bank::{ItemId, Template};
    /// use vibank::source::Source;
    /// let text = "[[question]]\ntitle = 'A swing'\nstatement = 'A swing takes 2.5 s for a full cycle.'\n\
    ///             [[question.part]]\nask = 'Find its frequency.'\nkey = '0.4 Hz'\n";
    /// let id = ItemId::of_path("own/swing.toml").unwrap();
    /// let (item, findings) = Template::of_question(id, &Source::new("exam.toml", text));
    /// assert!(findings.is_empty());
    /// assert_eq!(item.unwrap().parts[0].id, "part_1");
    /// ```
    pub fn of_question(id: ItemId, source: &Source) -> (Option<Self>, Vec<Finding>) {
        let revision = Revision::of(&source.text);
        read_text(id, revision, source, None)
    }

    /// The same item with another key of a part, as its file would state it; of a choice, the options that are right.
    ///
    /// It bears the revision of the item that it corrects, since its data are drawn alike.
    ///
    /// # Errors
    ///
    /// [`CorrectionError`].
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::bank::Catalogue;
    /// use vibank::source::{Data, Span, Value};
    /// use vibank::{answer::Verdict, grade, instance::Instance, solution::Solution};
    ///
    /// let (catalogue, _) = Catalogue::load([
    ///     ("bank.toml", "format = 1\ntitle = 'T'"),
    ///     ("c/_chapter.toml", "title = 'C'"),
    ///     ("c/a.toml", "[item]\ntitle = 'A'\nsource = 'by hand'\n[parameters]\nf = '2 Hz'\n[quantities]\nomega = { formula = 'f', unit = 'rad/s' }\n[statement]\ntext = 'A wheel turns with << f >>.'\n[[part]]\nkey = 'omega'\nask = 'How fast is it?'\n"),
    /// ]);
    /// let key = Value { data: Data::Text("2*pi*f".into()), span: Span::NONE };
    /// let corrected = catalogue.find("c/a").unwrap().with_key("omega", &key).unwrap();
    /// let solution = Solution::of(Instance::of_source(&corrected));
    /// let place = corrected.place("omega").unwrap();
    /// assert_eq!(grade::mark(&solution, place, "12.6 rad/s").verdict, Verdict::Right);
    /// ```
    pub fn with_key(&self, part: &str, key: &Value) -> Result<Self, CorrectionError> {
        self.with_keys(&[(part, key)])
    }

    /// The same with the keys of several parts, each named once.
    ///
    /// # Errors
    ///
    /// [`CorrectionError`].
    pub fn with_keys(&self, keys: &[(&str, &Value)]) -> Result<Self, CorrectionError> {
        corrected::with_keys(self, keys)
    }

    /// A compiled item that reads responses to these parts, given by their places, and knows no key.
    ///
    /// Nothing where what is asked cannot be parted from its key.
    ///
    /// ```
    /// use vibank::bank::{Catalogue, embedded};
    /// let (catalogue, _) = Catalogue::open(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// let stripped = item.stripped(&[0, 1]).unwrap();
    /// let json = serde_json::to_string(&stripped).unwrap();
    /// assert!(json.contains("T_p"));
    /// ```
    pub fn stripped(&self, places: &[usize]) -> Option<Compiled> {
        stripped::of(self, places)
    }
}
