//! Position and velocity at one instant.

use std::ops::Add;

/// Position and velocity at one instant, in m and m/s (or rad and rad/s).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Displacement from equilibrium, in m or rad.
    pub position: f64,
    /// Its rate of change, in m/s or rad/s.
    pub velocity: f64,
}

impl State {
    /// Rest at the equilibrium.
    pub const REST: Self = Self {
        position: 0.0,
        velocity: 0.0,
    };

    /// Whether both numbers are finite.
    pub const fn is_finite(self) -> bool {
        self.position.is_finite() && self.velocity.is_finite()
    }
}

impl Add for State {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            position: self.position + other.position,
            velocity: self.velocity + other.velocity,
        }
    }
}
