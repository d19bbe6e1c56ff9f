//! Utilisation of the sections of a line: greatest tension by breaking load, and least bending radius allowed by the smallest
//! one, from the envelopes over the whole run.

use super::Profile;
use crate::case::{Case, Material, Section};

/// A section and the limits of its material.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitCheck {
    /// The section.
    pub section: String,
    /// What it is made of.
    pub material: String,
    /// Greatest tension in it \[N\], and at which arc length from end A \[m\].
    pub tension: (f64, f64),
    /// Breaking load \[N\], where the material gives one.
    pub break_load: Option<f64>,
    /// Smallest radius it was bent to \[m\], and at which arc length \[m\]; absent where it does not bend.
    pub radius: Option<(f64, f64)>,
    /// Smallest radius it may be bent to \[m\], where the material gives one.
    pub least_radius: Option<f64>,
}

impl LimitCheck {
    /// Utilisation of the breaking load: greatest tension by breaking load \[-\].
    #[must_use]
    pub fn tension_utilisation(&self) -> Option<f64> {
        Some(self.tension.0 / self.break_load?)
    }

    /// Least radius allowed by the smallest there is \[-\]: above 1 the section is bent too sharply.
    #[must_use]
    pub fn bending_utilisation(&self) -> Option<f64> {
        Some(self.least_radius? / self.radius?.0)
    }

    /// Warnings of limits that are exceeded.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut list = Vec::new();
        if let (Some(share), Some(load)) = (self.tension_utilisation(), self.break_load)
            && share > 1.0
        {
            list.push(format!(
                "section `{}` is loaded beyond its breaking load: {:.3e} N at {:.1} m, against {load:.3e} N of `{}`",
                self.section, self.tension.0, self.tension.1, self.material
            ));
        }
        if let (Some(share), Some(least), Some((radius, arc))) =
            (self.bending_utilisation(), self.least_radius, self.radius)
            && share > 1.0
        {
            list.push(format!(
                "section `{}` is bent more sharply than it may be: to a radius of {radius:.3} m at {arc:.1} m, against \
                 {least} m of `{}`",
                self.section, self.material
            ));
        }
        list
    }
}

/// The sections whose material states a limit, from end A.
#[must_use]
pub fn check(case: &Case, profile: &Profile) -> Vec<LimitCheck> {
    let mut from = 0.0;
    let mut list = Vec::new();
    for section in &case.line {
        let to = from + section.length_m;
        if let Some(material) = case.materials.get(&section.material) {
            list.extend(check_section(section, material, profile, (from, to)));
        }
        from = to;
    }
    list
}

fn check_section(
    section: &Section,
    material: &Material,
    profile: &Profile,
    (from, to): (f64, f64),
) -> Option<LimitCheck> {
    if material.break_load_n.is_none() && material.min_bend_radius_m.is_none() {
        return None;
    }
    let slop = 1e-9 * to.max(1.0);
    let begin = profile.arc.partition_point(|s| *s < from - slop);
    let end = profile.arc.partition_point(|s| *s <= to + slop);
    let greatest = |values: &[f64]| {
        let here = values.get(begin..end)?.iter().zip(&profile.arc[begin..end]);
        here.map(|(value, arc)| (*value, *arc))
            .reduce(|best, here| if here.0 > best.0 { here } else { best })
    };
    let bend = greatest(&profile.curvature_max).filter(|(curvature, _)| *curvature > 0.0);
    Some(LimitCheck {
        section: section.name.clone(),
        material: section.material.clone(),
        tension: greatest(&profile.tension_max)?,
        break_load: material.break_load_n,
        radius: bend.map(|(curvature, arc)| (1.0 / curvature, arc)),
        least_radius: material.min_bend_radius_m,
    })
}
