//! Symbols before an equals sign: whether they name what is asked, or another quantity of the item.

use super::{AnswerKind, Declare, Known, Role, Unreadable, Why};
use crate::expr::{self, Name, Shape, Type};
use crate::math::symbol;
use crate::quantity::NodeId;
use crate::response::{
    AskedBound, Folded, Label, Lexicon, Manner, Passage, label_behind, label_in_front, parted,
};
use crate::unit::{Dimension, Rational, Unit};

/// Letters of the field that always stand for one thing: a matrix of this letter is that of mass, damping or stiffness.
const MATRICES: [&str; 3] = ["M", "C", "K"];

/// The names that may stand before the equals sign of a response to a part, and those that may not.
#[derive(Debug, Default)]
pub(crate) struct Naming {
    lexicon: Lexicon,
    /// The names of the item that say something else than what is asked.
    others: Vec<Name>,
    /// The names of what is asked.
    asked: Vec<Name>,
    /// Whether what is asked is a rate or a period, of which students write differences.
    is_of_time: bool,
    /// Letters that the item does not know and that say something else by the custom of the field.
    customary: Vec<&'static str>,
    is_formula: bool,
    /// The bound that is asked, where one is.
    bound: Option<AskedBound>,
    /// Whether one value is asked, be it of several components.
    is_one: bool,
    is_matrix: bool,
    is_shape: bool,
    /// Symbols that are not names, `V(π)`, `x₃/x`, `cos θ`: as they can be typed, with the names that stand for them.
    printed: Vec<(Label, Name)>,
}

impl Naming {
    /// The names of an item of which these are asked. Only what students see counts: data, coordinates, and what its
    /// parts ask for, later ones among them.
    pub(crate) fn of(
        declare: &dyn Declare,
        kind: AnswerKind,
        keys: &[NodeId],
        unit: Option<Unit>,
    ) -> Self {
        let is_labelled = matches!(
            kind,
            AnswerKind::Numeric
                | AnswerKind::Integer
                | AnswerKind::Formula
                | AnswerKind::Matrix
                | AnswerKind::ModeShape
        );
        let (true, [key]) = (is_labelled, keys) else {
            return Self::default();
        };
        let known = declare.known();
        let asked: Vec<&Known> = known
            .iter()
            .filter(|own| is_asked(declare, *key, own))
            .collect();
        let unit = unit.or_else(|| declare.unit_of(*key));
        let dimension = declare.graph().kind(*key).and_then(Type::dimension);
        let mut naming = Self {
            customary: customary(kind, &asked, dimension, unit),
            is_formula: kind == AnswerKind::Formula,
            is_one: is_one(kind, declare.graph().kind(*key).map(Type::shape)),
            is_matrix: kind == AnswerKind::Matrix && !asked.is_empty(),
            is_shape: kind == AnswerKind::ModeShape,
            is_of_time: [Dimension::TIME, Dimension::TIME.inverse()]
                .map(Some)
                .contains(&dimension),
            asked: asked.iter().map(|own| own.name.clone()).collect(),
            ..Self::default()
        };
        for own in known.iter().filter(|own| is_seen(own.role)) {
            naming
                .lexicon
                .allow(&own.name, own.symbol.clone(), own.role == Role::Coordinate);
            if !asked.iter().any(|asked| is_same(asked, own))
                && is_other(own, &asked, dimension, kind)
            {
                naming.others.push(own.name.clone());
            }
        }
        // What is asked is no name that was asked before.
        let printed = known
            .iter()
            .filter(|own| is_seen(own.role) || asked.iter().any(|asked| is_same(asked, own)));
        naming.printed = printed
            .filter_map(|own| Some((Label::of_symbol(&own.symbol)?, own.name.clone())))
            .collect();
        for own in asked {
            naming.lexicon.allow(&own.name, own.symbol.clone(), true);
            // Many leave the index out.
            let letter = Name::new(parted(own.name.as_str()).0);
            if !known.iter().any(|known| known.name == letter) && !naming.asked.contains(&letter) {
                naming.lexicon.allow(&letter, symbol(letter.as_str()), true);
                naming.asked.push(letter);
            }
        }
        naming
    }

