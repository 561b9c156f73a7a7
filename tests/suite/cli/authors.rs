//! The bench of authors: what `new` begins, questions of one's own, `preview`, `check --watch`, words that are nearly right.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use super::{blueprint, content, folder, put, small, text_of, vibank};

#[test]
fn check_looks_at_the_files_that_a_blueprint_names() {
    let folder = folder("check-beside");
    let plan = "title = 'T'\nsecret = 'exam.key'\nstudents = 'class.csv'\n[[question]]\nitem = 'ch3/e5-log-decrement'\n";
    let plan = put(&folder, "exam.toml", plan);
    put(&folder, "class.csv", "id,name\n1,Ada\n1,Emmy\n");
    vibank(&["check", &plan])
        .ends(1)
        .complains("exam.key")
        .complains("vibank new secret")
        .complains("class.csv")
        .complains("1 blueprint, 2 errors, 0 warnings");
    put(&folder, "class.csv", "id,name\n1,Ada\n2,Emmy\n");
    vibank(&["new", "secret", &text_of(&folder.join("exam.key"))]).ends(0);
    vibank(&["check", &plan])
        .ends(0)
        .complains("1 blueprint, 0 errors, 0 warnings");
}

#[test]
fn a_new_exam_can_be_checked_printed_and_marked_as_it_stands() {
    let folder = folder("new-exam");
    let exam = text_of(&folder.join("exam.toml"));
    vibank(&["new", "exam", &exam])
        .ends(0)
        .says("vibank preview");
    vibank(&["new", "exam", &exam])
        .ends(2)
        .complains("exists already");
    vibank(&["check", "--seeds", "5", &exam])
        .ends(0)
        .complains("1 blueprint, 0 errors, 0 warnings");
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &exam, "-o", &out])
        .ends(0)
        .says("4 sheets");
    // The question that stands in it is kept with the run, word by word.
    let manifest: serde_json::Value =
        serde_json::from_str(&content(folder.join("out/manifest.json"))).unwrap();
    let kept = manifest["items"]["own/a-swing"].as_str().unwrap();
    assert!(content(&exam).contains(kept));
    let form = content(folder.join("out/responses.csv"));
    let answers = ["0.4 Hz", "2.51 rad/s", "0.4", "0.7 Hz"];
    let mut answers = answers.into_iter();
    let filled = form
        .lines()
        .map(|line| match line.split(',').collect::<Vec<_>>()[..] {
            [_, _, "3", "a", ..] => format!("{line}{}", answers.next().unwrap()),
            [_, _, "3", "b", ..] => format!("{line}b"),
            _ => line.to_owned(),
        });
    let filled = filled.collect::<Vec<_>>().join("\n");
    let responses = put(&folder, "filled.csv", filled);
    let marks = text_of(&folder.join("marks"));
    let ran = vibank(&[
        "grade",
        &text_of(&folder.join("out/manifest.json")),
        &responses,
        "-o",
        &marks,
        "--no-feedback",
    ]);
    // The bank never had it, so that nothing has moved on.
    assert!(!ran.err.contains("moved on"), "{}", ran.err);
    let details = content(folder.join("marks/details.csv"));
    let rows = details
        .lines()
        .filter(|line| line.contains("own/a-swing,part_1"));
    let is_right: Vec<bool> = rows.map(|row| row.contains(",right,")).collect();
    assert_eq!(is_right, [true, true, true, false]);
    let mut rows = details
        .lines()
        .filter(|line| line.contains("own/a-swing,part_2"));
    assert!(
        rows.clone().count() == 4
            && rows.all(|row| row.contains(",right,") || row.contains(",wrong,"))
    );
}

#[test]
fn a_new_bank_has_no_finding_and_is_not_made_where_something_is() {
    let folder = folder("new-bank");
    let bank = text_of(&folder.join("mine"));
    vibank(&["new", "bank", &bank])
        .ends(0)
        .says(&format!("vibank check --bank {bank}"));
    vibank(&["check", "--bank", &bank])
        .ends(0)
        .complains("1 item, 0 errors, 0 warnings");
    vibank(&["list", "--bank", &bank])
        .ends(0)
        .says("ch1/block-on-a-spring");
    let before = content(folder.join("mine/bank.toml"));
    vibank(&["new", "bank", &bank])
        .ends(2)
        .complains("exists already");
    assert_eq!(content(folder.join("mine/bank.toml")), before);
}

