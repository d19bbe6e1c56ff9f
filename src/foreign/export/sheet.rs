//! The rows of a file, before a program's form is given to them.

/// All rows. Numbers of points, bodies, rods and lines count from 1 in the order of the rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sheet {
    /// Title of the system.
    pub title: String,
    /// Line types.
    pub types: Vec<TypeRow>,
    /// Rod types.
    pub rod_types: Vec<RodTypeRow>,
    /// Bodies.
    pub bodies: Vec<BodyRow>,
    /// Rods.
    pub rods: Vec<RodRow>,
    /// Points.
    pub points: Vec<SheetPoint>,
    /// Lines.
    pub lines: Vec<SheetLine>,
    /// Ends that come off: what they are attached to, the line, time \[s\] and tension \[N\], 0 where there is none.
    pub failures: Vec<(String, usize, [f64; 2])>,
    /// Past of Syrope ropes: line, greatest and present mean tension \[N\].
    pub pasts: Vec<(usize, [f64; 2])>,
    /// Options: value and name.
    pub options: Vec<(String, &'static str)>,
    /// Files that are named.
    pub files: Vec<(String, String)>,
    /// What the file does not say, or says in another way.
    pub remarks: Vec<String>,
}

/// A line type.
#[derive(Debug, Clone, PartialEq)]
pub struct TypeRow {
    /// Its name.
    pub name: String,
    /// Diameter \[m\].
    pub diameter: f64,
    /// Mass in air \[kg/m\].
    pub mass: f64,
    /// EA, or what stands for it.
    pub ea: String,
    /// Internal damping: BA \[N s\], or the negative share of the critical one.
    pub damping: String,
    /// Bending stiffness \[N m²\].
    pub bending: f64,
    /// Drag across on the diameter, along on the perimeter.
    pub drag: [f64; 2],
    /// Added mass across and along.
    pub added_mass: [f64; 2],
    /// Friction on the bed, in files that give it by type.
    pub friction: f64,
}

/// A rod type.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RodTypeRow {
    /// Its name.
    pub name: String,
    /// Diameter \[m\].
    pub diameter: f64,
    /// Mass in air \[kg/m\].
    pub mass: f64,
    /// Drag across, on the diameter.
    pub drag: f64,
    /// Added mass across.
    pub added_mass: f64,
    /// Drag of the ends, along the rod.
    pub drag_end: f64,
    /// Added mass of the ends, along the rod.
    pub added_mass_end: f64,
}

/// A body.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyRow {
    /// What holds it.
    pub hold: &'static str,
    /// Place of its origin \[m\].
    pub place: [f64; 3],
    /// Roll, pitch, yaw \[deg\].
    pub angles: [f64; 3],
    /// Mass \[kg\].
    pub mass: f64,
    /// Centre of gravity \[m\].
    pub centre: [f64; 3],
    /// Moments of inertia about it \[kg m²\].
    pub inertia: [f64; 3],
    /// Displaced volume \[m³\].
    pub volume: f64,
    /// Drag coefficient times area, along and about its axes.
    pub drag_area: [f64; 6],
    /// Added mass coefficients along its axes.
    pub added_mass: [f64; 3],
}

/// A rod.
#[derive(Debug, Clone, PartialEq)]
pub struct RodRow {
    /// Its type.
    pub of_type: String,
    /// What holds it.
    pub hold: String,
    /// Its ends \[m\].
    pub ends: [[f64; 3]; 2],
    /// Segments; 0 is a joint.
    pub segments: usize,
}

/// A point.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetPoint {
    /// What holds it.
    pub hold: String,
    /// Its place \[m\].
    pub place: [f64; 3],
    /// Mass \[kg\].
    pub mass: f64,
    /// Volume \[m³\].
    pub volume: f64,
    /// Drag coefficient times area \[m²\].
    pub drag_area: f64,
    /// Added mass coefficient.
    pub added_mass: f64,
    /// Steady load \[N\].
    pub load: [f64; 3],
}

/// A line.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetLine {
    /// Its type.
    pub of_type: String,
    /// What its ends are attached to: the number of a point, or a rod such as `R2A`.
    pub ends: [String; 2],
    /// Unstretched length \[m\].
    pub length: f64,
    /// Segments.
    pub segments: usize,
    /// Whether the bed does not bear it.
    pub without_bed: bool,
}
