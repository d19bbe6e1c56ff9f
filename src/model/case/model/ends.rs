//! What holds the ends, and the payload.

use crate::case::CarriedText;
use crate::case::fields::ValueType::{Name, NumberOrTriple};
use crate::case::fields::{Conditions, of, positive};
use crate::case::schema::{table, variants, words};

use super::one_or_many::OneOrMany;

table! {
    /// The two ends of the line.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Ends => EndsKeys {}
    tables {
        /// The end where the first section begins.
        a: End, alike;
        /// The end where the last section stops.
        b: End, alike;
    }
}

/// Ends that are held, and so may move, be clamped, or be let go.
const HELD: Conditions = &[("kind", &["fixed", "anchor", "moving"])];
const MOVING: Conditions = &[("kind", &["moving"])];
const HARMONIC: Conditions = &[("kind", &["moving"]), ("motion", &["harmonic"])];
const IRREGULAR: Conditions = &[("kind", &["moving"]), ("motion", &["irregular"])];
const FROM_FILE: Conditions = &[("kind", &["moving"]), ("motion", &["table", "vessel"])];
const TABLE: Conditions = &[("kind", &["moving"]), ("motion", &["table"])];
const VESSEL: Conditions = &[("kind", &["moving"]), ("motion", &["vessel"])];

table! {
    /// One end of the line.
    #[derive(Debug, Clone, PartialEq)]
    pub struct End => EndKeys {
        /// Name of the end, used in channel names.
        name: String, "name", kind Name;
        /// What holds the end.
        kind: EndKind, "kind";
        /// Position, z up from still water; held ends need it.
        position_m: Option<[f64; 3]>, "position", range of(-1e6, 1e6), absent "given by the start shape";
        /// Amplitude of the prescribed motion of a moving end.
        amplitude_m: [f64; 3] = [0.0, 0.0, 0.0], "motion amplitude", range of(-1e4, 1e4), matters HARMONIC;
        /// Period of the prescribed motion; a moving end needs it.
        period_s: Option<f64>, "motion period", range positive(1e5), absent "no motion", matters HARMONIC;
        /// Phase of the prescribed motion.
        phase_deg: [f64; 3] = [0.0, 0.0, 0.0], "motion phase", range of(-360.0, 360.0), matters HARMONIC;
        /// The prescribed motion grows smoothly from nothing over this time.
        ramp_s: f64 = 0.0, "motion ramp", range of(0.0, 1e6), matters MOVING;
        /// A held end is let go at this time.
        release_s: Option<f64>, "release", range of(0.0, 1e6), absent "never", matters HELD;
        /// How a moving end moves: in harmonics, along a table, irregularly, or as a vessel in the waves.
        motion: MotionName = MotionName::Harmonic, "motion", matters MOVING;
        /// CSV file beside the case: time_s,x_m,y_m,z_m from the position, or a vessel's responses over period_s.
        motion_file: Option<String>, "motion file", absent "not used", matters FROM_FILE;
        /// Between the rows of a table: a C2 spline, which may overshoot, monotone cubics (C1), or straight lines.
        motion_interpolation: MotionInterpolation = MotionInterpolation::Spline, "motion interpolation", matters TABLE;
        /// Root mean square of an irregular motion along x, y, z.
        rms_m: Option<[f64; 3]>, "motion rms", range of(0.0, 1e3), absent "not used", matters IRREGULAR;
        /// Period of the peak of an irregular motion's spectrum.
        peak_period_s: Option<f64>, "motion peak period", range positive(1e5), absent "not used", matters IRREGULAR;
        /// Gamma of an irregular motion's JONSWAP spectrum.
        gamma: f64 = 3.3, "motion peak enhancement", range of(1.0, 20.0), matters IRREGULAR;
        /// Harmonics an irregular motion is made of along each axis.
        components: usize = 100, "motion components", range of(1.0, 1e4), matters IRREGULAR;
        /// Of an irregular motion: the same seed, the same motion.
        seed: u64 = 1, "motion seed", range of(0.0, 9e15), matters IRREGULAR;
        /// Where the vessel points, from +x towards +y.
        heading_deg: f64 = 0.0, "vessel heading", range of(-360.0, 360.0), matters VESSEL;
        /// Where the line hangs from the vessel's reference point: forward, to port, up.
        hang_point_m: [f64; 3] = [0.0, 0.0, 0.0], "hang point", range of(-1e3, 1e3), matters VESSEL;
        /// Clamps the end: angle of the line there above the horizontal, going from A to B.
        clamp_elevation_deg: Option<f64>, "clamp elevation", range of(-90.0, 90.0), absent "hinged", matters HELD;
        /// Direction of a clamped end in plan, from +x towards +y, going from A to B.
        clamp_azimuth_deg: f64 = 0.0, "clamp azimuth", range of(-360.0, 360.0), matters HELD;
    }
}

words! {
    /// How a moving end moves about its place.
    #[derive(Default)]
    pub enum MotionName {
        /// In harmonics of one period.
        #[default]
        Harmonic = "harmonic",
        /// Along a table of places over time.
        Table = "table",
        /// Irregularly, to a root mean square along each axis.
        Irregular = "irregular",
        /// As a vessel does in the waves of the case.
        Vessel = "vessel",
    }
}

words! {
    /// How a table of places over time is interpolated.
    #[derive(Default)]
    pub enum MotionInterpolation {
        /// Natural cubic spline: continuous in velocity and acceleration.
        #[default]
        Spline = "spline",
        /// Monotone cubic Hermite (Fritsch and Butland 1984): continuous in velocity, between neighbouring rows.
        Monotone = "monotone",
        /// Straight lines.
        Linear = "linear",
    }
}

table! {
    /// A file that goes with the case.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Attachment => AttachmentKeys {
        /// The text of a file that the case names.
        text: CarriedText, "carried file";
    }
}

