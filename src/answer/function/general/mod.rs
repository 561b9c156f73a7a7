//! The general solution of a model's equations, with free constants that the student names.
//!
//! A response is right when it satisfies the equations for all values of its constants, and the constants
//! can meet any initial state: each is a factor or a phase, and the positions and velocities at the start,
//! as functions of the constants, have full rank.

mod complex;
mod constants;
mod read;

use std::collections::BTreeMap;
use std::sync::Arc;

use self::complex::Parts;
use crate::answer::equality::Draws;
use crate::answer::letters::Allowed;
use crate::answer::meaning::{Meaning, ORDERS, Prefer};
use crate::answer::{
    Answer, Answered, Asked, Blank, Context, Credit, Declare, Key, Marker, Marking, Nature, Note,
    Reading, Remark, Role, Slip, Trial, Unreadable, Why,
};
use crate::expr::{Equation, Expr, Kind as Node, Name, Precise, Program, Workspace};
use crate::math::Math;
use crate::numerics::Rational;
use crate::quantity::{Absent, NodeId};
use crate::response::{Lexicon, Passage};
use crate::source::{Table, Text};

/// Letters that people give to constants, alone or with a number: all but those of time, of e and of i.
const LETTERS: &str = "A B C D E F G H J K L M N O P Q R S T U V W X Y Z a b c d f g h k l m n p q r s u v w x y z \
    phi psi alpha beta delta theta gamma epsilon eta chi";
/// What those write who cannot use C and D, as in Mathematica.
const DOUBLED: &str = "AA BB CC DD";
/// A letter that is a constant, or the imaginary unit as programs write it: which is seen from where it stands.
const DOUBTFUL: &str = "I";
/// Constants that a response may use: a few more than are needed.
const MAX_USED: usize = 16;
/// Highest number after such a letter.
const MAX_NUMBERED: usize = 6;

#[derive(Debug)]
pub(crate) struct General(Arc<Setup>);

#[derive(Debug)]
pub(crate) struct Setup {
    equations: Vec<Equation>,
    coordinates: Vec<Name>,
    symbols: Vec<Math>,
    constants: Vec<Name>,
    /// Where their values stand in a point.
    slots: Vec<usize>,
    frequencies: Option<NodeId>,
    shapes: Option<NodeId>,
    meaning: Meaning,
    lexicon: Lexicon,
    /// With the letter that may be a constant or the imaginary unit among the constants.
    with_doubtful: Option<Lexicon>,
    /// The letters of its answer line.
    letters: Vec<Expr>,
}

struct Prepared {
    setup: Arc<Setup>,
    data: Vec<Precise>,
    /// Frequencies, and for each the shape of its mode.
    modes: Vec<(f64, Vec<f64>)>,
}

/// Reads a part that asks for a general solution.
pub(crate) fn read(
    part: &Table<'_>,
    key: &Text,
    components: &[Text],
    declare: &mut dyn Declare,
) -> Option<Box<dyn Answer>> {
    let of = |quantity: &str| Text {
        value: key.value.replace("general_motion", quantity),
        span: key.span,
    };
    let equations = declare.equations(&of("equations"))?;
    let known = declare.known();
    let is_asked = |name: &Name| {
        components.is_empty() || components.iter().any(|text| text.value == name.as_str())
    };
    let coordinates: Vec<_> = known
        .iter()
        .filter(|own| own.role == Role::Coordinate && is_asked(&own.name))
        .collect();
    let mut meaning = Meaning::of(declare, Prefer::Coordinates);
    let allowed = Allowed::read(part, declare, None, true)?;
    let is_moving = |letter: &Expr| match letter.kind() {
        Node::Name(name) => allowed.lexicon.is_moving(name),
        _ => false,
    };
    let mut letters = allowed.letters();
    letters.retain(|letter| !is_moving(letter));
    let mut lexicon = allowed.lexicon;
    let listed = part.texts("in");
    // What is neither printed nor needed is free to be used.
    let is_taken = |name: &Name| {
        let own = known.iter().find(|own| own.name == *name);
        let is_shown = own.is_some_and(|own| !matches!(own.role, Role::Quantity { .. }));
        let mut names = equations
            .iter()
            .flat_map(|of| [of.left.names(), of.right.names()]);
        is_shown
            || listed.iter().any(|text| text.value == name.as_str())
            || own.is_some() && names.any(|names| names.uses(name))
    };
    let numbered = LETTERS.split_whitespace().flat_map(|letter| {
        (0..=MAX_NUMBERED).map(move |number| match number {
            0 => letter.to_owned(),
            number => format!("{letter}{number}"),
        })
    });
    let all = numbered.chain(DOUBLED.split_whitespace().map(str::to_owned));
    // `w1` stays ω₁. All are asked for before any is added: what people type is made out anew for each lexicon.
    let is_spelling = |name: &Name| {
        lexicon
            .reads(name.as_str())
            .is_some_and(|own| *own != *name)
    };
    let free = all
        .map(Name::new)
        .filter(|name| !is_taken(name) && !is_spelling(name));
    let mut constants: Vec<Name> = free.collect();
    let doubtful = Name::new(DOUBTFUL);
    let is_free = !is_taken(&doubtful) && lexicon.reads(DOUBTFUL).is_none();
    for name in &constants {
        meaning.add_free(name);
        lexicon.allow(name, crate::math::symbol(name.as_str()), false);
    }
    lexicon.allow(&Name::new("t"), crate::math::symbol("t"), false);
    let with_doubtful = is_free.then(|| {
        meaning.add_free(&doubtful);
        constants.push(doubtful.clone());
        lexicon.with(&doubtful, crate::math::symbol(DOUBTFUL))
    });
    letters.retain(|letter| {
        !constants
            .iter()
            .any(|own| *letter == Expr::name(own.clone()))
    });
    let places = constants.iter().filter_map(|name| meaning.place(name));
    let slots = places.map(|place| place * ORDERS).collect();
    let frequencies = declare.formula("frequencies", &of("natural_angular_frequencies"));
    let shapes = declare.formula("shapes", &of("mode_shapes"));
    Some(Box::new(General(Arc::new(Setup {
        equations,
        coordinates: coordinates.iter().map(|own| own.name.clone()).collect(),
        symbols: coordinates
            .iter()
            .map(|own| Math::clone(&own.symbol))
            .collect(),
        constants,
        slots,
        frequencies,
        shapes,
        meaning,
        lexicon,
        with_doubtful,
        letters,
    }))))
}

