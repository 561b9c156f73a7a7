//! Labels to their places: clear of lines, of bodies that they do not belong to, and of each other.
//!
//! Each label has a list of places, best first. Labels are settled in turn; each goes to the first place
//! that is free, and where none is, to the one with the least in its way.

use super::drawing::{Drawing, Obstacle, Spot, Wish};
use super::{Bounds, Fill};

/// Room between a label and a line.
const GAP: f64 = 0.05;

/// Room between two labels.
const APART: f64 = 0.06;

/// How far a label may lie from what it names; beyond that a reader looks for another owner.
const REACH: f64 = 0.45;

/// How often labels are settled again for the sake of those that found no place; two rounds do for all of the bank.
const ROUNDS: usize = 4;

/// Settles the labels that have several places. Where some find none that is free and near, all are settled again,
/// these first; the round with the fewest of them counts.
pub(crate) fn settle(drawing: &mut Drawing) {
    let mut wishes = std::mem::take(&mut drawing.wishes);
    let fixed = drawing.labels.len();
    let mut best = (usize::MAX, Vec::new());
    for _ in 0..ROUNDS {
        let strays: Vec<bool> = wishes.iter().map(|wish| is_stray(drawing, wish)).collect();
        let count = strays.iter().filter(|stray| **stray).count();
        let settled = drawing.labels.split_off(fixed);
        if count < best.0 {
            best = (count, settled);
        }
        if count == 0 {
            break;
        }
        let mut first = Vec::with_capacity(wishes.len());
        let mut later = Vec::with_capacity(wishes.len());
        for (wish, is_stray) in wishes.into_iter().zip(strays) {
            if is_stray { &mut first } else { &mut later }.push(wish);
        }
        first.append(&mut later);
        wishes = first;
    }
    drawing.labels.append(&mut best.1);
}

/// Settles a label; whether it lies on something or apart from what it names.
fn is_stray(drawing: &mut Drawing, wish: &Wish) -> bool {
    let Some((is_free, spot)) = best(drawing, wish) else {
        return false;
    };
    let near = drawing
        .letter(wish.label.clone(), wish.owner, spot)
        .grown(REACH);
    let mut own = drawing.marks.iter().filter(|mark| mark.owner == wish.owner);
    let is_alone = own.clone().next().is_none();
    let is_near = own.any(|mark| {
        let mut is_met = mark.fill != Fill::None && touches(near, mark.path.bounds());
        mark.path
            .for_each_segment(|a, b| is_met = is_met || near.chord(a, b).is_some());
        is_met
    });
    !is_free || !(is_alone || is_near)
}

/// The best place of a label, and whether nothing is in its way there.
fn best(drawing: &Drawing, wish: &Wish) -> Option<(bool, Spot)> {
    // Whatever is in the way ends the count, as long as a free place may follow.
    const ANYTHING: f64 = 1e-9;
    let first = wish.spots.first()?;
    let others = others(drawing, wish);
    // Most labels stay here; only the others are worth looking for the obstacles that any of their places
    // may meet.
    if cost(drawing, wish, first, &others, &drawing.obstacles, ANYTHING) == 0.0 {
        return Some((true, *first));
    }
    let near = near(drawing, wish);
    let is_free = |spot: &&Spot| cost(drawing, wish, spot, &others, &near, ANYTHING) == 0.0;
    if let Some(free) = wish.spots.iter().find(is_free) {
        return Some((true, *free));
    }
    let mut best = (f64::INFINITY, *first);
    for spot in &wish.spots {
        let cost = cost(drawing, wish, spot, &others, &near, best.0);
        if cost < best.0 {
            best = (cost, *spot);
        }
    }
    Some((false, best.1))
}

/// The areas of other things; not those that the labelled thing lies across, as a radius does in its disk.
fn others(drawing: &Drawing, wish: &Wish) -> Vec<Bounds> {
    let own = drawing.marks.iter().filter(|mark| mark.owner == wish.owner);
    let own = own.map(|mark| mark.path.bounds()).reduce(Bounds::joined);
    let middle = own.map(Bounds::centre);
    let areas = drawing.areas.iter().filter(|area| area.owner != wish.owner);
    areas
        .map(|area| area.bounds)
        .filter(|area| middle.is_none_or(|middle| !area.has(middle)))
        .collect()
}

