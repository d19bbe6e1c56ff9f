//! A system in motion, as the methods of time integration take it.
//!
//! A rotation vector v from the base of its body changes by `v' = J(v)^-1 w` with the angular velocity w along the axes of the body and
//!
//! ```text
//! J(v)^-1 = I + [v]/2 + (1/a² - (1 + cos a)/(2 a sin a)) [v]²,   a = |v|
//! ```
//!
//! (Müller 2021, doi 10.1007/s00707-021-03036-1), so that the order of a method is that of rotations too.

use std::ops::Range;

use super::border::{Border, accelerate};
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::payout_border::correct_drives;
use super::point_loads::landing_acceleration;
use super::system_state::SystemState;
use crate::dynamics::alpha_scheme::mix;
use crate::numerics::V3;
use crate::solve::{
    Factors, Hysteresis, Integrated, Iterated, Kinematics, Marched, NewtonError, Parted,
    PartedSystem, Residual, State,
};

impl Parted for SystemState {
    /// The lines, then the joints.
    fn parts(&self) -> impl Iterator<Item = &State> {
        self.lines.iter().chain(std::iter::once(&self.joints))
    }

    fn parts_mut(&mut self) -> impl Iterator<Item = &mut State> {
        let joints = std::iter::once(&mut self.joints);
        self.lines.iter_mut().chain(joints)
    }

    fn copy_from(&mut self, other: &Self) {
        for (line, other) in self.lines.iter_mut().zip(&other.lines) {
            line.copy_from(other);
        }
        self.joints.copy_from(&other.joints);
        self.bases.copy_from_slice(&other.bases);
        self.attached.copy_from_slice(&other.attached);
        self.kinks_passed_s = other.kinks_passed_s;
        self.body_flow.clone_from(&other.body_flow);
        self.flow_loads.copy_from_slice(&other.flow_loads);
        self.velocities.clone_from_slice(&other.velocities);
        self.drive_excess.copy_from_slice(&other.drive_excess);
        self.pay_out_as(other);
    }

    /// Histories, bases and what is attached to what.
    fn copy_history_from(&mut self, other: &Self) {
        for (line, other) in self.lines.iter_mut().zip(&other.lines) {
            line.memory.copy_from(&other.memory);
        }
        self.joints.memory.copy_from(&other.joints.memory);
        self.bases.copy_from_slice(&other.bases);
        self.attached.copy_from_slice(&other.attached);
        self.kinks_passed_s = other.kinks_passed_s;
        self.velocities.clone_from_slice(&other.velocities);
    }
}

impl PartedSystem for MovingSystem {
    type State = SystemState;

    fn free(&self, part: usize) -> Range<usize> {
        match self.scenes.get(part) {
            Some(scene) => 1..scene.nodes() - 1,
            None => self.joints.free.clone(),
        }
    }

    fn is_line(&self, part: usize) -> bool {
        part < self.scenes.len()
    }

    fn offset(&self, part: usize) -> usize {
        self.scenes[..part].iter().map(Kinematics::nodes).sum()
    }

    fn scale(&self, part: usize, node: usize) -> f64 {
        match self.is_line(part) {
            true => 1.0,
            false => self.scale_of_joint(node),
        }
    }
}

impl Iterated for MovingSystem {
    type Work = Border;

    fn equations(&self, state: &SystemState) -> Border {
        Border::new(self, state)
    }

    fn displace(
        &self,
        border: &mut Border,
        t: f64,
        state: &SystemState,
        c: Factors,
    ) -> Result<(usize, f64), NewtonError> {
        border.solve(self, t, state, c)?;
        border.greatest(self)
    }

    fn apply(&self, border: &Border, state: &mut SystemState, c: Factors, share: f64) {
        for (number, part) in state.parts_mut().enumerate() {
            let displacements = border.displacements(number);
            for i in self.free(number) {
                let d = displacements[i] * share;
                part.x[i] -= d;
                part.v[i] -= d * c.damping;
                part.a[i] -= d * c.mass;
            }
        }
        self.follow(state);
    }

    fn norm_on_force(&self, border: &Border, state: &SystemState) -> f64 {
        let lines = self.lines(state).enumerate();
        let norms = lines.map(|(number, (scene, line))| {
            scene.force_norm_displacement(border.displacements(number), line)
        });
        norms.fold(0.0, f64::max)
    }

    /// Whether a segment came taut or slack. The rate of convergence, measured where no tension has a kink, predicts nothing there: with it
    /// an iteration stopped with the whole tension of the segment out of balance.
    fn is_misjudged(&self, border: &Border, state: &SystemState, _by_bound: bool) -> bool {
        let joints = border.displacements(self.scenes.len());
        let mut lines = self.lines(state).enumerate();
        lines.any(|(number, (scene, line))| {
            let out = self.paid_out_by(number, joints);
            let d = border.displacements(number);
            scene.line.turns_taut_or_slack(d, out, line)
        })
    }

