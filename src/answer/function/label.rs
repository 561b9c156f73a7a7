//! What stands before the equals signs of a function: its name, that of another, or other forms of it.

use crate::answer::{Declare, Role, Unreadable, Why};
use crate::expr::{Expr, Kind, Name};
use crate::math::{Math, symbol};
use crate::response::{self, Lexicon, Manner, cut, is_dotted};
use crate::source::{Span, lower};

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
    pub(crate) fn asked<'r>(&self, response: &'r str) -> Result<&'r str, Unreadable> {
        let all = Span::new(0, response.len());
        let pieces: Vec<&str> = cut(response, all, &[';', '\n'])
            .into_iter()
            .map(|place| response[place.range()].trim())
            .filter(|piece| !piece.is_empty())
            .collect();
        if pieces.len() < 2 {
            return Ok(response);
        }
        let is_own = |piece: &&&str| {
            let (left, rest) = split(piece);
            rest.is_some() && matches!(self.side(left), Ok(Side::Own))
        };
        match &pieces.iter().filter(is_own).collect::<Vec<_>>()[..] {
            [one] => Ok(one),
            _ => Err(Why::OneFunction(self.asked.clone()).into()),
        }
    }

    /// What is after the last equals sign, and the other forms before it.
    pub(crate) fn forms<'r>(&self, response: &'r str) -> Result<(&'r str, Vec<Expr>), Unreadable> {
        let mut forms = Vec::new();
        let mut rest = response;
        let mut is_first = true;
        while let (left, Some(behind)) = split(rest) {
            if is_first && left.trim().is_empty() {
                (is_first, rest) = (false, behind);
                continue;
            }
            // `The motion is x(t) = …` names it after words.
            let left = match response::described(left) {
                Some("") if is_first && !is_of_rate(left) => {
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
                    return Err(Unreadable::at(
                        left.trim(),
                        Why::OtherFunction(self.asked.clone()),
                    ));
                }
                Err(help) if !is_first => return Err(help),
                Err(_) if self.is_fresh(left) => {}
                Err(_) => {
                    return Err(Unreadable::at(
                        left.trim(),
                        Why::UnclearFunction(self.asked.clone()),
                    ));
                }
            }
            is_first = false;
            rest = behind;
        }
        Ok((rest, forms))
    }

    /// What the text before an equals sign is; `x(t) [m]` has its unit after it.
    fn side(&self, text: &str) -> Result<Side, Unreadable> {
        let text = without_unit(text);
        let typed = response::formula(text, &self.lexicon, Manner::REAL);
        let value = typed
            .map_err(|error| Unreadable::typed(&error, text))?
            .value;
        Ok(match value.kind() {
            Kind::Name(name) if self.own.contains(name) => Side::Own,
            Kind::Name(_) | Kind::Prime(..) => Side::Other,
            _ => Side::Formula(value),
        })
    }

    /// Whether a text is a letter that the item does not know, which anybody may choose for what is asked: no
    /// derivative, nor one of those for velocity and acceleration, nor its value elsewhere, `x(0)`, `x(2t)`.
    fn is_fresh(&self, text: &str) -> bool {
        is_fresh(text, &self.arguments)
    }
}

/// The same for a function of these arguments.
pub(crate) fn is_fresh(text: &str, arguments: &[String]) -> bool {
    let text = without_unit(text);
    let (name, behind) = match text.find('(') {
        Some(open) => (text[..open].trim(), &text[open..]),
        None => (text, ""),
    };
    let argument = behind
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let is_of_variable = behind.is_empty()
        || argument.is_some_and(|own| arguments.iter().any(|known| known == own.trim()));
    let is_name =
        |char: char| (char.is_alphanumeric() || "_\\{}".contains(char)) && !is_dotted(char);
    is_of_variable
        && name.starts_with(|char: char| char.is_alphabetic() || char == '\\')
        && name.chars().all(is_name)
        && !name.contains("dot")
        && !["v", "a"].contains(
            &name.trim_end_matches(|char: char| char.is_ascii_digit() || "_{}".contains(char)),
        )
}

/// Whether words describe a rate of what is asked.
fn is_of_rate(words: &str) -> bool {
    const RATES: [&str; 6] = [
        "velocity",
        "acceleration",
        "speed",
        "rate",
        "vitesse",
        "accélération",
    ];
    words
        .split_whitespace()
        .any(|word| RATES.contains(&lower(word).as_str()))
}

fn without_unit(text: &str) -> &str {
    let text = text.trim();
    let bracket = text.rfind('[').filter(|_| text.ends_with(']'));
    bracket.map_or(text, |at| text[..at].trim_end())
}

/// A text before and after its first equals sign.
fn split(text: &str) -> (&str, Option<&str>) {
    let found = text.char_indices().find(|(_, char)| "=≈".contains(*char));
    match found {
        Some((at, char)) => (
            &text[..at],
            Some(text[at + char.len_utf8()..].trim_start_matches('=')),
        ),
        None => (text, None),
    }
}
