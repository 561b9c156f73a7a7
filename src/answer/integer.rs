//! `integer`: a whole number, such as a count.
//!
//! The student types `3`. Only the number itself is right; an integer has no tolerance.
//!
//! ```toml
//! [[part]]
//! kind = "integer"
//! key  = "n_half"
//! ask  = "How many half-cycles does it make?"
//! ```

use super::settle::{Candidate, Rule, settle};
use super::{
    Answer, AnswerError, Answered, Context, Credit, Declare, Doubt, Echo, Key, KeyValue, Marker,
    Marking, Misfit, Nature, Reading, Remark, Slip, Trial, Unreadable, Why, numeric,
};
use crate::expr::Form;
use crate::math::Math;
use crate::quantity::{Absent, NodeId};
use crate::unit::{Decimal, DecimalMark, Quantity};

#[derive(Debug)]
struct Integer {
    key: NodeId,
}

struct Whole {
    key: f64,
    mistakes: Vec<(usize, f64, Credit)>,
    mark: DecimalMark,
    doubt: Doubt,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(super) fn read(
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
    Some(Box::new(Integer { key }))
}

impl Answer for Integer {
    fn kind(&self) -> crate::answer::Kind {
        crate::answer::Kind::Integer
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        // A key that is whole but for its rounding is that whole number.
        let key = context.evaluation.real(self.key)?.round();
        let numbers = context.mistakes.iter().filter_map(|mistake| {
            let number = mistake.values.first()?.as_real()?.round();
            Some((mistake.number, number, mistake.credit))
        });
        Ok(Box::new(Whole {
            key,
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

    fn echo(&self, response: &str) -> Result<Echo, Unreadable> {
        let (first, others) = numeric::readings(response, self.mark)?;
        let readings = [first].into_iter().chain(others);
        Echo::of(readings.map(|own| self.reading(&own))).ok_or_else(|| Why::Form.into())
    }

    fn mark(&self, response: &str) -> Marking {
        let (first, others) = match numeric::readings(response, self.mark) {
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
        if quantity.unit.text() == "rev" {
            return Marking::unreadable(Why::CountedUnit);
        }
        let reading = self.reading(quantity);
        if !quantity.unit.is_one() {
            return Marking::wrong(reading, Remark::from(Misfit::Count));
        }
        if !quantity.value.is_integer() {
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
