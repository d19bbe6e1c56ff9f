//! One Newton iteration of a system: the bands of the lines, bordered by the joints.
//!
//! Each line that borders on unknowns is condensed onto its end nodes. What is left there goes to the joints as an element: an end on a free
//! point moves with it; an end at the arm r of a free body moves by `du + dt x r`, and its force F has the moment `r x F`.

use std::collections::HashMap;

use super::body_equation::{MovingBody, rotation_jacobian};
use super::joint_place::{Place, add_parts};
use super::joints::Role;
use super::line_ends::LineEnds;
use super::moving_system::MovingSystem;
use super::payout_border::{self, BorderedLines, DrivenPayout, driven};
use super::point_loads::point_load;
use super::system_state::SystemState;
use crate::numerics::{BlockBand, BlockEnvelope, Condensation, CondensedBeside, M3, V3};
use crate::solve::{Factors, NewtonError, Parted, PartedSystem, Residual, State};
use crate::system::network::Held;
use crate::system::pose::cross;

/// Work arrays of the iteration; solving allocates in [`Border::new`] only.
#[derive(Debug, Clone)]
pub struct Border {
    /// Residuals of the lines, and then their displacements.
    lines: Vec<Vec<V3>>,
    tangents: Tangents,
    condensations: Vec<Condensation>,
    bodies: Vec<MovingBody>,
    matrix: BlockEnvelope,
    /// Right-hand side by the rows of the unknowns, and then their displacements.
    rows: Vec<V3>,
    /// The same by joints.
    joints: Vec<V3>,
    /// Residuals of the unknowns themselves, nothing condensed onto them.
    own: Vec<V3>,
    /// Greatest residual of an inner node of the lines \[N\].
    of_lines: f64,
    /// The lengths of lines that are unknowns.
    driven: Vec<DrivenPayout>,
}

/// The bands of the lines. A line that is condensed, or solved, needs its band no longer: lines of one shape share one, which stays in the
/// cache of the processor.
#[derive(Debug, Clone)]
struct Tangents {
    bands: Vec<BlockBand>,
    /// The band of each line.
    of_lines: Vec<usize>,
}

impl Tangents {
    /// For lines of these numbers of nodes; `own`: each has a band of its own.
    fn new(system: &MovingSystem, nodes: impl Iterator<Item = usize>, own: bool) -> Self {
        let mut bands = Vec::new();
        let mut known = HashMap::new();
        let of_lines = system.scenes.iter().zip(nodes).enumerate();
        let of_lines = of_lines.map(|(line, (scene, nodes))| {
            let wide = scene.is_pentadiagonal();
            let shape = (nodes, wide, if own { line } else { 0 });
            *known.entry(shape).or_insert_with(|| {
                let mut band = BlockBand::new(nodes);
                if wide {
                    band.widen();
                }
                bands.push(band);
                bands.len() - 1
            })
        });
        let of_lines = of_lines.collect();
        Self { bands, of_lines }
    }

    fn of_line(&mut self, line: usize) -> &mut BlockBand {
        &mut self.bands[self.of_lines[line]]
    }

    /// Those of all lines, each its own.
    fn of_all(&self) -> &[BlockBand] {
        &self.bands
    }

    fn are_own(&self) -> bool {
        self.bands.len() == self.of_lines.len()
    }
}

/// The equations of motion at a state, none eliminated.
pub(super) struct Linearised<'a> {
    /// The bands of the lines.
    pub(super) tangents: &'a [BlockBand],
    /// Their residuals \[N\].
    pub(super) residuals: &'a [Vec<V3>],
    /// The matrix of the joints, lines apart.
    pub(super) matrix: &'a BlockEnvelope,
    /// Their residuals \[N, N m\].
    pub(super) rows: &'a [V3],
}

/// Accelerations of a state from its positions and velocities, by the forces.
///
/// # Errors
/// Where nothing has mass.
pub fn accelerate(
    border: &mut Border,
    system: &MovingSystem,
    t: f64,
    state: &mut SystemState,
) -> Result<(), NewtonError> {
    const MASS: Factors = Factors {
        mass: 1.0,
        damping: 0.0,
        stiffness: 0.0,
    };
    for (number, part) in state.parts_mut().enumerate() {
        for i in system.free(number) {
            part.a[i] = V3::zeros();
        }
    }
    system.follow(state);
    border.solve(system, t, state, MASS)?;
    for (number, part) in state.parts_mut().enumerate() {
        let d = border.displacements(number);
        for i in system.free(number) {
            part.a[i] -= d[i];
        }
    }
    system.follow(state);
    Ok(())
}

