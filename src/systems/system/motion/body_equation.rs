//! The equation of motion of a free body, lines apart: Newton and Euler about its origin, with added mass by Kirchhoff's equations,
//! loads, damping and bed.
//!
//! With u and w the velocity of the origin and the angular velocity along the axes of the body, and M the mass matrix about the
//! origin, added mass included,
//!
//! ```text
//! (P, L) = M (u, w)      force = P' + w x P      moment = L' + w x L + u x P
//! ```
//!
//! (Fossen 2011, sec. 6.3). All is written once, for dual numbers in the six unknowns of a step: the tangent is exact.
//!
//! The second term of either is of second order. Where potential flow or responses give the loads of waves to first order, and their
//! mean drift apart, or coefficients of the current have the moment that turns the body across it, added mass acts to first order too:
//! along the axes at the pose given, by accelerations alone, and damping along these axes turned to the heading of the body. A part of
//! the second order without the rest is a drift that no body has.

use nalgebra::{Matrix6, Rotation3, UnitQuaternion, Vector6};

use super::super::body_in_flow::{self, BodyRates, Momentum, product};
use super::super::load_sum::LoadSum;
use super::super::moving_pose::{Dual, MovingPose, constant, unknown};
use super::body_damping::{damp, is_linear};
use super::flow_load::FlowLoad;
use super::foot::Foot;
use super::point_loads::BedHolds;
use super::pose_motion::BodyMotion;
use crate::numerics::{M3, V3};
use crate::physics::sea::WaterMotion;
use crate::solve::Factors;
use crate::system::body_loads::{add_loads_by_pose, fixed_loads};
use crate::system::members;
use crate::system::network::{Body, Network};
use crate::system::pose::{Pose, cross};

/// The water around a body, and the bed under it.
#[derive(Debug, Clone, Copy, Default)]
pub struct BodyWater<'a> {
    /// Waves at its stations; empty in still water.
    pub waves: &'a [WaterMotion],
    /// Loads of potential flow, if it has coefficients.
    pub flow: Option<&'a FlowLoad>,
    /// What of it bears on the bed.
    pub feet: &'a [Foot],
    /// What holds that to it.
    pub holds: BedHolds<'a>,
}

/// A body in the equation of motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MovingBody {
    /// Which body of the network.
    pub number: usize,
    /// Mass matrix about the origin, along the axes of the body, added mass included \[kg, kg m, kg m²\].
    pub mass: Matrix6<f64>,
    /// Of it what acts to first order alone, and the same along the earth's axes at the pose given.
    linear: [Matrix6<f64>; 2],
    /// Of it the added mass that feels the flow by itself.
    in_flow: Matrix6<f64>,
}

impl MovingBody {
    /// A body; its members have the added mass that they have at the pose given.
    #[must_use]
    pub fn new(network: &Network, number: usize, pose: &Pose) -> Self {
        let body = &network.bodies[number];
        let by_members = members::added_mass(network, body, pose);
        let mut mass = body.added_mass + turned(&by_members, &pose.matrix().inverse());
        mass += rigid(body);
        let linear = match is_linear(body) {
            true => [
                body.added_mass,
                turned(&body.added_mass, &body.pose.matrix()),
            ],
            false => [Matrix6::zeros(); 2],
        };
        let in_flow = match body.centre_of_added_mass {
            Some(_) => body.added_mass,
            None => Matrix6::zeros(),
        };
        Self {
            number,
            mass,
            linear,
            in_flow,
        }
    }

    /// The same body without inertia: of its residual loads are left, those of the flow on its added mass by velocities too.
    #[must_use]
    pub fn massless(&self) -> Self {
        Self {
            in_flow: Matrix6::zeros(),
            ..self.loads_beside_inertia()
        }
    }

