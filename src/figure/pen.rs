//! How lines and areas look: distinguished in black-and-white print by weight and dash alone.

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Its width.
    pub weight: Weight,
    /// Its dashes.
    pub dash: Dash,
    /// Whether it is drawn in grey.
    pub is_faint: bool,
}

/// The width of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Weight {
    /// 0.18 mm: hatching, dimension lines, leaders.
    Hair,
    /// 0.25 mm: arrows, axes, construction lines.
    Thin,
    /// 0.35 mm: springs, cords, outlines.
    Medium,
    /// 0.5 mm: ground lines, rods.
    Bold,
    /// 0.8 mm: plates.
    Heavy,
}

/// The dashes of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Without a gap.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Long and short in turn: axes of symmetry.
    Chain,
    /// Long dashes, to tell a third and fourth curve apart.
    Long,
}

/// How an area is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// Not at all.
    None,
    /// Light grey: bodies with mass.
    Tint,
    /// Grey: small bodies, liquids, plates.
    Shade,
    /// Black: arrow heads, small balls.
    Ink,
    /// White: what covers the lines behind it.
    Paper,
}

impl Pen {
    /// A solid line.
    pub const fn new(weight: Weight) -> Self {
        Self {
            weight,
            dash: Dash::Solid,
            is_faint: false,
        }
    }

    /// The same with dashes.
    #[must_use]
    pub const fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The same in grey.
    #[must_use]
    pub const fn faint(self) -> Self {
        Self {
            is_faint: true,
            ..self
        }
    }

    /// Its width in figure units.
    pub fn width(self) -> f64 {
        self.weight.width()
    }
}

impl Weight {
    /// The width in figure units.
    pub fn width(self) -> f64 {
        match self {
            Self::Hair => 0.018,
            Self::Thin => 0.025,
            Self::Medium => 0.035,
            Self::Bold => 0.05,
            Self::Heavy => 0.08,
        }
    }
}

impl Dash {
    /// Lengths of dashes and gaps in tenths of a millimetre, as SVG takes them.
    pub(crate) fn pattern(self) -> Option<&'static str> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some("14 9"),
            Self::Dotted => Some("0.1 7"),
            Self::Chain => Some("26 7 4 7"),
            Self::Long => Some("32 10"),
        }
    }
}
