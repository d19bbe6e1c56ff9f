//! Every force's tangent against central differences, on lines that are taut, slack, moving, in a sheared
//! current, astride the drag crisis.

use proptest::prelude::*;
use seacable::numerics::{BlockBand, V3};
use seacable::physics::{CurrentGrid, CurrentProfile};
use seacable::scene::{self, PaidOut, Scene};
use seacable::solve::{
    ExplicitRhs, Factors, Hysteresis, Kinematics, Residual, State, StaticSearch,
};

/// Two materials, floats, a payload, a current sheared over depth.
pub(crate) const LINE: &str = r#"
[case]
title = "tangent"
[current]
speed_m_per_s = [0.2, 0.7]
direction_deg = [0.0, 80.0]
depth_m = [0.0, 60.0]
[materials.rope]
diameter_m = 0.2
mass_kg_per_m = 30.0
ea_n = 1.0e6
axial_damping_n_s = 2.0e4
drag_normal = "NORMAL"
drag_tangential = "jia-2019-tangential"
attached_drag_width_m = 0.3
added_mass_tangential = 0.1
[materials.wire]
diameter_m = 0.1
mass_kg_per_m = 60.0
ea_n = 5.0e6
axial_damping_ratio = 0.1
drag_normal = 1.1
drag_tangential = 0.02
drag_tangential_width = "perimeter"
[[line]]
name = "rope"
material = "rope"
length_m = 30.0
segments = 3
[[line]]
name = "wire"
material = "wire"
length_m = 20.0
segments = 2
[[floats]]
section = "wire"
from_m = 5.0
lift_kg = 300.0
mass_kg = 200.0
drag_area_m2 = 2.0
added_mass_kg = 100.0
[ends.a]
name = "vessel"
kind = "fixed"
position_m = [0, 0, 0]
[ends.b]
name = "payload"
kind = "payload"
[payload]
dry_mass_kg = 2000.0
wet_mass_kg = 1500.0
drag_area_m2 = [3.0, 4.0, 5.0]
added_mass_kg = 500.0
[start]
shape = "straight"
elevation_deg = -50.0
"#;

fn line(normal: &str) -> Scene {
    let text = LINE.replace("\"NORMAL\"", normal);
    scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
}

/// The same with dynamic stiffness in the rope: at rest, or remembering the tensions that it had when straight.
fn line_of_fibre(reading: &str, scope: &str) -> Scene {
    let fibre = format!(
        "ea_n = 1.0e6\nbreak_load_n = 1e5\ndynamic_stiffness = \"{reading}\"\ndynamic_alpha = 14.0\n\
         dynamic_beta = 0.2\ndynamic_gamma = 0.25\nstiffness_scope = \"{scope}\""
    );
    let text = LINE.replace("\"NORMAL\"", "1.2");
    let text = text.replacen("ea_n = 1.0e6", &fibre, 1);
    scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
}

/// The same with a rope whose tension follows a table.
fn line_of_table() -> Scene {
    let table = "strain = [0.0, 0.01, 0.04, 0.08]\ntension_n = [0.0, 2e3, 3e4, 2e5]";
    let text = LINE.replace("\"NORMAL\"", "1.2");
    let text = text.replacen("ea_n = 1.0e6", table, 1);
    scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
}

/// The same with a rope that creeps: viscoelastic with a stiffness, or of the Syrope model.
fn line_of_creep(model: &str) -> Scene {
    let slow = match model {
        "viscoelastic" => "ea_n = 1.0e6",
        _ => {
            "strain = [0.0, 0.02, 0.05, 0.1]\ntension_n = [0.0, 1e4, 3e4, 1e5]\npermanent_strain_ratio = 0.4\n\
             working_curve = \"exponential\"\nworking_curve_shape = 1.2\npast_tension_n = 2e4"
        }
    };
    let creep = format!(
        "{slow}\ncreep_model = \"{model}\"\ndynamic_ea_n = 3e6\ndynamic_ea_per_tension = 15.0\n\
         slow_damping_n_s = 4e6\nfast_damping_n_s = 1e4"
    );
    let text = LINE
        .replace("\"NORMAL\"", "1.2")
        .replacen("axial_damping_n_s = 2.0e4\n", "", 1)
        .replacen("ea_n = 1.0e6", &creep, 1);
    scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
}

