//! What threads and files may answer to the workbench, in hostile words. A new effect needs its answer here.

use std::path::PathBuf;
use std::sync::Arc;

use seacable::run::{Progress, Settings, Work};
use seacable::study::sweep::{SweepOutcomes, SweepResults, SweepSnapshot};
use seacable::study::{TrialOutcome, TrialVerdict};
use seacable::tui::state::job_process::{FoundJob, JobProcess, ProcessEffect, ProcessMsg};
use seacable::tui::state::sweep_request::{SweepEffect, SweepMsg};
use seacable::tui::state::sweep_verdict::SweepVerdict;
use seacable::tui::state::sweeps::SweepRead;
use seacable::tui::state::trials::TrialProgress;
use seacable::tui::state::{JobState, Severity};
use seacable::tui::{Effect, Msg};
use seacable::visible::is_invisible;

use super::HOSTILE;
use super::documents::path;

/// The worst that can be answered to an effect, one after the other.
pub(super) fn answers(effect: Effect) -> Vec<Msg> {
    let said = || HOSTILE.to_owned();
    let long = || format!("{HOSTILE}\n\n{HOSTILE}\t{HOSTILE}\n").repeat(30);
    let say = |level| Msg::Say(level, long());
    match effect {
        Effect::ReadCases => Vec::new(),
        Effect::ReadCase(file) => vec![Msg::CaseRejected(file, long())],
        Effect::SaveCase { text, .. } => vec![
            Msg::NotSaved(said()),
            Msg::ChangedOnDisk,
            Msg::Saved(path(), text),
        ],
        Effect::Watch(file) => vec![Msg::ChangedOutside(file, said())],
        Effect::NewFile { .. } => vec![Msg::NotMade(long())],
        Effect::KeepRecovery { .. }
        | Effect::TakeOverRecovery { .. }
        | Effect::DropRecovery(_)
        | Effect::RememberGlyphs(_) => {
            vec![say(Severity::Warning)]
        }
        Effect::Start { ticket, .. } => vec![
            Msg::Stored(ticket, path()),
            Msg::Recorded(ticket, Box::default()),
            Msg::JobFailed(ticket, long()),
        ],
        Effect::StartTrials { ticket, of: _ } => {
            vec![Msg::TrialProgress(ticket, Box::new(trials()))]
        }
        Effect::EditFile(_) => vec![Msg::Edited(Err(long())), Msg::Edited(Ok(long()))],
        Effect::ReadEdited(_) => vec![Msg::Edited(Err(long()))],
        Effect::FindModes { text, .. } => vec![Msg::Modes(text, Err(long()))],
        Effect::PrepareResume(dir, until) => vec![Msg::ResumeReady(dir, until, Err(long()))],
        Effect::Compare { name, .. } => vec![
            Msg::Page(name, Err(long()), false),
            Msg::Page(said(), Ok(long()), false),
        ],
        Effect::Study(request, _) => vec![
            Msg::Page(request.of.title(&request.result), Err(long()), true),
            Msg::Page(request.of.title(&request.result), Ok(long()), true),
        ],
        Effect::WriteNotes(..) | Effect::WriteText { .. } => vec![say(Severity::Error)],
        Effect::ReadRunCase { dir, wanted, .. } => vec![Msg::RunCase(dir, wanted, Err(long()))],
        Effect::ReadRun(dir) => vec![Msg::RunRead(dir, Err(long()))],
        Effect::DeleteRuns(dirs) => vec![Msg::RunsDeleted(dirs), say(Severity::Error)],
        Effect::KeepRun(run) => vec![Msg::Kept(PathBuf::from(HOSTILE), run), say(Severity::Error)],
        Effect::Copy(text) => {
            let raw: Vec<char> = text
                .chars()
                .filter(|c| is_invisible(*c) && *c != '\n')
                .collect();
            assert!(raw.is_empty(), "{raw:?} for the clipboard:\n{text}");
            vec![say(Severity::Info)]
        }
        Effect::ReadSettings | Effect::EditKeys => vec![Msg::SettingsRead(Box::new(settings()))],
        Effect::KeepScreen(..) | Effect::KeepSession(_) => vec![say(Severity::Warning)],
        Effect::Sweep(effect) => sweeps(effect),
        Effect::Process(ProcessEffect::Submit(ticket, new)) => vec![
            process(ProcessMsg::Numbered(ticket, 7)),
            Msg::Stored(ticket, PathBuf::from(HOSTILE)),
            process(ProcessMsg::NotSubmitted(ticket, new, long())),
        ],
        Effect::Process(_) => Vec::new(),
        // The desk answers these, or they change nothing that is seen.
        Effect::MakePart(_)
        | Effect::CheckValues(_)
        | Effect::ComputeShip(_)
        | Effect::Plan { .. }
        | Effect::Vary(..)
        | Effect::CheckEdits(_)
        | Effect::MakeReport(_)
        | Effect::WriteMade(_)
        | Effect::ListRuns { .. }
        | Effect::RefreshRuns
        | Effect::Cancel(_)
        | Effect::Repaint
        | Effect::Suspend
        | Effect::Quit => Vec::new(),
    }
}

