//! The contracts for other programs: `solve`, `mark` and `compute`, one line in, one line out.

use serde_json::{Value as Json, json};

use super::{BANK, fed, small};

/// Answers of a command to requests, one each.
fn answers(command: &str, requests: &[Json]) -> Vec<Json> {
    let input: String = requests
        .iter()
        .map(|request| format!("{request}\n"))
        .collect();
    let bank: &[&str] = if command == "compute" {
        &[]
    } else {
        &["--bank", BANK]
    };
    let ran = fed(&[&[command, "--jsonl"], bank].concat(), input.into_bytes()).ends(0);
    let lines = ran.lines();
    assert_eq!(lines.len(), requests.len(), "one line each");
    lines
}

#[test]
fn an_item_is_solved_for_given_data() {
    let arguments = [
        "solve",
        "free/spring-mass",
        "--set",
        "m=8 kg",
        "--want",
        "omega_n",
        "--json",
    ];
    let line = &small(&arguments).ends(0).lines()[0];
    assert_eq!(line["id"], "free/spring-mass");
    assert_eq!(
        line["parameters"]["m"],
        json!({"value": 8.0, "unit": "kg", "si": 8.0})
    );
    assert_eq!(
        line["answers"],
        json!({"omega_n": {"kind": "numeric", "unit": "rad/s", "si": 10.0}})
    );
    small(&["solve", "free/spring-mass"])
        .ends(0)
        .says("omega_n")
        .says("20.0 rad/s");
}

#[test]
fn requests_are_answered_in_order_and_errors_stand_on_their_line() {
    let replies = answers(
        "solve",
        &[
            json!({"id": "free/spring-mass", "set": {"m": 8, "k": "800"}, "tag": [1, {"a": 2}]}),
            json!({"id": "free/nothing", "tag": 2}),
            json!({"id": "free/spring-mass", "set": {"q": "1"}}),
            json!({"id": "free/spring-mass", "want": ["nothing"]}),
            json!({"id": "free/spring-mass", "set": {"m": "2 m"}}),
            json!({"id": "free/spring-mass", "set": {"m": "-2 kg"}}),
            json!({"id": "free/spring-mass", "set": {"m": "0 kg"}}),
            json!({"id": "free/spring-mass", "colour": 1}),
            json!({"id": "free/damped-block", "at": [0, "0.5", 1e-3], "want": ["x", "regime"]}),
            json!(5),
        ],
    );
    assert_eq!(replies[0]["tag"], json!([1, {"a": 2}]));
    assert_eq!(replies[0]["answers"]["omega_n"]["si"], 10.0);
    let ids: Vec<&String> = replies[0]["answers"]
        .as_object()
        .expect("an object")
        .keys()
        .collect();
    assert_eq!(ids, ["omega_n", "f_n", "delta"]);
    let code = |at: usize| replies[at]["error"]["code"].as_str().unwrap_or_default();
    assert_eq!((code(1), &replies[1]["tag"]), ("unknown-item", &json!(2)));
    assert_eq!(code(2), "unknown-parameter");
    assert_eq!(code(3), "unknown-answer");
    assert_eq!(code(4), "unit");
    assert_eq!(code(5), "domain");
    assert_eq!(code(6), "domain");
    assert_eq!((code(7), code(9)), ("json", "json"));
    assert_eq!(replies[7]["id"], "free/spring-mass");
    let x = &replies[8]["answers"]["x"];
    assert_eq!(
        (&x["kind"], &x["at"]),
        (&json!("quantity"), &json!([0.0, 0.5, 0.001]))
    );
    assert_eq!(x["si"][0], 0.01);
    assert_eq!(
        replies[8]["answers"]["regime"],
        json!({"kind": "choice", "value": "under"})
    );
    assert_eq!(
        replies[8]["answers"].as_object().map(serde_json::Map::len),
        Some(2)
    );
}

