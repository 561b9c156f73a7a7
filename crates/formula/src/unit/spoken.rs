//! Numbers, units and quantities in spoken English, for readers of screens.

use super::decimal::Decimal;
use super::factor::Factor;
use super::figures;
use super::notation::DecimalMark;
use super::product::Unit;
use super::quantity::Quantity;
use super::rational::Rational;

impl Decimal {
    /// In words where signs are not spoken: `minus 1.6 times 10 to the minus 4`.
    pub fn spoken(&self, mark: DecimalMark) -> String {
        let (mut text, power) = figures::size(self, mark);
        if self.is_negative() {
            text.insert_str(0, "minus ");
        }
        if let Some(power) = power {
            text.push_str(" times 10 to the ");
            text.push_str(&signed(Rational::integer(power)));
        }
        text
    }
}

impl Unit {
    /// In words, for one or for several: `newton metres per radian`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    ///
    /// let spoken = |unit| Unit::parse(unit).unwrap().spoken(true);
    /// assert_eq!(spoken("N m/rad"), "newton metres per radian");
    /// assert_eq!(spoken("m/s^2"), "metres per second squared");
    /// assert_eq!(spoken("kHz"), "kilohertz");
    /// assert_eq!(spoken("1/s"), "per second");
    /// ```
    pub fn spoken(&self, several: bool) -> String {
        let last = self.above().count().saturating_sub(1);
        let above = self
            .above()
            .enumerate()
            .map(|(i, factor)| name(factor, factor.power, several && i == last));
        let below = self
            .below()
            .map(|factor| format!("per {}", name(factor, factor.power.negated(), false)));
        let words: Vec<String> = above.chain(below).collect();
        words.join(" ")
    }
}

impl Quantity {
    /// In words: `2.0 kilograms`, `1 newton metre`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{DecimalMark, Quantity};
    ///
    /// let spoken = |text| Quantity::parse(text).unwrap().spoken(DecimalMark::Point);
    /// assert_eq!(spoken("2.0 kg"), "2.0 kilograms");
    /// assert_eq!(spoken("1 kN m"), "1 kilonewton metre");
    /// assert_eq!(spoken("-3e-4 m"), "minus 3 times 10 to the minus 4 metres");
    /// ```
    pub fn spoken(&self, mark: DecimalMark) -> String {
        let number = self.value.spoken(mark);
        if self.unit.is_one() {
            return number;
        }
        let one = number == "1" || number == "minus 1";
        format!("{number} {}", self.unit.spoken(!one))
    }
}

fn name(factor: &Factor, power: Rational, several: bool) -> String {
    let prefix = factor.prefix().map_or("", |prefix| prefix.word);
    let word = factor.row().words[usize::from(several)];
    let power = match power {
        Rational::ONE => String::new(),
        power if power == Rational::integer(2) => " squared".to_owned(),
        power if power == Rational::integer(3) => " cubed".to_owned(),
        power => format!(" to the power {}", signed(power)),
    };
    format!("{prefix}{word}{power}")
}

fn signed(power: Rational) -> String {
    let sign = if power.is_negative() { "minus " } else { "" };
    let size = power.abs();
    let half = size.numerator() == 1 && size.denominator() == 2;
    if half {
        format!("{sign}one half")
    } else {
        format!("{sign}{}", size.to_string().replace('/', " over "))
    }
}
