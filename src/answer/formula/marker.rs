//! Marks formulas: by their dimension, then by their values.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Setup, explained, in_words};
use crate::answer::equality::{Comparable, Comparison, Points};
use crate::answer::typed::{self, Manner, Trouble, Typed};
use crate::answer::{
    Credit, Feedback, Key, Marker, Marking, Nature, Reading, Reason, Trial, Verdict,
};
use crate::expr::{Expr, Field};
use crate::unit::{DecimalMark, Dimension};

/// A prepared key.
pub(super) struct Prepared {
    pub(super) setup: Arc<Setup>,
    pub(super) key: Comparable,
    pub(super) points: Points,
    pub(super) mistakes: Vec<Mistake>,
    pub(super) mark: DecimalMark,
}

pub(super) struct Mistake {
    pub(super) number: usize,
    pub(super) formula: Comparable,
    pub(super) credit: Credit,
}

impl Prepared {
    fn manner(&self, response: &str) -> Manner {
        let has_lists = ["atan2", "hypot", "min", "max", "mod", "clamp"];
        Manner {
            comma_is_decimal: !has_lists.iter().any(|name| response.contains(name)),
            has_imaginary_unit: self.setup.kind.field() == Field::Complex,
        }
    }

    /// The reading whose dimension fits, if one does; and what is wrong with the dimension of the first otherwise.
    fn fitting(&self, typed: Typed<Expr>) -> (Expr, Option<String>) {
        let trouble = self.dimension_trouble(&typed.value);
        match (trouble, typed.other) {
            (Some(_), Some(other)) if self.dimension_trouble(&other).is_none() => (other, None),
            (trouble, _) => (typed.value, trouble),
        }
    }

    fn dimension_trouble(&self, typed: &Expr) -> Option<String> {
        let setup = &self.setup;
        let found = match typed.check(&setup.meaning) {
            Err(errors) => return Some(explained(errors.first())),
            Ok(found) => found,
        };
        let fits = match (setup.kind.dimension(), found.dimension()) {
            (Some(key), Some(typed)) => key == typed,
            _ => true,
        };
        let found = found.dimension().filter(|_| !fits)?;
        let expected = setup.kind.dimension().unwrap_or(Dimension::PURE);
        let unit = setup
            .unit
            .filter(|unit| !unit.is_one())
            .map(|unit| unit.text());
        let expected = unit.unwrap_or_else(|| in_words(expected));
        Some(
            format!(
                "This comes out in {}, it has to be in {expected}.",
                in_words(found)
            )
            .replace("in a pure number", "as a pure number"),
        )
    }

    /// The marking of a formula behind which a unit stands all the same, `sqrt(k/m) rad/s`.
    fn mark_before_unit(&self, response: &str, has_names: bool) -> Option<Marking> {
        let manner = self.manner(response);
        let reads = |text: &str| {
            let typed = typed::formula(text, &self.setup.lexicon, manner)
                .ok()?
                .value;
            (!has_names || !typed.names().free.is_empty()).then_some(())
        };
        let (formula, unit) = typed::with_unit(response).find(|(text, _)| reads(text).is_some())?;
        let unit_text = response[formula.len()..].trim();
        if self
            .setup
            .kind
            .dimension()
            .is_some_and(|own| own != unit.dimension())
        {
            return Some(Marking::unreadable(format!(
                "At `{unit_text}`: letters carry their units, and this one does not fit. Leave it out."
            )));
        }
        let mut marking = self.mark(formula);
        if has_names && marking.reading.is_some() {
            let words = format!("Letters carry their units: leave out `{unit_text}`.");
            marking.feedback.push(Feedback::Words(words));
        }
        Some(marking)
    }

    /// The named mistake that a formula is.
    fn mistake(&self, typed: &Comparable) -> Option<&Mistake> {
        let is_it =
            |mistake: &&Mistake| self.points.compare(&mistake.formula, typed) == Comparison::Same;
        self.mistakes.iter().find(is_it)
    }

    /// Whether a response is a number in the unit of the key.
    fn is_number(&self, response: &str) -> bool {
        let has_key_dimension = |quantity: crate::unit::Quantity| {
            Some(quantity.unit.dimension()) == self.setup.kind.dimension()
        };
        crate::answer::numeric::quantity(response, self.mark).is_ok_and(has_key_dimension)
    }
}

