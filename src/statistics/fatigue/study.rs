//! Rainflow damage of random narrow-band records against the closed form.

use super::closed_form::narrow_band_damage;
use super::component::FatigueComponent;
use super::damage::{DamageError, MeanLoad, MinerSum};
use super::mean_stress::MeanCorrection;
use super::rainflow::ThreePointCounter;
use super::turning_points::SeriesError;
use crate::numerics::random::Random;
use crate::numerics::statistics::{mean, variance};
use std::f64::consts::TAU;

/// Why the study cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// A number that is too small or too great.
    #[error("{name} is {value}; it should be {bounds}")]
    Bounds {
        /// Its name.
        name: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        bounds: &'static str,
    },
    /// A damage that cannot be summed.
    #[error(transparent)]
    Damage(#[from] DamageError),
    /// A tension that is not finite.
    #[error(transparent)]
    Series(#[from] SeriesError),
}

/// Random Gaussian records of a flat narrow band about 1 Hz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NarrowBandRecords {
    /// Seed.
    pub seed: u64,
    /// Number of records.
    pub records: usize,
    /// Cosines with random amplitudes and phases in a record, at equal steps of the band; a record takes one period of the
    /// steps, so `components / bandwidth` mean periods.
    pub components: usize,
    /// Width of the band over its middle.
    pub bandwidth: f64,
    /// Values in a mean period.
    pub samples: usize,
    /// Standard deviation of the tension, N.
    pub deviation: f64,
    /// Mean tension, N.
    pub mean: f64,
}

impl Default for NarrowBandRecords {
    fn default() -> Self {
        Self {
            seed: 1,
            records: 200,
            components: 50,
            bandwidth: 0.05,
            samples: 32,
            deviation: 1e5,
            mean: 1e6,
        }
    }
}

/// Damage of the records over the closed form.
#[derive(Debug, Clone, PartialEq)]
pub struct NarrowBandStudy {
    /// Of each record.
    pub ratios: Vec<f64>,
    /// Their mean.
    pub ratio: f64,
    /// Standard error of that mean, from the scatter of the records.
    pub standard_error: f64,
}

impl NarrowBandRecords {
    fn checked(&self) -> Result<(), StudyError> {
        let rows = [
            (
                "the number of records",
                self.records as f64,
                2.0..=1e6,
                "from 2 to 1e6",
            ),
            (
                "the number of components",
                self.components as f64,
                2.0..=1e4,
                "from 2 to 1e4",
            ),
            (
                "the bandwidth",
                self.bandwidth,
                1e-4..=1.0,
                "from 1e-4 to 1",
            ),
            (
                "the number of samples a period",
                self.samples as f64,
                4.0..=1e4,
                "from 4 to 1e4",
            ),
            (
                "the standard deviation in N",
                self.deviation,
                1e-6..=1e12,
                "from 1e-6 to 1e12 N",
            ),
            (
                "the mean in N",
                self.mean,
                -1e12..=1e12,
                "from -1e12 to 1e12 N",
            ),
        ];
        for (name, value, interval, bounds) in rows {
            if !interval.contains(&value) {
                return Err(StudyError::Bounds {
                    name,
                    value,
                    bounds,
                });
            }
        }
        Ok(())
    }

    /// Mean periods of a record.
    #[must_use]
    pub fn periods(&self) -> f64 {
        self.components as f64 / self.bandwidth
    }

    /// One record of tensions, N.
    fn record(&self, random: &mut Random) -> Vec<f64> {
        let length = (self.periods() * self.samples as f64).round() as usize;
        let mut record = vec![self.mean; length];
        let step = self.bandwidth / self.components as f64;
        let each = self.deviation / (self.components as f64).sqrt();
        for k in 0..self.components {
            let frequency = 1.0 - 0.5 * self.bandwidth + (k as f64 + 0.5) * step;
            // A Gaussian record has Rayleigh amplitudes; equal ones would scatter less than the sea.
            let amplitude = each * (-2.0 * random.uniform().ln()).sqrt();
            add_cosine(
                &mut record,
                amplitude,
                TAU * random.uniform(),
                frequency / self.samples as f64,
            );
        }
        record
    }

