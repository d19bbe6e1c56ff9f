//! Drag that is linear by statistics: its tangent, averaged over normally distributed velocities of the water past each place.
//!
//! With w the velocity of the water past a place, normal about its mean u with the covariance S, the linear force that misses the drag F(w)
//! least in the mean square has the matrix `E[dF/dw]` (Price's theorem; Borgman 1969, doi 10.1061/TACEAT.0008647, for one direction). The
//! mean is a quadrature over the sphere of directions of `S^1/2 xi`, xi of unit covariance, exact to the ninth degree (Albrecht and
//! Collatz, ZAMM 38, 1958), and over its length by Gauss's rule, or where there is no current, and drag grows with the speed, by its mean.
//! A few harmonics are no normal process: there velocities count by the share that gives one harmonic its own linear drag, `8/(3 pi)`.
//! The tangent is that of the model itself, at states whose water moves so. Quadratic damping of bodies counts each velocity by itself:
//! its mean magnitude, `sqrt(2/pi) sigma`.

use std::f64::consts::FRAC_2_PI;
use std::sync::LazyLock;

use nalgebra::Vector6;

use super::channel::FEW;
use super::excitation::Excitation;
use super::linear_system::{Amplitudes, FrequencyTangents};
use super::spread::{Roots, Spread, damped_axes};
use super::{Amplitude, Complex};
use crate::numerics::{BlockBand, BlockEnvelope, M3, V3};
use crate::physics::CurrentProfile;
use crate::physics::sea::WaterMotion;
use crate::solve::Factors;
use crate::system::motion::body_equation::rotation_jacobian;
use crate::system::motion::border::Border;
use crate::system::motion::joints::Role;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::system_state::SystemState;

const BY_VELOCITY: Factors = Factors {
    mass: 0.0,
    damping: 1.0,
    stiffness: 0.0,
};

/// Drag of a harmonic by that of normal velocities of the same deviation: `8/(3 pi)` by `sqrt(8/pi)/sqrt(2)`, for drag along one direction.
const HARMONIC: f64 = 0.752_252_778;

/// Step of differences, by the velocities of an excitation.
const STEP: f64 = 1e-3;

/// Mean length of three independent normal numbers, `2 sqrt(2/pi)`.
const MEAN_LENGTH: f64 = 1.595_769_121_605_730_7;
/// Gauss's rule for that length: lengths and weights, from the roots of the seventh Hermite polynomial.
const LENGTHS: [(f64, f64); 3] = [
    (1.154_405_394_739_968_2, 0.640_001_179_777_454_2),
    (2.366_759_410_734_541_5, 0.344_575_142_183_293_05),
    (3.750_439_717_725_742_5, 0.015_423_678_039_252_693),
];

/// Directions of the quadrature with their weights: the corners of an icosahedron and of the dodecahedron over its faces.
static DIRECTIONS: LazyLock<Vec<(V3, f64)>> = LazyLock::new(|| {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let turned = |a: f64, b: f64, c: f64| [V3::new(a, b, c), V3::new(b, c, a), V3::new(c, a, b)];
    let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let mut all = Vec::new();
    for [p, q] in signs {
        all.extend(turned(0.0, p, q * golden).map(|d| (d, 25.0 / 840.0)));
        all.extend(turned(0.0, p * golden, q / golden).map(|d| (d, 27.0 / 840.0)));
        for r in [1.0, -1.0] {
            all.push((V3::new(p, q, r), 27.0 / 840.0));
        }
    }
    all.into_iter().map(|(d, w)| (d.normalize(), w)).collect()
});

/// The drag found.
pub(super) struct LinearDrag {
    /// The whole damping.
    pub(super) damping: FrequencyTangents,
    /// Of it what the water moves: the drag of lines and points.
    lines: Vec<BlockBand>,
    joints: BlockEnvelope,
}

/// Finds it for spreads of velocities.
pub(super) struct DragAverager<'a> {
    system: &'a MovingSystem,
    mean: &'a SystemState,
    border: &'a mut Border,
    /// Damping without drag.
    still: FrequencyTangents,
    has_current: bool,
    /// By what lengths of velocities are multiplied.
    share: f64,
    state: SystemState,
}

