//! Waves on a line whose tension, mass and stiffness change slowly along it, after Wentzel, Kramers and Brillouin.
//!
//! A wave of angular frequency omega across a line of tension T, bending stiffness EI and mass m (with added mass) per length
//! has the local wave number k of `EI k⁴ + T k² = m omega²`, and an amplitude a with `(2 EI k³ + T k) a² = const` (cable
//! with two float zones, equations 26 and 29; the second is the flux of energy, so that it holds also where EI and m
//! change slowly). A line hinged at both ends has a mode where the phase `∫ k ds` is a whole number of pi.
//!
//! Motion in the plane of the line and out of it obey the same formulas: the section is round, and the bow of the line and
//! its stretch, which make the lowest modes in the plane differ, are left out. Reflections where the
//! medium jumps, as at the ends of a float zone, are left out as well.

use std::f64::consts::PI;

use super::ModePencil;
use crate::numerics::V3;
use crate::numerics::quadrature::cumulative_trapezoid;
use crate::numerics::roots::{Bracket, bisect};
use crate::scene::Scene;
use crate::solve::State;

/// Steps of the bisection for a frequency on a logarithmic scale, down to rounding.
const HALVINGS: usize = 200;

/// Local wave number \[1/m\] from tension \[N\], bending stiffness \[N m²\], mass by length \[kg/m\] and angular frequency
/// \[rad/s\]: `k² = 2 m omega² / (T + sqrt(T² + 4 EI m omega²))`, which loses no digits to EI = 0. Infinite if both
/// are zero.
#[must_use]
pub fn wave_number(tension: f64, ei: f64, mass: f64, omega: f64) -> f64 {
    let inertia = mass * omega * omega;
    let whole = tension + tension.hypot(2.0 * (ei * inertia).sqrt());
    (2.0 * inertia / whole).sqrt()
}

/// The medium of a wave: a line at rest, node by node.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WkbMedium {
    /// Arc length from end A, stretched \[m\].
    pub arc: Vec<f64>,
    /// Tension \[N\].
    pub tension: Vec<f64>,
    /// Bending stiffness \[N m²\].
    pub ei: Vec<f64>,
    /// Mass by length with added mass across the line \[kg/m\].
    pub mass: Vec<f64>,
}

/// A wave of one frequency along a medium, node by node.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WkbWave {
    /// Local wave number \[1/m\].
    pub number: Vec<f64>,
    /// Phase from end A \[rad\].
    pub phase: Vec<f64>,
    /// Amplitude, the greatest 1 \[-\].
    pub amplitude: Vec<f64>,
}

impl WkbMedium {
    /// The line of a scene at rest; none if it is slack somewhere without bending stiffness.
    #[must_use]
    pub fn of_line_at_rest(scene: &Scene, rest: &State) -> Option<Self> {
        let nodes = scene.line_nodes();
        let chord = |i: usize| rest.x[i + 1] - rest.x[i];
        let mut arc = vec![0.0];
        for i in 0..nodes.checked_sub(1)? {
            arc.push(arc[i] + chord(i).norm());
        }
        let last = nodes - 1;
        // Each node has half of the segments beside it, and their mass.
        let held = |i: usize| {
            let before = if i > 0 { arc[i] - arc[i - 1] } else { 0.0 };
            let after = if i < last { arc[i + 1] - arc[i] } else { 0.0 };
            0.5 * (before + after)
        };
        let pencil = ModePencil::new(scene, rest);
        let plane = super::LinePlane::nearest_to(&rest.x[..nodes]);
        let across: Vec<V3> = plane.across(&rest.x[..nodes]);
        let mass = |i: usize| across[i].dot(&(pencil.mass(i) * across[i])) / held(i);
        // Bodies at an end are no part of the medium.
        let inner = |i: usize| i.clamp(1, last.saturating_sub(1).max(1)).min(last);
        let segment = |i: usize| scene.line.segments[i.min(last - 1)].ei;
        let stiffness = |i: usize| 0.5 * (segment(i.saturating_sub(1)) + segment(i));
        let medium = Self {
            tension: scene.tensions(rest),
            ei: (0..nodes).map(stiffness).collect(),
            mass: (0..nodes).map(|i| mass(inner(i))).collect(),
            arc,
        };
        let held = medium.tension.iter().zip(&medium.ei);
        let mut held = held.map(|(t, ei)| *t > 0.0 || *ei > 0.0);
        held.all(|held| held).then_some(medium)
    }

    /// A wave of angular frequency omega \[rad/s\].
    #[must_use]
    pub fn wave(&self, omega: f64) -> WkbWave {
        let nodes = 0..self.arc.len();
        let number: Vec<f64> = nodes
            .clone()
            .map(|i| wave_number(self.tension[i], self.ei[i], self.mass[i], omega))
            .collect();
        let flux = |i: usize| number[i] * (2.0 * self.ei[i] * number[i].powi(2) + self.tension[i]);
        let bare: Vec<f64> = nodes.map(|i| flux(i).powf(-0.5)).collect();
        let most = bare.iter().copied().fold(0.0, f64::max);
        WkbWave {
            phase: cumulative_trapezoid(&self.arc, &number),
            amplitude: bare.iter().map(|a| a / most).collect(),
            number,
        }
    }

