//! Loads of waves on a body in time: those of the first order as harmonics, slow drift by Newman's approximation.
//!
//! With `psi_j` the phase of component j at the body, `a_j` its amplitude and `D_j` the mean drift at its frequency,
//!
//! ```text
//! F1 = Re sum X_j a_j exp(i psi_j)
//! F2 = sum_jk a_j a_k (D_j + D_k)/2 cos(psi_j - psi_k) = C C_D + S S_D,   C = sum a cos psi, C_D = sum a D cos psi, and so on
//! ```
//!
//! F2 contains the mean drift (Newman 1974). Wave systems of a sea drift each by itself.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix3, Vector3, Vector6};

use super::PotentialFlow;
use crate::numerics::V3;
use crate::physics::sea::{Sea, WaveField};
use crate::system::pose::Pose;

/// A component of the waves at the body.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Term {
    omega: f64,
    amplitude: f64,
    phase: f64,
    /// Loads of the first order of the component itself \[N, N m\].
    load: Vector6<Complex<f64>>,
    /// Mean drift per amplitude squared.
    drift: [f64; 3],
}

/// The loads of the waves of a sea on a body at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveLoads {
    fields: Vec<(WaveField, Vec<Term>)>,
    /// Turns the axes of the coefficients into the earth's.
    heading: f64,
}

/// Whether waves from all directions of a sea are covered: the first heading that is not \[rad\].
#[must_use]
pub fn uncovered(flow: &PotentialFlow, sea: &Sea, yaw: f64) -> Option<f64> {
    let from_bow = |field: &WaveField| (field.direction() - yaw).rem_euclid(TAU);
    let mut headings = sea.fields().iter().map(from_bow);
    headings.find(|heading| {
        let first = flow.excitation.as_ref().map(|table| table.covers(*heading));
        let drift = flow.drift.as_ref().map(|table| table.covers(*heading));
        first == Some(false) || drift == Some(false)
    })
}

/// Share of the energy of a sea above the highest frequency of the loads.
#[must_use]
pub fn energy_above(flow: &PotentialFlow, sea: &Sea) -> f64 {
    let Some(table) = &flow.excitation else {
        return 0.0;
    };
    let (_, high) = table.span();
    let (mut above, mut all) = (0.0, 0.0);
    for component in sea.at_point(&V3::zeros()) {
        let energy = component.amplitude * component.amplitude;
        all += energy;
        if component.omega > high {
            above += energy;
        }
    }
    if all > 0.0 { above / all } else { 0.0 }
}

impl WaveLoads {
    /// The loads on a body about the pose at which its coefficients hold.
    #[must_use]
    pub fn new(flow: &PotentialFlow, sea: &Sea, pose: &Pose) -> Self {
        let heading = pose.angles()[2];
        let field = |field: &WaveField| {
            let from_bow = (field.direction() - heading).rem_euclid(TAU);
            let components = field.at_point(&pose.origin).into_iter();
            let terms = components.map(|c| {
                let first = flow.excitation.as_ref();
                let first = first.map(|table| table.at(from_bow, c.omega));
                let drift = flow.drift.as_ref();
                let drift = drift.map(|table| table.at(from_bow, c.omega));
                Term {
                    omega: c.omega,
                    amplitude: c.amplitude,
                    phase: c.phase,
                    load: first.unwrap_or_default() * Complex::from(c.amplitude),
                    drift: drift.unwrap_or_default(),
                }
            });
            (field.clone(), terms.collect())
        };
        Self {
            fields: sea.fields().iter().map(field).collect(),
            heading,
        }
    }

