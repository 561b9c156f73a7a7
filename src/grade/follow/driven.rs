//! What follows for the steady motion of one coordinate from an equation of motion, a natural frequency or a damping
//! ratio of one's own.
//!
//! Items write the amplitude in the data; its second route is the complex amplitude of the model. That of one's own
//! oscillator stands in for it,
//!
//! ```text
//! X = F/(k − m Ω² + i Ω c),   k = m ω₀²,   c = 2 ζ m ω₀   where ω₀ and ζ are one's own.
//! ```

use super::answers::{Answers, Own, Source, in_data, number};
use super::oscillator::{self, Coefficients};
use super::system::changed;
use crate::expr::{Equation, Expr, Field, Form, Name, Normal, Order, Shape, Substitution, Value};
use crate::mechanics::{Model, Quantity, Sdof};
use crate::numerics::Complex;
use crate::quantity::NodeId;
use crate::solution::Solution;

/// A driven oscillator: m x'' + c x' + k x = Re(F e^(iΩt)).
#[derive(Clone, Copy)]
struct Driven {
    mass: f64,
    damping: f64,
    stiffness: f64,
    force: Complex,
    frequency: f64,
}

/// Adds what follows for the quantities whose second route asks for a complex amplitude.
pub(crate) fn extend(solution: &Solution<'_>, answers: &mut Answers, equations: &[Equation]) {
    let template = solution.template();
    let graph = &template.graph;
    let asked = graph.asked().filter_map(|(path, node)| {
        let (model, quantity) = graph.offered(path)?;
        let is_single = model.degrees_of_freedom() == 1;
        (is_single && matches!(quantity, Quantity::ComplexAmplitude(_))).then_some((model, node))
    });
    for (model, node) in asked.collect::<Vec<_>>() {
        let Some((own, source)) = own(solution, answers, equations, model) else {
            continue;
        };
        let Some(value) = own.amplitude() else {
            continue;
        };
        let evaluation = solution.evaluation().replacing(vec![(node, value)]);
        let routes = template.quantities.iter().flat_map(|(quantity, info)| {
            let routes = [Some(*quantity), info.verify].into_iter().flatten();
            routes.map(|route| (*quantity, route))
        });
        let found: Vec<(NodeId, Value)> = routes
            .filter(|(quantity, _)| !answers.has(*quantity))
            .filter_map(|(quantity, route)| {
                Some((quantity, changed(solution, &evaluation, route)?))
            })
            .collect();
        for (quantity, value) in found {
            answers.add_following(solution, quantity, source.as_ref(), value, None);
        }
    }
}

/// The student's own oscillator, and the answer from which it comes; an equation is none.
fn own(
    solution: &Solution<'_>,
    answers: &Answers,
    equations: &[Equation],
    model: &Model,
) -> Option<(Driven, Option<Own>)> {
    let [coordinate] = model.coordinates() else {
        return None;
    };
    let mut typed = equations.iter();
    if let Some(own) = typed.find_map(|own| Driven::of(solution, own, coordinate)) {
        return Some((own, None));
    }
    let right = Driven::of(solution, &model.equation(0)?, coordinate)?;
    let known: Vec<(NodeId, Sdof)> = oscillator::numbers(solution.template())
        .filter(|(_, of, _)| of == coordinate)
        .map(|(node, _, single)| (node, single))
        .collect();
    let answered = |single: Sdof| {
        let (node, _) = known.iter().find(|(_, own)| *own == single)?;
        answers
            .last(*node)
            .filter(|own| own.source != Source::Related)
            .cloned()
    };
    let frequency = answered(Sdof::NaturalAngularFrequency);
    let ratio = answered(Sdof::DampingRatio);
    let source = frequency.clone().or_else(|| ratio.clone())?;
    let value =
        |own: &Option<Own>, right: f64| own.as_ref().map_or(Some(right), |own| own.value.as_real());
    let w = value(&frequency, (right.stiffness / right.mass).sqrt())?;
    let z = value(
        &ratio,
        right.damping / (2.0 * (right.stiffness * right.mass).sqrt()),
    )?;
    let own = Driven {
        stiffness: right.mass * w * w,
        damping: 2.0 * z * right.mass * w,
        ..right
    };
    Some((own, Some(source)))
}

impl Driven {
    /// The numbers of an equation of motion that one frequency drives.
    fn of(solution: &Solution<'_>, equation: &Equation, coordinate: &Name) -> Option<Self> {
        let value = |formula: &Expr| {
            let formula = in_data(formula, &solution.template().graph)?;
            number(&formula, solution.evaluation())
        };
        let coefficients = Coefficients::of(equation, coordinate)?;
        let still = Substitution::new().with(coordinate.clone(), Expr::number(0));
        let rest = still
            .apply(&(equation.right.clone() - equation.left.clone()))
            .ok()?;
        let (_, harmonics) = Normal::of(&rest).ok()?.harmonics(&Name::new("t")).ok()??;
        let (mut force, mut frequency) = (Complex::new(0.0, 0.0), None);
        for harmonic in &harmonics {
            let of = |part: &Normal| value(&part.to_expr(&Order::new()));
            let (factor, own) = (of(&harmonic.factor)?, of(&harmonic.frequency)?);
            // cos(Ωt + φ) is the real part of e^(iφ) e^(iΩt), a sine that of −i e^(iφ) e^(iΩt).
            let quarter = if harmonic.is_sine {
                std::f64::consts::FRAC_PI_2
            } else {
                0.0
            };
            let (sine, cosine) = crate::numerics::sin_cos(of(&harmonic.phase)? - quarter);
            // Under two frequencies there is no one amplitude.
            if frequency.is_some_and(|known| known != own) {
                return None;
            }
            frequency = Some(own);
            force = Complex::new(force.re + factor * cosine, force.im + factor * sine);
        }
        Some(Self {
            mass: value(&coefficients.mass)?,
            damping: value(&coefficients.damping)?,
            stiffness: value(&coefficients.stiffness)?,
            force,
            frequency: frequency?,
        })
    }

    fn amplitude(&self) -> Option<Value> {
        let re = self.stiffness - self.mass * self.frequency * self.frequency;
        let im = self.frequency * self.damping;
        let size = re * re + im * im;
        let (a, b) = (self.force.re, self.force.im);
        let numbers = vec![(a * re + b * im) / size, (b * re - a * im) / size];
        let form = Form {
            field: Field::Complex,
            shape: Shape::Scalar,
        };
        let is_finite = numbers.iter().all(|number| number.is_finite());
        is_finite.then(|| Value::new(form, numbers, vec![0.0; 2]))?
    }
}