/// The bodies that turn, with the added mass that they have in a state.
pub(super) fn moving_bodies(system: &MovingSystem, state: &SystemState) -> Vec<MovingBody> {
    let turns = |number: &usize| system.network.bodies[*number].turns();
    let bodies = (0..system.network.bodies.len()).filter(turns);
    let moving = |number| {
        let pose = system.body(state, number).pose;
        MovingBody::new(&system.network, number, &pose)
    };
    bodies.map(moving).collect()
}

impl Border {
    /// For a system, whose bodies have the added mass that they have in this state.
    #[must_use]
    pub fn new(system: &MovingSystem, state: &SystemState) -> Self {
        let nodes = || state.lines.iter().map(|line| line.x.len());
        let driven = driven(system, state);
        let unknowns = system.joints.envelope.len();
        Self {
            lines: nodes().map(|n| vec![V3::zeros(); n]).collect(),
            // Lengths that are unknowns are solved for with the bands of all lines.
            tangents: Tangents::new(system, nodes(), !driven.is_empty()),
            condensations: condensations(system, state),
            bodies: moving_bodies(system, state),
            matrix: BlockEnvelope::new(system.joints.envelope.clone()),
            rows: vec![V3::zeros(); unknowns],
            joints: vec![V3::zeros(); state.joints.x.len()],
            own: vec![V3::zeros(); unknowns],
            of_lines: 0.0,
            driven,
        }
    }

    /// Solves for the lengths of lines that are unknowns, and takes what follows from the displacements found without them.
    fn drives(&mut self, system: &MovingSystem, t: f64, state: &SystemState, c: Factors) {
        let work = BorderedLines {
            tangents: self.tangents.of_all(),
            condensations: &mut self.condensations,
            matrix: &self.matrix,
            rows: &mut self.rows,
        };
        let found = (self.lines.as_mut_slice(), self.joints.as_mut_slice());
        payout_border::solve((system, state), (t, c), &mut self.driven, work, found);
    }

    /// The greatest of what the displacement just found misses of winches and points that slide \[m\]: see `DrivenPayout::missed`.
    #[must_use]
    pub fn missed_by_drives(&self, system: &MovingSystem, c: Factors) -> f64 {
        let driven = self.driven.iter();
        driven.map(|one| one.missed(system, c)).fold(0.0, f64::max)
    }

    /// The bodies that turn.
    #[must_use]
    pub fn bodies(&self) -> &[MovingBody] {
        &self.bodies
    }

    /// The greatest residual at the state solved for last: of a node, a point or a body \[N\], moments by the arm of their body.
    #[must_use]
    pub fn residual(&self, system: &MovingSystem) -> f64 {
        let joints = system.joints.free.clone();
        let rows = joints.filter_map(|joint| Some((system.joints.row(joint)?, joint)));
        let sizes = rows.map(|(row, joint)| self.own[row].norm() / system.scale_of_joint(joint));
        sizes.fold(self.of_lines, f64::max)
    }

    /// The displacements, negative, of the nodes of a part: a line, or the joints.
    #[must_use]
    pub fn displacements(&self, part: usize) -> &[V3] {
        self.lines.get(part).unwrap_or(&self.joints)
    }

    /// Solves the linearised equations of motion at a state: the displacements that make its residual vanish, to be subtracted.
    ///
    /// # Errors
    /// [`NewtonError::Singular`], [`NewtonError::NotFinite`] with the number of the node among all.
    pub fn solve(
        &mut self,
        system: &MovingSystem,
        t: f64,
        state: &SystemState,
        c: Factors,
    ) -> Result<(), NewtonError> {
        self.matrix.clear();
        self.rows.fill(V3::zeros());
        self.own.fill(V3::zeros());
        self.of_lines = 0.0;
        for line in 0..self.lines.len() {
            self.line(system, t, state, (line, c))
                .map_err(|node| NewtonError::Singular {
                    node: system.offset(line) + node,
                })?;
        }
        self.points(system, state, c);
        self.free_bodies(system, state, c);
        if let Err(singular) = self.matrix.solve(&mut self.rows) {
            let joint = (0..self.joints.len())
                .find(|joint| system.joints.row(*joint) == Some(singular.node));
            return Err(NewtonError::Singular {
                node: system.offset(self.lines.len()) + joint.unwrap_or_default(),
            });
        }
        back(
            (system, state),
            &self.rows,
            &self.condensations,
            (&mut self.lines, &mut self.joints),
        );
        self.drives(system, t, state, c);
        Ok(())
    }

