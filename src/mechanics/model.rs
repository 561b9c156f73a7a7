//! A model: what follows from the energies.

use super::definition::{Body, Definition, Friction, Initial};
use super::energy::written;
use super::equilibrium::{Balance, Equilibrium};
use super::error::{DefinitionKey, ModelError};
use super::evaluation::{Evaluation, ModelGiven};
use super::kinematics::Kinematics;
use super::lagrange::{Energies, position};
use super::linear::{Linear, Matrix};
use super::order::textbook;
use super::programs::Compiled;
use super::quantity::{Quantity, QuantityError};
use super::steps::{self, Letters, NewtonError, Step, Way};
use super::{Unavailable, dimensions, formulas};
use crate::expr::{Equation, Expr, Name, Normal, Order, Variable};
use crate::numerics::SortedSet;
use crate::unit::Dimension;

/// Most coordinates of a model.
pub(crate) const MAX_COORDINATES: usize = 16;

/// A mechanical or electrical system derived from its energies.
///
/// ```text
/// d/dt ∂T/∂q' − ∂T/∂q + ∂V/∂q + ∂D/∂q' = Q
/// ```
///
/// ```
/// use vibank::expr::Expr;
/// use vibank::mechanics::{Coordinate, Definition, Model};
/// let (m, k, x) = (Expr::name("m"), Expr::name("k"), Expr::name("x"));
/// let model = Model::derive(Definition {
///     coordinates: vec![Coordinate::length("x")],
///     kinetic: m * x.clone().prime(1).squared() / Expr::number(2),
///     potential: k * x.squared() / Expr::number(2),
///     ..Definition::default()
/// })
/// .unwrap();
/// assert_eq!(model.equation(0).unwrap().left.to_string(), "m*x'' + k*x");
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    pub(crate) definition: Definition,
    pub(crate) energies: Energies,
    pub(crate) equilibrium: Equilibrium,
    pub(crate) evaluation: Evaluation,
    pub(crate) residuals: Vec<Normal>,
    linear: Option<Linear>,
    /// Whether the equations are linear as they stand.
    is_linear: bool,
    order: Order,
}

impl Model {
    /// Derives everything that needs no numbers.
    ///
    /// # Errors
    ///
    /// All that is wrong with the definition.
    pub fn derive(definition: Definition) -> Result<Self, Vec<ModelError>> {
        let count = definition.coordinates.len();
        if count == 0 || count > MAX_COORDINATES {
            return Err(vec![ModelError::CoordinateCount {
                found: count,
                most: MAX_COORDINATES,
            }]);
        }
        let kinematics = Kinematics::of(&definition).map_err(|error| vec![error])?;
        let mut errors = dimensions::check(&definition);
        let energies = Energies::of(&definition, &kinematics, &mut errors);
        let friction = friction(&definition, &kinematics).map_err(|error| errors.push(error));
        let initial = initial(&definition, &kinematics).map_err(|error| errors.push(error));
        let (Some((energies, kinetic)), Ok(friction), Ok(initial), true) =
            (energies, friction, initial, errors.is_empty())
        else {
            return Err(errors);
        };
        Self::assemble(
            definition,
            &kinematics,
            energies,
            kinetic,
            friction,
            initial,
        )
        .map_err(|error| vec![error])
    }

