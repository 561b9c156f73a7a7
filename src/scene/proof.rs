//! Plots of an item that cannot be drawn.

use super::{Data, Scene, Undrawn};
use crate::bank::Template;
use crate::diagnostic::{Code, Diagnose, Finding, Label};
use crate::instance::Instance;
use crate::solution::Solution;

#[derive(Debug, thiserror::Error)]
#[error("the plot `{name}` cannot be drawn for the data of the source: {reason}")]
struct Missing {
    name: String,
    reason: Undrawn,
}

/// The plots that take too long for the data of the source; `check` reports them.
pub fn undrawn(template: &Template) -> Vec<Finding> {
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    let missing = template.plots.iter().filter_map(|plot| {
        let reason = scene.plot(&plot.name).err()?;
        let name = plot.name.clone();
        matches!(reason, Undrawn::Work).then_some(Missing { name, reason })
    });
    missing
        .map(|missing| Finding::of(&missing, &template.source))
        .collect()
}

impl Diagnose for Missing {
    fn code(&self) -> Code {
        Code::SIZE
    }

    fn labels(&self) -> Vec<Label> {
        Vec::new()
    }

    fn help(&self) -> Option<String> {
        Some("draw a closed form in place of integrals and roots, or fewer curves".to_owned())
    }
}
