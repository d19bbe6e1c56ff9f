//! The properties of a line type at a nominal diameter.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::fmt;

use super::{Coefficient, Family, LineType, OuterDiameter, Sourced};
use crate::case::Material;
use crate::case::fields::TypedNumber;
use crate::number::digits;

/// Greatest nominal diameter \[m\] that is computed with: breaking loads of chain fall beyond 0.36 m.
const GREATEST: f64 = 0.36;

/// Density of sea water \[kg/m^3\] for the weight in water that is shown; a case computes with its own.
const SEA_WATER: f64 = 1025.0;

/// A property with its formula and source.
#[derive(Debug, Clone, PartialEq)]
pub struct Property {
    /// Its value, in SI.
    pub value: f64,
    /// How it is computed, d being the nominal diameter in m and D the outer one.
    pub formula: String,
    /// The publication or file.
    pub source: Cow<'static, str>,
}

/// What a line type is, apart from its properties.
#[derive(Debug, Clone, PartialEq)]
pub struct TypeDescription {
    /// Its name, `chain-r4-studless`.
    pub name: Cow<'static, str>,
    /// What it is, in words.
    pub title: Cow<'static, str>,
    /// What the nominal diameter is that of, in words.
    pub nominal: &'static str,
    /// Stiffness in motion by breaking load, `alpha + beta Lm`, with the mean tension Lm in percent of it, and its source.
    pub dynamic_stiffness: Option<([f64; 2], Cow<'static, str>)>,
    /// What a user should know of it; may be empty.
    pub note: Cow<'static, str>,
}

impl TypeDescription {
    /// That of a type of the table.
    #[must_use]
    pub fn of_line_type(line_type: &LineType) -> Self {
        let nominal = match line_type.family {
            Family::Chain => "the diameter of the bar",
            Family::Wire => "the diameter of the steel",
            Family::Fibre => "the diameter of the rope",
        };
        let dynamic = line_type.dynamic_stiffness;
        Self {
            name: line_type.name.into(),
            title: line_type.title.into(),
            nominal,
            dynamic_stiffness: dynamic.map(|of| (of.value, of.source.into())),
            note: line_type.note.into(),
        }
    }
}

/// A line type at a nominal diameter. Coefficients are on the outer, volume-equivalent diameter.
#[derive(Debug, Clone, PartialEq)]
pub struct LineProperties {
    /// The type.
    pub line_type: TypeDescription,
    /// Nominal diameter \[m\].
    pub nominal_m: f64,
    /// Outer diameter D by which drag, buoyancy and added mass act \[m\].
    pub diameter: Property,
    /// Mass in air \[kg/m\].
    pub mass: Property,
    /// Mass less displaced sea water of 1025 kg/m^3 \[kg/m\].
    pub wet_weight: Property,
    /// Axial stiffness EA \[N\].
    pub ea: Property,
    /// Minimum breaking load \[N\].
    pub break_load: Property,
    /// Proof load \[N\], of chain.
    pub proof_load: Option<Property>,
    /// Normal drag coefficient on D.
    pub drag_normal: Property,
    /// Tangential drag coefficient on D.
    pub drag_tangential: Property,
    /// Added mass coefficient across the line, on the displaced volume.
    pub added_mass_normal: Property,
    /// Added mass coefficient along the line, on the displaced volume.
    pub added_mass_tangential: Property,
    /// What to know of this size: it lies outside the range of the type.
    pub warning: Option<String>,
}

/// A nominal diameter that cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NominalDiameterError {
    /// What is wrong, and what to do.
    message: String,
}

impl fmt::Display for NominalDiameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for NominalDiameterError {}

impl NominalDiameterError {
    pub(super) fn new(message: String) -> Self {
        Self { message }
    }
}

/// The nominal diameter \[m\] of a text: `120mm`, `0.12 m`, `0.12`.
///
/// # Errors
/// No number, no unit of length, or a diameter that is not positive and at most 0.36 m.
pub fn nominal_diameter(text: &str) -> Result<f64, NominalDiameterError> {
    let read = TypedNumber::read(text, "m");
    let value = match read {
        Some(TypedNumber::Plain(value) | TypedNumber::Converted(value)) => Some(value),
        _ => None,
    };
    checked(value.unwrap_or(f64::NAN)).map_err(|_| NominalDiameterError {
        message: format!(
            "The nominal diameter is a length above 0 and up to {GREATEST} m, such as 120mm or 0.12: `{}`",
            text.trim()
        ),
    })
}

