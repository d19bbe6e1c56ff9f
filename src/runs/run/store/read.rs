//! A run back from disk, as far as it goes.

use std::{io, path::Path};

use serde::de::DeserializeOwned;

use super::{
    CASE, CHANNELS, CHECKPOINT, ERRORS, HISTORY, HistoryReader, PROFILE, ROPES, RUN, SHAPES,
    SUMMARY, ShapeReader, StoreError, columns,
    complete::{CHANNEL_COLUMNS, ERROR_COLUMNS, SUMMARY_COLUMNS},
    fatigue_spots, is_locked,
    number::parse,
    profile_csv::{PROFILE_COLUMNS, ROPE_COLUMNS},
    table::{CsvReader, not_a_number},
};
use crate::case::ChannelId;
use crate::files::read::{run_table, run_text};
use crate::files::shallow::shallow;
use crate::run::along::FatigueSpot;
use crate::run::{
    Channel, Checkpoint, DecimatedRecord, History, LineShape, Profile, Quantity, QuantityId,
    ResumedRun, Run, RunInfo, RunState, VERSION,
};
use crate::seal::{self, SealedPart};

/// Reads a run. What is damaged or missing is left out, with a warning in [`RunInfo::warnings`]; a
/// partial run gives one, too.
///
/// # Errors
/// Nothing is there, it is no run directory, or `run.toml` cannot be understood.
pub fn read(dir: &Path) -> Result<Run, StoreError> {
    let info = read_info(dir)?;
    // A run that never finished has no summary or profile to miss.
    let whole = info.state != RunState::Partial;
    let mut reader = RunReader {
        dir,
        whole,
        warnings: Vec::new(),
    };

    let case_text = reader.case_text();
    let (history, shapes) = reader.record().into_parts();
    let (profiles, summary) = (reader.profiles(), reader.summary());
    let fatigue = reader.fatigue();
    let mut warnings = reader.warnings;
    if !warnings.is_empty() && info.version != VERSION {
        let (theirs, ours) = (&info.version, VERSION);
        warnings.push(format!(
            "Version {theirs} wrote this run; this is version {ours}."
        ));
    }

    let mut run = Run {
        info,
        case_text,
        history,
        shapes,
        profiles,
        summary,
        fatigue,
    };
    if !whole {
        run.info
            .warnings
            .push(partial(is_locked(dir), &run.history));
    }
    run.info.warnings.extend(warnings);
    Ok(run)
}

/// Reads the channels of a stored run with the extremes over all its steps and their times, without rows; extremes that are not known
/// yet are NaN.
///
/// # Errors
/// A table that cannot be understood.
pub fn channel_extremes(dir: &Path) -> Result<Vec<Channel>, StoreError> {
    let mut reader = RunReader {
        dir,
        whole: true,
        warnings: Vec::new(),
    };
    let channels = reader.channels();
    match reader.warnings.into_iter().next() {
        None => Ok(channels),
        Some(reason) => Err(StoreError::Damaged {
            file: dir.join(CHANNELS),
            reason,
        }),
    }
}

/// Reads the checkpoint of a run.
///
/// # Errors
/// The run has no checkpoint, one that cannot be understood, or one that does not belong to the files beside it.
pub fn resume(dir: &Path) -> Result<ResumedRun, StoreError> {
    let (checkpoint, case): (Checkpoint, _) = sealed_checkpoint(dir)?;
    case?;
    let dir = dir.to_owned();
    Ok(ResumedRun { checkpoint, dir })
}

/// Reads the checkpoint of a run of any kind, which must be whole and of the history and the shapes beside it; and whether it is of the
/// case beside it.
///
/// # Errors
/// As [`resume`].
pub fn sealed_checkpoint<C: DeserializeOwned>(
    dir: &Path,
) -> Result<(C, Result<(), StoreError>), StoreError> {
    let file = dir.join(CHECKPOINT);
    let text = run_text(&file).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => StoreError::NoCheckpoint(dir.to_owned()),
        _ => StoreError::io("Reading", &file)(error),
    })?;
    let (content, seal) = seal::opened(&text).map_err(|reason| {
        let info = read_info(dir).ok();
        let version = info.as_ref().map(|info| info.version.as_str());
        StoreError::Damaged {
            file,
            reason: with_version(&reason, version),
        }
    })?;
    check_sealed(dir, HISTORY, &seal.history)?;
    check_sealed(dir, SHAPES, &seal.shapes)?;
    let case = case_text(dir)?;
    let case = seal.case.is(&case).then_some(()).ok_or_else(|| {
        let reason = "it is not the case that the checkpoint beside it belongs to; undo the change (another duration is set by --until), or compute the case anew";
        StoreError::Damaged {
            file: dir.join(CASE),
            reason: reason.to_owned(),
        }
    });
    Ok((content, case))
}

