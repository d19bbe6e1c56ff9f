//! Materials as line types.

use std::f64::consts::PI;

use super::number::written;
use super::sheet::{Sheet, TypeRow};
use super::target::{Target, Unsayable};
use crate::case::{
    CreepModel, DragCoefficient, DragWidth, Material, TensionInterpolation, WorkingCurveShape,
};
use crate::number::percent;
use crate::physics::rope::TensionTable;

/// Difference of a wet weight from that of the displaced water, by the mass, or of a tension by the tension, which is none.
const SAME: f64 = 1e-9;

/// The line type of a material, with this friction where types have it.
pub fn line_type(
    (name, material): (&str, &Material),
    (density, friction): (f64, f64),
    target: Target,
    sheet: &mut Sheet,
    refused: &mut Vec<Unsayable>,
) -> TypeRow {
    let mut refuse = |key: &str, what: &str| {
        refused.push(Unsayable {
            key: format!("materials.{name}.{key}"),
            what: what.to_owned(),
        });
    };
    let diameter = diameter(name, material, density, sheet);
    let Some(diameter) = diameter else {
        refuse(
            "wet_weight_kg_per_m",
            "a line that weighs more in water than in air",
        );
        return blank(name);
    };
    // Drag counts by the diameter, added mass by its square.
    let by = material.diameter_m / diameter;
    let coefficient = |drag: &DragCoefficient| match drag {
        DragCoefficient::Constant(value) => *value,
        DragCoefficient::Named(_) => 0.0,
    };
    let along = match material.drag_tangential_width {
        DragWidth::Diameter => 1.0 / PI,
        DragWidth::Perimeter => 1.0,
    };
    let (ea, damping) = match target {
        Target::MoorDyn => stiffness(name, material, sheet),
        Target::MapPlusPlus => constant_stiffness(material),
    };
    if ea.is_empty() {
        refuse("ea_n", "a line without a stiffness");
    }
    lost(name, material, target, sheet);
    TypeRow {
        name: name.to_owned(),
        diameter,
        mass: material.mass_kg_per_m,
        ea,
        damping,
        bending: material.ei_n_m2,
        drag: [
            coefficient(&material.drag_normal) * by,
            coefficient(&material.drag_tangential) * along * by,
        ],
        added_mass: [
            material.added_mass_normal * by * by,
            material.added_mass_tangential * by * by,
        ],
        friction,
    }
}

/// One stiffness, empty where the material has none, and damping.
fn constant_stiffness(material: &Material) -> (String, String) {
    let ea = material.representative_ea_n();
    let damping = material.axial_damping_n_s.unwrap_or(0.0);
    (ea.map_or_else(String::new, written), written(damping))
}

fn blank(name: &str) -> TypeRow {
    TypeRow {
        name: name.to_owned(),
        diameter: 0.0,
        mass: 0.0,
        ea: String::new(),
        damping: String::new(),
        bending: 0.0,
        drag: [0.0; 2],
        added_mass: [0.0; 2],
        friction: 0.0,
    }
}

/// The diameter by which a line displaces what its weight in water says.
fn diameter(name: &str, material: &Material, density: f64, sheet: &mut Sheet) -> Option<f64> {
    let own = material.diameter_m;
    let Some(wet) = material.wet_weight_kg_per_m else {
        return Some(own);
    };
    let displaced = material.mass_kg_per_m - wet;
    let by_diameter = density * 0.25 * PI * own * own;
    if (displaced - by_diameter).abs() <= SAME * material.mass_kg_per_m {
        return Some(own);
    }
    if displaced <= 0.0 || density <= 0.0 {
        return None;
    }
    let diameter = (4.0 * displaced / (PI * density)).sqrt();
    sheet.remarks.push(format!(
        "{name}: the diameter is {} m in the place of {}, for its weight in water; coefficients of drag and added mass go with it.",
        written(diameter),
        written(own)
    ));
    Some(diameter)
}

/// EA and BA in the form of MoorDyn.
fn stiffness(name: &str, material: &Material, sheet: &mut Sheet) -> (String, String) {
    let damping = match (material.axial_damping_n_s, material.axial_damping_ratio) {
        (Some(damping), _) => written(damping),
        (None, Some(ratio)) => written(-ratio),
        (None, None) => "0".to_owned(),
    };
    let two = || {
        let slow = written(material.slow_damping_n_s.unwrap_or(0.0));
        match material.fast_damping_n_s {
            0.0 => slow,
            fast => format!("{slow}|{}", written(fast)),
        }
    };
    let fast = material.dynamic_ea_n.unwrap_or(0.0);
    let growth = material.dynamic_ea_per_tension;
    match material.creep_model {
        CreepModel::None => (constant(name, material, sheet), damping),
        CreepModel::Viscoelastic => {
            let slow = constant(name, material, sheet);
            let both = match growth {
                0.0 => format!("{slow}|{}", written(fast)),
                growth => format!("{slow}|{}|{}", written(fast), written(growth)),
            };
            (both, two())
        }
        CreepModel::Syrope => {
            let file = syrope(name, material, sheet);
            let all = format!("SYROPE:{file}|{}|{}", written(fast), written(growth));
            (all, two())
        }
    }
}