words! {
    /// What holds an end.
    pub enum EndKind {
        /// Held at its position (a vessel taken as fixed, a platform).
        Fixed = "fixed",
        /// Held at its position on the sea bed.
        Anchor = "anchor",
        /// Carries the payload; otherwise free.
        Payload = "payload",
        /// Follows a prescribed motion about its position.
        Moving = "moving",
        /// Free.
        Free = "free",
    }
}

impl EndKind {
    /// Whether something holds or moves the end.
    #[must_use]
    pub const fn is_held(self) -> bool {
        !matches!(self, Self::Payload | Self::Free)
    }
}

table! {
    /// A body at the end of the line; a point, unless it has a rotation.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Payload => PayloadKeys {
        /// Mass in air.
        dry_mass_kg: f64, "dry mass", range positive(1e10);
        /// Weight in water, as mass. Give this or volume_m3.
        wet_mass_kg: Option<f64>, "wet mass", range of(-1e10, 1e10), absent "from the volume";
        /// Displaced volume. Give this or wet_mass_kg.
        volume_m3: Option<f64>, "volume", range of(0.0, 1e7), absent "from the wet mass or the shape";
        /// Drag coefficient times area: one number, or along x, y, z.
        drag_area_m2: Option<OneOrMany>, "drag area", kind NumberOrTriple, range of(0.0, 1e6), absent "from the shape";
        /// Added mass: one number, or along x, y, z.
        added_mass_kg: Option<OneOrMany>, "added mass", kind NumberOrTriple, range of(0.0, 1e10), absent "from the shape";
        /// Area that bears on the sea bed.
        bed_area_m2: Option<f64>, "area on the bed", range of(0.0, 1e6), absent "by the shape, or the bottom of a cube of its volume";
        /// From the hang point down to what bears on the bed.
        bottom_m: Option<f64>, "bottom", range of(0.0, 1e3), absent "at its position";
        /// Greatest pull by which the bed holds the body back once it has borne on it.
        breakout_n: f64 = 0.0, "breakout force", range of(0.0, 1e10);
        /// Distance off the bed at which it is free of that pull.
        breakout_distance_m: f64 = 0.1, "breakout distance", range positive(100.0);
        /// The payload is cut off the line at this time.
        release_s: Option<f64>, "release", range of(0.0, 1e6), absent "never";
    }
    tables {
        /// The form of the payload, for what its other keys leave out.
        shape: Option<PayloadShape>;
        /// How the payload turns about the end of the line; absent means that it is a point.
        rotation: Option<Rotation>;
    }
}

table! {
    /// A payload that turns about the end of the line: symmetric about an axis through its hang point.
    /// Drag area and added mass along z are then those along the axis, along x and y those across.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Rotation => RotationKeys {
        /// From the hang point down the axis of the body, about which it is symmetric.
        centre_of_gravity_m: f64, "centre of gravity", range positive(1e3);
        /// About an axis across, through the centre of gravity.
        inertia_kg_m2: f64, "moment of inertia", range of(0.0, 1e14);
        /// From the hang point down the axis; the added mass sits there too.
        centre_of_buoyancy_m: Option<f64>, "centre of buoyancy", range of(0.0, 1e3), absent "at the centre of gravity";
        /// From the hang point down the axis.
        centre_of_drag_m: Option<f64>, "centre of drag", range of(0.0, 1e3), absent "at the centre of buoyancy";
        /// Stretch of the axis, about the centre of drag, that drag is spread over: it then resists turning too.
        drag_length_m: f64 = 0.0, "length of drag", range of(0.0, 1e3);
        /// Of the water, about an axis across, through the centre of buoyancy.
        added_inertia_kg_m2: f64 = 0.0, "added moment of inertia", range of(0.0, 1e14);
        /// Angle of the axis from straight down at time zero, unless the start is an equilibrium.
        start_tilt_deg: f64 = 0.0, "start tilt", range of(-180.0, 180.0);
        /// Which way it is tilted, from +x towards +y.
        start_azimuth_deg: f64 = 0.0, "start azimuth", range of(-360.0, 360.0);
        /// How fast it spins about its axis, for good: the line transmits no torque.
        spin_deg_per_s: f64 = 0.0, "spin", range of(-36e3, 36e3);
        /// Moment of inertia about its own axis; needed where it spins.
        spin_inertia_kg_m2: Option<f64>, "spin inertia", range of(0.0, 1e14), absent "needed where it spins";
    }
}

variants! {
    /// The form of a payload, or of what is at a point of a system.
    pub enum PayloadShape => ShapeKeys by kind, "shape", "Form of the body." {
        /// A box.
        Box(BoxShape) = "box",
        /// A sphere and an upright cylinder.
        SphereAndCylinder(SphereAndCylinder) = "sphere-and-cylinder",
    }
}

table! {
    /// A box: length along x, breadth along y, height along z.
    #[derive(Debug, Clone, PartialEq)]
    pub struct BoxShape => BoxShapeKeys {
        /// Length, along x.
        length_m: f64, "box length", range positive(1e3);
        /// Breadth, along y.
        breadth_m: f64, "box breadth", range positive(1e3);
        /// Height, along z.
        height_m: f64, "box height", range positive(1e3);
    }
}

table! {
    /// A sphere and an upright cylinder.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SphereAndCylinder => SphereAndCylinderKeys {
        /// Diameter of the sphere.
        sphere_diameter_m: f64, "sphere diameter", range positive(1e3);
        /// Diameter of the upright cylinder.
        cylinder_diameter_m: f64, "cylinder diameter", range positive(1e3);
        /// Length of the upright cylinder.
        cylinder_length_m: f64, "cylinder length", range positive(1e3);
    }
}
