//! The six motions of a ship in waves, and the displacement of a point fixed to it.
//!
//! Motions by published statistics are independent of each other in different degrees of freedom: their statistics do not
//! determine their phases. Motions by [`wave_response`] respond to one sea. Ship axes: x forward, y to port, z up; right-handed
//! rotations of first order.

pub mod record;
pub mod spectral_band;
pub mod wave_response;

use std::f64::consts::TAU;

use rayon::prelude::*;

use self::record::MotionRecord;
use self::spectral_band::{MotionRms, SpectralBand, SpectralBandError, fit_bands};
use self::wave_response::WaveResponse;
use super::model::MotionSettings;
use crate::numerics::V3;
use crate::numerics::statistics::expected_gaussian_maximum;
use crate::physics::sea::Component;

/// A degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct DegreeOfFreedom {
    /// Mean \[m or rad\].
    pub mean: f64,
    /// Target root mean squares about the mean \[m or rad\].
    pub target: MotionRms,
    /// Spectral bands with these root mean squares.
    pub bands: Vec<SpectralBand>,
    /// Regular components.
    pub components: Vec<Component>,
}

impl DegreeOfFreedom {
    /// Whether a band has more than a tenth of the variance of displacement, velocity or acceleration.
    fn is_decided_by(&self, band: &SpectralBand) -> bool {
        let own = band.moments();
        (0..3).any(|k| {
            let all: f64 = self.bands.iter().map(|band| band.moments()[k]).sum();
            own[k] > DECISIVE_SHARE * all
        })
    }

    /// Target root mean square of displacement about zero (`rate` 0), velocity (1) or acceleration (2).
    #[must_use]
    pub fn target_rms(&self, rate: usize) -> f64 {
        match rate {
            0 => self.target.displacement.hypot(self.mean),
            1 => self.target.velocity,
            _ => self.target.acceleration,
        }
    }
}

/// The six motions of a ship: surge, sway, heave, roll, pitch, yaw.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipMotion {
    /// Each degree of freedom.
    pub degrees: [DegreeOfFreedom; 6],
    /// The waves at the ship's reference point; none for motions by published statistics.
    pub waves: Vec<Component>,
    /// Step of a record \[s\].
    pub step: f64,
    /// Instants of a record.
    pub instants: usize,
}

/// A band whose record holds too few frequencies for the extremes of a Gaussian record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SparseBand {
    /// Degree of freedom, 0 to 5.
    pub degree: usize,
    /// The band.
    pub band: SpectralBand,
    /// Frequencies n of the band in the record: as many of its amplitudes are independent.
    pub frequencies: usize,
    /// The greatest value that so many components of equal energy reach, `sqrt(2 n)` \[standard deviations\].
    pub greatest: f64,
    /// Expected maximum of a Gaussian record of as many cycles \[standard deviations\].
    pub expected: f64,
}

/// A band with a smaller share of the variances of displacement, velocity and acceleration does not decide on extremes.
const DECISIVE_SHARE: f64 = 0.1;

/// Statistics of a degree of freedom that no motion has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{why}")]
pub struct MotionStatisticsError {
    /// Degree of freedom, 0 to 5.
    pub degree: usize,
    /// Why.
    pub why: String,
}

impl ShipMotion {
    /// The motions of a seed: the response to the waves of that seed, or motions by published statistics, which are the same
    /// for every seed while the records differ.
    ///
    /// # Errors
    /// [`MotionStatisticsError`] for statistics that no motion has.
    pub fn new(
        settings: &MotionSettings,
        response: Option<&WaveResponse>,
        seed: u64,
    ) -> Result<Self, MotionStatisticsError> {
        let waves = response.map_or_else(Vec::new, |response| {
            response.waves(settings.components, seed)
        });
        let degrees = match response {
            Some(response) => response.degrees(&waves),
            None => (0..6)
                .map(|degree| Self::degree(settings, degree, seed))
                .collect::<Result<_, _>>()?,
        };
        let degrees =
            <[DegreeOfFreedom; 6]>::try_from(degrees).map_err(|_| MotionStatisticsError {
                degree: 0,
                why: "not six degrees of freedom".to_owned(),
            })?;
        Ok(Self {
            degrees,
            waves,
            step: settings.step_s,
            instants: settings.instants(),
        })
    }

    fn degree(
        settings: &MotionSettings,
        degree: usize,
        seed: u64,
    ) -> Result<DegreeOfFreedom, MotionStatisticsError> {
        let (mean, rms) = settings.target(degree);
        let square = rms.displacement.powi(2) - mean * mean;
        if square < 0.0 {
            return Err(MotionStatisticsError {
                degree,
                why: "the root mean square, which includes the mean, is less than the mean"
                    .to_owned(),
            });
        }
        let target = MotionRms {
            displacement: square.sqrt(),
            ..rms
        };
        let bands =
            fit_bands(target, settings.slow_period_s).map_err(|why: SpectralBandError| {
                MotionStatisticsError {
                    degree,
                    why: why.to_string(),
                }
            })?;
        let streams = bands.iter().zip(2 * degree as u64..);
        let duration = settings.step_s * settings.instants() as f64;
        let components = streams
            .flat_map(|(band, stream)| band.components(settings.components, duration, seed, stream))
            .collect();
        Ok(DegreeOfFreedom {
            mean,
            target,
            bands,
            components,
        })
    }

