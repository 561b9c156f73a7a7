//! What a response says in several statements: the one that counts, and what it says that other letters are,
//! `ζ = λ/ω_n with ω_n = √(k/m)`.

use super::differential::{leibniz, spelling};
use super::equations::is_initial_state;
use super::letters::{combining, is_dotted};
use super::list::{cut_where, trimmed};
use super::sides::{is_word, last_side, without_arguments};
use super::signs::is_apostrophe;
use super::words::{RATES, STATEMENTS};
use super::{Chain, Lexicon, Manner, Passage, Trouble, Typed, TypedError, formula_at, sides};
use vibank_formula::expr::{Expr, Function, Kind, Name, Operator, Substitution};
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// The statements of a response: the one that answers, and the others.
#[derive(Clone)]
pub struct Stated<'t> {
    text: &'t str,
    main: Span,
    others: Vec<Span>,
    measure: &'t dyn Fn(Passage<'_>) -> Option<Expr>,
}

/// What a statement says that a letter is.
#[derive(Clone, Debug)]
struct Definition {
    name: Name,
    /// Its primes.
    order: u8,
    /// Whether it is said of its square, `ω_n² = k/m`.
    is_square: bool,
    /// Whether the lexicon has the letter.
    is_known: bool,
    /// Whether the question has it, be it that the answer may not use it.
    is_of_question: bool,
    /// What may be its value, the nearest to the letter first.
    values: Vec<Span>,
    /// What it is by the custom of the field.
    formula: Option<Expr>,
}

/// A letter before or after an equals sign.
struct Letter {
    name: Name,
    order: u8,
    is_square: bool,
    is_known: bool,
    is_of_question: bool,
}

impl<'t> Stated<'t> {
    /// The statements of a text; that which `answers`, by what stands before its first equals sign, counts, and the first
    /// one where it has no equals sign.
    ///
    /// # Errors
    ///
    /// Where it is not clear which of them counts.
    pub(crate) fn of(
        text: &'t str,
        answers: impl Fn(Passage<'t>) -> bool,
    ) -> Result<Self, TypedError> {
        let all = statements(text);
        let single = |main| Self {
            text,
            main,
            others: Vec::new(),
            measure: &|_| None,
        };
        let [first, .., last] = all[..] else {
            return Ok(single(all.first().copied().unwrap_or_default()));
        };
        let label = |statement: &Span| label(text, *statement);
        let answering: Vec<Span> = all
            .iter()
            .copied()
            .filter(|own| {
                label(own).is_some_and(|label| answers(Passage::of(&text[label.range()])))
            })
            .collect();
        // Of `ω_d = …, ω = …` the whole name says more than its letter.
        let worth = |own: &Span| {
            let label = label(own).map_or("", |label| &text[label.range()]);
            (!label.starts_with('|'), label.chars().count())
        };
        let most = answering.iter().map(worth).max();
        let answering: Vec<Span> = answering
            .into_iter()
            .filter(|own| Some(worth(own)) == most)
            .collect();
        let main = match answering[..] {
            [.., last] => last,
            [] if label(&first).is_none() => first,
            [] => {
                // A letter that no other statement makes use of.
                let is_used = |own: &Span| {
                    let word = label(own).map_or("", |label| &text[label.range()]);
                    let mut others = all.iter().filter(|other| *other != own);
                    !is_word(word) || others.any(|other| text[other.range()].contains(word))
                };
                let mut unused = all.iter().filter(|own| !is_used(own));
                // `V(x) = …; V(0) = …`
                let bare = |own: &Span| {
                    let label = label(own)?;
                    Some(without_arguments(&text[label.range()]))
                };
                let is_one = || all.iter().all(|own| bare(own) == bare(&first));
                match (unused.next(), unused.next()) {
                    (Some(main), None) => *main,
                    _ if is_one() => last,
                    _ => {
                        let range = last.range();
                        return Err(TypedError::new(Trouble::List, range.start, range.end));
                    }
                }
            }
        };
        Ok(Self {
            others: all.into_iter().filter(|own| *own != main).collect(),
            ..single(main)
        })
    }

    /// The same where letters may have values with units, which this reads.
    #[must_use]
    pub fn measured_by(self, measure: &'t dyn Fn(Passage<'_>) -> Option<Expr>) -> Self {
        Self { measure, ..self }
    }

