//! What the line for an answer says: what the marker of a part will do with what is written there.

use super::Choosing;
use crate::expr::Expr;
use crate::math::Math;
use crate::response::Lexicon;
use crate::unit::Unit;

/// What is asked for at an answer line, as data; [`Language::blank`](crate::message::Language::blank) words it.
///
/// A kind describes its own marker ([`Answer::blank`](super::Answer::blank)), so the line never asks for anything
/// that is then marked in another way.
#[derive(Clone, Debug, PartialEq)]
pub struct Blank {
    /// What is to be written.
    pub form: Asked,
    /// The letters that may be used, in the order of the item; none where numbers alone are asked.
    pub letters: Vec<Letter>,
    /// The unit of the numbers, where they have one.
    pub unit: Option<Unit>,
    /// The significant figures of the numbers; none where there are no numbers, or where they are exact.
    pub figures: Option<u32>,
}

/// What is to be written at an answer line.
#[derive(Clone, Debug, PartialEq)]
pub enum Asked {
    /// A real number.
    Value,
    /// A complex number.
    ComplexValue,
    /// Numbers, in the order that the question states or in any.
    Values {
        /// Whether the order counts.
        is_ordered: bool,
    },
    /// A count: digits without a unit or a decimal sign.
    Integer,
    /// A formula in the letters of the item.
    Formula,
    /// A function, with letters or with numbers.
    Function {
        /// The variable, as it is typeset.
        variable: Math,
    },
    /// A general solution with free constants.
    GeneralSolution,
    /// One or more equations, such as those of motion.
    Equation {
        /// Whether there are several.
        are_several: bool,
    },
    /// A matrix, row by row.
    Matrix(Entries),
    /// An interval, or several.
    Interval(Entries),
    /// The components of one or more mode shapes.
    ModeShape {
        /// How the components are written.
        entries: Entries,
        /// The scale in which they are asked.
        scale: ShapeScale,
        /// Whether there are several.
        are_several: bool,
    },
    /// Listed options.
    Choice(Choosing),
    /// Work on paper.
    Work,
}

/// How entries, bounds or components are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entries {
    /// Numbers, with or without a unit.
    Numbers,
    /// Formulas in the letters of the item.
    Formulas,
    /// Numbers or formulas, as the student likes.
    Either,
}

/// The scale in which a shape is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeScale {
    /// Every multiple of the shape is right.
    Any,
    /// Unit modal mass.
    Mass,
    /// A first component of 1.
    First,
}

/// A letter that an answer may use.
#[derive(Clone, Debug, PartialEq)]
pub struct Letter {
    /// As it is printed.
    pub symbol: Math,
    /// As it can be typed.
    pub typed: String,
}

impl Blank {
    /// A line for an answer of this form, without letters, unit and figures.
    pub(crate) fn of(form: Asked) -> Self {
        Self {
            form,
            letters: Vec::new(),
            unit: None,
            figures: None,
        }
    }

    /// The same for numbers in a unit with significant figures; one that is 1 goes without saying.
    #[must_use]
    pub(crate) fn with_numbers(self, unit: Option<Unit>, figures: u32) -> Self {
        Self {
            unit: unit.filter(|unit| !unit.is_one()),
            figures: Some(figures),
            ..self
        }
    }

    /// The same for exact numbers.
    #[must_use]
    pub(crate) fn without_figures(self) -> Self {
        let figures = None;
        Self { figures, ..self }
    }

    /// The same for formulas in these letters, each printed once.
    #[must_use]
    pub(crate) fn with_letters(mut self, letters: &[Expr], lexicon: &Lexicon) -> Self {
        for letter in letters {
            let symbol = letter.typeset(lexicon);
            if self.letters.iter().all(|other| other.symbol != symbol) {
                let typed = lexicon.typed(letter);
                self.letters.push(Letter { symbol, typed });
            }
        }
        self
    }

    /// The unit that is printed after the line: that of values. Others stand with what it says.
    pub fn unit_behind(&self) -> Option<Unit> {
        let has_values = matches!(
            self.form,
            Asked::Value | Asked::ComplexValue | Asked::Values { .. }
        );
        self.unit.filter(|_| has_values)
    }

    /// The name of its form for programs.
    #[cfg(feature = "render")]
    pub(crate) fn form_name(&self) -> &'static str {
        match &self.form {
            Asked::Value => "value",
            Asked::ComplexValue => "complex-value",
            Asked::Values { .. } => "values",
            Asked::Integer => "integer",
            Asked::Formula => "formula",
            Asked::Function { .. } => "function",
            Asked::GeneralSolution => "general-solution",
            Asked::Equation { .. } => "equation",
            Asked::Matrix(_) => "matrix",
            Asked::Interval(_) => "interval",
            Asked::ModeShape { .. } => "mode-shape",
            Asked::Choice(_) => "choice",
            Asked::Work => "work",
        }
    }
}