    fn assemble(
        definition: Definition,
        kinematics: &Kinematics,
        energies: Energies,
        kinetic: Normal,
        friction: Vec<Option<Friction>>,
        initial: Vec<Initial>,
    ) -> Result<Self, ModelError> {
        let names = &energies.coordinates;
        let symbolic = ModelError::symbolic(DefinitionKey::Kinetic, definition.kinetic.span());
        let sums = energies.sums(kinetic).map_err(&symbolic)?;
        let residuals = energies.residuals(&sums).map_err(&symbolic)?;
        let balance = Balance::of(&residuals, names).map_err(&symbolic)?;
        check_bounded(&definition, &sums.potential, names)?;
        let equilibrium = balance.equilibrium(&definition, kinematics, names)?;
        let about = |position: &[Expr]| {
            Linear::about(&residuals, &balance, names, position).map_err(&symbolic)
        };
        let exact = Linear::exact(&residuals, names);
        let is_linear = exact.is_some();
        let (linear, varying) = match (exact, equilibrium.formula()) {
            (Some(exact), _) => (Some(exact), None),
            (None, Some(position)) => (about(position)?, None),
            // With the coordinates themselves substituted, the coefficients stay functions of the position.
            (None, None) => {
                let anywhere: Vec<_> = names.iter().cloned().map(Expr::name).collect();
                (None, about(&anywhere)?)
            }
        };
        let given = ModelGiven {
            energies: &energies,
            residuals: &residuals,
            balance: &balance,
            equilibrium: &equilibrium,
            friction: &friction,
            initial: &initial,
        };
        Ok(Self {
            evaluation: Evaluation::of(&given, linear.as_ref().or(varying.as_ref()))
                .map_err(&symbolic)?,
            order: textbook(&definition),
            definition,
            energies,
            equilibrium,
            residuals,
            linear,
            is_linear,
        })
    }

    /// The names of the coordinates, in order.
    pub fn coordinates(&self) -> &[Name] {
        &self.energies.coordinates
    }

    /// The coordinates with their dimensions, in order.
    pub(crate) fn coordinate_dimensions(&self) -> Vec<(Name, Dimension)> {
        let own = self.definition.coordinates.iter();
        own.map(|own| (own.name.clone(), own.dimension)).collect()
    }

    /// Whether it says where its motion begins.
    pub(crate) fn has_start(&self) -> bool {
        !self.definition.initial.is_empty()
    }

    /// A formula over what moves with the coordinates in place of the kinematic names; nothing where it cannot be
    /// written so.
    pub(crate) fn in_coordinates(&self, formula: &Expr) -> Option<Expr> {
        let kinematics = Kinematics::of(&self.definition).ok()?;
        kinematics.apply(DefinitionKey::Kinematics, formula).ok()
    }

    /// The bodies whose laws of motion are declared.
    pub fn bodies(&self) -> &[Body] {
        &self.definition.bodies
    }

    /// The number of degrees of freedom.
    pub fn degrees_of_freedom(&self) -> usize {
        self.energies.coordinates.len()
    }

    /// The names that have to be given numbers, sorted.
    pub fn names(&self) -> &[Name] {
        &self.evaluation.slots.constants
    }

    /// The kinetic energy in coordinates and velocities: as written, with the kinematics substituted.
    pub fn kinetic(&self) -> Expr {
        written(
            &self.energies.kinetic,
            &self.definition.kinetic,
            &self.order,
        )
    }

    /// The potential energy in the coordinates.
    pub fn potential(&self) -> Expr {
        written(
            &self.energies.potential,
            &self.definition.potential,
            &self.order,
        )
    }

    /// The dissipation function in the velocities.
    pub fn dissipation(&self) -> Expr {
        written(
            &self.energies.dissipation,
            &self.definition.dissipation,
            &self.order,
        )
    }

    /// The equation of motion along one coordinate, linearized about the equilibrium; constants and
    /// functions of time stand on the right. Nothing where that position has no formula, or time stands
    /// beside a coordinate.
    pub fn equation(&self, coordinate: usize) -> Option<Equation> {
        let linear = self.linear.as_ref()?;
        let left = linear.left(coordinate, self.coordinates()).ok()?;
        let right = linear.excitation.get(coordinate)?;
        Some(Equation {
            left: left.to_expr(&self.order),
            right: right.to_expr(&self.order),
        })
    }

    /// Lagrange's equation along one coordinate, as it is.
    pub(crate) fn full_equation(&self, coordinate: usize) -> Option<Equation> {
        let moving: SortedSet<_> = self.coordinates().iter().cloned().collect();
        let (left, right) = self.residuals.get(coordinate)?.split_by(&moving);
        Some(Equation {
            left: left.to_expr(&self.order),
            right: right.negated().to_expr(&self.order),
        })
    }

