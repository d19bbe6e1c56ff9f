//! Miner's sum: the damages of all cycles added (Palmgren 1924, Miner, J. Appl. Mech. 12 (1945) A159).

use super::component::FatigueComponent;
use super::curve::CurveError;
use super::mean_stress::{MeanCorrection, MeanStressError};
use super::rainflow::Cycle;

/// Seconds of a year of 365.25 days.
pub const YEAR: f64 = 365.25 * 86_400.0;

/// Why damage cannot be summed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DamageError {
    /// A cycle that the curve refuses.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// A cycle that cannot be corrected to zero mean.
    #[error(transparent)]
    Mean(#[from] MeanStressError),
    /// A quantity that is not positive and finite.
    #[error("{name} is {value}; it should be positive and finite")]
    NotPositive {
        /// Its name.
        name: &'static str,
        /// What it is.
        value: f64,
    },
    /// A sum that is too great for a number.
    #[error(
        "the sum of the damages is more than a number can hold; check reference strength, area and units"
    )]
    Overflow,
}

/// Checks that a quantity is positive and finite.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, DamageError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(DamageError::NotPositive { name, value })
    }
}

/// Which mean load a curve takes whose constant depends on it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum MeanLoad {
    /// That of each cycle.
    #[default]
    OfCycle,
    /// That of the record or sea state, N, the same for all cycles (API RP 2SK).
    OfRecord(f64),
}

/// Damage with its slopes to the tension.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Damage {
    /// Miner's sum.
    pub sum: f64,
    /// Number of cycles, halves as 0.5.
    pub cycles: f64,
    /// Greatest range, N, before any correction.
    pub greatest_range: f64,
    /// d ln(sum) / d ln(range) with all means kept: m of a curve with one slope.
    pub range_exponent: f64,
    /// d ln(sum) / d ln(tension), where ranges and means grow together.
    pub tension_exponent: f64,
    /// d(sum) / d(range), where all ranges grow by the same number of N, 1/N.
    pub range_slope: f64,
}

impl Damage {
    /// Least and greatest sum where all tensions may be wrong by a relative error, of either sign, below 1:
    /// `sum (1 ± error)^n` with n the [`tension_exponent`](Self::tension_exponent).
    ///
    /// # Errors
    /// An error that is negative, not below 1 or NaN; a bound that is too great for a number.
    pub fn bounds(&self, relative_error: f64) -> Result<(f64, f64), DamageError> {
        if !(0.0..1.0).contains(&relative_error) {
            let (name, value) = (
                "one less the relative error of the tension",
                1.0 - relative_error,
            );
            return Err(DamageError::NotPositive { name, value });
        }
        let at = |factor: f64| self.sum * factor.powf(self.tension_exponent);
        let (low, high) = (at(1.0 - relative_error), at(1.0 + relative_error));
        if high.is_finite() {
            Ok((low, high))
        } else {
            Err(DamageError::Overflow)
        }
    }

    /// Error of the sum to first order, where every range may be wrong by so many N.
    #[must_use]
    pub fn error_of_ranges(&self, range_error: f64) -> f64 {
        self.range_slope * range_error.abs()
    }

    /// Damage of an hour, of a record that takes `duration` seconds.
    ///
    /// # Errors
    /// A duration that is not positive.
    pub fn per_hour(&self, duration: f64) -> Result<f64, DamageError> {
        Ok(self.sum / positive("the duration of the record in s", duration)? * 3600.0)
    }

    /// Damage of a year of 365.25 days, of a record that takes `duration` seconds.
    ///
    /// # Errors
    /// A duration that is not positive.
    pub fn per_year(&self, duration: f64) -> Result<f64, DamageError> {
        Ok(self.sum / positive("the duration of the record in s", duration)? * YEAR)
    }
}

/// Adds cycles as they come.
#[derive(Debug, Clone, PartialEq)]
pub struct MinerSum<'a> {
    component: &'a FatigueComponent,
    correction: MeanCorrection,
    mean_load: MeanLoad,
    total: Damage,
}

impl<'a> MinerSum<'a> {
    /// Of no cycle yet.
    #[must_use]
    pub fn new(
        component: &'a FatigueComponent,
        correction: MeanCorrection,
        mean_load: MeanLoad,
    ) -> Self {
        Self {
            component,
            correction,
            mean_load,
            total: Damage::default(),
        }
    }

