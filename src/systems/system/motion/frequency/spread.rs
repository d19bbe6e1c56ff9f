//! How strongly a system and the water around it move: covariances of velocities, by the responses to all excitations.

use nalgebra::{Matrix6, Vector6};

use super::excitation::Excitation;
use super::linear_system::Amplitudes;
use super::{Amplitude, Complex};
use crate::numerics::{M3, V3};
use crate::system::motion::body_damping::damped_velocities;
use crate::system::motion::joints::Role;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::system_state::SystemState;

/// What moves how strongly: covariances of the velocity of the water past each place, and deviations of the velocities of the bodies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spread {
    /// Of the nodes of each line \[m²/s²\].
    pub(super) lines: Vec<Vec<M3>>,
    /// Of the joints.
    pub(super) joints: Vec<M3>,
    /// Of the stations of the bodies.
    pub(super) stations: Vec<M3>,
    /// Of the velocities that damping acts on, body by body \[m/s, rad/s\].
    pub(super) bodies: Vec<Vector6<f64>>,
}

/// Square roots of the covariances.
pub(super) struct Roots {
    pub(super) lines: Vec<Vec<M3>>,
    pub(super) joints: Vec<M3>,
    pub(super) stations: Vec<M3>,
}

impl Roots {
    pub(super) fn of_spread(spread: &Spread) -> Self {
        let roots = |list: &[M3]| list.iter().map(root).collect::<Vec<_>>();
        Self {
            lines: spread.lines.iter().map(|line| roots(line)).collect(),
            joints: roots(&spread.joints),
            stations: roots(&spread.stations),
        }
    }
}

/// The symmetric root of a covariance.
fn root(covariance: &M3) -> M3 {
    if *covariance == M3::zeros() {
        return M3::zeros();
    }
    let axes = covariance.symmetric_eigen();
    let along = M3::from_diagonal(&axes.eigenvalues.map(|square| square.max(0.0).sqrt()));
    axes.eigenvectors * along * axes.eigenvectors.transpose()
}

