//! Loads of the water that moves past a member, by Morison's equation (Morison et al. 1950; DNV-RP-C205 2019, section 6.2).

use std::f64::consts::PI;

use num_dual::DualNum;

use super::super::load_sum::LoadSum;
use super::super::moving_pose::{Dual, DualVector, MovingPose, near};
use super::placed::Placed;
use crate::physics::sea::WaterMotion;
use crate::system::network::{Member, Network};

/// Drag by the velocity of the water relative to the member: across it on its part below the surface, and along it on its ends there.
pub(in crate::system) fn drag(
    network: &Network,
    member: &Member,
    pose: &MovingPose<'_>,
    placed: &Placed<'_>,
    sum: &mut LoadSum,
) {
    let half = 0.5 * network.density;
    if member.drag > 0.0 {
        for slice in placed.wet_slices() {
            let waves = placed.waves_at_slice(slice.number);
            let velocity = relative_velocity(network, pose, (&slice.arm, slice.height), waves);
            let across = velocity - placed.axis * velocity.dot(&placed.axis);
            let speed2 = across.dot(&across);
            if speed2.re == 0.0 {
                continue;
            }
            let area = slice.radius * slice.long * (2.0 * member.drag);
            sum.add(&slice.arm, &(across * (area * speed2.sqrt() * half)));
        }
    }
    for end in placed.wet_ends() {
        let velocity = relative_velocity(network, pose, (&end.arm, end.height), end.waves);
        let along = velocity.dot(&placed.axis);
        let force = along * along * along.re.signum() * end.drag_area * half;
        sum.add(&end.arm, &(placed.axis * force));
    }
}

/// Velocity of the water relative to a place of the body, at an arm from its origin and a height above the surface \[m/s\].
fn relative_velocity(
    network: &Network,
    pose: &MovingPose<'_>,
    (arm, height): (&DualVector, Dual),
    waves: Option<&WaterMotion>,
) -> DualVector {
    // The profile rises and falls with the surface.
    let mut at = pose.place(arm);
    at.z = height;
    let here = at.map(|part| part.re);
    let current = network.current.as_ref();
    let (water, gradient) = current.map_or_else(Default::default, |current| current.flow(&here));
    let mut velocity = near((&water, &gradient), &here, &at) - pose.velocity_at(arm);
    if let Some(flow) = waves {
        velocity += near(
            (&flow.velocity, &flow.gradient),
            &flow.place,
            &pose.place(arm),
        );
    }
    velocity
}

/// Load of the acceleration of the water on the part of a member below the surface: the pressure of the undisturbed wave in all directions,
/// and the added mass across the member and along it at its ends. With the buoyancy up to the surface of the wave, which counts its pressure at
/// still water as that at rest, the pressure on the ends is complete.
pub(in crate::system) fn wave_inertia(
    network: &Network,
    member: &Member,
    pose: &MovingPose<'_>,
    placed: &Placed<'_>,
    sum: &mut LoadSum,
) {
    if placed.waves.is_empty() {
        return;
    }
    for slice in placed.wet_slices() {
        let Some(flow) = placed.waves_at_slice(slice.number) else {
            continue;
        };
        let water = acceleration(flow, &pose.place(&slice.arm));
        let across = water - placed.axis * water.dot(&placed.axis);
        let mass = slice.radius * slice.radius * slice.long * (PI * network.density);
        let both = water + across * Dual::from_re(member.added_mass);
        sum.add(&slice.arm, &(both * mass));
    }
    for end in placed.wet_ends() {
        let Some(flow) = end.waves else { continue };
        let along = acceleration(flow, &pose.place(&end.arm)).dot(&placed.axis);
        let mass = end.added_volume * network.density;
        sum.add(&end.arm, &(placed.axis * (along * mass)));
    }
}

/// Acceleration of the water near a station \[m/s²\].
fn acceleration(flow: &WaterMotion, place: &DualVector) -> DualVector {
    let known = (&flow.acceleration, &flow.acceleration_gradient);
    near(known, &flow.place, place)
}