impl<'a> DragAverager<'a> {
    pub(super) fn new(
        system: &'a MovingSystem,
        mean: &'a SystemState,
        border: &'a mut Border,
        excitations: usize,
    ) -> Self {
        let mut still = system.clone();
        still.network.current = None;
        for scene in &mut still.scenes {
            scene.line.current = CurrentProfile::Uniform(V3::zeros());
        }
        let nodes = mean
            .lines
            .iter()
            .zip(&system.scenes)
            .flat_map(|(line, scene)| line.x.iter().map(|x| scene.line.current.at(x).0));
        let has_current = nodes.into_iter().any(|velocity| velocity != V3::zeros())
            || system.network.current.is_some();
        let mut state = mean.clone();
        for line in &mut state.lines {
            line.wave_flow.resize(line.x.len(), WaterMotion::default());
        }
        let joints = &mut state.joints;
        joints
            .wave_flow
            .resize(joints.x.len(), WaterMotion::default());
        Self {
            still: FrequencyTangents::at_state(border, &still, mean, BY_VELOCITY),
            system,
            mean,
            border,
            has_current,
            share: if excitations <= FEW { HARMONIC } else { 1.0 },
            state,
        }
    }

    /// The drag for a spread of velocities.
    pub(super) fn average(&mut self, spread: &Spread) -> LinearDrag {
        let roots = Roots::of_spread(spread);
        let one = [(MEAN_LENGTH, 1.0)];
        let lengths = if self.has_current { &LENGTHS[..] } else { &one };
        let mut sum = zero_like(&self.still);
        for (length, share) in lengths {
            for (direction, weight) in DIRECTIONS.iter() {
                self.set((&roots, spread), &(direction * *length * self.share));
                let found = self
                    .border
                    .linearise(self.system, 0.0, &self.state, BY_VELOCITY);
                for (sum, part) in sum.lines.iter_mut().zip(found.tangents) {
                    add_band(sum, part, share * weight);
                }
                sum.joints.add(found.matrix, share * weight);
            }
        }
        let mut drag = sum.clone();
        for (drag, still) in drag.lines.iter_mut().zip(&self.still.lines) {
            add_band(drag, still, -1.0);
        }
        drag.joints.add(&self.still.joints, -1.0);
        LinearDrag {
            damping: sum,
            lines: drag.lines,
            joints: drag.joints,
        }
    }

    /// Moves the water past every place by its own root of the covariance, and the bodies.
    fn set(&mut self, (roots, spread): (&Roots, &Spread), xi: &V3) {
        let state = &mut self.state;
        let set = |flows: &mut [WaterMotion], roots: &[M3], places: &[V3]| {
            for ((flow, root), place) in flows.iter_mut().zip(roots).zip(places) {
                flow.place = *place;
                flow.velocity = root * xi;
            }
        };
        for (line, roots) in state.lines.iter_mut().zip(&roots.lines) {
            set(&mut line.wave_flow, roots, &line.x);
        }
        let joints = &mut state.joints;
        set(&mut joints.wave_flow, &roots.joints, &joints.x);
        // Opposite directions move bodies in opposite ways, so that terms of second order drop out.
        let way = [xi.z, xi.y, xi.x].into_iter().find(|c| c.abs() > 1e-9);
        let way = way.unwrap_or(1.0).signum() * FRAC_2_PI.sqrt();
        for (number, sigma) in spread.bodies.iter().enumerate() {
            self.move_body(number, &(sigma * way * self.share));
        }
        for (number, range) in self.system.stations.iter().enumerate() {
            let motion = self.system.body(&self.state, number);
            let spin = motion.pose.rotation * motion.spin;
            for station in range.clone() {
                let place = self.mean.body_flow[station].place;
                let with_body = motion.velocity + spin.cross(&(place - motion.pose.origin));
                let flow = &mut self.state.body_flow[station];
                flow.place = place;
                flow.velocity = with_body + roots.stations[station] * xi;
            }
        }
    }