    /// The same where the bound of a quantity is asked.
    #[must_use]
    pub(crate) fn with_bound(self, bound: Option<AskedBound>) -> Self {
        Self { bound, ..self }
    }

    /// A response with a name in place of the symbol that is asked, where that is printed as no name: `V(π) = 3 J`.
    ///
    /// # Errors
    ///
    /// Where it is such a symbol of another quantity.
    pub(crate) fn named<'t>(&self, response: Folded<'t>) -> Result<Folded<'t>, Unreadable> {
        if self.printed.is_empty() {
            return Ok(response);
        }
        // `-3 J = V(π)`
        if let Some((label, end)) = label_behind(&response)
            && self.printed_name(label)?.is_some()
        {
            return Ok(response.up_to(end));
        }
        let Some((label, end)) = label_in_front(&response) else {
            return Ok(response);
        };
        // `Ė`, which is read as it is, says that it is a rate.
        let is_read =
            |label| self.is_formula && self.reads(label).is_some_and(|own| self.is_asked(&own));
        match self
            .printed_name(label)?
            .filter(|_| !is_read(label))
            .cloned()
        {
            Some(name) => Ok(response.with_name(end, name.as_str())),
            None => Ok(response),
        }
    }

    /// The statement of a response that answers, where the others are of other symbols: `k = 47.7 N/m, K = 2.19 N/m`,
    /// `1.71 s (f = 0.585 Hz)`; and the bound of a range, where that is asked: `k ≤ 47.7 N/m`.
    pub(crate) fn answering<'t>(&self, response: Folded<'t>) -> Folded<'t> {
        let is_name = |side: Passage<'_>| self.is_of_asked(side) || self.is_free_name(side);
        let bound = self.bound.and_then(|bound| response.bound(bound, is_name));
        if let Some(place) = bound {
            return response.part(place);
        }
        if !self.is_one || self.asked.is_empty() {
            return response;
        }
        let is_asked = |label: Passage<'_>| self.is_of_asked(label);
        let place = response
            .answering(is_asked, |label| self.is_printed(label))
            .or_else(|| response.behind_name(is_asked));
        match place {
            Some(place) => response.part(place),
            None => response,
        }
    }

    /// Whether a side is a name that says nothing else than what is asked, `k` for k_max, or its magnitude, `|x|`.
    fn is_free_name(&self, side: Passage<'_>) -> bool {
        let Some(own) = self.reads(side) else {
            return false;
        };
        let own = match own.kind() {
            expr::Kind::Call(expr::Function::Abs, of) if of.len() == 1 => &of[0],
            _ => &own,
        };
        matches!(own.kind(), expr::Kind::Name(name) if !self.others.contains(name))
    }

    /// The name of what is asked, if a label is its printed symbol.
    fn printed_name(&self, label: Passage<'_>) -> Result<Option<&Name>, Unreadable> {
        let typed = Label::of_passage(behind_words(label));
        let of_omega = typed.with_omega();
        // What is asked may be printed as another quantity is that serves its solution.
        let printed = self.printed.iter();
        let same = printed.filter(|(own, _)| *own == typed || of_omega.as_ref() == Some(own));
        let names: Vec<&Name> = same.map(|(_, name)| name).collect();
        match names.iter().find(|name| self.asked.contains(name)) {
            Some(name) => Ok(Some(name)),
            None if names.is_empty() => Ok(None),
            None => Err(Unreadable::at(label, Why::OtherQuantity)),
        }
    }

    /// Checks what stands before the equals signs of the statements of a response.
    ///
    /// # Errors
    ///
    /// Where that names another quantity than the one that is asked.
    pub(crate) fn check(&self, response: Passage<'_>) -> Result<(), Unreadable> {
        let says_nothing = [&self.others, &self.asked]
            .iter()
            .all(|names| names.is_empty());
        if says_nothing && self.customary.is_empty() {
            return Ok(());
        }
        match self
            .labels(response)
            .into_iter()
            .find(|own| self.is_of_another(*own))
        {
            Some(label) => Err(Unreadable::at(label, Why::OtherQuantity)),
            None => Ok(()),
        }
    }

    /// What stands before the equals signs of the statements of a response that may be its answer: a formula may have
    /// other statements beside it that say what its letters are.
    fn labels<'t>(&self, response: Passage<'t>) -> Vec<Passage<'t>> {
        let stated = response.stated(|label| self.is_of_asked(label));
        match stated {
            Ok(stated) if self.is_formula && stated.has_others() => {
                stated.label().into_iter().collect()
            }
            _ => response.labels(),
        }
    }

    /// Whether a symbol before an equals sign is the one that is asked.
    pub(crate) fn is_of_asked(&self, label: Passage<'_>) -> bool {
        let is_name = self
            .reads(label.without_frame())
            .is_some_and(|typed| self.is_asked(&typed));
        is_name || self.is_printed(label)
    }

    /// Whether a symbol is the one that is asked as that is printed, where it is no name.
    fn is_printed(&self, label: Passage<'_>) -> bool {
        matches!(self.printed_name(label), Ok(Some(_)))
    }

    /// Whether a letter of a side may be what is asked, `2 ω`, also where its other letters are not known, or what is
    /// asked has no name.
    pub(crate) fn may_have_asked(&self, side: Passage<'_>) -> bool {
        if self.asked.is_empty() || !has_letters(side) {
            return true;
        }
        let letters = side.letters().into_iter();
        let mut read = letters.filter_map(|letter| self.reads(letter));
        read.any(|letter| self.is_of_key(&letter))
    }

    /// Whether a formula is made of what is asked for, `2 ω`.
    pub(crate) fn is_of_key(&self, formula: &expr::Expr) -> bool {
        let names = formula.names();
        self.asked.iter().any(|asked| names.uses(asked))
    }

    /// The formula in names of the item that a side of a statement is, if names stand in it.
    pub(crate) fn letters(&self, side: Passage<'_>) -> Option<expr::Expr> {
        self.reads(side)
            .filter(|formula| !formula.names().free.is_empty())
    }

    /// The formula that a label is.
    fn reads(&self, label: Passage<'_>) -> Option<expr::Expr> {
        let typed = label.formula(&self.lexicon, Manner::default());
        typed.ok().map(|typed| typed.value)
    }

    fn is_of_another(&self, label: Passage<'_>) -> bool {
        let label = behind_words(label);
        if self.is_of_other_complex(label) || self.is_root_of_asked(label) {
            return true;
        }
        // In `F0/(m2 Ω²)` no unit stands beside a name.
        let bare = if self.reads(label).is_some_and(|own| is_quotient(&own)) {
            label
        } else {
            label.without_frame()
        };
        let formula = self.reads(bare);
        match formula.as_ref().map(expr::Expr::kind) {
            Some(expr::Kind::Name(name)) => {
                self.others.contains(name) && !self.is_letter_of_matrix(bare)
            }
            // `a0 M + a1 K` is a step, `K - ω² M` where K is asked and `K^2` are others.
            Some(kind) if self.is_matrix => {
                !is_sum(kind) || formula.as_ref().is_some_and(|own| self.is_of_key(own))
            }
            // `u^{(2)}` is the shape of that mode.
            Some(expr::Kind::Prime(of, mode)) if self.is_shape => {
                self.is_asked(of) && !self.is_of_mode(u32::from(*mode))
            }
            // `omega'`, which is the damped frequency for some
            Some(expr::Kind::Prime(of, order)) if self.is_asked(of) => {
                *order != 1 || !self.is_damped(of)
            }
            // `T_n`, `K11`
            _ => {
                let mut customary = self.customary.iter();
                customary.any(|letter| bare.has_letter(letter)) || self.is_made_of_asked(bare)
            }
        }
    }

    /// Whether the damped frequency ω_d is asked, and this is its letter alone.
    fn is_damped(&self, letter: &expr::Expr) -> bool {
        let mut asked = self.asked.iter().map(|own| parted(own.as_str()));
        let is_name =
            |own: &str| matches!(letter.kind(), expr::Kind::Name(name) if name.as_str() == own);
        asked.any(|(own, index)| own == "omega" && index == "d" && is_name(own))
    }

    /// Whether a label is the letter of which a power is asked, `ω` where ω² is.
    fn is_root_of_asked(&self, label: Passage<'_>) -> bool {
        let typed = Label::of_passage(label);
        let root = typed.with_omega().unwrap_or(typed);
        let mut asked = self
            .printed
            .iter()
            .filter(|(_, name)| self.asked.contains(name));
        asked.any(|(printed, _)| printed.is_power_of(&root))
    }

    /// Whether a label is a part of a complex number that has the letter of what is asked and another index: `arg Z_m`,
    /// where that of Z_k is asked.
    fn is_of_other_complex(&self, label: Passage<'_>) -> bool {
        let mut letters = self.asked.iter().map(|own| parted(own.as_str()).0);
        let read = label
            .behind_part_of_complex()
            .and_then(|own| self.reads(own));
        read.is_some_and(|own| match own.kind() {
            expr::Kind::Name(name) => {
                let letter = parted(name.as_str()).0;
                self.others.contains(name) && letters.any(|own| own == letter)
            }
            _ => false,
        })
    }

    /// Whether a label is the letter of the matrix that is asked, `K` for K_θ, whatever else has that letter.
    fn is_letter_of_matrix(&self, label: Passage<'_>) -> bool {
        let is_own = |letter: &str| {
            let mut asked = self.asked.iter();
            label.is(letter) && asked.any(|name| name.as_str().starts_with(letter))
        };
        self.is_matrix && MATRICES.into_iter().any(is_own)
    }

    /// Whether what is asked has this number in its name, or none.
    fn is_of_mode(&self, mode: u32) -> bool {
        let mut indices = self.asked.iter().map(|name| parted(name.as_str()).1);
        let numbered = indices.clone().any(|index| !index.is_empty());
        !numbered || indices.any(|index| index.parse() == Ok(mode))
    }

    /// Whether a formula is the name of what is asked alone.
    pub(crate) fn is_asked(&self, expr: &expr::Expr) -> bool {
        matches!(expr.kind(), expr::Kind::Name(name) if self.asked.contains(name))
    }

    /// Whether a label of several words is made of the symbol that is asked: `omega t`, `m omega`, `log omega`, and
    /// `Delta omega` of a rate or a period.
    fn is_made_of_asked(&self, label: Passage<'_>) -> bool {
        let is_asked = |own: Passage<'_>| self.reads(own).is_some_and(|own| self.is_asked(&own));
        if self.is_of_time && label.behind_difference().is_some_and(is_asked) {
            return self.reads(label).is_none_or(|own| !self.is_asked(&own));
        }
        let factors = label.factors();
        let is_factor = |own: &Passage<'_>| {
            let is_name = self
                .reads(*own)
                .is_some_and(|own| matches!(own.kind(), expr::Kind::Name(_)));
            own.is("t") || own.is_logarithm() || is_name && !is_asked(*own)
        };
        factors.len() > 1
            && factors.iter().any(|own| is_asked(*own))
            && factors.iter().all(|own| is_asked(*own) || is_factor(own))
            && factors.iter().any(is_factor)
    }
}

