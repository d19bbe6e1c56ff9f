//! What the directories of the runs hold.

use std::collections::BTreeMap;
use std::os::unix::fs::MetadataExt;
use std::path::Path;
use std::{fs, io};

use super::IndexError;
use super::baseline::{self, Inputs};
use super::query::MeasuredResult;
use crate::case::TextDigest;
use crate::files::read::{run_table, run_text};
use crate::run::store::{self, CASE, ERRORS, RUN, RunNotes, SUMMARY};
use crate::run::{RunInfo, RunState};

/// The runs below a directory: the name of each, and a stamp that is another one after every change.
pub(super) fn stamps(root: &Path) -> Result<BTreeMap<String, String>, IndexError> {
    let failed = |error| IndexError::Folder {
        dir: root.to_owned(),
        error,
    };
    let inside = match fs::read_dir(root) {
        Ok(inside) => inside,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(error) => return Err(failed(error)),
    };
    let mut stamps = BTreeMap::new();
    for item in inside {
        let item = item.map_err(failed)?;
        // A name that is no text could not be shown or typed.
        let Ok(name) = item.file_name().into_string() else {
            continue;
        };
        // Hidden directories are runs about to appear.
        if name.starts_with('.') {
            continue;
        }
        if let Some(stamp) = stamp(&item.path()) {
            stamps.insert(name, stamp);
        }
    }
    Ok(stamps)
}

/// Times and size by which a change of a run is seen. Files of a run are replaced, which changes its directory; one edited in
/// place has another time itself.
fn stamp(dir: &Path) -> Option<String> {
    let run = fs::metadata(dir.join(RUN)).ok()?;
    let folder = fs::metadata(dir).ok()?;
    let time = |of: &fs::Metadata| format!("{}.{:09}", of.mtime(), of.mtime_nsec());
    Some(format!("{} {} {}", time(&run), run.len(), time(&folder)))
}

/// A run as read from its directory.
#[derive(Debug)]
pub(super) struct FolderRun {
    pub(super) info: Result<RunInfo, String>,
    pub(super) text: TextDigest,
    pub(super) inputs: Inputs,
    pub(super) results: Vec<(String, MeasuredResult)>,
    pub(super) notes: RunNotes,
}

impl FolderRun {
    /// Reads a run; what is missing or damaged is left out.
    pub(super) fn read(dir: &Path) -> Self {
        let info = store::read_info(dir).map_err(|error| error.to_string());
        let text = run_text(&dir.join(CASE)).unwrap_or_default();
        let whole = info.as_ref().is_ok_and(|i| i.state != RunState::Partial);
        Self {
            info,
            text: TextDigest::of_text(&text),
            inputs: baseline::inputs(&text),
            results: if whole { results(dir) } else { Vec::new() },
            notes: RunNotes::read(dir),
        }
    }
}

/// The results of a run with their errors.
fn results(dir: &Path) -> Vec<(String, MeasuredResult)> {
    let number = |text: Option<&str>| text.and_then(|text| text.parse::<f64>().ok());
    let mut ranges = BTreeMap::new();
    for row in rows(&dir.join(ERRORS)) {
        if let (Some(name), Some(least), Some(greatest)) =
            (row.get(0), number(row.get(4)), number(row.get(5)))
        {
            ranges.insert(name.to_owned(), (least, greatest));
        }
    }
    let read = |row: csv::StringRecord| {
        let name = row.get(0)?.to_owned();
        let result = MeasuredResult {
            value: number(row.get(1)).filter(|value| value.is_finite())?,
            unit: row.get(2)?.to_owned(),
            error: number(row.get(3)).filter(|error| error.is_finite()),
            unsettled: ranges.get(&name).copied(),
        };
        Some((name, result))
    };
    rows(&dir.join(SUMMARY)).filter_map(read).collect()
}

/// The rows of a table, as far as they can be read.
fn rows(file: &Path) -> impl Iterator<Item = csv::StringRecord> {
    let reader = |file| csv::ReaderBuilder::new().flexible(true).from_reader(file);
    let opened = run_table(file).ok().into_iter();
    let rows = opened.flat_map(move |file| reader(file).into_records());
    rows.map_while(Result::ok)
}
