//! The figure of an item in motion: modes drawn on the system.

use super::Scene;
use super::notation::Symbols;
use crate::expr::Expr;
use crate::figure::{MovingFigure, Picture};
use crate::math::Math;
use crate::message::Phrase;
use crate::unit::{Decimal, Quantity, Unit};

/// Components of a mode shape as shares of the largest of their dimension, by their symbols.
type Shares = Vec<(Math, String)>;

pub(crate) fn picture(scene: &Scene<'_, '_>, number: usize) -> Option<Picture> {
    let figure = scene.solution.template().figure.as_ref()?;
    let (shape, shares) = mode(scene, number)?;
    let number = number + 1;
    let name = scene.language.phrase(&Phrase::Mode(number));
    let shown = Phrase::ModeShown {
        number,
        shape: &shares,
    };
    let alt = scene.language.phrase(&shown);
    let id = format!("{}-mode-{number}", scene.scope());
    let figure = MovingFigure::of(figure, scene).ok()??;
    Some(figure.extremes(&shape, (&id, &name, &alt)))
}

/// A mode shape in SI units, and its components as shares by their symbols: the largest length is 1, and the largest
/// angle.
fn mode(scene: &Scene<'_, '_>, number: usize) -> Option<(Vec<f64>, Shares)> {
    let numbers = scene.solution.evaluation().model("model")?;
    let modes = numbers.modes().ok()?;
    let shape = (number < modes.count()).then(|| modes.mode_shape(number))?;
    let coordinates = numbers.model().coordinate_dimensions();
    let shares = coordinates.iter().zip(&shape).map(|((name, own), part)| {
        let alike = coordinates.iter().zip(&shape);
        let alike = alike.filter(|((_, other), _)| other == own);
        let largest = alike.fold(0.0_f64, |largest, (_, part)| largest.max(part.abs()));
        let share = if largest > 0.0 { part / largest } else { 0.0 };
        let share = Decimal::rounded(share, 3).unwrap_or(Decimal::ZERO);
        let symbol = Expr::name(name.clone()).typeset(&Symbols(scene.solution));
        let share = Quantity::new(share, Unit::ONE).text(scene.solution.mark());
        (symbol, share)
    });
    let shares = shares.collect();
    Some((shape, shares))
}