    fn missed(&self, border: &Border, c: Factors) -> f64 {
        border.missed_by_drives(self, c)
    }
}

impl Marched for MovingSystem {
    fn next_kink(&self, state: &SystemState) -> f64 {
        let of_current = self.next_row_of_current(state.joints.memory.time);
        of_current.min(self.next_kink_of_motions(state))
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut SystemState) {
        self.write_wave_kinematics(t, None, state);
    }

    fn commit(&self, t: f64, dt: f64, state: &mut SystemState) {
        let SystemState { lines, paid, .. } = &mut *state;
        for (number, line) in lines.iter_mut().enumerate() {
            let scene = self.scene_among(number, paid);
            Hysteresis::commit(scene, t, dt, line);
        }
        self.commit_joints(t, state);
    }
}

impl Integrated for MovingSystem {
    fn rate(&self, part: usize, state: &State, node: usize) -> V3 {
        let turns = !self.is_line(part) && matches!(self.joints.roles[node], Role::Rotation(_));
        match turns {
            true => rate_of_rotation(&state.x[node], &state.v[node]),
            false => state.v[node],
        }
    }

    fn prescribe(&self, t: f64, state: &mut SystemState) {
        Self::prescribe(self, t, state);
    }

    fn follow(&self, state: &mut SystemState) {
        Self::follow(self, state);
    }

    /// The rows of the current pass as time does.
    fn pass_kink(&self, t: f64, state: &mut SystemState) -> bool {
        self.pass_kink_of_motions(t, state)
    }

    /// Accelerations of unknowns are of a time of their own; prescribed ones act at that of the balance.
    fn prescribe_between(
        &self,
        fraction: f64,
        before: &SystemState,
        end: &SystemState,
        between: &mut SystemState,
    ) {
        let held = 0..self.joints.free.start;
        mix(
            fraction,
            &end.joints.a[held.clone()],
            &before.joints.a[held.clone()],
            &mut between.joints.a[held],
        );
        // Places mix as those of unknowns do; rotations of bodies that are moved begin anew with every state.
        self.turn_clamps_between(fraction, (before, end), between);
    }

    fn accelerate(
        &self,
        border: &mut Border,
        t: f64,
        state: &mut SystemState,
    ) -> Result<(), NewtonError> {
        accelerate(border, self, t, state)?;
        self.write_creep_rates(t, state);
        Ok(())
    }

    fn fastest_decay(&self, border: &Border, state: &SystemState) -> (f64, usize) {
        self.decay(border.bodies(), state)
    }

    fn extrapolate_wave_kinematics(
        &self,
        t: f64,
        time: f64,
        before: &SystemState,
        state: &mut SystemState,
    ) {
        self.write_wave_kinematics(t, Some((time, before)), state);
    }

    fn correct_after_balance(
        &self,
        fraction: f64,
        before: &SystemState,
        between: &SystemState,
        end: &mut SystemState,
    ) {
        for (number, (scene, state)) in self.lines(before).enumerate() {
            let SystemState { lines, paid, .. } = &mut *end;
            let line = &self.scene_among(number, paid).line;
            line.chord_corrections(fraction, (&scene.line, state), &mut lines[number]);
        }
        correct_drives(self, fraction, (before, between), end);
    }

    /// Also by the bed, which stops a point or body that a step brought onto it unseen.
    fn snap_acceleration(&self, between: &SystemState, end: &SystemState) -> f64 {
        let snaps = (0..self.scenes.len()).map(|line| {
            let at = |state| &self.scene(line, state).line;
            at(end).acceleration_by_snaps((at(between), &between.lines[line]), &end.lines[line])
        });
        let landings = self.bearing().map(|foot| {
            let places = [between, end].map(|state| foot.place(&state.joints.x[foot.joint]));
            landing_acceleration(&self.network, &foot.point, &places[0], &places[1])
        });
        snaps.chain(landings).fold(0.0, f64::max)
    }

    fn passes(&self, before: &SystemState, end: &SystemState) -> f64 {
        self.passes_at_ends(before, end)
    }

    fn freeze_drag_coefficients(&self, state: &mut SystemState) {
        let SystemState { lines, paid, .. } = state;
        for (number, line) in lines.iter_mut().enumerate() {
            Hysteresis::freeze_drag_coefficients(self.scene_among(number, paid), line);
        }
    }
}

/// How fast a rotation vector v \[rad\] changes at an angular velocity w \[rad/s\].
fn rate_of_rotation(v: &V3, w: &V3) -> V3 {
    let square = v.norm_squared();
    let weight = if square < 1e-6 {
        1.0 / 12.0 + square / 720.0
    } else {
        let a = square.sqrt();
        1.0 / square - (1.0 + a.cos()) / (2.0 * a * a.sin())
    };
    let across = v.cross(w);
    w + across * 0.5 + v.cross(&across) * weight
}
