//! Loads on bodies: stiffness against differences, members against closed forms, rods and points in a current, several equilibria.

use std::f64::consts::{PI, TAU};

use nalgebra::{Matrix6, SymmetricEigen, UnitQuaternion, Vector6};
use seacable::numerics::V3;
use seacable::physics::current::CurrentProfile;
use seacable::system::SolvedSystem;
use seacable::system::analysis::analyses::Analyses;
use seacable::system::analysis::{masses::mass_matrix, periods::periods};
use seacable::system::body_loads::body_loads;
use seacable::system::line_physics::LinePhysics;
use seacable::system::network::{Body, HeadingLoads, Member, Network};
use seacable::system::pose::Pose;
use seacable::system::stability::Stability;

use crate::{HEAD, place, solved, tensions};

/// A system of a text with more tables behind it.
fn system(text: &str, more: &[String]) -> SolvedSystem {
    solved(&format!("{HEAD}{text}{}", more.concat()))
}

/// The material `wire`, thin and without drag: mass and weight in water \[kg/m\], EA \[N\].
fn material(mass: f64, wet: f64, ea: f64) -> String {
    format!(
        "[materials.wire]\ndiameter_m = 0.01\nmass_kg_per_m = {mass}\nwet_weight_kg_per_m = {wet}\nea_n = {ea}\n"
    )
}

fn fixed(name: &str, at: [f64; 3]) -> String {
    format!("[points.{name}]\nkind = \"fixed\"\nposition_m = {at:?}\n")
}

fn wire(name: &str, [from, to]: [&str; 2], length: f64) -> String {
    format!(
        "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"wire\"\nlength_m = {length}\n"
    )
}

const WEIGHT: f64 = 1025.0 * 9.80665;

fn sea() -> Network {
    Network {
        gravity: 9.80665,
        density: 1025.0,
        ..Network::default()
    }
}

fn cylinder(from: [f64; 3], to: [f64; 3], radius: f64) -> Member {
    Member {
        from: V3::from(from),
        to: V3::from(to),
        radius: (radius, radius),
        drag: 1.1,
        added_mass: 1.0,
        drag_ends: [0.9, 1.3],
        added_mass_ends: [0.6, 0.8],
        drag_only: false,
    }
}

fn with(members: Vec<Member>) -> Body {
    Body {
        free: true,
        members,
        ..Body::default()
    }
}

fn load(network: &Network, body: &Body, pose: &Pose) -> Vector6<f64> {
    body_loads(network, body, pose, LinePhysics::Full).0
}

fn differences(network: &Network, body: &Body, pose: &Pose) -> Matrix6<f64> {
    let mut found = Matrix6::zeros();
    for column in 0..6 {
        let h = 1e-5;
        let side = |sign: f64| {
            let mut motion = Vector6::<f64>::zeros();
            motion[column] = sign * h;
            let step = V3::new(motion[0], motion[1], motion[2]);
            let turn = V3::new(motion[3], motion[4], motion[5]);
            load(network, body, &pose.moved(&step, &turn))
        };
        found.set_column(column, &(-(side(1.0) - side(-1.0)) / (2.0 * h)));
    }
    found
}

