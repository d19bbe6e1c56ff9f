//! Systems of lines, at rest and in motion: closed forms, stiffness against differences, invariance, random systems, refusals.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod accuracy;
mod ageing;
mod analysis;
mod attached;
mod audit;
mod bodies;
mod channels;
mod clamps;
mod closed_forms;
mod creep;
mod current_file;
mod discretised;
mod exported;
mod floating;
mod foreign_arrays;
mod foreign_clamps;
mod foreign_dialects;
mod foreign_files;
mod foreign_pinned;
mod foreign_water;
mod foreign_yaml;
mod foreign_yaml_faults;
mod frequency_domain;
mod friction;
mod grid_bed;
mod hauled;
mod line_start;
mod motion;
mod on_bed;
mod payout;
mod pinned;
mod potential_flow;
mod published;
mod random;
mod refusals;
mod statistics;
mod stiffness;
mod turning;
mod waves;

use seacable::case::kind;
use seacable::system::{SolvedSystem, SystemFile};

/// A system of a text, solved.
fn solved(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(text, "system.toml").unwrap()
}

/// Tensions at both ends of a line by its name.
fn tensions(system: &SolvedSystem, line: &str) -> [f64; 2] {
    let index = system.network.line(line).unwrap();
    system.rest.balance.lines[index].tensions()
}

/// The place of a point by its name.
fn place(system: &SolvedSystem, point: &str) -> [f64; 3] {
    let index = system.network.point(point).unwrap();
    system.rest.placement.points[index].into()
}

const HEAD: &str = "[system]\ntitle = \"test\"\n";
