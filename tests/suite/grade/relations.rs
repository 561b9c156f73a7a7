//! Follow-through along the relations between what was asked, where the author's formula goes back to the data.

use crate::BANK;
use vibank::answer::{Marking, Reason, Verdict};
use vibank::grade::Grade;
use vibank::instance::Instance;
use vibank::mechanics::Sdof;
use vibank::solution::{Nested, Number, Solution};

/// The marking of the last of these responses.
fn last(item: &str, set: &[(&str, &str)], responses: &[(&str, &str)]) -> Marking {
    let template = BANK.find(item).expect("the item is there");
    let solution = Solution::of(Instance::of(template, None, set).expect("an instance"));
    let place = |part: &str| {
        let place = template.parts.iter().position(|own| own.has_id(part));
        place.expect("the part is there")
    };
    let all = responses
        .iter()
        .map(|(part, response)| (place(part), *response));
    let grade = Grade::mark(&solution, all);
    let (part, _) = responses.last().expect("there is a response");
    grade.part(place(part)).expect("it was marked").clone()
}

/// The last response counts as a follow-through of the others, and is not right without them.
#[track_caller]
fn follows(item: &str, responses: &[(&str, &str)]) {
    let marking = last(item, &[], responses);
    assert_eq!(
        marking.verdict,
        Verdict::Right,
        "{responses:?}: {marking:?}"
    );
    assert_eq!(marking.reasons()[0], Reason::FollowThrough, "{marking:?}");
    let alone = last(item, &[], &responses[responses.len() - 1..]);
    assert_ne!(alone.verdict, Verdict::Right, "{alone:?}");
}

#[test]
fn what_was_asked_goes_on_where_the_author_goes_back_to_the_data() {
    // k = m ω₀².
    follows(
        "ch2/t1-stiffness-from-period",
        &[("omega0", "5 rad/s"), ("k_value", "10 N/m")],
    );
    // v_max = ω₀ A, and √(2 E/m).
    let energy = "ch2/t6-energy-of-free-motion";
    follows(energy, &[("omega0", "10 rad/s"), ("v_max", "0.5916 m/s")]);
    follows(energy, &[("A", "0.05 m"), ("v_max", "0.6325 m/s")]);
    follows(energy, &[("E", "1/2*k*x0^2"), ("v_max", "0.6325 m/s")]);
    // Ω_p = ω₀/√(1 − 2ζ²).
    let rotor = "ch4/t1-rotating-unbalance";
    follows(rotor, &[("zeta", "0.4"), ("Omega_pk", "24.25 rad/s")]);
    follows(
        rotor,
        &[("omega_n", "25 rad/s"), ("Omega_pk", "26.06 rad/s")],
    );
    // Z = U r²/√((1 − r²)² + (2ζr)²), r = Ω/ω₀.
    follows(
        "ch4/p3-base-excited-relative",
        &[("omega_n", "1.8 rad/s"), ("Z", "0.3885 m")],
    );
    // n half-periods.
    follows(
        "ch3/p3-two-springs-coulomb",
        &[("T", "2*pi*sqrt(m/k)"), ("t_stop", "1.777 s")],
    );
}

#[test]
fn an_amplitude_follows_from_a_wrong_equation() {
    let item = "ch4/p1-rolling-disk-hub-moment";
    // 16/√((88 − 2·4²)² + (2·4)²).
    let equation = ("eom", "m*x'' + b*x' + 11/2*k*x = -M0/r*sin(Omega*t)");
    follows(item, &[equation, ("X", "0.2828 m")]);
}

#[test]
fn a_named_mistake_does_not_beat_what_follows() {
    let item = "ch3/t1-two-peaks";
    // ln 8 in place of its half, then λ = D/T_p and c = 2 m D/T_p.
    follows(item, &[("D", "2.079"), ("lam", "3.466 1/s")]);
    follows(item, &[("D", "2.079"), ("c", "10.40 N s/m")]);
}

#[test]
fn a_named_mistake_is_not_taken_for_what_follows_within_a_wide_tolerance() {
    let set = [
        ("mu_k", "0.3"),
        ("x0", "0.2 m"),
        ("v0", "0.5 m/s"),
        ("m", "2 kg"),
        ("k", "200 N/m"),
    ];
    let of = |response| {
        last(
            "ch3/t6-coulomb-general",
            &set,
            &[("delta", "38.26 mm"), ("x_rest", response)],
        )
    };
    // It follows to 24.4 mm; 28.8 mm is the right distance on the wrong side.
    assert_ne!(of("28.8 mm").verdict, Verdict::Right);
    assert_eq!(of("24.4 mm").verdict, Verdict::Right);
}