impl Spread {
    /// Of excitations with the responses to them, or of the water alone where there are none yet; each counts so many times.
    pub(super) fn of_excitations<'a>(
        system: &MovingSystem,
        mean: &SystemState,
        all: impl IntoIterator<Item = (&'a Excitation, Option<&'a Amplitudes>)>,
        weight: f64,
    ) -> Self {
        let none = |count: usize| vec![M3::zeros(); count];
        let mut spread = Self {
            lines: mean.lines.iter().map(|line| none(line.x.len())).collect(),
            joints: none(mean.joints.x.len()),
            stations: none(mean.body_flow.len()),
            bodies: vec![Vector6::zeros(); system.network.bodies.len()],
        };
        let still = Amplitudes::default();
        for (excitation, response) in all {
            spread.add(system, mean, (excitation, response.unwrap_or(&still)));
        }
        spread.weigh(weight);
        for sigma in &mut spread.bodies {
            *sigma = sigma.map(f64::sqrt);
        }
        spread
    }

    fn weigh(&mut self, weight: f64) {
        let lines = self.lines.iter_mut().flatten();
        let all = lines.chain(&mut self.joints).chain(&mut self.stations);
        all.for_each(|square| *square *= weight);
        self.bodies.iter_mut().for_each(|square| *square *= weight);
    }

    fn add(
        &mut self,
        system: &MovingSystem,
        mean: &SystemState,
        (excitation, response): (&Excitation, &Amplitudes),
    ) {
        let rate = Complex::new(0.0, excitation.omega);
        let past = |water: &Amplitude, moved: Option<&Amplitude>| {
            water - moved.map_or_else(Amplitude::zeros, |moved| moved * rate)
        };
        for (line, sums) in self.lines.iter_mut().enumerate() {
            let moved = response.lines.get(line);
            for (node, sum) in sums.iter_mut().enumerate() {
                let moved = moved.and_then(|moved| moved.get(node));
                *sum += covariance(&past(&excitation.water.lines[line][node], moved));
            }
        }
        for (joint, sum) in self.joints.iter_mut().enumerate() {
            if matches!(system.joints.roles[joint], Role::Free(_)) {
                *sum += covariance(&past(
                    &excitation.water.joints[joint],
                    response.joints.get(joint),
                ));
            }
        }
        for (number, sum) in self.bodies.iter_mut().enumerate() {
            let (Some(origin), Some(turn)) = (
                response.joints.get(system.joints.bodies[number]),
                response.joints.get(system.joints.rotations[number]),
            ) else {
                continue;
            };
            let pose = system.body(mean, number).pose;
            let (velocity, spin) = (origin * rate, turn * rate);
            let rates = Vector6::from_iterator(velocity.iter().chain(&spin).copied());
            let axes = damped_axes(system, mean, number).map(Complex::from);
            *sum += (axes * rates).map(|rate| 0.5 * rate.norm_sqr());
            let turning = pose
                .rotation
                .to_rotation_matrix()
                .matrix()
                .map(Complex::from)
                * spin;
            for station in system.stations[number].clone() {
                let arm = mean.body_flow[station].place - pose.origin;
                let with_body = velocity + turning.cross(&arm.map(Complex::from));
                self.stations[station] += covariance(&(excitation.stations[station] - with_body));
            }
        }
    }

    /// Goes a share of the way to another spread, by its squares.
    pub(super) fn go_towards(&mut self, other: &Self, share: f64) {
        let go = |own: &mut [M3], other: &[M3]| {
            for (own, other) in own.iter_mut().zip(other) {
                *own += (other - *own) * share;
            }
        };
        for (own, other) in self.lines.iter_mut().zip(&other.lines) {
            go(own, other);
        }
        go(&mut self.joints, &other.joints);
        go(&mut self.stations, &other.stations);
        for (own, other) in self.bodies.iter_mut().zip(&other.bodies) {
            *own = own.zip_map(other, |own, other| {
                (own * own + share * (other * other - own * own)).sqrt()
            });
        }
    }

    /// The greatest change to another spread, by the greatest of its kind \[-\].
    pub(super) fn change(&self, other: &Self) -> f64 {
        let of = |a: &[M3], b: &[M3]| {
            let size = |m: &M3| m.trace().max(0.0).sqrt();
            let greatest = a.iter().map(size).fold(0.0, f64::max);
            let pairs = a.iter().zip(b);
            let change = pairs.map(|(a, b)| (size(a) - size(b)).abs());
            change.fold(0.0, f64::max) / greatest.max(f64::MIN_POSITIVE)
        };
        let lines = self.lines.iter().flatten().copied().collect::<Vec<_>>();
        let others = other.lines.iter().flatten().copied().collect::<Vec<_>>();
        // Of a body the velocities of its origin by the greatest of them, and the turns likewise.
        let bodies = self.bodies.iter().zip(&other.bodies).map(|(a, b)| {
            let of = |from: usize| {
                let (a, b) = (a.fixed_rows::<3>(from), b.fixed_rows::<3>(from));
                (a - b).amax() / a.amax().max(f64::MIN_POSITIVE)
            };
            of(0).max(of(3))
        });
        bodies
            .fold(of(&lines, &others), f64::max)
            .max(of(&self.joints, &other.joints))
            .max(of(&self.stations, &other.stations))
    }
}

/// Covariance of an amplitude over its phase.
fn covariance(amplitude: &Amplitude) -> M3 {
    M3::from_fn(|r, c| 0.5 * (amplitude[r] * amplitude[c].conj()).re)
}

/// From velocity of the origin, and spin along the axes of the body, to the velocities that its damping acts on.
pub(super) fn damped_axes(system: &MovingSystem, mean: &SystemState, body: usize) -> Matrix6<f64> {
    let column = |k: usize| {
        let mut motion = system.body(mean, body);
        (motion.velocity, motion.spin) = match k {
            0..3 => (V3::ith(k, 1.0), V3::zeros()),
            _ => (V3::zeros(), V3::ith(k - 3, 1.0)),
        };
        damped_velocities(&system.network.bodies[body], &motion)
    };
    Matrix6::from_columns(&std::array::from_fn::<_, 6, _>(column))
}
