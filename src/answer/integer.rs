//! `integer`: an integer, such as a count.
//!
//! The student types `3`, or `3N` where *N* is a number of the question. Only the number itself is right; an integer
//! has no tolerance.
//!
//! ```toml
//! [[part]]
//! kind = "integer"
//! key  = "n_half"
//! ask  = "How many half-cycles does it make?"
//! ```

use std::sync::Arc;

use super::settle::{Candidate, Rule, settle};
use super::steps::Steps;
use super::{
    Answer, AnswerError, Answered, Asked, Band, Blank, Context, Credit, Declare, Doubt, Echo, Key,
    KeyValue, Marker, Marking, Misfit, Nature, Reading, Remark, Role, Slip, Trial, Unreadable, Why,
    numeric,
};
use crate::expr::{Expr, Form, Name, Precise, Program, Slots, Workspace};
use crate::math::Math;
use crate::quantity::{Absent, NodeId};
use crate::response::{Lexicon, Manner, Passage, Reworded, Style, Values, Wording};
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

#[derive(Debug)]
struct Integer {
    key: NodeId,
    symbols: Arc<Symbols>,
}

/// The data that are pure numbers, in which a count may be written.
#[derive(Debug)]
struct Symbols {
    lexicon: Lexicon,
    names: Vec<(Name, NodeId)>,
    /// The words of the question, and of what is counted.
    known: Wording,
    /// The letters that steps before a count may be written in.
    steps: Steps,
}

struct Whole {
    key: f64,
    symbols: Arc<Symbols>,
    /// The values of the symbols.
    values: Vec<Precise>,
    mistakes: Vec<(usize, f64, Credit)>,
    mark: DecimalMark,
    doubt: Doubt,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(
    part: &crate::source::Table<'_>,
    declare: &mut dyn Declare,
) -> Option<Box<dyn Answer>> {
    let text = part
        .required("key")
        .and_then(|key| part.as_formula("key", key))?;
    let key = declare.formula("key", &text)?;
    let kind = declare.graph().kind(key)?;
    let is_pure = kind.dimension().is_none_or(|dimension| dimension.is_pure());
    if kind.form() != Form::REAL || !is_pure {
        let found = kind.form().to_string();
        declare.find(
            &AnswerError::KeyForm {
                expected: "a pure number",
                found,
            },
            &text,
        );
        return None;
    }
    let asked = part.text("ask");
    let known = Wording::of_count(asked.as_ref().map(|ask| &*ask.value));
    let symbols = Arc::new(Symbols::of(declare, key, known));
    Some(Box::new(Integer { key, symbols }))
}

impl Symbols {
    fn of(declare: &dyn Declare, key: NodeId, known: Wording) -> Self {
        let (mut lexicon, mut names) = (Lexicon::new(), Vec::new());
        for own in declare.known() {
            let is_pure = own.kind.dimension().is_some_and(|own| own.is_pure());
            match own.role {
                Role::Parameter { node, .. } if is_pure && own.kind.form() == Form::REAL => {
                    lexicon.allow(&own.name, Arc::clone(&own.symbol), false);
                    names.push((own.name, node));
                }
                _ => lexicon.forbid(&own.name),
            }
        }
        Self {
            lexicon,
            names,
            known,
            steps: Steps::of(declare, key),
        }
    }
}

impl Answer for Integer {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Integer
    }

    fn blank(&self) -> Blank {
        Blank::of(Asked::Integer)
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        // A key that is whole but for its rounding is that integer.
        let key = context.evaluation.real(self.key)?.round();
        let numbers = context.mistakes.iter().filter_map(|mistake| {
            let number = mistake.values.first()?.as_real()?.round();
            Some((mistake.number, number, mistake.credit))
        });
        let values = self.symbols.names.iter();
        let values = values.map(|(_, node)| context.evaluation.real(*node).map(Precise::exact));
        Ok(Box::new(Whole {
            key,
            symbols: Arc::clone(&self.symbols),
            values: values.collect::<Result<_, _>>()?,
            mistakes: numbers.collect(),
            mark: context.mark,
            doubt: context.doubt,
        }))
    }
}

impl Marker for Whole {
    fn trials(&self) -> Vec<Trial> {
        let key = Decimal::shortest(self.key).map_or_else(String::new, |key| key.to_string());
        let next =
            Decimal::shortest(self.key + 1.0).map_or_else(String::new, |key| key.to_string());
        vec![
            Trial::new(Nature::Right, key.as_str()),
            Trial::new(Nature::Borderline, format!("n = {key}.0")),
            Trial::new(Nature::Wrong, next),
            Trial::new(Nature::Wrong, format!("{key}.5")),
            Trial::new(Nature::WrongUnit, format!("{key} kg")),
            Trial::new(Nature::Unreadable, "a few"),
        ]
    }

    fn key(&self) -> Key {
        let digits =
            Decimal::shortest(self.key).map_or_else(|| self.key.to_string(), |key| key.to_string());
        Key {
            math: Math::number(digits),
            accepted: None,
            value: KeyValue::Numbers {
                form: Form::REAL,
                si: vec![self.key],
            },
        }
    }

