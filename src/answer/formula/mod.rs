//! `formula`: a formula in the symbols of the item.
//!
//! The student types `sqrt(3k/(2m))`, `√(3k/2m)` or `(3*k/2/m)^0.5`: any form of the same function of the
//! data is right, as long as the constraints of the item hold. Products need no sign, Greek letters come as words or signs, simple LaTeX is read.
//! The letters of the answer are all parameters, symbols and coordinates, and the quantities of earlier parts, but for
//! those that `without` lists; `in` lists the letters in which the key is printed, which may be used as well.
//! A formula of another dimension is reported.
//! Where it is a bound, `bound = "upper"` or `"lower"`, a range that it bounds on this side says it, too: `x0 <= 3 mu m g/k`.
//!
//! ```toml
//! [[part]]
//! kind     = "formula"
//! key      = "omega_d"
//! in       = ["m", "c", "k"]
//! ask      = "Find the angular frequency of the damped motion."
//! mistakes = [{ answer = "sqrt(k/m)", feedback = "That is the motion without damping." }]
//! ```

mod marker;
mod slip;
mod solved;
mod values;

use std::sync::{Arc, OnceLock};

use self::marker::{Mistake, Prepared};
use super::equality::{BySigns, Comparable, Points, Signs};
use super::letters::Allowed;
use super::meaning::{Meaning, Prefer};
use super::recalled::RightAnswers;
use super::shared::{self, Shared};
use super::{
    Answer, AnswerError, AnswerKind, Asked, Blank, Context, Declare, Key, Marker, Naming, bound,
    numeric, symbolic,
};
use crate::expr::{Expr, Field, Name, Shape, Type};
use crate::numerics::SortedMap;
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::response::{AskedBound, Lexicon};
use crate::source::{Table, Text};
use crate::unit::Unit;

#[derive(Debug)]
pub(crate) struct Formula {
    key: NodeId,
    setup: Arc<Setup>,
    /// Whether it changes with time: it uses `t` or a coordinate.
    moves: bool,
    /// The bound that its value is.
    bound: Option<AskedBound>,
    /// The numeric answer by which a response is marked that gives the value of the formula; none where the formula moves.
    value: Option<Box<dyn Answer>>,
}

/// What holds whatever the data are.
#[derive(Debug)]
pub(crate) struct Setup {
    /// In the names that an answer may use.
    shown: Expr,
    expr: Expr,
    kind: Type,
    unit: Option<Unit>,
    meaning: Meaning,
    lexicon: Lexicon,
    /// What the answer may be called.
    naming: Naming,
    /// The letters of its answer line.
    letters: Vec<Expr>,
    /// The key and the named mistakes, compiled once for all data.
    compiled: Shared<Comparable>,
    /// The points at which answers are compared with the key.
    points: BySigns<Points>,
    right: RightAnswers,
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
    let bound = bound::read(part, declare);
    let text = text?;
    let key = declare.formula("key", &text)?;
    let kind = declare.graph().kind(key)?.clone();
    let mut formula = of_key(part, &text, key, declare)?;
    formula.bound = bound;
    if !formula.moves {
        formula.value = numeric::of_formula(key, &kind, declare);
    }
    Some(Box::new(formula))
}

/// What asks for a key as a formula.
pub(crate) fn of_key(
    part: &Table<'_>,
    text: &Text,
    key: NodeId,
    declare: &mut dyn Declare,
) -> Option<Formula> {
    let kind = declare.graph().kind(key)?.clone();
    if kind.shape() != Shape::Scalar || kind.field() == Field::Boolean {
        let found = kind.form().to_string();
        declare.find(
            &AnswerError::KeyForm {
                expected: "a number",
                found,
            },
            text,
        );
        return None;
    }
    let own = Name::new(text.value.as_str());
    let named = declare
        .graph()
        .find(&own)
        .filter(|node| *node == key)
        .map(|_| own);
    let meaning = Meaning::of(declare, Prefer::Quantities);
    let expr = symbolic::formula(declare.graph(), key);
    let uses_time = declare.graph().depends(key, &Name::new("t"));
    let moves = uses_time || meaning.uses_moving(&expr);
    let mut allowed = Allowed::read(part, declare, named.as_ref(), moves)?;
    if uses_time {
        allowed.allow_variable(&Name::new("t"));
    }
    let shown = meaning.expanded(&expr, &allowed.names);
    let unit = declare.unit_of(key);
    let naming = Naming::of(declare, AnswerKind::Formula, &[key], unit);
    let setup = Setup {
        naming,
        letters: allowed.of_formula(&shown),
        shown,
        expr,
        kind,
        unit,
        meaning,
        lexicon: allowed.lexicon,
        compiled: Shared::default(),
        points: BySigns::default(),
        right: RightAnswers::default(),
        printed: OnceLock::new(),
    };
    Some(Formula {
        key,
        setup: Arc::new(setup),
        moves,
        bound: None,
        value: None,
    })
}

impl Answer for Formula {
    fn kind(&self) -> AnswerKind {
        AnswerKind::Formula
    }

    fn blank(&self) -> Blank {
        Blank::of(Asked::Formula).with_letters(&self.setup.letters, &self.setup.lexicon)
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn bound(&self) -> Option<AskedBound> {
        self.bound
    }

    fn other_form(&self) -> Option<&dyn Answer> {
        self.value.as_deref()
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn printed(&self, evaluation: &Evaluation<'_>) -> Option<Result<Arc<Key>, Absent>> {
        let exists = evaluation.exists_for(self.key);
        Some(exists.map(|()| Arc::clone(self.setup.printed())))
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let (setup, graph) = (&self.setup, context.evaluation.graph());
        context.evaluation.exists_for(self.key)?;
        let none = SortedMap::new();
        let compile = |expr: &Expr, replaced: &SortedMap<Name, Expr>| {
            Comparable::of(&setup.meaning, expr, replaced).ok()
        };
        let own = context.standing.get(&Name::new(graph.label(self.key)));
        let key = match own {
            Some(own) => compile(own, &none).map(Arc::new),
            None if context.standing.is_empty() => setup
                .compiled
                .get(shared::KEY, || compile(&setup.expr, &none)),
            None => compile(&setup.expr, &context.standing).map(Arc::new),
        };
        let key = key.ok_or_else(|| Absent::Function {
            label: "key".into(),
            of: Vec::new(),
        })?;
        let data = setup.meaning.values(&context.evaluation);
        let signs = Signs::of(&data);
        let around = || Points::around(&setup.meaning, &context.sampling, &signs, &[&key]);
        let points = setup.points.kept(&signs, context, around);
        let mistakes = context.mistakes.iter().filter_map(|mistaken| {
            let number = shared::of_mistake(mistaken.number);
            let formula = setup.compiled.get(number, || match mistaken.given.first() {
                Some(node) => compile(&symbolic::formula(graph, *node), &none),
                None => compile(&setup.expr, &symbolic::replaced(graph, mistaken)),
            });
            Some(Mistake {
                number: mistaken.number,
                formula: formula?,
                credit: mistaken.credit,
            })
        });
        let mistakes = mistakes.collect();
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            key,
            points,
            mistakes,
            recalled: setup.right.on(signs, context),
            data,
            mark: context.mark,
            doubt: context.doubt,
        }))
    }
}
