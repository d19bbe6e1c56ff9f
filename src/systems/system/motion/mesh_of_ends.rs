//! The mesh at ends that are paid out: only their segment grows or shrinks; where it is too long it is parted, where too short joined
//! with the next: see [`super::new_node`] and [`super::surplus`].

use super::moving_system::{MovingSystem, put_into_water};
use super::new_node::NewNode;
use super::paid_line::PaidLine;
use super::system_state::SystemState;
use crate::case::OnSection;
use crate::dynamics::MethodState;
use crate::numerics::V3;
use crate::scene::{self, PaidOut, Scene};
use crate::solve::State;

/// Lengths of the end segment by those of the mesh, beyond which it is parted or joined with the next; apart far enough for a line that
/// runs to and fro.
const LONGEST: f64 = 1.6;
pub(super) const SHORTEST: f64 = 0.4;
/// The length below which nothing is left to haul in.
const NOTHING: f64 = 0.05;
/// Share of its length by which an end segment may change in a step.
const CHANGE: f64 = 0.3;

/// What the mesh of an end needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Remesh {
    /// Its segment is too long.
    Part,
    /// It is too short.
    Join,
    /// Nothing is left of its section, or of the line.
    Stop,
}

/// An end of a line that is paid out, by the number among those lines, and what its mesh needs.
pub(super) type EndMesh = (usize, usize, Remesh);

impl MovingSystem {
    /// The line with so many segments more at ends A and B than it has at rest, to be paid out from there.
    ///
    /// # Errors
    /// Why it cannot be built.
    pub fn meshed(&self, paid: &PaidLine, added: [i64; 2]) -> Result<Scene, String> {
        let mut case = paid.case.clone();
        // A line of one section may pass as a whole from one end to the other.
        let [a, b] = added;
        let added = if case.line.len() == 1 {
            [a + b, 0]
        } else {
            [a, b]
        };
        for (end, added) in added.into_iter().enumerate() {
            let last = end * (case.line.len() - 1);
            let section = &mut case.line[last];
            let segments = section.segments.saturating_add_signed(added as isize);
            section.length_m *= segments as f64 / section.segments as f64;
            section.segments = segments;
            // What hangs on the section hangs at its end towards B.
            let hung = case.clumps.iter_mut();
            for clump in hung.filter(|clump| clump.is_on(Some(&section.name))) {
                clump.at_m = section.length_m;
            }
        }
        let mut scene = scene::build(&case, 1).map_err(|why| why.to_string())?;
        scene
            .line
            .ends
            .clone_from(&self.scenes[paid.line].line.ends);
        let line = &self.network.lines[paid.line];
        put_into_water(&self.network, self.water.as_ref(), line, &mut scene);
        for end in (0..2).filter(|end| !self.scenes[paid.line].is_clamped(*end)) {
            scene.unclamp(end);
        }
        for end in (0..2).filter(|end| paid.ends[*end].is_some()) {
            scene.feed(end);
        }
        Ok(scene)
    }

    /// What is paid out at an end of a line in this state.
    #[must_use]
    pub fn paid_out(&self, number: usize, end: usize, state: &SystemState) -> PaidOut {
        let paid = &self.paid[number];
        let Some((payout, sign)) = paid.ends[end] else {
            return PaidOut::default();
        };
        let joint = self.payouts[payout].joint;
        let mesh = self.mesh_length(number, end);
        let joints = &state.joints;
        let added = state.added[number][end] as f64;
        let out = [&joints.x, &joints.v, &joints.a].map(|list| sign * list[joint].x);
        let surplus = self.surplus((number, end), state);
        let length = mesh * (1.0 - added) + out[0] + surplus[0];
        PaidOut {
            // A trial of an iteration may leave nothing.
            length: length.max(0.5 * NOTHING * mesh),
            rate: out[1] + surplus[1],
            acceleration: out[2] + surplus[2],
        }
    }

    /// What displacements of the joints pay out at the ends of a line \[m\].
    pub(super) fn paid_out_by(&self, line: usize, joints: &[V3]) -> [f64; 2] {
        let paid = self.paid.iter().find(|paid| paid.line == line);
        let ends = paid.map_or([None; 2], |paid| paid.ends);
        ends.map(|end| {
            end.map_or(0.0, |(payout, sign)| {
                sign * joints[self.payouts[payout].joint].x
            })
        })
    }