impl Answer for General {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Function
    }

    fn blank(&self) -> Blank {
        Blank::of(Asked::GeneralSolution).with_letters(&self.0.letters, &self.0.lexicon)
    }

    fn keys(&self) -> Vec<NodeId> {
        Vec::new()
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let setup = &self.0;
        let value =
            |node: Option<NodeId>| node.and_then(|node| context.evaluation.value(node).ok());
        let modes = match (value(setup.frequencies), value(setup.shapes)) {
            (Some(frequencies), Some(shapes)) => {
                let rows = shapes.numbers().chunks(setup.coordinates.len().max(1));
                frequencies
                    .numbers()
                    .iter()
                    .copied()
                    .zip(rows.map(<[f64]>::to_vec))
                    .collect()
            }
            _ => Vec::new(),
        };
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            data: setup.meaning.data(&context.evaluation),
            modes,
        }))
    }
}

/// A typed solution as programs, by coordinate.
pub(crate) struct TypedSolution {
    positions: Vec<Program>,
    velocities: Vec<Program>,
    accelerations: Vec<Program>,
    residuals: Vec<Program>,
    /// Left minus right of the equations with positions as inputs.
    bare: Vec<Program>,
    /// The constants that occur in it, as places.
    used: Vec<usize>,
    /// The largest share of one of its decimal numbers that rounding may have taken; zero where it has none.
    rounding: f64,
}

impl Setup {
    /// The constants that occur in a response, as places.
    fn used(&self, typed: &[Expr]) -> Vec<usize> {
        let names: Vec<_> = typed.iter().map(Expr::names).collect();
        let is_used = |place: &usize| {
            let mut names = names.iter();
            names.any(|names| names.uses(&self.constants[*place]))
        };
        (0..self.constants.len()).filter(is_used).collect()
    }

