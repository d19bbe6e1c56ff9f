//! A case of one line between two ends as a system of one line.
//!
//! What both kinds of file have is copied with the expressions in it; ends become points, sections with floats, modules and clumps those of the line
//! `line`, clumps at an end the body of the point there, a body that travels a point hauled between two lines. What acts and a system cannot state is a fault at its key; what only concerns
//! other views of the case is a remark in the notes.

mod bearing;
mod channels;
mod comments;
mod copied;
mod end_clumps;
mod ends;
mod line;
mod lines;
mod marks;
mod paths;
mod payload;
mod places;
mod published;
mod refused;
mod results;
mod run;
mod source;
mod start;
mod traveller;
mod trials;
mod turning_payload;
mod unused;

use std::path::Path;

use self::copied::copy;
use self::source::LineSource;
use self::trials::CarriedTrials;
use super::fault::{self, Fault};
use super::imported::Imported;
use super::to_case::case_text::{CaseText, block, text};
use crate::case::{self, Diagnostic};
use crate::kinds::FileType;
use crate::visible;

/// Whether a text is that of a case of one line.
#[must_use]
pub fn is_line_case(text: &str) -> bool {
    let header = format!("[{}]", FileType::Line.table());
    let mut lines = text.lines().map(str::trim_start);
    FileType::of_text(text) == FileType::Line && lines.any(|line| line.starts_with(&header))
}

/// The system of the line of a case with this text, whose file this is.
///
/// # Errors
/// Everything that is wrong with the case, or that acts in it and a system cannot state, each at its key.
pub fn read(case_text: &str, path: &Path) -> Result<Imported, Vec<Diagnostic>> {
    let case = case::parse_of(case_text, path)?;
    let file = visible::path(path);
    let source = LineSource::new(case_text, case);
    let mut imported =
        system_of(&source).map_err(|faults| fault::diagnostics(faults, &file, case_text))?;
    comments::put(&mut imported, &source);
    Ok(imported)
}

fn system_of(source: &LineSource<'_>) -> Result<Imported, Vec<Fault>> {
    let mut faults = refused::faults(source);
    faults.extend(results::faults(source));
    faults.extend(end_clumps::faults(source));
    if !faults.is_empty() {
        faults
            .sort_by(|one, other| (one.span.start, &one.key).cmp(&(other.span.start, &other.key)));
        faults.dedup();
        return Err(faults);
    }
    let mut system = CaseText::of_text(source.text);
    let trials = CarriedTrials::new(source);
    head(&mut system, source, &trials);
    copy(&mut system, source, "parameters");
    run::environment(&mut system, source);
    copy(&mut system, source, "current");
    run::waves(&mut system, source);
    copy(&mut system, source, "seabed");
    materials(&mut system, source);
    ends::write(&mut system, source);
    traveller::write_point(&mut system, source);
    line::write(&mut system, source);
    traveller::write_hauling(&mut system, source);
    start::of_ends(&mut system, source);
    run::write(&mut system, source);
    results::write(&mut system, source);
    trials.write(&mut system, source);
    copied::files(&mut system, source);
    Ok(Imported {
        text: system.text,
        from: system.from,
        beside: None,
        keys: source.keys(),
    })
}

/// Writes the materials of the line.
fn materials(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    for name in source.case.materials.keys() {
        if let Some(node) = source.node(&["materials", name]) {
            let header = format!("[materials.{}]", copied::bare(name));
            copied::copy_table(system, source, &header, node, &[]);
        }
    }
}

/// The table `[system]`: what the case is, and what of it is not carried over.
fn head(system: &mut CaseText<'_>, source: &LineSource<'_>, trials: &CarriedTrials) {
    let Some(node) = source.node(&["case"]) else {
        return;
    };
    system.table("[system]", Some(&node.span));
    let mut notes = unused::remarks(source, trials).join(" ");
    for entry in node.entries() {
        let mut value = copied::value_of(source, &entry.node);
        if entry.key == "notes" && !notes.is_empty() {
            let own = source.case.case.notes.trim();
            let between = if own.contains('\n') { "\n" } else { " " };
            value = block(&format!("{own}{between}{}", std::mem::take(&mut notes)));
        }
        system.given(&entry.key, &value, &entry.node.span, "");
    }
    if !notes.is_empty() {
        system.line(&format!("notes = {}", text(&notes)), None);
    }
}
