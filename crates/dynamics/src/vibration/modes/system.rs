//! Masses and springs in the form in which they were given.
//!
//! The form matters: a network of springs determines its small frequencies to all digits, the matrix assembled from it
//! no longer does. A [`System`] therefore keeps springs as springs, squares as squares, and matrices as matrices.

use nalgebra::DMatrix;

use super::ModesError;
use crate::numerics::Dd;

/// Largest number of degrees of freedom that is accepted.
pub const MAX_DEGREES_OF_FREEDOM: usize = 2000;

/// Largest number of degrees of freedom whose modes are found whatever the data; those of larger systems where they can be
/// proven, as of most chains.
pub const MAX_WITHOUT_PROOF: usize = 256;

/// Largest number of springs, dampers or squares that is accepted.
pub const MAX_ELEMENTS: usize = 100_000;

/// A spring (N/m) or a viscous damper (N·s/m) between two nodes; node 0 is the ground, masses are nodes 1, 2, ....
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::modes::Link;
///
/// let spring = Link::between(1, 2, 400.0);
/// let wall = Link::to_ground(1, 250.0);
/// assert_eq!((spring.ends, wall.ends), ([1, 2], [1, 0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// The two nodes.
    pub ends: [usize; 2],
    /// Stiffness in N/m or damping coefficient in N·s/m.
    pub coefficient: f64,
}

impl Link {
    /// An element between two masses.
    pub fn between(first: usize, second: usize, coefficient: f64) -> Self {
        Self {
            ends: [first, second],
            coefficient,
        }
    }

    /// An element between a mass and the ground.
    pub fn to_ground(node: usize, coefficient: f64) -> Self {
        Self::between(node, 0, coefficient)
    }

    /// Checks a list of elements against the number of nodes.
    ///
    /// # Errors
    ///
    /// An end that does not exist, an element from a node to itself, a coefficient that is not finite.
    pub(crate) fn check_all(links: &[Self], nodes: usize) -> Result<(), ModesError> {
        check_count(links.len())?;
        for (i, link) in links.iter().enumerate() {
            let element = i + 1;
            let [first, second] = link.ends;
            if let Some(&node) = link.ends.iter().find(|&&node| node > nodes) {
                return Err(ModesError::Node {
                    element,
                    node,
                    count: nodes,
                });
            }
            if first == second {
                return Err(ModesError::Loop {
                    element,
                    node: first,
                });
            }
            if !link.coefficient.is_finite() {
                return Err(ModesError::Coefficient {
                    element,
                    value: link.coefficient,
                });
            }
        }
        Ok(())
    }

    /// Relative displacement of the ends.
    #[inline]
    pub(crate) fn elongation<T: Component>(&self, shape: &[T]) -> T {
        let [first, second] = self.displacements(shape);
        first - second
    }

    /// Displacements of the ends; that of the ground is zero.
    #[inline]
    pub(crate) fn displacements<T: Component>(&self, shape: &[T]) -> [T; 2] {
        self.ends
            .map(|node| node.checked_sub(1).map_or(T::default(), |i| shape[i]))
    }

    /// Adds the element to a symmetric matrix.
    pub(crate) fn stamp<T: Copy + std::ops::AddAssign<f64>>(
        &self,
        value: f64,
        matrix: &mut DMatrix<T>,
    ) {
        let nodes = self.ends.map(|node| node.checked_sub(1));
        for i in nodes.into_iter().flatten() {
            matrix[(i, i)] += value;
        }
        if let [Some(i), Some(j)] = nodes {
            matrix[(i, j)] += -value;
            matrix[(j, i)] += -value;
        }
    }
}

/// A component of a shape: a plain or a double-double number.
pub(crate) trait Component: Copy + Default + std::ops::Sub<Output = Self> {}
impl Component for f64 {}
impl Component for Dd {}

/// Kinetic energy: point masses, or a mass matrix.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Inertia {
    Masses(Vec<f64>),
    Matrix(DMatrix<f64>),
}