/// A question of each simple kind with a fixed key, and a right and a wrong answer to each.
const KINDS: [(&str, &str, &str); 11] = [
    ("key = '2.5 mm'", "0.25 cm", "2.5 m"),
    ("key = 0.25", "1/4", "0.3"),
    ("key = '0.8[N/m]'\nunit = 'N/m'", "0.8 N/m", "8 N/m"),
    ("kind = 'integer'\nkey = 3", "3", "4"),
    ("kind = 'formula'\nkey = 'sqrt(k/m)'", "(k/m)^(1/2)", "k/m"),
    (
        "kind = 'matrix'\nkey = '[[2*k, -k], [-k, k]]'",
        "k [2 -1; -1 1]",
        "k [2 1; 1 1]",
    ),
    (
        "kind = 'interval'\nvariable = 'k'\nkey = '(3[N/m], inf)'",
        "k > 3 N/m",
        "k > 4 N/m",
    ),
    (
        "kind = 'function'\nkey = 'A*cos(sqrt(k/m)*t)'\nspan = ['0[s]', '9[s]']",
        "A cos(sqrt(k/m) t)",
        "A sin(sqrt(k/m) t)",
    ),
    (
        "kind = 'choice'\nshuffle = false\noptions = [{ id = 'up', text = 'up', right = true }, { id = 'down', text = 'down' }]",
        "a",
        "b",
    ),
    ("key = '[0.2, 0.4]'\nunit = '1'", "0.4, 0.2", "0.3, 0.9"),
    (
        "kind = 'work'\nrubric = [{ points = 1, text = 'a sketch with all forces' }]",
        "",
        "",
    ),
];

#[test]
fn questions_of_ones_own_have_fixed_keys_of_all_simple_kinds() {
    let folder = folder("own-kinds");
    let parts = KINDS.map(|(key, _, _)| format!("[[question.part]]\nask = 'What?'\n{key}\n"));
    let text = format!(
        "title = 'T'\nseed = 1\nvariants = 2\n[[question]]\ntitle = 'Each kind'\nid = 'kinds'\nstatement = 'A block on a spring.'\n\
         parameters = {{ m = '2 kg', k = '800 N/m', A = '3 cm' }}\n{}",
        parts.concat()
    );
    let exam = put(&folder, "exam.toml", text);
    vibank(&["check", "--seeds", "3", &exam]).ends(0);
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &exam, "-o", &out]).ends(0);
    let form = content(folder.join("out/responses.csv"));
    let mut lines = form.lines();
    let mut filled = vec![lines.next().unwrap().to_owned()];
    let answers = KINDS.iter().map(|(_, right, _)| right);
    let answers = answers.chain(KINDS.iter().map(|(_, _, wrong)| wrong));
    filled.extend(
        lines
            .zip(answers)
            .map(|(line, answer)| format!("{line}\"{answer}\"")),
    );
    let responses = put(&folder, "filled.csv", filled.join("\n"));
    let marks = text_of(&folder.join("marks"));
    let manifest = text_of(&folder.join("out/manifest.json"));
    vibank(&[
        "grade",
        &manifest,
        &responses,
        "-o",
        &marks,
        "--no-feedback",
    ]);
    let results: serde_json::Value =
        serde_json::from_str(&content(folder.join("marks/results.json"))).unwrap();
    let text = results.to_string();
    let details = content(folder.join("marks/details.csv"));
    for (wanted, rows) in ["right", "wrong"].into_iter().zip(sheets(&details)) {
        for (row, (key, ..)) in rows.iter().zip(&KINDS) {
            if !key.contains("work") {
                assert!(row.contains(&format!(",{wanted},")), "{key}: {row}\n{text}");
            }
        }
    }
}