/// A body of everything: upright, lying, inclined and conical members, areas, wind and current by heading, off the origin.
fn of_everything() -> (Network, Body) {
    let network = Network {
        current: Some(CurrentProfile::Table {
            depth: vec![0.0, 40.0],
            velocity: vec![V3::new(1.2, 0.4, 0.0), V3::new(0.2, -0.1, 0.0)],
        }),
        wind: V3::new(12.0, -5.0, 0.0),
        ..sea()
    };
    let mut members = vec![
        cylinder([20.0, 0.0, -15.0], [20.0, 0.0, 9.0], 4.0),
        cylinder([-18.0, 6.0, -14.0], [-10.0, 9.0, 12.0], 3.0),
        cylinder([-10.0, -12.0, -0.5], [22.0, -14.0, 0.8], 2.0),
        cylinder([0.0, 0.0, -30.0], [0.0, 0.0, -12.0], 5.0),
    ];
    members[1].radius.1 = 2.0;
    let rows = |scale: f64| HeadingLoads {
        headings: vec![-2.6, -1.0, 0.3, 1.4],
        loads: vec![
            [-300.0, 120.0, 4e3],
            [200.0, -500.0, -9e3],
            [350.0, 90.0, 1e3],
            [-40.0, 480.0, 7e3],
        ]
        .into_iter()
        .map(|row: [f64; 3]| row.map(|load| scale * load))
        .collect(),
    };
    let body = Body {
        mass: 4e6,
        weight: 4e7,
        centre_of_gravity: V3::new(0.4, -0.2, -6.0),
        pose: Pose::new(V3::new(2.0, -1.0, 0.3), 0.05, -0.02, 0.3),
        waterplane: Matrix6::from_fn(|i, j| 1e7 / (1.0 + (i as f64 - j as f64).abs())),
        drag_area: V3::new(120.0, 300.0, 500.0),
        wind_loads: Some(rows(1.0)),
        current_loads: Some(rows(300.0)),
        load: V3::new(1e5, 2e5, -3e5),
        ..with(members)
    };
    (network, body)
}

#[test]
fn stiffness_of_every_load_is_that_of_differences() {
    let (network, body) = of_everything();
    for (k, angles) in [
        (0.0, 0.0, 0.4),
        (0.1, -0.2, 1.0),
        (0.6, 0.9, -2.0),
        (1.5, 0.1, 2.7),
    ]
    .into_iter()
    .enumerate()
    {
        let origin = V3::new(3.0, -2.0, -1.3 + k as f64);
        let pose = Pose::new(origin, angles.0, angles.1, angles.2);
        let exact = body_loads(&network, &body, &pose, LinePhysics::Full).1;
        let numeric = differences(&network, &body, &pose);
        for (i, j) in [(0, 0), (0, 3), (3, 0), (3, 3)] {
            let size = exact.fixed_view::<3, 3>(i, j).amax().max(1.0);
            let off = (exact - numeric).fixed_view::<3, 3>(i, j).amax() / size;
            assert!(off < 2e-6, "pose {k}, block {i}, {j}: {off:.1e}");
        }
    }
}

/// Poses upright, heeled and level, with the surface along the members and over their ends.
fn cut_poses() -> Vec<Pose> {
    let angles = [0.0, 1e-7, 0.02, 0.4, 1.2, 1.5, 1.57, 0.5 * PI];
    let heights = [-9.0, -3.1, -0.4, 0.0, 0.7, 2.9, 8.0];
    let poses = angles.iter().flat_map(|pitch| {
        heights.map(|z| Pose::new(V3::new(1.0, -2.0, z), 0.1 * pitch, *pitch, 0.3))
    });
    poses.collect()
}

fn in_a_current() -> Network {
    Network {
        current: Some(CurrentProfile::Table {
            depth: vec![0.0, 40.0],
            velocity: vec![V3::new(1.2, 0.4, 0.0), V3::new(0.2, -0.1, 0.0)],
        }),
        ..sea()
    }
}

