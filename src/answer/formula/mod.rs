//! `formula`: a formula in the symbols of the item.
//!
//! The student types `sqrt(3k/(2m))`, `√(3k/2m)` or `(3*k/2/m)^0.5`: any form of the same function of the
//! data is right. Products need no sign, Greek letters come as words or signs, simple LaTeX is read.
//! `in` lists the names that the answer may use: by default all parameters, symbols and coordinates, and
//! the quantities of earlier parts. A formula of another dimension is told so.
//!
//! ```toml
//! [[part]]
//! kind     = "formula"
//! key      = "omega_d"
//! in       = ["m", "c", "k"]
//! ask      = "Find the angular frequency of the damped motion."
//! mistakes = [{ answer = "sqrt(k/m)", feedback = "That is the motion without damping." }]
//! ```

use std::collections::BTreeMap;
use std::sync::Arc;

use super::equality::{Comparable, Comparison, Points};
use super::meaning::{Meaning, Prefer, lexicon};
use super::typed::{self, Lexicon, Manner, Trouble, Typed};
use super::{
    Answer, AnswerError, AnswerKind, Context, Credit, Declare, Feedback, Key, KeyValue, Marker,
    Marking, Reading, Reason, symbolic,
};
use crate::expr::{CheckError, Expr, Field, Joint, Name, Shape, Type};
use crate::quantity::{Absent, NodeId};
use crate::source::{Table, Value};
use crate::unit::{DecimalMark, Dimension, Unit};

/// The kind.
pub(super) struct Kind;

#[derive(Debug)]
struct Formula {
    key: NodeId,
    setup: Arc<Setup>,
    mistakes: Vec<(usize, NodeId)>,
}

/// What holds whatever the data are.
#[derive(Debug)]
struct Setup {
    /// In the names that an answer may use.
    shown: Expr,
    expr: Expr,
    kind: Type,
    unit: Option<Unit>,
    meaning: Meaning,
    lexicon: Lexicon,
}

/// A prepared key.
struct Prepared {
    setup: Arc<Setup>,
    key: Comparable,
    points: Points,
    mistakes: Vec<Mistake>,
    mark: DecimalMark,
}

struct Mistake {
    number: usize,
    formula: Comparable,
    credit: Credit,
}

impl AnswerKind for Kind {
    fn name(&self) -> &'static str {
        "formula"
    }

    fn minutes(&self) -> u32 {
        4
    }

    fn read(&self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        let text = part
            .required("key")
            .and_then(|key| part.as_formula("key", key));
        let listed = part.texts("in");
        let text = text?;
        let key = declare.formula("key", &text)?;
        let kind = declare.graph().kind(key)?.clone();
        if kind.shape() != Shape::Scalar || kind.field() == Field::Boolean {
            let found = kind.form().to_string();
            declare.find(
                &AnswerError::KeyForm {
                    expected: "a number",
                    found,
                },
                &text,
            );
            return None;
        }
        let known = declare.known();
        let mut is_sound = true;
        for name in &listed {
            if !known.iter().any(|own| own.name.as_str() == name.value) && name.value != "t" {
                declare.find(&AnswerError::UnknownName(name.value.clone()), name);
                is_sound = false;
            }
        }
        let own = Name::new(text.value.as_str());
        let named = declare
            .graph()
            .find(&own)
            .filter(|node| *node == key)
            .map(|_| own);
        let (mut lexicon, mut names) = lexicon(declare, &listed, named.as_ref());
        let uses_time = declare.graph().depends(key, &Name::new("t"));
        if uses_time || listed.iter().any(|name| name.value == "t") {
            let time = Name::new("t");
            lexicon.allow(&time, &crate::math::symbol("t"), false);
            names.push(time);
        }
        let meaning = Meaning::of(declare, Prefer::Quantities);
        let expr = symbolic::formula(declare.graph(), key);
        let shown = meaning.expanded(&expr, &names);
        let unit = declare.unit_of(key);
        is_sound.then(|| {
            let setup = Setup {
                shown,
                expr,
                kind,
                unit,
                meaning,
                lexicon,
            };
            Box::new(Formula {
                key,
                setup: Arc::new(setup),
                mistakes: Vec::new(),
            }) as Box<dyn Answer>
        })
    }
}

