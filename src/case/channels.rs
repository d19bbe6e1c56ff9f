//! The channels a run of a case records, named from the words of the case.
//!
//! One function decides names and order, so that the run, its files, the charts and the checks of
//! published values never disagree.

use super::{Case, DynamicStiffness, End, EndKind};

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
    /// A coordinate of the body that travels along the line \[m\].
    Traveller(usize),
    /// Unstretched length from end A to the body that travels along the line \[m\].
    TravellerArc,
    /// Tension of the line where that body is \[N\].
    TravellerTension,
    /// Angle between the axis of a payload that turns and straight down \[deg\].
    Tilt,
    /// Energy of the whole line and what hangs on it \[J\].
    Energy,
    /// Height of the waves above still water over the gauge \[m\].
    Elevation,
    /// What the dynamic stiffness of a section, by its number, stands at in its first or last segment.
    Rope(usize, LineEnd, RopeQuantity),
}

/// A quantity of dynamic stiffness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RopeQuantity {
    /// Lm: mean of the past tension, in percent of the breaking load.
    MeanLoad,
    /// La: deviation of the tension from that mean, in percent of the breaking load.
    Deviation,
    /// k: stiffness EA by breaking load \[-\].
    Stiffness,
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
/// then position of every end that moves and speed of every end that nothing holds (of a payload that turns, of its centre
/// of gravity, and its tilt), then position of every body hung on the line, place of the body that
/// travels along it and the tension there, then the line's pull on every held end, then the height of the waves, then
/// its energy where that is asked for, then the dynamic stiffness at both ends of every section that has it: `polyester.a`
/// is its first segment, `polyester.b` its last. An end that is let go at some time counts as one that nothing holds, too.
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
    let turns = case
        .payload
        .as_ref()
        .is_some_and(|body| body.rotation.is_some());
    list.extend(tilt_channel(&case.ends.b.name, case.ends.b.kind, turns));
    for (index, clump) in case.clumps.iter().enumerate() {
        list.extend(body_channels(index, &clump.name));
    }
    if let Some(traveller) = &case.traveller {
        list.extend(traveller_channels(&traveller.name));
    }
    for (which, end) in [(LineEnd::A, &case.ends.a), (LineEnd::B, &case.ends.b)] {
        list.extend(force_channels(which, &end.name, end.kind));
    }
    list.extend(case.waves.as_ref().map(|_| elevation_channel()));
    list.extend(case.output.energy.then(energy_channel));
    for (index, section) in case.line.iter().enumerate() {
        let material = case.materials.get(&section.material);
        if material.is_some_and(|m| m.dynamic_stiffness != DynamicStiffness::None) {
            list.extend(rope_channels(index, &section.name));
        }
    }
    list
}

/// Height of the waves.
pub(crate) fn elevation_channel() -> Channel {
    Channel {
        name: "wave_elevation_m[gauge]".to_owned(),
        unit: "m",
        source: Source::Elevation,
    }
}

/// Energy of the whole line.
pub(crate) fn energy_channel() -> Channel {
    Channel {
        name: "energy_j[line]".to_owned(),
        unit: "J",
        source: Source::Energy,
    }
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

/// Place of a body that travels along the line, and the tension there.
pub(crate) fn traveller_channels(name: &str) -> Vec<Channel> {
    let place = AXES.into_iter().enumerate().map(|(axis, letter)| Channel {
        name: format!("{letter}_m[{name}]"),
        unit: "m",
        source: Source::Traveller(axis),
    });
    let mut list: Vec<Channel> = place.collect();
    list.push(Channel {
        name: format!("arc_m[{name}]"),
        unit: "m",
        source: Source::TravellerArc,
    });
    list.push(Channel {
        name: format!("tension_n[{name}]"),
        unit: "N",
        source: Source::TravellerTension,
    });
    list
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

/// Dynamic stiffness at both ends of a section.
pub(crate) fn rope_channels(section: usize, name: &str) -> impl Iterator<Item = Channel> {
    let quantities = [
        ("mean_load_percent", "%", RopeQuantity::MeanLoad),
        ("load_deviation_percent", "%", RopeQuantity::Deviation),
        ("stiffness_k", "-", RopeQuantity::Stiffness),
    ];
    let ends = [("a", LineEnd::A), ("b", LineEnd::B)];
    quantities
        .into_iter()
        .flat_map(move |(quantity, unit, which)| {
            ends.map(|(letter, end)| Channel {
                name: format!("{quantity}[{name}.{letter}]"),
                unit,
                source: Source::Rope(section, end, which),
            })
        })
}

const AXES: [&str; 3] = ["x", "y", "z"];

fn end_channels(which: LineEnd, end: &End) -> Vec<Channel> {
    motion_channels(which, &end.name, end.kind, end.release_s.is_some())
}

/// Tilt of a payload at end B, if that turns.
pub(crate) fn tilt_channel(name: &str, kind: EndKind, turns: bool) -> Option<Channel> {
    (turns && kind == EndKind::Payload).then(|| Channel {
        name: format!("tilt_deg[{name}]"),
        unit: "deg",
        source: Source::Tilt,
    })
}

/// Position and speed of an end of this name and kind, which is let go at some time or is not.
pub(crate) fn motion_channels(
    which: LineEnd,
    name: &str,
    kind: EndKind,
    let_go: bool,
) -> Vec<Channel> {
    let (moves, loose) = match kind {
        _ if let_go => (true, true),
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
