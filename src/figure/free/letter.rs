//! The letter of an arrow: a component of a force without its sign, per length of its arm.

use crate::expr::{Expr, Function, Kind, Operator};
use crate::numerics::Rational;

/// A product, factor by factor in the order of the author.
#[derive(Clone, Debug)]
pub(crate) struct Product {
    is_negative: bool,
    number: Rational,
    above: Vec<Expr>,
    below: Vec<Expr>,
    /// The velocity whose sign a force of dry friction has.
    velocity: Option<Expr>,
}

impl Product {
    /// The factors of a component; `None` for a component that vanishes.
    pub(crate) fn of(component: &Expr) -> Option<Self> {
        let mut product = Self {
            is_negative: false,
            number: Rational::ONE,
            above: Vec::new(),
            below: Vec::new(),
            velocity: None,
        };
        product.take(component, false)?;
        Some(product)
    }

    fn take(&mut self, factor: &Expr, is_below: bool) -> Option<()> {
        match factor.kind() {
            Kind::Binary(Operator::Multiply, a, b) => {
                self.take(a, is_below)?;
                self.take(b, is_below)
            }
            Kind::Binary(Operator::Divide, a, b) => {
                self.take(a, is_below)?;
                self.take(b, !is_below)
            }
            Kind::Negate(inner) => {
                self.is_negative = !self.is_negative;
                self.take(inner, is_below)
            }
            Kind::Call(Function::Sign, arguments) if !is_below => {
                self.velocity = arguments.first().cloned();
                Some(())
            }
            _ => {
                match factor.as_number() {
                    Some(number) if number.is_zero() => return None,
                    Some(number) => self.count(number, is_below),
                    None if is_below => self.below.push(factor.clone()),
                    None => self.above.push(factor.clone()),
                }
                Some(())
            }
        }
    }

    fn count(&mut self, number: Rational, is_below: bool) {
        if number.is_negative() {
            self.is_negative = !self.is_negative;
        }
        let size = number.abs();
        let result = if is_below {
            self.number.checked_div(size)
        } else {
            self.number.checked_mul(size)
        };
        // Beyond what a number holds nothing is folded; such a letter is printed as it is.
        match result {
            Some(number) => self.number = number,
            None if is_below => self.below.push(Expr::number(size)),
            None => self.above.push(Expr::number(size)),
        }
    }

    /// Whether a sign stands before it.
    pub(crate) fn is_negative(&self) -> bool {
        self.is_negative
    }

    /// The velocity whose sign it has, if it is a force of dry friction.
    pub(crate) fn velocity(&self) -> Option<&Expr> {
        self.velocity.as_ref()
    }

    /// Divides by another product; `None` if a factor of that one is no factor of this one.
    pub(crate) fn over(mut self, divisor: &Self) -> Option<Self> {
        for factor in &divisor.above {
            // An arm is written after its force.
            let place = self.above.iter().rposition(|own| own == factor)?;
            self.above.remove(place);
        }
        for factor in &divisor.below {
            let place = self.below.iter().rposition(|own| own == factor)?;
            self.below.remove(place);
        }
        self.count(divisor.number, true);
        self.is_negative ^= divisor.is_negative;
        Some(self)
    }

    /// Shares it between several arrows.
    pub(crate) fn shared(mut self, arrows: u8) -> Self {
        self.count(Rational::from(i32::from(arrows)), true);
        self
    }

    /// The product without its sign.
    pub(crate) fn letter(&self) -> Expr {
        let above = self
            .above
            .iter()
            .fold(Expr::number(self.number), |all, one| all * one.clone());
        self.below.iter().fold(above, |all, one| all / one.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn letter(component: &str, arm: &str) -> Option<(bool, String)> {
        let of = |text| Product::of(&Expr::read(text).expect("a formula"));
        let product = of(component)?.over(&of(arm)?)?;
        Some((product.is_negative(), product.letter().to_string()))
    }

    #[test]
    fn a_moment_is_a_force_times_its_arm() {
        let found = |negative, text: &str| Some((negative, text.to_owned()));
        assert_eq!(letter("-k*y*l", "l"), found(true, "k*y"));
        assert_eq!(letter("-k*a*y*a", "a"), found(true, "k*a*y"));
        assert_eq!(letter("-S*l/2", "l/2"), found(true, "S"));
        assert_eq!(letter("2*k*z*r/2", "r/2"), found(false, "2*k*z"));
        assert_eq!(letter("k*(x2 - x1)*r", "r"), found(false, "k*(x2 - x1)"));
        assert_eq!(
            letter("2*k*(x2 - 2*x1)", "2"),
            found(false, "k*(x2 - 2*x1)")
        );
    }

    #[test]
    fn a_moment_that_has_another_arm_has_no_letter() {
        assert_eq!(letter("-k*y*l", "r"), None);
        assert_eq!(letter("0", "1"), None);
    }

    #[test]
    fn dry_friction_is_drawn_without_the_sign_of_the_velocity() {
        let force = Expr::read("-mu*m*g*sign(x')").expect("a formula");
        let product = Product::of(&force).expect("it is there");
        assert_eq!(product.letter().to_string(), "mu*m*g");
        assert_eq!(
            product.velocity().map(Expr::to_string),
            Some("x'".to_owned())
        );
        assert!(product.is_negative());
    }
}
