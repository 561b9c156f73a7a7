//! Arithmetic on single entries, real or complex.

use super::assembler::Assembler;
use super::error::Result;
use super::instruction::{ProgramStep, Register};
use crate::expr::Function;

/// The register of a real number, or the two of a complex one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EntryRegister {
    pub(crate) real: Register,
    pub(crate) imaginary: Option<Register>,
}

impl EntryRegister {
    pub(crate) fn real(real: Register) -> Self {
        Self {
            real,
            imaginary: None,
        }
    }

    pub(crate) fn complex(real: Register, imaginary: Register) -> Self {
        Self {
            real,
            imaginary: Some(imaginary),
        }
    }

    pub(crate) fn is_complex(self) -> bool {
        self.imaginary.is_some()
    }

    pub(crate) fn add(self, other: Self, to: &mut Assembler) -> Result<Self> {
        let real = to.compute(ProgramStep::Add(self.real, other.real))?;
        let imaginary = match (self.imaginary, other.imaginary) {
            (Some(a), Some(b)) => Some(to.compute(ProgramStep::Add(a, b))?),
            (a, b) => a.or(b),
        };
        Ok(Self { real, imaginary })
    }

    pub(crate) fn subtract(self, other: Self, to: &mut Assembler) -> Result<Self> {
        let real = to.compute(ProgramStep::Subtract(self.real, other.real))?;
        let imaginary = match (self.imaginary, other.imaginary) {
            (Some(a), Some(b)) => Some(to.compute(ProgramStep::Subtract(a, b))?),
            (None, Some(b)) => Some(to.compute(ProgramStep::Negate(b))?),
            (a, None) => a,
        };
        Ok(Self { real, imaginary })
    }

    pub(crate) fn negate(self, to: &mut Assembler) -> Result<Self> {
        self.each(to, |to, part| to.compute(ProgramStep::Negate(part)))
    }

    pub(crate) fn multiply(self, other: Self, to: &mut Assembler) -> Result<Self> {
        match (self.imaginary, other.imaginary) {
            (Some(_), Some(_)) => {
                let (a, b) = (to.pair(self)?, to.pair(other)?);
                to.compute_pair(ProgramStep::ComplexMultiply(a, b))
            }
            (None, _) => other.each(to, |to, part| {
                to.compute(ProgramStep::Multiply(self.real, part))
            }),
            (_, None) => self.each(to, |to, part| {
                to.compute(ProgramStep::Multiply(part, other.real))
            }),
        }
    }

    pub(crate) fn divide(self, other: Self, to: &mut Assembler) -> Result<Self> {
        if other.is_complex() {
            let (a, b) = (to.pair(self)?, to.pair(other)?);
            return to.compute_pair(ProgramStep::ComplexDivide(a, b));
        }
        self.each(to, |to, part| {
            to.compute(ProgramStep::Divide(part, other.real))
        })
    }

    pub(crate) fn power_whole(self, exponent: i32, to: &mut Assembler) -> Result<Self> {
        match (exponent, self.imaginary) {
            (0, _) => Ok(Self::real(to.exact(1.0)?)),
            (1, _) => Ok(self),
            (2, None) => self.multiply(self, to),
            (_, None) => Ok(Self::real(
                to.compute(ProgramStep::PowerWhole(self.real, exponent))?,
            )),
            (_, Some(imaginary)) => to.compute_pair(ProgramStep::ComplexPowerWhole(
                [self.real, imaginary],
                exponent,
            )),
        }
    }

    pub(crate) fn power(self, exponent: Self, to: &mut Assembler) -> Result<Self> {
        if self.is_complex() || exponent.is_complex() {
            let (a, b) = (to.pair(self)?, to.pair(exponent)?);
            return to.compute_pair(ProgramStep::ComplexPower(a, b));
        }
        Ok(Self::real(
            to.compute(ProgramStep::Power(self.real, exponent.real))?,
        ))
    }

    /// A function that real and complex numbers have.
    pub(crate) fn function(self, function: Function, to: &mut Assembler) -> Result<Self> {
        match (function, self.imaginary) {
            (Function::Abs, Some(imaginary)) => {
                let step = ProgramStep::Binary(Function::Hypot, self.real, imaginary);
                Ok(Self::real(to.compute(step)?))
            }
            (_, Some(imaginary)) => {
                to.compute_pair(ProgramStep::ComplexUnary(function, [self.real, imaginary]))
            }
            (_, None) => Ok(Self::real(to.unary(function, self.real)?)),
        }
    }

    /// `re`, `im`, `arg`, `conj`.
    pub(crate) fn part(self, function: Function, to: &mut Assembler) -> Result<Self> {
        let [real, imaginary] = to.pair(self)?;
        Ok(match function {
            Function::Re => Self::real(real),
            Function::Im => Self::real(imaginary),
            Function::Arg => {
                Self::real(to.compute(ProgramStep::Binary(Function::Atan2, imaginary, real))?)
            }
            _ => match self.imaginary {
                Some(imaginary) => Self::complex(real, to.compute(ProgramStep::Negate(imaginary))?),
                None => self,
            },
        })
    }

    /// The same operation on both parts.
    fn each(
        self,
        to: &mut Assembler,
        operation: impl Fn(&mut Assembler, Register) -> Result<Register>,
    ) -> Result<Self> {
        let real = operation(to, self.real)?;
        let imaginary = match self.imaginary {
            Some(imaginary) => Some(operation(to, imaginary)?),
            None => None,
        };
        Ok(Self { real, imaginary })
    }
}
