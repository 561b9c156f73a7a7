//! How the textbooks tie the numbers of one degree of freedom to each other: each relation stands here, and only here.
//!
//! The first of a number is its definition in m, c and k, from which a model makes its formulas; the others are the ways
//! in which somebody who has other numbers gets it, from which follow-through is computed. That the numbers of a model
//! agree with all of them is a test.

use super::Sdof;

impl Sdof {
    /// All numbers of one degree of freedom, each after those by which it is usually found.
    pub const ALL: [Self; 14] = [
        Self::Mass,
        Self::Damping,
        Self::Stiffness,
        Self::NaturalAngularFrequency,
        Self::NaturalFrequency,
        Self::Period,
        Self::CriticalDamping,
        Self::DecayRate,
        Self::DampingRatio,
        Self::DampedAngularFrequency,
        Self::DampedPeriod,
        Self::LogarithmicDecrement,
        Self::QualityFactor,
        Self::ResonanceAngularFrequency,
    ];

    /// Its letter in the relations.
    pub fn letter(self) -> &'static str {
        match self {
            Self::Mass => "m",
            Self::Damping => "c",
            Self::Stiffness => "k",
            Self::NaturalAngularFrequency => "w",
            Self::NaturalFrequency => "f",
            Self::Period => "T",
            Self::DecayRate => "a",
            Self::DampingRatio => "z",
            Self::CriticalDamping => "C",
            Self::DampedAngularFrequency => "d",
            Self::DampedPeriod => "P",
            Self::LogarithmicDecrement => "L",
            Self::QualityFactor => "Q",
            Self::ResonanceAngularFrequency => "r",
        }
    }

    /// The number that has this letter.
    pub fn of_letter(letter: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|own| own.letter() == letter)
    }

    /// Its definition in m, c and k.
    pub fn definition(self) -> &'static str {
        self.relations()[0]
    }

    /// Formulas for it in the letters of the numbers: its definition, then the others, the most usual first.
    ///
    /// ```
    /// use vibank::mechanics::Sdof;
    /// assert_eq!(Sdof::Period.relations(), ["2*pi*sqrt(m/k)", "2*pi/w", "1/f"]);
    /// ```
    pub fn relations(self) -> &'static [&'static str] {
        match self {
            Self::Mass => &["m", "k/w^2", "c/(2*a)"],
            Self::Damping => &[
                "c",
                "2*m*a",
                "2*z*m*w",
                "2*z*sqrt(k*m)",
                "sqrt(k*m)/Q",
                "z*C",
            ],
            Self::Stiffness => &["k", "m*w^2", "4*pi^2*m/T^2"],
            Self::NaturalAngularFrequency => &[
                "sqrt(k/m)",
                "2*pi*f",
                "2*pi/T",
                "a/z",
                "sqrt(d^2 + a^2)",
                "d/sqrt(1 - z^2)",
            ],
            Self::NaturalFrequency => &["sqrt(k/m)/(2*pi)", "w/(2*pi)", "1/T"],
            Self::Period => &["2*pi*sqrt(m/k)", "2*pi/w", "1/f"],
            Self::DecayRate => &["c/(2*m)", "z*w", "L/P", "w/(2*Q)"],
            Self::DampingRatio => &[
                "c/(2*sqrt(k*m))",
                "a/w",
                "c/(2*m*w)",
                "L/sqrt(4*pi^2 + L^2)",
                "1/(2*Q)",
                "c/C",
            ],
            Self::CriticalDamping => &["2*sqrt(k*m)", "2*m*w"],
            Self::DampedAngularFrequency => &[
                "sqrt(k/m - (c/(2*m))^2)",
                "w*sqrt(1 - z^2)",
                "sqrt(w^2 - a^2)",
                "2*pi/P",
            ],
            Self::DampedPeriod => &["2*pi/sqrt(k/m - (c/(2*m))^2)", "2*pi/d"],
            Self::LogarithmicDecrement => &[
                "2*pi*(c/(2*m))/sqrt(k/m - (c/(2*m))^2)",
                "a*P",
                "2*pi*z/sqrt(1 - z^2)",
            ],
            Self::QualityFactor => &["sqrt(k*m)/c", "1/(2*z)"],
            Self::ResonanceAngularFrequency => &["sqrt(k/m - 2*(c/(2*m))^2)", "w*sqrt(1 - 2*z^2)"],
        }
    }
}
