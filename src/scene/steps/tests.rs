//! Printed derivations are read back: their lines follow from each other, and end in what the model has.

use super::*;
use crate::answer::{AnswerKind, Verdict};
use crate::bank::{Catalogue, Template, embedded};
use crate::expr::{Normal, Substitution};
use crate::instance::Instance;
use crate::mechanics::Reason;
use crate::numerics::SortedSet;
use crate::response::{Folded, Lexicon, Manner, Passage};
use crate::scene::Data;
use crate::seed::Seed;
use crate::solution::Solution;

/// Draws with which each printed equation is marked; `VIBANK_STEPS` sets another number.
#[expect(
    clippy::disallowed_methods,
    reason = "the length of a test, not what it comes to"
)]
fn draws() -> u64 {
    let draws = std::env::var("VIBANK_STEPS").ok();
    draws.and_then(|draws| draws.parse().ok()).unwrap_or(2)
}

/// What is read back of the printed lines of one derivation.
struct Reader<'s, 'a, 't> {
    scene: &'s Scene<'a, 't>,
    lexicon: Lexicon,
    /// The printed relations between displacements, as they were read back.
    relations: Substitution,
}

impl<'s, 'a, 't> Reader<'s, 'a, 't> {
    fn of(scene: &'s Scene<'a, 't>, model: &crate::mechanics::Model, steps: &[Step]) -> Self {
        let notation = Symbols(scene.solution());
        let mut names = SortedSet::new();
        let mut moving: SortedSet<Name> = model.coordinates().iter().cloned().collect();
        for line in steps.iter().flat_map(|step| &step.lines) {
            for side in &line.sides {
                let formulas: Vec<&Expr> = match side {
                    LineSide::Formula(own) => vec![own],
                    LineSide::Determinant(rows) => rows.iter().flatten().collect(),
                    LineSide::Terms(_) => Vec::new(),
                };
                for own in formulas {
                    names.extend(own.names().free.into_iter().map(|own| own.name));
                }
            }
        }
        for step in steps
            .iter()
            .filter(|step| step.reason == Reason::Kinematics)
        {
            for line in &step.lines {
                if let Some(LineSide::Formula(own)) = line.sides.first() {
                    moving.extend(own.names().free.into_iter().map(|own| own.name));
                }
            }
        }
        names.extend(moving.iter().cloned());
        let mut lexicon = Lexicon::new();
        for name in &names {
            lexicon.allow(name, notation.name(name).math, moving.contains(name));
        }
        Self {
            scene,
            lexicon,
            relations: Substitution::moving(model.coordinates().iter().cloned()),
        }
    }

    /// A printed side as it is read back, in the coordinates.
    fn read(&self, side: &LineSide) -> Option<Normal> {
        let LineSide::Formula(own) = side else {
            return None;
        };
        let printed = own.typeset(&Symbols(self.scene.solution())).latex();
        let folded = Folded::of(&printed);
        let folded = folded.as_ref().map_or(Passage::default(), Folded::passage);
        // Only a formula with a datum in it, 9.81 m/s², is read with units: that has a shorter limit.
        let read = |values| {
            let manner = Manner {
                comma_is_decimal: false,
                has_imaginary_unit: false,
                values,
                ..Manner::default()
            };
            folded.formula(&self.lexicon, manner)
        };
        let read = read(None).or_else(|_| read(Some(crate::unit::DecimalMark::Point)));
        let read = read.unwrap_or_else(|error| panic!("`{printed}`: {:?}", error.trouble));
        let put_in = self.relations.apply(&read.value).expect("it is small");
        Some(Normal::of(&put_in).expect("it is small"))
    }

    fn learn(&mut self, line: &Line) {
        let [LineSide::Formula(name), side] = line.sides.as_slice() else {
            panic!("a relation has two sides");
        };
        let Kind::Name(name) = name.kind() else {
            panic!("a relation begins with a name");
        };
        let moved = self.read(side).expect("a formula");
        let moved = moved.to_expr(&crate::expr::Order::new());
        self.relations = std::mem::take(&mut self.relations).with(name.clone(), moved);
    }
}

/// The determinant is the polynomial below it.
fn follow_determinant(reader: &Reader<'_, '_, '_>, step: &Step, label: &str) {
    let [first, second, ..] = step.lines.as_slice() else {
        panic!("{label}: a determinant and its equation");
    };
    let LineSide::Determinant(rows) = &first.sides[0] else {
        panic!("{label}: a determinant");
    };
    let entry = |row: usize, column: usize| {
        let entry = LineSide::Formula(rows[row][column].clone());
        reader.read(&entry).expect("a formula")
    };
    let expanded = if rows.len() == 1 {
        entry(0, 0)
    } else {
        let products = [(0, 0, 1, 1), (0, 1, 1, 0)];
        let [main, other] =
            products.map(|(a, b, c, d)| entry(a, b).times(&entry(c, d)).expect("it is small"));
        main.plus(&other.negated()).expect("it is small")
    };
    assert_same(
        label,
        &expanded,
        &reader.read(&second.sides[0]).expect("a formula"),
    );
}

