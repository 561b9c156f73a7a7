//! Free-body diagrams: what is read, what is refused, which way arrows point.

use vibank::bank::{Catalogue, Template};
use vibank::diagnostic::Severity;
use vibank::instance::Instance;
use vibank::scene::{Data, Scene, unfree};
use vibank::solution::Solution;

/// A block on a spring and a cord, over a disk with a hanging block.
const MODEL: &str = r#"
[model]
coordinates = { x = { name = "block, to the right", unit = "m" } }
kinematics  = { y = "x", theta = "x/r" }
kinetic     = "1/2*m*x'^2 + 1/2*M*y'^2 + 1/2*I*theta'^2"
potential   = "1/2*k*x^2 - M*g*y"
dissipation = "1/2*c*x'^2"
[model.bodies.block]
mass     = "m"
moves    = "x"
forces   = { spring = "-k*x", damper = "-c*x'", cord = "S1" }
unknowns = ["S1"]
[model.bodies.disk]
inertia  = "I"
moves    = "theta"
forces   = { cord_1 = "-S1*r", cord_2 = "S2*r" }
unknowns = ["S1", "S2"]
[model.bodies.hanging]
mass     = "M"
moves    = "y"
forces   = { weight = "M*g", cord = "-S2" }
unknowns = ["S2"]
"#;

const FIGURE: &str = r#"
[figure]
points = { B = [3, 2.5], D = [6.4, 1.8], H = [7.1, -0.6] }
elements = [
  { ground = ["[0, 3.6]", "[0, 2]"] },
  { spring = ["[0, 2.7]", "[2.4, 2.7]"], label = "k", id = "spring" },
  { damper = ["[0, 2.3]", "[2.4, 2.3]"], label = "c", id = "damper" },
  { block = "B", size = [1.2, 1], label = "m", id = "block" },
  { rod = ["[5.4, 1.8]", "D"] },
  { pulley = "D", radius = 0.7, id = "disk" },
  { cord = ["B.right", "D cw", "H"], id = "cord" },
  { block = "H", size = [1, 0.8], label = "M", id = "hanging" },
  { coordinate = "x", from = "B.top", direction = [1, 0] },
]
"#;

const FREE: &str = r#"
[figure.free.block]
arrows = [{ normal = "B.bottom" }]
[figure.free.disk]
links  = { cord_1 = "cord.first", cord_2 = "cord.last" }
arms   = { cord_1 = "r", cord_2 = "r" }
turn   = "cw"
arrows = [{ reaction = "D", direction = [0.6, 0.8] }]
[figure.free.hanging]
along  = [0, -1]
arrows = [{ weight = "H" }]
"#;

fn item(model: &str, figure: &str, free: &str) -> String {
    format!(
        "[item]\ntitle = 'T'\nsource = 'S'\n[parameters]\n\
         m = '1 kg'\nM = '1 kg'\nk = '100 N/m'\nc = '1 N s/m'\nr = '0.1 m'\nI = '0.01 kg m^2'\ng = '9.81 m/s^2'\n\
         {model}[statement]\ntext = 'X'\n{figure}{free}\
         [solution]\ntext = '''\n<< figure.free >>\n'''\n\
         [[part]]\nid = 'a'\nkey = '2*m'\nunit = 'kg'\nask = 'Y'\n"
    )
}

/// The template of an item, or the errors in it; what only shows in a drawing is one of them.
fn read(text: &str) -> Result<Catalogue, Vec<String>> {
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", include_str!("../fixtures/bank/bank.toml")),
        (
            "free/_chapter.toml",
            include_str!("../fixtures/bank/free/_chapter.toml"),
        ),
        ("free/bodies.toml", text),
    ]);
    let errors: Vec<String> = findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .map(|finding| format!("{}: {}", finding.code.name(), finding.message))
        .collect();
    if !errors.is_empty() {
        return Err(errors);
    }
    let unfree = unfree(&Solution::of(Instance::of_source(template(&catalogue))));
    match unfree {
        Some(finding) => Err(vec![format!(
            "{}: {}",
            finding.code.name(),
            finding.message
        )]),
        None => Ok(catalogue),
    }
}

