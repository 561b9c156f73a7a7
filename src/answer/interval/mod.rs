//! `interval`: the values of a quantity for which something holds, as one interval or several.
//!
//! The student types `mu < 0.35`, `0.15 <= x0 <= 0.45`, `|x| <= a`, `[a, b)`, `]a, b]`, or several of
//! these joined by `or` or `∪`; ends are numbers with units or formulas. `within` cuts key and response before they are
//! compared, so that a bound that goes without saying may be left out. Whether the ends belong to the
//! interval counts, unless `ends = "either"`.
//!
//! ```toml
//! [[part]]
//! kind     = "interval"
//! id       = "mu_range"
//! variable = "mu"
//! key      = "[mu_min, inf)"
//! within   = "[0, inf)"
//! ask      = "For which values of $\\mu$ does the block stay?"
//! ```

mod bound;
mod read;
mod set;
mod subject;

use std::cell::Cell;
use std::sync::Arc;

use self::bound::Ends;
use self::read::Refusal;
use self::set::{End, Set, SetPiece};
use super::letters::Allowed;
use super::matrix::Written;
use super::meaning::{Meaning, Prefer};
use super::settle::{Candidate, Rule, settle};
use super::trial::other_unit;
use super::{
    Answer, AnswerError, Answered, Asked, Blank, Close, Context, Credit, Declare, Doubt, Echo, Key,
    KeyValue, Marker, Marking, Nature, Reading, Remark, Role, Slip, Tolerance, Trial, Unreadable,
};
use crate::expr::{Constant, Expr, Kind as Node, Name, Precise, Type};
use crate::math::Math;
use crate::quantity::{Absent, NodeId};
use crate::response::{Lexicon, Passage, Wording};
use crate::source::{Table, Text, Value};
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

#[derive(Debug)]
struct Interval {
    key: Vec<DeclaredInterval>,
    within: Option<DeclaredInterval>,
    tolerance: Tolerance,
    /// Significant figures of the work.
    figures: u32,
    digits: u32,
    setup: Arc<Setup>,
    mistakes: Vec<(usize, Vec<DeclaredInterval>)>,
}

/// An interval as it is declared; an end without a node is no bound.
#[derive(Clone, Debug)]
struct DeclaredInterval {
    ends: [Option<NodeId>; 2],
    open: [bool; 2],
}

#[derive(Debug)]
pub(crate) struct Setup {
    variable: Name,
    symbol: Arc<Math>,
    unit: Unit,
    written: Written,
    /// Whether it counts which ends belong to the interval.
    is_strict: bool,
    meaning: Meaning,
    lexicon: Lexicon,
    /// The words of the question.
    asked: Wording,
    /// The letters of its answer line.
    letters: Vec<Expr>,
}

/// A prepared key.
struct Prepared {
    setup: Arc<Setup>,
    key: Set,
    /// Half-widths around the ends of the key, piece by piece.
    halves: Vec<[f64; 2]>,
    within: Option<SetPiece>,
    digits: u32,
    mistakes: Vec<(usize, Set, Credit)>,
    /// The inputs of formulas for these data.
    data: Vec<Precise>,
    mark: DecimalMark,
    doubt: Doubt,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let key = part.required("key").map(|key| part.as_texts("key", key));
    let variable = part.required_text("variable");
    let within = part.text("within");
    let (ends, tolerance) = (part.text("ends"), part.text("tolerance"));
    let written = Written::read(part, declare);
    let (key, variable) = (key?, variable?);
    let key = pieces(&key, declare)?;
    let within = match within {
        Some(text) => Some(pieces(&[text], declare)?.pop()?),
        None => None,
    };
    let known = declare
        .known()
        .into_iter()
        .find(|own| own.name.as_str() == variable.value);
    let Some(known) = known else {
        declare.find(&AnswerError::UnknownName(variable.value.clone()), &variable);
        return None;
    };
    let unit = match known.role {
        Role::Parameter { node, .. } | Role::Quantity { node, .. } => declare.unit_of(node),
        Role::Symbol | Role::Coordinate => known
            .kind
            .dimension()
            .and_then(|dimension| Unit::parse(&dimension.describe()).ok()),
    };
    let unit = unit.unwrap_or(Unit::ONE);
    let tolerance = match tolerance {
        Some(text) => Tolerance::read(&text, &unit, declare)?,
        None => Tolerance::default(),
    };
    let allowed = Allowed::read(part, declare, Some(&known.name), false)?;
    let letters = allowed.letters();
    let mut lexicon = allowed.lexicon;
    lexicon.allow(&known.name, Arc::clone(&known.symbol), false);
    let setup = Setup {
        variable: known.name,
        symbol: known.symbol,
        unit,
        written,
        is_strict: ends.is_none_or(|ends| ends.value != "either"),
        meaning: Meaning::of(declare, Prefer::Quantities),
        lexicon,
        asked: part
            .text("ask")
            .map(|ask| Wording::of_question(&ask.value))
            .unwrap_or_default(),
        letters,
    };
    let digits = key.iter().flat_map(|piece| piece.ends).flatten().next();
    Some(Box::new(Interval {
        figures: u32::from(declare.figures()),
        digits: u32::from(digits.map_or(3, |node| declare.digits_of(node))),
        key,
        within,
        tolerance,
        setup: Arc::new(setup),
        mistakes: Vec::new(),
    }))
}

