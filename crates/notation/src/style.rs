//! How the pieces of a formula are set and spaced.

/// How a symbol is set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Italic for a single letter, upright for capital Greek, as in LaTeX.
    #[default]
    Default,
    /// Upright (`\mathrm`).
    Upright,
    /// Upright bold (`\mathbf`).
    Bold,
    /// Italic bold (`\boldsymbol`).
    BoldItalic,
    /// Script (`\mathcal`).
    Script,
    /// Double-struck (`\mathbb`).
    Double,
}

/// How an operator is spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// `+`, `−`, `⋅` between two operands.
    Binary,
    /// A sign before an operand.
    Prefix,
    /// `=`, `<`, `→`.
    Relation,
    /// `,`, `;`.
    Punctuation,
    /// A delimiter that opens and does not grow.
    Opening,
    /// A delimiter that closes and does not grow.
    Closing,
    /// A mark without space, `!`, `′`, `/`, `∞`.
    Ordinary,
    /// `∑`, `∫`.
    Large,
}

/// Size of the parts of a fraction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Size {
    /// By context (`\frac`).
    #[default]
    Auto,
    /// Full size (`\dfrac`).
    Display,
    /// Small (`\tfrac`).
    Text,
}

/// What stands above a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accent {
    /// First time derivative.
    Dot,
    /// Second time derivative.
    DoubleDot,
    /// Third time derivative.
    TripleDot,
    /// `\hat`: a circumflex over the base.
    Hat,
    /// `\tilde`: a swung dash over the base.
    Tilde,
    /// `\bar`, `\overline`: grows with its base.
    Bar,
    /// `\vec`: grows with its base.
    Vector,
}

/// What a table is for, which fixes its alignment and spacing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableKind {
    /// Centred cells.
    Matrix,
    /// Value and condition, left-aligned.
    Cases,
    /// Pairs of right- and left-aligned columns (`aligned`).
    Aligned,
}
