//! `equation`: an equation of motion or another equation, or several.
//!
//! The student types `m x'' + c x' + k x = F0 cos(Ωt)` with `x'`, `xdot`, `\dot{x}`, `dx/dt`. Any side, any
//! order of terms and any common factor made of data is right; several equations, joined by semicolons,
//! are right if they follow from the key and the key from them. What is wrong is told by terms: a sign,
//! a term that is missing, a coefficient.
//!
//! ```toml
//! [[part]]
//! kind     = "equation"
//! id       = "eom"
//! key      = "m*x'' + c*x' + k*x = 0"     # or `model.equation`
//! unknowns = ["x"]                         # the coordinates if left out
//! ask      = "Find the equation of motion."
//! mistakes = [{ answer = "m*x'' + k*x = 0", feedback = "The damper is missing." }]
//! ```

mod rows;
mod terms;

use std::collections::BTreeMap;
use std::sync::Arc;

use self::rows::Rows;
use super::equality::Around;
use super::meaning::{Meaning, Prefer, lexicon};
use super::typed::{self, Chain, Lexicon, Manner, Typed, cut};
use super::{
    Answer, AnswerError, AnswerKind, Context, Credit, Declare, Feedback, Key, KeyValue, Marker,
    Marking, Reading, Reason, Role, symbolic,
};
use crate::expr::{Equation, Expr, Name, Precise, Program, Relation};
use crate::math::Math;
use crate::numerics::Rational;
use crate::quantity::{Absent, NodeId};
use crate::source::{Span, Table, Text, Value};

/// The kind.
pub(super) struct Kind;

/// Data for which equations are compared.
const DATA_POINTS: usize = 4;

#[derive(Debug)]
struct Asked {
    setup: Arc<Setup>,
    mistakes: Vec<(usize, Vec<Equation>)>,
}

#[derive(Debug)]
struct Setup {
    key: Vec<Equation>,
    unknowns: Vec<Name>,
    meaning: Meaning,
    lexicon: Lexicon,
}

struct Prepared {
    setup: Arc<Setup>,
    key: Vec<Program>,
    /// For each choice of data, points that differ in all else.
    points: Vec<Vec<Vec<Precise>>>,
    mistakes: Vec<(usize, Vec<Program>, Credit)>,
}

impl AnswerKind for Kind {
    fn name(&self) -> &'static str {
        "equation"
    }

    fn minutes(&self) -> u32 {
        6
    }

    fn read(&self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        part.required("key");
        let (texts, unknowns, listed) =
            (part.texts("key"), part.texts("unknowns"), part.texts("in"));
        let mut meaning = Meaning::of(declare, Prefer::Coordinates);
        let known = declare.known();
        let mut names = Vec::new();
        for text in &unknowns {
            let Some(own) = known.iter().find(|own| own.name.as_str() == text.value) else {
                declare.find(&AnswerError::UnknownName(text.value.clone()), text);
                return None;
            };
            names.push(own.name.clone());
        }
        if unknowns.is_empty() {
            let coordinates = known.iter().filter(|own| own.role == Role::Coordinate);
            names = coordinates.map(|own| own.name.clone()).collect();
        }
        for name in &names {
            meaning.set_moving(name);
        }
        let mut key = Vec::new();
        for text in &texts {
            key.extend(equations(text, &meaning, declare)?);
        }
        if key.is_empty() {
            return None;
        }
        let (mut lexicon, _) = lexicon(declare, &listed, None);
        for own in known.iter().filter(|own| names.contains(&own.name)) {
            lexicon.allow(&own.name, &own.symbol, true);
        }
        let time = Name::new("t");
        lexicon.allow(&time, &crate::math::symbol("t"), false);
        Some(Box::new(Asked {
            setup: Arc::new(Setup {
                key,
                unknowns: names,
                meaning,
                lexicon,
            }),
            mistakes: Vec::new(),
        }))
    }
}

