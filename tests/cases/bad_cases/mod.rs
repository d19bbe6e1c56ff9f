//! Bad case files, one by one: each fault is reported with line, column, key, reason and remedy.

mod bodies;
mod claims;
mod creep;
mod files;
mod keys;
mod line;
mod load_cases;
mod loads;
mod rope;
mod sea;
mod values;

use seacable::case::{self, Diagnostic};

/// A small case without faults. Every test below spoils it in one place.
const GOOD: &str = r#"[case]
title = "Test"

[current]
speed_m_per_s = [0.5, 0.2]
depth_m = [0.0, 100.0]

[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 200.0
ea_n = 1e9
axial_damping_ratio = 0.02
drag_normal = 1.2

[[line]]
name = "upper"
material = "chain"
length_m = 80.0
segments = 8

[[line]]
name = "lower"
material = "chain"
length_m = 20.0
segments = 2

[ends.a]
name = "vessel"
kind = "fixed"
position_m = [0.0, 0.0, 0.0]

[ends.b]
name = "load"
kind = "payload"

[payload]
dry_mass_kg = 1000.0
wet_mass_kg = 800.0
drag_area_m2 = 2.0
added_mass_kg = 500.0

[[floats]]
section = "upper"
from_m = 10.0
to_m = 30.0
lift_kg = 100.0

[marks]
"payload.drag_area_m2" = { status = "assumed", reason = "a guess" }

[[study]]
name = "current"
key = "materials.chain.diameter_m"
values = [0.05, 0.1]

[[published]]
name = "tension at the load"
channel = "tension_n[lower|load]"
statistic = "mean"
window_s = [0.0, 200.0]
value = 7.7e3
tolerance_rel = 0.03
source = "a paper"
inputs = "published"
at = { study = "current", value = 0.05 }

[[trend]]
name = "thicker, more drag"
study = "current"
channel = "x_m[load]"
statistic = "final"
expect = "rises"
source = "a paper"
"#;

fn faults(text: &str) -> Vec<Diagnostic> {
    case::parse(text, "bad.toml").unwrap_err()
}

/// The one fault of the good case with `old` replaced by `new`.
fn spoilt(old: &str, new: &str) -> Diagnostic {
    assert_eq!(
        GOOD.matches(old).count(),
        1,
        "`{old}` must stand there once"
    );
    let mut found = faults(&GOOD.replace(old, new));
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

/// Holds a fault against where it must be and what it must say.
fn assert_fault(fault: &Diagnostic, at: (u32, u32), key: &str, problem: &str, remedy: &str) {
    assert_eq!((fault.line, fault.column), at, "{fault}");
    assert_eq!(fault.key, key, "{fault}");
    assert!(fault.problem.contains(problem), "{fault}");
    assert!(fault.remedy.contains(remedy), "{fault}");
}

#[test]
fn the_good_case_has_no_faults() {
    assert!(case::parse(GOOD, "good.toml").is_ok());
}
