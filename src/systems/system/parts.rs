//! The parts of a line: its sections, each of one material, in order from its end A.

use super::discretised::SEGMENTS;
use super::model::{LineInputs, LineSection, SystemFile};
use crate::case::{Clump, Floats, Material, Modules, OnSection, OneOrMany, WaterSurface};

/// A stretch of a line of one material, with what is attached to it in lengths from its end nearer to A.
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
    /// Floats on it.
    pub floats: Vec<Floats>,
    /// Modules on it.
    pub modules: Vec<Modules>,
    /// The bodies on it.
    pub clumps: Vec<Clump>,
    /// Segments that its section asks for.
    pub segments: Option<usize>,
    /// Pieces of equal length that its section is divided into; 1 where it is not.
    pub pieces: usize,
}

impl Part {
    /// A piece of it, between two lengths from its end nearer to A \[m\].
    #[must_use]
    pub fn piece(&self, piece: [f64; 2]) -> Self {
        Self {
            length_m: piece[1] - piece[0],
            floats: on_piece(&self.floats, self.length_m, piece),
            modules: on_piece(&self.modules, self.length_m, piece),
            clumps: on_piece(&self.clumps, self.length_m, piece),
            ..self.clone()
        }
    }
}

/// What of floats, modules or bodies on a section of a length is on a piece of it \[m\].
#[must_use]
pub fn on_piece<T: OnSection>(all: &[T], section_m: f64, piece: [f64; 2]) -> Vec<T> {
    let all = all.iter();
    all.filter_map(|one| one.on_piece(section_m, piece))
        .collect()
}

impl LineSection {
    /// The body at its end towards B, where it has one.
    #[must_use]
    pub fn clump(&self) -> Option<Clump> {
        let bare = Self {
            length_m: self.length_m,
            ..Self::default()
        };
        let own = self.stated_clump();
        (own != bare.stated_clump()).then_some(own)
    }

    fn stated_clump(&self) -> Clump {
        let shortest = |value: &OneOrMany| match value.alike() {
            Some(one) => OneOrMany::One(one),
            None => value.clone(),
        };
        Clump {
            name: String::new(),
            section: None,
            at_m: self.length_m,
            mass_kg: self.clump_mass_kg.unwrap_or(self.clump_kg.abs()),
            wet_mass_kg: self.clump_kg,
            drag_area_m2: shortest(&self.clump_drag_area_m2),
            drag_area_normal_m2: self.clump_drag_area_normal_m2,
            drag_area_tangential_m2: self.clump_drag_area_tangential_m2,
            added_mass_kg: shortest(&self.clump_added_mass_kg),
            added_mass_normal_kg: self.clump_added_mass_normal_kg,
            added_mass_tangential_kg: self.clump_added_mass_tangential_kg,
            bed_area_m2: self.clump_bed_area_m2,
            bottom_m: self.clump_bottom_m,
            breakout_n: self.clump_breakout_n,
            breakout_distance_m: self.clump_breakout_distance_m,
        }
    }

    /// The same section with this body at its end towards B.
    #[must_use]
    pub fn with_clump(self, clump: &Clump) -> Self {
        Self {
            clump_kg: clump.wet_mass_kg,
            clump_mass_kg: Some(clump.mass_kg),
            clump_drag_area_m2: clump.drag_area_m2.clone(),
            clump_drag_area_normal_m2: clump.drag_area_normal_m2,
            clump_drag_area_tangential_m2: clump.drag_area_tangential_m2,
            clump_added_mass_kg: clump.added_mass_kg.clone(),
            clump_added_mass_normal_kg: clump.added_mass_normal_kg,
            clump_added_mass_tangential_kg: clump.added_mass_tangential_kg,
            clump_bed_area_m2: clump.bed_area_m2,
            clump_bottom_m: clump.bottom_m,
            clump_breakout_n: clump.breakout_n,
            clump_breakout_distance_m: clump.breakout_distance_m,
            ..self
        }
    }

    /// The same section without that body.
    #[must_use]
    pub fn without_clump(self) -> Self {
        Self {
            name: self.name,
            material: self.material,
            length_m: self.length_m,
            segments: self.segments,
            ..Self::default()
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

/// The parts of a line, which the checks passed: its sections, with what is attached to them.
#[must_use]
pub fn parts(file: &SystemFile, line: &LineInputs) -> Vec<Part> {
    let part = |section: LineSection| Part {
        material: file.materials[&section.material].clone(),
        floats: of_section(&line.floats, &section),
        modules: of_section(&line.modules, &section),
        clumps: section
            .clump()
            .into_iter()
            .chain(of_section(&line.clumps, &section))
            .collect(),
        section: section.name,
        name: section.material,
        length_m: section.length_m,
        segments: section.segments,
        pieces: 1,
    };
    let mut parts: Vec<Part> = sections(line).into_iter().map(part).collect();
    // A body at the beginning of a section hangs where that meets the one before.
    for number in 1..parts.len() {
        let at_m = parts[number - 1].length_m;
        let all = std::mem::take(&mut parts[number].clumps);
        let (first, others): (Vec<Clump>, Vec<Clump>) =
            all.into_iter().partition(|clump| clump.at_m <= 0.0);
        parts[number].clumps = others;
        let first = first.into_iter().map(|clump| Clump { at_m, ..clump });
        parts[number - 1].clumps.extend(first);
    }
    parts
}

/// A share of a number of segments, one at least.
#[must_use]
pub fn shared(segments: usize, share: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count of segments, bounded by the file"
    )]
    let count = (segments as f64 * share).round() as usize;
    count.max(1)
}

fn of_section<T: OnSection + Clone>(all: &[T], section: &LineSection) -> Vec<T> {
    let own = all.iter().filter(|one| one.is_on(section.name.as_deref()));
    own.cloned().collect()
}

impl LineInputs {
    /// Whether anything is attached to it by a table of its own.
    #[must_use]
    pub fn has_attachments(&self) -> bool {
        !(self.floats.is_empty() && self.modules.is_empty() && self.clumps.is_empty())
    }

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
