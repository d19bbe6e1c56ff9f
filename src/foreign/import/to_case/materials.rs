//! Line types as materials.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use super::case_text::{CaseText, number as number_of, numbers, text};
use super::names::Names;
use crate::import::mooring::{
    Damping, Given, Mass, Mooring, MooringLineType, PastTension, PolyesterCurve, Program,
    Stiffness, Syrope, WorkingForm,
};

/// Writes the materials that lines are made of. Ropes whose strain depends on their past are one for each past.
pub fn write(case: &mut CaseText<'_>, mooring: &Mooring, names: &Names) {
    let pasts = Pasts::of_mooring(mooring);
    let mut written = HashSet::new();
    for (number, line) in mooring.lines.iter().enumerate() {
        let name = name_of(mooring, names, &pasts, number);
        if !written.insert(name.clone()) {
            continue;
        }
        let of_type = &mooring.line_types[line.of_type.value];
        case.table(&format!("[materials.{name}]"), Some(&of_type.span));
        material(case, of_type, mooring.program);
        if let (Stiffness::Syrope(_), Some(past)) =
            (&of_type.stiffness.value, pasts.of_line(mooring, number))
        {
            let greatest = number_of(past.greatest.value);
            case.given("past_tension_n", &greatest, &past.greatest.span, "Tmax0");
            if past.mean.value > 0.0 {
                let mean = number_of(past.mean.value);
                case.given("initial_mean_tension_n", &mean, &past.mean.span, "Tmean0");
            }
        }
    }
}

/// The past of each line, and of which types of line there are different ones.
#[derive(Debug, Clone, Default)]
pub struct Pasts {
    by_line: HashMap<usize, usize>,
    differ: HashSet<usize>,
}

impl Pasts {
    /// Those of a mooring; of a line that is named twice the first counts.
    #[must_use]
    pub fn of_mooring(mooring: &Mooring) -> Self {
        let mut pasts = Self::default();
        for (number, past) in mooring.past_tensions.iter().enumerate() {
            for line in &past.lines {
                pasts.by_line.entry(*line).or_insert(number);
            }
        }
        let mut first: HashMap<usize, Option<[f64; 2]>> = HashMap::new();
        for (number, line) in mooring.lines.iter().enumerate() {
            let of_type = line.of_type.value;
            let is_syrope =
                |of: &MooringLineType| matches!(of.stiffness.value, Stiffness::Syrope(_));
            if !is_syrope(&mooring.line_types[of_type]) {
                continue;
            }
            let past = pasts.of_line(mooring, number);
            let values = past.map(|past| [past.greatest.value, past.mean.value]);
            if *first.entry(of_type).or_insert(values) != values {
                pasts.differ.insert(of_type);
            }
        }
        pasts
    }

    /// The past of a line.
    #[must_use]
    pub fn of_line<'m>(&self, mooring: &'m Mooring, line: usize) -> Option<&'m PastTension> {
        let number = self.by_line.get(&line)?;
        mooring.past_tensions.get(*number)
    }
}

/// The material of a line: its type, with the line where others of the type have another past.
#[must_use]
pub fn name_of(mooring: &Mooring, names: &Names, pasts: &Pasts, line: usize) -> String {
    let of_type = mooring.lines[line].of_type.value;
    let name = &names.materials[of_type];
    match pasts.differ.contains(&of_type) {
        true => format!("{name}-{}", names.lines[line]),
        false => name.clone(),
    }
}

fn material(case: &mut CaseText<'_>, of: &MooringLineType, program: Program) {
    let mut one = |key: &str, given: &Given<f64>, column: &str| {
        case.given(key, &number_of(given.value), &given.span, column);
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
    if let Stiffness::Constant(ea) | Stiffness::Viscoelastic { slow: ea, .. } = &of.stiffness.value
    {
        one("ea_n", &Given::new(*ea, of.stiffness.span.clone()), "EA");
    }
    elasticity(case, of);
    let mut one = |key: &str, given: &Given<f64>, column: &str| {
        case.given(key, &number_of(given.value), &given.span, column);
    };
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
        Program::Ontology => "as the ontology refers it to pi D",
        _ => "assumed: as MoorDyn refers it to pi D",
    };
    case.assumed("drag_tangential_width", "\"perimeter\"", why);
}

/// Tension by strain, where it is more than one stiffness.
fn elasticity(case: &mut CaseText<'_>, of: &MooringLineType) {
    let span = &of.stiffness.span;
    let curve = match &of.stiffness.value {
        Stiffness::Table(curve) => Some(curve),
        Stiffness::Syrope(rope) => Some(&rope.first_loading),
        Stiffness::Constant(_) | Stiffness::Viscoelastic { .. } => None,
    };
    if let Some(curve) = curve {
        let column = |k: usize| numbers(&curve.iter().map(|row| row[k]).collect::<Vec<f64>>());
        case.given("strain", &column(0), span, "strains of its curve");
        case.given("tension_n", &column(1), span, "tensions of its curve");
        case.assumed("tension_interpolation", "\"linear\"", "as MoorDyn reads it");
    }
    let (model, fast, per_tension) = match &of.stiffness.value {
        Stiffness::Viscoelastic {
            fast, per_tension, ..
        } => ("viscoelastic", *fast, *per_tension),
        Stiffness::Syrope(rope) => ("syrope", rope.fast, rope.per_tension),
        Stiffness::Constant(_) | Stiffness::Table(_) => return,
    };
    case.given("creep_model", &text(model), span, "EA");
    if let Stiffness::Syrope(rope) = &of.stiffness.value {
        working_curve(case, rope, span);
    }
    case.given("dynamic_ea_n", &number_of(fast), span, "EA of fast motion");
    if per_tension != 0.0 {
        let growth = number_of(per_tension);
        case.given(
            "dynamic_ea_per_tension",
            &growth,
            span,
            "EA by the mean tension",
        );
    }
    if let Damping::Two(slow, fast) = of.damping.value {
        case.given(
            "slow_damping_n_s",
            &number_of(slow),
            &of.damping.span,
            "BA of slow motion",
        );
        if fast > 0.0 {
            case.given(
                "fast_damping_n_s",
                &number_of(fast),
                &of.damping.span,
                "BA of fast motion",
            );
        }
    }
}

/// The curve below the greatest past tension. A first parameter below 1 is a ratio of strains, above it a stiffness.
fn working_curve(case: &mut CaseText<'_>, rope: &Syrope, span: &Range<usize>) {
    let PolyesterCurve { form, k1, k2 } = rope.working_curve;
    let shape = match form {
        WorkingForm::Linear => "linear",
        WorkingForm::Quadratic => "quadratic",
        WorkingForm::Exponential => "exponential",
    };
    case.given("working_curve", &text(shape), span, "WCType");
    if form == WorkingForm::Linear && k1 >= 1.0 {
        case.given("working_curve_ea_n", &number_of(k1), span, "k1");
    } else {
        case.given("permanent_strain_ratio", &number_of(k1), span, "k1");
    }
    if form != WorkingForm::Linear {
        case.given("working_curve_shape", &number_of(k2), span, "k2");
    }
}