    /// Adds a cycle of tension, N.
    ///
    /// # Errors
    /// What curve or correction refuses; a count that is not finite or negative; a sum too great for a number. The sum stays
    /// as it was.
    pub fn add(&mut self, cycle: &Cycle) -> Result<(), DamageError> {
        if !(cycle.count >= 0.0 && cycle.count.is_finite()) {
            let (name, value) = ("the count of a cycle", cycle.count);
            return Err(DamageError::NotPositive { name, value });
        }
        let corrected = self.correction.correct(cycle.range, cycle.mean)?;
        let mean = match self.mean_load {
            MeanLoad::OfCycle => cycle.mean,
            MeanLoad::OfRecord(mean) => mean,
        };
        let one = self.component.cycle_damage(corrected.range, mean)?;
        let damage = cycle.count * one.damage;
        let by_mean = one.mean_slope * mean + one.exponent * corrected.mean_slope * cycle.mean;
        let total = Damage {
            sum: self.total.sum + damage,
            cycles: self.total.cycles + cycle.count,
            greatest_range: self.total.greatest_range.max(cycle.range),
            // Both exponents are kept times the sum until the end.
            range_exponent: self.total.range_exponent + damage * one.exponent,
            tension_exponent: self.total.tension_exponent + damage * (one.exponent + by_mean),
            range_slope: self.total.range_slope + slope(damage * one.exponent, cycle.range),
        };
        let sums = [
            total.sum,
            total.cycles,
            total.range_exponent,
            total.tension_exponent,
        ];
        if !(sums.iter().all(|sum| sum.is_finite()) && total.range_slope.is_finite()) {
            return Err(DamageError::Overflow);
        }
        self.total = total;
        Ok(())
    }

    /// The sum so far.
    #[must_use]
    pub fn damage(&self) -> Damage {
        let mut total = self.total;
        if total.sum > 0.0 {
            total.range_exponent /= total.sum;
            total.tension_exponent /= total.sum;
        } else {
            let exponent = self.component.law().exponent;
            (total.range_exponent, total.tension_exponent) = (exponent, exponent);
        }
        total
    }
}

/// A quotient that is zero of nothing.
fn slope(value: f64, range: f64) -> f64 {
    if range > 0.0 { value / range } else { 0.0 }
}

/// Damage of cycles of tension, N.
///
/// # Errors
/// Those of [`MinerSum::add`].
pub fn damage<'c>(
    cycles: impl IntoIterator<Item = &'c Cycle>,
    component: &FatigueComponent,
    correction: MeanCorrection,
    mean_load: MeanLoad,
) -> Result<Damage, DamageError> {
    let mut sum = MinerSum::new(component, correction, mean_load);
    for cycle in cycles {
        sum.add(cycle)?;
    }
    Ok(sum.damage())
}

/// The constant range whose `number` cycles do the damage of all cycles by a curve of one exponent m:
/// `(Σ n_i ΔT_i^m / number)^(1/m)`; zero of no cycles.
///
/// # Errors
/// An exponent or number that is not positive; a range or count that is not finite or negative.
pub fn equivalent_range<'c>(
    cycles: impl IntoIterator<Item = &'c Cycle> + Clone,
    exponent: f64,
    number: f64,
) -> Result<f64, DamageError> {
    positive("the exponent m", exponent)?;
    positive("the number of equivalent cycles", number)?;
    let mut greatest = 0.0_f64;
    for cycle in cycles.clone() {
        for (name, value) in [("a range", cycle.range), ("a count", cycle.count)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(DamageError::NotPositive { name, value });
            }
        }
        greatest = greatest.max(cycle.range);
    }
    if greatest == 0.0 {
        return Ok(0.0);
    }
    // Relative to the greatest range, so that no power overflows.
    let sum: f64 = cycles
        .into_iter()
        .map(|c| c.count / number * (c.range / greatest).powf(exponent))
        .sum();
    let range = greatest * sum.powf(1.0 / exponent);
    if range.is_finite() {
        Ok(range)
    } else {
        Err(DamageError::Overflow)
    }
}

#[cfg(test)]
mod tests;
