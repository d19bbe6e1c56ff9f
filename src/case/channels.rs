//! The channels a run of a case records, named from the words of the case.
//!
//! One function decides names and order, so that the run, its files, the charts and the checks of
//! published values never disagree.

use super::{Case, End, EndKind};

/// A quantity recorded against time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Channel {
    /// Name, beginning with quantity and unit: `tension_n[wire|payload]`.
    pub name: String,
    /// Unit as shown: "N", "m", "m/s".
    pub unit: &'static str,
    /// What is recorded.
    pub source: Source,
}

/// Where the values of a channel come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// Tension at a joint: 0 at end A, then after each section, the last at end B \[N\].
    Joint(usize),
    /// A coordinate of an end, 0 for x, 1 for y, 2 for z \[m\].
    Coordinate(LineEnd, usize),
    /// A coordinate of a body hung on the line, by its number in the case \[m\].
    Body(usize, usize),
    /// A component of the line's pull on a held end, 0 for x, 1 for y, 2 for z \[N\].
    Force(LineEnd, usize),
    /// Speed of an end over ground \[m/s\].
    Speed(LineEnd),
}

/// One of the two ends of the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineEnd {
    /// Where arc length is zero.
    A,
    /// Where arc length is greatest.
    B,
}

/// The channels a run of this case records, in their order: tensions at the joints from A to B,
/// then position of every end that moves and speed of every end that nothing holds, then position of every body hung on
/// the line, then the line's pull on every held end.
#[must_use]
pub fn channels(case: &Case) -> Vec<Channel> {
    let sections = case.line.iter().map(|section| section.name.as_str());
    let names: Vec<&str> = std::iter::once(case.ends.a.name.as_str())
        .chain(sections)
        .chain(std::iter::once(case.ends.b.name.as_str()))
        .collect();
    let mut list = joint_channels(&names);
    list.extend(end_channels(LineEnd::A, &case.ends.a));
    list.extend(end_channels(LineEnd::B, &case.ends.b));
    for (index, clump) in case.clumps.iter().enumerate() {
        list.extend(body_channels(index, &clump.name));
    }
    for (which, end) in [(LineEnd::A, &case.ends.a), (LineEnd::B, &case.ends.b)] {
        list.extend(force_channels(which, &end.name, end.kind));
    }
    list
}

/// Tensions at the joints between neighbours of this list of names, from end A to end B.
pub(crate) fn joint_channels(names: &[&str]) -> Vec<Channel> {
    names
        .windows(2)
        .enumerate()
        .map(|(joint, pair)| Channel {
            name: format!("tension_n[{}|{}]", pair[0], pair[1]),
            unit: "N",
            source: Source::Joint(joint),
        })
        .collect()
}

/// Position of a body hung on the line.
pub(crate) fn body_channels(index: usize, name: &str) -> impl Iterator<Item = Channel> {
    AXES.into_iter()
        .enumerate()
        .map(move |(axis, letter)| Channel {
            name: format!("{letter}_m[{name}]"),
            unit: "m",
            source: Source::Body(index, axis),
        })
}

/// The line's pull on an end of this name and kind, if it is held.
pub(crate) fn force_channels(
    which: LineEnd,
    name: &str,
    kind: EndKind,
) -> impl Iterator<Item = Channel> {
    let held = !matches!(kind, EndKind::Payload | EndKind::Free);
    let axes = AXES.into_iter().enumerate().filter(move |_| held);
    axes.map(move |(axis, letter)| Channel {
        name: format!("force_{letter}_n[{name}]"),
        unit: "N",
        source: Source::Force(which, axis),
    })
}

const AXES: [&str; 3] = ["x", "y", "z"];

fn end_channels(which: LineEnd, end: &End) -> Vec<Channel> {
    motion_channels(which, &end.name, end.kind)
}

/// Position and speed of an end of this name and kind.
pub(crate) fn motion_channels(which: LineEnd, name: &str, kind: EndKind) -> Vec<Channel> {
    let (moves, loose) = match kind {
        EndKind::Fixed | EndKind::Anchor => (false, false),
        EndKind::Moving => (true, false),
        EndKind::Payload | EndKind::Free => (true, true),
    };
    let coordinates = AXES.into_iter().enumerate();
    let mut list: Vec<Channel> = coordinates
        .filter(|_| moves)
        .map(|(axis, letter)| Channel {
            name: format!("{letter}_m[{name}]"),
            unit: "m",
            source: Source::Coordinate(which, axis),
        })
        .collect();
    if loose {
        list.push(Channel {
            name: format!("speed_m_per_s[{name}]"),
            unit: "m/s",
            source: Source::Speed(which),
        });
    }
    list
}
