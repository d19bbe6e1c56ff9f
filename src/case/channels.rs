//! The channels that a run of a case records: which quantity, at which place.
//!
//! A channel is identified by a [`ChannelId`], whose text (`tension_n[wire|payload]`) is its name in files. One table
//! declares every [`ChannelQuantity`] with name, unit and the words of its chart; [`channels`] lists the channels of a
//! case and their order.

use std::fmt;
use std::str::FromStr;

use super::{Case, DynamicStiffness, End, EndKind, Material, Section};

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

/// The channels of a case, in their order.
#[must_use]
pub fn channels(case: &Case) -> Vec<ChannelSpec> {
    RecordedLine::of(case).channels()
}

/// What of a case decides which channels its run records.
pub(crate) struct RecordedLine<'a> {
    /// Ends A and B.
    pub(crate) ends: [RecordedEnd<'a>; 2],
    /// Sections from A to B, and whether they have dynamic stiffness.
    pub(crate) sections: Vec<(&'a str, bool)>,
    /// Whether the payload at end B is a rigid body that rotates.
    pub(crate) rotates: bool,
    /// Bodies attached to the line.
    pub(crate) bodies: Vec<&'a str>,
    /// The body that travels along the line.
    pub(crate) traveller: Option<&'a str>,
    /// Whether there are waves.
    pub(crate) waves: bool,
    /// Whether the case asks for the energy.
    pub(crate) energy: bool,
}

/// An end of the line.
#[derive(Clone, Copy)]
pub(crate) struct RecordedEnd<'a> {
    /// Its name.
    pub(crate) name: &'a str,
    /// Its kind.
    pub(crate) kind: EndKind,
    /// Whether it is released at some time; it then counts as free.
    pub(crate) released: bool,
}

impl<'a> RecordedLine<'a> {
    fn of(case: &'a Case) -> Self {
        let end = |end: &'a End| RecordedEnd {
            name: &end.name,
            kind: end.kind,
            released: end.release_s.is_some(),
        };
        let section = |section: &'a Section| {
            let material = case.materials.get(&section.material);
            let is_dynamic = |m: &Material| m.dynamic_stiffness != DynamicStiffness::None;
            (section.name.as_str(), material.is_some_and(is_dynamic))
        };
        Self {
            ends: [end(&case.ends.a), end(&case.ends.b)],
            sections: case.line.iter().map(section).collect(),
            rotates: case.payload.as_ref().is_some_and(|p| p.rotation.is_some()),
            bodies: case
                .clumps
                .iter()
                .map(|clump| clump.name.as_str())
                .collect(),
            traveller: case.traveller.as_ref().map(|t| t.name.as_str()),
            waves: case.waves.is_some(),
            energy: case.output.energy,
        }
    }

    /// The channels in their order: tensions at the joints from A to B, position of every end that moves and speed of
    /// every end that is free (of a rigid payload: of its centre of gravity, and its tilt), position of every attached
    /// body, position, arc length and tension of the traveller, force on every held end, height of the waves, energy,
    /// dynamic stiffness at both ends of every section that has it.
    pub(crate) fn channels(&self) -> Vec<ChannelSpec> {
        use ChannelQuantity as Q;
        let [a, b] = &self.ends;
        let mut list = self.joint_tensions();
        let mut add = |quantities: &[Q], place: &str, site: Site| {
            let all = quantities.iter();
            list.extend(all.map(|quantity| ChannelSpec {
                id: quantity.at(place),
                site,
            }));
        };
        let ends = [(a, Site::End(LineEnd::A)), (b, Site::End(LineEnd::B))];
        for (end, site) in ends {
            let free = end.released || matches!(end.kind, EndKind::Payload | EndKind::Free);
            if free || end.kind == EndKind::Moving {
                add(&Q::POSITION, end.name, site);
            }
            if free {
                add(&[Q::Speed], end.name, site);
            }
        }
        if self.rotates && b.kind == EndKind::Payload {
            add(&[Q::Tilt], b.name, ends[1].1);
        }
        for (index, name) in self.bodies.iter().enumerate() {
            add(&Q::POSITION, name, Site::Body(index));
        }
        if let Some(name) = self.traveller {
            add(&Q::POSITION, name, Site::Traveller);
            add(&[Q::Arc, Q::Tension], name, Site::Traveller);
        }
        for (end, site) in ends {
            if !matches!(end.kind, EndKind::Payload | EndKind::Free) {
                add(&Q::FORCE, end.name, site);
            }
        }
        if self.waves {
            add(&[Q::WaveElevation], "gauge", Site::Gauge);
        }
        if self.energy {
            add(&[Q::Energy], "line", Site::Line);
        }
        for (index, (name, _)) in self.sections.iter().enumerate().filter(|(_, s)| s.1) {
            for quantity in Q::ROPE {
                for (letter, end) in [("a", LineEnd::A), ("b", LineEnd::B)] {
                    let site = Site::Section(index, end);
                    add(&[quantity], &format!("{name}.{letter}"), site);
                }
            }
        }
        list
    }

    /// Tensions at the joints between ends and sections, from A to B.
    fn joint_tensions(&self) -> Vec<ChannelSpec> {
        let [a, b] = self.ends.map(|end| end.name);
        let sections: Vec<&str> = self.sections.iter().map(|section| section.0).collect();
        let names = [&[a], &sections[..], &[b]].concat();
        let joints = names.windows(2).enumerate();
        let tension = |(joint, pair): (usize, &[&str])| ChannelSpec {
            id: ChannelQuantity::Tension.at(format!("{}|{}", pair[0], pair[1])),
            site: Site::Joint(joint),
        };
        joints.map(tension).collect()
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
