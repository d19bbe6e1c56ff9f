//! What holds the ends, and the payload.

use serde::{Deserialize, Serialize};

use super::OneOrMany;

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
    /// Clamps the end: angle of the line there above the horizontal, going from A to B \[deg\]; absent: hinged.
    pub clamp_elevation_deg: Option<f64>,
    /// Direction of a clamped end in plan, from +x towards +y, going from A to B \[deg\].
    #[serde(default)]
    pub clamp_azimuth_deg: f64,
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

/// A body at the end of the line, without rotation.
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
    /// Its form, for what the keys above leave out.
    pub shape: Option<Shape>,
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
