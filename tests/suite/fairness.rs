//! Honest work on the bank is right, wrong methods are not: the counts behind both.

use crate::BANK;
use vibank::answer::AnswerKind;
use vibank::bank::{Catalogue, Template};
use vibank::diagnostic::{Code, Finding};
use vibank::examine::Examination;
use vibank::instance::Instance;
use vibank::solution::Solution;
use vibank::suitability::{self, Unfit};

/// Draws of each item; `vibank check` takes 200.
const DRAWS: u64 = 25;

/// What is counted over items.
#[derive(Default)]
struct Counts {
    /// Parts that ask for numbers which rounding moves, and functions.
    parts: usize,
    /// Answers of honest work, each step rounded to the figures that are asked for.
    honest: u64,
    /// Ways that lead elsewhere: standard wrong methods and named mistakes.
    wrong: usize,
    unfair: Vec<String>,
}

fn count(template: &Template) -> Counts {
    let examined = Examination::of(template, DRAWS);
    let mut counts = Counts::default();
    for (part, own) in template.parts.iter().zip(&examined.parts) {
        if own.honest == 0 && part.answer.kind() == AnswerKind::Numeric {
            counts
                .unfair
                .push(format!("{}, {}: no honest work", template.id, part.id));
        }
        counts.parts += usize::from(own.honest > 0);
        counts.honest += own.honest;
        counts.wrong += own.methods + own.mistakes;
    }
    let is_unfair = |finding: &&Finding| {
        [
            Code::CHECK_HONEST_WORK,
            Code::CHECK_METHOD_RIGHT,
            Code::CHECK_MISTAKE_RIGHT,
        ]
        .contains(&finding.code)
    };
    let unfair = examined.findings.iter().filter(is_unfair);
    counts.unfair.extend(unfair.map(ToString::to_string));
    counts
}

/// A bank of one item, `c/a`.
fn bank_of(item: &str) -> Catalogue {
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'T'\n"),
        ("c/_chapter.toml", "title = 'C'\n"),
        ("c/a.toml", item),
    ]);
    assert!(catalogue.find("c/a").is_some(), "{findings:?}");
    catalogue
}

/// A sum of which all digits but one are lost in 256 bits, and one of which none that is printed is.
#[test]
fn a_key_that_rounding_leaves_open_is_not_handed_out() {
    let judged = |key: &str| {
        let item = format!(
            "[item]\ntitle = 'T'\nsource = 'by hand'\n[statement]\ntext = 'T'\n[[part]]\nid = 'p'\nkind = 'numeric'\nkey = '{key}'\nask = 'Find it.'\n"
        );
        let catalogue = bank_of(&item);
        let template = catalogue.find("c/a").unwrap();
        suitability::judge(&Solution::of(Instance::of_source(template)), &[0])
    };
    assert_eq!(judged("1 + 10^60*(sqrt(2)^2 - 2)"), Ok(()));
    let part = "p".to_owned();
    assert_eq!(
        judged("1 + 10^74*(sqrt(2)^2 - 2)"),
        Err(Unfit::UncertainKey { part })
    );
}

/// What is printed with more figures is rounded no second time: a tolerance counts it once.
#[test]
fn a_quantity_that_repeats_another_widens_no_tolerance() {
    let spread = |quantities: &str, key: &str| {
        let item = format!(
            "[item]\ntitle = 'T'\nsource = 'by hand'\n[parameters]\nk = {{ value = '7 N/m' }}\n[statement]\ntext = 'T'\n[quantities]\n{quantities}\n[[part]]\nid = 'p'\nkey = '{key}'\nunit = 'N/m'\nask = 'Find it.'\n"
        );
        let catalogue = bank_of(&item);
        let template = catalogue.find("c/a").unwrap();
        let solution = Solution::of(Instance::of_source(template));
        let key = template.graph.find(&key.into()).unwrap();
        solution.evaluation().spread(key)[0]
    };
    let same = |own: f64, other: f64| assert!((own / other - 1.0).abs() < 1e-5, "{own} {other}");
    let plain = spread("a = '2*k'\ny = 'a^2/k - a'", "y");
    // y = 4 k - 2 k moves with a by (2 a/k - 1) a = 3 a.
    same(plain, 8.0 * 7.0);
    let printed = "a = '2*k'\nb = { formula = 'a', digits = 6 }\n";
    same(spread(&format!("{printed}y = 'b^2/k - b'"), "y"), plain);
    same(spread(&format!("{printed}y = 'b^2/k - a'"), "y"), plain);
    same(spread(printed, "b"), 14.0);
    same(spread(printed, "a"), 14.0);
}

#[test]
fn honest_work_is_right_and_wrong_methods_are_not() {
    let catalogue = &*BANK;
    let items: Vec<&Template> = catalogue.items().collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let all = std::thread::scope(|scope| {
        let runs: Vec<_> = (0..threads)
            .map(|own| {
                let items = &items;
                scope.spawn(move || {
                    let mine = items.iter().skip(own).step_by(threads);
                    mine.map(|item| count(item)).collect::<Vec<Counts>>()
                })
            })
            .collect();
        runs.into_iter()
            .flat_map(|run| run.join().expect("no examination panics"))
            .fold(Counts::default(), |mut all, own| {
                all.parts += own.parts;
                all.honest += own.honest;
                all.wrong += own.wrong;
                all.unfair.extend(own.unfair);
                all
            })
    });
    println!(
        "{} answers of honest work to {} parts, {} ways that lead elsewhere",
        all.honest, all.parts, all.wrong
    );
    // `examine` reports a part of which one answer in so few is not right.
    assert!(all.unfair.is_empty(), "{}", all.unfair.join("\n"));
    // Nothing is counted as right because nothing was counted.
    assert!(
        all.parts >= 350 && all.honest >= 8_000,
        "{} {}",
        all.parts,
        all.honest
    );
    assert!(all.wrong >= 5_000, "{}", all.wrong);
}
