//! Marking formulas: the share of wrong verdicts and the time of one, on pairs of equal and of nearly equal formulas.

use vibank::answer::Verdict;
use vibank::bank::Catalogue;
use vibank::expr::{Expr, Precise, Program, Slots, Workspace};
use vibank::instance::Instance;
use vibank::response::Passage;
use vibank::solution::Solution;

use crate::measure::time;
use crate::record::{Error, Record};

/// A key with formulas that equal it and formulas that do not, each on its own line.
struct Corpus {
    key: &'static str,
    equal: &'static [&'static str],
    other: &'static [&'static str],
}

const CORPORA: [Corpus; 4] = [
    Corpus {
        key: "sqrt(k/m)",
        equal: &[
            "(k/m)^0.5",
            "sqrt(k)/sqrt(m)",
            "k/sqrt(k*m)",
            "1/sqrt(m/k)",
            "abs(sqrt(k/m))",
        ],
        other: &[
            "sqrt(m/k)",
            "1.000001*sqrt(k/m)",
            "sqrt(k/m)*1.0005",
            "-sqrt(k/m)",
            "sqrt(2*k/m)",
        ],
    },
    Corpus {
        key: "sqrt(4*k*m - c^2)/(2*m)",
        equal: &[
            "sqrt(k/m - (c/(2*m))^2)",
            "sqrt(k/m)*sqrt(1 - c^2/(4*k*m))",
            "1/2*sqrt(4*k/m - (c/m)^2)",
        ],
        other: &[
            "sqrt(k/m)",
            "sqrt(k/m - 2*(c/(2*m))^2)",
            "sqrt(k/m - (c/(2*m))^2)*1.000001",
            "sqrt(k/m)*(1 - c^2/(8*k*m))",
        ],
    },
    Corpus {
        key: "m*g*l*(1 - cos(theta))",
        equal: &[
            "2*m*g*l*sin(theta/2)^2",
            "m*g*l - m*g*l*cos(theta)",
            "m*g*l*(1 - cos(-theta))",
        ],
        other: &[
            "m*g*l*theta^2/2",
            "m*g*l*sin(theta)^2/(1 + cos(theta))*1.0003",
            "m*g*l*(1 + cos(theta))",
        ],
    },
    Corpus {
        key: "(x - l)^7",
        equal: &[
            "x^7 - 7*x^6*l + 21*x^5*l^2 - 35*x^4*l^3 + 35*x^3*l^4 - 21*x^2*l^5 + 7*x*l^6 - l^7",
            "-(l - x)^7",
        ],
        other: &[
            "(l - x)^7",
            "x^7 - 7*x^6*l + 21*x^5*l^2 - 35*x^4*l^3 + 35.00001*x^3*l^4 - 21*x^2*l^5 + 7*x*l^6 - l^7",
        ],
    },
];

const DATA: &str = r#"
[parameters]
m = "2 kg"
k = "800 N/m"
c = "4 N s/m"
l = "0.5 m"
g = "9.81 m/s^2"
[symbols]
x = "m"
theta = "rad"
"#;

/// The names in the formulas, in the order of sampled values.
const NAMES: [&str; 7] = ["m", "k", "c", "l", "g", "x", "theta"];

fn catalogue(key: &str) -> Catalogue {
    let item = format!(
        "[item]\ntitle = \"Test\"\nsource = \"test\"\n[statement]\ntext = \"Test.\"\n{DATA}\n[[part]]\nid = \"a\"\nkind = \"formula\"\nkey = \"{key}\"\nask = \"Which?\"\n"
    );
    let (catalogue, _) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = \"Test\"\n"),
        ("ch1/_chapter.toml", "title = \"Test\"\n"),
        ("ch1/test.toml", item.as_str()),
    ]);
    catalogue
}

/// Points whose coordinates are spread over [-2, 2], the same in every run.
fn points(count: usize) -> Vec<[f64; NAMES.len()]> {
    let mut state = 7_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 51) as f64 - 2.0
    };
    (0..count)
        .map(|_| std::array::from_fn(|_| next()))
        .collect()
}

/// The scheme that is common in exercise systems: formulas agree if their values do, at random points in [-2, 2], to a
/// relative tolerance. A point at which one of them has no value is passed over.
struct Sampling {
    tolerance: f64,
    points: Vec<[f64; NAMES.len()]>,
}

impl Sampling {
    fn accepts(&self, key: &Program, response: &str) -> bool {
        let Some(response) = compile(response) else {
            return false;
        };
        let mut room = Workspace::default();
        self.points.iter().all(|point| {
            let values = point.map(Precise::exact);
            let mut value = |program: &Program| program.evaluate_real(&values[..], &mut room).ok();
            match (value(key), value(&response)) {
                (Some(f), Some(g)) => (f - g).abs() <= self.tolerance * f.abs(),
                _ => true,
            }
        })
    }
}

fn compile(formula: &str) -> Option<Program> {
    Program::compile(&Expr::read(formula).ok()?, &Slots(&NAMES)).ok()
}

impl Corpus {
    /// All responses, each with whether it equals the key.
    fn responses(&self) -> impl Iterator<Item = (&'static str, bool)> {
        let equal = self.equal.iter().map(|response| (*response, true));
        equal.chain(self.other.iter().map(|response| (*response, false)))
    }

    /// Measures a checker; an item is one response, the error the share of wrong verdicts.
    fn measure(&self, method: &'static str, accepts: impl Fn(&str) -> bool) -> Record {
        let responses: Vec<_> = self.responses().collect();
        let wrong = responses
            .iter()
            .filter(|(response, equal)| accepts(response) != *equal);
        let share = wrong.count() as f64 / responses.len() as f64;
        let mut error = Error::computed(share);
        error.digits = 0;
        Record {
            task: "checker".to_owned(),
            case: self.key.replace(',', ";"),
            parameter: None,
            method,
            tolerance: None,
            timing: time(|item| accepts(responses[item % responses.len()].0)),
            error,
        }
    }
}

/// Formulas against prepared keys.
pub(crate) fn formulas(records: &mut Vec<Record>) {
    for corpus in CORPORA {
        let catalogue = catalogue(corpus.key);
        let solution = Solution::of(Instance::of_source(
            catalogue.items().next().expect("the item loads"),
        ));
        let marker = solution.marker(0).expect("the key exists");
        records.push(corpus.measure("vibank", |response| {
            marker.mark(Passage::of(response)).verdict == Verdict::Right
        }));
        let key = compile(corpus.key).expect("the key is a formula");
        for (method, count, tolerance) in [
            ("5 points, tolerance 1e-3", 5, 1e-3),
            ("8 points, tolerance 1e-9", 8, 1e-9),
        ] {
            let sampling = Sampling {
                tolerance,
                points: points(count),
            };
            records.push(corpus.measure(method, |response| sampling.accepts(&key, response)));
        }
    }
}
