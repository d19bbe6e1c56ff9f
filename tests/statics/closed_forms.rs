//! Lines at rest against closed forms and shooting written here for the purpose: they share nothing with the
//! program but the case.
//!
//! A lumped line is off by terms of the second order in segment length. So each shape is found on two meshes, and
//! Richardson's extrapolation of them, `fine + (fine - coarse)/3`, must meet the independent answer far
//! closer than either: to terms of the fourth order, `(l/a)²` of the change between the meshes, with l the segment
//! length and a the smallest radius of the line.

use crate::elastic_catenary::Catenary;
use crate::rest;
use seacable::numerics::V3;
use seacable::scene::Scene;
use seacable::solve::{State, StaticSearch};
use seacable::statics::equilibrium::EquilibriumSearch;

const G: f64 = 9.80665;

/// Positions and tension at nine places along the line, found on 64 and on 128 segments and extrapolated, with
/// the greatest change between the two meshes.
struct Found {
    /// Position and tension.
    place: Vec<(V3, f64)>,
    /// In positions and in tensions.
    change: (f64, f64),
}

fn find(changes: &str) -> Found {
    let solve = |n: usize| -> Vec<(V3, f64)> {
        let scene = rest::build(&format!("line.segments = {n}\n{changes}"));
        let state = rest::at_rest(&scene);
        let at = |k: usize| (state.x[k * n / 8], scene.tension_at(k * n / 8, &state));
        (0..=8).map(at).collect()
    };
    let (coarse, fine) = (solve(64), solve(128));
    let pairs = || fine.iter().zip(&coarse);
    Found {
        place: pairs()
            .map(|(f, c)| (f.0 + (f.0 - c.0) / 3.0, f.1 + (f.1 - c.1) / 3.0))
            .collect(),
        change: pairs().fold((0.0, 0.0), |m, (f, c)| {
            (
                f64::max(m.0, (f.0 - c.0).norm()),
                f64::max(m.1, (f.1 - c.1).abs()),
            )
        }),
    }
}

