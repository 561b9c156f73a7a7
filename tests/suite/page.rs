//! The self-check page: its grader against the library, and the page itself.
//!
//! The committed module runs here in an interpreter and has to give the replies of the library, bit for bit.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use crate::BANK;
use sha2::{Digest, Sha256};
use vibank::bank::Template;
use vibank::instance::Instance;
use vibank::solution::Solution;
use vibank::wasm::Grader;
use vibank::worksheet::Practice;
use wasmi::{Config, Engine, Instance as Running, Linker, Module, Store, TypedFunc};

const REBUILD: &str = "build it again with `src/wasm/build.sh` (needs `rustup target add wasm32-unknown-unknown` and zopfli)";

/// The module, running.
struct Sandbox {
    store: Store<()>,
    instance: Running,
}

impl Sandbox {
    fn start(lines: &str) -> Self {
        let bytes = fresh().unwrap_or_else(|| {
            let deflated = fs::read("src/wasm/grader.deflate").expect("the module is committed");
            joined(&miniz_oxide::inflate::decompress_to_vec(&deflated).expect("it is deflated"))
        });
        let mut config = Config::default();
        // Formulas nest: the depth that a browser allows.
        config.set_max_recursion_depth(10_000);
        let engine = Engine::new(&config);
        let module = Module::new(&engine, &bytes).expect("a module");
        assert_eq!(module.imports().count(), 0, "the module imports nothing");
        let mut store = Store::new(&engine, ());
        let instance = Linker::new(&engine)
            .instantiate_and_start(&mut store, &module)
            .expect("it starts");
        let mut sandbox = Self { store, instance };
        assert_eq!(sandbox.call("load", lines), "");
        sandbox
    }

    fn call(&mut self, name: &str, text: &str) -> String {
        let store = &mut self.store;
        let instance = self.instance;
        let memory = instance.get_memory(&*store, "memory").expect("it has one");
        let reserve: TypedFunc<i32, i32> = instance.get_typed_func(&*store, "reserve").expect("");
        let release: TypedFunc<(i32, i32), ()> =
            instance.get_typed_func(&*store, "release").expect("");
        let function: TypedFunc<(i32, i32), i64> =
            instance.get_typed_func(&*store, name).expect("");
        let length = text.len() as i32;
        let start = reserve.call(&mut *store, length).expect("room");
        memory
            .write(&mut *store, start as u32 as usize, text.as_bytes())
            .expect("it was reserved");
        let packed = function
            .call(&mut *store, (start, length))
            .unwrap_or_else(|error| panic!("`{text}` stopped the module: {error}"))
            as u64;
        let mut reply = vec![0; packed as u32 as usize];
        memory
            .read(&*store, (packed >> 32) as usize, &mut reply)
            .expect("it is there");
        release
            .call(store, ((packed >> 32) as i32, packed as u32 as i32))
            .expect("given back");
        String::from_utf8(reply).expect("JSON")
    }
}

/// A module out of the streams of `src/wasm/streams.py`, as the page joins them.
fn joined(bytes: &[u8]) -> Vec<u8> {
    /// What follows an opcode is bytes, and their count is in the second of its streams.
    const BYTES: usize = 3;
    /// In place of an opcode, for the variables of a function.
    const VARIABLES: usize = 256;
    fn number(from: &mut &[u8]) -> usize {
        let (mut value, mut shift) = (0, 0);
        loop {
            let byte = from.split_off_first().expect("a number goes on");
            value |= usize::from(byte & 0x7f) << shift;
            shift += 7;
            if *byte < 0x80 {
                return value;
            }
        }
    }
    fn put(out: &mut Vec<u8>, mut value: usize) {
        while value >= 0x80 {
            out.push(value as u8 | 0x80);
            value >>= 7;
        }
        out.push(value as u8);
    }
    let rest = &mut &bytes[..];
    let functions = number(rest);
    let count = number(rest);
    let forms: Vec<usize> = (0..count).map(|_| number(rest)).collect();
    let lengths: Vec<usize> = (0..3 + 2 * count).map(|_| number(rest)).collect();
    let mut streams: Vec<&[u8]> = lengths
        .iter()
        .map(|length| rest.split_off(..*length).expect("all of a stream"))
        .collect();
    assert!(rest.is_empty(), "nothing stands after the streams");

    let mut code = Vec::new();
    put(&mut code, functions);
    for _ in 0..functions {
        let (mut body, mut op, mut depth) = (Vec::new(), VARIABLES, 1);
        while depth > 0 {
            let [first, second] = [3 + 2 * op, 4 + 2 * op];
            if forms[op] == BYTES {
                let count = number(&mut streams[second]);
                body.extend(streams[first].split_off(..count).expect("all of it"));
            } else {
                for stream in [first, second].into_iter().take(forms[op]) {
                    let value = streams[stream];
                    number(&mut streams[stream]);
                    body.extend(&value[..value.len() - streams[stream].len()]);
                }
            }
            let next = streams[2].split_off_first().expect("a function goes on");
            body.push(*next);
            op = usize::from(*next);
            match op {
                0x02..=0x04 => depth += 1,
                0x0b => depth -= 1,
                _ => {}
            }
        }
        put(&mut code, body.len());
        code.extend(body);
    }
    let [before, after] = [streams[0], streams[1]];
    assert!(
        streams.iter().skip(2).all(|stream| stream.is_empty()),
        "all that was taken apart is joined"
    );
    let mut out = before.to_vec();
    out.push(10);
    put(&mut out, code.len());
    out.extend(code);
    out.extend(after);
    out
}

