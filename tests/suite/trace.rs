//! What each scene computes, and what it skips.

use vibank::bank::Catalogue;
use vibank::grade;
use vibank::instance::Instance;
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::suitability;

use crate::small_bank;

/// What a scene of an item computes, for the data of its source.
fn computed(item: &str, scene: impl FnOnce(&Solution<'_>)) -> Vec<String> {
    let catalogue = small_bank();
    let template = catalogue.find(item).expect("the item is there");
    let solution = Solution::of(Instance::of_source(template));
    scene(&solution);
    let trace = solution.trace();
    let all = trace.computed.len() + trace.skipped.len();
    assert_eq!(
        all,
        Solution::of(Instance::of_source(template))
            .trace()
            .skipped
            .len()
    );
    trace.computed
}

fn place(solution: &Solution<'_>, part: &str) -> usize {
    let parts = &solution.template().parts;
    parts
        .iter()
        .position(|found| found.has_id(part))
        .expect("the part is there")
}

/// Shows statement and questions.
fn question(solution: &Solution<'_>) {
    let template = solution.template();
    let scene = Scene::of(solution, Data::Both);
    scene.passage(&template.statement);
    for part in &template.parts {
        scene.passage(&part.ask);
    }
}

#[test]
fn a_question_computes_nothing() {
    for item in [
        "free/spring-mass",
        "free/damped-block",
        "friction/half-cycles",
    ] {
        assert_eq!(computed(item, question), Vec::<String>::new(), "{item}");
    }
}

#[test]
fn one_part_marked_computes_that_part_alone() {
    let marked = |item: &str, part: &str| {
        computed(item, |solution| {
            drop(grade::mark(solution, place(solution, part), "5"));
        })
    };
    // The first part's mistake is a formula of its own; the second part's replaces what it needs.
    assert_eq!(
        marked("free/spring-mass", "omega_n"),
        ["omega_n", "mistake of omega_n"]
    );
    assert!(!marked("free/spring-mass", "f_n").contains(&"delta".to_owned()));
    assert_eq!(marked("friction/half-cycles", "count"), ["x_f", "count"]);
    let regime = marked("free/damped-block", "regime");
    assert!(regime.contains(&"zeta".to_owned()) && !regime.contains(&"omega_d".to_owned()));
}

#[test]
fn a_missing_or_too_long_response_computes_nothing() {
    for response in ["", "  ", &"1".repeat(5000)] {
        let computed = computed("free/spring-mass", |solution| {
            drop(grade::mark(solution, 0, response));
        });
        assert_eq!(computed, Vec::<String>::new());
    }
}

#[test]
fn a_key_computes_what_it_depends_on() {
    let key = |item: &str, id: &str| computed(item, |solution| drop(solution.entry(id, &[])));
    assert_eq!(key("free/damped-block", "zeta"), ["zeta"]);
    assert_eq!(key("free/damped-block", "omega_d"), ["zeta", "omega_d"]);
    assert_eq!(key("friction/half-cycles", "x_f"), ["x_f"]);
    assert_eq!(
        key("friction/half-cycles", "x_rest"),
        ["x_f", "count", "x_rest"]
    );
    // A function of time is not evaluated where no time is asked for, nor is it a number.
    assert!(!key("free/damped-block", "x").contains(&"zeta".to_owned()));
}

#[test]
fn a_worked_solution_computes_what_it_prints() {
    let worked = |item: &str, part: &str| {
        computed(item, |solution| {
            let part = &solution.template().parts[place(solution, part)];
            Scene::of(solution, Data::Both).passage(&part.solution);
        })
    };
    assert_eq!(worked("free/spring-mass", "omega_n"), ["omega_n"]);
    assert_eq!(worked("free/damped-block", "zeta"), ["zeta"]);
    assert_eq!(worked("friction/half-cycles", "count"), ["x_f"]);
}

#[test]
fn drawing_and_choosing_have_a_cost_of_their_own() {
    let catalogue: Catalogue = small_bank();
    let template = catalogue
        .find("free/damped-block")
        .expect("the item is there");
    let drawn = || Instance::draw(template, Seed::new(5)).expect("the constraint can be met");
    // The constraint needs the damping ratio; the question that is shown then does not.
    let shown = Solution::of(drawn());
    question(&shown);
    assert!(
        shown.trace().computed.is_empty(),
        "{:?}",
        shown.trace().computed
    );
    let chosen = Solution::of(drawn());
    let parts: Vec<usize> = (0..template.parts.len()).collect();
    let _ = suitability::judge(&chosen, &parts);
    assert!(chosen.trace().computed.contains(&"omega_d".to_owned()));
    assert!(shown.trace().computed.is_empty());
}
