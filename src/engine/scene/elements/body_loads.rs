//! Drag and added mass of the point bodies on the line.

use crate::numerics::{BlockBand, M3, V3};
use crate::scene::AttachedBody;
use crate::scene::element::{At, Element};
use crate::scene::water::BodyInWater;
use crate::solve::Factors;

/// Drag and added mass of [`AttachedBody`], whose mass and weight belong to their nodes.
pub(super) struct BodyLoads;

impl Element for BodyLoads {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let BodyInWater { u, a, share, .. } = at.line.body_in_water(number, at.state);
            r[*node] += (body.added.component_mul(&a) - body.drag(&u)) * share;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let BodyInWater { u, a, share, .. } = at.line.body_in_water(number, at.state);
            let (_, gradient) = at.line.current.flow(&at.state.x[*node]);
            r[*node] += (body.added.component_mul(&a) - body.drag(&u)) * share;
            let by_velocity = body.drag_by_velocity(&u) * share;
            let added = body.added * share;
            let mut own = by_velocity * c.damping + M3::from_diagonal(&(added * c.mass));
            own -= by_velocity * gradient * c.stiffness;
            tangent.diag[*node] += own;
        }
    }

    fn has_explicit_form(&self) -> bool {
        true
    }

    fn add_energy(&self, at: At<'_>, energy: &mut f64) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let v = &at.state.v[*node];
            let share = at.line.body_in_water(number, at.state).share;
            *energy += 0.5 * share * v.dot(&body.added.component_mul(v));
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

    /// Of the submerged fraction, as the body moves through the surface.
    fn add_growth(&self, at: At<'_>, power: &mut f64) {
        for (number, AttachedBody { node, body }) in at.line.bodies.iter().enumerate() {
            let by = at.line.body_in_water(number, at.state).by_place;
            let v = &at.state.v[*node];
            let rate = by.dot(v) - by.z * at.line.elevation_rate(*node, at.state);
            *power += 0.5 * rate * v.dot(&body.added.component_mul(v));
        }
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        for (number, hung) in at.line.bodies.iter().enumerate() {
            if hung.node == node {
                let BodyInWater {
                    u, a, share, load, ..
                } = at.line.body_in_water(number, at.state);
                *force += (hung.body.drag(&u) - hung.body.added.component_mul(&a)) * share + load;
            }
        }
    }
}
