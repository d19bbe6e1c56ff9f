//! Line types of a library of the user, in the form of MoorPy's: polynomials of the nominal diameter.
//!
//! As in MoorPy (`getLineProps`), with d in m and all in SI: mass is `mass_d2 d^2`; the breaking load `MBL_0 + MBL_d d + MBL_d2 d^2 +
//! MBL_d3 d^3`; the stiffness the same of `EA`, and `EA_MBL` times the breaking load; the outer diameter `dvol_dnom d` or that of a rod of
//! the material's `density`. Coefficients of drag are on the outer diameter.

use std::f64::consts::PI;

use super::law::short;
use super::properties::{NominalDiameterError, TypeDescription, checked, wet_weight};
use super::{LineProperties, OuterDiameter, Property};
use crate::case::Diagnostic;
use crate::number::digits;

/// A cubic polynomial of the nominal diameter and the diameters for which it holds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Polynomial {
    /// Coefficients of 1, d, d² and d³, in SI.
    pub coefficients: [f64; 4],
    /// The least diameter \[m\], if one is given.
    pub least: Option<f64>,
    /// The greatest diameter \[m\], if one is given.
    pub greatest: Option<f64>,
}

impl Polynomial {
    /// Its value at a diameter \[m\].
    #[must_use]
    pub fn value(&self, d: f64) -> f64 {
        let [a, b, c, e] = self.coefficients;
        a + d * (b + d * (c + d * e))
    }

    /// With its numbers, those that are 0 left out; empty where all are.
    #[must_use]
    pub fn formula(&self) -> String {
        let powers = ["", " d", " d^2", " d^3"];
        let terms = self.coefficients.iter().zip(powers);
        let mut text = String::new();
        for (value, power) in terms.filter(|(value, _)| **value != 0.0) {
            let sign = match (text.is_empty(), *value < 0.0) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            text += &format!("{sign}{}{power}", short(value.abs()));
        }
        text
    }
}

/// A line type of a library.
#[derive(Debug, Clone, PartialEq)]
pub struct LibraryType {
    /// Its name.
    pub name: String,
    /// Mass in air by the square of the diameter \[kg/m³\].
    pub mass: f64,
    /// Breaking load \[N\].
    pub break_load: Polynomial,
    /// Stiffness EA \[N\], without its share of the breaking load.
    pub ea: Polynomial,
    /// Stiffness by breaking load, N/N.
    pub ea_by_load: f64,
    /// Stiffness in motion by breaking load: a constant, and by the mean load as a share of the breaking load.
    pub dynamic: [f64; 2],
    /// The outer diameter.
    pub outer: OuterDiameter,
    /// Drag across and along, on the outer diameter.
    pub drag: [f64; 2],
    /// Added mass across and along, on the displaced volume.
    pub added_mass: [f64; 2],
}

/// A library of line types.
#[derive(Debug, Clone, PartialEq)]
pub struct Library {
    /// The file it comes from.
    pub file: String,
    /// Its types, in the order of the file.
    pub types: Vec<LibraryType>,
    /// Types of the file that have a fault, in its order.
    pub not_read: Vec<UnreadType>,
}

/// A type of a library that has a fault.
#[derive(Debug, Clone, PartialEq)]
pub struct UnreadType {
    /// Its name.
    pub name: String,
    /// What is wrong with it; nothing behind the first hundred of such types.
    pub faults: Vec<Diagnostic>,
}

