//! Lists, vectors and matrices as people type them: `(1, 0.618)`, `[1; -2]`, `[[3m, 0], [0, m]]`.

use super::before_unit::with_unit;
use super::frame::{balanced, groups, is_transposed_name};
use super::identity::identity_in;
use super::labels::{by_indices, in_order, labelled};
use super::layout::{has_signed_gap, laid_out, spaced};
use super::parser::Parser;
use super::signs::is_between_digits;
use super::words::is_function;
use super::{Lexicon, MAX_DEPTH, MAX_LENGTH, Manner, Trouble, Typed, TypedError, read};
use vibank_formula::expr::Expr;
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// The longest list in bytes whose letters may be in the other case: programs, which print longer ones, keep the case.
const MAX_RESPELT: usize = 400;

/// Most entries that are read.
const MAX_ENTRIES: usize = 400;
/// Most brackets around one another that are lists.
const MAX_NESTED: u32 = 4;
/// What parts rows and entries; `&` as in LaTeX.
const SEPARATORS: &[char] = &[',', ';', '&'];

/// What a list is to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// A matrix; with its rows where it has as many columns: then multiples of the identity are read.
    Matrix(Option<usize>),
    /// A vector, whose components are compared one by one.
    Vector,
    /// A vector up to a factor, which may be a letter that is not a name.
    Direction,
}

/// A list of formulas by rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The entries, each row as long as the others.
    pub rows: Vec<Vec<Expr>>,
    /// The unit of all entries.
    pub unit: Option<Unit>,
}

impl Listed {
    /// Whether all entries are numbers.
    pub fn is_numeric(&self) -> bool {
        let mut entries = self.rows.iter().flatten();
        entries.all(|entry| entry.names().free.is_empty())
    }
}

/// Reads a list of the form that is asked. A comma parts entries, but is a decimal sign where only so the list has that
/// form; entries may also be parted by spaces. A list of another form is as it was typed.
pub(crate) fn list_of_form(
    text: &str,
    lexicon: &Lexicon,
    units: &[Unit],
    wanted: Wanted,
    fits: impl Fn(&Listed) -> bool,
) -> Result<Listed, TypedError> {
    let bars = ["\\begin{vmatrix}", "\\begin{Vmatrix}"];
    if let Some(at) = bars.iter().find_map(|bars| text.find(bars)) {
        return Err(TypedError::new(
            Trouble::Determinant,
            at,
            at + bars[0].len(),
        ));
    }
    let plain = laid_out(text);
    let spaced = spaced(&plain);
    let mut ways = vec![
        (false, &plain),
        (false, &spaced),
        (true, &plain),
        (true, &spaced),
    ];
    if has_signed_gap(&plain) {
        // Of `[1 -0,34]` the minus is the sign of a number.
        ways.rotate_right(1);
    }
    let mut others = Vec::new();
    for (comma_is_decimal, text) in ways {
        let manner = Manner {
            comma_is_decimal,
            ..Manner::default()
        };
        let listed = list(text, lexicon, manner, units, wanted);
        let is_final = match &listed {
            Ok(listed) => fits(listed),
            Err(error) => matches!(error.trouble, Trouble::UnitOrLetter | Trouble::Order),
        };
        if is_final {
            return listed;
        }
        others.push(listed);
    }
    // `[[M1, 0], [0, M2]]` for m₁ and m₂, where the only trouble is a letter that is not known.
    let mut troubles = others
        .iter()
        .map(|listed| listed.as_ref().err().map(|own| &own.trouble));
    if text.len() <= MAX_RESPELT
        && troubles.all(|trouble| matches!(trouble, Some(Trouble::Unknown { .. })))
    {
        let manner = Manner::default().in_any_case();
        let listed = list(&plain, lexicon, manner, units, wanted);
        if let Ok(listed) = listed
            && fits(&listed)
        {
            return Ok(listed);
        }
    }
    let typed = others.iter().position(Result::is_ok).unwrap_or(0);
    others.swap_remove(typed)
}