/// The same with drag on the stretched or on the unstretched length.
fn line_of_drag_length(word: &str) -> Scene {
    let text = LINE.replace("\"NORMAL\"", "1.2");
    let text = format!("{text}\n[environment]\ndrag_length = \"{word}\"\n");
    scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
}

/// The same line in irregular waves, its upper end 12 m above still water, leaving the water there or not.
fn line_at_sea(surface: &str, stretching: &str, depth: &str) -> Scene {
    let text = LINE
        .replace("\"NORMAL\"", "1.2")
        .replace("position_m = [0, 0, 0]", "position_m = [3.0, -8.0, 12.0]");
    let sea = format!(
        "[environment]\nwater_surface = \"{surface}\"\n[waves]\nkind = \"irregular\"\n\
         significant_height_m = 5.0\npeak_period_s = 8.0\ncomponents = 20\ndirection_deg = 40.0\n\
         stretching = \"{stretching}\"\n{depth}\n"
    );
    scene::build(&seacable::case::parse_keys(&(text + &sea)).unwrap(), 1).unwrap()
}

/// A state near the straight start, displaced, moving and accelerating at random.
pub(crate) fn state(scene: &Scene, numbers: &[f64], strain: f64, speed: f64) -> State {
    let mut next = numbers.iter().copied().cycle();
    let mut vector = |size: f64| V3::from_fn(|_, _| size * next.next().unwrap());
    let mut state = scene.initial_state();
    for i in 1..scene.nodes() {
        state.x[i] = state.x[i] * (1.0 + strain) + vector(0.02);
        state.v[i] = vector(speed);
        state.a[i] = vector(2.0);
    }
    scene.update_wave_kinematics(23.0, &mut state);
    state
}

/// The largest difference between the tangent and central differences, as a share of its largest entry.
pub(crate) fn mismatch(scene: &Scene, state: &State, c: Factors) -> f64 {
    let n = scene.nodes();
    let mut tangent = BlockBand::new(n);
    let mut r = vec![V3::zeros(); n];
    scene.linearise(0.0, state, c, &mut r, &mut tangent);
    let mut plain = r.clone();
    scene.residual(0.0, state, &mut plain);
    let size = tangent
        .diag
        .iter()
        .map(nalgebra::Matrix::amax)
        .fold(0.0, f64::max);
    let force = r.iter().map(V3::amax).fold(1.0, f64::max);
    let mut worst = r
        .iter()
        .zip(&plain)
        .map(|(a, b)| (a - b).amax() / force)
        .fold(0.0, f64::max);
    for node in 1..n {
        for axis in 0..3 {
            let h = 1e-7;
            let shifted = |sign: f64| {
                let mut moved = state.clone();
                moved.x[node][axis] += sign * h * c.stiffness;
                moved.v[node][axis] += sign * h * c.damping;
                moved.a[node][axis] += sign * h * c.mass;
                let mut r = vec![V3::zeros(); n];
                scene.residual(0.0, &moved, &mut r);
                r
            };
            let (up, down) = (shifted(1.0), shifted(-1.0));
            for row in node - 1..(node + 2).min(n) {
                let difference = (up[row] - down[row]) / (2.0 * h);
                let block = match row as isize - node as isize {
                    -1 => tangent.upper[row],
                    0 => tangent.diag[row],
                    _ => tangent.lower[row],
                };
                worst = f64::max(worst, (block.column(axis) - difference).amax() / size);
            }
        }
    }
    worst
}