    /// A response as one solution of real numbers, or as two, the real and the imaginary part of one of complex
    /// numbers.
    ///
    /// # Errors
    ///
    /// Why the response has no derivatives that can be compared.
    fn solutions(&self, typed: &[Expr]) -> Result<Vec<TypedSolution>, Unreadable> {
        let none = || Unreadable::of(Why::Undifferentiable);
        let solution = |typed: &[Expr]| self.solution(typed).ok_or_else(none);
        if !typed.iter().any(complex::is_complex) {
            return Ok(vec![solution(typed)?]);
        }
        let used = self.used(typed);
        let phases: Vec<Name> = typed.iter().flat_map(complex::phases).collect();
        let own = used.iter().map(|place| &self.constants[*place]);
        let free = (0..self.constants.len()).filter(|place| !used.contains(place));
        let partners = free.map(|place| self.constants[place].clone());
        let complex: BTreeMap<Name, Name> = crate::numerics::gather(
            own.filter(|name| !phases.contains(name))
                .cloned()
                .zip(partners),
        );
        let parts: Vec<Parts> = typed
            .iter()
            .map(|formula| Parts::of(formula, &complex))
            .collect::<Option<_>>()
            .ok_or_else(none)?;
        let size = |own: &Parts| own.real.size() + own.imaginary.as_ref().map_or(0, Expr::size);
        if parts.iter().map(size).sum::<u32>() > complex::MAX_SIZE {
            return Err(Why::TooLong.into());
        }
        let real: Vec<Expr> = parts.iter().map(|own| own.real.clone()).collect();
        let zero = || Expr::number(0);
        let imaginary: Vec<Expr> = parts
            .into_iter()
            .map(|own| own.imaginary.unwrap_or_else(zero))
            .collect();
        let mut solutions = vec![solution(&real)?];
        if !imaginary.iter().all(Expr::is_zero) {
            solutions.push(solution(&imaginary)?);
        }
        Ok(solutions)
    }

    fn solution(&self, typed: &[Expr]) -> Option<TypedSolution> {
        let coordinates = self.coordinates.iter().cloned();
        let replaced: BTreeMap<Name, Expr> =
            crate::numerics::gather(coordinates.zip(typed.iter().cloned()));
        let none = BTreeMap::new();
        let mut rounding = 0.0_f64;
        for expr in typed {
            expr.walk(&mut |node| {
                if let crate::expr::Kind::Number(value) = node.kind() {
                    rounding = rounding.max(rounding_of(*value));
                }
            });
        }
        let all = |exprs: Vec<Expr>, replaced| -> Option<Vec<Program>> {
            exprs
                .iter()
                .map(|expr| self.meaning.compile(expr, replaced).ok())
                .collect()
        };
        let differences = || {
            self.equations
                .iter()
                .map(Equation::difference)
                .collect::<Vec<_>>()
        };
        let rates = |order| {
            let of = |name: &Name| Expr::name(name.clone()).prime(order);
            self.coordinates.iter().map(of).collect::<Vec<_>>()
        };
        Some(TypedSolution {
            used: self.used(typed),
            positions: all(typed.to_vec(), &none)?,
            velocities: all(rates(1), &replaced)?,
            accelerations: all(rates(2), &replaced)?,
            residuals: all(differences(), &replaced)?,
            bare: all(differences(), &none)?,
            rounding,
        })
    }

    fn slot(&self, name: &Name) -> Option<usize> {
        Some(self.meaning.place(name)? * ORDERS)
    }
}

impl Prepared {
    /// The data with values for constants and time.
    fn point(&self, constants: &[f64], time: f64) -> Vec<Precise> {
        let mut point = self.data.clone();
        let setup = &self.setup;
        for (slot, value) in setup.slots.iter().zip(constants) {
            point[*slot] = Precise::exact(*value);
        }
        if let Some(slot) = setup.slot(&Name::new("t")) {
            point[slot] = Precise::exact(time);
        }
        point
    }

    fn times(&self) -> Vec<f64> {
        let slowest = self
            .modes
            .iter()
            .map(|(frequency, _)| *frequency)
            .filter(|frequency| *frequency > 0.0);
        let period = std::f64::consts::TAU / slowest.fold(f64::INFINITY, f64::min);
        let span = if period.is_finite() && period > 0.0 {
            2.0 * period
        } else {
            10.0
        };
        (0..16)
            // None of them is a simple share of the period, at which sines vanish or meet cosines.
            .map(|place| span * (f64::from(place) + 0.37) / 16.0)
            .collect()
    }

    /// Whether the equations hold for constants at random, and for each of them that is large beside the others: so
    /// each mode shows alone, and what no constant multiplies does.
    fn satisfies(&self, solution: &TypedSolution) -> Option<bool> {
        const SMALL: f64 = 1e-3;
        let mut draws = Draws::new();
        let mut random = || -> Vec<f64> {
            let constants = self.setup.constants.iter();
            constants.map(|_| 1.0 + 0.9 * draws.signed()).collect()
        };
        let mut all: Vec<Vec<f64>> = (0..3).map(|_| random()).collect();
        for large in &solution.used {
            let mut constants = random();
            for (place, value) in constants.iter_mut().enumerate() {
                *value *= if place == *large { 1.0 } else { SMALL };
            }
            all.push(constants);
        }
        for constants in &all {
            if !self.satisfies_with(solution, constants)? {
                return Some(false);
            }
        }
        Some(self.lasts(solution, &all[0]))
    }

