//! The bed under the ends of a member.

use super::super::load_sum::LoadSum;
use super::super::moving_pose::{MovingPose, constant, near};
use crate::numerics::{M3, V3};
use crate::system::network::{Body, Member, Network};

/// The bed under the ends of a member, each a ball of its radius whose lowest point bears on it: a spring that gives way by a millimetre
/// under the body's weight and pushes along the normal of the bed. Over a slope the height of that point is measured vertically.
pub(in crate::system) fn bed(
    network: &Network,
    body: &Body,
    member: &Member,
    pose: &MovingPose<'_>,
    sum: &mut LoadSum,
) {
    let Some(bed) = &network.bed else { return };
    let spring = body.weight.max(1.0) / GIVES_WAY;
    let ends = [
        (&member.from, member.radius.0),
        (&member.to, member.radius.1),
    ];
    for (end, radius) in ends {
        let arm = pose.arm(end);
        let place = pose.place(&arm);
        let here = place.map(|part| part.re);
        let [x, y] = bed.rise(&here);
        let gradient = V3::new(-x, -y, 1.0);
        let lower = (place - constant(&here)).dot(&constant(&V3::new(gradient.x, gradient.y, 0.0)));
        let above = pose.origin.z + arm.z - (bed.z_below(&here) + radius) + lower;
        if above.re < 0.0 {
            let turned = bed.curvature(&here).unwrap_or_else(M3::zeros);
            let along = near((&gradient, &turned), &here, &place);
            sum.add(&arm, &(along * (above * -spring)));
        }
    }
}

/// How far the bed gives way under the weight of a body in air on one end of a member \[m\].
const GIVES_WAY: f64 = 1e-3;
