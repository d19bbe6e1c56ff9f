//! Chains whose fairlead heaves, against OrcaFlex by the measure of MoorDyn's own tests: the greatest difference of the change of the
//! tension from rest, over twice the greatest change. MoorDyn passes at 0.15.

use std::sync::atomic::AtomicBool;

use seacable::case::{self, edit, shipped};
use seacable::run::RunState;
use seacable::run::job::{Request, execute};

const LIMIT: f64 = 0.12;

fn measure(depth: &str, amplitude: usize, at_rest: f64) -> f64 {
    let path = format!("mooring/heaved_{depth}m.toml");
    let (_, text) = shipped::SHIPPED.iter().find(|(p, _)| *p == path).unwrap();
    let text = edit::set(text, "ends.b.amplitude_m.z", &format!("{amplitude}.0")).unwrap();
    let case = case::parse(&text, &path).unwrap();
    let record = case.published_curve[amplitude / 5].clone();
    let request = Request {
        case,
        text,
        file: path,
        overrides: Vec::new(),
        id: String::new(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done);
    let times = &run.history.time;
    let named = |name: &str| run.history.channels.iter().find(|c| c.name() == name);
    let tension = named("tension_n[chain|top]").unwrap();
    let still = tension.values[0];
    let (mut off, mut change) = (0.0_f64, 0.0_f64);
    for (time, value) in record.time_s.iter().zip(&record.value) {
        let here = times.iter().position(|t| (t - time).abs() < 1e-6).unwrap();
        off = off.max(((tension.values[here] - still) - (value - at_rest)).abs());
        change = change.max((value - at_rest).abs());
    }
    off / (2.0 * change)
}

#[test]
fn chains_are_heaved_as_by_orcaflex() {
    for (depth, at_rest) in [("50", 991.6e3), ("200", 2065.4e3), ("600", 5232.6e3)] {
        for amplitude in [2, 5] {
            let found = measure(depth, amplitude, at_rest);
            println!("{depth} m of water, heave of {amplitude} m: {found:.3}");
            assert!(found <= LIMIT, "{depth} m, {amplitude} m: {found:.3}");
        }
    }
}
