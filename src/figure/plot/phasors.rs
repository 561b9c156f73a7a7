//! Phasor diagrams: complex amplitudes as pointers in the complex plane, set off from the origin or tip to tail.

use std::f64::consts::PI;

use super::description::number;
use super::{CurveStyle, Picture, PlotError};
use crate::figure::arrow::{ArrowHead, Orbit, arrow, bent};
use crate::figure::story::{Pointer, Story};
use crate::figure::{Anchor, Bounds, Dash, Drawing, FigureLabel, Pen, Point, Spot, Weight, spots};
use crate::math::Math;
use crate::unit::{DecimalMark, Unit};

/// A phasor diagram.
#[derive(Clone, Debug)]
pub struct Phasors {
    /// The pointers, in the order in which they are joined.
    pub phasors: Vec<Phasor>,
    /// Angles about the origin.
    pub angles: Vec<PhasorAngle>,
    /// The unit of the pointers.
    pub unit: Unit,
    /// The decimal sign of the description.
    pub decimal: DecimalMark,
}

/// A pointer.
#[derive(Clone, Debug)]
pub struct Phasor {
    /// Real and imaginary part, in the unit of the diagram.
    pub value: Point,
    /// What stands at it.
    pub label: Option<Math>,
    /// Whether it begins at the tip of the one before.
    pub is_joined: bool,
    /// How it is drawn.
    pub style: CurveStyle,
}

/// An angle at the origin, from one direction to another the shorter way, in radians.
#[derive(Clone, Debug)]
pub struct PhasorAngle {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// What stands at it.
    pub label: Option<Math>,
}

/// Largest width of what the pointers span.
const WIDTH: f64 = 7.0;
/// Largest height of it.
const HEIGHT: f64 = 4.4;
/// How far the axes go beyond it.
const MARGIN: f64 = 0.45;
/// Radius of the arc of an angle; one more lies farther out.
const RADIUS: f64 = 0.75;
/// Pointers shorter than this share of the longest have no visible direction.
const MIN_SHARE: f64 = 1e-3;

impl Phasors {
    /// Draws the diagram, real parts to the right and imaginary parts upwards, in one scale.
    ///
    /// # Errors
    ///
    /// [`PlotError::Nothing`] where no pointer has a length.
    pub fn draw(&self) -> Result<Picture, PlotError> {
        let feet = self.feet();
        let tips = feet.iter().zip(&self.phasors);
        let tips: Vec<Point> = tips.map(|(foot, own)| *foot + own.value).collect();
        let origin = Point::new(0.0, 0.0);
        let span = tips
            .iter()
            .fold(Bounds::of(origin, origin), |span, tip| span.with(*tip));
        let lengths = self.phasors.iter().map(|own| own.value.length());
        let longest = lengths.fold(0.0_f64, f64::max);
        if !(longest > 0.0 && longest.is_finite()) {
            return Err(PlotError::Nothing);
        }
        // A pointer that lies along an axis leaves the other side without an extent.
        let room = |extent: f64, most: f64| most / extent.max(1e-3 * longest);
        let scale = room(span.width(), WIDTH).min(room(span.height(), HEIGHT));
        let mut drawing = Drawing::new();
        axes(&mut drawing, span, scale);
        for (number, (own, (foot, tip))) in
            self.phasors.iter().zip(feet.iter().zip(&tips)).enumerate()
        {
            if own.value.length() < MIN_SHARE * longest {
                continue;
            }
            drawing.belongs_to(number as u32 + 1);
            let (foot, tip) = (*foot * scale, *tip * scale);
            arrow(&mut drawing, foot, tip, pen(own.style), ArrowHead::USUAL);
            if let Some(label) = &own.label {
                // A short pointer among long ones has no room beside it.
                let near = spots::beside(foot, tip, 0.04, None).into_iter();
                let beyond = [0.1, 0.3].map(|gap| spots::around(tip, gap, None));
                let spots = near.chain(beyond.into_iter().flatten()).collect();
                drawing.place(FigureLabel::of(label), spots);
            }
        }
        for (number, turn) in self.angles.iter().enumerate() {
            drawing.belongs_to((self.phasors.len() + number) as u32 + 1);
            turn.draw(&mut drawing, RADIUS + 0.35 * number as f64);
        }
        drawing.settle();
        Ok(Picture {
            drawing,
            story: self.story(),
        })
    }

    /// Where each pointer begins.
    fn feet(&self) -> Vec<Point> {
        let mut tip = Point::new(0.0, 0.0);
        let mut feet = Vec::with_capacity(self.phasors.len());
        for own in &self.phasors {
            let foot = if own.is_joined {
                tip
            } else {
                Point::new(0.0, 0.0)
            };
            feet.push(foot);
            tip = foot + own.value;
        }
        feet
    }

    fn story(&self) -> Story {
        let pointers = self.phasors.iter().map(|own| Pointer {
            label: own.label.clone(),
            length: number(own.value.length(), self.unit, self.decimal),
            angle: degrees(own.value.angle(), self.decimal),
            is_joined: own.is_joined,
        });
        let angles = self.angles.iter();
        let angles = angles.map(|own| (own.label.clone(), degrees(own.turn(), self.decimal)));
        Story::Phasors {
            pointers: pointers.collect(),
            angles: angles.collect(),
        }
    }
}