    /// What stands before the equals sign of the statement that counts.
    pub fn label(&self) -> Option<Passage<'t>> {
        label(self.text, self.main).map(|label| Passage::of(&self.text[label.range()]))
    }

    /// The sides of the statement that counts, its symbol among them.
    pub fn pieces(&self) -> Vec<Passage<'t>> {
        let main = &self.text[self.main.range()];
        sides::statement(main)
            .into_iter()
            .map(Passage::of)
            .collect()
    }

    /// Whether there is more than one statement.
    pub fn has_others(&self) -> bool {
        !self.others.is_empty()
    }

    /// The formula that its symbol is said to be, its other letters as they are defined.
    ///
    /// # Errors
    ///
    /// What cannot be read.
    pub fn formula(&self, lexicon: &Lexicon, manner: Manner) -> Result<Typed<Expr>, TypedError> {
        let sides = self.sides(lexicon)?;
        let last = sides.last().copied().unwrap_or(self.main);
        self.side(last, lexicon, manner)
    }

    /// The other sides of the statement that counts, and those of statements of the same symbol, that can be read.
    pub fn other_forms(&self, lexicon: &Lexicon, manner: Manner) -> Vec<Typed<Expr>> {
        let mut sides = self.sides(lexicon).unwrap_or_default();
        sides.pop();
        let name = self.label().map(|label| label.text());
        let rivals = self.others.iter().filter(|other| {
            let own = label(self.text, **other).map(|label| &self.text[label.range()]);
            own.is_some() && own == name
        });
        sides.extend(rivals.map(|rival| {
            let last = last_side(&self.text[rival.range()]).range();
            let start = rival.range().start;
            Span::new(start + last.start, start + last.end)
        }));
        let read = |side: Span| self.side(side, lexicon, manner).ok();
        let mut forms: Vec<Typed<Expr>> = sides.into_iter().filter_map(read).collect();
        // What is said of a letter that the question has must be true: without it the answer is the same.
        let definitions = self.definitions(lexicon);
        let last = self
            .sides(lexicon)
            .ok()
            .and_then(|sides| sides.last().copied());
        if let Some(last) = last.filter(|_| definitions.iter().any(|own| own.is_of_question)) {
            let (of_question, own): (Vec<_>, Vec<_>) =
                definitions.into_iter().partition(|own| own.is_of_question);
            let names = of_question.into_iter().filter(|own| !own.is_known);
            let wider = lexicon.with_moving(names.map(|own| own.name));
            forms.extend(self.side_with(own, last, &wider, manner));
        }
        forms
    }

    /// All sides of a statement without its symbol, `½ I θ'² = ½ m l² θ'²`, the last one last.
    ///
    /// # Errors
    ///
    /// What cannot be read.
    pub fn all_forms(
        &self,
        lexicon: &Lexicon,
        manner: Manner,
    ) -> Result<Vec<Typed<Expr>>, TypedError> {
        let sides = sides::equal_sides(&self.text[self.main.range()]).into_iter();
        let place = |side: Span| moved(side, self.main.range().start);
        sides
            .map(|side| self.side(place(side), lexicon, manner))
            .collect()
    }

    /// What the statement that counts says that its symbol is, the last side last.
    fn sides(&self, lexicon: &Lexicon) -> Result<Vec<Span>, TypedError> {
        let start = self.main.range().start;
        let sides = sides::sides(&self.text[self.main.range()], lexicon);
        let sides = sides.map_err(|error| TypedError {
            span: moved(error.span, start),
            ..error
        })?;
        let mut sides: Vec<Span> = sides.into_iter().map(|side| moved(side, start)).collect();
        // `dE/dt = m x' x'' + k x x' = 0` says of the rate that it is zero as well.
        let is_zero = |side: &Span| self.text[side.range()].trim() == "0";
        let is_of_rate = || self.label().is_some_and(|label| is_rate(label.text()));
        if sides.len() > 1 && sides.last().is_some_and(is_zero) && is_of_rate() {
            sides.pop();
        }
        Ok(sides)
    }

    fn side(
        &self,
        side: Span,
        lexicon: &Lexicon,
        manner: Manner,
    ) -> Result<Typed<Expr>, TypedError> {
        self.side_with(self.definitions(lexicon), side, lexicon, manner)
    }

    /// A side with its letters as these say.
    fn side_with(
        &self,
        definitions: Vec<Definition>,
        side: Span,
        lexicon: &Lexicon,
        manner: Manner,
    ) -> Result<Typed<Expr>, TypedError> {
        let place = side.range();
        let read =
            |lexicon: &Lexicon| formula_at(self.text, place.start, place.end, lexicon, manner);
        if definitions.is_empty() {
            return read(lexicon);
        }
        let defined = Defined::measured(self.text, definitions, lexicon, manner, self.measure);
        let typed = read(&defined.lexicon)?;
        let all = [typed.value].into_iter().chain(typed.others);
        let mut readings = defined.readings(all)?.into_iter();
        let missing = TypedError::new(Trouble::Missing, place.start, place.end);
        let value = readings.next().ok_or(missing)?;
        Ok(Typed {
            value,
            others: readings.collect(),
        })
    }

    /// What the other statements say that letters are.
    fn definitions(&self, lexicon: &Lexicon) -> Vec<Definition> {
        let own = self
            .label()
            .and_then(|label| letter(label.text(), lexicon, false));
        let is_of_answer = |name: &Name| own.as_ref().is_some_and(|own| own.name == *name);
        let said = self
            .others
            .iter()
            .map(|other| said(self.text, *other, lexicon, false));
        let found = said.filter_map(|said| match said {
            Said::Letter(definition) => Some(definition),
            Said::Equation | Said::Nothing => None,
        });
        found.filter(|own| !is_of_answer(&own.name)).collect()
    }
}

