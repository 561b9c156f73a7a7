//! Where formulas and functions are compared: what is right inside the domain of an item is right, and no slip is.

use crate::BANK;
use vibank::answer::{KeyValue, Reason, Verdict};
use vibank::expr::{Expr, Kind, Name, Operator, Precise, Program, Slots, Substitution, Workspace};
use vibank::grade;
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;

/// The verdict on a response to a part of an item with these data.
fn verdict(item: &str, part: &str, set: &[(&str, &str)], response: &str) -> Verdict {
    let template = BANK.find(item).expect("the item is there");
    let place = template.parts.iter().position(|own| own.has_id(part));
    let instance = Instance::of(template, None, set).expect("an instance");
    let place = place.expect("the part is there");
    grade::mark(&Solution::of(instance), place, response).verdict
}

#[test]
fn forms_that_are_equal_where_the_constraints_hold_are_right() {
    for (item, part, response) in [
        ("ch3/t1-two-peaks", "zeta", "1/sqrt(1+(2*pi/D)^2)"),
        ("ch3/t1-two-peaks", "zeta", "|D|/sqrt(4*pi^2 + D^2)"),
        ("ch2/t3-unknown-mass-added", "k", "4*pi^2*dm/|T2^2 - T1^2|"),
        ("ch2/t3-unknown-mass-added", "m", "|dm*T1^2/(T1^2 - T2^2)|"),
    ] {
        assert_eq!(
            verdict(item, part, &[], response),
            Verdict::Right,
            "{item} {part} {response}"
        );
    }
}

#[test]
fn a_negative_datum_stays_negative() {
    let item = "[parameters]\nv = { value = '2 m/s', range = '-3 .. 3 m/s', step = '1 m/s' }\n[quantities]\n\
        speed = { formula = 'abs(v)', unit = 'm/s' }\n[[part]]\nid = 'p'\nkind = 'formula'\nkey = 'speed'\nask = 'Find it.'\n";
    let catalogue = super::catalogue(item);
    let template = catalogue.items().next().expect("an item");
    let of = |value: &str, response: &str| {
        let instance = Instance::of(template, None, &[("v", value)]).expect("an instance");
        grade::mark(&Solution::of(instance), 0, response).verdict
    };
    assert_eq!(of("-2 m/s", "-v"), Verdict::Right);
    assert_eq!(of("-2 m/s", "|v|"), Verdict::Right);
    assert_eq!(of("2 m/s", "v"), Verdict::Wrong);
    assert_eq!(of("-2 m/s", "v"), Verdict::Wrong);
    assert_eq!(of("2 m/s", "-v"), Verdict::Wrong);
    assert_eq!(of("2 m/s", "|v|"), Verdict::Right);
}

/// All that is said of a formula, matrix or equation is the same on every sheet, whichever was marked first.
#[test]
fn the_data_of_a_sheet_do_not_count() {
    let item = r#"
[parameters]
m = { value = "2 kg", range = "1 .. 5 kg", step = "0.5 kg" }
k = { value = "800 N/m", range = "200 .. 900 N/m", step = "50 N/m" }
[constraints]
stiff = "k/m > 200[1/s^2]"
[model]
coordinates = { x = { unit = "m" } }
kinetic = "1/2*m*x'^2"
potential = "1/2*k*x^2"
[quantities]
omega_n = { formula = "sqrt(k/m)", unit = "rad/s" }
[[part]]
id = "f"
kind = "formula"
key = "omega_n"
ask = "Find it."
[[part]]
id = "e"
kind = "equation"
key = "model.equation"
ask = "Find it."
"#;
    let responses = [
        (0, "sqrt(k/m)"),
        (0, "sqrt(k/(2*m))"),
        (0, "sqrt(k/m)/(2*pi)"),
        (0, "sqrt(m/k)"),
        (1, "m*x'' + k*x = 0"),
        (1, "m*x'' - k*x = 0"),
        (1, "m*x'' + 2*k*x = 0"),
        (1, "x'' + k*x = 0"),
    ];
    let sheets = [
        ("1 kg", "250 N/m"),
        ("2 kg", "900 N/m"),
        ("4 kg", "850 N/m"),
    ];
    let marked = |order: [usize; 3]| {
        let catalogue = super::catalogue(item);
        let template = catalogue.items().next().expect("an item");
        let mut markings = vec![String::new(); sheets.len()];
        for place in order {
            let (m, k) = sheets[place];
            let instance = Instance::of(template, None, &[("m", m), ("k", k)]).expect("data");
            let solution = Solution::of(instance);
            let all = responses.map(|(part, response)| grade::mark(&solution, part, response));
            markings[place] = format!("{all:?}");
        }
        markings
    };
    let markings = marked([0, 1, 2]);
    assert!(markings.iter().all(|own| *own == markings[0]));
    assert_eq!(markings, marked([2, 0, 1]));
}

