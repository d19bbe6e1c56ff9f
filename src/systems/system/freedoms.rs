//! Which numbers of a system are unknown: three of a free point, six of a body. Of a body that is pinned the first three stay
//! ([`Contact::Pin`](super::bounds::Contact::Pin)).

use std::sync::Arc;

use nalgebra::{DVector, SMatrix};

use super::network::{Held, Network};
use super::pose::{Pose, cross};
use crate::numerics::V3;
use crate::numerics::envelope::{EnvelopeShape, number};

/// Where the unknowns of points and bodies stand among all of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Freedoms {
    /// First unknown of each point; nothing for points that are held or on a body.
    pub points: Vec<Option<usize>>,
    /// First unknown of each body: three along x, y, z, then three turns; nothing for bodies that are held.
    pub bodies: Vec<Option<usize>>,
    /// How many there are.
    pub count: usize,
    /// Which of them lines couple.
    pub shape: Arc<EnvelopeShape>,
}

/// Which bodies are unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnknownBodies {
    /// Those that are free or pinned.
    Free,
    /// All of them: for the stiffness of what is held.
    All,
}

impl Freedoms {
    /// The unknowns of a system, numbered along its lines: those that a line couples stand near each other.
    #[must_use]
    pub fn of_network(network: &Network, which: UnknownBodies) -> Self {
        let points = network.points.len();
        let unknown = |body: usize| network.bodies[body].turns() || which == UnknownBodies::All;
        let part = |point: usize| match &network.points[point].held {
            Held::At(_) => None,
            Held::On(body, _) => unknown(*body).then_some(points + body),
            Held::Free(_) => Some(point),
        };
        let mut neighbours = vec![Vec::new(); points + network.bodies.len()];
        for line in &network.lines {
            if let (Some(a), Some(b)) = (part(line.from), part(line.to)) {
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        }
        join_carriers(network, &mut neighbours, &unknown);
        let free = |point: usize| matches!(network.points[point].held, Held::Free(_));
        let of_points = (0..points).map(|point| if free(point) { 3 } else { 0 });
        let of_bodies = (0..network.bodies.len()).map(|body| if unknown(body) { 6 } else { 0 });
        let sizes: Vec<usize> = of_points.chain(of_bodies).collect();
        let (begins, shape) = number(&neighbours, &sizes);
        let first = |part: usize| (sizes[part] > 0).then_some(begins[part]);
        Self {
            points: (0..points).map(first).collect(),
            bodies: (points..sizes.len()).map(first).collect(),
            count: sizes.iter().sum(),
            shape: Arc::new(shape),
        }
    }

    /// Unknowns in words: `x of junction`, `pitch of spar`.
    #[must_use]
    pub fn name(&self, network: &Network, unknown: usize) -> String {
        const TURNS: [&str; 6] = ["x", "y", "z", "roll", "pitch", "yaw"];
        let within = |first: &Option<usize>, size: usize| {
            first.filter(|first| (*first..*first + size).contains(&unknown))
        };
        for (point, first) in network.points.iter().zip(&self.points) {
            if let Some(first) = within(first, 3) {
                return format!("{} of {}", TURNS[unknown - first], point.name);
            }
        }
        for (body, first) in network.bodies.iter().zip(&self.bodies) {
            if let Some(first) = within(first, 6) {
                return format!("{} of {}", TURNS[unknown - first], body.name);
            }
        }
        String::new()
    }
}

/// Joins what touches a body that is pinned to another to that one too: its forces act there.
fn join_carriers(
    network: &Network,
    neighbours: &mut [Vec<usize>],
    unknown: &impl Fn(usize) -> bool,
) {
    let points = network.points.len();
    for (number, body) in network.bodies.iter().enumerate() {
        let Some((carrier, _)) = body.carrier.filter(|(carrier, _)| unknown(*carrier)) else {
            continue;
        };
        let (own, on) = (points + number, points + carrier);
        let mut touched = neighbours[own].clone();
        touched.push(own);
        for part in touched.into_iter().filter(|part| *part != on) {
            neighbours[on].push(part);
            neighbours[part].push(on);
        }
    }
}

/// Where everything is.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// Places of the points \[m\].
    pub points: Vec<V3>,
    /// Poses of the bodies.
    pub bodies: Vec<Pose>,
}