/// The rows of a table of details, by sheet.
fn sheets(details: &str) -> Vec<Vec<&str>> {
    let rows: Vec<&str> = details.lines().skip(1).collect();
    let code = |row: &&str| row.split(',').next().map(str::to_owned);
    rows.chunk_by(|a, b| code(a) == code(b))
        .map(<[&str]>::to_vec)
        .collect()
}

#[test]
fn questions_of_ones_own_can_draw_their_data() {
    let folder = folder("own-drawn");
    let text = "title = 'T'\nseed = 1\nvariants = 3\n[[question]]\ntitle = 'A spring'\n\
                statement = 'A block of mass << m.given >> on a spring of stiffness << k.given >>.'\n\
                [question.parameters]\nm = { value = '2 kg', range = '1 .. 5 kg', step = '0.5 kg' }\n\
                k = { value = '800 N/m', range = '200 .. 900 N/m', step = '50 N/m' }\n\
                [question.quantities]\nomega_n = { formula = 'sqrt(k/m)', unit = 'rad/s' }\n\
                [[question.part]]\nkey = 'omega_n'\nask = 'Find its natural angular frequency.'\n";
    let exam = put(&folder, "exam.toml", text);
    vibank(&["check", "--seeds", "20", &exam])
        .ends(0)
        .complains("0 errors");
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &exam, "-o", &out]).ends(0);
    let manifest: serde_json::Value =
        serde_json::from_str(&content(folder.join("out/manifest.json"))).unwrap();
    let values = |at: usize| manifest["variants"][at]["questions"][0]["values"].to_string();
    assert_ne!(values(0), values(1));
    assert_eq!(
        manifest["variants"][0]["questions"][0]["item"],
        "own/a-spring"
    );
    // The same question goes into a page, a package and a course.
    for (name, command) in [
        ("page.html", &["page"][..]),
        ("package.zip", &["page", "--scorm", "1.2"]),
        ("questions.xml", &["export", "moodle"]),
        ("qti.zip", &["export", "qti"]),
    ] {
        let out = text_of(&folder.join(name));
        vibank(&[command, &[&exam, "-o", &out]].concat()).ends(0);
    }
    assert!(content(folder.join("questions.xml")).contains("own/a-spring"));
    // What a learner has in the package is found with the blueprint.
    let package = text_of(&folder.join("package.zip"));
    let show = ["show", "--learner", "4711", "--key", &package];
    vibank(&show).ends(2).complains("--blueprint");
    vibank(&[&show[..], &["--blueprint", &exam]].concat())
        .ends(0)
        .says("own/a-spring")
        .says("rad/s");
}

#[test]
fn what_is_wrong_with_a_question_of_ones_own_has_its_place_in_the_blueprint() {
    let folder = folder("own-wrong");
    let head = "title = 'T'\nseed = 1\nvariants = 1\n\n[[question]]\n";
    let part = "[[question.part]]\nask = 'What?'\nkey = '3 m'\n";
    for (name, body, place, words) in [
        ("no-statement", format!("title = 'A'\n{part}"), "5:1", "`question` has no `statement`"),
        ("no-title", format!("statement = 'S'\n{part}"), "5:1", "`question` has no `title`"),
        ("unknown-key", format!("title = 'A'\nstatement = 'S'\n{part}kye = 3\n"), "11:1", "did you mean `key`?"),
        ("near-key", format!("title = 'A'\nstatement = 'S'\nminuts = 3\n{part}"), "8:1", "did you mean `minutes`?"),
        ("kind", format!("title = 'A'\nstatement = 'S'\n{part}kind = 'nummeric'\n"), "11:8", "did you mean `numeric`?"),
        ("id", format!("id = 'A B'\ntitle = 'A'\nstatement = 'S'\n{part}"), "6:6", "small letters"),
        ("both", format!("item = 'free/spring-mass'\nstatement = 'S'\ntitle = 'A'\n{part}"), "6:1", "has no `item`"),
        ("text", "title = 'A'\nstatement = '''\nS\n<< m.given >>\n'''\n[[question.part]]\nask = 'W'\nkey = 3\n".to_owned(), "9:1", "`m`"),
        ("apart", format!("title = 'A'\nstatement = 'S'\n[page]\npass = '60 %'\n{part}"), "8:2", "between the lines"),
        ("twice", format!("title = 'A'\nstatement = 'S'\n{part}[[question]]\ntitle = 'a'\nstatement = 'S'\n{part}"), "11:1", "`a`"),
        ("nothing", "points = 3\n".to_owned(), "5:1", "`item`, `pick` and `statement`"),
    ] {
        let exam = put(&folder, &format!("{name}.toml"), format!("{head}{body}"));
        let ran = small(&["check", &exam]).ends(1).complains(words);
        assert!(ran.err.contains(&format!("{name}.toml:{place}")), "{name}: {}", ran.err);
    }
    let inline = put(
        &folder,
        "inline.toml",
        "title = 'T'\nseed = 1\nvariants = 1\nquestion = [{ title = 'A', statement = 'S', part = [{ ask = 'W', key = 3 }] }]\n",
    );
    small(&["check", &inline])
        .ends(1)
        .complains("a header `[[question]]`");
}