/// Loads and masses of a cone, and of the two that it is cut into anywhere, are the same.
#[test]
fn a_member_cut_in_two_has_the_same_sums() {
    let network = in_a_current();
    let cone = Member {
        radius: (2.0, 1.2),
        ..cylinder([0.0, 0.0, -6.0], [0.0, 0.0, 6.0], 2.0)
    };
    let parts = |share: f64| {
        let (at, radius) = (cone.from.lerp(&cone.to, share), 2.0 - 0.8 * share);
        let (mut one, mut two) = (cone.clone(), cone.clone());
        (one.to, two.from) = (at, at);
        (one.radius.1, two.radius.0) = (radius, radius);
        for (member, inner) in [(&mut one, 1), (&mut two, 0)] {
            member.drag_ends[inner] = 0.0;
            member.added_mass_ends[inner] = 0.0;
        }
        with(vec![one, two])
    };
    let whole = with(vec![cone.clone()]);
    for pose in cut_poses() {
        let loads = load(&network, &whole, &pose);
        let mass = mass_matrix(&network, &whole, &pose);
        for share in [0.11, 0.5, 0.73] {
            // Where it is cut within the length that the surface cuts, the quadrature ends beside a singularity.
            let z = (pose.origin + pose.arm(&cone.from.lerp(&cone.to, share))).z;
            let tolerance = if z.abs() < 2.0 { 5e-6 } else { 1e-9 };
            let off = (load(&network, &parts(share), &pose) - loads).amax();
            assert!(off < tolerance * WEIGHT * 100.0, "{pose:?}, {share}: {off}");
            let off = (mass_matrix(&network, &parts(share), &pose) - mass).amax();
            assert!(off < tolerance * 1025.0 * 5e3, "{pose:?}, {share}: {off}");
        }
    }
}

/// No sum jumps as a member goes through the surface, upright, heeled or level.
#[test]
fn the_sums_of_a_member_do_not_jump_at_the_surface() {
    let network = in_a_current();
    let body = with(vec![cylinder([0.0, 0.0, -3.0], [0.0, 0.0, 3.0], 1.5)]);
    let steps = 4_000;
    for pitch in [0.0, 1e-4, 0.3, 1.3, 0.5 * PI] {
        let at = |k: i32| {
            let z = -5.0 + 10.0 * f64::from(k) / f64::from(steps);
            let pose = Pose::new(V3::new(0.0, 0.0, z), 0.0, pitch, 0.2);
            let mass = mass_matrix(&network, &body, &pose);
            (load(&network, &body, &pose), mass.diagonal())
        };
        let (first, last) = (at(0), at(steps));
        let scale = |a: &Vector6<f64>, b: &Vector6<f64>| a.amax().max(b.amax());
        let sizes = (scale(&first.0, &last.0), scale(&first.1, &last.1));
        let mut before = first;
        for k in 1..=steps {
            let here = at(k);
            let (force, mass) = ((here.0 - before.0).amax(), (here.1 - before.1).amax());
            assert!(
                force < 2e-2 * sizes.0,
                "{pitch}, {k}: {force} of {}",
                sizes.0
            );
            assert!(mass < 5e-2 * sizes.1, "{pitch}, {k}: {mass} of {}", sizes.1);
            before = here;
        }
    }
}

/// The ends of a member drag along it where they are in the water.
#[test]
fn the_drag_of_ends_is_along_the_member() {
    let network = Network {
        current: Some(CurrentProfile::Uniform(V3::new(2.0, 0.0, 0.0))),
        ..sea()
    };
    let mut member = cylinder([-4.0, 0.0, 0.0], [4.0, 0.0, 0.0], 0.5);
    member.drag = 0.0;
    let body = with(vec![member]);
    let each = 0.5 * 1025.0 * PI * 0.25 * 4.0;
    for (z, wet) in [(-5.0, 1.0), (0.0, 0.5), (5.0, 0.0)] {
        let force = load(&network, &body, &Pose::new(V3::z() * z, 0.0, 0.0, 0.0));
        let exact = wet * (0.9 + 1.3) * each;
        assert!((force[0] - exact).abs() < 1e-9 * each, "{z}: {force}");
    }
    // Across the current the ends do nothing; at 60 degrees they see half of its speed.
    let force = load(
        &network,
        &body,
        &Pose::new(V3::z() * -5.0, 0.0, 0.0, PI / 3.0),
    );
    let along = 0.25 * (0.9 + 1.3) * each;
    assert!((force[0] - 0.5 * along).abs() < 1e-9 * each, "{force}");
    assert!((force[1] - 0.75_f64.sqrt() * along).abs() < 1e-9 * each);
}