/// The ratio makes the row vanish.
fn follow_row(reader: &Reader<'_, '_, '_>, step: &Step, names: &[Name], label: &str) {
    let [row, ratio] = step.lines.as_slice() else {
        panic!("{label}: a row and its ratio");
    };
    let row = reader.read(&row.sides[0]).expect("a formula");
    let ratio = reader.read(&ratio.sides[1]).expect("a formula");
    let [first, second] = names else {
        panic!("{label}: two coordinates");
    };
    let order = crate::expr::Order::new();
    let shape = Substitution::new()
        .with(first.clone(), Expr::number(1))
        .with(second.clone(), ratio.to_expr(&order));
    let left = Normal::of(&shape.apply(&row.to_expr(&order)).expect("it is small"));
    let zero = Normal::of(&Expr::number(0)).expect("a number");
    assert_same(label, &left.expect("it is small"), &zero);
}

fn assert_same(label: &str, first: &Normal, second: &Normal) {
    let is_same = first.is_equal(second).expect("it is small");
    assert!(is_same, "{label}: two neighbours differ");
}

/// Left minus right of an equation.
fn residual(reader: &Reader<'_, '_, '_>, line: &Line) -> Option<Normal> {
    let [left, right] = line.sides.as_slice() else {
        return None;
    };
    let (left, right) = (reader.read(left)?, reader.read(right)?);
    Some(left.plus(&right.negated()).expect("it is small"))
}

/// Whether the lines of a step are equations, each of which follows from the one before; else each is a chain of its
/// own.
fn is_equations(reason: &Reason) -> bool {
    matches!(
        reason,
        Reason::Lagrange(_) | Reason::Elimination(..) | Reason::Divided(_)
    )
}

/// How often its equation was marked.
fn follow(template: &Template, way: Way, label: &str) -> u64 {
    let model = template.graph.derived("model").expect("a model");
    let steps = model.derivation(way).expect("a derivation");
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    let mut reader = Reader::of(&scene, model, &steps);
    let mut terms: Option<Normal> = None;
    let mut along = 0;
    for step in &steps {
        let mut before: Option<Normal> = None;
        match &step.reason {
            Reason::Characteristic => {
                follow_determinant(&reader, step, label);
                return 0;
            }
            Reason::Row(_) => {
                follow_row(&reader, step, model.coordinates(), label);
                return 0;
            }
            _ => {}
        }
        for line in &step.lines {
            if step.reason == Reason::Kinematics {
                reader.learn(line);
                continue;
            }
            if is_equations(&step.reason) {
                let Some(own) = residual(&reader, line) else {
                    continue;
                };
                // The terms add up to the equation.
                if let Some(before) = before.as_ref().or(terms.as_ref()) {
                    assert_same(label, before, &own);
                }
                before = Some(own);
                continue;
            }
            let sides: Vec<Normal> = line
                .sides
                .iter()
                .filter_map(|side| reader.read(side))
                .collect();
            if matches!(step.reason, Reason::Terms(_) | Reason::Energy) {
                for pair in sides.windows(2) {
                    assert_same(label, &pair[0], &pair[1]);
                }
            }
            if let (Some(LineSide::Terms(term)), Some(value)) = (line.sides.first(), sides.last()) {
                let value = match term.as_slice() {
                    [(_, LawTerm::Kinetic(_) | LawTerm::Force(_))] => value.negated(),
                    [
                        (
                            _,
                            LawTerm::MomentumRate(_)
                            | LawTerm::Potential(_)
                            | LawTerm::Dissipation(_),
                        ),
                    ] => value.clone(),
                    _ => continue,
                };
                terms = Some(match terms {
                    Some(sum) => sum.plus(&value).expect("it is small"),
                    None => value,
                });
            }
        }
        if let Reason::Elimination(name, _) = &step.reason {
            along = model
                .coordinates()
                .iter()
                .position(|own| own == name)
                .unwrap_or(0);
        }
    }
    if let Way::Lagrange(at) = way {
        along = at;
    }
    // The balance of energy of several coordinates is no equation of motion.
    if way == Way::Energy && model.degrees_of_freedom() > 1 {
        return 0;
    }
    mark(template, model, along, &steps, label)
}

