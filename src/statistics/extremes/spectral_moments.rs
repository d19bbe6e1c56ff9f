//! Moments of a spectrum, and the periods and bandwidths that follow from them.

use super::error::{ExtremesError, check_inside};

/// Moments of a spectrum about frequency zero: the integral of `f^n S(f)`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpectralMoments {
    /// Variance, in the square of the unit.
    pub m0: f64,
    /// In the square of the unit times Hz.
    pub m1: f64,
    /// In the square of the unit times Hz^2.
    pub m2: f64,
    /// In the square of the unit times Hz^4. Grows with the greatest frequency where the density falls slower than `f^-5`.
    pub m4: f64,
}

impl SpectralMoments {
    fn ratio(&self, ratio: f64) -> Result<f64, ExtremesError> {
        let range = (0.0, f64::INFINITY);
        check_inside("the variance of the spectrum", self.m0, range, "above 0")?;
        check_inside("a ratio of spectral moments", ratio, range, "above 0")?;
        Ok(ratio)
    }

    /// Mean period between upward crossings of the mean, `sqrt(m0/m2)`, in s.
    ///
    /// # Errors
    /// Where the spectrum has no variance above frequency zero.
    pub fn zero_crossing_period(&self) -> Result<f64, ExtremesError> {
        self.ratio(self.m0 / self.m2).map(f64::sqrt)
    }

    /// Mean period `m0/m1`, in s.
    ///
    /// # Errors
    /// Where the spectrum has no variance above frequency zero.
    pub fn mean_period(&self) -> Result<f64, ExtremesError> {
        self.ratio(self.m0 / self.m1)
    }

    /// Bandwidth `sqrt(1 - m2^2/(m0 m4))` of Cartwright and Longuet-Higgins: 0 narrow, 1 wide.
    ///
    /// # Errors
    /// Where the spectrum has no variance above frequency zero.
    pub fn bandwidth(&self) -> Result<f64, ExtremesError> {
        let regularity = self.ratio(self.m2 / self.m0 * (self.m2 / self.m4))?;
        Ok((1.0 - regularity).max(0.0).sqrt())
    }

    /// Bandwidth `sqrt(m0 m2/m1^2 - 1)` of Longuet-Higgins (1975), without the fourth moment.
    ///
    /// # Errors
    /// Where the spectrum has no variance above frequency zero.
    pub fn narrowness(&self) -> Result<f64, ExtremesError> {
        let ratio = self.ratio(self.m0 / self.m1 * (self.m2 / self.m1))?;
        Ok((ratio - 1.0).max(0.0).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A uniform density from 0 to 2 Hz: moments 2, 2, 8/3 and 32/5.
    #[test]
    fn of_a_uniform_density() {
        let moments = SpectralMoments {
            m0: 2.0,
            m1: 2.0,
            m2: 8.0 / 3.0,
            m4: 6.4,
        };
        assert_eq!(moments.mean_period(), Ok(1.0));
        assert!((moments.zero_crossing_period().unwrap() - 0.75_f64.sqrt()).abs() < 1e-15);
        assert!((moments.bandwidth().unwrap() - 2.0 / 3.0).abs() < 1e-15);
        assert!((moments.narrowness().unwrap() - 1.0 / 3.0_f64.sqrt()).abs() < 1e-15);
        assert!(SpectralMoments::default().narrowness().is_err());
    }
}
