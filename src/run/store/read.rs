//! A run back from disk, as far as it goes.

use std::{fs, io, path::Path};

use super::{
    CASE, CHANNELS, CHECKPOINT, ERRORS, PROFILE, ROPES, RUN, Rows, SUMMARY, Shapes, StoreError,
    complete::{CHANNEL_COLUMNS, ERROR_COLUMNS, SUMMARY_COLUMNS},
    is_locked,
    number::parse,
    ropes::{ROPE_COLUMNS, read_ropes},
    shapes::{self, BENDING_COLUMNS, PROFILE_COLUMNS, RESPONSE_COLUMNS},
    table,
};
use crate::case::ChannelId;
use crate::run::{
    Channel, Checkpoint, DecimatedRecord, History, Profile, Quantity, Resume, Run, RunInfo,
    RunState,
};

/// Reads a run. What is damaged or missing is left out, and said in [`RunInfo::warnings`]; so is a
/// run found in state partial.
///
/// # Errors
/// Nothing is there, it is no run directory, or `run.toml` cannot be understood.
pub fn read(dir: &Path) -> Result<Run, StoreError> {
    let info = read_info(dir)?;
    // A run that never finished has no summary or profile to miss.
    let whole = info.state != RunState::Partial;
    let mut reader = Reader {
        dir,
        whole,
        warnings: Vec::new(),
    };

    let case_text = reader.case_text();
    let (history, shapes) = reader.record().into_parts();
    let (profile, summary) = (reader.profile(), reader.summary());
    let warnings = reader.warnings;

    let mut run = Run {
        info,
        case_text,
        history,
        shapes,
        profile,
        summary,
    };
    if !whole {
        run.info
            .warnings
            .push(partial(is_locked(dir), &run.history));
    }
    run.info.warnings.extend(warnings);
    Ok(run)
}

/// Reads where a run stands, to go on from there.
///
/// # Errors
/// The run has no checkpoint, or one that cannot be understood.
pub fn resume(dir: &Path) -> Result<Resume, StoreError> {
    let file = dir.join(CHECKPOINT);
    let text = fs::read_to_string(&file).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => StoreError::NoCheckpoint(dir.to_owned()),
        _ => StoreError::io("Reading", &file)(error),
    })?;
    let checkpoint: Checkpoint = toml::from_str(&text).map_err(|error| StoreError::Damaged {
        file,
        reason: error.to_string().trim_end().to_owned(),
    })?;
    let dir = dir.to_owned();
    Ok(Resume { checkpoint, dir })
}

/// Reads only the text of its case.
///
/// # Errors
/// It cannot be read.
pub fn case_text(dir: &Path) -> Result<String, StoreError> {
    let file = dir.join(CASE);
    fs::read_to_string(&file).map_err(StoreError::io("Reading", file))
}

