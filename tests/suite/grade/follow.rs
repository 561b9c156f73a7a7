//! Follow-through on items of the bank: own earlier answers go on, and nothing is given away.

use crate::BANK;
use vibank::answer::{Marking, Reason, Verdict};
use vibank::bank::Catalogue;
use vibank::grade::{Grade, remarks};
use vibank::instance::Instance;
use vibank::solution::Solution;

/// The bank, loaded once.
/// Marks responses to parts of an item with the data of its source; the marking of the last one.
fn last(item: &str, responses: &[(&str, &str)]) -> Marking {
    marked(&BANK, item, responses)
}

fn marked(catalogue: &Catalogue, item: &str, responses: &[(&str, &str)]) -> Marking {
    let template = catalogue.find(item).expect("the item is there");
    let solution = Solution::of(Instance::of_source(template));
    let place = |part: &str| {
        let mut parts = template.parts.iter();
        parts
            .position(|own| own.has_id(part))
            .expect("the part is there")
    };
    let all = responses
        .iter()
        .map(|(part, response)| (place(part), *response));
    let grade = Grade::mark(&solution, all);
    let (part, _) = responses.last().expect("there is a response");
    grade.part(place(part)).expect("it was marked").clone()
}

/// The last response counts as a follow-through of the others, and not without them.
#[track_caller]
fn follows(item: &str, responses: &[(&str, &str)]) {
    let marking = last(item, responses);
    assert_eq!(marking.verdict, Verdict::Right, "{marking:?}");
    assert_eq!(marking.reason(), Reason::FollowThrough, "{marking:?}");
    let alone = last(item, &responses[responses.len() - 1..]);
    assert_ne!(alone.verdict, Verdict::Right, "{alone:?}");
}

/// The last response is not right, whatever the others are.
#[track_caller]
fn stays_wrong(catalogue: &Catalogue, item: &str, responses: &[(&str, &str)]) {
    let marking = marked(catalogue, item, responses);
    assert_eq!(marking.verdict, Verdict::Wrong, "{marking:?}");
}

/// The springs taken in series as k1 and k2 alone: 2.4 N/m instead of 4 N/m.
const SERIES: (&str, &str) = ("k_eq", "k1*k2/(k1 + k2)");

#[test]
fn values_follow_from_a_formula_of_ones_own() {
    let item = "ch4/p3-base-excited-relative";
    // √(2.4/2), 4/(2√4.8), 4/√(5.6² + 8²).
    follows(item, &[SERIES, ("omega_n", "1.095 rad/s")]);
    follows(item, &[SERIES, ("zeta", "0.913")]);
    follows(item, &[SERIES, ("Z", "40.96 cm")]);
    follows(
        item,
        &[
            SERIES,
            ("Z", "40.96 cm"),
            ("z_ss", "0.4096*sin(2*t - 2.1815)"),
        ],
    );
}

#[test]
fn values_follow_from_a_value_in_place_of_a_formula() {
    let energy = "ch2/t6-energy-of-free-motion";
    follows(energy, &[("E", "0.28 J"), ("v_max", "1.0583 m/s")]);
    follows(energy, &[("E", "0.28 J"), ("A", "83.67 mm")]);
    let friction = "ch3/p3-two-springs-coulomb";
    follows(friction, &[("T", "0.8886 s"), ("t_stop", "1.7772 s")]);
    // Of another dimension it stands for nothing.
    stays_wrong(&BANK, energy, &[("E", "0.28 V"), ("v_max", "1.0583 m/s")]);
}

#[test]
fn an_equation_and_a_formula_follow_from_a_formula() {
    let item = "ch4/p3-base-excited-relative";
    let equation = "m*z'' + b*z' + k1*k2/(k1 + k2)*z = m*U*Omega^2*sin(Omega*t)";
    follows(item, &[SERIES, ("eom", equation)]);
    let own = ("omega_n", "sqrt(15*k/(4*m))");
    let right = ("zeta", "c/2*sqrt(3/(50*k*m))");
    let formula = "sqrt(15*k/(4*m))*sqrt(1 - 3*c^2/(200*k*m))";
    follows(
        "ch2/p1-pinned-bar-block",
        &[own, right, ("omega_d", formula)],
    );
}

