//! Warnings about a line at rest: that it may rest elsewhere as well, that nothing gives it a shape, that it has no rest at
//! all, that a clamp does nothing.

use crate::lines;
use std::sync::atomic::AtomicBool;

use seacable::case::Case;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};

fn computed(changes: &str) -> Run {
    let case: Case = lines::line(&format!("solver.method = \"static\"\n{changes}"));
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    execute(&request, &AtomicBool::new(false), &mut |_| {})
}

/// A light stiff rod between two hinges nearer than it is long balances above them as well as below, where it would not
/// stay; a heavy limp one only sags.
#[test]
fn a_bowed_rod_has_two_shapes_and_a_sagging_one_has_one() {
    let rod = |weight: f64, ei: f64| {
        computed(&format!(
            r#"
            line = {{ length_m = 10.2, segments = 24 }}
            materials.rope = {{ mass_kg_per_m = {weight}, ea_n = 1e7, ei_n_m2 = {ei} }}
            ends.b = {{ name = "post", kind = "fixed", position_m = [10.0, 0.0, 0.0] }}
            "#
        ))
    };
    let reported = |run: &Run| {
        run.info
            .warnings
            .iter()
            .any(|w| w.contains("more than one equilibrium"))
    };
    let bowed = rod(0.1, 1e4);
    assert_eq!(bowed.info.state, RunState::Done, "{:?}", bowed.info.failure);
    assert!(reported(&bowed), "{:?}", bowed.info.warnings);
    assert!(
        bowed
            .info
            .warnings
            .iter()
            .any(|w| w.contains("would not stay")),
        "{:?}",
        bowed.info.warnings
    );
    let sagging = rod(10.0, 1e2);
    assert_eq!(
        sagging.info.state,
        RunState::Done,
        "{:?}",
        sagging.info.failure
    );
    assert!(!reported(&sagging), "{:?}", sagging.info.warnings);
}

const SLACK: &str = r#"
    environment.water_density_kg_per_m3 = 1025.0
    materials.rope = { mass_kg_per_m = 30.0, wet_weight_kg_per_m = 20.0 }
    ends.a = { kind = "anchor", position_m = [0.0, 0.0, -40.0] }
    ends.b = { name = "buoy", kind = "fixed", position_m = [40.0, 0.0, 0.0] }
"#;

#[test]
fn slack_line_on_a_smooth_bed_lies_in_any_shape() {
    let run = computed(&format!("{SLACK}\nseabed = {{ depth_m = 40.0 }}"));
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    assert!(
        run.info.warnings.iter().any(|w| w.contains("one of many")),
        "{:?}",
        run.info.warnings
    );
    let rough = computed(&format!(
        "{SLACK}\nseabed = {{ depth_m = 40.0, friction = 0.5 }}"
    ));
    assert_eq!(rough.info.state, RunState::Done, "{:?}", rough.info.failure);
    assert!(
        rough
            .info
            .warnings
            .iter()
            .all(|w| !w.contains("one of many"))
    );
    assert!(
        rough
            .info
            .warnings
            .iter()
            .any(|w| w.contains("more line than needed")),
        "{:?}",
        rough.info.warnings
    );
}

/// A buoyant line longer than the way between its ends, both on the surface: what floats there slack may lie anyhow, and a
/// current that stretches it gives it one shape.
#[test]
fn slack_line_afloat_lies_in_one_of_many_shapes() {
    let afloat = |current: &str| {
        computed(&format!(
            r#"
            environment = {{ water_density_kg_per_m3 = 1025.0, water_surface = "crossed" }}
            line = {{ length_m = 100.0, segments = 20 }}
            materials.rope = {{ diameter_m = 0.1, mass_kg_per_m = 4.0, drag_normal = 1.2 }}
            ends.b = {{ name = "post", kind = "fixed", position_m = [40.0, 0.0, -20.0] }}
            {current}
            "#
        ))
    };
    let reported = |run: &Run| {
        let warned = run.info.warnings.iter();
        warned
            .chain(&run.info.failure)
            .any(|w| w.contains("float on the surface"))
    };
    let calm = afloat("");
    assert!(reported(&calm), "{:?}", calm.info);
    let streaming = afloat("current = { speed_m_per_s = 0.5, direction_deg = 90.0 }");
    assert_eq!(
        streaming.info.state,
        RunState::Done,
        "{:?}",
        streaming.info.failure
    );
    assert!(!reported(&streaming), "{:?}", streaming.info.warnings);
}

/// On a slope slack line is held by friction, as much as the slope asks for; without any it hangs downhill from the anchor.
#[test]
fn slack_line_on_a_slope_needs_friction() {
    let on = |friction: &str| {
        computed(&format!(
            "{SLACK}\nseabed = {{ depth_m = 40.0, {friction} slope_deg = 10.0 }}"
        ))
    };
    let held = on("friction = 0.5,");
    assert_eq!(held.info.state, RunState::Done, "{:?}", held.info.failure);
    let slides = on("friction = 0.05,");
    assert!(
        slides
            .info
            .failure
            .as_ref()
            .is_some_and(|why| why.contains("slides down")),
        "{:?}",
        slides.info
    );
    let smooth = on("");
    let lowest = smooth
        .profile()
        .nodes
        .iter()
        .map(|x| x[2])
        .fold(0.0, f64::min);
    assert!(lowest < -41.0, "{lowest} m");
}

#[test]
fn a_clamp_without_bending_stiffness_is_reported() {
    let run =
        computed("ends.a = { clamp_elevation_deg = -30.0 }\nmaterials.rope.drag_normal = 1.0");
    assert!(
        run.info
            .warnings
            .iter()
            .any(|w| w.contains("clamp at `top` holds nothing")),
        "{:?}",
        run.info.warnings
    );
}

/// A weight at a third of 27 segments, whose place is no node of half as many: the companions have it at the same place, and their
/// estimate of the mesh error is about the error there is.
#[test]
fn a_body_stays_in_its_place_on_the_companions_mesh() {
    let sag = |segments: usize| {
        let run = computed(&format!(
            r#"
            line.segments = {segments}
            materials.rope = {{ ea_n = 1e8 }}
            ends.b = {{ name = "post", kind = "fixed", position_m = [80.0, 0.0, 10.0] }}
            clumps = [{{ name = "weight", section = "rope", at_m = 33.333333333333336, mass_kg = 30.0, wet_mass_kg = 30.0 }}]
            solver.error_estimate = true
            "#
        ));
        let summary = run
            .summary
            .iter()
            .find(|q| q.name() == "z_m[weight].final")
            .unwrap()
            .clone();
        (summary.value, summary.mesh_error.unwrap())
    };
    let (coarse, estimated) = sag(27);
    let (fine, _) = sag(288);
    let error = (coarse - fine).abs();
    assert!(
        (error..2.7 * error).contains(&estimated),
        "{estimated} m estimated, {error} m"
    );
}
