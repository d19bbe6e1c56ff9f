//! Numerical errors of a system at rest.
//!
//! Of lines divided into segments they are those of the coupled result: the same system with twice the segments in every divided line, at
//! rest near by, has other tensions and places, by what the meshes of all lines make of them through the stiffness of the whole. Lines of
//! closed form beside divided ones have theirs by that too. A system of closed forms alone has errors by rounding.

use std::f64::consts::PI;

use nalgebra::DVector;

use super::along_bed::{force_along, on_slope, stiffness_along};
use super::bounds::Contact;
use super::equilibrium::{SystemEquilibrium, search_near};
use super::freedoms::Placement;
use super::network::{Line, Network};
use super::rest::{not_divided, refused};
use crate::line_between_ends::MeshOrder;
use crate::numerics::V3;
use crate::numerics::richardson::PRESUMED;

/// By how much the segments of the companion are shorter.
const RATIO: usize = 2;

/// Numerical errors of a system at rest; nothing where they are not known.
#[derive(Debug, Clone)]
pub struct ErrorsAtRest {
    /// Of the forces on the ends of each line \[N\], the greater.
    pub lines: Vec<Option<f64>>,
    /// Of the place of each point \[m\].
    pub points: Vec<Option<f64>>,
    /// Of the origin of each body \[m\] and of how it is turned \[rad\].
    pub bodies: Vec<Option<[f64; 2]>>,
    /// The companion of a system with divided lines, or why it has none.
    pub companion: Option<Result<Box<FinerSystem>, String>>,
}

/// A system with shorter segments in its divided lines, at rest.
#[derive(Debug, Clone)]
pub struct FinerSystem {
    /// The system.
    pub network: Network,
    /// Where it rests.
    pub rest: SystemEquilibrium,
    /// Error of a result by its difference from that of this system.
    share: f64,
}

impl ErrorsAtRest {
    /// Those of a system of which none are known.
    #[must_use]
    pub fn unknown(network: &Network) -> Self {
        Self {
            lines: vec![None; network.lines.len()],
            points: vec![None; network.points.len()],
            bodies: vec![None; network.bodies.len()],
            companion: None,
        }
    }

    /// The errors that its search and its rounding leave, those of meshes left out.
    #[must_use]
    pub fn by_rounding(network: &Network, rest: &SystemEquilibrium) -> Self {
        let (here, balanced) = (&rest.placement, balanced(network, rest));
        let distance = |here: &V3, balanced: &V3| {
            PRESUMED * (here - balanced).norm() + f64::EPSILON * here.norm()
        };
        let points = here.points.iter().zip(&balanced.points);
        let bodies = here.bodies.iter().zip(&balanced.bodies);
        let bodies = bodies.map(|(here, balanced)| {
            let turn = PRESUMED * here.rotation.angle_to(&balanced.rotation) + f64::EPSILON;
            Some([distance(&here.origin, &balanced.origin), turn])
        });
        let lines = network.lines.iter().enumerate().map(|(k, line)| {
            let own = rest.balance.lines[k].rounding();
            Some(own + PRESUMED * greatest(pulled(line, k, rest, &balanced)))
        });
        Self {
            lines: lines.collect(),
            points: points.map(|(a, b)| Some(distance(a, b))).collect(),
            bodies: bodies.collect(),
            companion: None,
        }
    }

    /// The errors of a system at rest.
    #[must_use]
    pub fn of_equilibrium(network: &Network, rest: &SystemEquilibrium) -> Self {
        let lines = &rest.balance.lines;
        let unknown = Self::unknown(network);
        if lines.iter().all(|line| line.discretised.is_none()) {
            return Self {
                lines: lines.iter().map(|line| Some(line.rounding())).collect(),
                ..unknown
            };
        }
        match FinerSystem::of_equilibrium(network, rest) {
            Ok(finer) => finer.errors(network, rest),
            Err(why) => Self {
                companion: Some(Err(why)),
                ..unknown
            },
        }
    }

    /// Why errors are not known, where they are not.
    #[must_use]
    pub fn missing(&self) -> Option<&str> {
        let companion = self.companion.as_ref()?.as_ref();
        companion.err().map(String::as_str)
    }

    /// The companion, where there is one.
    #[must_use]
    pub fn finer(&self) -> Option<&FinerSystem> {
        self.companion.as_ref()?.as_deref().ok()
    }
}

