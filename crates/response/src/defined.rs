//! What the statements of a response say that letters are, `ζ = λ/ω_n with ω_n = √(k/m)`, and formulas with these in
//! their place.

use super::arguments::{is_initial_state, without_arguments};
use super::customary::{DAMPING_RATIOS, DECAY_RATES, RATES, of_textbooks};
use super::differential::spelling;
use super::list::{cut_where, trimmed};
use super::sides::is_word;
use super::signs::{is_apostrophe, is_digit, is_of_word};
use super::statements::{is_approximation, moved, statements};
use super::{
    Chain, Lexicon, Manner, Passage, Trouble, Typed, TypedError, formula_at, letters, sides,
};
use vibank_formula::expr::{Expr, Function, Kind, Name, Operator, Substitution};
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// What defines the letters of equations that the question does not have, beside the custom of the field.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Defining {
    /// Other statements.
    Statements,
    /// Other statements, of letters of the question, too.
    Anew,
    /// Textbooks, of the natural frequency, the damping ratio and the decay rate.
    Textbooks,
}

/// What a statement says that a letter is.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    pub(crate) name: Name,
    /// Its primes.
    pub(crate) order: u8,
    /// Whether it is said of its square, `ω_n² = k/m`.
    pub(crate) is_square: bool,
    /// By what it is multiplied, `2λ = c/m`.
    pub(crate) factor: Option<Expr>,
    /// Whether the lexicon has the letter.
    pub(crate) is_known: bool,
    /// Whether the question has it, be it that the answer may not use it.
    pub(crate) is_of_question: bool,
    /// What may be its value, the nearest to the letter first.
    pub(crate) values: Vec<Span>,
    /// What it is by the custom of the field.
    pub(crate) formula: Option<Expr>,
}

impl Definition {
    /// Of a letter that the question does not have, by the custom of the field.
    fn of_custom(letter: &str, formula: Expr) -> Self {
        Self {
            name: Name::new(letter),
            order: 0,
            is_square: false,
            factor: None,
            is_known: false,
            is_of_question: false,
            values: Vec::new(),
            formula: Some(formula),
        }
    }
}

/// A letter before or after an equals sign.
pub(crate) struct Letter {
    pub(crate) name: Name,
    pub(crate) order: u8,
    pub(crate) is_square: bool,
    pub(crate) is_known: bool,
    pub(crate) is_of_question: bool,
}

/// What a statement beside others says.
pub(crate) enum Said {
    /// What a letter is.
    Letter(Definition),
    /// Which value a letter of the question has.
    Value(Definition),
    /// In words what a letter means.
    Nothing,
    /// More.
    Equation,
}

/// What a statement says; of equations also what a product of letters, `me`, is as a letter of its own.
pub(crate) fn said(text: &str, statement: Span, lexicon: &Lexicon, may_be_product: bool) -> Said {
    let start = statement.range().start;
    let text = &text[statement.range()];
    let mut sides = sides::equal_sides(text);
    if sides.len() < 2 {
        return Said::Equation;
    }
    let read = |side: Option<&Span>, may_be_product| {
        side.and_then(|side| letter(&text[side.range()], lexicon, may_be_product))
    };
    let multiple = sides
        .first()
        .and_then(|side| multiple(&text[side.range()], lexicon));
    let (factor, multiplied) = multiple.unzip();
    // What a letter is, `k = ρgS`, is no letter of its own.
    let (first, last) = (
        multiplied
            .or_else(|| read(sides.first(), may_be_product))
            .or_else(|| redefined_constant(text, &sides, lexicon)),
        read(sides.last(), false),
    );
    let letter = match (first, last) {
        // `θ' = ω`
        (first, Some(last)) if !last.is_known && first.as_ref().is_none_or(|own| own.is_known) => {
            sides.pop();
            sides.reverse();
            last
        }
        (Some(first), _) => {
            sides.remove(0);
            first
        }
        (None, _) => return Said::Equation,
    };
    let mut texts = sides.iter().map(|side| text[side.range()].trim());
    if texts.clone().any(|side| sides::described(side) == Some("")) {
        return Said::Nothing;
    }
    let is_datum = letter.is_known && !lexicon.is_moving(&letter.name);
    let has_value = is_datum && texts.any(|side| is_value(side, lexicon));
    let definition = Definition {
        name: letter.name,
        order: letter.order,
        is_square: letter.is_square,
        factor,
        is_known: letter.is_known,
        is_of_question: letter.is_of_question,
        values: sides.into_iter().map(|side| moved(side, start)).collect(),
        formula: None,
    };
    if has_value {
        Said::Value(definition)
    } else {
        Said::Letter(definition)
    }
}

