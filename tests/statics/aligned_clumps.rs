//! Clumps with drag across and along the line: ten modules around a taut line in a current, and a pipe of the same drag by length.

use std::fmt::Write;

use seacable::numerics::V3;
use seacable::scene::{self, Scene};
use seacable::solve::{Kinematics, State};

use crate::rest;

/// Length of the line \[m\], modules on it, their drag areas across and along it \[m²\].
const LENGTH: f64 = 100.0;
const MODULES: usize = 10;
const AREAS: [f64; 2] = [12.0, 3.0];
/// Half of the density of the water \[kg/m³\].
const HALF: f64 = 512.5;

/// A taut weightless line in a current, its end B at this place, with drag of its own; more is put at its end.
fn line(b: [f64; 3], current: [f64; 2], drag: &str, more: &str) -> String {
    let [speed, direction] = current;
    format!(
        "case.title = \"modules\"\nenvironment.water_density_kg_per_m3 = {:?}\nenvironment.drag_length = \"unstretched\"\n\
         current = {{ speed_m_per_s = {speed:?}, direction_deg = {direction:?} }}\nsolver.method = \"static\"\n\
         materials.rope = {{ diameter_m = 0.5, mass_kg_per_m = 200.0, wet_weight_kg_per_m = 0.0, ea_n = 1e8, {drag} }}\n\
         line = [{{ name = \"rope\", material = \"rope\", length_m = {LENGTH:?}, segments = 20 }}]\n\
         ends.a = {{ name = \"a\", kind = \"fixed\", position_m = [0.0, 0.0, -200.0] }}\n\
         ends.b = {{ name = \"b\", kind = \"fixed\", position_m = {b:?} }}\n{more}",
        2.0 * HALF
    )
}

/// Modules in the middle of equal parts of the line, with these keys.
fn modules(keys: &str) -> String {
    let mut text = String::new();
    for k in 0..MODULES {
        let at = (k as f64 + 0.5) * LENGTH / MODULES as f64;
        writeln!(
            text,
            "[[clumps]]\nname = \"m{k}\"\nsection = \"rope\"\nat_m = {at:?}\nmass_kg = 100.0\nwet_mass_kg = 0.0\n{keys}"
        )
        .unwrap();
    }
    text
}

const NONE: &str = "drag_normal = 0.0, drag_tangential = 0.0";

fn aligned() -> String {
    let [across, along] = AREAS;
    modules(&format!(
        "drag_area_normal_m2 = {across:?}\ndrag_area_tangential_m2 = {along:?}\n"
    ))
}

/// The line's own drag that is that of the modules by length: coefficient times diameter times length is the area.
fn pipe() -> String {
    let [across, along] = AREAS.map(|area| area * MODULES as f64 / (LENGTH * 0.5));
    format!("drag_normal = {across:?}, drag_tangential = {along:?}")
}

fn at_rest(text: &str) -> (Scene, State) {
    let scene = scene::build(&seacable::case::parse_keys(text).unwrap(), 1).unwrap();
    let state = rest::at_rest(&scene);
    (scene, state)
}

/// The forces of the line on what holds its ends A and B \[N\].
fn forces(text: &str) -> [V3; 2] {
    let (scene, state) = at_rest(text);
    [0, scene.nodes() - 1].map(|node| scene.end_force(node, &state))
}

/// End B of a line at this inclination, stretched by two per cent.
fn inclined(degrees: f64) -> [f64; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [1.02 * LENGTH * cos, 0.0, -200.0 + 1.02 * LENGTH * sin]
}