#[test]
fn an_equality_among_the_constraints_is_solved() {
    let item = "[parameters]\na = { value = '2 m', range = '1 .. 3 m', step = '1 m' }\n\
        b = { value = '4 m', range = '1 .. 9 m', step = '1 m' }\n[constraints]\ntwice = 'b == 2*a'\n\
        [quantities]\nl = { formula = 'a + b', unit = 'm' }\n\
        [[part]]\nid = 'p'\nkind = 'formula'\nkey = 'l'\nask = 'Find it.'\n";
    super::check(
        item,
        &[
            ("a + b", "right"),
            ("b + b/2", "right"),
            ("3*a", "right"),
            ("2*a", "wrong"),
            ("2*b - a/2", "wrong"),
        ],
    );
}

#[test]
fn a_number_of_cycles_is_an_integer_and_a_mass_is_not() {
    let item = "[parameters]\nn = { value = '3', range = '1 .. 8', step = '1' }\n\
        m = { value = '3 kg', range = '1 .. 8 kg', step = '1 kg' }\n\
        [quantities]\nq = { formula = 'm*(-1)^n', unit = 'kg' }\n\
        [[part]]\nid = 'p'\nkind = 'formula'\nkey = 'q'\nask = 'Find it.'\n";
    super::check(
        item,
        &[
            ("m*cos(n*pi)", "right"),
            ("m*(-1)^(n+2)", "right"),
            ("m*(-1)^(n+1)", "wrong"),
            ("m*cos(2*n*pi)", "wrong"),
        ],
    );
}

/// A formula with its names in place of numbers, for an instance.
fn value(expr: &Expr, solution: &Solution<'_>) -> Option<f64> {
    let names: Vec<Name> = expr.names().free.into_iter().map(|own| own.name).collect();
    let texts: Vec<&str> = names.iter().map(Name::as_str).collect();
    let program = Program::compile(expr, &Slots(&texts)).ok()?;
    let graph = &solution.template().graph;
    let number = |name: &Name| {
        Some(Precise::exact(
            solution.evaluation().real(graph.find(name)?).ok()?,
        ))
    };
    let data = names.iter().map(number).collect::<Option<Vec<_>>>()?;
    program
        .evaluate(&data[..], &mut Workspace::default())
        .ok()?
        .as_real()
}

