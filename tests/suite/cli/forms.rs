//! Sheets as pages on which they are answered, the files that these save, tables of scanners, and make-up exams.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};
use sha2::{Digest, Sha256};

use super::{Ran, blueprint, content, folder, put, small, text_of, vibank};

fn json_of(path: impl AsRef<Path>) -> Json {
    serde_json::from_str(&content(path)).expect("JSON")
}

fn codes(manifest: &Json) -> Vec<String> {
    let variants = manifest["variants"].as_array().expect("a list");
    let code = |own: &Json| own["code"].as_str().expect("a code").to_owned();
    variants.iter().map(code).collect()
}

/// A file of answers as a page saves it.
fn saved(code: &str, answers: &[(usize, &str, &str)]) -> Json {
    let lines = answers.iter();
    let lines = lines.map(|(question, part, response)| format!("{question}{part}\t{response}\n"));
    let summed = format!("{code}\n{}", lines.collect::<String>());
    let sum = Sha256::digest(summed.as_bytes());
    let sum: String = sum.iter().map(|byte| format!("{byte:02x}")).collect();
    let answers = answers.iter();
    let answers: Vec<Json> = answers
        .map(|(question, part, response)| json!({ "question": question, "part": part, "response": response }))
        .collect();
    json!({ "format": "vibank answers 1", "code": code, "title": "T", "sheet": "x", "answers": answers, "sum": sum })
}

struct Exam {
    folder: PathBuf,
    manifest: Json,
    codes: Vec<String>,
}

impl Exam {
    fn new(name: &str) -> Self {
        let folder = folder(name);
        let plan = put(&folder, "test.toml", blueprint("seed = 7\nvariants = 4"));
        small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))]).ends(0);
        let manifest = json_of(folder.join("out/manifest.json"));
        Self {
            codes: codes(&manifest),
            manifest,
            folder,
        }
    }

    /// √(k/m) of the first question, by hand.
    fn omega(&self, variant: usize) -> f64 {
        let values = &self.manifest["variants"][variant]["questions"][0]["values"];
        let datum = |name: &str| -> f64 {
            let text = values[name].as_str().expect("it has the datum");
            let number = text.split(' ').next().unwrap_or_default();
            number.parse().expect("a number")
        };
        (datum("k") / datum("m")).sqrt()
    }

    fn grade(&self, responses: &str) -> Ran {
        let manifest = text_of(&self.folder.join("out/manifest.json"));
        let out = text_of(&self.folder.join("marks"));
        small(&["grade", &manifest, responses, "--out", &out])
    }

    /// The verdicts of part 1a, sheet by sheet.
    fn verdicts(&self) -> Vec<String> {
        let results = json_of(self.folder.join("marks/results.json"));
        let all = results.as_array().expect("a list");
        let of = |code: &String| {
            let found = all
                .iter()
                .find(|own| own["code"] == *code && own["question"] == 1 && own["part"] == "a");
            found.expect("each part has a row")["verdict"]
                .as_str()
                .expect("a word")
                .to_owned()
        };
        self.codes.iter().map(of).collect()
    }
}

#[test]
fn a_folder_of_saved_answers_is_marked_and_what_is_wrong_with_a_file_is_told_by_its_name() {
    let exam = Exam::new("saved");
    let right = |variant: usize| format!("{:.4} rad/s", exam.omega(variant));
    let answers = exam.folder.join("answers");
    let write = |name: &str, file: &Json| put(&answers, name, file.to_string());
    let first = right(0);
    write("a.json", &saved(&exam.codes[0], &[(1, "a", &first)]));
    write("a-again.json", &saved(&exam.codes[0], &[(1, "a", &first)]));
    let second = right(1);
    write(
        "b.json",
        &saved(&exam.codes[1], &[(1, "a", &second), (1, "b", "3 Hz")]),
    );
    write(
        "b-late.json",
        &saved(&exam.codes[1], &[(1, "a", "5 rad/s"), (1, "b", "3 Hz")]),
    );
    let mut changed = saved(&exam.codes[2], &[(1, "a", "1 rad/s")]);
    changed["answers"][0]["response"] = right(2).into();
    write("c.json", &changed);
    write("d.json", &saved("AAA-AAA-AAA", &[(1, "a", "1 rad/s")]));
    write(
        "e.json",
        &saved(&exam.codes[3], &[(9, "z", "1 rad/s"), (1, "a", &right(3))]),
    );
    put(&answers, "notes.txt", "Ask about sheet 3.");
    put(
        &answers,
        "cut.json",
        "{\"format\": \"vibank answers 1\", \"code",
    );
    let ran = exam.grade(&text_of(&answers)).ends(1);
    ran.complains("`a.json` has the same answers")
        .complains("answer sheet")
        .complains("differently, in 1a")
        .complains(&format!(
            "`c.json` was changed after it was saved; its answers to sheet {}",
            exam.codes[2]
        ))
        .complains("`notes.txt` is not a file of answers")
        .complains("`cut.json` cannot be read any more")
        .complains("`e.json`: no part 9z of the sheet");
    // The code of `d.json` has a check character that does not fit, so it is not a code at all.
    assert_eq!(
        exam.verdicts(),
        ["right", "unreadable", "unreadable", "right"]
    );
    // One file alone is taken too, and a sheet of another run is reported.
    let foreign = Exam::new("saved-foreign");
    let other = foreign.codes.iter().find(|code| !exam.codes.contains(code));
    let alone = put(
        &exam.folder,
        "alone.json",
        saved(&exam.codes[0], &[(1, "a", &first)]).to_string(),
    );
    exam.grade(&alone).ends(0).says("1 right");
    if let Some(other) = other {
        let alone = put(
            &exam.folder,
            "other.json",
            saved(other, &[(1, "a", "2 Hz")]).to_string(),
        );
        exam.grade(&alone)
            .ends(1)
            .complains("which is not in this run");
    }
    exam.grade(&text_of(&exam.folder.join("empty")))
        .ends(2)
        .complains("cannot read");
}

