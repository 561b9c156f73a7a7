//! Figures that move: what the bank's do, what is read, what is refused.

use crate::BANK;
use vibank::bank::{Catalogue, Template};
use vibank::diagnostic::Severity;
use vibank::figure::{Head, ModelState, MovingFigure};
use vibank::instance::Instance;
use vibank::scene::{Data, Run, Scene};
use vibank::solution::Solution;

const HEAD: Head<'_> = Head {
    id: "a",
    title: "T",
    description: "",
};

fn moving(catalogue: &Catalogue) -> impl Iterator<Item = &Template> {
    let items = catalogue.items();
    items.filter(|item| item.figure.as_ref().is_some_and(|figure| figure.moves()))
}

/// How many coordinates its model has.
fn coordinates(item: &Template) -> usize {
    let model = item.graph.derived("model").expect("what moves has a model");
    model.degrees_of_freedom()
}

fn state(count: usize, moved: Option<usize>) -> ModelState {
    ModelState {
        coordinates: (0..count)
            .map(|place| if moved == Some(place) { 0.2 } else { 0.0 })
            .collect(),
        time: 0.0,
    }
}

#[test]
fn at_rest_a_figure_that_moves_is_as_it_stands() {
    let catalogue = &*BANK;
    for item in moving(catalogue) {
        let solution = Solution::of(Instance::of_source(item));
        let scene = Scene::of(&solution, Data::Both);
        let figure = item.figure.as_ref().expect("it moves");
        let still = figure.draw(&scene).expect("it is drawn").svg(&HEAD);
        let at = |moved| {
            let state = state(coordinates(item), moved);
            let figure = MovingFigure::of(figure, &scene).expect("it is drawn");
            figure.expect("it moves").displaced(&state).svg(&HEAD)
        };
        assert!(at(None) == still, "{} at rest", item.id);
        for moved in 0..coordinates(item) {
            assert!(
                at(Some(moved)) != still,
                "{}: coordinate {moved} moves nothing",
                item.id
            );
        }
    }
}

#[test]
fn modes_are_drawn_on_the_system() {
    let catalogue = &*BANK;
    let several = moving(catalogue).filter(|item| coordinates(item) > 1);
    for item in several {
        let solution = Solution::of(Instance::of_source(item));
        let scene = Scene::of(&solution, Data::Both);
        let still = scene.picture().expect("it has a figure");
        for mode in 0..coordinates(item) {
            let picture = scene.mode_picture(mode).expect("it has this mode");
            let id = &item.id;
            assert!(
                picture.svg.contains("stroke-opacity=\".45\""),
                "{id}: no extremes"
            );
            assert!(
                !picture.svg.contains("NaN") && picture.svg.len() < 60_000,
                "{id}"
            );
            assert!(
                picture.width < still.width + 20.0 && picture.width < 180.0,
                "{id}"
            );
        }
    }
    let item = catalogue
        .find("ch5/t1-three-equal-masses-chain")
        .expect("it is there");
    let solution = Solution::of(Instance::of_source(item));
    let scene = Scene::of(&solution, Data::Both);
    let alt = |mode| scene.mode_picture(mode).expect("it has three").alt;
    assert_eq!(
        alt(2),
        "The figure with both extremes of mode 3: x sub 1 0.707, x sub 2 −1.00, x sub 3 0.707."
    );
    assert!(scene.mode_picture(3).is_none());
}

#[test]
fn each_figure_that_moves_has_a_motion() {
    let catalogue = &*BANK;
    for item in moving(catalogue) {
        let solution = Solution::of(Instance::of_source(item));
        let scene = Scene::of(&solution, Data::Both);
        let runs = scene.runs();
        assert!(!runs.is_empty(), "{} has none", item.id);
        // Those between differ by their frequency alone.
        for run in [runs[0], runs[runs.len() - 1]] {
            let moving = scene.moving(run, "a").expect("what is offered is there");
            let frames = &moving.film.frames;
            let id = &item.id;
            assert!(
                moving.film.svg.contains("<g class=\"moving\"></g></svg>"),
                "{id}"
            );
            assert!(
                frames.iter().all(|frame| !frame.contains("NaN")),
                "{id} {run:?}"
            );
            assert!(
                frames.iter().any(|frame| frame != &frames[0]),
                "{id} {run:?} stands still"
            );
            for shares in &moving.shares {
                assert_eq!(shares.len(), frames.len());
                assert!(shares.iter().all(|share| share.abs() <= 1.0));
            }
        }
    }
}