/// The entries of a list by rows; a list without rows is one row.
pub(crate) fn list(
    text: &str,
    lexicon: &Lexicon,
    manner: Manner,
    units: &[Unit],
    wanted: Wanted,
) -> Result<Listed, TypedError> {
    if text.len() > MAX_LENGTH {
        return Err(TypedError::new(Trouble::TooLong, MAX_LENGTH, text.len()));
    }
    balanced(text)?;
    let reader = Reader {
        text,
        lexicon,
        manner,
        units,
        wanted,
    };
    let end = text.trim_end_matches(|char: char| char.is_whitespace() || ";,.".contains(char));
    let whole = Span::new(0, end.len());
    let listed = reader.framed(whole, 0)?;
    match &listed.unit {
        // `m2  mm` is a unit where `m^2 mm` is one of letters: the echo could not say which was read.
        Some(unit) if !reader.is_asked(unit) && reader.is_of_letters(unit) => Err(TypedError {
            trouble: Trouble::UnitOrLetter,
            span: whole,
        }),
        _ => Ok(listed),
    }
}

pub(crate) struct Reader<'a> {
    pub(crate) text: &'a str,
    pub(crate) lexicon: &'a Lexicon,
    pub(crate) manner: Manner,
    /// Those of what is asked.
    pub(crate) units: &'a [Unit],
    pub(crate) wanted: Wanted,
}