/// What a statement beside others says.
enum Said {
    /// What a letter is.
    Letter(Definition),
    /// In words what a letter means, or its value.
    Nothing,
    /// More.
    Equation,
}

/// What a statement says; of equations also what a product of letters, `me`, is as a letter of its own.
fn said(text: &str, statement: Span, lexicon: &Lexicon, may_be_product: bool) -> Said {
    let start = statement.range().start;
    let text = &text[statement.range()];
    let mut sides = sides::equal_sides(text);
    if sides.len() < 2 {
        return Said::Equation;
    }
    let read = |side: Option<&Span>| {
        side.and_then(|side| letter(&text[side.range()], lexicon, may_be_product))
    };
    let (first, last) = (read(sides.first()), read(sides.last()));
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
    let says_nothing = |side: &Span| {
        let side = text[side.range()].trim();
        sides::described(side) == Some("")
            || letter.is_known && !lexicon.is_moving(&letter.name) && is_value(side)
    };
    if sides.iter().any(says_nothing) {
        return Said::Nothing;
    }
    Said::Letter(Definition {
        name: letter.name,
        order: letter.order,
        is_square: letter.is_square,
        is_known: letter.is_known,
        is_of_question: letter.is_of_question,
        values: sides.into_iter().map(|side| moved(side, start)).collect(),
        formula: None,
    })
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
    may_redefine: bool,
) -> Option<Result<Vec<Typed<Chain>>, TypedError>> {
    let mut all = statements(text);
    let is_of_words =
        |char: char| char.is_alphabetic() || is_apostrophe(char) || " -.".contains(char);
    if let [first, _, ..] = all[..]
        && text[first.range()].chars().all(is_of_words)
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
            Said::Nothing => {}
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
    let mut definitions: Vec<Definition> = definitions.into_iter().map(|(own, _)| own).collect();
    let customary = customary(lexicon).into_iter();
    let customary: Vec<Definition> = customary
        .filter(|own| definitions.iter().all(|other| other.name != own.name))
        .collect();
    definitions.extend(customary);
    let is_whole = |equation: &Span| equation.range() == (0..text.trim_end().len());
    if definitions.is_empty() && is_one && equations.iter().all(is_whole) {
        return None;
    }
    let defined = Defined::of(text, definitions, lexicon, manner);
    let read = |equation: Span| {
        let place = equation.range();
        let typed = super::chain(text, place.start, place.end, &defined.lexicon, manner)?;
        let chain = |compared: &Expr| match compared.kind() {
            Kind::Compare(sides, relations) => Some(Chain {
                sides: sides.clone(),
                relations: relations.clone(),
            }),
            _ => None,
        };
        let all = [typed.value].into_iter().chain(typed.others);
        let compared = all.map(|chain| Expr::derived(Kind::Compare(chain.sides, chain.relations)));
        let readings = defined.readings(compared)?;
        let mut chains = readings.iter().filter_map(chain);
        let missing = TypedError::new(Trouble::Missing, place.start, place.end);
        let value = chains.next().ok_or(missing)?;
        Ok(Typed {
            value,
            others: chains.collect(),
        })
    };
    Some(equations.into_iter().map(read).collect())
}