/// The letter of which a multiple is said, `2λ = c/m`, `2ζω_n = c/m`, after what it is multiplied by.
fn multiple(side: &str, lexicon: &Lexicon) -> Option<(Expr, Letter)> {
    let own = |text: &str| letter(text, lexicon, false).filter(|own| !own.is_known);
    let (factor, rest) = factor_before(side).unwrap_or((1, side));
    let with_ratio = || {
        let slash = usize::from(rest.starts_with('\\'));
        let (length, name) = letters::letter(&rest[slash..])?;
        let length = slash + length;
        let ratio = own(&rest[..length]).filter(|_| DAMPING_RATIOS.contains(&name.as_str()))?;
        let other = rest[length..].trim_start_matches([' ', '*']);
        let other = letter(other, lexicon, false)?;
        let is_plain = other.order == 0 && !other.is_square;
        is_plain.then(|| (Expr::number(factor) * Expr::name(other.name), ratio))
    };
    with_ratio().or_else(|| {
        let is_multiplied = rest.len() < side.len();
        is_multiplied.then(|| own(rest).map(|own| (Expr::number(factor), own)))?
    })
}

/// The integer before a letter, and what comes after it: `2λ`, `2*λ`.
fn factor_before(side: &str) -> Option<(i32, &str)> {
    let rest = side.trim_start_matches(is_digit);
    let factor = side[..side.len() - rest.len()].parse().ok()?;
    let rest = rest.trim_start();
    let rest = rest.strip_prefix('*').map_or(rest, str::trim_start);
    (factor > 0).then_some((factor, rest))
}

/// The equations among the statements of a text, in which other statements or the custom of the field say what letters
/// are that the lexicon does not have: `m a + k x = 0 with a = x''`, `m dv/dt = -k x`. None where nothing is said.
///
/// # Errors
///
/// What cannot be read.
pub(crate) fn defined_chains(
    text: &str,
    lexicon: &Lexicon,
    manner: Manner,
    defining: Defining,
) -> Option<Result<Vec<Typed<Chain>>, TypedError>> {
    let may_redefine = defining == Defining::Anew;
    let mut all = statements(text);
    all.retain(|own| !is_approximation(&text[own.range()]));
    if let [first, _, ..] = all[..]
        && !text[first.range()].contains(|char| !is_of_word(char) && !" .".contains(char))
    {
        all.remove(0);
    }
    let is_one = all.len() == 1;
    let (mut equations, mut definitions, mut coordinates) = (Vec::new(), Vec::new(), Vec::new());
    for statement in all {
        // `F = m a: -k x = m x''`
        let statement = behind_colon(text, statement);
        // The state at the start says nothing of the motion.
        if !equations.is_empty() && is_initial_state(&text[statement.range()]) {
            continue;
        }
        match said(text, statement, lexicon, may_redefine) {
            Said::Letter(own) if !(own.is_known && lexicon.is_moving(&own.name)) => {
                definitions.push((own, statement));
            }
            Said::Letter(own) if may_redefine && own.order == 0 => {
                coordinates.push((own, statement));
            }
            Said::Nothing | Said::Value(_) => {}
            Said::Letter(_) | Said::Equation => equations.push(statement),
        }
    }
    // `m x3'' + k z = 0, z = x3 - x2`; alone it is an equation.
    if equations.is_empty() {
        equations.extend(coordinates.into_iter().map(|(_, statement)| statement));
    } else {
        definitions.append(&mut coordinates);
    }
    // `a = -k/m x`
    if equations.is_empty() {
        let (_, first) = definitions.first()?;
        equations.push(*first);
        definitions.remove(0);
    }
    // `x2 + y2 = l2` may be an equation of its own.
    let behind = definitions.iter().filter(|(own, statement)| {
        let start = statement.range().start;
        own.values.iter().any(|value| value.range().start == start)
    });
    let behind: Vec<Name> = behind.map(|(own, _)| own.name.clone()).collect();
    let mut definitions: Vec<Definition> = definitions.into_iter().map(|(own, _)| own).collect();
    let mut customary = customary(lexicon);
    if defining == Defining::Textbooks {
        let read = |formula: &str| Some(super::formula(formula, lexicon, manner).ok()?.value);
        let open = of_textbooks(text, read).into_iter();
        customary.extend(open.map(|(symbol, formula)| Definition::of_custom(symbol, formula)));
    }
    let customary: Vec<Definition> = customary
        .into_iter()
        .filter(|own| definitions.iter().all(|other| other.name != own.name))
        .collect();
    definitions.extend(customary);
    let whole = Span::new(0, text.trim_end().len());
    if definitions.is_empty() && is_one && equations.iter().all(|own| *own == whole) {
        return None;
    }
    let defined = Defined::of(text, definitions, lexicon, manner);
    let unread = defined.all.iter().find_map(|(own, value)| match value {
        Some(Err(error)) if behind.contains(&own.name) => Some(error.clone()),
        _ => None,
    });
    if let Some(error) = unread {
        return Some(Err(error));
    }
    let chains = equations.into_iter().map(|equation| {
        let place = equation.range();
        let typed = super::chain(text, place.start, place.end, &defined.lexicon, manner)?;
        let all = [typed.value].into_iter().chain(typed.others);
        let compared = all.map(|chain| Expr::derived(Kind::Compare(chain.sides, chain.relations)));
        let readings = defined.readings(compared)?.into_iter();
        let mut chains = readings.filter_map(|compared| match compared.kind() {
            Kind::Compare(sides, relations) => Some(Chain {
                sides: sides.clone(),
                relations: relations.clone(),
            }),
            _ => None,
        });
        let missing = TypedError::new(Trouble::Missing, place.start, place.end);
        let value = chains.next().ok_or(missing)?;
        Ok(Typed {
            value,
            others: chains.collect(),
        })
    });
    Some(chains.collect())
}

