//! The derivative of the force on an end that is held on the bed.

use super::bed::BedContact;
use crate::numerics::lanes::outer;
use crate::numerics::{BlockBand, M3, V3};
use crate::scene::element::At;
use crate::solve::State;

/// Derivatives of a force on an end.
struct EndForceSlopes {
    /// By the force without the bed.
    by_load: M3,
    /// By the force of the bed on the neighbouring node.
    by_beside: M3,
}

impl BedContact {
    /// Where the first or last node is held on the bed, turns the row of its residual in the tangent into that of its negative end
    /// force with [`BedContact::force_on_end`]; elsewhere it is that already. `r` is its residual \[N\].
    pub(in crate::scene) fn linearise_end_force(
        &self,
        at: At<'_>,
        node: usize,
        r: &V3,
        tangent: &mut BlockBand,
    ) {
        if self.end_held_on_bed(node, at).is_none() {
            return;
        }
        let last = at.line.segments.len();
        let load = -r - self.force(node, at.state);
        tangent.diag[node] += self.force_by_position(node, at.state);
        let beside = if node == 0 { 1 } else { last - 1 };
        let rubs = beside != 0 && beside != last && !self.seabed.is_smooth_grid();
        let by_beside = rubs.then(|| self.force(beside, at.state));
        let normal = self.seabed.normal(&at.state.x[node]);
        let slopes = slopes_of_end_force(&normal, &load, by_beside);
        let (near, far) = if node == 0 {
            (&mut tangent.upper[0], tangent.far_upper.first_mut())
        } else {
            (&mut tangent.lower[last], tangent.far_lower.get_mut(last))
        };
        tangent.diag[node] = slopes.by_load * tangent.diag[node];
        if let Some(by_place) = self.seabed.normal_slope(&at.state.x[node]) {
            tangent.diag[node] -= push_by_turning(&normal, &load, &by_place);
        }
        *near =
            slopes.by_load * *near - slopes.by_beside * self.force_by_position(beside, at.state);
        if let Some(far) = far {
            *far = slopes.by_load * *far;
        }
    }

    /// Derivative of the force of the bed on node i by its position \[N/m\].
    fn force_by_position(&self, i: usize, state: &State) -> M3 {
        let push = self.push(i, state);
        let normal = self.seabed.normal(&state.x[i]);
        let [slope, _] = self.seabed.slopes(&state.x[i], &state.v[i], &push);
        let rubs = push.force > 0.0;
        let friction = rubs.then(|| self.friction_on(i, (&normal, &push), state));
        let friction = friction.flatten();
        friction.map_or(slope, |friction| slope + friction.by_position)
    }
}

/// Derivative of the push `n P`, `P = -n.load` where that is positive, by the place as it turns the normal: N P - n load' N, N the derivative of
/// the normal.
fn push_by_turning(normal: &V3, load: &V3, by_place: &M3) -> M3 {
    let push = (-normal.dot(load)).max(0.0);
    if push <= 0.0 {
        return M3::zeros();
    }
    by_place * push - outer(normal, &(by_place.transpose() * load))
}

/// Derivatives of `load + force_on_end(load)`. With n the normal, P = -n.load the push on the end, g the friction on the
/// neighbouring node over its push b, and e = g/|g|:
///
/// ```text
/// F = Q load + g P              Q = I - nn'      friction in full
/// F = Q load - e e' load                         friction that resists all of the load along it
/// ```
fn slopes_of_end_force(normal: &V3, load: &V3, beside: Option<V3>) -> EndForceSlopes {
    let push = -normal.dot(load);
    if push <= 0.0 {
        return EndForceSlopes {
            by_load: M3::identity(),
            by_beside: M3::zeros(),
        };
    }
    let level = M3::identity() - outer(normal, normal);
    let held = beside.filter(|force| normal.dot(force) > 0.0);
    let Some(force) = held else {
        return EndForceSlopes {
            by_load: level,
            by_beside: M3::zeros(),
        };
    };
    let borne = normal.dot(&force);
    let friction = level * force / borne;
    let by_force = (level - outer(&friction, normal)) / borne;
    let (size, resisted) = (friction.norm(), -load.dot(&friction));
    if resisted > 0.0 && size * size * push > resisted {
        let along = friction / size;
        let turned = M3::from_diagonal_element(along.dot(load)) + outer(&along, load);
        let across = M3::identity() - outer(&along, &along);
        EndForceSlopes {
            by_load: level - outer(&along, &along),
            by_beside: -turned * across * by_force / size,
        }
    } else {
        EndForceSlopes {
            by_load: level - outer(&friction, normal),
            by_beside: by_force * push,
        }
    }
}
