//! The check of ship and line in time: let go in the slowest swinging mode of the linearised equations, they swing with the
//! period of that mode, as far as the line's own inertia and drag, which the linearised equations leave out, allow.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix3, Vector3, Vector6};

use super::CoupledError;
use super::model::CoupledModel;
use crate::dynamics::March;
use crate::dynamics::generalized_alpha::GeneralizedAlpha;
use crate::numerics::V3;
use crate::ship::stability::PlanarDynamics;
use crate::solve::{ExplicitRhs, Instant, Kinematics, Progressing};

/// The ship let go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeDecay {
    /// Period of the slowest swinging mode, linearised, on a quasi-static line \[s\].
    pub linear_s: f64,
    /// Period of that mode, measured on ship and line in time \[s\].
    pub measured_s: f64,
    /// Share of the amplitude that is left after a period, linearised.
    pub linear_left: f64,
    /// The same, measured.
    pub measured_left: f64,
}

/// Swings that are followed.
const SWINGS: f64 = 1.5;

/// Steps a swing.
const STEPS: f64 = 400.0;

/// How far the ship is let go, as a share of the depth of water.
const AMPLITUDE: f64 = 5e-3;

/// Lets the ship go and measures its period: from one side and from the other, half the difference of the two, so that where
/// exactly the discretised line rests does not matter.
///
/// # Errors
/// [`CoupledError`]: the ship has no mode that swings, or ship and line cannot be marched.
pub fn decay(setting: &CoupledModel<'_>) -> Result<FreeDecay, CoupledError> {
    let missing = CoupledError::Missing;
    let planar = setting.equilibrium.planar.as_ref();
    let planar = planar.ok_or(missing("the file has no [hull]"))?;
    let (root, shape) =
        slowest(planar).ok_or(missing("every slow motion creeps back without swinging"))?;
    let largest = shape.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let scale = AMPLITUDE * setting.mooring.depth_m / largest.max(f64::MIN_POSITIVE);
    let (there, back) = rayon::join(
        || let_go(setting, root, &shape, scale),
        || let_go(setting, root, &shape, -scale),
    );
    let (there, back) = (there?, back?);
    let filter = Filter::new(planar, root)
        .ok_or(missing("the slow motions are not told from each other"))?;
    // Half the difference of the two, as the mode alone sees it.
    let seen: Vec<(f64, Complex<f64>)> = there
        .iter()
        .zip(&back)
        .map(|(a, b)| {
            (
                a.time,
                filter.of(&((a.q - b.q) * 0.5), &((a.v - b.v) * 0.5)),
            )
        })
        .collect();
    let measured = grown(&seen)
        .filter(|root| root.im.abs() > 0.0)
        .ok_or(missing("the ship let go does not swing around its place"))?;
    let left = |root: Complex<f64>| (root.re * TAU / root.im.abs()).exp();
    Ok(FreeDecay {
        linear_s: TAU / root.im.abs(),
        measured_s: TAU / measured.im.abs(),
        linear_left: left(root),
        measured_left: left(measured),
    })
}

/// The ship in the plane at an instant.
struct Seen {
    time: f64,
    q: Vector3<f64>,
    v: Vector3<f64>,
}

/// What a motion has of one mode alone: `w·(λ M q + D q + M v)`, w the left shape of the mode. Of any other mode of the same
/// equations it sees nothing, of a free motion the mode's `e^(λ t)`.
struct Filter {
    by_place: Vector3<Complex<f64>>,
    by_rate: Vector3<Complex<f64>>,
}

impl Filter {
    fn new(planar: &PlanarDynamics, root: Complex<f64>) -> Option<Self> {
        let left = null(&pencil(planar, root).transpose())?;
        let mass = complex(&planar.mass);
        let place = mass * root + complex(&planar.damping);
        Some(Self {
            by_place: place.tr_mul(&left),
            by_rate: mass.tr_mul(&left),
        })
    }

    fn of(&self, q: &Vector3<f64>, v: &Vector3<f64>) -> Complex<f64> {
        (0..3)
            .map(|i| self.by_place[i] * q[i] + self.by_rate[i] * v[i])
            .sum()
    }
}