/// A statement without what its colon says of it, `Newton: m x'' = -k x`.
fn behind_colon(text: &str, statement: Span) -> Span {
    let pieces = cut_where(text, statement, |_, char| char == ':');
    let last = pieces.last().copied().unwrap_or(statement);
    let is_equation = text[last.range()]
        .trim_start()
        .starts_with(|first| first != '=')
        && text[last.range()].contains('=');
    if is_equation {
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
        found.extend(free.map(|(letter, order)| Definition {
            name: Name::new(*letter),
            order: 0,
            is_square: false,
            is_known: false,
            is_of_question: false,
            values: Vec::new(),
            formula: Some(Expr::name(coordinate.clone()).prime(*order)),
        }));
    }
    found
}

/// A definition with its value as it was read; none where only the letter itself is said.
type ReadDefinition = (Definition, Option<Result<Typed<Expr>, TypedError>>);

/// Definitions with the lexicon that has their letters, and their values as they were read.
struct Defined {
    lexicon: Lexicon,
    all: Vec<ReadDefinition>,
}

impl Defined {
    fn of(text: &str, definitions: Vec<Definition>, lexicon: &Lexicon, manner: Manner) -> Self {
        Self::measured(text, definitions, lexicon, manner, &|_| None)
    }

    /// The same where values may have units that `measure` reads.
    fn measured(
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
                    let measured = begins_value(own.text()).then(|| measure(own)).flatten();
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
    fn readings(&self, all: impl Iterator<Item = Expr>) -> Result<Vec<Expr>, TypedError> {
        let mut readings = Vec::new();
        for expr in all {
            readings.extend(substituted(&expr, &self.all, &self.lexicon)?);
        }
        Ok(readings)
    }
}

/// Whether a label is that of a rate, `dE/dt`, `Ė`, `E'`.
fn is_rate(label: &str) -> bool {
    leibniz(label, 0).is_some_and(|(.., end)| end == label.len())
        || label.ends_with(is_apostrophe)
        || label
            .chars()
            .any(|char| is_dotted(char) || combining(char).is_some())
        || label.starts_with("\\dot")
}

/// Whether a text is a number with a unit or without.
fn is_value(text: &str) -> bool {
    let is_of_number = |char: char| char.is_ascii_digit() || "-+.,*^ ".contains(char);
    let unit = text.trim_start_matches(is_of_number);
    begins_value(text) && (unit.is_empty() || Unit::read(unit).is_ok())
}

/// Whether a text begins as a number does.
fn begins_value(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit() || "-.".contains(first))
}

pub(crate) fn moved(span: Span, by: usize) -> Span {
    Span::new(span.range().start + by, span.range().end + by)
}

