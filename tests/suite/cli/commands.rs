//! Commands that show, list, explain and begin.

use super::{BANK, blueprint, content, folder, put, small, text_of, vibank};

#[test]
fn help_and_version_are_no_misuse() {
    vibank(&["--help"]).ends(0).says("sheet").says("grade");
    vibank(&["--version"]).ends(0).says("vibank 0.");
    for command in [
        "list", "show", "solve", "mark", "compute", "sheet", "grade", "check", "explain", "new",
    ] {
        vibank(&[command, "--help"]).ends(0).says("Example: ");
    }
}

#[test]
fn misuse_ends_with_2() {
    vibank(&[]).ends(2);
    vibank(&["frobnicate"]).ends(2).complains("frobnicate");
    vibank(&["solve"]).ends(2);
    vibank(&["list", "--level", "9"]).ends(2);
    vibank(&["list", "--bank", "/nowhere"])
        .ends(2)
        .complains("cannot read `/nowhere`");
    small(&["grade", "/nowhere.json", "/nowhere.csv"])
        .ends(2)
        .complains("/nowhere.json");
    small(&["sheet", "/nowhere.toml"])
        .ends(2)
        .complains("/nowhere.toml");
}

#[test]
fn items_are_listed_and_filtered() {
    small(&["list"])
        .ends(0)
        .says("free  Free vibration")
        .says("friction/half-cycles");
    let ran = small(&[
        "list",
        "--chapter",
        "free",
        "--level",
        "1",
        "--format",
        "json",
    ])
    .ends(0);
    let list = &ran.lines()[0];
    assert_eq!(list.as_array().map(Vec::len), Some(1));
    assert_eq!(list[0]["id"], "free/spring-mass");
    assert_eq!(list[0]["parts"][1]["kind"], "numeric");
    let by_kind = small(&["list", "--kind", "choice"]).ends(0);
    assert!(by_kind.out.contains("damped-block") && !by_kind.out.contains("half-cycles"));
    small(&["list", "--kind", "choice", "--level", "3"])
        .ends(0)
        .complains("no item fits all of this");
    small(&["list", "--topic", "acoustics"])
        .ends(2)
        .complains("no item has the topic `acoustics`");
    small(&["list", "--kind", "choise"])
        .ends(2)
        .complains("did you mean `choice`?");
}

#[test]
fn the_terminal_tells_plots_in_words() {
    let ran = vibank(&["show", "ch3/e4-underdamped-response", "--solution"]).ends(0);
    let ran = ran.says("(Plot: x against t");
    assert!(!ran.out.contains("<svg"), "{}", ran.out);
}

#[test]
fn an_item_is_shown_with_the_data_of_its_source() {
    let ran = small(&["show", "free/spring-mass"]).ends(0);
    let ran = ran
        .says("k = 800 N/m")
        .says("a) Find its natural angular frequency.");
    assert!(
        !ran.out.contains("= 20"),
        "the key is not shown: {}",
        ran.out
    );
    small(&["show", "free/spring-mass", "--key"])
        .ends(0)
        .says("= 20.0 rad/s");
    small(&["show", "free/spring-mass", "--solution"])
        .ends(0)
        .says("hint: Compare stiffness and mass.")
        .says("3.18 Hz");
    small(&["show", "free/spring-mass", "--set", "m=8 kg", "--key"])
        .ends(0)
        .says("= 10.0 rad/s");
    // After one period the decrement of several is that of one.
    vibank(&["show", "ch3/e5-log-decrement", "--set", "n=1"])
        .ends(0)
        .complains("warning: with these data, a mistake of part `ratio_n`");
}