impl Library {
    /// The type of this name, in letters of either case.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&LibraryType> {
        let same = |line: &&LibraryType| line.name.eq_ignore_ascii_case(name.trim());
        self.types.iter().find(same)
    }

    /// The type of this name that has a fault, in letters of either case.
    #[must_use]
    pub fn find_unread(&self, name: &str) -> Option<&UnreadType> {
        let same = |line: &&UnreadType| line.name.eq_ignore_ascii_case(name.trim());
        self.not_read.iter().find(same)
    }

    /// The properties of a type of it at a nominal diameter \[m\].
    ///
    /// # Errors
    /// The diameter is not positive, above 0.36 m or outside of those given; mass, stiffness or breaking load are not positive there.
    pub fn properties(
        &self,
        of: &LibraryType,
        nominal_m: f64,
    ) -> Result<LineProperties, NominalDiameterError> {
        let d = checked(nominal_m)?;
        of.holds_at(d)?;
        let source = || self.file.clone().into();
        let given = |value: f64, formula: String| Property {
            value,
            formula,
            source: source(),
        };
        let break_load = given(of.break_load.value(d), of.break_load.formula());
        let mass = given(of.mass * d * d, format!("{} d^2", short(of.mass)));
        let ea = of.ea.value(d) + of.ea_by_load * break_load.value;
        let ea = given(ea, of.ea_formula());
        let (diameter, outer) = match of.outer {
            OuterDiameter::Times(ratio) => (ratio * d, format!("{} d", digits(ratio, 4))),
            OuterDiameter::ByDensity(density) => (
                (4.0 * mass.value / (PI * density)).sqrt(),
                format!("sqrt(4 mass / (pi {density} kg/m^3))"),
            ),
        };
        let diameter = given(diameter, outer);
        of.positive(d, &[("mass", mass.value), ("stiffness EA", ea.value)])?;
        if of.break_load != Polynomial::default() {
            of.positive(d, &[("breaking load", break_load.value)])?;
        }
        let plain = |value: f64, on: &str| given(value, format!("{} {on}", digits(value, 4)));
        Ok(LineProperties {
            line_type: of.description(&self.file),
            nominal_m: d,
            wet_weight: wet_weight(&mass, diameter.value),
            drag_normal: plain(of.drag[0], "on D"),
            drag_tangential: plain(of.drag[1], "on D"),
            added_mass_normal: plain(of.added_mass[0], "of the displaced volume"),
            added_mass_tangential: plain(of.added_mass[1], "of the displaced volume"),
            proof_load: None,
            warning: None,
            diameter,
            mass,
            ea,
            break_load,
        })
    }
}

impl LibraryType {
    /// The formula of the stiffness.
    #[must_use]
    pub fn ea_formula(&self) -> String {
        let own = self.ea.formula();
        let by_load = format!("{} times the breaking load", short(self.ea_by_load));
        match (own.is_empty(), self.ea_by_load != 0.0) {
            (_, false) => own,
            (true, true) => by_load,
            (false, true) => format!("{own} + {by_load}"),
        }
    }

    fn description(&self, file: &str) -> TypeDescription {
        let [constant, by_load] = self.dynamic;
        // MoorPy has the mean load as a share of the breaking load, cases in percent of it.
        let dynamic = [constant, 0.01 * by_load];
        TypeDescription {
            name: self.name.clone().into(),
            title: self.name.clone().into(),
            nominal: "by which the library goes",
            dynamic_stiffness: (self.dynamic != [0.0; 2])
                .then(|| (dynamic, file.to_owned().into())),
            note: "".into(),
        }
    }

    /// Whether its polynomials are given for a diameter.
    fn holds_at(&self, d: f64) -> Result<(), NominalDiameterError> {
        let parts = [("breaking load", &self.break_load), ("stiffness", &self.ea)];
        for (what, law) in parts {
            let mm = |length: f64| digits(length * 1e3, 6);
            let error = |limit: String| {
                let (name, size) = (&self.name, mm(d));
                NominalDiameterError::new(format!(
                    "The {what} of {name} is given {limit} mm: {size} mm"
                ))
            };
            if let Some(least) = law.least.filter(|least| d < *least) {
                return Err(error(format!("from {}", mm(least))));
            }
            if let Some(greatest) = law.greatest.filter(|greatest| d > *greatest) {
                return Err(error(format!("up to {}", mm(greatest))));
            }
        }
        Ok(())
    }

    fn positive(&self, d: f64, values: &[(&str, f64)]) -> Result<(), NominalDiameterError> {
        let wrong = values
            .iter()
            .find(|(_, value)| !(*value > 0.0 && value.is_finite()));
        let Some((what, value)) = wrong else {
            return Ok(());
        };
        let size = digits(d * 1e3, 6);
        let name = &self.name;
        Err(NominalDiameterError::new(format!(
            "The {what} of {name} is {} at {size} mm by its coefficients",
            digits(*value, 4)
        )))
    }
}
