//! The bank's own known results: each is a response that has to be right.

use crate::BANK;
use vibank::expr::Name;
use vibank::instance::Instance;
use vibank::solution::Solution;

const SYMBOLIC: [&str; 5] = ["formula", "matrix", "interval", "equation", "mode-shape"];

#[test]
fn known_results_are_right() {
    let catalogue = &*BANK;
    let (mut wrong, mut count) = (Vec::new(), 0);
    for template in catalogue.items() {
        for check in &template.checks {
            let set: Vec<(String, String)> = check
                .given
                .iter()
                .map(|(place, quantity)| {
                    (
                        template.parameters[*place].name.to_string(),
                        quantity.to_string(),
                    )
                })
                .collect();
            let set: Vec<(&str, &str)> =
                set.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
            let Ok(instance) = Instance::of(template, None, &set) else {
                continue;
            };
            let solution = Solution::of(instance);
            for expected in &check.expect {
                let Some(place) = template
                    .parts
                    .iter()
                    .position(|part| part.has_id(&expected.id.value))
                else {
                    continue;
                };
                let kind = template.parts[place].answer.kind().name();
                // What names a quantity is compared as a number.
                let is_formula = matches!(kind, "formula")
                    && template
                        .graph
                        .find(&Name::new(expected.id.value.as_str()))
                        .is_some();
                // So is a shape, whatever scale the part asks for.
                let is_scaled = kind == "mode-shape"
                    && template.source.text.contains("normalization = \"first\"");
                if !SYMBOLIC.contains(&kind) || is_formula || is_scaled {
                    continue;
                }
                count += 1;
                let marking = match solution.marker(place) {
                    Ok(_) => vibank::grade::mark(&solution, place, &expected.response.value),
                    Err(absent) => {
                        wrong.push(format!("{} {}: {absent}", template.id, expected.id.value));
                        continue;
                    }
                };
                if marking.verdict.name() != "right" {
                    let read = marking.reading.map(|reading| reading.text);
                    wrong.push(format!(
                        "{} {} `{}`: {} {read:?} {:?}",
                        template.id,
                        expected.id.value,
                        expected.response.value,
                        marking.verdict.name(),
                        marking.remarks
                    ));
                }
            }
        }
        // The key of a formula, as it is printed, is right as well.
        let solution = Solution::of(Instance::of_source(template));
        for (place, part) in template.parts.iter().enumerate() {
            let kind = part.answer.kind().name();
            let Some(marker) = solution
                .marker(place)
                .ok()
                .filter(|_| ["formula", "equation", "function"].contains(&kind))
            else {
                continue;
            };
            let key = marker.key();
            let vibank::answer::KeyValue::Formula { text, latex } = key.value else {
                continue;
            };
            for printed in [text, latex, key.math.plain()] {
                // Cases, units of constants and a raised star are for the eye alone.
                if printed.contains("if ")
                    || printed.contains("cases")
                    || printed.contains("kg")
                    || printed.contains("Q*")
                    || printed.contains("∗")
                {
                    continue;
                }
                count += 1;
                let marking = vibank::grade::mark(&solution, place, &printed);
                if marking.verdict.name() != "right" {
                    let read = marking.reading.map(|reading| reading.text);
                    wrong.push(format!(
                        "{} {} key `{printed}`: {} {read:?} {:?}",
                        template.id,
                        part.id,
                        marking.verdict.name(),
                        marking.remarks
                    ));
                }
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {count}:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}
