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
];

#[test]
fn a_spelling_has_one_meaning_in_all_kinds() {
    let catalogue = super::hostile::catalogue();
    let template = catalogue.items().next().expect("the fixture");
    let solution = Solution::of(Instance::of_source(template));
    let mut faults = Vec::new();
    for (part, digit, around) in PLACES {
        let place = template.parts.iter().position(|own| own.id == *part);
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
        let place = template.parts.iter().position(|own| own.id == *part);
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