    /// Whether the equations hold for these constants.
    fn satisfies_with(&self, solution: &TypedSolution, constants: &[f64]) -> Option<bool> {
        // Of a formula without decimals nothing is rounded but by the machine.
        const EXACT: f64 = 1e-7;
        let mut room = Workspace::default();
        let times = self.times();
        let mut largest = |programs: &[Program]| -> Option<Vec<f64>> {
            let mut largest = vec![0.0_f64; programs.len()];
            for time in &times {
                let point = self.point(constants, *time);
                for (largest, program) in largest.iter_mut().zip(programs) {
                    let value = program.evaluate_real(&point[..], &mut room).ok()?;
                    *largest = largest.max(value.abs());
                }
            }
            Some(largest)
        };
        let positions = largest(&solution.positions)?;
        let accelerations = largest(&solution.accelerations)?;
        let residuals = largest(&solution.residuals)?;
        for (residual, program) in residuals.iter().zip(&solution.bare) {
            let mut scale = |order: usize, largest: &[f64]| {
                let mut sum = 0.0;
                for (name, largest) in self.setup.coordinates.iter().zip(largest) {
                    let mut point = self.point(constants, times[0]);
                    point[self.setup.slot(name)? + order] = Precise::exact(*largest);
                    sum += program.evaluate_real(&point[..], &mut room).ok()?.abs();
                }
                Some(sum)
            };
            // Rounding a shape moves all terms by its share, and rounding a frequency those of inertia by twice its
            // share.
            let (of_shape, of_inertia) = match solution.rounding {
                0.0 => (EXACT, EXACT),
                rounding => (rounding, 3.0 * rounding),
            };
            if *residual > of_shape * scale(0, &positions)? + of_inertia * scale(2, &accelerations)?
            {
                return Some(false);
            }
        }
        Some(true)
    }

    /// Whether a solution is as large after thousands of periods as in the first ones, where the equations have no
    /// terms of velocities and each mode oscillates: a damping that hardly shows in the equations shows there.
    fn lasts(&self, solution: &TypedSolution, constants: &[f64]) -> bool {
        const PERIODS: f64 = 2_000.0;
        const SAMPLES: u32 = 32;
        let mut room = Workspace::default();
        let is_undamped = solution.bare.iter().all(|program| {
            self.setup.coordinates.iter().all(|name| {
                let mut point = self.point(constants, 0.0);
                let slot = self.setup.slot(name);
                if let Some(slot) = slot {
                    point[slot + 1] = Precise::exact(1.0);
                }
                let value = program.evaluate_real(&point[..], &mut room);
                value.is_ok_and(|value| value == 0.0)
            })
        });
        let slowest = self.modes.iter().map(|(frequency, _)| *frequency);
        let slowest = slowest.fold(f64::INFINITY, f64::min);
        if !is_undamped || slowest <= 0.0 || slowest.is_infinite() {
            return true;
        }
        let period = std::f64::consts::TAU / slowest;
        // Times that are not in step with any mode.
        let size = |from: f64, room: &mut Workspace| -> Option<f64> {
            let mut sum = 0.0;
            for place in 0..SAMPLES {
                let share = (f64::from(place) + 0.37) / f64::from(SAMPLES);
                let point = self.point(constants, from + 14.0 * period * share * share);
                for program in &solution.positions {
                    let value = program.evaluate_real(&point[..], room).ok()?;
                    sum += value * value;
                }
            }
            Some(sum.sqrt())
        };
        let (first, late) = (size(0.0, &mut room), size(PERIODS * period, &mut room));
        first
            .zip(late)
            .is_some_and(|(first, late)| late <= 2.0 * first && first <= 2.0 * late)
    }

