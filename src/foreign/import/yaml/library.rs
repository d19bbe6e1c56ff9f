//! Libraries of line types of MoorPy: the table `lineProps`. A type that has a fault is named, and the others are read.

use super::load;
use super::mapping::Mapping;
use super::tree::{YamlNode, in_a_row, shortened};
use crate::case::Diagnostic;
use crate::import::fault::{self, Fault, GREATEST_FAULTS};
use crate::line_types::{Library, LibraryType, OuterDiameter, Polynomial, UnreadType};

/// Names of the stiffness in motion by the mean load: of `MoorPy` 1.2 and before, and of 1.3.
const BY_MEAN_LOAD: [&str; 2] = ["EAd_MBL_Lm", "EAD_LM"];

/// Coefficients that are read.
const COEFFICIENTS: [&str; 23] = [
    "mass_d2",
    "EA_0",
    "EA_d",
    "EA_d2",
    "EA_d3",
    "EA_dmin",
    "EA_dmax",
    "EA_MBL",
    "EAd_MBL",
    BY_MEAN_LOAD[0],
    BY_MEAN_LOAD[1],
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
/// It is no library, or none of its types can be read: all that is wrong, each at its row and column.
pub fn read(text: &str, file: &str) -> Result<Library, Vec<Diagnostic>> {
    let mut faults = Vec::new();
    let mut library = Library {
        file: in_a_row(file),
        types: Vec::new(),
        not_read: Vec::new(),
    };
    let shown = |mut faults: Vec<Fault>| {
        faults.sort_by_key(|fault| fault.span.start);
        fault::diagnostics(faults, file, text)
    };
    match load::load(text) {
        Ok((document, duplicates)) => {
            faults.extend(duplicates);
            types(document.root(), &mut faults, &mut |name, read| match read {
                Ok(of) => library.types.push(of),
                Err(faults) => {
                    let is_shown = library.not_read.len() < GREATEST_FAULTS;
                    let faults = if is_shown { shown(faults) } else { Vec::new() };
                    library.not_read.push(UnreadType { name, faults });
                }
            });
        }
        Err(fault) => faults.push(fault),
    }
    if faults.is_empty() && !library.types.is_empty() {
        return Ok(library);
    }
    let mut all = shown(faults);
    all.extend(library.not_read.into_iter().flat_map(|of| of.faults));
    all.sort_by_key(|fault| fault.span.start);
    Err(all)
}

/// Reads the types one by one; `faults` are those of the table as a whole.
fn types(
    root: Option<YamlNode<'_>>,
    faults: &mut Vec<Fault>,
    put: &mut dyn FnMut(String, Result<LibraryType, Vec<Fault>>),
) {
    let Some(root) = root.and_then(|root| Mapping::of_node(root, "", faults)) else {
        return;
    };
    let remedy = "a library of MoorPy has a table `lineProps` with the coefficients of each type";
    let Some(table) = root.mapping("lineProps", remedy, faults) else {
        return;
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
    for (name, node) in entries {
        let mut own = Vec::new();
        let row = Mapping::of_node(node, table.key(&shortened(name)), &mut own);
        let read = row.and_then(|row| line_type(name, &row, &mut own));
        let read = read.filter(|_| own.is_empty());
        put(in_a_row(name), read.ok_or(own));
    }
}

fn line_type(name: &str, row: &Mapping<'_>, faults: &mut Vec<Fault>) -> Option<LibraryType> {
    unknown(row, faults);
    if let [Some(_), Some(second)] = BY_MEAN_LOAD.map(|key| row.get(key)) {
        let [before, now] = BY_MEAN_LOAD;
        let problem = format!("`{before}` and `{now}` are two names of the same coefficient");
        let at = second.key_span();
        faults.push(Fault::new(at, row.key(now), problem, "leave one"));
    }
    let mut value = |key: &str| {
        let given = row.optional(key, faults).flatten();
        given.map_or(0.0, |given| given.value)
    };
    let ea_by_load = value("EA_MBL");
    let dynamic = ["EAd_MBL", mean_load_key(row)].map(&mut value);
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

/// The name under which a type has its stiffness in motion by the mean load.
fn mean_load_key(row: &Mapping<'_>) -> &'static str {
    let [before, now] = BY_MEAN_LOAD;
    match row.get(now) {
        Some(_) => now,
        None => before,
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
