//! Positions, velocities and accelerations of the nodes, and the history on which forces depend.

use serde::{Deserialize, Serialize};

use crate::numerics::V3;
use crate::physics::FrictionAnchor;
use crate::physics::rope::creep::CreepState;
use crate::physics::sea::{KeptWaves, WaterMotion};

/// History variables of the accepted steps. They change in [`Hysteresis`](super::Hysteresis) only, never while a step is
/// tried: all trials of a step start from the same history.
///
/// What is written as tables comes last here and in [`State`]: values behind a table are inserted into the text before it, which of many
/// lines takes the square of their number.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct HistoryVariables {
    /// Normal drag coefficients of both halves of every segment, where a method freezes them over a step
    /// ([`freeze_drag_coefficients`](super::Hysteresis::freeze_drag_coefficients)). One entry a segment, or empty.
    #[serde(rename = "held_drag")]
    pub drag_coefficients: Vec<[f64; 2]>,
    /// Piece of the prescribed motion of end A and of end B: how many kinks of it are passed.
    #[serde(skip_serializing_if = "is_first")]
    pub motion_pieces: [usize; 2],
    /// How many kinks of the motion of a traveller are passed.
    #[serde(skip_serializing_if = "is_zero")]
    pub traveller_kinks: usize,
    /// Time of the last accepted step \[s\], where ropes have a history.
    pub time: f64,
    /// Friction springs of the bed. One entry a node, or empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub grips: Vec<FrictionAnchor>,
    /// Tension history of ropes with dynamic stiffness. One entry a segment, or empty: the rope is then static.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ropes: Vec<RopeHistory>,
    /// What the one stiffness of a rope whose segments share it depends on. One entry a segment, or empty: no segment shares.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shared_stiffness: Vec<SharedStiffness>,
    /// Slow parts of ropes that creep. One entry a segment, or empty: the rope is then at rest.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub creep: Vec<CreepState>,
    /// Contact of bodies with the bed. One entry a body that may bear on it, or empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<BodyOnBed>,
}

/// Whether no kink is passed.
fn is_first(pieces: &[usize; 2]) -> bool {
    *pieces == [0, 0]
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// Contact of a body with the bed over the accepted steps.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BodyOnBed {
    /// Its friction spring.
    pub grip: FrictionAnchor,
    /// Whether suction holds it: it has borne on the bed, and has not been pulled off since.
    pub stuck: bool,
    /// Height of its bottom above the bed \[m\], and its rates \[m/s\], \[m/s²\].
    pub height: [f64; 3],
    /// The greatest speed normal to the bed at which it has landed \[m/s\]; 0 while it has not.
    pub landing_speed: f64,
}

impl BodyOnBed {
    /// Takes in the height of its bottom with its rates after an accepted step. Where it has landed since the last one, it did so at the speed
    /// that it had there by its acceleration above the bed.
    pub fn update(&mut self, height: [f64; 3]) {
        let [above, speed, acceleration] = self.height;
        if height[0] < 0.0 && above > 0.0 {
            let landing = (speed * speed - 2.0 * acceleration * above).max(0.0).sqrt();
            self.landing_speed = self.landing_speed.max(landing);
        }
        self.height = height;
    }
}

/// Tension history of a segment of rope over the accepted steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct RopeHistory {
    /// Mean tension \[N\].
    pub mean: f64,
    /// Strain at that mean under slow loading \[-\].
    pub strain: f64,
    /// Rate of the mean tension \[N/s\].
    pub tension_rate: f64,
    /// Rate of the strain at the mean \[1/s\].
    pub strain_rate: f64,
    /// Last tension \[N\].
    pub tension: f64,
}

/// What the one stiffness of a rope depends on, as of the last accepted step; each of its segments has a copy.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SharedStiffness {
    /// Whether the segment is of such a rope.
    pub shared: bool,
    /// Mean tension, averaged along the rope \[N\].
    pub mean: f64,
    /// Its rate \[N/s\].
    pub mean_rate: f64,
    /// Strain from where the branch of the mean begins, averaged along the rope \[-\].
    pub strain: f64,
    /// Its rate \[1/s\].
    pub strain_rate: f64,
}

