//! `seacable run`: a case computed and kept.

use std::{path::Path, process::ExitCode};

use super::{Failure, NOT_GOOD, args::RunWords, cases, output, progress, signals::Stop};
use crate::{
    case,
    report::text,
    run::{
        Resume, Run, RunState,
        job::{self, Event, Request},
        resume_request,
        store::{self, RunLocation, StoreError, Writer},
    },
};

pub(super) fn run(words: &RunWords) -> Result<ExitCode, Failure> {
    let (mut request, from) = match &words.resume {
        Some(dir) => {
            let (request, from) = resume_request(dir, words.until).map_err(Failure::Usage)?;
            (request, Some(from))
        }
        None => (request(words)?, None),
    };
    let stop =
        Stop::listen().map_err(|e| Failure::Usage(format!("Signals cannot be caught: {e}")))?;
    let place = match &words.out {
        Some(dir) => RunLocation::Exactly(dir.clone()),
        None => RunLocation::Below(store::DEFAULT_ROOT.into()),
    };
    let mut writer = Writer::begin(
        &place,
        request.beginning(),
        &case::stand_alone(&request.text, &request.case),
    )?;
    writer.id().clone_into(&mut request.id);

    let (run, trouble) = compute(&request, from.as_ref(), &stop, &mut writer);
    if let Some(error) = trouble {
        return Err(error.into());
    }
    let dir = writer.finish(&run)?;
    let mut text = format!("{}\n\n{}", dir.display(), text::summary(&run));
    if let Some(limits) = text::limits(&run, &request.case) {
        text.push_str(&format!("\n{limits}"));
    }
    if let Some(damping) = text::numerical_damping(&run.info.settings) {
        text.push_str(&format!("\nNumerical damping: {damping}\n"));
    }
    output::results(&text, words.ascii)?;
    Ok(status(&run, &stop))
}

/// The case with every `--set` and `--solver` applied, in their order.
fn request(words: &RunWords) -> Result<Request, Failure> {
    let loaded = cases::load(words.case.as_deref().unwrap_or(Path::new("")))?;
    let mut overrides = words.set.clone();
    overrides.extend(words.solver.map(|s| format!("solver.method={}", s.word())));
    let text = cases::set(&loaded.text, &overrides)?;
    let case = cases::parse(&text, &loaded.name)?;
    Ok(Request {
        case,
        text,
        file: loaded.file,
        overrides,
        id: String::new(),
    })
}

/// Computes while everything that comes out goes to disk. When the disk refuses, the run is cancelled.
fn compute(
    request: &Request,
    from: Option<&Resume>,
    stop: &Stop,
    writer: &mut Writer,
) -> (Run, Option<StoreError>) {
    let mut line = progress::Line::new();
    let mut trouble = None;
    let run = job::execute_from(request, from, stop.cancel(), &mut |event: Event| {
        match &event {
            Event::Frame(frame) => line.run(&frame.progress),
            Event::Estimating => line.words("Estimating the numerical errors"),
            Event::Started { .. } | Event::Checkpoint(_) | Event::Finished(_) => {}
        }
        if trouble.is_none() {
            trouble = writer.event(&event).err();
            if trouble.is_some() {
                stop.ask();
            }
        }
    });
    (run, trouble)
}

fn status(run: &Run, stop: &Stop) -> ExitCode {
    for warning in &run.info.warnings {
        output::message(&format!("warning: {warning}"));
    }
    match run.info.state {
        RunState::Done => ExitCode::SUCCESS,
        RunState::Cancelled | RunState::Partial => {
            output::message("The run was stopped before its end; what it had is kept.");
            stop.status().unwrap_or(ExitCode::from(NOT_GOOD))
        }
        RunState::Failed => {
            let why = run.info.failure.as_deref().unwrap_or("no reason was given");
            output::message(&format!("error: The run failed: {why}"));
            ExitCode::from(NOT_GOOD)
        }
    }
}
