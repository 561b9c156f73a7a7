//! Plots as an item declares them: which formulas are drawn against what.

use crate::figure::plot::CurveStyle;
use crate::math::Math;
use crate::quantity::NodeId;
use crate::unit::Unit;

/// A plot of an item.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Its name, as in `<< plots.name >>`.
    pub name: String,
    /// What it draws.
    pub kind: PlotKind,
}

/// What a plot draws.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum PlotKind {
    /// Quantities against a variable.
    Curves(Curves),
    /// The rate of a quantity against the quantity.
    PhasePlane(Curves),
    /// The mode shapes of a model.
    ModeShapes(ModeShapes),
    /// Complex amplitudes as pointers.
    Phasors(Phasors),
}

/// Curves over the range of a variable.
#[derive(Clone, Debug)]
pub struct Curves {
    /// The variable.
    pub x: Abscissa,
    /// The axis upwards.
    pub y: Ordinate,
    /// The curves in the order of the file, in which their dashes are given out.
    pub curves: Vec<Curve>,
    /// Points that are marked.
    pub marks: Vec<Mark>,
}

/// The variable of the curves and its axis.
#[derive(Clone, Debug)]
pub struct Abscissa {
    /// From where to where.
    pub range: [NodeId; 2],
    /// The unit in which the axis counts.
    pub unit: Unit,
    /// What stands at the axis.
    pub label: Math,
    /// The distance of ticks, and whether they are shares of π.
    pub ticks: Option<(NodeId, bool)>,
    /// Whether it is logarithmic.
    pub is_logarithmic: bool,
}

/// The axis of the values.
#[derive(Clone, Debug)]
pub struct Ordinate {
    /// The unit in which the axis counts.
    pub unit: Unit,
    /// In a phase plane, the unit of the rate.
    pub rate_unit: Unit,
    /// What stands at the axis; may be empty.
    pub label: Option<Math>,
    /// What is shown, if not all.
    pub range: Option<[NodeId; 2]>,
    /// Whether it is logarithmic.
    pub is_logarithmic: bool,
}

/// A curve of a plot, as the item declares it.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its value, or the two edges of a band, as a function of the variable.
    pub y: NodeId,
    /// In a phase plane, its rate.
    pub rate: Option<NodeId>,
    /// What stands at it.
    pub label: Option<Math>,
    /// How it is drawn.
    pub style: CurveStyle,
    /// Quantities that have other values for this curve.
    pub with: Vec<(NodeId, NodeId)>,
    /// From where to where of the variable it is drawn, if not over all of the axis.
    pub range: Option<[NodeId; 2]>,
}

/// A marked point.
#[derive(Clone, Debug)]
pub struct Mark {
    /// The place in the plane, as formulas of the item.
    pub at: [NodeId; 2],
    /// What stands at it.
    pub label: Option<Math>,
}

/// The mode shapes of a model.
#[derive(Clone, Debug)]
pub struct ModeShapes {
    /// The shapes, by rows.
    pub shapes: NodeId,
    /// The natural angular frequencies.
    pub frequencies: NodeId,
    /// The mass matrix, where the coordinates have several dimensions.
    pub masses: Option<NodeId>,
    /// The symbols of the coordinates.
    pub coordinates: Vec<Math>,
    /// The units of the components as shares of the first.
    pub units: Vec<Unit>,
}

/// Complex amplitudes as pointers in the complex plane.
#[derive(Clone, Debug)]
pub struct Phasors {
    /// The pointers.
    pub phasors: Vec<Phasor>,
    /// Angles about the origin.
    pub angles: Vec<Turn>,
    /// The unit of the pointers.
    pub unit: Unit,
}

/// A pointer.
#[derive(Clone, Debug)]
pub struct Phasor {
    /// The complex amplitude.
    pub of: NodeId,
    /// What stands at it.
    pub label: Option<Math>,
    /// Whether it begins at the tip of the one before.
    pub is_joined: bool,
    /// How it is drawn.
    pub style: CurveStyle,
}

/// An angle between the directions of two complex numbers.
#[derive(Clone, Debug)]
pub struct Turn {
    /// Where it begins and ends.
    pub ends: [NodeId; 2],
    /// What stands at it.
    pub label: Option<Math>,
}