    /// The same body, of whose residual the loads are left that act beside its inertia in still water.
    #[must_use]
    pub fn loads_beside_inertia(&self) -> Self {
        Self {
            mass: Matrix6::zeros(),
            linear: [Matrix6::zeros(); 2],
            ..self.clone()
        }
    }

    /// The residual, inertia less loads: force \[N\] and moment about the origin \[N m\] in the earth's directions, and its
    /// derivative by displacement of the origin and by the rotation vector along the axes of the body. `jacobian` turns changes of that
    /// vector into turns in the earth's directions.
    #[must_use]
    pub fn residual(
        &self,
        network: &Network,
        motion: &BodyMotion,
        around: &BodyWater<'_>,
        jacobian: &M3,
        c: Factors,
    ) -> (Vector6<f64>, Matrix6<f64>) {
        let body = &network.bodies[self.number];
        let one = M3::identity();
        let (k, damping, mass) = (c.stiffness, one * c.damping, one * c.mass);
        let rotation = motion.pose.matrix();
        let turn = unknown(&V3::zeros(), 3, &(jacobian * k));
        let velocity = unknown(&motion.velocity, 0, &damping);
        let acceleration = unknown(&motion.acceleration, 0, &mass);
        let spin = unknown(&motion.spin, 3, &damping);
        let spin_rate = unknown(&motion.spin_rate, 3, &mass);
        let still = rotation.matrix().map(Dual::from_re) * spin;
        let moving = MovingPose::moving(
            &motion.pose,
            unknown(&motion.pose.origin, 0, &(one * k)),
            turn,
            (velocity, still + turn.cross(&still)),
        )
        .in_waves(around.waves);
        let mut sum = LoadSum::none();
        let rates = BodyRates {
            acceleration,
            spin,
            spin_rate,
        };
        self.inertia(&moving, &rates, &mut sum);
        add_loads_by_pose(network, body, &moving, true, &mut sum);
        let given = (body, &self.in_flow);
        body_in_flow::add(network, given, &moving, true, &rates, &mut sum);
        damp(body, around.flow, &moving, &spin, &mut sum);
        for foot in around.feet {
            foot.bear(network, &moving, around.holds.at(foot.joint), &mut sum);
        }
        let (force, tangent) = sum.parts();
        let (mut fixed, by_turn) = fixed_loads(body, &motion.pose);
        if let Some(flow) = around.flow {
            fixed += flow.waves;
        }
        let mut by_unknowns = by_turn;
        let mut columns = by_unknowns.fixed_view_mut::<6, 3>(0, 3);
        columns.copy_from(&(by_turn.fixed_view::<6, 3>(0, 3) * jacobian * k));
        (-(force + fixed), tangent + by_unknowns)
    }

    /// Inertia as a load.
    fn inertia(&self, moving: &MovingPose<'_>, rates: &BodyRates, sum: &mut LoadSum) {
        let own = Momentum {
            velocity: moving.velocity,
            acceleration: rates.acceleration,
        };
        let [force, moment] = own.rates(moving, &(self.mass - self.linear[0]), rates);
        sum.add(&constant(&V3::zeros()), &-moving.to_earth(&force));
        sum.turn(&-moving.to_earth(&moment));
        if self.linear[1] != Matrix6::zeros() {
            let turned = moving.to_earth(&rates.spin_rate);
            let (force, moment) = product(&self.linear[1], &rates.acceleration, &turned);
            sum.add(&constant(&V3::zeros()), &-force);
            sum.turn(&-moment);
        }
    }

    /// Kinetic energy \[J\].
    #[must_use]
    pub fn kinetic_energy(&self, motion: &BodyMotion) -> f64 {
        let rates = velocities(motion);
        let (v, spin) = (motion.velocity, motion.pose.rotation * motion.spin);
        let in_earth = Vector6::new(v.x, v.y, v.z, spin.x, spin.y, spin.z);
        let turning = rates.dot(&((self.mass - self.linear[0]) * rates));
        0.5 * (turning + in_earth.dot(&(self.linear[1] * in_earth)))
    }
}