#[test]
fn what_moves_follows_the_solver() {
    let catalogue = &*BANK;
    let scene = |id: &str, check: &dyn Fn(&Scene<'_, '_>)| {
        let item = catalogue.find(id).expect("it is there");
        let solution = Solution::of(Instance::of_source(item));
        check(&Scene::of(&solution, Data::Both));
    };
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-6, "{a} is not {b}");
    scene("ch5/t1-three-equal-masses-chain", &|scene| {
        assert_eq!(scene.runs(), [0, 1, 2].map(Run::Mode));
        let moving = scene.moving(Run::Mode(0), "a").expect("it has three");
        // k/m = 400/s², and the lowest of three equal masses is √((2 − √2)k/m).
        let period = std::f64::consts::TAU / ((2.0 - 2.0_f64.sqrt()) * 400.0).sqrt();
        close(moving.seconds, 2.0 * period);
        let quarter = moving.film.frames.len() / 4;
        for (shares, size) in moving
            .shares
            .iter()
            .zip([0.5_f64.sqrt(), 1.0, 0.5_f64.sqrt()])
        {
            close(shares[0], size);
            close(shares[quarter], -size);
        }
        // All three turn together, at each half period.
        assert_eq!(moving.turns.len(), 9);
    });
    scene("ch5/e6-coupled-pendulums-beats", &|scene| {
        let moving = scene.moving(Run::Start, "a").expect("it begins somewhere");
        // The first pendulum begins, and later the other one has all of it.
        let [first, second] = moving.shares.as_slice() else {
            panic!("there are two");
        };
        let most = (0..second.len()).max_by(|a, b| second[*a].abs().total_cmp(&second[*b].abs()));
        let most = most.expect("there are pictures");
        let around = most.saturating_sub(6)..(most + 6).min(first.len());
        let left = first[around]
            .iter()
            .fold(0.0_f64, |left, own| left.max(own.abs()));
        assert!(
            first[0] > 0.99 && second[0].abs() < 1e-6,
            "{} {}",
            first[0],
            second[0]
        );
        assert!(
            second[most].abs() > 0.9 && left < 0.4,
            "{} {left}",
            second[most]
        );
    });
}

/// A block on a spring, a disk with a cord, and a rod.
fn item(motion: &str) -> String {
    format!(
        "[item]\ntitle = 'T'\nsource = 'S'\n[parameters]\nm = '1 kg'\nk = '100 N/m'\nr = '0.1 m'\n\
         [model]\ncoordinates = {{ x = {{ name = 'block', unit = 'm' }} }}\n\
         kinematics = {{ theta = 'x/r' }}\nkinetic = \"1/2*m*x'^2\"\npotential = '1/2*k*x^2'\n\
         [statement]\ntext = 'X'\n\
         [figure]\npoints = {{ B = [3, 1], O = [6, 1] }}\nelements = [\n\
         {{ spring = ['[0, 1]', '[2.5, 1]'] }},\n{{ block = 'B', size = [1, 1] }},\n\
         {{ cord = ['B.right', 'O cw', '[6.5, -1]'] }},\n{{ pulley = 'O', radius = 0.5 }},\n]\n{motion}\
         [[part]]\nid = 'a'\nkey = '2*m'\nunit = 'kg'\nask = 'Y'\n"
    )
}

fn read(text: &str) -> (Catalogue, Vec<String>) {
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", include_str!("../fixtures/bank/bank.toml")),
        (
            "free/_chapter.toml",
            include_str!("../fixtures/bank/free/_chapter.toml"),
        ),
        ("free/item.toml", text),
    ]);
    let errors = findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .map(|finding| {
            let help = finding.help.as_deref().unwrap_or_default();
            format!("{}: {}; {help}", finding.code.name(), finding.message)
        });
    let errors = errors.collect();
    (catalogue, errors)
}

#[test]
fn links_go_with_the_bodies_that_they_touch() {
    let motion = "[figure.motion]\nB = ['x', 0]\nO = { turn = '-theta' }\nend = { at = [6.5, -1], shift = [0, '-x'] }\n";
    let (catalogue, errors) = read(&item(motion));
    assert!(errors.is_empty(), "{errors:?}");
    let item = catalogue.find("free/item").expect("it is read");
    let solution = Solution::of(Instance::of_source(item));
    let scene = Scene::of(&solution, Data::Both);
    let figure = item.figure.as_ref().expect("it has one");
    let state = ModelState {
        coordinates: vec![0.25],
        time: 0.0,
    };
    let figure = MovingFigure::of(figure, &scene).expect("it is drawn");
    let svg = figure.expect("it moves").displaced(&state).svg(&HEAD);
    // The block a quarter of a unit to the right, the end of the spring with it, the cord over the pulley as before.
    for piece in [
        "M275 -50L375 -50L375 -150L275 -150Z",
        "L275 -100",
        "M375 -",
        "A50 50 0 0 1 650 -100L650 125",
    ] {
        assert!(svg.contains(piece), "{piece} in {svg}");
    }
}

#[test]
fn what_cannot_move_is_a_finding_with_a_way_out() {
    let found = |motion: &str| {
        let (_, errors) = read(&item(&format!("[figure.motion]\n{motion}\n")));
        errors.join(" | ")
    };
    for (motion, expected) in [
        (
            "Q = ['x', 0]",
            "figure::place: `Q` is not a point of this figure; ",
        ),
        ("B = ['y', 0]", "`y`"),
        (
            "B = ['r', 0]",
            "figure::motion: r does not move: no coordinate of the model is in it; write it with x",
        ),
        ("B = [0, 0]", "figure::motion: this shift does not move"),
        (
            "B = ['theta', 0]",
            "expected a length; multiply the angle by a length",
        ),
        (
            "O = { turn = 'x' }",
            "expected an angle; divide the length by a radius",
        ),
        (
            "O = { turn = 'theta', about = 'Z' }",
            "`Z` is not a point of this figure",
        ),
        ("O = { turn = 'theta', round = 'B' }", "round"),
        ("O = 'theta'", "a shift, `[\"x\", 0]`, or a turn"),
    ] {
        let found = found(motion);
        assert!(found.contains(expected), "{motion}: {found}");
    }
    let text = item("[figure.motion]\nB = ['x', 0]\n");
    let (from, to) = (text.find("[model]"), text.find("[statement]"));
    let without = text.replace(&text[from.expect("there")..to.expect("there")], "");
    let (_, errors) = read(&without);
    assert!(
        errors.join(" ").contains("a figure moves by the coordinates of a model, and this item has none; declare `[model]`"),
        "{errors:?}"
    );
}
