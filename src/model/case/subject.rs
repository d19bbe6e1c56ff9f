//! What a single number of a run is taken of: a channel, a quantity of the whole line, a natural mode.

use std::fmt;
use std::str::FromStr;

use toml_edit::Value as Toml;

use super::channel_id::{ChannelId, ChannelNameError, ChannelQuantity};
use super::fields::ValueType;
use super::line_quantity::{EnergyQuantity, LineQuantity, STEADY};
use super::schema::KeyValue;
use super::tree::TomlNode;

/// What a single number is taken of. Its text is the `channel` of published values and trends.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Subject {
    /// A channel, over time.
    Channel(ChannelId),
    /// A quantity of the whole line, over arc length.
    Line(LineQuantity),
    /// The same of a line of a system, by the name of the line: `tension_n[along north]`.
    Along(LineQuantity, String),
    /// Frequency of a natural mode by its number from 1: `in_plane_hz[2]`.
    ModeFrequency(ModePlane, usize),
    /// Number of the natural mode nearest to a given frequency: `out_of_plane_mode_near`.
    NearestMode(ModePlane),
    /// Time from which on the response is steady.
    SteadyTime,
    /// A term of the energy balance.
    Energy(EnergyQuantity),
}

/// The plane in which a natural mode moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ModePlane {
    /// That of the line.
    InPlane,
    /// Across it.
    OutOfPlane,
}

impl ModePlane {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::InPlane, Self::OutOfPlane];

    const fn name(self) -> &'static str {
        match self {
            Self::InPlane => "in_plane",
            Self::OutOfPlane => "out_of_plane",
        }
    }
}

const FREQUENCY: &str = "_hz[";
const NEAREST: &str = "_mode_near";

/// What is between a quantity along a line and the name of the line.
const ALONG: &str = "[along ";

impl Subject {
    /// The numbers that a run has of natural modes: the lowest frequencies in and out of the plane of the line, and
    /// where a frequency is given the numbers of the modes nearest to it.
    #[must_use]
    pub fn of_modes(count: usize, near: bool) -> Vec<Self> {
        let of_plane = |plane| {
            let frequencies = (1..=count).map(move |n| Self::ModeFrequency(plane, n));
            frequencies.chain(near.then_some(Self::NearestMode(plane)))
        };
        ModePlane::ALL.into_iter().flat_map(of_plane).collect()
    }

    /// A quantity along a line: of a line by itself where it has no name.
    #[must_use]
    pub fn along(quantity: LineQuantity, line: &str) -> Self {
        match line {
            "" => Self::Line(quantity),
            name => Self::Along(quantity, name.to_owned()),
        }
    }

    /// Whether it is how much of a line lies on the bed.
    #[must_use]
    pub fn is_length_on_bed(&self) -> bool {
        matches!(self, Self::Channel(id) if id.quantity == ChannelQuantity::OnBed)
    }

    /// Whether it counts the nodes that slide: it jumps by segments, and shows no order.
    #[must_use]
    pub fn counts_nodes(&self) -> bool {
        matches!(self, Self::Channel(id) if id.quantity == ChannelQuantity::Sliding)
    }

    /// The quantity along a line that it is, and the name of the line, which is empty of a line by itself.
    #[must_use]
    pub fn line_quantity(&self) -> Option<(LineQuantity, &str)> {
        match self {
            Self::Line(quantity) => Some((*quantity, "")),
            Self::Along(quantity, line) => Some((*quantity, line)),
            _ => None,
        }
    }

    /// Its unit as shown.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        match self {
            Self::Channel(channel) => channel.quantity.unit(),
            Self::Line(quantity) | Self::Along(quantity, _) => quantity.unit(),
            Self::ModeFrequency(..) => "Hz",
            Self::NearestMode(_) => "-",
            Self::SteadyTime => "s",
            Self::Energy(quantity) => quantity.unit(),
        }
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Channel(channel) => channel.fmt(f),
            Self::Line(quantity) => f.write_str(quantity.name()),
            Self::Along(quantity, line) => write!(f, "{}{ALONG}{line}]", quantity.name()),
            Self::ModeFrequency(plane, number) => {
                write!(f, "{}{FREQUENCY}{number}]", plane.name())
            }
            Self::NearestMode(plane) => write!(f, "{}{NEAREST}", plane.name()),
            Self::SteadyTime => f.write_str(STEADY),
            Self::Energy(quantity) => f.write_str(quantity.name()),
        }
    }
}

impl FromStr for Subject {
    type Err = ChannelNameError;

    fn from_str(text: &str) -> Result<Self, ChannelNameError> {
        if text == STEADY {
            return Ok(Self::SteadyTime);
        }
        if let Some(quantity) = LineQuantity::named(text) {
            return Ok(Self::Line(quantity));
        }
        if let Some((name, line)) = text.split_once(ALONG)
            && let (Some(quantity), Some(line)) =
                (LineQuantity::named(name), line.strip_suffix(']'))
        {
            return Ok(Self::Along(quantity, line.to_owned()));
        }
        if let Some(quantity) = EnergyQuantity::named(text) {
            return Ok(Self::Energy(quantity));
        }
        let of_mode = ModePlane::ALL.into_iter().find_map(|plane| {
            let rest = text.strip_prefix(plane.name())?;
            let number = rest
                .strip_prefix(FREQUENCY)
                .and_then(|n| n.strip_suffix(']'));
            match number.and_then(|n| n.parse().ok()) {
                Some(number) => Some(Self::ModeFrequency(plane, number)),
                None => (rest == NEAREST).then_some(Self::NearestMode(plane)),
            }
        });
        of_mode.map_or_else(|| text.parse().map(Self::Channel), Ok)
    }
}

impl KeyValue for Subject {
    const KIND: ValueType = ValueType::Text;

    fn blank() -> Self {
        Self::Channel(ChannelId::blank())
    }

    fn read(node: &TomlNode) -> Option<Self> {
        node.text()?.parse().ok()
    }

    fn write(&self) -> Toml {
        self.to_string().into()
    }
}
