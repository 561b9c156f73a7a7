//! What is wrong with an equation, term by term.

/// What is wrong with the terms of an equation.
#[derive(Clone, Debug, PartialEq)]
pub struct Terms {
    /// Which equation of several, from 1.
    pub equation: Option<usize>,
    /// What is wrong with which term.
    pub faults: Vec<(Term, Fault)>,
    /// What is wrong with how it depends on large motions.
    pub linearity: Option<Linearity>,
}

/// A term of an equation, as people call it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// What it does.
    pub kind: TermKind,
    /// The unknown in which it is, with primes for its time derivatives; none for what stands without unknowns.
    pub unknown: Option<String>,
    /// The unknowns that do not stand in it, where it has none.
    pub without: Vec<String>,
}

/// What a term does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TermKind {
    /// It excites the motion.
    Exciting,
    /// A mass or moment of inertia times an acceleration.
    Inertia,
    /// Dry friction.
    Friction,
    /// Viscous damping, a coefficient times a velocity.
    Damping,
    /// A coefficient times a displacement.
    Stiffness,
    /// None of these.
    Other,
}

/// What is wrong with a term.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The key has it, the response does not.
    Missing,
    /// It should not be there.
    Surplus,
    /// It has the opposite sign.
    Sign,
    /// Its coefficient is another one than in the key.
    Coefficient(Coefficient),
}

/// What is wrong with a coefficient.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Coefficient {
    /// A factor that is a number.
    Number,
    /// Data, each by its symbol and in words.
    Data {
        /// That do not stand in it and should.
        missed: Vec<(String, Option<String>)>,
        /// That stand in it and should not.
        surplus: Vec<(String, Option<String>)>,
    },
    /// Something else.
    Other,
}

/// How an equation depends on large motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Linearity {
    /// It is right but for having to be linearized.
    Due,
    /// It is linearized where that is not asked.
    Surplus,
    /// It is right for small motions alone.
    WrongForLarge,
    /// It has to be linearized besides what else is wrong.
    DueBesides,
}

impl Terms {
    /// Whether only signs are wrong.
    pub(crate) fn is_sign(&self) -> bool {
        self.linearity.is_none()
            && !self.faults.is_empty()
            && self.faults.iter().all(|(_, fault)| *fault == Fault::Sign)
    }
}
