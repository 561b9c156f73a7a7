//! The letters that the answers of a part may use.

use std::sync::Arc;

use super::{AnswerError, Declare, Known, Role};
use crate::expr::{Expr, Name, Shape};
use crate::math::symbol;
use crate::response::Lexicon;
use crate::source::Table;

/// The letters that the answers of a part may use.
pub(crate) struct Allowed {
    /// How they are typed.
    pub(crate) lexicon: Lexicon,
    /// Those in which the key is printed.
    pub(crate) names: Vec<Name>,
    /// Those of an answer line.
    letters: Vec<Name>,
}

impl Allowed {
    /// The letters that may be used: all data and symbols, the numbers that earlier parts ask for, and what the part lists as
    /// `in`; a symbol is on the line from the first part on that writes it; what moves with time only where the answer does; without those of its `without`, and never the key itself unless
    /// it is listed.
    pub(crate) fn read(
        part: &Table<'_>,
        declare: &mut dyn Declare,
        key: Option<&Name>,
        moves: bool,
    ) -> Option<Self> {
        let (listed, barred) = (part.texts("in"), part.texts("without"));
        let known = declare.known();
        for name in listed.iter().chain(&barred) {
            let is_time = name.value == "t";
            if !is_time && known.iter().all(|own| own.name.as_str() != name.value) {
                declare.find(&AnswerError::UnknownName(name.value.clone()), name);
                return None;
            }
        }
        let is_in = |list: &[crate::source::Text], own: &Known| {
            list.iter().any(|text| text.value == own.name.as_str())
        };
        let mut allowed = Self {
            lexicon: Lexicon::new(),
            names: Vec::new(),
            letters: Vec::new(),
        };
        let mut seen: Vec<&Name> = Vec::new();
        for own in &known {
            let is_known = match own.role {
                Role::Quantity { is_asked, .. } => is_asked,
                _ => true,
            };
            let is_listed = is_in(&listed, own);
            let is_moving = match own.role {
                Role::Coordinate => true,
                Role::Quantity { node, .. } => declare.graph().depends(node, &Name::new("t")),
                _ => false,
            };
            // A matrix in place of a number would hide a datum of its letter.
            let is_number = own.kind.shape() == Shape::Scalar;
            let is_free = is_known && key != Some(&own.name) && is_number && (moves || !is_moving);
            let may = (is_free || is_listed) && !is_in(&barred, own);
            if !may || seen.contains(&&own.name) {
                continue;
            }
            seen.push(&own.name);
            allowed
                .lexicon
                .allow(&own.name, Arc::clone(&own.symbol), is_moving);
            if is_listed || own.role != Role::Symbol || declare.is_introduced(&own.name) {
                allowed.letters.push(own.name.clone());
            }
            if listed.is_empty() || is_listed {
                allowed.names.push(own.name.clone());
            }
        }
        for own in known.iter().filter(|own| !seen.contains(&&own.name)) {
            allowed.lexicon.forbid(&own.name);
            allowed
                .lexicon
                .set_symbol(&own.name, Arc::clone(&own.symbol));
        }
        if listed.iter().any(|text| text.value == "t") {
            allowed.allow_variable(&Name::new("t"));
            allowed.letters.push(Name::new("t"));
        }
        Some(allowed)
    }

    /// Lets answers use the variable of a function, which is named elsewhere on the line.
    pub(crate) fn allow_variable(&mut self, name: &Name) {
        if !self.names.contains(name) {
            self.lexicon.allow(name, symbol(name.as_str()), false);
            self.names.push(name.clone());
        }
    }

    /// The letters of a line.
    pub(crate) fn letters(&self) -> Vec<Expr> {
        self.letters.iter().cloned().map(Expr::name).collect()
    }

    /// The letters of a line for a formula, with the derivatives and the time that it uses.
    pub(crate) fn of_formula(&self, key: &Expr) -> Vec<Expr> {
        let mut letters = self.letters();
        for used in key.names().free {
            let letter = Expr::name(used.name.clone()).prime(used.order);
            let is_more = used.order > 0 || used.name.as_str() == "t";
            if is_more && !letters.contains(&letter) {
                letters.push(letter);
            }
        }
        letters
    }

    /// The letters of a line for equations in unknowns, which come first with their derivatives as far as these equations
    /// have them.
    pub(crate) fn of_equations<'a>(
        &self,
        unknowns: &[Name],
        sides: impl Iterator<Item = &'a Expr>,
    ) -> Vec<Expr> {
        let used: Vec<_> = sides.flat_map(|side| side.names().free).collect();
        let highest = used.iter().map(|used| used.order).max().unwrap_or(0);
        let mut letters = Vec::new();
        for name in unknowns {
            let orders = (0..=highest).map(|order| Expr::name(name.clone()).prime(order));
            letters.extend(orders);
        }
        let time = Name::new("t");
        let others = self.letters.iter().filter(|name| {
            let is_used = used.iter().any(|used| used.name == **name);
            !unknowns.contains(name) && (is_used || !self.lexicon.is_moving(name))
        });
        letters.extend(others.cloned().map(Expr::name));
        if used.iter().any(|used| used.name == time) {
            letters.push(Expr::name(time));
        }
        letters
    }
}