/// A ship that heels has the same righting moment about its own axes at every heading.
#[test]
fn a_water_plane_turns_with_its_body() {
    let diagonal = nalgebra::vector![0.0, 0.0, 9e7, 1.4e10, 4e11, 0.0];
    let righting = |given: f64, heading: f64| {
        let ship = Body {
            pose: Pose::new(V3::zeros(), 0.0, 0.0, given),
            waterplane: Matrix6::from_diagonal(&diagonal),
            ..with(Vec::new())
        };
        let pose = Pose::new(V3::zeros(), 0.01, 0.02, heading);
        let force = load(&sea(), &ship, &pose);
        let moment = V3::new(force[3], force[4], force[5]);
        UnitQuaternion::from_euler_angles(0.0, 0.0, -heading) * moment
    };
    let straight = righting(0.0, 0.0);
    let (roll, pitch) = (0.01_f64.sin() * 0.02_f64.cos(), 0.02_f64.sin());
    assert!((straight.x / (-roll * 1.4e10) - 1.0).abs() < 1e-12);
    assert!((straight.y / (-pitch * 4e11) - 1.0).abs() < 1e-12);
    for (given, heading) in [(0.0, 0.5), (0.0, 3.1), (1.6, 1.6), (1.6, -2.0)] {
        let off = righting(given, heading) - straight;
        assert!(off.norm() < 1e-11 * straight.norm(), "{heading}: {off}");
    }
}

#[test]
fn a_lying_cylinder_floats_at_its_middle() {
    let body = with(vec![cylinder([-8.0, 0.0, 0.0], [8.0, 0.0, 0.0], 2.0)]);
    let (force, stiffness) = body_loads(&sea(), &body, &Pose::default(), LinePhysics::Plain);
    let half = WEIGHT * 0.5 * PI * 4.0 * 16.0;
    assert!((force[2] / half - 1.0).abs() < 1e-12, "{force}");
    assert!(force[4].abs() < 1e-9 * half);
    // The water-plane is 16 m by 4 m; the centre of buoyancy lies 4r/3pi below.
    assert!((stiffness[(2, 2)] / (WEIGHT * 64.0) - 1.0).abs() < 1e-9);
    let low = 4.0 * 2.0 / (3.0 * PI);
    let roll = WEIGHT * 16.0 * 64.0 / 12.0 - half * low;
    let pitch = WEIGHT * 4.0 * 16.0_f64.powi(3) / 12.0 - half * low;
    assert!((stiffness[(3, 3)] - roll).abs() < 1e-7 * pitch);
    assert!((stiffness[(4, 4)] / pitch - 1.0).abs() < 1e-7);
}

#[test]
fn an_upright_cylinder_has_its_water_plane_and_metacentre() {
    let body = with(vec![cylinder([0.0, 0.0, -20.0], [0.0, 0.0, 6.0], 3.0)]);
    let (force, stiffness) = body_loads(&sea(), &body, &Pose::default(), LinePhysics::Plain);
    let area = PI * 9.0;
    assert!((force[2] / (WEIGHT * area * 20.0) - 1.0).abs() < 1e-12);
    assert!((stiffness[(2, 2)] / (WEIGHT * area) - 1.0).abs() < 1e-12);
    let pitch = WEIGHT * (PI * 81.0 / 4.0 - area * 20.0 * 10.0);
    assert!((stiffness[(4, 4)] / pitch - 1.0).abs() < 1e-12);
}

