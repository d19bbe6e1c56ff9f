//! Forces on lumped masses, and their masses.

use std::f64::consts::PI;

use super::{Bend, LumpedModel, ModelLine};
use crate::numerics::{M3, V3};
use crate::scene::{LostBuoyancy, lost_buoyancy};

/// Forces \[N\] and masses with added mass \[kg\] of all nodes; kept between evaluations, which then allocate nothing.
#[derive(Debug, Clone)]
pub struct Loads {
    /// Force on each node \[N\].
    pub force: Vec<V3>,
    /// Its mass \[kg\].
    pub mass: Vec<M3>,
}

impl Loads {
    /// Room for the nodes of a model.
    #[must_use]
    pub fn of_model(model: &LumpedModel) -> Self {
        Self {
            force: vec![V3::zeros(); model.start.len()],
            mass: vec![M3::zeros(); model.start.len()],
        }
    }

    /// Acceleration of a node \[m/s²\]; none where it is massless.
    #[must_use]
    pub fn acceleration(&self, node: usize) -> V3 {
        let inverse = self.mass[node].try_inverse();
        inverse.map_or_else(V3::zeros, |inverse| inverse * self.force[node])
    }
}

impl LumpedModel {
    /// Evaluates all forces at places \[m\] and velocities \[m/s\]; drag coefficients count this many times.
    pub fn evaluate(&self, x: &[V3], v: &[V3], drag_scale: f64, loads: &mut Loads) {
        loads.force.fill(V3::zeros());
        loads.mass.fill(M3::zeros());
        for line in &self.lines {
            self.segments(line, x, v, loads);
            self.nodes(line, x, v, drag_scale, loads);
        }
        for bend in &self.bends {
            let forces = bending(bend, x);
            for (node, force) in bend.nodes.into_iter().zip(forces) {
                loads.force[node] += force;
            }
        }
        for point in &self.points {
            let node = point.node;
            let buoyancy = match x[node].z <= 0.0 {
                true => self.density * point.volume,
                false => 0.0,
            };
            let speed = v[node].norm();
            let drag = -v[node] * (0.5 * self.density * point.drag_area * drag_scale * speed);
            loads.force[node] +=
                point.load + drag + V3::z() * (self.gravity * (buoyancy - point.mass));
            loads.mass[node] += M3::identity() * point.moving_mass;
        }
    }

    /// Potential energy \[J\] at places \[m\], whose negative gradient the forces at rest are.
    #[must_use]
    pub fn energy(&self, x: &[V3]) -> f64 {
        let mut energy = 0.0;
        for line in &self.lines {
            let area = 0.25 * PI * line.diameter * line.diameter;
            let last = line.nodes.len() - 1;
            for pair in line.nodes.windows(2) {
                let strain = (x[pair[1]] - x[pair[0]]).norm() / line.segment - 1.0;
                energy += line.elasticity.energy(strain) * line.segment;
                let dry = dry_part(line, [x[pair[0]].z, x[pair[1]].z]);
                energy += self.gravity * self.density * area * line.segment * dry.energy;
            }
            for (i, node) in line.nodes.iter().copied().enumerate() {
                let halves = if i == 0 || i == last { 0.5 } else { 1.0 };
                let length = halves * line.segment;
                let z = x[node].z;
                energy += self.gravity * length * z * line.mass;
                energy -= self.gravity * length * z * self.density * area;
                let depth = self.bed_z.map_or(0.0, |bed| (bed - z).max(0.0));
                energy += 0.5 * self.bed_stiffness * depth * depth * line.diameter * length;
            }
        }
        for bend in &self.bends {
            let [a, b, c] = bend.nodes.map(|node| x[node]);
            let together = (b - a).norm() + (c - b).norm();
            // Its change by the angle phi is EI times the curvature 2 sin(phi / 2) / length.
            let half = (0.25 * together * Self::curvature(bend, x))
                .clamp(0.0, 1.0)
                .asin();
            energy += 4.0 * bend.ei / bend.length * (1.0 - half.cos());
        }
        for point in &self.points {
            let place = x[point.node];
            let buoyancy = self.density * point.volume * place.z.min(0.0);
            energy += self.gravity * (point.mass * place.z - buoyancy) - point.load.dot(&place);
        }
        energy
    }

