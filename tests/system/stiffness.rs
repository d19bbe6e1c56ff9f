//! The stiffness of a body against central differences of the forces on it, and invariance of systems.

use nalgebra::{Matrix6, Vector6};
use seacable::numerics::V3;
use seacable::system::equilibrium::search;
use seacable::system::line_physics::LinePhysics;
use seacable::system::network::{Held, Network};
use seacable::system::pose::Pose;
use seacable::system::start::start;
use seacable::system::stiffness::of_body;

use crate::solved;

/// What bears by its area on hills, in a current that grows upwards and turns.
#[test]
fn the_force_on_a_point_at_rest_has_its_derivative() {
    let system = solved(
        "[system]\ntitle = \"t\"\n[current]\nspeed_m_per_s = [1.2, 0.3]\ndirection_deg = [20.0, 70.0]\ndepth_m = [0.0, 80.0]\n\
         [seabed]\ndepth_m = 60.0\ndepth_file = \"d.csv\"\nstiffness_n_per_m3 = 2e4\n\
         [files.\"d.csv\"]\ntext = \"\"\"\nx_m,y_m,depth_m\n-40,-40,55\n-40,0,58\n-40,40,61\n0,-40,60\n0,0,60\n0,40,57\n40,-40,63\n40,0,59\n40,40,52\n\"\"\"\n\
         [materials.wire]\nmass_kg_per_m = 20.0\ndiameter_m = 0.05\nea_n = 1e7\n\
         [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n\
         [points.clump]\nkind = \"free\"\nposition_m = [1.0, 2.0, -58.0]\nmass_kg = 4000.0\nvolume_m3 = 0.5\n\
         drag_area_m2 = [1.0, 3.0, 7.0]\nbed_area_m2 = 2.0\nbottom_m = 1.0\n\
         [[lines]]\nname = \"wire\"\nfrom = \"top\"\nto = \"clump\"\nmaterial = \"wire\"\nlength_m = 58.0\nsegments = 10\n",
    );
    let network = &system.network;
    let Held::Free(clump) = &network.points[network.point("clump").unwrap()].held else {
        panic!("it is free");
    };
    for z in [-59.3, -58.9, -40.0] {
        let at = |place: V3| clump.force(network, &place, LinePhysics::Full);
        let place = V3::new(3.0, -7.0, z);
        let (force, slope) = at(place);
        for k in 0..3 {
            let step = V3::ith(k, 1e-5);
            let by = (at(place + step).0 - at(place - step).0) / 2e-5;
            assert!(
                (by - slope.column(k)).norm() < 1e-6 * (1.0 + by.norm()),
                "{z} {k}"
            );
        }
        assert!(force.x > 0.0 && force.norm() > 1.0);
    }
}

/// Force and moment of the lines on a body at a pose.
fn load(network: &Network, body: usize, pose: Pose) -> Vector6<f64> {
    let mut network = network.clone();
    network.bodies[body].pose = pose;
    let rest = search(&network, &start(&network)).unwrap();
    let mut sum = Vector6::zeros();
    for (line, at_rest) in network.lines.iter().zip(&rest.balance.lines) {
        for (end, force) in [(line.from, at_rest.force_a), (line.to, at_rest.force_b)] {
            if let Held::On(on, place) = &network.points[end].held
                && *on == body
            {
                let moment = pose.arm(place).cross(&force);
                for k in 0..3 {
                    sum[k] += force[k];
                    sum[k + 3] += moment[k];
                }
            }
        }
    }
    sum
}

/// Stiffness of the lines on a body by differences of their load.
pub(crate) fn differences(network: &Network, body: usize) -> Matrix6<f64> {
    differences_by(network, body, [1e-3, 1e-5])
}

/// The same by these displacements \[m\] and turns \[rad\].
pub(crate) fn differences_by(
    network: &Network,
    body: usize,
    [far, turned]: [f64; 2],
) -> Matrix6<f64> {
    let pose = network.bodies[body].pose;
    let mut found = Matrix6::zeros();
    for column in 0..6 {
        let step = if column < 3 { far } else { turned };
        let side = |sign: f64| {
            let mut motion = Vector6::<f64>::zeros();
            motion[column] = sign * step;
            let (du, dt) = (
                V3::new(motion[0], motion[1], motion[2]),
                V3::new(motion[3], motion[4], motion[5]),
            );
            load(network, body, pose.moved(&du, &dt))
        };
        found.set_column(column, &(-(side(1.0) - side(-1.0)) / (2.0 * step)));
    }
    found
}

