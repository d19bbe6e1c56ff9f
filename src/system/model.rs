//! A system of lines as the user words it: one struct a table of the file, one field a key.

use std::collections::BTreeMap;

use crate::case::fields::ValueType::Name;
use crate::case::fields::{Conditions, of, positive};
use crate::case::schema::{table, words};
use crate::case::{Current, Environment, Mark, Material};
use crate::reference::PublishedNumber;

const ON_BODY: Conditions = &[("kind", &["body"])];
const FREE: Conditions = &[("kind", &["free"])];

table! {
    /// Everything a system file says.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SystemFile => SystemKeys {}
    tables {
        /// What the system is, for people.
        about: SystemInfo as "system";
        /// Water and gravity.
        environment: Environment, optional;
        /// A current on the lines; points and bodies feel it by their steady loads only.
        current: Option<Current>;
        /// The level sea bed; absent means that none is in reach.
        seabed: Option<SystemBed>;
        /// What the lines are made of, by name.
        materials: BTreeMap<String, Material>, required;
        /// The bodies that points are on, by name.
        bodies: BTreeMap<String, BodyInputs>;
        /// The ends of the lines, by name.
        points: BTreeMap<String, PointInputs>, required;
        /// The lines, from one point to another.
        lines: Vec<LineInputs>, required;
        /// Where an input comes from when the source does not print it, by key path.
        marks: BTreeMap<String, Mark>;
        /// A published value the system is held against.
        published: Vec<PublishedNumber>;
    }
}

table! {
    /// What a system is, for people.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SystemInfo => SystemInfoKeys {
        /// One line that says what the system is.
        title: String, "title";
        /// Where the data come from.
        source: String = "", "source";
        /// The scene, what the source leaves out, what was decided.
        notes: String = "", "notes";
    }
}

table! {
    /// A level, rigid sea bed.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SystemBed => SystemBedKeys {
        /// Depth of the bed below still water.
        depth_m: f64, "depth", range of(0.0, 2e4);
        /// Axial friction under a line that lies from its end on the bed: tension lost by the weight that the bed bears.
        friction: f64 = 0.0, "friction", range of(0.0, 10.0);
    }
}

words! {
    /// What holds a point.
    pub enum PointKind {
        /// Held at its position: an anchor.
        Fixed = "fixed",
        /// Free: where lines meet, a clump weight, a buoy.
        Free = "free",
        /// On a body, at a place in its frame: a fairlead.
        Body = "body",
    }
}

table! {
    /// A point that lines end at.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PointInputs => PointKeys {
        /// What holds it.
        kind: PointKind, "kind";
        /// Fixed: the place, z up from still water. On a body: the place in its frame. Free: where the search begins.
        position_m: Option<[f64; 3]>, "position", range of(-1e6, 1e6), absent "among its neighbours";
        /// The body that the point is on.
        body: Option<String>, "body", kind Name, absent "needed for kind body", matters ON_BODY;
        /// Mass in air.
        mass_kg: f64 = 0.0, "mass", range of(0.0, 1e10), matters FREE;
        /// Displaced volume.
        volume_m3: f64 = 0.0, "volume", range of(0.0, 1e7), matters FREE;
        /// Steady load on it, along x, y, z.
        load_n: [f64; 3] = [0.0, 0.0, 0.0], "steady load", range of(-1e12, 1e12), matters FREE;
    }
}

words! {
    /// What holds a body.
    pub enum BodyKind {
        /// Held at its pose.
        Held = "held",
        /// Free in all six directions.
        Free = "free",
    }
}

const FLOATING: Conditions = &[("kind", &["free"])];

