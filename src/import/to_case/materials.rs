//! Line types as materials.

use super::case_text::{CaseText, number};
use super::names::Names;
use crate::import::mooring::{Damping, Given, LineType, Mass, Mooring, Program, Stiffness};

/// Writes the materials that lines are made of.
pub fn write(case: &mut CaseText<'_>, mooring: &Mooring, names: &Names) {
    let used = |number: usize| {
        mooring
            .lines
            .iter()
            .any(|line| line.of_type.value == number)
    };
    for (number, of_type) in mooring.line_types.iter().enumerate() {
        if used(number) {
            let header = format!("[materials.{}]", names.materials[number]);
            case.table(&header, Some(&of_type.span));
            material(case, of_type, mooring.program);
        }
    }
}

fn material(case: &mut CaseText<'_>, of: &LineType, program: Program) {
    let mut one = |key: &str, given: &Given<f64>, column: &str| {
        case.given(key, &number(given.value), &given.span, column);
    };
    one("diameter_m", &of.diameter, "Diam");
    let (mass, wet) = match of.mass.value {
        Mass::InAir(mass) => (mass, None),
        Mass::InWater(wet, mass) => (mass.unwrap_or(wet.abs()), Some(wet)),
    };
    one(
        "mass_kg_per_m",
        &Given::new(mass, of.mass.span.clone()),
        "Mass/m",
    );
    if let Some(wet) = wet {
        one(
            "wet_weight_kg_per_m",
            &Given::new(wet, of.mass.span.clone()),
            "weight in water",
        );
    }
    match &of.stiffness.value {
        Stiffness::Constant(ea) => {
            one("ea_n", &Given::new(*ea, of.stiffness.span.clone()), "EA");
        }
        // Kept to slow motion where the rest is left out.
        Stiffness::Viscoelastic { slow, .. } => {
            one(
                "ea_n",
                &Given::new(*slow, of.stiffness.span.clone()),
                "EA of slow motion",
            );
        }
        Stiffness::Table(curve) => secant(&mut one, curve, of),
        Stiffness::Syrope(rope) => secant(&mut one, &rope.first_loading, of),
    }
    if of.bending.value > 0.0 {
        one("ei_n_m2", &of.bending, "EI");
    }
    let span = of.damping.span.clone();
    match of.damping.value {
        Damping::Coefficient(damping) if damping > 0.0 => {
            one("axial_damping_n_s", &Given::new(damping, span), "BA");
        }
        Damping::Ratio(ratio) if ratio > 0.0 => {
            one("axial_damping_ratio", &Given::new(ratio, span), "-zeta");
        }
        Damping::Two(slow, _) if slow > 0.0 => {
            one(
                "axial_damping_n_s",
                &Given::new(slow, span),
                "BA of slow motion",
            );
        }
        _ => {}
    }
    one("drag_normal", &of.drag_normal, "Cd");
    one("drag_tangential", &of.drag_tangential, "CdAx");
    one("added_mass_normal", &of.added_mass_normal, "Ca");
    one("added_mass_tangential", &of.added_mass_tangential, "CaAx");
    if let Some(load) = &of.break_load {
        one("break_load_n", load, "breaking load");
    }
    let why = match program {
        Program::MoorDyn | Program::MoorDyn1 => "as MoorDyn refers CdAx to pi D",
        _ => "assumed: as MoorDyn refers it to pi D",
    };
    case.assumed("drag_tangential_width", "\"perimeter\"", why);
}

/// A curve of tension over strain that is left out, but for its first slope.
fn secant(one: &mut impl FnMut(&str, &Given<f64>, &str), curve: &[[f64; 2]], of: &LineType) {
    let slope = curve
        .get(1)
        .map_or(0.0, |[strain, tension]| tension / strain);
    one(
        "ea_n",
        &Given::new(slope, of.stiffness.span.clone()),
        "first slope of its curve",
    );
}
