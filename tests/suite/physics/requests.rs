//! Requests from outside: whatever the line, there is one reply, and it is JSON.

use proptest::prelude::*;
use serde_json::{Value, json};
use vibank::compute::{answer, tasks};

fn reply(line: &str) -> Value {
    let reply = answer(line);
    assert!(!reply.contains('\n'));
    serde_json::from_str(&reply).unwrap()
}

/// Any JSON of a few levels, with the words of requests more often than others.
fn values() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        (-5..5_i32).prop_map(Value::from),
        prop_oneof![
            "[a-z0-9.+-]{0,8}",
            "-?[0-9]{1,4}(\\.[0-9]{1,4})?(e-?[0-9]{1,3})?"
        ]
        .prop_map(Value::from),
    ];
    leaf.prop_recursive(3, 24, 4, |inner| {
        prop::collection::vec(inner, 0..4).prop_map(Value::from)
    })
}

const KEYS: &[&str] = &[
    "m", "c", "k", "x0", "v0", "t", "F0", "Omega", "x1", "xn1", "n", "Td", "mu", "mu_s", "g", "F",
    "masses", "springs", "dampers", "rayleigh", "M", "K", "L", "theta0", "omega0",
];

proptest! {
    #[test]
    fn any_text_has_a_reply(line in ".{0,80}") {
        prop_assert!(reply(&line)["error"]["code"].is_string());
    }

    #[test]
    fn any_parameters_have_a_reply(task in 0..16_usize, values in prop::collection::vec((0..KEYS.len(), values()), 0..9)) {
        let names: Vec<&str> = tasks().collect();
        let parameters: serde_json::Map<String, Value> =
            values.into_iter().map(|(key, value)| (KEYS[key].to_owned(), value)).collect();
        let request = json!({ "id": [1, "a"], "task": names[task % names.len()], "params": parameters });
        let reply = reply(&request.to_string());
        prop_assert_eq!(&reply["id"], &json!([1, "a"]));
        prop_assert!(reply["result"].is_object() != reply["error"]["message"].is_string());
    }

    #[test]
    fn any_numbers_have_a_reply(numbers in prop::collection::vec(any::<f64>(), 9), task in 0..3_usize) {
        let (task, keys): (&str, &[&str]) = [
            ("free_response", ["m", "c", "k", "x0", "v0", "t"].as_slice()),
            ("forced_response", &["m", "c", "k", "F0", "Omega", "x0", "v0", "t"]),
            ("steady_amplitude_phase", &["m", "c", "k", "F0", "Omega"]),
        ][task];
        let parameters: serde_json::Map<String, Value> =
            keys.iter().zip(numbers).map(|(key, number)| ((*key).to_owned(), json!(number.abs()))).collect();
        let reply = reply(&json!({ "id": 1, "task": task, "params": parameters }).to_string());
        for (name, value) in reply["result"].as_object().into_iter().flatten() {
            prop_assert!(value.as_f64().is_none_or(f64::is_finite), "{name}");
        }
    }
}

#[test]
fn decimals_in_strings_are_numbers() {
    let as_numbers = r#"{"id":7,"task":"free_response","params":{"m":1.5,"c":0.1,"k":3,"x0":0.1,"v0":-2e-3,"t":[1,2]}}"#;
    let as_strings = r#"{"id":7,"task":"free_response","params":{"m":"1.5","c":"0.1","k":"3","x0":"0.1","v0":"-2e-3","t":["1","2"]}}"#;
    assert_eq!(answer(as_numbers), answer(as_strings));
}

#[test]
fn results_read_back_to_the_same_numbers() {
    let line = r#"{"id":"x","task":"log_decrement","params":{"x1":0.3,"xn1":0.1,"n":2,"Td":0.7}}"#;
    let result = &reply(line)["result"];
    let delta = vibank::vibration::LogarithmicDecrement::of(0.3, 0.1, 2).unwrap();
    assert_eq!(result["delta"].as_f64(), Some(delta.value()));
    assert_eq!(result["c"], Value::Null);
}
