//! Which lines may come to lie on the bed.

use crate::system::bed::Bed;
use crate::system::network::{Held, Line, Network, ReleaseCondition};

/// By how much a line may stretch, and what moves may come down, by the depth.
const STRETCH: f64 = 0.1;
const HEAVE: f64 = 0.1;

/// Whether a line may come to lie on the bed: that bears it, and it hangs down to there with both ends above one place as low as their
/// motions take them, or what holds its ends or its length may change.
pub(super) fn may_reach(network: &Network, number: usize) -> bool {
    let line = &network.lines[number];
    let Some(bed) = network.bed.as_ref().filter(|_| line.bed_contact) else {
        return false;
    };
    let ends = [line.from, line.to].map(|point| height(network, point));
    match (ends, bed) {
        ([Some(a), Some(b)], Bed::Level(bed)) if !changes(network, number, line) => {
            let lowest = 0.5 * (a + b - line.length() * (1.0 + STRETCH));
            lowest <= bed + HEAVE * bed.abs()
        }
        _ => true,
    }
}

/// Whether an end of a line is let go at some time, or it is paid out.
fn changes(network: &Network, number: usize, line: &Line) -> bool {
    let mut paid = network.payouts.iter().flat_map(|payout| &payout.ends);
    line.releases.iter().any(ReleaseCondition::is_given) || paid.any(|end| end.line == number)
}

/// Height of a point as low as its prescribed motion takes it \[m\]; nothing where only lines hold it, or a body that is moved.
fn height(network: &Network, point: usize) -> Option<f64> {
    let point = &network.points[point];
    match &point.held {
        Held::At(place) => {
            let motion = point.motion.as_ref();
            let far = motion.map_or(0.0, |motion| motion.scale().0);
            Some(place.z - far)
        }
        Held::On(body, at) => {
            let body = &network.bodies[*body];
            let place = body.pose.origin + body.pose.arm(at);
            body.motion.is_none().then_some(place.z)
        }
        Held::Free(_) => None,
    }
}
