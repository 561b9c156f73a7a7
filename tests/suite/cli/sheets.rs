//! `vibank sheet`: what it writes, and that the same input gives the same bytes.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use super::{BANK, blueprint, content, folder, put, small, text_of, vibank};

/// All files of a folder with their bytes.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be listed").path();
        let name = path
            .file_name()
            .expect("it has a name")
            .to_string_lossy()
            .into_owned();
        if path.is_dir() {
            let inner = files(&path).into_iter();
            found.extend(inner.map(|(inside, text)| (format!("{name}/{inside}"), text)));
        } else {
            found.insert(name, content(&path));
        }
    }
    found
}

#[test]
fn a_run_writes_sheets_keys_solutions_form_and_manifest() {
    let folder = folder("sheet");
    let top = "seed = 7\nvariants = 30\nformats = [\"html\", \"md\", \"json\"]";
    let plan = put(&folder, "test.toml", blueprint(top));
    let out = folder.join("out");
    small(&["sheet", &plan, "--out", &text_of(&out)])
        .ends(0)
        .says("30 sheets of 3 questions");
    let files = files(&out);
    let names: Vec<&str> = files.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        [
            "fairness.html",
            "key-table.html",
            "key-table.md",
            "keys.html",
            "keys.md",
            "manifest.json",
            "responses.csv",
            "sheets.html",
            "sheets.jsonl",
            "sheets.md",
            "solutions.html",
            "solutions.md",
        ]
    );
    assert_eq!(files["sheets.jsonl"].lines().count(), 30);
    // Seven parts a sheet, and the header.
    assert_eq!(files["responses.csv"].lines().count(), 30 * 7 + 1);
    let manifest: serde_json::Value =
        serde_json::from_str(&files["manifest.json"]).expect("the manifest is JSON");
    let variants = manifest["variants"].as_array().expect("it has variants");
    assert_eq!(variants.len(), 30);
    for variant in variants {
        let code = variant["code"].as_str().expect("each has a code");
        for page in [
            "sheets.html",
            "sheets.md",
            "keys.html",
            "solutions.html",
            "key-table.html",
        ] {
            assert!(files[page].contains(code), "{code} is not in {page}");
        }
    }
    for page in ["sheets.html", "keys.html", "solutions.html"] {
        let text = &files[page];
        assert!(
            text.starts_with("<!") && text.trim_end().ends_with("</html>"),
            "{page}"
        );
        assert!(!text.contains("<script"), "{page} runs nothing");
        assert!(
            !text.contains("http://") || text.contains("w3.org"),
            "{page} loads nothing"
        );
    }
}

#[test]
fn no_two_variants_are_equal() {
    let folder = folder("distinct");
    let plan = put(&folder, "test.toml", blueprint("seed = 1\nvariants = 60"));
    let out = folder.join("out");
    small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let manifest: serde_json::Value =
        serde_json::from_str(&content(out.join("manifest.json"))).expect("it is JSON");
    let variants = manifest["variants"].as_array().expect("it has variants");
    for question in 0..3 {
        let mut values: Vec<String> = variants
            .iter()
            .map(|variant| variant["questions"][question]["values"].to_string())
            .collect();
        values.sort();
        values.dedup();
        assert_eq!(values.len(), variants.len(), "question {question}");
    }
}

#[test]
fn the_same_input_gives_the_same_bytes_with_any_number_of_threads() {
    let folder = folder("same");
    let top = "seed = 2026\nvariants = 80\nshuffle = true\nformats = [\"html\", \"md\", \"json\"]";
    let plan = put(&folder, "test.toml", blueprint(top));
    let made = |name: &str, more: &[&str]| {
        let out = folder.join(name);
        small(&[&["sheet", &plan, "--out", &text_of(&out)], more].concat()).ends(0);
        files(&out)
    };
    let first = made("first", &["--threads", "1"]);
    assert_eq!(first, made("second", &["--threads", "2"]));
    assert_eq!(first, made("third", &[]));
    let split = made("split", &["--split", "--threads", "2"]);
    assert_eq!(
        split
            .keys()
            .filter(|name| name.starts_with("sheets/"))
            .count(),
        2 * 80
    );
    assert_eq!(split, made("split-again", &["--split", "--threads", "1"]));
}

#[test]
fn another_seed_gives_other_sheets() {
    let folder = folder("seeds");
    let codes = |seed: &str| {
        let plan = put(
            &folder,
            "test.toml",
            blueprint(&format!("variants = 5\n{seed}")),
        );
        let out = folder.join("out");
        small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
        content(out.join("responses.csv"))
    };
    assert_ne!(codes("seed = 1"), codes("seed = 2"));
}

