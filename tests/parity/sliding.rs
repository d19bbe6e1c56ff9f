//! Length of line that slides over the bed, of a line and of the system of it, against its closed form.

use std::path::Path;

use seacable::case::QuantityId;
use seacable::import::line_case;
use seacable::run::result_scales;

use crate::one_line::{line_run, system_run};

/// Axial stiffness \[N\], weight \[N/m\], friction \[-\].
const EA: f64 = 1e7;
const WEIGHT: f64 = 1e3;
const FRICTION: f64 = 0.5;
/// Length of a segment \[m\].
const SEGMENT: f64 = 2.0;
/// How far the end is pulled out \[m\], before it is pushed back, and how long that takes both ways \[s\]; half-way back the rope is slack there.
const PULLED: f64 = 0.5;
const PERIOD: f64 = 200.0;

/// A line of 200 m on a level bed, whose end is pulled out along it.
fn pulled(method: &str, law: &str) -> String {
    let (middle, amplitude) = (200.0 + 0.5 * PULLED, 0.5 * PULLED);
    let mass = WEIGHT / 10.0;
    format!(
        "[case]\ntitle = \"Pulled over the bed\"\n[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n\
         [seabed]\ndepth_m = 50.0\nstiffness_n_per_m3 = 1e6\ndamping_n_s_per_m3 = 1e5\nfriction = {FRICTION:?}\n{law}\
         [materials.rope]\ndiameter_m = 0.1\nmass_kg_per_m = {mass:?}\nea_n = {EA:?}\naxial_damping_ratio = 0.2\n\
         [[line]]\nname = \"rope\"\nmaterial = \"rope\"\nlength_m = 200.0\nsegments = 100\n\
         [ends.a]\nname = \"far\"\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -50.0]\n\
         [ends.b]\nname = \"end\"\nkind = \"moving\"\nposition_m = [{middle:?}, 0.0, -50.0]\n\
         amplitude_m = [{amplitude:?}, 0.0, 0.0]\nperiod_s = {PERIOD:?}\nphase_deg = [-90.0, 0.0, 0.0]\n\
         [solver]\nmethod = \"{method}\"\nduration_s = 150.0\ntime_step_s = 0.05\nerror_estimate = false\nposition_tolerance_m = 1e-9\n[output]\ninterval_s = 1.0\n"
    )
}

/// The length that slides by the closed form: where tension falls by the friction of the weight from the end on, `u = mu w L² / 2 EA`. Pushed back
/// friction turns, by twice as much.
fn closed_form(t: f64) -> f64 {
    let out = |t: f64| 0.5 * PULLED * (1.0 - (std::f64::consts::TAU * t / PERIOD).cos());
    let friction = FRICTION * WEIGHT;
    match t <= 0.5 * PERIOD {
        true => (2.0 * EA * out(t) / friction).sqrt(),
        false => (EA * (PULLED - out(t)) / friction).sqrt(),
    }
}

#[test]
fn what_slides_follows_the_pull_and_begins_anew_where_it_turns() {
    for method in ["alpha", "quasi"] {
        let text = pulled(method, "grip_stiffness_n_per_m3 = 3e7\n");
        let system = line_case::read(&text, Path::new("line.toml")).unwrap().text;
        let line = line_run(text).history;
        let values = &line.channel("sliding_m[line]").unwrap().values;
        let system = system_run(&system).history;
        let other = &system.channel("sliding_m[line]").unwrap().values;
        assert_eq!(values, other, "{method}");
        // Where the end hardly moves nothing tells what slides from what rests.
        let moves = |t: f64| (t % (0.5 * PERIOD) - 0.25 * PERIOD).abs() < 0.22 * PERIOD;
        for (t, value) in line.time.iter().zip(values).filter(|(t, _)| moves(**t)) {
            let off = (value - closed_form(*t)).abs();
            assert!(off < 2.0 * SEGMENT, "{method}, {t} s: {value} {off}");
        }
    }
}

/// It counts nodes: its bar is a segment at least, and no accuracy is asked of it.
#[test]
fn the_length_that_slides_is_known_to_a_segment() {
    let text = pulled("alpha", "").replace("duration_s = 150.0", "duration_s = 4.0");
    let text = text.replace("error_estimate = false", "error_estimate = true");
    let run = line_run(text);
    let sliding = |id: &QuantityId| id.to_string().starts_with("sliding_m");
    let own: Vec<_> = run.summary.iter().filter(|q| sliding(&q.id)).collect();
    assert_eq!(own.len(), 4);
    for quantity in own {
        let error = quantity.error_estimate().unwrap();
        assert!(error >= SEGMENT, "{quantity:?}");
    }
    let scales = result_scales(4.0, &run);
    assert!(!scales.is_empty() && !scales.iter().any(|(id, _)| sliding(id)));
}

#[test]
fn what_holds_nothing_at_rest_has_no_length_that_slides() {
    let law = "friction_law = \"zhu-2017\"\nslip_speed_m_per_s = 1e-3\n";
    let text = pulled("alpha", law).replace("duration_s = 150.0", "duration_s = 1.0");
    let system = line_case::read(&text, Path::new("line.toml")).unwrap().text;
    let name = "sliding_m[line]";
    assert!(line_run(text).history.channel(name).is_none());
    assert!(system_run(&system).history.channel(name).is_none());
}
