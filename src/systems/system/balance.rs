//! The forces on the unknowns of a system, and their stiffness.
//!
//! A point at the arm `r` from the origin of a body moves by `du + dt x r` as the body moves by `du` and turns by `dt`. A force F
//! there is the force F and the moment `r x F` on the body, and
//!
//! ```text
//! d(r x F) = [F]x [r]x dt + [r]x dF
//! ```
//!
//! The first part turns the arm under the force: with it the stiffness of a body is exact, loads that hold still included. The direction of a
//! clamp on a body moves like a point at the arm of that direction, but for `du`.

use nalgebra::{DVector, SMatrix};

use super::body_loads::body_loads;
use super::clamps;
use super::discretised::Unsolved;
use super::freedoms::{Follower, Freedoms, Placement, follower};
use super::laid::laid_from;
use super::line_at_rest::LineAtRest;
use super::line_physics::LinePhysics;
use super::line_solver::{has_closed_form, solve};
use super::network::{Held, Line, Network};
use super::pose::cross;
use crate::line_between_ends::ClampedEquilibrium;
use crate::numerics::V3;
use crate::numerics::envelope::EnvelopeMatrix;
use crate::statics::catenary::CatenaryError;

/// Forces and stiffness of a system at a placement.
#[derive(Debug, Clone)]
pub struct Balance {
    /// Force on each unknown \[N, N m\].
    pub force: DVector<f64>,
    /// Minus the change of the forces with the unknowns \[N/m, N, N m\].
    pub stiffness: EnvelopeMatrix,
    /// The lines at rest.
    pub lines: Vec<LineAtRest>,
    /// Greatest tension at an end \[N\].
    pub tension: f64,
}

/// A line that has no equilibrium between its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct UnsolvedLine {
    /// Which line.
    pub line: usize,
    /// Why.
    pub why: String,
    /// Newton iterations of its own search, if it is divided.
    pub iterations: u64,
}

/// A line at rest between its points at a placement; `near` is one near by.
///
/// # Errors
/// A line without a solution.
pub fn line_at_rest(
    network: &Network,
    placement: &Placement,
    index: usize,
    physics: LinePhysics,
    near: Option<&LineAtRest>,
) -> Result<LineAtRest, UnsolvedLine> {
    let line = &network.lines[index];
    let [a, b] = [line.from, line.to].map(|point| &placement.points[point]);
    let clamps = &clamps::directions(network, line, placement);
    let solved = match &line.discretised {
        Some(element)
            if physics == LinePhysics::Full && !has_closed_form(network, line, (a, b)) =>
        {
            let from = laid_from(network, placement, index).unwrap_or_default();
            element.solve((a, b), clamps, from, near)
        }
        element => {
            let laid = laid_from(network, placement, index);
            let from = laid.filter(|_| physics == LinePhysics::Full);
            match solve(network, line, (a, b), (physics, from), near) {
                // It floats, or is dry between wet parts.
                Err(CatenaryError::AtSurface(why)) => match element {
                    Some(element) => element.solve((a, b), clamps, laid.unwrap_or_default(), near),
                    None => Err(Unsolved::of_reason(why)),
                },
                found => found.map_err(|error| Unsolved::of_reason(&error)),
            }
        }
    };
    solved.or_else(|Unsolved { why, iterations }| {
        let straight = ends_stay(network, line).then(|| without_rest(network, placement, index));
        straight.flatten().ok_or(UnsolvedLine {
            line: index,
            why,
            iterations,
        })
    })
}

/// A line straight and without forces in the place of an equilibrium that it has none of, where it begins a run in a shape of its own.
#[must_use]
pub fn without_rest(network: &Network, placement: &Placement, index: usize) -> Option<LineAtRest> {
    let line = &network.lines[index];
    let element = line.discretised.as_ref();
    let element = element.filter(|_| line.begins_in_shape())?;
    let ends = [line.from, line.to].map(|point| &placement.points[point]);
    element.unloaded((ends[0], ends[1])).ok()
}

/// Whether nothing that is searched for hangs on a line.
fn ends_stay(network: &Network, line: &Line) -> bool {
    let stays = |point: usize| match &network.points[point].held {
        Held::At(_) => true,
        Held::On(body, _) => !network.bodies[*body].turns(),
        Held::Free(_) => false,
    };
    stays(line.from) && stays(line.to)
}

