//! Statistics of a run in time that the file of a system asks for, against closed forms of a motion that it prescribes.

use seacable::case::kind;
use seacable::reference::Outcome;
use seacable::system::SystemFile;
use seacable::system::validation::rows;

use crate::motion::moved;
use crate::{HEAD, solved};

/// A chain whose top goes up and down by 3 m, `z = 3 sin(2 pi t / 40)`, with published values.
fn heaved(published: &[(&str, f64, f64)]) -> String {
    let mut text = "[environment]\nwater_density_kg_per_m3 = 0.0\n[materials.chain]\nmass_kg_per_m = 100.0\ndiameter_m = 0.1\nea_n = 1e9\n\
         [points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -50.0]\n\
         [points.top]\nkind = \"moved\"\nposition_m = [95.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 3.0]\nperiod_s = 40.0\n\
         [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"top\"\nmaterial = \"chain\"\nlength_m = 120.0\nsegments = 24\n\
         [solver]\nmethod = \"quasi\"\ntime_step_s = 0.05\nduration_s = 160.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n".to_owned();
    for (quantity, value, tolerance) in published {
        text.push_str(&format!(
            "[[published]]\nname = \"{quantity}\"\nquantity = \"{quantity}\"\nvalue = {value:?}\ntolerance_abs = {tolerance:?}\nsource = \"closed form\"\ninputs = \"assumed\"\n"
        ));
    }
    text
}

#[test]
fn windows_and_times_are_those_of_the_motion() {
    let at = |t: f64| 3.0 * (std::f64::consts::TAU * t / 40.0).sin();
    let stated = [
        ("z_m[top].max(0..5)", at(5.0), 1e-6),
        ("z_m[top].min(0..25)", at(25.0), 1e-6),
        ("z_m[top].mean(0..20)", 6.0 / std::f64::consts::PI, 1e-4),
        ("z_m[top].final(0..12.5)", at(12.5), 1e-6),
        ("z_m[top].time_of_max(0..40)", 10.0, 1e-3),
        ("z_m[top].time_of_min(0..40)", 30.0, 1e-3),
        ("z_m[top].travel", 3.0, 1e-6),
        ("z_m[top].rate(0..10)", 0.3, 1e-6),
        // From 3 at 10 s to -3 at 30 s: a tenth of the way is left where z is -2.4. Read straight between rows of 0.5 s.
        (
            "z_m[top].rise_time(10..30)",
            20.0 + 20.0 / std::f64::consts::PI * 0.8_f64.asin(),
            1e-2,
        ),
        // Within 2 % of the range of 6 from the last value, -3.
        (
            "z_m[top].settling_time(10..30)",
            20.0 + 20.0 / std::f64::consts::PI * 0.96_f64.asin(),
            2e-2,
        ),
        ("z_m[top].mean_peak", 3.0, 1e-3),
        ("z_m[top].mean_trough", -3.0, 1e-3),
        // The end of the line, where its tension is greatest and it is as high as the top.
        ("tension_n[along chain].arc_of_max", 120.0, 1e-9),
        ("z_m[along chain].max(120..120)", 3.0, 1e-6),
    ];
    let solved = solved(&format!("{HEAD}{}", heaved(&stated)));
    let run = moved(&heaved(&stated));
    let found = rows(&solved, Some(&run));
    assert_eq!(found.len(), stated.len());
    for row in found {
        assert_eq!(
            row.outcome,
            Outcome::Pass,
            "{}: {:?}, not {:?}: {:?}",
            row.name,
            row.computed,
            row.published,
            row.reason
        );
    }
}

#[test]
fn a_window_that_the_run_does_not_reach_is_not_computed() {
    let stated = [("z_m[top].max(0..200)", 3.0, 1e-6)];
    let solved = solved(&format!("{HEAD}{}", heaved(&stated)));
    let found = rows(&solved, Some(&moved(&heaved(&stated))));
    assert_eq!(found[0].outcome, Outcome::NotRun);
}

#[test]
fn statistics_that_cannot_be_taken_are_refused() {
    for (quantity, words) in [
        ("tension_n[chian|b].max", "did you mean \"chain\""),
        ("tension_n.max", "name it: `tension_n[along LINE]`"),
        (
            "tension_n[chain|b].arc_of_max",
            "goes over the length of the line",
        ),
        ("tension_n[along chain].settling_time", "goes over time"),
        ("tension_n[chain|b].max(5..2)", "the window is empty"),
        ("z_m[along chain].mean(50..2)", "the stretch runs backward"),
        ("z_m[along chain].peak", "which peak is meant is not stated"),
    ] {
        let text = format!("{HEAD}{}", heaved(&[(quantity, 1.0, 1.0)]));
        let found = kind::parse::<SystemFile>(&text, "system.toml").unwrap_err();
        let said = format!("{} {}", found[0], found[0].remedy);
        assert!(said.contains(words), "{quantity}: {said}");
    }
}