/// Checks that a file begins with what a checkpoint was written after.
fn check_sealed(dir: &Path, name: &str, part: &SealedPart) -> Result<(), StoreError> {
    let file = dir.join(name);
    let begins = run_table(&file).and_then(|file| part.begins(file));
    if begins.map_err(StoreError::io("Reading", &file))? {
        return Ok(());
    }
    Err(StoreError::Damaged {
        file,
        reason: "it was changed or cut since the checkpoint beside it was written; compute the case anew"
            .to_owned(),
    })
}

/// Reads only what was computed and its results, without the history; of a run that came to its end.
///
/// # Errors
/// As [`read_info`], and of results that cannot be understood.
pub fn read_results(dir: &Path) -> Result<(RunInfo, Vec<Quantity>), StoreError> {
    let info = read_info(dir)?;
    let mut reader = RunReader {
        dir,
        whole: true,
        warnings: Vec::new(),
    };
    let summary = reader.summary();
    match reader.warnings.into_iter().next() {
        None => Ok((info, summary)),
        Some(reason) => Err(StoreError::Damaged {
            file: dir.join(SUMMARY),
            reason,
        }),
    }
}

/// Reads only the text of its case.
///
/// # Errors
/// It cannot be read.
pub fn case_text(dir: &Path) -> Result<String, StoreError> {
    let file = dir.join(CASE);
    run_text(&file).map_err(StoreError::io("Reading", file))
}

/// Reads only `run.toml`.
///
/// # Errors
/// As [`read`].
pub fn read_info(dir: &Path) -> Result<RunInfo, StoreError> {
    let path = dir.join(RUN);
    let text = run_text(&path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound if !dir.exists() => StoreError::NotFound(dir.to_owned()),
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => {
            StoreError::NotARun(dir.to_owned())
        }
        io::ErrorKind::InvalidData => StoreError::Damaged {
            file: path.clone(),
            reason: "it is not text in UTF-8.".to_owned(),
        },
        _ => StoreError::io("Reading", &path)(error),
    })?;
    let damaged = |reason: String| {
        let table = shallow(&text).parse::<toml::Table>().unwrap_or_default();
        let version = table.get("version").and_then(toml::Value::as_str);
        StoreError::Damaged {
            file: path.clone(),
            reason: with_version(&reason, version),
        }
    };
    // Few files have these letters, and it is read often.
    if ["inf", "nan"].iter().any(|word| text.contains(word))
        && let Ok(table) = shallow(&text).parse::<toml::Table>()
    {
        seal::check_finite(&table).map_err(damaged)?;
    }
    toml::from_str(shallow(&text)).map_err(|error| damaged(error.to_string()))
}

/// Why a file cannot be understood, and which version of the program wrote it.
fn with_version(reason: &str, version: Option<&str>) -> String {
    let reason = reason.trim_end();
    match version {
        Some(version) if version != VERSION => {
            format!("{reason}\nVersion {version} wrote it; this is version {VERSION}.")
        }
        _ => reason.to_owned(),
    }
}

/// Why a run is partial, and how far it is.
fn partial(held: bool, history: &History) -> String {
    let why = if held {
        "a program is still computing it"
    } else {
        "the program was stopped while it computed"
    };
    match history.time.last() {
        Some(last) => format!("The run is partial: {why}. Its history ends at {last} s."),
        None => format!("The run is partial: {why}, before the first result."),
    }
}

/// The field of a row in a column; empty where the file has no such column.
fn field(fields: &csv::StringRecord, column: Option<usize>) -> &str {
    column.and_then(|at| fields.get(at)).unwrap_or("")
}

struct RunReader<'a> {
    dir: &'a Path,
    whole: bool,
    warnings: Vec<String>,
}