/// The letter that a text is, or its square.
fn letter(text: &str, lexicon: &Lexicon, may_be_product: bool) -> Option<Letter> {
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
        if may_be_product && is_product && order == 0 && is_word(word) {
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
            let uses = |expr: &Expr| {
                let names = expr.names().free;
                names
                    .iter()
                    .any(|used| used.name == definition.name && used.order >= definition.order)
            };
            if !readings.iter().any(uses) {
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
            let put = |expr: &Expr| -> Vec<Expr> {
                let all = values
                    .iter()
                    .filter_map(|value| definition.put(expr, value, lexicon));
                all.collect()
            };
            readings = readings.iter().flat_map(put).take(MAX_READINGS).collect();
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
    /// The letter by what is said of it or of its square.
    fn value_of(&self, value: &Expr) -> Expr {
        if self.is_square {
            return Expr::derived(Kind::Call(Function::Sqrt, vec![value.clone()]));
        }
        value.clone()
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

/// What stands before the first equals sign of a statement.
pub(crate) fn label(text: &str, statement: Span) -> Option<Span> {
    let start = statement.range().start;
    let end = text[statement.range()].find(['=', '≈'])?;
    let label = trimmed(text, Span::new(start, start + end));
    (!label.range().is_empty()).then_some(label)
}

/// The statements of a text, each but the first with an equals sign; the text where it is one. What is only compared
/// with a statement, `ω = √(k/m) < ω_0`, is none.
fn statements(text: &str) -> Vec<Span> {
    statements_by(text, word_at)
}

/// The same with other words that join statements, by their length.
pub(crate) fn statements_by(text: &str, joint_at: impl Fn(&str) -> Option<usize>) -> Vec<Span> {
    const RELATIONS: [char; 4] = ['<', '>', '≤', '≥'];
    let whole = vec![Span::new(0, text.len())];
    if !text.contains(['=', '≈']) {
        return whole;
    }
    let (before, bracketed) = match bracketed(text) {
        Some((before, inner)) => (before, Some(inner)),
        None => (text.len(), None),
    };
    let is_decimal = |at: usize| {
        text[..at].ends_with(|last: char| last.is_ascii_digit())
            && text[at + 1..].starts_with(|next: char| next.is_ascii_digit())
    };
    let first = text.split(['=', '≈']).next().unwrap_or(text).trim();
    let is_end = |at: usize, char: char| match char {
        ';' | '\n' => true,
        '/' => is_before_sibling(text, at, first),
        ',' => !is_decimal(at),
        ' ' => joint_at(&text[at + 1..]).is_some(),
        ':' => joint_at(&text[at..]).is_some(),
        char => RELATIONS.contains(&char),
    };
    let parts = [Some(Span::new(0, before)), bracketed]
        .into_iter()
        .flatten();
    let mut found: Vec<Span> = Vec::new();
    for piece in parts.flat_map(|part| cut_where(text, part, is_end)) {
        let mut own = trimmed(text, piece);
        // `, where ω = …`
        while let Some(length) = joint_at(&text[own.range()]).filter(|_| !found.is_empty()) {
            own = trimmed(text, Span::new(own.range().start + length, own.range().end));
        }
        // `, i.e. x'' = …`
        if !found.is_empty() && text[own.range()].starts_with('=') {
            own = trimmed(text, Span::new(own.range().start + 1, own.range().end));
        }
        if own.range().is_empty() {
            continue;
        }
        let is_statement = |own: Span| text[own.range()].contains(['=', '≈']);
        let is_compared = text[..piece.range().start].ends_with(RELATIONS);
        match found.first() {
            None => found.push(own),
            Some(_) if is_statement(own) => found.push(own),
            Some(first) if is_compared && is_statement(*first) => {}
            Some(_) => return whole,
        }
        // `μ m g ≥ F, μ = …` begins with an inequality.
        let is_compared_next = text[piece.range().end..].starts_with(RELATIONS);
        if is_compared_next && !is_statement(own) {
            return whole;
        }
    }
    if found.is_empty() { whole } else { found }
}

/// Whether the slash at a place parts two statements, `ω1 = 2 / ω2 = 3`: after it a letter of the first one's kind stands
/// before an equals sign.
fn is_before_sibling(text: &str, at: usize, first: &str) -> bool {
    let Some((sibling, _)) = text[at + 1..].split_once(['=', '≈']) else {
        return false;
    };
    let sibling = sibling.trim();
    let stem = |word: &str| {
        word.trim_end_matches(|last: char| !last.is_alphabetic())
            .len()
    };
    let is_apart = text[..at].ends_with(' ') && text[at + 1..].starts_with(' ');
    is_apart
        && sibling != first
        && is_word(first)
        && is_word(sibling)
        && sibling[..stem(sibling)] == first[..stem(first)]
}

/// The length of the word with which a text begins and that joins statements.
pub(crate) fn word_at(text: &str) -> Option<usize> {
    let is_it = |word: &&&str| {
        let behind = text.strip_prefix(**word);
        behind.is_some_and(|behind| behind.starts_with([' ', ',', ':']))
    };
    STATEMENTS.iter().find(is_it).map(|word| word.len())
}

/// The statements in brackets after a response, `(with ω = …)`, and where what stands before them ends.
fn bracketed(text: &str) -> Option<(usize, Span)> {
    let inner = text.strip_suffix(')')?;
    let mut depth = 0_usize;
    let opens = |(_, char): &(usize, char)| match char {
        ')' => {
            depth += 1;
            false
        }
        '(' if depth == 0 => true,
        '(' => {
            depth -= 1;
            false
        }
        _ => false,
    };
    let (open, _) = inner.char_indices().rev().find(opens)?;
    let is_apart = inner[..open].ends_with(' ') && inner[open..].contains('=');
    is_apart.then(|| (open, Span::new(open + 1, inner.len())))
}