/// Points spread evenly over a box count the volume in the water and its moment.
#[test]
fn what_is_immersed_is_what_points_in_it_count() {
    let member = Member {
        radius: (3.0, 2.0),
        ..cylinder([0.0, 0.0, -5.0], [0.0, 0.0, 5.0], 3.0)
    };
    for (pitch, z) in [(0.3, 0.5), (1.1, -1.0), (1.5, 0.7), (1.0, 3.5), (2.4, -3.0)] {
        let pose = Pose::new(V3::new(0.0, 0.0, z), 0.2, pitch, 0.0);
        let force = load(&sea(), &with(vec![member.clone()]), &pose);
        let (mut count, mut moment) = (0.0, V3::zeros());
        let n = 80;
        let cell = |k: i32, size: f64| size * ((f64::from(k) + 0.5) / f64::from(n) - 0.5);
        for (i, j, k) in
            (0..n).flat_map(|i| (0..n).flat_map(move |j| (0..n).map(move |k| (i, j, k))))
        {
            let at = V3::new(cell(i, 6.0), cell(j, 6.0), cell(k, 10.0));
            let radius = 2.5 - 0.1 * at.z;
            let arm = pose.arm(&at);
            if at.xy().norm() <= radius && arm.z + z <= 0.0 {
                count += 1.0;
                moment += arm;
            }
        }
        let volume = 360.0 / f64::from(n).powi(3);
        let (wanted, turning) = (count * volume, moment * volume);
        assert!(
            (force[2] / WEIGHT - wanted).abs() < 0.4,
            "{pitch}: {wanted}"
        );
        assert!((force[3] / WEIGHT - turning.y).abs() < 1.5, "{pitch}");
        assert!((force[4] / WEIGHT + turning.x).abs() < 1.5, "{pitch}");
    }
}

#[test]
fn a_buoyant_rod_leans_in_the_current_until_drag_and_buoyancy_balance() {
    let system = system(
        r#"
[current]
speed_m_per_s = 0.8
[rods.float]
kind = "free"
end_a_m = [0.0, 0.0, -40.0]
end_b_m = [1.0, 0.0, -28.0]
mass_kg = 300.0
diameter_m = 0.3
drag_normal = 1.2
"#,
        &[
            material(0.1, 1e-6, 1e6),
            fixed("anchor", [0.0, 0.0, -60.0]),
            wire("tether", ["anchor", "float-a"], 20.0),
        ],
    );
    let (a, b) = (place(&system, "float-a"), place(&system, "float-b"));
    let long = (145.0_f64).sqrt();
    let buoyancy = WEIGHT * PI * 0.0225 * long - 300.0 * 9.80665;
    let drag = 0.5 * 1025.0 * 1.2 * 0.3 * long * 0.64;
    // Across the rod: drag of the speed across it, buoyancy's part across it.
    let lean = ((b[0] - a[0]) / long).asin();
    let off = drag * lean.cos().powi(2) - buoyancy * lean.sin();
    assert!(off.abs() < 1e-6 * buoyancy, "{off}");
    assert!(lean > 0.1, "{lean}");
    assert_eq!(system.stability, Stability::Stable);
    // The tether bears what buoyancy and drag leave; its own drag is nothing, its mesh exact.
    let normal = drag * lean.cos().powi(2);
    let pull = V3::new(normal * lean.cos(), 0.0, buoyancy - normal * lean.sin());
    let [_, top] = tensions(&system, "tether");
    assert!((top / pull.norm() - 1.0).abs() < 1e-6, "{top}");
}

#[test]
fn a_buoy_in_a_current_leans_by_drag_over_buoyancy() {
    let system = system(
        r#"
[current]
speed_m_per_s = 1.0
direction_deg = 90.0
[points.buoy]
kind = "free"
mass_kg = 100.0
volume_m3 = 1.0
drag_area_m2 = 2.0
"#,
        &[
            material(0.01, 1e-6, 1e7),
            fixed("anchor", [0.0, 0.0, -60.0]),
            wire("tether", ["anchor", "buoy"], 30.0),
        ],
    );
    let at = place(&system, "buoy");
    let wanted = 0.5 * 1025.0 * 2.0 / (WEIGHT - 100.0 * 9.80665);
    assert!(
        (at[1] / (at[2] + 60.0) / wanted - 1.0).abs() < 1e-5,
        "{at:?}"
    );
    assert!(at[0].abs() < 1e-9);
}

