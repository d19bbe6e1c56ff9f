//! Where the search for an equilibrium begins: free points among their neighbours.

use nalgebra::{Cholesky, DMatrix};

use super::freedoms::Placement;
use super::network::{Held, Network};
use crate::numerics::V3;

/// Bodies where they are given; free points where they are given, or else where springs in the place of the lines, the
/// stiffer the shorter the line, would hold them.
#[must_use]
pub fn start(network: &Network) -> Placement {
    let mut placement = Placement {
        points: network
            .points
            .iter()
            .map(|point| known(&point.held))
            .collect(),
        bodies: network.bodies.iter().map(|body| body.pose).collect(),
    };
    placement.carry(network);
    let searched = |held: &Held| matches!(held, Held::Free(free) if free.start.is_none());
    let mut count = 0;
    let numbers: Vec<Option<usize>> = network
        .points
        .iter()
        .map(|point| {
            let number = count;
            let unknown = searched(&point.held);
            count += usize::from(unknown);
            unknown.then_some(number)
        })
        .collect();
    let mut springs = DMatrix::<f64>::zeros(count, count);
    let mut pull = DMatrix::<f64>::zeros(count, 3);
    for line in &network.lines {
        let stiffness = 1.0 / line.length();
        for (end, other) in [(line.from, line.to), (line.to, line.from)] {
            let Some(row) = numbers[end] else { continue };
            springs[(row, row)] += stiffness;
            match numbers[other] {
                Some(column) => springs[(row, column)] -= stiffness,
                None => {
                    for axis in 0..3 {
                        pull[(row, axis)] += stiffness * placement.points[other][axis];
                    }
                }
            }
        }
    }
    if let Some(found) = Cholesky::new(springs).map(|factors| factors.solve(&pull)) {
        for (place, number) in placement.points.iter_mut().zip(&numbers) {
            if let Some(row) = number {
                *place = V3::new(found[(*row, 0)], found[(*row, 1)], found[(*row, 2)]);
            }
        }
    }
    placement
}

fn known(held: &Held) -> V3 {
    match held {
        Held::At(place) => *place,
        Held::Free(free) => free.start.unwrap_or_default(),
        Held::On(..) => V3::zeros(),
    }
}
