//! Spellings of one value in every kind that can hold it: one that a kind accepts, all accept, with the same meaning.
//! A new spelling is a row of [`SPELLINGS`].

use vibank::answer::Verdict;
use vibank::grade;
use vibank::instance::Instance;
use vibank::solution::Solution;

/// Spellings of a digit `d`; `D` stands for its double.
const SPELLINGS: &[&str] = &[
    "d",
    "+d",
    "d.0",
    "d,0",
    "d{,}0",
    "0.de1",
    "0.dE+1",
    "d0e-1",
    "d0e−1",
    "d0×10^-1",
    "d0·10⁻¹",
    "d0*10^(-1)",
    "d0*10**-1",
    "d0 \\cdot 10^{-1}",
    "D/2",
    "D÷2",
    "\\frac{D}{2}",
    "\\dfrac{D}{2}",
    "(D)/2",
    "\\left(d\\right)",
    "sqrt(d^2)",
    "√(d²)",
    "$d$",
    "𝟏*d",
];

/// Parts of the fixture that hold the digit, with what stands around it.
const PLACES: &[(&str, char, &str)] = &[
    ("omega_n", '5', "# rad/s"),
    ("omega_n", '5', "ω = # rad/s"),
    ("omega_n", '5', "ω_n ≈ # s^-1"),
    ("both", '5', "#; 8.66 rad/s"),
    ("both", '5', "# and 8.66 rad/s"),
    ("both", '5', "[#; 8.66] rad/s"),
    ("both", '5', "ω_1 = # rad/s; ω_2 = 8.66 rad/s"),
    ("Z", '3', "# + 4i ohm"),
    ("Z", '3', "(# + 4j) Ω"),
    ("Z", '3', "Z = # Ω + 4i Ω"),
    ("n", '2', "#"),
    ("n", '2', "n = #"),
    ("formula", '2', "sqrt(k/m - (c/((#) m))^2)"),
    (
        "formula",
        '2',
        "ω_d = \\sqrt{\\frac{k}{m} - \\left(\\frac{c}{(#) m}\\right)^2}",
    ),
    ("eom1", '2', "m x1'' + (#) k x1 - k x2 = 0"),
    ("eom1", '2', "m \\ddot{x}_1 = k x_2 - (#) k x_1"),
    ("motion", '5', "0.5 exp(-0.75 t) cos((#) t)"),
    (
        "motion",
        '5',
        "x = 0.5 m e^{-0.75 t} \\cos\\left((#) t\\right)",
    ),
    ("K", '2', "[[(#)*k, -k], [-k, 2*k]]"),
    (
        "K",
        '2',
        "\\begin{pmatrix} (#) k & -k \\\\ -k & 2k \\end{pmatrix}",
    ),
    ("u1", '1', "[#; 1]"),
    ("u1", '1', "x_1 = #; x_2 = 1"),
    ("range", '1', "mu >= 0.1274*(#)"),
    (
        "general",
        '5',
        "(1; 1) A cos((#) t + p) + (1; -1) B cos(8.66 t + q)",
    ),
];

#[test]
fn a_spelling_has_one_meaning_in_all_kinds() {
    let catalogue = super::hostile::catalogue();
    let template = catalogue.items().next().expect("the fixture");
    let solution = Solution::of(Instance::of_source(template));
    let mut faults = Vec::new();
    for (part, digit, around) in PLACES {
        let place = template.parts.iter().position(|own| own.has_id(part));
        let place = place.expect("a part of the item");
        let double = (2 * digit.to_digit(10).expect("a digit")).to_string();
        for spelling in SPELLINGS {
            let number = spelling.replace('D', &double).replace("\\dfrac", "\\Ffrac");
            let number = number
                .replace("\\cdot", "\\Cot")
                .replace('d', &digit.to_string());
            let number = number
                .replace("\\Ffrac", "\\dfrac")
                .replace("\\Cot", "\\cdot");
            let response = around.replace('#', &number);
            let marking = grade::mark(&solution, place, &response);
            if marking.verdict != Verdict::Right {
                faults.push(format!("{part} `{response}`: {marking:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// What is echoed as the reading is read as the same value.
#[test]
fn a_reading_is_read_as_itself() {
    let catalogue = super::hostile::catalogue();
    let template = catalogue.items().next().expect("the fixture");
    let solution = Solution::of(Instance::of_source(template));
    let mut faults = Vec::new();
    for (part, digit, around) in PLACES {
        let place = template.parts.iter().position(|own| own.has_id(part));
        let place = place.expect("a part of the item");
        for number in ["#", "-#", "2*#", "sqrt(#)", "#e-3", "# + 1", "pi*#"] {
            let number = number.replace('#', &digit.to_string());
            let marking = grade::mark(&solution, place, &around.replace('#', &number));
            let Some(reading) = marking.reading else {
                continue;
            };
            let again = grade::mark(&solution, place, &reading.text.replace(", ", "; "));
            if again.verdict != marking.verdict {
                faults.push(format!(
                    "{part} `{number}` as `{}`: {:?}, then {:?}",
                    reading.text, marking.verdict, again
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Signs of which only the table in `crates/response/src/signs.rs` may know; a kind sees what they stand for.
const FANCY: &str = "−–—‐‑‒―×⋅∙∗•÷∕⁄′’‘´“”⩽⩾≦≧≃≅≔∨∧";

#[test]
fn one_table_knows_the_signs() {
    // What is written for people, not read.
    const WRITTEN: [&str; 1] = ["answer/equation/told.rs"];
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders = vec![root.join("crates/response/src"), root.join("src/answer")];
    let (mut faults, mut count) = (Vec::new(), 0);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let is_free = ["response/src/signs.rs", "tests.rs"]
                .iter()
                .chain(&WRITTEN)
                .any(|own| path.ends_with(own));
            if is_free {
                continue;
            }
            count += 1;
            let text = std::fs::read_to_string(&path).expect("a text");
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let lines = code.lines().enumerate();
            for (line, code) in lines.filter(|(_, line)| !line.trim_start().starts_with("//")) {
                if code.contains(|char| FANCY.contains(char)) {
                    faults.push(format!("{}:{}: {code}", path.display(), line + 1));
                }
            }
        }
    }
    assert!(count > 80, "{count} files");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