/// A beam that hangs from a point above its centre: at rest as it hangs, and turned over.
#[test]
fn an_equilibrium_turned_over_is_found_and_told_to_be_unstable() {
    let system = system(
        r#"
[environment]
water_density_kg_per_m3 = 0.0
[bodies.block]
kind = "free"
position_m = [0.0, 0.0, -12.0]
mass_kg = 5000.0
inertia_kg_m2 = [4e3, 5e3, 6e3]
[points.left]
kind = "body"
body = "block"
position_m = [-0.5, 0.0, 1.0]
[points.right]
kind = "body"
body = "block"
position_m = [0.5, 0.0, 1.0]
"#,
        &[
            material(1.0, 1.0, 1e8),
            fixed("hook", [-0.3, 0.0, 0.0]),
            fixed("eye", [0.3, 0.0, 0.0]),
            wire("left", ["hook", "left"], 11.0),
            wire("right", ["eye", "right"], 11.0),
        ],
    );
    assert!(
        matches!(system.stability, Stability::Stable),
        "{:?}",
        system.stability
    );
    let others = Analyses::of_system(&system).others;
    let over = others
        .iter()
        .find(|(rest, _)| rest.placement.bodies[0].arm(&V3::z()).z < -0.999);
    let (rest, how) = over.unwrap();
    assert!(matches!(how, Stability::Unstable(_)), "{how:?}");
    assert!(rest.residual < 1e-9 * rest.balance.tension);
}

#[test]
fn a_clump_on_a_wire_bounces_and_swings_with_the_periods_of_both() {
    let system = system(
        r#"
[points.clump]
kind = "free"
mass_kg = 800.0
volume_m3 = 0.1
added_mass_kg = 60.0
"#,
        &[
            material(0.1, 1e-7, 1e6),
            fixed("top", [0.0, 0.0, -1.0]),
            wire("wire", ["top", "clump"], 50.0),
        ],
    );
    let modes = periods(&system.network, &system.rest).unwrap().modes;
    let weight = 800.0 * 9.80665 - 0.1 * WEIGHT;
    let long = 50.0 * (1.0 + weight / 1e6);
    let swing = TAU * (860.0 * long / weight).sqrt();
    let bounce = TAU * (860.0 * 50.0_f64 / 1e6).sqrt();
    let found: Vec<f64> = modes.iter().filter_map(|mode| mode.period_s).collect();
    assert_eq!(found.len(), 3);
    for (found, wanted) in found.iter().zip([swing, swing, bounce]) {
        assert!((found / wanted - 1.0).abs() < 1e-6, "{found} {wanted}");
    }
    assert_eq!(modes[2].names(&system.network), ("clump", "z"));
}

/// Above the surface the water neither carries it nor moves with it.
#[test]
fn a_clump_in_the_air_has_the_periods_of_its_own_mass() {
    let system = system(
        "[environment]\nwater_surface = \"crossed\"\n[points.clump]\nkind = \"free\"\nmass_kg = 800.0\nvolume_m3 = 0.1\nadded_mass_kg = 600.0\n",
        &[
            material(0.1, 1e-7, 1e6),
            fixed("top", [0.0, 0.0, 70.0]),
            wire("wire", ["top", "clump"], 50.0),
        ],
    );
    let modes = periods(&system.network, &system.rest).unwrap().modes;
    let found: Vec<f64> = modes.iter().filter_map(|mode| mode.period_s).collect();
    let weight = 800.0 * 9.80665;
    let swing = TAU * (800.0 * 50.0_f64 * (1.0 + weight / 1e6) / weight).sqrt();
    let bounce = TAU * (800.0 * 50.0_f64 / 1e6).sqrt();
    assert_eq!(found.len(), 3);
    // The wire weighs 5 kg in the air.
    for (found, wanted) in found.iter().zip([swing, swing, bounce]) {
        assert!((found / wanted - 1.0).abs() < 0.01, "{found} {wanted}");
    }
}