#[test]
fn a_secret_file_keys_the_seeds() {
    let folder = folder("secret");
    put(&folder, "one.key", "0123456789abcdef0123456789abcdef");
    put(&folder, "two.key", "fedcba9876543210fedcba9876543210");
    let run = |name: &str, secret: &str| {
        let top = format!("variants = 3\nsecret = \"{secret}\"");
        let plan = put(&folder, "test.toml", blueprint(&top));
        let out = folder.join(name);
        small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
        out
    };
    let (one, again, two) = (
        run("1", "one.key"),
        run("1b", "one.key"),
        run("2", "two.key"),
    );
    assert_eq!(files(&one), files(&again));
    let values = |out: &Path| {
        let manifest: serde_json::Value =
            serde_json::from_str(&content(out.join("manifest.json"))).expect("it is JSON");
        assert_eq!(manifest["keyed"], true);
        manifest["variants"][0]["questions"].to_string()
    };
    assert_ne!(values(&one), values(&two));
    let plan = put(
        &folder,
        "test.toml",
        blueprint("variants = 3\nsecret = \"none.key\""),
    );
    small(&["sheet", &plan]).ends(2).complains("none.key");
    put(&folder, "short.key", "1234");
    let plan = put(
        &folder,
        "test.toml",
        blueprint("variants = 3\nsecret = \"short.key\""),
    );
    small(&["sheet", &plan]).ends(2).complains("short.key");
}

#[test]
fn a_code_shows_its_sheet_with_the_manifest() {
    let folder = folder("codes");
    let plan = put(&folder, "test.toml", blueprint("seed = 3\nvariants = 2"));
    let out = folder.join("out");
    small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let form = content(out.join("responses.csv"));
    let code = form
        .lines()
        .nth(1)
        .and_then(|line| line.split(',').next())
        .expect("it has rows");
    let manifest = text_of(&out.join("manifest.json"));
    let shown = small(&["show", code, "--manifest", &manifest, "--key"]).ends(0);
    let shown = shown.says("Question 3").says("Half cycles of a block");
    let data: serde_json::Value = serde_json::from_str(&content(&manifest)).expect("it is JSON");
    let mass = data["variants"][0]["questions"][0]["values"]["m"]
        .as_str()
        .expect("it has m");
    let shown = shown.says(&format!("m = {mass}"));
    small(&["show", code])
        .ends(2)
        .complains("--manifest FOLDER/manifest.json");
    let drawn = small(&["show", code, "--blueprint", &plan, "--key"]).ends(0);
    assert_eq!(
        drawn.out, shown.out,
        "blueprint and manifest give the same sheet"
    );
    let slipped = format!(
        "{}{}",
        if code.starts_with('A') { "B" } else { "A" },
        &code[1..]
    );
    small(&["show", &slipped, "--manifest", &manifest]).ends(2);
}

#[test]
fn a_class_list_gives_each_student_a_sheet() {
    let folder = folder("class");
    let list = "id,name,group,colour\n\
        17,\"Noether, Emmy\",A,red\n\
        18,\"<script>alert(1)</script>\",B,\n\
        19,\"a \"\"quoted\"\"\nname\",B,\n";
    put(&folder, "class.csv", list);
    let plan = put(
        &folder,
        "test.toml",
        blueprint("seed = 5\nstudents = \"class.csv\"\nformats = [\"html\", \"md\"]"),
    );
    let out = folder.join("out");
    small(&["sheet", &plan, "--out", &text_of(&out)])
        .ends(0)
        .says("3 sheets");
    let page = content(out.join("sheets.html"));
    assert!(page.contains("Noether, Emmy"));
    assert!(!page.contains("<script"), "a name stays text");
    assert!(page.contains("&lt;script&gt;"));
    assert!(
        !content(out.join("sheets.md")).contains("<script>"),
        "a name stays text in Markdown"
    );
    let manifest: serde_json::Value =
        serde_json::from_str(&content(out.join("manifest.json"))).expect("it is JSON");
    assert_eq!(manifest["variants"][0]["student"]["colour"], "red");
    assert_eq!(
        manifest["variants"][2]["student"]["name"],
        "a \"quoted\" name"
    );
    assert!(
        content(out.join("responses.csv"))
            .lines()
            .nth(1)
            .is_some_and(|row| row.contains(",17,"))
    );
}