#[test]
fn a_sheet_is_a_page_without_its_key() {
    let folder = folder("form");
    let text = "title = 'T'\nseed = 5\nstudents = 'class.csv'\nformats = ['json']\n\
         [[question]]\nitem = 'ch3/e5-log-decrement'\n[[question]]\nitem = 'ch3/t2-pick-the-regime'\n";
    put(
        &folder,
        "class.csv",
        "id,name,format\n1,Ada,screen\n2,Ben,\n",
    );
    let plan = put(&folder, "plan.toml", text);
    let out = folder.join("out");
    vibank(&["sheet", &plan, "--out", &text_of(&out)])
        .ends(0)
        .says("screen/");
    let manifest = json_of(out.join("manifest.json"));
    let codes = codes(&manifest);
    assert!(out.join(format!("screen/{}.html", codes[0])).is_file());
    assert!(!out.join(format!("screen/{}.html", codes[1])).exists());
    let manifest_file = text_of(&out.join("manifest.json"));
    vibank(&["form", &manifest_file]).ends(0).says("2 pages");
    let page = content(out.join(format!("form/{}.html", codes[1])));
    for words in [codes[1].as_str(), "Ben", "<math", "data-question=\"2\""] {
        assert!(page.contains(words), "{words}");
    }
    // The answers of the sheet are nowhere on it.
    let row = content(out.join("sheets.jsonl"));
    let row: Json = serde_json::from_str(row.lines().nth(1).expect("a line")).expect("JSON");
    let parts = row["questions"][0]["parts"].as_array().expect("a list");
    assert!(parts.len() > 1);
    for words in ["feedback", "tolerance", "right\\\":true", "mistakes"] {
        let carried = page.split("id=\"form\">").nth(1).expect("the form");
        let carried = carried.split("</script>").next().expect("its end");
        assert!(!carried.contains(words), "{words}");
    }
    vibank(&["form", &manifest_file, "--code", "XXX"])
        .ends(2)
        .complains("the run has no sheet XXX");
    vibank(&["form", &plan])
        .ends(2)
        .complains("make the sheets with");
    vibank(&["forget", &text_of(&out), "1"]).ends(0);
    assert!(!out.join(format!("screen/{}.html", codes[0])).exists());
}

/// Tables as the sources of scanners write them; none is the file of a scanned exam.
/// Questions of a blueprint were taken as they are typed, since what read them had no data.
#[test]
fn answers_to_questions_of_ones_own_are_read_and_their_keys_are_not_told() {
    let folder = folder("own-form");
    let question = "title = 'T'\nseed = 3\nvariants = 1\n[[question]]\ntitle = 'A swing'\n\
        statement = 'A swing of << m >> turns.'\nparameters = { m = '2 kg' }\n\
        [[question.part]]\nask = 'Find its frequency.'\nkey = '0.4317 Hz'\n\
        [[question.part]]\nask = 'Find its weight.'\nkey = 'm*9.8123[m/s^2]'\nunit = 'N'\n\
        [[question.part]]\nkind = 'work'\nask = 'Draw it.'\nrubric = [{ points = 1, text = 'All' }]\n";
    let plan = put(&folder, "t.toml", question);
    let out = text_of(&folder.join("out"));
    small(&["sheet", &plan, "--out", &out]).ends(0);
    let ran = small(&["form", &out]).ends(0);
    assert_eq!(ran.err, "");
    let manifest = json_of(folder.join("out/manifest.json"));
    let page = content(folder.join(format!("out/form/{}.html", codes(&manifest)[0])));
    for reported in ["0.4317", "9.8123"] {
        assert!(!page.contains(reported), "{reported}");
    }
}

