//! What the user set, what sessions left, and what is installed beside the program.

use std::fs;
use std::path::Path;

use super::finding::{DoctorFinding, Surroundings};
use crate::manual::installed;
use crate::manual::installed::Installed;
use seacable_base::{crash_log, places, visible};
use seacable_jobs::list::JobEntry;
use seacable_jobs::{JobsDir, survival};
use seacable_runs::run::store::DEFAULT_ROOT;
use seacable_tui::settings::{UserSettings, config_file, keys_file};

const TOPIC: &str = "session";

pub(super) fn findings(around: &Surroundings<'_>) -> Vec<DoctorFinding> {
    let mut found = settings();
    found.push(index(around));
    found.push(unsaved());
    found.push(jobs());
    found.push(manual(around));
    found.push(crash());
    found
}

/// The files of keys and settings, each fault a finding of its own.
fn settings() -> Vec<DoctorFinding> {
    let settings = UserSettings::load();
    let file = |name: &str, path: std::io::Result<std::path::PathBuf>| match path {
        Ok(path) if path.exists() => DoctorFinding::fine(TOPIC, name, visible::path(&path)),
        Ok(path) => DoctorFinding::fine(TOPIC, name, format!("none ({})", visible::path(&path))),
        Err(error) => DoctorFinding::fine(TOPIC, name, error.to_string()),
    };
    let mut found = vec![file("keys", keys_file()), file("settings", config_file())];
    found.extend(settings.faults.iter().map(|fault| {
        let place = format!("{}:{}:{}", fault.file, fault.line, fault.column);
        let what = match fault.key.as_str() {
            "" => fault.problem.clone(),
            key => format!("{key}: {}", fault.problem),
        };
        let found = DoctorFinding::fine(TOPIC, "fault of settings", format!("{place}: {what}"));
        found.problem(fault.remedy.to_string())
    }));
    found
}

/// The database of the runs below the directory, which is made anew where it is lost.
fn index(around: &Surroundings<'_>) -> DoctorFinding {
    let runs = around.directory.join(DEFAULT_ROOT);
    let count = fs::read_dir(&runs).map_or(0, Iterator::count);
    let files = places::cache_dir().and_then(fs::read_dir);
    let databases = files.map_or(0, |files| {
        let files = files.flatten();
        files
            .filter(|file| {
                file.path()
                    .extension()
                    .is_some_and(|end| end == "sqlite" || end == "db")
            })
            .count()
    });
    let value = match count {
        0 => "no runs below this directory".to_owned(),
        count => {
            format!("{count} entries below {DEFAULT_ROOT}, {databases} databases in the cache")
        }
    };
    DoctorFinding::fine(TOPIC, "index of runs", value)
}

/// Changes that sessions left unsaved.
fn unsaved() -> DoctorFinding {
    let dir = places::state_dir().map(|dir| dir.join("recovery"));
    let files = dir.and_then(fs::read_dir);
    let count = files.map_or(0, |files| {
        files.flatten().filter(|file| is_toml(&file.path())).count()
    });
    let found = DoctorFinding::fine(
        TOPIC,
        "unsaved changes",
        format!("{count} kept for recovery"),
    );
    match count {
        0 => found,
        _ => found.note("opening the case in the workbench offers them"),
    }
}

fn is_toml(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == "toml")
}

/// The jobs of the user, and whether they go on after the logout.
fn jobs() -> DoctorFinding {
    let opened = JobsDir::open();
    let value = match &opened {
        Ok(dir) => {
            let computing = JobEntry::all(dir).len();
            format!("{computing} jobs, which go on without the screen")
        }
        Err(error) => format!("end with the workbench: {error}"),
    };
    let found = DoctorFinding::fine(TOPIC, "jobs", value);
    match (opened, survival::ended_by_logout()) {
        (Err(_), _) => found.note("give the state folder a place that can be written"),
        (Ok(_), Some(why)) => found.note(why),
        (Ok(_), None) => found,
    }
}

/// Manual pages and completions.
fn manual(around: &Surroundings<'_>) -> DoctorFinding {
    let shells = installed::shells(&|name| around.program(name).is_some());
    let (there, all) = installed::state(&shells);
    let value = format!("{there} of {all} files of manual and completions in place");
    let found = DoctorFinding::fine(TOPIC, "manual", value);
    match installed::verdict(there, all) {
        Installed::All => found,
        Installed::None | Installed::Some => {
            found.note("`seacable install-manual` puts manual pages and shell completions in place")
        }
    }
}

fn crash() -> DoctorFinding {
    match crash_log::last() {
        None => DoctorFinding::fine(TOPIC, "last fault", "none known"),
        Some(crash) => {
            let value = format!("{}: {}", crash.time, crash.what);
            let path = visible::path(&crash.path);
            DoctorFinding::fine(TOPIC, "last fault", value).note(format!(
                "{path} has the details; report it, then delete the file"
            ))
        }
    }
}
