//! Version, file, method and steps of runs; their work and cost.

use crate::number::{digits, duration, si};
use crate::run::{RunInfo, RunState, Settings};

/// A setting or cost of each run, in words with its unit; empty where a run has none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ComparedSetting {
    /// What it is.
    pub name: &'static str,
    /// The value in each run.
    pub values: Vec<String>,
}

/// What is not the same in all runs.
pub(super) fn differing(runs: &[RunInfo]) -> Vec<ComparedSetting> {
    let mut all = rows(runs, &ABOUT);
    let of_settings = SETTINGS.map(|(name, read)| ComparedSetting {
        name,
        values: runs.iter().map(|run| read(&run.settings)).collect(),
    });
    all.extend(of_settings);
    all.retain(|row| row.values.iter().any(|value| *value != row.values[0]));
    all
}

/// Work and cost of every run.
pub(super) fn cost(runs: &[RunInfo]) -> Vec<ComparedSetting> {
    rows(runs, &COST)
}

type SettingReader<T> = (&'static str, fn(&T) -> String);

fn rows(runs: &[RunInfo], readers: &[SettingReader<RunInfo>]) -> Vec<ComparedSetting> {
    let row = |(name, read): &SettingReader<RunInfo>| ComparedSetting {
        name,
        values: runs.iter().map(read).collect(),
    };
    readers.iter().map(row).collect()
}

const ABOUT: [SettingReader<RunInfo>; 4] = [
    ("version", |run| run.version.clone()),
    ("case file", |run| run.case_file.clone()),
    ("title", |run| run.title.clone()),
    ("state", |run| match run.state {
        RunState::Done => "complete".to_owned(),
        RunState::Partial => "partial".to_owned(),
        RunState::Failed => "failed".to_owned(),
        RunState::Cancelled => "cancelled".to_owned(),
    }),
];

const SETTINGS: [SettingReader<Settings>; 10] = [
    ("method", |s| s.method.clone()),
    ("duration", |s| si(s.duration_s, "s")),
    ("longest step", |s| si(s.time_step_s, "s")),
    ("step tolerance", |s| optional(s.step_tolerance, "-")),
    ("rho infinity", |s| optional(s.rho_inf, "-")),
    ("position tolerance", |s| {
        optional(s.position_tolerance_m, "m")
    }),
    ("nodes", |s| s.nodes.to_string()),
    ("output interval", |s| si(s.output_interval_s, "s")),
    ("error estimate", |s| s.error_method.clone()),
    ("accuracy", |s| s.accuracy.clone().unwrap_or_default()),
];

const COST: [SettingReader<RunInfo>; 6] = [
    ("steps", |run| run.work.steps.to_string()),
    ("steps rejected", |run| run.work.rejections.to_string()),
    ("Newton iterations", |run| run.work.iterations.to_string()),
    ("force evaluations", |run| run.work.evaluations.to_string()),
    ("CPU time", |run| duration(run.cost.cpu_s)),
    ("wall time of error estimate", |run| {
        duration(run.cost.companions_wall_s)
    }),
];

fn optional(value: Option<f64>, unit: &str) -> String {
    match unit {
        "-" => value.map_or_else(String::new, |value| digits(value, 6)),
        _ => value.map_or_else(String::new, |value| si(value, unit)),
    }
}
