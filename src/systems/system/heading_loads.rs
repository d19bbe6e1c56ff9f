//! Wind and current on a body by coefficients: load by speed squared, by the heading from which they come, as tank and tunnel tests
//! give them; the mean drift of waves by their heading; and drag of a body on areas along its axes.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use num_dual::DualNum;

use super::body_in_flow::share_in_water;
use super::load_sum::LoadSum;
use super::moving_pose::{Dual, DualVector, MovingPose, constant, near};
use super::network::{Body, HeadingLoads, Network};
use crate::numerics::V3;
use crate::physics::sea::WaterMotion;

/// Wind, current and drag on a body.
pub(super) fn add(network: &Network, body: &Body, pose: &MovingPose<'_>, sum: &mut LoadSum) {
    if let Some((loads, towards)) = &body.drift_loads {
        by_heading(loads, &constant(towards), pose, sum);
    }
    if let Some(loads) = &body.wind_loads {
        by_heading(loads, &(constant(&network.wind) - pose.velocity), pose, sum);
    }
    let origin = pose.origin.map(|part| part.re);
    if let Some(loads) = &body.current_loads {
        let place = V3::new(origin.x, origin.y, 0.0);
        let (water, gradient) = match &network.current {
            Some(current) => current.flow(&place),
            None => Default::default(),
        };
        let mut surface = pose.origin;
        surface.z = Dual::from_re(0.0);
        let flow = near((&water, &gradient), &place, &surface) - pose.velocity;
        by_heading(loads, &flow, pose, sum);
    }
    if body.drag_area != V3::zeros() {
        let in_water = share_in_water(network, body, pose);
        let waves = pose.at_strips(body.strips_in_waves());
        for (number, (place, share)) in body.drag_strips().enumerate() {
            let flow = waves.get(number).or(pose.at_station());
            on_areas(network, body, pose, (&place, flow), in_water * share, sum);
        }
    }
}

/// Drag of a share of the body at a place of its frame on an area along each of its axes: `rho/2 A |u| u`, axis by axis.
fn on_areas(
    network: &Network,
    body: &Body,
    pose: &MovingPose<'_>,
    (place, waves): (&V3, Option<&WaterMotion>),
    share: Dual,
    sum: &mut LoadSum,
) {
    let arm = pose.arm(place);
    let place = pose.place(&arm);
    let here = place.map(|part| part.re);
    let (still, gradient) = match &network.current {
        Some(current) => current.flow(&here),
        None => Default::default(),
    };
    let mut velocity = near((&still, &gradient), &here, &place) - pose.velocity_at(&arm);
    if let Some(flow) = waves {
        velocity += near((&flow.velocity, &flow.gradient), &flow.place, &place);
    }
    let speed2 = velocity.dot(&velocity);
    if speed2.re == 0.0 {
        return;
    }
    let speed = speed2.sqrt();
    for k in 0..3 {
        let axis = pose.arm(&V3::ith(k, 1.0));
        let along = velocity.dot(&axis) * speed * (0.5 * network.density * body.drag_area[k]);
        sum.add(&arm, &(axis * (along * share)));
    }
}

/// The load of a flow relative to the body by its heading: surge and sway along the body's heading, and yaw.
fn by_heading(loads: &HeadingLoads, flow: &DualVector, pose: &MovingPose<'_>, sum: &mut LoadSum) {
    let speed2 = flow.x.powi(2) + flow.y.powi(2);
    if speed2.re == 0.0 {
        return;
    }
    let ahead = pose.arm(&V3::x());
    let heading = ahead.y.atan2(ahead.x);
    let relative = flow.y.atan2(flow.x) - heading;
    let [surge, sway, yaw] = loads.at(relative).map(|load| load * speed2);
    let (sin, cos) = heading.sin_cos();
    let force = Vector3::new(
        surge * cos - sway * sin,
        surge * sin + sway * cos,
        Dual::from_re(0.0),
    );
    sum.add(&constant(&V3::zeros()), &force);
    sum.turn(&Vector3::new(Dual::from_re(0.0), Dual::from_re(0.0), yaw));
}

impl HeadingLoads {
    /// Surge, sway and yaw by speed squared at a heading \[rad\]: periodic cubics through the values given, with the slopes of their
    /// neighbours' chords (Catmull and Rom).
    fn at(&self, heading: Dual) -> [Dual; 3] {
        let turns = ((heading.re - self.headings[0]) / TAU).floor();
        let angle = heading - turns * TAU;
        let n = self.headings.len();
        let next = self.headings.partition_point(|known| *known <= angle.re);
        // Two headings before and two behind, a turn further where they lie beyond the last.
        let node = |k: usize| {
            let (index, turn) = (k % n, (k / n) as f64 - 1.0);
            (self.headings[index] + TAU * turn, self.loads[index])
        };
        let nodes = [0, 1, 2, 3].map(|k| node(n + next + k - 2));
        let span = nodes[2].0 - nodes[1].0;
        let t = (angle - nodes[1].0) / span;
        let (t2, t3) = (t.powi(2), t.powi(3));
        let one = |k: usize| {
            let slope = |a: usize, b: usize| {
                (nodes[b].1[k] - nodes[a].1[k]) / (nodes[b].0 - nodes[a].0) * span
            };
            let (from, to) = (nodes[1].1[k], nodes[2].1[k]);
            (t3 * 2.0 - t2 * 3.0 + 1.0) * from
                + (t3 - t2 * 2.0 + t) * slope(0, 2)
                + (t2 * 3.0 - t3 * 2.0) * to
                + (t3 - t2) * slope(1, 3)
        };
        [0, 1, 2].map(one)
    }
}
