//! Envelopes along the line over every step: a peak between two output times is not lost where the case asks for it.

use crate::lines;
use std::sync::atomic::AtomicBool;

use seacable::run::job::{Request, execute};
use seacable::run::{Profile, RunState};

/// A rod that is heaved at its top and pulls at its foot, in steps of 0.05 s; what the test says of its material, and of
/// the output at this interval.
fn envelopes(more: &str, output: &str, interval: f64) -> Profile {
    let case = lines::line(&format!(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2, ei_n_m2 = 1e4{more} }}
        line = {{ length_m = 60.0, segments = 12 }}
        ends.a = {{ kind = "moving", amplitude_m = [0.4, 0.0, 1.5], period_s = 4.0 }}
        ends.b = {{ name = "foot", kind = "anchor", position_m = [30.0, 0.0, -40.0] }}
        solver = {{ method = "alpha", time_step_s = 0.05, duration_s = 12.0 }}
        output = {{ interval_s = {interval:?}{output} }}
        "#
    ));
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run.profile
}

#[test]
fn a_limit_has_the_bending_of_every_step() {
    let every = envelopes("", "", 0.05);
    let rarely = envelopes("", "", 3.0);
    let limited = envelopes(", min_bend_radius_m = 5.0", "", 3.0);
    assert_eq!(limited.curvature_max, every.curvature_max);
    assert_eq!(limited.moment_max, every.moment_max);
    // What is not asked for is taken at output times alone, and misses the peaks.
    assert!(rarely.curvature_max[5] < 0.99 * every.curvature_max[5]);
    assert_eq!(limited.tension_max, rarely.tension_max);
}

#[test]
fn a_case_that_asks_has_all_of_every_step() {
    let every = envelopes("", "", 0.05);
    let asked = envelopes("", ", envelope = \"steps\"", 3.0);
    assert_eq!(asked.tension_max, every.tension_max);
    assert_eq!(asked.tension_min, every.tension_min);
    assert_eq!(asked.z_max, every.z_max);
    assert_eq!(asked.z_min, every.z_min);
    assert_eq!(asked.curvature_max, every.curvature_max);
}
