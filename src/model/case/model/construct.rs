//! Parts of cases built in code by their required keys, all others at their defaults.
//!
//! A line of one material between two fixed points, hanging in air:
//!
//! ```
//! use seacable_model::case::{self, Case, End, Ends, Material, Method, Section};
//!
//! let ends = Ends {
//!     a: End::fixed("platform", [0.0, 0.0, 20.0]),
//!     b: End::fixed("ship", [80.0, 0.0, 18.0]),
//! };
//! let mut case = Case::new("Rope", ends);
//! case.environment.water_density_kg_per_m3 = 0.0;
//! case.materials.insert("rope".into(), Material::new(0.02, 1.1, 2e7));
//! case.line = vec![Section::new("rope", "rope", 81.0, 40)];
//! case.solver.method = Method::Static;
//! assert_eq!(case::parse(&case::write(&case), "rope.toml").unwrap(), case);
//! ```

use std::fmt::Write;

use super::{
    Attachment, Case, CaseInfo, Clump, End, EndKind, Ends, Floats, Material, Method, Modules,
    MotionName, Seabed, Section, Solver, TensionInterpolation, Traveller, WaveKind, Waves,
};
use crate::physics::rope::{TableInterpolation, TensionTable};

impl Solver {
    /// A run over a time \[s\].
    #[must_use]
    pub fn over(duration_s: f64) -> Self {
        Self {
            duration_s,
            ..Self::default()
        }
    }

    /// Whether it computes anything in time.
    #[must_use]
    pub fn is_in_time(&self) -> bool {
        self.method != Method::Static
    }
}

impl Case {
    /// A case of this title with these ends, without materials and sections; all else as in a file that leaves it out.
    #[must_use]
    pub fn new(title: &str, ends: Ends) -> Self {
        let case = CaseInfo {
            title: title.to_owned(),
            ..CaseInfo::default()
        };
        Self {
            case,
            ends,
            ..Self::default()
        }
    }
}

impl From<TensionInterpolation> for TableInterpolation {
    fn from(given: TensionInterpolation) -> Self {
        match given {
            TensionInterpolation::Smooth => Self::Smooth,
            TensionInterpolation::Linear => Self::Straight,
        }
    }
}

impl Material {
    /// The cross-section of its diameter \[m²\].
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        std::f64::consts::FRAC_PI_4 * self.diameter_m * self.diameter_m
    }

    /// Mass that weighs as much as it does in water of a density \[kg/m³\], by length \[kg/m\].
    #[must_use]
    pub fn wet_kg_per_m(&self, density: f64) -> f64 {
        let displaced = density * self.area_m2();
        self.wet_weight_kg_per_m
            .unwrap_or(self.mass_kg_per_m - displaced)
    }

    /// Its tension-strain table; nothing where it has none, or one that does not rise from zero.
    #[must_use]
    pub fn tension_table(&self) -> Option<TensionTable> {
        let (strain, tension) = (self.strain.as_ref()?, self.tension_n.as_ref()?);
        TensionTable::interpolated(strain, tension, self.tension_interpolation.into())
    }

    /// Its stiffness EA \[N\], or of a table the tension by strain at its end; nothing where it has neither.
    #[must_use]
    pub fn representative_ea_n(&self) -> Option<f64> {
        let last = |list: &Option<Vec<f64>>| list.as_ref().and_then(|list| list.last().copied());
        let table = last(&self.tension_n).zip(last(&self.strain));
        self.ea_n
            .or(table.map(|(tension, strain)| tension / strain))
    }

    /// A material of this diameter \[m\], mass per length \[kg/m\] and axial stiffness EA \[N\]; all else as in a file
    /// that leaves it out.
    #[must_use]
    pub fn new(diameter_m: f64, mass_kg_per_m: f64, ea_n: f64) -> Self {
        Self {
            diameter_m,
            mass_kg_per_m,
            ea_n: Some(ea_n),
            ..Self::default()
        }
    }
}

impl Section {
    /// A section of a material, its unstretched length \[m\] divided into segments.
    #[must_use]
    pub fn new(name: &str, material: &str, length_m: f64, segments: usize) -> Self {
        Self {
            name: name.to_owned(),
            material: material.to_owned(),
            length_m,
            segments,
        }
    }
}

impl End {
    /// An end of this name and kind at a position \[m\]; all else as in a file that leaves it out.
    #[must_use]
    pub fn new(name: &str, kind: EndKind, position_m: Option<[f64; 3]>) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            position_m,
            ..Self::default()
        }
    }

    /// An end fixed at a position \[m\].
    #[must_use]
    pub fn fixed(name: &str, position_m: [f64; 3]) -> Self {
        Self::new(name, EndKind::Fixed, Some(position_m))
    }

    /// The end moved along the table of displacements in this file of the case, growing from nothing over a time \[s\].
    #[must_use]
    pub fn moved_by_table(self, file: &str, ramp_s: f64) -> Self {
        Self {
            kind: EndKind::Moving,
            motion: MotionName::Table,
            motion_file: Some(file.to_owned()),
            ramp_s,
            ..self
        }
    }
}