fn pieces(texts: &[Text], declare: &mut dyn Declare) -> Option<Vec<DeclaredInterval>> {
    texts.iter().map(|text| piece(text, declare)).collect()
}

fn piece(text: &Text, declare: &mut dyn Declare) -> Option<DeclaredInterval> {
    let Ok(interval) = crate::expr::Interval::read(&text.value) else {
        declare.find(&AnswerError::Unread(text.value.clone(), "interval"), text);
        return None;
    };
    let mut end = |expr: &Expr| {
        if is_infinite(expr) {
            return Some(None);
        }
        let named = match expr.kind() {
            Node::Name(name) => declare.graph().find(name),
            _ => None,
        };
        named
            .or_else(|| declare.expr("end", expr.clone(), text))
            .map(Some)
    };
    let ends = [end(&interval.from)?, end(&interval.to)?];
    Some(DeclaredInterval {
        ends,
        open: interval.open,
    })
}

/// Whether it is `inf`, with any sign.
fn is_infinite(expr: &Expr) -> bool {
    match expr.kind() {
        Node::Constant(Constant::Infinity) => true,
        Node::Negate(inner) => is_infinite(inner),
        _ => false,
    }
}

impl DeclaredInterval {
    fn value(&self, context: &Context<'_>) -> Result<SetPiece, Absent> {
        let end = |place: usize| -> Result<End, Absent> {
            let Some(node) = self.ends[place] else {
                return Ok(End::none(place));
            };
            Ok(End {
                value: context.evaluation.real(node)?,
                is_open: self.open[place],
            })
        };
        Ok(SetPiece([end(0)?, end(1)?]))
    }
}

impl Answer for Interval {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Interval
    }

    fn blank(&self) -> Blank {
        let Setup {
            written,
            letters,
            lexicon,
            unit,
            ..
        } = &*self.setup;
        let blank = Blank::of(Asked::Interval(written.entries()));
        written.describe(blank, (letters, lexicon), (Some(*unit), self.digits))
    }

    fn ranging(&self) -> Option<&Math> {
        Some(&self.setup.symbol)
    }

    fn keys(&self) -> Vec<NodeId> {
        self.key
            .iter()
            .flat_map(|piece| piece.ends)
            .flatten()
            .collect()
    }

    fn unit(&self) -> Option<Unit> {
        Some(self.setup.unit).filter(|unit| !unit.is_one())
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn read_mistake(
        &mut self,
        number: usize,
        answer: &Value,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        let declared = pieces(&part.as_texts("answer", answer), declare)?;
        self.mistakes.push((number, declared));
        Some(Vec::new())
    }

    fn figures(&self) -> u32 {
        self.figures
    }

    fn states_tolerance(&self) -> bool {
        !self.tolerance.is_derived()
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let evaluation = &*context.evaluation;
        let within = self
            .within
            .as_ref()
            .map(|within| within.value(context))
            .transpose()?;
        let set = |pieces: &[DeclaredInterval]| -> Result<Set, Absent> {
            let pieces = pieces.iter().map(|piece| piece.value(context));
            Ok(Set::of(pieces.collect::<Result<_, _>>()?).cut(within.as_ref()))
        };
        let key = set(&self.key)?;
        // An end that comes from the key has the tolerance of its formula; one that comes from elsewhere is exact.
        let half = |value: f64| {
            let node = self
                .keys()
                .into_iter()
                .find(|node| evaluation.real(*node) == Ok(value));
            node.map_or(0.0, |node| {
                let spread = || evaluation.spread(node).first().copied().unwrap_or(0.0);
                self.tolerance
                    .half_width(value, spread, self.figures, evaluation)
            })
        };
        let halves = key
            .0
            .iter()
            .map(|piece| [half(piece.0[0].value), half(piece.0[1].value)])
            .collect();
        let mut mistakes = Vec::new();
        for mistaken in &context.mistakes {
            let own = self
                .mistakes
                .iter()
                .find(|(number, _)| *number == mistaken.number);
            if let Some(Ok(given)) = own.map(|(_, pieces)| set(pieces)) {
                mistakes.push((mistaken.number, given, mistaken.credit));
            }
        }
        Ok(Box::new(Prepared {
            setup: Arc::clone(&self.setup),
            key,
            halves,
            within,
            digits: self.digits,
            mistakes,
            data: self.setup.meaning.data(evaluation),
            mark: context.mark,
            doubt: context.doubt,
        }))
    }
}

