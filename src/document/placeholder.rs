//! What a text asks for.

use serde::Serialize;

use crate::source::Span;

/// A demand of a text: a value in a form.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Placeholder {
    /// The name, dotted: `omega_n`, `model.equation.x1`, `plots.response`, `figure`, `figure.free`.
    #[serde(rename = "n")]
    pub path: String,
    /// The form in which it is written.
    #[serde(rename = "f", skip_serializing_if = "is_default")]
    pub form: Form,
    /// Whether it stands inside a formula.
    #[serde(rename = "m", skip_serializing_if = "std::ops::Not::not")]
    pub in_math: bool,
    /// Where it stands in the text; not kept in a compiled text.
    #[serde(skip)]
    pub span: Span,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// The form of a value in a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Form {
    /// The number with its unit.
    #[default]
    Value,
    /// As the sheet shows data: symbol, number or both.
    Given,
    /// The typeset symbol alone.
    Symbol,
    /// The words.
    Name,
    /// The number without its unit.
    Number,
    /// The unit alone, typeset.
    Unit,
    /// The closed form in symbols.
    Formula,
    /// The closed form with the numbers substituted.
    Substituted,
    /// Symbol, closed form and value.
    Equation,
    /// The closed form, with the data substituted, and the value, line by line.
    Worked,
}

impl Form {
    /// The forms that are written after a dot.
    pub const NAMED: &[(&str, Form)] = &[
        ("given", Self::Given),
        ("symbol", Self::Symbol),
        ("name", Self::Name),
        ("number", Self::Number),
        ("unit", Self::Unit),
        ("formula", Self::Formula),
        ("substituted", Self::Substituted),
        ("equation", Self::Equation),
        ("worked", Self::Worked),
    ];

    /// The form of this word.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::NAMED
            .iter()
            .find(|(word, _)| *word == name)
            .map(|(_, form)| *form)
    }
}

/// The derivations of a model, which a layer above makes.
fn is_derivation(name: &str) -> bool {
    matches!(
        name,
        "lagrange" | "energy" | "newton" | "characteristic" | "row" | "turning_points" | "static"
    )
}

impl Placeholder {
    /// Whether it stands on lines of its own: a figure, a plot, the lines of a derivation.
    pub(crate) fn is_block(&self) -> bool {
        let mut names = self.names();
        match names.next() {
            Some("figure") => true,
            Some("plots") => true,
            // `model.lagrange.x`, `models.relative.newton`.
            Some("model") => names.next().is_some_and(is_derivation),
            Some("models") => names.nth(1).is_some_and(is_derivation),
            _ => self.form == Form::Worked,
        }
    }

    /// The names of its path.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.path.split('.')
    }
}
