//! Input files of `CableDyn` (SMI-Lab-Inha): the tables of MoorDyn of its second version, with lines of several sections, points without
//! masses, bodies of its own columns, and options of its own.
//!
//! As its documentation has it (doc/driver_format.md, doc/options.rst of version 0.3).

pub mod bodies;
pub mod lines;
pub mod options;

use self::bodies::{on_one_point, read_bodies};
use self::lines::{on_rods, read_lines, read_points};
use super::fault::Fault;
use super::moordyn::events;
use super::moordyn::files::Files;
use super::moordyn::line_types::{read_line_types, read_rod_types};
use super::moordyn::loads;
use super::moordyn::parts::read_rods;
use super::moordyn::sections::{SectionBlock, SectionTitle, Sections};
use super::mooring::{Mooring, Program, Unmodelled};
use super::words::Row;

/// Rows before the tables that may name the program.
const TITLE_ROWS: usize = 4;

/// Whether a file is one of `CableDyn`: its banner says so, its lines have sections, or its line types the names of its coefficients.
#[must_use]
pub fn is_cable_dyn(text: &str, sections: &Sections<'_>) -> bool {
    let is_banner = |line: &str| {
        line.trim_start().starts_with("---") && line.to_lowercase().contains("cabledyn")
    };
    let types = sections.block(SectionTitle::LineTypes);
    let mut header = types.iter().flat_map(|block| block.rows.iter().take(1));
    let names_own = header.any(|row| row.words().iter().any(|word| word.is("Cd_n")));
    text.lines().take(TITLE_ROWS).any(is_banner)
        || sections.block(SectionTitle::LineSections).is_some()
        || names_own
}

/// The sections without what follows `--` at the beginning of a word, which is a remark.
#[must_use]
pub fn without_remarks<'t>(sections: Sections<'t>) -> Sections<'t> {
    let cut = |row: Row<'t>| {
        let begins = row.text.trim_start().starts_with("--");
        let at = match begins {
            true => Some(0),
            false => row.text.find(" --").or_else(|| row.text.find("\t--")),
        };
        Row {
            text: at.map_or(row.text, |at| &row.text[..at]),
            ..row
        }
    };
    let blocks = sections.blocks.into_iter().map(|block| SectionBlock {
        rows: block.rows.into_iter().map(cut).collect(),
        ..block
    });
    Sections {
        blocks: blocks.collect(),
        ..sections
    }
}

/// The tables in the order in which they name each other.
pub fn assembled(
    mut mooring: Mooring,
    sections: &Sections<'_>,
    files: &Files<'_>,
    faults: &mut Vec<Fault>,
) -> Mooring {
    let block = |section| sections.block(section);
    mooring.program = Program::CableDyn;
    if let Some(types) = block(SectionTitle::LineTypes) {
        read_line_types(types, files, &mut mooring, faults);
    }
    if let Some(types) = block(SectionTitle::RodTypes) {
        read_rod_types(types, &mut mooring, faults);
    }
    let buoys = block(SectionTitle::Bodies).map(|rows| read_bodies(rows, &mut mooring, faults));
    if let Some(rods) = block(SectionTitle::Rods) {
        read_rods(rods, &mut mooring, faults);
    }
    if let Some(rows) = block(SectionTitle::ExternalLoads) {
        loads::read(rows, &mut mooring, faults);
    }
    let at_rods = block(SectionTitle::Points).map(|rows| read_points(rows, &mut mooring, faults));
    if let Some(lines) = block(SectionTitle::Lines) {
        let pieces = block(SectionTitle::LineSections);
        read_lines(lines, pieces, &mut mooring, faults);
    }
    on_rods(&mut mooring, &at_rods.unwrap_or_default());
    on_one_point(&mut mooring, &buoys.unwrap_or_default(), faults);
    if let Some(failures) = block(SectionTitle::Failure) {
        events::read_failures(failures, &mut mooring, faults);
    }
    if let Some(past) = block(SectionTitle::SyropeIc) {
        events::read_past(past, &mut mooring, faults);
    }
    for (section, name, what) in UNMODELLED {
        if let Some(rows) = block(section) {
            events::read_unmodelled(rows, name, what, &mut mooring);
        }
    }
    if let Some(rows) = block(SectionTitle::Options) {
        options::read(rows, files, &mut mooring, faults);
    }
    mooring
}

/// Sections that are not modelled, with the name by which they are left out.
const UNMODELLED: [(SectionTitle, &str, &str); 5] = [
    (
        SectionTitle::EndConnections,
        "clamps",
        "ends of lines that are clamped or turn against a stiffness (END CONNECTIONS)",
    ),
    (
        SectionTitle::Control,
        "control",
        "lines that another program's controller drives",
    ),
    (
        SectionTitle::EquivalentBuoyancy,
        "",
        "buoyancy modules that are spread along sections (EQUIVALENT BUOYANCY)",
    ),
    (
        SectionTitle::LineAttachments,
        "",
        "clumps and floats on lines (ATTACHMENTS)",
    ),
    (
        SectionTitle::Turbines,
        "",
        "turbines of an array (TURBINES)",
    ),
];

/// A part that is not modelled, at bytes of the file.
fn unmodelled(
    name: &'static str,
    span: std::ops::Range<usize>,
    key: &str,
    what: String,
) -> Unmodelled {
    Unmodelled {
        name,
        span,
        key: key.to_owned(),
        what,
    }
}
