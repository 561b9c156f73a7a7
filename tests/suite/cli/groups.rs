//! Groups of blanks: an item whose parts were grouped is asked, marked and found under its old names.
//!
//! `tests/fixtures/groups` has an item of version 0.1.0 with six of its nine parts in three groups.

use std::collections::BTreeMap;

use serde_json::Value as Json;
use vibank::bank::{Catalogue, Template};
use vibank::instance::Instance;
use vibank::numerics::Rational;
use vibank::solution::Solution;
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, Sheet, headings};

use super::{Ran, content, folder, put, text_of, vibank};

const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/0.1.0");
const ITEM: &str = include_str!("../../fixtures/groups/p3-parallel-springs-damper.toml");
const NAME: &str = "ch2/p3-parallel-springs-damper";

/// Identities before and after.
const RENAMED: [(&str, &str); 6] = [
    ("omega_n", "natural.formula"),
    ("omega_n_value", "natural.value"),
    ("zeta", "damping.formula"),
    ("zeta_value", "damping.value"),
    ("omega_d", "damped.omega_d"),
    ("omega_d_value", "damped.value"),
];

fn bank(item: &str) -> Catalogue {
    let about = content(format!("{GOLDEN}/bank/bank.toml"));
    let chapter = content(format!("{GOLDEN}/bank/ch2/_chapter.toml"));
    let path = format!("{NAME}.toml");
    let files = [
        ("bank.toml", about.as_str()),
        ("ch2/_chapter.toml", chapter.as_str()),
        (path.as_str(), item),
    ];
    let (catalogue, findings) = Catalogue::load(files);
    assert!(
        findings.is_empty(),
        "{:?}",
        findings.first().map(ToString::to_string)
    );
    catalogue
}

fn item(catalogue: &Catalogue) -> &Template {
    catalogue.find(NAME).expect("the item is sound")
}

/// The bank of version 0.1.0 with the grouped item in place of the old one, in a folder.
fn grouped_bank(name: &str) -> String {
    let out = folder(name);
    for chapter in std::fs::read_dir(format!("{GOLDEN}/bank")).unwrap() {
        let chapter = chapter.unwrap().path();
        let files: Vec<_> = match std::fs::read_dir(&chapter) {
            Ok(files) => files.map(|file| file.unwrap().path()).collect(),
            Err(_) => vec![chapter],
        };
        for file in files {
            let inner = file.strip_prefix(format!("{GOLDEN}/bank")).unwrap();
            put(&out, inner.to_str().unwrap(), content(&file));
        }
    }
    put(&out, &format!("{NAME}.toml"), ITEM);
    text_of(&out)
}

#[test]
fn a_group_is_one_question_with_a_letter_and_numbered_blanks() {
    let catalogue = bank(ITEM);
    let item = item(&catalogue);
    assert_eq!((item.parts.len(), item.questions()), (9, 6));
    let ids: Vec<&str> = item.parts.iter().map(|part| part.id.as_str()).collect();
    let expected = [
        "k_eq",
        "eom",
        "natural.formula",
        "natural.value",
        "damping.formula",
        "damping.value",
        "damped.omega_d",
        "damped.value",
        "x",
    ];
    assert_eq!(ids, expected);
    let letters = |places: &[usize]| -> Vec<String> {
        let headings = headings(item, places);
        headings.into_iter().map(|own| own.letter).collect()
    };
    let all: Vec<usize> = (0..9).collect();
    assert_eq!(
        letters(&all),
        ["a", "b", "c1", "c2", "d1", "d2", "e1", "e2", "f"]
    );
    // A blank that is asked alone keeps the text of its group before it.
    assert_eq!(letters(&[0, 3, 8]), ["a", "b1", "c"]);
    let alone = headings(item, &[0, 3, 8]);
    assert_eq!(
        alone[1]
            .opened()
            .map(|(letter, group)| (letter, &*group.id)),
        Some(("b", "natural"))
    );
    for (old, new) in RENAMED {
        assert_eq!(item.place(old), item.place(new), "{old}");
        assert!(item.place(old).is_some(), "{old}");
    }
    // The hint of the group is that of each blank; the others have their own.
    let hints = |id: &str| {
        item.part(id)
            .map(|part| (part.hints.len(), part.own_hints().len()))
    };
    assert_eq!(hints("damped.value"), Some((1, 0)));
    assert_eq!(hints("natural.value"), Some((1, 1)));
}

