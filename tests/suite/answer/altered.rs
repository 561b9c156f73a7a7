//! Formulas, equations and matrices of the bank with one thing altered, typed as responses: a term or factor dropped, a
//! sign turned, a number or a coefficient doubled, sine and cosine exchanged. None is right, unless it is the same after
//! all, which numbers show.

use std::collections::BTreeMap;

use crate::BANK;
use vibank::answer::{AnswerKind, KeyValue, Verdict};
use vibank::bank::Template;
use vibank::expr::{Constant, Equation, Expr, Function, Kind, Operator};
use vibank::grade::mark;
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;

const SEED: u64 = 3;

/// Formulas that differ from this one in one place.
fn altered(formula: &Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    let derived = Expr::derived;
    let double = |expr: &Expr| {
        derived(Kind::Binary(
            Operator::Multiply,
            derived(Kind::Number(2.into())),
            expr.clone(),
        ))
    };
    match formula.kind() {
        Kind::Binary(operator, left, right) => {
            let of = |operator, left: &Expr, right: &Expr| {
                derived(Kind::Binary(operator, left.clone(), right.clone()))
            };
            match operator {
                Operator::Add | Operator::Subtract => {
                    let other = match operator {
                        Operator::Add => Operator::Subtract,
                        _ => Operator::Add,
                    };
                    found.extend([left.clone(), right.clone(), of(other, left, right)]);
                    found.extend([
                        of(*operator, &double(left), right),
                        of(*operator, left, &double(right)),
                    ]);
                }
                Operator::Multiply => found.extend([
                    left.clone(),
                    right.clone(),
                    of(Operator::Divide, left, right),
                ]),
                Operator::Divide => found.extend([
                    left.clone(),
                    of(Operator::Multiply, left, right),
                    of(Operator::Divide, right, left),
                ]),
                Operator::Power => {
                    found.extend([left.clone(), of(Operator::Power, left, &double(right))]);
                }
            }
            found.extend(altered(left).iter().map(|left| of(*operator, left, right)));
            found.extend(
                altered(right)
                    .iter()
                    .map(|right| of(*operator, left, right)),
            );
        }
        Kind::Negate(inner) => {
            found.push(inner.clone());
            let of = |inner| derived(Kind::Negate(inner));
            found.extend(altered(inner).into_iter().map(of));
        }
        Kind::Call(function, arguments) => {
            let other = match function {
                Function::Sin => Some(Function::Cos),
                Function::Cos => Some(Function::Sin),
                Function::Sinh => Some(Function::Cosh),
                Function::Cosh => Some(Function::Sinh),
                _ => None,
            };
            found.extend(other.map(|other| derived(Kind::Call(other, arguments.clone()))));
            if let [argument] = &arguments[..] {
                found.push(argument.clone());
            }
            for (at, argument) in arguments.iter().enumerate() {
                found.extend(altered(argument).into_iter().map(|own| {
                    let mut arguments = arguments.clone();
                    arguments[at] = own;
                    derived(Kind::Call(*function, arguments))
                }));
            }
        }
        Kind::Array(entries) => {
            for (at, entry) in entries.iter().enumerate() {
                let mut own = altered(entry);
                if !matches!(entry.kind(), Kind::Array(_)) {
                    own.extend([derived(Kind::Negate(entry.clone())), double(entry)]);
                }
                found.extend(own.into_iter().map(|own| {
                    let mut entries = entries.clone();
                    entries[at] = own;
                    derived(Kind::Array(entries))
                }));
            }
        }
        Kind::Number(_) => found.push(double(formula)),
        Kind::Prime(inner, order) => {
            found.push(inner.clone());
            found.push(derived(Kind::Prime(inner.clone(), 3 - (*order).min(2))));
        }
        _ => {}
    }
    found
}

/// Values of letters, drawn when they are met. Moving ones are drawn anew for each point, the others stay.
struct Point {
    number: u64,
    moving: Vec<String>,
}

