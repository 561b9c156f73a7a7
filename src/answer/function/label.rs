//! What stands before the equals signs of a function: its name, that of another, or other forms of it.

use crate::answer::{Declare, Role, Unreadable, Why};
use crate::expr::{Expr, Kind, Name, Operator};
use crate::math::{Math, symbol};
use crate::response::{Lexicon, Manner, Passage};

/// The names that can stand before an equals sign.
#[derive(Debug)]
pub(crate) struct Labels {
    lexicon: Lexicon,
    /// Those of what is asked.
    own: Vec<Name>,
    /// What is asked, as a message has it.
    asked: String,
    /// What may stand in brackets after a name: the variable.
    arguments: [String; 2],
}

/// What stands before an equals sign.
enum Side {
    Own,
    Other,
    Formula(Expr),
}

impl Labels {
    /// The names of an item, of which this one is asked; any coordinate where what is asked has no name.
    pub(crate) fn of(declare: &dyn Declare, asked: Option<&Name>, variable: &Name) -> Self {
        let known = declare.known();
        let symbol_of = |name: &Name| {
            let own = known.iter().find(|own| own.name == *name);
            own.map(|own| own.symbol.plain())
        };
        let stem = asked.map(|name| name.as_str().split('_').next().unwrap_or_default());
        let is_own = |name: &Name, plain: &str, is_coordinate: bool| match asked {
            Some(asked) => {
                name == asked
                    || stem == Some(name.as_str())
                    || symbol_of(asked).as_deref() == Some(plain)
            }
            None => is_coordinate,
        };
        let (mut lexicon, mut own) = (Lexicon::new(), Vec::new());
        for of in &known {
            let is_coordinate = of.role == Role::Coordinate;
            if is_own(&of.name, &of.symbol.plain(), is_coordinate) {
                own.push(of.name.clone());
            }
            lexicon.allow(&of.name, of.symbol.clone(), true);
        }
        if let Some(stem) = stem.map(Name::new).filter(|stem| !own.contains(stem)) {
            if symbol_of(&stem).is_none() {
                lexicon.allow(&stem, symbol(stem.as_str()), true);
            }
            own.push(stem);
        }
        lexicon.allow(variable, symbol(variable.as_str()), false);
        let shown = asked.and_then(symbol_of).unwrap_or_else(|| {
            let first = own.first().map(|name| symbol(name.as_str()));
            first.as_ref().map_or("x".to_owned(), Math::plain)
        });
        Self {
            lexicon,
            own,
            asked: format!("{shown}({variable})"),
            arguments: [
                variable.as_str().to_owned(),
                symbol(variable.as_str()).plain(),
            ],
        }
    }

    /// The function that is asked, among several that are given by name, `x1 = …; x2 = …`.
    pub(crate) fn asked<'t>(&self, response: Passage<'t>) -> Result<Passage<'t>, Unreadable> {
        let pieces = response.lines();
        if pieces.len() < 2 {
            return Ok(response);
        }
        let own = pieces.into_iter().filter(|piece| {
            let sides = piece.equated();
            sides.is_some_and(|(left, _)| matches!(self.side(left), Ok(Side::Own)))
        });
        match own.collect::<Vec<_>>()[..] {
            // `q0 cos(ω0 t); ω0 = …` says what its letter is.
            [one] if !self.uses_another(one, response) => Ok(one),
            _ => Err(Why::OneFunction(self.asked.clone()).into()),
        }
    }

    /// Whether a letter stands in a statement of which another one says what it is.
    fn uses_another(&self, own: Passage<'_>, response: Passage<'_>) -> bool {
        let read = |side: Passage<'_>| Some(side.formula(&self.lexicon, Manner::REAL).ok()?.value);
        let function = own.equated().and_then(|(_, function)| read(function));
        let names = function
            .map(|function| function.names())
            .unwrap_or_default();
        let mut others = response.lines().into_iter().filter_map(Passage::equated);
        others.any(|(left, _)| {
            let other = read(left);
            let other = other.as_ref().map(Expr::kind);
            matches!(other, Some(Kind::Name(name)) if names.uses(name))
        })
    }

    /// What is after the last equals sign, and the other forms before it.
    pub(crate) fn forms<'t>(
        &self,
        response: Passage<'t>,
    ) -> Result<(Passage<'t>, Vec<Expr>), Unreadable> {
        let mut forms = Vec::new();
        let mut rest = response;
        let mut is_first = true;
        while let Some((left, behind)) = rest.equated() {
            if is_first && left.is_empty() {
                (is_first, rest) = (false, behind);
                continue;
            }
            // `The motion is x(t) = …` names it after words.
            let left = match left.described() {
                Some(own) if is_first && own.is_empty() && !left.is_of_rate() => {
                    rest = behind;
                    continue;
                }
                Some(own) if is_first => own,
                _ => left,
            };
            match self.side(left) {
                Ok(Side::Own) if is_first => {}
                Ok(Side::Formula(form)) => forms.push(form),
                Ok(_) => {
                    return Err(Unreadable::at(left, Why::OtherFunction(self.asked.clone())));
                }
                Err(help) if !is_first => return Err(help),
                // A letter that the item does not know.
                Err(_) if left.is_free_letter(&self.arguments) => {}
                Err(_) => {
                    return Err(Unreadable::at(
                        left,
                        Why::UnclearFunction(self.asked.clone()),
                    ));
                }
            }
            is_first = false;
            rest = behind;
        }
        Ok((rest, forms))
    }

    /// Whether a text is the name of what is asked.
    pub(crate) fn is_own(&self, label: Passage<'_>) -> bool {
        matches!(self.side(label), Ok(Side::Own))
    }

    fn is_variable(&self, argument: &Expr) -> bool {
        matches!(argument.kind(), Kind::Name(name) if *name.as_str() == *self.arguments[0])
    }

    /// What stands before an equals sign; `x(t) [m]` has its unit after it.
    fn side(&self, side: Passage<'_>) -> Result<Side, Unreadable> {
        let side = side.without_bracketed_unit();
        let typed = side.formula(&self.lexicon, Manner::REAL);
        let value = typed
            .map_err(|error| Unreadable::typed(&error, side))?
            .value;
        // `x (t)` with a space is no product here.
        let called = match value.kind() {
            Kind::Binary(Operator::Multiply, called, argument) if self.is_variable(argument) => {
                called
            }
            _ => &value,
        };
        Ok(match called.kind() {
            Kind::Name(name) if self.own.contains(name) => Side::Own,
            Kind::Name(_) | Kind::Prime(..) => Side::Other,
            _ => Side::Formula(value),
        })
    }
}
