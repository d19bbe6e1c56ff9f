//! Parts of a system that nothing holds.

use super::network::{Held, Network};

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
    for (index, _) in network
        .bodies
        .iter()
        .enumerate()
        .filter(|(_, body)| !body.free)
    {
        groups.join(points + index, earth);
    }
    for line in &network.lines {
        groups.join(line.from, line.to);
    }
    let ground = groups.root(earth);
    let part = (0..earth).find(|&part| groups.root(part) != ground)?;
    Some(match part.checked_sub(points) {
        None => Loose::Point(part),
        Some(body) => Loose::Body(body),
    })
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
