//! What can be wrong with a system of several degrees of freedom.

use thiserror::Error;

/// A system that has no modes: its data contradict each other or leave the domain.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ModesError {
    /// There is nothing that moves.
    #[error("there is no mass")]
    NoMass,
    /// More degrees of freedom than can be solved in reasonable time.
    #[error("{count} degrees of freedom are more than the {limit} that are solved")]
    TooMany {
        /// Degrees of freedom given.
        count: usize,
        /// Most that are accepted.
        limit: usize,
    },
    /// A large system whose frequencies are too close or too far apart for the quick way.
    #[error(
        "the modes of these {count} degrees of freedom cannot be proven, since some lie too close together or too far apart; up to {limit} are solved whatever the data"
    )]
    NotProven {
        /// Degrees of freedom given.
        count: usize,
        /// Most that are solved without a proof.
        limit: usize,
    },
    /// More springs, dampers or squares than any system of this size needs.
    #[error("{count} elements are more than the {limit} that are accepted")]
    TooManyElements {
        /// Elements given.
        count: usize,
        /// Most that are accepted.
        limit: usize,
    },
    /// A node without mass, or with one that is negative or not finite.
    #[error("the mass of node {node} is {mass} kg: it must be positive and finite")]
    Mass {
        /// Node, counted from 1.
        node: usize,
        /// Its mass in kg.
        mass: f64,
    },
    /// A spring or damper ends at a node that does not exist.
    #[error(
        "element {element} ends at node {node}, but the nodes are 1 to {count}, and 0 for the ground"
    )]
    Node {
        /// Position of the spring or damper in its list, from 1.
        element: usize,
        /// The node it names.
        node: usize,
        /// Number of nodes.
        count: usize,
    },
    /// A spring or damper joins a node to itself.
    #[error("element {element} joins node {node} to itself")]
    Loop {
        /// Position of the spring or damper in its list, from 1.
        element: usize,
        /// The node at both ends.
        node: usize,
    },
    /// A stiffness or damping coefficient that is not finite, or a negative one where that has no meaning.
    #[error("the coefficient of element {element} is {value}")]
    Coefficient {
        /// Position of the element in its list, from 1.
        element: usize,
        /// The value that was given for it.
        value: f64,
    },
    /// A matrix or vector that does not fit the number of degrees of freedom.
    #[error("a matrix of {rows} by {columns} was given where the system asks for {size} by {size}")]
    Dimensions {
        /// Rows given.
        rows: usize,
        /// Columns given.
        columns: usize,
        /// Degrees of freedom.
        size: usize,
    },
    /// A vector of the wrong length.
    #[error("a vector of {length} components was given where the system asks for {size}")]
    Length {
        /// Components given.
        length: usize,
        /// Components needed.
        size: usize,
    },
    /// A matrix entry, initial value, force or time that is not finite.
    #[error("a value that is not finite was given")]
    NotFinite,
    /// A mass, damping or stiffness matrix that differs from its transpose.
    #[error("the matrix is not symmetric at row {row}, column {column}")]
    NotSymmetric {
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
    },
    /// Kinetic energy that is not positive for every motion.
    #[error("mass matrix not positive definite")]
    MassNotPositiveDefinite,
    /// Frequencies, shapes or displacements outside the range of binary64.
    #[error("the result is outside the range of numbers")]
    OutOfRange,
    /// A time so long that damping which couples the modes leaves hardly a digit of the motion.
    #[error("over {horizon} s the fastest of the coupled modes leaves no digits of the motion")]
    TooLong {
        /// The end of the motion, in s.
        horizon: f64,
    },
    /// A time before the start, or beyond the horizon for which the motion was prepared.
    #[error("the time {time} s is not between 0 and the horizon {horizon} s")]
    Time {
        /// The time asked for.
        time: f64,
        /// The last time that is answered.
        horizon: f64,
    },
    /// A harmonic force without damping at a natural frequency: there is no steady state.
    #[error("there is no steady state: the force acts at an undamped natural frequency")]
    Resonance,
}

impl ModesError {
    /// Refuses a size for which rotations take too long.
    pub(crate) fn refuse_unproven(count: usize) -> Result<(), Self> {
        let limit = super::MAX_WITHOUT_PROOF;
        if count > limit {
            return Err(Self::NotProven { count, limit });
        }
        Ok(())
    }
}