/// The equation at the end is marked as an answer, over several draws.
fn mark(
    template: &Template,
    model: &crate::mechanics::Model,
    along: usize,
    steps: &[Step],
    label: &str,
) -> u64 {
    let last = steps.last().and_then(|step| step.lines.last());
    let Some(line) = last.filter(|line| {
        matches!(
            line.sides.as_slice(),
            [LineSide::Formula(_), LineSide::Formula(_)]
        )
    }) else {
        return 0;
    };
    let quantity = crate::mechanics::Quantity::Equation(along);
    let Ok(asked) = model.equations(quantity) else {
        return 0;
    };
    let of_source = Solution::of(Instance::of_source(template));
    let asks = |(place, _): &(usize, &crate::bank::Part)| {
        let marker = of_source.marker(*place).ok();
        let equations = marker.and_then(|marker| marker.equations(Passage::default()));
        equations.is_some_and(|own| own.key == asked)
    };
    let mut parts = template.parts.iter().enumerate();
    let is_equation =
        |(_, part): &(usize, &crate::bank::Part)| part.answer.kind() == AnswerKind::Equation;
    let part = parts.find(|part| is_equation(part) && asks(part));
    let Some((place, _)) = part else {
        return 0;
    };
    let mut marked = 0;
    for seed in 0..draws() {
        let Ok(instance) = Instance::draw(template, Seed::new(seed)) else {
            continue;
        };
        let solution = Solution::of(instance);
        let sides = line
            .sides
            .iter()
            .map(|side| set_side(side, &Symbols(&solution)).latex());
        let typed = sides.collect::<Vec<_>>().join(" = ");
        let folded = Folded::of(&typed);
        let folded = folded.as_ref().map_or(Passage::default(), Folded::passage);
        let marking = solution.marker(place).expect("a key").mark(folded);
        assert_eq!(
            marking.verdict,
            Verdict::Right,
            "{label}, seed {seed}: {typed}"
        );
        marked += 1;
    }
    marked
}

#[test]
fn texts_know_the_names_of_all_derivations() {
    let placeholder = |path: String| crate::document::Placeholder {
        path,
        form: crate::document::Form::Value,
        in_math: false,
        span: crate::source::Span::NONE,
    };
    for name in Way::NAMES {
        assert!(placeholder(format!("model.{name}")).is_block());
        assert!(placeholder(format!("models.full.{name}")).is_block());
    }
    assert!(!placeholder("model.equation.x".to_owned()).is_block());
}

#[test]
fn a_value_is_worked_out_in_the_unit_that_a_part_asks_for() {
    let (catalogue, _) = Catalogue::open(embedded());
    let template = catalogue.find("ch2/e7-lc-circuit").expect("an item");
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    let asked = |name: &str| {
        let node = template.graph.find(&Name::new(name));
        let node = node.expect("a quantity");
        let info = template.info(node).expect("a quantity");
        fill::value_as_asked(&scene, node, info).map(|value| value.plain())
    };
    assert_eq!(asked("T0").as_deref(), Some("0.628 ms"));
    assert_eq!(asked("f0"), None);
}

/// The balance at rest vanishes and the motion is left, with what the letters are said to stand for.
#[test]
fn balances_at_rest_are_read_back_and_vanish() {
    let (catalogue, _) = Catalogue::open(embedded());
    let (mut balances, mut motions) = (0, 0);
    for template in catalogue.items() {
        let path = Path::new(["models", "full", "static"].map(Name::new).to_vec());
        let Some(steps) = template.graph.lines(&path) else {
            continue;
        };
        let steps = steps.unwrap_or_else(|lack| panic!("{}: {lack}", template.id));
        let model = template.graph.derived("models.full").expect("a model");
        let solution = Solution::of(Instance::of_source(template));
        let scene = Scene::of(&solution, Data::Both);
        let mut reader = Reader::of(&scene, model, &steps);
        let of = |reason: Reason| steps.iter().filter(move |step| step.reason == reason);
        let learned = of(Reason::Kinematics).chain(of(Reason::Letters));
        let learned: Vec<&Line> = learned.flat_map(|step| &step.lines).collect();
        // Twice: a letter may stand for what a later line says another one stands for.
        for line in learned.iter().chain(&learned) {
            reader.learn(line);
        }
        let zero = Normal::of(&Expr::number(0)).expect("a number");
        for line in of(Reason::AtRest).flat_map(|step| &step.lines) {
            let balance = reader.read(&line.sides[1]).expect("a formula");
            assert_same(template.id.as_str(), &balance, &zero);
            balances += 1;
        }
        for line in of(Reason::InMotion).flat_map(|step| &step.lines) {
            let sides: Vec<Normal> = line.sides[1..]
                .iter()
                .filter_map(|side| reader.read(side))
                .collect();
            for pair in sides.windows(2) {
                assert_same(template.id.as_str(), &pair[0], &pair[1]);
                motions += 1;
            }
        }
    }
    assert!(
        balances >= 6 && motions >= 6,
        "{balances} balances, {motions} motions"
    );
}

#[test]
fn printed_lines_are_read_back_and_follow_from_each_other() {
    let (catalogue, _) = Catalogue::open(embedded());
    let (mut followed, mut marked) = (0, 0);
    for template in catalogue.items() {
        let Some(model) = template.graph.derived("model") else {
            continue;
        };
        let mut ways: Vec<Way> = (0..model.degrees_of_freedom()).map(Way::Lagrange).collect();
        ways.extend([Way::Energy, Way::Newton, Way::Characteristic]);
        ways.extend((0..model.degrees_of_freedom()).map(Way::Row));
        for way in ways {
            if model.derivation(way).is_ok() {
                marked += follow(template, way, &format!("{} {way:?}", template.id));
                followed += 1;
            }
        }
    }
    assert!(
        followed > 60 && marked > 30 * draws(),
        "{followed} derivations, {marked} marked"
    );
}