    /// Loads of the drag that the water of each excitation makes at the stations of the bodies, in the earth's directions: the mean of
    /// their derivative along its velocities.
    pub(super) fn at_stations(
        &mut self,
        spread: &Spread,
        excitations: &[&Excitation],
    ) -> Vec<Vec<Vector6<Complex>>> {
        let bodies = self.system.network.bodies.len();
        let mut loads = vec![vec![Vector6::zeros(); bodies]; excitations.len()];
        if self.system.stations.iter().all(std::ops::Range::is_empty) {
            return loads;
        }
        let roots = Roots::of_spread(spread);
        let corners = DIRECTIONS.iter().filter(|(_, w)| *w < 26.0 / 840.0);
        let corners: Vec<V3> = corners.map(|(direction, _)| *direction).collect();
        for direction in &corners {
            self.set((&roots, spread), &(direction * MEAN_LENGTH * self.share));
            let flow = self.state.body_flow.clone();
            for (excitation, loads) in excitations.iter().zip(&mut loads) {
                for body in 0..self.border.bodies().len() {
                    let number = self.border.bodies()[body].number;
                    let slope = self.station_slope((body, number), excitation, &flow);
                    loads[number] += slope / Complex::from(corners.len() as f64);
                }
            }
            self.state.body_flow = flow;
        }
        loads
    }

    /// The derivative of the load on a body along the velocities of the water of an excitation.
    fn station_slope(
        &mut self,
        (body, number): (usize, usize),
        excitation: &Excitation,
        flow: &[WaterMotion],
    ) -> Vector6<Complex> {
        let stations = self.system.stations[number].clone();
        let mut slope = Vector6::zeros();
        if stations.is_empty() {
            return slope;
        }
        for (part, unit) in [
            (Complex::from(STEP), Complex::from(1.0)),
            (Complex::new(0.0, STEP), -Complex::i()),
        ] {
            for sign in [1.0, -1.0] {
                for station in stations.clone() {
                    let moved = excitation.stations[station].map(|u| (u * part).re * sign);
                    self.state.body_flow[station].velocity = flow[station].velocity + moved;
                }
                let load = -self.body_residual(body, number);
                slope += load.map(|value| unit * (value * sign / (2.0 * STEP)));
            }
        }
        slope
    }

    /// The residual of a body without inertia, in the earth's directions.
    fn body_residual(&self, body: usize, number: usize) -> Vector6<f64> {
        let rotation = self.system.joints.rotations[number];
        let motion = self.system.body(&self.state, number);
        let jacobian = rotation_jacobian(&motion.pose.rotation, &self.state.joints.x[rotation]);
        let around = self.system.water_around(&self.state, number);
        let none = Factors {
            damping: 0.0,
            ..BY_VELOCITY
        };
        let massless = self.border.bodies()[body].massless();
        let network = &self.system.network;
        massless
            .residual(network, &motion, &around, &jacobian, none)
            .0
    }

    /// Sets the velocities of a body that turns, along the axes of its damping.
    fn move_body(&mut self, number: usize, rates: &Vector6<f64>) {
        if !self.system.network.bodies[number].turns() {
            return;
        }
        let joints = &self.system.joints;
        let axes = damped_axes(self.system, self.mean, number);
        let Some(rates) = axes.try_inverse().map(|axes| axes * rates) else {
            return;
        };
        if joints.row(joints.bodies[number]).is_some() {
            self.state.joints.v[joints.bodies[number]] = rates.fixed_rows::<3>(0).into_owned();
        }
        self.state.joints.v[joints.rotations[number]] = rates.fixed_rows::<3>(3).into_owned();
    }
}