/// A formula changed at one place in each way that a hand slips: terms dropped, signs, factors, exponents and letters.
fn slips(expr: &Expr, letters: &[Name]) -> Vec<Expr> {
    let mut found = Vec::new();
    match expr.kind() {
        Kind::Binary(operator, a, b) => {
            let make = |operator, a: &Expr, b: &Expr| {
                Expr::derived(Kind::Binary(operator, a.clone(), b.clone()))
            };
            match operator {
                Operator::Add | Operator::Subtract => {
                    let other = if *operator == Operator::Add {
                        Operator::Subtract
                    } else {
                        Operator::Add
                    };
                    found.extend([a.clone(), b.clone(), make(other, a, b)]);
                }
                Operator::Multiply => {
                    found.extend([a.clone(), b.clone(), make(Operator::Divide, a, b)]);
                }
                Operator::Divide => found.extend([
                    a.clone(),
                    make(Operator::Multiply, a, b),
                    make(Operator::Divide, b, a),
                ]),
                Operator::Power => found.push(a.clone()),
            }
            found.extend(slips(a, letters).iter().map(|a| make(*operator, a, b)));
            if *operator != Operator::Power {
                found.extend(slips(b, letters).iter().map(|b| make(*operator, a, b)));
            }
        }
        Kind::Negate(inner) => {
            found.push(inner.clone());
            found.extend(
                slips(inner, letters)
                    .into_iter()
                    .map(|inner| Expr::derived(Kind::Negate(inner))),
            );
        }
        Kind::Call(function, arguments) if arguments.len() == 1 => {
            found.push(arguments[0].clone());
            let inner = slips(&arguments[0], letters).into_iter();
            found.extend(inner.map(|inner| Expr::call(*function, [inner])));
        }
        Kind::Name(name) => {
            let others = letters.iter().filter(|other| *other != name);
            found.extend(others.map(|other| Expr::name(other.clone())));
        }
        Kind::Number(number) => found.push(Expr::number(*number) + Expr::number(1)),
        _ => {}
    }
    found.extend([
        Expr::number(2) * expr.clone(),
        expr.clone() / Expr::number(2),
    ]);
    found
}

