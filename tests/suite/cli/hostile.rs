//! Hostile input: a clear message each, the right exit code, no panic, no hang.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use serde_json::json;

use super::{BANK, Ran, blueprint, content, fed, folder, put, small, text_of, vibank};

/// Nothing here may take longer, with a slow build on a busy machine.
const MAX_DURATION: Duration = Duration::from_mins(1);

#[track_caller]
fn soon<T>(run: impl FnOnce() -> T) -> T {
    #[expect(
        clippy::disallowed_methods,
        reason = "the test is about the time it takes"
    )]
    let begin = Instant::now();
    let result = run();
    let taken = begin.elapsed();
    assert!(taken < MAX_DURATION, "it took {taken:?}");
    result
}

/// Answers of a command to lines that are not necessarily JSON.
fn raw(command: &str, input: impl Into<Vec<u8>>) -> Ran {
    let bank: &[&str] = if command == "compute" {
        &[]
    } else {
        &["--bank", BANK]
    };
    let input = input.into();
    soon(|| fed(&[&[command, "--jsonl"], bank].concat(), input)).ends(0)
}

const LINE_COMMANDS: [&str; 3] = ["solve", "mark", "compute"];

#[test]
fn a_line_of_ten_megabytes_is_answered_and_the_next_one_too() {
    for command in LINE_COMMANDS {
        let long = format!(
            "{{\"id\":\"{}\"}}\n{{\"id\":\"free/spring-mass\"}}\n",
            "x".repeat(10 << 20)
        );
        let lines = raw(command, long).lines();
        assert_eq!(lines.len(), 2, "{command}");
        let code = if command == "compute" {
            "line_too_long"
        } else {
            "limit"
        };
        assert_eq!(lines[0]["error"]["code"], code, "{command}: {}", lines[0]);
        let blank = raw(command, format!("{}\n", " ".repeat(10 << 20)));
        assert!(blank.out.len() < 1000);
    }
}

#[test]
fn brackets_without_end_are_refused_on_their_line() {
    let deep = 100_000;
    for command in LINE_COMMANDS {
        for open in ["[", "{\"id\":", "{\"id\":\"free/spring-mass\",\"tag\":["] {
            let rest = "[".repeat(deep);
            let lines = raw(command, format!("{open}{rest}\n{{}}\n")).lines();
            assert_eq!(lines.len(), 2, "{command}");
            assert!(
                lines[0]["error"]["message"].is_string(),
                "{command}: {}",
                lines[0]
            );
        }
    }
    for response in ["(", "[", "{", "-", "√", "sqrt(", "2^", "\\frac{"] {
        let count = deep / response.len();
        let request = json!({"id": "free/spring-mass", "part": "omega_n", "response": response.repeat(count)});
        let line = &raw("mark", format!("{request}\n")).lines()[0];
        assert_eq!(line["verdict"], "unreadable", "{response}");
        // Also within the length that is read.
        let request = json!({"id": "free/spring-mass", "part": "omega_n", "response": response.repeat(3900 / response.len())});
        let line = &raw("mark", format!("{request}\n")).lines()[0];
        assert_ne!(line["verdict"], "right", "{response}: {line}");
    }
}

