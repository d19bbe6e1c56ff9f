//! Published curves: their points from a file, their difference from a run with its numerical error, and the chart of both.

use crate::lines;
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case};
use seacable::reference::{Outcome, ValidationRow, rows};
use seacable::report::figures::published_curves;
use seacable::run::Run;
use seacable::run::job::{Request, execute};

/// A weightless spring of 100 m, 1e4 N/m, with a weight of 200 kg, its top moved 0.1 m once in 4 s: after a while the weight
/// follows by the factor of a driven oscillator. Its curve repeats, and begins anywhere in the period.
fn bouncing(curve: &str, points: &str) -> Case {
    let file = toml::Value::String(points.to_owned());
    lines::line(&format!(
        r#"
        materials.rope.ea_n = 1.0e6
        materials.rope.mass_kg_per_m = 1e-3
        materials.rope.wet_weight_kg_per_m = 0.0
        materials.rope.axial_damping_n_s = 2.0e4
        line.segments = 4
        ends.a = {{ name = "top", kind = "moving", position_m = [0.0, 0.0, 0.0], amplitude_m = [0.0, 0.0, 0.1], period_s = 4.0, ramp_s = 4.0 }}
        ends.b = {{ name = "bob", kind = "payload" }}
        payload = {{ dry_mass_kg = 200.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }}
        solver = {{ duration_s = 48.0, error_estimate = true }}
        output.interval_s = 0.1
        study = [{{ name = "period", key = "ends.a.period_s", values = [4.0, 5.0] }}]
        published_curve = [
            {{ name = "steady", channel = "tension_n[rope|bob]", window_s = [36.0, 48.0], tolerance_percent = 1.0, source = "s", inputs = "published", {curve} }},
            {{ name = "elsewhere", channel = "tension_n[rope|bob]", time_s = [0.0, 48.0], value = [1.0, 1.0], tolerance_percent = 1.0, source = "s", inputs = "published", at = {{ study = "period", value = 5.0 }} }},
        ]
        files."steady.csv".text = {file}
        "#
    ))
}

/// The steady tension: `m (g + a)` with the weight's acceleration that of a driven oscillator, damped by c.
fn exact() -> String {
    let (m, k, c, w) = (200.0, 1.0e4, 200.0, TAU / 4.0);
    // x = X / Y: |k + i w c| / |k - m w² + i w c|.
    let size =
        (k * k + (w * c).powi(2)).sqrt() / ((k - m * w * w).powi(2) + (w * c).powi(2)).sqrt();
    let swing = m * w * w * 0.1 * size;
    let point = |i: i32| {
        let t = 0.05 * f64::from(i);
        format!("{t:.2},{:.6}\n", m * 9.80665 + swing * (w * t + 1.0).sin())
    };
    let points: String = (0..80).map(point).collect();
    format!("# tension at the weight\ntime_s,value\n{points}")
}

fn run(case: Case) -> Run {
    let request = Request {
        case,
        text: String::new(),
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    };
    execute(&request, &AtomicBool::new(false), &mut |_| {})
}

fn held(case: &Case, run: &Run) -> Vec<ValidationRow> {
    rows(case, &|at| at.is_none().then_some(run))
}

#[test]
fn a_curve_from_a_file_is_followed_with_its_error_and_drawn() {
    let case = bouncing(r#"points_file = "steady.csv", period_s = 4.0"#, &exact());
    assert_eq!(case.published_curve[0].time_s.len(), 80);
    let run = run(case.clone());
    let rows = held(&case, &run);
    let row = &rows[0];
    assert_eq!(row.outcome, Outcome::Pass, "{row:?}");
    let (off, error) = (row.difference.unwrap(), row.error.unwrap());
    assert!(off < 0.5 && error > 0.0 && error < 0.5, "{off} % {error} %");
    // Only the curve that belongs to the case as it stands is in the run's own numbers.
    let reported: Vec<String> = run
        .summary
        .iter()
        .map(seacable::run::Quantity::name)
        .collect();
    assert!(
        run.quantity("tension_n[rope|bob].from_curve_1").is_some(),
        "{reported:?}"
    );
    assert!(run.quantity("tension_n[rope|bob].from_curve_2").is_none());
    // Drawn over the window of the run, three periods of it, as it fits best.
    let charts = published_curves(&rows);
    assert_eq!(charts.len(), 2);
    let [computed, published] = &charts[0].series[..] else {
        panic!("{:?}", charts[0].series)
    };
    assert_eq!(charts[0].y.unit, "N");
    assert!(
        (239..=242).contains(&published.points.len()),
        "{}",
        published.points.len()
    );
    for (t, value) in &published.points {
        assert!((36.0 - 1e-9..=48.0 + 1e-9).contains(t));
        let after = computed
            .points
            .partition_point(|p| p.0 < *t)
            .min(computed.points.len() - 1);
        assert!((computed.points[after].1 - value).abs() < 60.0, "{t}");
    }
    // What was not run is drawn as it is published.
    assert_eq!(charts[1].series.len(), 1);
}

#[test]
fn a_curve_that_gives_its_points_twice_or_not_at_all_is_refused() {
    let text = |curve: &str| {
        format!(
            r#"
            case.title = "t"
            materials.m = {{ diameter_m = 0.1, mass_kg_per_m = 10.0, ea_n = 1e8 }}
            line = [{{ name = "s", material = "m", length_m = 10.0, segments = 2 }}]
            ends.a = {{ name = "a", kind = "fixed", position_m = [0.0, 0.0, 0.0] }}
            ends.b = {{ name = "b", kind = "free" }}
            published_curve = [{{ name = "c", channel = "x_m[b]", tolerance_percent = 1.0, source = "s", inputs = "published", {curve} }}]
            "#
        )
    };
    let problems = |curve: &str| {
        let found = case::parse(&text(curve), "c.toml").unwrap_err();
        found.into_iter().map(|f| f.problem).collect::<Vec<_>>()
    };
    let twice = problems(r#"points_file = "p.csv", time_s = [0.0, 1.0], value = [1.0, 1.0]"#);
    assert_eq!(
        twice,
        ["the curve has its points twice: here and in `points_file`"]
    );
    assert_eq!(problems("window_s = [0.0, 1.0]").len(), 2);
    let missing = problems(r#"points_file = "nowhere.csv""#);
    assert!(
        missing[0].contains("nowhere.csv cannot be read"),
        "{missing:?}"
    );
}
