//! The route that a solution prints: its last line with numbers, computed as a student computes it.
//!
//! Who follows hints and solution works with the values that are printed there, those of earlier parts among them,
//! and not with the formula of the key in the data.

use super::typed;
use crate::answer::AnswerKind;
use crate::bank::{Passage, Piece, Target, Units};
use crate::document::{Block, Form};
use crate::expr::{Expr, Kind as Node, Name, Precise, Program, Slots, Value, Workspace};
use crate::math::{Class, Holes, Math, symbol};
use crate::quantity::NodeId;
use crate::response::{self, Folded, Lexicon, Manner};
use crate::scene::shown_in;
use crate::solution::Solution;
use crate::unit::{Decimal, DecimalMark, Unit};

/// What the line before the key gives for a part, as it is typed; nothing where the solution has no such line.
pub(crate) fn printed(solution: &Solution<'_>, place: usize) -> Option<String> {
    let part = &solution.template().parts[place];
    let keys = part.answer.keys();
    let ([key], AnswerKind::Numeric) = (&keys[..], part.answer.kind()) else {
        return None;
    };
    let value = by_lines(solution, &part.solution, *key)?;
    typed::value(&value, part.answer.unit(), part.answer.figures())
}

fn by_lines(solution: &Solution<'_>, passage: &Passage, key: NodeId) -> Option<Value> {
    let shown = passage.pieces.iter().filter(|piece| {
        piece
            .when
            .is_none_or(|when| solution.evaluation().holds(when) == Ok(true))
    });
    shown
        .filter_map(|piece| worked(solution, piece, key).or_else(|| written(solution, piece, key)))
        .last()
}

/// The quantity that a key is, where it only names one.
fn named(solution: &Solution<'_>, key: NodeId) -> NodeId {
    let graph = &solution.template().graph;
    match graph.expr(key).map(Expr::kind) {
        Some(Node::Name(name)) => graph.find(name).unwrap_or(key),
        _ => key,
    }
}

/// `<< key.worked >>`: the formula of the key, with the values that are printed in it.
fn worked(solution: &Solution<'_>, piece: &Piece, key: NodeId) -> Option<Value> {
    let own = named(solution, key);
    let forms = piece.document.placeholders().iter().zip(&piece.targets);
    let is_worked = |(placeholder, target): (&crate::document::Placeholder, &Target)| {
        placeholder.form == Form::Worked && *target == Target::Node(own)
    };
    if !forms.into_iter().any(is_worked) {
        return None;
    }
    let rounded = shown_in(solution.template(), own)
        .into_iter()
        .filter_map(|node| Some((node, as_printed(solution, node)?)));
    let evaluation = solution.evaluation().replacing(rounded.collect());
    evaluation.value(own).ok().cloned()
}

/// A display that ends in the key: the side before it, with the values that are printed in it.
fn written(solution: &Solution<'_>, piece: &Piece, key: NodeId) -> Option<Value> {
    let own = named(solution, key);
    let is_key = |side: &[Math]| match side {
        [Math::Hole(hole), rest @ ..] => {
            let is_own = piece.targets.get(*hole as usize) == Some(&Target::Node(own));
            is_own && rest.first().is_none_or(is_end)
        }
        _ => false,
    };
    piece
        .document
        .blocks()
        .iter()
        .filter_map(|block| match block {
            Block::Display(math) => Some(math),
            _ => None,
        })
        .filter_map(|math| {
            let sides = sides(math);
            let place = sides.iter().rposition(|side| is_key(side))?;
            computed(solution, piece, sides.get(place.checked_sub(1)?)?)
        })
        .last()
}

/// What ends a formula in a line of text.
fn is_end(math: &Math) -> bool {
    match math {
        Math::Operator { text, class } => *class == Class::Punctuation || text == ".",
        Math::Text(text) => text.starts_with(['.', ',', ';']),
        Math::Space(_) => true,
        _ => false,
    }
}