#[test]
fn numbers_beyond_all_bounds_are_told() {
    let bad = [
        "NaN",
        "nan",
        "inf",
        "Infinity",
        "-inf",
        "1e400 kg",
        "1e999999999999 kg",
        "",
        "kg",
        "0x10 kg",
        "1e5000",
        "--2 kg",
    ];
    let giant = "9".repeat(100_000);
    for value in bad.into_iter().chain([giant.as_str()]) {
        let request = json!({"id": "free/spring-mass", "set": {"m": value}});
        let line = &raw("solve", format!("{request}\n")).lines()[0];
        let message = line["error"]["message"].as_str().unwrap_or_default();
        assert!(
            !message.is_empty() && message.len() < 500,
            "{value:.20}: {line:.300}",
            line = line.to_string()
        );
    }
    for value in ["1e400", "-1e400", "NaN", "Infinity"] {
        let line = format!("{{\"id\":\"free/spring-mass\",\"set\":{{\"m\":{value}}}}}\n");
        let line = &raw("solve", line).lines()[0];
        assert!(line["error"]["message"].is_string(), "{value}: {line}");
    }
    // The ends of binary64 are answered, or reported to be absent with the reason.
    for (m, k) in [
        ("1e-300 kg", "1e300 N/m"),
        ("1e300 kg", "1e-300 N/m"),
        ("5e-324 kg", "1 N/m"),
    ] {
        let request =
            json!({"id": "free/spring-mass", "set": {"m": m, "k": k}, "want": ["omega_n"]});
        let line = &raw("solve", format!("{request}\n")).lines()[0];
        let entry = &line["answers"]["omega_n"];
        let reported =
            entry["si"].is_number() || entry["reason"].is_string() || line["error"].is_object();
        assert!(reported, "{line}");
    }
    for response in [
        "1e400 rad/s",
        "NaN",
        "inf rad/s",
        "1e-400 rad/s",
        "0/0",
        "1/0 rad/s",
        giant.as_str(),
        "20 rad/s^99999999999",
        "20 (rad/s)^(1/0)",
    ] {
        let request = json!({"id": "free/spring-mass", "part": "omega_n", "response": response});
        let line = &raw("mark", format!("{request}\n")).lines()[0];
        let verdict = line["verdict"].as_str().unwrap_or_default();
        assert!(["wrong", "unreadable"].contains(&verdict), "{line}");
    }
    for value in [
        "1e400", "-1e400", "NaN", "null", "\"1\"", "1e308", "-0.0", "5e-324",
    ] {
        let line = format!(
            "{{\"id\":1,\"task\":\"free_response\",\"params\":{{\"m\":{value},\"c\":1,\"k\":4,\"x0\":1,\"v0\":0,\"t\":1}}}}\n"
        );
        assert_eq!(raw("compute", line).lines().len(), 1);
    }
}

#[test]
fn requests_cannot_ask_for_too_much() {
    let times: Vec<f64> = (0..200_000).map(f64::from).collect();
    let request = json!({"id": "free/damped-block", "at": times, "want": ["x"]});
    let line = &raw("solve", format!("{request}\n")).lines()[0];
    assert_eq!(
        line["error"]["code"],
        "limit",
        "{line:.200}",
        line = line.to_string()
    );
    let want = vec!["x"; 50_000];
    let request = json!({"id": "free/damped-block", "want": want, "at": vec![1; 50_000]});
    soon(|| raw("solve", format!("{request}\n")));
}

#[test]
fn bytes_that_are_no_text_are_answered_on_their_line() {
    for command in LINE_COMMANDS {
        let input = [
            b"\xff\xfe\x00\n".as_slice(),
            b"{\"id\":\"\xff\"}\n",
            b"\0\n",
            b"{}\n",
        ]
        .concat();
        let lines = raw(command, input).lines();
        assert_eq!(lines.len(), 4, "{command}");
        assert!(
            lines.iter().all(|line| line.get("error").is_some()),
            "{command}: {lines:?}"
        );
    }
}

/// A bank with one item that is changed, beside a sound one.
fn bank(name: &str, item: impl AsRef<[u8]>) -> (PathBuf, String) {
    let folder = folder(name);
    put(&folder, "bank.toml", content(format!("{BANK}/bank.toml")));
    put(
        &folder,
        "free/_chapter.toml",
        content(format!("{BANK}/free/_chapter.toml")),
    );
    put(
        &folder,
        "free/sound.toml",
        content(format!("{BANK}/free/spring-mass.toml")),
    );
    put(&folder, "free/hostile.toml", item);
    let path = text_of(&folder);
    (folder, path)
}

fn sound() -> String {
    content(format!("{BANK}/free/spring-mass.toml"))
}

/// The item is refused with these words, and the other is served.
#[track_caller]
fn refused(name: &str, item: impl AsRef<[u8]>, words: &str) -> Ran {
    let (_, bank) = bank(name, item);
    let ran = soon(|| vibank(&["check", "--bank", &bank]))
        .ends(1)
        .complains("free/hostile.toml");
    let ran = ran.complains(words);
    assert!(
        ran.err.len() < 400_000,
        "the report is {} bytes long",
        ran.err.len()
    );
    soon(|| vibank(&["show", "free/sound", "--bank", &bank])).ends(0);
    ran
}