/// EA, or the file of a table.
fn constant(name: &str, material: &Material, sheet: &mut Sheet) -> String {
    match (material.tension_table(), material.ea_n) {
        (Some(table), _) => {
            let file = format!("{name}_stiffness.txt");
            curve((name, &file), material, &table, sheet)
        }
        (None, Some(ea)) => written(ea),
        (None, None) => String::new(),
    }
}

/// Rows that a table of MoorDyn has at most (`nCoef`).
const MOST_ROWS: usize = 30;

/// Writes a table of tension over strain beside the file; the name of that. MoorDyn goes straight from row to row: of a curve that is
/// smooth as many rows are written as it reads.
fn curve(
    (name, file): (&str, &str),
    material: &Material,
    table: &TensionTable,
    sheet: &mut Sheet,
) -> String {
    let given = material.strain.as_deref().unwrap_or_default();
    let strains = match material.tension_interpolation {
        TensionInterpolation::Linear => given.to_vec(),
        TensionInterpolation::Smooth => divided(given),
    };
    if let Some(off) = beside(table, &strains) {
        sheet.remarks.push(format!(
            "{name}: its table is smooth, that of MoorDyn straight between {} rows: tensions differ by up to {}.",
            strains.len(),
            percent(off)
        ));
    }
    let mut text = "strain  tension\n(-)  (N)\n".to_owned();
    for strain in &strains {
        let tension = table.at(*strain).tension;
        text += &format!("{}  {}\n", written(*strain), written(tension));
    }
    sheet.files.push((file.to_owned(), text));
    file.to_owned()
}

/// The strains of a table with others between them, equally far apart, as many as MoorDyn reads.
fn divided(strains: &[f64]) -> Vec<f64> {
    let stretches = strains.len().saturating_sub(1).max(1);
    let pieces = ((MOST_ROWS - 1) / stretches).max(1);
    let mut all = Vec::with_capacity(stretches * pieces + 1);
    for pair in strains.windows(2) {
        for k in 0..pieces {
            all.push(pair[0] + (pair[1] - pair[0]) * k as f64 / pieces as f64);
        }
    }
    all.extend(strains.last());
    all
}

/// The greatest difference between a table and straight lines between these strains, by the tension of the table half way between two of
/// them; nothing where there is none.
fn beside(table: &TensionTable, strains: &[f64]) -> Option<f64> {
    let differences = strains.windows(2).map(|pair| {
        let [from, middle, to] =
            [pair[0], 0.5 * (pair[0] + pair[1]), pair[1]].map(|strain| table.at(strain).tension);
        (0.5 * (from + to) / middle - 1.0).abs()
    });
    let greatest = differences.fold(0.0, f64::max);
    (greatest > SAME).then_some(greatest)
}

/// Writes the curves of a Syrope rope beside the file; its name.
fn syrope(name: &str, material: &Material, sheet: &mut Sheet) -> String {
    let file = format!("{name}_first_loading.txt");
    let table = material.tension_table();
    let first = table.map_or_else(String::new, |table| {
        curve((name, &file), material, &table, sheet)
    });
    let form = match material.working_curve {
        WorkingCurveShape::Linear => "LINEAR",
        WorkingCurveShape::Quadratic => "QUADRATIC",
        WorkingCurveShape::Exponential => "EXP",
    };
    let k1 = material
        .working_curve_ea_n
        .or(material.permanent_strain_ratio)
        .unwrap_or(0.0);
    let k2 = material.working_curve_shape.unwrap_or(0.0);
    let file = format!("{name}_syrope.txt");
    let text = format!(
        "{first}  OWC\n{form}  WCType\n{}  k1\n{}  k2\n",
        written(k1),
        written(k2)
    );
    sheet.files.push((file.clone(), text));
    file
}

/// What a line type does not say.
fn lost(name: &str, material: &Material, target: Target, sheet: &mut Sheet) {
    let mut lost = Vec::new();
    if material.break_load_n.is_some() {
        lost.push("breaking load");
    }
    if material.min_bend_radius_m.is_some() {
        lost.push("least bending radius");
    }
    if material.bore.is_some() {
        lost.push("bore");
    }
    if material.mass_damping_per_s > 0.0 {
        lost.push("mass damping");
    }
    if target == Target::MapPlusPlus {
        if material.ei_n_m2 > 0.0 {
            lost.push("bending stiffness");
        }
        if material.axial_damping_ratio.is_some() {
            lost.push("damping ratio");
        }
    }
    if !lost.is_empty() {
        sheet.remarks.push(format!(
            "{name}: the file does not say its {}.",
            lost.join(", ")
        ));
    }
}
