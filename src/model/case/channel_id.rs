//! What identifies a channel: a quantity at a place. Its text (`tension_n[wire|payload]`) is its name in files.
//!
//! One table declares every [`ChannelQuantity`] with name, unit and the words of its chart.

use std::fmt;
use std::str::FromStr;

use toml_edit::Value as Toml;

use super::fields::ValueType;
use super::schema::KeyValue;
use super::tree::TomlNode;

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
    /// Effective tension of the line \[N\].
    Tension: "tension_n", "N", "tension", "Tension at the joints";
    /// Tension of the wall of a pipe \[N\]: see [`PipeWall`](crate::physics::PipeWall).
    WallTension: "wall_tension_n", "N", "tension", "Tension of the pipe wall";
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
    /// Turn of a body about its own x, last \[deg\].
    Roll: "roll_deg", "deg", "roll", "Roll";
    /// Turn of a body about its y before that \[deg\].
    Pitch: "pitch_deg", "deg", "pitch", "Pitch";
    /// Turn of a body about the vertical, first \[deg\].
    Yaw: "yaw_deg", "deg", "yaw", "Yaw";
    /// Unstretched length from end A to a body that travels along the line \[m\].
    Arc: "arc_m", "m", "arc length", "Place along the line";
    /// First component of the line's force on a held end \[N\].
    ForceX: "force_x_n", "N", "force", "Force on the ends, x";
    /// Second component of the line's force on a held end \[N\].
    ForceY: "force_y_n", "N", "force", "Force on the ends, y";
    /// Vertical component of the line's force on a held end \[N\].
    ForceZ: "force_z_n", "N", "force", "Force on the ends, z";
    /// Upward pull of the lines on a fixed point \[N\].
    Uplift: "uplift_n", "N", "force", "Upward pull on the anchors";
    /// First component of the force of a pin on its body \[N\].
    PinForceX: "pin_force_x_n", "N", "force", "Force of the pins, x";
    /// Second component of the force of a pin on its body \[N\].
    PinForceY: "pin_force_y_n", "N", "force", "Force of the pins, y";
    /// Vertical component of the force of a pin on its body \[N\].
    PinForceZ: "pin_force_z_n", "N", "force", "Force of the pins, z";
    /// Curvature of a line at a clamped end \[1/m\].
    Curvature: "curvature_per_m", "1/m", "curvature", "Curvature at the clamps";
    /// Bending moment of a line there \[N m\].
    Moment: "moment_nm", "N m", "moment", "Bending moment at the clamps";
    /// Normal force of the sea bed on a body or a loose end \[N\]; negative where suction holds it.
    BedForce: "bed_force_n", "N", "force", "Force of the bed";
    /// Speed normal to the bed at which a body landed, the greatest so far \[m/s\]; 0 before.
    LandingSpeed: "landing_speed_m_per_s", "m/s", "speed", "Landing speed";
    /// Unstretched length of a line that lies on the bed: whose weight the bed bears \[m\].
    OnBed: "on_bed_m", "m", "length", "Length on the bed";
    /// Unstretched length of a line that slides over the bed \[m\].
    Sliding: "sliding_m", "m", "length", "Length that slides over the bed";
    /// Height of the waves above still water over the gauge \[m\].
    WaveElevation: "wave_elevation_m", "m", "elevation", "Height of the waves";
    /// Unstretched length of a line that is paid out, or that a point slides along \[m\].
    Length: "length_m", "m", "length", "Unstretched length";
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
    /// Angles of a body, roll first.
    pub const ANGLES: [Self; 3] = [Self::Roll, Self::Pitch, Self::Yaw];
    /// Components of a force, x first.
    pub const FORCE: [Self; 3] = [Self::ForceX, Self::ForceY, Self::ForceZ];
    /// Components of the force of a pin, x first.
    pub const PIN_FORCE: [Self; 3] = [Self::PinForceX, Self::PinForceY, Self::PinForceZ];
    /// Quantities of a line that bends.
    pub const BENDING: [Self; 2] = [Self::Curvature, Self::Moment];
    /// Quantities of dynamic stiffness.
    pub const ROPE: [Self; 3] = [Self::MeanLoad, Self::LoadDeviation, Self::Stiffness];
    /// Quantities whose extremes checks compare: tension, uplift, force on an end, height.
    pub const CHECKED: [Self; 4] = [Self::Tension, Self::Uplift, Self::ForceZ, Self::Z];

    /// Whether a value of zero is a floor, where it stays however slack the line is: a tension, and the pull of a line on its end at the
    /// `last` moment. The extremes of a pull may be zero where it changes its direction, or hangs straight down at the start.
    #[must_use]
    pub const fn rests_at_zero(self, last: bool) -> bool {
        match self {
            Self::Tension => true,
            Self::ForceX | Self::ForceY | Self::ForceZ | Self::Uplift => last,
            _ => false,
        }
    }

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

impl KeyValue for ChannelId {
    const KIND: ValueType = ValueType::Text;

    fn blank() -> Self {
        ChannelQuantity::Tension.at("")
    }

    fn read(node: &TomlNode) -> Option<Self> {
        node.text()?.parse().ok()
    }

    fn write(&self) -> Toml {
        self.to_string().into()
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
