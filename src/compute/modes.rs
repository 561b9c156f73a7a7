//! The task `modes`: natural angular frequencies and mode shapes of several degrees of freedom.
//!
//! `masses` and `springs`, a list of `[i, j, k]` where node 0 is the ground, or matrices `M` and `K` give `omega`,
//! ascending, and `shapes`, mass-normalized, in the same order. A mode that grows has `null` for its frequency; then there
//! is also a list `growth` of the rates, `null` for the others. `shapes` = k asks for the k lowest shapes only; up to 256
//! degrees of freedom all are given by default, beyond that none.

use super::{Parameters, RequestError, ResultReply, Task, network};
use crate::numerics::Dd;
use crate::vibration::modes as solver;

pub(crate) struct NaturalModes;

/// Up to this size modes take less than what can be seen, and keep all digits of close ones.
const SMALL: usize = 16;

/// Largest size whose modes are refined to the last digit.
const MAX_REFINED: usize = 64;

impl Task for NaturalModes {
    fn name(&self) -> &'static str {
        "modes"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["masses", "springs", "M", "K", "shapes"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let system = network::system(parameters)?;
        let modes = solver::Modes::of(system).map_err(RequestError::domain)?;
        let count = modes.count();
        let default = if count > solver::MAX_WITHOUT_PROOF {
            0
        } else {
            count
        };
        let shown = parameters.optional_index("shapes")?.unwrap_or(default);
        Ok(described_modes(&modes, shown.min(count)))
    }
}

/// Modes to the last digit, up to a size.
fn described_modes(modes: &solver::Modes, shown: usize) -> ResultReply {
    let count = modes.count();
    if count > SMALL
        && let Some(polished) = modes.polished()
    {
        let frequency = |mode| polished.natural_angular_frequency(mode);
        let growth = |mode| polished.growth_rate(mode);
        return described([count, shown], frequency, growth, |mode| {
            polished.mode_shape(mode).to_vec()
        });
    }
    let refined = (count <= MAX_REFINED).then(|| modes.refined());
    if let Some(refined) = refined.filter(solver::Refined::is_finite) {
        let frequency = |mode| refined.natural_angular_frequency(mode).map(Dd::hi);
        let growth = |mode| refined.growth_rate(mode).map(Dd::hi);
        return described([count, shown], frequency, growth, |mode| {
            refined.mode_shape(mode)
        });
    }
    let frequency = |mode| modes.natural_angular_frequency(mode);
    let growth = |mode| modes.growth_rate(mode);
    described([count, shown], frequency, growth, |mode| {
        modes.mode_shape(mode)
    })
}

/// The frequencies of all modes and the shapes of those that are shown.
fn described(
    [count, shown]: [usize; 2],
    frequency: impl Fn(usize) -> Option<f64>,
    growth: impl Fn(usize) -> Option<f64>,
    shape: impl Fn(usize) -> Vec<f64>,
) -> ResultReply {
    let shapes: Vec<Vec<f64>> = (0..shown).map(shape).collect();
    let growths: Vec<Option<f64>> = (0..count).map(growth).collect();
    let reply = ResultReply::default()
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
    fn a_long_chain_has_its_lowest_shapes() {
        let springs: Vec<_> = (0..600).map(|i| json!([i, i + 1, 1])).collect();
        let request = |shapes: usize| {
            let parameters =
                json!({ "masses": vec![1; 600], "springs": springs, "shapes": shapes });
            reply(&parameters.to_string())
        };
        let two = request(2);
        assert_eq!(two["result"]["shapes"].as_array().unwrap().len(), 2);
        let frequencies = two["result"]["omega"].as_array().unwrap();
        for (i, frequency) in frequencies.iter().enumerate() {
            let expected =
                2.0 * crate::numerics::sin((2 * i + 1) as f64 * std::f64::consts::PI / 2402.0);
            assert!(
                (frequency.as_f64().unwrap() / expected - 1.0).abs() < 1e-15,
                "{i}"
            );
        }
        let ring: Vec<_> = (0..600)
            .map(|i| json!([i + 1, (i + 1) % 600 + 1, 1]))
            .collect();
        let parameters = json!({ "masses": vec![1; 600], "springs": ring });
        assert_eq!(
            reply(&parameters.to_string())["error"]["code"],
            "out_of_domain"
        );
        assert_eq!(
            reply(r#"{"masses":[1],"springs":[],"shapes":-1}"#)["error"]["code"],
            "not_a_number"
        );
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