/// Potential energy: springs, squares `1/2 k (b·q)²` with the rows `b` of a matrix, or a stiffness matrix.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Stiffness {
    Springs(Vec<Link>),
    Squares {
        stiffnesses: Vec<f64>,
        rows: DMatrix<f64>,
    },
    Matrix(DMatrix<f64>),
}

/// An undamped linear system `M q'' + K q = 0`, checked.
///
/// # Examples
///
/// Two masses between two walls:
///
/// ```
/// use vibank_dynamics::vibration::modes::{Link, System};
///
/// let springs = [Link::to_ground(1, 100.0), Link::between(1, 2, 50.0), Link::to_ground(2, 100.0)];
/// let system = System::of_network(&[1.0, 1.0], &springs)?;
/// assert_eq!(system.degrees_of_freedom(), 2);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct System {
    pub(crate) inertia: Inertia,
    pub(crate) stiffness: Stiffness,
}

impl System {
    /// Point masses (kg) joined by springs. Springs may be negative; then the system may be unstable.
    ///
    /// # Errors
    ///
    /// No mass, a mass that is not positive, an end that does not exist, a spring from a node to itself, values that are not finite.
    pub fn of_network(masses: &[f64], springs: &[Link]) -> Result<Self, ModesError> {
        check_masses(masses)?;
        Link::check_all(springs, masses.len())?;
        Ok(Self {
            inertia: Inertia::Masses(masses.to_vec()),
            stiffness: Stiffness::Springs(springs.to_vec()),
        })
    }

    /// A mass matrix and a potential energy that is a sum of squares of linear forms,
    ///
    /// ```text
    /// V = Σ_s 1/2 k_s (Σ_i B_si q_i)²,    k_s >= 0.
    /// ```
    ///
    /// # Errors
    ///
    /// As [`System::of_matrices`]; a negative `k_s`.
    pub fn of_squares(
        mass: &DMatrix<f64>,
        rows: &DMatrix<f64>,
        stiffnesses: &[f64],
    ) -> Result<Self, ModesError> {
        let inertia = Inertia::of_matrix(mass)?;
        check_count(stiffnesses.len())?;
        if rows.shape() != (stiffnesses.len(), mass.nrows()) {
            let (rows, columns) = rows.shape();
            return Err(ModesError::Dimensions {
                rows,
                columns,
                size: mass.nrows(),
            });
        }
        if let Some(i) = stiffnesses
            .iter()
            .position(|k| !(k.is_finite() && *k >= 0.0))
        {
            return Err(ModesError::Coefficient {
                element: i + 1,
                value: stiffnesses[i],
            });
        }
        if rows.iter().any(|b| !b.is_finite()) {
            return Err(ModesError::NotFinite);
        }
        let stiffness = Stiffness::Squares {
            stiffnesses: stiffnesses.to_vec(),
            rows: rows.clone(),
        };
        Ok(Self { inertia, stiffness })
    }

    /// A mass matrix and a stiffness matrix.
    ///
    /// # Errors
    ///
    /// Matrices that are not square, symmetric and finite, or do not fit each other.
    /// That the mass matrix is positive definite is found out by [`Modes::of`](super::Modes::of).
    pub fn of_matrices(mass: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> Result<Self, ModesError> {
        let inertia = Inertia::of_matrix(mass)?;
        check_symmetric(stiffness, mass.nrows())?;
        Ok(Self {
            inertia,
            stiffness: Stiffness::Matrix(stiffness.clone()),
        })
    }

    /// Number of coordinates.
    pub fn degrees_of_freedom(&self) -> usize {
        match &self.inertia {
            Inertia::Masses(masses) => masses.len(),
            Inertia::Matrix(mass) => mass.nrows(),
        }
    }

    /// The mass matrix M, n × n, in kg (or kg·m² for angles).
    pub fn mass_matrix(&self) -> DMatrix<f64> {
        match &self.inertia {
            Inertia::Masses(masses) => {
                DMatrix::from_diagonal(&nalgebra::DVector::from_column_slice(masses))
            }
            Inertia::Matrix(mass) => mass.clone(),
        }
    }

    /// The stiffness matrix, each entry rounded once.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::{Link, System};
    ///
    /// let system = System::of_network(&[1.0, 2.0], &[Link::to_ground(1, 3.0), Link::between(1, 2, 5.0)])?;
    /// assert_eq!(system.stiffness_matrix().as_slice(), [8.0, -5.0, -5.0, 5.0]);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn stiffness_matrix(&self) -> DMatrix<f64> {
        match &self.stiffness {
            Stiffness::Matrix(stiffness) => stiffness.clone(),
            _ => self.exact_stiffness_matrix().map(Dd::hi),
        }
    }

