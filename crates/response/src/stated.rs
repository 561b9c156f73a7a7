//! What a response says in several statements: the one that counts, its letters as the others define them.

use super::arguments::{is_at_value, without_arguments};
use super::defined::{Defined, Definition, Said, letter, said};
use super::differential::leibniz;
use super::letters::{combining, is_dotted};
use super::measured::{self, Measured};
use super::sides::{begins_with_function, is_word, last_side};
use super::signs::is_apostrophe;
use super::statements::{label, moved, statements};
use super::{Lexicon, Manner, Passage, Trouble, Typed, TypedError, formula_at, sides};
use vibank_formula::expr::Expr;
use vibank_source::Span;

/// What reads a value with its unit.
type Measure<'t> = &'t dyn Fn(Passage<'_>) -> Option<Expr>;

/// The statements of a response: the one that answers, and the others.
#[derive(Clone)]
pub struct Stated<'t> {
    text: &'t str,
    main: Span,
    others: Vec<Span>,
    measure: Option<Measure<'t>>,
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
        let all = without_values_elsewhere(text, statements(text), &answers);
        let single = |main| Self {
            text,
            main,
            others: Vec::new(),
            measure: None,
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
            let is_plain = !label.starts_with('|') && !begins_with_function(label);
            (is_plain, label.chars().count())
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
                let mut unused = all.iter().filter(|own| {
                    let word = label(own).map_or("", |label| &text[label.range()]);
                    let mut others = all.iter().filter(|other| other != own);
                    is_letter(word) && !others.any(|other| text[other.range()].contains(word))
                });
                // `V(x) = …; V(0) = …`
                let bare = |own: &Span| {
                    let label = label(own)?;
                    Some(without_arguments(&text[label.range()]))
                };
                // `k x = m g, x = m g/k`
                let mut named = all.iter().filter(|own| bare(own).is_some_and(is_letter));
                match (unused.next(), unused.next()) {
                    (Some(main), None) => *main,
                    _ if all.iter().all(|own| bare(own) == bare(&first)) => last,
                    _ if named.next() == Some(&last) && named.next().is_none() => last,
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

    /// The same where letters, those of the question among them, have the values that the others say, with units, which
    /// this reads.
    #[must_use]
    pub fn measured_by(self, measure: Measure<'t>) -> Self {
        Self {
            measure: Some(measure),
            ..self
        }
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

    /// The last statement, if it is not the one that counts.
    pub fn last_of_others(&self) -> Option<Passage<'t>> {
        let last = self.others.last()?;
        let is_last = last.range().start > self.main.range().start;
        is_last.then(|| Passage::of(&self.text[last.range()]))
    }

    /// Whether there is more than one statement.
    pub fn has_others(&self) -> bool {
        self.count_of_others() > 0
    }

    /// How many statements there are beside the one that counts.
    pub fn count_of_others(&self) -> usize {
        self.others.len()
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

    /// The function of numbers with units in it that its symbol is said to be, its other letters as they are defined.
    ///
    /// # Errors
    ///
    /// What cannot be read, or that no unit stands in it.
    pub fn measured(&self, lexicon: &Lexicon) -> Result<Typed<Measured>, TypedError> {
        let side = self.sides(lexicon)?.pop().unwrap_or(self.main);
        let defined = self.defined(self.definitions(lexicon), lexicon, Manner::default());
        let typed = measured::measured(&self.text[side.range()], &defined.lexicon, false)?;
        let mut all = Vec::new();
        for Measured { formula, unit } in [typed.value].into_iter().chain(typed.others) {
            let formulas = defined.readings(std::iter::once(formula))?.into_iter();
            all.extend(formulas.map(|formula| Measured { formula, unit }));
        }
        first_of(all, side)
    }

    /// The other sides of the statement that counts, and those of statements of the same symbol, that can be read.
    pub fn other_forms(&self, lexicon: &Lexicon, manner: Manner) -> Vec<Typed<Expr>> {
        let mut sides = self.sides(lexicon).unwrap_or_default();
        sides.pop();
        let name = self.label().map(|label| label.text());
        let rivals = self.others.iter().filter(|other| {
            let text = &self.text[other.range()];
            let own = label(self.text, **other).map(|label| &self.text[label.range()]);
            // `I = …, with r = R, = …`
            own.is_some() && own == name || text.starts_with('=')
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
        let places = sides.map(|side| moved(side, self.main.range().start));
        places
            .map(|side| self.side(side, lexicon, manner))
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
        if let [_, .., last] = sides[..]
            && self.text[last.range()].trim() == "0"
            && self.label().is_some_and(|label| is_rate(label.text()))
        {
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
        let defined = self.defined(definitions, lexicon, manner);
        let typed = read(&defined.lexicon)?;
        let all = [typed.value].into_iter().chain(typed.others);
        first_of(defined.readings(all)?, side)
    }

    fn defined(&self, definitions: Vec<Definition>, lexicon: &Lexicon, manner: Manner) -> Defined {
        let measure = self.measure.unwrap_or(&|_| None);
        Defined::measured(self.text, definitions, lexicon, manner, measure)
    }

    /// What the other statements say that letters are.
    fn definitions(&self, lexicon: &Lexicon) -> Vec<Definition> {
        let own = self
            .label()
            .and_then(|label| letter(label.text(), lexicon, false));
        let said = self
            .others
            .iter()
            .map(|other| said(self.text, *other, lexicon, false));
        let found = said.filter_map(|said| match said {
            Said::Letter(definition) => Some(definition),
            // The response says what the letter is, be it otherwise than the question.
            Said::Value(definition) => self.measure.map(|_| Definition {
                is_of_question: false,
                ..definition
            }),
            Said::Equation | Said::Nothing => None,
        });
        let own = own.map(|own| own.name);
        found
            .filter(|said| own.as_ref() != Some(&said.name))
            .collect()
    }
}

/// The readings of a side, the first one before the others.
fn first_of<T>(readings: Vec<T>, side: Span) -> Result<Typed<T>, TypedError> {
    let mut readings = readings.into_iter();
    let missing = TypedError::new(Trouble::Missing, side.range().start, side.range().end);
    Ok(Typed {
        value: readings.next().ok_or(missing)?,
        others: readings.collect(),
    })
}

/// Whether a label is one letter, and not a function of one, `tanθ`.
fn is_letter(label: &str) -> bool {
    is_word(label) && !begins_with_function(label)
}

/// Statements without what one of them is at some place, `V(0) = 0` beside `V(θ) = …`, unless only that place `answers`.
fn without_values_elsewhere<'t>(
    text: &'t str,
    mut statements: Vec<Span>,
    answers: &dyn Fn(Passage<'t>) -> bool,
) -> Vec<Span> {
    let label = |own: &Span| label(text, *own).map(|label| &text[label.range()]);
    let functions: Vec<&str> = statements
        .iter()
        .filter_map(label)
        .filter(|label| !is_at_value(label))
        .map(without_arguments)
        .collect();
    statements.retain(|own| {
        let label = label(own).unwrap_or_default();
        let bare = without_arguments(label);
        !is_at_value(label)
            || !functions.contains(&bare)
            || answers(Passage::of(label)) && !answers(Passage::of(bare))
    });
    statements
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