/// A statement without what its colon says of it, `Newton: m x'' = -k x`; `for x' > 0: …` says it of a part of the motion.
fn behind_colon(text: &str, statement: Span) -> Span {
    let pieces = cut_where(text, statement, |_, char| char == ':');
    let last = pieces.last().copied().unwrap_or(statement);
    let is_equation = text[last.range()]
        .trim_start()
        .starts_with(|first| first != '=')
        && text[last.range()].contains('=');
    let before = &text[statement.range().start..last.range().start];
    if is_equation && !before.contains(['<', '>', '≤', '≥']) {
        trimmed(text, last)
    } else {
        statement
    }
}

/// Letters that the lexicon does not have and that stand for rates of its coordinate by the custom of the field.
fn customary(lexicon: &Lexicon) -> Vec<Definition> {
    let mut found = Vec::new();
    for (coordinates, rates) in RATES {
        let moving = lexicon.moving_names();
        let mut own = moving.filter(|name| coordinates.contains(&name.as_str()));
        let Some(coordinate) = own.next() else {
            continue;
        };
        if own.any(|other| other != coordinate) {
            continue;
        }
        let free = rates.iter().filter(|(letter, _)| {
            lexicon.reads(letter).is_none() && lexicon.forbidden(letter).is_none()
        });
        found.extend(free.map(|(letter, order)| {
            Definition::of_custom(letter, Expr::name(coordinate.clone()).prime(*order))
        }));
    }
    found
}

/// A definition with its value as it was read; none where only the letter itself is said.
type ReadDefinition = (Definition, Option<Result<Typed<Expr>, TypedError>>);

/// Definitions with the lexicon that has their letters, and their values as they were read.
pub(crate) struct Defined {
    pub(crate) lexicon: Lexicon,
    pub(crate) all: Vec<ReadDefinition>,
}

impl Defined {
    fn of(text: &str, definitions: Vec<Definition>, lexicon: &Lexicon, manner: Manner) -> Self {
        Self::measured(text, definitions, lexicon, manner, &|_| None)
    }

