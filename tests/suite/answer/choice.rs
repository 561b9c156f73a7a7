//! Choices: letters as printed, words of options.

use super::check;

fn item(more: &str, options: &[(&str, &str, bool)]) -> String {
    let options: Vec<String> = options
        .iter()
        .map(|(id, text, right)| format!("{{ id = '{id}', text = '{text}', right = {right} }}"))
        .collect();
    format!(
        "[[part]]\nkind = 'choice'\nid = 'p'\nshuffle = false\n{more}\nask = 'Which?'\noptions = [{}]\n",
        options.join(", ")
    )
}

#[test]
fn a_letter_is_the_printed_one_whatever_options_are_called() {
    let item = item(
        "",
        &[
            ("L", "the inductance", false),
            ("C", "the capacitance", false),
            ("R", "the resistance", true),
        ],
    );
    check(
        &item,
        &[
            ("c", "right"),
            ("C", "right"),
            ("(C)", "right"),
            ("C)", "right"),
            ("option c", "right"),
            ("R", "right"),
            ("c) the resistance", "right"),
            ("b", "wrong"),
            ("B", "wrong"),
            ("c) the capacitance", "unreadable"),
            ("d", "unreadable"),
        ],
    );
}

#[test]
fn an_option_may_be_copied_with_its_latex() {
    let item = item(
        "",
        &[
            (
                "rate",
                r"the rate $\mathrm di/\mathrm dt$ of the current",
                true,
            ),
            ("angle", r"the angle $\theta$", false),
        ],
    );
    check(
        &item,
        &[
            (r"the rate $\mathrm di/\mathrm dt$ of the current", "right"),
            (r"the angle $\theta$", "wrong"),
            (r"b) the angle $\theta$", "wrong"),
            (r"the angle $\phi$", "unreadable"),
        ],
    );
}

#[test]
fn words_are_those_of_an_option_or_how_only_one_begins() {
    let item = item(
        "",
        &[
            (
                "spring",
                "elastic, through a spring (partner: a capacitor)",
                true,
            ),
            ("mass", "inertial, through a mass (partner: a coil)", false),
            ("over", "aperiodic (overdamped)", false),
            ("under", "pseudo-periodic", false),
            ("none", "elastic and damped", false),
        ],
    );
    check(
        &item,
        &[
            ("elastic, through a spring (partner: a capacitor)", "right"),
            ("Elastic, through a spring", "right"),
            ("(a) elastic, through a spring", "right"),
            ("elastic, through", "right"),
            ("aperiodic", "wrong"),
            ("aperiodic (overdamped)", "wrong"),
            ("c) aperiodic (overdamped)", "wrong"),
            ("pseudo periodic", "wrong"),
            ("overdamped", "wrong"),
            ("the overdamped", "wrong"),
            // Two options begin so, or one within a word, or with others beside.
            ("elastic", "unreadable"),
            ("aper", "unreadable"),
            ("over", "wrong"),
            ("damped", "unreadable"),
        ],
    );
}

#[test]
fn several_are_chosen_by_letters_in_any_case() {
    let item = item(
        "several = true",
        &[
            ("x", "one", true),
            ("a", "two", false),
            ("y", "three", true),
        ],
    );
    check(
        &item,
        &[
            ("a, c", "right"),
            ("A C", "right"),
            ("ac", "right"),
            ("c and a", "right"),
            ("one; three", "right"),
            ("a", "partial"),
            ("none", "wrong"),
            ("a, d", "unreadable"),
        ],
    );
}
