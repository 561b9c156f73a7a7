//! `function`: a function of time, or of another variable, over a span.
//!
//! The student types `0.632 exp(-0.0125 t) sin(15.8 t)` or the same with symbols, in any form: sines or
//! cosines, any sign convention, phases in radians. What is said beside it of its letters, `φ = 28.07°`, counts, be it
//! otherwise than in the question. Both functions are compared over the span, which is
//! three periods unless stated; the tolerance is a share of the largest value. Where none is stated, each
//! time has its own, from rounding every intermediate result to the working figures:
//!
//! ```text
//! half-width(t) = 0.005 · 10^(3−s) · ( max|x| + Σ |z ∂x/∂z|(t) )     over the steps z between data and answer.
//! ```
//!
//! Where a datum of the key does not show on the span, as light damping does not over three periods, the sizes of both
//! functions are compared once more after the span, where it does.
//!
//! A response all in letters has nothing to be rounded: unless a tolerance is stated, it has to be exact.
//!
//! ```toml
//! [[part]]
//! kind      = "function"
//! key       = "x"
//! span      = ["0", "6*pi/omega_n"]
//! tolerance = "2 %"             # of the largest value; derived if left out
//! in        = ["x0"]            # letters in which the key is printed
//! ask       = "Find $x(t)$."
//! ```
//!
//! With `constants`, the general solution of a model's equations is asked. The student names the constants
//! (`A`, `B1`, `phi2`, …) and gives one function for each of the `components`, `x1 = …; x2 = …`. It is right
//! when it satisfies the equations for all constants and can meet any initial state.
//!
//! ```toml
//! [[part]]
//! kind       = "function"
//! id         = "general"
//! key        = "model.general_motion"
//! components = ["x1", "x2"]
//! constants  = 4
//! ask        = "Find the general solution."
//! ```

mod general;
mod label;
mod late;
mod marker;
mod phase;
mod read;
mod samples;
mod slip;
mod span;

use std::cell::OnceCell;
use std::rc::Rc;
use std::sync::{Arc, OnceLock};

use self::label::Labels;
use self::marker::{Prepared, largest};
use self::samples::{derived, samples};
use self::span::{Extent, spans, times};
use super::letters::Allowed;
use super::meaning::{Meaning, Prefer};
use super::{
    Answer, AnswerError, Asked, Blank, Context, Declare, Key, Marker, Tolerance, symbolic,
};
use crate::expr::{Expr, Form, Name, Type};
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::response::Lexicon;
use crate::source::Table;
use crate::unit::Unit;

/// Times at which functions are compared.
const SAMPLES: usize = 48;

#[derive(Debug)]
struct ComparedTimes {
    key: NodeId,
    span: Extent,
    tolerance: Tolerance,
    figures: u32,
    setup: Arc<Setup>,
}

#[derive(Debug)]
pub(crate) struct Setup {
    shown: Expr,
    kind: Type,
    unit: Option<Unit>,
    variable: Name,
    /// Whether the key is another function in different pieces of its span.
    is_in_pieces: bool,
    meaning: Meaning,
    lexicon: Lexicon,
    /// The variable alone: where numbers have units, other letters are such.
    of_numbers: Lexicon,
    /// The letters of its answer line.
    letters: Vec<Expr>,
    labels: Labels,
    /// As it is printed, once it was.
    printed: OnceLock<Arc<Key>>,
}

