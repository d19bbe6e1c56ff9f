//! Free decay of ship and line in the time domain, released in the slowest oscillating mode of the linearised equations: a check
//! of its period and damping, up to the inertia and drag of the line, which the linearised equations neglect.

use std::f64::consts::TAU;

use std::sync::atomic::AtomicBool;

use nalgebra::{Complex, Matrix3, Vector3};

use super::CoupledError;
use super::model::{CoupledModel, ShipVariant};
use super::time_domain::integrate;
use crate::numerics::V3;
use crate::ship::stability::PlanarDynamics;

/// Free decay in the slowest oscillating mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeDecay {
    /// Period of the mode, linearised, on a quasi-static line \[s\].
    pub linear_s: f64,
    /// Period measured in the time domain \[s\].
    pub measured_s: f64,
    /// Amplitude ratio of successive periods, linearised.
    pub linear_ratio: f64,
    /// Amplitude ratio measured in the time domain.
    pub measured_ratio: f64,
}

/// Periods simulated.
const PERIODS: f64 = 1.5;

/// Steps a period.
const STEPS: f64 = 400.0;

/// Initial displacement as a fraction of the water depth.
const AMPLITUDE: f64 = 5e-3;

impl FreeDecay {
    /// Releases the ship from opposite displacements; half the difference of the two runs cancels the offset of the
    /// discretised equilibrium.
    ///
    /// # Errors
    /// [`CoupledError`]: no oscillating mode, or the time integration failed.
    pub fn new(model: &CoupledModel<'_>, stop: &AtomicBool) -> Result<Self, CoupledError> {
        let missing = CoupledError::Missing;
        let planar = model.equilibrium.dynamics.as_ref();
        let planar = planar.ok_or(missing("the file has no [hull]"))?;
        let (root, shape) = slowest(planar).ok_or(missing("every slow mode is overdamped"))?;
        let largest = shape.iter().map(|u| u.norm()).fold(0.0, f64::max);
        let scale = AMPLITUDE * model.mooring.depth_m / largest.max(f64::MIN_POSITIVE);
        let (plus, minus) = rayon::join(
            || release(model, root, &shape, scale, stop),
            || release(model, root, &shape, -scale, stop),
        );
        let (plus, minus) = (plus?, minus?);
        let filter =
            ModalFilter::new(planar, root).ok_or(missing("the slow modes cannot be separated"))?;
        let modal: Vec<(f64, Complex<f64>)> = plus
            .iter()
            .zip(&minus)
            .map(|(a, b)| {
                (
                    a.time,
                    filter.amplitude(&((a.q - b.q) * 0.5), &((a.v - b.v) * 0.5)),
                )
            })
            .collect();
        let measured = growth_rate(&modal)
            .filter(|root| root.im.abs() > 0.0)
            .ok_or(missing("the released ship does not oscillate"))?;
        let ratio = |root: Complex<f64>| (root.re * TAU / root.im.abs()).exp();
        Ok(Self {
            linear_s: TAU / root.im.abs(),
            measured_s: TAU / measured.im.abs(),
            linear_ratio: ratio(root),
            measured_ratio: ratio(measured),
        })
    }
}

/// Surge, sway and yaw at an instant.
struct PlanarState {
    time: f64,
    q: Vector3<f64>,
    v: Vector3<f64>,
}

/// Modal coordinate of one mode, `w·(λ M q + D q + M v)` with w its left eigenvector: zero for any other mode of the same
/// equations, proportional to `e^(λ t)` in free motion.
struct ModalFilter {
    by_displacement: Vector3<Complex<f64>>,
    by_velocity: Vector3<Complex<f64>>,
}

impl ModalFilter {
    fn new(planar: &PlanarDynamics, root: Complex<f64>) -> Option<Self> {
        let left = null_vector(&pencil(planar, root).transpose())?;
        let mass = complex(&planar.mass);
        let displacement = mass * root + complex(&planar.damping);
        Some(Self {
            by_displacement: displacement.tr_mul(&left),
            by_velocity: mass.tr_mul(&left),
        })
    }

    fn amplitude(&self, q: &Vector3<f64>, v: &Vector3<f64>) -> Complex<f64> {
        (0..3)
            .map(|i| self.by_displacement[i] * q[i] + self.by_velocity[i] * v[i])
            .sum()
    }
}

