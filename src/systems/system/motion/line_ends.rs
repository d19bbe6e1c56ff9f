//! What a line borders on: the places of its ends, and the directions of its clamps on bodies that turn.
//!
//! The direction d of such a clamp moves like a place of its body at the arm d, but for displacements of the body; its residual is the
//! derivative of the energy of the bend by it: see [`ClampLoad`].

use std::array::from_fn;

use super::super::pose::cross;
use super::body_equation::rotation_jacobian;
use super::joint_place::{Arm, Place, place};
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::numerics::{Condensation, SideCouplings, V3};
use crate::scene::ClampLoad;
use crate::system::clamps::clamp_on;

/// The ends A and B of a line, and the clamps there that turn.
pub(super) struct LineEnds {
    ends: [Place; 2],
    clamps: [Option<TurningClamp>; 2],
}

/// A clamp on a body that turns: how its direction moves, and what it does.
struct TurningClamp {
    place: Place,
    load: ClampLoad,
}

impl LineEnds {
    /// Those of a line in a state.
    pub(super) fn of_line(system: &MovingSystem, state: &SystemState, line: usize) -> Self {
        Self {
            ends: state.attached[line].map(|joint| place(system, state, joint)),
            clamps: from_fn(|end| turning_clamp(system, state, line, end)),
        }
    }

    /// The places of the ends, numbers 0 and 1, and those of the directions of the clamps, 2 and 3.
    pub(super) fn places(&self) -> impl Iterator<Item = (usize, &Place)> {
        let clamps = self.clamps.iter().map(|clamp| Some(&clamp.as_ref()?.place));
        let all = self.ends.iter().map(Some).chain(clamps);
        all.enumerate().filter_map(|(k, place)| Some((k, place?)))
    }

    /// Residuals of the directions of its clamps \[N m\].
    pub(super) fn residuals(&self) -> [V3; 2] {
        let of = |clamp: &Option<TurningClamp>| clamp.as_ref().map(|clamp| clamp.load.residual);
        self.clamps
            .each_ref()
            .map(|clamp| of(clamp).unwrap_or_default())
    }

    /// Whether any of its clamps turns.
    pub(super) fn turn(&self) -> bool {
        self.clamps.iter().any(Option::is_some)
    }

    /// Couplings of its clamps to its nodes, by a share of the stiffness; nothing where none turns.
    pub(super) fn couplings(&self, stiffness: f64) -> Option<SideCouplings> {
        let of = |clamp: &TurningClamp| clamp.load.coupling * stiffness;
        let all = self.clamps.each_ref();
        self.turn().then(|| all.map(|clamp| clamp.as_ref().map(of)))
    }

    /// Adds what is on the ends and clamps to the rows of what they are at.
    pub(super) fn add(&self, left: &[V3; 4], rows: &mut [V3]) {
        for (k, place) in self.places() {
            place.add(&left[k], rows);
        }
    }

    /// The displacements of all nodes by those of the unknowns, `loaded` with the loads condensed last.
    pub(super) fn respond(
        &self,
        rows: &[V3],
        condensation: &Condensation,
        x: &mut [V3],
        loaded: bool,
    ) {
        let mut moved = [V3::zeros(); 4];
        for (k, place) in self.places() {
            moved[k] = place.displacement(rows);
        }
        let last = x.len() - 1;
        (x[0], x[last]) = (moved[0], moved[1]);
        let turned = self.turn().then_some([moved[2], moved[3]]);
        match loaded {
            true => condensation.respond_beside(x, turned.as_ref()),
            false => condensation.respond_beside_unloaded(x, turned.as_ref()),
        }
    }
}

/// The clamp at an end of a line, if it is on a body that turns.
fn turning_clamp(
    system: &MovingSystem,
    state: &SystemState,
    line: usize,
    end: usize,
) -> Option<TurningClamp> {
    let (body, _) = system.clamp_on(line, end)?;
    let rotation = system.joints.rotations[body];
    let row = system.joints.row(rotation)?;
    let load = system
        .scene(line, state)
        .clamp_load(end, &state.lines[line])?;
    let pose = system.body(state, body).pose;
    let mut place = Place::default();
    place.turn(Arm {
        rotation: row,
        arm: cross(&load.direction),
        jacobian: rotation_jacobian(&pose.rotation, &state.joints.x[rotation]),
    });
    Some(TurningClamp { place, load })
}

impl MovingSystem {
    /// The body that an end of a line is clamped on, and the direction of the clamp in its frame.
    pub(super) fn clamp_on(&self, line: usize, end: usize) -> Option<(usize, V3)> {
        clamp_on(&self.network, &self.network.lines[line], end)
    }

    /// The clamps of all lines on bodies that turn, or on those that do not: line, end, body and direction in its frame.
    fn clamps(&self, that_turn: bool) -> impl Iterator<Item = (usize, usize, usize, V3)> {
        let ends = (0..self.scenes.len()).flat_map(|line| [(line, 0), (line, 1)]);
        ends.filter_map(move |(line, end)| {
            let (body, own) = self.clamp_on(line, end)?;
            (self.network.bodies[body].turns() == that_turn).then_some((line, end, body, own))
        })
    }

    /// Turns clamps with the bodies that hold them: those that turn, or those that are held or moved.
    pub(super) fn turn_clamps(&self, state: &mut SystemState, that_turn: bool) {
        for (line, end, body, own) in self.clamps(that_turn) {
            let pose = state.body(&self.joints, body).pose;
            state.lines[line].clamps[end] = Some(pose.arm(&own));
        }
    }

    /// Clamps on bodies that are moved as they are between two states, at a share of the way back from the end.
    pub(super) fn turn_clamps_between(
        &self,
        share: f64,
        (before, end): (&SystemState, &SystemState),
        between: &mut SystemState,
    ) {
        for (line, at, ..) in self.clamps(false) {
            let of = |state: &SystemState| state.lines[line].clamps[at];
            if let (Some(before), Some(end)) = (of(before), of(end)) {
                let mixed = end * (1.0 - share) + before * share;
                between.lines[line].clamps[at] = mixed.try_normalize(0.0).or(Some(end));
            }
        }
    }

    /// Whether an end of a line is clamped on a body that turns.
    pub(super) fn has_turning_clamps(&self, line: usize) -> bool {
        self.clamps(true).any(|(on, ..)| on == line)
    }

    /// The power that bodies which are moved put into the clamps of lines on them \[W\].
    pub(super) fn power_on_clamps(&self, state: &SystemState) -> f64 {
        let mut power = 0.0;
        for (line, end, body, _) in self.clamps(false) {
            let load = self.scene(line, state).clamp_load(end, &state.lines[line]);
            let motion = self.body(state, body);
            let spin = motion.pose.rotation * motion.spin;
            power -= load.map_or(0.0, |load| load.moment().dot(&spin));
        }
        power
    }
}