    /// Frequency \[Hz\] of the n-th mode, from 1, of the line hinged at both ends.
    #[must_use]
    pub fn frequency_hz(&self, n: usize) -> Option<f64> {
        let wanted = n as f64 * PI;
        let turned = |omega: f64| {
            let number = |i: usize| wave_number(self.tension[i], self.ei[i], self.mass[i], omega);
            let steps = (1..self.arc.len()).map(|i| {
                let step = self.arc[i] - self.arc[i - 1];
                0.5 * step * (number(i) + number(i - 1))
            });
            steps.sum::<f64>()
        };
        let (low, high) = (1e-9, 1e9);
        if n == 0 || turned(low) > wanted || turned(high) < wanted {
            return None;
        }
        let geometric_mean = |b: &Bracket| (b.low * b.high).sqrt();
        let below = |omega: f64| turned(omega) < wanted;
        let omega = bisect(Bracket { low, high }, HALVINGS, geometric_mean, below).high;
        Some(omega / std::f64::consts::TAU)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn medium(nodes: usize, tension: impl Fn(f64) -> f64, ei: f64) -> WkbMedium {
        let arc: Vec<f64> = (0..nodes)
            .map(|i| 100.0 * i as f64 / (nodes - 1) as f64)
            .collect();
        WkbMedium {
            tension: arc.iter().map(|s| tension(*s)).collect(),
            ei: vec![ei; nodes],
            mass: vec![2.0; nodes],
            arc,
        }
    }

    #[test]
    fn wave_numbers_solve_their_equation() {
        for (t, ei, m, omega) in [
            (1e3, 0.0, 2.0, 3.0),
            (1e3, 50.0, 2.0, 9.0),
            (0.0, 50.0, 2.0, 9.0),
            (-5.0, 50.0, 2.0, 9.0),
        ] {
            let k = wave_number(t, ei, m, omega);
            let left = ei * k.powi(4) + t * k * k;
            assert!((left / (m * omega * omega) - 1.0).abs() < 1e-12, "{t} {ei}");
        }
        assert!(wave_number(0.0, 0.0, 2.0, 3.0).is_infinite());
    }

    #[test]
    fn an_even_string_and_an_even_beam_are_exact() {
        let string = medium(11, |_| 800.0, 0.0);
        let beam = medium(11, |_| 0.0, 800.0);
        for n in 1..6 {
            let k = n as f64 * PI / 100.0;
            let tau = std::f64::consts::TAU;
            let expected = (
                k * (800.0_f64 / 2.0).sqrt(),
                k * k * (800.0_f64 / 2.0).sqrt(),
            );
            assert!((string.frequency_hz(n).unwrap() * tau / expected.0 - 1.0).abs() < 1e-12);
            assert!((beam.frequency_hz(n).unwrap() * tau / expected.1 - 1.0).abs() < 1e-12);
        }
        let wave = string.wave(3.0);
        assert!(wave.amplitude.iter().all(|a| (a - 1.0).abs() < 1e-12));
        assert!(string.frequency_hz(0).is_none());
    }

    #[test]
    fn on_a_hanging_chain_amplitudes_fall_as_the_fourth_root_of_tension() {
        // T = m g s: k = omega / sqrt(g s), phase 2 omega (sqrt(s) - sqrt(s0)) / sqrt(g), amplitude s^(-1/4).
        let chain = medium(4001, |s| 2.0 * 9.81 * (s + 10.0), 0.0);
        let omega = 4.0;
        let wave = chain.wave(omega);
        let phase = |s: f64| 2.0 * omega * ((s + 10.0).sqrt() - 10.0_f64.sqrt()) / 9.81_f64.sqrt();
        for (i, s) in chain.arc.iter().enumerate() {
            assert!((wave.phase[i] - phase(*s)).abs() < 1e-6 * phase(100.0));
            assert!((wave.amplitude[i] - (10.0 / (s + 10.0)).powf(0.25)).abs() < 1e-12);
        }
    }

    /// Four waves between hinged ends, eqs (30) to (34) of the paper of the double-stepped cable: the constants of eq. (33), C with
    /// the sign that its eq. (31) needs and the print lacks, are -1, 0 and 0, so that the shapes are sines.
    #[test]
    fn four_waves_between_hinges_are_the_sines_of_equations_30_to_34() {
        use nalgebra::Complex;
        let (t, ei, m, length): (f64, f64, f64, f64) = (5000.0, 82.0, 4.2, 100.0);
        for n in 1..6 {
            let travelling = f64::from(n) * PI / length;
            let omega = ((ei * travelling.powi(4) + t * travelling.powi(2)) / m).sqrt();
            assert!((wave_number(t, ei, m, omega) / travelling - 1.0).abs() < 1e-12);
            // The evanescent pair, shortened so that its exponentials stay finite: the algebra does not need its size.
            let evanescent = 0.01 * (travelling.powi(2) + t / ei).sqrt();
            let i = Complex::<f64>::i();
            let k = [
                Complex::from(travelling),
                i * evanescent,
                -i * evanescent,
                Complex::from(-travelling),
            ];
            let e = k.map(|k| (i * k * length).exp());
            let s = k.map(|k| k * k);
            let below = (s[1] - s[0]) * (s[2] - s[0]) * (e[2] - e[1]);
            let a = ((s[1] - s[0]) * (s[2] - s[3]) * e[1]
                + (s[2] - s[0]) * (s[3] - s[1]) * e[2]
                + (s[3] - s[0]) * (s[1] - s[2]) * e[3])
                / below;
            let b = (s[3] - s[0]) * (e[3] - e[2]) / ((s[1] - s[0]) * (e[2] - e[1]));
            let c = -(s[3] - s[0]) * (e[3] - e[1]) / ((s[2] - s[0]) * (e[2] - e[1]));
            assert!((a + 1.0).norm() < 1e-9 && b.norm() < 1e-9 && c.norm() < 1e-9);
            assert!((a * e[0] + b * e[1] + c * e[2] + e[3]).norm() < 1e-9);
        }
    }
}