table! {
    /// A rigid body. Its frame is the earth's where its angles are zero: x forward, y to port, z up.
    #[derive(Debug, Clone, PartialEq)]
    pub struct BodyInputs => BodyKeys {
        /// What holds it.
        kind: BodyKind, "kind";
        /// Place of its origin; of a free body the place that its hydrostatics refer to, where the search begins.
        position_m: [f64; 3] = [0.0, 0.0, 0.0], "position", range of(-1e6, 1e6);
        /// Turn about x, after the two others.
        roll_deg: f64 = 0.0, "roll", range of(-180.0, 180.0);
        /// Turn about y, after that about z.
        pitch_deg: f64 = 0.0, "pitch", range of(-90.0, 90.0);
        /// Turn about z, first.
        yaw_deg: f64 = 0.0, "yaw", range of(-360.0, 360.0);
        /// Mass in air, ballast included; a free body needs it.
        mass_kg: Option<f64>, "mass", range positive(1e12), absent "not used while it is held";
        /// Centre of gravity in its frame.
        centre_of_gravity_m: [f64; 3] = [0.0, 0.0, 0.0], "centre of gravity", range of(-1e3, 1e3);
        /// About axes through the centre of gravity: Ixx, Iyy, Izz, or these and Ixy, Ixz, Iyz.
        inertia_kg_m2: Vec<f64>, "moments of inertia", range of(-1e18, 1e18), absent "none";
        /// Displaced volume at the pose given.
        volume_m3: f64 = 0.0, "volume", range of(0.0, 1e9);
        /// Centre of buoyancy in its frame, at the pose given.
        centre_of_buoyancy_m: [f64; 3] = [0.0, 0.0, 0.0], "centre of buoyancy", range of(-1e3, 1e3);
        /// By its water-plane alone, about its origin: 36 numbers row by row, or the diagonal. Moments of weight and buoyancy are added.
        waterplane_stiffness: Vec<f64>, "water-plane stiffness", unit "N/m, N, N m", range of(-1e15, 1e15), absent "none";
        /// Added mass about its origin: 36 numbers row by row, or the diagonal; for natural periods.
        added_mass: Vec<f64>, "added mass", unit "kg, kg m, kg m2", range of(-1e18, 1e18), absent "none";
        /// Steady load at its origin along x, y, z, in the earth's directions.
        load_n: [f64; 3] = [0.0, 0.0, 0.0], "steady load", range of(-1e12, 1e12), matters FLOATING;
        /// Steady moment about its origin, in the earth's directions.
        moment_n_m: [f64; 3] = [0.0, 0.0, 0.0], "steady moment", range of(-1e15, 1e15), matters FLOATING;
        /// From its origin down to what bears on the bed.
        bottom_m: Option<f64>, "bottom", range of(-1e3, 1e3), absent "it does not touch the bed", matters FLOATING;
    }
}

table! {
    /// A line from one point to another, of one material or of sections.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LineInputs => LineKeys {
        /// Name of the line.
        name: String, "name", kind Name;
        /// The point at its end A.
        from: String, "from", kind Name;
        /// The point at its end B.
        to: String, "to", kind Name;
        /// Material of a line of one section.
        material: Option<String>, "material", kind Name, absent "by its sections";
        /// Unstretched length of a line of one section.
        length_m: Option<f64>, "length", range positive(1e5), absent "by its sections";
        /// Copies turned about a vertical axis by these angles: of the line and of its points off that axis.
        repeat_at_deg: Vec<f64>, "repeats", range of(-360.0, 360.0), absent "once";
        /// The axis of the copies: x and y. Points on a body turn about the z axis of their body.
        repeat_about_m: [f64; 2] = [0.0, 0.0], "axis of repeats", range of(-1e6, 1e6);
        /// Segments of the line where it has no closed form: in a current, or with bending stiffness.
        segments: Option<usize>, "segments", range of(2.0, 1e4), absent "100";
        /// Friction under this line in the place of the bed's.
        friction: Option<f64>, "friction", range of(0.0, 10.0), absent "that of the bed";
    }
    tables {
        /// The sections of the line, from its end A to its end B.
        sections: Vec<LineSection>;
    }
}

table! {
    /// A section of a line.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LineSection => LineSectionKeys {
        /// What it is made of.
        material: String, "material", kind Name;
        /// Unstretched length.
        length_m: f64, "length", range positive(1e5);
        /// Weight in water of a body at its end towards B, as mass; negative floats. Not on the last section.
        clump_kg: f64 = 0.0, "clump", range of(-1e10, 1e10);
    }
}
