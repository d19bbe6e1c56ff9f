//! The forces on a free point in motion, lines apart, and their derivatives.

use crate::numerics::{M3, V3};
use crate::physics::bed_friction::{Friction, FrictionContact, FrictionModel};
use crate::physics::bed_reaction::BedReaction;
use crate::physics::sea::WaterMotion;
use crate::physics::seabed::{curved_contact, push_slopes};
use crate::physics::{CurrentProfile, FrictionAnchor};
use crate::solve::{BodyOnBed, Factors};
use crate::system::bed::Bed;
use crate::system::immersion::Immersion;
use crate::system::network::{FreePoint, Network};

/// A force and its derivatives.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct PointLoad {
    /// The force \[N\].
    pub(super) force: V3,
    /// By position \[N/m\].
    pub(super) by_position: M3,
    /// By velocity \[N s/m\].
    pub(super) by_velocity: M3,
    /// Power that it loses \[W\].
    pub(super) lost: f64,
    /// Its potential energy \[J\], steady loads included.
    pub(super) energy: f64,
    /// Its mass along x, y, z, with the added mass of what of it is under water \[kg\].
    pub(super) mass: V3,
    /// Derivative of that mass by position \[kg/m\].
    pub(super) mass_by_position: M3,
}

impl PointLoad {
    /// What its inertia at an acceleration \[m/s²\] is beyond the force \[N\], and its change with the acceleration, the velocity and the position by these factors.
    pub(super) fn residual(&self, acceleration: &V3, c: Factors) -> (V3, M3) {
        let by_position =
            M3::from_diagonal(acceleration) * self.mass_by_position - self.by_position;
        let tangent = M3::from_diagonal(&(self.mass * c.mass)) - self.by_velocity * c.damping
            + by_position * c.stiffness;
        (acceleration.component_mul(&self.mass) - self.force, tangent)
    }

    /// Its kinetic energy at a velocity \[J\]. What is beyond the mass along x is exactly 0 where all are the same.
    pub(super) fn kinetic_energy(&self, v: &V3) -> f64 {
        let beyond = self.mass.add_scalar(-self.mass.x);
        0.5 * self.mass.x * v.norm_squared() + 0.5 * v.dot(&beyond.component_mul(v))
    }
}

/// The surface over a point.
struct SurfaceOverPoint {
    /// Share of its volume under water.
    share: f64,
    /// Derivative of the share by place \[1/m\].
    by_place: V3,
}

/// What surrounds a point: waves, where there are any, and what holds it to the bed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Around<'a> {
    pub(super) waves: Option<&'a WaterMotion>,
    pub(super) hold: BedHold<'a>,
}

/// What holds a point to the bed by what happened before.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct BedHold<'a> {
    /// The anchor about which friction acts, where it does.
    pub grip: Option<&'a FrictionAnchor>,
    /// Whether suction holds it.
    pub stuck: bool,
}

/// What holds all that bears on the bed.
#[derive(Debug, Clone, Copy, Default)]
pub struct BedHolds<'a> {
    /// Anchors of friction, one a joint; none where there is none.
    pub grips: &'a [FrictionAnchor],
    /// Histories of what bears.
    pub bodies: &'a [BodyOnBed],
    /// Their numbers by the joint.
    pub numbers: &'a [Option<usize>],
}

impl<'a> BedHolds<'a> {
    /// At a joint.
    pub(super) fn at(&self, joint: usize) -> BedHold<'a> {
        let number = self.numbers.get(joint).copied().flatten();
        let body = number.and_then(|number| self.bodies.get(number));
        BedHold {
            grip: self.grips.get(joint),
            stuck: body.is_some_and(|body| body.stuck),
        }
    }
}

