//! The formula language: read, resolve, check dimensions, evaluate, differentiate, simplify, typeset.
//!
//! A text is read into an [`Expr`] (an [`Equation`], an [`Interval`]), an immutable tree whose nodes know where they
//! were written. [`Expr::check`] resolves its names in a [`Scope`] and infers its [`Type`], form and dimensions, or
//! says all that is wrong with it. [`Program::compile`] makes a flat list of steps of it, with names explained by a
//! [`Binder`]: a name is an input of the program, or a formula that is put in, or a function of time that somebody
//! else computes. A program runs over any [`Scalar`]; [`Program::evaluate`] runs it in binary64 with a bound on the
//! error of every number, and again in double-double where that leaves something open, so that `0.3` and `3*0.1` tie
//! and results are right to the last digits. What has no finite value is an [`Absence`], with its reason and place.
//!
//! Nothing here knows items: who owns names gives a `Scope` and a `Binder`. Reading students' notation is not this
//! language either; that is `answer`'s.
//!
//! # Examples
//!
//! The period of a pendulum at a large angle, and its ratio to that at small ones.
//!
//! ```
//! use vibank_formula::expr::{Expr, Name, Precise, Program, Scope, Slots, Type, Workspace};
//! use vibank_dynamics::numerics::Rational;
//! use vibank_formula::unit::Dimension;
//!
//! struct Pendulum;
//!
//! impl Scope for Pendulum {
//!     fn name(&self, name: &Name) -> Option<Type> {
//!         match name.as_str() {
//!             "l" => Some(Type::real(Dimension::LENGTH)),
//!             "g" => Some(Type::real(Dimension::ACCELERATION)),
//!             "theta_0" => Some(Type::real(Dimension::PURE)),
//!             _ => None,
//!         }
//!     }
//!
//!     fn known(&self) -> Vec<String> {
//!         ["l", "g", "theta_0"].map(str::to_owned).to_vec()
//!     }
//! }
//!
//! let period = Expr::read("4*sqrt(l/g)*elliptic_k(sin(theta_0/2)^2)")?;
//! assert_eq!(period.check(&Pendulum).unwrap(), Type::real(Dimension::TIME));
//!
//! let program = Program::compile(&period, &Slots(&["l", "g", "theta_0"]))?;
//! let decimal = |text| Precise::from(Rational::from_decimal(text).unwrap());
//! let data = [decimal("0.8"), decimal("9.81"), decimal("1.5")];
//! let value = program.evaluate(&data, &mut Workspace::default())?;
//! assert!((value.as_real().unwrap() - 2.084_897_959_808_567_5).abs() < 1e-14);
//!
//! let findings = Expr::read("4*sqrt(l/g) + teta_0")?.check(&Pendulum).unwrap_err();
//! assert_eq!(findings[0].to_string(), "`teta_0` is not known here");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod build;
mod check;
mod constant;
mod function;
mod names;
mod number;
mod program;
mod read;
mod relation;
mod symbolic;
mod tolerance;
mod tree;
mod types;
mod typeset;

pub use check::{CheckError, Joint, Scope};
pub use constant::fold;
pub use function::Function;
pub use names::{Name, Names, Path};
pub use number::{Approx, Doubt, HyperDual, Precise, Real, Scalar, Undefined};
pub use program::{
    Absence, Binder, Binding, CompileError, Inputs, Outcome, Program, Registers, Slots, Sweep,
    Value, Workspace,
};
pub use read::ReadError;
pub use relation::{Equation, Interval};
pub use symbolic::sum_of_signed_terms;
pub use symbolic::{
    Harmonic, Normal, Order, Substitution, SymbolicError, Variable, differentiate, time_derivative,
};
pub use tree::{Constant, Expr, Kind, Operator, Relation};
pub use types::{AnyDimension, Field, Form, Shape, Type};
pub use typeset::{Notation, PlainNotation, Symbol, SymbolKind};
