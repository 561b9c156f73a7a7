//! The functions of the formula language.

/// A function that formulas may call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Principal square root.
    Sqrt,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Decimal logarithm.
    Log10,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Inverse hyperbolic sine.
    Asinh,
    /// Inverse hyperbolic cosine.
    Acosh,
    /// Inverse hyperbolic tangent.
    Atanh,
    /// Magnitude.
    Abs,
    /// Angle of the point (x, y), written `atan2(y, x)`.
    Atan2,
    /// √(x² + y²).
    Hypot,
    /// Smallest.
    Min,
    /// Largest.
    Max,
    /// `clamp(x, lo, hi)`.
    Clamp,
    /// −1, 0 or 1.
    Sign,
    /// Largest integer below.
    Floor,
    /// Smallest integer above.
    Ceil,
    /// Nearest integer, halves away from zero.
    Round,
    /// `mod(x, n)`, with the sign of n.
    Mod,
    /// Complete elliptic integral of the first kind, of the parameter m = k².
    EllipticK,
    /// The same of the complementary parameter p = 1 − m, which keeps its digits next to m = 1.
    EllipticKm1,
    /// Real part.
    Re,
    /// Imaginary part.
    Im,
    /// Argument in (−π, π].
    Arg,
    /// Complex conjugate.
    Conj,
    /// Transpose of a matrix.
    Transpose,
    /// Determinant.
    Det,
    /// Scalar product.
    Dot,
    /// Euclidean norm.
    Norm,
}

/// Name in formulas, and the smallest and largest number of arguments.
type FunctionRow = (Function, &'static str, usize, usize);

const TABLE: &[FunctionRow] = &[
    (Function::Sqrt, "sqrt", 1, 1),
    (Function::Exp, "exp", 1, 1),
    (Function::Ln, "ln", 1, 1),
    (Function::Log10, "log10", 1, 1),
    (Function::Sin, "sin", 1, 1),
    (Function::Cos, "cos", 1, 1),
    (Function::Tan, "tan", 1, 1),
    (Function::Asin, "asin", 1, 1),
    (Function::Acos, "acos", 1, 1),
    (Function::Atan, "atan", 1, 1),
    (Function::Sinh, "sinh", 1, 1),
    (Function::Cosh, "cosh", 1, 1),
    (Function::Tanh, "tanh", 1, 1),
    (Function::Asinh, "asinh", 1, 1),
    (Function::Acosh, "acosh", 1, 1),
    (Function::Atanh, "atanh", 1, 1),
    (Function::Abs, "abs", 1, 1),
    (Function::Atan2, "atan2", 2, 2),
    (Function::Hypot, "hypot", 2, 2),
    (Function::Min, "min", 1, 20),
    (Function::Max, "max", 1, 20),
    (Function::Clamp, "clamp", 3, 3),
    (Function::Sign, "sign", 1, 1),
    (Function::Floor, "floor", 1, 1),
    (Function::Ceil, "ceil", 1, 1),
    (Function::Round, "round", 1, 1),
    (Function::Mod, "mod", 2, 2),
    (Function::EllipticK, "elliptic_k", 1, 1),
    (Function::EllipticKm1, "elliptic_km1", 1, 1),
    (Function::Re, "re", 1, 1),
    (Function::Im, "im", 1, 1),
    (Function::Arg, "arg", 1, 1),
    (Function::Conj, "conj", 1, 1),
    (Function::Transpose, "transpose", 1, 1),
    (Function::Det, "det", 1, 1),
    (Function::Dot, "dot", 2, 2),
    (Function::Norm, "norm", 1, 1),
];

impl Function {
    /// All functions, in the order of their table.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(|row| row.0)
    }

    /// The function of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        TABLE.iter().find(|row| row.1 == name).map(|row| row.0)
    }

    /// Its name in formulas.
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// The smallest and largest number of its arguments.
    pub fn arity(self) -> (usize, usize) {
        (self.row().2, self.row().3)
    }

    /// Whether its arguments have to be real numbers.
    pub(crate) fn is_real_only(self) -> bool {
        matches!(
            self,
            Self::Atan2
                | Self::Hypot
                | Self::Min
                | Self::Max
                | Self::Clamp
                | Self::Sign
                | Self::Floor
                | Self::Ceil
                | Self::Round
                | Self::Mod
                | Self::EllipticK
                | Self::EllipticKm1
        )
    }

    /// Whether it has a complex derivative wherever it has a value, up to cuts.
    pub fn is_analytic(self) -> bool {
        !self.is_real_only()
            && !matches!(
                self,
                Self::Abs | Self::Re | Self::Im | Self::Arg | Self::Conj | Self::Norm
            )
    }

    fn row(self) -> &'static FunctionRow {
        TABLE
            .iter()
            .find(|row| row.0 == self)
            .expect("every function stands in the table")
    }
}