/// A file of keys with hostile words in it.
fn settings() -> seacable::tui::settings::UserSettings {
    let text = format!("[keys]\nrun = {HOSTILE:?}\n{HOSTILE:?} = \"x\"\n");
    let (keys, faults) = seacable::tui::bindings::file::read(&text, HOSTILE);
    seacable::tui::settings::UserSettings {
        keys,
        faults,
        ..Default::default()
    }
}

fn process(said: ProcessMsg) -> Msg {
    Msg::Process(said)
}

/// Jobs of other screens and hosts, in every state.
pub(super) fn found_jobs() -> Vec<Msg> {
    let long = || format!("{HOSTILE}\n\n{HOSTILE}\t{HOSTILE}\n").repeat(30);
    let states = [
        JobState::Queued,
        JobState::Done,
        JobState::Failed(long()),
        JobState::Cancelled,
        JobState::Killed(long()),
        JobState::Elsewhere(long()),
    ];
    let found = states.into_iter().zip(1..).map(|(state, number)| {
        let found = FoundJob {
            name: HOSTILE.to_owned(),
            is_sweep: false,
            process: JobProcess {
                number: Some(number),
                host: matches!(state, JobState::Elsewhere(_)).then(|| HOSTILE.to_owned()),
                case: PathBuf::from(HOSTILE),
                label: HOSTILE.to_owned(),
                results: Some(PathBuf::from(HOSTILE)),
                ..JobProcess::default()
            },
            state,
            progress: Progress::default(),
        };
        process(ProcessMsg::Found(Box::new(found)))
    });
    found
        .chain([process(ProcessMsg::EndedByLogout(long()))])
        .collect()
}

/// Sweeps that are listed, read, refused and begun.
fn sweeps(effect: SweepEffect) -> Vec<Msg> {
    let long = || format!("{HOSTILE}\n\n{HOSTILE}\t{HOSTILE}\n").repeat(30);
    let told = match effect {
        SweepEffect::List(file) => vec![SweepMsg::Listed(file, Vec::new())],
        SweepEffect::Read { dir, .. } => vec![SweepMsg::Read(dir, Err(long()))],
        SweepEffect::Check(snapshot) => {
            let verdict = SweepVerdict::of_snapshot(&snapshot);
            vec![SweepMsg::Checked(snapshot.dir.clone(), Arc::new(verdict))]
        }
        SweepEffect::Compare(snapshot, request) => {
            vec![SweepMsg::Compared(
                snapshot.dir.clone(),
                request.text,
                false,
            )]
        }
        SweepEffect::Start(ticket, request) => {
            let dir = PathBuf::from(HOSTILE);
            let mut told = vec![SweepMsg::Begun(ticket, dir.clone())];
            if let Ok(plan) = request.plan() {
                let SweepResults::InTime(ids) = plan.sweep.results.clone() else {
                    return Vec::new();
                };
                let refused = plan.sweep.variation.points.iter();
                let refused = refused.map(|_| Some(Err(HOSTILE.to_owned()))).collect();
                let outcomes = SweepOutcomes::Runs(refused, ids);
                let found = SweepSnapshot::computed(&dir, Arc::new(plan), outcomes);
                told.push(SweepMsg::Read(dir, Ok(SweepRead::new(found))));
            }
            told.push(SweepMsg::Ended(ticket, Err(long())));
            told
        }
    };
    told.into_iter().map(Msg::Sweep).collect()
}

/// Trials of a case with hostile names, computed, refused and wrong.
fn trials() -> TrialProgress {
    let said = || HOSTILE.to_owned();
    let trial = |outcome, reason| TrialVerdict {
        case: said(),
        file: said(),
        trial: said(),
        settings: Some(Settings {
            method: said(),
            error_method: said(),
            method_reason: Some(said()),
            ..Settings::default()
        }),
        work: Work::default(),
        outcome,
        reason,
        expect_refusal: false,
        numbers: Vec::new(),
    };
    TrialProgress {
        findings: vec![
            trial(TrialOutcome::Ok, None),
            trial(TrialOutcome::Refused, Some(said())),
            trial(TrialOutcome::Wrong, Some(said())),
        ],
        done: 3,
        all: 4,
        over: false,
    }
}
