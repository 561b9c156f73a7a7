//! `--trace`: what showing the first sheet computes.

use vibank::scene::Scene;
use vibank::worksheet::{Plan, Sheet};

use super::make::refuse;
use crate::cli::Failure;

/// Tells what showing the questions of the first variant computes.
pub(crate) fn first_sheet(plan: &Plan<'_>) -> Result<(), Failure> {
    let sheet = Sheet::draw(plan, plan.variant(0, 0), None).map_err(|error| refuse(&error))?;
    for question in &sheet.questions {
        let template = question.solution.template();
        let scene = Scene::of(&question.solution, plan.blueprint.data);
        scene.passage(&template.statement);
        for place in &question.parts {
            let part = &template.parts[*place];
            part.group.iter().for_each(|group| {
                scene.passage(&group.text);
            });
            scene.passage(&part.ask);
        }
        let trace = question.solution.trace();
        eprintln!(
            "question {} of {}: computed {}; skipped {}",
            question.number,
            template.id,
            list(&trace.computed),
            list(&trace.skipped)
        );
    }
    Ok(())
}

fn list(names: &[String]) -> String {
    if names.is_empty() {
        "nothing".to_owned()
    } else {
        names.join(", ")
    }
}