/// The root of what grows as `e^(λ t)`, from its logarithm by least squares, turn after turn.
fn grown(seen: &[(f64, Complex<f64>)]) -> Option<Complex<f64>> {
    let mut turns = Complex::new(0.0, 0.0);
    let mut before = seen.first()?.1;
    let mut logs = Vec::with_capacity(seen.len());
    for (t, value) in seen {
        turns += (value / before).ln();
        before = *value;
        logs.push((*t, turns));
    }
    let n = logs.len() as f64;
    let time = logs.iter().map(|(t, _)| t).sum::<f64>() / n;
    let mean = logs.iter().map(|(_, l)| l).sum::<Complex<f64>>() / n;
    let square: f64 = logs.iter().map(|(t, _)| (t - time).powi(2)).sum();
    let product: Complex<f64> = logs.iter().map(|(t, l)| (l - mean) * (t - time)).sum();
    let root = product / square;
    (root.re.is_finite() && root.im.is_finite()).then_some(root)
}

/// The ship let go in a mode, seen over time.
fn let_go(
    setting: &CoupledModel<'_>,
    root: Complex<f64>,
    shape: &[Complex<f64>; 3],
    scale: f64,
) -> Result<Vec<Seen>, CoupledError> {
    // Real where it is largest, so that it begins at a crest.
    let begin = shape.map(|u| scale * u.re);
    let going = shape.map(|u| scale * (root * u).re);
    let turn = V3::z() * begin[2];
    let shift = V3::new(begin[0], begin[1], 0.0) + turn.cross(&setting.arm());
    // Weight and trim are balanced by the line where the ship rests, not where it is let go.
    let (scene, statics) = setting.line(setting.settings.segments, &V3::zeros())?;
    let (_, rigid_displacement) = setting.line(setting.settings.segments, &shift)?;
    let moored = setting.moored(scene, &statics, setting.flows())?;
    let mut state = moored.turned(&rigid_displacement, turn);
    let velocity = Vector6::new(going[0], going[1], 0.0, 0.0, 0.0, going[2]);
    moored.set_going(&velocity, &mut state);
    moored.accelerate(0.0, &mut state);
    let period = TAU / root.im.abs();
    let march = March {
        duration: SWINGS * period,
        step: period / STEPS,
        output: period / STEPS,
    };
    let mut method = GeneralizedAlpha::new(moored.nodes(), 0.0, 1e-11, 30);
    let planar = |all: &Vector6<f64>| Vector3::new(all[0], all[1], all[5]);
    let mut seen = Vec::new();
    let mut watch = |instant: Instant<'_>| {
        if instant.output {
            seen.push(Seen {
                time: instant.time,
                q: planar(&moored.motion(instant.state)),
                v: planar(&moored.velocity(instant.state)),
            });
        }
        Progressing::Continue
    };
    march.run(&mut method, &moored, &mut state, &mut watch)?;
    Ok(seen)
}

/// The slowest mode that swings, with its shape in surge, sway and yaw.
fn slowest(planar: &PlanarDynamics) -> Option<(Complex<f64>, [Complex<f64>; 3])> {
    let list = planar.eigenvalues()?;
    // A mode that dies within a swing has no period to measure.
    let swings = |l: &&Complex<f64>| l.im > 0.0 && l.re.abs() < 0.15 * l.im;
    let root = *list
        .iter()
        .filter(swings)
        .min_by(|a, b| a.im.total_cmp(&b.im))?;
    let shape = null(&pencil(planar, root))?;
    let shape = [shape[0], shape[1], shape[2]];
    let lead = shape[leading(&shape)];
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

/// What a singular matrix makes nothing of: across its rows, the longest of their products.
fn null(matrix: &Matrix3<Complex<f64>>) -> Option<Vector3<Complex<f64>>> {
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

/// Which of surge, sway and yaw moves most.
fn leading(shape: &[Complex<f64>; 3]) -> usize {
    let far = |i: &usize| shape[*i].norm();
    (0..3)
        .max_by(|a, b| far(a).total_cmp(&far(b)))
        .unwrap_or_default()
}
