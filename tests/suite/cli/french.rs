//! What is said in French: sheets, answer keys, feedback and self-check pages without a word of English but their items'.

use std::collections::BTreeSet;
use std::path::Path;

use super::desk::Desk;
use super::{content, put, text_of, vibank};

/// An item whose texts hold no word of any language.
const ITEM: &str = r#"
[item]
title = "Ooo"
source = "by hand"

[parameters]
m = { value = "2 kg", range = "1 .. 5 kg", step = "0.5 kg" }
k = { value = "800 N/m", range = "200 .. 900 N/m", step = "50 N/m" }

[quantities]
omega = { formula = "sqrt(k/m)", unit = "rad/s" }

[statement]
text = "<< m.given >>, << k.given >>."

[[part]]
key = "omega"
ask = "?"
hints = ["?"]
solution = "<< omega >>"

[[part]]
id = "w"
kind = "formula"
key = "k/m"
ask = "?"
solution = "!"

[[part]]
id = "pick"
kind = "choice"
ask = "?"
solution = "!"
options = [{ id = "a", text = "$1$", right = true }, { id = "b", text = "$2$" }]

[[part]]
id = "draw"
kind = "work"
ask = "?"
space = "2 cm"
solution = "!"
rubric = [{ points = 1, text = "!" }]
"#;

/// An item whose solution is derived from its model, and whose figure shows its modes.
const DERIVED: &str = r#"
[item]
title = "Uuu"
source = "by hand"

[parameters]
m = { value = "2 kg", range = "1 .. 5 kg", step = "0.5 kg" }
k = { value = "800 N/m", range = "200 .. 900 N/m", step = "50 N/m" }

[model]
coordinates = { x = { name = "!", unit = "m" }, y = { name = "!", unit = "m" } }
kinetic = "1/2*m*x'^2 + 1/2*m*y'^2"
potential = "1/2*k*x^2 + 1/2*k*(y - x)^2 + 1/2*k*y^2"

[model.bodies.bloc_1]
mass = "m"
moves = "x"
forces = { ressort_1 = "-k*x", ressort = "k*(y - x)" }

[model.bodies.bloc_2]
mass = "m"
moves = "y"
forces = { ressort = "-k*(y - x)", ressort_2 = "-k*y" }

[quantities]
K = { formula = "[[2*k, -k], [-k, 2*k]]", unit = "N/m", verify = "model.K" }

[statement]
text = "<< m.given >>, << k.given >>."

[figure]
points = { A = [3, 0.9], B = [6.6, 0.9] }
elements = [
  { block = "A", size = [1.4, 1.8], label = "m", id = "bloc_1" },
  { block = "B", size = [1.4, 1.8], label = "m", id = "bloc_2" },
  { spring = ["A.right", "B.left"], label = "k", id = "ressort" },
]

[figure.motion]
A = ["x", 0]
B = ["y", 0]

[solution]
text = '''
<< model.newton >>

<< model.lagrange.x >>

<< model.characteristic >>

<< model.row.1 >>
'''

[[part]]
key = "K"
kind = "matrix"
ask = "?"
solution = "<< figure.mode.2 >>"
"#;

/// An item with dry friction, whose turning points are listed.
const FRICTION: &str = r#"
[item]
title = "Iii"
source = "by hand"

[parameters]
m = { value = "6 kg", range = "3 .. 8 kg", step = "0.5 kg" }
k = { value = "128 N/m", range = "80 .. 200 N/m", step = "4 N/m" }
mu = "0.05"
g = "9.81 m/s^2"

[model]
coordinates = { x = { name = "!", unit = "m" } }
kinetic = "1/2*m*x'^2"
potential = "1/2*k*x^2"
friction = { x = "mu*m*g" }
initial = { x = "1[m]" }

[quantities]
omega = { formula = "sqrt(k/m)", unit = "rad/s", verify = "model.natural_angular_frequency" }

[statement]
text = "<< m.given >>, << k.given >>, << mu.given >>."

[solution]
text = '''
<< model.energy >>

<< model.turning_points >>
'''

[[part]]
key = "omega"
ask = "?"
solution = "<< omega.worked >>"
"#;

fn desk(name: &str) -> (Desk, String) {
    let desk = Desk::new(name);
    let bank = desk.folder.join("bank");
    std::fs::create_dir_all(bank.join("ooo")).expect("a folder");
    put(
        &bank,
        "bank.toml",
        "format = 1\ntitle = \"Ooo\"\nlanguage = \"fr\"\n",
    );
    put(
        &bank.join("ooo"),
        "_chapter.toml",
        "title = \"Ooo\"\nnumber = 1\n",
    );
    for (name, item) in [("ooo", ITEM), ("uuu", DERIVED), ("iii", FRICTION)] {
        put(&bank.join("ooo"), &format!("{name}.toml"), item);
    }
    let blueprint = "title = \"Ooo\"\nlanguage = \"fr\"\nseed = 1\nvariants = 2\nduration = \"90 min\"\nhints = true\nformats = [\"html\", \"md\"]\n[[question]]\nitem = \"ooo/ooo\"\n[[question]]\nitem = \"ooo/ooo\"\n";
    put(&desk.folder, "t.toml", blueprint);
    let bank = text_of(&bank);
    (desk, bank)
}

