//! What a solver may ask of a line.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::numerics::{BlockBand, V3};
use crate::physics::Grip;
use crate::physics::sea::Flow;

/// What a line remembers of the steps accepted so far. It changes in [`System::commit`] and [`System::freeze_drag_coefficients`] only,
/// never while a step is being tried: every trial of a step sees the same past.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Memory {
    /// Normal drag coefficients of both halves of every segment, where a method holds them over a step: see
    /// [`System::freeze_drag_coefficients`]. One entry a segment, or none at all.
    pub held_drag: Vec<[f64; 2]>,
    /// Where a bed with friction has hold of every node. One entry a node, or none at all.
    pub grips: Vec<Grip>,
    /// What ropes with dynamic stiffness remember, see [`System::commit`]. One entry a segment, or none at all: such a
    /// rope is then at rest.
    pub ropes: Vec<RopeHistory>,
    /// Time of the last accepted step \[s\], where ropes remember.
    pub time: f64,
}

/// What a segment of rope remembers of the tensions of accepted steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct RopeHistory {
    /// Their mean \[N\].
    pub mean: f64,
    /// Strain that goes with that mean, loaded slowly \[-\].
    pub strain: f64,
    /// How fast the mean moves \[N/s\].
    pub tension_rate: f64,
    /// How fast its strain moves \[1/s\].
    pub strain_rate: f64,
    /// The last of them \[N\].
    pub tension: f64,
}

impl Memory {
    /// Takes over another line's memory, without allocating where the sizes agree.
    pub fn copy_from(&mut self, other: &Self) {
        self.held_drag.clone_from(&other.held_drag);
        self.grips.clone_from(&other.grips);
        self.ropes.clone_from(&other.ropes);
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
    /// What the line remembers of its past.
    pub memory: Memory,
    /// What waves make of the water at every node, where there are waves and the line is on its way: see
    /// [`System::update_wave_kinematics`]. One entry a node, or none at all.
    #[serde(skip)]
    pub wave_flow: Vec<Flow>,
    /// Tensions of the segments as the iteration before foretold them \[N\], for the stiffness across the line: see
    /// [`System::extrapolate_tensions`]. One entry a segment, or none at all: tensions are then those of the stretch.
    #[serde(rename = "foretold")]
    pub extrapolated_tension: Vec<f64>,
    /// How much longer the segments are than their tensions tell \[m\], where a method takes forces between two states: see
    /// [`System::correct_chord_lengths`]. One entry a segment, or none at all.
    #[serde(default, rename = "excess")]
    pub chord_correction: Vec<f64>,
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
            memory: Memory::default(),
            wave_flow: Vec::new(),
            extrapolated_tension: Vec::new(),
            chord_correction: Vec::new(),
        }
    }

    /// Takes over another state of the same size without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.x.copy_from_slice(&other.x);
        self.v.copy_from_slice(&other.v);
        self.a.copy_from_slice(&other.a);
        self.memory.copy_from(&other.memory);
        self.wave_flow.clone_from(&other.wave_flow);
        self.extrapolated_tension
            .clone_from(&other.extrapolated_tension);
        self.chord_correction.clone_from(&other.chord_correction);
    }

    /// Whether every number is finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let finite = |list: &[V3]| list.iter().all(|p| p.iter().all(|c| c.is_finite()));
        finite(&self.x) && finite(&self.v) && finite(&self.a)
    }
}

/// How much of mass, damping and stiffness enters a tangent: statics, quasi-statics and every
/// implicit time step differ in nothing else.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// Change of acceleration per change of position \[1/s²\].
    pub mass: f64,
    /// Change of velocity per change of position \[1/s\].
    pub damping: f64,
    /// Change of position per change of position \[-\]; 1 but for tests.
    pub stiffness: f64,
}

/// A discretised line, as a solver sees it. The residual is `R = M(x) a - f(t, x, v)` \[N\], a vector
/// a node; none of these functions changes the line or allocates.
pub trait System: Sync {
    /// Number of nodes, both ends counted.
    fn nodes(&self) -> usize;

    /// The nodes that move by their equation of motion; the others are prescribed.
    fn free(&self) -> Range<usize>;

    /// Whether nodes two apart are coupled: the tangent then needs its far blocks.
    fn is_pentadiagonal(&self) -> bool;

    /// Sets position, velocity and acceleration of the prescribed nodes at time t \[s\].
    fn prescribe(&self, t: f64, state: &mut State);

