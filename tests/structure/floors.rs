//! The floors of the program, each of which stands on those below, and their rooms.

use crate::arrows::{Arrows, words};

/// The folders of `src` from the lowest up.
pub(crate) const FLOORS: [&str; 16] = [
    "numerics",
    "physics",
    "base",
    "display",
    "statistics",
    "keys",
    "model",
    "engine",
    "runs",
    "systems",
    "foreign",
    "studies",
    "report",
    "jobs",
    "tui",
    "cli",
];

/// The floors whose modules are rooms of their own. The others are one room.
const OF_ROOMS: [&str; 9] = [
    "base",
    "display",
    "statistics",
    "model",
    "engine",
    "runs",
    "systems",
    "foreign",
    "studies",
];

/// The arrows that lead to a higher floor.
pub(crate) fn arrows_up(files: &Arrows) -> Vec<String> {
    let up = files
        .each()
        .filter(|(from, to, _)| height(from) < height(to));
    up.map(|(from, to, names)| format!("  {from} -> {to}: {}", words(names)))
        .collect()
}

/// The room that a file belongs to: `model/case`, `tui`.
pub(crate) fn room(file: &str) -> String {
    let (floor, rest) = file.split_once('/').unwrap();
    if !OF_ROOMS.contains(&floor) {
        return floor.to_owned();
    }
    let room = rest.split('/').next().unwrap();
    format!("{floor}/{}", room.trim_end_matches(".rs"))
}

fn height(file: &str) -> usize {
    let (folder, _) = file.split_once('/').unwrap();
    FLOORS.iter().position(|floor| *floor == folder).unwrap()
}
