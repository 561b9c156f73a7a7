//! What programs write around numbers, lists and equations.

/// Calls of programs that stand for the number in their brackets.
pub(crate) const NUMBERS: &[&str] = &[
    "np.float64",
    "np.float32",
    "np.complex128",
    "numpy.float64",
    "float",
    "int",
    "print",
    "disp",
    "simplify",
    "Simplify",
    "FullSimplify",
    "evalf",
];

/// Calls of programs that stand for the list in their brackets.
pub(crate) const LISTS: &[&str] = &[
    "np.array",
    "numpy.array",
    "array",
    "np.matrix",
    "numpy.matrix",
    "sp.Matrix",
    "sympy.Matrix",
    "Matrix",
    "matrix",
    "mat",
    "MatrixForm",
    "vec",
    "vector",
    "Vector",
    "col",
    "list",
    "List",
    "tuple",
];

/// Calls of programs that make an equation of their two arguments.
pub(crate) const EQUATIONS: &[&str] = &["Eq", "sp.Eq", "sympy.Eq", "Equal", "Equality"];

/// Modules and objects of programs before the names of functions.
pub(crate) const MODULES: &[&str] = &[
    "np.linalg.",
    "np.",
    "numpy.",
    "math.",
    "cmath.",
    "Math.",
    "sp.",
    "sympy.",
    "sym.",
    "torch.",
];
