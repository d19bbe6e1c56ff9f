//! Floats and buoyancy modules, distributed over their segments.

use std::f64::consts::FRAC_PI_4;

use super::Segment;
use super::build::bare_segment;
use super::elasticity::Elasticity;
use crate::case;

/// A segment of a section, by where it begins and its length \[m\], of a material with floats and modules.
pub(super) fn segment<'c>(
    water: &case::Environment,
    (material, elasticity): (&case::Material, &Elasticity),
    (section_length, floats, modules): (
        f64,
        impl Iterator<Item = &'c case::Floats>,
        impl Iterator<Item = &'c case::Modules>,
    ),
    (from, length): (f64, f64),
) -> Segment {
    let mut segment = bare_segment(water, material, elasticity, length);
    let (bare, reach) = (material.diameter_m, (from, from + length));
    for modules in modules {
        add_modules(water, modules, bare, section_length, reach, &mut segment);
    }
    for floats in floats {
        add_floats(water, floats, section_length, reach, &mut segment);
    }
    segment
}

/// A whole section with floats and modules on it as one segment, but for its tension: what has constants along it is spread as in a mesh.
#[must_use]
pub fn spread(
    water: &case::Environment,
    material: &case::Material,
    section_length: f64,
    (floats, modules): (&[case::Floats], &[case::Modules]),
) -> Segment {
    let elasticity = Elasticity::linear(material.representative_ea_n().unwrap_or(0.0));
    segment(
        water,
        (material, &elasticity),
        (section_length, floats.iter(), modules.iter()),
        (0.0, section_length),
    )
}

/// Length of the part from `from` to `to` \[m\] (default: the end of the section) that overlaps a piece of the section.
fn overlap(from: f64, to: Option<f64>, section: f64, piece: (f64, f64)) -> f64 {
    (piece.1.min(to.unwrap_or(section)) - piece.0.max(from)).max(0.0)
}

/// Adds the share of floats that overlaps this part of the section.
fn add_floats(
    water: &case::Environment,
    floats: &case::Floats,
    section_length: f64,
    (from, to): (f64, f64),
    segment: &mut Segment,
) {
    let end = floats.to_m.unwrap_or(section_length);
    let stretch = end - floats.from_m;
    let overlap = overlap(floats.from_m, floats.to_m, section_length, (from, to));
    if stretch <= 0.0 || overlap == 0.0 {
        return;
    }
    let share = overlap / stretch;
    segment.half_mass += 0.5 * share * floats.mass_kg;
    segment.half_weight -= 0.5 * share * floats.lift_kg * water.gravity_m_per_s2;
    segment.added.normal += 0.5 * share * floats.added_mass_kg;
    let by_area = |area: f64| 0.5 * water.water_density_kg_per_m3 * area * share / (to - from);
    segment.drag.floats += by_area(floats.drag_area_m2);
    segment.drag.floats_tangential += by_area(floats.drag_area_tangential_m2);
}

/// Adds the share of buoyancy modules on this part of the section, by the equivalence of Lin et al. 2016: volume and
/// mass per length are kept (its eqs 20 and 21), `V = pi/4 (Df² - Dp²) Lf / Sf` and `M = V rho_f + M_fh / Sf`, and so is
/// drag, `[C_Df Df Lf + C_D Dp (Sf - Lf)] / Sf`; that along the line where it is given, else it stays that of the line. The line under a module keeps its own stiffness.
fn add_modules(
    water: &case::Environment,
    modules: &case::Modules,
    bare_diameter: f64,
    section_length: f64,
    piece: (f64, f64),
    segment: &mut Segment,
) {
    let covered = overlap(modules.from_m, modules.to_m, section_length, piece);
    let share = covered / (piece.1 - piece.0);
    let filled = modules.length_m / modules.pitch_m;
    let ring = modules.diameter_m.powi(2) - bare_diameter.powi(2);
    let volume = FRAC_PI_4 * ring * filled;
    let mass = volume * modules.density_kg_per_m3 + modules.fittings_kg / modules.pitch_m;
    let displaced = volume * water.water_density_kg_per_m3;
    segment.half_mass += 0.5 * covered * mass;
    segment.half_weight += 0.5 * covered * (mass - displaced) * water.gravity_m_per_s2;
    segment.added.normal += 0.5 * covered * displaced;
    segment.bearing_width += share * filled * (modules.diameter_m - bare_diameter);
    segment.drag.normal *= 1.0 - share * filled;
    let by_coefficient = |coefficient: f64| {
        0.5 * water.water_density_kg_per_m3 * coefficient * modules.diameter_m * filled * share
    };
    segment.drag.floats += by_coefficient(modules.drag_normal);
    if let Some(tangential) = modules.drag_tangential {
        segment.drag.tangential *= 1.0 - share * filled;
        segment.drag.floats_tangential += by_coefficient(tangential);
    }
}