#[test]
fn an_item_that_cannot_be_used_is_no_unknown_one() {
    let folder = folder("commands-broken");
    std::fs::create_dir_all(folder.join("bank/ch1")).expect("the folder can be made");
    put(&folder, "bank/bank.toml", "format = 1\ntitle = 'Test'\n");
    put(
        &folder,
        "bank/ch1/_chapter.toml",
        "title = 'One'\nnumber = 1\n",
    );
    put(
        &folder,
        "bank/ch1/x.toml",
        "[item]\ntitle = 'Nothing is asked'\n",
    );
    let bank = text_of(&folder.join("bank"));
    let exam = put(
        &folder,
        "exam.toml",
        "title = 'T'\nseed = 1\nvariants = 1\n[[question]]\nitem = 'ch1/x'\n",
    );
    let out = text_of(&folder.join("out"));
    for command in [
        &["show", "ch1/x", "--bank", &bank][..],
        &["solve", "ch1/x", "--bank", &bank],
        &["mark", "ch1/x", "a", "1", "--bank", &bank],
        &["practice", "ch1/x", "--bank", &bank],
        &["sheet", &exam, "--out", &out, "--bank", &bank],
    ] {
        let ran = vibank(command).ends(2).complains("vibank check");
        assert!(!ran.err.contains("did you mean"), "{}", ran.err);
    }
}

#[test]
fn unknown_names_come_with_the_nearest_known_one() {
    for typed in ["free/spring-mas", "free/spr", "spring"] {
        small(&["show", typed])
            .ends(2)
            .complains("did you mean `free/spring-mass`?");
    }
    small(&["solve", "free/spring-mass", "--want", "omega_m"])
        .ends(2)
        .complains("did you mean `omega_n`?");
    small(&["mark", "free/spring-mass", "omega_m", "1"])
        .ends(2)
        .complains("did you mean `omega_n`?");
    small(&["solve", "free/spring-mass", "--set", "mm=1 kg"])
        .ends(2)
        .complains("did you mean `m`?");
    vibank(&["explain", "bank::unknown-kye"])
        .ends(2)
        .complains("did you mean `bank::unknown-key`?");
}

#[test]
fn codes_are_explained() {
    vibank(&["explain", "bank::unknown-key"])
        .ends(0)
        .says("misspelt");
    let all = vibank(&["explain"]).ends(0);
    assert_eq!(
        all.out.lines().count(),
        vibank::diagnostic::codes::PAGES.len()
    );
}

#[test]
fn what_new_begins_works_as_it_stands() {
    let folder = folder("new");
    let sheet = text_of(&folder.join("begun.toml"));
    vibank(&["new", "sheet", &sheet])
        .ends(0)
        .says("vibank sheet");
    vibank(&["new", "sheet", &sheet])
        .ends(2)
        .complains("exists already");
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &sheet, "--out", &out]).ends(0);
    let item = text_of(&folder.join("bank/begun/item.toml"));
    vibank(&["new", "item", &item]).ends(0).says("vibank check");
    put(
        &folder,
        "bank/bank.toml",
        "format = 1\ntitle = \"B\"\n[topics]\n\"free vibration\" = \"…\"\n",
    );
    put(&folder, "bank/begun/_chapter.toml", "title = \"C\"\n");
    let bank = text_of(&folder.join("bank"));
    vibank(&["check", "--bank", &bank])
        .ends(0)
        .complains("1 item, 0 errors");
    assert!(content(&item).contains("[[check]]"));
}

#[test]
fn a_sound_bank_has_no_findings_and_an_unsound_one_has() {
    small(&["check"])
        .ends(0)
        .complains("3 items, 0 errors, 0 warnings");
    let folder = folder("unsound");
    put(&folder, "bank.toml", content(format!("{BANK}/bank.toml")));
    put(
        &folder,
        "free/_chapter.toml",
        content(format!("{BANK}/free/_chapter.toml")),
    );
    let sound = content(format!("{BANK}/free/spring-mass.toml"));
    put(&folder, "free/spring-mass.toml", &sound);
    put(
        &folder,
        "free/broken.toml",
        sound.replace("sqrt(k/m)", "sqrt(k/"),
    );
    put(
        &folder,
        "free/not-utf-8.toml",
        b"[item]\ntitle = \"\xff\"\n",
    );
    let bank = text_of(&folder);
    let ran = vibank(&["check", "--bank", &bank]).ends(1);
    let ran = ran.complains("free/broken.toml:13:").complains("1 item, ");
    ran.complains("free/not-utf-8.toml");
    let json = vibank(&["check", "--bank", &bank, "--format", "json"]).ends(1);
    assert_eq!(json.lines()[0]["findings"][0]["file"], "free/broken.toml");
    // What is broken never hides the rest.
    vibank(&["show", "free/spring-mass", "--bank", &bank])
        .ends(0)
        .complains("`vibank check` shows them");
}