#[test]
fn the_points_of_a_group_are_shared_out_over_its_blanks() {
    let catalogue = bank(ITEM);
    let points = |keys: &str| -> BTreeMap<String, f64> {
        let text = format!(
            "title = \"T\"\nseed = 1\nvariants = 1\n[[question]]\nitem = \"{NAME}\"\n{keys}\n"
        );
        let source = Source::new("sheet.toml", text);
        let blueprint = Blueprint::read(&source).expect("the blueprint is sound");
        let plan = Plan::of(&blueprint, &catalogue, None).expect("it fits the bank");
        let sheet = Sheet::draw(&plan, plan.variant(0, 0), None).expect("it can be drawn");
        let question = &sheet.questions[0];
        assert_eq!(Rational::sum(&question.points), Some(question.total()));
        let parts = &question.solution.template().parts;
        let places = question.parts.iter().map(|place| parts[*place].id.clone());
        places
            .zip(question.points.iter().map(|points| points.to_f64()))
            .collect()
    };
    let of = |points: &BTreeMap<String, f64>, ids: &[&str]| -> Vec<f64> {
        ids.iter().map(|id| points[*id]).collect()
    };
    let pairs = [
        "k_eq",
        "natural.formula",
        "natural.value",
        "damped.omega_d",
        "damped.value",
    ];
    // As the item has them: groups of one and two points, the last with blanks of one to three.
    assert_eq!(of(&points(""), &pairs), [1.0, 0.5, 0.5, 0.5, 1.5]);
    // Eighteen points over questions of weight 1, 1, 1, 2, 2, 2.
    assert_eq!(
        of(&points("points = 18"), &pairs),
        [2.0, 1.0, 1.0, 1.0, 3.0]
    );
    // A group, a blank and a part that was renamed; the names of version 0.1.0 do as well.
    let some = points("parts = [\"k_eq\", \"natural\", \"zeta_value\"]\npoints = 4");
    assert_eq!(
        some,
        points("parts = [\"k_eq\", \"omega_n\", \"omega_n_value\", \"zeta_value\"]\npoints = 4")
    );
    assert_eq!(some.len(), 4);
    let fixed = points("parts = [\"k_eq\", \"natural\"]\npart_points = { natural = 3 }");
    assert_eq!(of(&fixed, &pairs[..3]), [1.0, 1.5, 1.5]);
    let one = points("parts = [\"natural\"]\npart_points = { omega_n = 2 }");
    assert_eq!(of(&one, &pairs[1..3]), [2.0, 0.5]);
}

#[test]
fn what_a_blueprint_says_twice_or_not_at_all_of_a_group_is_refused() {
    let out = folder("groups-refused");
    let bank = grouped_bank("groups-refused-bank");
    let refused = |keys: &str| -> Ran {
        let text = format!(
            "title = \"T\"\nseed = 1\nvariants = 1\n[[question]]\nitem = \"{NAME}\"\n{keys}\n"
        );
        let path = put(&out, "sheet.toml", text);
        vibank(&[
            "sheet",
            &path,
            "--bank",
            &bank,
            "--out",
            &text_of(&out.join("o")),
        ])
        .ends(2)
    };
    refused("part_points = { natural = 3, omega_n = 1 }").complains("twice");
    refused("part_points = { omega_n = 3, \"natural.formula\" = 1 }").complains("twice");
    refused("parts = [\"eom\"]\npart_points = { natural = 3 }").complains("not asked");
    refused("parts = [\"natura\"]").complains("did you mean `natural`?");
}