#[test]
fn items_nested_without_end_are_refused() {
    let deep = 100_000;
    for (name, open, close) in [
        ("parentheses", "(", ")"),
        ("brackets", "[", "]"),
        ("roots", "sqrt(", ")"),
        ("signs", "-", ""),
        ("powers", "2^", ""),
    ] {
        let formula = format!("{}k/m{}", open.repeat(deep), close.repeat(deep));
        let item = sound().replace("\"sqrt(k/m)\"", &format!("\"{formula}\""));
        refused(&format!("deep-{name}"), item, "error[");
    }
    for (name, open) in [("array", "["), ("table", "{a="), ("dotted", "a.")] {
        let value = if name == "dotted" {
            format!("{}b = 1", open.repeat(deep))
        } else {
            format!("deep = {}", open.repeat(deep))
        };
        refused(
            &format!("deep-toml-{name}"),
            format!("{}\n{value}\n", sound()),
            "error[",
        );
    }
    for (name, text) in [
        (
            "braces",
            format!("$${}x{}$$", "{".repeat(deep), "}".repeat(deep)),
        ),
        ("quotes", "> ".repeat(deep)),
        ("stars", "*_".repeat(deep)),
        ("links", "[".repeat(deep)),
        ("holes", "<< m >>".repeat(deep)),
    ] {
        let item = sound().replace("A block of mass", &format!("{text} A block of mass"));
        let (_, bank) = bank(&format!("deep-text-{name}"), item);
        soon(|| vibank(&["check", "--bank", &bank]));
        soon(|| vibank(&["show", "free/sound", "--bank", &bank])).ends(0);
    }
}

#[test]
fn cyclic_quantities_are_refused_at_load() {
    let circle = |text: &str| sound().replace("sqrt(k/m)", text);
    refused("cycle-self", circle("omega_n + sqrt(k/m)"), "bank::cycle");
    refused("cycle-two", circle("sqrt(k/m)*f_n/f_n"), "bank::cycle");
    let chain: String = (0..1500)
        .map(|at| format!("q{at} = \"q{} + 1\"\n", at + 1))
        .collect();
    let item = sound().replace(
        "[statement]",
        "[quantities.q1500]\nformula = \"1\"\n[statement]",
    );
    let item = item.replace("[quantities]\n", &format!("[quantities]\n{chain}"));
    refused("chain", item, "error[");
}

#[test]
fn a_formula_that_is_not_finite_is_absent_with_its_reason() {
    for formula in [
        "sqrt(k/m)/0",
        "sqrt(-k/m)",
        "sqrt(k/m)*exp(1e6)",
        "sqrt(k/m)*ln(0)",
        "sqrt(k/m)*1e400",
        "sqrt(k/m)^1",
    ] {
        let item = sound().replace("\"sqrt(k/m)\"", &format!("\"{formula}\""));
        let (_, bank) = bank("absent", item);
        let ran = soon(|| vibank(&["solve", "free/hostile", "--bank", &bank]));
        if formula.ends_with("^1") {
            ran.ends(0).says("20.0 rad/s");
        } else {
            assert!(
                !ran.out.contains("NaN") && !ran.out.contains(" inf"),
                "{}",
                ran.out
            );
        }
        soon(|| vibank(&["show", "free/hostile", "--bank", &bank, "--solution"]));
    }
}

#[test]
fn a_constraint_that_cannot_be_met_is_named() {
    let item = sound().replace(
        "[statement]",
        "[constraints]\nnever_met = \"m > 100[kg]\"\n\n[statement]",
    );
    let (folder, bank) = bank("constraint", item);
    soon(|| vibank(&["show", "free/hostile", "--seed", "1", "--bank", &bank]))
        .ends(2)
        .complains("`never_met`");
    let plan = "title = \"T\"\nseed = 1\nvariants = 2\n[[question]]\nitem = \"free/hostile\"\n";
    let plan = put(&folder, "plan.txt", plan);
    let out = text_of(&folder.join("out"));
    soon(|| vibank(&["sheet", &plan, "--out", &out, "--bank", &bank]))
        .ends(2)
        .complains("`never_met`")
        .complains("help: loosen the constraints");
    assert!(
        !folder.join("out/sheets.html").exists(),
        "nothing half-written is left"
    );
    let request = "{\"id\":\"free/hostile\",\"seed\":1}\n";
    let ran = fed(&["solve", "--jsonl", "--bank", &bank], request.into()).ends(0);
    assert_eq!(ran.lines()[0]["error"]["code"], "limit");
}

#[test]
fn a_grid_without_end_is_refused_or_drawn() {
    let ranges = [
        ("1e-300 .. 1e300 kg", "1e-300 kg"),
        ("1 .. 5 kg", "0 kg"),
        ("1 .. 5 kg", "-1 kg"),
        ("5 .. 1 kg", "1 kg"),
        ("0 .. 99999999999999999999999999 kg", "1 kg"),
    ];
    for (range, step) in ranges {
        let item = sound().replace("1 .. 5 kg", range).replace("0.1 kg", step);
        let (_, bank) = bank("grid", item);
        soon(|| vibank(&["check", "--bank", &bank]));
        soon(|| vibank(&["show", "free/hostile", "--seed", "1", "--bank", &bank]));
    }
}

