//! What an answer line says is what is marked there.

use crate::BANK;
use vibank::answer::{Asked, Verdict};
use vibank::grade;
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::solution::Solution;

fn said(item: &str, part: &str) -> String {
    let catalogue = &*BANK;
    let template = catalogue.find(item).expect("the item");
    let blank = template.part(part).expect("the part").answer.blank();
    let said = Language::English.blank(&blank).plain(&Vec::new());
    said.trim_end().to_owned()
}

#[test]
fn each_form_is_said() {
    for (item, part, line) in [
        (
            "ch2/p3-parallel-springs-damper",
            "k_eq",
            "(formula in m, c, k₁, k₂, x₀, v₀)",
        ),
        (
            "ch2/p3-parallel-springs-damper",
            "omega_n",
            "(formula in m, c, k₁, k₂, x₀, v₀, k_eq)",
        ),
        (
            "ch2/p3-parallel-springs-damper",
            "omega_n_value",
            "(value, 3 figures)",
        ),
        (
            "ch2/p3-parallel-springs-damper",
            "eom",
            "(equation in x, ẋ, ẍ, m, c, k₁, k₂, x₀, v₀, k_eq)",
        ),
        // Of zero there are no three figures.
        (
            "ch2/e2-horizontal-elastic-pendulum",
            "x_st",
            "(exact value)",
        ),
        (
            "ch1/e9-pendulum-equilibrium-stability",
            "theta_eq",
            "(exact values, in any order)",
        ),
    ] {
        assert_eq!(said(item, part), line, "{item} {part}");
    }
}

#[test]
fn each_letter_that_is_offered_can_be_typed() {
    let catalogue = &*BANK;
    let (mut refused, mut count) = (Vec::new(), 0);
    for template in catalogue.items() {
        let solution = Solution::of(Instance::of_source(template));
        let parts = template.parts.iter().enumerate();
        for (place, part) in parts.filter(|(place, _)| solution.asks(*place)) {
            let blank = part.answer.blank();
            for letter in &blank.letters {
                let response = match blank.form {
                    Asked::Formula | Asked::Function { .. } => letter.typed.clone(),
                    Asked::Equation { are_several: false } => format!("{} = 0", letter.typed),
                    _ => continue,
                };
                count += 1;
                let marking = grade::mark(&solution, place, &response);
                // A letter alone is no answer, but it is one that is understood.
                let is_read = marking.reading.is_some();
                let why = format!("{:?}", marking.remarks);
                if !is_read
                    && ["Unknown", "NotAllowed", "Sign"]
                        .iter()
                        .any(|word| why.contains(word))
                {
                    refused.push(format!("{} {} {response}: {why}", template.id, part.id));
                }
            }
        }
    }
    assert!(count > 1000, "{count}");
    assert!(
        refused.is_empty(),
        "{}\n{}",
        refused.len(),
        refused.join("\n")
    );
}

#[test]
fn a_letter_that_is_barred_is_handed_back() {
    let catalogue = &*BANK;
    let template = catalogue
        .find("ch3/e4-underdamped-response")
        .expect("the item");
    let solution = Solution::of(Instance::of_source(template));
    let place = template.parts.iter().position(|part| part.has_id("x"));
    let place = place.expect("the part");
    let line = Language::English.blank(&template.parts[place].answer.blank());
    let line = line.plain(&Vec::new());
    let (_, letters) = line.split_once(" in ").expect("it has letters");
    let letters = letters.split(", or with").next().unwrap_or_default();
    assert!(!letters.split(", ").any(|letter| letter == "C"), "{line}");
    let marking = grade::mark(&solution, place, "C exp(-lambda t) cos(omega_p t + phi)");
    assert_eq!(marking.verdict, Verdict::Unreadable, "{marking:?}");
}
