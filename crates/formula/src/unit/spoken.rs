//! Numbers, units and quantities in words, for readers of screens.

use super::decimal::Decimal;
use super::factor::Factor;
use super::figures;
use super::notation::DecimalMark;
use super::product::Unit;
use super::quantity::Quantity;
use super::rational::Rational;
use vibank_notation::Voice;

impl Decimal {
    /// In English words where signs are not spoken: `minus 1.6 times 10 to the minus 4`.
    pub fn spoken(&self, mark: DecimalMark) -> String {
        let (mut text, power) = figures::size(self, mark);
        if self.is_negative() {
            text.insert_str(0, "minus ");
        }
        if let Some(power) = power {
            text.push_str(" times 10 to the ");
            text.push_str(&signed(Rational::integer(power), Voice::ENGLISH));
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
    /// use vibank_notation::Voice;
    ///
    /// let spoken = |unit| Unit::parse(unit).unwrap().spoken(true, Voice::ENGLISH);
    /// assert_eq!(spoken("N m/rad"), "newton metres per radian");
    /// assert_eq!(spoken("m/s^2"), "metres per second squared");
    /// assert_eq!(spoken("kHz"), "kilohertz");
    /// assert_eq!(spoken("1/s"), "per second");
    /// ```
    pub fn spoken(&self, several: bool, voice: &Voice) -> String {
        let last = self.above().count().saturating_sub(1);
        let above = self
            .above()
            .enumerate()
            .map(|(i, factor)| name(factor, factor.power, several && i == last, voice));
        let below = self.below().map(|factor| {
            let name = name(factor, factor.power.negated(), false, voice);
            format!("{} {name}", voice.per)
        });
        let words: Vec<String> = above.chain(below).collect();
        words.join(" ")
    }
}

impl Quantity {
    /// In English words: `2.0 kilograms`, `1 newton metre`.
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
        format!("{number} {}", self.unit.spoken(!one, Voice::ENGLISH))
    }
}

fn name(factor: &Factor, power: Rational, several: bool, voice: &Voice) -> String {
    let prefix = factor.prefix().map_or("", |prefix| prefix.word);
    let [prefix, word] =
        [prefix, factor.row().words[usize::from(several)]].map(|word| (voice.unit)(word));
    let power = match power {
        Rational::ONE => String::new(),
        power if power == Rational::integer(2) => format!(" {}", voice.squared),
        power if power == Rational::integer(3) => format!(" {}", voice.cubed),
        power => format!(" {} {}", voice.power[0], signed(power, voice)),
    };
    format!("{prefix}{word}{power}")
}

fn signed(power: Rational, voice: &Voice) -> String {
    let sign = if power.is_negative() {
        format!("{} ", voice.minus)
    } else {
        String::new()
    };
    let size = power.abs();
    let half = size.numerator() == 1 && size.denominator() == 2;
    if half {
        format!("{sign}{}", voice.half)
    } else {
        let over = format!(" {} ", voice.over);
        format!("{sign}{}", size.to_string().replace('/', &over))
    }
}