    /// Linearises the equations of motion at a state, none eliminated: the bands of the lines with their residuals, ends included, and
    /// the matrix of the joints, lines apart, with theirs.
    pub(super) fn linearise(
        &mut self,
        system: &MovingSystem,
        t: f64,
        state: &SystemState,
        c: Factors,
    ) -> Linearised<'_> {
        if !self.tangents.are_own() {
            let nodes = self.lines.iter().map(Vec::len);
            self.tangents = Tangents::new(system, nodes, true);
        }
        self.matrix.clear();
        self.rows.fill(V3::zeros());
        for line in 0..self.lines.len() {
            let (r, tangent) = (&mut self.lines[line], self.tangents.of_line(line));
            system
                .scene(line, state)
                .linearise(t, &state.lines[line], c, r, tangent);
            let own = [r[0], r[r.len() - 1]];
            let ends = LineEnds::of_line(system, state, line);
            let [a, b] = ends.residuals();
            let own = [own[0], own[1], a, b];
            for (k, place) in ends.places() {
                self.turn_arms(place, &own[k], c.stiffness);
            }
            // The residuals of the nodes are left to them; clamps have none.
            ends.add(&[V3::zeros(), V3::zeros(), a, b], &mut self.rows);
        }
        self.points(system, state, c);
        self.free_bodies(system, state, c);
        Linearised {
            tangents: self.tangents.of_all(),
            residuals: &self.lines,
            matrix: &self.matrix,
            rows: &self.rows,
        }
    }

    /// The node that moves most, by its number among all, and by how much \[m\]; rotations by the arm of their body.
    ///
    /// # Errors
    /// [`NewtonError::NotFinite`].
    pub fn greatest(&self, system: &MovingSystem) -> Result<(usize, f64), NewtonError> {
        let mut worst = (0, 0.0);
        let mut offset = 0;
        for number in 0..=self.lines.len() {
            let d = self.displacements(number);
            for i in system.free(number) {
                let moved = d[i].amax() * system.scale(number, i);
                if !moved.is_finite() {
                    return Err(NewtonError::NotFinite { node: offset + i });
                }
                if moved > worst.1 {
                    worst = (offset + i, moved);
                }
            }
            offset += d.len();
        }
        Ok(worst)
    }

    /// A line: its own displacements where its ends are prescribed, else what it leaves on the unknowns.
    fn line(
        &mut self,
        system: &MovingSystem,
        t: f64,
        state: &SystemState,
        (line, c): (usize, Factors),
    ) -> Result<(), usize> {
        let scene = system.scene(line, state);
        let (r, tangent) = (&mut self.lines[line], self.tangents.of_line(line));
        scene.linearise(t, &state.lines[line], c, r, tangent);
        let last = r.len() - 1;
        let sizes = r[1..last].iter().map(V3::norm_squared);
        self.of_lines = self.of_lines.max(sizes.fold(0.0, f64::max).sqrt());
        if system.is_plain(state, line) {
            (r[0], r[last]) = (V3::zeros(), V3::zeros());
            return tangent.solve(1..last, r).map_err(|singular| singular.node);
        }
        let own = [r[0], r[last]];
        let ends = LineEnds::of_line(system, state, line);
        let couplings = ends.couplings(c.stiffness);
        let condensed = self.condensations[line].condense_beside(tangent, r, couplings.as_ref());
        let condensed = condensed.map_err(|singular| singular.node)?;
        self.join(&ends, condensed, &own, c.stiffness);
        Ok(())
    }

    /// Adds the condensed line to the rows of its ends and clamps; `own` are the residuals of the end nodes themselves.
    fn join(
        &mut self,
        ends: &LineEnds,
        CondensedBeside { blocks, mut left }: CondensedBeside,
        own: &[V3; 2],
        stiffness: f64,
    ) {
        let clamps = ends.residuals();
        for (left, residual) in left[2..].iter_mut().zip(&clamps) {
            *left += residual;
        }
        let own = [own[0], own[1], clamps[0], clamps[1]];
        for (i, on) in ends.places() {
            on.add(&left[i], &mut self.rows);
            on.add(&own[i], &mut self.own);
            self.turn_arms(on, &own[i], stiffness);
            for (j, by) in ends.places() {
                self.couple(on, by, &blocks[i][j]);
            }
        }
    }

    /// Adds how the moment of a force changes as its arms turn.
    fn turn_arms(&mut self, on: &Place, force: &V3, stiffness: f64) {
        for arm in on.arms() {
            let turned = cross(force) * arm.arm * stiffness;
            *self.matrix.block(arm.rotation, arm.rotation) +=
                arm.jacobian.transpose() * turned * arm.jacobian;
        }
    }

    /// Adds a block between two places.
    fn couple(&mut self, on: &Place, by: &Place, block: &M3) {
        for (row, lever) in on.parts() {
            for (column, moved) in by.parts() {
                let mut value = *block;
                if let Some(lever) = lever {
                    value = lever.transpose() * value;
                }
                if let Some(moved) = moved {
                    value *= moved;
                }
                *self.matrix.block(*row, *column) += value;
            }
        }
    }

    /// The free points, and ends that are let go.
    fn points(&mut self, system: &MovingSystem, state: &SystemState, c: Factors) {
        for joint in system.joints.free.clone() {
            let Some(row) = system.joints.row(joint) else {
                continue;
            };
            match system.joints.roles[joint] {
                Role::Free(number) => {
                    let Held::Free(point) = &system.network.points[number].held else {
                        continue;
                    };
                    let (x, v, a) = node(&state.joints, joint);
                    let around = system.around(&state.joints, joint);
                    let load = point_load(&system.network, point, (x, v), around);
                    let (residual, tangent) = load.residual(a, c);
                    self.rows[row] += residual;
                    self.own[row] += residual;
                    *self.matrix.block(row, row) += tangent;
                }
                Role::Released(line, end) if state.attached[line][end] != joint => {
                    *self.matrix.block(row, row) += M3::identity();
                }
                // Solved for apart.
                Role::Payout(_) => *self.matrix.block(row, row) += M3::identity(),
                _ => {}
            }
        }
    }

    /// The bodies that turn; what is on the origin of one that is pinned to another goes to that one.
    fn free_bodies(&mut self, system: &MovingSystem, state: &SystemState, c: Factors) {
        for number in 0..self.bodies.len() {
            let body = &self.bodies[number];
            let joints = &system.joints;
            let rotation = joints.rotations[body.number];
            let Some(row) = joints.row(rotation) else {
                continue;
            };
            let motion = system.body(state, body.number);
            let jacobian = rotation_jacobian(&motion.pose.rotation, &state.joints.x[rotation]);
            let around = system.water_around(state, body.number);
            // Without inertia neither turns of momentum count.
            let massless = (c.mass == 0.0).then(|| body.massless());
            let body = massless.as_ref().unwrap_or(body);
            let (residual, tangent) =
                body.residual(&system.network, &motion, &around, &jacobian, c);
            let mut origin = Place::default();
            add_parts(system, state, joints.bodies[body.number], &mut origin);
            // Moments along the axes of the rotation vector: whatever the heading, the pivots are those of a stiffness.
            let mut turn = Place::default();
            turn.push(row, None);
            let along = jacobian.transpose();
            let force = residual.fixed_rows::<3>(0).into_owned();
            let moment = along * residual.fixed_rows::<3>(3);
            for (place, load) in [(&origin, &force), (&turn, &moment)] {
                place.add(load, &mut self.rows);
                place.add(load, &mut self.own);
            }
            self.turn_arms(&origin, &force, c.stiffness);
            for (on, from, along) in [(&origin, 0, M3::identity()), (&turn, 3, along)] {
                for (by, to) in [(&origin, 0), (&turn, 3)] {
                    let block = along * tangent.fixed_view::<3, 3>(from, to);
                    self.couple(on, by, &block);
                }
            }
        }
    }
}