/// Words of our English texts that no French text has.
fn english() -> BTreeSet<String> {
    let words = |text: &str| -> BTreeSet<String> {
        let value: serde_json::Value = serde_json::from_str(text).expect("a file of words");
        let values = value.as_object().expect("an object").values();
        let text: Vec<&str> = values.filter_map(serde_json::Value::as_str).collect();
        split(&text.join(" "))
    };
    let english = [
        include_str!("../../../templates/words/en.json"),
        include_str!("../../../templates/page/texts.en.json"),
    ];
    let french = [
        include_str!("../../../templates/words/fr.json"),
        include_str!("../../../templates/page/texts.fr.json"),
    ];
    let mut all: BTreeSet<String> = english.into_iter().flat_map(words).collect();
    // Of remarks and answer lines.
    all.extend(split(
        "value formula figures choose person marked right wrong asked typed read this that answer answers unit does not \
         fit measures letters number missing teacher could been taken with from the and your",
    ));
    // Of formulas: of ranges, of functions by pieces.
    all.extend(split("otherwise range value"));
    // Of LaTeX, and a word of both languages.
    all.remove("text");
    all.remove("compare");
    for word in french.into_iter().flat_map(words) {
        all.remove(&word);
    }
    all
}

/// Words of three letters and more, in small letters.
fn split(text: &str) -> BTreeSet<String> {
    let words = text.split(|sign: char| !sign.is_alphabetic());
    words
        .filter(|word| word.chars().count() > 2)
        .map(str::to_lowercase)
        .collect()
}

/// What a reader sees of a page: without styles, scripts and tags.
fn seen(html: &str) -> String {
    let mut text = html.to_owned();
    for (opens, closes) in [
        ("<style", "</style>"),
        ("<script", "</script>"),
        ("<annotation", "</annotation>"),
        // What is said of a figure to those who cannot see it is in English still.
        ("<title id", "</title>"),
        ("<desc", "</desc>"),
    ] {
        while let Some(from) = text.find(opens) {
            let to = text[from..]
                .find(closes)
                .map_or(text.len(), |to| from + to + closes.len());
            text.replace_range(from..to, " ");
        }
    }
    let mut seen = String::new();
    let mut is_tag = false;
    for sign in text.chars() {
        match sign {
            '<' => is_tag = true,
            '>' => {
                is_tag = false;
                seen.push(' ');
            }
            _ if !is_tag => seen.push(sign),
            _ => {}
        }
    }
    seen
}

#[track_caller]
fn is_french(path: &Path) {
    let english = english();
    let found: Vec<String> = split(&seen(&content(path)))
        .into_iter()
        .filter(|word| english.contains(word))
        .collect();
    assert!(found.is_empty(), "{}: {found:?}", path.display());
}

#[test]
fn sheets_keys_and_feedback_are_french_throughout() {
    let (desk, bank) = desk("french-sheets");
    let plan = text_of(&desk.folder.join("t.toml"));
    let out = desk.folder.join("out");
    let folder = text_of(&out);
    vibank(&["sheet", &plan, "--bank", &bank, "--out", &folder]).ends(0);
    for name in ["sheets", "keys", "solutions", "key-table"] {
        for ending in ["html", "md"] {
            is_french(&out.join(format!("{name}.{ending}")));
        }
    }
    let keys = content(out.join("keys.md"));
    assert!(keys.contains(" à ") && !keys.contains(" to "), "{keys}");
    let sheets = seen(&content(out.join("sheets.html")));
    for words in [
        "(valeur, 3 chiffres significatifs)",
        "(formule en fonction de",
        "(une seule réponse)",
        "variante",
        "Durée : 90 min",
        "2 exercices",
    ] {
        assert!(sheets.contains(words), "`{words}` is not in {sheets}");
    }
    let form = content(out.join("responses.csv"));
    let typed = ["3 m", "k/m + 1", "z", "", "20", "sqrt(", "a;b", ""];
    let mut lines = form.lines();
    let mut rows = vec![lines.next().expect("a heading").to_owned()];
    let separator = if rows[0].contains(';') { ';' } else { ',' };
    for (line, typed) in lines.zip(typed.iter().cycle()) {
        let given = line.rfind(separator).map_or(line, |at| &line[..=at]);
        rows.push(format!("{given}\"{typed}\""));
    }
    let filled = put(&desk.folder, "responses.csv", rows.join("\n") + "\n");
    let manifest = text_of(&out.join("manifest.json"));
    let marks = desk.folder.join("marks");
    vibank(&[
        "grade",
        &manifest,
        &filled,
        "--bank",
        &bank,
        "--out",
        &text_of(&marks),
    ]);
    let pages = std::fs::read_dir(marks.join("feedback")).expect("feedback was written");
    let mut count = 0;
    for page in pages {
        is_french(&page.expect("a file").path());
        count += 1;
    }
    assert_eq!(count, 2);
}

