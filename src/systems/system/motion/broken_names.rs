//! The names of the parts of a line that may break.

use super::moving_system::MovingSystem;

/// What the name of the second part of a line ends in, and of the point between both. No name in a file has a blank.
pub(super) const SECOND: &str = " beyond the break";

pub(super) const BETWEEN: &str = " at the break";

/// Whether a point stands between the parts of a line that may break.
#[must_use]
pub fn is_between(name: &str) -> bool {
    name.ends_with(BETWEEN)
}

/// The name under which an end of a line is known: the end B of a line that may break is that of its second part. Nothing for the
/// ends at the break.
#[must_use]
pub fn name_of_end(system: &MovingSystem, line: usize, end: usize) -> Option<String> {
    let given = &system.network.lines[line];
    let point = [given.from, given.to][end];
    let at_break = is_between(&system.network.points[point].name);
    (!at_break).then(|| given.name.replace(SECOND, ""))
}
