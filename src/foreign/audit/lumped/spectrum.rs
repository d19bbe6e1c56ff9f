//! The fastest motion of lumped masses, and the time step that it allows.

use nalgebra::{Complex, DVector};

use super::LumpedModel;
use super::equilibrium::{Unknowns, stiffness};
use super::forces::Loads;
use crate::numerics::V3;
use crate::numerics::envelope::EnvelopeMatrix;

/// Iterations of the power method.
const ITERATIONS: usize = 400;

/// The fastest mode of a system about its rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastestMode {
    /// Undamped angular frequency \[rad/s\].
    pub frequency: f64,
    /// Share of critical damping by the internal damping of the lines and by the bed.
    pub damping: f64,
}

/// The fastest modes about places at rest, by the power method: that of the highest frequency, and that of the strongest damping.
/// Nothing where nothing is free.
#[must_use]
pub fn fastest(model: &LumpedModel, x: &[V3]) -> Vec<FastestMode> {
    let unknowns = Unknowns::of_model(model);
    let still = vec![V3::zeros(); x.len()];
    let mut loads = Loads::of_model(model);
    model.evaluate(x, &still, 0.0, &mut loads);
    let stiff = stiffness(model, &unknowns, x);
    let damped = dampers(model, &unknowns, x);
    let by_mass = |push: &DVector<f64>| {
        let mut next = DVector::zeros(push.len());
        for (node, first) in unknowns.first.iter().enumerate() {
            if let (Some(first), Some(inverse)) = (first, loads.mass[node].try_inverse()) {
                let part = inverse * push.fixed_rows::<3>(*first);
                next.fixed_rows_mut::<3>(*first).copy_from(&part);
            }
        }
        next
    };
    let mut modes = Vec::new();
    for by in [&stiff, &damped] {
        let Some(mode) = greatest(unknowns.count(), |mode| by_mass(&by.times(mode))) else {
            continue;
        };
        let [square, rate] = [&stiff, &damped].map(|of| mode.dot(&by_mass(&of.times(&mode))));
        let frequency = square.max(0.0).sqrt();
        if frequency > 0.0 {
            modes.push(FastestMode {
                frequency,
                damping: 0.5 * rate.max(0.0) / frequency,
            });
        }
    }
    modes
}

/// The vector that a matrix multiplies most, by the power method; nothing where it is zero.
fn greatest(count: usize, times: impl Fn(&DVector<f64>) -> DVector<f64>) -> Option<DVector<f64>> {
    // Signs alternate from node to node, as in the fastest modes; no mode is orthogonal to it.
    let mut mode = DVector::from_fn(count, |k, _| {
        let sign = if (k / 3) % 2 == 0 { 1.0 } else { -1.0 };
        sign * (1.0 + 0.37 * ((k * k + 3) % 17) as f64)
    });
    for _ in 0..ITERATIONS {
        mode = times(&mode);
        let norm = mode.norm();
        if !(norm > 0.0 && norm.is_finite()) {
            return None;
        }
        mode /= norm;
    }
    Some(mode)
}

/// The internal damping of the lines, and that of the bed under nodes in it \[N s/m\].
fn dampers(model: &LumpedModel, unknowns: &Unknowns, x: &[V3]) -> EnvelopeMatrix {
    let mut matrix = unknowns.matrix();
    for line in &model.lines {
        for pair in line.nodes.windows(2) {
            let apart = x[pair[1]] - x[pair[0]];
            let along = apart.try_normalize(0.0).unwrap_or_else(V3::z);
            let block = along * along.transpose() * (line.damping / line.segment);
            for (row, column, sign) in [(0, 0, 1.0), (1, 1, 1.0), (0, 1, -1.0), (1, 0, -1.0)] {
                let at = [row, column].map(|end| unknowns.first[pair[end]]);
                if let [Some(row), Some(column)] = at {
                    matrix.add_block(row, column, &(block * sign));
                }
            }
        }
        let last = line.nodes.len() - 1;
        for (i, node) in line.nodes.iter().copied().enumerate() {
            let halves = if i == 0 || i == last { 0.5 } else { 1.0 };
            let lies = model.bed_z.is_some_and(|z| x[node].z < z);
            if let Some(first) = unknowns.first[node].filter(|_| lies) {
                let push = model.bed_damping * line.diameter * halves * line.segment;
                matrix.add(first + 2, first + 2, push);
            }
        }
    }
    matrix
}

