//! What the lines of a system at rest do to points and bodies, and how near they are to breaking.

use super::clamps::clamp_on;
use super::equilibrium::SystemEquilibrium;
use super::network::{Held, Network};
use crate::numerics::V3;

/// Force of all lines on a point \[N\].
#[must_use]
pub fn pull(network: &Network, rest: &SystemEquilibrium, point: usize) -> V3 {
    let lines = network.lines.iter().zip(&rest.balance.lines);
    let on_point = lines.map(|(line, at_rest)| {
        let at = |end: usize, force: V3| if end == point { force } else { V3::zeros() };
        at(line.from, at_rest.force_a) + at(line.to, at_rest.force_b)
    });
    on_point.sum()
}

/// The same for every point.
#[must_use]
pub fn pulls(network: &Network, rest: &SystemEquilibrium) -> Vec<V3> {
    let mut pulls = vec![V3::zeros(); network.points.len()];
    for (line, at_rest) in network.lines.iter().zip(&rest.balance.lines) {
        pulls[line.from] += at_rest.force_a;
        pulls[line.to] += at_rest.force_b;
    }
    pulls
}

/// Force \[N\] and moment about its origin \[N m\] of all lines on a body.
#[must_use]
pub fn on_body(network: &Network, rest: &SystemEquilibrium, body: usize) -> (V3, V3) {
    let (placement, pulls) = (&rest.placement, pulls(network, rest));
    let (mut force, mut moment) = (V3::zeros(), of_clamps(network, rest, body));
    for (index, point) in network.points.iter().enumerate() {
        if matches!(point.held, Held::On(on, _) if on == body) {
            let here = pulls[index];
            force += here;
            moment += (placement.points[index] - placement.bodies[body].origin).cross(&here);
        }
    }
    (force, moment)
}

/// Moment of all clamps on a body \[N m\]: `d x F` of each.
fn of_clamps(network: &Network, rest: &SystemEquilibrium, body: usize) -> V3 {
    let pose = &rest.placement.bodies[body];
    let lines = network.lines.iter().zip(&rest.balance.lines);
    let moments = lines.flat_map(|(line, at_rest)| {
        let forces = at_rest.clamped().map(|clamped| clamped.force_n_m);
        let ends = forces.into_iter().flatten().enumerate();
        ends.filter_map(|(end, force)| {
            let (on, own) = clamp_on(network, line, end)?;
            (on == body).then(|| pose.arm(&own).cross(&force))
        })
    });
    moments.sum()
}

/// Force of its pin on a body \[N\]: what balances all else; nothing for a body that is not pinned.
#[must_use]
pub fn of_pin(network: &Network, rest: &SystemEquilibrium, body: usize) -> Option<V3> {
    let first = rest.freedoms.bodies[body].filter(|_| network.bodies[body].pinned)?;
    Some(-rest.balance.force.fixed_rows::<3>(first))
}

/// The greatest tension over breaking load of a line, at the ends of its sections \[-\]; nothing where none states one.
#[must_use]
pub fn share_of_breaking_load(
    network: &Network,
    rest: &SystemEquilibrium,
    line: usize,
) -> Option<f64> {
    let (line, at_rest) = (&network.lines[line], &rest.balance.lines[line]);
    let places = &rest.placement.points;
    let ends = [&places[line.from], &places[line.to]];
    let whole = line.length();
    let mut arc = 0.0;
    let mut greatest: Option<f64> = None;
    for section in &line.parts {
        let (from, to) = (arc / whole, (arc + section.length_m) / whole);
        arc += section.length_m;
        if let Some(breaks) = section.break_load {
            let tension = at_rest.at(from, ends).1.max(at_rest.at(to, ends).1);
            greatest = Some(greatest.unwrap_or(0.0).max(tension / breaks));
        }
    }
    greatest
}
