//! `seacable study`: hard cases held against what must come out; speed against error; varying steps beside constant ones.

use std::{io, path::Path, process::ExitCode, sync::Mutex};

use super::{
    Failure, NOT_GOOD,
    args::{HardWords, SpeedWords, StepsWords, StudyWords},
    cases::{self, Loaded},
    output::{self, OutputFile},
    progress,
    signals::Stop,
};
use crate::case::Case;
use crate::report::chart::{Glyphs, draw};
use crate::report::table::Table;
use crate::study::{
    hard::{self, Computed, Hard},
    speed::{self, SpeedError},
    tally,
};

/// Columns of the page.
const WIDTH: usize = 160;

/// Columns and rows of the chart.
const PLOT: (usize, usize) = (80, 24);

pub(super) fn study(words: &StudyWords) -> Result<ExitCode, Failure> {
    match words {
        StudyWords::HardCases(words) => hard_cases(words),
        StudyWords::Speed(words) => speed_of(words),
        StudyWords::Steps(words) => steps_of(words),
    }
}

fn hard_cases(words: &HardWords) -> Result<ExitCode, Failure> {
    let file = OutputFile::check(words.output.as_deref(), words.force, &words.cases)?;
    let loaded = cases::with_trials(&words.cases)?;
    let cases: Vec<Hard> = loaded.into_iter().map(hard_case).collect();
    let stop =
        Stop::listen().map_err(|e| Failure::Usage(format!("Signals cannot be caught: {e}")))?;
    let computed = compute(&cases, &stop);
    if let Some(status) = stop.status() {
        output::message("Stopped before all trials were computed; nothing was judged.");
        return Ok(status);
    }
    let findings = hard::findings(&cases, &computed);
    let table = hard::table(&findings);
    write_csv(&table, file.as_ref())?;
    let tally = tally(&findings);
    output::results(&format!("{}\n{tally}\n", table.to_text(WIDTH)), words.ascii)?;
    Ok(if tally.holds() {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(NOT_GOOD)
    })
}

/// Writes a table to a file, where one is asked for.
fn write_csv(table: &Table, file: Option<&OutputFile<'_>>) -> Result<(), Failure> {
    let Some(file) = file else { return Ok(()) };
    let mut text = Vec::new();
    let written = table.write_csv(&mut text).map_err(io::Error::other);
    written.map_err(Failure::Output)?;
    file.write(&text)
}

fn speed_of(words: &SpeedWords) -> Result<ExitCode, Failure> {
    let inputs = [words.case.clone()];
    let file = OutputFile::check(words.output.as_deref(), words.force, &inputs)?;
    let (name, case) = case_of(&words.case, &words.set)?;
    let stop =
        Stop::listen().map_err(|e| Failure::Usage(format!("Signals cannot be caught: {e}")))?;
    let usage = |why: SpeedError| Failure::Usage(format!("{name}: {why}."));
    let plan = speed::plan(&case).map_err(usage)?;
    let mut line = progress::Line::new();
    let mut tell = |begun: usize, of: usize, what: &str| {
        line.words(&format!("{begun} of {of}: {what}"));
    };
    let study = match speed::compute(&case, plan, words.repeats, stop.cancel(), &mut tell) {
        Ok(study) => study,
        Err(why) => return stopped(&stop, usage(why)),
    };
    drop(line);
    let table = speed::table(&study);
    write_csv(&table, file.as_ref())?;
    let glyphs = if words.ascii {
        Glyphs::Ascii
    } else {
        Glyphs::Braille
    };
    let chart = draw(&speed::chart(&study), PLOT.0, PLOT.1, glyphs).to_text();
    let mesh = speed::mesh_table(&study).to_text(WIDTH);
    output::results(
        &format!("{}\n{chart}\n{mesh}", table.to_text(WIDTH)),
        words.ascii,
    )?;
    Ok(ExitCode::SUCCESS)
}

/// The case of a file with what is set on top of it, and its name.
fn case_of(file: &Path, set: &[String]) -> Result<(String, Case), Failure> {
    let loaded = cases::load(file)?;
    let text = cases::set(&loaded.text, set)?;
    let case = cases::parse(&text, &loaded.file)?;
    Ok((loaded.name, case))
}

/// How a study ends that did not come to its end: stopped by a signal, or in failure.
fn stopped(stop: &Stop, failure: Failure) -> Result<ExitCode, Failure> {
    let status = stop.status().ok_or(failure)?;
    output::message("Stopped before all points were computed.");
    Ok(status)
}

fn steps_of(words: &StepsWords) -> Result<ExitCode, Failure> {
    let inputs = [words.case.clone()];
    let file = OutputFile::check(words.output.as_deref(), words.force, &inputs)?;
    let (name, case) = case_of(&words.case, &words.set)?;
    let stop =
        Stop::listen().map_err(|e| Failure::Usage(format!("Signals cannot be caught: {e}")))?;
    let mut line = progress::Line::new();
    let mut tell = |begun: usize, of: usize, what: &str| {
        line.words(&format!("{begun} of {of}: {what}"));
    };
    let rows = match speed::compare(&case, words.variants, stop.cancel(), &mut tell) {
        Ok(rows) => rows,
        Err(why) => return stopped(&stop, Failure::Usage(format!("{name}: {why}."))),
    };
    drop(line);
    let table = speed::comparison_table(&rows, words.variants);
    write_csv(&table, file.as_ref())?;
    output::results(&table.to_text(WIDTH), words.ascii)?;
    Ok(ExitCode::SUCCESS)
}

fn hard_case(loaded: Loaded) -> Hard {
    Hard {
        file: loaded.file,
        text: loaded.text,
        case: loaded.case,
    }
}

/// Every trial on its own core.
fn compute(cases: &[Hard], stop: &Stop) -> Vec<Option<Computed>> {
    let line = Mutex::new(progress::Line::new());
    hard::compute_all(cases, stop.cancel(), &|all, done| {
        if let Ok(mut line) = line.lock() {
            line.words(&format!("{done} of {} trials computed", all.len()));
        }
    })
}
