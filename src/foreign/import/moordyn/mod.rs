//! Input files of MoorDyn, of its first and second version, and of MoorPy, which have the same form.
//!
//! Tables are read by the order of their columns, as the program reads them; headers must name them in that order.

pub mod elevation;
pub mod events;
pub mod files;
pub mod holds;
pub mod line_types;
pub mod loads;
pub mod options;
pub mod parts;
pub mod sections;
pub mod table;
pub mod water_kinematics;

use std::path::Path;

use self::files::Files;
use self::sections::{SectionTitle, Sections};
use super::fault::{Fault, without_followers};
use super::mooring::{Hold, Mooring, MooringPoint, Program};
use super::size;
use super::words::Row;
use super::{cable_dyn, map_plus_plus};

/// Reads a file. Files that it names are looked for in this folder.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read(text: &str, folder: &Path) -> Result<Mooring, Vec<Fault>> {
    read_into(Mooring::new(Program::MoorDyn), text, 0, folder)
}

/// Reads a file whose first byte is counted as `start` into a mooring that may have bodies, which points can be on.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read_into(
    mooring: Mooring,
    text: &str,
    start: usize,
    folder: &Path,
) -> Result<Mooring, Vec<Fault>> {
    // Some editors put a mark of the encoding before the first letter.
    let (text, start) = match text.strip_prefix('\u{feff}') {
        Some(rest) => (rest, start + '\u{feff}'.len_utf8()),
        None => (text, start),
    };
    let sections = Sections::of_text(text, start);
    let too_large = size::check(&sections);
    if !too_large.is_empty() {
        return Err(too_large);
    }
    if map_plus_plus::is_map(&sections) {
        return map_plus_plus::read(&sections);
    }
    let of_cables = cable_dyn::is_cable_dyn(text, &sections);
    let sections = match of_cables {
        true => cable_dyn::without_remarks(sections),
        false => sections,
    };
    let mut faults = sections.faults.clone();
    let mut mooring = mooring;
    mooring.title = title(&sections.head);
    let files = Files { folder };
    let mut mooring = match of_cables {
        true => cable_dyn::assembled(mooring, &sections, &files, &mut faults),
        false => assembled(mooring, &sections, &files, &mut faults),
    };
    faults.extend(missing_sections(&mooring, &sections));
    if sections
        .block(SectionTitle::Outputs)
        .is_some_and(|block| !block.rows.is_empty())
    {
        mooring.passed_over.push("OUTPUTS".to_owned());
    }
    if faults.is_empty() && mooring.lines.is_empty() && !has_bodies(&mooring) {
        faults.push(nothing_moves(&sections));
    }
    if faults.is_empty() {
        return Ok(mooring);
    }
    without_followers(&mut faults);
    faults.sort_by_key(|fault| fault.span.start);
    faults.dedup();
    Err(faults)
}

/// Sections that a file needs and does not have.
fn missing_sections(mooring: &Mooring, sections: &Sections<'_>) -> Vec<Fault> {
    let has_lines_alone = mooring.rods.is_empty() && mooring.bodies.is_empty();
    let has_lines = sections.block(SectionTitle::Lines).is_some();
    let needed = [
        (SectionTitle::Points, has_lines_alone),
        (SectionTitle::Lines, has_lines_alone),
        (SectionTitle::LineTypes, has_lines),
    ];
    let missing = needed
        .into_iter()
        .filter(|(section, needed)| *needed && sections.block(*section).is_none());
    let fault = |(section, _): (SectionTitle, bool)| {
        Fault::new(
            0..0,
            section.title(),
            format!("there is no section {}", section.title()),
            "a mooring has LINE TYPES, POINTS and LINES",
        )
    };
    missing.map(fault).collect()
}

/// The fault of a file without lines in which nothing moves.
fn nothing_moves(sections: &Sections<'_>) -> Fault {
    let block = sections.block(SectionTitle::Lines);
    Fault::new(
        block.map_or(0..0, |block| block.span.clone()),
        "LINES",
        "the file has no lines, and no body or rod that is free, pinned or coupled",
        "add a line: nothing in the file moves or comes to an equilibrium",
    )
}

/// Whether a body, or a rod with a length, moves or comes to an equilibrium.
fn has_bodies(mooring: &Mooring) -> bool {
    let bodies = mooring.bodies.iter().map(|body| &body.hold.value);
    let rods = mooring.rods.iter().filter(|rod| !rod.is_joint());
    let mut holds = bodies.chain(rods.map(|rod| &rod.hold.value));
    holds.any(|hold| !matches!(hold, Hold::Fixed | Hold::Body(_)))
}

/// The tables in the order in which they name each other.
fn assembled(
    mut mooring: Mooring,
    sections: &Sections<'_>,
    files: &Files<'_>,
    faults: &mut Vec<Fault>,
) -> Mooring {
    let block = |section| sections.block(section);
    let first = block(SectionTitle::LineTypes).is_some_and(line_types::is_first_version);
    mooring.program = match first {
        true => Program::MoorDyn1,
        false => Program::MoorDyn,
    };
    if let Some(types) = block(SectionTitle::LineTypes) {
        line_types::read_line_types(types, files, &mut mooring, faults);
    }
    if let Some(types) = block(SectionTitle::RodTypes) {
        line_types::read_rod_types(types, &mut mooring, faults);
    }
    if let Some(bodies) = block(SectionTitle::Bodies) {
        parts::read_bodies(bodies, &mut mooring, faults);
    }
    if let Some(rods) = block(SectionTitle::Rods) {
        parts::read_rods(rods, &mut mooring, faults);
    }
    if let Some(points) = block(SectionTitle::Points) {
        parts::read_points(points, &mut mooring, faults);
    }
    if let Some(lines) = block(SectionTitle::Lines) {
        parts::read_lines(lines, &mut mooring, faults);
    }
    if let Some(failures) = block(SectionTitle::Failure) {
        events::read_failures(failures, &mut mooring, faults);
    }
    if let Some(past) = block(SectionTitle::SyropeIc) {
        events::read_past(past, &mut mooring, faults);
    }
    if let Some(rows) = block(SectionTitle::Control) {
        let what = "lines that another program's controller drives";
        events::read_unmodelled(rows, "control", what, &mut mooring);
    }
    if let Some(rows) = block(SectionTitle::ExternalLoads) {
        loads::read(rows, &mut mooring, faults);
    }
    if let Some(rows) = block(SectionTitle::Options) {
        options::read_options(rows, files, &mut mooring, faults);
    }
    without_depth(&mut mooring);
    mooring
}

/// Takes a depth of 0 for one that is not given, as `MoorDyn` does, which then has the bed at the deepest fixed point.
fn without_depth(mooring: &mut Mooring) {
    let is_below =
        |point: &MooringPoint| point.hold.value == Hold::Fixed && point.place[2].value < 0.0;
    let is_zero = mooring
        .sea
        .depth
        .as_ref()
        .is_some_and(|depth| depth.value == 0.0);
    if is_zero && mooring.points.iter().any(is_below) {
        mooring.sea.depth = None;
        let remark = "A depth of 0 m is that of the deepest fixed point, as MoorDyn takes it.";
        mooring.remarks.push(remark.to_owned());
    }
}

/// The first row before the tables that says something.
fn title(head: &[Row<'_>]) -> String {
    let words = |row: &Row<'_>| row.text.split_whitespace().collect::<Vec<_>>().join(" ");
    let is_title = |text: &String| {
        text.chars().any(char::is_alphabetic) && !text.to_lowercase().contains("echo ")
    };
    head.iter().map(words).find(is_title).unwrap_or_default()
}