impl Waves {
    /// Regular waves of this height \[m\] and period \[s\] along x; all else as in a file that leaves it out.
    #[must_use]
    pub fn regular(height_m: f64, period_s: f64) -> Self {
        Self {
            kind: WaveKind::Regular,
            height_m: Some(height_m),
            period_s: Some(period_s),
            ..Self::default()
        }
    }
}

impl Seabed {
    /// A level bed at this depth \[m\] without friction; all else as in a file that leaves it out.
    #[must_use]
    pub fn level(depth_m: f64) -> Self {
        Self {
            depth_m,
            ..Self::default()
        }
    }
}

/// What is attached to a section of a line: floats, modules, or a body.
pub trait OnSection: Sized {
    /// The name of the section; nothing for that of a line which has one.
    fn section(&self) -> Option<&str>;

    /// What of it is on a piece of a section of this length, between two lengths from its end nearer to A \[m\], and measured from there.
    fn on_piece(&self, section_m: f64, piece: [f64; 2]) -> Option<Self>;

    /// Whether it is on the section of this name.
    fn is_on(&self, name: Option<&str>) -> bool {
        self.section().is_none_or(|own| name == Some(own))
    }
}

/// What a piece has of a stretch \[m\], measured from the piece, and its share of the stretch; all of it where the stretch is within.
fn stretch_on_piece(
    (from_m, to_m): (f64, Option<f64>),
    section_m: f64,
    [from, to]: [f64; 2],
) -> Option<(f64, Option<f64>, f64)> {
    if from <= 0.0 && to >= section_m {
        return Some((from_m, to_m, 1.0));
    }
    let end_m = to_m.unwrap_or(section_m);
    let (begin, end) = (from_m.max(from), end_m.min(to));
    let share = (end - begin) / (end_m - from_m);
    (end > begin).then_some((begin - from, Some(end - from), share))
}

impl OnSection for Floats {
    fn section(&self) -> Option<&str> {
        self.section.as_deref()
    }

    fn on_piece(&self, section_m: f64, piece: [f64; 2]) -> Option<Self> {
        let (from_m, to_m, share) = stretch_on_piece((self.from_m, self.to_m), section_m, piece)?;
        Some(Self {
            section: self.section.clone(),
            from_m,
            to_m,
            lift_kg: share * self.lift_kg,
            mass_kg: share * self.mass_kg,
            drag_area_m2: share * self.drag_area_m2,
            drag_area_tangential_m2: share * self.drag_area_tangential_m2,
            added_mass_kg: share * self.added_mass_kg,
        })
    }
}

impl OnSection for Modules {
    fn section(&self) -> Option<&str> {
        self.section.as_deref()
    }

    fn on_piece(&self, section_m: f64, piece: [f64; 2]) -> Option<Self> {
        let (from_m, to_m, _) = stretch_on_piece((self.from_m, self.to_m), section_m, piece)?;
        Some(Self {
            from_m,
            to_m,
            ..self.clone()
        })
    }
}

impl OnSection for Clump {
    fn section(&self) -> Option<&str> {
        self.section.as_deref()
    }

    /// One where two pieces meet is on the first.
    fn on_piece(&self, section_m: f64, [from, to]: [f64; 2]) -> Option<Self> {
        let begins = from <= 0.0 || self.at_m > from;
        let ends = to >= section_m || self.at_m <= to;
        (begins && ends).then(|| Self {
            at_m: self.at_m - from,
            ..self.clone()
        })
    }
}

impl Clump {
    /// A body of a mass \[kg\] hanging in air at a distance from the start of a section \[m\].
    #[must_use]
    pub fn in_air(name: &str, section: &str, at_m: f64, mass_kg: f64) -> Self {
        Self {
            name: name.to_owned(),
            section: Some(section.to_owned()),
            at_m,
            mass_kg,
            wet_mass_kg: mass_kg,
            ..Self::default()
        }
    }

    /// Whether it has a drag across and along the line, which it is aligned with.
    #[must_use]
    pub fn has_aligned_drag(&self) -> bool {
        self.drag_area_normal_m2 > 0.0 || self.drag_area_tangential_m2 > 0.0
    }

    /// Whether it has an added mass across and along the line, which it is aligned with.
    #[must_use]
    pub fn has_aligned_added_mass(&self) -> bool {
        self.added_mass_normal_kg > 0.0 || self.added_mass_tangential_kg > 0.0
    }
}

impl Traveller {
    /// A body of a mass \[kg\] in air that travels from an unstretched arc length to another \[m\] at a speed \[m/s\].
    #[must_use]
    pub fn in_air(
        name: &str,
        mass_kg: f64,
        (from_m, to_m): (f64, f64),
        speed_m_per_s: f64,
    ) -> Self {
        Self {
            name: name.to_owned(),
            mass_kg,
            wet_mass_kg: mass_kg,
            from_m,
            to_m: Some(to_m),
            speed_m_per_s,
            ..Self::default()
        }
    }
}

impl Attachment {
    /// A table of displacements over time: seconds, and metres along x, y, z.
    #[must_use]
    pub fn displacements(rows: impl IntoIterator<Item = (f64, [f64; 3])>) -> Self {
        let mut text = String::from("time_s,x_m,y_m,z_m\n");
        for (t, [x, y, z]) in rows {
            // Writing to a text does not fail.
            let _ = writeln!(text, "{t:?},{x:?},{y:?},{z:?}");
        }
        Self { text: text.into() }
    }
}