/// A matrix of forces and moments in axes turned back by this rotation.
fn turned(matrix: &Matrix6<f64>, turn: &Rotation3<f64>) -> Matrix6<f64> {
    let turn = turn.matrix();
    let mut out = Matrix6::zeros();
    for (row, column) in [(0, 0), (0, 3), (3, 0), (3, 3)] {
        let block = matrix.fixed_view::<3, 3>(row, column).into_owned();
        let there = turn * block * turn.transpose();
        out.fixed_view_mut::<3, 3>(row, column).copy_from(&there);
    }
    out
}

/// Velocity of the origin and angular velocity along the axes of the body.
pub(super) fn velocities(motion: &BodyMotion) -> Vector6<f64> {
    let velocity = motion.pose.rotation.inverse() * motion.velocity;
    let spin = motion.spin;
    Vector6::new(velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z)
}

/// Mass matrix about the origin without water.
fn rigid(body: &Body) -> Matrix6<f64> {
    let lever = cross(&body.centre_of_gravity);
    let mut mass = Matrix6::zeros();
    let mut set = |row: usize, column: usize, block: M3| {
        mass.fixed_view_mut::<3, 3>(row, column).copy_from(&block);
    };
    set(0, 0, M3::identity() * body.mass);
    set(0, 3, -lever * body.mass);
    set(3, 0, lever * body.mass);
    set(3, 3, body.inertia - lever * lever * body.mass);
    mass
}