/// What a wrong formula has in common with the key.
fn slip(comparison: &Comparison) -> (Reason, Option<&'static str>) {
    const TWO_PI: f64 = std::f64::consts::TAU;
    let is_near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    match comparison {
        Comparison::Undefined => (
            Reason::Other,
            Some("This has no value for data for which there is an answer."),
        ),
        Comparison::Different {
            ratio: Some(ratio), ..
        } if is_near(-ratio, 1.0) => (Reason::Sign, Some("The sign is wrong.")),
        Comparison::Different {
            ratio: Some(ratio), ..
        } if is_near(*ratio, TWO_PI) || is_near(*ratio, 1.0 / TWO_PI) => (
            Reason::TwoPi,
            Some(
                "It is off by a factor of 2π: angular frequencies and frequencies in hertz differ by it.",
            ),
        ),
        Comparison::Different { part, .. } if *part < 5e-3 => (
            Reason::Near,
            Some(
                "It is nearly right: give the numbers in it exactly, as fractions, roots or multiples of π.",
            ),
        ),
        Comparison::Different { ratio: Some(_), .. } => (
            Reason::Other,
            Some("The symbols fit, but not the number in front."),
        ),
        _ => (Reason::Other, None),
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![Trial::new(Nature::Unreadable, "sqrt(")];
        let text = self.setup.shown.to_string();
        // Cases and numbers with units cannot be typed.
        let is_typable = !text.contains("if ") && !text.contains('[');
        if !is_typable || !self.setup.shown.names().paths.is_empty() {
            return trials;
        }
        trials.extend([
            Trial::new(Nature::Right, text.as_str()),
            Trial::new(Nature::Borderline, format!("2*({text})/2")),
            Trial::new(Nature::Unreadable, format!("({text}")),
            Trial::new(Nature::Unreadable, format!("({text})*unheard_of")),
        ]);
        if !self.setup.shown.is_zero() {
            trials.push(Trial::new(Nature::Wrong, format!("1.000001*({text})")));
            trials.push(Trial::new(Nature::Wrong, format!("-({text})")));
        }
        if self
            .setup
            .kind
            .dimension()
            .is_some_and(|dimension| !dimension.is_pure())
        {
            trials.push(Trial::new(Nature::WrongUnit, format!("({text})^2")));
        }
        trials
    }

    fn key(&self) -> Key {
        self.setup.printed()
    }

    fn mark(&self, response: &str) -> Marking {
        const NUMBER: &str = "A formula in symbols is asked, not a number.";
        let setup = &self.setup;
        let has_names = !setup.shown.names().free.is_empty();
        let typed = match typed::formula(response, &setup.lexicon, self.manner(response)) {
            Ok(typed) => typed,
            Err(error) => {
                if let Some(marking) = self.mark_before_unit(response, has_names) {
                    return marking;
                }
                let is_unknown = matches!(error.trouble, Trouble::Unknown { .. } | Trouble::Unit);
                if is_unknown && has_names && self.is_number(response) {
                    return Marking::unreadable(NUMBER);
                }
                return Marking::unreadable(error.sentence(response));
            }
        };
        let (expr, trouble) = self.fitting(typed);
        let is_number = expr.names().free.is_empty() && !expr.is_zero();
        if has_names && (is_number || trouble.is_some() && self.is_number(response)) {
            return Marking::unreadable(NUMBER);
        }
        let reading = Reading {
            math: expr.typeset(&setup.lexicon),
            text: expr.to_string(),
            si: Vec::new(),
        };
        let Ok(typed) = Comparable::of(&setup.meaning, &expr, &BTreeMap::new()) else {
            return Marking::unreadable(
                "This formula cannot be compared; write it in a simpler form.",
            );
        };
        // Steps may go against the dimensions where the whole does not: `ln(x0) - ln(x1)`.
        let is_of_dimension = trouble.is_none() || expr.check(&setup.meaning).is_err();
        let comparison = if is_of_dimension {
            self.points.compare(&self.key, &typed)
        } else {
            Comparison::Undefined
        };
        if comparison == Comparison::Same {
            let remark = trouble.map(|trouble| Feedback::Words(format!("Right, but: {trouble}")));
            return Marking::read(reading, Credit::FULL, Reason::Matches, remark);
        }
        if let Some(mistake) = self.mistake(&typed) {
            let feedback = Some(Feedback::Mistake(mistake.number));
            return Marking::read(
                reading,
                mistake.credit,
                Reason::Mistake(mistake.number),
                feedback,
            );
        }
        if comparison == Comparison::Undecided && trouble.is_none() {
            return Marking::unreadable(
                "All digits are lost when this is computed, so it cannot be compared; write it in a simpler form.",
            );
        }
        if let Some(trouble) = trouble {
            let before = self.mark_before_unit(response, has_names);
            if let Some(marking) = before.filter(|marking| marking.verdict == Verdict::Right) {
                return marking;
            }
            let words = Some(Feedback::Words(trouble));
            return Marking::read(reading, Credit::NONE, Reason::Dimension, words);
        }
        let (reason, words) = slip(&comparison);
        let words = words.map(|words| Feedback::Words(words.to_owned()));
        Marking::read(reading, Credit::NONE, reason, words)
    }
}
