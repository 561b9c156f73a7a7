//! `equation`: an equation of motion or another equation, or several.
//!
//! The student types `m x'' + c x' + k x = F0 cos(Ωt)` with `x'`, `xdot`, `\dot{x}`, `dx/dt`. Any side, any
//! order of terms and any common factor made of data is right; several equations, joined by semicolons,
//! are right if they follow from the key and the key from them. Where several parts of an item ask for one
//! equation each of one system, responses that make up the same equations together are right, too.
//! Two equations, one for either direction of a motion, `… = -F for x' > 0; … = F for x' < 0`, are one; of equations
//! joined by `or` each has to be right alone. What is wrong is named term by term: a sign, a term that is missing, a
//! datum that a coefficient misses.
//!
//! ```toml
//! [[part]]
//! kind     = "equation"
//! id       = "eom"
//! key      = "m*x'' + c*x' + k*x = 0"     # or `model.equation`
//! unknowns = ["x"]                         # if left out, the coordinates of the model of the keys
//! ask      = "Find the equation of motion."
//! mistakes = [{ answer = "m*x'' + k*x = 0", feedback = "The damper is missing." }]
//! ```

mod marker;
mod points;
mod quotient;
mod read;
mod root;
mod rows;
mod system;
mod terms;
mod told;

use std::cell::OnceCell;
use std::sync::{Arc, OnceLock};

use self::marker::Prepared;
use self::points::Choices;
use super::equality::{BySigns, Signs};
use super::letters::Allowed;
use super::meaning::{Meaning, Prefer};
use super::recalled::RightAnswers;
use super::shared::{self, Shared};
use super::{
    Answer, AnswerError, Answered, Asked, Blank, Context, Declare, Doubt, Key, Marker, Reading,
    Role, symbolic,
};
use crate::expr::{Equation, Expr, Name, Program};
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::response::Lexicon;
use crate::source::{Table, Text, Value};

#[derive(Debug)]
struct Equations {
    setup: Arc<Setup>,
    mistakes: Vec<(usize, Vec<Equation>)>,
    written: Written,
}

/// In what equations are compared.
#[derive(Debug)]
enum Written {
    /// In letters, for any data; the other form is at hand.
    InLetters(Box<Equations>),
    /// With the values of the instance in place of letters, `0.5 x'' + 80 x = 0`.
    InValues,
}

#[derive(Debug)]
pub(crate) struct Setup {
    key: Vec<Equation>,
    unknowns: Vec<Name>,
    meaning: Meaning,
    lexicon: Lexicon,
    /// The letters of its answer line.
    letters: Vec<Expr>,
    /// The key and the named mistakes, compiled once for all data.
    compiled: Shared<Vec<Program>>,
    /// The data for which equations are compared with the key.
    choices: BySigns<Choices>,
    right: RightAnswers,
    /// As it is printed, once it was.
    printed: OnceLock<Arc<Key>>,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    part.required("key");
    let (texts, unknowns) = (part.texts("key"), part.texts("unknowns"));
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
        let of_models: Vec<Name> = texts
            .iter()
            .flat_map(|text| declare.coordinates_of(text))
            .collect();
        let coordinates = known.iter().filter(|own| own.role == Role::Coordinate);
        names = coordinates
            .map(|own| own.name.clone())
            .filter(|name| of_models.is_empty() || of_models.contains(name))
            .collect();
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
    let allowed = Allowed::read(part, declare, None, true)?;
    let sides = key
        .iter()
        .flat_map(|equation| [&equation.left, &equation.right]);
    let letters = allowed.of_equations(&names, sides);
    let mut lexicon = allowed.lexicon;
    for own in known.iter().filter(|own| names.contains(&own.name)) {
        lexicon.allow(&own.name, Arc::clone(&own.symbol), true);
    }
    let time = Name::new("t");
    lexicon.allow(&time, crate::math::symbol("t"), false);
    let setup = Arc::new(Setup {
        key,
        unknowns: names,
        meaning,
        lexicon,
        letters,
        compiled: Shared::default(),
        choices: BySigns::default(),
        right: RightAnswers::default(),
        printed: OnceLock::new(),
    });
    let in_values = Equations {
        setup: Arc::clone(&setup),
        mistakes: Vec::new(),
        written: Written::InValues,
    };
    Some(Box::new(Equations {
        setup,
        mistakes: Vec::new(),
        written: Written::InLetters(Box::new(in_values)),
    }))
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

impl Answer for Equations {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Equation
    }