    /// The mass matrix as a formula.
    pub fn mass_matrix(&self) -> Option<Expr> {
        self.matrix(|linear| &linear.mass)
    }

    /// The damping matrix as a formula.
    pub fn damping_matrix(&self) -> Option<Expr> {
        self.matrix(|linear| &linear.damping)
    }

    /// The stiffness matrix as a formula.
    pub fn stiffness_matrix(&self) -> Option<Expr> {
        self.matrix(|linear| &linear.stiffness)
    }

    /// The equilibrium, one formula per coordinate, if it has them.
    pub fn equilibrium(&self) -> Option<Vec<Expr>> {
        let position = self.equilibrium.formula()?;
        let written = |own: &Expr| Normal::of(own).map(|own| own.to_expr(&self.order));
        position.iter().map(|own| written(own).ok()).collect()
    }

    /// M, C and K of a model of one coordinate as formulas.
    pub(crate) fn coefficients(&self) -> Result<[Normal; 3], Unavailable> {
        if self.degrees_of_freedom() > 1 {
            return Err(Unavailable::SeveralCoordinates);
        }
        let linear = self.linear.as_ref().ok_or(Unavailable::NoFormula)?;
        Ok([&linear.mass, &linear.damping, &linear.stiffness].map(|own| own[0][0].clone()))
    }

    /// A formula in the order of the model.
    pub(crate) fn written(&self, formula: &Normal) -> Expr {
        formula.to_expr(&self.order)
    }

    /// The squares of which V is the sum, if it is one.
    pub(crate) fn squares(&self) -> Option<&Compiled> {
        self.evaluation.squares(&self.energies)
    }

    /// Whether the equations are linear without an approximation.
    pub(crate) fn is_linear(&self) -> bool {
        self.is_linear
    }

    pub(crate) fn linear(&self) -> Option<&Linear> {
        self.linear.as_ref()
    }

    pub(crate) fn order(&self) -> &Order {
        &self.order
    }

    fn matrix(&self, of: impl Fn(&Linear) -> &Matrix) -> Option<Expr> {
        let rows = of(self.linear.as_ref()?).iter();
        Some(Expr::array(
            rows.map(|row| {
                let entries = row.iter().map(|own| own.to_expr(&self.order));
                Expr::array(entries.collect::<Vec<_>>())
            })
            .collect::<Vec<_>>(),
        ))
    }

    /// A quantity as a formula in the names of the model, where it has one.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoFormula`] where it has none, [`Unavailable::SeveralCoordinates`].
    pub fn formula(&self, quantity: Quantity) -> Result<Expr, Unavailable> {
        formulas::formula(self, quantity)
    }

    /// The equations that a quantity is: one, or one per coordinate, with dry friction on the right.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoFormula`].
    pub fn equations(&self, quantity: Quantity) -> Result<Vec<Equation>, Unavailable> {
        formulas::equations(self, quantity)
    }

    /// The quantity that a path names, without its beginning (`model` or `models.<name>`).
    ///
    /// ```
    /// use vibank::expr::{Expr, Name};
    /// use vibank::mechanics::{Coordinate, Definition, Model, Quantity};
    /// let model = Model::derive(Definition {
    ///     coordinates: vec![Coordinate::length("x1"), Coordinate::length("x2")],
    ///     kinetic: Expr::read("1/2*m*(x1'^2 + x2'^2)")?,
    ///     ..Definition::default()
    /// })
    /// .unwrap();
    /// let path = ["motion", "x2"].map(Name::from);
    /// assert_eq!(model.quantity(&path)?, Quantity::Motion(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A name that is not a quantity of this model, or a coordinate that is missing or unknown.
    pub fn quantity(&self, path: &[Name]) -> Result<Quantity, QuantityError> {
        Quantity::of(self, path)
    }

