//! Tension of the wall of a pipe that hangs straight down in water, against the balance of its wall by hand.

use std::f64::consts::FRAC_PI_4;
use std::sync::atomic::AtomicBool;

use crate::lines;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};

const G: f64 = 9.80665;
const WATER: f64 = 1025.0;
const STEEL: f64 = 7850.0;
const LENGTH: f64 = 400.0;
/// Depth of the top \[m\].
const TOP: f64 = 20.0;
const OUTER: f64 = 0.5;
const INNER: f64 = 0.44;

/// Areas of the outside, the bore and the wall \[m²\].
fn areas() -> [f64; 3] {
    let [outer, inner] = [OUTER, INNER].map(|d| FRAC_PI_4 * d * d);
    [outer, inner, outer - inner]
}

/// The pipe with its content and the inner pressure at its top, and what else a test says.
fn pipe(content: f64, pressure: f64, changes: &str) -> Run {
    let [_, inner, wall] = areas();
    let mass = STEEL * wall + content * inner;
    let case = lines::line(&format!(
        r#"
        environment.water_density_kg_per_m3 = {WATER:?}
        materials.rope.diameter_m = {OUTER:?}
        materials.rope.mass_kg_per_m = {mass:?}
        materials.rope.ea_n = 1e12
        materials.rope.bore = {{ diameter_m = {INNER:?}, content_density_kg_per_m3 = {content:?}, pressure_pa = {pressure:?}, pressure_height_m = {:?} }}
        line = {{ length_m = {LENGTH:?}, segments = 10 }}
        ends.a.position_m = [0.0, 0.0, {:?}]
        {changes}
        "#,
        -TOP, -TOP
    ));
    let request = Request {
        case,
        text: String::new(),
        file: "pipe.toml".to_owned(),
        overrides: Vec::new(),
        id: "pipe".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

/// Final values at the top and the foot \[N\]; both have an estimated error.
fn ends(run: &Run) -> [f64; 2] {
    ["a", "b"].map(|end| {
        let name = format!("wall_tension_n[rope.{end}].final");
        let found = run.quantity(&name).unwrap();
        let error = found.error_estimate().unwrap();
        assert!(error < 1e-4 * found.value.abs(), "{name} +- {error}");
        found.value
    })
}

/// The wall hangs by its top and bears at its foot the pressures on what closes it or, open, on its own rim.
#[test]
fn a_hanging_pipe_closed_or_open_at_its_foot() {
    let [outer, inner, wall] = areas();
    let steel = STEEL * G * wall * LENGTH;
    let outside = WATER * G * (TOP + LENGTH);
    // Content [kg/m³], pressure at the top [Pa], tension of the wall at its foot [N].
    let open = WATER * G * TOP;
    let oil = 2e6 + 850.0 * G * LENGTH;
    for (content, pressure, foot) in [
        (0.0, 0.0, -outside * outer),
        (850.0, 2e6, oil * inner - outside * outer),
        (WATER, open, -outside * wall),
    ] {
        for method in ["static", "alpha"] {
            let solver = format!(
                "solver = {{ method = \"{method}\", duration_s = 1.0, error_estimate = true }}"
            );
            let [top, end] = ends(&pipe(content, pressure, &solver));
            let by_hand = foot + steel;
            let near = |a: f64, b: f64| (a - b).abs() < 1e-5 * steel;
            assert!(near(top, by_hand), "{method} {content}: {top} {by_hand}");
            assert!(near(end, foot), "{method} {content}: {end} {foot}");
        }
    }
}

/// In motion the wall differs from the effective tension by the pressures where its end is.
#[test]
fn the_pressures_are_those_at_the_height_of_the_end() {
    let [outer, inner, _] = areas();
    let heave = r#"
        ends.a.kind = "moving"
        ends.a.amplitude_m = [0.0, 0.0, 30.0]
        ends.a.period_s = 40.0
        solver = { method = "alpha", duration_s = 20.0 }
        output.interval_s = 1.0
    "#;
    let run = pipe(850.0, 2e6, heave);
    let values = |name: &str| &run.history.channel(name).unwrap().values;
    let (wall, effective) = (
        values("wall_tension_n[rope.a]"),
        values("tension_n[top|rope]"),
    );
    let (mut above, mut below) = (0, 0);
    for ((wall, effective), z) in wall.iter().zip(effective).zip(values("z_m[top]")) {
        let pressure = 2e6 + 850.0 * G * (-TOP - z);
        let outside = WATER * G * (-z).max(0.0);
        let known = effective + pressure * inner - outside * outer;
        assert!((wall - known).abs() < 1e-6 * known.abs(), "{wall} {known}");
        *(if *z > 0.0 { &mut above } else { &mut below }) += 1;
    }
    assert!(above > 2 && below > 2, "{above} {below}");
}