/// The results of a run of version 0.1.0, by sheet, question and letter.
fn results(path: &str) -> BTreeMap<String, (String, f64)> {
    let rows: Vec<Json> = serde_json::from_str(&content(path)).expect("it is JSON");
    let own = |row: &Json| {
        let place = format!("{} {}{}", row["code"], row["question"], row["part"]);
        let verdict = row["verdict"].as_str().unwrap().to_owned();
        (place, (verdict, row["points"].as_f64().unwrap_or(0.0)))
    };
    rows.iter().map(own).collect()
}

#[test]
fn a_run_of_an_earlier_version_is_marked_with_an_item_that_was_grouped_since() {
    let out = folder("groups-marks");
    let bank = grouped_bank("groups-marks-bank");
    let [manifest, responses] =
        ["manifest.json", "responses.csv"].map(|name| format!("{GOLDEN}/{name}"));
    let to = text_of(&out);
    vibank(&[
        "grade",
        &manifest,
        &responses,
        "--bank",
        &bank,
        "--out",
        &to,
        "--accept-revisions",
    ])
    .ends(0);
    let old = results(&format!("{GOLDEN}/results.json"));
    let new = results(&format!("{to}/results.json"));
    assert!(old.len() > 60, "{}", old.len());
    assert_eq!(old, new);
}

#[test]
fn old_names_are_read_wherever_a_part_is_named() {
    let bank = grouped_bank("groups-mark-bank");
    let mark = |part: &str, response: &str, more: &[&str]| {
        let arguments = [&["mark", NAME, part, response, "--bank", &bank], more].concat();
        vibank(&arguments).out
    };
    for (old, new) in RENAMED {
        for response in ["sqrt((k1 + k2)/m)", "0.05", "1.3 rad/s", "?"] {
            assert_eq!(
                mark(old, response, &[]),
                mark(new, response, &[]),
                "{old} {response}"
            );
        }
    }
    // An earlier answer by its old name is gone on from.
    let wrong = ["--earlier", "omega_n_value=2 rad/s"];
    let again = ["--earlier", "natural.value=2 rad/s"];
    let own = mark("damped.value", "2 rad/s", &wrong);
    assert_eq!(own, mark("omega_d_value", "2 rad/s", &again));
    assert_ne!(own, mark("damped.value", "2 rad/s", &[]));

    let catalogue = self::bank(ITEM);
    let solution = Solution::of(Instance::of(item(&catalogue), None, &[]).unwrap());
    for (old, new) in RENAMED {
        let entry = |id| serde_json::to_value(solution.entry(id, &[])).unwrap();
        assert_eq!(entry(old), entry(new), "{old}");
        assert!(!entry(old).is_null());
    }
}