/// The obstacles that any place of a label may meet.
fn near(drawing: &Drawing, wish: &Wish) -> Vec<Obstacle> {
    let boxes = wish
        .spots
        .iter()
        .map(|spot| spot.anchor.bounds(&wish.label, spot.at));
    let reach = boxes.fold(Bounds::NOTHING, Bounds::joined).grown(GAP);
    let met = |obstacle: &&Obstacle| touches(reach, obstacle.bounds);
    drawing.obstacles.iter().filter(met).copied().collect()
}

/// What is in the way of a label there; 0 if nothing. Counting stops at the limit.
fn cost(
    drawing: &Drawing,
    wish: &Wish,
    spot: &Spot,
    areas: &[Bounds],
    obstacles: &[Obstacle],
    limit: f64,
) -> f64 {
    let bounds = spot.anchor.bounds(&wish.label, spot.at);
    let mut cost = 0.0;
    let near = bounds.grown(APART);
    for other in &drawing.labels {
        // Letters over letters cannot be read; over an area they are only in the way.
        cost += 40.0 * near.overlap(other.bounds);
    }
    for area in areas {
        cost += 2.0 * bounds.overlap(*area);
    }
    for obstacle in obstacles {
        if cost >= limit {
            break;
        }
        let thick = bounds.grown(GAP + obstacle.radius);
        if touches(bounds.grown(GAP), obstacle.bounds)
            && let Some(chord) = thick.chord(obstacle.a, obstacle.b)
        {
            // Deep cuts are worse than grazing ones.
            let is_cut = bounds.chord(obstacle.a, obstacle.b).is_some();
            cost += chord + if is_cut { 1.0 } else { 0.1 };
        }
    }
    cost
}

fn touches(a: Bounds, b: Bounds) -> bool {
    a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Anchor, FigureLabel, Path, Pen, Point, Weight};

    #[test]
    fn a_label_goes_to_the_free_side() {
        let mut drawing = Drawing::new();
        let (a, b) = (Point::new(-1.0, 0.2), Point::new(1.0, 0.2));
        drawing.stroke(Path::line(a, b), Pen::new(Weight::Thin));
        let origin = Point::default();
        let spots = [Anchor::BOTTOM, Anchor::TOP].map(|anchor| Spot::new(origin, anchor));
        drawing.place(FigureLabel::words("k"), spots.to_vec());
        drawing.place(FigureLabel::words("k"), spots.to_vec());
        drawing.settle();
        assert_eq!(drawing.labels()[0].anchor, Anchor::TOP);
        // The second one finds both taken: lying on a line is better than lying on a label.
        assert_eq!(drawing.labels()[1].anchor, Anchor::BOTTOM);
    }
    #[test]
    fn a_label_makes_room_for_one_that_has_no_other_place() {
        let mut drawing = Drawing::new();
        let (a, b) = (Point::new(-1.0, 0.0), Point::new(1.0, 0.0));
        drawing.stroke(Path::line(a, b), Pen::new(Weight::Thin));
        let (above, below) = (Point::new(0.0, 0.1), Point::new(0.0, -0.1));
        let spots = [
            Spot::new(above, Anchor::BOTTOM),
            Spot::new(below, Anchor::TOP),
        ];
        drawing.place(FigureLabel::words("k"), spots.to_vec());
        drawing.place(FigureLabel::words("c"), spots[..1].to_vec());
        drawing.settle();
        let places: Vec<(String, Anchor)> = drawing
            .labels()
            .iter()
            .map(|lettering| (lettering.label.plain(), lettering.anchor))
            .collect();
        assert!(places.contains(&("c".to_owned(), Anchor::BOTTOM)));
        assert!(places.contains(&("k".to_owned(), Anchor::TOP)));
    }
}
