//! A case that starts from the state of a stored run: what of that run must agree with the case.

use crate::visible;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::diagnostic::{Diagnostic, Finding};
use super::fields::quantity;
use super::model::{Attachment, Case};
use super::tree::TomlNode;
use crate::files::{read, root};
use crate::seal;

/// The file of a run directory that a run resumes from.
const CHECKPOINT: &str = "checkpoint.toml";

/// The key that names the run.
const KEY: &str = "start.from_run";

/// Arc lengths that differ by less than this share of the line are the same.
const SLOP: f64 = 1e-9;

/// What is read here of a checkpoint; the rest is read when the run starts.
#[derive(Deserialize)]
struct CheckpointArc {
    recorded: CheckpointRecord,
}

#[derive(Deserialize)]
struct CheckpointRecord {
    profiles: Vec<CheckpointProfile>,
}

#[derive(Deserialize)]
struct CheckpointProfile {
    arc: Vec<f64>,
}

/// Attaches the checkpoint of the run that the case starts from, and compares its line with that of the case.
pub(super) fn gather(
    case: &mut Case,
    root: &TomlNode,
    text: &str,
    (file, folder): (&str, &Path),
) -> Result<(), Diagnostic> {
    let Some(name) = case.start.from_run.clone() else {
        return Ok(());
    };
    let span = root
        .find(&["start", "from_run"])
        .map_or(0..0, |node| node.span.clone());
    let fault = |problem: String, remedy: &str| {
        Finding::new(&span, KEY.to_owned(), problem, remedy).at(file, text)
    };
    let mut is_outside = false;
    if !case.files.contains_key(&name) {
        let dir = directory(folder, &name);
        let place = root::place_of_run(folder, &dir, &name);
        is_outside = place.as_ref().is_ok_and(|place| place.is_outside);
        let read = place.and_then(|place| read::run_text(&place.path.join(CHECKPOINT)));
        let read = read.map_err(|error| {
            let path = dir.join(CHECKPOINT);
            let problem = format!("{} cannot be read: {error}", visible::path(&path));
            let remedy = "name the directory of a dynamic run that reached an output time, relative to the case file or to here";
            fault(problem, remedy)
        })?;
        case.files
            .insert(name.clone(), Attachment { text: read.into() });
    }
    let attached = case.files.get(&name).map_or("", |c| &*c.text);
    let (checkpoint, _): (CheckpointArc, _) = seal::opened(attached).map_err(|error| {
        // The reason may quote the file.
        let reason = match is_outside {
            true => "it is none".to_owned(),
            false => error.to_string(),
        };
        let problem = format!("the checkpoint of {name} cannot be read: {reason}");
        fault(problem, "name another run, or compute that one anew")
    })?;
    // The checkpoint of a system has the lines of that.
    let lines = &checkpoint.recorded.profiles;
    let arc = lines.first().map_or(&[][..], |line| &line.arc);
    mismatch(case, arc).map_or(Ok(()), |problem| {
        let remedy = "start from a run of the same line: sections, lengths and segments";
        Err(fault(problem, remedy))
    })
}

/// The directory of a run: beside the case file, or as named.
fn directory(folder: &Path, name: &str) -> PathBuf {
    let beside = folder.join(name);
    if beside.is_dir() {
        beside
    } else {
        PathBuf::from(name)
    }
}

/// Why the line of the run is not that of the case; nothing where it is.
fn mismatch(case: &Case, there: &[f64]) -> Option<String> {
    let mut here = vec![0.0];
    let mut from = 0.0;
    for section in &case.line {
        let n = section.segments;
        here.extend((1..=n).map(|i| from + section.length_m * i as f64 / n as f64));
        from += section.length_m;
    }
    let words = |arc: &[f64]| {
        let length = arc.last().copied().unwrap_or(0.0);
        format!("{} nodes over {}", arc.len(), quantity(length, "m"))
    };
    if there.len() != here.len() || (there.last()? - from).abs() > SLOP * from {
        return Some(format!(
            "the run's line has {}, this one {}",
            words(there),
            words(&here)
        ));
    }
    let apart = |(a, b): &(&f64, &f64)| (*a - *b).abs() > SLOP * from;
    let at = there.iter().zip(&here).position(|pair| apart(&pair))?;
    Some(format!(
        "node {at} of the run's line lies at {}, of this one at {}",
        quantity(there[at], "m"),
        quantity(here[at], "m")
    ))
}