/// Requests about a question: everything that a page asks, with right, wrong and unreadable responses.
fn requests(
    number: usize,
    code: &str,
    template: &Template,
    keys: &[(String, String)],
) -> Vec<String> {
    let about = |what: &str, part: &str, more: serde_json::Value| {
        let mut request = serde_json::json!({ "do": what, "question": number, "code": code });
        if !part.is_empty() {
            request["part"] = part.into();
        }
        for (key, value) in more.as_object().into_iter().flatten() {
            request[key] = value.clone();
        }
        request.to_string()
    };
    let mut requests = vec![about("show", "", serde_json::json!({}))];
    for (part, key) in keys {
        for response in [key.as_str(), "2.5 Hz", "m x'' + k x = 0", "a, b", "][<b>"] {
            let response = serde_json::json!({ "response": response });
            requests.push(about("mark", part, response));
        }
        requests.push(about("read", part, serde_json::json!({ "response": key })));
        requests.push(about("solve", part, serde_json::json!({})));
        let hints = template.part(part).map_or(0, |part| part.hints.len());
        requests
            .extend((0..hints).map(|at| about("hint", part, serde_json::json!({ "number": at }))));
    }
    requests
}

/// The parts that are asked of a variant, and their keys as a student might type them.
fn keys(template: &Template, code: &str) -> Vec<(String, String)> {
    let variant: vibank::seed::Variant = code.parse().expect("a code");
    let seed = variant.item(template.id.as_str(), None);
    let solution =
        Solution::of(Instance::draw(template, seed).expect("its constraints can be met"));
    let asked = (0..template.parts.len()).filter(|place| solution.asks(*place));
    let key = |place: usize| {
        let key = solution
            .marker(place)
            .map(|marker| marker.key().math.plain());
        (template.parts[place].id.clone(), key.unwrap_or_default())
    };
    asked.map(key).collect()
}