    /// The stiffness matrix with the rounding errors of its sums.
    pub(crate) fn exact_stiffness_matrix(&self) -> DMatrix<Dd> {
        let size = self.degrees_of_freedom();
        match &self.stiffness {
            Stiffness::Springs(springs) => assembled(springs, size),
            Stiffness::Squares { stiffnesses, rows } => DMatrix::from_fn(size, size, |i, j| {
                (0..stiffnesses.len()).fold(Dd::ZERO, |sum, s| {
                    sum + Dd::product(rows[(s, i)], rows[(s, j)]) * stiffnesses[s]
                })
            }),
            Stiffness::Matrix(stiffness) => stiffness.map(Dd::from),
        }
    }
}

impl Inertia {
    /// A mass matrix; a diagonal one becomes point masses.
    fn of_matrix(mass: &DMatrix<f64>) -> Result<Self, ModesError> {
        check_symmetric(mass, mass.nrows())?;
        let diagonal: Vec<f64> = mass.diagonal().iter().copied().collect();
        if diagonal.iter().any(|&m| m <= 0.0) {
            return Err(ModesError::MassNotPositiveDefinite);
        }
        let coupled = (0..mass.nrows()).any(|i| (0..i).any(|j| mass[(i, j)] != 0.0));
        Ok(if coupled {
            Self::Matrix(mass.clone())
        } else {
            Self::Masses(diagonal)
        })
    }
}

/// The matrix of a list of springs or dampers, with the rounding errors of its sums.
pub(crate) fn assembled(links: &[Link], size: usize) -> DMatrix<Dd> {
    let mut matrix = DMatrix::from_element(size, size, Dd::ZERO);
    for link in links {
        link.stamp(link.coefficient, &mut matrix);
    }
    matrix
}

/// Checks that a matrix is square of the given size, symmetric and finite.
pub(crate) fn check_symmetric(matrix: &DMatrix<f64>, size: usize) -> Result<(), ModesError> {
    let (rows, columns) = matrix.shape();
    check_size(rows)?;
    if (rows, columns) != (size, size) {
        return Err(ModesError::Dimensions {
            rows,
            columns,
            size,
        });
    }
    if matrix.iter().any(|x| !x.is_finite()) {
        return Err(ModesError::NotFinite);
    }
    let pairs = (0..size).flat_map(|row| (0..row).map(move |column| (row, column)));
    match pairs
        .into_iter()
        .find(|&(i, j)| matrix[(i, j)] != matrix[(j, i)])
    {
        Some((row, column)) => Err(ModesError::NotSymmetric {
            row: row + 1,
            column: column + 1,
        }),
        None => Ok(()),
    }
}

fn check_size(count: usize) -> Result<(), ModesError> {
    match count {
        0 => Err(ModesError::NoMass),
        _ if count > MAX_DEGREES_OF_FREEDOM => Err(ModesError::TooMany {
            count,
            limit: MAX_DEGREES_OF_FREEDOM,
        }),
        _ => Ok(()),
    }
}

fn check_count(count: usize) -> Result<(), ModesError> {
    if count > MAX_ELEMENTS {
        return Err(ModesError::TooManyElements {
            count,
            limit: MAX_ELEMENTS,
        });
    }
    Ok(())
}

fn check_masses(masses: &[f64]) -> Result<(), ModesError> {
    check_size(masses.len())?;
    match masses.iter().position(|m| !(m.is_finite() && *m > 0.0)) {
        Some(i) => Err(ModesError::Mass {
            node: i + 1,
            mass: masses[i],
        }),
        None => Ok(()),
    }
}
