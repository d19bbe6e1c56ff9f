//! The channels that a run of a case records: which quantity, at which place.
//!
//! A channel is identified by a [`ChannelId`], whose text (`tension_n[wire|payload]`) is its name in files. One table
//! declares every [`ChannelQuantity`] with name, unit and the words of its chart; [`channels`] lists the channels of a
//! case and their order.

use std::fmt;
use std::str::FromStr;

use super::{Case, DynamicStiffness, EndKind};

/// Declares the quantities: variant, name in files, unit, label on the axis of a chart, title of the chart.
macro_rules! channel_quantities {
    ($($(#[$doc:meta])* $variant:ident: $name:literal, $unit:literal, $label:literal, $title:literal;)*) => {
        /// A quantity that is recorded against time.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum ChannelQuantity { $($(#[$doc])* $variant,)* }

        impl ChannelQuantity {
            /// All quantities.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Name in files, which ends in the unit: `tension_n`.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// Unit as shown: "N", "m/s"; "-" where there is none.
            #[must_use]
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$variant => $unit,)* }
            }

            /// Label on the axis of a chart.
            #[must_use]
            pub const fn label(self) -> &'static str {
                match self { $(Self::$variant => $label,)* }
            }

            /// Title of a chart against time.
            #[must_use]
            pub const fn title(self) -> &'static str {
                match self { $(Self::$variant => $title,)* }
            }
        }
    };
}

channel_quantities! {
    /// Tension of the line \[N\].
    Tension: "tension_n", "N", "tension", "Tension at the joints";
    /// First coordinate \[m\].
    X: "x_m", "m", "x", "x";
    /// Second coordinate \[m\].
    Y: "y_m", "m", "y", "y";
    /// Height above still water \[m\].
    Z: "z_m", "m", "z", "z";
    /// Speed over ground \[m/s\].
    Speed: "speed_m_per_s", "m/s", "speed", "Speed";
    /// Angle between the axis of a rigid payload and straight down \[deg\].
    Tilt: "tilt_deg", "deg", "tilt", "Tilt of the payload";
    /// Unstretched length from end A to a body that travels along the line \[m\].
    Arc: "arc_m", "m", "arc length", "Place along the line";
    /// First component of the line's force on a held end \[N\].
    ForceX: "force_x_n", "N", "force", "Force on the ends, x";
    /// Second component of the line's force on a held end \[N\].
    ForceY: "force_y_n", "N", "force", "Force on the ends, y";
    /// Vertical component of the line's force on a held end \[N\].
    ForceZ: "force_z_n", "N", "force", "Force on the ends, z";
    /// Height of the waves above still water over the gauge \[m\].
    WaveElevation: "wave_elevation_m", "m", "elevation", "Height of the waves";
    /// Energy of the whole line and what hangs on it \[J\].
    Energy: "energy_j", "J", "energy", "Energy";
    /// Lm: mean of the past tension of a rope with dynamic stiffness \[% of the breaking load\].
    MeanLoad: "mean_load_percent", "%", "of the breaking load", "Mean load (Lm)";
    /// La: deviation of the tension from that mean \[% of the breaking load\].
    LoadDeviation: "load_deviation_percent", "%", "of the breaking load", "Deviation from the mean load (La)";
    /// k: stiffness EA by breaking load of such a rope \[-\].
    Stiffness: "stiffness_k", "-", "EA by breaking load", "Dynamic stiffness";
}

impl ChannelQuantity {
    /// Coordinates of a position, x first.
    pub const POSITION: [Self; 3] = [Self::X, Self::Y, Self::Z];
    /// Components of a force, x first.
    pub const FORCE: [Self; 3] = [Self::ForceX, Self::ForceY, Self::ForceZ];
    /// Quantities of dynamic stiffness.
    pub const ROPE: [Self; 3] = [Self::MeanLoad, Self::LoadDeviation, Self::Stiffness];

    /// The quantity at a place.
    #[must_use]
    pub fn at(self, place: impl Into<String>) -> ChannelId {
        ChannelId {
            quantity: self,
            place: place.into(),
        }
    }
}

/// What identifies a channel. Its text is the name in files: `tension_n[wire|payload]`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ChannelId {
    /// What is recorded.
    pub quantity: ChannelQuantity,
    /// Where: name of an end or body, `section|section` at a joint, `section.a` at an end of a section.
    pub place: String,
}

impl fmt::Display for ChannelId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}[{}]", self.quantity.name(), self.place)
    }
}

/// A name that is that of no channel.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no quantity that this version knows")]
pub struct ChannelNameError(pub String);

impl FromStr for ChannelId {
    type Err = ChannelNameError;

    fn from_str(text: &str) -> Result<Self, ChannelNameError> {
        let split = text.split_once('[');
        let id = split.and_then(|(quantity, rest)| {
            let mut all = ChannelQuantity::ALL.iter();
            let quantity = all.find(|q| q.name() == quantity)?;
            Some(quantity.at(rest.strip_suffix(']')?))
        });
        id.ok_or_else(|| ChannelNameError(text.to_owned()))
    }
}

/// A channel of a case: what identifies it, and where on the line it is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChannelSpec {
    /// What identifies it.
    pub id: ChannelId,
    /// Where it is read.
    pub site: Site,
}

/// Where on the line a channel is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Site {
    /// A joint: 0 at end A, then after each section, the last at end B.
    Joint(usize),
    /// An end of the line.
    End(LineEnd),
    /// A body attached to the line, by its number in the case.
    Body(usize),
    /// The body that travels along the line.
    Traveller,
    /// The first or last segment of a section, by its number.
    Section(usize, LineEnd),
    /// The gauge of the waves.
    Gauge,
    /// The whole line.
    Line,
}

