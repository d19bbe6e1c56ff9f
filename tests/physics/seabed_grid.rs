//! Lines on a sea bed with depths over a grid: against planes, the closed form on a slope, finite differences, energy.

use std::fmt::Write as _;

use crate::energy::out_by;
use crate::tangents::{LINE, mismatch, state};
use crate::{march, rest};
use seacable::numerics::V3;
use seacable::scene::{self, Scene};
use seacable::solve::{Factors, State};
use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties};
use seacable::statics::equilibrium::EquilibriumSearch;

/// A table of depths every 50 m from -400 to 1600 m, as a key of a case.
fn depths(of: impl Fn(f64, f64) -> f64) -> String {
    let mut table = "x_m,y_m,depth_m\\n".to_owned();
    for i in -8..=32 {
        for j in -8..=8 {
            let (x, y) = (50.0 * f64::from(i), 50.0 * f64::from(j));
            write!(table, "{x:?},{y:?},{:?}\\n", of(x, y)).unwrap();
        }
    }
    format!("files.\"bed.csv\".text = \"{table}\"")
}

/// A chain of 900 m from an anchor on the bed at x = y = 0, 100 m deep, to an end at (800, 60, -10) m.
fn chain(bed: &str, files: &str) -> Scene {
    line((900.0, 60.0, 5e8), bed, files)
}

/// The same of this length, with its top at this y \[m\] and of this stiffness \[N\].
fn line((length, y, ea): (f64, f64, f64), bed: &str, files: &str) -> Scene {
    rest::build(&format!(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        line = {{ length_m = {length:?}, segments = 150 }}
        materials.rope = {{ diameter_m = 0.1, mass_kg_per_m = 100.0, wet_weight_kg_per_m = 87.0, ea_n = {ea:?} }}
        ends.a = {{ name = "anchor", kind = "anchor", position_m = [0.0, 0.0, -100.0] }}
        ends.b = {{ name = "top", kind = "fixed", position_m = [840.0, {y:?}, -10.0] }}
        seabed = {{ depth_m = 100.0, {bed} }}
        {files}
        "#
    ))
}

fn settle(scene: &Scene) -> State {
    let mut state = scene.initial_state();
    let found = EquilibriumSearch::default().run(scene, 0.0, &mut state);
    assert!(found.is_ok(), "{found:?}");
    state
}

fn farthest(one: &State, other: &State) -> f64 {
    let apart = one.x.iter().zip(&other.x).map(|(a, b)| (a - b).norm());
    apart.fold(0.0, f64::max)
}

#[test]
fn a_level_grid_is_the_level_bed() {
    let level = settle(&chain("stiffness_n_per_m3 = 1e7", ""));
    for way in ["smooth", "bilinear"] {
        let bed = format!(
            "stiffness_n_per_m3 = 1e7, depth_file = \"bed.csv\", interpolation = \"{way}\""
        );
        let grid = settle(&chain(&bed, &depths(|_, _| 100.0)));
        let apart = farthest(&level, &grid);
        assert!(apart < 1e-6, "{way}: {apart} m");
    }
}

#[test]
fn a_plane_grid_is_the_sloping_bed() {
    let slope: f64 = 3.0;
    let plane = settle(&chain(
        "stiffness_n_per_m3 = 1e7, slope_deg = 3.0, slope_azimuth_deg = 20.0",
        "",
    ));
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let tan = slope.to_radians().tan();
    let files = depths(|x, y| 100.0 - tan * (x * cos + y * sin));
    for way in ["smooth", "bilinear"] {
        let bed = format!(
            "stiffness_n_per_m3 = 1e7, depth_file = \"bed.csv\", interpolation = \"{way}\""
        );
        let grid = settle(&chain(&bed, &files));
        // The bed gives way by a millimetre, over a grid vertically.
        let apart = farthest(&plane, &grid);
        assert!(apart < 1e-3, "{way}: {apart} m");
    }
}

#[test]
fn a_chain_up_a_slope_meets_the_closed_form() {
    const LENGTH: f64 = 855.0;
    let tan = 0.05;
    let files = depths(|x, _| 100.0 - tan * x);
    let bed = "stiffness_n_per_m3 = 1e7, depth_file = \"bed.csv\"";
    let scene = line((LENGTH, 0.0, 5e8), bed, &files);
    let found = settle(&scene);
    let sections = [SectionProperties::new(LENGTH, 87.0 * 9.80665, 5e8)];
    let exact = CatenaryLine {
        ends: EndOffset {
            x_m: 840.0,
            z_m: 90.0,
        },
        sections: &sections,
        bed: Some(RigidBed {
            below_a_m: 0.0,
            slope_rad: f64::atan(tan),
            friction: 0.0,
        }),
        surface_above_a_m: None,
    }
    .solve()
    .unwrap();
    let segment = &scene.line.segments[149];
    let stretch = (found.x[150] - found.x[149]).norm() / segment.axial.length - 1.0;
    let tension = 5e8 * stretch;
    let wanted = exact.at(LENGTH * (1.0 - 0.5 / 150.0)).tension_n;
    assert!(
        (tension / wanted - 1.0).abs() < 2e-3,
        "{tension} N, {wanted} N"
    );
    let on_bed = found
        .x
        .iter()
        .filter(|x| x.z + 100.0 - tan * x.x < 1e-3)
        .count();
    assert!(
        (LENGTH / 150.0 * on_bed as f64 - exact.on_bed_m).abs() < 15.0,
        "{on_bed} {}",
        exact.on_bed_m
    );
}

