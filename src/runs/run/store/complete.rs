//! The files of a complete run.

use std::path::Path;

use super::{
    CASE, CHANNELS, ERRORS, FATIGUE, HISTORY, PROFILE, ROPES, RUN, SHAPES, SUMMARY, StoreError,
    columns,
    create::{info_text, replace},
    fatigue_csv::write_fatigue,
    history_csv::write_history,
    number::{text, text_or_empty},
    profile_csv::{PROFILE_COLUMNS, ROPE_COLUMNS},
    shapes_csv::write_shapes,
    table::CsvWriter,
};
use crate::case::ChannelId;
use crate::run::{Channel, Profile, Quantity, Run, RunInfo};

/// Columns of `summary.csv`.
pub(super) const SUMMARY_COLUMNS: [&str; 4] = ["quantity", "value", "unit", "error_estimate"];
/// Columns of `errors.csv`.
pub(super) const ERROR_COLUMNS: [&str; 6] = [
    "quantity",
    "unit",
    "time_error",
    "mesh_error",
    "least",
    "greatest",
];
/// Columns of `channels.csv`.
pub(super) const CHANNEL_COLUMNS: [&str; 6] = [
    "channel",
    "unit",
    "max",
    "time_of_max_s",
    "min",
    "time_of_min_s",
];

/// What writes a file of a run, by its name.
pub(super) type Put<'a> = dyn FnMut(&str, &[u8]) -> Result<(), StoreError> + 'a;

/// Writes everything, `run.toml` last; the record only where it was not `streamed` while the run went on.
pub(super) fn all(
    dir: &Path,
    id: &str,
    run: &Run,
    streamed: bool,
    put: &mut Put<'_>,
) -> Result<(), StoreError> {
    put(CASE, run.case_text.as_bytes())?;
    put(SUMMARY, &summary(&run.summary)?)?;
    put(ERRORS, &errors(&run.summary)?)?;
    put(CHANNELS, &channels(&run.history.channels)?)?;
    if !streamed {
        put(HISTORY, &write_history(&run.history)?)?;
        put(
            SHAPES,
            write_shapes(&run.shapes, &line_names(run)).as_bytes(),
        )?;
    }
    put(PROFILE, &profiles(&run.profiles)?)?;
    let with_ropes = run.profiles.iter().filter(|line| !line.ropes.is_empty());
    let ropes: Vec<_> = with_ropes
        .map(|line| (line.line.as_str(), &line.ropes, line.ropes.arc.len()))
        .collect();
    if !ropes.is_empty() {
        put(ROPES, &columns::write(&ROPE_COLUMNS, &ropes)?)?;
    }
    if !run.fatigue.is_empty() {
        put(FATIGUE, &write_fatigue(&run.fatigue)?)?;
    }

    let mut info = RunInfo {
        id: id.to_owned(),
        ..run.info.clone()
    };
    let (rows, recorded) = (run.history.time.len(), run.output_times());
    if !streamed && recorded > rows {
        info.warnings.push(format!(
            "kept from memory: {HISTORY} holds {rows} of {recorded} output times, those of all extremes among them"
        ));
    }
    put(RUN, info_text(dir, &info)?.as_bytes())
}

/// `profile.csv`; of a run without lines its header.
fn profiles(lines: &[Profile]) -> Result<Vec<u8>, StoreError> {
    let none = Profile::default();
    let tables = lines
        .iter()
        .map(|line| (line.line.as_str(), line, line.nodes.len()));
    let tables: Vec<_> = match lines {
        [] => vec![("", &none, 0)],
        _ => tables.collect(),
    };
    columns::write(&PROFILE_COLUMNS, &tables)
}

/// Names of the lines of a run; none of a line by itself.
fn line_names(run: &Run) -> Vec<String> {
    let names = run.profiles.iter().map(|line| line.line.clone());
    names.filter(|name| !name.is_empty()).collect()
}

/// Writes `run.toml` alone.
pub(super) fn info(dir: &Path, info: &RunInfo) -> Result<(), StoreError> {
    replace(dir, RUN, info_text(dir, info)?.as_bytes())
}

fn summary(quantities: &[Quantity]) -> Result<Vec<u8>, StoreError> {
    let mut csv = CsvWriter::new(SUMMARY_COLUMNS)?;
    for q in quantities {
        let error = text_or_empty(q.error_estimate());
        csv.row([q.name(), text(q.value), q.unit(), error])?;
    }
    csv.bytes()
}

fn errors(quantities: &[Quantity]) -> Result<Vec<u8>, StoreError> {
    let mut csv = CsvWriter::new(ERROR_COLUMNS)?;
    for q in quantities {
        let (time, mesh) = (text_or_empty(q.time_error), text_or_empty(q.mesh_error));
        let [least, greatest] =
            [0, 1].map(|end| text_or_empty(q.unsettled.map(|range| range[end])));
        csv.row([q.name(), q.unit(), time, mesh, least, greatest])?;
    }
    csv.bytes()
}

fn channels(channels: &[Channel]) -> Result<Vec<u8>, StoreError> {
    let mut csv = CsvWriter::new(CHANNEL_COLUMNS)?;
    for c in channels {
        let [max, max_time, min, min_time] = [c.peak.0, c.peak.1, c.trough.0, c.trough.1].map(text);
        csv.row([&c.name(), c.unit(), &max, &max_time, &min, &min_time])?;
    }
    csv.bytes()
}

/// `channels.csv` before any extreme is known.
pub(super) fn channel_units(channels: &[ChannelId]) -> Result<Vec<u8>, StoreError> {
    let mut csv = CsvWriter::new(CHANNEL_COLUMNS)?;
    for id in channels {
        csv.row([&id.to_string(), id.quantity.unit(), "", "", "", ""])?;
    }
    csv.bytes()
}