    /// The solution of the key as a formula of each coordinate.
    fn written(&self) -> Vec<(Math, String)> {
        let setup = &self.setup;
        let number = |value: f64| {
            let digits = crate::unit::Decimal::rounded(value, 4)
                .and_then(|decimal| crate::unit::Decimal::shortest(decimal.to_f64()));
            digits.and_then(|digits| crate::numerics::Rational::from_decimal(&digits.to_string()))
        };
        let component = |place: usize| {
            let mut sum = Expr::number(0);
            for (mode, (frequency, shape)) in self.modes.iter().enumerate() {
                let largest = shape
                    .iter()
                    .copied()
                    .fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
                let Some(weight) = number(shape[place] / largest) else {
                    continue;
                };
                let constant = |letter: &str| Expr::name(format!("{letter}{}", mode + 1).as_str());
                let time = Expr::name("t");
                let motion = match number(*frequency) {
                    Some(frequency) if !frequency.is_zero() => {
                        let angle = Expr::number(frequency) * time;
                        let of = |function| Expr::call(function, [angle.clone()]);
                        constant("A") * of(crate::expr::Function::Cos)
                            + constant("B") * of(crate::expr::Function::Sin)
                    }
                    _ => constant("A") + constant("B") * time,
                };
                sum = sum + Expr::number(weight) * motion;
            }
            sum
        };
        let both = |place: usize| {
            let formula = component(place);
            let math = Math::row([
                setup.symbols[place].clone(),
                Math::relation("="),
                formula.typeset(&setup.lexicon),
            ]);
            (math, format!("{} = {formula}", setup.coordinates[place]))
        };
        (0..setup.coordinates.len()).map(both).collect()
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let solution: Vec<String> = self.written().into_iter().map(|(_, text)| text).collect();
        let mut still = solution.clone();
        if let (Some(first), Some(name)) = (still.first_mut(), self.setup.coordinates.first()) {
            *first = format!("{name} = A1");
        }
        vec![
            Trial::new(Nature::Right, solution.join("; ")),
            Trial::new(Nature::Wrong, still.join("; ")),
            Trial::new(Nature::Unreadable, "A cos("),
        ]
    }

    fn key(&self) -> Key {
        let (lines, texts): (Vec<_>, Vec<_>) = self.written().into_iter().unzip();
        // A line each: side by side, two motions of two modes are wider than a page.
        let math = if lines.len() > 1 {
            let row = |line| vec![Math::row(Vec::new()), line];
            Math::aligned(lines.into_iter().map(row).collect())
        } else {
            Math::row(lines)
        };
        Key::formula(texts.join("; "), math)
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let setup = &self.setup;
        let typed = match setup.read(response) {
            Ok(typed) => typed,
            Err(why) => return Marking::unreadable(why),
        };
        let mut row = Vec::new();
        for (symbol, formula) in setup.symbols.iter().zip(&typed) {
            if !row.is_empty() {
                row.push(Math::punctuation(";"));
            }
            row.extend([
                symbol.clone(),
                Math::relation("="),
                formula.typeset(&setup.lexicon),
            ]);
        }
        let texts = setup.coordinates.iter().zip(&typed);
        let reading = Reading {
            math: Math::row(row),
            text: texts
                .map(|(name, formula)| format!("{name} = {formula}"))
                .collect::<Vec<_>>()
                .join("; "),
            answered: Answered::Functions(typed.clone()),
        };
        let wrong = |reading, slip: Slip| Marking::wrong(reading, Remark::from(slip));
        let needed = 2 * setup.coordinates.len();
        let found = setup.used(&typed).len();
        if found > MAX_USED {
            return Marking::unreadable(Why::TooManyConstants {
                most: MAX_USED,
                needed,
            });
        }
        let mut solutions = match setup.solutions(&typed) {
            Ok(solutions) => solutions,
            Err(why) => return Marking::unreadable(why),
        };
        // Of a sum of conjugates nothing is imaginary.
        if solutions.len() > 1 && self.vanishes(&solutions[1], &solutions[0]) {
            solutions.truncate(1);
        }
        for solution in &solutions {
            match self.satisfies(solution) {
                None => return wrong(reading, Slip::NoValueAtTimes),
                Some(false) => return wrong(reading, Slip::Unsatisfied),
                Some(true) => {}
            }
        }
        if self
            .rank(&solutions)
            .is_none_or(|rank| rank < needed * solutions.len())
        {
            let slip = if found < needed {
                Slip::TooFewConstants { found, needed }
            } else {
                Slip::NotGeneral
            };
            return wrong(reading, slip);
        }
        if !solutions
            .iter()
            .all(|solution| self.are_factors_and_phases(solution))
        {
            return wrong(reading, Slip::NotFactors);
        }
        let note = (found > needed).then_some(Note::ConstantsToSpare { needed, found });
        Marking::read(reading, Credit::FULL, note.map(Remark::from))
    }
}

/// The share of a number by which rounding moved it at most, half a unit of its last decimal; at least that of four
/// figures, and at most that of three. Zero for an integer.
fn rounding_of(value: Rational) -> f64 {
    const MOST_DECIMALS: i32 = 12;
    if value.is_integer() {
        return 0.0;
    }
    let number = value.to_f64().abs();
    let is_decimal = |places: &i32| {
        let shifted = number * crate::numerics::powi(10.0, *places);
        (shifted - shifted.round()).abs() <= 1e-9 * shifted
    };
    let places = (1..=MOST_DECIMALS)
        .find(is_decimal)
        .unwrap_or(MOST_DECIMALS);
    let half = 0.5 * crate::numerics::powi(10.0, -places);
    (half / number).clamp(0.0005, 0.005)
}