impl Prepared {
    fn accepts(key: &Set, halves: &[[f64; 2]], typed: &Set) -> bool {
        key.0.len() == typed.0.len()
            && key
                .0
                .iter()
                .zip(&typed.0)
                .zip(halves)
                .all(|((key, typed), halves)| {
                    (0..2).all(|place| key.0[place].is_near(&typed.0[place], halves[place]))
                })
    }

    /// Whether the ends are as open as those of the key.
    fn has_right_ends(&self, typed: &Set) -> bool {
        !self.setup.is_strict || self.key.has_ends_of(typed)
    }

    fn named(&self, typed: &Set) -> Option<&(usize, Set, Credit)> {
        self.mistakes.iter().find(|(_, given, _)| {
            let halves: Vec<[f64; 2]> = given
                .0
                .iter()
                .map(|piece| [0, 1].map(|place| 0.01 * piece.0[place].size()))
                .collect();
            let is_open_alike = given.has_ends_of(typed) || !self.setup.is_strict;
            Self::accepts(given, &halves, typed) && (is_open_alike || !self.is_key(given))
        })
    }

    /// Whether a set differs from the key by its ends at most.
    fn is_key(&self, given: &Set) -> bool {
        Self::accepts(&self.key, &self.halves, given)
    }

    /// A set as it was typed or might be, with figures beyond those that are asked.
    fn typeset(&self, set: &Set) -> (Math, String) {
        // Two more tell ends apart that lie just inside of a tolerance and just outside.
        self.rounded(set, self.digits + 2)
    }

    /// A set with so many significant figures, as inequalities or intervals.
    fn rounded(&self, set: &Set, digits: u32) -> (Math, String) {
        let unit = self.setup.unit;
        let number = |end: &End| {
            let value = unit.of_si(end.value);
            match Decimal::rounded(value, digits) {
                Some(_) if value == 0.0 => Quantity::new(Decimal::ZERO, Unit::ONE),
                Some(decimal) => {
                    let shortest = Decimal::shortest(decimal.to_f64()).unwrap_or(decimal);
                    Quantity::new(shortest, unit)
                }
                None => Quantity::new(Decimal::ZERO, Unit::ONE),
            }
        };
        set.typeset(
            &self.setup.symbol,
            self.setup.variable.as_str(),
            self.mark,
            &number,
        )
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let name = &self.setup.variable;
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "somewhere between"),
            Trial::new(
                Nature::WrongUnit,
                format!("{name} > 3 {}", other_unit(&self.setup.unit)),
            ),
        ];
        if self.key.0.is_empty() || self.setup.written == Written::Formula {
            return trials;
        }
        let text = self.typeset(&self.key).1;
        // What has no bound at all has no inequality.
        if text.contains("any") {
            return trials;
        }
        trials.push(Trial::new(Nature::Right, text));
        let ends = self.key.0.iter().zip(&self.halves).enumerate();
        let end = ends.flat_map(|(at, (piece, halves))| {
            [0, 1].map(|place| (at, place, piece.0[place].value, halves[place]))
        });
        // An end that is not cut off by the bounds of the question.
        let bounds = self.within.iter().flat_map(|within| &within.0);
        let mut ends = end.filter(|(_, _, value, half)| {
            let is_free = bounds.clone().all(|end| end.value != *value);
            value.is_finite() && *half > 0.0 && is_free
        });
        if let Some((at, place, value, half)) = ends.next() {
            let moved = |share: f64| {
                let mut set = self.key.clone();
                set.0[at].0[place].value = value + share * half;
                self.typeset(&set).1
            };
            trials.push(Trial::new(Nature::Borderline, moved(0.9)));
            trials.push(Trial::new(Nature::Borderline, moved(-0.9)));
            trials.push(Trial::new(Nature::Wrong, moved(1.3)));
        }
        trials
    }

    fn key(&self) -> Key {
        let (math, text) = self.rounded(&self.key, self.digits);
        Key {
            math,
            accepted: None,
            value: KeyValue::Intervals {
                pieces: self.key.bounds(),
                text,
            },
        }
    }

    fn typed_mistake(&self, number: usize) -> Option<String> {
        let own = self.mistakes.iter().find(|(own, ..)| *own == number);
        let is_number = self.setup.written != Written::Formula;
        let text = own.map(|(_, set, _)| self.typeset(set).1);
        text.filter(|_| is_number)
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let candidate = |marking: Marking| {
            let read = marking.reading.as_ref();
            let shown = read.map_or_else(String::new, |reading| reading.math.plain());
            Candidate { shown, marking }
        };
        let first = self.judged(response, Ways::default());
        if first.marking.reading.is_none() {
            return first.marking;
        }
        // By convention words keep the ends.
        let rule = if first.is_doubtful {
            Rule::None
        } else {
            Rule::Stated
        };
        let ways = first.others();
        let first = candidate(first.marking);
        let others = ways.map(|ways| candidate(self.judged(response, ways).marking));
        let others = others.filter(|other| other.shown != first.shown);
        let others: Vec<Candidate> = others.collect();
        settle(self.doubt, rule, first, others)
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let first = self.judged(response, Ways::default());
        let others = first
            .others()
            .filter_map(|ways| self.judged(response, ways).marking.reading);
        let readings: Vec<Reading> = first
            .marking
            .reading
            .clone()
            .into_iter()
            .chain(others)
            .collect();
        match Echo::of(readings) {
            Some(echo) => Ok(echo),
            None => Echo::of_marking(first.marking),
        }
    }
}