impl PhasorAngle {
    /// How far it turns, from −π to π.
    fn turn(&self) -> f64 {
        let turn = self.to - self.from;
        if turn > PI {
            turn - 2.0 * PI
        } else if turn < -PI {
            turn + 2.0 * PI
        } else {
            turn
        }
    }

    fn draw(&self, drawing: &mut Drawing, radius: f64) {
        let to = self.from + self.turn();
        let orbit = Orbit {
            centre: Point::new(0.0, 0.0),
            radius,
            axis: None,
        };
        bent(drawing, orbit, self.from, to, Pen::new(Weight::Thin));
        if let Some(label) = &self.label {
            let middle = Point::at_angle(f64::midpoint(self.from, to));
            let out = [0.2, 0.3, 0.45, 0.65, 0.9].map(|more| radius + more);
            let places = out.into_iter().chain([radius - 0.25]);
            let places = places.map(|reach| Spot::new(middle * reach, Anchor::MIDDLE));
            let ends = [self.from, to].map(|end| Point::at_angle(end) * radius);
            let beside = ends
                .into_iter()
                .flat_map(|end| spots::around(end, 0.1, None));
            drawing.place(FigureLabel::of(label), places.chain(beside).collect());
        }
    }
}

/// The real and the imaginary axis through the origin, over what the pointers span.
fn axes(drawing: &mut Drawing, span: Bounds, scale: f64) {
    let (low, high) = (span.low * scale, span.high * scale);
    let real = [low.x - MARGIN, high.x + MARGIN].map(|x| Point::new(x, 0.0));
    let imaginary = [low.y - MARGIN, high.y + MARGIN].map(|y| Point::new(0.0, y));
    let pen = Pen::new(Weight::Hair);
    for ([from, to], name, anchor) in [
        (real, "Re", Anchor::LEFT),
        (imaginary, "Im", Anchor::BOTTOM),
    ] {
        arrow(drawing, from, to, pen, ArrowHead::USUAL);
        let beyond = (to - from).unit() * 0.12;
        drawing.text(FigureLabel::upright(name), to + beyond, anchor);
    }
}

fn pen(style: CurveStyle) -> Pen {
    let pen = Pen::new(Weight::Medium);
    match style {
        CurveStyle::Dashed => pen.dashed(Dash::Dashed),
        CurveStyle::Dotted => pen.dashed(Dash::Dotted),
        CurveStyle::Limit => Pen::new(Weight::Hair).dashed(Dash::Long),
        CurveStyle::Auto | CurveStyle::Solid | CurveStyle::Band => pen,
    }
}

/// `−28.1°`.
fn degrees(radians: f64, mark: DecimalMark) -> String {
    let unit = Unit::parse("deg").unwrap_or(Unit::ONE);
    number(unit.of_si(radians), unit, mark)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::symbol;

    fn phasor(x: f64, y: f64, is_joined: bool) -> Phasor {
        Phasor {
            value: Point::new(x, y),
            label: Some(symbol("F")),
            is_joined,
            style: CurveStyle::Auto,
        }
    }

    fn diagram(phasors: Vec<Phasor>) -> Phasors {
        Phasors {
            phasors,
            angles: Vec::new(),
            unit: Unit::parse("N").unwrap(),
            decimal: DecimalMark::Point,
        }
    }

    #[test]
    fn joined_pointers_begin_where_the_one_before_ends() {
        let chain = diagram(vec![
            phasor(3.0, 0.0, false),
            phasor(0.0, 4.0, true),
            phasor(1.0, 1.0, false),
        ]);
        let feet: Vec<[f64; 2]> = chain.feet().iter().map(|foot| [foot.x, foot.y]).collect();
        assert_eq!(feet, [[0.0, 0.0], [3.0, 0.0], [0.0, 0.0]]);
        let picture = chain.draw().unwrap();
        let Story::Phasors { pointers, .. } = &picture.story else {
            panic!("{:?}", picture.story);
        };
        let joined: Vec<(&str, &str, bool)> = pointers
            .iter()
            .map(|own| (&*own.length, &*own.angle, own.is_joined))
            .collect();
        assert_eq!(joined[1], ("4 N", "90°", true));
        let (width, height) = picture.drawing.size();
        assert!(width < 90.0 && height < 70.0, "{width} mm by {height} mm");
    }

    #[test]
    fn pointers_without_a_length_are_nothing_to_draw() {
        assert_eq!(
            diagram(vec![phasor(0.0, 0.0, false)]).draw().unwrap_err(),
            PlotError::Nothing
        );
        assert!(
            diagram(vec![phasor(2.0, 0.0, false), phasor(0.0, 0.0, true)])
                .draw()
                .is_ok()
        );
    }

    #[test]
    fn an_angle_turns_the_shorter_way() {
        let turn = PhasorAngle {
            from: 3.0,
            to: -3.0,
            label: None,
        };
        assert!((turn.turn() - (2.0 * PI - 6.0)).abs() < 1e-12);
    }
}
