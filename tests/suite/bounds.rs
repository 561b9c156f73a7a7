//! Bounds on work: what an item may cost is counted in units, the same on every machine, and each bound has a finding
//! that names it.

use vibank::answer::Verdict;
use vibank::bank::{Catalogue, embedded};
use vibank::diagnostic::Finding;
use vibank::document::Document;
use vibank::examine::Examination;
use vibank::expr::{Expr, Normal};
use vibank::grade::{MAX_RESPONSE_LENGTH, mark};
use vibank::instance::Instance;
use vibank::scene::{Data, Scene, Undrawn, undrawn};
use vibank::seed::Seed;
use vibank::solution::{Solution, proof};
use vibank::survey::Survey;
use vibank::work::within;

/// More than any bound.
const MUCH: u64 = 1 << 50;

fn bank(item: &str) -> (Catalogue, Vec<Finding>) {
    Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'Test'\n"),
        ("ch1/_chapter.toml", "title = 'One'\nnumber = 1\n"),
        ("ch1/x.toml", item),
    ])
}

/// An item with other quantities, another statement and other parts.
fn item(title: &str, quantities: &str, statement: &str, rest: &str) -> String {
    format!(
        "[item]\ntitle = '{title}'\nsource = 'by hand'\n\
         [parameters]\n\
         m = {{ value = '2 kg', range = '1 .. 5 kg', step = '0.5 kg' }}\n\
         k = {{ value = '800 N/m', range = '200 .. 900 N/m', step = '50 N/m' }}\n\
         [quantities]\n\
         omega_n = {{ formula = 'sqrt(k/m)', unit = 'rad/s' }}\n{quantities}\n\
         [statement]\ntext = '''{statement}'''\n\
         [[part]]\nkey = 'omega_n'\nask = 'Find it.'\n{rest}\n"
    )
}

/// What reading an item costs, and what is found.
fn read(item: &str) -> (u64, Vec<String>) {
    let read = within(MUCH, || bank(item).1);
    (
        read.units,
        read.value.iter().map(ToString::to_string).collect(),
    )
}

#[track_caller]
fn one(found: &[String], code: &str, words: &str) {
    assert!(
        found.len() == 1 && found[0].contains(code) && found[0].contains(words),
        "{found:#?}"
    );
}

#[test]
fn items_of_the_bank_stay_far_below_the_bounds() {
    for (path, text) in embedded() {
        if path.contains("/_") || !path.contains('/') {
            continue;
        }
        let (units, _) = read(text);
        assert!(units < 5_000_000, "reading {path} takes {units} units");
    }
}

#[test]
fn nested_functions_cost_what_they_are_long() {
    let nested = |depth: usize| {
        let text = include_str!("../fixtures/bounds/nested-sines.toml");
        let sines = format!("{}x{}", "sin(".repeat(18), ")".repeat(18));
        let deeper = format!("{}x{}", "sin(".repeat(depth), ")".repeat(depth));
        assert!(text.contains(&sines));
        let (units, found) = read(&text.replace(&sines, &deeper));
        assert!(found.is_empty(), "{found:?}");
        units
    };
    // The second derivative of n functions in each other has n² terms.
    let (few, many) = (nested(6), nested(18));
    assert!(many < 9 * few * 2, "{few} and {many} units");
}

#[test]
fn products_of_nested_roots_cost_more_than_flat_ones() {
    // As many products, of roots with `depth` further ones in them: which of two comes first, their inmost ends decide.
    let units = |depth: usize| {
        let root = |number: usize| {
            let open = "sqrt(1 + ".repeat(depth);
            format!("{open}sqrt({number} + x^2){}", ")".repeat(depth))
        };
        let sums =
            (0..8).map(|number| format!("({} + {})", root(2 * number), root(2 * number + 1)));
        let product = sums.collect::<Vec<_>>().join("*");
        let product = Expr::read(&product).expect("a formula");
        within(MUCH, || Normal::of(&product).is_ok()).units
    };
    let (flat, deep) = (units(0), units(20));
    assert!(deep > 2 * flat, "{flat} and {deep} units");
}

#[test]
fn nested_functions_before_factors_are_set_once() {
    let (catalogue, findings) = bank(include_str!("../fixtures/bounds/nested-products.toml"));
    assert!(findings.is_empty(), "{findings:?}");
    let template = catalogue.items().next().expect("it is sound");
    let instance = Instance::draw(template, Seed::new(7)).expect("it can be drawn");
    let solution = Solution::of(instance);
    // With each factor set twice this would be 4¹⁴ pieces.
    let key = Scene::of(&solution, Data::Both).key(0);
    assert!(key.is_ok());
}