    fn blank(&self) -> Blank {
        let are_several = self.setup.key.len() > 1;
        Blank::of(Asked::Equation { are_several })
            .with_letters(&self.setup.letters, &self.setup.lexicon)
    }

    fn keys(&self) -> Vec<NodeId> {
        Vec::new()
    }

    fn other_form(&self) -> Option<&dyn Answer> {
        match &self.written {
            Written::InLetters(other) => Some(&**other),
            Written::InValues => None,
        }
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn heeds_others(&self) -> bool {
        true
    }

    fn read_mistake(
        &mut self,
        number: usize,
        answer: &Value,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        let mut given = Vec::new();
        for text in &part.as_texts("answer", answer) {
            // A slip may have wrong dimensions: only its names have to be known.
            let Ok(equation) = Equation::read(&text.value) else {
                declare.find(&AnswerError::Unread(text.value.clone(), "equation"), text);
                return None;
            };
            if self
                .setup
                .compile(std::slice::from_ref(&equation), &SortedMap::new())
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

    fn kept_mistake(&self, number: usize) -> Option<String> {
        let own = self.mistakes.iter().find(|(own, _)| *own == number);
        own.map(|(_, equations)| written(equations))
    }

    fn printed(&self, _evaluation: &Evaluation<'_>) -> Option<Result<Arc<Key>, Absent>> {
        Some(Ok(Arc::clone(self.setup.printed())))
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let setup = &self.setup;
        let graph = context.evaluation.graph();
        let none = SortedMap::new();
        let compile = || setup.compile(&setup.key, &context.standing);
        let key = if context.standing.is_empty() {
            setup.compiled.get(shared::KEY, compile)
        } else {
            compile().map(Arc::new)
        };
        let key = key.ok_or_else(|| Absent::Function {
            label: "key".into(),
            of: Vec::new(),
        })?;
        let data = setup.meaning.values(&context.evaluation);
        let signs = Signs::of(&data);
        let choices = match self.written {
            Written::InLetters(_) => setup.choices.kept(&signs, context, || {
                let centres = context.sampling.centres(&setup.meaning, &signs);
                Choices::around(setup, &key, centres)
            }),
            Written::InValues => Arc::new(Choices::of_instance(setup, &key, &data)),
        };
        let mut mistakes = Vec::new();
        for mistaken in &context.mistakes {
            let own = self
                .mistakes
                .iter()
                .find(|(number, _)| *number == mistaken.number);
            let number = shared::of_mistake(mistaken.number);
            let programs = setup.compiled.get(number, || match own {
                Some((_, equations)) => setup.compile(equations, &none),
                None => setup.compile(&setup.key, &symbolic::replaced(graph, mistaken)),
            });
            if let Some(programs) = programs {
                mistakes.push((mistaken.number, programs, mistaken.credit));
            }
        }
        let recalled = match self.written {
            Written::InLetters(_) => setup.right.on(signs, context),
            Written::InValues => None,
        };
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            key,
            choices,
            recalled,
            data,
            own: OnceCell::new(),
            mistakes,
            doubt: match self.written {
                Written::InLetters(_) => context.doubt,
                // Values are rounded.
                Written::InValues => Doubt::Benefit,
            },
        }))
    }
}

impl Setup {
    /// The key as it is printed: the same for all data.
    fn printed(&self) -> &Arc<Key> {
        self.printed
            .get_or_init(|| Arc::new(Key::formula(written(&self.key), self.typeset(&self.key))))
    }

    /// How equations were read.
    pub(crate) fn reading(&self, equations: &[Equation]) -> Reading {
        Reading {
            math: self.typeset(equations),
            text: written(equations),
            answered: Answered::Equations(equations.to_vec()),
        }
    }

    /// Equations side by side, typeset.
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

    fn compile(
        &self,
        equations: &[Equation],
        replaced: &SortedMap<Name, Expr>,
    ) -> Option<Vec<Program>> {
        let compile =
            |equation: &Equation| self.meaning.compile(&equation.difference(), replaced).ok();
        equations.iter().map(compile).collect()
    }
}

fn written(equations: &[Equation]) -> String {
    let texts = equations
        .iter()
        .map(|equation| format!("{} = {}", equation.left, equation.right));
    texts.collect::<Vec<_>>().join("; ")
}