/// A symbol without the words that describe it, `the elongation x2`.
fn behind_words(label: Passage<'_>) -> Passage<'_> {
    let symbol = label.described().filter(|own| !own.is_empty());
    symbol.unwrap_or(label)
}

/// Whether a formula is a sum or a difference.
fn is_sum(formula: &expr::Kind) -> bool {
    use expr::Operator::{Add, Subtract};
    matches!(formula, expr::Kind::Binary(Add | Subtract, ..))
}

/// Whether a formula is a quotient of several names, `m2/m1`.
fn is_quotient(formula: &expr::Expr) -> bool {
    let is_divided = matches!(
        formula.kind(),
        expr::Kind::Binary(expr::Operator::Divide, ..)
    );
    is_divided && formula.names().free.len() > 1
}

/// Whether a side has more than one letter: one alone may be one's own for what is asked, `2 ω`.
pub(crate) fn has_letters(side: Passage<'_>) -> bool {
    let letters = side.letters();
    letters
        .first()
        .is_some_and(|first| letters.iter().any(|other| !other.is(&first.to_string())))
}

/// Whether a part asks for one value, of which a response may say others beside it.
pub(crate) fn is_one(kind: AnswerKind, shape: Option<Shape>) -> bool {
    match kind {
        AnswerKind::Numeric => shape == Some(Shape::Scalar),
        AnswerKind::ModeShape => matches!(shape, Some(Shape::Vector(_))),
        AnswerKind::Integer | AnswerKind::Matrix => true,
        _ => false,
    }
}

/// Whether a name is that of the key, or of one of the entries that it lists.
pub(crate) fn is_asked(declare: &dyn Declare, key: NodeId, own: &Known) -> bool {
    let (Role::Parameter { node, .. } | Role::Quantity { node, .. }) = own.role else {
        return false;
    };
    let is_name =
        |expr: &expr::Expr| matches!(expr.kind(), expr::Kind::Name(name) if *name == own.name);
    node == key
        || declare
            .graph()
            .expr(key)
            .is_some_and(|expr| match expr.kind() {
                expr::Kind::Array(entries) => entries.iter().any(is_name),
                _ => is_name(expr),
            })
}

/// Whether students see a name: not those that only the item computes with.
pub(crate) fn is_seen(role: Role) -> bool {
    match role {
        Role::Parameter { .. } | Role::Coordinate => true,
        Role::Quantity { is_asked, .. } => is_asked,
        Role::Symbol => false,
    }
}

fn is_same(one: &Known, other: &Known) -> bool {
    one.name == other.name || one.symbol == other.symbol
}

/// Whether a name says something else than what is asked. The letter of what is asked without an index does not: many
/// write `k` for k_eq and ω for ω_d. With the index of another quantity, `ω_n`, it does. A datum may be asked for as well:
/// `v0 = …` of the least start.
fn is_other(own: &Known, asked: &[&Known], dimension: Option<Dimension>, kind: AnswerKind) -> bool {
    let (letter, index) = parted(own.name.as_str());
    let mut names = asked.iter().map(|asked| parted(asked.name.as_str()));
    // `E_1 = 5 J` is said of E_1(0).
    let is_of_it = |asked: &&Known| {
        let symbol = asked.symbol.plain();
        let argument = symbol.strip_prefix(&own.symbol.plain());
        argument.is_some_and(|argument| argument.starts_with('('))
    };
    if matches!(own.role, Role::Quantity { .. }) && asked.iter().any(is_of_it) {
        return false;
    }
    if let Some((_, of_asked)) = names.find(|asked| asked.0 == letter) {
        if matches!(own.role, Role::Quantity { .. }) {
            // `Z_L = 85 Ω` is said of its modulus, too.
            let rest = of_asked.strip_prefix(index);
            let is_part = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'));
            return !index.is_empty() && !is_part;
        }
        // `ω_1` is not ω_2.
        let is_number = |index: &str| index.parse::<u32>().is_ok_and(|number| number > 0);
        return is_number(index) && is_number(of_asked) && index != of_asked;
    }
    // Components have the symbols of their coordinates.
    if kind == AnswerKind::ModeShape {
        return false;
    }
    if own.kind.dimension() != dimension || own.kind.shape() != Shape::Scalar {
        return true;
    }
    matches!(own.role, Role::Parameter { .. }) && !asked.is_empty()
}

/// The letters that name something else than what is asked by the custom of the field, also where the item has no such
/// letter: a period or a frequency for an angular frequency, one matrix of a model for another.
fn customary(
    kind: AnswerKind,
    asked: &[&Known],
    dimension: Option<Dimension>,
    unit: Option<Unit>,
) -> Vec<&'static str> {
    let is_rate = dimension == Some(Dimension::TIME.inverse());
    let is_angular =
        unit.is_some_and(|unit| !unit.counts_cycles() && unit.angles() == Some(Rational::ONE));
    match kind {
        AnswerKind::Matrix => {
            let is_own = |letter: &&&str| {
                asked
                    .iter()
                    .any(|own| parted(own.name.as_str()).0 == **letter)
            };
            let others = MATRICES
                .iter()
                .filter(|letter| !asked.is_empty() && !is_own(letter));
            others.copied().collect()
        }
        // An electrical impedance is neither an admittance nor one of its own two parts.
        _ if unit.is_some_and(|unit| unit.has_factor("ohm"))
            && asked.iter().any(|own| parted(own.name.as_str()).0 == "Z") =>
        {
            vec!["Y", "R", "X"]
        }
        _ if is_rate && is_angular => vec!["T", "f"],
        _ if is_rate => vec!["T"],
        _ if dimension == Some(Dimension::TIME) => vec!["f"],
        _ => Vec::new(),
    }
}