#[test]
fn stiffness_of_the_shipped_platforms_is_that_of_differences() {
    for (text, friction) in [
        (include_str!("../../cases/systems/oc3_spar.toml"), 0.001),
        (include_str!("../../cases/systems/oc4_semi.toml"), 0.0),
        (include_str!("../../cases/systems/oc4_semi.toml"), 0.6),
        (include_str!("../../cases/systems/crows_foot.toml"), 0.0),
        (include_str!("../../cases/systems/volturnus.toml"), 0.0),
    ] {
        let mut network = solved(text).network;
        network
            .lines
            .iter_mut()
            .for_each(|line| line.friction = friction);
        // Away from symmetry, so that every entry counts.
        network.bodies[0].pose = Pose::new(V3::new(6.0, -4.0, 0.5), 0.02, -0.03, 0.05);
        let rest = search(&network, &start(&network)).unwrap();
        let exact = of_body(&network, &rest, 0).unwrap();
        let numeric = differences(&network, 0);
        let block = |i: usize, j: usize| {
            (exact.fixed_view::<3, 3>(i, j) - numeric.fixed_view::<3, 3>(i, j)).amax()
                / exact.fixed_view::<3, 3>(i, j).amax()
        };
        for (i, j) in [(0, 0), (0, 3), (3, 0), (3, 3)] {
            assert!(block(i, j) < 2e-6, "block {i}, {j}: {:.1e}", block(i, j));
        }
        if friction == 0.0 {
            let force = exact.fixed_view::<3, 3>(0, 0);
            assert!((force - force.transpose()).amax() < 1e-10 * force.amax());
        }
    }
}

/// Turned about the vertical and moved sideways, a system has the same tensions.
#[test]
fn turned_and_moved_systems_have_the_same_tensions() {
    let network = solved(include_str!("../../cases/systems/crows_foot.toml")).network;
    let here = search(&network, &start(&network)).unwrap();
    let turn = nalgebra::Rotation3::from_axis_angle(&V3::z_axis(), 0.7);
    let step = V3::new(1234.5, -987.6, 0.0);
    let mut moved = network.clone();
    for point in &mut moved.points {
        if let Held::At(place) = &mut point.held {
            *place = turn * *place + step;
        }
    }
    for body in &mut moved.bodies {
        body.pose = Pose {
            origin: turn * body.pose.origin + step,
            rotation: nalgebra::UnitQuaternion::from_rotation_matrix(&turn) * body.pose.rotation,
        };
    }
    let there = search(&moved, &start(&moved)).unwrap();
    for (a, b) in here.balance.lines.iter().zip(&there.balance.lines) {
        let (a, b) = (a.tensions(), b.tensions());
        assert!((a[0] / b[0] - 1.0).abs() < 1e-9 && (a[1] / b[1] - 1.0).abs() < 1e-9);
    }
}

/// The order of the lines and which end is named first do not matter.
#[test]
fn the_order_of_lines_and_ends_does_not_matter() {
    let network = solved(include_str!("../../cases/systems/crows_foot.toml")).network;
    let here = search(&network, &start(&network)).unwrap();
    let mut other = network.clone();
    other.lines.reverse();
    for line in &mut other.lines {
        std::mem::swap(&mut line.from, &mut line.to);
        std::mem::swap(&mut line.sections, &mut line.reversed);
    }
    let there = search(&other, &start(&other)).unwrap();
    for (a, b) in here
        .balance
        .lines
        .iter()
        .zip(there.balance.lines.iter().rev())
    {
        let (a, b) = (a.tensions(), b.tensions());
        assert!((a[0] / b[1] - 1.0).abs() < 1e-9 && (a[1] / b[0] - 1.0).abs() < 1e-9);
    }
}
