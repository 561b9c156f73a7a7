//! The targets: what is done with an input, and what has to hold of it.
//!
//! All of them ask for no panic and for bounded work, counted in units and not by a clock. What a target saw comes back
//! as a number: inputs of which one saw something new are worth mutating further.

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

use vibank::answer::{Doubt, KeyValue, Verdict};
use vibank::bank::{Catalogue, Compiled, Template, embedded};
use vibank::diagnostic::Finding;
use vibank::document::{Document, Filling, read_math};
use vibank::grade::{Grade, mark};
use vibank::instance::Instance;
use vibank::math::{Display, Voice};
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::source::Source;
use vibank::wasm::Grader;
use vibank::work;
use vibank::worksheet::{Blueprint, Plan, Practice, PracticeQuestion, Sheet};

use crate::packed;

/// All targets.
pub const NAMES: [&str; 10] = [
    "answer",
    "blueprint",
    "class_list",
    "compute",
    "item",
    "manifest",
    "page",
    "responses",
    "text",
    "workbook",
];

/// Units of work that no input may take: some seconds.
const MAX_WORK: u64 = 1_000_000_000;

/// Runs a target on an input; what it saw.
///
/// # Panics
///
/// Where an oracle does not hold, and for names that are no target's.
pub fn run(target: &str, bytes: &[u8]) -> u64 {
    let text = || String::from_utf8_lossy(bytes);
    let seen = work::within(MAX_WORK, || match target {
        "answer" => answer(&text()),
        "blueprint" => blueprint(&text()),
        "class_list" => saw(&vibank::cli::fuzz::class_list(bytes)),
        "compute" => compute(&text()),
        "item" => item(&text()),
        "manifest" => manifest(bytes),
        "page" => page(&text()),
        "responses" => saw(&vibank::cli::fuzz::responses(bytes)),
        "text" => prose(&text()),
        "workbook" => workbook(bytes),
        other => panic!("there is no target `{other}`"),
    });
    assert!(!seen.is_exhausted, "more than {MAX_WORK} units of work");
    // The size of the work is a part of what was seen.
    seen.value ^ u64::from(64 - seen.units.leading_zeros()) << 58
}

/// A number of what was seen: messages by their words, without the numbers in them.
fn saw(what: &impl std::fmt::Debug) -> u64 {
    let mut hash = DefaultHasher::new();
    let words = format!("{what:?}");
    let letters = words.chars().filter(|letter| letter.is_alphabetic());
    letters.take(60).collect::<String>().hash(&mut hash);
    hash.finish()
}

fn seen_in(findings: &[Finding]) -> u64 {
    let mut codes: Vec<_> = findings.iter().map(|finding| finding.code.name()).collect();
    codes.sort_unstable();
    codes.dedup();
    saw(&codes)
}

/// A message's places lie in its file, on the borders of letters, and it can be drawn.
fn places_lie_in(findings: &[Finding]) {
    for finding in findings {
        let text = &finding.source.text;
        for label in finding.labels.iter().filter(|label| !label.span.is_none()) {
            let range = label.span.range();
            assert!(
                range.start <= range.end && range.end <= text.len(),
                "{finding}"
            );
            assert!(
                text.is_char_boundary(range.start) && text.is_char_boundary(range.end),
                "{finding}"
            );
        }
        assert!(!finding.message.trim().is_empty());
        let _ = finding.place();
    }
}

const BANK: (&str, &str) = (
    "bank.toml",
    "format = 1\ntitle = 'Fuzz'\n[topics]\nresonance = 'x'\n",
);
const CHAPTER: (&str, &str) = ("ch1/_chapter.toml", "title = 'One'\nnumber = 1\n");

