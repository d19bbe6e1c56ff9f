//! Where the search for an equilibrium begins: free points among their neighbours.

use std::sync::Arc;

use nalgebra::DVector;

use super::freedoms::Placement;
use super::network::{Held, Network};
use crate::numerics::V3;
use crate::numerics::envelope::{EnvelopeMatrix, number};
use crate::numerics::envelope_factors::EnvelopeCholesky;

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
    let unknown: Vec<bool> = network.points.iter().map(|p| searched(&p.held)).collect();
    let mut neighbours = vec![Vec::new(); unknown.len()];
    for line in network
        .lines
        .iter()
        .filter(|line| unknown[line.from] && unknown[line.to])
    {
        neighbours[line.from].push(line.to);
        neighbours[line.to].push(line.from);
    }
    let sizes: Vec<usize> = unknown
        .iter()
        .map(|unknown| usize::from(*unknown))
        .collect();
    let (rows, shape) = number(&neighbours, &sizes);
    let mut springs = EnvelopeMatrix::zeros(&Arc::new(shape));
    let nothing = DVector::zeros(springs.size());
    let mut pull = [nothing.clone(), nothing.clone(), nothing.clone()];
    for line in &network.lines {
        let stiffness = 1.0 / line.length();
        for (end, other) in [(line.from, line.to), (line.to, line.from)] {
            if !unknown[end] {
                continue;
            }
            springs.add(rows[end], rows[end], stiffness);
            if unknown[other] {
                springs.add(rows[end], rows[other], -stiffness);
                continue;
            }
            for (axis, pull) in pull.iter_mut().enumerate() {
                pull[rows[end]] += stiffness * placement.points[other][axis];
            }
        }
    }
    if let Some(factors) = EnvelopeCholesky::new(&springs, &nothing) {
        let found = pull.map(|pull| factors.solve(&pull));
        let places = placement.points.iter_mut().zip(&rows).zip(&unknown);
        for ((place, row), _) in places.filter(|(_, unknown)| **unknown) {
            *place = V3::new(found[0][*row], found[1][*row], found[2][*row]);
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