    /// The lines of a derivation in letters; none for [`Way::TurningPoints`], which needs numbers. For [`Way::Static`] see
    /// `Model::statics`, which needs a second model.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoFormula`] where an equation has no closed form, [`Unavailable::SeveralCoordinates`], and what stands in the
    /// way of calculating with the formulas.
    pub fn derivation(&self, way: Way) -> Result<Vec<Step>, Unavailable> {
        steps::derivation(self, way)
    }

    /// The lines of the balance at rest of a model with weights and pre-stretches, and of what is left of it in motion,
    /// which has to be `reduced`, the model without them. `letters` says what its letters for static stretches stand for.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NotAtRest`] if forces are left at rest, [`Unavailable::NothingStatic`] if none are balanced,
    /// [`Unavailable::AnotherMotion`] if the motion is not that of `reduced`, and what stands in the way of calculating with the
    /// formulas.
    pub(crate) fn statics(
        &self,
        reduced: &Self,
        letters: &Letters,
    ) -> Result<Vec<Step>, Unavailable> {
        steps::statics(self, reduced, letters)
    }

    /// Proves that the laws of the bodies are the equations of the energies: for each coordinate the sum over the bodies
    /// of ∂(move)/∂q times (inertia − forces) is the left side of Lagrange's equation, and no force of constraint is left.
    ///
    /// # Errors
    ///
    /// What does not agree.
    pub(crate) fn prove_newton(&self) -> Result<(), NewtonError> {
        steps::prove_newton(self)
    }

    /// Whether a quantity can exist: most need an equilibrium.
    ///
    /// # Errors
    ///
    /// [`ModelError::NoEquilibrium`].
    pub fn check(&self, quantity: Quantity) -> Result<(), ModelError> {
        match &self.equilibrium {
            Equilibrium::Missing(name) if quantity.needs_rest() => Err(ModelError::NoEquilibrium {
                name: name.clone(),
                span: self.definition.potential.span(),
            }),
            _ => Ok(()),
        }
    }
}

fn friction(
    definition: &Definition,
    kinematics: &Kinematics,
) -> Result<Vec<Option<Friction>>, ModelError> {
    let mut all = vec![None; definition.coordinates.len()];
    for (name, friction) in &definition.friction {
        let at = position(definition, name, DefinitionKey::Friction, &friction.kinetic)?;
        let apply = |formula: &Expr| kinematics.apply(DefinitionKey::Friction, formula);
        all[at] = Some(Friction {
            kinetic: apply(&friction.kinetic)?,
            holding: friction.holding.as_ref().map(apply).transpose()?,
        });
    }
    Ok(all)
}

fn initial(definition: &Definition, kinematics: &Kinematics) -> Result<Vec<Initial>, ModelError> {
    let at_rest = Initial {
        position: Expr::number(0),
        velocity: Expr::number(0),
    };
    let mut all = vec![at_rest; definition.coordinates.len()];
    for (name, initial) in &definition.initial {
        let at = position(definition, name, DefinitionKey::Initial, &initial.position)?;
        all[at] = Initial {
            position: kinematics.apply(DefinitionKey::Initial, &initial.position)?,
            velocity: kinematics.apply(DefinitionKey::Initial, &initial.velocity)?,
        };
    }
    Ok(all)
}

/// A potential energy that is a polynomial whose highest even power has only negative coefficients falls
/// without bound for all positive data: most likely a slipped sign.
fn check_bounded(
    definition: &Definition,
    potential: &Normal,
    coordinates: &[Name],
) -> Result<(), ModelError> {
    let span = definition.potential.span();
    for name in coordinates {
        let powers = potential
            .powers_of(&Variable::of(name, 0))
            .unwrap_or_default();
        let Some((exponent, coefficient)) = powers.last() else {
            continue;
        };
        let is_even =
            exponent.is_integer() && exponent.numerator() > 0 && exponent.numerator() % 2 == 0;
        if is_even && coefficient.has_negative_coefficients_alone() {
            return Err(ModelError::Unbounded {
                name: name.clone(),
                span,
            });
        }
    }
    Ok(())
}
