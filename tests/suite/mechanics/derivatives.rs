//! Two routes to M, C and K, and a third one by another library.

use std::sync::Arc;

use num_dual::{DualNum, HyperDual64};
use vibank::expr::{Name, Precise};
use vibank::mechanics::{Model, Numbers};

use super::systems::SYSTEMS;

/// Some number between 1/2 and 3/2 that belongs to a name.
fn datum(name: &Name, turn: u32) -> f64 {
    let letters = name.as_str().bytes().map(u32::from);
    let mixed = letters.fold(turn, |mixed, letter| {
        mixed.wrapping_mul(31).wrapping_add(letter)
    });
    0.5 + f64::from(mixed.wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24)
}

fn numbers(model: &Arc<Model>, turn: u32) -> Numbers {
    Numbers::of(model.clone(), |name| Ok(Precise::exact(datum(name, turn))))
}

#[test]
fn symbolic_and_hyper_dual_matrices_agree() {
    for system in SYSTEMS {
        let model = Arc::new(system.model());
        for turn in 0..20 {
            let numbers = numbers(&model, turn);
            let by_numbers = numbers.linearization().unwrap();
            let pairs = [
                (numbers.mass_matrix(), by_numbers.mass),
                (numbers.damping_matrix(), by_numbers.damping),
                (numbers.stiffness_matrix(), by_numbers.stiffness),
            ];
            for (symbolic, other) in pairs {
                let symbolic = symbolic.unwrap().numbers();
                let scale = symbolic
                    .iter()
                    .fold(0.0, |scale: f64, own| scale.max(own.abs()));
                for (a, b) in symbolic.iter().zip(&other) {
                    let off = (a - b).abs();
                    assert!(
                        off <= 4.0 * f64::EPSILON * scale,
                        "{}: {a} and {b}",
                        system.name
                    );
                }
            }
        }
    }
}

/// The energies of the double pendulum, over any numbers.
struct DoublePendulum([f64; 5]);

impl DoublePendulum {
    fn kinetic(&self, [a, b]: [HyperDual64; 2], [u, v]: [HyperDual64; 2]) -> HyperDual64 {
        let [m1, m2, l1, l2, _] = self.0;
        let x = a.cos() * u * l1 + b.cos() * v * l2;
        let y = a.sin() * u * l1 + b.sin() * v * l2;
        (u * l1) * (u * l1) * (0.5 * m1) + (x * x + y * y) * (0.5 * m2)
    }

    fn potential(&self, [a, b]: [HyperDual64; 2]) -> HyperDual64 {
        let [m1, m2, l1, l2, g] = self.0;
        -(a.cos() * ((m1 + m2) * g * l1)) - b.cos() * (m2 * g * l2)
    }
}

/// Zeros, with ε₁ at one place and ε₂ at another.
fn seeded(first: usize, second: usize) -> [HyperDual64; 2] {
    [0, 1].map(|at| {
        let part = |own: usize| f64::from(u8::from(own == at));
        HyperDual64::new(0.0, part(first), part(second), 0.0)
    })
}

#[test]
fn another_library_gives_the_same_matrices() {
    let system = SYSTEMS
        .iter()
        .find(|own| own.name == "double pendulum")
        .unwrap();
    let model = Arc::new(system.model());
    let numbers = numbers(&model, 7);
    let data = ["m1", "m2", "l1", "l2", "g"].map(|name| datum(&Name::from(name), 7));
    let witness = DoublePendulum(data);
    let own = numbers.linearization().unwrap();
    let still = [HyperDual64::from(0.0); 2];
    for at in 0..4 {
        let (row, column) = (at / 2, at % 2);
        let mass = witness.kinetic(still, seeded(row, column)).eps1eps2;
        let stiffness = witness.potential(seeded(row, column)).eps1eps2;
        assert!((own.mass[at] - mass).abs() <= 4.0 * f64::EPSILON * own.mass[0]);
        assert!((own.stiffness[at] - stiffness).abs() <= 4.0 * f64::EPSILON * own.stiffness[0]);
    }
}

#[test]
fn functions_and_operators_have_the_derivatives_of_another_library() {
    use vibank::expr::{Expr, HyperDual, Inputs, Program, Registers, Slots, Undefined};
    struct At(f64);
    impl Inputs<HyperDual> for At {
        fn input(&self, _slot: u32) -> Result<HyperDual, Undefined> {
            Ok(HyperDual {
                value: self.0,
                first: 1.0,
                second: 1.0,
                both: 0.0,
            })
        }
    }
    type Function = fn(HyperDual64) -> HyperDual64;
    let cases: [(&str, Function); 16] = [
        ("sqrt(x)", |x| x.sqrt()),
        ("exp(x)", |x| x.exp()),
        ("ln(x)", |x| x.ln()),
        ("log10(x)", |x| x.log10()),
        ("sin(x)", |x| x.sin()),
        ("cos(x)", |x| x.cos()),
        ("tan(x)", |x| x.tan()),
        ("asin(x)", |x| x.asin()),
        ("acos(x)", |x| x.acos()),
        ("atan(x)", |x| x.atan()),
        ("sinh(x)", |x| x.sinh()),
        ("tanh(x)", |x| x.tanh()),
        ("atanh(x)", |x| x.atanh()),
        ("x^x", |x| (x * x.ln()).exp()),
        ("x^(-5/2)/(1 + x^3)", |x| x.powf(-2.5) / (x.powi(3) + 1.0)),
        ("atan2(x, 2 - x)", |x| (x / (-x + 2.0)).atan()),
    ];
    for (formula, function) in cases {
        let program = Program::compile(&Expr::read(formula).unwrap(), &Slots(&["x"])).unwrap();
        let mut room = Registers::default();
        for x in [0.125, 0.37, 0.81] {
            let own = *program
                .run(&At(x), &mut room)
                .unwrap()
                .numbers()
                .next()
                .unwrap();
            let other = function(HyperDual64::new(x, 1.0, 1.0, 0.0));
            let pairs = [
                (own.value, other.re),
                (own.first, other.eps1),
                (own.both, other.eps1eps2),
            ];
            for (a, b) in pairs {
                assert!(
                    (a - b).abs() <= 1e-14 * b.abs().max(1.0),
                    "{formula} at {x}: {a} and {b}"
                );
            }
        }
    }
}
