//! Drag and added mass of the point bodies on the line.

use crate::numerics::{BlockBand, M3, V3};
use crate::scene::AttachedBody;
use crate::scene::element::{At, Element};
use crate::scene::water::BodyInWater;
use crate::solve::Factors;

/// Drag and added mass of [`AttachedBody`], whose mass and weight belong to their nodes.
pub(super) struct BodyLoads;

/// Adds what the force on a body changes by as the line turns at it, by the nodes before, at and after it.
fn add_turned(at: At<'_>, node: usize, [before, own, after]: [M3; 3], tangent: &mut BlockBand) {
    tangent.diag[node] += own;
    if node > 0 {
        tangent.lower[node] += before;
    }
    if node + 1 < at.line.line_nodes {
        tangent.upper[node] += after;
    }
}

impl Element for BodyLoads {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let BodyInWater { u, a, share, .. } = at.line.body_in_water(number, at.state);
            let added = at.line.body_added_mass(number, at.state);
            r[*node] += (added.force(&a) - body.drag(&u)) * share;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let BodyInWater { u, a, share, .. } = at.line.body_in_water(number, at.state);
            let (_, gradient) = at.line.current.flow(&at.state.x[*node]);
            let added = at.line.body_added_mass(number, at.state);
            r[*node] += (added.force(&a) - body.drag(&u)) * share;
            let by_velocity = body.drag_by_velocity(&u) * share;
            let mut own = by_velocity * c.damping + added.matrix_with(0.0) * share * c.mass;
            own -= by_velocity * gradient * c.stiffness;
            tangent.diag[*node] += own;
            if let Some(turned) = added.by_positions(&a) {
                add_turned(
                    at,
                    *node,
                    turned.map(|by| by * (share * c.stiffness)),
                    tangent,
                );
            }
        }
    }

    fn has_explicit_form(&self) -> bool {
        true
    }

    fn add_energy(&self, at: At<'_>, energy: &mut f64) {
        for (number, AttachedBody { node, .. }) in at.line.bodies.iter().enumerate() {
            let v = &at.state.v[*node];
            let share = at.line.body_in_water(number, at.state).share;
            let added = at.line.body_added_mass(number, at.state);
            *energy += 0.5 * share * v.dot(&added.force(v));
        }
    }

    fn add_dissipation(&self, at: At<'_>, power: &mut f64) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let BodyInWater { u, share, .. } = at.line.body_in_water(number, at.state);
            *power -= body.drag(&u).dot(&at.state.v[*node]) * share;
        }
    }

    fn add_water_drag_power(&self, at: At<'_>, power: &mut f64) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let BodyInWater { u, share, .. } = at.line.body_in_water(number, at.state);
            *power += body.drag(&u).dot(&(u + at.state.v[*node])) * share;
        }
    }

    /// Of the submerged fraction, as the body moves through the surface, and of its direction, as the line turns.
    fn add_growth(&self, at: At<'_>, power: &mut f64) {
        for (number, AttachedBody { node, .. }) in at.line.bodies.iter().enumerate() {
            let BodyInWater {
                share,
                by_place: by,
                ..
            } = at.line.body_in_water(number, at.state);
            let v = &at.state.v[*node];
            let rate = by.dot(v) - by.z * at.line.elevation_rate(*node, at.state);
            let added = at.line.body_added_mass(number, at.state);
            *power += 0.5 * rate * v.dot(&added.force(v));
            *power += share * added.growth(at.line.velocities_beside(*node, at.state));
        }
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        for (number, hung) in at.line.bodies.iter().enumerate() {
            if hung.node == node {
                let BodyInWater {
                    u, a, share, load, ..
                } = at.line.body_in_water(number, at.state);
                let added = at.line.body_added_mass(number, at.state);
                *force += (hung.body.drag(&u) - added.force(&a)) * share + load;
            }
        }
    }
}