#[test]
fn a_warning_about_a_text_refuses_no_sheet() {
    let folder = folder("own-warning");
    let exam = put(
        &folder,
        "exam.toml",
        "title = 'T'\nseed = 1\nvariants = 1\n[[question]]\ntitle = 'A'\nstatement = 'It costs 3 $x'\n\
         [[question.part]]\nask = 'What?'\nkey = '3 m'\n",
    );
    vibank(&["check", &exam])
        .ends(0)
        .complains("text::dollar")
        .complains("exam.toml:6:");
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &exam, "-o", &out])
        .ends(0)
        .complains("text::dollar");
}

#[test]
fn fixed_data_are_no_fault_of_the_variants() {
    let folder = folder("own-fair");
    let exam = put(
        &folder,
        "exam.toml",
        "title = 'T'\nseed = 1\nstudents = 'class.csv'\n[[question]]\ntitle = 'A'\nstatement = 'S'\n\
         [[question.part]]\nask = 'What?'\nkey = '3 m'\n",
    );
    put(&folder, "class.csv", "id,seat\n1,A1\n2,A2\n3,B1\n");
    let out = text_of(&folder.join("out"));
    let ran = vibank(&["sheet", &exam, "-o", &out]).ends(0);
    assert!(!ran.err.contains("not all alike"), "{}", ran.err);
}

#[test]
fn words_that_are_nearly_right_are_named() {
    let folder = folder("nearly");
    let of =
        |question: &str| format!("title = 'T'\nseed = 1\nvariants = 1\n[[question]]\n{question}\n");
    for (name, text, words) in [
        (
            "item",
            of("item = 'free/spring-mas'"),
            "did you mean `free/spring-mass`?",
        ),
        (
            "part",
            of("item = 'free/spring-mass'\nparts = ['omega']"),
            "did you mean `omega_n`?",
        ),
        (
            "set",
            of("item = 'free/spring-mass'\nset = { mm = '2 kg' }"),
            "did you mean `m`?",
        ),
        (
            "topic",
            of("pick = { topic = 'free vibrations' }"),
            "did you mean `free vibration`?",
        ),
        (
            "chapter",
            of("pick = { chapter = 'fre' }"),
            "did you mean `free`?",
        ),
        (
            "kind",
            of("pick = { kind = 'numerik' }"),
            "did you mean `numeric`?",
        ),
        (
            "key",
            of("item = 'free/spring-mass'\npoint = 3"),
            "did you mean `points`?",
        ),
        (
            "format",
            format!("formats = ['htlm']\n{}", of("item = 'free/spring-mass'")),
            "did you mean `html`?",
        ),
        (
            "paper",
            format!("paper = 'a44'\n{}", of("item = 'free/spring-mass'")),
            "did you mean `a4`?",
        ),
    ] {
        let exam = put(&folder, &format!("{name}.toml"), text);
        small(&["check", &exam]).ends(1).complains(words);
    }
    let exam = put(
        &folder,
        "columns.toml",
        blueprint("seed = 1\nstudents = 'class.csv'\ncolumns = { id = 'Cod' }"),
    );
    put(&folder, "class.csv", "Code,Name\n1,A\n");
    small(&["sheet", &exam, "-o", &text_of(&folder.join("out"))])
        .ends(2)
        .complains("did you mean `Code`?");
    vibank(&["chekc"]).ends(2).complains("'check'");
    vibank(&["new", "exm", "x"]).ends(2).complains("'exam'");
    small(&["mark", "free/spring-mass", "omega", "3"])
        .ends(2)
        .complains("did you mean `omega_n`?");
    small(&["show", "free/spring-mas"])
        .ends(2)
        .complains("did you mean `free/spring-mass`?");
}