#[test]
fn ten_modules_drag_as_a_pipe_of_their_area_by_length() {
    for degrees in [0.0, 35.0, 70.0] {
        let b = inclined(degrees);
        let by_modules = forces(&line(b, [1.5, 20.0], NONE, &aligned()));
        let by_pipe = forces(&line(b, [1.5, 20.0], &pipe(), ""));
        let size = (by_pipe[0] + by_pipe[1]).norm();
        assert!(size > 1e4, "{size}");
        for (own, other) in by_modules.iter().zip(&by_pipe) {
            assert!(
                (own - other).norm() < 6e-3 * size,
                "{degrees}: {own} {other}"
            );
        }
        // All of it, by the closed form of a straight line.
        let t = V3::new(b[0], b[1], b[2] + 200.0).normalize();
        let azimuth = 20.0_f64.to_radians();
        let u = V3::new(1.5 * azimuth.cos(), 1.5 * azimuth.sin(), 0.0);
        let (along, across) = (t * t.dot(&u), u - t * t.dot(&u));
        let force = across * (AREAS[0] * across.norm()) + along * (AREAS[1] * along.norm());
        let force = force * (HALF * MODULES as f64);
        let found = by_modules[0] + by_modules[1];
        assert!(
            (found - force).norm() < 2e-3 * size,
            "{degrees}: {found} {force}"
        );
        // A drag area whichever way the water passes does not follow the line.
        let around = modules(&format!("drag_area_m2 = {:?}\n", AREAS[0]));
        let by_axes = forces(&line(b, [1.5, 20.0], NONE, &around));
        let off = (by_axes[0] + by_axes[1] - force).norm();
        assert!(off > 0.1 * size, "{degrees}: {off}");
    }
}

/// Floats and modules over the whole line have the drag of a pipe, across it and along it.
#[test]
fn floats_and_modules_drag_along_the_line_where_asked_for() {
    let b = inclined(35.0);
    let [across, along] = AREAS.map(|area| area * MODULES as f64);
    let same = |found: [V3; 2], expected: [V3; 2]| {
        for (own, other) in found.iter().zip(&expected) {
            assert!((own - other).norm() < 1e-9 * other.norm(), "{own} {other}");
        }
    };
    let floats = format!(
        "floats = [{{ section = \"rope\", lift_kg = 0.0, drag_area_m2 = {across:?}, drag_area_tangential_m2 = {along:?} }}]\n"
    );
    let by_pipe = forces(&line(b, [1.5, 20.0], &pipe(), ""));
    same(forces(&line(b, [1.5, 20.0], NONE, &floats)), by_pipe);
    // Modules of no weight that cover two fifths of a rope: 0.4 of their drag and 0.6 of its own.
    let modules = |along: &str| {
        format!(
            "modules = [{{ section = \"rope\", diameter_m = 1.5, length_m = 2.0, pitch_m = 5.0, density_kg_per_m3 = 1025.0, drag_normal = 0.8{along} }}]\n"
        )
    };
    let drag = |normal: f64, tangential: f64| {
        format!("drag_normal = {normal:?}, drag_tangential = {tangential:?}")
    };
    let bare = drag(1.2, 0.1);
    let normal = 0.6 * 1.2 + 0.4 * 0.8 * 3.0;
    let given = forces(&line(
        b,
        [1.5, 20.0],
        &bare,
        &modules(", drag_tangential = 0.3"),
    ));
    same(
        given,
        forces(&line(
            b,
            [1.5, 20.0],
            &drag(normal, 0.6 * 0.1 + 0.4 * 0.3 * 3.0),
            "",
        )),
    );
    let absent = forces(&line(b, [1.5, 20.0], &bare, &modules("")));
    same(
        absent,
        forces(&line(b, [1.5, 20.0], &drag(normal, 0.1), "")),
    );
}

/// Turned about the vertical, mirrored in the plane of x and z, and written from its other end.
#[test]
fn the_answer_does_not_depend_on_how_the_line_is_written() {
    let b = inclined(35.0);
    let plain = forces(&line(b, [1.5, 20.0], NONE, &aligned()));
    let same = |found: [V3; 2], expected: [V3; 2]| {
        for (own, other) in found.iter().zip(&expected) {
            assert!((own - other).norm() < 1e-6 * other.norm(), "{own} {other}");
        }
    };
    let turn = nalgebra::Rotation3::from_axis_angle(&V3::z_axis(), 50_f64.to_radians());
    let turned = turn * V3::from(b);
    let found = forces(&line(turned.into(), [1.5, 70.0], NONE, &aligned()));
    same(found, plain.map(|force| turn * force));
    let found = forces(&line(b, [1.5, -20.0], NONE, &aligned()));
    same(
        found,
        plain.map(|force| V3::new(force.x, -force.y, force.z)),
    );
    let text = line(b, [1.5, 20.0], NONE, &aligned());
    let a = "[0.0, 0.0, -200.0]";
    let written = format!("{b:?}");
    let reversed = text
        .replace(a, "PLACE")
        .replace(&written, a)
        .replace("PLACE", &written);
    let [first, last] = forces(&reversed);
    same([last, first], plain);
}
