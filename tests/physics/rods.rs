//! Lines that bend, against closed forms: the elastica, beams, buckling, clamps, and the order in segment length.

use seacable::case;
use seacable::numerics::V3;
use seacable::scene::{self, Scene};
use seacable::solve::State;
use seacable::statics::equilibrium::{EquilibriumSearch, instabilities};

/// The scene of a case, and its equilibrium.
fn at_rest(text: &str) -> (Scene, State) {
    let scene = scene::build(&case::parse(text, "rod.toml").unwrap(), 1).unwrap();
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .unwrap();
    (scene, state)
}

/// A rod of length 10 m along x from a clamp at the origin, in no water, with a load at its tip. EI = 100 N m².
fn cantilever(segments: usize, tip_load_n: f64, weight_n_per_m: f64) -> (Scene, State) {
    let text = format!(
        r#"
[case]
title = "cantilever"
[environment]
gravity_m_per_s2 = 10.0
water_density_kg_per_m3 = 0.0
[materials.rod]
diameter_m = 0.05
mass_kg_per_m = 1.0
wet_weight_kg_per_m = {weight}
ea_n = 1.0e7
ei_n_m2 = 100.0
[[line]]
name = "rod"
material = "rod"
length_m = 10.0
segments = {segments}
[ends.a]
name = "wall"
kind = "fixed"
position_m = [0, 0, 0]
clamp_elevation_deg = 0.0
[ends.b]
name = "tip"
kind = "payload"
[payload]
dry_mass_kg = {load}
drag_area_m2 = 0.0
added_mass_kg = 0.0
wet_mass_kg = {load}
[start]
shape = "straight"
"#,
        weight = weight_n_per_m / 10.0,
        load = (tip_load_n / 10.0).max(1e-9),
    );
    at_rest(&text)
}

fn tip(segments: usize, load: f64) -> V3 {
    let (_, state) = cantilever(segments, load, 0.0);
    *state.x.last().unwrap()
}

/// Deflection w/L and shortening u/L of a cantilever under a tip load P, by elliptic integrals, for P L²/EI.
const ELASTICA: [(f64, f64, f64); 6] = [
    (0.2, 0.066_364_5, 0.002_646_5),
    (1.0, 0.301_720_8, 0.056_433_2),
    (2.0, 0.493_457_5, 0.160_641_7),
    (5.0, 0.713_791_5, 0.387_628_4),
    (10.0, 0.810_609_0, 0.554_995_6),
    (20.0, 0.868_695_9, 0.683_885_6),
];

#[test]
fn cantilever_elastica_under_tip_load() {
    for (load, w, u) in ELASTICA {
        // P L²/EI = P with these numbers; order 2, so two meshes extrapolate.
        let (coarse, fine) = (tip(80, load), tip(160, load));
        let p = fine + (fine - coarse) / 3.0;
        // Axial compression and stretch: P/EA L at most 2e-5 m.
        assert!(
            (-p.z / 10.0 - w).abs() < 5e-6,
            "{load}: {} {w}",
            -p.z / 10.0
        );
        assert!(
            (1.0 - p.x / 10.0 - u).abs() < 5e-6,
            "{load}: {} {u}",
            1.0 - p.x / 10.0
        );
    }
}

#[test]
fn the_elastica_converges_with_the_square_of_the_segment() {
    let (_, w, _) = ELASTICA[3];
    let errors: Vec<f64> = [10, 20, 40, 80]
        .iter()
        .map(|n| (-tip(*n, 5.0).z / 10.0 - w).abs())
        .collect();
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
}