    /// The same where values may have units that `measure` reads.
    pub(crate) fn measured(
        text: &str,
        definitions: Vec<Definition>,
        lexicon: &Lexicon,
        manner: Manner,
        measure: &dyn Fn(Passage<'_>) -> Option<Expr>,
    ) -> Self {
        let unknown = definitions.iter().filter(|own| !own.is_known);
        let lexicon = lexicon.with_moving(unknown.map(|own| own.name.clone()));
        let exact = |value: Expr| Typed {
            value,
            others: Vec::new(),
        };
        let value = |own: &Definition| match &own.formula {
            Some(formula) => Some(Ok(exact(formula.clone()))),
            None => {
                let read = |place: &Span| {
                    let range = place.range();
                    // Letters behind a number are its unit: `x0 = 0.0465 m`.
                    let own = Passage::of(&text[range.clone()]);
                    let measured = begins_value(own.text(), &lexicon)
                        .then(|| measure(own))
                        .flatten();
                    measured.map_or_else(
                        || formula_at(text, range.start, range.end, &lexicon, manner),
                        |value| Ok(exact(value)),
                    )
                };
                own.values.iter().map(read).reduce(Result::or)
            }
        };
        let all: Vec<_> = definitions
            .into_iter()
            .map(|own| {
                let value = value(&own);
                (own, value)
            })
            .collect();
        Self { lexicon, all }
    }

    /// The readings of formulas with their letters as they are defined.
    pub(crate) fn readings(
        &self,
        all: impl Iterator<Item = Expr>,
    ) -> Result<Vec<Expr>, TypedError> {
        let mut readings = Vec::new();
        for expr in all {
            readings.extend(substituted(&expr, &self.all, &self.lexicon)?);
        }
        Ok(readings)
    }
}

/// Whether a text is a number with a unit or without.
fn is_value(text: &str, lexicon: &Lexicon) -> bool {
    let unit = text.trim_start_matches(|char| is_digit(char) || "-+.,*^ ".contains(char));
    begins_value(text, lexicon) && (unit.is_empty() || Unit::read(unit).is_ok())
}

/// Whether a text begins as a number does. One over letters of the question, `1/(L C)`, is a formula.
fn begins_value(text: &str, lexicon: &Lexicon) -> bool {
    let divisor = text
        .trim_start_matches(is_digit)
        .trim_start()
        .strip_prefix('/');
    let is_formula = divisor.is_some_and(|divisor| {
        !divisor.trim_start().starts_with(is_digit)
            && super::formula(text, lexicon, Manner::default()).is_ok()
    });
    !is_formula && text.starts_with(|first: char| first.is_ascii_digit() || "-.".contains(first))
}

/// The letter that a text is, or its square.
pub(crate) fn letter(text: &str, lexicon: &Lexicon, may_be_product: bool) -> Option<Letter> {
    let text = without_arguments(text.trim_matches(['$', ' ']));
    let squared = ["^2", "²", "^{2}"]
        .iter()
        .find_map(|square| text.strip_suffix(square));
    let word = squared.unwrap_or(text).trim_end();
    if let Ok(typed) = super::formula(word, lexicon, Manner::default()) {
        let (inner, order) = match typed.value.kind() {
            Kind::Prime(inner, order) => (inner.kind(), *order),
            kind => (kind, 0),
        };
        // `me` is a letter of its own where something is said of it.
        let is_product = matches!(inner, Kind::Binary(Operator::Multiply, ..));
        // Of λ more can be said than that it is ζ ω_n.
        let is_own = may_be_product
            || DECAY_RATES
                .iter()
                .any(|own| spelling(word).as_deref() == Some(own));
        if is_own && is_product && order == 0 && is_word(word) {
            return own_letter(word, lexicon, squared.is_some());
        }
        let Kind::Name(name) = inner else { return None };
        // `v` stands for ẋ where nothing else is said of it.
        let is_rate = |letter| word.starts_with(letter) && !name.as_str().starts_with(letter);
        if order == 0 || !['v', 'a'].into_iter().any(is_rate) {
            return Some(Letter {
                name: name.clone(),
                order,
                is_square: squared.is_some(),
                is_known: true,
                is_of_question: true,
            });
        }
    }
    own_letter(word, lexicon, squared.is_some())
}

/// The letter of a constant that is said to be something else than its value, `e = ε`.
fn redefined_constant(text: &str, sides: &[Span], lexicon: &Lexicon) -> Option<Letter> {
    let (first, others) = sides.split_first()?;
    let word = text[first.range()].trim();
    let typed = super::formula(word, lexicon, Manner::default()).ok()?;
    let is_value = |side: &Span| is_value(text[side.range()].trim(), lexicon);
    let is_other = matches!(typed.value.kind(), Kind::Constant(_)) && !others.iter().any(is_value);
    is_other.then(|| own_letter(word, lexicon, false))?
}

/// A letter that the lexicon does not have, with its primes.
fn own_letter(word: &str, lexicon: &Lexicon, is_square: bool) -> Option<Letter> {
    let bare = word.trim_end_matches(|last: char| last == '\'' || is_apostrophe(last));
    let order = word[bare.len()..].chars().count();
    if !is_word(bare) || sides::begins_with_function(bare) {
        return None;
    }
    let spelling = spelling(bare)?;
    let of_question = lexicon.forbidden(&spelling);
    Some(Letter {
        is_of_question: of_question.is_some(),
        name: of_question
            .cloned()
            .unwrap_or_else(|| Name::new(spelling.as_str())),
        order: u8::try_from(order).ok()?,
        is_square,
        is_known: false,
    })
}

/// A formula with the letters as they are defined, in all readings of what they are.
fn substituted(
    expr: &Expr,
    definitions: &[ReadDefinition],
    lexicon: &Lexicon,
) -> Result<Vec<Expr>, TypedError> {
    /// Readings of a formula with its definitions; those of the rules come first.
    const MAX_READINGS: usize = 16;
    let mut readings = vec![expr.clone()];
    // A definition may use the others, but none itself.
    for _ in 0..=definitions.len() {
        let mut is_done = true;
        for (definition, value) in definitions {
            let mut used = readings.iter().flat_map(|expr| expr.names().free);
            if !used.any(|own| own.name == definition.name && own.order >= definition.order) {
                continue;
            }
            is_done = false;
            let typed = match value {
                Some(Ok(typed)) => typed,
                Some(Err(error)) => return Err(error.clone()),
                None => continue,
            };
            let values = [&typed.value].into_iter().chain(&typed.others);
            let values: Vec<Expr> = values.map(|value| definition.value_of(value)).collect();
            let all = readings.iter().flat_map(|expr| {
                let values = values.iter();
                values.filter_map(|value| definition.put(expr, value, lexicon))
            });
            readings = all.take(MAX_READINGS).collect();
        }
        if is_done {
            return Ok(readings);
        }
    }
    let place = definitions.iter().find_map(|(own, _)| own.values.first());
    let place = place.map_or(0..0, |place| place.range());
    Err(TypedError::new(Trouble::List, place.start, place.end))
}

impl Definition {
    /// The letter by what is said of it, of its square or of a multiple.
    fn value_of(&self, value: &Expr) -> Expr {
        let value = match &self.factor {
            None => value.clone(),
            Some(factor) => value.clone() / factor.clone(),
        };
        if self.is_square {
            return Expr::derived(Kind::Call(Function::Sqrt, vec![value]));
        }
        value
    }

