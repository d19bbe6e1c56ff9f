//! Designs in YAML (JSON is a part of it): RAFT, the IEA ontology, arrays of `FAModel`, line-type libraries of MoorPy.
//!
//! [`load`] makes a tree of a text, in which every node knows its bytes; which format a file has is seen from its top keys.

pub mod array;
mod constants;
pub mod famodel;
pub mod famodel_fairleads;
pub mod famodel_lines;
pub mod famodel_rows;
pub mod joints;
pub mod library;
pub mod load;
pub mod mapping;
pub mod ontology;
pub mod ontology_types;
pub mod raft;
pub mod system;
pub mod tree;

use std::path::Path;

use self::mapping::Mapping;
use self::tree::YamlNode;
use super::fault::Fault;
use super::mooring::Mooring;
pub use constants::{DENSITY, GRAVITY};

/// Reads the mooring of a design. Files that it names are looked for in this folder.
///
/// # Errors
/// All that is wrong, in the order of the file; that it has no mooring that is read.
pub fn read(text: &str, folder: &Path) -> Result<Mooring, Vec<Fault>> {
    let (document, mut faults) = load::load(text).map_err(|fault| vec![fault])?;
    let read = match document.root() {
        Some(root) if root.is_mapping() => design(root, text, folder),
        Some(root) => Err(vec![no_design(&root)]),
        None => Err(Vec::new()),
    };
    match read {
        Ok(mooring) if faults.is_empty() => return Ok(mooring),
        Ok(_) => {}
        Err(found) => faults.extend(found),
    }
    faults.sort_by_key(|fault| fault.span.start);
    faults.dedup();
    Err(faults)
}

fn design(root: YamlNode<'_>, text: &str, folder: &Path) -> Result<Mooring, Vec<Fault>> {
    let has = |key: &str| root.get(key);
    let table = Mapping {
        node: root,
        path: String::new(),
    };
    if let Some(library) = has("lineProps") {
        return Err(vec![Fault::new(
            library.key_span(),
            "lineProps",
            "this is a library of line types, not a mooring",
            "`seacable lines --library FILE` shows its types",
        )]);
    }
    if has("components").is_some() {
        return ontology::read(&table);
    }
    if has("mooring_systems").is_some() || has("mooring_line_configs").is_some() {
        return famodel::read(&table, folder);
    }
    let raft = ["mooring", "moorings", "array_mooring", "array"];
    if raft.iter().any(|key| has(key).is_some()) {
        return raft::read(&table, text, folder);
    }
    if has("line_types").is_some() && has("lines").is_some() {
        return raft::read_table(&table, text, folder);
    }
    Err(vec![no_design(&root)])
}

/// A file without any of the tables that moorings are read from.
fn no_design(root: &YamlNode<'_>) -> Fault {
    Fault::new(
        root.span(),
        "",
        "this is none of the designs that are read",
        "looked for, at the top: `mooring` or `array` (RAFT), `components` with `mooring` (IEA ontology), `mooring_systems` (FAModel), `lineProps` (a library of MoorPy, \
         for `seacable lines --library`)",
    )
}
