//! Results are those of every step, whatever is written: no peak between two output times is lost, and no step depends on them.

use crate::lines;
use std::sync::atomic::AtomicBool;

use seacable::case::Case;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};

/// A rod that is heaved at its top and pulls at its foot, with this method and output at this interval.
fn computed(solver: &str, interval: f64) -> Run {
    let case = lines::line(&format!(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2, ei_n_m2 = 1e4 }}
        line = {{ length_m = 60.0, segments = 12 }}
        ends.a = {{ kind = "moving", amplitude_m = [0.4, 0.0, 1.5], period_s = 4.0 }}
        ends.b = {{ name = "foot", kind = "anchor", position_m = [30.0, 0.0, -40.0] }}
        solver = {{ {solver}, duration_s = 12.0 }}
        output = {{ interval_s = {interval:?} }}
        "#
    ));
    execute_case(case)
}

fn execute_case(case: Case) -> Run {
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

#[test]
fn no_result_depends_on_the_output_times() {
    for solver in [
        "method = \"alpha\", time_step_s = 0.05",
        "method = \"alpha\"",
        "method = \"rk4\"",
        "method = \"quasi\", position_tolerance_m = 1e-9",
    ] {
        let [often, rarely] = [0.05, 3.0].map(|interval| computed(solver, interval));
        assert_eq!(often.info.work, rarely.info.work, "{solver}");
        assert_eq!(often.history.time.len(), 241);
        assert_eq!(rarely.history.time, [0.0, 3.0, 6.0, 9.0, 12.0]);
        assert_eq!(often.profiles, rarely.profiles, "{solver}");
        assert_eq!(often.summary, rarely.summary, "{solver}");
        for (a, b) in often.history.channels.iter().zip(&rarely.history.channels) {
            assert_eq!((a.peak, a.trough), (b.peak, b.trough), "{solver} {}", a.id);
        }
    }
}

/// A body that lands on the bed, is dragged over it and lifted off: written every 10 s or every 0.05 s, it takes the same steps
/// and has the same extremes, of its contact too.
#[test]
fn landing_does_not_depend_on_the_output_times() {
    for method in ["alpha", "rk4"] {
        let [often, rarely] = [0.05, 10.0].map(|interval| {
            let case = lines::line(&format!(
                r#"
                environment.water_density_kg_per_m3 = 1025.0
                materials.rope = {{ diameter_m = 0.03, mass_kg_per_m = 3.5, ea_n = 2e6, drag_normal = 1.2, axial_damping_ratio = 0.1 }}
                line = {{ length_m = 60.0, segments = 6 }}
                ends.a = {{ kind = "moving", amplitude_m = [2.0, 0.0, 3.0], period_s = 16.0, ramp_s = 4.0 }}
                ends.b = {{ name = "body", kind = "payload" }}
                payload = {{ dry_mass_kg = 2000.0, wet_mass_kg = 1200.0, drag_area_m2 = 2.0, added_mass_kg = 800.0, bed_area_m2 = 2.0 }}
                seabed = {{ depth_m = 61.0, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = 1e4, friction = 0.4 }}
                solver = {{ method = "{method}", duration_s = 40.0 }}
                output = {{ interval_s = {interval:?} }}
                "#
            ));
            execute_case(case)
        });
        assert_eq!(often.info.work, rarely.info.work, "{method}");
        assert_eq!(
            (often.history.time.len(), rarely.history.time.len()),
            (801, 5)
        );
        assert_eq!(often.profiles, rarely.profiles, "{method}");
        let landed = often
            .history
            .channel("landing_speed_m_per_s[body]")
            .unwrap();
        assert!(landed.peak.0 > 0.3, "{method}: {:?}", landed.peak);
        let borne = often.history.channel("bed_force_n[body]").unwrap();
        assert!(
            borne.peak.0 > 1e4 && borne.values[800] == 0.0,
            "{:?}",
            borne.peak
        );
        for (a, b) in often.history.channels.iter().zip(&rarely.history.channels) {
            let range = a.peak.0 - a.trough.0;
            let same = |a: f64, b: f64| (a - b).abs() <= 1e-3 * range;
            let extremes = same(a.peak.0, b.peak.0) && same(a.trough.0, b.trough.0);
            assert!(extremes, "{method} {}", a.id);
        }
    }
}

/// Between the steps lies what shorter steps give: to third order, so that a peak is met by a hundredth of its height above
/// the steps beside it.
#[test]
fn peaks_between_steps_are_met() {
    let [coarse, fine] = [0.2, 0.0125].map(|step| {
        computed(
            &format!("method = \"alpha\", rho_inf = 1.0, time_step_s = {step}"),
            0.2,
        )
    });
    let top = |run: &Run| {
        run.summary
            .iter()
            .find(|q| q.name() == "z_m[top].max")
            .map(|q| q.value)
    };
    let (coarse, fine) = (top(&coarse).unwrap(), top(&fine).unwrap());
    assert!((fine - 1.5).abs() < 1e-6, "{fine}");
    assert!((coarse - 1.5).abs() < 2e-4, "{coarse}");
}