#[test]
fn every_format_is_one_that_is_written() {
    for format in vibank::worksheet::FORMATS {
        let is_written = vibank::output::writer(format).is_some();
        assert!(
            is_written || ["json", "xlsx"].contains(format),
            "`{format}` is missing in `WRITERS`"
        );
    }
    for writer in vibank::output::WRITERS {
        let name = writer.name();
        let is_named = vibank::worksheet::FORMATS.contains(&name);
        assert!(is_named, "`{name}` is missing in `FORMATS`");
    }
}

#[test]
fn short_options_mean_the_long_ones() {
    let folder = folder("short");
    let exam = put(&folder, "exam.toml", blueprint("seed = 1\nvariants = 1"));
    let out = text_of(&folder.join("out"));
    small(&["sheet", &exam, "-o", &out]).ends(0);
    assert!(folder.join("out/manifest.json").is_file());
    let long = small(&["show", "free/spring-mass", "--seed", "7"]).ends(0);
    let short = small(&["show", "free/spring-mass", "-s", "7"]).ends(0);
    assert_eq!(long.out, short.out);
}

/// A program that runs until the test ends it.
struct Running {
    child: Child,
    _stdin: ChildStdin,
    /// What it says on standard error, line by line.
    said: mpsc::Receiver<String>,
}

impl Running {
    fn start(arguments: &[&str]) -> (Self, String) {
        let mut child = Command::new(env!("CARGO_BIN_EXE_vibank"))
            .args(arguments)
            .env("VIBANK_CACHE", "")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let stdin = child.stdin.take().unwrap();
        let (send, said) = mpsc::channel();
        let errors = BufReader::new(child.stderr.take().unwrap());
        thread::spawn(move || {
            errors
                .lines()
                .map_while(Result::ok)
                .all(|line| send.send(line).is_ok())
        });
        let mut first = String::new();
        if arguments.contains(&"preview") {
            let mut out = BufReader::new(child.stdout.take().unwrap());
            out.read_line(&mut first).unwrap();
        }
        let running = Self {
            child,
            _stdin: stdin,
            said,
        };
        (running, first.trim().to_owned())
    }