    /// A formula with the value in place of the letter.
    fn put(&self, expr: &Expr, value: &Expr, lexicon: &Lexicon) -> Option<Expr> {
        let put = Substitution::moving(lexicon.moving_names().cloned());
        if self.order == 0 {
            return put.with(self.name.clone(), value.clone()).apply(expr).ok();
        }
        self.put_primed(expr, value, lexicon)
    }

    /// A formula with the value in place of the primed letter.
    fn put_primed(&self, expr: &Expr, value: &Expr, lexicon: &Lexicon) -> Option<Expr> {
        if let Kind::Prime(inner, order) = expr.kind()
            && matches!(inner.kind(), Kind::Name(name) if *name == self.name)
            && *order >= self.order
        {
            let rest = order - self.order;
            let marked = Name::new("=");
            let put = Substitution::moving(lexicon.moving_names().cloned())
                .with(marked.clone(), value.clone());
            return put.apply(&Expr::name(marked).prime(rest)).ok();
        }
        let mut is_whole = true;
        let mapped = expr.try_map_children(&mut |child| {
            let own = self.put_primed(child, value, lexicon);
            is_whole &= own.is_some();
            Ok::<_, std::convert::Infallible>(own.unwrap_or_else(|| child.clone()))
        });
        mapped.ok().filter(|_| is_whole)
    }
}
