//! What is recorded of a system in motion beside tensions and places, against closed forms and other results of the same run.

use std::sync::atomic::AtomicBool;

use seacable::run::Run;
use seacable::run::job::{Request, execute};

use crate::motion::{channel, moved};
use crate::{HEAD, solved};

/// The history of a channel of a line case.
fn of_line(text: &str, name: &str) -> Vec<f64> {
    let case = seacable::case::parse(&format!("[case]\ntitle = \"t\"\n{text}"), "t.toml").unwrap();
    let request = Request {
        case,
        text: String::new(),
        file: "t.toml".to_owned(),
        overrides: Vec::new(),
        id: "t".to_owned(),
    };
    let run: Run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.failure, None);
    run.history.channel(name).unwrap().values.clone()
}

/// Weight of the chain \[N/m\] and its length \[m\].
const WEIGHT: f64 = 1000.0;
const LENGTH: f64 = 120.0;

const CHAIN: &str = "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n\
     [seabed]\ndepth_m = 50.0\nstiffness_n_per_m3 = 1e6\n[materials.chain]\nmass_kg_per_m = 100.0\ndiameter_m = 0.1\nea_n = 1e9\n";

/// A chain on the bed, its top heaved slowly.
fn chain(recorded: &str) -> String {
    format!(
        "{CHAIN}[points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -50.0]\n\
         [points.top]\nkind = \"moved\"\nposition_m = [95.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 3.0]\nperiod_s = 40.0\n\
         [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"top\"\nmaterial = \"chain\"\nlength_m = {LENGTH:?}\nsegments = 60\n\
         [solver]\nmethod = \"quasi\"\nduration_s = 40.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n{recorded}\n"
    )
}

#[test]
fn the_length_on_the_bed_is_what_the_top_does_not_carry() {
    let run = moved(&chain("uplift = true"));
    let on_bed = channel(&run, "on_bed_m[chain]");
    let pull = channel(&run, "uplift_n[top]");
    for (on_bed, pull) in on_bed.iter().zip(pull) {
        let carried = LENGTH + pull / WEIGHT;
        assert!((on_bed - carried).abs() < 1e-4, "{on_bed} {carried}");
    }
    // The closed form at rest.
    let at_rest = solved(&format!("{HEAD}{}", chain("")));
    let catenary = at_rest.rest.balance.lines[0].on_bed();
    assert!(
        (on_bed[0] - catenary).abs() < 0.05,
        "{} {catenary}",
        on_bed[0]
    );
    // It passes several segments of 2 m, and never jumps.
    let steps = on_bed.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    assert!(steps.fold(0.0, f64::max) < 1.0, "{on_bed:?}");
    let swing = on_bed
        .iter()
        .fold(0.0_f64, |most, s| most.max((s - on_bed[0]).abs()));
    assert!(swing > 4.0, "{swing}");
}

#[test]
fn a_line_case_has_the_same_length_on_the_bed() {
    let line = of_line(
        &format!(
            "{CHAIN}[[line]]\nname = \"chain\"\nmaterial = \"chain\"\nlength_m = {LENGTH:?}\nsegments = 60\n\
             [ends.a]\nname = \"anchor\"\nkind = \"anchor\"\nposition_m = [0.0, 0.0, -50.0]\n\
             [ends.b]\nname = \"top\"\nkind = \"moving\"\nposition_m = [95.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 3.0]\nperiod_s = 40.0\n\
             [solver]\nmethod = \"quasi\"\nduration_s = 40.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n"
        ),
        "on_bed_m[line]",
    );
    let run = moved(&chain(""));
    let pairs = line.iter().zip(channel(&run, "on_bed_m[chain]"));
    for (line, system) in pairs {
        assert!((line - system).abs() < 0.02, "{line} {system}");
    }
}