/// The sides of a chain of equations.
fn sides(math: &Math) -> Vec<Vec<Math>> {
    let mut atoms = Vec::new();
    flatten(math, &mut atoms);
    let is_equal = |atom: &Math| matches!(atom, Math::Operator { text, class: Class::Relation } if text == "=" || text == "≈");
    atoms.split(is_equal).map(<[Math]>::to_vec).collect()
}

fn flatten(math: &Math, atoms: &mut Vec<Math>) {
    match math {
        Math::Row(pieces) => pieces.iter().for_each(|piece| flatten(piece, atoms)),
        Math::Table { rows, .. } => rows.iter().flatten().for_each(|cell| flatten(cell, atoms)),
        other => atoms.push(other.clone()),
    }
}

/// Letters in the places of values.
struct ValueLetters(Vec<Math>);

impl Holes for ValueLetters {
    fn filling(&self, hole: u32) -> Option<&Math> {
        self.0.get(hole as usize)
    }
}

/// The value of a side, read as a student reads it; nothing if letters stand in it that have no printed value.
fn computed(solution: &Solution<'_>, piece: &Piece, side: &[Math]) -> Option<Value> {
    let names: Vec<String> = (0..piece.targets.len())
        .map(|hole| format!("q{hole}"))
        .collect();
    let mut lexicon = Lexicon::new();
    for name in &names {
        lexicon.allow(&Name::new(name.as_str()), symbol(name), false);
    }
    let letters = ValueLetters(names.iter().map(|name| symbol(name)).collect());
    let mut text = String::new();
    Math::row(side.iter().cloned()).write_latex(&mut text, &letters);
    let folded = Folded::of(&text);
    let folded = folded
        .as_ref()
        .map_or(response::Passage::default(), Folded::passage);
    let manner = Manner {
        comma_is_decimal: false,
        has_imaginary_unit: false,
        values: Some(DecimalMark::Point),
        ..Manner::default()
    };
    let read = folded.formula(&lexicon, manner).ok()?.value;
    let used = read.names();
    let holes: Vec<usize> = (0..names.len())
        .filter(|hole| used.uses(&Name::new(names[*hole].as_str())))
        .collect();
    let mut data = vec![Precise::exact(0.0); names.len()];
    for hole in &holes {
        let form = piece.document.placeholders().get(*hole)?.form;
        let (Target::Node(node), Form::Value) = (&piece.targets[*hole], form) else {
            return None;
        };
        let number = match as_printed(solution, *node) {
            Some(value) => value.as_real()?,
            None => solution.evaluation().real(*node).ok()?,
        };
        data[*hole] = Precise::exact(number);
    }
    let texts: Vec<&str> = names.iter().map(String::as_str).collect();
    let program = Program::compile(&read, &Slots(&texts)).ok()?;
    let value = program
        .evaluate(&data[..], &mut Workspace::default())
        .ok()?;
    (!holes.is_empty()).then_some(value)
}

/// A value as it is printed, in SI units; nothing for a datum, which is printed in full.
fn as_printed(solution: &Solution<'_>, node: NodeId) -> Option<Value> {
    let template = solution.template();
    let info = template
        .info(node)
        .filter(|info| info.parameter.is_none())?;
    let value = solution.evaluation().value(node).ok()?;
    let unit = |at: usize| match &info.units {
        Some(Units::One(unit)) => *unit,
        Some(Units::Each(units)) => units.get(at).copied().unwrap_or(Unit::ONE),
        None => Unit::ONE,
    };
    let numbers = value.numbers().iter().enumerate().map(|(at, si)| {
        let own = unit(at);
        let is_integer = own.is_one() && *si == si.round();
        let rounded = Decimal::rounded(own.of_si(*si), u32::from(info.digits));
        match rounded.filter(|_| !is_integer) {
            Some(decimal) => own.to_si(decimal.to_f64()),
            None => *si,
        }
    });
    Value::new(
        value.form(),
        numbers.collect(),
        vec![0.0; value.numbers().len()],
    )
}