    /// Writes into the state what moves the water at its nodes at time t \[s\], the same for all that is asked of the
    /// line in that state and near it. A method calls it once for every state whose forces it wants, when the positions
    /// are known or foretold; a line at rest, and statics, never. Allocates at the first call only.
    fn update_wave_kinematics(&self, _t: f64, _state: &mut State) {}

    /// The residual of every node.
    fn residual(&self, t: f64, state: &State, r: &mut [V3]);

    /// The residual, and its tangent `mass dR/da + damping dR/dv + stiffness dR/dx`.
    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand);

    /// Accelerations of the free nodes from positions and velocities, `a = M(x)^-1 f(t, x, v)`. Those
    /// of the prescribed nodes are left as they are.
    fn accelerate(&self, t: f64, state: &mut State);

    /// The fastest rate at which drag slows a free node that moves as it does \[1/s\], or more, and the node: what an
    /// explicit step must be short for. None unless a line tells one.
    fn fastest_decay(&self, _state: &State) -> (f64, usize) {
        (0.0, 0)
    }

    /// The acceleration by which parts of the line jolt a node at `end` that do not pull yet at `between` \[m/s²\]: what a
    /// method that balances forces between its steps has not seen. None unless a line tells one.
    fn snap_acceleration(&self, _between: &State, _end: &State) -> f64 {
        0.0
    }

    /// Writes into the state at the end of a step how much longer its segments are than their tensions tell. A method that
    /// balances forces at a mix of two states, `share` of the one before, mixes chords: of a segment that turns the mix is
    /// shorter than both, so that the balance makes both longer, and the tension read at the end of the step too high by
    /// `EA share (1 - share) (omega h)² / 2`. Allocates at the first call only.
    fn correct_chord_lengths(&self, _share: f64, _before: &State, _end: &mut State) {}

    /// Writes what the line is to remember of an accepted state at time t \[s\], `dt` after the one before, into that
    /// state's memory: once at the start with `dt` 0, then after every accepted step. Allocates at the start only.
    fn commit(&self, _t: f64, _dt: f64, _state: &mut State) {}

    /// Writes the normal drag coefficients of both halves of every segment into the state's memory, where they stay as
    /// they are until the next step is accepted. A method that leaves inertia out needs it where the coefficient
    /// jumps: without inertia nothing carries a node across a force that falls while its speed rises.
    fn freeze_drag_coefficients(&self, state: &mut State);

    /// Writes into the state the tensions to begin with, from its stretch or, where that is nothing a line at rest
    /// could have, from the first guess.
    fn initialise_tensions(&self, _state: &mut State) {}

    /// Writes into the state the tensions that displacements `-d` make of it, to first order, before they are made. A
    /// stiff line that turns also stretches, to second order, by a strain that means little and a tension that means a
    /// lot; with foretold tensions in the stiffness across the line, Newton does not see those, and takes
    /// a few iterations to the same answer however stiff the line (the mixed iteration of Magisano, Leonetti and Garcea,
    /// 2017).
    fn extrapolate_tensions(&self, _d: &[V3], _state: &mut State) {}

    /// The displacement \[m\] of a node, along the stiffest part of the line, that would change a force as much as these
    /// displacements do at most, inertia and drag left out: across a line they are felt far less than along it. A line
    /// that does not tell counts every direction alike.
    fn force_norm_displacement(&self, d: &[V3], _state: &State) -> f64 {
        d.iter().map(V3::amax).fold(0.0, f64::max)
    }

    /// A node at which the line is folded back on itself, if there is one. Bending forces vanish at such a fold, so
    /// that forces may balance there, but no line stays so: an equilibrium with a fold is none to be told.
    fn kinked_node(&self, _state: &State) -> Option<usize> {
        None
    }

    /// The same with its clamps turned only a `share` of the way from where the line goes in `start` to where they
    /// are; nothing where nothing is clamped.
    fn with_clamps(&self, _start: &State, _share: f64) -> Option<Box<dyn System + '_>> {
        None
    }

    /// The same on a bed without friction; nothing where there is none anyway.
    fn without_friction(&self) -> Option<Box<dyn System + '_>> {
        None
    }

    /// Has a rough bed hold the line as it lies, with no force yet.
    fn reset_friction(&self, _state: &mut State) {}

    /// A force typical of this line \[N\]: residuals are measured against it.
    fn force_scale(&self) -> f64;

    /// The force that rounding of positions makes of nothing \[N\]: no residual can be asked to be smaller.
    fn rounding_force(&self) -> f64;

    /// The displacement of a node \[m\] below which no force of the line changes by more than
    /// `relative` times [`System::force_scale`]: what "converged on force" means for positions.
    fn position_tolerance(&self, relative: f64) -> f64;
}
