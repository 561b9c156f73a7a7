//! Each kind tested by itself: made-up responses to every part of the bank come to what they have to.

use crate::BANK;
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;

/// Seeds for which the responses are made up; the first is the data of the source.
const SEEDS: u64 = 20;

#[test]
fn made_up_responses_come_to_what_they_have_to() {
    let catalogue = &*BANK;
    let (mut faults, mut count) = (Vec::new(), 0);
    for template in catalogue.items() {
        for seed in 0..SEEDS {
            let instance = match seed {
                0 => Ok(Instance::of_source(template)),
                seed => Instance::draw(template, Seed::new(seed)),
            };
            let Ok(instance) = instance else {
                continue;
            };
            let solution = Solution::of(instance);
            for (place, part) in template.parts.iter().enumerate() {
                // A formula does not change with the data: two draws of it will do.
                let is_symbolic = ["formula", "equation"].contains(&part.answer.kind().name());
                if is_symbolic && seed > 1 || !solution.asks(place) {
                    continue;
                }
                let Ok(marker) = solution.marker(place) else {
                    continue;
                };
                for trial in marker.trials() {
                    count += 1;
                    let marking = vibank::grade::mark(&solution, place, &trial.response);
                    if !trial.admits(&marking) {
                        faults.push(format!(
                            "{} {} seed {seed}, {:?} `{}`: {} {:?} {:?}",
                            template.id,
                            part.id,
                            trial.nature,
                            trial.response,
                            marking.verdict.name(),
                            marking.reading.map(|reading| reading.text),
                            marking.remarks
                        ));
                    }
                }
            }
        }
    }
    assert!(count > 10_000, "{count} responses");
    assert!(
        faults.is_empty(),
        "{} of {count}:\n{}",
        faults.len(),
        faults[..faults.len().min(60)].join("\n")
    );
}