#[test]
fn no_slip_in_a_formula_of_the_bank_is_right() {
    let (mut count, mut faults) = (0, Vec::new());
    for template in BANK.items() {
        let drawn = (1..=4).filter_map(|seed| Instance::draw(template, Seed::new(seed)).ok());
        let drawn: Vec<Solution<'_>> = drawn.map(Solution::of).collect();
        let solution = Solution::of(Instance::of_source(template));
        for (place, part) in template.parts.iter().enumerate() {
            if part.answer.kind().name() != "formula" {
                continue;
            }
            let Ok(marker) = solution.marker(place) else {
                continue;
            };
            let KeyValue::Formula { text, .. } = marker.key().value else {
                continue;
            };
            let Ok(key) = Expr::read(&text) else { continue };
            let letters: Vec<Name> = key.names().free.into_iter().map(|own| own.name).collect();
            let differs = |slip: &Expr| {
                drawn.iter().chain([&solution]).any(|solution| {
                    match (value(&key, solution), value(slip, solution)) {
                        (Some(a), Some(b)) => (a - b).abs() > 1e-6 * a.abs().max(b.abs()),
                        _ => false,
                    }
                })
            };
            for slip in slips(&key, &letters).iter().filter(|slip| differs(slip)) {
                count += 1;
                let marking = grade::mark(&solution, place, &slip.to_string());
                // Where the item itself names a form that is right for some data, it says so.
                let is_named = matches!(marking.reasons()[..], [Reason::Mistake(_), ..]);
                if marking.verdict == Verdict::Right && !is_named {
                    faults.push(format!("{} {}: {slip} for {key}", template.id, part.id));
                }
            }
        }
    }
    assert!(count > 2000, "{count} slips");
    assert!(
        faults.is_empty(),
        "{} of {count}:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

#[test]
fn light_damping_is_seen_behind_the_span() {
    let item = "ch2/p1-pinned-bar-block";
    let light = [
        ("m", "1.5 kg"),
        ("l", "0.45 m"),
        ("c", "0.125 N s/m"),
        ("k", "250 N/m"),
        ("theta0", "0 rad"),
        ("thetadot0", "10 rad/s"),
    ];
    for (response, due) in [
        ("0.6325*sin(15.81*t)", Verdict::Wrong),
        ("0.6325*exp(-0.0125*t)*sin(15.81*t)", Verdict::Right),
        ("0.632*exp(-0.0125*t)*sin(15.8*t)", Verdict::Right),
        ("0.632*exp(-0.025*t)*sin(15.8*t)", Verdict::Wrong),
        ("0.632*exp(-0.00625*t)*sin(15.8*t)", Verdict::Wrong),
        ("0.632*exp(0.0125*t)*sin(15.8*t)", Verdict::Wrong),
    ] {
        assert_eq!(verdict(item, "theta", &light, response), due, "{response}");
    }
}

/// A key of one instance as a function of time in numbers of four figures, with one datum scaled.
fn in_numbers(key: &Expr, solution: &Solution<'_>, scaled: &Name, factor: f64) -> Option<String> {
    let graph = &solution.template().graph;
    let mut put = Substitution::new();
    for variable in key.names().free {
        if variable.name.as_str() == "t" {
            continue;
        }
        let number = solution
            .evaluation()
            .real(graph.find(&variable.name)?)
            .ok()?;
        let number = if variable.name == *scaled {
            factor * number
        } else {
            number
        };
        let digits = vibank::unit::Decimal::rounded(number, 4)?;
        put = put.with(variable.name, Expr::read(&format!("({digits})")).ok()?);
    }
    Some(put.apply(key).ok()?.to_string())
}

#[test]
fn a_motion_with_a_wrong_datum_is_wrong_across_the_bank() {
    let (mut count, mut faults) = (0, Vec::new());
    for template in BANK.items() {
        for seed in 0..3 {
            let Ok(instance) = Instance::draw(template, Seed::new(seed)) else {
                continue;
            };
            let solution = Solution::of(instance);
            for (place, part) in template.parts.iter().enumerate() {
                if part.answer.kind().name() != "function" || !solution.asks(place) {
                    continue;
                }
                let Ok(marker) = solution.marker(place) else {
                    continue;
                };
                let KeyValue::Formula { text, .. } = marker.key().value else {
                    continue;
                };
                let Ok(key) = Expr::read(&text) else { continue };
                let [node] = part.answer.keys()[..] else {
                    continue;
                };
                let Some(key) = branch(&key, &solution) else {
                    continue;
                };
                for datum in template.graph.parameters(node) {
                    let name = Name::new(template.graph.label(datum));
                    for factor in [0.5, 2.0] {
                        if !key.names().uses(&name) {
                            continue;
                        }
                        let (Some(right), Some(wrong)) = (
                            in_numbers(&key, &solution, &name, 1.0),
                            in_numbers(&key, &solution, &name, factor),
                        ) else {
                            continue;
                        };
                        // What hardly changes the motion is no slip, and what cannot be typed is none either.
                        if !differ(&right, &wrong)
                            || grade::mark(&solution, place, &right).verdict != Verdict::Right
                        {
                            continue;
                        }
                        count += 1;
                        let marking = grade::mark(&solution, place, &wrong);
                        if marking.verdict == Verdict::Right {
                            faults.push(format!(
                                "{} {} seed {seed}: {factor} {name}: {wrong}",
                                template.id, part.id
                            ));
                        }
                    }
                }
            }
        }
    }
    assert!(count > 200, "{count} motions");
    assert!(
        faults.is_empty(),
        "{} of {count}:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

/// Whether two functions of time differ by a sixth of the larger one's largest value, at some time.
fn differ(first: &str, second: &str) -> bool {
    let values = |text: &str| -> Vec<f64> {
        let expr = Expr::read(text).expect("a formula");
        let program = Program::compile(&expr, &Slots(&["t"])).expect("it compiles");
        let time = |place: i32| Precise::exact(1e-3 * 10_f64.powf(f64::from(place) / 80.0));
        let mut room = Workspace::default();
        let value = |place| {
            program
                .evaluate(&[time(place)][..], &mut room)
                .ok()?
                .as_real()
        };
        (0..400).filter_map(value).collect()
    };
    let (first, second) = (values(first), values(second));
    let largest = first
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut pairs = first.iter().zip(&second);
    first.len() == second.len() && pairs.any(|(a, b)| (a - b).abs() > largest / 6.0)
}

/// The branch of a formula that holds for an instance.
fn branch(expr: &Expr, solution: &Solution<'_>) -> Option<Expr> {
    let Kind::If(condition, first, second) = expr.kind() else {
        return Some(expr.clone());
    };
    let number = Expr::derived(Kind::If(
        condition.clone(),
        Expr::number(1),
        Expr::number(0),
    ));
    let holds = value(&number, solution)?;
    branch(if holds == 1.0 { first } else { second }, solution)
}
