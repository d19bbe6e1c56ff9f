//! Names of what a value comes from, in the words of the file.
//!
//! The writers name columns as MoorDyn does; designs in YAML have keys in their place.

use crate::import::mooring::Program;

/// Columns of MoorDyn with the keys of RAFT and of the IEA ontology.
const KEYS: [(&str, &str, &str); 20] = [
    ("Diam", "diameter", "diameter"),
    ("Mass/m", "mass_density", "mass_density"),
    ("EA", "stiffness", "stiffness"),
    ("EI", "bending_stiffness", "bending_stiffness"),
    ("BA", "damping", "damping"),
    ("Cd", "transverse_drag", "transverse_drag"),
    ("CdAx", "tangential_drag", "tangential_drag"),
    ("Ca", "transverse_added_mass", "transverse_added_mass"),
    ("CaAx", "tangential_added_mass", "tangential_added_mass"),
    ("breaking load", "breaking_load", "breaking_load"),
    ("Attachment", "type", "node_type"),
    ("X Y Z", "location", "location"),
    ("X0 Y0 Z0", "x_location y_location", "location"),
    ("Mass", "mass", "node_mass"),
    ("Volume", "volume", "node_volume"),
    ("CdA", "drag_area", "drag_area"),
    ("LineType", "type", "line_type"),
    ("UnstrLen", "length", "unstretched_length"),
    ("WtrDpth", "water_depth", "water_depth"),
    ("rho", "", "water_density"),
];

/// Columns of MoorDyn with the keys of `FAModel`; of other columns rows alone are given.
const FAMODEL: [(&str, &str); 9] = [
    ("Diam", "d_vol"),
    ("Mass/m", "m"),
    ("EA", "EA"),
    ("breaking load", "MBL"),
    ("LineType", "type"),
    ("UnstrLen", "length"),
    ("WtrDpth", "water_depth"),
    ("rho", "rho_water"),
    ("X0 Y0 Z0", "x_location y_location"),
];

/// The name of a column in the words of a program.
#[must_use]
pub fn name(program: Program, column: &str) -> &str {
    if program == Program::FaModel {
        let of = FAMODEL.iter().find(|(name, _)| *name == column);
        return of.map_or("", |(_, key)| key);
    }
    let of = |(name, _, _): &&(&str, &str, &str)| *name == column;
    let found = KEYS.iter().find(of);
    match (program, found) {
        (Program::Raft, Some((_, key, _))) | (Program::Ontology, Some((_, _, key))) => key,
        _ => column,
    }
}
