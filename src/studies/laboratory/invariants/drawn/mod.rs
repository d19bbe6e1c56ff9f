//! Random systems with all that a file may have: bed, friction, slopes, current, waves, wind, members, bodies that float, are moved or pinned,
//! rods, lines that are paid out, let go or break, ropes with tables, lines that bend or float, a surface that is crossed, clumps.

mod environment;
mod parts;
mod plane;
mod systems;

use std::fmt::{Arguments, Write};

use toml::Table;

pub(super) use self::plane::Plane;
use crate::numerics::random::Random;

/// The kinds, in turn; the last of them in motion alone.
pub const KINDS: [&str; 10] = [
    "lines between held ends",
    "web of free points",
    "floating body",
    "moved body",
    "buoy of members",
    "rods and pinned bodies",
    "bodies with a shared line",
    "clump on the bed",
    "line paid out",
    "end let go, line that breaks",
];
/// Kinds that differ from others in motion alone.
pub(super) const IN_MOTION_ALONE: usize = 2;

/// Simulated time \[s\].
const DURATION_S: f64 = 5.0;

/// A random system of a kind, in motion or at rest.
///
/// # Errors
/// Where what is written is no TOML, which would be a fault here.
pub(super) fn drawn(kind: usize, random: &mut Random, moves: bool) -> Result<Table, String> {
    let mut maker = DrawnSystemWriter {
        random,
        text: String::new(),
        moves,
        plane: Plane {
            depth: 0.0,
            by_x: 0.0,
            by_y: 0.0,
        },
        bed: false,
        current: false,
        lines: 0,
        points: 0,
    };
    maker.head();
    match kind {
        0 => maker.held(),
        1 => maker.web(),
        2 => maker.body("free"),
        3 => maker.body("moved"),
        4 => maker.buoy(),
        5 => maker.rods(),
        6 => maker.shared(),
        7 => maker.clump(),
        8 => maker.paid_out(),
        _ => maker.let_go(),
    }
    toml::from_str(&maker.text).map_err(|why| format!("{why}\n{}", maker.text))
}

struct DrawnSystemWriter<'a> {
    random: &'a mut Random,
    text: String,
    moves: bool,
    plane: Plane,
    /// Whether there is a bed.
    bed: bool,
    current: bool,
    lines: usize,
    points: usize,
}

impl DrawnSystemWriter<'_> {
    fn put(&mut self, words: Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.text.write_fmt(words);
    }
}
