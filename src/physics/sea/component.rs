//! A regular component of an irregular record, and the moments of a set of them.

use std::f64::consts::TAU;

/// `amplitude cos(omega t + phase)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Component {
    /// Angular frequency \[rad/s\], positive.
    pub omega: f64,
    /// Amplitude, in the unit of the record.
    pub amplitude: f64,
    /// Lead \[rad\].
    pub phase: f64,
}

impl Component {
    /// Its value at time t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        self.amplitude * (self.omega * t + self.phase).cos()
    }
}

/// Spectral moments of a spectrum or of a set of components.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Moments {
    /// Variance \[unit²\].
    pub m0: f64,
    /// Variance of the rate of change \[unit²/s²\].
    pub m2: f64,
}

impl Moments {
    /// Of components.
    #[must_use]
    pub fn of_components(components: &[Component]) -> Self {
        let mut sum = Self::default();
        for c in components {
            let energy = 0.5 * c.amplitude * c.amplitude;
            sum.m0 += energy;
            sum.m2 += energy * c.omega * c.omega;
        }
        sum
    }

    /// Significant height, `4 sqrt(m0)`.
    #[must_use]
    pub fn significant_height(&self) -> f64 {
        4.0 * self.m0.sqrt()
    }

    /// Mean period between upward crossings of the mean \[s\], `2 pi sqrt(m0 / m2)`.
    #[must_use]
    pub fn crossing_period(&self) -> f64 {
        TAU * (self.m0 / self.m2).sqrt()
    }
}