/// The load on a point at a place and with a velocity.
pub(super) fn point_load(
    network: &Network,
    point: &FreePoint,
    (x, v): (&V3, &V3),
    Around { waves, hold }: Around<'_>,
) -> PointLoad {
    let mut load = PointLoad::default();
    let surface = waves.map_or(0.0, |flow| flow.elevation_at(x));
    let slope = waves.map_or_else(V3::zeros, |flow| flow.slope);
    let Immersion {
        share,
        by_height,
        integral,
    } = Immersion::of_point(network, point, x.z - surface);
    let immersion = SurfaceOverPoint {
        share,
        by_place: (V3::z() - slope) * by_height,
    };
    load.mass = point.mass(share);
    load.mass_by_position = point.added_mass * immersion.by_place.transpose();
    let rising = waves.map_or(0.0, |flow| by_height * flow.elevation_rate);
    // Added mass that comes under water at a velocity takes up energy that no force gives.
    let growth = immersion.by_place.dot(v) - rising;
    load.lost -= 0.5 * growth * v.dot(&point.added_mass.component_mul(v));
    load.force = point.load + V3::z() * (point.buoyancy * share - point.weight);
    load.by_position += V3::z() * immersion.by_place.transpose() * point.buoyancy;
    load.energy = point.weight * x.z - point.buoyancy * integral - point.load.dot(x);
    drag(network, point, (x, v), waves, &immersion, &mut load);
    bed(network, point, (&point.bottom(x), v), hold, &mut load);
    if let Some(flow) = waves {
        // What the rising surface lifts is put in by the waves.
        load.lost -= point.buoyancy * share * (flow.elevation_rate + slope.dot(v));
        wave_inertia(network, point, (x, v), flow, &immersion, &mut load);
    }
    load
}

/// Load of the acceleration of the water on displaced and added mass, as far as the point is under water (Morison et al. 1950).
fn wave_inertia(
    network: &Network,
    point: &FreePoint,
    (x, v): (&V3, &V3),
    flow: &WaterMotion,
    immersion: &SurfaceOverPoint,
    load: &mut PointLoad,
) {
    let displaced = if network.gravity > 0.0 {
        point.buoyancy / network.gravity
    } else {
        0.0
    };
    let mass = point.added_mass.add_scalar(displaced);
    let water = flow.acceleration_at(x);
    let wet = mass * immersion.share;
    let force = water.component_mul(&wet);
    load.force += force;
    load.by_position += M3::from_diagonal(&mass) * (water * immersion.by_place.transpose())
        + M3::from_diagonal(&wet) * flow.acceleration_gradient;
    load.lost -= force.dot(v);
}

/// Drag by the velocity of the water relative to the point, as far as it is under water.
fn drag(
    network: &Network,
    point: &FreePoint,
    (x, v): (&V3, &V3),
    waves: Option<&WaterMotion>,
    immersion: &SurfaceOverPoint,
    load: &mut PointLoad,
) {
    if point.drag_area == V3::zeros() || immersion.share == 0.0 {
        return;
    }
    let current = network.current.as_ref();
    let (water, mut gradient) =
        current.map_or_else(Default::default, |current: &CurrentProfile| current.flow(x));
    let mut u = water - v;
    if let Some(flow) = waves {
        u += flow.velocity_at(x);
        gradient += flow.gradient;
    }
    let (whole, by_flow) = point.drag(network.density, &u, immersion.share);
    let force = whole * immersion.share;
    load.force += force;
    load.by_velocity -= by_flow;
    load.by_position += by_flow * gradient + whole * immersion.by_place.transpose();
    load.lost -= force.dot(v);
}

/// The fastest motion of a point with this mass \[kg\] on the bed \[rad/s\]: as an oscillator on twice the spring, which the push has as it
/// lands, with the damper, `omega (zeta + sqrt(zeta^2 + 1))`.
pub(super) fn fastest_on_bed(point: &FreePoint, mass: f64) -> f64 {
    let (stiffness, damping) = point.bed_springs();
    let suction = point.suction.map_or(0.0, |suction| suction.stiffness());
    let stiffness = stiffness.max(point.grip_springs().0).max(suction);
    let omega = (2.0 * stiffness / mass).sqrt();
    let zeta = 0.5 * damping / (mass * omega);
    omega * (zeta + (zeta * zeta + 1.0).sqrt())
}

