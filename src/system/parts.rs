//! The parts of a line: its sections, each of one material, in order from its end A.

use super::model::{LineInputs, SystemFile};
use crate::case::Material;

/// A stretch of a line of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name of its material.
    pub name: String,
    /// What it is made of.
    pub material: Material,
    /// Unstretched length \[m\].
    pub length_m: f64,
    /// Weight in water of a body at its end towards B, as mass \[kg\]; negative floats.
    pub clump_kg: f64,
    /// Pieces of equal length that its section is divided into; 1 where it is not.
    pub pieces: usize,
}

/// The parts of a line, which the checks passed: its sections, or the line of one material as one.
#[must_use]
pub fn parts(file: &SystemFile, line: &LineInputs) -> Vec<Part> {
    let part = |material: &String, length_m: f64, clump_kg: f64| Part {
        name: material.clone(),
        material: file.materials[material].clone(),
        length_m,
        clump_kg,
        pieces: 1,
    };
    match (&line.material, line.length_m) {
        (Some(material), Some(length_m)) => vec![part(material, length_m, 0.0)],
        _ => line
            .sections
            .iter()
            .map(|section| part(&section.material, section.length_m, section.clump_kg))
            .collect(),
    }
}