#[test]
fn a_plot_that_takes_too_long_is_not_drawn_and_found() {
    let (catalogue, findings) = bank(include_str!("../fixtures/bounds/plot-of-integrals.toml"));
    assert!(findings.is_empty(), "{findings:?}");
    let template = catalogue.items().next().expect("it is sound");
    let solution = Solution::of(Instance::of_source(template));
    let drawn = within(MUCH, || Scene::of(&solution, Data::Both).plot("p"));
    assert!(matches!(drawn.value, Err(Undrawn::Work)));
    assert!(drawn.units <= 20_000_000, "{} units", drawn.units);
    let found: Vec<String> = undrawn(template).iter().map(ToString::to_string).collect();
    one(&found, "[bank::size]", "more than 20 million steps");
}

#[test]
fn values_of_one_set_of_data_share_their_bound() {
    let integrals: String = (0..300)
        .map(|number| {
            format!(
                "q{number} = {{ formula = 'integral(integral(sin(x*y) + {number}, x, 0, 1), y, 0, 1)', unit = '1' }}\n"
            )
        })
        .collect();
    let (catalogue, findings) = bank(&item("t", &integrals, "A block.", ""));
    assert!(findings.is_empty(), "{findings:?}");
    let template = catalogue.items().next().expect("it is sound");
    let checked = within(MUCH, || proof::findings(template, 5));
    assert!(checked.units <= 200_000_000, "{} units", checked.units);
    let found: Vec<String> = checked.value.iter().map(ToString::to_string).collect();
    one(&found, "[bank::size]", "more than 20 million steps");
}

#[test]
fn chains_are_bounded_whichever_way_they_are_written() {
    let link = |number: usize| {
        format!(
            "q{number} = {{ formula = 'q{} + 1', unit = '1' }}\n",
            number - 1
        )
    };
    let first = "q0 = { formula = 'm/1[kg]', unit = '1' }\n";
    let ascending: String = (1..250).map(link).collect();
    let descending: String = (1..250).rev().map(link).collect();
    for chain in [first.to_owned() + &ascending, descending + first] {
        let (_, found) = read(&item("t", &chain, "A block.", ""));
        one(
            &found,
            "[bank::cycle]",
            "on more than 200 quantities in a row",
        );
    }
    // The parameter at its beginning counts too.
    let short: String = (1..199).map(link).collect();
    let (_, found) = read(&item("t", &(first.to_owned() + &short), "A block.", ""));
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn what_is_larger_than_its_bound_is_found_and_not_read() {
    let parts: String = (0..5000)
        .map(|number| {
            format!("[[part]]\nid = 'p{number}'\nkey = 'omega_n'\nask = 'x'\nunit = 'rad/s'\n")
        })
        .collect();
    let quantities: String = (0..501)
        .map(|number| format!("q{number} = '{number}'\n"))
        .collect();
    let cases = [
        (
            item("t", "", "A block.", &parts[..200_000]),
            "entries, at most 100 are read",
        ),
        (
            item("t", "", "A block.", &parts),
            "bytes, at most 262144 are read",
        ),
        (
            item("t", &quantities, "A block.", ""),
            "`quantities` has 502 entries, at most 500",
        ),
        (
            item(&"t".repeat(301), "", "A block.", ""),
            "the title has 301 letters, at most 300",
        ),
        (
            item(&"t".repeat(1_000_000), "", "A block.", ""),
            "the file has 10",
        ),
    ];
    for (item, words) in cases {
        let (units, found) = read(&item);
        let found = found
            .iter()
            .filter(|finding| !finding.contains("[bank::syntax]"));
        one(&found.cloned().collect::<Vec<_>>(), "[bank::size]", words);
        assert_eq!(units, 0);
    }
    let (_, found) = read(&item("t", "", &"<< m >> ".repeat(20_000), ""));
    one(&found, "[text::markup]", "at most 65536 are read");
    // Findings themselves are counted.
    let (_, found) = read(&item("t", "", &"$ ".repeat(9_000), ""));
    assert_eq!(found.len(), 101);
    // Nor are places looked for of those that are not shown, which would take the square of them where escapes stand.
    let errors = Document::read(&"$\\foo ".repeat(9_000)).errors;
    assert!(errors.len() <= 101, "{}", errors.len());
    assert!(
        found
            .iter()
            .any(|finding| finding.contains("more than 100 findings"))
    );
}

#[test]
fn a_constraint_that_never_holds_is_an_error() {
    let never = item(
        "t",
        "",
        "A block.",
        "[constraints]\nheavy = 'm > 100[kg]'\n",
    );
    let (catalogue, findings) = bank(&never);
    assert!(findings.is_empty(), "{findings:?}");
    let template = catalogue.items().next().expect("it is sound");
    let checked = within(MUCH, || proof::findings(template, 200));
    let found: Vec<String> = checked.value.iter().map(ToString::to_string).collect();
    one(&found, "[check::draws]", "`heavy` was broken 1000 times");
    assert!(found[0].contains("error"), "{found:?}");
    assert!(checked.units < 2_000_000, "{} units", checked.units);
}

/// An item with a part of every kind.
#[test]
fn an_examination_ends_where_its_draws_take_too_much() {
    let (catalogue, findings) = bank(&item(
        "Costly",
        "",
        "<< m >>, << k >>",
        "mistakes = [{ answer = 'omega_n*integral(sin(1/y), y, 0, 1)', feedback = 'No.' }]",
    ));
    assert!(findings.is_empty(), "{findings:#?}");
    let item = catalogue.find("ch1/x").expect("it can be read");
    let examined = within(MUCH, || Examination::of(item, 200));
    assert!(examined.units < 100_000_000, "{} units", examined.units);
    let found: Vec<String> = examined
        .value
        .findings
        .iter()
        .map(ToString::to_string)
        .collect();
    let ended = |line: &String| line.contains("bank::size") && line.contains("were not examined");
    assert!(found.iter().any(ended), "{found:#?}");
    let survey = within(MUCH, || Survey::over(item, 200));
    assert!(survey.units < 100_000_000, "{} units", survey.units);
    assert!(survey.value.draws < 20);
}

fn kinds() -> Catalogue {
    let (catalogue, _) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'Test'\n"),
        ("kinds/_chapter.toml", "title = 'Kinds'\n"),
        (
            "kinds/item.toml",
            include_str!("../fixtures/kinds/item.toml"),
        ),
    ]);
    catalogue
}