/// Whether a point bears on the bed by itself.
pub(super) fn bears(point: &FreePoint) -> bool {
    point.bed_springs().0 > 0.0
}

/// Normal force of the bed on a point by its bottom \[N\], negative where suction holds it.
pub(super) fn normal_force(
    network: &Network,
    point: &FreePoint,
    at: (&V3, &V3),
    hold: BedHold<'_>,
) -> f64 {
    let bed = network.bed.as_ref();
    let held = bed.and_then(|bed| Some((bed, point.held_by_bed(bed, at, hold.stuck)?)));
    held.map_or(0.0, |(bed, held)| held.force * bed.gradient(at.0).norm())
}

/// The load of the bed on the bottom alone.
pub(super) fn bed_load(
    network: &Network,
    point: &FreePoint,
    at: (&V3, &V3),
    hold: BedHold<'_>,
) -> PointLoad {
    let mut load = PointLoad::default();
    bed(network, point, at, hold, &mut load);
    load
}

/// The bed under the bottom of a point, with friction about its anchor.
fn bed(
    network: &Network,
    point: &FreePoint,
    (x, v): (&V3, &V3),
    hold: BedHold<'_>,
    load: &mut PointLoad,
) {
    let Some(bed) = &network.bed else { return };
    let Some(held) = point.held_by_bed(bed, (x, v), hold.stuck) else {
        return;
    };
    let depth = (-bed.height(x)).max(0.0);
    let elastic = point.bed_springs().0 * depth;
    load.energy += 0.5 * elastic * depth;
    let gradient = bed.gradient(x);
    let [by_position, by_velocity] = push_slopes(&gradient, bed.curvature(x).as_ref(), v, &held);
    load.force += gradient * held.force;
    load.by_position += by_position;
    load.by_velocity += by_velocity;
    load.lost += (elastic - held.force) * gradient.dot(v);
    // Suction holds what is off the bed, and friction what is on it.
    let push = held;
    let rough = hold.grip.filter(|_| point.friction > 0.0 && depth > 0.0);
    if let Some(grip) = rough {
        let normal = gradient.normalize();
        let contact = contact(bed, &normal, &push, (x, v));
        let held = match point.slip_speed {
            Some(_) => friction(point).with_tangent(&contact, None),
            None => Some(friction(point).grip(&contact, grip)),
        };
        let Some(held) = held else { return };
        load.force += held.force;
        load.by_position += held.by_position;
        load.by_velocity += held.by_velocity;
        load.lost -= held.force.dot(v);
    }
}

fn friction(point: &FreePoint) -> Friction {
    Friction {
        axial: point.friction,
        lateral: point.friction,
        law: match point.slip_speed {
            Some(speed) => FrictionModel::Regularised(speed),
            None => FrictionModel::ElasticPlastic(0.0),
        },
    }
}

/// A contact with the bed, by its unit normal.
fn contact<'a>(
    bed: &Bed,
    normal: &'a V3,
    push: &'a BedReaction,
    (x, v): (&'a V3, &'a V3),
) -> FrictionContact<'a> {
    let curvature = bed.curvature(x);
    FrictionContact {
        normal,
        push,
        x,
        v,
        curved: curvature.map(|by_place| curved_contact(&bed.gradient(x), &by_place, v, push)),
    }
}

/// An anchor without force where a point is.
pub(super) fn anchor(point: &FreePoint, x: &V3) -> FrictionAnchor {
    let (stiffness, damping) = point.grip_springs();
    FrictionAnchor {
        at: *x,
        along: V3::x(),
        stiffness,
        damping,
        laid: false,
        slip: 0.0,
    }
}

/// The anchor after an accepted step: dragged along where the point slides, beneath it where it is off the bed.
pub(super) fn drag_anchor(
    network: &Network,
    point: &FreePoint,
    (x, v): (&V3, &V3),
    grip: &mut FrictionAnchor,
) {
    // Nothing holds a point without weight or mass.
    let slides = point.slip_speed.is_none() && grip.stiffness > 0.0;
    let Some(bed) = network.bed.as_ref().filter(|_| slides) else {
        return;
    };
    let (push, normal) = (point.push_of_bed(bed, (x, v)), bed.gradient(x).normalize());
    let hold = (grip.stiffness, grip.damping);
    let contact = contact(bed, &normal, &push, (x, v));
    *grip = friction(point).slide_grip(&contact, grip, hold, &V3::x());
}