impl Answer for Formula {
    fn kind(&self) -> &'static dyn AnswerKind {
        &Kind
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
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
        let text = part.as_formula("answer", answer)?;
        let node = declare.formula("mistake", &text)?;
        self.mistakes.push((number, node));
        Some(Vec::new())
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        let (setup, graph) = (&self.setup, context.evaluation.graph());
        context.evaluation.exists_for(self.key)?;
        let none = BTreeMap::new();
        let compile = |expr: &Expr, replaced: &BTreeMap<Name, Expr>| {
            Comparable::of(&setup.meaning, expr, replaced).map_err(|_| Absent::Function {
                label: "key".into(),
                of: Vec::new(),
            })
        };
        let key = compile(&setup.expr, &none)?;
        let points = Points::around(&setup.meaning, context.evaluation, &[&key]);
        let mut mistakes = Vec::new();
        for mistaken in &context.mistakes {
            let own = self
                .mistakes
                .iter()
                .find(|(number, _)| *number == mistaken.number);
            let formula = match own {
                Some((_, node)) => compile(&symbolic::formula(graph, *node), &none),
                None => compile(&setup.expr, &symbolic::replaced(graph, mistaken)),
            };
            if let Ok(formula) = formula {
                mistakes.push(Mistake {
                    number: mistaken.number,
                    formula,
                    credit: mistaken.credit,
                });
            }
        }
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            key,
            points,
            mistakes,
            mark: context.mark,
        }))
    }
}

impl Prepared {
    fn manner(&self, response: &str) -> Manner {
        let has_lists = ["atan2", "hypot", "min", "max", "mod", "clamp"];
        Manner {
            comma_is_decimal: !has_lists.iter().any(|name| response.contains(name)),
            has_imaginary_unit: self.setup.kind.field() == Field::Complex,
        }
    }

    /// The reading whose dimension fits, if one does; and what is wrong with the dimension of the first otherwise.
    fn fitting(&self, typed: Typed<Expr>) -> (Expr, Option<String>) {
        let trouble = self.dimension_trouble(&typed.value);
        match (trouble, typed.other) {
            (Some(_), Some(other)) if self.dimension_trouble(&other).is_none() => (other, None),
            (trouble, _) => (typed.value, trouble),
        }
    }

    fn dimension_trouble(&self, typed: &Expr) -> Option<String> {
        let setup = &self.setup;
        let found = match typed.check(&setup.meaning) {
            Err(errors) => return Some(explained(errors.first())),
            Ok(found) => found,
        };
        let fits = match (setup.kind.dimension(), found.dimension()) {
            (Some(key), Some(typed)) => key == typed,
            _ => true,
        };
        let found = found.dimension().filter(|_| !fits)?;
        let expected = setup.kind.dimension().unwrap_or(Dimension::PURE);
        let unit = setup
            .unit
            .filter(|unit| !unit.is_one())
            .map(|unit| unit.text());
        let expected = unit.unwrap_or_else(|| in_words(expected));
        Some(
            format!(
                "This comes out in {}, it has to be in {expected}.",
                in_words(found)
            )
            .replace("in a pure number", "as a pure number"),
        )
    }

    /// The named mistake that a formula is.
    fn mistake(&self, typed: &Comparable) -> Option<&Mistake> {
        let is_it =
            |mistake: &&Mistake| self.points.compare(&mistake.formula, typed) == Comparison::Same;
        self.mistakes.iter().find(is_it)
    }

    /// Whether a response is a number in the unit of the key.
    fn is_number(&self, response: &str) -> bool {
        let has_key_dimension = |quantity: crate::unit::Quantity| {
            Some(quantity.unit.dimension()) == self.setup.kind.dimension()
        };
        super::numeric::quantity(response, self.mark).is_ok_and(has_key_dimension)
    }
}