#[test]
fn a_sheet_of_groups_is_filled_in_and_marked_by_its_letters() {
    let out = folder("groups-sheet");
    let bank = grouped_bank("groups-sheet-bank");
    let blueprint = format!(
        "title = \"T\"\nseed = 1\nvariants = 1\nhints = true\nformats = [\"html\", \"md\", \"json\"]\n[[question]]\nitem = \"{NAME}\"\n"
    );
    let path = put(&out, "sheet.toml", blueprint);
    let to = text_of(&out.join("sheets"));
    vibank(&["sheet", &path, "--bank", &bank, "--out", &to]).ends(0);
    let manifest: Json = serde_json::from_str(&content(format!("{to}/manifest.json"))).unwrap();
    let entry = &manifest["variants"][0];
    let code = entry["code"].as_str().unwrap();
    let page = content(format!("{to}/sheets.html"));
    let shared = "The damped angular frequency";
    for (format, page) in [("html", &page), ("md", &content(format!("{to}/sheets.md")))] {
        assert_eq!(page.matches(shared).count(), 1, "{format}");
        assert_eq!(
            page.matches("Damping slows the oscillation.").count(),
            1,
            "{format}"
        );
        for letter in ["c)", "c1)", "c2)", "e2)", "f)"] {
            assert!(page.contains(letter), "{format} {letter}");
        }
    }
    // One row a sheet, with a column for each blank.
    let parts = entry["questions"][0]["parts"].as_array().unwrap();
    let letters: Vec<&str> = parts
        .iter()
        .map(|part| part["letter"].as_str().unwrap())
        .collect();
    let catalogue = self::bank(ITEM);
    let seed = entry["questions"][0]["seed"].as_u64().unwrap();
    let instance = Instance::of(item(&catalogue), Some(vibank::seed::Seed::new(seed)), &[]);
    let solution = Solution::of(instance.unwrap());
    let value = |part: &str| {
        let entry = serde_json::to_value(solution.entry(part, &[])).unwrap();
        entry["si"].as_f64().unwrap().to_string()
    };
    let keys = [
        "k1 + k2".to_owned(),
        "m x'' + b x' + (k1 + k2) x = 0".to_owned(),
        "sqrt((k1 + k2)/m)".to_owned(),
        format!("{} rad/s", value("natural.value")),
        "b/(2*sqrt((k1 + k2)*m))".to_owned(),
        value("damping.value"),
        "sqrt((k1 + k2)/m - (b/(2*m))^2)".to_owned(),
        format!("{} rad/s", value("damped.value")),
        String::new(),
    ];
    let head: Vec<String> = letters.iter().map(|letter| format!("1{letter}")).collect();
    let row: Vec<String> = keys.iter().map(|key| format!("\"{key}\"")).collect();
    let form = format!("code,{}\n{code},{}\n", head.join(","), row.join(","));
    let form = put(&out, "filled.csv", form);
    let marks = text_of(&out.join("marks"));
    vibank(&[
        "grade",
        &format!("{to}/manifest.json"),
        &form,
        "--bank",
        &bank,
        "--out",
        &marks,
    ])
    .ends(0);
    let marked = results(&format!("{marks}/results.json"));
    assert_eq!(marked.len(), 9);
    let right = marked.values().filter(|(verdict, _)| verdict == "right");
    assert_eq!(right.count(), 8, "{marked:?}");
}

#[test]
fn broken_groups_are_found() {
    let errors = |from: &str, to: &str| -> String {
        assert!(ITEM.contains(from), "{from}");
        let about = content(format!("{GOLDEN}/bank/bank.toml"));
        let chapter = content(format!("{GOLDEN}/bank/ch2/_chapter.toml"));
        let text = ITEM.replacen(from, to, 1);
        let path = format!("{NAME}.toml");
        let files = [
            ("bank.toml", about.as_str()),
            ("ch2/_chapter.toml", chapter.as_str()),
            (path.as_str(), text.as_str()),
        ];
        let (_, findings) = Catalogue::load(files);
        let said = findings.iter().map(ToString::to_string);
        said.collect::<Vec<_>>().join("\n")
    };
    let found = |from: &str, to: &str, words: &str| {
        let said = errors(from, to);
        assert!(said.contains(words), "`{words}` is not in: {said}");
    };
    // A group bears no name that a formula, a part or another group has.
    found(
        "id     = \"natural\"",
        "id     = \"k1\"",
        "already the name",
    );
    found(
        "id     = \"natural\"",
        "id     = \"eom\"",
        "two parts `eom`",
    );
    found(
        "id     = \"damping\"",
        "id     = \"natural\"",
        "two parts `natural`",
    );
    found(
        "id     = \"natural\"",
        "id     = \"a.b\"",
        "cannot be a name",
    );
    found(
        "id       = \"value\"",
        "id       = \"formula\"",
        "two parts `natural.formula`",
    );
    found(
        "was      = \"omega_n_value\"",
        "was      = \"omega_n\"",
        "two parts `omega_n`",
    );
    found(
        "was      = \"omega_n\"",
        "was      = \"eom\"",
        "two parts `eom`",
    );
    found(
        "id     = \"natural\"\n",
        "id     = \"natural\"\nkey    = \"omega_n\"\n",
        "`key`",
    );
    found(
        "text   = 'The natural angular frequency $\\omega_n$ (natural pulsation).'\n",
        "",
        "`text`",
    );
    let single = ITEM
        .split("[[part.blank]]")
        .take(2)
        .collect::<Vec<_>>()
        .join("[[part.blank]]");
    let single = &ITEM[single.len()..];
    let (second, _) = single.split_once("\n[[part]]").unwrap();
    found(second, "", "a group has at least two blanks");
}
