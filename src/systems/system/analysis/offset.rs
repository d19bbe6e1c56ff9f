//! A body held away from its place: the force of the lines on it, and their tensions, against the offset.

use super::super::equilibrium::{SystemEquilibrium, SystemError, search};
use super::super::freedoms::Placement;
use super::super::loads;
use super::super::network::{Held, Line, Network};
use super::super::pose::Pose;
use super::super::stiffness::of_body;
use crate::numerics::V3;
use nalgebra::Matrix2;

/// A system with one body held at a chosen pose, solved again and again from the state before.
#[derive(Debug, Clone)]
pub struct HeldAway {
    network: Network,
    body: usize,
    start: Placement,
    /// The state found last.
    last: SystemEquilibrium,
}

/// The system with the body somewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct OffsetPoint {
    /// Offset in plan \[m\].
    pub offset_m: [f64; 2],
    /// Force of the lines on the body \[N\].
    pub force_n: V3,
    /// The line of the greatest tension, and that tension \[N\].
    pub greatest: (usize, f64),
    /// The line of the greatest share of its breaking load, and that share; nothing where no line states one.
    pub weakest: Option<(usize, f64)>,
    /// Greatest upward pull of a line on a fixed point \[N\], and its line; nothing where no line pulls up.
    pub uplift: Option<(usize, f64)>,
    /// Tensions at both ends of every line \[N\].
    pub tensions: Vec<[f64; 2]>,
}

impl HeldAway {
    /// The system with this body held, all else as it rests.
    #[must_use]
    pub fn new(network: &Network, rest: &SystemEquilibrium, body: usize) -> Self {
        let mut network = network.clone();
        network.bodies[body].free = false;
        network.bodies[body].pinned = false;
        network.bodies[body].carrier = None;
        network.bodies[body].pose = rest.placement.bodies[body];
        Self {
            network,
            body,
            start: rest.placement.clone(),
            last: rest.clone(),
        }
    }

    /// The same without one line.
    #[must_use]
    pub fn without(&self, line: usize) -> Self {
        let mut lost = self.clone();
        lost.network.lines.remove(line);
        lost
    }

    /// The system held.
    #[must_use]
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// The body moved in plan from where it rests \[m\]. The next search begins where this one ends.
    ///
    /// # Errors
    /// No equilibrium there.
    pub fn at(&mut self, offset_m: [f64; 2]) -> Result<OffsetPoint, SystemError> {
        let home = self.network.bodies[self.body].pose;
        let away = Pose {
            origin: home.origin + V3::new(offset_m[0], offset_m[1], 0.0),
            ..home
        };
        self.start.bodies[self.body] = away;
        let rest = search(&self.network, &self.start)?;
        self.start = rest.placement.clone();
        let found = point(&self.network, &rest, self.body, offset_m);
        self.last = rest;
        Ok(found)
    }

    /// Stiffness of the lines on the body in plan where it was put last \[N/m\]; zero where a line has no solution.
    #[must_use]
    pub fn stiffness(&self) -> Matrix2<f64> {
        let whole = of_body(&self.network, &self.last, self.body);
        whole.map_or_else(
            |_| Matrix2::zeros(),
            |k| k.fixed_view::<2, 2>(0, 0).into_owned(),
        )
    }

    /// The longest line of the system \[m\].
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.network
            .lines
            .iter()
            .map(Line::length)
            .fold(0.0, f64::max)
    }
}

fn point(
    network: &Network,
    rest: &SystemEquilibrium,
    body: usize,
    offset_m: [f64; 2],
) -> OffsetPoint {
    let force_n = loads::on_body(network, rest, body).0;
    let mut greatest = (0, 0.0);
    let mut weakest: Option<(usize, f64)> = None;
    let mut uplift: Option<(usize, f64)> = None;
    let mut tensions = Vec::with_capacity(network.lines.len());
    for (index, (line, at_rest)) in network.lines.iter().zip(&rest.balance.lines).enumerate() {
        let ends = [(line.from, at_rest.force_a), (line.to, at_rest.force_b)];
        for (end, force) in ends {
            let anchor = matches!(network.points[end].held, Held::At(_));
            if anchor && force.z > uplift.map_or(0.0, |(_, z)| z) {
                uplift = Some((index, force.z));
            }
        }
        let both = at_rest.tensions();
        let tension = both[0].max(both[1]);
        if tension > greatest.1 {
            greatest = (index, tension);
        }
        if let Some(share) = loads::share_of_breaking_load(network, rest, index)
            && share > weakest.map_or(0.0, |(_, share)| share)
        {
            weakest = Some((index, share));
        }
        tensions.push(both);
    }
    OffsetPoint {
        offset_m,
        force_n,
        greatest,
        weakest,
        uplift,
        tensions,
    }
}

/// The body pushed along a heading \[rad\] by so many metres, in even steps from its place; ends where no equilibrium is found.
#[must_use]
pub fn curve(held: &mut HeldAway, heading: f64, to_m: f64, steps: u32) -> Vec<OffsetPoint> {
    let mut points = Vec::new();
    for step in 0..=steps {
        let far = to_m * f64::from(step) / f64::from(steps.max(1));
        match held.at([far * heading.cos(), far * heading.sin()]) {
            Ok(point) => points.push(point),
            Err(_) => break,
        }
    }
    points
}