/// Turns changes of a rotation vector, along the axes of the body where it was before the rotation, into turns of the body in the
/// earth's directions: `R J(v)` with R the rotation after it and J the right Jacobian
/// `I - (1 - cos a)/a² [v] + (a - sin a)/a³ [v]²`, a = |v|.
#[must_use]
pub fn rotation_jacobian(rotation: &UnitQuaternion<f64>, vector: &V3) -> M3 {
    let angle2 = vector.norm_squared();
    let (first, second) = if angle2 < 1e-8 {
        (0.5 - angle2 / 24.0, 1.0 / 6.0 - angle2 / 120.0)
    } else {
        let angle = angle2.sqrt();
        (
            (1.0 - angle.cos()) / angle2,
            (angle - angle.sin()) / (angle2 * angle),
        )
    };
    let by = cross(vector);
    rotation.to_rotation_matrix().matrix() * (M3::identity() - by * first + by * by * second)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{DepthGrid, DepthInterpolation};
    use crate::physics::CurrentProfile;
    use crate::physics::kirchhoff::{KirchhoffAddedMass, RelativeMotion};
    use crate::physics::sea::{
        Component, DepthDecay, Sea, SeaReader, Stretching, WaveField, WaveLoad, WaveSettings,
    };
    use crate::system::bed::Bed;
    use crate::system::build::moved_mass;
    use crate::system::motion::foot::feet;
    use crate::system::motion::joints::Joints;
    use crate::system::network::{BodyFoot, FreePoint, HeadingLoads, Held, Member, Point};
    use crate::system::point_on_bed::BearingArea;
    use nalgebra::UnitQuaternion;
    use std::sync::Arc;

    fn body() -> Body {
        Body {
            free: true,
            mass: 4e3,
            weight: 4e4,
            centre_of_gravity: V3::new(0.3, -0.2, -1.0),
            inertia: M3::new(5e4, 2e3, 1e3, 2e3, 6e4, -3e3, 1e3, -3e3, 8e4),
            buoyancy: 2e4,
            centre_of_buoyancy: V3::new(0.0, 0.1, 0.5),
            waterplane: Matrix6::from_diagonal(&Vector6::new(0.0, 0.0, 3e4, 2e5, 3e5, 0.0)),
            added_mass: Matrix6::from_diagonal(&Vector6::new(1e3, 2e3, 3e3, 1e4, 2e4, 1e4)),
            damping: Matrix6::from_diagonal(&Vector6::new(1e3, 1e3, 2e3, 1e4, 1e4, 1e4)),
            quadratic_damping: Matrix6::from_diagonal(&Vector6::new(5e2, 3e2, 1e3, 1e4, 1e4, 2e3)),
            load: V3::new(1e3, 2e3, 0.0),
            bottom: Some(2.0),
            members: vec![Member {
                from: V3::new(1.0, 0.0, -6.0),
                to: V3::new(1.5, 0.5, 3.0),
                radius: (0.8, 0.8),
                drag: 1.1,
                added_mass: 0.9,
                drag_ends: [1.2, 0.7],
                added_mass_ends: [0.6, 0.8],
                drag_only: false,
            }],
            drag_area: V3::new(2.0, 3.0, 4.0),
            ..Body::default()
        }
    }

    /// The motion with the six unknowns moved by a little.
    fn moved(
        motion: &BodyMotion,
        vector: &V3,
        base: UnitQuaternion<f64>,
        c: Factors,
        d: &Vector6<f64>,
    ) -> BodyMotion {
        let (step, turn) = (
            d.fixed_rows::<3>(0).into_owned(),
            d.fixed_rows::<3>(3).into_owned(),
        );
        BodyMotion {
            pose: Pose {
                origin: motion.pose.origin + step * c.stiffness,
                rotation: base * UnitQuaternion::from_scaled_axis(vector + turn * c.stiffness),
            },
            velocity: motion.velocity + step * c.damping,
            spin: motion.spin + turn * c.damping,
            acceleration: motion.acceleration + step * c.mass,
            spin_rate: motion.spin_rate + turn * c.mass,
        }
    }

    #[test]
    fn the_tangent_is_the_derivative_of_the_residual() {
        for (current_loads, bed) in [
            (None, Some(Bed::Level(-0.9))),
            (None, Some(hills())),
            (Some(loads()), None),
        ] {
            let network = Network {
                bed,
                gravity: 9.81,
                density: 1025.0,
                bodies: vec![Body {
                    current_loads,
                    pose: Pose::new(V3::zeros(), 0.0, 0.0, 0.3),
                    ..body()
                }],
                wind: V3::new(10.0, 0.0, 0.0),
                ..Network::default()
            };
            check_tangents(&network);
        }
    }

    /// A body across the surface whose added mass has a centre, in a current that is sheared, with a foot on the bed.
    #[test]
    fn the_tangent_of_a_body_in_flow_is_the_derivative() {
        let bearing = BearingArea {
            area: 2.0,
            stiffness: 3e4,
            damping: 2e3,
            grip: 1e4,
        };
        let foot = BodyFoot {
            point: 0,
            at: V3::new(0.4, -0.3, -2.0),
            bears: FreePoint {
                bearing: Some(bearing),
                ..FreePoint::default()
            },
        };
        for (bed, above) in [(Some(hills()), -9.0), (None, 1.3)] {
            let body = Body {
                pose: Pose::new(V3::zeros(), 0.0, 0.0, 0.3),
                members: Vec::new(),
                bottom: None,
                centre_of_added_mass: Some(V3::new(0.1, -0.2, 0.7)),
                drag_length: 2.5,
                feet: vec![foot],
                ..body()
            };
            let network = Network {
                bed,
                crossed: true,
                gravity: 9.81,
                density: 1025.0,
                current: Some(CurrentProfile::Table {
                    depth: vec![0.0, 20.0],
                    velocity: vec![V3::new(1.2, 0.4, 0.0), V3::new(-0.3, 0.2, 0.0)],
                }),
                points: vec![Point {
                    name: "foot".to_owned(),
                    held: Held::On(0, foot.at),
                    motion: None,
                }],
                bodies: vec![body],
                ..Network::default()
            };
            check_tangents_at(&network, V3::new(3.0, -2.0, above));
        }
    }

    /// A body of revolution needs what Kirchhoff's equations of one say, by the code of payloads of lines.
    #[test]
    fn a_body_of_revolution_has_the_added_mass_of_a_payload() {
        let added = KirchhoffAddedMass {
            normal: 700.0,
            tangential: 250.0,
            inertia: 180.0,
        };
        let centre = V3::new(0.0, 0.0, -1.5);
        let about = Vector6::new(700.0, 700.0, 250.0, 180.0, 180.0, 0.0);
        let body = Body {
            free: true,
            added_mass: moved_mass(&Matrix6::from_diagonal(&about), &centre),
            centre_of_added_mass: Some(centre),
            ..Body::default()
        };
        let water = V3::new(0.9, -0.4, 0.2);
        let network = Network {
            gravity: 9.81,
            density: 1025.0,
            current: Some(CurrentProfile::Uniform(water)),
            bodies: vec![body],
            ..Network::default()
        };
        let motion = BodyMotion {
            pose: Pose::new(V3::new(1.0, 2.0, -20.0), 0.4, -0.3, 0.8),
            velocity: V3::new(0.7, -0.5, 0.3),
            spin: V3::new(0.2, -0.3, 0.5),
            acceleration: V3::new(0.3, 0.2, -0.6),
            spin_rate: V3::new(-0.1, 0.2, 0.3),
        };
        let moving = MovingBody::new(&network, 0, &Pose::default());
        let jacobian = rotation_jacobian(&motion.pose.rotation, &V3::zeros());
        let still = Factors {
            mass: 0.0,
            damping: 0.0,
            stiffness: 0.0,
        };
        let around = BodyWater::default();
        let (found, _) = moving.residual(&network, &motion, &around, &jacobian, still);
        // The axis of a payload points down, away from where it hangs.
        let (t, turned) = (
            motion.pose.arm(&-V3::z()),
            motion.pose.rotation * motion.spin,
        );
        let gained = motion.pose.rotation * motion.spin_rate;
        let (_, v, a) = motion.motion_of(&centre);
        let turn = turned.cross(&t);
        let relative = RelativeMotion {
            t,
            v: v - water,
            a,
            turn,
            gain: gained.cross(&t) + turned.cross(&turn),
        };
        let (force, couple) = added.force_and_couple(&relative);
        let moment = t.cross(&couple) + motion.pose.arm(&centre).cross(&force);
        let own: V3 = found.fixed_rows::<3>(0).into();
        let own_moment: V3 = found.fixed_rows::<3>(3).into();
        assert!((own - force).norm() < 1e-9 * force.norm(), "{own} {force}");
        assert!(
            (own_moment - moment).norm() < 1e-9 * moment.norm(),
            "{own_moment} {moment}"
        );
    }

    /// Hills below the body, of which its foot and its members touch.
    fn hills() -> Bed {
        let axis: Vec<f64> = (-6..=6).map(|k| 3.1 * f64::from(k)).collect();
        let pairs = axis.iter().flat_map(|x| axis.iter().map(move |y| (*x, *y)));
        let depth = pairs.map(|(x, y)| 0.7 + 0.5 * (0.2 * x).sin() * (0.3 * y).cos() + 0.1 * y);
        let depth = depth.collect();
        let grid = DepthGrid::new(
            axis.clone(),
            axis.clone(),
            depth,
            DepthInterpolation::Smooth,
        );
        Bed::Grid(Arc::new(grid.unwrap()))
    }

    /// Loads by heading, with which added mass and damping act to first order.
    fn loads() -> HeadingLoads {
        HeadingLoads {
            headings: vec![0.0, 1.5, 3.0, 4.5],
            loads: vec![
                [9e2, 10.0, 0.0],
                [0.0, 2e3, 4e3],
                [-8e2, 0.0, 0.0],
                [0.0, -2e3, -4e3],
            ],
        }
    }

    fn check_tangents(network: &Network) {
        check_tangents_at(network, V3::new(3.0, -2.0, 1.0));
    }

    fn check_tangents_at(network: &Network, origin: V3) {
        let base = UnitQuaternion::from_euler_angles(0.2, -0.1, 0.7);
        let vector = V3::new(0.3, -0.2, 0.4);
        let motion = BodyMotion {
            pose: Pose {
                origin,
                rotation: base * UnitQuaternion::from_scaled_axis(vector),
            },
            velocity: V3::new(0.7, -0.5, 0.3),
            spin: V3::new(0.2, -0.3, 0.5),
            acceleration: V3::new(0.3, 0.2, -0.6),
            spin_rate: V3::new(-0.1, 0.2, 0.3),
        };
        let moving = MovingBody::new(network, 0, &Pose::default());
        for waves in [Vec::new(), waves_around(network, &motion.pose)] {
            check_tangent(network, &moving, (&motion, &vector, base), &waves);
        }
    }

    /// Short waves at the stations of the body.
    fn waves_around(network: &Network, pose: &Pose) -> Vec<WaterMotion> {
        let setting = WaveSettings {
            direction: 0.6,
            depth: 60.0,
            gravity: 9.81,
            stretching: Stretching::Vertical,
            decay: DepthDecay::Airy,
            ramp: 0.0,
            load: WaveLoad::Morison,
        };
        let component = Component {
            omega: 1.1,
            amplitude: 1.5,
            phase: 0.4,
        };
        let sea = Sea::new(vec![WaveField::new(vec![component], &setting)]);
        let station = pose.origin + pose.arm(&network.bodies[0].station());
        let mut flows = vec![sea.flow(2.0, &station, true)];
        for member in &network.bodies[0].members {
            let mut stations = [WaterMotion::default(); members::STATIONS];
            let mut reader = SeaReader::Once(&sea, 2.0);
            members::read_waves(member, pose, (&mut reader, 0), &mut stations);
            flows.extend(stations);
        }
        let strips = network.bodies[0].drag_strips();
        let places = strips.map(|(place, _)| pose.origin + pose.arm(&place));
        flows.extend(places.map(|place| sea.flow(2.0, &place, true)));
        flows
    }

    fn check_tangent(
        network: &Network,
        moving: &MovingBody,
        (motion, vector, base): (&BodyMotion, &V3, UnitQuaternion<f64>),
        waves: &[WaterMotion],
    ) {
        let c = Factors {
            mass: 7.0,
            damping: 3.0,
            stiffness: 1.0,
        };
        let mut flow = FlowLoad::default();
        flow.waves[2] = 1e4;
        flow.memory[4] = 1e4;
        flow.damping[(0, 4)] = 3e3;
        let feet = feet(network, &Joints::new(network));
        let around = BodyWater {
            waves,
            flow: (!waves.is_empty()).then_some(&flow),
            feet: &feet[0],
            holds: BedHolds::default(),
        };
        let residual = |motion: &BodyMotion, vector: &V3| {
            moving.residual(
                network,
                motion,
                &around,
                &rotation_jacobian(&motion.pose.rotation, vector),
                c,
            )
        };
        let (_, tangent) = residual(motion, vector);
        for k in 0..6 {
            let h = 1e-5;
            let d = Vector6::ith(k, h);
            let turn = d.fixed_rows::<3>(3).into_owned();
            let ahead = residual(&moved(motion, vector, base, c, &d), &(vector + turn)).0;
            let behind = residual(&moved(motion, vector, base, c, &-d), &(vector - turn)).0;
            let slope = (ahead - behind) / (2.0 * h);
            let error = (slope - tangent.column(k)).norm();
            assert!(
                error < 1e-6 * slope.norm(),
                "{k}: {error}\n{slope}\n{}",
                tangent.column(k)
            );
        }
    }
}