/// Reads only `run.toml`.
///
/// # Errors
/// As [`read`].
pub fn read_info(dir: &Path) -> Result<RunInfo, StoreError> {
    let path = dir.join(RUN);
    let text = fs::read_to_string(&path).map_err(|error| match error.kind() {
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
    toml::from_str(&text).map_err(|error| StoreError::Damaged {
        file: path,
        reason: error.to_string().trim_end().to_owned(),
    })
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

struct Reader<'a> {
    dir: &'a Path,
    whole: bool,
    warnings: Vec<String>,
}

impl Reader<'_> {
    fn case_text(&mut self) -> String {
        fs::read_to_string(self.dir.join(CASE)).unwrap_or_else(|error| {
            self.warnings
                .push(format!("{CASE} cannot be read: {error}."));
            String::new()
        })
    }

    /// A table with these columns; trouble is told, unless a partial run simply has not got there.
    fn table(&mut self, name: &str, columns: Option<&[&str]>) -> table::Rows {
        let mut table = table::read(self.dir, name);
        if let Some(columns) = columns {
            table.expect(name, columns);
        }
        table
    }

    fn told(&mut self, trouble: Option<String>) {
        self.warnings.extend(trouble.filter(|_| self.whole));
    }

    /// History and shapes, thinned where they are long.
    fn record(&mut self) -> DecimatedRecord {
        let known = self.channels();
        let of = |id: &ChannelId| known.iter().find(|c| c.id == *id);
        let mut rows = Rows::open(self.dir);
        let mut kept = DecimatedRecord::new(rows.ids().iter().cloned());
        while let Some((time, values)) = rows.next() {
            kept.row(time, values);
        }
        let mut shapes = Shapes::open(self.dir);
        while let Some(shape) = shapes.next() {
            kept.shape(shape);
        }
        // Extremes over every step, where they are known; a run that was stopped has those of its rows.
        for channel in kept.channels_mut() {
            if let Some(known) = of(&channel.id).filter(|c| !c.peak.0.is_nan()) {
                (channel.peak, channel.trough) = (known.peak, known.trough);
            }
        }
        self.told(rows.trouble());
        self.told(shapes.trouble());
        kept
    }

    /// Channels by name with unit and extremes; extremes not known yet are NaN.
    fn channels(&mut self) -> Vec<Channel> {
        let table = self.table(CHANNELS, Some(&CHANNEL_COLUMNS));
        let mut channels = Vec::new();
        for (_, fields) in &table.rows {
            let [name, _, numbers @ ..] = fields.as_slice() else {
                continue;
            };
            let at = |i: usize| numbers.get(i).and_then(|f| parse(f)).unwrap_or(f64::NAN);
            let Ok(id) = name.parse() else { continue };
            channels.push(Channel {
                peak: (at(0), at(1)),
                trough: (at(2), at(3)),
                ..Channel::new(id)
            });
        }
        self.told(table.trouble);
        channels
    }

    fn profile(&mut self) -> Profile {
        let mut table = self.table(PROFILE, None);
        let further = table.columns.len().saturating_sub(PROFILE_COLUMNS.len());
        let mut columns = PROFILE_COLUMNS.to_vec();
        // Bending has four columns and the response eleven.
        if matches!(further, 4 | 15) {
            columns.extend(BENDING_COLUMNS);
        }
        if matches!(further, 11 | 15) {
            columns.extend(RESPONSE_COLUMNS);
        }
        table.expect(PROFILE, &columns);
        let mut profile = shapes::read_profile(&mut table, PROFILE);
        self.told(table.trouble);
        // Only a line with such ropes has the file.
        if self.dir.join(ROPES).exists() {
            let mut table = self.table(ROPES, Some(&ROPE_COLUMNS));
            profile.ropes = read_ropes(&mut table, ROPES);
            self.told(table.trouble);
        }
        profile
    }

    /// Values from `summary.csv`, the two parts of their errors from `errors.csv`.
    fn summary(&mut self) -> Vec<Quantity> {
        let mut table = self.table(SUMMARY, Some(&SUMMARY_COLUMNS));
        let parts = self.table(ERRORS, Some(&ERROR_COLUMNS));
        let mut summary = Vec::new();
        for (row, (line, fields)) in table.rows.iter().enumerate() {
            let (Some(name), Some(value)) = (fields.first(), fields.get(1).and_then(|f| parse(f)))
            else {
                table.trouble = Some(format!(
                    "{SUMMARY}, line {line} holds a value that is no number; read up to there."
                ));
                break;
            };
            // Both files list the quantities in the same order; look further only when one is damaged.
            let same = |(_, other): &&(u64, Vec<String>)| other.first() == Some(name);
            let part = parts.rows.get(row).filter(same);
            let part = part.or_else(|| parts.rows.iter().find(same));
            let error = |i: usize| part.and_then(|(_, f)| f.get(i)).and_then(|f| parse(f));
            let Ok(id) = name.parse() else { continue };
            summary.push(Quantity {
                id,
                value,
                time_error: error(2),
                mesh_error: error(3),
            });
        }
        self.told(table.trouble);
        self.told(parts.trouble);
        summary
    }
}
