//! Arithmetic instead of a decimal: `1/3`, `2*pi rad/s`, `sqrt(2)/2 m`, `3 - 4i ohm`.
//!
//! What is read is a formula of numbers alone with a unit behind it. The unit is the shortest end of the text
//! before which a formula stands: `3/4 m/s` is three quarters of a metre per second, `1/2 m` half a metre.
//! What might be something else is asked back: `19-21` may be a range, `2e` may lack its exponent.

use std::sync::LazyLock;

use super::super::typed::{self, Lexicon, Manner, Trouble};
use crate::expr::{Constant, Expr, Kind, Operator, Precise, Program, Slots, Value, Workspace};
use crate::unit::{DecimalMark, Unit};

/// Longest text that is read, in bytes.
pub(super) const LONGEST: usize = 200;
const HELP: &str =
    "Type one number and its unit, the unit last: `15.8 rad/s`, `1.6e-2 m`, `sqrt(2)/2 m`.";

/// Functions and constants, but no names.
static NUMBERS: LazyLock<Lexicon> = LazyLock::new(Lexicon::new);

/// A formula of numbers with the unit behind it.
#[derive(Clone, Debug)]
pub(super) struct Arithmetic {
    pub(super) expr: Expr,
    pub(super) unit: Option<Unit>,
}

/// Whether a text has more than a decimal and a unit: an operator, a root, a constant.
pub(super) fn is_arithmetic(text: &str) -> bool {
    let has_word = [
        "pi", "sqrt", "sin", "cos", "tan", "exp", "ln", "log", "frac",
    ]
    .iter()
    .any(|word| text.contains(word));
    has_word || text.contains(|sign: char| "+*/·×⋅÷^()√π±∓-−–½¼¾²³⁴⁻".contains(sign))
}

impl Arithmetic {
    /// Reads a formula of numbers and its unit.
    ///
    /// # Errors
    ///
    /// A sentence that says what cannot be read and what to type instead.
    pub(super) fn read(text: &str, mark: DecimalMark, is_complex: bool) -> Result<Self, String> {
        if text.len() > LONGEST {
            return Err("This is too long to be read.".to_owned());
        }
        if let Some(number) = ambiguous_comma(text).filter(|_| mark == DecimalMark::Point) {
            return Err(format!(
                "The comma in `{number}` may separate decimals or thousands: write `{}` or `{}`.",
                number.replace(',', "."),
                number.replace(',', "")
            ));
        }
        let manner = Manner {
            comma_is_decimal: true,
            has_imaginary_unit: is_complex,
        };
        let formula = |text: &str| typed::formula(text, &NUMBERS, manner);
        let error = match formula(text) {
            Ok(typed) => {
                return Self {
                    expr: typed.value,
                    unit: None,
                }
                .checked(text);
            }
            Err(error) => error,
        };
        for (number, unit) in typed::with_unit(text) {
            let Ok(typed) = formula(number) else {
                continue;
            };
            let unit = Some(unit);
            return Self {
                expr: typed.value,
                unit,
            }
            .checked(number);
        }
        Err(match error.trouble {
            Trouble::Unknown { .. } | Trouble::NotAllowed(_) | Trouble::Sign | Trouble::Unit => {
                HELP.to_owned()
            }
            _ => format!("{} {HELP}", error.sentence(text)),
        })
    }

    /// Refuses what might be meant otherwise; an angle in degrees is one in radians.
    fn checked(mut self, text: &str) -> Result<Self, String> {
        let (mut bare, mut powers, mut has_infinity) = (0, 0, false);
        self.expr.walk(&mut |node| match node.kind() {
            Kind::Constant(Constant::E) => bare += 1,
            Kind::Constant(Constant::Infinity) => has_infinity = true,
            Kind::Binary(Operator::Power, base, _)
                if *base.kind() == Kind::Constant(Constant::E) =>
            {
                powers += 1;
            }
            _ => {}
        });
        if bare > powers {
            return Err(format!(
                "In `{}` the exponent is missing behind `e`: type `2e-3`, or `exp(1)` for the number e.",
                text.trim()
            ));
        }
        if has_infinity {
            return Err(HELP.to_owned());
        }
        if let Kind::Binary(Operator::Subtract, a, b) = self.expr.kind() {
            let is_plain = a.as_number().is_some() && b.as_number().is_some();
            if is_plain && !text.trim().contains(' ') {
                return Err(format!(
                    "`{}` may be a range or a difference: give one number.",
                    text.trim()
                ));
            }
        }
        if is_in_degrees(&self.expr) {
            match self.unit {
                None => self.unit = Unit::parse("rad").ok(),
                Some(_) => return Err(format!("There are two units. {HELP}")),
            }
        }
        Ok(self)
    }

    /// The value, if there is one.
    pub(super) fn value(&self) -> Option<Value> {
        let program = Program::compile(&self.expr, &Slots(&[])).ok()?;
        let none: [Precise; 0] = [];
        program.evaluate(&none, &mut Workspace::default()).ok()
    }
}

/// Whether a value is an angle in degrees; one that stands in a function or exponent leaves no unit.
fn is_in_degrees(expr: &Expr) -> bool {
    match expr.kind() {
        Kind::Measure(..) => true,
        Kind::Negate(inner) => is_in_degrees(inner),
        Kind::Binary(Operator::Power, base, _) => is_in_degrees(base),
        Kind::Binary(_, left, right) => is_in_degrees(left) || is_in_degrees(right),
        _ => false,
    }
}

/// A number with one comma that cuts it into up to three digits and exactly three.
fn ambiguous_comma(text: &str) -> Option<&str> {
    let is_of_number = |char: char| char.is_ascii_digit() || char == ',' || char == '.';
    text.split(|char| !is_of_number(char)).find(|number| {
        number.split_once(',').is_some_and(|(whole, rest)| {
            (1..=3).contains(&whole.len())
                && !whole.starts_with('0')
                && rest.len() == 3
                && !number.contains('.')
        })
    })
}
