//! Libraries of line types of MoorPy: the table `lineProps`.

use super::load;
use super::mapping::Mapping;
use super::tree::{Node, in_a_row, shortened};
use crate::case::Diagnostic;
use crate::import::fault::Fault;
use crate::line_types::{Library, LibraryType, OuterDiameter, Polynomial};

/// Coefficients that are read.
const COEFFICIENTS: [&str; 22] = [
    "mass_d2",
    "EA_0",
    "EA_d",
    "EA_d2",
    "EA_d3",
    "EA_dmin",
    "EA_dmax",
    "EA_MBL",
    "EAd_MBL",
    "EAd_MBL_Lm",
    "MBL_0",
    "MBL_d",
    "MBL_d2",
    "MBL_d3",
    "MBL_dmin",
    "MBL_dmax",
    "dvol_dnom",
    "density",
    "Cd",
    "Cd_ax",
    "Ca",
    "Ca_ax",
];

/// Reads a library; `file` is its name in diagnostics and as a source.
///
/// # Errors
/// All that is wrong, each at its row and column.
pub fn read(text: &str, file: &str) -> Result<Library, Vec<Diagnostic>> {
    let mut faults = Vec::new();
    let types = match load::load(text) {
        Ok((document, duplicates)) => {
            faults.extend(duplicates);
            types(document.root(), &mut faults)
        }
        Err(fault) => {
            faults.push(fault);
            Vec::new()
        }
    };
    if faults.is_empty() {
        return Ok(Library {
            file: in_a_row(file),
            types,
        });
    }
    faults.sort_by_key(|fault| fault.span.start);
    Err(super::first(faults)
        .iter()
        .map(|fault| fault.diagnostic(file, text))
        .collect())
}

fn types(root: Option<Node<'_>>, faults: &mut Vec<Fault>) -> Vec<LibraryType> {
    let Some(root) = root.and_then(|root| Mapping::of(root, "", faults)) else {
        return Vec::new();
    };
    let remedy = "a library of MoorPy has a table `lineProps` with the coefficients of each type";
    let Some(table) = root.mapping("lineProps", remedy, faults) else {
        return Vec::new();
    };
    let entries = table.node.entries().unwrap_or_default();
    if entries.is_empty() {
        let problem = "the library has no types";
        faults.push(Fault::new(
            table.node.key_span(),
            "lineProps",
            problem,
            remedy,
        ));
    }
    let mut types = Vec::new();
    for (name, node) in entries {
        let path = table.key(&shortened(name));
        let row = Mapping::of(node, path, faults);
        types.extend(row.and_then(|row| line_type(name, &row, faults)));
    }
    types
}

fn line_type(name: &str, row: &Mapping<'_>, faults: &mut Vec<Fault>) -> Option<LibraryType> {
    unknown(row, faults);
    let mut value = |key: &str| {
        let given = row.optional(key, faults).flatten();
        given.map_or(0.0, |given| given.value)
    };
    let ea_by_load = value("EA_MBL");
    let dynamic = ["EAd_MBL", "EAd_MBL_Lm"].map(&mut value);
    let drag = ["Cd", "Cd_ax"].map(&mut value);
    let added_mass = ["Ca", "Ca_ax"].map(&mut value);
    let mass = row.positive("mass_d2", faults);
    let break_load = polynomial("MBL", row, faults);
    let ea = polynomial("EA", row, faults);
    let outer = outer(row, faults);
    if ea == Polynomial::default() && ea_by_load == 0.0 {
        let problem = "there is no coefficient of the stiffness";
        let span = row.node.key_span();
        faults.push(Fault::new(
            span,
            row.key("EA_d2"),
            problem,
            "give EA_d2 or EA_MBL",
        ));
    }
    Some(LibraryType {
        name: in_a_row(name),
        mass: mass?.value,
        break_load,
        ea,
        ea_by_load,
        dynamic,
        outer: outer?,
        drag,
        added_mass,
    })
}

/// The polynomial of the keys `EA_0`, `EA_d` and so on. Limits below 0 are none.
fn polynomial(of: &str, row: &Mapping<'_>, faults: &mut Vec<Fault>) -> Polynomial {
    let mut given = |end: &str| {
        let given = row.optional(&format!("{of}_{end}"), faults).flatten();
        given.map(|given| given.value)
    };
    let coefficients = ["0", "d", "d2", "d3"].map(|end| given(end).unwrap_or(0.0));
    Polynomial {
        coefficients,
        least: given("dmin").filter(|limit| *limit >= 0.0),
        greatest: given("dmax").filter(|limit| *limit >= 0.0),
    }
}

fn outer(row: &Mapping<'_>, faults: &mut Vec<Fault>) -> Option<OuterDiameter> {
    let ratio = row.optional_positive("dvol_dnom", faults)?;
    let density = row.optional_positive("density", faults)?;
    match (ratio, density) {
        (Some(_), Some(density)) => {
            let problem = "the outer diameter is given twice, by `dvol_dnom` and by `density`";
            faults.push(Fault::new(
                density.span,
                row.key("density"),
                problem,
                "leave one",
            ));
            None
        }
        (_, Some(density)) => Some(OuterDiameter::ByDensity(density.value)),
        (Some(ratio), None) => Some(OuterDiameter::Times(ratio.value)),
        (None, None) => Some(OuterDiameter::Times(1.0)),
    }
}

/// Numbers under other keys: those of costs have no use here, all others are at fault.
fn unknown(row: &Mapping<'_>, faults: &mut Vec<Fault>) {
    for (key, node) in row.others(&COEFFICIENTS) {
        if key.starts_with("cost") || node.number().is_none() {
            continue;
        }
        let name = shortened(key);
        let remedy = match crate::case::nearest(key, COEFFICIENTS) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("coefficients are {}", COEFFICIENTS.join(", ")),
        };
        let problem = format!("`{name}` is not a coefficient of a line type");
        faults.push(Fault::new(node.key_span(), row.key(&name), problem, remedy));
    }
}