impl Reader<'_> {
    pub(crate) fn is_asked(&self, unit: &Unit) -> bool {
        let dimension = unit.dimension();
        self.units.iter().any(|own| own.dimension() == dimension)
    }

    /// Whether a unit, as it is printed, is a formula of the letters of the answer.
    fn is_of_letters(&self, unit: &Unit) -> bool {
        let printed = unit.to_string();
        let read = self.formula_in(&printed, Span::new(0, printed.len()));
        read.is_ok_and(|formula| !formula.value.names().free.is_empty())
    }

    /// Where the identity stands in a piece where a matrix of known size is asked, and how many rows it has.
    fn identity(&self, piece: Span) -> Option<(Span, usize)> {
        match self.wanted {
            Wanted::Matrix(Some(rows)) => identity_in(self.text, piece, rows, self.lexicon),
            _ => None,
        }
    }

    /// A list with what stands around it.
    fn framed(&self, piece: Span, depth: u32) -> Result<Listed, TypedError> {
        let piece = trimmed(self.text, piece);
        if self.pieces(piece, SEPARATORS).len() > 1 {
            return self.bare(piece, depth);
        }
        let (label, piece) = labelled(self.text, piece);
        in_order(self.text, &[label])?;
        let mut listed = self.unlabelled(piece, depth)?;
        let is_matrix = matches!(self.wanted, Wanted::Matrix(_));
        if is_matrix && label.is_some_and(|label| is_transposed_name(&self.text[label.range()])) {
            listed.rows = transposed(&listed.rows);
        }
        Ok(listed)
    }

    /// A list, or a sum of such, without a symbol before it.
    fn unlabelled(&self, piece: Span, depth: u32) -> Result<Listed, TypedError> {
        // Shapes of a free scale are not added: which scale each of them has is open.
        if self.wanted != Wanted::Direction
            && let Some(terms) = self.terms(piece, depth)
        {
            return self.sum(&terms, depth);
        }
        let list = self.list_in(piece, depth).or_else(|| {
            let groups = groups(self.text, piece);
            groups.first().copied().filter(|group| *group == piece)
        });
        let Some(list) = list else {
            return match self.identity(piece) {
                Some((identity, size)) => self.multiple_of_identity(piece, identity, size),
                None => self.bare(piece, depth),
            };
        };
        let Listed { mut rows, unit } = self.body(inside(list), depth)?;
        let frame = self.frame(piece, list)?;
        if frame.is_transposed {
            rows = transposed(&rows);
        }
        if frame.is_diagonal {
            rows = diagonal(&rows.concat());
        }
        if let Some(factor) = frame.factor {
            for entry in rows.iter_mut().flatten() {
                *entry = factor.clone() * entry.clone();
                if entry.depth() > MAX_DEPTH {
                    return Err(TypedError {
                        trouble: Trouble::TooDeep,
                        span: piece,
                    });
                }
            }
        }
        let unit = frame.unit.or(unit);
        Ok(Listed { rows, unit })
    }

    /// The multiple of the identity that a piece is: a one in place of the identity shows what multiplies it.
    fn multiple_of_identity(
        &self,
        piece: Span,
        identity: Span,
        size: usize,
    ) -> Result<Listed, TypedError> {
        const ONE: &str = "(1)";
        let (start, end) = (identity.range().start, identity.range().end);
        let before = &self.text[..start];
        let text = format!("{before}{ONE}{}", &self.text[end..piece.range().end]);
        let reader = Reader {
            text: &text,
            ..*self
        };
        let whole = Span::new(piece.range().start, text.len());
        let frame = reader.frame(whole, Span::new(start, start + ONE.len()));
        let frame = frame.map_err(|error| TypedError {
            span: piece,
            ..error
        })?;
        let factor = frame.factor.unwrap_or_else(|| Expr::number(1));
        Ok(Listed {
            rows: diagonal(&vec![factor; size]),
            unit: frame.unit,
        })
    }

    /// The terms of a sum of lists, each with its sign; `None` where a piece is no such sum.
    fn terms(&self, piece: Span, depth: u32) -> Option<Vec<Span>> {
        let start = piece.range().start;
        let pieces = cut_where(self.text, piece, |at, char| {
            let before = self.text[start..at].trim_end();
            // Another sign belongs to the number after it.
            matches!(char, '+' | '-')
                && before.ends_with(|last: char| last.is_alphanumeric() || ")]}".contains(last))
        });
        if pieces.len() == 1 {
            return None;
        }
        let with_signs = pieces.iter().map(|piece| match piece.range().start {
            own if own == start => *piece,
            own => Span::new(own - 1, piece.range().end),
        });
        let terms: Vec<Span> = with_signs.collect();
        let mut lists = terms.iter();
        lists
            .all(|term| self.list_in(*term, depth).is_some() || self.identity(*term).is_some())
            .then_some(terms)
    }

    /// The sum of lists of one size, entry by entry.
    fn sum(&self, terms: &[Span], depth: u32) -> Result<Listed, TypedError> {
        let mut sum: Option<Listed> = None;
        for term in terms {
            let refuse = |trouble| TypedError {
                trouble,
                span: *term,
            };
            let own = match self.text[term.range()].strip_prefix('+') {
                Some(_) => Span::new(term.range().start + 1, term.range().end),
                None => *term,
            };
            let listed = self.framed(own, depth)?;
            let Some(all) = &mut sum else {
                sum = Some(listed);
                continue;
            };
            let sizes = |list: &Listed| list.rows.iter().map(Vec::len).collect::<Vec<_>>();
            if sizes(all) != sizes(&listed) {
                return Err(refuse(Trouble::Ragged));
            }
            if all.unit != listed.unit {
                return Err(refuse(Trouble::UnitOfEntry));
            }
            let entries = all.rows.iter_mut().flatten();
            for (entry, own) in entries.zip(listed.rows.into_iter().flatten()) {
                *entry = entry.clone() + own;
                if entry.depth() > MAX_DEPTH {
                    return Err(refuse(Trouble::TooDeep));
                }
            }
        }
        let nothing = terms.first().copied().unwrap_or(Span::NONE);
        sum.ok_or(TypedError {
            trouble: Trouble::LeftOver,
            span: nothing,
        })
    }

    /// A list without brackets, after which a unit may stand.
    fn bare(&self, span: Span, depth: u32) -> Result<Listed, TypedError> {
        let listed = self.body(span, depth);
        if depth > 0 {
            return listed;
        }
        let last = self.pieces(span, SEPARATORS).pop().unwrap_or(span);
        let last = labelled(self.text, last).1;
        let units = with_unit(&self.text[last.range()]).filter_map(|(number, unit)| {
            let end = last.range().start + number.len();
            let number = self.formula(Span::new(last.range().start, end)).ok()?;
            number.names().free.is_empty().then_some((end, unit))
        });
        let units: Vec<(usize, Unit)> = units.collect();
        let asked = units.iter().find(|(_, unit)| self.is_asked(unit));
        let Some((end, unit)) = asked.or(units.first()) else {
            return listed;
        };
        let numbers = self.body(Span::new(span.range().start, *end), depth);
        let Some(Listed { rows, .. }) = numbers.ok().filter(Listed::is_numeric) else {
            return listed;
        };
        match listed {
            Ok(listed) if listed.is_numeric() => Ok(listed),
            Ok(listed) if asked.is_none() && rows.concat().len() == 1 => Ok(listed),
            Ok(_) if asked.is_none() => Err(TypedError {
                trouble: Trouble::UnitOrLetter,
                span: last,
            }),
            _ => Ok(Listed {
                rows,
                unit: Some(*unit),
            }),
        }
    }

    /// What stands between brackets, or without any: rows in brackets of their own, or parted by semicolons.
    fn body(&self, span: Span, depth: u32) -> Result<Listed, TypedError> {
        let pieces = self.pieces(span, SEPARATORS);
        let labels: Vec<_> = pieces
            .iter()
            .map(|piece| labelled(self.text, *piece).0)
            .collect();
        if let Some(rows) = by_indices(self.text, &pieces) {
            return self.placed(&rows);
        }
        in_order(self.text, &labels)?;
        let mut texts = pieces.iter().map(|piece| self.text[piece.range()].trim());
        let has_rows = pieces
            .iter()
            .any(|piece| self.list_in(*piece, depth).is_some())
            || pieces.len() > 1
                && texts.all(|own| own.starts_with(['[', '{']) && own.ends_with([']', '}']));
        if let [one] = &pieces[..]
            && (has_rows || self.identity(*one).is_some())
        {
            return self.framed(*one, depth + 1);
        }
        let (mut rows, mut unit) = (Vec::new(), None);
        let mut entry_units = Vec::new();
        if has_rows {
            for (place, piece) in pieces.iter().enumerate() {
                let row = self.framed(*piece, depth + 1)?;
                let is_same = row.unit == unit;
                // One after the last row is that of all.
                if place > 0 && !is_same && (unit.is_some() || place + 1 < pieces.len()) {
                    return Err(TypedError {
                        trouble: Trouble::UnitOfEntry,
                        span: *piece,
                    });
                }
                unit = row.unit;
                rows.push(row.rows.concat());
            }
        } else {
            for row in self.pieces(span, &[';']) {
                let entries = self.pieces(row, &[',', '&']);
                let mut read = Vec::new();
                for place in entries {
                    let (entry, own) = self.entry(place)?;
                    entry_units.push((own.filter(|_| !entry.is_zero()), entry.is_zero(), place));
                    read.push(entry);
                }
                rows.push(read);
            }
            unit = common(&entry_units)?;
        }
        if rows.iter().map(Vec::len).sum::<usize>() > MAX_ENTRIES {
            return Err(TypedError {
                trouble: Trouble::TooLong,
                span,
            });
        }
        if rows.iter().any(|row| row.len() != rows[0].len()) {
            return Err(TypedError {
                trouble: Trouble::Ragged,
                span,
            });
        }
        Ok(Listed { rows, unit })
    }

    /// The rows of entries that stand at these places.
    fn placed(&self, rows: &[Vec<Span>]) -> Result<Listed, TypedError> {
        let mut units = Vec::new();
        let mut read = |place: &Span| {
            let (entry, own) = self.entry(*place)?;
            units.push((own.filter(|_| !entry.is_zero()), entry.is_zero(), *place));
            Ok(entry)
        };
        let mut row = |places: &Vec<Span>| places.iter().map(&mut read).collect();
        let rows = rows.iter().map(&mut row).collect::<Result<_, _>>()?;
        let unit = common(&units)?;
        Ok(Listed { rows, unit })
    }

    /// An entry, and the unit after it.
    fn entry(&self, place: Span) -> Result<(Expr, Option<Unit>), TypedError> {
        let place = labelled(self.text, place).1;
        self.formula(place)
            .map(|entry| (entry, None))
            .or_else(|error| {
                let start = place.range().start;
                let entry = with_unit(&self.text[place.range()]).find_map(|(value, unit)| {
                    let value = Span::new(start, start + value.len());
                    Some((self.formula(value).ok()?, unit))
                });
                match entry {
                    Some((entry, unit)) if entry.names().free.is_empty() => Ok((entry, Some(unit))),
                    Some(_) => Err(TypedError {
                        trouble: Trouble::UnitOfEntry,
                        span: place,
                    }),
                    None => Err(error),
                }
            })
    }

    fn formula(&self, place: Span) -> Result<Expr, TypedError> {
        Ok(self.formula_in(self.text, place)?.value)
    }

    pub(crate) fn formula_in(&self, text: &str, place: Span) -> Result<Typed<Expr>, TypedError> {
        let (from, to) = (place.range().start, place.range().end);
        let whole = |parser: &mut Parser<'_>| parser.whole_formula();
        read(text, from, to, self.lexicon, self.manner, whole)
    }

    /// The first bracket in a piece that holds a list.
    fn list_in(&self, piece: Span, depth: u32) -> Option<Span> {
        groups(self.text, piece).into_iter().find(|group| {
            let before = &self.text[..group.range().start];
            let word = before.trim_end_matches(|char: char| char.is_ascii_alphanumeric());
            let is_argument = before.ends_with(['_', '^']) || is_function(&before[word.len()..]);
            let inside = inside(*group);
            !is_argument
                && depth < MAX_NESTED
                && (self.pieces(inside, SEPARATORS).len() > 1
                    || self.list_in(inside, depth + 1).is_some())
        })
    }

    /// The pieces between signs that stand in no bracket and are no decimal comma.
    fn pieces(&self, span: Span, signs: &[char]) -> Vec<Span> {
        cut_where(self.text, span, |at, char| {
            let is_decimal =
                char == ',' && self.manner.comma_is_decimal && is_between_digits(self.text, at);
            signs.contains(&char) && !is_decimal
        })
    }
}