    fn bands(&self) -> Vec<Vec<Band>> {
        let band = |value, credit, mistake| Band {
            value,
            half: 0.0,
            credit,
            mistake,
        };
        let mistakes = self.mistakes.iter();
        let mistakes = mistakes.map(|(number, value, credit)| band(*value, *credit, Some(*number)));
        let right = band(self.key, Credit::FULL, None);
        vec![std::iter::once(right).chain(mistakes).collect()]
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let digits = response.in_digits(&self.symbols.known);
        let response = digits.as_ref().map_or(response, Reworded::passage);
        let read = self.readings(response);
        if !read.as_ref().is_ok_and(|read| read.0.unit.is_one())
            && let Some((reading, _)) = self.in_symbols(response)
        {
            return Ok(Echo::of_reading(reading));
        }
        let (first, others) = read?;
        let readings = [first].into_iter().chain(others);
        Echo::of(readings.map(|own| self.reading(&own))).ok_or_else(|| Why::Form.into())
    }

    fn is_mistaken_key(&self) -> bool {
        let mut others = self.mistakes.iter();
        others.any(|(_, given, credit)| *given == self.key && *credit < Credit::FULL)
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let digits = response.in_digits(&self.symbols.known);
        let response = digits.as_ref().map_or(response, Reworded::passage);
        // Elsewhere that is no answer.
        if self.key == 0.0 && response.words().is("none") {
            return self.counted(self.reading(&Quantity::pure(Decimal::ZERO)), 0.0);
        }
        let read = self.readings(response);
        // A count has no unit: what could be one is a symbol of the question.
        if !read.as_ref().is_ok_and(|read| read.0.unit.is_one())
            && let Some((reading, number)) = self.in_symbols(response)
        {
            return self.counted(reading, number);
        }
        let (first, others) = match read {
            Ok(readings) => readings,
            Err(why) => return Marking::unreadable(why),
        };
        let candidate = |quantity: Quantity| Candidate {
            shown: quantity.text(self.mark),
            marking: self.judged(&quantity),
        };
        let others = others.into_iter().map(candidate);
        settle(self.doubt, Rule::None, candidate(first), others)
    }
}

impl Whole {
    /// The count that a response is, by its conventional reading, and what else may be meant. What looks like a range is
    /// a difference where it descends, `24-6`.
    fn readings(&self, response: Passage<'_>) -> Result<(Quantity, Vec<Quantity>), Unreadable> {
        let steps = (&Unit::ONE, &self.symbols.steps);
        numeric::counts(response, self.mark, steps)
    }

    /// A response in symbols of the question, `3N` or `3N = 60`, and what it comes to.
    fn in_symbols(&self, response: Passage<'_>) -> Option<(Reading, f64)> {
        let style = Style {
            mark: self.mark,
            comma_is_decimal: true,
            is_complex: false,
        };
        let values = Values::read(response, style).ok()?;
        let sides = values.statement(&values.all()).sides;
        let mut readings = Vec::new();
        // What stands before an equals sign may be the symbol that is asked.
        let (last, before) = sides.split_last()?;
        let before = before.iter().filter(|side| !values.is_name(side));
        for side in before.chain([last]) {
            readings.push(self.formula(values.passage(side))?);
        }
        let (formula, number) = readings.first().cloned()?;
        let has_symbols = readings.iter().any(|(own, _)| !own.names().free.is_empty());
        let is_one = readings.iter().all(|(_, own)| *own == number);
        let shown = Decimal::shortest(number).filter(|_| has_symbols && is_one)?;
        let reading = Reading {
            math: Math::row([
                formula.typeset(&self.symbols.lexicon),
                Math::relation("="),
                Quantity::new(shown, Unit::ONE).math(self.mark),
            ]),
            text: formula.to_string(),
            answered: Answered::Number {
                si: number,
                unit: None,
            },
        };
        Some((reading, number))
    }

    fn formula(&self, side: Passage<'_>) -> Option<(Expr, f64)> {
        let typed = side.formula(&self.symbols.lexicon, Manner::REAL).ok()?;
        let names: Vec<&str> = self
            .symbols
            .names
            .iter()
            .map(|own| own.0.as_str())
            .collect();
        let program = Program::compile(&typed.value, &Slots(&names)).ok()?;
        let number = program.evaluate_real(&self.values[..], &mut Workspace::default());
        Some((typed.value, number.ok()?))
    }

    fn reading(&self, quantity: &Quantity) -> Reading {
        Reading {
            math: quantity.math(self.mark),
            text: quantity.to_string(),
            answered: Answered::Number {
                si: quantity.value.to_f64(),
                unit: Some(quantity.unit).filter(|unit| !unit.is_one()),
            },
        }
    }

    /// The marking of a reading.
    fn judged(&self, quantity: &Quantity) -> Marking {
        let number = quantity.value.to_f64();
        if quantity.unit.has_factor("rev") {
            return Marking::unreadable(Why::CountedUnit);
        }
        let reading = self.reading(quantity);
        if !quantity.unit.is_one() {
            return Marking::wrong(reading, Remark::from(Misfit::Count));
        }
        self.counted(reading, number)
    }

    /// The marking of a number without a unit.
    fn counted(&self, reading: Reading, number: f64) -> Marking {
        if number.fract() != 0.0 {
            return Marking::wrong(reading, Remark::from(Slip::NotInteger));
        }
        if number == self.key {
            return Marking::right(reading);
        }
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| *given == number && *given != self.key);
        match named {
            Some((number, _, credit)) => Marking::mistake(reading, *number, *credit),
            None => Marking::wrong(reading, None),
        }
    }
}