    /// Tension and internal damping of the segments of a line.
    fn segments(&self, line: &ModelLine, x: &[V3], v: &[V3], loads: &mut Loads) {
        for pair in line.nodes.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let apart = x[b] - x[a];
            let length = apart.norm();
            if length == 0.0 {
                continue;
            }
            let along = apart / length;
            let (tension, _) = line.elasticity.at(length / line.segment - 1.0);
            let rate = (v[b] - v[a]).dot(&along) / line.segment;
            let pull = along * (tension + line.damping * rate);
            loads.force[a] += pull;
            loads.force[b] -= pull;
            let dry = dry_part(line, [x[a].z, x[b].z]);
            let area = 0.25 * PI * line.diameter * line.diameter;
            let displaced = self.gravity * self.density * area * line.segment;
            loads.force[a].z -= displaced * dry.lost[0];
            loads.force[b].z -= displaced * dry.lost[1];
        }
    }

    /// Weight, drag, bed and mass of the nodes of a line.
    fn nodes(&self, line: &ModelLine, x: &[V3], v: &[V3], drag_scale: f64, loads: &mut Loads) {
        let last = line.nodes.len() - 1;
        let area = 0.25 * PI * line.diameter * line.diameter;
        for (i, node) in line.nodes.iter().copied().enumerate() {
            let halves = if i == 0 || i == last { 0.5 } else { 1.0 };
            let length = halves * line.segment;
            let chord = x[line.nodes[(i + 1).min(last)]] - x[line.nodes[i.saturating_sub(1)]];
            let along = chord.try_normalize(0.0).unwrap_or_else(V3::z);
            let water = match x[node].z <= 0.0 {
                true => self.density,
                false => 0.0,
            };
            let mut force = V3::z() * (self.gravity * length * (self.density * area - line.mass));
            let tangential = along * v[node].dot(&along);
            let normal = v[node] - tangential;
            let half = 0.5 * water * line.diameter * length * drag_scale;
            force -= normal * (half * line.drag[0] * normal.norm())
                + tangential * (half * PI * line.drag[1] * tangential.norm());
            if let Some(depth) = self.bed_z.map(|z| z - x[node].z).filter(|d| *d > 0.0) {
                force.z += (depth * self.bed_stiffness - v[node].z * self.bed_damping)
                    * line.diameter
                    * length;
            }
            loads.force[node] += force;
            let displaced = water * area * length;
            let outer = along * along.transpose();
            loads.mass[node] += M3::identity()
                * (line.mass * length + displaced * line.added_mass[0])
                + outer * (displaced * (line.added_mass[1] - line.added_mass[0]));
        }
    }
}

/// The dry part of a segment between nodes at these heights \[m\]. `MoorDyn` lumps the buoyancy of the wet part half at each node (`Line::calcSubSeg`);
/// here it is where it acts, so that it has an energy.
pub(super) fn dry_part(line: &ModelLine, heights: [f64; 2]) -> LostBuoyancy {
    lost_buoyancy(0.5 * line.diameter, heights)
}

/// Forces of bending on the three nodes of a bend \[N\].
#[must_use]
pub fn bending(bend: &Bend, x: &[V3]) -> [V3; 3] {
    let [a, b, c] = bend.nodes.map(|node| x[node]);
    let [before, behind] = [b - a, c - b];
    let lengths = [before.norm(), behind.norm()];
    let (Some(q), Some(p)) = (before.try_normalize(0.0), behind.try_normalize(0.0)) else {
        return [V3::zeros(); 3];
    };
    let Some(axis) = q.cross(&p).try_normalize(1e-14) else {
        return [V3::zeros(); 3];
    };
    let moment = bend.ei * LumpedModel::curvature(bend, x);
    let on_first = q.cross(&axis) * (moment / lengths[0]);
    let on_last = p.cross(&axis) * (moment / lengths[1]);
    [on_first, -on_first - on_last, on_last]
}