/// An item: read, drawn, solved, written in all formats.
fn item(text: &str) -> u64 {
    let (catalogue, findings) = Catalogue::load([BANK, CHAPTER, ("ch1/item.toml", text)]);
    places_lie_in(&findings);
    let Some(item) = catalogue.items().next() else {
        return seen_in(&findings);
    };
    let solution = Solution::of(Instance::of_source(item));
    shown(&solution, item);
    if let Ok(instance) = Instance::draw(item, Seed::new(7)) {
        shown(&Solution::of(instance), item);
    }
    // What a page carries of it is the same item.
    let compiled = Compiled::of(item).template();
    assert!(compiled.is_ok(), "{:?}", compiled.err());
    places_lie_in(&vibank::solution::proof::findings(item, 3));
    seen_in(&findings) ^ saw(&item.parts.len())
}

fn shown(solution: &Solution<'_>, item: &Template) {
    let scene = Scene::of(solution, Data::Both);
    let passages = [&item.statement, &item.solution];
    let parts = item.parts.iter();
    for passage in passages
        .into_iter()
        .chain(parts.flat_map(|part| [&part.ask, &part.solution]))
    {
        for piece in scene.passage(passage) {
            written(&piece.document, &piece.fillings);
        }
    }
    for place in 0..item.parts.len() {
        let _ = (scene.key(place), solution.marker(place).is_ok());
    }
}

/// A document in all formats.
fn written(document: &Document, fillings: &Vec<Filling>) {
    let _ = document.html(fillings, Voice::ENGLISH);
    let _ = document.latex(fillings);
    let _ = document.typst(fillings, Voice::ENGLISH);
    let _ = document.markdown(fillings);
    let _ = document.plain(fillings);
}

/// A text of an item, and the same as a formula.
fn prose(text: &str) -> u64 {
    let reading = Document::read(text);
    for error in &reading.errors {
        let (span, words) = (error.span(), error.to_string());
        let range = span.range();
        assert!(
            span.is_none() || range.end <= text.len() && text.is_char_boundary(range.start),
            "{words}"
        );
    }
    written(&reading.document, &Vec::new());
    if let Ok(math) = read_math(text) {
        let _ = (math.mathml(Display::Block, Voice::ENGLISH), math.latex(), math.typst(Display::Block, Voice::ENGLISH));
        let _ = (math.plain(), math.spoken(Voice::ENGLISH));
    }
    saw(&reading.errors.iter().map(ToString::to_string).collect::<Vec<_>>())
}

thread_local! {
    static CATALOGUE: &'static Catalogue =
        Box::leak(Box::new(Catalogue::open(embedded()).0));
    static KINDS: &'static Template = {
        let files = [
            ("bank.toml", "format = 1\ntitle = 'Fuzz'\n"),
            ("kinds/_chapter.toml", "title = 'Kinds'\n"),
            ("kinds/item.toml", include_str!("../../tests/fixtures/kinds/item.toml")),
        ];
        let (catalogue, findings) = Catalogue::load(files);
        let catalogue: &'static Catalogue = Box::leak(Box::new(catalogue));
        catalogue.items().next().unwrap_or_else(|| panic!("{findings:?}"))
    };
    static SOLUTION: Solution<'static> = {
        let solution = Solution::of(Instance::of_source(KINDS.with(|kinds| *kinds)));
        printed_keys_are_right(&solution);
        solution
    };
    static GRADER: Grader = {
        let item = KINDS.with(|kinds| *kinds);
        let practice = Practice {
            program: "fuzz".into(),
            title: "Practice".into(),
            instructions: Document::default(),
            language: "en".into(),
            decimal: '.',
            doubt: Doubt::default(),
            other_form: None,
            data: Data::Both,
            questions: vec![PracticeQuestion::of(item, 0, "Kinds")],
        };
        let lines = practice.lines(&[Compiled::of(item)]);
        Grader::of(&lines).unwrap_or_else(|error| panic!("{error}"))
    };
}

