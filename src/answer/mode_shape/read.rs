//! Reads shapes: vectors by rows or by columns, with a unit or in letters.

use super::marker::{Prepared, typeset};
use super::span::vectors;
use super::{AskedScale, Setup};
use crate::answer::matrix::Written;
use crate::answer::{Answered, Reading, Unreadable, Why};
use crate::expr::{Expr, Workspace};
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::response::{Listed, Passage, Wanted};
use crate::unit::Unit;

/// How a response was read, and its vectors in SI units.
pub(crate) struct Shapes {
    pub(crate) reading: Reading,
    pub(crate) vectors: Vec<Vec<f64>>,
}

/// How a response can be read: by rows, and by columns where both are to be had.
pub(crate) fn read(key: &Prepared, response: Passage<'_>) -> Result<Vec<Shapes>, Unreadable> {
    let read = read_list(key, response);
    let Err(why) = read else {
        return read;
    };
    let setup = &key.setup;
    // Relations say nothing of the size but where the first component is one.
    let is_one = key.keys.len() == 1 && setup.scale != AskedScale::Mass;
    let solved = is_one
        .then(|| response.solved_components(key.width(), &setup.coordinates))
        .flatten();
    let is_scaled = setup.scale != AskedScale::Mass;
    let bare = |list: Passage<'_>| list.without_units_of_entries(&setup.units, is_scaled);
    let read = |list: Passage<'_>| {
        let as_it_is = read_list(key, list).ok();
        as_it_is.or_else(|| read_list(key, bare(list)?.passage()).ok())
    };
    let other = solved.and_then(|solved| read(solved.passage()));
    let other = other.or_else(|| read_list(key, bare(response)?.passage()).ok());
    let scaled = || {
        let list = response.without_common_letter();
        list.filter(|_| is_one && is_scaled)
    };
    let other = other.or_else(|| read_list(key, scaled()?.passage()).ok());
    other.ok_or(why)
}

fn read_list(key: &Prepared, response: Passage<'_>) -> Result<Vec<Shapes>, Unreadable> {
    let setup = &key.setup;
    let (width, count) = (key.width(), key.keys.len());
    // Relations say nothing of the size.
    let related = (count == 1 && setup.scale == AskedScale::Any)
        .then(|| response.related_components(width, &setup.coordinates))
        .flatten();
    let reworded = related.unwrap_or_else(|| response.ratio_as_list());
    let response = reworded.passage();
    let fits = |listed: &Listed| !arrangements(&listed.rows, width, count).is_empty();
    let wanted = if setup.scale == AskedScale::Any {
        Wanted::Direction
    } else {
        Wanted::Vector
    };
    let listed = response.list(&setup.lexicon, &setup.units, wanted, fits);
    let listed = listed.map_err(|error| Unreadable::typed(&error, response))?;
    let has_names = !listed.is_numeric();
    let Listed { rows, unit } = listed;
    let arrangements = arrangements(&rows, width, count);
    if arrangements.is_empty() {
        return Err(misfit(&rows, width, count).into());
    }
    if let Some(unit) = unit {
        check_unit(setup, &unit)?;
    }
    if has_names && setup.written == Written::Number {
        return Err(Why::NumbersNotFormulas.into());
    }
    let shapes = arrangements.iter().map(|entries| {
        let mut numbers = values(key, entries)?;
        if !has_names {
            for (place, number) in numbers.iter_mut().enumerate() {
                let own = setup.units.get(place).copied();
                // A unit is only a scale, where any will do.
                let stated = unit.filter(|_| setup.scale == AskedScale::Mass);
                *number = stated.or(own).unwrap_or(Unit::ONE).to_si(*number);
            }
        }
        Some(Shapes {
            vectors: vectors(&numbers, width),
            reading: reading(key, entries, unit.as_ref(), numbers),
        })
    });
    let shapes: Option<Vec<Shapes>> = shapes.collect();
    shapes.ok_or_else(|| Why::ComponentValue.into())
}

/// Refuses a unit that can be no unit of all components.
fn check_unit(setup: &Setup, unit: &Unit) -> Result<(), Unreadable> {
    let mut own = setup.units.iter();
    let Some(first) = own.next() else {
        return Ok(());
    };
    if own.any(|other| other.dimension() != first.dimension()) {
        return Err(Unreadable::at(unit.text(), Why::UnitOfComponents));
    }
    if setup.scale == AskedScale::Mass && unit.dimension() != first.dimension() {
        return Err(Unreadable::at(unit.text(), Why::UnitOfShape(*first)));
    }
    Ok(())
}

fn reading(key: &Prepared, entries: &[Expr], unit: Option<&Unit>, si: Vec<f64>) -> Reading {
    let width = key.width();
    let set = entries
        .iter()
        .map(|entry| entry.typeset(&key.setup.lexicon));
    let mut math = typeset(&set.collect::<Vec<_>>(), width);
    let vectors = entries.chunks(width.max(1)).map(|row| {
        let texts = row.iter().map(ToString::to_string);
        format!("[{}]", texts.collect::<Vec<_>>().join(", "))
    });
    let vectors: Vec<String> = vectors.collect();
    let mut text = match &vectors[..] {
        [one] => one.clone(),
        many => format!("[{}]", many.join(", ")),
    };
    if let Some(unit) = unit {
        math = Math::row([math, Math::thin_space(), unit.math()]);
        text = format!("{text} {unit}");
    }
    let answered = Answered::Shapes(si);
    Reading {
        math,
        text,
        answered,
    }
}

/// The numbers of entries for these data.
fn values(key: &Prepared, entries: &[Expr]) -> Option<Vec<f64>> {
    let mut room = Workspace::default();
    let numbers = entries.iter().map(|entry| {
        let program = key.setup.meaning.compile(entry, &SortedMap::new()).ok()?;
        program.evaluate(&key.data[..], &mut room).ok()?.as_real()
    });
    numbers.collect()
}

/// The components of this many vectors one after the other: by rows, by columns, or in one row or column.
fn arrangements(rows: &[Vec<Expr>], width: usize, count: usize) -> Vec<Vec<Expr>> {
    let columns = rows.first().map_or(0, Vec::len);
    let mut arrangements = Vec::new();
    let is_line = rows.len() == 1 || columns == 1;
    if (rows.len(), columns) == (count, width) || is_line && rows.len() * columns == width * count {
        arrangements.push(rows.concat());
    }
    if (rows.len(), columns) == (width, count) && !is_line {
        let by_columns = (0..columns).flat_map(|column| rows.iter().map(move |row| &row[column]));
        arrangements.push(by_columns.cloned().collect());
    }
    arrangements
}

fn misfit(rows: &[Vec<Expr>], width: usize, count: usize) -> Why {
    let found = rows.iter().map(Vec::len).sum();
    if count == 1 {
        let asked = width;
        return Why::Components { found, asked };
    }
    Why::ShapesOf {
        found,
        rows: rows.len(),
        shapes: count,
        width,
    }
}
