//! Steps before a value: the letters that they may be written in, and what they come to.

use super::naming::{has_letters, is_asked, is_one, is_seen};
use super::{AnswerKind, Declare, Role};
use crate::expr::{Expr, Field, Kind, Name, Operator, Scope, Type};
use crate::math::symbol;
use crate::quantity::NodeId;
use crate::response::{Lexicon, Manner, Passage, parted};
use crate::unit::Dimension;

/// What the steps before a value may be written in.
#[derive(Debug, Default)]
pub(crate) struct Steps {
    /// The letters of the question, with and without their indices, and those of the field.
    pub(crate) letters: Lexicon,
    /// What each of these letters is.
    types: Vec<(Name, Type)>,
    /// The names of what is asked.
    asked: Vec<Name>,
    dimension: Option<Dimension>,
    manner: Manner,
    is_one: bool,
}

impl Scope for Steps {
    fn name(&self, name: &Name) -> Option<Type> {
        let found = self.types.iter().find(|(own, _)| own == name);
        found.map(|(_, own)| own.clone())
    }

    fn known(&self) -> Vec<String> {
        Vec::new()
    }
}

impl Steps {
    pub(crate) fn of(declare: &dyn Declare, key: NodeId) -> Self {
        let ((mut letters, types), mut asked) = (letters_of_steps(declare), Vec::new());
        let known = declare.known();
        for own in known.iter().filter(|own| is_asked(declare, key, own)) {
            let letter = Name::new(parted(own.name.as_str()).0);
            letters.allow(&own.name, own.symbol.clone(), false);
            if letters.reads(letter.as_str()).is_none() {
                letters.allow(&letter, symbol(letter.as_str()), false);
            }
            asked.extend([own.name.clone(), letter]);
        }
        let kind = declare.graph().kind(key);
        let is_complex = kind.map(Type::field) == Some(Field::Complex);
        Self {
            letters,
            types,
            asked,
            dimension: kind.and_then(Type::dimension),
            manner: Manner {
                has_imaginary_unit: is_complex,
                ..Manner::default()
            },
            is_one: is_one(AnswerKind::Numeric, kind.map(Type::shape)),
        }
    }

    /// Whether a side is a step before a value: a formula in letters of which none is what is asked.
    pub(crate) fn are_in(&self, side: Passage<'_>) -> bool {
        self.are_of_question_in(side) || self.are_own_in(side)
    }

    /// Whether a side is a formula in letters of the question, of which none is what is asked: `√(k/m) = 19 rad/s`,
    /// `1/T = 2 Hz`. With one letter it may name another quantity, `ω² = 19/s²`, unless it has the dimension of what is
    /// asked.
    fn are_of_question_in(&self, side: Passage<'_>) -> bool {
        self.step(side)
            .is_some_and(|step| step.names().free.len() > 1 || self.is_derived(&step))
    }

    /// Whether a side is a formula in letters of the question that has the dimension of what is asked.
    pub(crate) fn are_derived_in(&self, side: Passage<'_>) -> bool {
        self.step(side).is_some_and(|step| self.is_derived(&step))
    }

    /// The formula in letters of the question that a side is, if none of them is what is asked.
    fn step(&self, side: Passage<'_>) -> Option<Expr> {
        let formula = side.formula(&self.letters, self.manner).ok()?.value;
        let names = formula.names();
        let is_step = self.is_one
            && !self.asked.is_empty()
            && !names.free.is_empty()
            && !self.asked.iter().any(|own| names.uses(own));
        is_step.then_some(formula)
    }

    /// Whether a side is nothing where what is asked is nothing, and only there: `ω²`.
    pub(crate) fn vanishes(&self, side: Passage<'_>) -> bool {
        let typed = side.formula(&self.letters, self.manner);
        typed.is_ok_and(|typed| match typed.value.kind() {
            Kind::Binary(Operator::Power, base, exponent) => {
                let is_positive = exponent.as_number().is_some_and(|own| own.numerator() > 0);
                let is_asked = matches!(base.kind(), Kind::Name(own) if self.asked.contains(own));
                is_positive && is_asked
            }
            _ => false,
        })
    }

    /// Whether a formula is no name, and has the dimension of what is asked.
    fn is_derived(&self, formula: &Expr) -> bool {
        let is_name = matches!(
            formula.kind(),
            Kind::Name(_) | Kind::Prime(..) | Kind::Negate(_)
        );
        let kind = formula.check(self).ok();
        !is_name
            && self.dimension.is_some()
            && kind.and_then(|own| own.dimension()) == self.dimension
    }

    /// Whether a side is a formula with letters of one's own, of which none is what is asked: `√(K/J) = 19 rad/s`.
    fn are_own_in(&self, side: Passage<'_>) -> bool {
        let is_of_asked = |letter: &Passage<'_>| {
            let typed = letter.formula(&self.letters, self.manner);
            typed.is_ok_and(|typed| self.asked.iter().any(|own| typed.value.names().uses(own)))
        };
        // Without a name of what is asked nobody knows which letter is not it.
        !self.asked.is_empty()
            && side.is_of_free_letters()
            && has_letters(side)
            && side.formula(&self.letters, self.manner).is_err()
            && !side.letters().iter().any(is_of_asked)
    }
}

/// The letters that the steps before a value may be written in: those of the question, with and without their indices,
/// and the period, the frequency, the decay rate and the damping ratio; with what each of them is.
fn letters_of_steps(declare: &dyn Declare) -> (Lexicon, Vec<(Name, Type)>) {
    const CUSTOMARY: [(&str, Dimension); 4] = [
        ("T", Dimension::TIME),
        ("f", Dimension::FREQUENCY),
        ("lambda", Dimension::FREQUENCY),
        ("zeta", Dimension::PURE),
    ];
    let mut lexicon = Lexicon::new();
    let known = declare.known();
    let mut types: Vec<(Name, Type)> = Vec::new();
    for own in known.iter().filter(|own| is_seen(own.role)) {
        lexicon.allow(&own.name, own.symbol.clone(), own.role == Role::Coordinate);
        types.push((own.name.clone(), own.kind.clone()));
    }
    let letters = types
        .iter()
        .map(|(name, own)| (Name::new(parted(name.as_str()).0), own.clone()));
    let customary = CUSTOMARY.map(|(letter, dimension)| (Name::new(letter), Type::real(dimension)));
    let letters: Vec<(Name, Type)> = letters.chain(customary).collect();
    for (letter, own) in letters {
        if types.iter().all(|(name, _)| *name != letter) {
            lexicon.allow(&letter, symbol(letter.as_str()), false);
            types.push((letter, own));
        }
    }
    (lexicon, types)
}