    /// The bands that are too narrow for the record: an envelope of bandwidth B \[Hz\] has `n = B T` independent values in a record
    /// of duration T, those of its n frequencies, and `sqrt(2 n)` is below the expected maximum of a Gaussian record.
    #[must_use]
    pub fn narrow_bands(&self) -> Vec<SparseBand> {
        let degrees = self.degrees.iter().enumerate();
        let bands = degrees.flat_map(|(degree, of)| of.bands.iter().map(move |b| (degree, of, b)));
        let narrow = bands.filter(|(_, of, band)| of.is_decided_by(band));
        narrow
            .map(|(degree, of, band)| self.narrowness(degree, of, band))
            .filter(|narrow| narrow.greatest < narrow.expected)
            .collect()
    }

    fn narrowness(&self, degree: usize, of: &DegreeOfFreedom, band: &SpectralBand) -> SparseBand {
        let duration = self.time(self.instants);
        // The one component of a band narrower than the frequency of the record may lie beside it.
        let reach = band.middle * band.half_width + TAU / duration;
        let within = |c: &&Component| (c.omega - band.middle).abs() <= reach;
        let frequencies = of.components.iter().filter(within).count();
        let cycles = band.middle * duration / TAU;
        SparseBand {
            degree,
            band: *band,
            frequencies,
            greatest: (2.0 * frequencies as f64).sqrt(),
            expected: expected_gaussian_maximum(1.0, cycles).expected,
        }
    }

    /// The records of all six, the same for any number of threads.
    #[must_use]
    pub fn records(&self) -> Vec<MotionRecord> {
        let each = self.degrees.par_iter();
        each.map(|d| MotionRecord::new(&d.components, d.mean, self.step, self.instants))
            .collect()
    }

    /// Time of an instant \[s\].
    #[must_use]
    pub fn time(&self, instant: usize) -> f64 {
        self.step * instant as f64
    }
}

/// Displacement of a point at `arm` \[m\] in ship axes, at an instant of the six records.
#[must_use]
pub fn point_displacement(records: &[MotionRecord], arm: &V3, instant: usize) -> V3 {
    rigid_displacement(std::array::from_fn(|i| records[i].x[instant]), arm)
}

/// Displacement of a point at `arm` \[m\] by six motions: translation plus rotation × arm.
#[must_use]
pub fn rigid_displacement(motions: [f64; 6], arm: &V3) -> V3 {
    let q = |degree: usize| motions[degree];
    let (translation, rotation) = (V3::new(q(0), q(1), q(2)), V3::new(q(3), q(4), q(5)));
    translation + rotation.cross(arm)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Heave alone, of unit deviation and a period of 8 s, over a record of this duration \[s\].
    fn heave(acceleration: f64, duration: f64) -> ShipMotion {
        let omega = TAU / 8.0;
        let target = MotionRms {
            displacement: 1.0,
            velocity: omega,
            acceleration: acceleration * omega * omega,
        };
        let bands = fit_bands(target, 60.0).unwrap();
        let components = |band: &SpectralBand| band.components(100, duration, 1, 0);
        let heave = DegreeOfFreedom {
            mean: 0.0,
            target,
            components: bands.iter().flat_map(components).collect(),
            bands,
        };
        let still = DegreeOfFreedom {
            mean: 0.0,
            target: MotionRms {
                displacement: 0.0,
                velocity: 0.0,
                acceleration: 0.0,
            },
            bands: Vec::new(),
            components: Vec::new(),
        };
        let mut degrees = std::array::from_fn(|_| still.clone());
        degrees[2] = heave;
        ShipMotion {
            degrees,
            waves: Vec::new(),
            step: 0.25,
            instants: (duration / 0.25) as usize,
        }
    }

    #[test]
    fn a_band_of_few_frequencies_is_too_narrow_for_its_record() {
        // Half widths of 0.001 and 0.12: over 1600 s less than one frequency apart, and 48.
        let narrow = heave(1.0, 1600.0);
        let found = narrow.narrow_bands();
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].degree, found[0].frequencies), (2, 1));
        assert!((found[0].greatest - 2.0_f64.sqrt()).abs() < 1e-12);
        assert!(found[0].expected > 3.2, "{:?}", found[0]);
        let record = &narrow.records()[2];
        let most = record.x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(most <= found[0].greatest + 1e-9, "{most}");
        assert!(heave(1.01, 1600.0).narrow_bands().is_empty());
        // Over a shorter record that band has too few as well.
        assert_eq!(heave(1.01, 60.0).narrow_bands()[0].frequencies, 2);
    }
}
