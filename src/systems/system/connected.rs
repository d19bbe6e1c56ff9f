//! Parts of a system that nothing holds.

use super::network::{Body, Held, Member, Network};

/// A free point or body that no line joins, directly or over others, to anything held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Loose {
    /// A point by its number.
    Point(usize),
    /// A body by its number.
    Body(usize),
}

/// The first part that nothing holds.
#[must_use]
pub fn loose(network: &Network) -> Option<Loose> {
    let points = network.points.len();
    // Points, then bodies, then the earth.
    let earth = points + network.bodies.len();
    let mut groups = Groups((0..=earth).collect());
    for (index, point) in network.points.iter().enumerate() {
        match point.held {
            Held::At(_) => groups.join(index, earth),
            Held::On(body, _) => groups.join(index, points + body),
            Held::Free(_) => {}
        }
    }
    for (index, body) in network
        .bodies
        .iter()
        .enumerate()
        .filter(|(_, body)| !body.free)
    {
        let held_by = body.carrier.map_or(earth, |(carrier, _)| points + carrier);
        groups.join(points + index, held_by);
    }
    for line in &network.lines {
        groups.join(line.from, line.to);
    }
    for (index, body) in network.bodies.iter().enumerate() {
        if bears_itself(network, index, body) {
            groups.join(points + index, earth);
        }
    }
    let ground = groups.root(earth);
    let part = (0..earth).find(|&part| groups.root(part) != ground)?;
    Some(match part.checked_sub(points) {
        // What carries a point is what has to be held.
        None => match network.points[part].held {
            Held::On(body, _) => Loose::Body(body),
            Held::At(_) | Held::Free(_) => Loose::Point(part),
        },
        Some(body) => Loose::Body(body),
    })
}

/// Whether a body that no line ends at may come to rest by itself: it floats, or lies on the bed.
fn bears_itself(network: &Network, number: usize, body: &Body) -> bool {
    let is_on_it =
        |point: &usize| matches!(network.points[*point].held, Held::On(on, _) if on == number);
    let mut ends = network.lines.iter().flat_map(|line| [line.from, line.to]);
    if ends.any(|end| is_on_it(&end)) {
        return false;
    }
    let displacing = body.members.iter().filter(|member| !member.drag_only);
    let volume: f64 = displacing.map(Member::volume).sum();
    let most = body.buoyancy + network.density * network.gravity * volume;
    let lies = body.bottom.is_some() && network.bed.is_some();
    // Without members or a water-plane more buoyancy than weight lifts it without end.
    let floats = volume > 0.0 || body.waterplane[(2, 2)] > 0.0 || body.buoyancy == body.weight;
    body.waterplane[(2, 2)] > 0.0 || body.weight <= most && floats || lies && body.weight >= most
}

/// Sets joined step by step.
struct Groups(Vec<usize>);

impl Groups {
    fn root(&mut self, mut of: usize) -> usize {
        while self.0[of] != of {
            self.0[of] = self.0[self.0[of]];
            of = self.0[of];
        }
        of
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a] = b;
    }
}
