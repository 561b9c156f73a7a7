//! Draws a plot: axes, curves, marks, and the labels at them.

use super::course::{CurveLine, area, lines, place};
use super::frame::Frame;
use super::lettering::{Letterer, Named};
use super::{CurveStyle, DASHES, Picture, Plot, PlotError, axis, description};
use crate::figure::story::Story;
use crate::figure::{Dash, Drawing, Fill, Path, Pen, Weight};
use crate::math::Math;

/// Radius of the dot of a mark.
const DOT: f64 = 0.07;

pub(crate) fn draw(plot: &Plot<'_>) -> Result<Picture, PlotError> {
    let (lines, frame) = lines(plot)?;
    let mut drawing = Drawing::new();
    let (up, moved) = axis_label(plot);
    for pair in lines.windows(2) {
        if pair[0].curve == pair[1].curve
            && let Some(area) = area(&pair[0], &pair[1], &frame)
        {
            drawing.fill(area, Fill::Tint);
        }
    }
    let ends = axis::draw(&mut drawing, &frame, plot, &up);
    let pens = pens(plot);
    // Thin lines first: what moves stands out over its limits.
    let mut order: Vec<&CurveLine> = lines.iter().collect();
    crate::numerics::sort_by_key(&mut order, |line| is_guide(plot, line));
    for line in order.into_iter().rev() {
        drawing.stroke(line.path(&frame), pens[line.curve]);
    }
    let mut letterer = Letterer::of(&frame, &lines, plot, ends);
    for (number, mark) in plot.marks.iter().enumerate() {
        match place(plot, mark.at).map(|at| frame.place(at)) {
            Some(at) if Frame::bounds().grown(1e-6).has(at) => {
                drawing.shape(Path::circle(at, DOT), None, Fill::Ink);
            }
            _ => {
                return Err(PlotError::Mark {
                    at: plot.marks[number].at,
                });
            }
        }
    }
    letterer.marks(&mut drawing, plot, &frame);
    letterer.curves(&mut drawing, &names(plot, moved));
    Ok(Picture {
        drawing,
        story: Story::Curves(description::of(plot, &lines, &up)),
    })
}

fn is_guide(plot: &Plot<'_>, line: &CurveLine) -> bool {
    matches!(
        plot.curves[line.curve].style,
        CurveStyle::Limit | CurveStyle::Band
    )
}

/// What the axis upwards counts: what it says itself, or the name of the only curve, which then needs none.
fn axis_label(plot: &Plot<'_>) -> (Math, Option<usize>) {
    if plot.y.label != Math::Row(Vec::new()) {
        return (plot.y.label.clone(), None);
    }
    let mut named = plot
        .curves
        .iter()
        .enumerate()
        .filter(|(_, curve)| is_named(curve));
    match (named.next(), named.next()) {
        (Some((number, curve)), None) => (
            curve.label.clone().unwrap_or(Math::Row(Vec::new())),
            Some(number),
        ),
        _ => (Math::Row(Vec::new()), None),
    }
}

/// Whether a curve, which is neither a limit nor a band, has a name.
fn is_named(curve: &super::Curve<'_>) -> bool {
    curve.label.is_some() && !matches!(curve.style, CurveStyle::Limit | CurveStyle::Band)
}

/// The names of the curves, with the pens in a legend if it comes to that.
fn names(plot: &Plot<'_>, moved: Option<usize>) -> Vec<Named> {
    let curves = plot.curves.iter().enumerate();
    let named = curves.filter(|(number, _)| Some(*number) != moved);
    named
        .filter_map(|(number, curve)| {
            Some(Named {
                curve: number,
                label: curve.label.clone()?,
                is_at_end: matches!(curve.style, CurveStyle::Limit | CurveStyle::Band),
            })
        })
        .collect()
}

/// The pen of each curve.
fn pens(plot: &Plot<'_>) -> Vec<Pen> {
    let mut dashes = DASHES.iter().cycle();
    let medium = Pen::new(Weight::Medium);
    plot.curves
        .iter()
        .map(|curve| curve.style)
        .map(|style| match style {
            CurveStyle::Auto => medium.dashed(*dashes.next().unwrap_or(&Dash::Solid)),
            CurveStyle::Solid => medium,
            CurveStyle::Dashed => medium.dashed(Dash::Dashed),
            CurveStyle::Dotted => medium.dashed(Dash::Dotted),
            CurveStyle::Limit => Pen::new(Weight::Hair).dashed(Dash::Long),
            CurveStyle::Band => Pen::new(Weight::Hair),
        })
        .collect()
}
