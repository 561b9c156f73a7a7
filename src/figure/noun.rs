//! What the things in a figure are called.

/// What a kind of thing is called, in each language in which figures are described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noun {
    /// Without an article, `block`.
    pub english: &'static str,
    /// With the article of its gender, `un bloc`.
    pub french: &'static str,
}

/// Those that are asked for, beside those that elements have for themselves.
impl Noun {
    pub(crate) const BAR: Self = Self::new("bar", "une barre");
    pub(crate) const ROD: Self = Self::new("rod", "une tige");
    pub(crate) const CORD: Self = Self::new("cord", "un câble");
    pub(crate) const FORCE: Self = Self::new("force", "une force");
    pub(crate) const MOMENT: Self = Self::new("moment", "un moment");
    pub(crate) const NORMAL_FORCE: Self = Self::new("normal force", "une force normale");
    pub(crate) const FRICTION: Self = Self::new("friction", "une force de frottement");
    pub(crate) const REACTION: Self = Self::new("reaction", "une réaction");
    pub(crate) const WEIGHT: Self = Self::new("weight", "un poids");
    pub(crate) const FLOOR: Self = Self::new("floor", "un sol");
    pub(crate) const CEILING: Self = Self::new("ceiling", "un plafond");
    pub(crate) const LEFT_WALL: Self = Self::new("wall on the left", "un mur de gauche");
    pub(crate) const RIGHT_WALL: Self = Self::new("wall on the right", "un mur de droite");

    pub(crate) const fn new(english: &'static str, french: &'static str) -> Self {
        Self { english, french }
    }
}