#[test]
fn a_blueprint_that_asks_for_what_is_not_there_is_refused_with_its_place() {
    let folder = folder("refused");
    let refused = |text: &str| {
        let plan = put(&folder, "test.toml", text);
        small(&["sheet", &plan]).ends(2)
    };
    refused("seed = 1\nvariants = 1\n").complains("title");
    refused(&blueprint("seed = 1\nvariants = 1").replace("spring-mass", "spring-mas"))
        .complains("test.toml:5:")
        .complains("did you mean `free/spring-mass`?");
    refused(&blueprint("seed = 1\nvariants = 0")).complains("variants");
    refused(&blueprint("seed = 1\nvariants = 1\nformats = [\"docx\"]")).complains("docx");
    refused(&blueprint("seed = 1\nvariant = 1")).complains("did you mean `variants`?");
    // What is refused late, by the layouts, leaves no empty folder either.
    let plan = put(&folder, "test.toml", blueprint("seed = 1\nvariants = 1"));
    let (layouts, out) = (folder.join("none"), folder.join("out"));
    let more = ["--out", &text_of(&out), "--layouts", &text_of(&layouts)];
    small(&[&["sheet", &plan][..], &more].concat())
        .ends(2)
        .complains("there is no folder");
    assert!(!out.exists(), "a refused run made its folder");
    let _ = vibank(&["sheet", "/dev/null", "--bank", BANK]).ends(2);
}

/// When each file of a folder was written.
fn times(folder: &Path) -> BTreeMap<String, std::time::SystemTime> {
    let names = files(folder).into_keys();
    let time = |name: &String| {
        let file = fs::metadata(folder.join(name)).expect("the file is there");
        file.modified().expect("the system keeps times")
    };
    names.map(|name| (name.clone(), time(&name))).collect()
}

