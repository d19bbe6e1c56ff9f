//! Materials of the system: those of the case, and those of stretches with floats or modules, which are spread over them as in a case.

use std::f64::consts::{FRAC_PI_4, PI};

use super::copied::{bare, copy_inner, copy_keys, copy_table};
use super::source::LineSource;
use super::stretches::Stretch;
use crate::case::{DragCoefficient, DragWidth, Environment, Floats, Material, Modules};
use crate::import::to_case::case_text::{CaseText, number};

/// Keys of a material that floats and modules change.
const CHANGED: [&str; 9] = [
    "diameter_m",
    "mass_kg_per_m",
    "wet_weight_kg_per_m",
    "axial_damping_ratio",
    "drag_normal",
    "drag_tangential",
    "attached_drag_width_m",
    "added_mass_normal",
    "added_mass_tangential",
];

/// The name of the material of a stretch, by its number from 0.
pub(super) fn name_of(source: &LineSource<'_>, line: &[Stretch<'_>], number: usize) -> String {
    let material = &source.case.line[line[number].section].material;
    match line[number].is_bare() {
        true => material.clone(),
        false => format!("{material}-buoyed-{}", number + 1),
    }
}

/// Writes the materials that the line has.
pub(super) fn write_materials(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    line: &[Stretch<'_>],
) {
    for name in source.case.materials.keys() {
        if let Some(node) = source.node(&["materials", name]) {
            copy_table(
                system,
                source,
                &format!("[materials.{}]", bare(name)),
                node,
                &[],
            );
        }
    }
    for (number_of, stretch) in line.iter().enumerate().filter(|(_, one)| !one.is_bare()) {
        let own = &source.case.line[stretch.section].material;
        let Some((node, material)) = source
            .node(&["materials", own])
            .zip(source.case.materials.get(own))
        else {
            continue;
        };
        let name = name_of(source, line, number_of);
        let header = format!("[materials.{}]", bare(&name));
        system.table(&header, Some(&node.span));
        let mut changed = CHANGED.to_vec();
        changed.retain(|key| !is_law(material, key));
        copy_keys(system, source, node, &changed);
        let section = source.case.line[stretch.section].length_m;
        Buoyed::of(material, stretch, section, source).write(system, material);
        copy_inner(system, source, &header, node);
    }
}

/// What a stretch with floats and modules has in the place of its material, by unstretched length.
struct Buoyed {
    /// Diameter \[m\].
    diameter: f64,
    /// Mass \[kg/m\].
    mass: f64,
    /// Weight in water, as mass \[kg/m\].
    wet: f64,
    /// Drag coefficient times width of what is attached to a line whose own goes by a law \[m\].
    attached: f64,
    /// Normal drag coefficient times width \[m\].
    drag: f64,
    /// Tangential drag coefficient times the width that it is referred to \[m\].
    drag_along: f64,
    /// That width by the diameter.
    width: f64,
    /// Normal added mass \[kg/m\].
    added: f64,
    /// Density of the water \[kg/m³\].
    density: f64,
}

impl Buoyed {
    fn of(
        material: &Material,
        stretch: &Stretch<'_>,
        section: f64,
        source: &LineSource<'_>,
    ) -> Self {
        let water = &source.case.environment;
        let mut buoyed = Self::bare(material, water);
        let bears = source.case.seabed.is_some();
        for modules in &stretch.modules {
            buoyed.add_modules(modules, material.diameter_m, bears);
        }
        for floats in &stretch.floats {
            buoyed.add_floats(floats, section, is_law(material, "drag_normal"));
        }
        buoyed
    }

    fn bare(material: &Material, water: &Environment) -> Self {
        let density = water.water_density_kg_per_m3;
        let displaced = density * area(material.diameter_m);
        let wet = material.wet_weight_kg_per_m;
        let width = match material.drag_tangential_width {
            DragWidth::Diameter => 1.0,
            DragWidth::Perimeter => PI,
        };
        Self {
            diameter: material.diameter_m,
            mass: material.mass_kg_per_m,
            wet: wet.unwrap_or(material.mass_kg_per_m - displaced),
            attached: material.attached_drag_width_m,
            drag: constant(&material.drag_normal) * material.diameter_m,
            drag_along: constant(&material.drag_tangential) * width * material.diameter_m,
            width,
            added: displaced * material.added_mass_normal,
            density,
        }
    }

    /// Floats spread evenly from `from_m` to `to_m` of a section \[m\].
    fn add_floats(&mut self, floats: &Floats, section: f64, has_law: bool) {
        let stretch = floats.to_m.unwrap_or(section) - floats.from_m;
        self.mass += floats.mass_kg / stretch;
        self.wet -= floats.lift_kg / stretch;
        let drag = match has_law {
            true => &mut self.attached,
            false => &mut self.drag,
        };
        *drag += floats.drag_area_m2 / stretch;
        self.drag_along += floats.drag_area_tangential_m2 / stretch;
        self.added += floats.added_mass_kg / stretch;
    }

    /// Modules by the equivalence of Lin et al. 2016: volume, mass and drag by length are kept; on a bed they bear on their width.
    fn add_modules(&mut self, modules: &Modules, bare_diameter: f64, bears: bool) {
        let filled = modules.length_m / modules.pitch_m;
        let volume = (area(modules.diameter_m) - area(bare_diameter)) * filled;
        let mass = volume * modules.density_kg_per_m3 + modules.fittings_kg / modules.pitch_m;
        self.mass += mass;
        self.wet += mass - volume * self.density;
        self.added += volume * self.density;
        self.drag *= 1.0 - filled;
        self.drag += modules.drag_normal * modules.diameter_m * filled;
        if let Some(tangential) = modules.drag_tangential {
            self.drag_along *= 1.0 - filled;
            self.drag_along += tangential * modules.diameter_m * filled;
        }
        if bears {
            self.diameter += filled * (modules.diameter_m - bare_diameter);
        }
    }

    /// Writes it in the coefficients of a material, the others of which are those of `bare`.
    fn write(&self, system: &mut CaseText<'_>, bare: &Material) {
        let why = "with floats or modules";
        let mut one = |key: &str, value: f64| system.assumed(key, &number(value), why);
        let wider = self.diameter / bare.diameter_m;
        let displaced = self.density * area(self.diameter);
        one("diameter_m", self.diameter);
        one("mass_kg_per_m", self.mass);
        one("wet_weight_kg_per_m", self.wet);
        if !is_law(bare, "drag_normal") {
            one("drag_normal", self.drag / self.diameter);
        }
        if !is_law(bare, "drag_tangential") {
            let along = self.drag_along / (self.width * self.diameter);
            one("drag_tangential", along);
        }
        if self.attached > 0.0 {
            one("attached_drag_width_m", self.attached);
        }
        if displaced > 0.0 {
            one("added_mass_normal", self.added / displaced);
        }
        one(
            "added_mass_tangential",
            bare.added_mass_tangential / (wider * wider),
        );
        // Its damping is that of the bare line: the ratio goes with the root of the mass.
        if let Some(ratio) = bare.axial_damping_ratio {
            one(
                "axial_damping_ratio",
                ratio * (bare.mass_kg_per_m / self.mass).sqrt(),
            );
        }
    }
}

fn area(diameter: f64) -> f64 {
    FRAC_PI_4 * diameter * diameter
}

/// Whether a key of a material gives drag by a law of the Reynolds number, which floats leave as it is; under modules it is refused.
fn is_law(material: &Material, key: &str) -> bool {
    let drag = match key {
        "drag_normal" => &material.drag_normal,
        "drag_tangential" => &material.drag_tangential,
        _ => return false,
    };
    matches!(drag, DragCoefficient::Named(_))
}

/// A coefficient; 0 of a law.
fn constant(drag: &DragCoefficient) -> f64 {
    match drag {
        DragCoefficient::Constant(value) => *value,
        DragCoefficient::Named(_) => 0.0,
    }
}