/// The unit of entries that all have the same one or none; zero needs none.
fn common(entries: &[(Option<Unit>, bool, Span)]) -> Result<Option<Unit>, TypedError> {
    let unit = entries.iter().find_map(|(unit, ..)| *unit);
    let mut entries = entries.iter();
    match entries.find(|(own, is_zero, _)| !is_zero && *own != unit) {
        Some((.., place)) => Err(TypedError {
            trouble: Trouble::UnitOfEntry,
            span: *place,
        }),
        None => Ok(unit),
    }
}

fn inside(group: Span) -> Span {
    Span::new(group.range().start + 1, group.range().end - 1)
}

fn transposed(rows: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    let width = rows.first().map_or(0, Vec::len);
    let column = |at: usize| rows.iter().map(|row| row[at].clone()).collect();
    (0..width).map(column).collect()
}

fn diagonal(entries: &[Expr]) -> Vec<Vec<Expr>> {
    let mut rows = vec![vec![Expr::number(0); entries.len()]; entries.len()];
    for (place, entry) in entries.iter().enumerate() {
        rows[place][place] = entry.clone();
    }
    rows
}

pub(crate) fn trimmed(text: &str, span: Span) -> Span {
    let inner = &text[span.range()];
    let start = span.range().start + inner.len() - inner.trim_start().len();
    Span::new(start, start + inner.trim().len())
}

/// The pieces between signs that stand in no bracket.
pub(crate) fn cut(text: &str, span: Span, signs: &[char]) -> Vec<Span> {
    cut_where(text, span, |_, char| signs.contains(&char))
}

/// The pieces between places that stand in no bracket.
pub(crate) fn cut_where(text: &str, span: Span, parts: impl Fn(usize, char) -> bool) -> Vec<Span> {
    let (mut pieces, mut start, mut depth) = (Vec::new(), span.range().start, 0_usize);
    for (at, char) in text[span.range()].char_indices() {
        let at = span.range().start + at;
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ if depth == 0 && parts(at, char) => {
                pieces.push(Span::new(start, at));
                start = at + char.len_utf8();
            }
            _ => {}
        }
    }
    pieces.push(Span::new(start, span.range().end));
    pieces
}
