//! What excites a system at each frequency: components of its waves, harmonics of prescribed motion, bands of slow drift.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector6;

use super::linear_system::{Amplitudes, add_body_load};
use super::perturbed::Phase;
use super::prescribed::Prescribed;
use super::{Amplitude, Complex};
use crate::numerics::V3;
use crate::physics::sea::{Sea, SeaReader, WaterMotion};
use crate::solve::Factors;
use crate::system::motion::border::Border;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::system_state::SystemState;
use crate::system::motion::wave_stations;

/// Amplitude at which loads of waves are read \[m\]: small against the line, large against rounding.
const READ_AT: f64 = 0.01;
/// Greatest displacement at which loads of prescribed motion are read \[m\]: the segments at the ends, whose other nodes stay, must not
/// turn slack.
const MOVED_BY: f64 = 1e-5;
/// Where the bands of slow drift begin and end by the mean frequency of the waves, and how each ends by the one before: as narrow as the
/// peak of a motion with a hundredth of critical damping at the least.
const SLOWEST: f64 = 0.01;
const FASTEST: f64 = 0.6;
const WIDER: f64 = 1.05;

/// An excitation of one frequency. All of them together make the sea; they are independent of each other.
pub(super) struct Excitation {
    /// The angular frequency \[rad/s\].
    pub(super) omega: f64,
    /// The wave at [`READ_AT`], and by what its loads are multiplied.
    wave: Option<(Sea, f64)>,
    /// Loads without drag: of nodes \[N\], and by the rows of the unknowns.
    pub(super) loads: Amplitudes,
    /// Velocity of the water at the nodes and joints \[m/s\]; none where waves are not felt.
    pub(super) water: Amplitudes,
    /// The same at the stations of the bodies.
    pub(super) stations: Vec<Amplitude>,
    /// Displacements of the joints that are prescribed.
    pub(super) given: Vec<Amplitude>,
    /// Elevation at the gauge \[m\].
    pub(super) elevation: Complex,
}

/// Reads all excitations.
pub(super) struct ExcitationReader<'a> {
    system: &'a MovingSystem,
    mean: &'a SystemState,
    border: &'a mut Border,
    state: SystemState,
}

impl<'a> ExcitationReader<'a> {
    /// About a mean position.
    pub(super) fn new(
        system: &'a MovingSystem,
        mean: &'a SystemState,
        border: &'a mut Border,
    ) -> Self {
        Self {
            system,
            mean,
            border,
            state: mean.clone(),
        }
    }

    /// The excitations of a system.
    pub(super) fn all(&mut self) -> Vec<Excitation> {
        let mut all = Vec::new();
        let prescribed = Prescribed {
            system: self.system,
            mean: self.mean,
        };
        let sea = self.system.network.sea.clone();
        let fields = sea.as_ref().map_or(&[][..], Sea::fields);
        let mut number = 0;
        for (place, field) in fields.iter().enumerate() {
            let components = field.at_point(&self.system.network.gauge);
            for (k, component) in components.into_iter().enumerate() {
                number += 1;
                if component.amplitude == 0.0 {
                    continue;
                }
                let wave = field.alone(k, READ_AT).map(|field| {
                    let by = component.amplitude / READ_AT;
                    (Sea::new(vec![field]), by)
                });
                let given = prescribed.by_waves(number - 1);
                let mut excitation = self.read(component.omega, wave, given);
                excitation.elevation = Complex::from_polar(component.amplitude, component.phase);
                self.add_first_order((place, k), &mut excitation.loads);
                all.push(excitation);
            }
        }
        for (omega, given) in prescribed.by_themselves() {
            all.push(self.read(omega, None, given));
        }
        all.extend(self.slow_drift());
        all
    }