    /// Waits for a line that holds these words.
    #[track_caller]
    fn waits_for(&self, words: &str) {
        /// A busy machine may take its time; a program that hangs does not end the suite.
        const MAX_DURATION: Duration = Duration::from_mins(2);
        let mut all = String::new();
        while !all.contains(words) {
            let line = self.said.recv_timeout(MAX_DURATION);
            let line = line.unwrap_or_else(|_| panic!("`{words}` was not said, but:\n{all}"));
            assert!(!line.contains("panicked"), "{line}");
            all.push_str(&line);
            all.push('\n');
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Sends the lines of a request; head and body of the answer.
fn ask(port: &str, lines: &str) -> (String, String) {
    let mut stream = TcpStream::connect(format!("127.0.0.1:{port}")).expect("it listens");
    stream.write_all(lines.as_bytes()).unwrap();
    let mut reply = Vec::new();
    stream.read_to_end(&mut reply).unwrap();
    let reply = String::from_utf8(reply).unwrap();
    let (head, body) = reply.split_once("\r\n\r\n").unwrap_or((&reply, ""));
    (head.to_owned(), body.to_owned())
}

/// The body of what is at an address.
#[track_caller]
fn get(address: &str, path: &str) -> String {
    let rest = address.strip_prefix("http://127.0.0.1:").unwrap();
    let (port, word) = rest.split_once('/').unwrap();
    let request = format!("GET /{word}{path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n");
    let (head, body) = ask(port, &request);
    assert!(head.starts_with("HTTP/1.1 200 OK"), "{path}: {head}");
    assert!(head.contains("default-src 'none'"), "{head}");
    body
}

fn state(address: &str, since: u64) -> serde_json::Value {
    serde_json::from_str(&get(address, &format!("state?variant=0&since={since}"))).unwrap()
}

#[test]
fn a_preview_follows_its_files() {
    let folder = folder("preview");
    let text = blueprint("seed = 1\nvariants = 2\nduration = '1 h 30'");
    let exam = put(&folder, "exam.toml", &text);
    let (program, address) = Running::start(&["preview", &exam, "--bank", super::BANK]);
    let first = state(&address, 0);
    assert_eq!(first["trouble"], serde_json::Value::Null);
    assert_eq!(first["sheet"]["duration_minutes"], 90.0);
    assert_eq!(first["sheet"]["questions"].as_array().unwrap().len(), 3);
    let sheet = get(&address, "worksheet?variant=0");
    assert!(sheet.contains("A test"), "{sheet}");
    assert_ne!(sheet, get(&address, "worksheet?variant=1"));
    assert!(get(&address, "key?variant=0").contains("answer key"));
    assert!(get(&address, "solutions?variant=0").contains("worked solutions"));
    assert!(get(&address, "").contains("preview.js"));
    // It is what a run prints.
    let out = text_of(&folder.join("out"));
    small(&["sheet", &exam, "-o", &out, "--split"]).ends(0);
    let code = first["sheet"]["code"].as_str().unwrap();
    assert_eq!(
        content(folder.join(format!("out/sheets/{code}.html"))),
        sheet
    );

    put(&folder, "exam.toml", text.replace("A test", "Another test"));
    let second = state(&address, first["version"].as_u64().unwrap());
    assert_eq!(second["sheet"]["title"], "Another test");
    program.waits_for("exam.toml has changed");

    put(&folder, "exam.toml", text.replace("seed = 1", "sed = 1"));
    let third = state(&address, second["version"].as_u64().unwrap());
    let trouble = third["trouble"].as_str().unwrap();
    assert!(trouble.contains("exam.toml:2:1"), "{trouble}");
    assert!(trouble.contains("did you mean `seed`?"), "{trouble}");
    // What was shown last stays.
    assert_eq!(third["sheet"]["title"], "Another test");
    program.waits_for("did you mean `seed`?");

    put(&folder, "exam.toml", &text);
    let fourth = state(&address, third["version"].as_u64().unwrap());
    assert_eq!(fourth["trouble"], serde_json::Value::Null);
    assert_eq!(get(&address, "worksheet?variant=0"), sheet);
}

#[test]
fn a_preview_follows_the_bank_and_the_class_list() {
    let folder = folder("preview-bank");
    let bank = folder.join("bank");
    for path in ["bank.toml", "free/_chapter.toml", "free/spring-mass.toml"] {
        put(&bank, path, content(Path::new(super::BANK).join(path)));
    }
    let exam = put(
        &folder,
        "exam.toml",
        "title = 'T'\nseed = 1\nstudents = 'class.csv'\n[[question]]\nitem = 'free/spring-mass'\n",
    );
    put(&folder, "class.csv", "id,name\n1,Ada\n");
    let (_program, address) =
        Running::start(&["preview", &exam, "--bank", &text_of(&bank), "--no-index"]);
    let first = state(&address, 0);
    assert_eq!(first["sheet"]["student"], "1 Ada");
    put(&folder, "class.csv", "id,name\n1,Ada\n2,Emmy\n");
    let second = state(&address, first["version"].as_u64().unwrap());
    assert_eq!(second["sheet"]["count"], 2);
    let item = content(bank.join("free/spring-mass.toml"));
    put(
        &bank,
        "free/spring-mass.toml",
        item.replace("title", "titel"),
    );
    let third = state(&address, second["version"].as_u64().unwrap());
    let trouble = third["trouble"].as_str().unwrap();
    assert!(trouble.contains("free/spring-mass.toml:"), "{trouble}");
    put(&bank, "free/spring-mass.toml", item);
    let fourth = state(&address, third["version"].as_u64().unwrap());
    assert_eq!(fourth["trouble"], serde_json::Value::Null);
}

#[test]
fn a_preview_answers_this_computer_alone() {
    let folder = folder("preview-guard");
    let exam = put(&folder, "exam.toml", blueprint("seed = 1\nvariants = 1"));
    let (_program, address) = Running::start(&["preview", &exam, "--bank", super::BANK]);
    let rest = address
        .strip_prefix("http://127.0.0.1:")
        .expect("it is this computer");
    let (port, word) = rest.split_once('/').unwrap();
    let word = word.trim_end_matches('/');
    assert_eq!(word.len(), 32);
    let own = format!("Host: 127.0.0.1:{port}");
    for (request, status) in [
        (format!("GET /key HTTP/1.1\r\n{own}\r\n\r\n"), "404"),
        (
            format!("GET /{}/key HTTP/1.1\r\n{own}\r\n\r\n", "0".repeat(32)),
            "404",
        ),
        (
            format!("GET /{word}/../key HTTP/1.1\r\n{own}\r\n\r\n"),
            "404",
        ),
        (
            format!("GET /{word}/key HTTP/1.1\r\nHost: example.org\r\n\r\n"),
            "403",
        ),
        (format!("GET /{word}/key HTTP/1.1\r\n\r\n"), "403"),
        (format!("POST /{word}/key HTTP/1.1\r\n{own}\r\n\r\n"), "405"),
        (format!("GET /{word}/key HTTP/1.1\r\nHost\r\n\r\n"), "400"),
        (
            format!("GET /{word}/key?variant=99999999999999999999 HTTP/1.1\r\n{own}\r\n\r\n"),
            "200",
        ),
        (
            format!("GET /{word}/key?variant=77 HTTP/1.1\r\n{own}\r\n\r\n"),
            "200",
        ),
    ] {
        let (head, _) = ask(port, &request);
        assert!(
            head.starts_with(&format!("HTTP/1.1 {status}")),
            "{request}: {head}"
        );
    }
    // What is no request is not answered, and hurts nobody.
    let mut stream = TcpStream::connect(format!("127.0.0.1:{port}")).unwrap();
    stream.write_all(&[0xff; 100]).unwrap();
    drop(stream);
    let endless = format!("GET /{word}/key HTTP/1.1\r\nX: {}", "x".repeat(40_000));
    let mut stream = TcpStream::connect(format!("127.0.0.1:{port}")).unwrap();
    let _ = stream.write_all(endless.as_bytes());
    drop(stream);
    assert!(get(&address, "key").contains("answer key"));
    let (_, taken) = address.rsplit_once("127.0.0.1:").unwrap();
    let taken = taken.split('/').next().unwrap();
    small(&["preview", &exam, "--port", taken])
        .ends(2)
        .complains("cannot listen on port");
    vibank(&["preview", "/nowhere.toml"])
        .ends(2)
        .complains("/nowhere.toml");
}

#[test]
fn a_watching_check_looks_again() {
    let folder = folder("watch");
    let text = blueprint("seed = 1\nvariants = 1");
    let exam = put(&folder, "exam.toml", text.replace("seed", "sed"));
    let (program, _) = Running::start(&["check", "--watch", &exam, "--bank", super::BANK]);
    program.waits_for("did you mean `seed`?");
    program.waits_for("waiting for changes");
    put(&folder, "exam.toml", &text);
    program.waits_for("exam.toml has changed");
    program.waits_for("0 errors, 0 warnings");
    program.waits_for("waiting for changes");
    drop(program);
    vibank(&["check", "--watch", "ch3/e5-log-decrement"])
        .ends(2)
        .complains("there is no file to watch");
}
