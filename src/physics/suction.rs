//! Suction: the pull by which the bed holds back what has borne on it.
//!
//! It rises to its greatest over half the distance off the bed over which it acts, and falls to nothing over the other half. Beyond, what it held
//! is free until it bears on the bed again.

/// Suction of what bears on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Suction {
    /// Greatest pull \[N\].
    pub greatest: f64,
    /// Distance off the bed over which it acts \[m\], positive.
    pub distance: f64,
}

impl Suction {
    /// The pull \[N\] at a height above the bed \[m\] on what is held, and its derivative by the height \[N/m\].
    #[must_use]
    pub fn pull(&self, height: f64) -> (f64, f64) {
        if height <= 0.0 || height >= self.distance {
            return (0.0, 0.0);
        }
        let slope = self.stiffness();
        if height < 0.5 * self.distance {
            (slope * height, slope)
        } else {
            (slope * (self.distance - height), -slope)
        }
    }

    /// Whether it holds what it held before, or not, and is at a height above the bed now \[m\].
    #[must_use]
    pub fn holds(&self, held: bool, height: f64) -> bool {
        height < 0.0 || held && height < self.distance
    }

    /// Slope of the pull, up or down \[N/m\].
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        2.0 * self.greatest / self.distance
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_borne_is_held_up_to_the_distance() {
        let suction = Suction {
            greatest: 5.0,
            distance: 0.2,
        };
        assert!((suction.pull(0.1).0 - 5.0).abs() < 1e-12);
        for height in [-0.1, 0.0, 0.2, 0.3] {
            assert_eq!(suction.pull(height), (0.0, 0.0));
        }
        for height in [0.03, 0.08, 0.12, 0.19] {
            let step = 1e-6;
            let ahead = suction.pull(height + step).0 - suction.pull(height - step).0;
            assert!((ahead / (2.0 * step) - suction.pull(height).1).abs() < 1e-6);
        }
        assert!(suction.holds(false, -0.01) && suction.holds(true, 0.1));
        assert!(!suction.holds(false, 0.1) && !suction.holds(true, 0.2));
    }
}