#[test]
fn a_run_that_was_killed_is_gone_on_with() {
    let folder = folder("killed");
    let top = "seed = 11\nvariants = 250\nformats = [\"html\", \"json\"]";
    let plan = put(&folder, "test.toml", blueprint(top));
    let whole = folder.join("whole");
    small(&["sheet", &plan, "--out", &text_of(&whole)]).ends(0);
    for more in [&[][..], &["--split"]] {
        let out = folder.join(if more.is_empty() { "out" } else { "split" });
        let place = text_of(&out);
        let arguments = [&["sheet", &plan, "--out", &place, "--bank", BANK], more].concat();
        let mut child = Command::new(env!("CARGO_BIN_EXE_vibank"))
            .args(&arguments)
            .env("VIBANK_CACHE", "")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        let ledger = out.join(".sheet.run");
        // The first line says that nothing is done yet; it takes about a hundred bytes.
        let has_begun = || fs::metadata(&ledger).is_ok_and(|ledger| ledger.len() > 200);
        while !has_begun() && child.try_wait().expect("it can be asked").is_none() {
            // Often enough to catch it between two chunks, and the child has the core.
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        let _ = child.kill();
        child.wait().expect("it ends");
        assert!(
            !out.join("manifest.json").exists(),
            "the manifest is the last file, and was there before the run was killed"
        );
        vibank(&arguments).ends(0).says("250 sheets");
        let found = files(&out);
        assert!(
            !found
                .keys()
                .any(|name| name.contains("/.") || name.starts_with('.'))
        );
        if more.is_empty() {
            assert_eq!(found, files(&whole));
        } else {
            let direct = folder.join("split-whole");
            small(&[&["sheet", &plan, "--out", &text_of(&direct)], more].concat()).ends(0);
            assert_eq!(found, files(&direct));
        }
    }
}

#[test]
fn what_would_come_out_the_same_is_left_as_it_is() {
    let folder = folder("unchanged");
    let run = |count: usize, more: &[&str]| {
        let top = format!("seed = 4\nvariants = {count}");
        let plan = put(&folder, "test.toml", blueprint(&top));
        let out = text_of(&folder.join("out"));
        small(&[&["sheet", &plan, "--out", &out], more].concat()).ends(0)
    };
    let out = folder.join("out");
    run(5, &["--split"]);
    let (first, made) = (times(&out), files(&out));
    run(5, &["--split"]).complains("5 sheets unchanged");
    assert_eq!(times(&out), first, "nothing was written");

    // A sheet that is lost is made again, and no other.
    let lost = made.keys().find(|name| name.starts_with("sheets/"));
    let lost = lost.expect("there are sheets");
    fs::remove_file(out.join(lost)).expect("it is there");
    run(5, &["--split"]).complains("4 sheets unchanged");
    assert_eq!(files(&out), made);
    let again = times(&out);
    let kept = made
        .keys()
        .filter(|name| name.contains('/') && !name.contains(&lost[7..18]));
    assert_eq!(kept.clone().count(), 4 * 3);
    for name in kept {
        assert_eq!(again[name], first[name], "{name} was written again");
    }

    // Further variants leave the first ones alone; fewer leave nothing behind.
    run(7, &["--split"]).complains("5 sheets unchanged");
    run(5, &["--split"]).complains("5 sheets unchanged");
    let mut left = files(&out);
    left.retain(|name, _| !name.starts_with("manifests/"));
    assert_eq!(left, made);

    // A form that was filled in is no reason to make the sheets again.
    put(&out, "responses.csv", "filled in");
    run(5, &["--split"]).complains("5 sheets unchanged");
    assert_eq!(content(out.join("responses.csv")), "filled in");

    // Another layout makes all of them again.
    put(
        &folder,
        "own/html/end.html",
        "</body>\n</html>\n<!-- own -->\n",
    );
    let layouts = text_of(&folder.join("own"));
    let ran = run(5, &["--split", "--layouts", &layouts, "--force"]);
    assert!(!ran.err.contains("sheets unchanged"), "{}", ran.err);
}

#[test]
fn shards_merge_into_one_folder() {
    let folder = folder("shards");
    let top = "seed = 21\nvariants = 90\nformats = [\"html\", \"md\"]";
    let plan = put(&folder, "test.toml", blueprint(top));
    let out = text_of(&folder.join("out"));
    for (shard, count) in [("3/4", 22), ("1/4", 22), ("4/4", 23), ("2/4", 23)] {
        let ran = small(&["sheet", &plan, "--out", &out, "--shard", shard]).ends(0);
        ran.says(&format!("{count} sheets"));
    }
    small(&["sheet", &plan, "--out", &out, "--split"])
        .ends(0)
        .complains("90 sheets unchanged");
    let direct = folder.join("direct");
    small(&["sheet", &plan, "--out", &text_of(&direct), "--split"]).ends(0);
    assert_eq!(files(&folder.join("out")), files(&direct));
    for wrong in ["0/4", "5/4", "x"] {
        small(&["sheet", &plan, "--shard", wrong])
            .ends(2)
            .complains("--shard");
    }
}

#[test]
fn a_folder_that_another_run_writes_to_is_left_to_it() {
    let folder = folder("locked");
    let plan = put(&folder, "test.toml", blueprint("seed = 1\nvariants = 1"));
    let ledger = put(&folder, "out/.sheet.run", "");
    let held = fs::File::open(&ledger).expect("the ledger is there");
    held.lock().expect("it can be locked");
    small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))])
        .ends(2)
        .complains("another run");
    held.unlock().expect("it can be unlocked");
    small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))]).ends(0);
}

#[test]
fn a_run_sums_itself_up_for_programs() {
    let folder = folder("summary");
    let plan = put(&folder, "test.toml", blueprint("seed = 1\nvariants = 2"));
    let out = text_of(&folder.join("out"));
    let ran = small(&["sheet", &plan, "--out", &out, "--format", "json"]).ends(0);
    let summary = &ran.lines()[0];
    assert_eq!(
        (&summary["sheets"], &summary["questions"]),
        (&2.into(), &3.into())
    );
    let files = summary["files"].as_array().expect("it lists files");
    assert!(files.contains(&"manifest.json".into()));
}