/// One of the two ends of the line or of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineEnd {
    /// Where arc length is zero.
    A,
    /// Where arc length is greatest.
    B,
}

/// The channels of a case in their order: tensions at the joints from A to B, position of every end that moves and speed
/// of every end that is free (of a rigid payload: of its centre of gravity, and its tilt), position of every attached
/// body, position, arc length and tension of the traveller, force on every held end, height of the waves, energy where
/// the case asks for it, dynamic stiffness at both ends of every section that has it. An end that is released at some
/// time counts as free.
#[must_use]
pub fn channels(case: &Case) -> Vec<ChannelSpec> {
    let (a, b) = (&case.ends.a, &case.ends.b);
    let sections = case.line.iter().map(|section| section.name.as_str());
    let ends = [a.name.as_str(), b.name.as_str()];
    let names: Vec<&str> = ends[..1].iter().copied().chain(sections).collect();
    let mut list = joint_channels(&[&names[..], &ends[1..]].concat());
    for (which, end) in [(LineEnd::A, a), (LineEnd::B, b)] {
        let released = end.release_s.is_some();
        list.extend(motion_channels(which, &end.name, end.kind, released));
    }
    let rotates = case.payload.as_ref().is_some_and(|p| p.rotation.is_some());
    list.extend(tilt_channel(&b.name, b.kind, rotates));
    for (index, clump) in case.clumps.iter().enumerate() {
        list.extend(body_channels(index, &clump.name));
    }
    let traveller = case.traveller.as_ref();
    list.extend(traveller.map_or_else(Vec::new, |t| traveller_channels(&t.name)));
    for (which, end) in [(LineEnd::A, a), (LineEnd::B, b)] {
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
pub(crate) fn elevation_channel() -> ChannelSpec {
    spec(ChannelQuantity::WaveElevation, "gauge", Site::Gauge)
}

/// Energy of the whole line.
pub(crate) fn energy_channel() -> ChannelSpec {
    spec(ChannelQuantity::Energy, "line", Site::Line)
}

/// Tensions at the joints between neighbours of this list of names, from end A to end B.
pub(crate) fn joint_channels(names: &[&str]) -> Vec<ChannelSpec> {
    let joints = names.windows(2).enumerate();
    let joint = |(joint, pair): (usize, &[&str])| {
        let place = format!("{}|{}", pair[0], pair[1]);
        spec(ChannelQuantity::Tension, &place, Site::Joint(joint))
    };
    joints.map(joint).collect()
}

/// Position of a body attached to the line.
pub(crate) fn body_channels(index: usize, name: &str) -> [ChannelSpec; 3] {
    ChannelQuantity::POSITION.map(|axis| spec(axis, name, Site::Body(index)))
}

/// Position of a body that travels along the line, its arc length, and the tension there.
pub(crate) fn traveller_channels(name: &str) -> Vec<ChannelSpec> {
    let further = [ChannelQuantity::Arc, ChannelQuantity::Tension];
    let all = ChannelQuantity::POSITION.into_iter().chain(further);
    all.map(|quantity| spec(quantity, name, Site::Traveller))
        .collect()
}

/// The line's force on an end of this name and kind, if it is held.
pub(crate) fn force_channels(
    which: LineEnd,
    name: &str,
    kind: EndKind,
) -> impl Iterator<Item = ChannelSpec> {
    let held = !matches!(kind, EndKind::Payload | EndKind::Free);
    let components = ChannelQuantity::FORCE.into_iter().filter(move |_| held);
    components.map(move |component| spec(component, name, Site::End(which)))
}

/// Dynamic stiffness at both ends of a section: `polyester.a` is its first segment, `polyester.b` its last.
pub(crate) fn rope_channels(section: usize, name: &str) -> impl Iterator<Item = ChannelSpec> {
    let ends = [("a", LineEnd::A), ("b", LineEnd::B)];
    ChannelQuantity::ROPE.into_iter().flat_map(move |quantity| {
        ends.map(|(letter, end)| {
            let place = format!("{name}.{letter}");
            spec(quantity, &place, Site::Section(section, end))
        })
    })
}

/// Tilt of a payload at end B, if it rotates.
pub(crate) fn tilt_channel(name: &str, kind: EndKind, rotates: bool) -> Option<ChannelSpec> {
    let tilts = rotates && kind == EndKind::Payload;
    tilts.then(|| spec(ChannelQuantity::Tilt, name, Site::End(LineEnd::B)))
}

/// Position and speed of an end of this name and kind, which is released at some time or not.
pub(crate) fn motion_channels(
    which: LineEnd,
    name: &str,
    kind: EndKind,
    released: bool,
) -> Vec<ChannelSpec> {
    let free = released || matches!(kind, EndKind::Payload | EndKind::Free);
    let moves = free || kind == EndKind::Moving;
    let position = ChannelQuantity::POSITION.into_iter().filter(|_| moves);
    let speed = free.then_some(ChannelQuantity::Speed);
    let all = position.chain(speed);
    all.map(|quantity| spec(quantity, name, Site::End(which)))
        .collect()
}

fn spec(quantity: ChannelQuantity, place: &str, site: Site) -> ChannelSpec {
    ChannelSpec {
        id: quantity.at(place),
        site,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back_as_its_channel() {
        for quantity in ChannelQuantity::ALL {
            let id = quantity.at("pay,load].x");
            assert_eq!(id.to_string().parse(), Ok(id));
        }
        assert_eq!(
            ChannelQuantity::Tension.at("wire|payload").to_string(),
            "tension_n[wire|payload]"
        );
        for wrong in ["tension_n", "heat_w[wire]", "x_m[", "x_m]", ""] {
            assert!(wrong.parse::<ChannelId>().is_err(), "{wrong}");
        }
    }
}
