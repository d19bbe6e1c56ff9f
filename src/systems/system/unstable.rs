//! Leaving an equilibrium that is unstable: a float that is top-heavy rests upright as long as nothing touches it.
//!
//! A search that begins in symmetry stays in it, and ends where the symmetric forces balance. From there the bodies are turned a little along the
//! motion that the stiffness does not resist, and the search goes on downhill. Of motions that are resisted alike, as roll and pitch of a round
//! float, that one is taken which is nearest to a turn fixed in the bodies: the answer turns with the system.

use nalgebra::DVector;

use super::equilibrium::{SystemEquilibrium, search, search_downhill};
use super::network::{Line, Network};
use super::stability::unstable_motion;
use crate::numerics::V3;

/// Turn by which an unstable equilibrium is left \[rad\].
const TURN: f64 = 0.02;
/// Times that this is done: a float may lie down along one axis, then roll about the other.
const TIMES: usize = 4;
/// Turns \[rad\] and shares of the greatest length within which two equilibria are the same.
const SAME: f64 = 1e-5;

/// What lies off an equilibrium.
enum Departure {
    /// It is not unstable.
    None,
    /// It is unstable, and searches from beside it find no other.
    Nowhere,
    /// It is unstable, and the system comes to this one.
    To(Box<SystemEquilibrium>),
}

/// The equilibrium that a system comes to when it is let go near one that is unstable; that one where it comes to none that is not.
#[must_use]
pub(super) fn leave(network: &Network, found: SystemEquilibrium) -> SystemEquilibrium {
    let mut here = match departure(network, &found) {
        Departure::To(next) => *next,
        Departure::None | Departure::Nowhere => return found,
    };
    for _ in 1..TIMES {
        match departure(network, &here) {
            Departure::None => {
                here.left = Some(Box::new(found));
                return here;
            }
            Departure::Nowhere => break,
            Departure::To(next) => here = *next,
        }
    }
    found
}

/// Where a system goes from an equilibrium.
fn departure(network: &Network, rest: &SystemEquilibrium) -> Departure {
    let Some(motion) = unstable_motion(network, rest, &turns(network, rest)) else {
        return Departure::None;
    };
    let is_another = |next: &SystemEquilibrium| !is_same(network, rest, next);
    let next = [TURN, -TURN].into_iter().find_map(|turn| {
        let step = &motion * turn;
        let from = rest.placement.moved(network, &rest.freedoms, &step);
        let next = search(network, &from).ok().filter(is_another);
        // Currents turn a body in a way that the energy of the first search knows nothing of.
        next.or_else(|| search_downhill(network, &from).ok().filter(is_another))
    });
    next.map_or(Departure::Nowhere, |next| {
        Departure::To(Box::new(SystemEquilibrium {
            steps: rest.steps + next.steps,
            evaluations: rest.evaluations + next.evaluations,
            work: rest.work + next.work,
            ..next
        }))
    })
}

/// A turn of each body, fixed in its own axes and of another size than those of the others: pitch, and enough of the two others where that is
/// resisted.
fn turns(network: &Network, rest: &SystemEquilibrium) -> DVector<f64> {
    let mut towards = DVector::zeros(rest.freedoms.count);
    let bodies = rest.freedoms.bodies.iter().zip(&rest.placement.bodies);
    for (number, (first, pose)) in bodies.enumerate() {
        let Some(first) = first else { continue };
        // A rod does not spin.
        let own = match network.bodies[number].spins_about {
            Some(_) => V3::new(0.0, 1.0, 1e-3),
            None => V3::new(1e-3, 1.0, 1e-4),
        };
        let size = 1.0 / (1.0 + 0.3 * number as f64);
        towards
            .rows_mut(first + 3, 3)
            .copy_from(&(pose.arm(&own) * size));
    }
    towards
}

/// Whether two equilibria are one, spins of rods left out.
pub(super) fn is_same(network: &Network, one: &SystemEquilibrium, two: &SystemEquilibrium) -> bool {
    let (one, two) = (&one.placement, &two.placement);
    let size = network.lines.iter().map(Line::length);
    let near = SAME * size.fold(1.0, f64::max);
    let points = one.points.iter().zip(&two.points);
    let bodies = one.bodies.iter().zip(&two.bodies).zip(&network.bodies);
    points.into_iter().all(|(a, b)| (a - b).norm() <= near)
        && bodies.into_iter().all(|((a, b), body)| {
            let turned = match &body.spins_about {
                Some(axis) => (a.arm(axis) - b.arm(axis)).norm(),
                None => a.rotation.angle_to(&b.rotation),
            };
            turned <= SAME && (a.origin - b.origin).norm() <= near
        })
}
