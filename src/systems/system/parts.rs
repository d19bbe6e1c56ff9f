//! The parts of a line: its sections, each of one material, in order from its end A.

use super::discretised::SEGMENTS;
use super::model::{LineInputs, LineSection, SystemFile};
use crate::case::{Material, OneOrMany, WaterSurface};
use crate::numerics::V3;
use crate::scene::per_axis;

/// A stretch of a line of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name of its material.
    pub name: String,
    /// Name of its section, where it has one.
    pub section: Option<String>,
    /// What it is made of.
    pub material: Material,
    /// Unstretched length \[m\].
    pub length_m: f64,
    /// The body at its end towards B.
    pub clump: SectionClump,
    /// Segments that its section asks for.
    pub segments: Option<usize>,
    /// Pieces of equal length that its section is divided into; 1 where it is not.
    pub pieces: usize,
}

/// A body where two sections of a line meet.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SectionClump {
    /// Weight in water, as mass \[kg\]; negative floats.
    pub wet_kg: f64,
    /// Mass in air \[kg\].
    pub mass_kg: f64,
    /// Drag coefficient times area along x, y, z \[m²\].
    pub drag_area_m2: V3,
    /// The same across and along the line, in its place \[m²\].
    pub aligned_drag_area_m2: [f64; 2],
    /// Added mass along x, y, z \[kg\].
    pub added_mass_kg: V3,
    /// How it bears on the bed.
    pub bearing: ClumpBearing,
}

/// How a body on a line bears on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClumpBearing {
    /// Area that bears \[m²\]; nothing for the bottom of a cube of its volume.
    pub area_m2: Option<f64>,
    /// From the line down to what bears \[m\].
    pub bottom_m: f64,
    /// Greatest pull of the bed once it has borne on it \[N\].
    pub breakout_n: f64,
    /// Distance off the bed at which it is free of that pull \[m\].
    pub breakout_distance_m: f64,
}

impl Default for ClumpBearing {
    fn default() -> Self {
        LineSection::default().clump_bearing()
    }
}

impl SectionClump {
    /// Volume that it displaces in water of a density \[m³\].
    #[must_use]
    pub fn volume_m3(&self, density: f64) -> f64 {
        match density > 0.0 {
            true => (self.mass_kg - self.wet_kg) / density,
            false => 0.0,
        }
    }
}

impl LineSection {
    /// The body at its end towards B.
    #[must_use]
    pub fn clump(&self) -> SectionClump {
        SectionClump {
            wet_kg: self.clump_kg,
            mass_kg: self.clump_mass_kg.unwrap_or(self.clump_kg.abs()),
            drag_area_m2: per_axis(&self.clump_drag_area_m2),
            aligned_drag_area_m2: [
                self.clump_drag_area_normal_m2,
                self.clump_drag_area_tangential_m2,
            ],
            added_mass_kg: per_axis(&self.clump_added_mass_kg),
            bearing: self.clump_bearing(),
        }
    }

    fn clump_bearing(&self) -> ClumpBearing {
        ClumpBearing {
            area_m2: self.clump_bed_area_m2,
            bottom_m: self.clump_bottom_m,
            breakout_n: self.clump_breakout_n,
            breakout_distance_m: self.clump_breakout_distance_m,
        }
    }

    /// The same section without that body.
    #[must_use]
    pub fn without_clump(self) -> Self {
        Self {
            clump_kg: 0.0,
            clump_mass_kg: None,
            clump_drag_area_m2: OneOrMany::One(0.0),
            clump_drag_area_normal_m2: 0.0,
            clump_drag_area_tangential_m2: 0.0,
            clump_added_mass_kg: OneOrMany::One(0.0),
            clump_bed_area_m2: None,
            clump_bottom_m: 0.0,
            clump_breakout_n: 0.0,
            clump_breakout_distance_m: ClumpBearing::default().breakout_distance_m,
            ..self
        }
    }
}

/// The sections of a line, which the checks passed: a line of one material has one.
#[must_use]
pub fn sections(line: &LineInputs) -> Vec<LineSection> {
    match (&line.material, line.length_m) {
        (Some(material), Some(length_m)) => vec![LineSection {
            material: material.clone(),
            length_m,
            ..LineSection::default()
        }],
        _ => line.sections.clone(),
    }
}

/// The parts of a line, which the checks passed.
#[must_use]
pub fn parts(file: &SystemFile, line: &LineInputs) -> Vec<Part> {
    let part = |section: LineSection| Part {
        material: file.materials[&section.material].clone(),
        clump: section.clump(),
        section: section.name,
        name: section.material,
        length_m: section.length_m,
        segments: section.segments,
        pieces: 1,
    };
    sections(line).into_iter().map(part).collect()
}

impl LineInputs {
    /// The segments that the line, or its sections, ask for.
    #[must_use]
    pub fn asked_segments(&self) -> Option<usize> {
        let of_sections: Option<usize> = self.sections.iter().map(|one| one.segments).sum();
        let of_sections = of_sections.filter(|count| *count > 0);
        self.segments.or(of_sections)
    }

    /// The segments that it is divided into, but for the fewest of each section.
    #[must_use]
    pub fn wanted_segments(&self) -> usize {
        self.asked_segments().unwrap_or(SEGMENTS)
    }
}

/// Whether lines and points of a file have their weight in air above its water.
#[must_use]
pub fn is_crossed(file: &SystemFile) -> bool {
    let water = &file.environment;
    let weighs = water.water_density_kg_per_m3 > 0.0 && water.gravity_m_per_s2 > 0.0;
    weighs && water.water_surface == WaterSurface::Crossed
}