#[test]
fn what_follows_from_a_wrong_equation_of_motion_counts() {
    let item = "ch2/p1-pinned-bar-block";
    // The spring under the block is taken at the end of the bar; times −6, as some would write it.
    let eom = (
        "eom",
        "-5*m*l^2*theta'' - 3/2*c*l^2*theta' - 12*k*l^2*theta = 0",
    );
    follows(item, &[eom, ("omega_n", "sqrt(12*k/(5*m))")]);
    follows(item, &[eom, ("omega_n_value", "20 rad/s")]);
    follows(item, &[eom, ("zeta", "c/(8*sqrt(5*k*m/3))")]);
    follows(
        item,
        &[
            eom,
            ("omega_n", "sqrt(12*k/(5*m))"),
            ("omega_n_value", "20 rad/s"),
        ],
    );
    // What the slip leaves alone is not a follow-through.
    let marking = last(item, &[eom, ("c_eq", "c*l^2/4")]);
    assert_eq!(
        (marking.verdict, marking.reason()),
        (Verdict::Right, Reason::Matches)
    );
}

#[test]
fn numbers_follow_from_numbers_and_right_ones_stay() {
    let item = "ch5/e6-coupled-pendulums-beats";
    let (own, right) = (("omega_in", "3.5 rad/s"), ("omega_anti", "3.189 rad/s"));
    follows(item, &[own, right, ("omega_mean", "3.345 rad/s")]);
    let item = "ch3/p3-two-springs-coulomb";
    // Half the band, (0.15/0.0098 − 1)/2 = 7.2: eight half-cycles instead of four.
    follows(item, &[("delta", "9.81 mm"), ("n_half", "8")]);
    follows(
        item,
        &[("delta", "9.81 mm"), ("n_half", "8"), ("t_stop", "2.513 s")],
    );
}

#[test]
fn numbers_of_an_oscillator_follow_from_each_other() {
    // The item computes both from stiffness and mass; the period goes on from the pulsation all the same.
    let item = "[item]\ntitle = 'A'\nsource = 'by hand'\n[parameters]\nm = '2 kg'\nk = '200 N/m'\n\
        [model]\ncoordinates = { x = { unit = 'm' } }\nkinetic = \"1/2*m*x'^2\"\npotential = '1/2*k*x^2'\n\
        [quantities]\nomega = { formula = 'sqrt(k/m)', unit = 'rad/s', verify = 'model.natural_angular_frequency' }\n\
        T = { formula = '2*pi*sqrt(m/k)', unit = 's', verify = 'model.period' }\n\
        [statement]\ntext = 'A block << m >> on a spring << k >>.'\n\
        [[part]]\nkey = 'omega'\nask = 'omega?'\n[[part]]\nkey = 'T'\nask = 'T?'\n";
    let files = [
        ("bank.toml", "format = 1\ntitle = 'T'"),
        ("c/_chapter.toml", "title = 'C'"),
        ("c/a.toml", item),
    ];
    let (catalogue, _) = Catalogue::load(files);
    let marking = marked(
        &catalogue,
        "c/a",
        &[("omega", "7.07 rad/s"), ("T", "0.889 s")],
    );
    assert_eq!(marking.reason(), Reason::FollowThrough, "{marking:?}");
    stays_wrong(
        &catalogue,
        "c/a",
        &[("omega", "7.07 rad/s"), ("T", "0.141 s")],
    );
}

/// The items compute these from the springs and the mass; the model behind both shows how they hang together.
#[test]
fn numbers_follow_from_a_stiffness_or_a_damping_of_ones_own() {
    let item = "ch2/p6-series-springs-damper";
    let own = ("k_eq", "k1 + k2");
    follows(item, &[own, ("omega_n", "sqrt((k1 + k2)/m)")]);
    follows(item, &[own, ("zeta", "b/(2*sqrt((k1 + k2)*m))")]);
    let item = "ch4/e8-transient-plus-steady";
    let own = ("lam", "alpha/m");
    follows(item, &[own, ("omega_d", "sqrt(k/m - alpha^2/m^2)")]);
}

#[test]
fn the_steady_motion_follows_from_what_it_is_made_of() {
    let item = "ch4/e1-forced-steady-state";
    // m = 0.5 kg, k = 50 N/m, Ω = 8 rad/s, F0/m = 6 N/kg; two springs taken for one: 200 - 64 beside 2.4·8 = 19.2.
    let eom = ("eom", "m*x'' + alpha*x' + 2*k*x = F0*cos(Omega*t)");
    follows(item, &[eom, ("x0_value", "43.68 mm")]);
    follows(item, &[eom, ("phi_value", "-0.1403 rad")]);
    follows(
        item,
        &[("x0_value", "0.2 m"), ("x_ss", "0.2*cos(8*t - 0.48996)")],
    );
    follows(
        "ch4/p1-rolling-disk-hub-moment",
        &[("X", "0.45 m"), ("x_ss", "-0.45*sin(4*t - 0.197396)")],
    );
}