#[test]
fn a_seed_draws_what_is_not_set_and_always_the_same() {
    let request =
        |seed: u64, set: Json| json!({"id": "free/spring-mass", "seed": seed, "set": set});
    let replies = answers(
        "solve",
        &[
            request(1, json!({})),
            request(1, json!({})),
            request(2, json!({})),
            request(1, json!({"m": "3 kg"})),
        ],
    );
    assert_eq!(replies[0], replies[1]);
    assert_ne!(replies[0]["parameters"], replies[2]["parameters"]);
    assert_eq!(
        replies[0]["parameters"]["k"], replies[3]["parameters"]["k"],
        "one stream each"
    );
}

#[test]
fn responses_are_marked_with_verdict_reading_and_reason() {
    let mark = |part: &str, response: &str| json!({"id": "free/spring-mass", "part": part, "response": response});
    let replies = answers(
        "mark",
        &[
            mark("omega_n", "20 rad/s"),
            mark("omega_n", "3.183 Hz"),
            mark("omega_n", "20 Hz"),
            mark("omega_n", "191 rpm"),
            mark("omega_n", "20"),
            mark("omega_n", "20,0 1/s"),
            mark("omega_n", "0.05 s"),
            mark("omega_n", "-20 rad/s"),
            mark("omega_n", "20 kg"),
            mark("omega_n", "quite fast"),
            mark("omega_n", "   "),
            mark("nothing", "1"),
            json!({"id": "free/damped-block", "part": "regime", "response": "under", "tag": "x"}),
            json!({"id": "friction/half-cycles", "part": "count", "response": "4"}),
            json!({"id": "friction/half-cycles", "part": "count", "response": "4.5"}),
        ],
    );
    let verdicts: Vec<&str> = replies
        .iter()
        .map(|reply| reply["verdict"].as_str().unwrap_or("error"))
        .collect();
    let expected = [
        "right",
        "right",
        "wrong",
        "right",
        "right",
        "right",
        "wrong",
        "wrong",
        "wrong",
        "unreadable",
        "missing",
        "error",
        "right",
        "right",
    ];
    for (at, expected) in expected.iter().enumerate() {
        assert_eq!(verdicts[at], *expected, "{}", replies[at]);
    }
    assert_ne!(verdicts[14], "right", "{}", replies[14]);
    // A bare number is taken in the unit of the key, and that is said.
    assert_eq!(replies[4]["feedback"][0], "Taken in rad/s.");
    assert_eq!(replies[0]["si"], json!([20.0]));
    assert_eq!(replies[0]["credit"], 1.0);
    assert_eq!(replies[2]["reasons"][0], "two-pi");
    assert_eq!(replies[6]["reasons"][0], "mistake-1");
    assert_eq!(replies[7]["reasons"][0], "sign");
    assert_eq!(replies[8]["reasons"][0], "dimension");
    assert_eq!(replies[12]["tag"], "x");
    for reply in replies
        .iter()
        .filter(|reply| reply.get("verdict").is_some())
    {
        assert!(
            !reply["feedback"][0].as_str().unwrap_or_default().is_empty(),
            "{reply}"
        );
    }
}

#[test]
fn one_response_is_marked_on_the_command_line() {
    small(&["mark", "free/spring-mass", "omega_n", "20 rad/s"])
        .ends(0)
        .says("right, credit 1");
    small(&["mark", "free/spring-mass", "omega_n", "21 rad/s"])
        .ends(1)
        .says("wrong");
    small(&["mark", "free/spring-mass", "omega_n", "-20 rad/s"])
        .ends(1)
        .says("wrong");
    small(&[
        "mark",
        "free/spring-mass",
        "omega_n",
        "10 rad/s",
        "--set",
        "m=8 kg",
        "--json",
    ])
    .ends(0)
    .says("\"verdict\":\"right\"");
    small(&["mark", "free/spring-mass", "omega_n"]).ends(2);
}

