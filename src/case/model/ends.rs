//! What holds the ends, and the payload.

use serde::{Deserialize, Serialize};

use super::OneOrMany;
use super::sea::{components, gamma, seed};

/// The two ends of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ends {
    /// Where arc length is zero.
    pub a: End,
    /// Where arc length is greatest.
    pub b: End,
}

/// One end of the line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct End {
    /// Name, used in channel names (`tension_n[vessel|chain]`).
    pub name: String,
    /// What holds it.
    pub kind: EndKind,
    /// Position \[m\] as \[x, y, z\], z up from still water. Needed for held ends; a free or payload
    /// end may leave it out, the start shape then gives it.
    pub position_m: Option<[f64; 3]>,
    /// Amplitude of prescribed motion along x, y, z \[m\].
    #[serde(default)]
    pub amplitude_m: [f64; 3],
    /// Period of prescribed motion \[s\].
    pub period_s: Option<f64>,
    /// Phase of prescribed motion along x, y, z \[deg\]: x = x0 + A sin(2πt/T + phase).
    #[serde(default)]
    pub phase_deg: [f64; 3],
    /// The motion grows smoothly from nothing over this time \[s\].
    #[serde(default)]
    pub ramp_s: f64,
    /// A held end is let go at this time \[s\]; absent: never.
    pub release_s: Option<f64>,
    /// How a moving end moves.
    #[serde(default)]
    pub motion: MotionName,
    /// The file that the motion is read from, beside the case: places over time, or a vessel's responses.
    pub motion_file: Option<String>,
    /// Root mean square of an irregular motion along x, y, z \[m\].
    pub rms_m: Option<[f64; 3]>,
    /// Period of the peak of its spectrum \[s\].
    pub peak_period_s: Option<f64>,
    /// Peak enhancement of its JONSWAP spectrum \[-\].
    #[serde(default = "gamma")]
    pub gamma: f64,
    /// Number of harmonics it is made of along each axis.
    #[serde(default = "components")]
    pub components: usize,
    /// Seed of its random frequencies and phases.
    #[serde(default = "seed")]
    pub seed: u64,
    /// Where the vessel points, from +x towards +y \[deg\].
    #[serde(default)]
    pub heading_deg: f64,
    /// Where the line hangs from the vessel, from the point that its responses are about: forward, to port, up \[m\].
    #[serde(default)]
    pub hang_point_m: [f64; 3],
    /// Clamps the end: angle of the line there above the horizontal, going from A to B \[deg\]; absent: hinged.
    pub clamp_elevation_deg: Option<f64>,
    /// Direction of a clamped end in plan, from +x towards +y, going from A to B \[deg\].
    #[serde(default)]
    pub clamp_azimuth_deg: f64,
}

impl End {
    /// An end of this name and kind at a position \[m\]; all else as in a file that leaves it out.
    #[must_use]
    pub fn new(name: &str, kind: EndKind, position_m: Option<[f64; 3]>) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            position_m,
            amplitude_m: [0.0; 3],
            period_s: None,
            phase_deg: [0.0; 3],
            ramp_s: 0.0,
            release_s: None,
            motion: MotionName::default(),
            motion_file: None,
            rms_m: None,
            peak_period_s: None,
            gamma: gamma(),
            components: components(),
            seed: seed(),
            heading_deg: 0.0,
            hang_point_m: [0.0; 3],
            clamp_elevation_deg: None,
            clamp_azimuth_deg: 0.0,
        }
    }
}

/// How a moving end moves about its place.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum MotionName {
    /// In harmonics of one period.
    #[default]
    Harmonic,
    /// Along a table of places over time.
    Table,
    /// Irregularly, to a root mean square along each axis.
    Irregular,
    /// As a vessel does in the waves of the case.
    Vessel,
}

/// A file that goes with the case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Carried {
    /// Its text.
    pub text: String,
}

/// What holds an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EndKind {
    /// Held at its position (a vessel taken as fixed, a platform).
    Fixed,
    /// Held at its position on the sea bed.
    Anchor,
    /// Carries the payload; otherwise free.
    Payload,
    /// Follows a prescribed motion about its position.
    Moving,
    /// Free.
    Free,
}

/// A body at the end of the line; a point, unless it has a rotation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Payload {
    /// Mass in air \[kg\].
    pub dry_mass_kg: f64,
    /// Weight in water as mass \[kg\]. Give this or `volume_m3`, or let the shape give the volume.
    pub wet_mass_kg: Option<f64>,
    /// Displaced volume \[m³\].
    pub volume_m3: Option<f64>,
    /// Drag coefficient times area \[m²\]: one number, or along x, y, z. Absent: from the shape.
    pub drag_area_m2: Option<OneOrMany>,
    /// Added mass \[kg\]: one number, or along x, y, z. Absent: from the shape.
    pub added_mass_kg: Option<OneOrMany>,
    /// It is cut off the line at this time \[s\]; absent: never.
    pub release_s: Option<f64>,
    /// Its form, for what the keys above leave out.
    pub shape: Option<Shape>,
    /// How it turns about its hang point; absent: it is a point, and does not.
    pub rotation: Option<Rotation>,
}

/// A payload that turns about the end of the line: symmetric about an axis through its hang point.
/// Drag area and added mass along z are then those along the axis, along x and y those across.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// From the hang point to the centre of gravity \[m\].
    pub centre_of_gravity_m: f64,
    /// Moment of inertia about an axis across, through the centre of gravity \[kg m²\].
    pub inertia_kg_m2: f64,
    /// From the hang point to the centre of buoyancy, where the added mass sits too \[m\]; absent: the centre of
    /// gravity.
    pub centre_of_buoyancy_m: Option<f64>,
    /// From the hang point to where drag acts \[m\]; absent: the centre of buoyancy.
    pub centre_of_drag_m: Option<f64>,
    /// Length of the axis, about the centre of drag, over which drag is spread evenly \[m\]; 0: it acts there.
    #[serde(default)]
    pub drag_length_m: f64,
    /// Added moment of inertia about an axis across, through the centre of buoyancy \[kg m²\].
    #[serde(default)]
    pub added_inertia_kg_m2: f64,
    /// Angle of the axis from straight down at time zero \[deg\].
    #[serde(default)]
    pub start_tilt_deg: f64,
    /// Which way it is tilted, from +x towards +y \[deg\].
    #[serde(default)]
    pub start_azimuth_deg: f64,
    /// How fast it spins about its axis \[deg/s\], positive by the right hand with the thumb away from the hang point: for
    /// good, as a line without torsion transmits no torque.
    #[serde(default)]
    pub spin_deg_per_s: f64,
    /// Moment of inertia about its axis \[kg m²\]; needed where it spins.
    pub spin_inertia_kg_m2: Option<f64>,
}

/// The form of a payload.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, tag = "kind")]
pub enum Shape {
    /// A box: length along x, breadth along y, height along z.
    Box {
        /// Length \[m\].
        length_m: f64,
        /// Breadth \[m\].
        breadth_m: f64,
        /// Height \[m\].
        height_m: f64,
    },
    /// A sphere and an upright cylinder.
    SphereAndCylinder {
        /// Diameter of the sphere \[m\].
        sphere_diameter_m: f64,
        /// Diameter of the cylinder \[m\].
        cylinder_diameter_m: f64,
        /// Length of the cylinder \[m\].
        cylinder_length_m: f64,
    },
}