#[test]
fn the_tables_of_scanners_are_read_by_their_headings() {
    let folder = folder("scanners");
    put(&folder, "class.csv", "id,name\n0017,Ada\n23,Ben\n42,Cleo\n");
    let question = |item: &str| format!("[[question]]\nitem = '{item}'\n");
    let text = "title = 'T'\nseed = 5\nstudents = 'class.csv'\nformats = ['json']\n".to_owned();
    let items = ["ch3/t2-pick-the-regime", "ch1/t1-dof-chains-and-frames"];
    let plan = put(&folder, "plan.toml", text + &items.map(question).concat());
    let out = folder.join("out");
    vibank(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let manifest = json_of(out.join("manifest.json"));
    let sheets = manifest["variants"].as_array().expect("a list");
    // The choices of each sheet in order, with what is printed for each option.
    let choices = |sheet: &Json| -> Vec<(String, usize)> {
        let questions = sheet["questions"].as_array().expect("a list").iter();
        let parts = questions.flat_map(|question| {
            let number = question["number"].as_u64().expect("a number");
            let parts = question["parts"].as_array().expect("a list").clone();
            parts.into_iter().filter_map(move |part| {
                let options = part["options"].as_array()?.len();
                Some((format!("{number}{}", part["letter"].as_str()?), options))
            })
        });
        parts.collect()
    };
    let codes = codes(&manifest);
    let count = choices(&sheets[0]).len();
    assert!(count >= 1, "the sheet has a choice");
    let place = choices(&sheets[0])[0].0.clone();
    let given = |name: &str, table: &str| -> BTreeMap<String, String> {
        let form = put(&folder, name, table);
        let marks = folder.join("marks");
        vibank(&[
            "grade",
            &text_of(&out.join("manifest.json")),
            &form,
            "--out",
            &text_of(&marks),
        ]);
        let results = json_of(marks.join("results.json"));
        let all = results.as_array().expect("a list").iter();
        let own = all.filter(|own| {
            format!(
                "{}{}",
                own["question"],
                own["part"].as_str().unwrap_or_default()
            ) == place
        });
        own.map(|own| {
            let text = |name: &str| own[name].as_str().unwrap_or_default().to_owned();
            (text("code"), text("response"))
        })
        .collect()
    };
    let expected = |responses: [&str; 3]| -> BTreeMap<String, String> {
        let responses = responses.map(str::to_owned);
        codes.iter().cloned().zip(responses).collect()
    };
    let amc = "\"A:id\",\"Name\",\"Mark\",\"q1\",\"TICKED:q1\"\n\"17\",\"Ada\",\"3\",1,\"B\"\n\"0023\",\"Ben\",\"2\",0,\"AC\"\n\"42\",\"Cleo\",\"0\",0,\"\"\n";
    assert_eq!(given("amc.csv", amc), expected(["b", "a, c", ""]));
    let omr = "file_id,input_path,output_path,score,Roll,q1\nx.png,in/x.png,out/x.png,0,0017,B\ny.png,in/y.png,out/y.png,0,23,AC\nz.png,in/z.png,out/z.png,0,42,\n";
    assert_eq!(given("omr.csv", omr), expected(["b", "a, c", ""]));
    let form_scanner = format!(
        "File name;Block.question1\n17.jpg;B\n{}.jpg;A|C\n42;\n",
        codes[1]
    );
    assert_eq!(given("fs.csv", &form_scanner), expected(["b", "a, c", ""]));
    let form = put(
        &folder,
        "odd.csv",
        format!("Roll,q1,q{}\n17,B,\n99,A,\n23,A,C\n", count + 1),
    );
    vibank(&["grade", &text_of(&out.join("manifest.json")), &form])
        .ends(1)
        .complains("row 3: no sheet of `99` was handed out")
        .complains(&format!(
            "row 4: `q{}` has an answer, and the sheet {}",
            count + 1,
            codes[1]
        ));
}

#[test]
fn a_make_up_has_no_datum_of_the_first_sheet() {
    let folder = folder("make-up");
    put(&folder, "class.csv", "id,name\ns1,Ada\ns2,Ben\ns3,Cleo\n");
    let plan = put(
        &folder,
        "exam.toml",
        blueprint("seed = 9\nstudents = 'class.csv'"),
    );
    let first = folder.join("exam");
    small(&["sheet", &plan, "--out", &text_of(&first)]).ends(0);
    let manifest = text_of(&first.join("manifest.json"));
    let out = folder.join("again");
    let make_up = |students: &str| {
        let out = text_of(&out);
        small(&[
            "sheet",
            &plan,
            "--make-up",
            students,
            "--first",
            &manifest,
            "--out",
            &out,
        ])
    };
    make_up("s3,s1").ends(0).says("2 sheets");
    let of = |folder: &Path| -> BTreeMap<String, Json> {
        let manifest = json_of(folder.join("manifest.json"));
        let variants = manifest["variants"].as_array().expect("a list").clone();
        let id = |own: &Json| own["student"]["id"].as_str().expect("an id").to_owned();
        variants.into_iter().map(|own| (id(&own), own)).collect()
    };
    let (before, after) = (of(&first), of(&out));
    assert_eq!(
        after.keys().map(String::as_str).collect::<Vec<_>>(),
        ["s1", "s3"]
    );
    let mut compared = 0;
    for (id, sheet) in &after {
        for (place, question) in sheet["questions"]
            .as_array()
            .expect("a list")
            .iter()
            .enumerate()
        {
            let earlier = &before[id]["questions"][place];
            assert_eq!(earlier["item"], question["item"]);
            for (name, value) in question["values"].as_object().expect("values") {
                assert_ne!(&earlier["values"][name], value, "{id} {name}");
                compared += 1;
            }
        }
    }
    assert!(compared > 10, "{compared} data");
    // The same command gives the same bytes.
    let bytes = content(out.join("manifest.json"));
    fs::remove_dir_all(&out).expect("it can be removed");
    make_up("s1,s3").ends(0);
    assert_eq!(content(out.join("manifest.json")), bytes);
    make_up("s9")
        .ends(2)
        .complains("no student `s9`")
        .complains("did you mean");
    make_up("Ada").ends(2).complains("named by the id `s1`");
    // The sheets of the class would be gone.
    let (sheets, inside) = (content(first.join("sheets.html")), text_of(&first));
    let in_place = ["--make-up", "s1", "--first", &manifest, "--out", &inside];
    small(&[&["sheet", &plan], &in_place[..]].concat())
        .ends(2)
        .complains("has the sheets of the first run")
        .complains("a folder of its own");
    assert_eq!(content(first.join("sheets.html")), sheets);
    small(&[
        "sheet",
        &plan,
        "--make-up",
        "s1",
        "--first",
        &text_of(&folder.join("none.json")),
    ])
    .ends(2)
    .complains("--first");
    // Where a datum is one of two, and the other is barred, there is nothing left.
    let item = "[item]\ntitle = 'A'\nsource = 'S'\nallow = ['single-route']\n[parameters]\nf = { value = '2 Hz', range = '2 .. 3 Hz', step = '1 Hz' }\ng = { value = '2 Hz', range = '2 .. 3 Hz', step = '1 Hz' }\n[constraints]\nsame = 'f == g or f > g'\nleast = 'f + g > 4.5[Hz]'\n[statement]\ntext = 'X'\n[[part]]\nid = 'sum'\nkey = 'f + g'\nunit = 'Hz'\nask = 'Y'\n";
    put(&folder, "bank/bank.toml", "format = 1\ntitle = 'T'");
    put(&folder, "bank/c/_chapter.toml", "title = 'C'");
    put(&folder, "bank/c/a.toml", item);
    let bank = text_of(&folder.join("bank"));
    let plan = put(
        &folder,
        "narrow.toml",
        "title = 'T'\nseed = 1\nstudents = 'class.csv'\nformats = ['json']\n[[question]]\nitem = 'c/a'\n",
    );
    let narrow = text_of(&folder.join("narrow"));
    vibank(&["sheet", &plan, "--bank", &bank, "--out", &narrow]).ends(0);
    vibank(&[
        "sheet",
        &plan,
        "--bank",
        &bank,
        "--make-up",
        "s1",
        "--first",
        &text_of(&folder.join("narrow/manifest.json")),
        "--out",
        &text_of(&folder.join("narrow-again")),
    ])
    .ends(2)
    .complains("that the first sheet does not have")
    .complains("of c/a is the same")
    .complains("widen its range");
}
