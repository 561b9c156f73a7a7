//! What an author writes about a system.

use crate::expr::{Expr, Function, Name};
use crate::numerics::SortedMap;
use crate::source::Span;
use crate::unit::Dimension;

/// The physics of a system as it is written: energies, dissipation and forces over coordinates.
///
/// Names that are neither coordinates nor kinematic names are constants; a quantity that depends on
/// time or on a coordinate has to be substituted before.
///
/// ```
/// use vibank::expr::Expr;
/// use vibank::mechanics::{Coordinate, Definition};
/// let definition = Definition {
///     coordinates: vec![Coordinate::length("x")],
///     kinetic: Expr::name("m") * Expr::name("x").prime(1).squared() / Expr::number(2),
///     potential: Expr::name("k") * Expr::name("x").squared() / Expr::number(2),
///     ..Definition::default()
/// };
/// assert_eq!(definition.coordinates.len(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct Definition {
    /// The generalized coordinates, in order.
    pub coordinates: Vec<Coordinate>,
    /// What moves with the coordinates or is prescribed.
    pub kinematics: Vec<(Name, Expr)>,
    /// The kinetic energy T.
    pub kinetic: Expr,
    /// The potential energy V.
    pub potential: Expr,
    /// The dissipation function D, half the power lost.
    pub dissipation: Expr,
    /// Other generalized forces, by coordinate.
    pub forces: Vec<(Name, Expr)>,
    /// Dry friction, by coordinate.
    pub friction: Vec<(Name, Friction)>,
    /// The initial state, by coordinate.
    pub initial: Vec<(Name, Initial)>,
    /// The position about which to linearize, by coordinate, where it is stated.
    pub equilibrium: Vec<(Name, Expr)>,
    /// The bodies with their forces, for Newton's way to the same equations.
    pub bodies: Vec<Body>,
    /// The dimensions of the names that are constants, as far as they are known. They order products as
    /// textbooks do: what has mass first, then accelerations, lengths, times, numbers.
    pub dimensions: SortedMap<Name, Dimension>,
}

/// A generalized coordinate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coordinate {
    /// The name under which formulas of the model know it.
    pub name: Name,
    /// Of its positions: a length, or 1 for an angle.
    pub dimension: Dimension,
    /// Whether it is declared in units of an angle, so that positions a turn apart are the same.
    pub is_angle: bool,
    /// Where it is declared.
    pub span: Span,
}

impl Definition {
    /// The dry friction along a coordinate, with the sign of its velocity.
    pub(crate) fn friction_along(&self, name: &Name) -> Option<(&Friction, Expr)> {
        let (_, friction) = self.friction.iter().find(|(own, _)| own == name)?;
        let velocity = Expr::name(name.clone()).prime(1);
        Some((friction, Expr::call(Function::Sign, [velocity])))
    }
}

/// The size of the dry-friction force along a coordinate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Friction {
    /// While it slides.
    pub kinetic: Expr,
    /// The most it can be at rest; as large as the kinetic one if it is not given.
    pub holding: Option<Expr>,
}

/// The initial state along a coordinate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Initial {
    /// The position at t = 0, as the item states it.
    pub position: Expr,
    /// The velocity at t = 0, as the item states it.
    pub velocity: Expr,
}

/// A body that is cut free: how it moves, and the forces on it.
///
/// Forces that the balance at rest takes up are left out here as they are in the energies.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The name under which formulas of the model know it.
    pub name: Name,
    /// What it does: each displacement or angle, a coordinate or kinematic name, with its mass or moment of inertia.
    pub moves: Vec<(Name, Expr)>,
    /// Its forces, each with a component (force or moment) for each move.
    pub forces: Vec<(Name, Vec<Expr>)>,
    /// The forces of constraint, whose sizes the laws of motion have to give: tensions, reactions.
    pub unknowns: Vec<Name>,
    /// Where it is declared.
    pub span: Span,
}

impl Coordinate {
    /// A coordinate that is a displacement, in metres.
    pub fn length(name: impl Into<Name>) -> Self {
        Self::new(name, Dimension::LENGTH)
    }

    /// A coordinate of any dimension that is not an angle.
    pub fn new(name: impl Into<Name>, dimension: Dimension) -> Self {
        Self {
            name: name.into(),
            dimension,
            is_angle: false,
            span: Span::NONE,
        }
    }

    /// A coordinate that is a rotation, in radians.
    pub fn angle(name: impl Into<Name>) -> Self {
        Self {
            is_angle: true,
            ..Self::new(name, Dimension::PURE)
        }
    }
}

impl Default for Definition {
    /// No coordinates and no energies.
    fn default() -> Self {
        Self {
            coordinates: Vec::new(),
            kinematics: Vec::new(),
            kinetic: Expr::number(0),
            potential: Expr::number(0),
            dissipation: Expr::number(0),
            forces: Vec::new(),
            friction: Vec::new(),
            initial: Vec::new(),
            equilibrium: Vec::new(),
            bodies: Vec::new(),
            dimensions: SortedMap::new(),
        }
    }
}