/// Whether an independent answer is met, by a line of this smallest radius; its position in the plane of x and z.
/// Statics leave a residual of 1e-8 besides.
fn check(what: &str, radius: f64, found: &Found, expected: impl Fn(usize) -> ((f64, f64), f64)) {
    let (mut off, mut off_tension, mut greatest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (k, (x, tension)) in found.place.iter().enumerate() {
        let ((ex, ez), t) = expected(k);
        off = off.max((x.x - ex).hypot(x.z - ez));
        off_tension = off_tension.max((tension - t).abs());
        greatest = greatest.max(t);
    }
    let share = 0.01 + (100.0 / 128.0 / radius).powi(2);
    assert!(
        share < 0.5,
        "{what}: the mesh is too coarse to tell, {share}"
    );
    assert!(
        off < share * found.change.0 + 1e-6,
        "{what}: {off} m, meshes apart {} m",
        found.change.0
    );
    assert!(
        off_tension < share * found.change.1 + 1e-7 * greatest,
        "{what}: {off_tension} N, meshes apart {} N",
        found.change.1
    );
}

fn between(x: f64, z: f64, ea: f64) -> String {
    format!(
        "materials.rope.ea_n = {ea}\nends.b = {{ name = \"post\", kind = \"fixed\", position_m = [{x}.0, 0.0, {z}.0] }}"
    )
}

#[test]
fn two_ends_slack_and_taut_meet_the_catenary() {
    for (x, z, ea) in [
        (90, 0, 1e6),
        (40, 0, 1e6),
        (10, -20, 1e7),
        (60, -70, 1e8),
        (70, 50, 1e6),
        (99, 0, 1e9),
        (15, -90, 1e7),
        (60, -80, 1e7),
        (101, 0, 1e6),
        (80, -65, 1e5),
        (120, 30, 1e5),
    ] {
        let (x, z) = (f64::from(x), f64::from(z));
        let exact = Catenary::between(100.0, 2.0 * G, ea, x, z);
        let found = find(&between(x, z, ea).replace(".0.0", ".0"));
        let lowest = (0..=1000).map(|k| exact.tension(0.1 * f64::from(k)));
        let radius = lowest.fold(f64::INFINITY, f64::min) / (2.0 * G);
        check(&format!("({x}, {z}), EA {ea:e}"), radius, &found, |k| {
            let s = 12.5 * k as f64;
            (exact.at(s), exact.tension(s))
        });
    }
}

/// `T(s) = V - w s`, V from the stretch: `(V L - w L²/2) / EA = D - L`.
#[test]
fn a_vertical_line_longer_than_itself_is_exact() {
    let scene = rest::build(&between(0.0, -102.0, 1e6).replace(".0.0", ".0"));
    let state = rest::at_rest(&scene);
    let (w, ea) = (2.0 * G, 1e6);
    let v = ea * 0.02 + 0.5 * w * 100.0;
    let left = 1e-8 * scene.line.force_scale * 10.0;
    for (i, s) in scene.line.arc.iter().enumerate() {
        let z = -(s + (v * s - 0.5 * w * s * s) / ea);
        assert!(
            (state.x[i].z - z).abs() <= left * 100.0 / ea + 1e-12,
            "{i}: {} {z}",
            state.x[i].z
        );
        assert!(state.x[i].x.hypot(state.x[i].y) <= left * 100.0 / v);
        let tension = scene.tension_at(i, &state);
        assert!(
            (tension - (v - w * s)).abs() <= left + 1e-9 * v,
            "{i}: {tension}"
        );
    }
}

/// A weightless line in a current that comes from one side, with normal drag alone: its tension is the payload's
/// weight W throughout, and the slope c = dx/dz of the line, upwards from the payload, grows by `dc/ds = q/W` with
/// `q = 1/2 rho C_D D U²(z)`. In a uniform current that is a catenary lying on its side.
fn weightless(speeds: (f64, f64)) -> String {
    format!(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        current = {{ speed_m_per_s = [{}, {}], depth_m = [0.0, 100.0] }}
        materials.rope = {{ wet_weight_kg_per_m = 0.0, drag_normal = 1.2 }}
        ends.b = {{ name = "bob", kind = "payload" }}
        payload = {{ dry_mass_kg = 500.0, wet_mass_kg = 400.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}
        "#,
        speeds.0, speeds.1
    )
}

#[test]
fn a_weightless_line_in_a_uniform_current_lies_on_a_catenary() {
    let w = 400.0 * G;
    let a = w / (0.5 * 1025.0 * 1.2 * 0.1 * 0.8 * 0.8);
    // The tension is the same everywhere, and so is the strain; drag acts on the stretched length.
    let stretched = 1.0 + w / 1e6;
    let at = |s: f64| (a * (1.0_f64.hypot(s / a) - 1.0), a * (s / a).asinh());
    let (top_x, top_z) = at(100.0 * stretched);
    let found = find(&weightless((0.8, 0.8)));
    check("uniform", a, &found, |k| {
        let (x, z) = at((100.0 - 12.5 * k as f64) * stretched);
        // The current carries the payload to +x of its line's top.
        ((top_x - x, z - top_z), w)
    });
}

/// The same in a current that falls with depth, by shooting from the payload: its depth is found such that the line
/// ends at the top.
#[test]
fn a_weightless_line_in_a_sheared_current_meets_a_shooting_solution() {
    let w = 400.0 * G;
    let stretched = 1.0 + w / 1e6;
    let drag = 0.5 * 1025.0 * 1.2 * 0.1;
    let speed = |z: f64| 1.2 + (0.2 - 1.2) * (-z).clamp(0.0, 100.0) / 100.0;
    // (x, z, c) along the line, upwards from the payload at depth d, every 12.5 m of unstretched line.
    let shoot = |d: f64| -> Vec<(f64, f64)> {
        let slope = |y: V3| {
            let n = 1.0_f64.hypot(y.z);
            V3::new(y.z / n, 1.0 / n, drag * speed(y.y).powi(2) / w)
        };
        let mut y = V3::new(0.0, -d, 0.0);
        let mut all = vec![(0.0, -d)];
        let h = 0.125 * stretched;
        for step in 1..=800 {
            let k1 = slope(y);
            let k2 = slope(y + k1 * (0.5 * h));
            let k3 = slope(y + k2 * (0.5 * h));
            let k4 = slope(y + k3 * h);
            y += (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
            if step % 100 == 0 {
                all.push((y.x, y.y));
            }
        }
        all
    };
    let (mut low, mut high) = (10.0, 99.9);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if shoot(middle)[8].1 > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let line = shoot(low);
    check("sheared", 30.0, &find(&weightless((1.2, 0.2))), |k| {
        let (x, z) = line[8 - k];
        ((line[8].0 - x, z), w)
    });
}

/// The mirror image to the last bit.
#[test]
fn a_buoyant_line_is_the_mirror_image_of_a_heavy_one() {
    for (x, z) in [(80.0, -20.0), (30.0, 10.0), (101.0, -5.0), (95.0, 0.0)] {
        let solve = |sign: f64| {
            let ends = format!(
                "ends.b = {{ name = \"post\", kind = \"fixed\", position_m = [{x:?}, 0.0, {:?}] }}",
                sign * z
            );
            let scene = rest::build(&format!(
                "materials.rope.wet_weight_kg_per_m = {:?}\n{ends}",
                2.0 * sign
            ));
            let state = rest::at_rest(&scene);
            let tensions = scene.tensions(&state);
            (state, tensions)
        };
        let ((heavy, down), (buoyant, up)) = (solve(1.0), solve(-1.0));
        assert_eq!(down, up);
        for (a, b) in heavy.x.iter().zip(&buoyant.x) {
            assert_eq!((a.x, a.y, a.z), (b.x, b.y, -b.z));
        }
    }
}

fn search(scene: &Scene) -> Result<State, String> {
    let mut state = scene.initial_state();
    let found = EquilibriumSearch::default()
        .run(scene, 0.0, &mut state)
        .map_err(|e| e.to_string())?;
    assert!(found.residual <= 1e-8 * scene.line.force_scale + scene.rounding_force());
    Ok(state)
}

/// Folded under itself, both ends on one vertical: the line hangs in two plumb parts, which without bending stiffness
/// meet in a point. Either that is found, to the length of a segment, or it is refused in words that say so.
#[test]
fn a_vertical_slack_line_is_solved_or_refused() {
    for (apart, segments) in [(50.0, 10), (50.0, 11), (0.0, 10), (90.0, 40), (99.0, 10)] {
        let scene = rest::build(&format!(
            "line.segments = {segments}\nends.b = {{ name = \"post\", kind = \"fixed\", position_m = [0.0, 0.0, {:?}] }}",
            -apart
        ));
        match search(&scene) {
            Ok(state) => {
                let lowest = state.x.iter().map(|x| x.z).fold(0.0, f64::min);
                let l = 100.0 / f64::from(segments);
                let bottom = -0.5 * (100.0 + apart);
                assert!(
                    (lowest - bottom).abs() <= l,
                    "apart {apart}: lowest {lowest}, {bottom}"
                );
                let top = scene.tension_at(0, &state);
                assert!(
                    (top - 2.0 * G * -bottom).abs() <= 2.0 * G * l,
                    "apart {apart}: {top} N"
                );
            }
            Err(message) => {
                assert!(
                    message.contains("slack") && message.contains("node"),
                    "{message}"
                );
            }
        }
    }
}