    /// Loads and water of an excitation.
    fn read(&mut self, omega: f64, wave: Option<(Sea, f64)>, given: Vec<Amplitude>) -> Excitation {
        let mut excitation = self.empty(omega);
        for_flows(&mut self.state, |flow| *flow = flow.scaled(0.0));
        let still = vec![Amplitude::zeros(); given.len()];
        let moved = given.iter().map(Amplitude::norm).fold(0.0, f64::max);
        for quarter in [false, true] {
            // By exp(i omega t): the real part at time zero, minus the imaginary part a quarter of a period later.
            let (t, unit) = match quarter {
                false => (0.0, Complex::from(1.0)),
                true => (FRAC_PI_2 / omega, -Complex::i()),
            };
            if let Some((sea, scale)) = &wave {
                read_waves(self.system, sea, t, &mut self.state);
                self.take_water(unit * *scale, &mut excitation);
                let loads = &mut excitation.loads;
                self.take_loads((omega, quarter), *scale, &still, loads);
                for_flows(&mut self.state, |flow| *flow = flow.scaled(0.0));
            }
            if moved > 0.0 {
                let loads = &mut excitation.loads;
                self.take_loads((omega, quarter), moved / MOVED_BY, &given, loads);
            }
        }
        excitation.wave = wave;
        excitation.given = given;
        excitation
    }

    fn empty(&self, omega: f64) -> Excitation {
        let lines = self.mean.lines.iter();
        let lines = lines.map(|line| vec![Amplitude::zeros(); line.x.len()]);
        let lines: Vec<_> = lines.collect();
        let joints = self.mean.joints.x.len();
        Excitation {
            omega,
            wave: None,
            loads: Amplitudes {
                lines: lines.clone(),
                joints: vec![Amplitude::zeros(); self.system.joints.envelope.len()],
            },
            water: Amplitudes {
                lines,
                joints: vec![Amplitude::zeros(); joints],
            },
            stations: vec![Amplitude::zeros(); self.mean.body_flow.len()],
            given: vec![Amplitude::zeros(); joints],
            elevation: Complex::default(),
        }
    }

    /// Takes the velocities of the water that were read, and leaves them out of the state: drag has them apart.
    fn take_water(&mut self, unit: Complex, excitation: &mut Excitation) {
        let take = |flows: &mut [WaterMotion], sums: &mut [Amplitude]| {
            for (flow, sum) in flows.iter_mut().zip(sums) {
                *sum += flow.velocity.map(|v| unit * v);
                flow.velocity = V3::zeros();
            }
        };
        let SystemState {
            lines,
            joints,
            body_flow,
            ..
        } = &mut self.state;
        for (line, sums) in lines.iter_mut().zip(&mut excitation.water.lines) {
            take(&mut line.wave_flow, sums);
        }
        take(&mut joints.wave_flow, &mut excitation.water.joints);
        take(body_flow, &mut excitation.stations);
    }

    /// Adds the loads of the waves read and of prescribed motion, by central differences of the residual.
    fn take_loads(
        &mut self,
        (omega, quarter): (f64, bool),
        scale: f64,
        given: &[Amplitude],
        loads: &mut Amplitudes,
    ) {
        const NO_TANGENT: Factors = Factors {
            mass: 0.0,
            damping: 0.0,
            stiffness: 0.0,
        };
        let turn = if quarter {
            Complex::i()
        } else {
            Complex::from(1.0)
        };
        let back = turn.conj();
        for sign in [1.0, -1.0] {
            if sign < 0.0 {
                turn_waves(&mut self.state);
            }
            let phase = Phase {
                omega,
                factor: turn * (sign / scale),
            };
            phase.move_given(self.system, (self.mean, given), &mut self.state);
            let found = self
                .border
                .linearise(self.system, 0.0, &self.state, NO_TANGENT);
            // Loads are minus the residual.
            let by = back * (-0.5 * sign * scale);
            for (sums, parts) in loads.lines.iter_mut().zip(found.residuals) {
                add(sums, parts, by);
            }
            add(&mut loads.joints, found.rows, by);
        }
        let still = Phase {
            omega: 0.0,
            factor: Complex::default(),
        };
        still.move_given(self.system, (self.mean, given), &mut self.state);
    }