#[test]
fn neighbours_share_no_data_and_no_answer() {
    let folder = folder("seats");
    let seats = (1..=3).flat_map(|row| (1..=6).map(move |place| format!("{row}-{place}")));
    let rows = seats
        .enumerate()
        .map(|(id, seat)| format!("{id},Name {id},{seat}\n"));
    put(
        &folder,
        "class.csv",
        format!("id,name,seat\n{}", rows.collect::<String>()),
    );
    let top = "seed = 9\nstudents = \"class.csv\"\nformats = [\"md\"]";
    let plan = put(&folder, "test.toml", blueprint(top));
    let out = text_of(&folder.join("out"));
    let ran = small(&["sheet", &plan, "--out", &out, "--format", "json"]).ends(0);
    let fairness = &ran.lines()[0]["fairness"];
    // Three rows of six: 15 pairs side by side, 12 behind each other, 20 across a corner.
    assert_eq!(fairness["neighbours"], 47);
    assert_eq!(fairness["alike_neighbours"], 0);
    for question in fairness["questions"].as_array().expect("it has questions") {
        assert_eq!(question["repeats"], 0);
        let items = question["items"].as_object().expect("it has items");
        assert!(
            items
                .values()
                .all(|item| item["parts"][0] == item["parts"][1])
        );
        let answers = items
            .values()
            .filter_map(|item| item["answers"].as_object());
        for range in answers.flat_map(serde_json::Map::values) {
            let (least, most) = (range["least"].as_f64(), range["most"].as_f64());
            assert!(most <= least.map(|least| least * 100.0), "{range}");
        }
    }
    let page = content(folder.join("out/fairness.md"));
    assert!(
        page.contains("47 pairs of students sit beside each other"),
        "{page}"
    );
    // A draw that was passed over leaves no file.
    let split = text_of(&folder.join("split"));
    small(&["sheet", &plan, "--out", &split, "--split"]).ends(0);
    for kind in ["sheets", "keys", "solutions"] {
        assert_eq!(files(&folder.join("split").join(kind)).len(), 18);
    }
}

#[test]
fn the_schema_of_blueprints_has_the_keys_that_are_read() {
    let schema = &vibank(&["schema", "blueprint"]).ends(0).out;
    let schema: serde_json::Value = serde_json::from_str(schema).expect("a schema is JSON");
    let keys = |schema: &serde_json::Value| {
        let keys = schema["properties"].as_object().expect("it has properties");
        keys.keys().cloned().collect::<Vec<_>>()
    };
    let question = &schema["properties"]["question"]["items"];
    let places = [
        (keys(&schema), "", ""),
        (keys(question), "[[question]]\n", ""),
        (keys(&schema["properties"]["print"]), "[print]\n", ""),
        (
            keys(&schema["properties"]["columns"]),
            "students = 'class.csv'\ncolumns = { ",
            " }",
        ),
        (keys(&schema["properties"]["marks"]), "[marks]\n", ""),
        (
            keys(&question["properties"]["pick"]),
            "[[question]]\npick = { ",
            " }",
        ),
    ];
    let folder = folder("schema");
    for (keys, before, after) in places {
        for key in keys {
            // A value of the wrong kind: what matters is that the key is known.
            let plan = put(
                &folder,
                "plan.toml",
                format!("{before}{key} = 1979-05-27{after}\n"),
            );
            let alone = small(&["sheet", &plan]).ends(2);
            // A statement that is no text makes no question of one's own; what else belongs to one is read after it.
            if !alone.err.contains("unknown") || key == "statement" {
                continue;
            }
            // Some keys belong to questions of one's own, which have a statement.
            let own = format!("{before}statement = 'S'\n{key} = 1979-05-27{after}\n");
            let plan = put(&folder, "plan.toml", own);
            let ran = small(&["sheet", &plan]).ends(2);
            assert!(!ran.err.contains("unknown"), "{key}: {}", ran.err);
        }
    }
    let plan = put(
        &folder,
        "plan.toml",
        "[[question]]\npick = { chapters = \"a\" }\n",
    );
    small(&["sheet", &plan])
        .ends(2)
        .complains("did you mean `chapter`?");
    // The file that begins a blueprint names them all.
    let begun = include_str!("../../../templates/new/sheet.toml");
    let print = keys(&schema["properties"]["print"]);
    for key in keys(&schema).iter().chain(&keys(question)).chain(&print) {
        assert!(begun.contains(key.as_str()), "{key}");
    }
}

