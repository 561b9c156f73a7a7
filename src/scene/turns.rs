//! The turning points of a motion with dry friction as lines: where, which force is left to friction, and whether it
//! holds.

use super::Scene;
use super::lines::{SetChain, aligned};
use super::notation::Symbols;
use crate::document::{Filling, Inline, Step as Shown};
use crate::expr::{Notation, Path};
use crate::math::Math;
use crate::message::Phrase;
use crate::unit::{Decimal, Dimension, Quantity, Unit};

/// Lines beyond which a list teaches nothing more; of a longer one its beginning and its end are shown.
const MAX_LINES: usize = 9;
/// Lines of the beginning of a longer list.
const FIRST_LINES: usize = 5;
/// Lines of its end: the last point that is left, and the rest.
const LAST_LINES: usize = 2;
/// Turning points that are sought; where more come, the end is not shown.
const MAX_POINTS: usize = 500;

pub(crate) fn filling(scene: &Scene<'_, '_>, path: &Path) -> Filling {
    let Some(turns) = scene.solution.evaluation().turning_points(path, MAX_POINTS) else {
        return Filling::Steps(Vec::new());
    };
    let digits = u32::from(scene.solution.template().about.digits);
    let mark = scene.solution.mark();
    let value = |si: f64, unit: Unit| {
        let number = Decimal::rounded(unit.of_si(si), digits).unwrap_or(Decimal::ZERO);
        Quantity::new(number, unit).math(mark)
    };
    let (length, force) = units(turns.dimension);
    let coordinate = Symbols(scene.solution).name(&turns.coordinate).math;
    let line = |at: usize| {
        let point = &turns.points[at];
        let number = Math::number((turns.first + at).to_string());
        let relation = if point.is_held { "≤" } else { ">" };
        let sides = [
            value(point.position, length),
            Math::row([
                Math::punctuation(":"),
                Math::Space(18),
                value(point.pull, force),
                Math::relation(relation),
                value(turns.holding, force),
            ]),
        ];
        SetChain {
            sides: vec![coordinate.clone().with_sub(number), Math::row(sides)],
            is_approximate: false,
        }
    };
    let count = turns.points.len();
    let set = |places: std::ops::Range<usize>| aligned(&places.map(line).collect::<Vec<_>>());
    let lines = if count <= MAX_LINES {
        set(0..count)
    } else {
        let mut lines = set(0..FIRST_LINES);
        lines.push([
            Math::row([]),
            Math::text(scene.language.phrase(&Phrase::AndSoOnUntil)),
        ]);
        lines.extend(set(count - LAST_LINES..count));
        lines
    };
    Filling::Steps(vec![Shown {
        words: vec![Inline::Text(scene.language.phrase(&Phrase::TurningPoints))],
        lines,
    }])
}

/// The coherent units of a coordinate and of what acts along it.
fn units(dimension: Dimension) -> (Unit, Unit) {
    let unit = |text: &str| Unit::parse(text).unwrap_or(Unit::ONE);
    if dimension == Dimension::LENGTH {
        (unit("m"), unit("N"))
    } else if dimension == Dimension::PURE {
        (unit("rad"), unit("N m"))
    } else {
        let force = unit("J").dimension() / dimension;
        (unit(&dimension.describe()), unit(&force.describe()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{Catalogue, embedded};
    use crate::expr::Name;
    use crate::instance::Instance;
    use crate::scene::Data;
    use crate::seed::Seed;
    use crate::solution::Solution;

    fn path() -> Path {
        Path::new(["model", "turning_points"].map(Name::new).to_vec())
    }

    /// The closed forms of the items know nothing of the list.
    #[test]
    fn lists_end_where_the_closed_forms_of_the_items_say() {
        let (catalogue, _) = Catalogue::open(embedded());
        let mut lists = 0;
        for template in catalogue.items() {
            let graph = &template.graph;
            let named = |name: &str| graph.find(&Name::new(name));
            let (Some(count), Some(rest)) = (named("n_half"), named("x_rest")) else {
                continue;
            };
            for seed in 0..5 {
                let Ok(instance) = Instance::draw(template, Seed::new(seed)) else {
                    continue;
                };
                let solution = Solution::of(instance);
                let evaluation = solution.evaluation();
                let turns = evaluation.turning_points(&path(), 100).expect("friction");
                let (count, rest) = (evaluation.real(count), evaluation.real(rest));
                let (count, rest) = (count.expect("a number"), rest.expect("a number"));
                assert_eq!(turns.first, 0, "{}", template.id);
                assert_eq!(turns.points.len() as f64, count + 1.0, "{}", template.id);
                for point in &turns.points {
                    assert_eq!(
                        point.is_held,
                        point.pull <= turns.holding,
                        "{}",
                        template.id
                    );
                }
                let last = turns.points.last().expect("a rest");
                assert!(last.is_held && (last.position - rest).abs() < 1e-12);
                lists += 1;
            }
        }
        assert!(lists >= 25, "{lists} lists");
    }

    #[test]
    fn a_long_list_shows_its_beginning_and_its_end() {
        let (catalogue, _) = Catalogue::open(embedded());
        let template = catalogue.find("ch3/t7-mu-from-decay").expect("an item");
        let solution = Solution::of(Instance::of_source(template));
        let scene = Scene::of(&solution, Data::Both);
        let Filling::Steps(steps) = filling(&scene, &path()) else {
            panic!("lines");
        };
        let last = steps[0].lines.last().expect("a line")[1].plain();
        assert!(last.contains("≤"), "the rest is shown: {last}");
    }

    #[test]
    fn a_list_shows_place_pull_and_friction() {
        let (catalogue, _) = Catalogue::open(embedded());
        let template = catalogue
            .items()
            .find(|own| own.id.as_str().starts_with("ch3/p1-"));
        let solution = Solution::of(Instance::of_source(template.expect("it is in the bank")));
        let scene = Scene::of(&solution, Data::Both);
        let Filling::Steps(steps) = filling(&scene, &path()) else {
            panic!("lines");
        };
        let lines: Vec<String> = steps[0]
            .lines
            .iter()
            .map(|[left, right]| format!("{}{}", left.plain(), right.plain()))
            .collect();
        // By hand: the band is 5 k δ = 0.5·6·9.81 N = 29.43 N wide on either side, and each half-cycle takes 2 δ.
        assert_eq!(lines.len(), 4);
        assert!(
            lines[0].contains("0.300 m") && lines[0].contains("192 N"),
            "{lines:?}"
        );
        assert!(
            lines[3].contains("0.0241 m") && lines[3].contains("≤"),
            "{lines:?}"
        );
    }
}