fn template(catalogue: &Catalogue) -> &Template {
    catalogue.find("free/bodies").expect("it is read")
}

fn refused(model: &str, figure: &str, free: &str) -> String {
    match read(&item(model, figure, free)) {
        Ok(_) => "nothing".to_owned(),
        Err(errors) => errors.join("; "),
    }
}

#[test]
fn each_force_is_an_arrow_with_its_letter_and_direction() {
    let catalogue = read(&item(MODEL, FIGURE, FREE)).expect("nothing is wrong with it");
    let solution = Solution::of(Instance::of_source(template(&catalogue)));
    let scene = Scene::of(&solution, Data::Both);
    let picture = scene.free_picture().expect("it has one").expect("it holds");
    assert_eq!(
        picture.alt,
        "On the block m act the force of a spring k x to the left, the force of a damper c x dot to the left, \
         the force of a cord capital S sub 1 to the right and the normal force N upwards. \
         On the pulley act the force of a cord capital S sub 1 to the left, the force of a cord capital S sub 2 downwards \
         and the reaction R up and to the right. \
         On the block capital M act the weight capital M g downwards and the force of a cord capital S sub 2 upwards."
    );
    let figure = scene.picture().expect("it has a figure");
    let (spring, piston) = ("M0 -270L", "stroke-width=\"8\"");
    for link in [spring, piston] {
        assert!(
            figure.svg.contains(link) && !picture.svg.contains(link),
            "{link}"
        );
    }
}

#[test]
fn a_force_without_an_arrow_is_refused() {
    let free = FREE.replace("cord_1 = \"cord.first\", ", "");
    assert_eq!(
        refused(MODEL, FIGURE, &free),
        "figure::free: the force `cord_1` on `disk` has no arrow"
    );
    let figure = FIGURE.replace(", id = \"damper\"", "");
    assert_eq!(
        refused(MODEL, &figure, FREE),
        "figure::free: the force `damper` on `block` has no arrow"
    );
}

#[test]
fn a_link_without_a_force_is_refused() {
    let model = MODEL
        .replace(", damper = \"-c*x'\"", "")
        .replace("dissipation = \"1/2*c*x'^2\"\n", "");
    assert_eq!(
        refused(&model, FIGURE, FREE),
        "figure::free: the damper c is fastened to `block` and is not a force of the model"
    );
}

#[test]
fn an_arrow_does_the_work_of_its_force() {
    // What turns the other way.
    let free = FREE.replace("turn   = \"cw\"", "turn   = \"ccw\"");
    assert_eq!(
        refused(MODEL, FIGURE, &free),
        "figure::free: the cord of `cord_1` pushes `disk` where its letter is positive"
    );
    // A weight that would lift.
    let free = FREE.replace("along  = [0, -1]", "along  = [0, 1]");
    assert_eq!(
        refused(MODEL, FIGURE, &free),
        "figure::free: the arrow of `weight` on `hanging` does not do the work of the force in the model"
    );
    // A link across the motion.
    let figure = FIGURE.replace(
        "from = \"B.top\", direction = [1, 0]",
        "from = \"B.top\", direction = [0, 1]",
    );
    assert_eq!(
        refused(MODEL, &figure, FREE),
        "figure::free: the arrow of `spring` on `block` does not do the work of the force in the model"
    );
}

#[test]
fn what_is_no_force_of_the_model_does_no_work() {
    let free = FREE.replace(
        "{ normal = \"B.bottom\" }",
        "{ normal = \"B.bottom\", direction = [1, 0] }",
    );
    assert_eq!(
        refused(MODEL, FIGURE, &free),
        "figure::free: the normal force on `block` does work and is not a force of the model"
    );
}