#[test]
fn a_clump_swings_and_bounces_by_its_added_mass_along_each_axis() {
    let modes = |added: &str| -> Vec<f64> {
        let system = system(
            &format!(
                "\n[points.clump]\nkind = \"free\"\nmass_kg = 800.0\nvolume_m3 = 0.1\nadded_mass_kg = {added}\n"
            ),
            &[
                material(0.1, 1e-7, 1e6),
                fixed("top", [0.0, 0.0, -1.0]),
                wire("wire", ["top", "clump"], 50.0),
            ],
        );
        let modes = periods(&system.network, &system.rest).unwrap().modes;
        modes.iter().filter_map(|mode| mode.period_s).collect()
    };
    let found = modes("[60.0, 200.0, 900.0]");
    let [along, across, up] = ["60.0", "200.0", "900.0"].map(modes);
    for (found, wanted) in found.iter().zip([across[0], along[0], up[2]]) {
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
    }
}

/// A rod that is turned keeps its loads: nothing hangs on its spin, and its modes do not show it.
#[test]
fn a_rod_has_five_modes() {
    let (mut network, mut body) = (
        sea(),
        with(vec![cylinder([-6.0, 0.0, 0.0], [6.0, 0.0, 0.0], 0.2)]),
    );
    body.spins_about = Some(V3::x());
    body.weight = 1e3;
    let pose = Pose::new(V3::new(0.0, 0.0, -30.0), 0.0, -1.2, 0.3);
    let spun = Pose {
        rotation: pose.rotation * UnitQuaternion::from_scaled_axis(V3::x() * 0.7),
        ..pose
    };
    network.current = Some(CurrentProfile::Uniform(V3::x()));
    let (one, two) = (load(&network, &body, &pose), load(&network, &body, &spun));
    assert!((one - two).norm() < 1e-9 * one.norm());
    let system = system(
        r#"
[rods.bar]
kind = "free"
end_a_m = [-3.0, 0.0, -20.0]
end_b_m = [3.0, 0.0, -20.0]
mass_kg = 900.0
diameter_m = 0.2
"#,
        &[
            material(0.1, 1e-7, 1e6),
            fixed("left", [-4.0, 0.0, -1.0]),
            fixed("right", [4.0, 0.0, -1.0]),
            wire("left", ["left", "bar-a"], 18.0),
            wire("right", ["right", "bar-b"], 18.0),
        ],
    );
    assert_eq!(system.stability, Stability::Stable);
    let modes = periods(&system.network, &system.rest).unwrap().modes;
    assert_eq!(modes.len(), 5, "{modes:?}");
}

/// A rod too heavy for its slack lines lies on the bed, which bears its weight and gives way by less than a millimetre.
#[test]
fn a_heavy_rod_lies_on_the_bed() {
    let system = system(
        r#"
[seabed]
depth_m = 40.0
[rods.pipe]
kind = "free"
end_a_m = [-6.0, 0.0, -20.0]
end_b_m = [6.0, 0.0, -18.0]
mass_kg = 5000.0
diameter_m = 0.4
"#,
        &[
            material(0.5, 0.5, 1e7),
            fixed("left", [-20.0, 0.0, -1.0]),
            fixed("right", [20.0, 0.0, -1.0]),
            wire("left", ["left", "pipe-a"], 45.0),
            wire("right", ["right", "pipe-b"], 45.0),
        ],
    );
    for end in ["pipe-a", "pipe-b"] {
        let above = place(&system, end)[2] + 40.0;
        assert!(above > 0.199 && above < 0.2, "{end}: {above}");
    }
    assert!(tensions(&system, "left")[1] < 0.1 * 5000.0 * 9.8);
}

