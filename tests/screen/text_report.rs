//! The text report as it is printed.

use crate::sample;
use seacable::{case, chart::Glyphs, plain, reference, report::text, run::Run};

const CASE: &str = r#"
[case]
title = "A rope with a body"
source = "A paper, table 1"
notes = "One line of notes."

[materials.rope]
diameter_m = 0.05
mass_kg_per_m = 3.0
ea_n = 1e6
drag_normal = 1.2

[[line]]
name = "wire"
material = "rope"
length_m = 20.0
segments = 3

[ends.a]
name = "vessel"
kind = "fixed"
position_m = [0.0, 0.0, 0.0]

[ends.b]
name = "payload"
kind = "payload"

[payload]
dry_mass_kg = 500.0
wet_mass_kg = 400.0
drag_area_m2 = 1.0
added_mass_kg = 100.0

[start]
shape = "straight"

[solver]
duration_s = 5.0

[marks]
"payload.drag_area_m2" = { status = "calibrated", reason = "Fitted to the mean tension." }

[[study]]
name = "mass"
key = "payload.dry_mass_kg"
values = [500.0, 600.0]

[[published]]
name = "mean tension"
channel = "tension_n[wire|payload]"
statistic = "mean"
window_s = [0.0, 200.0]
value = 110e3
tolerance_rel = 0.02
source = "fig. 1"
inputs = "calibrated"
kind = "fitted"

[[published]]
name = "greatest tension"
channel = "tension_n[wire|payload]"
statistic = "max"
value = 1.5e6
tolerance_rel = 0.02
source = "fig. 2"
inputs = "published"
out_of_reach = "The start is not printed."

[[published]]
name = "travel of the heavier body"
channel = "x_m[payload]"
statistic = "travel"
value = 1404.38
tolerance_abs = 1.5
source = "fig. 3"
inputs = "calibrated"
at = { study = "mass", value = 600.0 }
"#;

fn run() -> Run {
    let mut run = sample::run();
    run.case_text = CASE.to_owned();
    run.info.overrides.clear();
    run.info.settings.duration_s = 4.9;
    run.info.title = "A rope with a body".to_owned();
    run
}

fn report(run: &Run, glyphs: Glyphs) -> String {
    let case = case::parse(&run.case_text, "sample.toml").unwrap();
    text::report(run, &case, &reference::rows_of_run(run, &case), glyphs)
}

#[test]
fn a_report_holds_what_a_reader_needs_on_80_columns() {
    let text = report(&run(), Glyphs::Braille);
    for line in text.lines() {
        assert!(
            unicode_width::UnicodeWidthStr::width(line) <= 80,
            "too wide: {line}"
        );
    }
    insta::with_settings!({ snapshot_path => "../../snapshots", prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!("text_report", text);
    });
}

#[test]
fn an_ascii_report_is_ascii() {
    let text = report(&run(), Glyphs::Ascii);
    assert!(plain::ascii(&text).is_ascii());
    assert!(
        !plain::ascii(&text).contains('?'),
        "every character has a neighbour in ASCII"
    );
}

#[test]
fn a_run_that_failed_or_was_stopped_says_so_at_the_top() {
    use seacable::run::RunState;
    let mut run = run();
    run.info.failure = Some("Newton gave up at 3 s.".to_owned());
    for (state, word) in [
        (RunState::Failed, "FAILED: Newton gave up at 3 s."),
        (RunState::Cancelled, "CANCELLED"),
        (RunState::Partial, "PARTIAL"),
    ] {
        run.info.state = state;
        let text = report(&run, Glyphs::Ascii);
        let top: Vec<&str> = text.lines().take(10).collect();
        assert!(top.iter().any(|line| line.contains(word)), "{top:?}");
    }
}

#[test]
fn an_empty_run_is_reported_too() {
    let mut run = run();
    run.history = seacable::run::History::default();
    run.shapes.clear();
    run.profiles.clear();
    run.summary.clear();
    let text = report(&run, Glyphs::Braille);
    assert!(text.contains("The run holds no results."));
    assert!(!text.contains("Charts"));
}