#[test]
fn a_formula_sheet_has_the_formulas_of_the_chapters() {
    let folder = folder("formulas");
    let text = "title = \"T\"\nseed = 1\nvariants = 2\nformula_sheet = true\n\
                formats = [\"html\", \"md\"]\n[[question]]\nitem = \"ch3/e5-log-decrement\"\n";
    let plan = put(&folder, "test.toml", text);
    let out = folder.join("out");
    vibank(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let page = content(out.join("sheets.md"));
    assert_eq!(
        page.matches("Logarithmic decrement: $").count(),
        2,
        "one a sheet"
    );
    assert!(
        !page.contains("Huygens"),
        "of the chapters that are asked alone"
    );
    assert!(content(out.join("sheets.html")).contains("class=\"formulas\""));
    let bare = put(
        &folder,
        "bare.toml",
        blueprint("seed = 1\nvariants = 1\nformula_sheet = true"),
    );
    small(&["sheet", &bare])
        .ends(2)
        .complains("bare.toml:4:17")
        .complains("`formulas` in `_chapter.toml`");
}

#[test]
fn points_of_parts_sum_up_to_those_of_their_question() {
    let folder = folder("points");
    let sheet = |keys: &str| {
        let text = format!(
            "title = \"T\"\nseed = 3\nvariants = 1\nformats = [\"json\"]\n[[question]]\nitem = \"free/spring-mass\"\n{keys}\n"
        );
        let plan = put(&folder, "plan.toml", text);
        let out = folder.join("out");
        let _ = fs::remove_dir_all(&out);
        (
            small(&["sheet", &plan, "--out", &text_of(&out)]),
            out.join("manifest.json"),
        )
    };
    let points = |keys: &str| {
        let (ran, manifest) = sheet(keys);
        ran.ends(0);
        let manifest: serde_json::Value =
            serde_json::from_str(&content(manifest)).expect("it is JSON");
        let question = &manifest["variants"][0]["questions"][0];
        let parts = question["parts"].as_array().expect("it has parts");
        let parts: Vec<f64> = parts
            .iter()
            .filter_map(|part| part["points"].as_f64())
            .collect();
        (question["points"].as_f64(), parts)
    };
    let (whole, parts) = points("points = 1");
    assert_eq!((whole, parts.iter().sum::<f64>()), (Some(1.0), 1.0));
    let is_step = |points: &f64| (points * 4.0).fract() == 0.0 && *points > 0.0;
    assert!(parts.iter().all(is_step), "{parts:?}");
    // The points of a part win, and the others share the rest.
    let (whole, parts) = points("points = 7\npart_points = { f_n = 1.3 }");
    assert_eq!((whole, parts[1]), (Some(7.0), 1.3), "{parts:?}");
    let (whole, parts) = points("part_points = { f_n = 1.3 }");
    assert_eq!((whole, parts[1]), (parts.iter().sum::<f64>().into(), 1.3));
    for (keys, words) in [
        ("part_points = { f_m = 1 }", "did you mean `f_n`?"),
        (
            "part_points = { f_n = 0 }",
            "`f_n` is `0`, expected a number of points from 0.001 to 1000000",
        ),
        (
            "points = 1e300",
            "`points` is `1e300`, expected a number of points",
        ),
        (
            "parts = [\"omega_n\"]\npart_points = { f_n = 1 }",
            "is not asked",
        ),
        (
            "points = 2\npart_points = { f_n = 2 }",
            "leave nothing to the others",
        ),
        (
            "parts = [\"f_n\"]\npoints = 2\npart_points = { f_n = 1 }",
            "sum up to 1",
        ),
        ("part_points = { f_n = \"2\" }", "expected a number"),
    ] {
        sheet(keys).0.ends(2).complains(words);
    }
}

#[test]
fn the_table_of_marks_has_a_second_row_where_one_is_too_narrow() {
    let folder = folder("marks");
    for (questions, rows) in [(12, vec![13]), (13, vec![7, 7]), (24, vec![13, 12])] {
        let question = "[[question]]\nitem = \"ch1/e3-ke-simple-pendulum\"\n";
        let top = "title = \"T\"\nseed = 1\nvariants = 1\nformats = [\"html\"]\n";
        let text = format!("{top}{}", question.repeat(questions));
        let plan = put(&folder, &format!("{questions}.toml"), text);
        let out = folder.join(questions.to_string());
        vibank(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
        let page = content(out.join("sheets.html"));
        let tables = page.split("<tr><th scope=\"row\">Question</th>").skip(1);
        let lengths: Vec<usize> = tables
            .map(|row| {
                let (row, _) = row.split_once("</tr>").expect("the row ends");
                row.matches("<th scope=\"col\">").count()
            })
            .collect();
        assert_eq!(lengths, rows, "{questions} questions");
    }
}

#[test]
fn seeds_that_were_not_suitable_are_put_down_to_their_item() {
    let folder = folder("unsuitable");
    let questions = [
        "ch2/p2-centre-pinned-bar-cable",
        "ch1/e3-ke-simple-pendulum",
    ];
    let questions = questions.map(|item| format!("[[question]]\nitem = \"{item}\"\n"));
    let top = "title = \"T\"\nseed = 1\nvariants = 8\nformats = [\"html\"]\n";
    let plan = put(&folder, "test.toml", format!("{top}{}", questions.concat()));
    vibank(&["sheet", &plan, "--out", &text_of(&folder.join("out"))])
        .ends(0)
        .complains("of them for ch2/p2-centre-pinned-bar-cable");
}