/// The acceleration at which the bed stops a point that a step brought onto it unseen: off the bed where the forces balanced, below it
/// at the end \[m/s²\].
pub(super) fn landing_acceleration(
    network: &Network,
    point: &FreePoint,
    between: &V3,
    end: &V3,
) -> f64 {
    let Some(bed) = network
        .bed
        .as_ref()
        .filter(|bed| bed.height(between) >= 0.0 && bed.height(end) < 0.0)
    else {
        return 0.0;
    };
    -point.bed_springs().0 * bed.height(end) / point.moving_mass.z.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;
    use crate::numerics::{DepthGrid, DepthInterpolation};
    use crate::physics::{BodyProperties, Suction};
    use crate::scene::current_profile;
    use crate::system::point_on_bed::BearingArea;
    use std::sync::Arc;

    /// Waves as a point knows them, with derivatives of any size.
    fn waves(random: &mut Random) -> WaterMotion {
        let mut number = || random.uniform() - 0.5;
        let mut vector = || V3::new(number(), number(), number());
        WaterMotion {
            place: vector() + V3::new(1.0, 2.0, 0.0),
            velocity: vector() * 2.0,
            gradient: M3::from_columns(&[vector(), vector(), vector()]) * 0.2,
            acceleration: vector(),
            acceleration_gradient: M3::from_columns(&[vector(), vector(), vector()]) * 0.2,
            jerk: vector(),
            elevation: 0.3,
            slope: V3::new(0.2, -0.1, 0.0),
            elevation_rate: 0.4,
        }
    }

    /// A clump with added mass and a drag area that are the same along all axes, the same with others along each, one with an area, and one that suction holds.
    fn clumps() -> [FreePoint; 4] {
        let one = FreePoint {
            weight: 5e3,
            buoyancy: 9e3,
            moving_mass: V3::repeat(800.0),
            added_mass: V3::repeat(300.0),
            drag_area: V3::repeat(1.3),
            load: V3::new(10.0, -20.0, 30.0),
            ..FreePoint::default()
        };
        let other = FreePoint {
            moving_mass: V3::new(700.0, 800.0, 1000.0),
            added_mass: V3::new(200.0, 300.0, 500.0),
            drag_area: V3::new(0.4, 1.3, 2.1),
            ..one
        };
        let on_area = FreePoint {
            below: 1.5,
            bearing: Some(BearingArea {
                area: 2.0,
                stiffness: 3e5,
                damping: 2e3,
                grip: 1e5,
            }),
            ..one
        };
        let held_back = FreePoint {
            suction: Some(Suction {
                greatest: 4e3,
                distance: 0.3,
            }),
            ..on_area
        };
        [one, other, on_area, held_back]
    }

    #[test]
    fn derivatives_are_those_of_the_force() {
        for clump in clumps() {
            check_derivatives(Bed::Level(-50.0), clump, 0.4);
        }
    }

    #[test]
    fn equal_areas_have_the_drag_of_one_area() {
        let [one, ..] = clumps();
        let law = BodyProperties {
            mass: 0.0,
            weight: 0.0,
            drag: one.drag_area * (0.5 * 1025.0),
            added: V3::zeros(),
            aligned: None,
        };
        let u = V3::new(0.4, -0.9, 0.3);
        let (force, by_flow) = one.drag(1025.0, &u, 1.0);
        assert!((force - law.drag(&u)).norm() < 1e-12 * force.norm());
        assert!((by_flow - law.drag_by_velocity(&u)).norm() < 1e-12 * by_flow.norm());
    }

    #[test]
    fn derivatives_over_hills_are_those_of_the_force() {
        let axis: Vec<f64> = (-6..=6).map(|k| 2.5 * f64::from(k)).collect();
        let pairs = axis.iter().flat_map(|x| axis.iter().map(move |y| (*x, *y)));
        let hills = pairs.map(|(x, y)| 3.0 * (0.2 * x).sin() * (0.3 * y).cos() - 0.1 * x);
        let at_point = |depth: &[f64]| {
            let grid = DepthGrid::new(
                axis.clone(),
                axis.clone(),
                depth.to_vec(),
                DepthInterpolation::Smooth,
            );
            grid.unwrap()
        };
        let hills: Vec<f64> = hills.collect();
        // 50 m below the point that is checked.
        let up = at_point(&hills).at(1.0, 2.0).depth;
        let hills: Vec<f64> = hills.iter().map(|depth| depth - up + 50.0).collect();
        for (friction, slip_speed) in [(0.0, None), (0.4, None), (0.4, Some(0.5))] {
            let [clump, _, on_area, held_back] = clumps().map(|point| FreePoint {
                slip_speed,
                ..point
            });
            for point in [clump, on_area, held_back] {
                check_derivatives(Bed::Grid(Arc::new(at_point(&hills))), point, friction);
            }
        }
    }

    fn check_derivatives(bed: Bed, clump: FreePoint, friction: f64) {
        let network = Network {
            gravity: 9.81,
            density: 1025.0,
            bed: Some(bed),
            current: Some(current_profile(None, &std::collections::BTreeMap::new())),
            ..Network::default()
        };
        let point = FreePoint { friction, ..clump };
        let v = V3::new(0.4, -0.9, 0.3);
        let flow = waves(&mut Random::new(1, 0));
        // About an anchor that holds, one that is dragged, and none.
        let anchors = [0.0, 1e-4, 0.3].map(|off| {
            let place = V3::new(1.0 - off, 2.0 + off, 0.0);
            let mut anchor = anchor(&point, &place);
            anchor.damping *= if off < 0.2 { 1e-4 } else { 1.0 };
            anchor
        });
        let grips = [
            None,
            Some(&anchors[0]),
            Some(&anchors[1]),
            Some(&anchors[2]),
        ];
        for (waves, grip) in grips
            .map(|grip| (None, grip))
            .into_iter()
            .chain([(Some(&flow), None)])
        {
            for z in [
                -50.1, -50.005, -50.0004, -49.93, -49.76, -20.0, -0.4, 0.2, 5.0,
            ] {
                let x = V3::new(1.0, 2.0, z + point.below);
                let hold = BedHold {
                    grip,
                    stuck: point.suction.is_some(),
                };
                let around = Around { waves, hold };
                let load = point_load(&network, &point, (&x, &v), around);
                let h = 1e-6;
                for k in 0..3 {
                    let step = V3::ith(k, h);
                    let at = |x: V3, v: V3| point_load(&network, &point, (&x, &v), around);
                    let (ahead, behind) = (at(x + step, v), at(x - step, v));
                    let by_x = (ahead.force - behind.force) / (2.0 * h);
                    let by_place = (ahead.mass - behind.mass) / (2.0 * h);
                    let slope = by_place - load.mass_by_position.column(k);
                    assert!(slope.norm() < 1e-4 * (1.0 + by_place.norm()), "{z} {k}");
                    let by_v = (at(x, v + step).force - at(x, v - step).force) / (2.0 * h);
                    assert!(
                        (by_x - load.by_position.column(k)).norm() < 1e-4 * (1.0 + by_x.norm())
                    );
                    assert!(
                        (by_v - load.by_velocity.column(k)).norm() < 1e-4 * (1.0 + by_v.norm())
                    );
                    let is_held = hold.stuck && z > -50.0;
                    if waves.is_none() && grip.is_none() && !is_held {
                        let still = at(x, V3::zeros()).force[k];
                        let slope = (ahead.energy - behind.energy) / (2.0 * h);
                        assert!(
                            (slope + still).abs() < 1e-3 * (1.0 + still.abs()),
                            "{z} {k}"
                        );
                    }
                }
            }
        }
    }
}