/// λ of values proportional to `e^(λ t)`: least squares on their logarithm, with its branch followed.
fn growth_rate(values: &[(f64, Complex<f64>)]) -> Option<Complex<f64>> {
    let mut logarithm = Complex::new(0.0, 0.0);
    let mut before = values.first()?.1;
    let mut logs = Vec::with_capacity(values.len());
    for (t, value) in values {
        logarithm += (value / before).ln();
        before = *value;
        logs.push((*t, logarithm));
    }
    let n = logs.len() as f64;
    let time = logs.iter().map(|(t, _)| t).sum::<f64>() / n;
    let mean = logs.iter().map(|(_, l)| l).sum::<Complex<f64>>() / n;
    let square: f64 = logs.iter().map(|(t, _)| (t - time).powi(2)).sum();
    let product: Complex<f64> = logs.iter().map(|(t, l)| (l - mean) * (t - time)).sum();
    let root = product / square;
    (root.re.is_finite() && root.im.is_finite()).then_some(root)
}

/// Free motion after release in a mode of this shape and scale, in still water.
fn release(
    model: &CoupledModel<'_>,
    root: Complex<f64>,
    shape: &[Complex<f64>; 3],
    scale: f64,
    stop: &AtomicBool,
) -> Result<Vec<PlanarState>, CoupledError> {
    // The shape is real where it is largest: the release is at a crest.
    let [surge, sway, yaw] = shape.map(|u| scale * u.re);
    let period = TAU / root.im.abs();
    let step = period / STEPS;
    let variant = ShipVariant {
        segments: model.settings.segments,
        step_s: step,
        duration_s: PERIODS * period,
        interval_s: step,
        start: (V3::new(surge, sway, 0.0), yaw),
    };
    let history = integrate(model.system(&variant, None), &V3::zeros(), stop)?;
    let channel = |k: usize| &history.records[k];
    let (surge, sway, yaw) = (channel(0), channel(1), channel(5));
    let at = |i: usize| Vector3::new(surge[i], sway[i], yaw[i].to_radians());
    // Rows a step apart: velocities by differences, off by the square of 2 pi / STEPS over 6.
    let inner = 1..surge.len().saturating_sub(1);
    let state = |i: usize| PlanarState {
        time: step * i as f64,
        q: at(i),
        v: (at(i + 1) - at(i - 1)) / (2.0 * step),
    };
    Ok(inner.map(state).collect())
}

/// Eigenvalue of the slowest oscillating mode, with its shape in surge, sway and yaw.
fn slowest(planar: &PlanarDynamics) -> Option<(Complex<f64>, [Complex<f64>; 3])> {
    let list = planar.eigenvalues()?;
    // The period of a mode that decays within a cycle cannot be measured.
    let oscillates = |l: &&Complex<f64>| l.im > 0.0 && l.re.abs() < 0.15 * l.im;
    let root = *list
        .iter()
        .filter(oscillates)
        .min_by(|a, b| a.im.total_cmp(&b.im))?;
    let shape = null_vector(&pencil(planar, root))?;
    let shape = [shape[0], shape[1], shape[2]];
    let lead = shape[largest(&shape)];
    (lead.norm() > 0.0).then(|| (root, shape.map(|u| u / lead)))
}

fn complex(matrix: &Matrix3<f64>) -> Matrix3<Complex<f64>> {
    matrix.map(|value| Complex::new(value, 0.0))
}

/// `M λ² + D λ + K`.
fn pencil(planar: &PlanarDynamics, root: Complex<f64>) -> Matrix3<Complex<f64>> {
    complex(&planar.mass) * (root * root)
        + complex(&planar.damping) * root
        + complex(&planar.stiffness)
}

/// Null vector of a singular matrix: the longest cross product of its normalised rows.
fn null_vector(matrix: &Matrix3<Complex<f64>>) -> Option<Vector3<Complex<f64>>> {
    let rows: Vec<Vector3<Complex<f64>>> = matrix
        .row_iter()
        .map(|row| {
            let row = row.transpose();
            let size = row.norm().max(f64::MIN_POSITIVE);
            row / Complex::new(size, 0.0)
        })
        .collect();
    let products = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| rows[i].cross(&rows[j]));
    products
        .into_iter()
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))
        .filter(|longest| longest.norm() > 0.0)
}

/// Index of the largest component.
fn largest(shape: &[Complex<f64>; 3]) -> usize {
    let size = |i: &usize| shape[*i].norm();
    (0..3)
        .max_by(|a, b| size(a).total_cmp(&size(b)))
        .unwrap_or_default()
}