/// Storage for condensing the lines.
fn condensations(system: &MovingSystem, state: &SystemState) -> Vec<Condensation> {
    let lines = state.lines.iter().enumerate();
    let condensations = lines.map(|(number, line)| {
        let plain = Condensation::new(line.x.len());
        match system.has_turning_clamps(number) {
            true => plain.with_sides(),
            false => plain,
        }
    });
    condensations.collect()
}

/// From the unknowns to the displacements of all nodes: of the joints, and of the lines that border on unknowns.
fn back(
    (system, state): (&MovingSystem, &SystemState),
    rows: &[V3],
    condensations: &[Condensation],
    (lines, joints): (&mut [Vec<V3>], &mut [V3]),
) {
    for (joint, out) in joints.iter_mut().enumerate() {
        let row = system.joints.row(joint);
        *out = row.map_or_else(V3::zeros, |row| rows[row]);
    }
    for (line, x) in lines.iter_mut().enumerate() {
        if system.is_plain(state, line) {
            continue;
        }
        LineEnds::of_line(system, state, line).respond(rows, &condensations[line], x, true);
    }
}

/// Position, velocity and acceleration of a joint.
fn node(state: &State, joint: usize) -> (&V3, &V3, &V3) {
    (&state.x[joint], &state.v[joint], &state.a[joint])
}