impl Placement {
    /// The placement moved along `step`, points on bodies with them.
    #[must_use]
    pub fn moved(&self, network: &Network, freedoms: &Freedoms, step: &DVector<f64>) -> Self {
        let three = |first: usize| V3::new(step[first], step[first + 1], step[first + 2]);
        let bodies = self.bodies.iter().zip(&freedoms.bodies);
        let bodies: Vec<Pose> = bodies
            .map(|(pose, first)| match first {
                Some(first) => pose.moved(&three(*first), &three(first + 3)),
                None => *pose,
            })
            .collect();
        let mut moved = Self {
            points: self.points.clone(),
            bodies,
        };
        for (point, first) in moved.points.iter_mut().zip(&freedoms.points) {
            if let Some(first) = first {
                *point += three(*first);
            }
        }
        moved.carry(network);
        moved
    }

    /// Puts the origins of bodies that are pinned to others where these have them.
    fn carry_bodies(&mut self, network: &Network) {
        for (number, body) in network.bodies.iter().enumerate() {
            if let Some((carrier, at)) = &body.carrier {
                let pose = self.bodies[*carrier];
                self.bodies[number].origin = pose.origin + pose.arm(at);
            }
        }
    }

    /// Puts points on bodies, and bodies that are pinned to others, where their bodies have them.
    pub fn carry(&mut self, network: &Network) {
        self.carry_bodies(network);
        for (place, point) in self.points.iter_mut().zip(&network.points) {
            if let Held::On(body, at) = &point.held {
                let pose = &self.bodies[*body];
                *place = pose.origin + pose.arm(at);
            }
        }
    }
}

/// How a point follows the unknowns: the first of them and their effect on it.
#[derive(Debug, Clone, Copy)]
pub struct Follower {
    /// First of its unknowns.
    pub first: usize,
    /// Change of its place by six unknowns; a free point has three.
    pub by: SMatrix<f64, 3, 6>,
    /// Three or six.
    pub size: usize,
    /// From the origin of its body \[m\]; zero for a free point.
    pub arm: V3,
}

impl Follower {
    /// Of a place at this arm \[m\] on a body with these unknowns.
    #[must_use]
    pub fn on_body(first: usize, arm: V3) -> Self {
        let mut follower = Self::turning(first, arm);
        follower
            .by
            .fixed_view_mut::<3, 3>(0, 0)
            .fill_with_identity();
        follower
    }

    /// Of an arm of a body, which its displacements leave as it is.
    #[must_use]
    pub fn turning(first: usize, arm: V3) -> Self {
        let mut by = SMatrix::<f64, 3, 6>::zeros();
        by.fixed_view_mut::<3, 3>(0, 3).copy_from(&-cross(&arm));
        Self {
            first,
            by,
            size: 6,
            arm,
        }
    }

    /// Of a free point.
    fn of_point(first: usize) -> Self {
        Self {
            size: 3,
            ..Self::on_body(first, V3::zeros())
        }
    }
}

/// How a point follows the unknowns; nothing for one that does not move.
#[must_use]
pub fn follower(
    network: &Network,
    freedoms: &Freedoms,
    placement: &Placement,
    point: usize,
) -> Option<Follower> {
    match &network.points[point].held {
        Held::At(_) => None,
        Held::Free(_) => Some(Follower::of_point(freedoms.points[point]?)),
        Held::On(body, at) => {
            let first = freedoms.bodies[*body]?;
            Some(Follower::on_body(first, placement.bodies[*body].arm(at)))
        }
    }
}