#[test]
fn every_kind_of_file_may_be_empty_or_no_text() {
    let folder = folder("files");
    put(&folder, "class-empty.csv", "");
    put(&folder, "class-bytes.csv", b"id,name\n1,\x81\n");
    for (name, bytes) in [
        ("empty.toml", b"".as_slice()),
        ("bytes.toml", b"title = \"\xff\""),
        ("zeros.toml", &[0; 100]),
    ] {
        let path = put(&folder, name, bytes);
        small(&["sheet", &path]).ends(2).complains(name);
        small(&["grade", &path, &path]).ends(2).complains(name);
        refused(&format!("file-{name}"), bytes, "error[");
        let bank = self::bank("bank-file", sound()).0;
        put(&bank, "bank.toml", bytes);
        vibank(&["check", "--bank", &text_of(&bank)])
            .ends(1)
            .complains("bank.toml");
        put(&bank, "bank.toml", content(format!("{BANK}/bank.toml")));
        put(&bank, "free/_chapter.toml", bytes);
        vibank(&["check", "--bank", &text_of(&bank)])
            .ends(1)
            .complains("_chapter.toml");
    }
    for list in ["class-empty.csv", "class-bytes.csv", "class-none.csv"] {
        let plan = put(
            &folder,
            "plan.toml",
            blueprint(&format!("seed = 1\nstudents = \"{list}\"")),
        );
        small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))])
            .ends(2)
            .complains("class-");
    }
    let nothing = self::folder("empty-bank");
    vibank(&["check", "--bank", &text_of(&nothing)])
        .ends(1)
        .complains("bank.toml");
}

#[test]
fn line_ends_and_a_mark_of_byte_order_change_nothing() {
    let (_, bank) = bank("crlf", format!("\u{feff}{}", sound().replace('\n', "\r\n")));
    vibank(&["check", "--bank", &bank]).ends(0);
    let solved = |id: &str| {
        vibank(&["solve", id, "--json", "--bank", &bank])
            .ends(0)
            .lines()
            .remove(0)
    };
    assert_eq!(
        solved("free/hostile")["answers"],
        solved("free/sound")["answers"]
    );
    let ran = vibank(&["list", "--format", "json", "--bank", &bank]).ends(0);
    let list = &ran.lines()[0];
    assert_eq!(
        list[0]["revision"], list[1]["revision"],
        "line ends do not make a revision"
    );
    let folder = folder("crlf-plan");
    let text = blueprint("seed = 1\nvariants = 2").replace('\n', "\r\n");
    let plan = put(&folder, "plan.toml", format!("\u{feff}{text}"));
    small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))]).ends(0);
}

#[test]
fn a_giant_number_of_variants_or_threads_is_refused_or_bounded() {
    let folder = folder("giant");
    for count in ["18446744073709551616", "-1", "1.5", "9223372036854775807"] {
        let plan = put(
            &folder,
            "plan.toml",
            blueprint(&format!("seed = 1\nvariants = {count}")),
        );
        let out = text_of(&folder.join("out"));
        soon(|| small(&["sheet", &plan, "--out", &out]))
            .ends(2)
            .complains("variants");
    }
    let plan = put(&folder, "plan.toml", blueprint("seed = 1\nvariants = 1"));
    let out = text_of(&folder.join("out"));
    soon(|| small(&["sheet", &plan, "--out", &out, "--threads", "1000000"]))
        .ends(2)
        .complains("--threads");
}

