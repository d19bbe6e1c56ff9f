//! Members of bodies: round cylinders and cones in the water. Every sum over a member (buoyancy, drag, the load of the water's acceleration,
//! added mass) is that of its part in the water, slice by slice where the surface cuts it ([`wet_part`]); its two flat ends have coefficients
//! of their own ([`ends`]).

mod added_mass;
mod bed;
mod buoyancy;
mod ends;
mod placed;
mod water_loads;
mod wet_part;

use super::moving_pose::MovingPose;
use super::pose::Pose;
use crate::physics::sea::{SeaReader, WaterMotion};
use crate::system::network::Member;

pub(super) use added_mass::added_mass;
pub(super) use bed::bed;
pub(super) use buoyancy::buoyancy;
pub(super) use placed::Placed;
pub(super) use water_loads::{drag, wave_inertia};

/// Stations of a member at which waves are read: its lower end, its upper end, and the slices of its part in the water.
pub(super) const STATIONS: usize = 2 + wet_part::SLICES;

/// Reads the waves of a sea at the stations of a member, places of the sea's reader from the first number.
pub(super) fn read_waves(
    member: &Member,
    pose: &Pose,
    (sea, first): (&mut SeaReader<'_>, usize),
    stations: &mut [WaterMotion],
) {
    let (ends, along) = stations.split_at_mut(2);
    let places = [&member.from, &member.to].map(|end| pose.origin + pose.arm(end));
    let upside_down = places[1].z < places[0].z;
    let [low, high] = match upside_down {
        true => [places[1], places[0]],
        false => places,
    };
    ends[0] = sea.flow(first, &low, true);
    ends[1] = sea.flow(first + 1, &high, true);
    let moving = MovingPose::at_rest(pose);
    let wet = Placed::at_pose(member, &moving, ends).wet_part();
    let mut last: Option<WaterMotion> = None;
    for (number, (station, share)) in (first + 2..).zip(along.iter_mut().zip(wet.shares())) {
        let place = low.lerp(&high, share);
        // All slices of a part without length are at one place.
        let known = last.filter(|known| known.place == place);
        let flow = known.unwrap_or_else(|| sea.flow(number, &place, false));
        *station = flow;
        last = Some(flow);
    }
}