/// The equations of a text: written, or those of a model.
fn equations(text: &Text, meaning: &Meaning, declare: &mut dyn Declare) -> Option<Vec<Equation>> {
    if !text.value.contains('=') {
        return declare.equations(text);
    }
    let equation = match Equation::read(&text.value) {
        Ok(equation) => equation,
        Err(error) => {
            declare.find(&error, text);
            return None;
        }
    };
    if let Err(errors) = equation.check(meaning) {
        for error in &errors {
            declare.find(error, text);
        }
        return None;
    }
    Some(vec![equation])
}

impl Answer for Asked {
    fn kind(&self) -> &'static dyn AnswerKind {
        &Kind
    }

    fn keys(&self) -> Vec<NodeId> {
        Vec::new()
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
        let texts: Vec<Text> = match &answer.data {
            crate::source::Data::List(items) => items
                .iter()
                .filter_map(|item| part.as_text("answer", item))
                .collect(),
            _ => part.as_text("answer", answer).into_iter().collect(),
        };
        let mut given = Vec::new();
        for text in &texts {
            // A slip may have wrong dimensions: only its names have to be known.
            let Ok(equation) = Equation::read(&text.value) else {
                declare.find(&AnswerError::Unread(text.value.clone(), "equation"), text);
                return None;
            };
            if self
                .setup
                .compile(std::slice::from_ref(&equation), &BTreeMap::new())
                .is_none()
            {
                equations(text, &self.setup.meaning, declare)?;
                return None;
            }
            given.push(equation);
        }
        self.mistakes.push((number, given));
        Some(Vec::new())
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        let setup = &self.setup;
        let graph = context.evaluation.graph();
        let none = BTreeMap::new();
        let absent = || Absent::Function {
            label: "key".into(),
            of: Vec::new(),
        };
        let key = setup.compile(&setup.key, &none).ok_or_else(absent)?;
        let count = 2 * setup.key.len() + 6;
        let mut around = Around::new(&setup.meaning, context.evaluation);
        let points = (0..DATA_POINTS)
            .map(|place| {
                let spread = 0.3 * (1.0 - place as f64 / DATA_POINTS as f64);
                let data = around.point(spread, false, false);
                (0..count)
                    .map(|_| {
                        setup
                            .meaning
                            .with_data(around.point(0.6, false, false), &data)
                    })
                    .collect()
            })
            .collect();
        let mut mistakes = Vec::new();
        for mistaken in &context.mistakes {
            let own = self
                .mistakes
                .iter()
                .find(|(number, _)| *number == mistaken.number);
            let given = match own {
                Some((_, equations)) => setup.compile(equations, &none),
                None => setup.compile(&setup.key, &symbolic::replaced(graph, mistaken)),
            };
            if let Some(programs) = given {
                mistakes.push((mistaken.number, programs, mistaken.credit));
            }
        }
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            key,
            points,
            mistakes,
        }))
    }
}

impl Setup {
    fn compile(
        &self,
        equations: &[Equation],
        replaced: &BTreeMap<Name, Expr>,
    ) -> Option<Vec<Program>> {
        let compile =
            |equation: &Equation| self.meaning.compile(&equation.difference(), replaced).ok();
        equations.iter().map(compile).collect()
    }

    fn typeset(&self, equations: &[Equation]) -> Math {
        let mut row = Vec::new();
        for equation in equations {
            if !row.is_empty() {
                row.push(Math::punctuation(";"));
            }
            row.push(equation.left.typeset(&self.lexicon));
            row.push(Math::relation("="));
            row.push(equation.right.typeset(&self.lexicon));
        }
        Math::row(row)
    }

    /// The equations that a response is.
    fn read(&self, response: &str) -> Result<Vec<Equation>, String> {
        let manner = Manner {
            comma_is_decimal: true,
            has_imaginary_unit: false,
        };
        let mut found = Vec::new();
        for place in pieces(response) {
            let (from, to) = (place.range().start, place.range().end);
            let chain = typed::chain(response, from, to, &self.lexicon, manner);
            let Typed { value, other } = chain.map_err(|error| error.sentence(response))?;
            let first = of_chain(value)?;
            let other = other.and_then(|other| of_chain(other).ok());
            let fits = |equations: &[Equation]| {
                equations
                    .iter()
                    .all(|equation| equation.check(&self.meaning).is_ok())
            };
            found.extend(match other {
                Some(other) if !fits(&first) && fits(&other) => other,
                _ => first,
            });
        }
        Ok(found)
    }
}