impl RunReader<'_> {
    fn case_text(&mut self) -> String {
        run_text(&self.dir.join(CASE)).unwrap_or_else(|error| {
            self.warnings
                .push(format!("{CASE} cannot be read: {error}."));
            String::new()
        })
    }

    /// Opens a table that needs these columns.
    fn table(&self, name: &str, columns: &[&str]) -> CsvReader {
        self.table_of(name, columns, columns)
    }

    /// Opens a table that needs some columns and knows more.
    fn table_of(&self, name: &str, needed: &[&str], known: &[&str]) -> CsvReader {
        let mut csv = CsvReader::open(self.dir, name);
        csv.require(needed);
        csv.note_unknown(|name| known.contains(&name));
        csv
    }

    /// Reports a problem, unless a partial run simply has not got there.
    fn report(&mut self, problem: Option<String>) {
        self.warnings.extend(problem.filter(|_| self.whole));
    }

    /// History and shapes, decimated where they are long.
    fn record(&mut self) -> DecimatedRecord {
        let known = self.channels();
        let of = |id: &ChannelId| known.iter().find(|c| c.id == *id);
        let mut rows = HistoryReader::open(self.dir);
        let mut kept = DecimatedRecord::new(rows.ids().iter().cloned());
        while let Some((time, values)) = rows.next() {
            kept.row(time, values);
        }
        let mut shapes = ShapeReader::open(self.dir);
        let mut at_once: Vec<LineShape> = Vec::new();
        while let Some(shape) = shapes.next() {
            if at_once
                .first()
                .is_some_and(|first| first.time != shape.time)
            {
                kept.add_shapes(&at_once);
                at_once.clear();
            }
            at_once.push(shape);
        }
        kept.add_shapes(&at_once);
        // Extremes over every step, where they are known; a run that was stopped has those of its rows.
        for channel in kept.channels_mut() {
            let known = of(&channel.id).filter(|c| {
                [c.peak, c.trough]
                    .iter()
                    .all(|(v, t)| v.is_finite() && t.is_finite())
            });
            if let Some(known) = known {
                (channel.peak, channel.trough) = (known.peak, known.trough);
            }
        }
        self.report(rows.problem());
        self.report(shapes.problem());
        kept
    }

    /// Channels with their extremes; extremes not known yet are NaN.
    fn channels(&mut self) -> Vec<Channel> {
        let mut csv = self.table(CHANNELS, &CHANNEL_COLUMNS);
        let [name, _, max, max_time, min, min_time] = CHANNEL_COLUMNS.map(|c| csv.position(c));
        let mut channels = Vec::new();
        while let Some((_, fields)) = csv.next() {
            let text = |place| field(fields, place);
            let number = |place| parse(text(place)).unwrap_or(f64::NAN);
            let Ok(id) = text(name).parse() else { continue };
            channels.push(Channel {
                peak: (number(max), number(max_time)),
                trough: (number(min), number(min_time)),
                ..Channel::new(id)
            });
        }
        self.report(csv.problem());
        channels
    }

    fn profiles(&mut self) -> Vec<Profile> {
        let (lines, problem) = columns::read(&PROFILE_COLUMNS, self.dir, PROFILE);
        self.report(problem);
        let mut lines: Vec<Profile> = lines
            .into_iter()
            .map(|(line, profile)| Profile { line, ..profile })
            .collect();
        // Only a run with such ropes has the file.
        if self.dir.join(ROPES).exists() {
            let (ropes, problem) = columns::read(&ROPE_COLUMNS, self.dir, ROPES);
            self.report(problem);
            for (name, ropes) in ropes {
                if let Some(line) = lines.iter_mut().find(|line| line.line == name) {
                    line.ropes = ropes;
                }
            }
        }
        lines
    }

    /// The damage along the line; only runs whose checks count it have the file.
    fn fatigue(&mut self) -> Vec<FatigueSpot> {
        match fatigue_spots(self.dir) {
            Ok(found) => found,
            Err(error) => {
                self.warnings.push(error.to_string());
                Vec::new()
            }
        }
    }

    /// Values from `summary.csv`, the two parts of their errors from `errors.csv`. Quantities that this version does not
    /// know are left out.
    fn summary(&mut self) -> Vec<Quantity> {
        let mut csv = self.table(SUMMARY, &SUMMARY_COLUMNS);
        let [name, value, ..] = SUMMARY_COLUMNS.map(|column| csv.position(column));
        let mut summary = Vec::new();
        while let Some((line, fields)) = csv.next() {
            let text = |place| field(fields, place);
            let Some(value) = parse(text(value)) else {
                csv.give_up(not_a_number(SUMMARY, line));
                break;
            };
            if let Ok(id) = text(name).parse() {
                summary.push(Quantity::new(id, value));
            }
        }
        self.report(csv.problem());
        self.add_errors(&mut summary);
        summary
    }

    fn add_errors(&mut self, summary: &mut [Quantity]) {
        // Runs of version 0.1 have no ranges.
        let mut csv = self.table_of(ERRORS, &ERROR_COLUMNS[..4], &ERROR_COLUMNS);
        let [name, _, time, mesh, least, greatest] =
            ERROR_COLUMNS.map(|column| csv.position(column));
        let mut next = 0;
        while let Some((_, fields)) = csv.next() {
            let text = |place| field(fields, place);
            let Ok(id) = text(name).parse::<QuantityId>() else {
                continue;
            };
            // Both files list the quantities in the same order; look further only when one is damaged.
            let in_order = summary.get(next).is_some_and(|q| q.id == id);
            let found = match in_order {
                true => Some(next),
                false => summary.iter().position(|q| q.id == id),
            };
            if let Some(at) = found {
                summary[at].time_error = parse(text(time));
                summary[at].mesh_error = parse(text(mesh));
                let range = parse(text(least)).zip(parse(text(greatest)));
                summary[at].unsettled = range.map(|(least, greatest)| [least, greatest]);
                next = at + 1;
            }
        }
        self.report(csv.problem());
    }
}
