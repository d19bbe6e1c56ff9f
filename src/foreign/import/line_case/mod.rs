//! A case of one line between two ends as a system of one line.
//!
//! What both kinds of file have is copied with the expressions in it; ends become points, sections those of the line `line`, floats and modules
//! materials of their sections, a body that travels a point hauled between two lines, clumps bodies where sections meet, or of the point at the
//! end that they hang on. What acts and a system cannot state is a fault at its key; what only concerns
//! other views of the case is a remark in the notes.

mod bearing;
mod buoyed;
mod channels;
mod copied;
mod end_clumps;
mod ends;
mod line;
mod paths;
mod payload;
mod refused;
mod results;
mod run;
mod source;
mod start;
mod stretches;
mod traveller;
mod turning_payload;
mod unused;

use std::path::Path;

use self::copied::copy;
use self::source::LineSource;
use self::stretches::stretches;
use super::fault::{self, Fault};
use super::imported::Imported;
use super::to_case::case_text::{CaseText, text};
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
    system_of(&source).map_err(|faults| fault::diagnostics(faults, &file, case_text))
}

fn system_of(source: &LineSource<'_>) -> Result<Imported, Vec<Fault>> {
    let mut faults = refused::faults(source);
    let mut line = stretches(source).unwrap_or_else(|found| {
        faults.extend(found);
        Vec::new()
    });
    if !line.is_empty() {
        faults.extend(traveller::part_line(source, &mut line));
    }
    faults.extend(results::faults(source, &line));
    faults.extend(end_clumps::faults(source, &line));
    if !faults.is_empty() {
        faults
            .sort_by(|one, other| (one.span.start, &one.key).cmp(&(other.span.start, &other.key)));
        faults.dedup();
        return Err(faults);
    }
    let mut system = CaseText::of_text(source.text);
    head(&mut system, source, &line);
    copy(&mut system, source, "parameters");
    run::environment(&mut system, source);
    copy(&mut system, source, "current");
    run::waves(&mut system, source);
    copy(&mut system, source, "seabed");
    buoyed::write_materials(&mut system, source, &line);
    ends::write(&mut system, source);
    traveller::write_point(&mut system, source);
    line::write(&mut system, source, &line);
    traveller::write_hauling(&mut system, source);
    start::of_ends(&mut system, source);
    run::write(&mut system, source, &line);
    results::write(&mut system, source, &line);
    copied::files(&mut system, source);
    Ok(Imported {
        text: system.text,
        from: system.from,
        beside: None,
        keys: source.keys(),
    })
}

/// The table `[system]`: what the case is, and what of it is not carried over.
fn head(system: &mut CaseText<'_>, source: &LineSource<'_>, line: &[stretches::Stretch<'_>]) {
    system.line(
        "# A case of one line, as a system; comments name its rows.",
        None,
    );
    system.table("[system]", source.span(&["case"]));
    let about = &source.case.case;
    system.line(
        &format!("title = {}", text(&about.title)),
        source.span(&["case", "title"]),
    );
    if !about.source.is_empty() {
        system.line(&format!("source = {}", text(&about.source)), None);
    }
    let mut notes = Vec::new();
    if !about.notes.is_empty() {
        notes.push(about.notes.trim().to_owned());
    }
    notes.extend(unused::remarks(source, line));
    if !notes.is_empty() {
        system.line(&format!("notes = {}", text(&notes.join(" "))), None);
    }
    if let Some(reason) = &about.tolerance_reason {
        system.line(&format!("tolerance_reason = {}", text(reason)), None);
    }
}
