//! What `[output]` asks for is recorded alike of a line and of the system of it.

use std::path::Path;

use seacable::import::line_case;
use seacable::run::History;

use crate::line_keys::{WIRE, greatest_difference};
use crate::one_line::{line_run, system_run};

/// The histories of the wire with these keys of `[output]`, as a line and as a system.
fn both(output: &str) -> [History; 2] {
    let text = WIRE.replace("\"long_m\"", "40.0");
    let text = format!("{text}{output}");
    let system = line_case::read(&text, Path::new("wire.toml")).unwrap().text;
    [line_run(text).history, system_run(&system).history]
}

fn values<'h>(history: &'h History, name: &str) -> &'h [f64] {
    &history.channel(name).unwrap().values
}

/// The energy of the system is that of the line, and it moves.
#[test]
fn energy_of_the_system_is_that_of_the_line() {
    let [line, system] = both("energy = true\n");
    let (own, other) = (
        values(&line, "energy_j[line]"),
        values(&system, "energy_j[system]"),
    );
    assert!(own.len() == 21 && other.len() == 21);
    assert!(greatest_difference(own, other) < 1e-9, "{own:?} {other:?}");
    let swing =
        own.iter().copied().fold(f64::MIN, f64::max) - own.iter().copied().fold(f64::MAX, f64::min);
    assert!(swing > 100.0, "{swing}");
}

/// Both record the pull on held ends where they are asked to, and the system of a line by itself as the line does.
#[test]
fn pulls_on_held_ends_are_recorded_alike() {
    let [line, system] = both("uplift = true\n");
    for name in ["uplift_n[anchor]", "force_z_n[anchor]", "force_x_n[ship]"] {
        let (own, other) = (values(&line, name), values(&system, name));
        assert!(greatest_difference(own, other) < 1e-8, "{name}");
    }
    let [uplift, force] = ["uplift_n[anchor]", "force_z_n[anchor]"].map(|of| values(&line, of));
    assert!(uplift == force && uplift[0].abs() > 1.0, "{uplift:?}");
    for history in both("forces = false\n") {
        assert!(history.channel("force_z_n[anchor]").is_none());
        assert!(history.channel("uplift_n[anchor]").is_none());
    }
}
