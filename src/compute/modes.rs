//! The task `modes`: natural angular frequencies and mode shapes of several degrees of freedom.
//!
//! `masses` and `springs`, a list of `[i, j, k]` where node 0 is the ground, or matrices `M` and `K` give `omega`,
//! ascending, and `shapes`, mass-normalized, in the same order. A mode that grows has `null` for its frequency; then there
//! is also a list `growth` of the rates, `null` for the others.

use super::{Parameters, Reply, RequestError, Task, network};
use crate::numerics::Dd;
use crate::vibration::modes as solver;

pub(super) struct Modes;

/// Up to this size modes take less than what can be seen, and keep all digits of close ones.
const SMALL: usize = 16;

/// Largest size whose modes are refined to the last digit.
const MAX_REFINED: usize = 64;

impl Task for Modes {
    fn name(&self) -> &'static str {
        "modes"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["masses", "springs", "M", "K"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<Reply, RequestError> {
        let system = network::system(parameters)?;
        let modes = solver::Modes::of(system).map_err(RequestError::domain)?;
        Ok(described_modes(&modes))
    }
}

/// Modes to the last digit, up to a size.
fn described_modes(modes: &solver::Modes) -> Reply {
    let count = modes.count();
    if count > SMALL
        && let Some(polished) = modes.polished()
    {
        let frequency = |mode| polished.natural_angular_frequency(mode);
        let growth = |mode| polished.growth_rate(mode);
        return described(count, frequency, growth, |mode| {
            polished.mode_shape(mode).to_vec()
        });
    }
    let refined = (count <= MAX_REFINED).then(|| modes.refined());
    if let Some(refined) = refined.filter(solver::Refined::is_finite) {
        let frequency = |mode| refined.natural_angular_frequency(mode).map(Dd::hi);
        let growth = |mode| refined.growth_rate(mode).map(Dd::hi);
        return described(count, frequency, growth, |mode| refined.mode_shape(mode));
    }
    let frequency = |mode| modes.natural_angular_frequency(mode);
    let growth = |mode| modes.growth_rate(mode);
    described(count, frequency, growth, |mode| modes.mode_shape(mode))
}

fn described(
    count: usize,
    frequency: impl Fn(usize) -> Option<f64>,
    growth: impl Fn(usize) -> Option<f64>,
    shape: impl Fn(usize) -> Vec<f64>,
) -> Reply {
    let shapes: Vec<Vec<f64>> = (0..count).map(shape).collect();
    let growths: Vec<Option<f64>> = (0..count).map(growth).collect();
    let reply = Reply::default()
        .optional_list("omega", (0..count).map(frequency))
        .vectors("shapes", shapes.iter().map(Vec::as_slice));
    if growths.iter().any(Option::is_some) {
        reply.optional_list("growth", growths)
    } else {
        reply
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn reply(parameters: &str) -> Value {
        let line = format!(r#"{{"id":1,"task":"modes","params":{parameters}}}"#);
        serde_json::from_str(&crate::compute::answer(&line)).unwrap()
    }

    #[test]
    fn networks_and_matrices_give_the_same_modes() {
        let network = reply(r#"{"masses":[1,"1"],"springs":[[0,1,100],[1,2,"62.5"],[0,2,100]]}"#);
        assert_eq!(network["result"]["omega"], json!([10.0, 15.0]));
        let matrices = reply(r#"{"M":[[1,0],[0,1]],"K":[[162.5,-62.5],[-62.5,162.5]]}"#);
        assert_eq!(network, matrices);
    }

    #[test]
    fn rigid_and_growing_modes_are_told_apart() {
        let reply = reply(r#"{"masses":[1,1,1],"springs":[[0,1,-4],[2,3,2]]}"#);
        assert_eq!(reply["result"]["omega"], json!([null, 0.0, 2.0]));
        assert_eq!(reply["result"]["growth"], json!([2.0, null, null]));
    }

    #[test]
    fn what_is_no_system_is_refused() {
        for (parameters, code) in [
            (r#"{"masses":[1]}"#, "missing_parameter"),
            (
                r#"{"masses":[1,0],"springs":[[0,1,1],[1,2,1]]}"#,
                "out_of_domain",
            ),
            (r#"{"masses":[1],"springs":[[0,2,1]]}"#, "out_of_domain"),
            (r#"{"masses":[1],"springs":[[0,1]]}"#, "not_a_number"),
            (r#"{"masses":[1],"springs":[[0,-1,1]]}"#, "not_a_number"),
            (r#"{"M":[[1,2],[2,1]],"K":[[1,0],[0,1]]}"#, "out_of_domain"),
            (r#"{"M":[[1,2]],"K":[[1,0],[0,1]]}"#, "not_a_number"),
            (r#"{"M":[[1]],"K":[[1]],"masses":[1]}"#, "out_of_domain"),
        ] {
            assert_eq!(reply(parameters)["error"]["code"], code, "{parameters}");
        }
    }
}
