//! Lines as lumped masses, as `MoorDyn` 2.7 divides them: what a file is in the program that it is for.
//!
//! Half of the mass, weight, drag and added mass of a segment is at either of its nodes (Hall and Goupee, Ocean Engineering 104 (2015)
//! 590-603, sections 2.1 to 2.4), bending acts by the angle between neighbouring segments. Free points, and rods without length, take part as
//! nodes; bodies and rods with length are held where the file has them. Water is still.

pub mod build;
pub mod equilibrium;
pub mod forces;
pub mod relaxation;
pub mod spectrum;

use crate::numerics::V3;

/// A system of lumped masses.
#[derive(Debug, Clone, Default)]
pub struct LumpedModel {
    /// Where the nodes are by the file \[m\]: points, joints, ends of rods, then the inner nodes of the lines in between them.
    pub start: Vec<V3>,
    /// Whether each is free.
    pub free: Vec<bool>,
    /// The lines.
    pub lines: Vec<ModelLine>,
    /// Masses of free points.
    pub points: Vec<LumpedPoint>,
    /// Nodes that bend as the inside of a line: before, itself, behind, with EI \[N m²\].
    pub bends: Vec<Bend>,
    /// Gravity \[m/s²\].
    pub gravity: f64,
    /// Density of the water \[kg/m³\].
    pub density: f64,
    /// Height of the bed \[m\]; nothing where none is known.
    pub bed_z: Option<f64>,
    /// Push of the bed by area and depth \[Pa/m\].
    pub bed_stiffness: f64,
    /// Push of the bed by area and speed \[Pa s/m\].
    pub bed_damping: f64,
    /// Whether some part that is free in the file is held here.
    pub holds_bodies: bool,
    /// Whether a rope of it creeps, which it does not in the model.
    pub creeps: bool,
}

/// A line of lumped masses.
#[derive(Debug, Clone)]
pub struct ModelLine {
    /// Its nodes from A to B.
    pub nodes: Vec<usize>,
    /// Unstretched length of a segment \[m\].
    pub segment: f64,
    /// Tension by strain.
    pub elasticity: SegmentElasticity,
    /// Internal damping BA \[N s\].
    pub damping: f64,
    /// Mass per length \[kg/m\].
    pub mass: f64,
    /// Diameter \[m\].
    pub diameter: f64,
    /// Drag across on the diameter, along on the perimeter.
    pub drag: [f64; 2],
    /// Added mass across and along, on the displaced volume.
    pub added_mass: [f64; 2],
}

/// Tension by strain.
#[derive(Debug, Clone, PartialEq)]
pub enum SegmentElasticity {
    /// EA \[N\].
    Constant(f64),
    /// Strains and tensions \[N\], rising.
    Table(Vec<[f64; 2]>),
}

impl SegmentElasticity {
    /// Tension \[N\] at a strain, and its slope \[N\]. Segments bear no compression.
    #[must_use]
    pub fn at(&self, strain: f64) -> (f64, f64) {
        if strain <= 0.0 {
            return (0.0, 0.0);
        }
        match self {
            Self::Constant(ea) => (ea * strain, *ea),
            Self::Table(rows) => {
                let behind = rows.partition_point(|row| row[0] < strain);
                let last = rows.len() - 1;
                let [a, b] = match behind {
                    0 => [[0.0, 0.0], rows[0]],
                    behind => [rows[behind.min(last) - 1], rows[behind.min(last)]],
                };
                let slope = (b[1] - a[1]) / (b[0] - a[0]);
                (a[1] + slope * (strain - a[0]), slope)
            }
        }
    }

    /// Energy by length \[N\] at a strain.
    #[must_use]
    pub fn energy(&self, strain: f64) -> f64 {
        if strain <= 0.0 {
            return 0.0;
        }
        match self {
            Self::Constant(ea) => 0.5 * ea * strain * strain,
            Self::Table(rows) => {
                let inner = rows.iter().map(|row| row[0]).filter(|of| *of < strain);
                let (mut energy, mut from) = (0.0, 0.0);
                for to in inner.chain([strain]) {
                    energy += 0.5 * (self.at(from).0 + self.at(to).0) * (to - from);
                    from = to;
                }
                energy
            }
        }
    }

    /// Stiffness at small strain \[N\].
    #[must_use]
    pub fn initial(&self) -> f64 {
        self.at(f64::MIN_POSITIVE).1
    }
}

/// A free point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LumpedPoint {
    /// Its node.
    pub node: usize,
    /// Mass, and this with added mass \[kg\].
    pub mass: f64,
    /// See `mass`.
    pub moving_mass: f64,
    /// Displaced volume \[m³\].
    pub volume: f64,
    /// Drag coefficient times area \[m²\].
    pub drag_area: f64,
    /// Steady load \[N\].
    pub load: V3,
}

/// A node at which two segments bend against each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// The node before, the node, the node behind it.
    pub nodes: [usize; 3],
    /// Bending stiffness \[N m²\].
    pub ei: f64,
    /// The line that it belongs to.
    pub line: usize,
    /// Mean unstretched length of its two segments \[m\].
    pub length: f64,
}

impl LumpedModel {
    /// Tension \[N\] of a segment of a line at these places, without damping.
    #[must_use]
    pub fn tension(&self, line: usize, segment: usize, x: &[V3]) -> f64 {
        let line = &self.lines[line];
        let apart = x[line.nodes[segment + 1]] - x[line.nodes[segment]];
        line.elasticity.at(apart.norm() / line.segment - 1.0).0
    }

    /// Tension \[N\] of the segment at end B of a line: what `MoorDyn` gives as that of the fairlead.
    #[must_use]
    pub fn end_tension(&self, line: usize, x: &[V3]) -> f64 {
        self.tension(line, self.lines[line].nodes.len() - 2, x)
    }

    /// Weight of a line in water \[N\].
    #[must_use]
    pub fn weight(&self, line: &ModelLine) -> f64 {
        let area = std::f64::consts::FRAC_PI_4 * line.diameter * line.diameter;
        let length = line.segment * (line.nodes.len() - 1) as f64;
        (line.mass - self.density * area) * self.gravity * length
    }

    /// Curvature at a bend \[1/m\], by the angle between its segments over half their lengths, as `MoorDyn` takes it.
    #[must_use]
    pub fn curvature(bend: &Bend, x: &[V3]) -> f64 {
        let [a, b, c] = bend.nodes.map(|node| x[node]);
        let [before, behind] = [b - a, c - b];
        let together = before.norm() + behind.norm();
        match (before.try_normalize(0.0), behind.try_normalize(0.0)) {
            // 4 / l sin(phi / 2), with cos(phi) of the unit vectors.
            (Some(q), Some(p)) => 2.0 * (p - q).norm() / together,
            _ => 0.0,
        }
    }
}
