//! Natural modes of shipped line cases, and of the systems that they are converted to.

use std::path::Path;

use seacable::case::{self, Case, kind, shipped};
use seacable::import::line_case;
use seacable::modes::{LineModes, Mode, ModeKind, of_case};
use seacable::run::natural_modes;
use seacable::system::motion::modes::modes_of_system;
use seacable::system::{SystemFile, quantities};

/// Modes that are compared.
const COUNT: usize = 8;
/// Relative difference of frequencies that counts as none, and the frequency below which all are rounding \[Hz\]: both rest to the tolerances of
/// their own searches.
const ALIKE: f64 = 1e-8;
const NONE_HZ: f64 = 1e-4;

/// A few cases of all kinds: hanging, on a bed, with floats, with a payload, bending, of ropes, in a current.
const CASES: [&str; 11] = [
    "basics/hanging_line.toml",
    "basics/mooring_static.toml",
    "basics/steep_wave.toml",
    "benchmarks/beam_simply_supported.toml",
    "benchmarks/current_across.toml",
    "benchmarks/point_load.toml",
    "double_stepped/cable.toml",
    "mooring/heaved_50m.toml",
    "mooring/hybrid_fixed.toml",
    "pendulous/manifold.toml",
    "umbilical/steep_wave.toml",
];

fn text_of(name: &str) -> &'static str {
    let mut all = shipped::SHIPPED.iter();
    all.find(|(known, _)| *known == name).unwrap().1
}

fn path_of(name: &str) -> String {
    format!("{}/cases/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn case_of(name: &str) -> Case {
    case::parse(text_of(name), &path_of(name)).unwrap()
}

/// The modes of the system that a case is converted to.
fn of_converted(name: &str, count: usize) -> LineModes {
    let imported = line_case::read(text_of(name), Path::new(&path_of(name))).unwrap();
    let solved = kind::parse::<SystemFile>(&imported.text, &path_of(name)).unwrap();
    modes_of_system(&solved, count).unwrap()
}

/// Frequencies \[Hz\], rising.
fn frequencies(found: &LineModes) -> Vec<f64> {
    let mut all: Vec<f64> = found.modes.iter().map(|m| m.mode.frequency_hz()).collect();
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn converted_lines_have_the_modes_of_the_line() {
    for name in CASES {
        let of_line = of_case(&case_of(name), COUNT).unwrap();
        let of_system = of_converted(name, COUNT);
        let pairs = frequencies(&of_line)
            .into_iter()
            .zip(frequencies(&of_system));
        assert_eq!(of_line.modes.len(), of_system.modes.len(), "{name}");
        for (line, system) in pairs {
            let off = (line - system).abs();
            println!("{name}: {line:.9} Hz, {system:.9} Hz, {:.1e}", off / line);
            assert!(
                off < ALIKE * line.abs().max(NONE_HZ),
                "{name}: {line} {system}"
            );
        }
        let kinds = |found: &LineModes, kind: ModeKind| {
            let modes = found.modes.iter();
            modes.filter(|mode| mode.mode.kind == kind).count()
        };
        for kind in [ModeKind::InPlane, ModeKind::OutOfPlane] {
            assert_eq!(kinds(&of_line, kind), kinds(&of_system, kind), "{name}");
        }
    }
}

#[test]
fn numbers_of_modes_are_results_of_a_system_that_asks_for_them() {
    let name = "double_stepped/cable.toml";
    let imported = line_case::read(text_of(name), Path::new(&path_of(name))).unwrap();
    let solved = kind::parse::<SystemFile>(&imported.text, &path_of(name)).unwrap();
    let case = case_of(name);
    let asked = case.modes.as_ref().unwrap();
    let found = of_case(&case, natural_modes::wanted(asked)).unwrap();
    let modes: Vec<Mode> = found.modes.into_iter().map(|named| named.mode).collect();
    let of_line = natural_modes::numbers(asked, &modes);
    assert_eq!(of_line.len(), 2 * (asked.count + 1));
    for number in of_line {
        let (of, _) = number.id.parts();
        let value = quantities::value(&solved, &of.to_string()).unwrap();
        assert!((value / number.value - 1.0).abs() < ALIKE, "{of}: {value}");
    }
    let without = imported.text.replace("count = 14", "count = 3");
    let faults = kind::parse::<SystemFile>(&without.replace("near_hz = 0.1", ""), &path_of(name));
    let faults = faults.unwrap_err();
    assert_eq!(faults.len(), 5, "{faults:?}");
    assert!(
        faults
            .iter()
            .all(|fault| fault.problem.contains("does not ask for"))
    );
}
