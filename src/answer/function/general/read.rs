//! Reads a general solution: a formula for each coordinate, or a sum of vectors.

use super::complex::phases;
use super::{DOUBTFUL, Setup};
use crate::answer::function::label::is_fresh;
use crate::answer::{Unreadable, Why};
use crate::expr::{Expr, Name};
use crate::math::Math;
use crate::response::{self, Lexicon, Manner, cut};
use crate::source::Span;

impl Setup {
    /// The formulas of a response, by coordinate; with complex numbers in them, where only so they can be read.
    pub(crate) fn read(&self, response: &str) -> Result<Vec<Expr>, Unreadable> {
        let may_be_complex = response.contains(['i', 'j', 'I']);
        self.read_in(response, Manner::REAL, &self.lexicon)
            .or_else(|why| {
                let constant = || {
                    let lexicon = self.with_doubtful.as_ref()?;
                    let typed = self.read_in(response, Manner::REAL, lexicon).ok()?;
                    // In an exponent or a phase it is the imaginary unit.
                    let is_doubtful = |name: &Name| name.as_str() == DOUBTFUL;
                    let turns = |own: &Expr| phases(own).iter().any(is_doubtful);
                    (!typed.iter().any(turns)).then_some(typed)
                };
                let complex = || self.read_in(response, Manner::COMPLEX, &self.lexicon).ok();
                let other = may_be_complex.then(|| constant().or_else(complex));
                other.flatten().ok_or(why)
            })
    }

    fn read_in(
        &self,
        response: &str,
        manner: Manner,
        lexicon: &Lexicon,
    ) -> Result<Vec<Expr>, Unreadable> {
        let all = Span::new(0, response.len());
        let mut places = cut(response, all, &[';', '\n']);
        places.retain(|place| !response[place.range()].trim().is_empty());
        if places.len() == 1 && self.coordinates.len() > 1 {
            places = cut(response, all, &[',']);
        }
        if let ([_], Some(at)) = (&places[..], response.find(" and ")) {
            places = vec![
                Span::new(0, at),
                Span::new(at + " and ".len(), response.len()),
            ];
        }
        let count = self.coordinates.len();
        if places.len() == 1 && count > 1 {
            let found = response::components(response, count, lexicon, manner);
            if let Some(found) = found.map_err(|error| Unreadable::typed(&error, response))? {
                return Ok(found);
            }
        }
        if places.len() != count {
            let symbols = self.symbols.iter().map(Math::plain).collect();
            return Err(Why::Functions(symbols).into());
        }
        let mut found: Vec<Option<Expr>> = vec![None; places.len()];
        for (position, place) in places.into_iter().enumerate() {
            let text = &response[place.range()];
            let named = match text.split_once('=') {
                Some((left, _)) => self.named(left, manner, lexicon)?,
                None => None,
            };
            let typed = response::formula(text, lexicon, manner)
                .map_err(|error| Unreadable::typed(&error, text))?;
            let place = named.unwrap_or(position);
            if found[place].replace(typed.value).is_some() {
                return Err(Why::TwoFunctions(self.symbols[place].plain()).into());
            }
        }
        found
            .into_iter()
            .collect::<Option<Vec<_>>>()
            .ok_or_else(|| Why::FunctionMissing.into())
    }

    /// The place of the coordinate that stands before an equals sign; none for a letter that the item does not know.
    fn named(
        &self,
        left: &str,
        manner: Manner,
        lexicon: &Lexicon,
    ) -> Result<Option<usize>, Unreadable> {
        let typed = response::formula(left, lexicon, manner);
        let is_typed = |name: &Name| {
            let typed = typed.as_ref().map(|typed| &typed.value);
            typed.is_ok_and(|typed| *typed == Expr::name(name.clone()))
        };
        let place = self.coordinates.iter().position(is_typed);
        let time = ["t".to_owned()];
        if place.is_none() && !left.trim().is_empty() && !is_fresh(left, &time) {
            let asked = self.symbols.first().map_or_else(String::new, Math::plain);
            return Err(Unreadable::at(
                left.trim(),
                Why::OtherFunction(asked + "(t)"),
            ));
        }
        Ok(place)
    }
}