pub(super) fn checked(diameter: f64) -> Result<f64, NominalDiameterError> {
    // Below a micrometre a material's stiffness and mass would underflow.
    if (1e-6..=GREATEST).contains(&diameter) {
        return Ok(diameter);
    }
    Err(NominalDiameterError {
        message: format!("The nominal diameter is above 0 and up to {GREATEST} m: {diameter} m"),
    })
}

/// The properties of a line type at a nominal diameter \[m\].
///
/// # Errors
/// The diameter is not positive, or above 0.36 m, from where breaking loads of chain fall.
pub fn properties(
    line_type: &LineType,
    nominal_m: f64,
) -> Result<LineProperties, NominalDiameterError> {
    let d = checked(nominal_m)?;
    let break_load = line_type.break_load.value.value(d, 0.0);
    let by_law = |law: &Sourced<super::DiameterLaw>| Property {
        value: law.value.value(d, break_load),
        formula: law.value.formula(),
        source: law.source.into(),
    };
    let mass = by_law(&line_type.mass);
    let diameter = outer(line_type, d, mass.value);
    let ratio = diameter.value / d;
    Ok(LineProperties {
        line_type: TypeDescription::of_line_type(line_type),
        nominal_m: d,
        wet_weight: wet_weight(&mass, diameter.value),
        ea: by_law(&line_type.ea),
        break_load: by_law(&line_type.break_load),
        proof_load: line_type.proof_load.as_ref().map(by_law),
        drag_normal: on_outer(line_type.drag_normal, ratio),
        drag_tangential: on_outer(line_type.drag_tangential, ratio),
        added_mass_normal: on_volume(line_type.added_mass_normal),
        added_mass_tangential: on_volume(line_type.added_mass_tangential),
        warning: outside(line_type, d),
        diameter,
        mass,
    })
}

/// Mass less that of the displaced sea water, with an outer diameter \[m\].
pub(super) fn wet_weight(mass: &Property, diameter: f64) -> Property {
    let displaced = 0.25 * PI * diameter.powi(2);
    Property {
        value: mass.value - SEA_WATER * displaced,
        formula: "mass - 1025 pi/4 D^2".to_owned(),
        source: mass.source.clone(),
    }
}

fn outer(line_type: &LineType, nominal: f64, mass: f64) -> Property {
    let (value, formula) = match line_type.outer.value {
        OuterDiameter::Times(ratio) => (ratio * nominal, format!("{} d", digits(ratio, 4))),
        OuterDiameter::ByDensity(density) => (
            (4.0 * mass / (PI * density)).sqrt(),
            format!("sqrt(4 mass / (pi {density} kg/m^3))"),
        ),
    };
    Property {
        value,
        formula,
        source: line_type.outer.source.into(),
    }
}

/// A drag coefficient on the nominal diameter as one on the outer diameter, for the same force.
fn on_outer(coefficient: Coefficient, ratio: f64) -> Property {
    let formula = match coefficient.value > 0.0 {
        true => format!("{} d/D", digits(coefficient.value, 4)),
        false => "none given".to_owned(),
    };
    Property {
        value: coefficient.value / ratio,
        formula,
        source: coefficient.source.into(),
    }
}

fn on_volume(coefficient: Coefficient) -> Property {
    Property {
        value: coefficient.value,
        formula: format!("{} of the displaced volume", digits(coefficient.value, 4)),
        source: coefficient.source.into(),
    }
}

fn outside(line_type: &LineType, nominal: f64) -> Option<String> {
    let [least, greatest] = line_type.diameters_m;
    let mm = |length: f64| digits(length * 1e3, 6);
    (!(least..=greatest).contains(&nominal)).then(|| {
        format!(
            "{} mm is outside of {} to {} mm, in which {} is made: its formulas are extrapolated.",
            mm(nominal),
            mm(least),
            mm(greatest),
            line_type.name
        )
    })
}

impl LineProperties {
    /// The material of a case; what the library has no value for is as in a file that leaves it out.
    #[must_use]
    pub fn material(&self) -> Material {
        let mut material = Material::new(self.diameter.value, self.mass.value, self.ea.value);
        let constant = crate::case::DragCoefficient::Constant;
        material.break_load_n = Some(self.break_load.value);
        material.drag_normal = constant(self.drag_normal.value);
        material.drag_tangential = constant(self.drag_tangential.value);
        material.added_mass_normal = self.added_mass_normal.value;
        material.added_mass_tangential = self.added_mass_tangential.value;
        material
    }
}