/// Periods of the free platforms by a stiffness of differences: that of the lines, and that of everything else on the body.
#[test]
fn periods_of_the_free_platforms_are_those_of_differences() {
    for text in [
        include_str!("../../cases/systems/oc3_free.toml"),
        include_str!("../../cases/systems/oc4_free.toml"),
        include_str!("../../cases/systems/volturnus_free.toml"),
    ] {
        let system = solved(text);
        let (network, pose) = (&system.network, system.rest.placement.bodies[0]);
        let body = &network.bodies[0];
        let mut held = network.clone();
        held.bodies[0].free = false;
        held.bodies[0].pose = pose;
        let lines = crate::stiffness::differences(&held, 0);
        let stiffness = lines + differences(network, body, &pose);
        let mass = mass_matrix(network, body, &pose);
        let inverse = mass.cholesky().unwrap().l().try_inverse().unwrap();
        let scaled = inverse * stiffness * inverse.transpose();
        let mut values: Vec<f64> = SymmetricEigen::new(0.5 * (scaled + scaled.transpose()))
            .eigenvalues
            .iter()
            .copied()
            .collect();
        values.sort_by(f64::total_cmp);
        let modes = periods(network, &system.rest).unwrap().modes;
        for (mode, value) in modes.iter().zip(values) {
            let (exact, numeric) = (mode.period_s.unwrap(), TAU / value.sqrt());
            assert!((exact / numeric - 1.0).abs() < 1e-6, "{exact} {numeric}");
        }
    }
}

/// Wind from ahead and from astern: the ship that may turn about its turret comes to rest with its bow to the wind, also from a
/// start across it.
#[test]
fn a_ship_on_a_turret_turns_into_the_wind() {
    for start in [0.0, 60.0, 130.0] {
        let loads = [(0.0, 500.0, 0.0), (90.0, 0.0, 2000.0), (180.0, -500.0, 0.0), (270.0, 0.0, -2000.0)]
            .map(|(heading, surge, sway)| {
                format!(
                    "[[bodies.ship.wind_loads]]\nheading_deg = {heading:?}\nsurge_n_s2_per_m2 = {surge:?}\nsway_n_s2_per_m2 = {sway:?}\n"
                )
            })
            .concat();
        let text = format!(
            r#"
[seabed]
depth_m = 80.0
[wind]
speed_m_per_s = 20.0
direction_deg = 180.0
[materials.wire]
diameter_m = 0.2
mass_kg_per_m = 220.0
ea_n = 9e8
[bodies.ship]
kind = "free"
yaw_deg = {start:?}
mass_kg = 1.2e8
volume_m3 = 117200.0
centre_of_gravity_m = [0.0, 0.0, -2.0]
centre_of_buoyancy_m = [0.0, 0.0, -7.0]
waterplane_stiffness = [0.0, 0.0, 9e7, 1.4e10, 4e11, 0.0]
[points.turret]
kind = "body"
body = "ship"
position_m = [100.0, 0.0, -12.0]
{loads}"#
        );
        let anchors = [
            ("one", 600.0, 0.0),
            ("two", -400.0, 500.0),
            ("three", -400.0, -500.0),
        ];
        let more: Vec<String> = anchors
            .iter()
            .flat_map(|(name, x, y)| {
                let line = format!("line_{name}");
                [
                    fixed(name, [*x, *y, -80.0]),
                    wire(&line, [name, "turret"], 620.0),
                ]
            })
            .collect();
        let ship = system(&text, &more);
        let pose = &ship.rest.placement.bodies[0];
        let yaw = pose.angles()[2];
        assert!(yaw.abs() < 1e-6, "{start}: {yaw}");
        assert_eq!(ship.stability, Stability::Stable);
    }
}