/// A reader that drew each finding with the whole file took minutes for 90,000 of them.
#[test]
fn findings_without_end_are_cut_off() {
    let folder = folder("findings");
    let keys: String = (0..20_000).map(|key| format!("k{key} = 1\n")).collect();
    let grades: Vec<String> = (0..20_000).map(|own| format!("g{own} = 1")).collect();
    let parts = "'a', ".repeat(50_000);
    let names: Vec<String> = (0..20_000).map(|own| format!("x{own} = '1 kg'")).collect();
    let head = "seed = 1\nvariants = 1\n";
    for (name, text) in [
        ("keys", blueprint(&format!("{head}{keys}"))),
        (
            "formats",
            blueprint(&format!("{head}formats = [{}]", "'md', ".repeat(50_000))),
        ),
        (
            "scale",
            format!(
                "{}[marks]\nscale = {{ {} }}\n",
                blueprint(head),
                grades.join(", ")
            ),
        ),
        ("parts", format!("{}parts = [{parts}]\n", blueprint(head))),
        (
            "set",
            format!("{}set = {{ {} }}\n", blueprint(head), names.join(", ")),
        ),
    ] {
        let plan = put(&folder, &format!("{name}.toml"), text);
        let ran = soon(|| small(&["check", &plan])).ends(1);
        assert!(ran.err.matches("error[").count() < 110, "{name}");
        ran.complains("more than 100 findings about this file");
    }
    let plan = put(&folder, "plan.toml", blueprint(head));
    let out = folder.join("out");
    small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let form = text_of(&out.join("responses.csv"));
    let decision = "[[decision]]\nitem = 'free/spring-mass'\npart = 'none'\nvoid = 'full marks'\nwho = 'A'\nwhy = 'B'\n";
    for text in [decision.repeat(5_000), keys] {
        put(&out, "decisions.toml", text);
        soon(|| small(&["grade", &text_of(&out.join("manifest.json")), &form]))
            .ends(2)
            .complains("more than 100 findings about this file");
    }
}

#[test]
fn a_line_that_each_page_shows_has_a_bound() {
    let folder = folder("long-lines");
    for key in ["title", "course", "date", "duration"] {
        let long = "x".repeat(100_000);
        let text = blueprint("seed = 1\nvariants = 1");
        let text = match key {
            "title" => text.replace("A test", &long),
            _ => format!("{key} = '{long}'\n{text}"),
        };
        let plan = put(&folder, "plan.toml", text);
        soon(|| small(&["check", &plan]))
            .ends(1)
            .complains(&format!(
                "100000 letters in the {key}, at most 300 are read"
            ));
    }
}

#[test]
fn what_messages_quote_neither_steers_the_terminal_nor_fills_it() {
    for id in ["\u{1b}[31mred\u{7}", "a\rb", &"x".repeat(100_000)] {
        let ran = small(&["show", id]).ends(2);
        let steers = |char: char| char.is_control() && char != '\n';
        assert!(!ran.err.contains(steers), "{:?}", ran.err);
        assert!(ran.err.len() < 5_000);
    }
}

#[test]
fn a_number_of_threads_that_no_machine_has_is_refused() {
    let ran = super::run_with(
        &[("RAYON_NUM_THREADS", "100000"), ("VIBANK_PRESS", "")],
        &["list", "--bank", BANK],
    );
    ran.ends(2).complains("at most 512");
}

/// Questions that nobody sees were asked for ever where the input had no end.
#[cfg(target_os = "linux")]
#[test]
fn who_asks_and_is_not_heard_ends() {
    let desk = super::desk::Desk::with_class("unheard", 2);
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    let manifest = desk.path("manifest.json");
    for arguments in [["practice", "free/spring-mass"], ["enter", &manifest]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
        let mut yes = std::process::Command::new("yes")
            .arg("1")
            .stdout(std::process::Stdio::piped())
            .spawn()
            .expect("there is `yes`");
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_vibank"));
        command
            .args(arguments)
            .args(["--bank", BANK])
            .env("VIBANK_CACHE", "")
            .stdin(yes.stdout.take().expect("a pipe"))
            .stdout(full.expect("Linux has it"))
            .stderr(std::process::Stdio::null());
        let ended = soon(|| command.status()).expect("it starts");
        let _ = yes.kill();
        let _ = yes.wait();
        assert_eq!(ended.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn layouts_of_the_user_can_read_nothing_and_run_nothing() {
    let folder = folder("layouts");
    let plan = put(&folder, "plan.toml", blueprint("seed = 1\nvariants = 1"));
    let (layouts, out) = (text_of(&folder.join("own")), text_of(&folder.join("out")));
    for layout in [
        "{% include \"/etc/passwd\" %}",
        "{{ get_env(name=\"HOME\") }}",
        "{{ load_data(path=\"/etc/passwd\") }}",
        "{% for a in [1] %}",
        "{{ nothing.at.all }}",
    ] {
        put(&folder, "own/html/worksheet.html", layout);
        let ran = soon(|| small(&["sheet", &plan, "--out", &out, "--layouts", &layouts])).ends(2);
        ran.complains("worksheet.html");
    }
}
