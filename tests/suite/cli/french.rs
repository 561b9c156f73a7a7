//! What is said in French: sheets, answer keys, feedback and self-check pages without a word of English but their items'.

use std::collections::BTreeSet;
use std::path::Path;

use super::desk::Desk;
use super::{content, put, text_of, vibank};

/// How the items with two data begin.
const HEAD: &str = r#"
[item]
title = "Ooo"
source = "by hand"

[parameters]
m = { value = "2 kg", range = "1 .. 5 kg", step = "0.5 kg" }
k = { value = "800 N/m", range = "200 .. 900 N/m", step = "50 N/m" }
"#;

/// An item whose texts hold no word of any language, with a figure and plots that the program describes.
const ITEM: &str = r#"
[quantities]
omega = { formula = "sqrt(k/m)", unit = "rad/s" }
x = { formula = "0.1[m]*cos(omega*t)", unit = "m" }
F_0 = { formula = "k*0.1[m]", unit = "N" }

[statement]
text = "<< m.given >>, << k.given >>."

[figure]
points = { B = [4.6, 0.6] }
elements = [
  { ground = ["[0, 0]", "[8, 0]"], smooth = true },
  { ground = ["[0, 2]", "[0, 0]"] },
  { spring = ["[0, 0.6]", "B.left"], label = "k" },
  { block = "B", size = [1.6, 1.2], label = "m" },
  { force = "B.right", direction = [1, 0], label = "'F'" },
]

[plots.motion]
x = { variable = "t", range = ["0", "4*pi/omega"], unit = "s" }
y = { unit = "m" }
curves = [{ y = "x", label = "x(t)" }, { y = "-x", style = "limit" }]
marks = [{ at = ["0", "0.1[m]"], label = "x_0" }]

[plots.phasors]
kind = "phasors"
unit = "N"
phasors = [{ of = "F_0", label = "F_0" }, { of = "i*F_0", label = "F", joined = true }]
angles = [{ from = "1", to = "1 + i", label = "v" }]

[[part]]
key = "omega"
ask = "?"
hints = ["?"]
solution = '''
<< omega >>

<< plots.motion >>

<< plots.phasors >>
'''

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
  { spring = ["[1, 0.9]", "A.left"], id = "ressort_1" },
  { spring = ["B.right", "[8.8, 0.9]"], id = "ressort_2" },
]

[figure.motion]
A = ["x", 0]
B = ["y", 0]

[figure.free.bloc_1]
along = [1, 0]

[figure.free.bloc_2]
along = [1, 0]