#[test]
fn the_module_answers_as_the_library_does() {
    if !is_current() {
        // Reported past the capture of the test runner.
        let _ = writeln!(
            std::io::stderr(),
            "skipped 1 test: src/wasm/grader.deflate was built from other sources; `.ci/run` compares a fresh module, and to renew \
             it, {REBUILD}"
        );
        return;
    }
    let catalogue = &*BANK;
    let all: Vec<&Template> = catalogue.items().collect();
    let (practice, items) = Practice::of_items(catalogue, &all, "All");
    let lines = practice.lines(&items);
    let native = Grader::of(&lines).expect("it was written so");
    let mut sandbox = Sandbox::start(&lines);
    // An interpreter is slow: so many parts of each kind of answer, from the whole bank.
    const EACH: usize = 5;
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut compared = 0;
    for (number, question) in practice.questions.iter().enumerate() {
        let template = catalogue.find(question.item.as_str()).expect("it is there");
        let choose = format!(r#"{{"do":"choose","question":{number},"from":7}}"#);
        let reply: serde_json::Value = serde_json::from_str(&native.answer(&choose)).expect("JSON");
        let code = reply["code"].as_str().unwrap_or_else(|| panic!("{reply}"));
        let asked: Vec<(String, String)> = keys(template, code)
            .into_iter()
            .filter(|(part, _)| {
                let kind = template
                    .part(part)
                    .map_or("", |part| part.answer.kind().name());
                let count = counts.entry(kind).or_default();
                *count += 1;
                *count <= EACH
            })
            .collect();
        if asked.is_empty() {
            continue;
        }
        for request in requests(number, code, template, &asked) {
            let (here, there) = (native.answer(&request), sandbox.call("ask", &request));
            assert!(
                here == there,
                "{request}\n library: {here}\n module:  {there}"
            );
            assert!(!here.starts_with(r#"{"error""#), "{request}: {here}");
            compared += 1;
        }
    }
    let choose = r#"{"do":"choose","question":0,"from":7}"#;
    assert_eq!(sandbox.call("ask", choose), native.answer(choose));
    assert!(
        compared > 300,
        "only {compared} replies were compared: {counts:?}"
    );
}

#[test]
fn a_french_page_is_heard_in_french() {
    const ENGLISH: &[&str] = &[
        "equals", "square", "over", "capital", "squared", "per", "sub", "minus", "end", "cosine",
        "paren", "second", "metres",
    ];
    let catalogue = super::small_bank();
    let all: Vec<&Template> = catalogue.items().collect();
    let (mut practice, items) = Practice::of_items(&catalogue, &all, "Small");
    practice.language = "fr".to_owned();
    let grader = Grader::of(&practice.lines(&items)).expect("it was written so");
    let mut heard = Vec::new();
    for (number, question) in practice.questions.iter().enumerate() {
        let template = catalogue.find(question.item.as_str()).expect("it is there");
        let code = "000-000-000";
        for request in requests(number, code, template, &keys(template, code)) {
            let reply = grader.answer(&request).replace("\\\"", "\"");
            for attribute in ["alttext=\"", "\"name\":\""] {
                let values = reply.split(attribute).skip(1);
                heard.extend(values.filter_map(|rest| Some(rest.split_once('"')?.0.to_owned())));
            }
        }
    }
    for words in &heard {
        let english = words.split(' ').find(|word| ENGLISH.contains(word));
        assert_eq!(english, None, "{words}");
    }
    for words in ["racine carrée de", "radian par seconde", "oméga indice n"] {
        assert!(
            heard.iter().any(|own| own.contains(words)),
            "`{words}` is not heard"
        );
    }
}

#[test]
fn a_request_that_makes_no_sense_gets_an_error() {
    let catalogue = super::small_bank();
    let all: Vec<&Template> = catalogue.items().collect();
    let (practice, items) = Practice::of_items(&catalogue, &all, "Small");
    let grader = Grader::of(&practice.lines(&items)).expect("it was written so");
    for request in [
        "",
        "{}",
        "[[[[[[",
        r#"{"do":"show","question":99,"code":"000-000-000"}"#,
        r#"{"do":"show","question":0,"code":"K7Q"}"#,
        r#"{"do":"show","question":0,"code":"<script>"}"#,
        r#"{"do":"hint","question":0,"code":"000-000-000","part":"none","number":0}"#,
    ] {
        let reply: serde_json::Value =
            serde_json::from_str(&grader.answer(request)).expect("the reply is JSON");
        assert!(reply["error"].is_string(), "{request}: {reply}");
    }
    assert!(Grader::of("no items").is_err());
}

#[test]
fn a_hostile_response_stays_text() {
    let catalogue = super::small_bank();
    let all: Vec<&Template> = catalogue.items().collect();
    let (practice, items) = Practice::of_items(&catalogue, &all, "Small");
    let grader = Grader::of(&practice.lines(&items)).expect("it was written so");
    let long = "(".repeat(3900);
    for (number, question) in practice.questions.iter().enumerate() {
        let template = catalogue.find(question.item.as_str()).expect("it is there");
        let code = "000-000-000";
        for (part, _) in keys(template, code) {
            for response in [
                "<img src=x onerror=alert(1)>",
                "\u{0}\u{1b}[2J",
                "𝟙</script>",
                &long,
            ] {
                for what in ["mark", "read"] {
                    let request = serde_json::json!({
                        "do": what, "question": number, "code": code, "part": part, "response": response,
                    });
                    let reply = grader.answer(&request.to_string());
                    assert!(
                        !reply.contains("<img") && !reply.contains("</script"),
                        "{reply}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_page_is_one_file_that_fetches_nothing() {
    let catalogue = super::small_bank();
    let all: Vec<&Template> = catalogue.items().collect();
    let title = "Practice </script><script>alert(1)</script>";
    let (practice, items) = Practice::of_items(&catalogue, &all, title);
    let page = vibank::output::practice(&practice, &items).expect("it can be filled");
    assert_eq!(
        page.matches("<script").count(),
        5,
        "texts, font, items, grader, program"
    );
    assert!(!page.contains("alert(1)</script>"), "the title stays text");
    for fetching in [" src=", "http://", "https://", "@import", "fetch("] {
        let outside = page.replace("url(data:", "");
        assert!(!outside.contains(fetching), "the page has `{fetching}`");
    }
    let again = vibank::output::practice(&practice, &items).expect("it can be filled");
    assert!(page == again, "the same items give the same bytes");
}

/// The sources of the module, in the order of their names.
fn all_sources() -> Vec<PathBuf> {
    let crates = ["dynamics", "formula", "notation", "response", "source"];
    let mut files = Vec::new();
    sources(Path::new("src"), &mut files);
    for name in crates {
        sources(&Path::new("crates").join(name).join("src"), &mut files);
    }
    files.sort_by(|a, b| a.as_os_str().cmp(b.as_os_str()));
    files
}

/// What of the sources in a folder is in the module.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).expect("a folder");
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        let is_outside = ["src/cli", "src/output", "src/main.rs"]
            .iter()
            .any(|outside| path == Path::new(outside));
        if is_outside {
            continue;
        }
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs")
            && !path.ends_with("tests.rs")
            && !path.ends_with("references.rs")
        {
            found.push(path);
        }
    }
}

/// A module that was just built from these sources, where `VIBANK_GRADER` names one.
fn fresh() -> Option<Vec<u8>> {
    let path = std::env::var_os("VIBANK_GRADER")?;
    Some(fs::read(path).expect("VIBANK_GRADER names a module"))
}

/// Whether the module is that of these sources, by the digest that `src/wasm/digest.sh` makes: tests are no part of it, the
/// lock file and the flags of the build are.
fn is_current() -> bool {
    if fresh().is_some() {
        return true;
    }
    let files = all_sources();
    let mut hash = Sha256::new();
    for file in files {
        hash.update(without_tests(&content(&file)));
    }
    for file in [
        "Cargo.lock",
        "src/wasm/build.sh",
        "src/wasm/module.py",
        "src/wasm/snip.py",
        "src/wasm/order.py",
        "src/wasm/streams.py",
    ] {
        hash.update(content(Path::new(file)));
    }
    let digest: String = hash
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    fs::read_to_string("src/wasm/grader.sources").is_ok_and(|noted| noted.trim() == digest)
}

fn content(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A source without its tests, which stand at its end or in a file of their own.
fn without_tests(source: &str) -> String {
    let mut kept = String::new();
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        if line != "#[cfg(test)]" {
            kept.push_str(line);
            kept.push('\n');
        } else if lines.next().is_some_and(|module| module.ends_with('{')) {
            break;
        }
    }
    kept
}

/// `src/wasm/snip.py` takes out of the module what prints values for programmers: nothing that is said may need it.
#[test]
fn nothing_is_printed_for_programmers() {
    // Each prints its own type for programmers.
    let own = ["src/answer/mod.rs", "src/figure/schematic.rs"];
    let mut found = Vec::new();
    for file in all_sources() {
        let allowed = usize::from(own.iter().any(|path| file == Path::new(path)));
        let source = without_tests(&content(&file));
        let lines = source.lines().map(str::trim_start);
        let printing = lines.filter(|line| !line.starts_with("//") && line.contains(":?}"));
        found.extend(
            printing
                .skip(allowed)
                .map(|line| format!("{}: {line}", file.display())),
        );
    }
    assert_eq!(found, Vec::<String>::new());
}

/// The digest of the test is that of the script which notes it.
#[cfg(unix)]
#[test]
fn tests_are_no_part_of_the_modules_sources() {
    let ran = std::process::Command::new("src/wasm/digest.sh")
        .arg("--list")
        .output()
        .expect("a shell");
    let listed = String::from_utf8(ran.stdout).expect("paths");
    let files = all_sources();
    let files: String = files
        .iter()
        .map(|path| format!("{}\n", path.display()))
        .collect();
    assert_eq!(listed, files);
    let source = "fn a() {}\n#[cfg(test)]\nmod tests;\nfn b() {}\n#[cfg(test)]\nmod more {\n    fn c() {}\n}\n";
    assert_eq!(without_tests(source), "fn a() {}\nfn b() {}\n");
}