    /// Counts every record by the three-point rule and relates its damage to that of the closed form with as many cycles as
    /// the band has upward crossings of the mean.
    ///
    /// # Errors
    /// Numbers out of bounds; what the curve refuses.
    pub fn study(&self, component: &FatigueComponent) -> Result<NarrowBandStudy, StudyError> {
        self.checked()?;
        // ∫ f² over the flat band, by its middle of 1 and width w: 1 + w²/12.
        let crossings = self.periods() * (1.0 + self.bandwidth.powi(2) / 12.0).sqrt();
        let expected = narrow_band_damage(component, self.deviation, self.mean, crossings)
            .map_err(DamageError::from)?;
        let mut ratios = Vec::with_capacity(self.records);
        for stream in 0..self.records {
            let record = self.record(&mut Random::new(self.seed, stream as u64));
            let damage = self.rainflow_damage(component, &record)?;
            ratios.push(if expected > 0.0 {
                damage / expected
            } else {
                0.0
            });
        }
        let ratio = mean(&ratios);
        let n = self.records as f64;
        let standard_error = (variance(&ratios, ratio) / (n - 1.0)).sqrt();
        Ok(NarrowBandStudy {
            ratios,
            ratio,
            standard_error,
        })
    }

    fn rainflow_damage(
        &self,
        component: &FatigueComponent,
        record: &[f64],
    ) -> Result<f64, StudyError> {
        let mean_load = MeanLoad::OfRecord(self.mean);
        let mut sum = MinerSum::new(component, MeanCorrection::None, mean_load);
        let mut outcome = Ok(());
        let mut add = |cycle| {
            let added = sum.add(&cycle);
            if outcome.is_ok() {
                outcome = added;
            }
        };
        let mut counter = ThreePointCounter::new();
        for (i, &tension) in record.iter().enumerate() {
            counter.push(i as f64, tension, &mut add)?;
        }
        counter.finish(&mut add);
        outcome?;
        Ok(sum.damage().sum)
    }
}

/// Adds a cosine of so many turns a value, by rotation: the error grows as the number of values, 1e-11 after 100,000.
fn add_cosine(record: &mut [f64], amplitude: f64, phase: f64, turns: f64) {
    let (sin, cos) = (TAU * turns).sin_cos();
    let (mut x, mut y) = (amplitude * phase.cos(), amplitude * phase.sin());
    for value in record {
        *value += x;
        (x, y) = (x * cos - y * sin, x * sin + y * cos);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fatigue::component::Measure;
    use crate::fatigue::curve::Law;

    fn component(law: Law) -> FatigueComponent {
        FatigueComponent::new("", law, Measure::TensionRatio, Some(1e7)).unwrap()
    }

    /// 24 records of 800 cycles: the ratio lies within four standard errors of one, and these are as small as stated.
    #[test]
    fn rainflow_agrees_with_the_closed_form() {
        let records = NarrowBandRecords {
            records: 24,
            components: 40,
            ..NarrowBandRecords::default()
        };
        let knee = Law::new(3.0, 3.0).with_knee(1e8, 5.0);
        let laws = [
            (Law::new(3.0, 3.0), 0.08),
            (Law::new(4.09, 3.2).falling_with_mean(2.79), 0.12),
            (knee, 0.12),
        ];
        for (law, most) in laws {
            let study = records.study(&component(law)).unwrap();
            let (ratio, error) = (study.ratio, study.standard_error);
            assert!(
                (ratio - 1.0).abs() < 4.0 * error && error < most,
                "{ratio} ± {error} of {law:?}"
            );
        }
    }

    #[test]
    fn bad_studies_are_refused() {
        let law = component(Law::new(3.0, 3.0));
        let good = NarrowBandRecords::default();
        for bad in [
            NarrowBandRecords { records: 1, ..good },
            NarrowBandRecords {
                components: 0,
                ..good
            },
            NarrowBandRecords {
                bandwidth: f64::NAN,
                ..good
            },
            NarrowBandRecords { samples: 0, ..good },
            NarrowBandRecords {
                deviation: f64::INFINITY,
                ..good
            },
        ] {
            assert!(bad.study(&law).is_err());
        }
    }
}
