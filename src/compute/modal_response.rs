//! The task `modal_response`: free motion of several degrees of freedom.
//!
//! `masses` and `springs`, or `M` and `K`, with `dampers`, a list of `[i, j, c]`, a matrix `C`, and `rayleigh`, the pair
//! `[alpha, beta]` of `C = alpha M + beta K + dampers`, all three optional, and the vectors `x0` and `v0` give the vectors
//! `x` and `v` at the time `t`, or a list of vectors for a list of times.

use super::parameters::Times;
use super::{Parameters, RequestError, ResultReply, Task, network};
use crate::vibration::modal::{Damping, ModalResponse as Motion};
use crate::vibration::modes::{MAX_WITHOUT_PROOF, Modes, ModesError};

pub(crate) struct ModalResponse;

/// Most numbers that a reply may hold.
// At `MAX_NUMBER_LENGTH` bytes each a reply stays within 52 MB.
const MAX_NUMBERS: usize = 2_000_000;

/// Most products of components that all samples together may take.
const MAX_PRODUCTS: usize = 200_000_000;

impl Task for ModalResponse {
    fn name(&self) -> &'static str {
        "modal_response"
    }

    fn keys(&self) -> &'static [&'static str] {
        &[
            "masses", "springs", "M", "K", "C", "dampers", "rayleigh", "x0", "v0", "t",
        ]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let system = network::system(parameters)?;
        let count = system.degrees_of_freedom();
        if count > MAX_WITHOUT_PROOF {
            let limit = MAX_WITHOUT_PROOF;
            return Err(RequestError::domain(ModesError::TooMany { count, limit }));
        }
        let modes = Modes::of(system).map_err(RequestError::domain)?;
        let damping = damping(parameters)?;
        let (displacements, velocities) = (parameters.list("x0")?, parameters.list("v0")?);
        let times = parameters.times("t")?;
        check_work(modes.count(), times.as_slice().len())?;
        let horizon = times.as_slice().iter().copied().fold(0.0, f64::max);
        let motion = Motion::of(&modes, &damping, &displacements, &velocities, horizon)
            .map_err(RequestError::domain)?;
        let size = modes.count();
        let (mut x, mut v) = (Vec::new(), Vec::new());
        for &time in times.as_slice() {
            let start = x.len();
            x.resize(start + size, 0.0);
            v.resize(start + size, 0.0);
            motion
                .state(time, &mut x[start..], &mut v[start..])
                .map_err(RequestError::domain)?;
            for (name, vector) in [("x", &x), ("v", &v)] {
                if vector[start..]
                    .iter()
                    .any(|component| !component.is_finite())
                {
                    return Err(RequestError::NotFinite { name });
                }
            }
        }
        Ok(match times {
            Times::One(_) => ResultReply::default().list("x", x).list("v", v),
            Times::Many(_) => ResultReply::default()
                .vectors("x", x.chunks_exact(size))
                .vectors("v", v.chunks_exact(size)),
        })
    }
}

fn damping(parameters: &Parameters) -> Result<Damping, RequestError> {
    const EXPECTED: &str = "a list of two finite numbers, [alpha, beta]";
    let mut damping = Damping::of_dampers(&network::optional_links(parameters, "dampers")?);
    if parameters.has("rayleigh") {
        let [mass_factor, stiffness_factor] = parameters.list("rayleigh")?[..] else {
            return Err(RequestError::NotANumber {
                name: "rayleigh",
                expected: EXPECTED,
            });
        };
        damping = damping.with_rayleigh(mass_factor, stiffness_factor);
    }
    if parameters.has("C") {
        damping = damping.with_matrix(&network::matrix(parameters, "C")?);
    }
    Ok(damping)
}

fn check_work(size: usize, samples: usize) -> Result<(), RequestError> {
    let most = (MAX_NUMBERS / size).min(MAX_PRODUCTS / (size * size));
    if samples > most {
        return Err(RequestError::TooMany {
            name: "t",
            count: samples,
            most,
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn reply(parameters: &str) -> Value {
        let line = format!(r#"{{"id":1,"task":"modal_response","params":{parameters}}}"#);
        serde_json::from_str(&crate::compute::answer(&line)).unwrap()
    }

    #[test]
    fn one_time_gives_a_vector_and_a_list_gives_vectors() {
        let one = reply(r#"{"masses":[1,1],"springs":[],"x0":[1,2],"v0":[0.5,0],"t":4}"#);
        assert_eq!(one["result"], json!({ "x": [3.0, 2.0], "v": [0.5, 0.0] }));
        let many = reply(r#"{"masses":[1,1],"springs":[],"x0":[1,2],"v0":[0.5,0],"t":[0,4]}"#);
        assert_eq!(many["result"]["x"], json!([[1.0, 2.0], [3.0, 2.0]]));
    }

    #[test]
    fn ways_to_give_the_same_damping_agree() {
        let system = r#""masses":[2,1],"springs":[[0,1,3],[1,2,1]],"x0":[0.5,0],"v0":[0,1],"t":3"#;
        let dampers = reply(&format!(
            r#"{{{system},"dampers":[[0,1,0.3],[1,2,"0.1"]]}}"#
        ));
        let rayleigh = reply(&format!(r#"{{{system},"rayleigh":[0,0.1]}}"#));
        for i in 0..2 {
            let x = |reply: &Value| reply["result"]["x"][i].as_f64().unwrap();
            assert!((x(&dampers) - x(&rayleigh)).abs() < 1e-15);
        }
        let matrices = r#""M":[[2,0],[0,1]],"K":[[4,-1],[-1,1]],"x0":[0.5,0],"v0":[0,1],"t":3"#;
        let matrix = reply(&format!(r#"{{{matrices},"C":[[0.4,-0.1],[-0.1,0.1]]}}"#));
        for i in 0..2 {
            let x = |reply: &Value| reply["result"]["x"][i].as_f64().unwrap();
            assert!((x(&matrix) - x(&rayleigh)).abs() < 1e-15);
        }
    }

    #[test]
    fn what_has_no_motion_is_refused() {
        let system = r#""masses":[1],"springs":[[0,1,1]]"#;
        for (rest, code) in [
            (r#""x0":[1],"v0":[0],"t":-1"#, "out_of_domain"),
            (r#""x0":[1,2],"v0":[0],"t":1"#, "out_of_domain"),
            (r#""x0":[1],"v0":[0]"#, "missing_parameter"),
            (r#""x0":[1],"v0":[0],"t":1,"rayleigh":[1]"#, "not_a_number"),
            (
                r#""x0":[1],"v0":[0],"t":1,"dampers":[[1,2,1]]"#,
                "out_of_domain",
            ),
        ] {
            assert_eq!(
                reply(&format!("{{{system},{rest}}}"))["error"]["code"],
                code,
                "{rest}"
            );
        }
        let growing = reply(r#"{"masses":[1],"springs":[[0,1,-1]],"x0":[1],"v0":[0],"t":1e6}"#);
        assert_eq!(growing["error"]["code"], "not_finite");
    }
}