    /// Length of the segments of the mesh at an end \[m\].
    pub(super) fn mesh_length(&self, number: usize, end: usize) -> f64 {
        let sections = &self.paid[number].case.line;
        let section = &sections[end * (sections.len() - 1)];
        section.length_m / section.segments as f64
    }

    /// Sets the end segments of all lines that are paid out.
    pub fn pay_out(&self, state: &mut SystemState) {
        for (number, paid) in self.paid.iter().enumerate() {
            for end in (0..2).filter(|end| paid.ends[*end].is_some()) {
                let now = self.paid_out(number, end, state);
                state.paid[number].pay_out(end, now);
            }
        }
    }

    /// The ends that are paid out, by the number of their line among those.
    pub(super) fn paid_ends(&self) -> impl Iterator<Item = (usize, usize)> {
        let ends = (0..self.paid.len()).flat_map(|number| [(number, 0), (number, 1)]);
        ends.filter(|(number, end)| self.paid[*number].ends[*end].is_some())
    }

    /// By how much the end segments change between two states, by what a step may: cubed, as errors of steps grow.
    #[must_use]
    pub(super) fn passes_at_ends(&self, from: &SystemState, to: &SystemState) -> f64 {
        let shares = self.paid_ends().map(|(number, end)| {
            let length = |state: &SystemState| self.paid_out(number, end, state).length;
            let (before, after) = (length(from), length(to));
            (after - before).abs() / (CHANGE * before.min(after))
        });
        shares.fold(0.0, f64::max).powi(3)
    }

    /// The first end whose segment is too long or too short.
    #[must_use]
    pub(super) fn end_mesh(&self, state: &SystemState) -> Option<EndMesh> {
        self.paid_ends().find_map(|(number, end)| {
            let share = self.paid_out(number, end, state).length / self.mesh_length(number, end);
            let need = match share {
                _ if share > LONGEST => Remesh::Part,
                _ if share < SHORTEST && self.can_join(number, end, state) => Remesh::Join,
                _ if share < NOTHING => Remesh::Stop,
                _ => return None,
            };
            Some((number, end, need))
        })
    }

    /// Whether the section at an end has another segment besides that of the end.
    fn can_join(&self, number: usize, end: usize, state: &SystemState) -> bool {
        let sections = &self.paid[number].case.line;
        let one = sections.len() == 1;
        let section = &sections[end * (sections.len() - 1)];
        let [a, b] = state.added[number];
        let added = if one { a + b } else { [a, b][end] };
        section.segments.saturating_add_signed(added as isize) > if one { 2 } else { 1 }
    }

    /// Parts or joins the segment of an end, in the system, the state and what the method keeps; returns the node that comes or goes, and
    /// whether it comes.
    ///
    /// # Errors
    /// Why the line cannot be built.
    pub(super) fn remesh(
        &mut self,
        (number, end, need): EndMesh,
        t: f64,
        state: &mut SystemState,
        method: &mut MethodState,
    ) -> Result<(usize, bool), String> {
        let line = self.paid[number].line;
        let nodes = state.lines[line].x.len();
        let parts = need == Remesh::Part;
        let placed = parts.then(|| self.new_node(number, end, t, state));
        let (mesh, length) = (
            self.mesh_length(number, end),
            self.paid_out(number, end, state).length,
        );
        let before = end_path(&state.lines[line].x, end, if parts { 1 } else { 2 });
        let stretch = before / if parts { length } else { length + mesh };
        let far = mesh / length;
        state.added[number][end] += if parts { 1 } else { -1 };
        let scene = self.meshed(&self.paid[number], state.added[number])?;
        // The node that comes or goes, and the segment at the end.
        let node = if end == 0 {
            1
        } else {
            nodes - 1 - usize::from(!parts)
        };
        let segment = end * (nodes - 2);
        let own = &mut state.lines[line];
        put_node(own, node, placed.as_ref());
        let share = if parts { [1.0 - far, far] } else { [1.0; 2] };
        change_corrections(&mut own.chord_correction, end, (segment, share), parts);
        change_history(own, &scene, (node, segment), parts);
        if let Some(jerk) = method.jerk.get_mut(line) {
            if parts {
                let beside = if end == 0 { jerk[1] } else { jerk[nodes - 2] };
                jerk.insert(node, beside);
            } else {
                jerk.remove(node);
            }
        }
        state.paid[number] = scene.clone();
        self.scenes[line] = scene;
        let after = end_path(&state.lines[line].x, end, if parts { 2 } else { 1 });
        if stretch > 1.0 {
            self.add_surplus((number, end), (after - before) / stretch, state);
        }
        self.follow(state);
        Ok((node, parts))
    }

