//! Loads on a ship in the time domain: wind, current and mean drift by their coefficients on the moving ship, and first-order
//! wave loads.

use nalgebra::{Complex, Matrix6, Vector6};

use crate::physics::ramp::smooth_ramp;
use crate::physics::sea::Component;
use crate::ship::hull::HullMatrices;
use crate::ship::loads::EnvironmentalLoads;
use crate::ship::motion::wave_response::WaveResponse;
use crate::solve::Factors;

/// Degrees of freedom that wind, current and drift act on.
const PLANAR: [usize; 3] = [0, 1, 5];

/// Loads on a ship in the time domain, in axes along a fixed heading.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Forcing {
    /// Wind, current and drift, and the heading of the axes \[rad\].
    pub environment: Option<(EnvironmentalLoads, f64)>,
    /// First-order wave loads.
    pub waves: Vec<WaveLoad>,
    /// Time over which the waves grow from zero \[s\].
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

/// Wave loads that give the free ship its RAOs u: `(-ω² M + i ω D + K) u`, eq. (4) of the ropeway paper without mooring.
#[must_use]
pub fn wave_loads(
    hull: &HullMatrices,
    response: &WaveResponse,
    waves: &[Component],
) -> Vec<WaveLoad> {
    let load = |wave: &Component| {
        let w = wave.omega;
        let response = response.rao.response(w);
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
    waves.iter().map(load).collect()
}

impl Forcing {
    /// Force \[N\] and moment \[N m\] at a time \[s\] on a ship of displacements `q` and velocities `v`.
    #[must_use]
    pub fn at(&self, time: f64, q: &Vector6<f64>, v: &Vector6<f64>) -> Vector6<f64> {
        let mut load = Vector6::zeros();
        for wave in &self.waves {
            let (sin, cos) = (wave.omega * time).sin_cos();
            load += wave.cosine * cos + wave.sine * sin;
        }
        if !self.waves.is_empty() {
            load *= smooth_ramp(time, self.ramp).0;
        }
        if let Some((loads, heading)) = &self.environment {
            let linearised = loads.linearised(*heading, q[5], [v[0], v[1]]);
            for (value, i) in linearised.load.iter().zip(PLANAR) {
                load[i] += value;
            }
        }
        load
    }

    /// Its derivatives by displacements and velocities, weighted by these factors.
    #[must_use]
    pub fn tangent(&self, q: &Vector6<f64>, v: &Vector6<f64>, c: Factors) -> Matrix6<f64> {
        let mut tangent = Matrix6::zeros();
        if let Some((loads, heading)) = &self.environment {
            let linearised = loads.linearised(*heading, q[5], [v[0], v[1]]);
            for (row, i) in PLANAR.into_iter().enumerate() {
                tangent[(i, 5)] += linearised.by_yaw[row] * c.stiffness;
                tangent[(i, 0)] += linearised.by_velocity[0][row] * c.damping;
                tangent[(i, 1)] += linearised.by_velocity[1][row] * c.damping;
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
        let rest = crate::case::kind::parse::<crate::ship::Ship>(text, "ship.toml").unwrap();
        let forcing = Forcing {
            environment: Some((rest.loads, 0.4)),
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