/// How what is left open is taken.
#[derive(Clone, Copy, Debug, Default)]
struct Ways {
    /// Whether numbers that may be meant otherwise are.
    is_otherwise: bool,
    /// Which ends are left out where words do not say.
    open: [bool; 2],
}

/// The marking of one reading of a response, and what else it may mean.
struct Judged {
    marking: Marking,
    is_doubtful: bool,
    is_unsaid: bool,
}

impl Judged {
    /// The other ways to take it.
    fn others(&self) -> impl Iterator<Item = Ways> + use<> {
        let numbers = Ways {
            is_otherwise: true,
            ..Ways::default()
        };
        let ends = [[true, true], [true, false], [false, true]];
        let ends = ends.map(|open| Ways {
            open,
            ..Ways::default()
        });
        let ends = ends.into_iter().take(if self.is_unsaid { 3 } else { 0 });
        Some(numbers)
            .filter(|_| self.is_doubtful)
            .into_iter()
            .chain(ends)
    }
}

impl Prepared {
    /// The marking of one reading of a response.
    fn judged(&self, response: Passage<'_>, ways: Ways) -> Judged {
        let ends = Ends {
            setup: &self.setup,
            data: &self.data,
            mark: self.mark,
            is_otherwise: ways.is_otherwise,
            open: ways.open,
            is_doubtful: Cell::new(false),
            is_unsaid: Cell::new(false),
        };
        let read = read::read(&ends, response);
        Judged {
            marking: self.marked(response, read),
            is_doubtful: ends.is_doubtful.get(),
            is_unsaid: ends.is_unsaid.get(),
        }
    }

    fn marked(&self, response: Passage<'_>, read: Result<Set, Refusal>) -> Marking {
        let typed = match read {
            Ok(set) => set.cut(self.within.as_ref()),
            Err(Refusal::Unread(why)) => return Marking::unreadable(*why),
            Err(Refusal::Misfit(misfit)) => {
                let reading = Reading {
                    math: Math::text(response.to_string()),
                    text: response.into(),
                    answered: Answered::Set(Vec::new()),
                };
                return Marking::wrong(reading, Remark::from(*misfit));
            }
        };
        let (math, text) = self.typeset(&typed);
        let reading = Reading {
            math,
            text,
            answered: Answered::Set(typed.bounds()),
        };
        let fits = self.is_key(&typed);
        if fits && self.has_right_ends(&typed) {
            return Marking::right(reading);
        }
        if let Some((number, _, credit)) = self.named(&typed) {
            return Marking::mistake(reading, *number, *credit);
        }
        let slip = if fits {
            Some(Slip::Near(Close::Ends))
        } else if typed.0.len() != self.key.0.len() {
            Some(Slip::CountOfIntervals)
        } else {
            None
        };
        Marking::wrong(reading, slip.map(Remark::from))
    }
}

/// The type of what is compared.
fn compared(setup: &Setup) -> Type {
    Type::real(setup.unit.dimension())
}