    /// Meshes the lines as a stored state has them.
    ///
    /// # Errors
    /// Why a line cannot be built.
    pub fn mesh_as(&mut self, stored: &[[i64; 2]], state: &mut SystemState) -> Result<(), String> {
        for (number, added) in stored.iter().enumerate().take(self.paid.len()) {
            let scene = self.meshed(&self.paid[number], *added)?;
            state.paid[number] = scene.clone();
            let line = self.paid[number].line;
            self.scenes[line] = scene;
        }
        Ok(())
    }
}

/// Length of the chords of so many segments at an end \[m\].
fn end_path(x: &[V3], end: usize, segments: usize) -> f64 {
    let nodes = [&x[..=segments], &x[x.len() - 1 - segments..]][end];
    let chords = nodes.windows(2).map(|pair| (pair[1] - pair[0]).norm());
    chords.sum()
}

/// Puts a new node into a line, or takes one out.
fn put_node(own: &mut State, at: usize, new: Option<&NewNode>) {
    let State { x, v, a, .. } = own;
    match new {
        Some(new) => {
            x.insert(at, new.place);
            v.insert(at, new.velocity);
            a.insert(at, new.acceleration);
        }
        None => {
            for list in [x, v, a] {
                list.remove(at);
            }
        }
    }
}

/// Divides the excess of the chord of the end segment by these shares of its length, at the end and beyond; or adds up those of two that
/// are joined.
fn change_corrections(
    list: &mut Vec<f64>,
    end: usize,
    (segment, share): (usize, [f64; 2]),
    parts: bool,
) {
    if list.is_empty() {
        return;
    }
    if parts {
        list.insert(segment, list[segment]);
        let [near, beyond] = [[segment, segment + 1], [segment + 1, segment]][end];
        list[near] *= share[0];
        list[beyond] *= share[1];
    } else {
        let joined = list.remove(segment);
        list[[segment, segment.wrapping_sub(1)][end]] += joined;
    }
}

/// Gives a new node and segment the history of the end segment, or takes that of those that go.
fn change_history(own: &mut State, scene: &Scene, (node, segment): (usize, usize), parts: bool) {
    fn change<T: Copy>(list: &mut Vec<T>, at: usize, new: Option<T>) {
        match new {
            _ if list.is_empty() => {}
            Some(new) => list.insert(at, new),
            None => {
                list.remove(at);
            }
        }
    }
    let of = |list: &[f64]| parts.then(|| list.get(segment).copied().unwrap_or_default());
    let extrapolated = of(&own.extrapolated_tension);
    change(&mut own.extrapolated_tension, segment, extrapolated);
    let memory = &mut own.memory;
    let drag = parts.then(|| {
        memory
            .drag_coefficients
            .get(segment)
            .copied()
            .unwrap_or_default()
    });
    change(&mut memory.drag_coefficients, segment, drag);
    let rope = parts.then(|| memory.ropes.get(segment).copied().unwrap_or_default());
    change(&mut memory.ropes, segment, rope);
    let shared = parts.then(|| {
        let list = &memory.shared_stiffness;
        list.get(segment).copied().unwrap_or_default()
    });
    change(&mut memory.shared_stiffness, segment, shared);
    let creep = parts.then(|| memory.creep.get(segment).copied().unwrap_or_default());
    change(&mut memory.creep, segment, creep);
    if !memory.grips.is_empty() {
        let grip = parts.then(|| scene.grips_at(&own.x)[node]);
        change(&mut memory.grips, node, grip);
    }
    if let Some(flow) = own.wave_flow.get(node).copied() {
        change(&mut own.wave_flow, node, parts.then_some(flow));
    }
}