    /// Adds the loads of the first order of potential flow.
    fn add_first_order(&self, (field, component): (usize, usize), loads: &mut Amplitudes) {
        for flow in &self.system.flows {
            if let Some(waves) = &flow.waves {
                let load = waves.of_component(field, component);
                add_body_load((self.system, self.mean), flow.body, &load, loads);
            }
        }
    }

    /// Slow drift in bands of frequency, along the axes in which its loads are independent.
    fn slow_drift(&self) -> Vec<Excitation> {
        let Some(mean) = mean_frequency(self.system.network.sea.as_ref()) else {
            return Vec::new();
        };
        let ends: Vec<f64> = std::iter::successors(Some(SLOWEST * mean), |end| Some(end * WIDER))
            .take_while(|end| *end < FASTEST * mean * WIDER)
            .collect();
        let mut all = Vec::new();
        for flow in &self.system.flows {
            let Some(waves) = &flow.waves else { continue };
            for (end, squares) in ends.iter().zip(&waves.slow_drift(&ends)) {
                let axes = squares.symmetric_eigen();
                let greatest = axes.eigenvalues.max();
                for (square, axis) in axes.eigenvalues.iter().zip(axes.eigenvectors.column_iter()) {
                    if *square <= 1e-9 * greatest || greatest <= 0.0 {
                        continue;
                    }
                    let load = axis * square.sqrt();
                    let load = Vector6::new(load[0], load[1], 0.0, 0.0, 0.0, load[2]);
                    let mut excitation = self.empty(end / WIDER.sqrt());
                    let (load, at) = (load.map(Complex::from), (self.system, self.mean));
                    add_body_load(at, flow.body, &load, &mut excitation.loads);
                    all.push(excitation);
                }
            }
        }
        all
    }
}

impl Excitation {
    /// Reads its waves into a state at the phase of a factor, and scales them by its size; nothing where it has none.
    pub(super) fn read_into(
        &self,
        factor: Complex,
        system: &MovingSystem,
        state: &mut SystemState,
    ) {
        let Some((sea, by)) = &self.wave else {
            return;
        };
        // Waves have no past.
        let t = factor.arg().rem_euclid(TAU) / self.omega;
        read_waves(system, sea, t, state);
        let by = by * factor.norm();
        for_flows(state, |flow| *flow = flow.scaled(by));
    }
}

/// Reads the waves of a sea at all nodes, joints and stations.
fn read_waves(system: &MovingSystem, sea: &Sea, t: f64, state: &mut SystemState) {
    for (scene, line) in system.scenes.iter().zip(&mut state.lines) {
        let water = scene.line.water.as_ref();
        let Some(water) = water.filter(|water| water.waves.is_some()) else {
            continue;
        };
        line.wave_flow.resize(line.x.len(), WaterMotion::default());
        for (flow, x) in line.wave_flow.iter_mut().zip(&line.x) {
            *flow = sea.flow(t, x, water.crossed);
        }
    }
    wave_stations::read(system, SeaReader::Once(sea, t), state);
}

fn turn_waves(state: &mut SystemState) {
    for_flows(state, |flow| *flow = flow.scaled(-1.0));
}

fn for_flows(state: &mut SystemState, change: impl Fn(&mut WaterMotion)) {
    let SystemState {
        lines,
        joints,
        body_flow,
        ..
    } = state;
    lines
        .iter_mut()
        .flat_map(|line| &mut line.wave_flow)
        .chain(&mut joints.wave_flow)
        .chain(body_flow)
        .for_each(change);
}

fn add(sums: &mut [Amplitude], parts: &[V3], by: Complex) {
    for (sum, part) in sums.iter_mut().zip(parts) {
        *sum += part.map(|value| by * value);
    }
}

/// The mean frequency of the waves by their energy.
fn mean_frequency(sea: Option<&Sea>) -> Option<f64> {
    let waves = sea?.at_point(&V3::zeros());
    let sum = |power: i32| -> f64 {
        let terms = waves.iter();
        terms
            .map(|wave| wave.amplitude.powi(2) * wave.omega.powi(power))
            .sum()
    };
    let energy = sum(0);
    (energy > 0.0).then(|| sum(1) / energy)
}