impl FinerSystem {
    fn of_equilibrium(network: &Network, rest: &SystemEquilibrium) -> Result<Self, String> {
        let finer = network.refined(RATIO);
        let finer = finer.map_err(|error| not_divided(error).problem)?;
        let found = search_near(&finer, &rest.placement);
        let found = found.map_err(|error| refused(&finer, &error).problem)?;
        let lines = network.lines.iter();
        let divided = lines.filter_map(|line| line.discretised.as_ref());
        let order = divided
            .map(|line| MeshOrder::of_case(line.case()))
            .fold(MeshOrder::SECOND, MeshOrder::lower);
        Ok(Self {
            network: finer,
            rest: found,
            share: order.share_of_coarser(RATIO as f64),
        })
    }

    /// Error of a result by its difference from that of this system.
    #[must_use]
    pub fn error(&self, difference: f64) -> f64 {
        self.share * difference.abs()
    }

    /// The errors of the system that this one is the companion of: by the meshes, and by what is left out of balance.
    fn errors(self, network: &Network, rest: &SystemEquilibrium) -> ErrorsAtRest {
        let balanced = balanced(network, rest);
        let (here, finer) = (&rest.placement, &self.rest.placement);
        let distance = |here: &V3, finer: &V3, balanced: &V3| {
            self.error((here - finer).norm()) + PRESUMED * (here - balanced).norm()
        };
        let points = 0..network.points.len();
        let points = points.map(|k| {
            let [here, finer, balanced] = [here, finer, &balanced].map(|place| &place.points[k]);
            Some(distance(here, finer, balanced))
        });
        let bodies = 0..network.bodies.len();
        let bodies = bodies.map(|k| {
            let [here, finer, balanced] = [here, finer, &balanced].map(|place| &place.bodies[k]);
            let turn = self.error(here.rotation.angle_to(&finer.rotation))
                + PRESUMED * here.rotation.angle_to(&balanced.rotation);
            // No rotation is farther from another than half a turn.
            let turn = turn.min(PI);
            Some([
                distance(&here.origin, &finer.origin, &balanced.origin),
                turn,
            ])
        });
        let lines = network.lines.iter().enumerate();
        let lines = lines.map(|(k, line)| {
            let [own, fine] = [rest, &self.rest].map(|rest| &rest.balance.lines[k]);
            let change = [own.force_a - fine.force_a, own.force_b - fine.force_b];
            let of_mesh = self.error(greatest(change));
            Some(of_mesh + own.rounding() + PRESUMED * greatest(pulled(line, k, rest, &balanced)))
        });
        ErrorsAtRest {
            lines: lines.collect(),
            points: points.collect(),
            bodies: bodies.collect(),
            companion: Some(Ok(Box::new(self))),
        }
    }
}

fn greatest(forces: [V3; 2]) -> f64 {
    forces
        .map(|force| force.norm())
        .into_iter()
        .fold(0.0, f64::max)
}

/// Change of the forces on the ends of a line as they move to another placement \[N\].
fn pulled(line: &Line, index: usize, rest: &SystemEquilibrium, to: &Placement) -> [V3; 2] {
    let step = [line.from, line.to].map(|point| to.points[point] - rest.placement.points[point]);
    let by_ends = &rest.balance.lines[index].by_ends;
    [0, 1].map(|end| by_ends[end][0] * step[0] + by_ends[end][1] * step[1])
}

/// Where the system would be if the forces that its search left out of balance were balanced: a Newton step further. The placement
/// itself where its stiffness is singular.
fn balanced(network: &Network, rest: &SystemEquilibrium) -> Placement {
    let bed = network.bed.as_ref();
    let lying = on_slope(bed, (&rest.freedoms, &rest.placement), &rest.contacts);
    let mut force = rest.balance.force.clone();
    force_along(&lying, &mut force);
    let mut stiffness = rest.balance.stiffness.clone();
    stiffness_along(bed, &lying, &rest.balance.force, &mut stiffness);
    let held: Vec<bool> = rest.contacts.iter().map(|c| *c != Contact::None).collect();
    stiffness.hold(&held, 1.0);
    for (force, held) in force.iter_mut().zip(&held) {
        if *held {
            *force = 0.0;
        }
    }
    let step = stiffness.solve(std::slice::from_ref(&force));
    let step = step.and_then(|mut steps| steps.pop());
    let finite = |step: &DVector<f64>| step.iter().all(|part| part.is_finite());
    match step.filter(finite) {
        Some(step) => rest.placement.moved(network, &rest.freedoms, &step),
        None => rest.placement.clone(),
    }
}
