//! Where the lines that lie on the bed were laid from, by what holds and what pulls their ends.
//!
//! Friction takes tension off along a line that lies on the bed from the end that is pulled towards the one that is held
//! ([`LaidFrom`]). An end at a free point is looked through: lines that go on there, one to the next, are one line, and what counts is what
//! is at the far ends of that.

use super::freedoms::Placement;
use super::network::{Held, Line, Network};
use crate::numerics::V3;
use crate::scene::LaidFrom;

/// How close to the bed an end is that lies on it but for rounding, by the line's length and its depth: as that of an end of a divided line
/// that is held on the bed.
const ON_BED: f64 = 1e-9;

/// Whether an end of a line at this height over the bed \[m\] lies on it; `z` is where it is \[m\].
pub(super) fn end_lies(line: &Line, over_bed: f64, z: f64) -> bool {
    over_bed.abs() <= ON_BED * (line.length() + z.abs())
}

/// The line beyond an end.
struct Beyond {
    /// Whether something holds its far end, or nothing pulls there.
    held: bool,
    /// Its unstretched length \[m\].
    length: f64,
}

/// Where a rough line was laid from; nothing for one that does not lie on the bed with both ends.
#[must_use]
pub(super) fn laid_from(network: &Network, placement: &Placement, line: usize) -> Option<LaidFrom> {
    let own = &network.lines[line];
    if !own.is_rough() || !lies(network, placement, own) {
        return None;
    }
    let [a, b] = [own.from, own.to].map(|point| beyond(network, placement, (point, line)));
    if a.held || b.held {
        return Some(LaidFrom::of_held([a.held, b.held]));
    }
    let whole = a.length + own.length() + b.length;
    let middle = (0.5 * whole - a.length) / own.length();
    Some(LaidFrom::Share(middle.clamp(0.0, 1.0)))
}

/// Whether both ends of a line are on the bed.
fn lies(network: &Network, placement: &Placement, line: &Line) -> bool {
    let Some(bed) = &network.bed else {
        return false;
    };
    let on_bed = |point: usize| {
        let place = &placement.points[point];
        let height = bed.height(place);
        end_lies(line, height, place.z) || (height < 0.0 && network.sinks_into_bed(point))
    };
    on_bed(line.from) && on_bed(line.to)
}

/// What is beyond a point at the end of a line.
fn beyond(network: &Network, placement: &Placement, (point, line): (usize, usize)) -> Beyond {
    let (mut point, mut line, mut length) = (point, line, 0.0);
    // Lines may close a ring.
    for _ in 0..network.lines.len() {
        if is_held(network, point) {
            return Beyond { held: true, length };
        }
        let Held::Free(free) = &network.points[point].held else {
            break;
        };
        let pulled = free.load.xy() != V3::zeros().xy()
            || (free.drag_area != V3::zeros() && network.flows());
        let others = network.lines.iter().enumerate();
        let mut others =
            others.filter(|(other, at)| *other != line && (at.from == point || at.to == point));
        match (others.next(), others.next()) {
            (None, _) => {
                return Beyond {
                    held: !pulled,
                    length,
                };
            }
            (Some((next, other)), None) if lies(network, placement, other) => {
                length += other.length();
                point = if other.from == point {
                    other.to
                } else {
                    other.from
                };
                line = next;
            }
            _ => break,
        }
    }
    Beyond {
        held: false,
        length,
    }
}

/// Whether a point stays where it is.
fn is_held(network: &Network, point: usize) -> bool {
    let point = &network.points[point];
    match &point.held {
        Held::At(_) => point.motion.is_none(),
        Held::On(body, _) => {
            let body = &network.bodies[*body];
            !body.turns() && body.motion.is_none()
        }
        Held::Free(_) => false,
    }
}