/// The forces at a placement; `before` are lines near by.
///
/// # Errors
/// The first line without a solution.
pub fn balance(
    network: &Network,
    freedoms: &Freedoms,
    placement: &Placement,
    physics: LinePhysics,
    before: Option<&[LineAtRest]>,
) -> Result<Balance, UnsolvedLine> {
    let n = freedoms.count;
    let mut out = Balance {
        force: DVector::zeros(n),
        stiffness: EnvelopeMatrix::zeros(&freedoms.shape),
        lines: Vec::with_capacity(network.lines.len()),
        tension: 0.0,
    };
    for (index, line) in network.lines.iter().enumerate() {
        let near = before.and_then(|lines| lines.get(index));
        let at_rest = line_at_rest(network, placement, index, physics, near)?;
        let ends = [line.from, line.to];
        let followers = ends.map(|point| follower(network, freedoms, placement, point));
        out.line(&at_rest, &followers);
        if let Some(clamped) = at_rest.clamped() {
            let of_clamp = |end| clamps::follower(network, freedoms, placement, (line, end));
            let [a, b] = followers;
            out.clamps(clamped, &[a, b, of_clamp(0), of_clamp(1)]);
        }
        out.tension = at_rest.tensions().into_iter().fold(out.tension, f64::max);
        out.lines.push(at_rest);
    }
    for (index, first) in freedoms.points.iter().enumerate() {
        if let (Held::Free(free), Some(first)) = (&network.points[index].held, first) {
            let (force, by_place) = free.force(network, &placement.points[index], physics);
            let mut rows = out.force.fixed_rows_mut::<3>(*first);
            rows += force;
            out.stiffness.add_block(*first, *first, &-by_place);
        }
    }
    for (index, first) in freedoms.bodies.iter().enumerate() {
        if let Some(first) = first {
            let body = &network.bodies[index];
            let pose = &placement.bodies[index];
            let (force, stiffness) = body_loads(network, body, pose, physics);
            let mut rows = out.force.fixed_rows_mut::<6>(*first);
            rows += force;
            out.stiffness.add_block(*first, *first, &stiffness);
        }
    }
    for (index, body) in network.bodies.iter().enumerate() {
        let carried = freedoms.bodies[index].zip(body.carrier);
        let Some((own, (carrier, at))) = carried else {
            continue;
        };
        if let Some(on) = freedoms.bodies[carrier] {
            out.pin(own, on, &placement.bodies[carrier].arm(&at));
        }
    }
    Ok(out)
}

impl Balance {
    /// Adds the force on the origin of a body that is pinned to another, at an arm from the origin of that one, to its unknowns:
    /// `u = du + dt x r`. `own` and `on` are their first unknowns.
    fn pin(&mut self, own: usize, on: usize, arm: &V3) {
        let force = self.force.fixed_rows::<3>(own).into_owned();
        let mut by = SMatrix::<f64, 3, 6>::zeros();
        by.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
        by.fixed_view_mut::<3, 3>(0, 3).copy_from(&-cross(arm));
        let mut rows = self.force.fixed_rows_mut::<6>(on);
        rows += by.transpose() * force;
        let turning = -(cross(&force) * cross(arm));
        self.stiffness.add_block(on + 3, on + 3, &turning);
        for k in 0..3 {
            for (unknown, factor) in by.row(k).iter().enumerate() {
                if *factor != 0.0 {
                    self.stiffness.add_multiple(on + unknown, own + k, *factor);
                }
            }
        }
    }

    /// Adds a line on the unknowns that its ends follow.
    fn line(&mut self, line: &LineAtRest, followers: &[Option<Follower>; 2]) {
        let (on_bodies, on_points) = ([line.force_a, line.force_b], line.forces_on_points());
        let slopes_on_points = line.stiffness_on_points();
        for (i, on) in followers.iter().enumerate() {
            let Some(on) = on else { continue };
            let (forces, slopes) = match on.size {
                3 => (on_points, &slopes_on_points),
                _ => (on_bodies, &line.by_ends),
            };
            let load = on.by.transpose() * forces[i];
            for k in 0..on.size {
                self.force[on.first + k] += load[k];
            }
            if on.size == 6 {
                let turning = -(cross(&forces[i]) * cross(&on.arm));
                let turns = on.first + 3;
                self.stiffness.add_block(turns, turns, &turning);
            }
            for (j, by) in followers.iter().enumerate() {
                let Some(by) = by else { continue };
                let block = on.by.transpose() * -slopes[i][j] * by.by;
                let block = block.view((0, 0), (on.size, by.size));
                self.stiffness.add_block(on.first, by.first, &block);
            }
        }
    }

    /// Adds the clamps of a line: followers of its ends, and of the directions of its clamps.
    fn clamps(&mut self, line: &ClampedEquilibrium, followers: &[Option<Follower>; 4]) {
        for (i, on) in followers.iter().enumerate() {
            let Some(on) = on else { continue };
            if i >= 2 {
                let force = &line.force_n_m[i - 2];
                let load = on.by.transpose() * force;
                let mut rows = self.force.fixed_rows_mut::<6>(on.first);
                rows += load;
                let turning = -(cross(force) * cross(&on.arm));
                let turns = on.first + 3;
                self.stiffness.add_block(turns, turns, &turning);
            }
            // Those between both ends are of the line.
            for (j, by) in followers.iter().enumerate().filter(|(j, _)| i.max(*j) >= 2) {
                let Some(by) = by else { continue };
                let block = on.by.transpose() * -line.stiffness[i][j] * by.by;
                let block = block.view((0, 0), (on.size, by.size));
                self.stiffness.add_block(on.first, by.first, &block);
            }
        }
    }
}