    /// Force \[N\] and moment about the origin \[N m\] in the earth's directions at time t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> Vector6<f64> {
        let mut sum = Vector6::zeros();
        for (field, terms) in &self.fields {
            let growth = field.growth(t);
            let (mut cosine, mut sine) = ([0.0; 4], [0.0; 4]);
            let mut first = Vector6::zeros();
            for term in terms {
                let (sin, cos) = (term.omega * t + term.phase).sin_cos();
                first += term.load.map(|x| x.re * cos - x.im * sin);
                let weights = [1.0, term.drift[0], term.drift[1], term.drift[2]];
                for (k, weight) in weights.into_iter().enumerate() {
                    cosine[k] += term.amplitude * weight * cos;
                    sine[k] += term.amplitude * weight * sin;
                }
            }
            let drift = [1, 2, 3].map(|k| cosine[0] * cosine[k] + sine[0] * sine[k]);
            sum += first * growth + in_plan(&drift) * (growth * growth);
        }
        self.turned(&sum)
    }

    /// Loads of the first order of a component of a field \[N, N m\] as complex amplitudes by `exp(i omega t)`, in the earth's directions.
    #[must_use]
    pub fn of_component(&self, field: usize, component: usize) -> Vector6<Complex<f64>> {
        let found = self
            .fields
            .get(field)
            .and_then(|(_, terms)| terms.get(component));
        let Some(term) = found else {
            return Vector6::zeros();
        };
        let load = term.load * Complex::from_polar(1.0, term.phase);
        let [re, im] = [load.map(|x| x.re), load.map(|x| x.im)].map(|part| self.turned(&part));
        re.zip_map(&im, Complex::new)
    }

    /// The mean drift of all waves in full height, in the earth's directions \[N, N m\].
    #[must_use]
    pub fn mean_drift(&self) -> Vector6<f64> {
        let terms = self.fields.iter().flat_map(|(_, terms)| terms);
        let sum = terms.map(|term| in_plan(&term.drift) * term.amplitude.powi(2));
        self.turned(&sum.sum())
    }

    /// Slow drift by bands of its frequency, which end at these \[rad/s\], rising: of each pair of components of a field the load at the
    /// difference of their frequencies \[N, N m\], as the sum of the squares of its amplitudes in the band,
    /// `[surge, sway, yaw]` by `[surge, sway, yaw]`, in the earth's directions. Beyond the last band it is left out.
    #[must_use]
    pub fn slow_drift(&self, ends: &[f64]) -> Vec<Matrix3<f64>> {
        let mut squares = vec![Matrix3::zeros(); ends.len()];
        for (_, terms) in &self.fields {
            for (j, one) in terms.iter().enumerate() {
                for other in &terms[j + 1..] {
                    let difference = (other.omega - one.omega).abs();
                    let band = ends.partition_point(|end| *end <= difference);
                    let Some(square) = squares.get_mut(band) else {
                        continue;
                    };
                    let size = one.amplitude * other.amplitude;
                    let drift = [0, 1, 2].map(|k| size * (one.drift[k] + other.drift[k]));
                    let load = self.turned(&in_plan(&drift));
                    let load = Vector3::new(load[0], load[1], load[5]);
                    *square += load * load.transpose();
                }
            }
        }
        squares
    }

    /// Along the earth's directions.
    fn turned(&self, load: &Vector6<f64>) -> Vector6<f64> {
        let (sin, cos) = self.heading.sin_cos();
        let pair = |x: f64, y: f64| (x * cos - y * sin, x * sin + y * cos);
        let ((fx, fy), (mx, my)) = (pair(load[0], load[1]), pair(load[3], load[4]));
        Vector6::new(fx, fy, load[2], mx, my, load[5])
    }
}

/// Surge, sway and yaw as a load of six components.
fn in_plan(drift: &[f64; 3]) -> Vector6<f64> {
    Vector6::new(drift[0], drift[1], 0.0, 0.0, 0.0, drift[2])
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::physics::sea::{Component, DepthDecay, Stretching, WaveLoad, WaveSettings};
    use crate::system::potential_flow::DriftTable;

    #[test]
    fn drift_in_two_waves_is_the_mean_and_beats_by_newman() {
        let waves = [(0.6, 1.5), (0.7, 1.0)].map(|(omega, amplitude)| Component {
            omega,
            amplitude,
            phase: 0.0,
        });
        let setting = WaveSettings {
            direction: 0.0,
            depth: f64::INFINITY,
            gravity: 9.81,
            stretching: Stretching::Vertical,
            decay: DepthDecay::Airy,
            ramp: 0.0,
            load: WaveLoad::Morison,
        };
        let sea = Sea::new(vec![WaveField::new(waves.to_vec(), &setting)]);
        let drift = DriftTable::new(
            vec![0.0],
            vec![0.6, 0.7],
            vec![vec![[2.0, 0.0, 0.0], [-4.0, 0.0, 0.0]]],
        );
        let flow = PotentialFlow {
            drift: Some(Arc::new(drift)),
            ..PotentialFlow::default()
        };
        let loads = WaveLoads::new(&flow, &sea, &Pose::default());
        for t in [0.0, 7.0, 31.0] {
            // 2 a² D each, and the beat with the mean of both: -1.
            let expected = 2.0 * 2.25 - 4.0 - 2.0 * 1.5 * f64::cos(0.1 * t);
            assert!((loads.at(t)[0] - expected).abs() < 1e-12);
        }
        // The same as a mean, and as the square of the amplitude of the beat.
        assert!((loads.mean_drift()[0] - (2.0 * 2.25 - 4.0)).abs() < 1e-12);
        let bands = loads.slow_drift(&[0.05, 0.2]);
        assert_eq!(bands[0], Matrix3::zeros());
        assert!((bands[1][(0, 0)] - 9.0).abs() < 1e-12);
        assert!(uncovered(&flow, &sea, 0.0).is_none());
        assert!(uncovered(&flow, &sea, 1.0).is_some());
    }
}
