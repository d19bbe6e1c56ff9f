//! What the materials of the sections of a system's lines state.

use super::model::SystemFile;

/// The diameter of a section of a line \[m\], by the name that its copies share.
#[must_use]
pub fn diameter(file: &SystemFile, line: &str, section: usize) -> Option<f64> {
    let line = file.lines.iter().find(|known| known.name == line)?;
    let section = line.sections.get(section).map(|section| &section.material);
    let material = section.or(line.material.as_ref())?;
    file.materials
        .get(material)
        .map(|material| material.diameter_m)
}