impl Setup {
    /// The key as it is printed: the same for all data.
    fn printed(&self) -> &Arc<Key> {
        self.printed
            .get_or_init(|| symbolic::printed(&self.shown, &self.lexicon))
    }
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let text = part
        .required("key")
        .and_then(|key| part.as_formula("key", key));
    let span = part.value("span").map(|value| spans(part, value));
    let (variable, tolerance) = (part.text("variable"), part.text("tolerance"));
    let components = part.texts("components");
    let constants = part.integer("constants", "the number of free constants", 0..=20);
    let text = text?;
    if constants.is_some_and(|count| count > 0) {
        return general::read(part, &text, &components, declare);
    }
    let key = declare.formula("key", &text)?;
    let kind = declare.graph().kind(key)?.clone();
    let variable = Name::new(variable.map_or("t".to_owned(), |text| text.value));
    let of = declare.graph().variables(key);
    if kind.form() != Form::REAL || of.iter().any(|name| *name != variable) {
        let found = kind.form().to_string();
        declare.find(
            &AnswerError::KeyForm {
                expected: "a function of one variable",
                found,
            },
            &text,
        );
        return None;
    }
    let unit = declare.unit_of(key);
    let tolerance = match tolerance {
        Some(text) => Tolerance::read(&text, &unit.unwrap_or(Unit::ONE), declare)?,
        None => Tolerance::default(),
    };
    let span = match &span {
        Some(span) => {
            let [from, to] = &span[..] else {
                return None;
            };
            Extent::Stated([declare.formula("span", from)?, declare.formula("span", to)?])
        }
        None => Extent::of_model(&text, declare)?,
    };
    let own = Name::new(text.value.as_str());
    let named = declare.graph().find(&own).map(|_| own);
    let mut allowed = Allowed::read(part, declare, named.as_ref(), false)?;
    allowed.allow_variable(&variable);
    let meaning = Meaning::of(declare, Prefer::Quantities);
    let formula = symbolic::formula(declare.graph(), key);
    let shown = meaning.expanded(&formula, &allowed.names);
    let in_data = meaning.expanded(&formula, std::slice::from_ref(&variable));
    Some(Box::new(ComparedTimes {
        key,
        span,
        tolerance,
        figures: u32::from(declare.figures()),
        setup: Arc::new(Setup {
            shown,
            kind,
            unit,
            labels: Labels::of(declare, named.as_ref(), &variable),
            of_numbers: Lexicon::new().with(&variable, crate::math::symbol(variable.as_str())),
            is_in_pieces: late::is_in_pieces(&in_data, &variable),
            variable,
            meaning,
            letters: allowed.letters(),
            lexicon: allowed.lexicon,
            printed: OnceLock::new(),
        }),
    }))
}

impl Answer for ComparedTimes {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Function
    }

    fn blank(&self) -> Blank {
        let setup = &self.setup;
        let variable = crate::math::symbol(setup.variable.as_str());
        Blank::of(Asked::Function { variable })
            .with_letters(&setup.letters, &setup.lexicon)
            .with_numbers(setup.unit, self.figures)
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn printed(&self, evaluation: &Evaluation<'_>) -> Option<Result<Arc<Key>, Absent>> {
        let times = self.span.ends(evaluation).map(times);
        let first = times.and_then(|times| samples(evaluation, self.key, &times[..1], 0.0));
        Some(first.map(|_| Arc::clone(self.setup.printed())))
    }

    fn figures(&self) -> u32 {
        self.figures
    }

    fn states_tolerance(&self) -> bool {
        !self.tolerance.is_derived()
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let evaluation = &*context.evaluation;
        let ends = self.span.ends(evaluation)?;
        let times = times(ends);
        let values = samples(evaluation, self.key, &times, 0.0)?;
        let largest = largest(&values);
        let halves = if self.tolerance.is_derived() {
            derived(evaluation, self.key, &times, &values, largest, self.figures)
        } else {
            let half = self
                .tolerance
                .half_width(largest, || 0.0, self.figures, evaluation);
            vec![half; SAMPLES]
        };
        Ok(Box::new(Prepared {
            setup: Arc::clone(&self.setup),
            data: self.setup.meaning.data(evaluation),
            evaluation: Rc::clone(&context.evaluation),
            key: self.key,
            ends,
            times,
            values,
            halves,
            tolerance: self.tolerance.clone(),
            figures: self.figures,
            mistaken: context.mistakes.clone(),
            mistakes: OnceCell::new(),
            windows: OnceCell::new(),
            doubt: context.doubt,
        }))
    }
}