impl Point {
    fn value(&self, letter: &str, order: u8) -> f64 {
        let is_moving = order > 0 || letter == "t" || self.moving.iter().any(|own| own == letter);
        let point = if is_moving { self.number } else { 0 };
        let seed = letter
            .bytes()
            .fold(u64::from(order) + 7 * point + 1, |sum, byte| {
                (sum.wrapping_mul(0x100_0000_01b3)) ^ u64::from(byte)
            });
        let mixed = (seed ^ (seed >> 29)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        0.6 + (mixed >> 40) as f64 / (1_u64 << 24) as f64
    }

    /// The values of a formula, of all entries; nothing for what this evaluator does not know.
    fn values(&self, formula: &Expr) -> Option<Vec<f64>> {
        let one = |expr: &Expr| match &self.values(expr)?[..] {
            [value] => Some(*value),
            _ => None,
        };
        Some(vec![match formula.kind() {
            Kind::Number(number) => number.to_f64(),
            Kind::Name(name) => self.value(name.as_str(), 0),
            Kind::Prime(inner, order) => match inner.kind() {
                Kind::Name(name) => self.value(name.as_str(), *order),
                _ => return None,
            },
            Kind::Constant(Constant::Pi) => std::f64::consts::PI,
            Kind::Constant(Constant::E) => std::f64::consts::E,
            Kind::Negate(inner) => -one(inner)?,
            Kind::Binary(operator, left, right) => {
                let (left, right) = (one(left)?, one(right)?);
                match operator {
                    Operator::Add => left + right,
                    Operator::Subtract => left - right,
                    Operator::Multiply => left * right,
                    Operator::Divide => left / right,
                    Operator::Power => left.powf(right),
                }
            }
            Kind::Call(function, arguments) => {
                let first = one(arguments.first()?)?;
                match function {
                    Function::Sqrt => first.sqrt(),
                    Function::Sin => first.sin(),
                    Function::Cos => first.cos(),
                    Function::Tan => first.tan(),
                    Function::Exp => first.exp(),
                    Function::Ln => first.ln(),
                    Function::Abs => first.abs(),
                    Function::Sign => first.signum(),
                    _ => return None,
                }
            }
            Kind::Array(entries) => {
                let values: Option<Vec<Vec<f64>>> =
                    entries.iter().map(|entry| self.values(entry)).collect();
                return Some(values?.concat());
            }
            _ => return None,
        }])
    }
}

/// Whether two formulas are the same at some points; as sides of equations, but for a factor that does not move.
fn are_same(key: &Expr, other: &Expr, moving: &[String], is_equation: bool) -> bool {
    let at = |number| {
        let point = Point {
            number,
            moving: moving.to_vec(),
        };
        let (one, two) = (point.values(key)?, point.values(other)?);
        (one.len() == two.len()).then_some((one, two))
    };
    let points: Option<Vec<_>> = (1..=4).map(at).collect();
    // What cannot be evaluated is looked at by the marker alone.
    let Some(points) = points else { return true };
    if is_equation {
        let ratios: Vec<f64> = points.iter().map(|(one, two)| two[0] / one[0]).collect();
        return ratios
            .iter()
            .all(|ratio| !ratio.is_finite() || (ratio / ratios[0] - 1.0).abs() < 1e-9);
    }
    // Of formulas all letters may take other values.
    points.iter().all(|(one, two)| {
        one.iter().zip(two).all(|(one, two)| {
            (one - two).abs() <= 1e-9 * one.abs().max(two.abs())
                || !one.is_finite()
                || !two.is_finite()
        })
    })
}

struct Counts {
    typed: BTreeMap<&'static str, usize>,
    right: Vec<String>,
}

impl Counts {
    /// Marks a response that differs from the key.
    fn count(
        &mut self,
        kind: &'static str,
        solution: &Solution<'_>,
        place: usize,
        typed: &str,
        key: &str,
    ) {
        *self.typed.entry(kind).or_default() += 1;
        if mark(solution, place, typed).verdict == Verdict::Right {
            let item = solution.template();
            let part = &item.parts[place].id;
            self.right
                .push(format!("{} {part}: `{typed}` for `{key}`", item.id));
        }
    }
}

/// What a matrix reads as with one minus dropped, or one digit altered that is no part of a letter.
fn altered_signs(printed: &str) -> Vec<String> {
    let alter = |(at, char): (usize, char)| {
        let new = match char {
            '−' | '-' => String::new(),
            '1'..='8' => char::from(char as u8 + 1).to_string(),
            _ => return None,
        };
        Some(format!(
            "{}{new}{}",
            &printed[..at],
            &printed[at + char.len_utf8()..]
        ))
    };
    printed.char_indices().filter_map(alter).collect()
}

fn try_item(item: &Template, counts: &mut Counts) {
    // Data of a source may be 1 or 0, which hides what is dropped.
    let Ok(instance) = Instance::draw(item, Seed::new(SEED)) else {
        return;
    };
    let solution = Solution::of(instance);
    for (place, part) in item.parts.iter().enumerate() {
        let kind = part.answer.kind();
        let name = match kind {
            AnswerKind::Formula => "formulas",
            AnswerKind::Equation => "equations",
            AnswerKind::Matrix => "matrices",
            // Functions of time are compared for the data of the item, which may hide what is altered.
            _ => continue,
        };
        let Ok(marker) = solution.marker(place) else {
            continue;
        };
        let key = marker.key();
        if kind == AnswerKind::Matrix {
            let printed = key.math.plain();
            for typed in altered_signs(&printed) {
                counts.count(name, &solution, place, &typed, &printed);
            }
            continue;
        }
        let KeyValue::Formula { text, .. } = &key.value else {
            continue;
        };
        let is_equation = kind == AnswerKind::Equation;
        let (side, rest) = match Equation::read(text) {
            Ok(equation) => (equation.left, format!(" = {}", equation.right)),
            Err(_) => match Expr::read(text) {
                Ok(formula) => (formula, String::new()),
                Err(_) => continue,
            },
        };
        let mut moving = Vec::new();
        side.walk(&mut |node| {
            if let Kind::Prime(inner, _) = node.kind() {
                moving.push(inner.to_string());
            }
        });
        for other in altered(&side) {
            let is_same = are_same(&side, &other, &moving, is_equation);
            if is_same {
                continue;
            }
            let typed = format!("{other}{rest}");
            counts.count(name, &solution, place, &typed, text);
        }
    }
}

#[test]
fn a_key_with_one_thing_altered_is_not_right() {
    let items: Vec<&Template> = BANK.items().collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let all = std::thread::scope(|scope| {
        let runs: Vec<_> = (0..threads)
            .map(|own| {
                let items = &items;
                scope.spawn(move || {
                    let mut counts = Counts {
                        typed: BTreeMap::new(),
                        right: Vec::new(),
                    };
                    items
                        .iter()
                        .skip(own)
                        .step_by(threads)
                        .for_each(|item| try_item(item, &mut counts));
                    counts
                })
            })
            .collect();
        runs.into_iter()
            .map(|run| run.join().expect("it ends"))
            .collect::<Vec<_>>()
    });
    let mut typed: BTreeMap<&str, usize> = BTreeMap::new();
    for (name, count) in all.iter().flat_map(|counts| &counts.typed) {
        *typed.entry(name).or_default() += count;
    }
    let right: Vec<&String> = all.iter().flat_map(|counts| &counts.right).collect();
    assert!(right.is_empty(), "{typed:?}, right: {right:#?}");
    assert!(
        ["formulas", "equations", "matrices"]
            .iter()
            .all(|name| typed[name] > 50),
        "{typed:?}"
    );
}