[solution]
text = '''
<< figure.free >>

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

/// A desk with a blueprint `t.toml`, and its bank.
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
    for (name, item) in [
        ("ooo", format!("{HEAD}{ITEM}")),
        ("uuu", format!("{HEAD}{DERIVED}")),
        ("iii", FRICTION.to_owned()),
    ] {
        put(&bank.join("ooo"), &format!("{name}.toml"), &item);
    }
    let blueprint = "title = \"Ooo\"\nlanguage = \"fr\"\nseed = 1\nvariants = 2\nduration = \"90 min\"\nhints = true\nformats = [\"html\", \"md\"]\n[marks]\nscale = { A = \"50 %\", F = \"0 %\" }\n[[question]]\nitem = \"ooo/ooo\"\n[[question]]\nitem = \"ooo/ooo\"\n";
    put(&desk.folder, "t.toml", blueprint);
    let bank = text_of(&bank);
    (desk, bank)
}

/// Words of our English texts that no French text has.
fn english() -> BTreeSet<String> {
    let words = |text: &str| -> BTreeSet<String> {
        let value = serde_json::from_str(text).expect("a file of words");
        split(&phrases(&value))
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
    // Of what is said of figures and plots.
    all.extend(split(
        "sketch block spring damper wall floor ceiling joins join acts act left upwards downwards free body diagram \
         against plot curve limit rises falls oscillates decays turning phasor mode shapes clockwise",
    ));
    // Of formulas that are heard, where a word stands in no other list.
    all.extend(split(
        "grade passed failed equals over root square sub end squared cubed to the power capital open close paren bracket times minus \
         dot cosine sine exponential derivative less greater least row per second metre metres radians",
    ));
    // Of LaTeX, and a word of both languages.
    all.remove("text");
    all.remove("compare");
    for word in french.into_iter().flat_map(words) {
        all.remove(&word);
    }
    all
}

/// All phrases of a file of words, one after the other.
fn phrases(value: &serde_json::Value) -> String {
    match value {
        serde_json::Value::Object(values) => values.values().map(phrases).collect(),
        value => format!(" {}", value.as_str().expect("a phrase")),
    }
}

/// Words of three letters and more, in small letters.
fn split(text: &str) -> BTreeSet<String> {
    let words = text.split(|sign: char| !sign.is_alphabetic());
    words
        .filter(|word| word.chars().count() > 2)
        .map(str::to_lowercase)
        .collect()
}

/// What a reader sees or hears of a page: without styles, scripts and tags, with what stands for pictures.
fn seen(html: &str) -> String {
    let mut text = without(html);
    let mut heard = String::new();
    for attribute in [
        "alt=\"",
        "alttext=\"",
        "aria-label=\"",
        "placeholder=\"",
        "title=\"",
    ] {
        let pieces = text.split(attribute).skip(1);
        let values = pieces.filter_map(|piece| piece.split('"').next());
        values.for_each(|value| heard.extend([" ", value]));
    }
    let mut is_tag = false;
    text.retain(|sign| {
        is_tag = (is_tag || sign == '<') && sign != '>';
        !is_tag
    });
    // What is left of a tag keeps the words on its sides apart.
    text.replace('>', " ") + &heard
}

/// A page without what its readers do not meet.
fn without(html: &str) -> String {
    let mut text = html.to_owned();
    for (opens, closes) in [
        ("<style", "</style>"),
        ("<script", "</script>"),
        ("<annotation", "</annotation>"),
    ] {
        while let Some(from) = text.find(opens) {
            let to = text[from..]
                .find(closes)
                .map_or(text.len(), |to| from + to + closes.len());
            text.replace_range(from..to, " ");
        }
    }
    text
}

#[track_caller]
fn is_french(path: &Path) {
    let english = english();
    let seen = seen(&content(path));
    let found: Vec<String> = split(&seen)
        .into_iter()
        .filter(|word| english.contains(word))
        .collect();
    assert!(found.is_empty(), "{}: {found:?}", path.display());
    let signs: Vec<char> = seen.chars().collect();
    for part in signs.windows(3) {
        // A line must not begin with the sign.
        let is_broken = part[0].is_alphabetic() && part[1] == ' ' && ":;»".contains(part[2]);
        assert!(!is_broken, "{}: {part:?}", path.display());
    }
}

#[test]
fn sheets_keys_and_feedback_are_french_throughout() {
    let (desk, bank) = desk("french-sheets");
    let plan = text_of(&desk.folder.join("t.toml"));
    let out = desk.folder.join("out");
    let folder = text_of(&out);
    vibank(&["sheet", &plan, "--bank", &bank, "--out", &folder]).ends(0);
    is_french(&out.join("fairness.html"));
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
        "Durée\u{a0}: 90 min",
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
    is_french(&marks.join("report.html"));
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
        "Deuxième loi de Newton, bloc 1\u{a0}:",
        "Équation de Lagrange\u{a0}:",
        "Bilan d’énergie\u{a0}:",
        "Mouvement à une seule pulsation",
        " ligne\u{a0}:",
        "Points de rebroussement",
        "et ainsi de suite, jusqu’à",
    ] {
        assert!(shown.contains(words), "`{words}` is not in {shown}");
    }
    assert!(html.contains("Sur le bloc m agissent la force d’un ressort"));
    // Numbers in them have a comma, also in what is said of a figure.
    assert!(!crate::text::decimals::has_decimal_point(&shown), "{shown}");
    assert!(html.contains("deux positions extrêmes du mode 2\u{a0}: x 1,00"));
}

/// What stands for a figure or a plot is said in French, too.
#[test]
fn pictures_are_described_in_french() {
    let (desk, bank) = desk("french-pictures");
    let out = desk.folder.join("out");
    let plan = text_of(&desk.folder.join("t.toml"));
    vibank(&["sheet", &plan, "--bank", &bank, "--out", &text_of(&out)]).ends(0);
    let sheets = content(out.join("sheets.html"));
    for words in [
        "Schéma\u{a0}: ressort, bloc et force",
        "Un ressort k relie le bloc m au mur de gauche.",
        "Une force F agit sur le bloc m.",
    ] {
        assert!(sheets.contains(words), "`{words}` is not in {sheets}");
    }
    let solutions = content(out.join("solutions.html"));
    for words in [
        "x(t) en fonction de t, de 0 à ",
        "La courbe x(t) oscille entre −0,1 m et 0,1 m, avec 3 extremums.",
        "Point marqué x₀\u{a0}: 0 s\u{a0}; 0,1 m.",
        "Diagramme de Fresnel. Vecteur F₀\u{a0}: ",
        "à 90°, à l’extrémité du précédent.",
    ] {
        assert!(solutions.contains(words), "`{words}` is not in {solutions}");
    }
}

#[test]
fn exports_are_french_throughout() {
    let (desk, bank) = desk("french-exports");
    let plan = text_of(&desk.folder.join("t.toml"));
    let moodle = desk.folder.join("questions.xml");
    let export = |platform: &[&str], out: &Path| {
        let out = text_of(out);
        let rest = [&*plan, "--bank", &bank, "--essay", "--out", &out];
        vibank(&[&["export"], platform, &rest].concat()).ends(0);
    };
    export(&["moodle"], &moodle);
    // Its tags and attributes are those of the format.
    let text = content(&moodle);
    let seen = text.replace("$course$/top", "");
    is_french(Path::new(&put(&desk.folder, "seen.xml", seen)));
    for words in [
        "/Exercice 1/réponses rédigées",
        "<small>(nombre seul)</small>",
        "<th>Points</th><th>pour</th>",
        "Un ressort k relie",
    ] {
        assert!(text.contains(words), "`{words}` is not in {text}");
    }
    let qti = desk.folder.join("questions.zip");
    export(&["qti"], &qti);
    #[expect(clippy::disallowed_methods, reason = "a test reads what was written")]
    let bytes = std::fs::read(&qti).expect("a package");
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).expect("an archive");
    let mut items = 0;
    for place in 0..archive.len() {
        let mut file = archive.by_index(place).expect("a file");
        if !file.name().expect("a name").ends_with("item.xml") {
            continue;
        }
        let mut text = String::new();
        std::io::Read::read_to_string(&mut file, &mut text).expect("a text");
        is_french(Path::new(&put(&desk.folder, "item.xml", &text)));
        assert!(text.contains("xml:lang=\"fr\""), "{text}");
        items += 1;
    }
    assert!(items >= 4, "{items}");
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