#[test]
fn a_datum_in_place_of_a_formula_gives_nothing() {
    for (item, own, value) in [
        ("ch2/e3-amplitude-phase", ("C", "x0"), "C_value"),
        ("ch4/t1-rotating-unbalance", ("X", "ecc"), "X_value"),
    ] {
        let template = BANK.find(item).expect("the item is there");
        let solution = Solution::of(Instance::of_source(template));
        let node = template
            .graph
            .find(&vibank::expr::Name::new(own.1))
            .expect("it has the datum");
        let datum = solution.evaluation().real(node).expect("it has a value");
        stays_wrong(&BANK, item, &[own, (value, &format!("{datum} m"))]);
    }
}

/// The first remark on an answer to an item of the bank that goes on from an earlier one.
fn said(item: &str, earlier: (&str, &str), later: (&str, &str)) -> String {
    let template = BANK.find(item).expect("the item is there");
    let solution = Solution::of(Instance::of_source(template));
    let place = |part: &str| {
        let mut parts = template.parts.iter();
        parts
            .position(|own| own.has_id(part))
            .expect("the part is there")
    };
    let responses = [earlier, later].map(|(part, response)| (place(part), response));
    let grade = Grade::mark(&solution, responses);
    let marking = grade.part(place(later.0)).expect("it was marked");
    remarks(
        &solution,
        place(later.0),
        marking,
        vibank::message::Language::English,
    )[0]
    .plain()
}

#[test]
fn the_feedback_names_the_answer_from_which_it_goes_on() {
    let said = said(
        "ch4/p3-base-excited-relative",
        SERIES,
        ("omega_n", "1.095 rad/s"),
    );
    assert!(
        said.contains("follow-through") && said.contains('k'),
        "{said}"
    );
}

#[test]
fn an_answer_of_another_size_or_dimension_does_not_stand_in() {
    let item = "ch4/p3-base-excited-relative";
    stays_wrong(
        &BANK,
        item,
        &[("k_eq", "1000*k1"), ("omega_n", "38.73 rad/s")],
    );
    stays_wrong(
        &BANK,
        item,
        &[("k_eq", "k1*k2"), ("omega_n", "4.243 rad/s")],
    );
    stays_wrong(&BANK, item, &[("k_eq", "-k1"), ("omega_n", "1.2247 rad/s")]);
    stays_wrong(&BANK, item, &[("k_eq", "four"), ("omega_n", "1.095 rad/s")]);
}

#[test]
fn an_answer_that_makes_the_rest_trivial_does_not_stand_in() {
    let item = "[item]\ntitle = 'A'\nsource = 'by hand'\n[parameters]\na = '2 m'\nb = '3'\n[quantities]\n\
        q = { formula = 'a*b', unit = 'm' }\ny = { formula = 'a*ln(q/a)', unit = 'm' }\nz = { formula = 'sqrt(a*q)', unit = 'm' }\n\
        [statement]\ntext = 'Lengths << a >>, << b >>.'\n\
        [[part]]\nkey = 'q'\nask = 'q?'\n[[part]]\nkey = 'y'\nask = 'y?'\n[[part]]\nkey = 'z'\nask = 'z?'\n[[part]]\nid = 'again'\nkey = 'q'\nask = 'q?'\n";
    let files = [
        ("bank.toml", "format = 1\ntitle = 'T'"),
        ("c/_chapter.toml", "title = 'C'"),
        ("c/a.toml", item),
    ];
    let (catalogue, _) = Catalogue::load(files);
    let fine = marked(&catalogue, "c/a", &[("q", "5 m"), ("z", "3.162 m")]);
    assert_eq!(fine.reason(), Reason::FollowThrough);
    // ln 1 = 0, √(a·a) = a, and the same answer again.
    stays_wrong(&catalogue, "c/a", &[("q", "2 m"), ("y", "0 m")]);
    stays_wrong(&catalogue, "c/a", &[("q", "2 m"), ("z", "2 m")]);
    stays_wrong(&catalogue, "c/a", &[("q", "5 m"), ("again", "5 m")]);
    // A negative length is no length.
    stays_wrong(&catalogue, "c/a", &[("q", "-5 m"), ("z", "3.162 m")]);
}

/// The lower spring of the table with the pulley does not act on the upper block: λ² − 16 λ + 32 = 0.
const UNCOUPLED_SPRING: (&str, &str) = ("K", "[[2k, -k], [-k, k]]");