#[test]
fn bare_tasks_are_computed() {
    let params = json!({"m": 1.0, "c": 0.0, "k": 4.0, "x0": 1.0, "v0": 0.0, "t": 0.0});
    let replies = answers(
        "compute",
        &[
            json!({"id": 1, "task": "free_response", "params": params}),
            json!({"id": 2, "task": "no_such_task", "params": {}}),
        ],
    );
    assert_eq!(replies[0]["id"], 1);
    assert!(replies[0].get("error").is_none(), "{}", replies[0]);
    assert_eq!(replies[1]["id"], 2);
    assert!(replies[1].get("error").is_some(), "{}", replies[1]);
}

#[test]
fn empty_lines_are_skipped_and_line_ends_of_any_kind_read() {
    let input = "\u{feff}{\"id\":\"free/spring-mass\",\"want\":[\"f_n\"]}\r\n\r\n\n{\"id\":\"free/spring-mass\",\"want\":[\"f_n\"]}";
    let ran = fed(&["solve", "--jsonl", "--bank", BANK], input.into()).ends(0);
    let lines = ran.lines();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0], lines[1]);
    fed(&["solve", "--jsonl", "--bank", BANK], Vec::new()).ends(0);
}

#[test]
fn earlier_responses_go_on_in_a_later_part() {
    let request = |earlier: serde_json::Value| json!({"id": "free/spring-mass", "part": "f_n", "response": "4.775 Hz", "earlier": earlier});
    let replies = answers(
        "mark",
        &[
            request(json!({"omega_n": "30 rad/s"})),
            request(json!({})),
            request(json!({"omega_n": 30})),
            request(json!({"omega": "30 rad/s"})),
        ],
    );
    assert_eq!(replies[0]["verdict"], "right", "{}", replies[0]);
    assert_eq!(replies[0]["reasons"][0], "follow-through");
    let said = replies[0]["feedback"][0].as_str().unwrap_or_default();
    assert!(
        said.contains("follow-through") && said.contains('ω'),
        "{said}"
    );
    assert_eq!(replies[1]["verdict"], "wrong", "{}", replies[1]);
    assert_eq!(replies[2]["error"]["code"], "json");
    assert_eq!(replies[3]["error"]["code"], "unknown-answer");
}

#[test]
fn who_waits_for_a_reply_gets_it() {
    use std::io::{BufRead, BufReader, Write};
    use std::process::{Command, Stdio};
    for command in ["mark", "solve"] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_vibank"))
            .args([command, "--jsonl", "--bank", BANK])
            .env("VIBANK_CACHE", "")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut stdin = child.stdin.take().expect("it has a standard input");
        let mut replies = BufReader::new(child.stdout.take().expect("it has a standard output"));
        for tag in 0..3 {
            writeln!(
                stdin,
                "{}",
                json!({"id": "free/nothing", "part": "a", "response": "1", "tag": tag})
            )
            .expect("it reads");
            let mut reply = String::new();
            replies.read_line(&mut reply).expect("it replies");
            assert!(
                reply.contains("error") && reply.contains(&format!("\"tag\":{tag}")),
                "{reply}"
            );
        }
        drop(stdin);
        child.wait().expect("it ends");
    }
}

#[test]
fn what_is_no_request_is_told_in_plain_words() {
    let replies = answers(
        "mark",
        &[
            json!([1, 2]),
            json!({"tag": 7, "id": 3}),
            json!({"id": "a", "part": "b", "answer": "c"}),
        ],
    );
    let message = |at: usize| replies[at]["error"]["message"].as_str().unwrap_or_default();
    assert_eq!(message(0), "a request is one JSON object");
    // Not a request whose `id` comes first.
    let listed = answers("solve", &[json!(["ch2/e8-springs-parallel-series"])]);
    assert_eq!(
        listed[0]["error"]["message"],
        "a request is one JSON object"
    );
    assert_eq!(replies[1]["tag"], 7);
    assert!(
        message(2).contains("`answer`") && !message(2).contains("line"),
        "{}",
        message(2)
    );
}