impl HistoryVariables {
    /// Copies another memory; allocates only where sizes differ.
    pub fn copy_from(&mut self, other: &Self) {
        self.drag_coefficients.clone_from(&other.drag_coefficients);
        self.grips.clone_from(&other.grips);
        self.ropes.clone_from(&other.ropes);
        self.shared_stiffness.clone_from(&other.shared_stiffness);
        self.creep.clone_from(&other.creep);
        self.bodies.clone_from(&other.bodies);
        self.motion_pieces = other.motion_pieces;
        self.traveller_kinks = other.traveller_kinks;
        self.time = other.time;
    }
}

/// Position \[m\], velocity \[m/s\] and acceleration \[m/s²\] of every node, from end A to end B.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Positions.
    pub x: Vec<V3>,
    /// Velocities.
    pub v: Vec<V3>,
    /// Accelerations.
    pub a: Vec<V3>,
    /// Wave kinematics at every node, written by
    /// [`update_wave_kinematics`](super::Kinematics::update_wave_kinematics). One entry a node, or empty.
    #[serde(skip)]
    pub wave_flow: Vec<WaterMotion>,
    /// What is kept to write them again.
    #[serde(skip)]
    pub kept_waves: KeptWaves,
    /// Tensions of the segments \[N\] extrapolated from the iteration before, for the geometric stiffness
    /// ([`extrapolate_tensions`](super::Residual::extrapolate_tensions)). One entry a segment, or empty: tensions then
    /// follow from strain.
    #[serde(rename = "foretold")]
    pub extrapolated_tension: Vec<f64>,
    /// Excess of the chord lengths over those that belong to the tensions \[m\]
    /// ([`correct_chord_lengths`](super::MidstepBalance::correct_chord_lengths)). One entry a segment, or empty.
    #[serde(default, rename = "excess")]
    pub chord_correction: Vec<f64>,
    /// Rates of the mean strains of ropes that creep \[1/s\], where a method integrates these with the positions. One entry a segment, or
    /// empty: mean strains are then solved for with the tensions.
    #[serde(skip)]
    pub creep_rates: Vec<f64>,
    /// Directions of the line at clamped ends A and B whose clamps turn with a body, from A to B; nothing where the line has its own.
    #[serde(skip)]
    pub clamps: [Option<V3>; 2],
    /// History variables.
    pub memory: HistoryVariables,
}

impl State {
    /// At rest at the given positions.
    #[must_use]
    pub fn at_rest(x: Vec<V3>) -> Self {
        let n = x.len();
        Self {
            x,
            v: vec![V3::zeros(); n],
            a: vec![V3::zeros(); n],
            memory: HistoryVariables::default(),
            wave_flow: Vec::new(),
            kept_waves: KeptWaves::default(),
            extrapolated_tension: Vec::new(),
            chord_correction: Vec::new(),
            creep_rates: Vec::new(),
            clamps: [None; 2],
        }
    }

    /// Copies another state of the same size without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.x.copy_from_slice(&other.x);
        self.v.copy_from_slice(&other.v);
        self.a.copy_from_slice(&other.a);
        self.memory.copy_from(&other.memory);
        self.wave_flow.clone_from(&other.wave_flow);
        self.extrapolated_tension
            .clone_from(&other.extrapolated_tension);
        self.chord_correction.clone_from(&other.chord_correction);
        self.creep_rates.clone_from(&other.creep_rates);
        self.clamps = other.clamps;
    }

    /// Prepares for a method that integrates the mean strains of ropes that creep. Allocates at the first call only.
    pub fn integrate_creep(&mut self) {
        self.creep_rates.resize(self.memory.creep.len(), 0.0);
    }

    /// Adds the rates of the mean strains in a stage, times a weight \[s\].
    pub fn add_creep(&mut self, stage: &Self, weight: f64) {
        for (own, rate) in self.memory.creep.iter_mut().zip(&stage.creep_rates) {
            own.mean += rate * weight;
        }
    }

    /// Sets the mean strains to those at the start of a step and their own rates times h \[s\].
    pub fn move_creep(&mut self, start: &Self, h: f64) {
        let rates = self.creep_rates.iter();
        let starts = start.memory.creep.iter().zip(rates);
        for (own, (start, rate)) in self.memory.creep.iter_mut().zip(starts) {
            own.mean = start.mean + rate * h;
        }
    }
}