#[test]
fn frequencies_and_shapes_follow_from_a_matrix_of_ones_own() {
    let item = "ch5/p4-table-block-pulley-hanging-block";
    follows(
        item,
        &[UNCOUPLED_SPRING, ("pulsations", "1.531, 3.696 rad/s")],
    );
    follows(
        item,
        &[UNCOUPLED_SPRING, ("omega1", "sqrt((2 - sqrt(2))*k/(4*m))")],
    );
    follows(
        item,
        &[UNCOUPLED_SPRING, ("omega2", "sqrt((2 + sqrt(2))*k/(4*m))")],
    );
    // Stiffness 22.6 over 16; with unit modal mass.
    follows(item, &[UNCOUPLED_SPRING, ("u1", "(0.3536, 0.5)")]);
    let numbers = ("K", "[[32, -16], [-16, 16]] N/m");
    follows(item, &[numbers, ("pulsations", "1.531, 3.696 rad/s")]);
    let item = "ch5/t4-modal-initial-conditions";
    let stiffness = ("K", "[[100, -50], [-50, 50]]");
    follows(item, &[stiffness, ("pulsations", "3.311; 10.68 rad/s")]);
    // Three coordinates: the double spring taken once.
    let item = "ch5/p3-three-mass-chain-double-spring";
    let stiffness = (
        "K",
        "[[k1 + k2, -k2, 0], [-k2, k2 + k3, -k3], [0, -k3, k3]]",
    );
    follows(
        item,
        &[stiffness, ("pulsations", "3.694, 9.721, 17.61 rad/s")],
    );
    follows(item, &[stiffness, ("u1", "(1, 1.576, 2.118)")]);
}

#[test]
fn all_that_equations_of_several_coordinates_have_follows_from_them() {
    let item = "ch5/p4-table-block-pulley-hanging-block";
    let right = ("eom2", "2 m x2'' = k (x1 - x2)");
    for wrong in [
        "4 m x1'' + 2 k x1 - k x2 = 0",
        "x1'' = -k/(2m) x1 + k/(4m) x2",
        "k x2 - 2 k x1 - 4 m x1'' = 0",
    ] {
        let own = ("eom1", wrong);
        follows(item, &[own, right, UNCOUPLED_SPRING]);
        follows(item, &[own, right, ("pulsations", "1.531, 3.696 rad/s")]);
        follows(
            item,
            &[own, right, ("omega1", "sqrt((2 - sqrt(2))*k/(4*m))")],
        );
        follows(item, &[own, right, ("u1", "(0.3536, 0.5)")]);
        // An equation that was not answered is the right one.
        follows(item, &[own, ("pulsations", "1.531, 3.696 rad/s")]);
    }
    let item = "ch5/e1-elastic-coupling";
    let own = ("eom1", "m1 x1'' + alpha1 x1' + k1 x1 - kc x2 = 0");
    follows(item, &[own, ("Omega1", "sqrt(k1/m1)")]);
    follows(item, &[own, ("pulsations", "8.313, 11.22 rad/s")]);
    let marking = last(item, &[own, ("Omega2", "sqrt((k2 + kc)/m2)")]);
    assert_eq!(marking.reason(), Reason::Matches);
}

#[test]
fn what_is_computed_with_a_shape_follows_from_it_in_any_scale() {
    let item = "ch5/t4-modal-initial-conditions";
    // (1, 2) has the modal mass 1 + 2·4 = 9.
    for shape in ["(1, 2)", "(0.3333, 0.6667)", "(-0.5, -1)"] {
        follows(item, &[("u1", shape), ("B1", "0.0333 m kg^(1/2)")]);
    }
}

#[test]
fn a_system_that_is_easier_than_the_right_one_does_not_stand_in() {
    let item = "ch5/p4-table-block-pulley-hanging-block";
    // Without coupling each frequency is that of one block: √(48/4), √(16/2).
    let apart = ("K", "[[3k, 0], [0, k]]");
    stays_wrong(&BANK, item, &[apart, ("pulsations", "2.828, 3.464 rad/s")]);
    let own = ("eom1", "4 m x1'' + 3 k x1 = 0");
    stays_wrong(&BANK, item, &[own, ("pulsations", "2.828, 3.464 rad/s")]);
    // A stiffness of another size, and one with which the system runs away.
    let stiff = ("K", "[[3000k, -k], [-k, k]]");
    stays_wrong(&BANK, item, &[stiff, ("pulsations", "2.828, 109.5 rad/s")]);
    let unstable = ("K", "[[k, -2k], [-2k, k]]");
    stays_wrong(&BANK, item, &[unstable, ("pulsations", "0, 4.182 rad/s")]);
}

#[test]
fn the_feedback_names_the_matrix_or_the_equation() {
    let said = |earlier| {
        said(
            "ch5/p4-table-block-pulley-hanging-block",
            earlier,
            ("pulsations", "1.531, 3.696 rad/s"),
        )
    };
    let of_matrix = said(UNCOUPLED_SPRING);
    assert!(of_matrix.ends_with("your own K."), "{of_matrix}");
    let of_equation = said(("eom1", "4 m x1'' + 2 k x1 - k x2 = 0"));
    assert!(of_equation.ends_with("your own equation."), "{of_equation}");
}
