//! What acts on a ship in time: wind, current and drift by their coefficients on the ship as it turns and moves, and the
//! loads of waves.

use nalgebra::{Complex, Matrix6, Vector6};

use crate::physics::growth::growth;
use crate::physics::sea::Component;
use crate::ship::hull::HullMatrices;
use crate::ship::loads::EnvironmentalLoads;
use crate::ship::motion::wave_response::WaveResponse;
use crate::solve::Factors;

/// Degrees of freedom that wind, current and drift act on.
const PLANAR: [usize; 3] = [0, 1, 5];

/// What acts on a ship in time, in axes along the heading that it rests at.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Forcing {
    /// Wind, current and drift, and the heading \[rad\] that the axes lie along.
    pub flows: Option<(EnvironmentalLoads, f64)>,
    /// Loads of waves.
    pub waves: Vec<WaveLoad>,
    /// The waves grow from nothing over this time \[s\].
    pub ramp: f64,
}

/// The load of a regular wave, `cosine cos(omega t) + sine sin(omega t)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveLoad {
    /// Angular frequency \[rad/s\].
    pub omega: f64,
    /// Forces \[N\] and moments \[N m\] with the cosine.
    pub cosine: Vector6<f64>,
    /// Those with the sine.
    pub sine: Vector6<f64>,
}

/// The loads of a sea that make a free ship answer it as its responses say: `(-ω² M + i ω D + K) u`, eq. (4) of the ropeway
/// paper without the mooring.
#[must_use]
pub fn wave_loads(hull: &HullMatrices, answer: &WaveResponse, sea: &[Component]) -> Vec<WaveLoad> {
    let load = |wave: &Component| {
        let w = wave.omega;
        let response = answer.rao.response(w);
        let amplitude = Complex::from_polar(wave.amplitude, wave.phase);
        let real = hull.restoring - hull.mass * (w * w);
        let imaginary = hull.damping * w;
        let of = |i: usize| -> Complex<f64> {
            let row = |j: usize| Complex::new(real[(i, j)], imaginary[(i, j)]) * response[j];
            (0..6).map(row).sum::<Complex<f64>>() * amplitude
        };
        let each: [Complex<f64>; 6] = std::array::from_fn(of);
        WaveLoad {
            omega: w,
            cosine: Vector6::from_fn(|i, _| each[i].re),
            sine: Vector6::from_fn(|i, _| -each[i].im),
        }
    };
    sea.iter().map(load).collect()
}

impl Forcing {
    /// Force \[N\] and moment \[N m\] at a time \[s\] on a ship displaced by its six motions, going with their rates.
    #[must_use]
    pub fn at(&self, time: f64, q: &Vector6<f64>, v: &Vector6<f64>) -> Vector6<f64> {
        let mut load = Vector6::zeros();
        for wave in &self.waves {
            let (sin, cos) = (wave.omega * time).sin_cos();
            load += wave.cosine * cos + wave.sine * sin;
        }
        if !self.waves.is_empty() {
            load *= growth(time, self.ramp).0;
        }
        if let Some((loads, heading)) = &self.flows {
            let moving = loads.moving(*heading, q[5], [v[0], v[1]]);
            for (value, i) in moving.load.iter().zip(PLANAR) {
                load[i] += value;
            }
        }
        load
    }

    /// Its derivative, by displacements and by rates as these factors weigh them.
    #[must_use]
    pub fn tangent(&self, q: &Vector6<f64>, v: &Vector6<f64>, c: Factors) -> Matrix6<f64> {
        let mut tangent = Matrix6::zeros();
        if let Some((loads, heading)) = &self.flows {
            let moving = loads.moving(*heading, q[5], [v[0], v[1]]);
            for (row, i) in PLANAR.into_iter().enumerate() {
                tangent[(i, 5)] += moving.by_turn[row] * c.stiffness;
                tangent[(i, 0)] += moving.by_velocity[0][row] * c.damping;
                tangent[(i, 1)] += moving.by_velocity[1][row] * c.damping;
            }
        }
        tangent
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tangent_is_the_derivative() {
        let text = include_str!("../../../cases/ship/anchored.toml");
        let rest = crate::ship::parse(text, "ship.toml").unwrap();
        let forcing = Forcing {
            flows: Some((rest.loads, 0.4)),
            ..Forcing::default()
        };
        let q = Vector6::new(0.1, 0.2, 0.0, 0.0, 0.0, 0.3);
        let v = Vector6::new(0.2, -0.1, 0.0, 0.0, 0.0, 0.02);
        let c = Factors {
            mass: 0.0,
            damping: 0.7,
            stiffness: 1.3,
        };
        let tangent = forcing.tangent(&q, &v, c);
        let h = 1e-6;
        for j in 0..6 {
            let mut along = Vector6::zeros();
            along[j] = h;
            let at = |sign: f64| {
                let (dq, dv) = (along * (sign * c.stiffness), along * (sign * c.damping));
                forcing.at(0.0, &(q + dq), &(v + dv))
            };
            let slope = (at(1.0) - at(-1.0)) / (2.0 * h);
            let scale = 1.0 + tangent.abs().max();
            assert!((slope - tangent.column(j)).norm() < 1e-6 * scale);
        }
    }
}