#[test]
fn derivations_are_french_throughout() {
    let (desk, bank) = desk("french-derived");
    let blueprint = "title = \"Ooo\"\nlanguage = \"fr\"\nseed = 1\nvariants = 1\nformats = [\"html\"]\n[[question]]\nitem = \"ooo/uuu\"\n[[question]]\nitem = \"ooo/iii\"\n";
    let plan = put(&desk.folder, "derived.toml", blueprint);
    let out = desk.folder.join("derived");
    let folder = text_of(&out);
    vibank(&["sheet", &plan, "--bank", &bank, "--out", &folder]).ends(0);
    is_french(&out.join("solutions.html"));
    let html = content(out.join("solutions.html"));
    let shown = seen(&html);
    for words in [
        "Deuxième loi de Newton, bloc 1 :",
        "Équation de Lagrange :",
        "Bilan d’énergie :",
        "Mouvement à une seule pulsation",
        " ligne :",
        "Points de rebroussement",
        "et ainsi de suite, jusqu’à",
    ] {
        assert!(shown.contains(words), "`{words}` is not in {shown}");
    }
    // Numbers in them have a comma, also in what is said of a figure.
    assert!(!has_decimal_point(&shown), "{shown}");
    assert!(html.contains("deux positions extrêmes du mode 2 : x 1,00"));
}

/// Whether a digit, a point and a digit follow each other anywhere.
fn has_decimal_point(text: &str) -> bool {
    let signs: Vec<char> = text.chars().collect();
    signs
        .windows(3)
        .any(|own| own[1] == '.' && own[0].is_ascii_digit() && own[2].is_ascii_digit())
}

#[test]
fn forms_are_french_throughout() {
    let (desk, bank) = desk("french-forms");
    let out = desk.folder.join("out");
    let plan = text_of(&desk.folder.join("t.toml"));
    vibank(&["sheet", &plan, "--bank", &bank, "--out", &text_of(&out)]).ends(0);
    let manifest = text_of(&out.join("manifest.json"));
    vibank(&["form", &manifest, "--bank", &bank]).ends(0);
    let pages = std::fs::read_dir(out.join("form")).expect("pages were written");
    let mut count = 0;
    for page in pages {
        let path = page.expect("a file").path();
        is_french(&path);
        let text = content(&path);
        assert!(text.contains("<html lang=\"fr\""));
        // What the page asks for, and the words of its program.
        for words in [
            "(valeur, 3 chiffres significatifs)",
            "(formule en fonction de",
            "Enregistrer les réponses",
        ] {
            assert!(
                text.contains(words),
                "`{words}` is not in {}",
                path.display()
            );
        }
        assert!(!text.contains("Save the answers"));
        count += 1;
    }
    assert_eq!(count, 2);
}

#[test]
fn a_region_speaks_the_language_of_its_tag() {
    let (desk, bank) = desk("french-region");
    let blueprint = content(desk.folder.join("t.toml")).replace("\"fr\"", "\"fr-CA\"");
    let plan = put(&desk.folder, "ca.toml", blueprint);
    let page = desk.folder.join("ca.html");
    vibank(&["page", &plan, "--bank", &bank, "--out", &text_of(&page)]).ends(0);
    let text = content(&page);
    assert!(text.contains("<html lang=\"fr-CA\""));
    assert!(text.contains("Voir le corrigé"));
    is_french(&page);
}

#[test]
fn self_check_pages_are_french_throughout() {
    let (desk, bank) = desk("french-pages");
    let page = desk.folder.join("page.html");
    let plan = text_of(&desk.folder.join("t.toml"));
    vibank(&["page", &plan, "--bank", &bank, "--out", &text_of(&page)]).ends(0);
    let text = content(&page);
    assert!(text.contains("<html lang=\"fr\""));
    is_french(&page);
    // The words that the program of the page uses.
    assert!(text.contains("Voir le corrigé") && !text.contains("Show solution"));
}

#[test]
fn english_items_on_a_french_sheet_are_a_warning() {
    let desk = Desk::new("french-warning");
    let plan = desk.plan("seed = 1\nvariants = 1\nformats = [\"html\"]\nlanguage = \"fr\"");
    desk.sheet(&plan, &[])
        .ends(0)
        .complains("the texts of the items are in `en`");
    // The decimal sign is that of the language, unless the blueprint states another one.
    let sheets = content(desk.out.join("sheets.html"));
    assert!(sheets.contains("lang=\"fr\""));
    let plan = desk.plan("seed = 1\nvariants = 1\nlanguage = \"de\"");
    desk.sheet(&plan, &[])
        .ends(2)
        .complains("the texts of the bank are in `en`, not in `de`");
}