#[test]
fn check_takes_items_and_files() {
    vibank(&["check", "ch3/e5-log-decrement", "--seeds", "5"]).ends(0);
    vibank(&["check", "nonsense"])
        .ends(2)
        .complains("there is no item or file `nonsense`");
    let folder = folder("check-files");
    let item = include_str!("../../fixtures/book/disk-on-a-wire.toml");
    put(&folder, "disk.toml", item.as_bytes());
    let file = text_of(&folder.join("disk.toml"));
    vibank(&["check", &file, "--seeds", "5"]).ends(0);
    put(
        &folder,
        "disk.toml",
        item.replace("M*R^2))\", unit", "M*R))\", unit").as_bytes(),
    );
    vibank(&["check", &file, "--seeds", "5"])
        .ends(1)
        .complains("m^(1/2)/s");
}

#[test]
fn reports_tell_what_the_draws_look_like() {
    let arguments = ["check", "ch3/e5-log-decrement", "--seeds", "20", "--report"];
    vibank(&arguments)
        .ends(0)
        .says("routes agree to")
        .says("nearest mistake");
    let json = vibank(&[&arguments[..], &["--format", "json"]].concat()).ends(0);
    let item = &json.lines()[0]["items"][0];
    assert_eq!(item["draws"], 20);
    assert!(item["disagreement"]["share"].as_f64().unwrap() < 1e-12);
    assert!(item["answers"][0]["tightest"].as_f64().unwrap() > 0.0);
}

#[test]
fn texts_of_chapters_and_blueprints_lose_nothing_in_silence() {
    let folder = folder("bare-texts");
    let bank = folder.join("bank");
    put(&bank, "bank.toml", content(format!("{BANK}/bank.toml")));
    let chapter = "title = \"C\"\nnumber = 1\ntext = \"See [the page](javascript:x).\"\n\
                   formulas = '''\n- Complex amplitude: $\\fancy{X} = 1$, << m >>.\n'''\n";
    put(&bank, "c/_chapter.toml", chapter);
    vibank(&["check", "--bank", &text_of(&bank)])
        .ends(1)
        .complains("_chapter.toml:3:")
        .complains("the link `javascript:x`")
        .complains("_chapter.toml:5:23")
        .complains("unknown command `\\fancy`")
        .complains("a placeholder cannot stand in a text without data");
    let sheet = |instructions: &str| {
        let top = format!("seed = 1\nvariants = 1\ninstructions = {instructions}");
        put(&folder, "test.toml", blueprint(&top))
    };
    let out = text_of(&folder.join("out"));
    for (instructions, words) in [
        ("'Use $\\fancy{X}$.'", "test.toml:4:22"),
        ("'Use << m >>.'", "a text without data"),
        ("'Price: 5$ or 6$'", "dollar"),
        (
            &*format!("'{}'", "word ".repeat(14_000)),
            "at most 65536 are read",
        ),
    ] {
        let plan = sheet(instructions);
        small(&["sheet", &plan, "--out", &out])
            .ends(2)
            .complains(words);
        small(&["check", "--deny", "warnings", &plan])
            .ends(1)
            .complains(words);
    }
    let plan = sheet("'Use $\\hat{X}$ and [the page](https://x.org).'");
    small(&["check", &plan])
        .ends(0)
        .complains("1 blueprint, 0 errors");
    small(&["sheet", &plan, "--out", &out]).ends(0);
    assert!(content(folder.join("out/sheets.html")).contains("the page"));
    // A blueprint that does not fit the bank.
    let plan = put(
        &folder,
        "test.toml",
        "title = \"T\"\nseed = 1\nvariants = 1\n[[question]]\nitem = \"free/spring\"\n",
    );
    small(&["check", &plan])
        .ends(1)
        .complains("the bank has no item `free/spring`");
}