/// Schemes of integration with constant steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scheme {
    /// Euler's, of first order.
    Euler,
    /// The midpoint rule or Heun's method.
    Second,
    /// The classical method of Runge and Kutta.
    Fourth,
}

impl Scheme {
    /// The scheme of a name; nothing for those that are not judged here.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name.to_lowercase().as_str() {
            "euler" => Some(Self::Euler),
            "rk2" | "heun" => Some(Self::Second),
            "rk4" => Some(Self::Fourth),
            _ => None,
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Euler => "Euler",
            Self::Second => "RK2",
            Self::Fourth => "RK4",
        }
    }

    /// By how much a step multiplies a motion of this rate times the step.
    #[must_use]
    fn growth(self, z: Complex<f64>) -> Complex<f64> {
        let order = match self {
            Self::Euler => 1,
            Self::Second => 2,
            Self::Fourth => 4,
        };
        let mut term = Complex::new(1.0, 0.0);
        let mut sum = term;
        for k in 1..=order {
            term = term * z / f64::from(k);
            sum += term;
        }
        sum
    }

    /// The greatest factor of a step of the two motions of a damped mode.
    #[must_use]
    pub fn amplification(self, mode: &FastestMode, step: f64) -> f64 {
        let FastestMode { frequency, damping } = *mode;
        let root = Complex::new(damping * damping - 1.0, 0.0).sqrt();
        let rates = [root, -root].map(|root| (root - damping) * frequency);
        let factors = rates.map(|rate| self.growth(rate * step).norm());
        factors[0].max(factors[1])
    }

    /// Error of the period of an undamped mode by steps of this length, by the period.
    #[must_use]
    pub fn period_error(self, mode: &FastestMode, step: f64) -> f64 {
        let angle = mode.frequency * step;
        let turned = self.growth(Complex::new(0.0, angle)).arg();
        match angle < std::f64::consts::FRAC_PI_2 && turned > 0.0 {
            true => (angle / turned - 1.0).abs(),
            false => f64::INFINITY,
        }
    }

    /// The longest step \[s\] with which a mode does not grow; nothing where it grows with every step.
    #[must_use]
    pub fn longest_step(self, mode: &FastestMode) -> Option<f64> {
        // A rounding error is no growth, but an undamped mode must not pass by it.
        let holds = |step: f64| self.amplification(mode, step) <= 1.0 + 1e-12;
        let mut step = 8.0 / (mode.frequency * (1.0 + 2.0 * mode.damping));
        let least = 1e-3 * step;
        while step > least {
            if holds(step) {
                return Some(step);
            }
            step *= 0.998;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_of_stability_are_the_known_ones() {
        let undamped = FastestMode {
            frequency: 2.0,
            damping: 0.0,
        };
        let fourth = Scheme::Fourth.longest_step(&undamped).unwrap();
        assert!((fourth * 2.0 / 8f64.sqrt() - 1.0).abs() < 5e-3, "{fourth}");
        assert_eq!(Scheme::Euler.longest_step(&undamped), None);
        let overdamped = FastestMode {
            frequency: 1.0,
            damping: 10.0,
        };
        let rate = 10.0 + 99f64.sqrt();
        let second = Scheme::Second.longest_step(&overdamped).unwrap();
        assert!((second * rate / 2.0 - 1.0).abs() < 5e-3, "{second}");
    }
}