/// What a wrong formula has in common with the key.
fn slip(comparison: &Comparison) -> (Reason, Option<&'static str>) {
    const TWO_PI: f64 = std::f64::consts::TAU;
    let is_near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    match comparison {
        Comparison::Undefined => (
            Reason::Other,
            Some("This has no value for data for which there is an answer."),
        ),
        Comparison::Different {
            ratio: Some(ratio), ..
        } if is_near(-ratio, 1.0) => (Reason::Sign, Some("The sign is wrong.")),
        Comparison::Different {
            ratio: Some(ratio), ..
        } if is_near(*ratio, TWO_PI) || is_near(*ratio, 1.0 / TWO_PI) => (
            Reason::TwoPi,
            Some(
                "It is off by a factor of 2π: angular frequencies and frequencies in hertz differ by it.",
            ),
        ),
        Comparison::Different { part, .. } if *part < 5e-3 => (
            Reason::Near,
            Some(
                "It is nearly right: give the numbers in it exactly, as fractions, roots or multiples of π.",
            ),
        ),
        Comparison::Different { ratio: Some(_), .. } => (
            Reason::Other,
            Some("The symbols fit, but not the number in front."),
        ),
        _ => (Reason::Other, None),
    }
}

/// A finding about dimensions as a student needs it.
pub(super) fn explained(error: Option<&CheckError>) -> String {
    match error {
        Some(CheckError::Dimensions {
            joint: Joint::Sum,
            left,
            right,
            ..
        }) => format!(
            "Terms of different dimensions are added: {} and {}.",
            in_words(*left),
            in_words(*right)
        ),
        Some(error) => {
            let mut words = error.to_string();
            if let Some(first) = words.get_mut(0..1) {
                first.make_ascii_uppercase();
            }
            words.push('.');
            words
        }
        None => "The dimensions do not fit.".to_owned(),
    }
}

fn in_words(dimension: Dimension) -> String {
    if dimension.is_pure() {
        "a pure number".to_owned()
    } else {
        dimension.describe()
    }
}

impl Marker for Prepared {
    fn key(&self) -> Key {
        let math = self.setup.shown.typeset(&self.setup.lexicon);
        let latex = math.latex();
        Key {
            math,
            accepted: None,
            value: KeyValue::Formula {
                text: self.setup.shown.to_string(),
                latex,
            },
        }
    }

    fn mark(&self, response: &str) -> Marking {
        const NUMBER: &str = "A formula in symbols is asked, not a number.";
        let setup = &self.setup;
        let has_names = !setup.shown.names().free.is_empty();
        let typed = match typed::formula(response, &setup.lexicon, self.manner(response)) {
            Ok(typed) => typed,
            Err(error) => {
                let is_unknown = matches!(error.trouble, Trouble::Unknown { .. });
                if is_unknown && has_names && self.is_number(response) {
                    return Marking::unreadable(NUMBER);
                }
                return Marking::unreadable(error.sentence(response));
            }
        };
        let (expr, trouble) = self.fitting(typed);
        let is_number = expr.names().free.is_empty() && !expr.is_zero();
        if has_names && (is_number || trouble.is_some() && self.is_number(response)) {
            return Marking::unreadable(NUMBER);
        }
        let reading = Reading {
            math: expr.typeset(&setup.lexicon),
            text: expr.to_string(),
            si: Vec::new(),
        };
        let Ok(typed) = Comparable::of(&setup.meaning, &expr, &BTreeMap::new()) else {
            return Marking::unreadable(
                "This formula cannot be compared; write it in a simpler form.",
            );
        };
        let comparison = match trouble {
            None => self.points.compare(&self.key, &typed),
            Some(_) => Comparison::Undefined,
        };
        if comparison == Comparison::Same {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        if let Some(mistake) = self.mistake(&typed) {
            let feedback = Some(Feedback::Mistake(mistake.number));
            return Marking::read(
                reading,
                mistake.credit,
                Reason::Mistake(mistake.number),
                feedback,
            );
        }
        if comparison == Comparison::Undecided {
            return Marking::unreadable(
                "All digits are lost when this is computed, so it cannot be compared; write it in a simpler form.",
            );
        }
        if let Some(trouble) = trouble {
            let words = Some(Feedback::Words(trouble));
            return Marking::read(reading, Credit::NONE, Reason::Dimension, words);
        }
        let (reason, words) = slip(&comparison);
        let words = words.map(|words| Feedback::Words(words.to_owned()));
        Marking::read(reading, Credit::NONE, reason, words)
    }
}
