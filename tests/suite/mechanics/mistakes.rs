//! What authors get wrong, and what is reported.

use vibank::diagnostic::Diagnose;
use vibank::expr::{Expr, Name};
use vibank::mechanics::{Coordinate, Definition, Model};
use vibank::unit::Dimension;

use super::{named, read};

/// A block on a spring with something changed.
fn derived(change: impl FnOnce(&mut Definition)) -> Vec<(String, String, String)> {
    let texts = ["1/2*m*x'^2", "1/2*k*x^2", "1/2*c*x'^2"];
    let mut definition = Definition {
        coordinates: vec![Coordinate::length("x")],
        kinetic: read(texts[0]),
        potential: read(texts[1]),
        dissipation: read(texts[2]),
        ..Definition::default()
    };
    let force = Dimension::FORCE;
    let dimensions = [
        ("m", Dimension::MASS),
        ("k", force / Dimension::LENGTH),
        ("c", force / Dimension::VELOCITY),
        ("g", Dimension::ACCELERATION),
        ("l", Dimension::LENGTH),
    ];
    definition.dimensions = dimensions.map(|(name, own)| (Name::from(name), own)).into();
    change(&mut definition);
    let sources = [
        &definition.kinetic,
        &definition.potential,
        &definition.dissipation,
    ];
    let sources: Vec<String> = sources.map(Expr::to_string).into();
    let errors = Model::derive(definition).err().unwrap_or_default();
    let place = |error: &dyn Diagnose| {
        let span = error.labels().first().map(|label| label.span);
        let span = span.filter(|span| !span.is_none())?;
        let found = sources.iter().find_map(|text| text.get(span.range()));
        found.map(str::to_owned)
    };
    let reported = errors.iter().map(|error| {
        (
            error.code().to_string(),
            error.to_string(),
            place(error).unwrap_or_default(),
        )
    });
    reported.collect()
}

fn check(change: impl FnOnce(&mut Definition), code: &str, message: &str) {
    let reported = derived(change);
    assert_eq!(reported.len(), 1, "{reported:?}");
    assert_eq!(
        (reported[0].0.as_str(), reported[0].1.as_str()),
        (code, message)
    );
}

#[test]
fn a_right_model_has_no_finding() {
    assert_eq!(derived(|_| {}), []);
}

#[test]
fn a_dimension_slip_points_at_the_term() {
    let reported = derived(|own| own.potential = read("1/2*k*x^2 - m*g"));
    let [(code, message, place)] = reported.as_slice() else {
        panic!("{reported:?}");
    };
    assert_eq!(code, "model::dimension");
    assert_eq!(message, "a term of `potential` is in N, due is J");
    assert_eq!(place, "m*g");
}

#[test]
fn each_kind_of_mistake_is_named() {
    check(
        |own| own.potential = read("-1/2*k*x^2"),
        "model::equilibrium",
        "`potential` has no lower bound along `x`",
    );
    check(
        |own| own.kinetic = read("1/2*m*x'^2 + 1/2*m*y'^2"),
        "model::coordinate",
        "`y'` in `kinetic`, but `y` is neither a coordinate nor in `kinematics`",
    );
    check(
        |own| own.kinetic = read("1/2*m*x'^4/(l*g)"),
        "model::kinetic",
        "`kinetic` is not quadratic in `x'`",
    );
    check(
        |own| own.kinetic = read("1/2*k*x^2"),
        "model::kinetic",
        "`kinetic` does not depend on `x'`: nothing has mass along `x`",
    );
    check(
        |own| own.forces = named(&[("y", "m*g")]),
        "model::coordinate",
        "`y` in `forces` is not a coordinate of this model",
    );
    check(
        |own| own.forces = named(&[("x", "m")]),
        "model::dimension",
        "a term of `forces` is in kg, due is N",
    );
    check(
        |own| own.kinematics = named(&[("y", "2*z"), ("z", "y/2")]),
        "model::coordinate",
        "`y` is defined by itself",
    );
    check(
        |own| own.coordinates.clear(),
        "model::coordinate",
        "a model has 1 to 16 coordinates, this one has 0",
    );
}

#[test]
fn a_model_without_equilibrium_has_a_mass_but_no_frequency() {
    let model = Model::derive(Definition {
        coordinates: vec![Coordinate::length("x")],
        kinetic: read("1/2*m*x'^2"),
        potential: read("-m*g*x"),
        ..Definition::default()
    })
    .unwrap();
    let check = |name: &str| model.check(model.quantity(&[Name::from(name)]).unwrap());
    assert!(check("mass").is_ok() && check("equation").is_ok());
    let error = check("natural_angular_frequency").unwrap_err();
    assert_eq!(error.code().to_string(), "model::equilibrium");
    assert_eq!(
        error.to_string(),
        "the model has no equilibrium: a constant force along `x` is not balanced"
    );
    assert_eq!(model.equation(0).unwrap().right.to_string(), "m*g");
}