/// A blueprint: read, its items looked up, one sheet drawn.
fn blueprint(text: &str) -> u64 {
    let source = Source::new("blueprint.toml", text);
    let blueprint = match Blueprint::read(&source) {
        Ok(blueprint) => blueprint,
        Err(findings) => {
            places_lie_in(&findings);
            return seen_in(&findings);
        }
    };
    let catalogue = CATALOGUE.with(|catalogue| *catalogue);
    match Plan::of(&blueprint, catalogue, None) {
        Err(findings) => {
            places_lie_in(&findings);
            seen_in(&findings) ^ 1
        }
        Ok(plan) => {
            // A sheet of very many questions is work that is asked for.
            if plan.questions.len() <= 20 {
                let _ = Sheet::draw(&plan, plan.variant(0, 0), None);
            }
            2
        }
    }
}

/// A manifest; one that is read is written and read again as the same.
fn manifest(bytes: &[u8]) -> u64 {
    let read = vibank::cli::fuzz::manifest(bytes);
    if let Ok(manifest) = serde_json::from_slice::<vibank::worksheet::Manifest>(bytes) {
        let again = serde_json::to_vec(&manifest).unwrap_or_default();
        let again = serde_json::from_slice::<vibank::worksheet::Manifest>(&again);
        assert!(again.is_ok_and(|again| again == manifest), "not the same");
    }
    saw(&read)
}

/// A workbook, as a class list and as responses.
fn workbook(bytes: &[u8]) -> u64 {
    let book = packed::archive(bytes);
    let students = vibank::cli::fuzz::class_list(&book);
    saw(&(students, vibank::cli::fuzz::responses(&book)))
}

/// A request of `compute`: the reply is one line of JSON.
fn compute(text: &str) -> u64 {
    let line = text.lines().next().unwrap_or_default();
    let reply = vibank::compute::answer(line);
    assert!(!reply.contains('\n'), "{reply}");
    let json: Result<serde_json::Value, _> = serde_json::from_str(&reply);
    assert!(json.is_ok(), "{reply}");
    saw(&reply)
}

/// A request of a page: the reply is JSON.
fn page(text: &str) -> u64 {
    let reply = GRADER.with(|grader| grader.answer(text));
    let json: Result<serde_json::Value, _> = serde_json::from_str(&reply);
    assert!(json.is_ok(), "{reply}");
    saw(&reply)
}

/// The key of a part, as it is printed, is right.
fn printed_keys_are_right(solution: &Solution<'_>) {
    for place in 0..solution.template().parts.len() {
        let Ok(marker) = solution.marker(place) else {
            continue;
        };
        let key = marker.key();
        let printed = match &key.value {
            KeyValue::Formula { text, .. } => text.clone(),
            _ => key.math.plain(),
        };
        if printed.contains("if ") {
            // A list of cases is for the eye alone.
            continue;
        }
        let marking = mark(solution, place, &printed);
        let id = &solution.template().parts[place].id;
        assert_eq!(marking.verdict, Verdict::Right, "`{printed}` of `{id}`");
    }
}

/// A response: the first byte chooses the part, the rest is what is typed; or all parts, among each other.
///
/// What was read, written and read again, is read in the same way.
fn answer(text: &str) -> u64 {
    SOLUTION.with(|solution| {
        let count = solution.template().parts.len();
        let Some(first) = text.chars().next() else {
            return 0;
        };
        let typed = &text[first.len_utf8()..];
        let place = first as usize % (count + 1);
        if place == count {
            let grade = Grade::mark(solution, (0..count).map(|place| (place, typed)));
            let verdicts = (0..count).map(|place| grade.part(place).map(|part| part.verdict));
            return saw(&verdicts.collect::<Vec<_>>());
        }
        let marking = mark(solution, place, typed);
        if let Some(reading) = &marking.reading {
            let again = mark(solution, place, &reading.text);
            if let Some(again) = &again.reading {
                assert_eq!(again.text, reading.text, "the echo of `{typed}` is read differently");
            }
        }
        saw(&(place, marking.verdict, &marking.reasons()))
    })
}