#[test]
fn no_response_takes_much_work() {
    const PIECES: [&str; 34] = [
        "1;",
        "1,2;",
        "2 N/m, ",
        "[1,2],",
        "x1 = 1; ",
        "0.5 or ",
        "1<mu<2 or ",
        "(m+k)*",
        "sqrt(k/m)+",
        "sin(",
        "sqrt(1+",
        "exp(-t)*",
        "A*cos(2*t)+",
        "(t+1)^9*",
        "x1''+",
        "x1'*x2+",
        "m^",
        "1/(1+",
        "Omega*",
        "m*g/model.stiffness",
        "e^(i*t)+",
        "a<b<",
        "\\frac{1}{",
        "k*l/m+",
        "kN ",
        "abc ",
        "x<",
        "é",
        "\\mathrm{m}",
        "x''/x1+",
        "A* e^(i*t)+",
        "A^4 e^(2i t)+",
        "(A + B) e^((1+2i) t)+",
        "D(x1+",
    ];
    let catalogue = kinds();
    let template = catalogue.items().next().expect("it is sound");
    let solution = Solution::of(Instance::of_source(template));
    let mut most = (0, String::new());
    for place in 0..template.parts.len() {
        // The key is prepared once, and by itself.
        let _ = solution.marker(place);
        for piece in PIECES {
            let text = piece.repeat(MAX_RESPONSE_LENGTH / piece.len() / 3);
            let text = format!("{text}1{}", ")".repeat(text.matches('(').count()));
            let units = within(MUCH, || mark(&solution, place, &text)).units;
            if units > most.0 {
                let id = &template.parts[place].id;
                most = (units, format!("{piece} of {} bytes to {id}", text.len()));
            }
        }
    }
    assert!(most.0 > 0 && most.0 <= 1_000_000, "{most:?}");
}

#[test]
fn a_response_beyond_its_bound_is_not_read_and_leaves_no_trace() {
    let catalogue = kinds();
    let template = catalogue.items().next().expect("it is sound");
    let solution = Solution::of(Instance::of_source(template));
    let mut place = template.parts.iter();
    let place = place
        .position(|part| part.id == "formula")
        .expect("it is there");
    let right = "sqrt(k/m - c^2/(4*m^2))";
    let _ = solution.marker(place);
    let marked = within(10, || mark(&solution, place, right));
    assert!(marked.is_exhausted);
    assert_eq!(marked.value.verdict, Verdict::Unreadable);
    assert_eq!(mark(&solution, place, right).verdict, Verdict::Right);
}