/// Part of the line below hills and below a tilted plane, without friction, held by it and sliding.
#[test]
fn tangent_over_hills() {
    let hills = depths(|x, y| 20.0 + 8.0 * (0.02 * x).sin() * (0.015 * y).cos() - 0.1 * x);
    let plane = depths(|x, y| 20.0 - 0.1 * x + 0.06 * y);
    for (table, way) in [
        (&hills, "smooth"),
        (&hills, "bilinear"),
        (&plane, "smooth"),
        (&plane, "bilinear"),
    ] {
        for friction in [
            "",
            "friction = 0.5",
            "friction = 1e-3",
            "friction = 2e-3\nfriction_lateral = 5e-3",
            "friction = 0.3\nfriction_law = \"zhu-2017\"\nslip_speed_m_per_s = 0.5",
        ] {
            let bed = format!(
                "[seabed]\ndepth_m = 20.0\ndepth_file = \"bed.csv\"\ninterpolation = \"{way}\"\nstiffness_n_per_m3 = 1e4\ndamping_n_s_per_m3 = 500.0\n{friction}\n[files]\n{}\n[ends.a]",
                table.trim_start_matches("files.")
            );
            let text = LINE.replace("\"NORMAL\"", "1.2").replace("[ends.a]", &bed);
            let scene = scene::build(&seacable::case::parse_keys(&text).unwrap(), 1).unwrap();
            assert_tangent_over_hills(&scene, &format!("{way} {friction}"));
        }
    }
}

fn assert_tangent_over_hills(scene: &Scene, what: &str) {
    let numbers = [0.3, -0.7, 0.5, 0.1, -0.2, 0.6, -0.9];
    for (laid, speed) in [(false, 0.05), (true, 0.05), (false, 0.9), (false, 5.0)] {
        let mut state = state(scene, &numbers, 0.03, speed);
        for grip in &mut state.memory.grips {
            grip.laid = laid;
            grip.at += V3::new(0.1, -0.2, 0.3);
        }
        let touching = (0..state.x.len())
            .any(|i| scene.elements.bed.as_ref().unwrap().height(&state.x[i]) < 0.0);
        assert!(touching, "no node is below the bed");
        for (mass, damping, stiffness) in [(0.0, 0.0, 1.0), (3.0, 0.5, 1.0)] {
            let c = Factors {
                mass,
                damping,
                stiffness,
            };
            let off = mismatch(scene, &state, c);
            assert!(off < 1e-5, "{what} {laid} {speed} {c:?}: {off}");
        }
    }
}

/// A chain plucked on a hillside.
fn plucked(damping: f64) -> (Scene, State) {
    let files = depths(|x, y| 100.0 - 6.0 * (0.01 * x).sin() * (0.008 * y).cos());
    let bed = format!("damping_n_s_per_m3 = {damping:?}, depth_file = \"bed.csv\"");
    let scene = line((870.0, 60.0, 1e7), &bed, &files);
    let mut state = settle(&scene);
    let last = state.x.len() - 1;
    for (i, v) in state.v.iter_mut().enumerate().take(last).skip(1) {
        let bump = (std::f64::consts::PI * i as f64 / last as f64).sin();
        *v = V3::new(0.0, 2.0 * bump, 0.0);
    }
    (scene, state)
}

/// Without damping nothing takes energy out: the push of the bed is the gradient of what its springs store.
#[test]
fn a_chain_on_hills_keeps_its_energy() {
    let (scene, start) = plucked(0.0);
    let given: f64 = start
        .v
        .iter()
        .zip(&scene.line.mass)
        .map(|(v, mass)| 0.5 * mass * v.norm_squared())
        .sum();
    let out = [0.004, 0.002].map(|step| {
        let mut state = start.clone();
        let before = scene.energy(&state);
        march::march(
            march::rk4(&scene),
            &scene,
            &mut state,
            (4.0, step),
            |_, _| {},
        );
        let aside: f64 = state
            .x
            .iter()
            .zip(&start.x)
            .map(|(a, b)| (a - b).norm())
            .fold(0.0, f64::max);
        assert!(aside > 1.0, "the chain moved by {aside} m");
        (scene.energy(&state) - before).abs() / given
    });
    assert!(out[1] < 1e-5 && out[0] < 1e-4, "{out:?}");
}

/// With damping, what takes energy out is booked.
#[test]
fn the_books_over_hills_balance() {
    let (scene, start) = plucked(2e3);
    let out = [0.004, 0.002].map(|step| {
        let mut state = start.clone();
        out_by(&scene, march::rk4(&scene), &mut state, (4.0, step)).0
    });
    assert!(out[0] < 1e-3 && out[1] < 0.5 * out[0], "{out:?}");
}
