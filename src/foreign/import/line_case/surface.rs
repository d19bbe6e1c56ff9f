//! What of a case counts as under water above the surface: of a line all, where the file does not say that it leaves the water.

use super::places::begins_at;
use super::source::{LETTERS, LineSource};
use crate::case::{Payload, WaterSurface, Waves};
use crate::import::to_case::case_text::CaseText;
use crate::scene::shape_form;

/// Waves higher than this share of the significant height are next to none.
const HIGHEST: f64 = 2.0;

/// Whether an end begins above still water.
pub(super) fn rises_above_water(source: &LineSource<'_>) -> bool {
    let ends = [&source.case.ends.a, &source.case.ends.b];
    let held = ends.into_iter().filter(|end| end.kind.is_held());
    let mut held = held.map(|end| end.position_m.unwrap_or_default());
    held.any(|place| place[2] > 0.0) || free_end_above(source, 0.0)
}

/// Writes that a free point does not float, where it may come to the surface and the case does not let it leave the water.
pub(super) fn of_point(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let around = &source.case.environment;
    let is_wet = around.water_density_kg_per_m3 > 0.0;
    if is_wet && around.water_surface == WaterSurface::Ignored && may_surface(source) {
        system.assumed("water_surface", "\"ignored\"", "as of a line");
    }
}

/// Whether a body of the case may come to the surface: it, or the line, is lighter than water, or it begins there.
fn may_surface(source: &LineSource<'_>) -> bool {
    let case = &source.case;
    let is_light = |wet: f64| wet < 0.0;
    let density = case.environment.water_density_kg_per_m3;
    let mut payload = case.payload.iter().map(|of| wet_mass(of, density));
    let mut clumps = case.clumps.iter().map(|clump| clump.wet_mass_kg);
    let mut travellers = case.traveller.iter().map(|body| body.wet_mass_kg);
    let mut materials = case.materials.values().map(|of| of.wet_kg_per_m(density));
    let carried = !case.floats.is_empty() || !case.modules.is_empty();
    carried
        || payload.any(is_light)
        || clumps.any(is_light)
        || travellers.any(is_light)
        || materials.any(is_light)
        || free_end_above(source, -sea(source))
}

/// The mass that weighs as much as a payload does in water of a density \[kg\].
fn wet_mass(of: &Payload, density: f64) -> f64 {
    let of_shape = of.shape.as_ref().map(|shape| shape_form(shape).volume);
    let volume = of.volume_m3.or(of_shape).unwrap_or(0.0);
    of.wet_mass_kg.unwrap_or(of.dry_mass_kg - density * volume)
}

/// Whether a free end begins above a height \[m\].
fn free_end_above(source: &LineSource<'_>, height: f64) -> bool {
    let ends = [&source.case.ends.a, &source.case.ends.b];
    let free = LETTERS
        .into_iter()
        .zip(ends)
        .filter(|(_, end)| !end.kind.is_held());
    let mut places = free.map(|(letter, _)| begins_at(source, letter).0);
    places.any(|place| place[2] > height)
}

/// How far waves and motions of ends reach \[m\].
fn sea(source: &LineSource<'_>) -> f64 {
    let of_waves = |waves: &Waves| {
        let significant = waves.significant_height_m.unwrap_or(0.0);
        waves.height_m.unwrap_or(0.0).max(HIGHEST * significant)
    };
    let ends = [&source.case.ends.a, &source.case.ends.b].into_iter();
    let of_ends =
        ends.map(|end| 2.0 * end.amplitude_m[2].abs() + 8.0 * end.rms_m.unwrap_or_default()[2]);
    source.case.waves.as_ref().map_or(0.0, of_waves) + of_ends.sum::<f64>()
}