impl LinearDrag {
    /// Adds the drag of the water of an excitation to loads, past nodes that it moves itself.
    pub(super) fn add_loads(
        &self,
        system: &MovingSystem,
        mean: &SystemState,
        excitation: &Excitation,
        loads: &mut Amplitudes,
    ) {
        let rate = Complex::new(0.0, excitation.omega);
        for (line, band) in self.lines.iter().enumerate() {
            let mut water = excitation.water.lines[line].clone();
            let ends = [0, water.len() - 1].into_iter().zip(mean.attached[line]);
            for (node, joint) in ends {
                water[node] -= excitation.given[joint] * rate;
            }
            multiply_add(band, &water, &mut loads.lines[line]);
        }
        for joint in system.joints.free.clone() {
            let Some(row) = system.joints.row(joint) else {
                continue;
            };
            if matches!(system.joints.roles[joint], Role::Free(_)) {
                let block = self.joints.diagonal(row).map(Complex::from);
                loads.joints[row] += block * excitation.water.joints[joint];
            }
        }
    }
}

/// Adds a band times amplitudes.
fn multiply_add(band: &BlockBand, x: &[Amplitude], out: &mut [Amplitude]) {
    let times = |block: &M3, x: &Amplitude| block.map(Complex::from) * x;
    for (i, out) in out.iter_mut().enumerate() {
        *out += times(&band.diag[i], &x[i]);
        if let Some(next) = x.get(i + 1) {
            *out += times(&band.upper[i], next);
        }
        if i > 0 {
            *out += times(&band.lower[i], &x[i - 1]);
        }
    }
}

fn zero_like(tangents: &FrequencyTangents) -> FrequencyTangents {
    let mut zero = tangents.clone();
    for band in &mut zero.lines {
        let copy = band.clone();
        add_band(band, &copy, -1.0);
    }
    zero.joints.clear();
    zero
}

/// Adds a band times a factor.
fn add_band(sum: &mut BlockBand, part: &BlockBand, factor: f64) {
    let add = |sum: &mut [M3], part: &[M3]| {
        for (sum, part) in sum.iter_mut().zip(part) {
            *sum += part * factor;
        }
    };
    add(&mut sum.diag, &part.diag);
    add(&mut sum.upper, &part.upper);
    add(&mut sum.lower, &part.lower);
    add(&mut sum.far_upper, &part.far_upper);
    add(&mut sum.far_lower, &part.far_lower);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_directions_integrate_the_sphere_to_the_ninth_degree() {
        let mean = |f: &dyn Fn(&V3) -> f64| DIRECTIONS.iter().map(|(d, w)| w * f(d)).sum::<f64>();
        assert_eq!(DIRECTIONS.len(), 32);
        assert!((mean(&|_| 1.0) - 1.0).abs() < 1e-14);
        let axis = V3::new(0.3, -0.8, 0.5).normalize();
        for power in 1..=9 {
            let exact = if power % 2 == 1 {
                0.0
            } else {
                1.0 / f64::from(power + 1)
            };
            let found = mean(&|d| d.dot(&axis).powi(power));
            assert!((found - exact).abs() < 1e-14, "{power}: {found}");
        }
        let squares = mean(&|d| d.x.powi(4) * d.y.powi(2) * d.z.powi(2));
        assert!((squares - 3.0 / 945.0).abs() < 1e-14);
    }

    /// The drag of one direction: `sqrt(8/pi) sigma` (Borgman 1969), and in a current the closed form of `2 E|u + w|`.
    #[test]
    fn one_direction_has_the_closed_form() {
        let axis = V3::new(0.6, 0.1, -0.3).normalize();
        for current in [0.0, 0.5, 2.0] {
            let one = [(MEAN_LENGTH, 1.0)];
            let lengths = if current > 0.0 { &LENGTHS[..] } else { &one };
            let mut found = 0.0;
            for (length, share) in lengths {
                for (d, w) in DIRECTIONS.iter() {
                    found += share * w * 2.0 * (current + length * d.dot(&axis)).abs();
                }
            }
            let normal = (-0.5 * current * current).exp() / std::f64::consts::TAU.sqrt();
            let below = 0.5 * statrs::function::erf::erfc(current / std::f64::consts::SQRT_2);
            let exact = 2.0 * (2.0 * normal + current * (1.0 - 2.0 * below));
            assert!(
                (found / exact - 1.0).abs() < 0.03,
                "{current}: {found} {exact}"
            );
        }
    }
}