#[test]
fn the_same_mistake_twice_is_no_follow_through() {
    let item = "ch3/p3-two-springs-coulomb";
    // One spring of two, in the period and again in the friction band.
    let marking = last(item, &[], &[("T", "2*pi*sqrt(m/k)"), ("delta", "39.24 mm")]);
    assert_ne!(marking.verdict, Verdict::Right, "{marking:?}");
}

#[test]
fn nothing_is_credited_that_does_not_follow() {
    let (mut count, mut faults) = (0, Vec::new());
    for template in BANK.items() {
        let solution = Solution::of(Instance::of_source(template));
        let number = |place: usize, factor: f64| {
            let part = &template.parts[place];
            let entry = solution.entry(&part.id, &[])?;
            let (Some(Nested::One(Number::Real(si))), Some(Nested::One(unit))) =
                (entry.si, entry.unit)
            else {
                return None;
            };
            let unit = if unit == "1" { String::new() } else { unit };
            let is_numeric = part.answer.kind().name() == "numeric" && si != 0.0;
            is_numeric.then(|| format!("{} {unit}", factor * si))
        };
        let earlier: Vec<Option<String>> = (0..template.parts.len())
            .map(|place| number(place, 1.21))
            .collect();
        for place in 1..template.parts.len() {
            // Far from the powers of the factor of the earlier answers.
            for factor in [0.537, 1.713, 2.389] {
                let Some(response) = number(place, factor) else {
                    continue;
                };
                let before = (0..place).filter_map(|at| Some((at, earlier[at].as_deref()?)));
                let grade = Grade::mark(&solution, before.chain([(place, response.as_str())]));
                count += 1;
                if grade
                    .part(place)
                    .is_some_and(|marking| marking.verdict == Verdict::Right)
                {
                    faults.push(format!(
                        "{} {}: {response}",
                        template.id, template.parts[place].id
                    ));
                }
            }
        }
    }
    assert!(count > 500, "{count} responses");
    // A number may follow by chance, as 2.389 does from 1.21 to the fifth power within two per cent.
    assert!(
        faults.len() * 100 <= count,
        "{} of {count}:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

#[test]
fn the_relations_of_one_degree_of_freedom_agree_with_each_other() {
    use vibank::expr::{Expr, Name, Precise, Program, Slots, Workspace};
    let of = |formula: &str, known: &[(Sdof, f64)]| {
        let expr = Expr::read(formula).expect("a formula");
        let names: Vec<Name> = expr.names().free.into_iter().map(|own| own.name).collect();
        let texts: Vec<&str> = names.iter().map(Name::as_str).collect();
        let program = Program::compile(&expr, &Slots(&texts)).expect("it compiles");
        let number = |name: &Name| {
            let single = Sdof::of_letter(name.as_str()).expect("a letter of a number");
            let found = known.iter().find(|(own, _)| *own == single);
            Precise::exact(found.expect("it is known").1)
        };
        let data: Vec<Precise> = names.iter().map(number).collect();
        let value = program.evaluate(&data[..], &mut Workspace::default());
        value.expect("a value").as_real().expect("a real value")
    };
    let mut known = vec![
        (Sdof::Mass, 1.7),
        (Sdof::Damping, 0.9),
        (Sdof::Stiffness, 23.0),
    ];
    let defined: Vec<(Sdof, f64)> = Sdof::ALL[3..]
        .iter()
        .map(|single| (*single, of(single.definition(), &known)))
        .collect();
    known.extend(defined);
    for (single, due) in known.clone() {
        for relation in single.relations() {
            let found = of(relation, &known);
            assert!(
                (found - due).abs() <= 1e-12 * due,
                "{single:?} = {relation}: {found}, not {due}"
            );
        }
    }
    // The numbers of the solver are the same.
    let oscillator = vibank::vibration::Oscillator::new(1.7, 0.9, 23.0).expect("an oscillator");
    for (single, solved) in [
        (
            Sdof::NaturalAngularFrequency,
            oscillator.natural_angular_frequency(),
        ),
        (Sdof::DecayRate, oscillator.decay_rate()),
        (Sdof::DampingRatio, oscillator.damping_ratio()),
        (Sdof::CriticalDamping, oscillator.critical_damping()),
        (
            Sdof::DampedAngularFrequency,
            oscillator
                .damped_angular_frequency()
                .expect("it oscillates"),
        ),
        (
            Sdof::QualityFactor,
            oscillator.quality_factor().expect("it is damped"),
        ),
    ] {
        let due = known
            .iter()
            .find(|(own, _)| *own == single)
            .expect("known")
            .1;
        assert!(
            (solved - due).abs() <= 1e-14 * due,
            "{single:?}: {solved}, not {due}"
        );
    }
}