/// A weightless rod along x from a clamp, of 5 m with EI = 300 N m² and 5 m with EI = 100 N m², with 4 N where these meet and 3 N at the tip.
fn stepped_cantilever(segments: usize) -> (Scene, State) {
    let text = format!(
        r#"
[case]
title = "stepped cantilever"
[environment]
gravity_m_per_s2 = 10.0
water_density_kg_per_m3 = 0.0
[materials]
thick = {{ diameter_m = 0.06, mass_kg_per_m = 1.0, wet_weight_kg_per_m = 0.0, ea_n = 1.0e8, ei_n_m2 = 300.0 }}
thin = {{ diameter_m = 0.05, mass_kg_per_m = 1.0, wet_weight_kg_per_m = 0.0, ea_n = 1.0e8, ei_n_m2 = 100.0 }}
[[line]]
name = "thick"
material = "thick"
length_m = 5.0
segments = {segments}
[[line]]
name = "thin"
material = "thin"
length_m = 5.0
segments = {segments}
[[clumps]]
name = "weight"
section = "thin"
at_m = 0.0
mass_kg = 0.4
wet_mass_kg = 0.4
added_mass_kg = 0.0
drag_area_m2 = 0.0
[ends.a]
name = "wall"
kind = "fixed"
position_m = [0, 0, 0]
clamp_elevation_deg = 0.0
[ends.b]
name = "tip"
kind = "payload"
[payload]
dry_mass_kg = 0.3
wet_mass_kg = 0.3
added_mass_kg = 0.0
drag_area_m2 = 0.0
[start]
shape = "straight"
"#
    );
    at_rest(&text)
}