#[test]
fn a_part_of_a_force_is_the_share_that_the_drawing_shows() {
    let slope = |angle: &str| {
        let model = "[model]\ncoordinates = { x = 'm' }\nkinetic = \"1/2*m*x'^2\"\n\
             potential = '1/2*k*x^2 - m*g*x*sin(0.5)'\n\
             [model.bodies.block]\nmass = 'm'\nmoves = 'x'\nforces = { weight = 'm*g*sin(0.5)', spring = '-k*x' }\n";
        let figure = format!(
            "[figure]\npoints = {{ u = '[cos({angle}), -sin({angle})]', B = [3, 2] }}\nelements = [\n\
             {{ block = 'B', size = [1, 0.8], angle = '-{angle}', id = 'block' }},\n\
             {{ spring = ['B - 3*u', 'B'], label = 'k', id = 'spring' }},\n\
             {{ arrow = ['B', 'B + u'], label = 'x' }},\n]\n"
        );
        let free = "[figure.free.block]\narrows = [{ weight = 'B', label = 'm*g' }]\n";
        refused(model, &figure, free)
    };
    assert_eq!(slope("0.5"), "nothing");
    assert_eq!(
        slope("0.7"),
        "figure::free: the arrow of `weight` on `block` does not do the work of the force in the model"
    );
}

#[test]
fn a_cord_over_a_kept_pulley_pulls_twice() {
    let model = "[model]\ncoordinates = { x = 'm' }\nkinematics = { z = '2*x' }\nkinetic = \"1/2*m*x'^2\"\n\
         potential = '1/2*k*z^2'\n\
         [model.bodies.block]\nmass = 'm'\nmoves = 'x'\nforces = { cord = '-2*k*z' }\n";
    let figure = "[figure]\npoints = { B = [5, 0.7], P = [4.4, 2.1] }\nelements = [\n\
         { block = 'B', size = [2, 1.4], label = 'm', id = 'block' },\n\
         { rod = ['P', '[4.4, 1.4]'], id = 'rod' },\n{ pulley = 'P', radius = 0.3, id = 'pulley' },\n\
         { cord = ['[0, 2.4]', 'P cw', '[0, 1.8]'], id = 'cord' },\n\
         { coordinate = 'x', from = 'B.right', direction = [1, 0] },\n]\n";
    let free = "[figure.free.block]\nkeep = ['block', 'rod', 'pulley']\n";
    let catalogue = read(&item(model, figure, free)).expect("nothing is wrong with it");
    let solution = Solution::of(Instance::of_source(template(&catalogue)));
    let picture = Scene::of(&solution, Data::Both).free_picture();
    assert_eq!(
        picture.expect("it has one").expect("it holds").alt,
        "On the block m act the force of a cord k z to the left and the force of a cord k z to the left."
    );
}

const TORSION: &str = "[model]\ncoordinates = { theta = 'rad' }\nkinetic = \"1/2*I*theta'^2\"\n\
     potential = '1/2*k*r^2*theta^2'\n\
     [model.bodies.body]\ninertia = 'I'\nmoves = 'theta'\nforces = { wire = '-k*r^2*theta' }\n";

/// A body on a wire, with the sense of its twist as it is shown.
fn on_a_wire(turn: &str) -> String {
    format!(
        "[figure]\npoints = {{ D = [3, 1] }}\nelements = [\n\
         {{ ground = ['[4, 4.4]', '[2, 4.4]'] }},\n{{ wire = ['[3, 4.4]', '[3, 1.3]'], id = 'wire' }},\n\
         {{ block = 'D', size = [3, 0.6], label = 'M', id = 'body' }},\n\
         {{ turn = [3, 3], {turn}, label = 'theta' }},\n]\n"
    )
}