/// The equations `a = b = c` is.
fn of_chain(chain: Chain) -> Result<Vec<Equation>, String> {
    if chain
        .relations
        .iter()
        .any(|relation| *relation != Relation::Equal)
    {
        return Err("An equation is asked, not an inequality.".to_owned());
    }
    let pair = |sides: &[Expr]| Equation {
        left: sides[0].clone(),
        right: sides[1].clone(),
    };
    Ok(chain.sides.windows(2).map(pair).collect())
}

/// The equations of a text, cut at semicolons, line ends, and commas between equations.
fn pieces(text: &str) -> Vec<Span> {
    let all = Span::new(0, text.len());
    let mut found = Vec::new();
    for line in cut(text, all, &[';', '\n']) {
        let parts = cut(text, line, &[',']);
        let are_equations = parts.iter().all(|part| text[part.range()].contains('='));
        found.extend(if are_equations { parts } else { vec![line] });
    }
    found.retain(|place| !text[place.range()].trim().is_empty());
    if found.is_empty() {
        found.push(all);
    }
    found
}

impl Prepared {
    fn compare(&self, key: &[Program], typed: &[Program]) -> Rows {
        let at = self
            .points
            .iter()
            .map(|points| Rows::of(key, typed, points));
        at.reduce(Rows::worse).unwrap_or(Rows::Undefined)
    }

    fn trouble(&self, equations: &[Equation]) -> Option<String> {
        let errors = equations
            .iter()
            .find_map(|equation| equation.check(&self.setup.meaning).err());
        errors.map(|errors| super::formula::explained(errors.first()))
    }
}

impl Marker for Prepared {
    fn key(&self) -> Key {
        let setup = &self.setup;
        let math = setup.typeset(&setup.key);
        let latex = math.latex();
        Key {
            math,
            accepted: None,
            value: KeyValue::Formula {
                text: written(&setup.key),
                latex,
            },
        }
    }

    fn mark(&self, response: &str) -> Marking {
        let setup = &self.setup;
        let equations = match setup.read(response) {
            Ok(equations) => equations,
            Err(words) => return Marking::unreadable(words),
        };
        let reading = Reading {
            math: setup.typeset(&equations),
            text: written(&equations),
            si: Vec::new(),
        };
        let Some(typed) = setup.compile(&equations, &BTreeMap::new()) else {
            return Marking::unreadable(
                "This equation cannot be compared; write it in a simpler form.",
            );
        };
        let rows = self.compare(&self.key, &typed);
        if rows == Rows::Same {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| self.compare(given, &typed) == Rows::Same);
        if let Some((number, _, credit)) = named {
            let feedback = Some(Feedback::Mistake(*number));
            return Marking::read(reading, *credit, Reason::Mistake(*number), feedback);
        }
        let say = |words: String| Some(Feedback::Words(words));
        if let Rows::Fewer { found, needed } = rows {
            let credit = Rational::new(found as i128, needed as i128).and_then(Credit::new);
            let words =
                format!("Right as far as it goes: {needed} independent equations are asked.");
            return Marking::read(
                reading,
                credit.unwrap_or(Credit::NONE),
                Reason::Other,
                say(words),
            );
        }
        if let Some(trouble) = self.trouble(&equations) {
            return Marking::read(reading, Credit::NONE, Reason::Dimension, say(trouble));
        }
        let words = match (&self.key[..], &typed[..]) {
            ([key], [typed]) => terms::feedback(setup, key, typed, &self.points),
            _ => None,
        };
        let reason = if words.as_ref().is_some_and(|words| words.contains("sign")) {
            Reason::Sign
        } else {
            Reason::Other
        };
        Marking::read(reading, Credit::NONE, reason, words.map(Feedback::Words))
    }
}

fn written(equations: &[Equation]) -> String {
    let texts = equations
        .iter()
        .map(|equation| format!("{} = {}", equation.left, equation.right));
    texts.collect::<Vec<_>>().join("; ")
}
