//! Room for work on paper.

use std::fs;

use super::{content, folder, put, text_of, vibank};

#[test]
fn room_for_work_is_printed_as_item_and_blueprint_say() {
    let folder = folder("space");
    let bank = folder.join("bank");
    fs::create_dir_all(bank.join("c")).expect("a folder can be made");
    put(&bank, "bank.toml", "format = 1\ntitle = 'T'");
    put(&bank, "c/_chapter.toml", "title = 'C'");
    let part = |id: &str, space: &str| {
        format!("[[part]]\nid = '{id}'\nkey = 'f'\nask = 'What is {id}?'\n{space}\n")
    };
    let item = |parts: &str| {
        format!(
            "[item]\ntitle = 'A'\nsource = 'S'\n[parameters]\nf = '2 Hz'\n[statement]\ntext = 'X'\n{parts}"
        )
    };
    let parts = [
        part("own", "space = '3 lines'"),
        part("bare", "space = 'none'"),
        part("usual", ""),
    ];
    put(&bank, "c/a.toml", item(&parts.concat()));
    let bank = text_of(&bank);
    let sheet = |top: &str, keys: &str| {
        let text = format!(
            "title = 'T'\nseed = 3\nvariants = 1\nformats = ['html', 'md', 'json']\n{top}\n[[question]]\n{keys}\n"
        );
        let plan = put(&folder, "plan.toml", text);
        let out = folder.join("out");
        let _ = fs::remove_dir_all(&out);
        let ran = vibank(&["sheet", &plan, "--bank", &bank, "--out", &text_of(&out)]);
        (ran, out)
    };
    let spaces = |top: &str, keys: &str| {
        let (ran, out) = sheet(top, keys);
        ran.ends(0);
        let row: serde_json::Value =
            serde_json::from_str(content(out.join("sheets.jsonl")).trim()).expect("it is JSON");
        let parts = row["questions"][0]["parts"].as_array().cloned();
        let parts = parts.expect("it has parts");
        let spaces = parts.iter().map(|part| part["space"].as_str());
        let spaces = spaces.map(|space| space.map(str::to_owned));
        (spaces.collect::<Vec<_>>(), out)
    };
    let all = |spaces: [&str; 3]| spaces.map(|space| Some(space.to_owned())).to_vec();
    let item_alone = "item = 'c/a'";
    assert_eq!(spaces("", item_alone).0, all(["3 lines", "none", "none"]));
    let (found, out) = spaces("space = '6 cm squared'", item_alone);
    assert_eq!(found, all(["3 lines", "none", "60 mm squared"]));
    let page = content(out.join("sheets.html"));
    assert!(page.contains("<div class=\"space lines\" style=\"height: 24mm\">"));
    assert!(page.contains("<div class=\"space squared\" style=\"height: 60mm\">"));
    assert_eq!(page.matches("<div class=\"space ").count(), 2);
    assert_eq!(content(out.join("sheets.md")).matches("&nbsp;").count(), 8);
    assert!(!content(out.join("keys.html")).contains("<div class=\"space "));
    let (found, _) = spaces(
        "space = '1 cm'",
        "item = 'c/a'\nspace = '2 cm'\npart_space = { usual = 'none' }",
    );
    assert_eq!(found, all(["20 mm", "20 mm", "none"]));
    for (top, keys, words) in [
        (
            "space = '5 inches'",
            item_alone,
            "`5 inches` is no working space",
        ),
        ("space = '30 cm'", item_alone, "at most 20 cm or 25 lines"),
        (
            "",
            "item = 'c/a'\npart_space = { usuall = '2 cm' }",
            "did you mean `usual`?",
        ),
        (
            "",
            "pick = { chapter = 'c' }\npart_space = { own = '2 cm' }",
            "belongs to one `item`",
        ),
        ("", "item = 'c/a'\nspace = 5", "expected a text"),
    ] {
        sheet(top, keys).0.ends(2).complains(words);
    }
    let wrong = put(
        &folder,
        "bank/c/b.toml",
        item(&part("own", "space = '3 rows'")),
    );
    vibank(&["check", &wrong, "--bank", &bank])
        .ends(1)
        .complains("b.toml:12:9")
        .complains("`3 rows` is no working space");
}