/// The tension of a weightless rod under vertical loads by the place of every node: `T + M²/2EI` is constant between loads, where `M` is
/// known by statics, and the tension at the wall is zero, which a clamp shows on any mesh. At the load in the middle it is that of the rod
/// after it.
#[test]
fn tensions_of_a_rod_that_bends_are_of_second_order() {
    let (at_middle, at_tip) = (4.0, 3.0);
    let mut errors = [Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    for segments in [10, 20, 40, 80] {
        let (scene, state) = stepped_cantilever(segments);
        let x = |node: usize| state.x[node].x;
        let [middle, tip] = [x(segments), x(2 * segments)];
        let thick = |x: f64| (at_tip * (tip - x) + at_middle * (middle - x)).powi(2) / 600.0;
        let thin = |x: f64| (at_tip * (tip - x)).powi(2) / 200.0;
        let before = thick(0.0) - thick(middle);
        let after = before * at_tip / (at_tip + at_middle);
        let exact = |node: usize| match node < segments {
            true => thick(0.0) - thick(x(node)),
            false => after + thin(middle) - thin(x(node)),
        };
        let tensions = scene.tensions(&state);
        let mut read = vec![0.0; tensions.len()];
        scene.read_step(0.0, &state, true, &mut read);
        assert_eq!(read, tensions, "in one pass and node by node");
        let error = |node: usize| (tensions[node] - exact(node)).abs();
        let inner = (1..2 * segments).filter(|node| *node != segments);
        errors[0].push(error(0));
        errors[1].push(inner.map(error).fold(0.0, f64::max));
        errors[2].push(error(segments));
        errors[3].push(error(2 * segments));
    }
    for (place, errors) in ["wall", "between", "middle", "tip"].iter().zip(errors) {
        let order = (errors[2] / errors[3]).log2();
        let is_exact = errors.iter().all(|error| *error < 1e-6);
        assert!(
            is_exact || order > 1.8,
            "{place}: {errors:?} N, order {order:.2}"
        );
        assert!(errors[3] < 2e-3, "{place}: {errors:?} N");
    }
}

/// A weightless line of 20 m with EI = 2 kN m² that hangs from a clamp 10 degrees off the vertical, and is pulled straight by 20 kN.
fn hung_from_a_clamp(segments: usize) -> (Scene, State) {
    let text = format!(
        r#"
[case]
title = "hung from a clamp"
[environment]
gravity_m_per_s2 = 10.0
water_density_kg_per_m3 = 0.0
[materials]
line = {{ diameter_m = 0.1, mass_kg_per_m = 1.0, wet_weight_kg_per_m = 0.0, ea_n = 1.0e9, ei_n_m2 = 2000.0 }}
[[line]]
name = "line"
material = "line"
length_m = 20.0
segments = {segments}
[ends.a]
name = "hang_off"
kind = "fixed"
position_m = [0, 0, 0]
clamp_elevation_deg = -80.0
[ends.b]
name = "weight"
kind = "payload"
[payload]
dry_mass_kg = 2000.0
wet_mass_kg = 2000.0
added_mass_kg = 0.0
drag_area_m2 = 0.0
"#
    );
    at_rest(&text)
}

/// The line bends within some sqrt(EI/T) = 0.32 m of the clamp: `EI k² / 2 = T (1 - cos)` of the angle. Segments of 2 m do not resolve
/// that, and had a fourth of the curvature.
#[test]
fn a_line_bends_at_a_clamp_by_its_closed_form_on_any_mesh() {
    let angle = 10.0_f64.to_radians();
    let exact = 2.0 * (20_000.0_f64 / 2000.0).sqrt() * (0.5 * angle).sin();
    let mut errors = Vec::new();
    for segments in [10, 20, 40, 80, 160, 320] {
        let (scene, state) = hung_from_a_clamp(segments);
        let flexure = scene.elements.flexure.as_ref().unwrap();
        let (curvature, moment) = flexure.bent_at(0, &scene.line, &state);
        assert!((moment / (2000.0 * curvature) - 1.0).abs() < 1e-12);
        let mut in_planes = vec![[0.0; 2]; segments + 1];
        flexure.curvatures(&scene.line, &state, &mut in_planes);
        let [first, second] = in_planes[0];
        assert!((first.hypot(second) / curvature - 1.0).abs() < 1e-12);
        errors.push((curvature / exact - 1.0).abs());
        // The whole force is known there.
        let tension = scene.tension_at(0, &state) / (20_000.0 * angle.cos());
        assert!((tension - 1.0).abs() < 1e-9, "{segments}: {tension}");
        let mut read = vec![0.0; segments + 1];
        scene.read_step(0.0, &state, false, &mut read);
        assert_eq!(read, scene.tensions(&state));
    }
    // The closed form of the mesh is one of small angles.
    assert!(errors.iter().all(|error| *error < 0.005), "{errors:?}");
    assert!(errors[5] < 0.01 * errors[0], "{errors:?}");
}

/// A weightless line between two hinges under 20 kN, with 200 N in its middle: for small slopes the moment there is `W/2 sqrt(EI/T)`.
/// Segments of 2 m do not resolve the 0.32 m within which it bends.
#[test]
fn a_line_bends_at_a_body_by_its_closed_form_on_any_mesh() {
    for segments in [10, 20, 40, 80, 160] {
        let text = format!(
            r#"
[case]
title = "loaded in its middle"
[environment]
gravity_m_per_s2 = 10.0
water_density_kg_per_m3 = 0.0
[materials]
line = {{ diameter_m = 0.1, mass_kg_per_m = 1.0, wet_weight_kg_per_m = 0.0, ea_n = 1.0e9, ei_n_m2 = 2000.0 }}
[[line]]
name = "line"
material = "line"
length_m = 20.0
segments = {segments}
[[clumps]]
name = "weight"
section = "line"
at_m = 10.0
mass_kg = 20.0
wet_mass_kg = 20.0
[ends.a]
name = "a"
kind = "fixed"
position_m = [0, 0, 0]
[ends.b]
name = "b"
kind = "fixed"
position_m = [{span:?}, 0, 0]
"#,
            // Longer by the stretch and by the way around the load.
            span = 20.0 * (1.0 + 20_000.0 / 1e9 - 0.5 * 0.005_f64.powi(2)),
        );
        let (scene, state) = at_rest(&text);
        let tension = scene.tension_at(segments / 4, &state);
        let flexure = scene.elements.flexure.as_ref().unwrap();
        let (_, moment) = flexure.bent_at(segments / 2, &scene.line, &state);
        let exact = 100.0 * (2000.0 / tension).sqrt();
        assert!(
            (moment / exact - 1.0).abs() < 0.005,
            "{segments}: {moment} {exact}"
        );
    }
}

#[test]
fn euler_bernoulli_beam_under_its_weight() {
    // w = q L⁴ / (8 EI), root moment q L² / 2: so light that the deflection is a thousandth of the length.
    let q = 8.0 * 100.0 * 0.01 / 1e4;
    let (scene, state) = cantilever(160, 0.0, q);
    let deflection = -state.x.last().unwrap().z;
    assert!((deflection - 0.01).abs() < 1e-5, "{deflection}");
    let moment = scene
        .elements
        .flexure
        .as_ref()
        .unwrap()
        .moments(&scene.line, &state)[0];
    assert!((moment - q * 50.0).abs() < 1e-4 * q * 50.0, "{moment}");
}

/// A rod between two hinges, pushed together by `push` metres, in no water, with a slight weight to choose a side.
fn pushed(push: f64) -> (Scene, State) {
    let text = format!(
        r#"
[case]
title = "strut"
[environment]
water_density_kg_per_m3 = 0.0
[materials.rod]
diameter_m = 0.05
mass_kg_per_m = 1.0
wet_weight_kg_per_m = 1.0e-6
ea_n = 1.0e7
ei_n_m2 = 100.0
[[line]]
name = "rod"
material = "rod"
length_m = 10.0
segments = 100
[ends.a]
name = "a"
kind = "fixed"
position_m = [0, 0, 0]
[ends.b]
name = "b"
kind = "fixed"
position_m = [{}, 0, 0]
"#,
        10.0 - push
    );
    at_rest(&text)
}

#[test]
fn a_strut_buckles_at_eulers_load() {
    // pi² EI / L² = 9.8696 N; past it the load grows by 1 + (pi a / L)² / 8 with the amplitude a, here about 1e-3.
    let (scene, state) = pushed(0.01);
    let load = -scene.tension_at(50, &state);
    let euler = std::f64::consts::PI.powi(2) * 100.0 / 100.0;
    assert!((load / euler - 1.0).abs() < 2e-3, "{load} against {euler}");
    let sag = state.x[50].z.abs();
    // Shortening is (pi a)² / (4 L).
    assert!(
        (sag - (4.0 * 10.0 * 0.01_f64).sqrt() / std::f64::consts::PI).abs() < 1e-3,
        "{sag}"
    );
}

/// A rod of 10 m, EI = 100 N m², no weight to speak of, between two clamps `apart` metres apart along x; elevations in
/// degrees, those above 90 turned back.
fn between_clamps(segments: usize, apart: f64, elevations: [f64; 2]) -> Scene {
    let clamp = |turn: f64| {
        let back = turn.abs() > 90.0;
        let (elevation, azimuth) = if back {
            (turn.signum() * 180.0 - turn, 180.0)
        } else {
            (turn, 0.0)
        };
        format!("clamp_elevation_deg = {elevation:?}\nclamp_azimuth_deg = {azimuth:?}")
    };
    let text = format!(
        r#"
[case]
title = "rod"
[environment]
water_density_kg_per_m3 = 0.0
[materials.rod]
diameter_m = 0.05
mass_kg_per_m = 1.0
wet_weight_kg_per_m = 1.0e-6
ea_n = 1.0e6
ei_n_m2 = 100.0
[[line]]
name = "rod"
material = "rod"
length_m = 10.0
segments = {segments}
[ends.a]
name = "a"
kind = "fixed"
position_m = [0, 0, 0]
{}
[ends.b]
name = "b"
kind = "fixed"
position_m = [{apart}, 0, 0]
{}
"#,
        clamp(elevations[0]),
        clamp(elevations[1])
    );
    scene::build(&case::parse(&text, "rod.toml").unwrap(), 1).unwrap()
}

/// Where the elastica ends that leaves the origin at this angle with this force and moment: x, z and its angle there.
/// `θ' = M/EI`, `M' = H sin θ - V cos θ` with the pull (H, V) on it at the origin turned round; Runge and Kutta's method.
fn elastica(angle: f64, force: (f64, f64), moment: f64) -> [f64; 4] {
    let slope = |s: [f64; 4]| {
        let (sin, cos) = s[2].sin_cos();
        let stretch = 1.0 + (force.0 * cos + force.1 * sin) / 1e6;
        [
            cos * stretch,
            sin * stretch,
            s[3] / 100.0,
            (force.0 * sin - force.1 * cos) * stretch,
        ]
    };
    let add = |s: [f64; 4], d: [f64; 4], h: f64| std::array::from_fn(|i| s[i] + h * d[i]);
    let (steps, mut s) = (2000, [0.0, 0.0, angle, moment]);
    let h = 10.0 / f64::from(steps);
    for _ in 0..steps {
        let a = slope(s);
        let b = slope(add(s, a, 0.5 * h));
        let c = slope(add(s, b, 0.5 * h));
        let d = slope(add(s, c, h));
        s = std::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    s
}

/// What the rod's own end force and moment miss the other clamp by.
fn missed(segments: usize, apart: f64, elevations: [f64; 2]) -> [f64; 3] {
    let scene = between_clamps(segments, apart, elevations);
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .unwrap_or_else(|why| panic!("{apart} {elevations:?}: {why}"));
    let pull = scene.end_force(0, &state);
    assert_eq!(instabilities(&scene, 0.0, &state), Some(0));
    let flexure = scene.elements.flexure.as_ref().unwrap();
    let first = scene.line.chord(0, &state).tangent;
    let angle = elevations[0].to_radians();
    // At a clamp the moment has the sign of the turn from it to the first segment.
    let turn = angle.cos() * first.z - angle.sin() * first.x;
    let moment = flexure.moments(&scene.line, &state)[0] * turn.signum();
    let end = elastica(angle, (pull.x, pull.z), moment);
    let off = (end[2] - elevations[1].to_radians()) / std::f64::consts::TAU;
    [
        end[0] - apart,
        end[1],
        (off - off.round()) * std::f64::consts::TAU,
    ]
}

#[test]
fn a_rod_clamped_at_odds_with_its_way_is_an_elastica() {
    for (apart, elevations) in [
        (8.0, [80.0, -80.0]),
        (8.0, [80.0, 80.0]),
        (5.0, [180.0, 0.0]),
        (5.0, [0.0, 180.0]),
        (3.0, [-160.0, 160.0]),
    ] {
        let [coarse, fine] = [80, 160].map(|n| missed(n, apart, elevations));
        for (fine, coarse) in fine.iter().zip(coarse) {
            // Order 2 in the segment.
            let order = (coarse / fine).abs().log2();
            assert!(fine.abs() < 0.01, "{apart} {elevations:?}: {fine}");
            assert!(
                (order - 2.0).abs() < 0.15,
                "{apart} {elevations:?}: {order}"
            );
        }
    }
}

#[test]
fn rods_clamped_at_random_come_to_rest() {
    // Multiples of the golden ratio, of its square and of its cube: evenly spread, and no two in step.
    let spread = |i: i32, by: f64| (f64::from(i) * by).fract();
    let count = 40;
    let mut found = 0;
    for i in 0..count {
        let turn = |by: f64| 360.0 * spread(i, by) - 180.0;
        let apart = 1.0 + 8.9 * spread(i, 0.618_034);
        let scene = between_clamps(80, apart, [turn(0.381_966), turn(0.236_068)]);
        let mut state = scene.initial_state();
        match EquilibriumSearch::default().run(&scene, 0.0, &mut state) {
            Ok(_) => found += 1,
            Err(why) => eprintln!("{apart} {:?}: {why}", [turn(0.381_966), turn(0.236_068)]),
        }
    }
    assert!(found >= 38, "{found} of {count}");
}