#[test]
fn the_tangent_of_a_current_over_places_is_the_finite_difference() {
    let places = [-40.0, 0.0, 60.0];
    let mut rows = Vec::new();
    for x in places {
        for y in places {
            for z in places {
                let velocity = V3::new(0.3 + 0.01 * y, 0.02 * x + 1e-4 * y * z, 0.003 * z);
                rows.push(([0.0, x, y, z], velocity));
            }
        }
    }
    let grid = std::sync::Arc::new(CurrentGrid::of_rows(&rows).unwrap());
    for normal in ["1.2", "\"jia-2019-normal\""] {
        let mut scene = line(normal);
        scene.line.current = CurrentProfile::Grid(std::sync::Arc::clone(&grid));
        let state = state(&scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, 0.4);
        let c = Factors {
            mass: 0.7,
            damping: 1.3,
            stiffness: 1.1,
        };
        let worst = mismatch(&scene, &state, c);
        assert!(worst < 1e-6, "{normal}: {worst}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn tangent_is_the_finite_difference(
        numbers in proptest::collection::vec(-1.0f64..1.0, 97),
        strain in prop_oneof![Just(0.03), Just(-0.03)],
        speed in prop_oneof![Just(0.05), Just(2.0)],
        mass in 0.0f64..2.0,
        damping in 0.0f64..2.0,
        stiffness in 0.0f64..1.0,
    ) {
        let scene = line("1.2");
        let state = state(&scene, &numbers, strain, speed);
        // The strains of all segments stay on one side of slack, and damping below the elastic part.
        let c = Factors { mass, damping, stiffness };
        prop_assert!(mismatch(&scene, &state, c) < 1e-5, "{}", mismatch(&scene, &state, c));
    }

    #[test]
    fn tangent_of_dynamic_stiffness(
        numbers in proptest::collection::vec(-1.0f64..1.0, 97),
        strain in prop_oneof![Just(0.03), Just(-0.03)],
        reading in prop_oneof![Just("secant"), Just("about-the-mean")],
        scope in prop_oneof![Just("segment"), Just("rope")],
        rests: bool,
        mass in 0.0f64..2.0,
        damping in 0.0f64..2.0,
        stiffness in 0.0f64..1.0,
    ) {
        let scene = line_of_fibre(reading, scope);
        let mut state = state(&scene, &numbers, strain, 0.05);
        if !rests {
            let mut before = self::state(&scene, &numbers, 0.02, 0.0);
            scene.commit(0.0, 0.0, &mut before);
            scene.commit(3.0, 3.0, &mut before);
            state.memory = before.memory;
            state.memory.time = 0.0;
        }
        let c = Factors { mass, damping, stiffness };
        prop_assert!(mismatch(&scene, &state, c) < 1e-5, "{}", mismatch(&scene, &state, c));
    }

    #[test]
    fn tangent_of_creep(
        numbers in proptest::collection::vec(-1.0f64..1.0, 97),
        strain in prop_oneof![Just(0.03), Just(0.06), Just(-0.03)],
        model in prop_oneof![Just("viscoelastic"), Just("syrope")],
        since in prop_oneof![Just(0.0), Just(0.01), Just(0.5), Just(20.0)],
        mass in 0.0f64..2.0,
        damping in 0.0f64..2.0,
        stiffness in 0.0f64..1.0,
    ) {
        let scene = line_of_creep(model);
        let mut state = state(&scene, &numbers, strain, 0.05);
        let mut before = self::state(&scene, &numbers, 0.97 * strain, 0.0);
        scene.commit(0.0, 0.0, &mut before);
        state.memory = before.memory;
        state.memory.time = -since;
        let c = Factors { mass, damping, stiffness };
        prop_assert!(mismatch(&scene, &state, c) < 1e-5, "{}", mismatch(&scene, &state, c));
    }

    #[test]
    fn tangent_of_a_tension_strain_table(
        numbers in proptest::collection::vec(-1.0f64..1.0, 97),
        strain in prop_oneof![Just(0.03), Just(0.1), Just(-0.03)],
        mass in 0.0f64..2.0,
        damping in 0.0f64..2.0,
        stiffness in 0.0f64..1.0,
    ) {
        let scene = line_of_table();
        let state = state(&scene, &numbers, strain, 0.05);
        let c = Factors { mass, damping, stiffness };
        prop_assert!(mismatch(&scene, &state, c) < 1e-5, "{}", mismatch(&scene, &state, c));
    }
}

/// Taut and slack, fast enough for drag to be a large part of the tangent.
#[test]
fn tangent_by_either_drag_length() {
    let numbers = [0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9];
    let c = Factors {
        mass: 3.0,
        damping: 0.5,
        stiffness: 1.0,
    };
    for word in ["stretched", "unstretched"] {
        let scene = line_of_drag_length(word);
        for strain in [0.1, 0.03, -0.1] {
            let state = state(&scene, &numbers, strain, 3.0);
            let off = mismatch(&scene, &state, c);
            assert!(off < 1e-5, "{word} {strain}: {off}");
        }
    }
}

/// Part of the line under a sloping bed, grips before the limit and beyond it, laid and not, and the law that has none.
#[test]
fn tangent_on_a_rough_slope() {
    for friction in [
        "friction = 0.5",
        "friction = 1e-3",
        "friction = 2e-3\nfriction_lateral = 5e-3",
        "friction = 0.3\nfriction_law = \"zhu-2017\"\nslip_speed_m_per_s = 0.5",
    ] {
        let bed = format!(
            "[seabed]\ndepth_m = 20.0\nslope_deg = 9.0\nslope_azimuth_deg = 70.0\nstiffness_n_per_m3 = 1e4\ndamping_n_s_per_m3 = 500.0\n{friction}\n[ends.a]"
        );
        let text = LINE.replace("\"NORMAL\"", "1.2").replace("[ends.a]", &bed);
        let scene = scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap();
        for (laid, speed) in [(false, 0.05), (true, 0.05), (false, 0.9)] {
            let mut state = state(&scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, speed);
            for grip in &mut state.memory.grips {
                grip.laid = laid;
                grip.at += V3::new(0.1, -0.2, 0.3);
            }
            for c in [
                Factors {
                    mass: 0.0,
                    damping: 0.0,
                    stiffness: 1.0,
                },
                Factors {
                    mass: 3.0,
                    damping: 0.5,
                    stiffness: 1.0,
                },
            ] {
                let off = mismatch(&scene, &state, c);
                assert!(off < 1e-5, "{friction} {laid} {speed} {c:?}: {off}");
            }
        }
    }
}

/// A payload and a clump below a sloping bed, and lifted off it by suction: friction holding and sliding. A body that rotates
/// bears on a place between its two nodes.
#[test]
fn tangent_of_bodies_on_the_bed() {
    const BODY: &str = "breakout_n = 4e3\nbreakout_distance_m = 5.0\nbed_area_m2 = 1.5\n";
    let rotation = "[payload.rotation]\ncentre_of_gravity_m = 2.0\ninertia_kg_m2 = 9e3\n";
    let clump = format!(
        "[[clumps]]\nname = \"clump\"\nsection = \"rope\"\nat_m = 20.0\nmass_kg = 300.0\nwet_mass_kg = 200.0\n{BODY}"
    );
    for (rotates, friction, off) in [
        (false, "friction = 0.5", 0.0),
        (false, "friction = 1e-3", 0.3),
        (true, "friction = 0.5", 0.0),
        (true, "friction = 1e-3", 0.3),
        (
            true,
            "friction = 0.3\nfriction_law = \"zhu-2017\"\nslip_speed_m_per_s = 0.5",
            0.0,
        ),
    ] {
        let bed = |depth: f64| {
            format!(
                "[seabed]\ndepth_m = {depth:?}\nslope_deg = 9.0\nslope_azimuth_deg = 70.0\nstiffness_n_per_m3 = 1e4\ndamping_n_s_per_m3 = 500.0\n{friction}\n{clump}[ends.a]"
            )
        };
        let scene = |depth: f64| {
            let text = LINE
                .replace("\"NORMAL\"", "1.2")
                .replace("[ends.a]", &bed(depth));
            let text = text
                .replace(
                    "drag_area_m2 = [3.0, 4.0, 5.0]",
                    &format!("drag_area_m2 = 3.0\nbottom_m = 1.0\n{BODY}"),
                )
                .replace(
                    "[start]",
                    &format!("{}\n[start]", if rotates { rotation } else { "" }),
                );
            scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap()
        };
        let on_bed = scene(20.0);
        let mut before = on_bed.initial_state();
        on_bed.commit(0.0, 0.0, &mut before);
        assert!(before.memory.bodies.iter().any(|body| body.stuck));
        // The same with the bed further down, so that suction holds the payload.
        for (scene, what) in [(&on_bed, "pressed"), (&scene(40.0), "held by suction")] {
            let mut state = state(scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, 0.05);
            state.memory = before.memory.clone();
            for body in &mut state.memory.bodies {
                body.grip.at = state.x[3] + V3::new(off, off, 0.0);
            }
            for c in [
                Factors {
                    mass: 0.0,
                    damping: 0.0,
                    stiffness: 1.0,
                },
                Factors {
                    mass: 3.0,
                    damping: 0.5,
                    stiffness: 1.0,
                },
            ] {
                let off = mismatch(scene, &state, c);
                assert!(off < 1e-5, "{rotates} {friction} {what} {c:?}: {off}");
            }
        }
    }
}

#[test]
fn tangent_astride_the_drag_crisis() {
    let scene = line("\"jia-2019-normal\"");
    let crisis = 1e5 * 1.19e-6 / 0.2;
    for share in [0.2, 0.45, 0.55, 0.9] {
        let mut state = state(&scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, 0.0);
        // Node 1 below and node 2 above the critical speed, the crisis at a share of the way between.
        let across = V3::y();
        for (node, offset) in [(1, -share), (2, 1.0 - share), (3, 2.0 - share)] {
            let water = scene.line.current.at(&state.x[node]).0;
            state.v[node] = water + across * (crisis + 0.3 * offset);
        }
        for c in [
            Factors {
                mass: 0.0,
                damping: 1.0,
                stiffness: 0.0,
            },
            Factors {
                mass: 0.0,
                damping: 0.0,
                stiffness: 1.0,
            },
            Factors {
                mass: 3.0,
                damping: 2.0,
                stiffness: 1.0,
            },
        ] {
            assert!(
                mismatch(&scene, &state, c) < 1e-5,
                "share {share} {c:?}: {}",
                mismatch(&scene, &state, c)
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn tangent_in_waves_and_across_the_surface(
        numbers in proptest::collection::vec(-1.0f64..1.0, 97),
        strain in prop_oneof![Just(0.03), Just(-0.03)],
        surface in prop_oneof![Just("ignored"), Just("crossed")],
        stretching in prop_oneof![Just("none"), Just("vertical"), Just("wheeler"), Just("linear")],
        depth in prop_oneof![Just(""), Just("depth_m = 60.0")],
        mass in 0.0f64..2.0,
        damping in 0.0f64..2.0,
        stiffness in 0.0f64..1.0,
    ) {
        let scene = line_at_sea(surface, stretching, depth);
        let state = state(&scene, &numbers, strain, 2.0);
        let c = Factors { mass, damping, stiffness };
        prop_assert!(mismatch(&scene, &state, c) < 1e-5, "{}", mismatch(&scene, &state, c));
    }
}

#[test]
fn the_explicit_acceleration_leaves_no_residual() {
    for scene in [
        line("\"jia-2019-normal\""),
        line_at_sea("ignored", "wheeler", ""),
        line_at_sea("crossed", "vertical", ""),
    ] {
        leaves_no_residual(&scene);
    }
}

fn leaves_no_residual(scene: &Scene) {
    let mut state = state(scene, &[0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9], 0.03, 0.4);
    scene.accelerate(0.0, &mut state);
    let mut r = vec![V3::zeros(); scene.nodes()];
    scene.residual(0.0, &state, &mut r);
    for i in scene.free() {
        assert!(
            r[i].norm() < 1e-9 * scene.force_scale(),
            "node {i}: {}",
            r[i].norm()
        );
    }
}

/// A line paid out at an end, with a length, a rate and an acceleration beside those of its mesh.
fn paid_out(end: usize, change: [f64; 3]) -> (Scene, PaidOut) {
    let mut scene = line("1.2");
    scene.feed(end);
    let mesh = scene.fed_end(end).unwrap().now().length;
    let now = PaidOut {
        length: mesh * 1.1 + change[0],
        rate: 0.7 + change[1],
        acceleration: -0.4 + change[2],
    };
    scene.pay_out(end, now);
    (scene, now)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn tangent_of_a_line_that_is_paid_out(
        numbers in proptest::collection::vec(-1.0f64..1.0, 97),
        end in 0usize..2,
        mass in 0.0f64..2.0,
        damping in 0.0f64..2.0,
        stiffness in 0.0f64..1.0,
    ) {
        let c = Factors { mass, damping, stiffness };
        let (scene, _) = paid_out(end, [0.0; 3]);
        let state = state(&scene, &numbers, 0.15, 0.05);
        prop_assert!(mismatch(&scene, &state, c) < 1e-5, "{}", mismatch(&scene, &state, c));
        // What the length itself changes: of the residuals of both nodes, and of its own equation.
        let h = 1e-6;
        let n = scene.nodes();
        let at = |scene: &Scene, state: &State| {
            let mut r = vec![V3::zeros(); n];
            scene.residual(0.0, state, &mut r);
            let (drum, _) = scene.drum(end, 0.0, state, c).unwrap();
            (r, drum)
        };
        let shifted = |sign: f64| {
            let by = [stiffness, damping, mass].map(|factor| sign * h * factor);
            at(&paid_out(end, by).0, &state)
        };
        let ((up, up_drum), (down, down_drum)) = (shifted(1.0), shifted(-1.0));
        let (drum, of_nodes) = scene.drum(end, 0.0, &state, c).unwrap();
        let nodes = scene.fed_end(end).unwrap().nodes(&scene.line);
        let size = of_nodes.iter().map(V3::amax).fold(1.0, f64::max);
        for (node, of) in nodes.into_iter().zip(of_nodes) {
            let difference = (up[node] - down[node]) / (2.0 * h);
            prop_assert!((of - difference).amax() < 1e-5 * size, "{of} {difference}");
        }
        let by_length = (up_drum.residual - down_drum.residual) / (2.0 * h);
        prop_assert!((drum.by_length - by_length).abs() < 1e-5 * size, "{} {by_length}", drum.by_length);
        let pull = (up_drum.pull - down_drum.pull) / (2.0 * h);
        prop_assert!((drum.pull_by_length - pull).amax() < 1e-5 * size);
        for (node, (by, of_pull)) in nodes.into_iter().zip([
            (drum.by_end, -drum.pull_by_neighbour),
            (drum.by_neighbour, drum.pull_by_neighbour),
        ]) {
            for axis in 0..3 {
                let moved = |sign: f64| {
                    let mut moved = state.clone();
                    moved.x[node][axis] += sign * h * stiffness;
                    moved.v[node][axis] += sign * h * damping;
                    moved.a[node][axis] += sign * h * mass;
                    at(&scene, &moved).1
                };
                let (up, down) = (moved(1.0), moved(-1.0));
                let difference = (up.residual - down.residual) / (2.0 * h);
                prop_assert!((by[axis] - difference).abs() < 1e-5 * size, "{} {difference}", by[axis]);
                let pull = (up.pull - down.pull) / (2.0 * h);
                prop_assert!((of_pull.column(axis) - pull).amax() < 1e-5 * size);
            }
        }
    }
}

#[test]
fn what_is_paid_out_is_all_there() {
    for end in [0, 1] {
        let whole = line("1.2");
        let mut scene = whole.clone();
        scene.feed(end);
        let mesh = scene.fed_end(end).unwrap().now().length;
        let out = 0.37 * mesh;
        let now = PaidOut {
            length: mesh + out,
            ..PaidOut::default()
        };
        scene.pay_out(end, now);
        let sums = |scene: &Scene| {
            let line = &scene.line;
            let length: f64 = line.segments.iter().map(|s| s.axial.length).sum();
            (
                length,
                line.mass.iter().sum::<f64>(),
                line.weight.iter().sum::<f64>(),
            )
        };
        let (before, after) = (sums(&whole), sums(&scene));
        let section = whole.line.segments[end * (whole.line.segments.len() - 1)];
        let per_length = |half: f64| 2.0 * half / mesh;
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-14;
        assert!(close(after.0, before.0 + out));
        assert!(close(
            after.1,
            before.1 + per_length(section.half_mass) * out
        ));
        assert!(close(
            after.2,
            before.2 + per_length(section.half_weight) * out
        ));
        scene.pay_out(
            end,
            PaidOut {
                length: mesh,
                ..PaidOut::default()
            },
        );
        assert!(close(sums(&scene).1, before.1));
    }
}

/// Clumps with drag and added mass across and along the line: at an inner node, where two sections meet, at the end with the payload, two at one node;
/// taut, slack and folded, in a sheared current, in waves, through the surface.
#[test]
fn tangent_of_clumps_aligned_with_the_line() {
    let clump = |name: &str, section: &str, at: f64| {
        format!(
            "[[clumps]]\nname = \"{name}\"\nsection = \"{section}\"\nat_m = {at:?}\nmass_kg = 900.0\nwet_mass_kg = -600.0\n\
             drag_area_normal_m2 = 6.0\ndrag_area_tangential_m2 = 2.5\nadded_mass_normal_kg = 900.0\nadded_mass_tangential_kg = 70.0\n"
        )
    };
    let clumps = [
        clump("inner", "rope", 20.0),
        clump("joint", "wire", 0.0),
        clump("beside", "rope", 30.0),
        clump("end", "wire", 20.0),
    ]
    .concat();
    let along = "drag_area_m2 = 2.0\ndrag_area_tangential_m2 = 3.0\n";
    let still = LINE
        .replace("\"NORMAL\"", "1.2")
        .replace("drag_area_m2 = 2.0\n", along);
    let sea = still.replace("position_m = [0, 0, 0]", "position_m = [3.0, -8.0, 12.0]");
    let waves = "[environment]\nwater_surface = \"crossed\"\n[waves]\nkind = \"irregular\"\n\
                 significant_height_m = 5.0\npeak_period_s = 8.0\ncomponents = 20\ndirection_deg = 40.0\n";
    let numbers = [0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9];
    for (text, plain) in [
        (format!("{still}{clumps}"), still.clone()),
        (format!("{sea}{waves}{clumps}"), format!("{sea}{waves}")),
    ] {
        let build = |text: &str| scene::build(&seacable::case::parse_keys(text).unwrap(), 1);
        let (scene, bare) = (build(&text).unwrap(), build(&plain).unwrap());
        for (strain, speed) in [(0.03, 0.4), (-0.03, 2.0), (-0.9, 3.0)] {
            let state = state(&scene, &numbers, strain, speed);
            for c in [
                Factors {
                    mass: 0.0,
                    damping: 0.0,
                    stiffness: 1.0,
                },
                Factors {
                    mass: 0.7,
                    damping: 1.3,
                    stiffness: 1.1,
                },
            ] {
                let off = mismatch(&scene, &state, c);
                assert!(off < 1e-6, "{strain} {speed} {c:?}: {off}");
            }
            // No faster than the bound of explicit steps says.
            let decay = |scene: &Scene| scene.fastest_drag_decay(1..scene.nodes(), &state).0;
            assert!(decay(&scene) > 0.0 && decay(&bare) > 0.0);
        }
    }
}