#[test]
fn a_twisted_wire_leaves_a_moment_about_itself() {
    let free = "[figure.free.body]\narrows = [{ weight = 'D' }, { reaction = 'D.top', direction = [0, 1], label = \"'S'\" }]\n";
    let picture = |turn: &str| {
        let catalogue =
            read(&item(TORSION, &on_a_wire(turn), free)).expect("nothing is wrong with it");
        let solution = Solution::of(Instance::of_source(template(&catalogue)));
        let picture = Scene::of(&solution, Data::Both).free_picture();
        picture.expect("it has one").expect("it holds")
    };
    let (up, down) = (picture("axis = [0, 1]"), picture("axis = [0, -1]"));
    assert_eq!(
        up.alt,
        "On the block capital M act the moment k r squared theta of an elastic wire, against the sense of the twist, \
         the weight W downwards and the reaction S upwards."
    );
    // The arrow runs against the twist, whichever way that is.
    assert_eq!(up.alt, down.alt);
    assert_ne!(
        up.svg.split_once("</desc>").map(|own| own.1),
        down.svg.split_once("</desc>").map(|own| own.1)
    );
    // A turn in the plane of the drawing is none about the wire.
    assert_eq!(
        refused(TORSION, &on_a_wire("from = 20"), free),
        "figure::free: the arrow of `wire` on `body` does not do the work of the force in the model"
    );
}

#[test]
fn a_spring_along_a_ring_pulls_along_its_tangent() {
    let model = "[model]\ncoordinates = { x = 'm', y = 'm' }\nkinetic = \"1/2*m*x'^2 + 1/2*M*y'^2\"\n\
         potential = '1/2*k*(y - x)^2'\n\
         [model.bodies.first]\nmass = 'm'\nmoves = 'x'\nforces = { spring = 'k*(y - x)' }\n\
         [model.bodies.second]\nmass = 'M'\nmoves = 'y'\nforces = { spring = '-k*(y - x)' }\n";
    let figure = "[figure]\npoints = { O = [2.5, 2.5], A = [2.5, 4.3], B = [0.7, 2.5] }\nelements = [\n\
         { ring = 'O', radius = 1.8 },\n{ spring = ['A', 'B'], around = 'O', id = 'spring' },\n\
         { bob = 'A', label = 'm', id = 'first' }, { bob = 'B', label = 'M', id = 'second' },\n]\n";
    let free = |along: &str| {
        format!(
            "[figure.free.first]\nalong = {along}\n[figure.free.second]\nalong = [0, -1]\nshift = [-1, -1]\n"
        )
    };
    let catalogue = read(&item(model, figure, &free("[-1, 0]"))).expect("nothing is wrong with it");
    let solution = Solution::of(Instance::of_source(template(&catalogue)));
    let picture = Scene::of(&solution, Data::Both).free_picture();
    let alt = picture.expect("it has one").expect("it holds").alt;
    assert!(
        alt.starts_with("On the ball m acts the force of a spring") && alt.contains("to the left."),
        "{alt}"
    );
    assert!(alt.ends_with("upwards."), "{alt}");
    assert_eq!(
        refused(model, figure, &free("[0, 1]")),
        "figure::free: the arrow of `spring` on `first` does not do the work of the force in the model"
    );
}

#[test]
fn names_that_lead_nowhere_are_refused() {
    let named = |from: &str, to: &str| refused(MODEL, FIGURE, &FREE.replace(from, to));
    assert_eq!(
        named("cord_1 = \"cord.first\"", "cord_1 = \"core.first\""),
        "figure::free: no element of the figure has the id `core`; \
         figure::free: the force `cord_1` on `disk` has no arrow"
    );
    assert_eq!(
        named("arms   = { cord_1", "arms   = { rope = \"r\", cord_1"),
        "figure::free: the model has no force `rope` on `disk`"
    );
    assert_eq!(
        named("arms   = { cord_1 = \"r\"", "arms   = { cord_1 = \"m\""),
        "figure::free: the moment of `cord_1` on `disk` is not a force times `m`"
    );
    assert_eq!(
        named("turn   = \"cw\"\n", ""),
        "figure::free: the positive direction of `theta` is not known"
    );
    let (rest, _) = FREE
        .split_once("[figure.free.hanging]")
        .expect("it is there");
    assert_eq!(
        refused(MODEL, FIGURE, rest),
        "figure::free: the body `hanging` of the model is in no free-body diagram"
    );
    let figure = FIGURE.replace("id = \"damper\"", "id = \"spring\"");
    assert!(
        refused(MODEL, &figure, FREE).contains("two elements of the figure have the id `spring`")
    );
}
