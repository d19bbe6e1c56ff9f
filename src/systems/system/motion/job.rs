//! A system computed in time as a [`Run`]: what the run store, reports, comparisons and the screen know.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

pub use super::channel_result::STATISTICS;
use super::checkpoint::ResumedSystem;
use super::march::Stored;
use super::run::{MotionRun, run_stored};
use crate::case::attachments::with_files;
use crate::run::event::JobEvent;
use crate::run::store::{now, rfc3339};
use crate::run::{
    Cost, History, Run, RunInfo, RunState, Settings, VERSION, Work, refuse_not_finite,
};
use crate::system::SolvedSystem;
use crate::system::model::MotionInputs;

/// A run of a system in time that is asked for.
#[derive(Debug, Clone)]
pub struct SystemRequest {
    /// The system at rest.
    pub solved: Arc<SolvedSystem>,
    /// How it is computed.
    pub motion: MotionInputs,
    /// Its text, with every override applied; kept with the run.
    pub text: String,
    /// File name of the system.
    pub file: String,
    /// Keys set on top of the file, as `key=value`.
    pub overrides: Vec<String>,
    /// Name of the run.
    pub id: String,
}

impl SystemRequest {
    /// The run that a file asks for, with the files that it names; nothing without a table `[solver]`.
    #[must_use]
    pub fn new(
        solved: Arc<SolvedSystem>,
        text: &str,
        file: String,
        overrides: Vec<String>,
    ) -> Option<Self> {
        let motion = solved.file.solver.clone()?;
        let text = with_files(text, &solved.file.files).into_owned();
        Some(Self {
            solved,
            motion,
            text,
            file,
            overrides,
            id: String::new(),
        })
    }

    /// The content of `run.toml` while the run is computed.
    #[must_use]
    pub fn initial_info(&self) -> RunInfo {
        RunInfo {
            id: self.id.clone(),
            title: self.solved.file.about.title.clone(),
            case_file: self.file.clone(),
            state: RunState::Partial,
            version: VERSION.to_owned(),
            started: rfc3339(now()),
            overrides: self.overrides.clone(),
            failure: None,
            warnings: Vec::new(),
            happened: Vec::new(),
            settings: Settings {
                method: self.motion.method.name().to_owned(),
                duration_s: self.motion.duration_s,
                ..Settings::default()
            },
            work: Work::default(),
            cost: Cost::default(),
        }
    }
}

/// Computes a request, or resumes an earlier run of it, with the companions that estimate errors if the file asks for them. A failure is reported in the run, which keeps
/// the results before it. Does not send [`JobEvent::Finished`]: the run is returned.
pub fn execute(
    request: &SystemRequest,
    from: Option<&ResumedSystem>,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Run {
    let info = request.initial_info();
    let case_text = request.text.clone();
    let stored = Some(Stored { from });
    match run_stored(&request.solved, &request.motion, stored, cancel, events) {
        Ok(computed) => {
            let mut run = of_result(info, case_text, computed);
            refuse_not_finite(&mut run);
            run
        }
        Err(why) => Run {
            info: RunInfo {
                state: RunState::Failed,
                failure: Some(format!("{}; {}", why.problem, why.remedy)),
                ..info
            },
            case_text,
            history: History::default(),
            shapes: Vec::new(),
            profiles: Vec::new(),
            summary: Vec::new(),
            fatigue: Vec::new(),
        },
    }
}

/// The result of a computation as a run.
fn of_result(info: RunInfo, case_text: String, computed: MotionRun) -> Run {
    Run {
        info: RunInfo {
            state: computed.state,
            settings: computed.stored_settings,
            failure: computed.failure,
            warnings: computed.warnings,
            happened: computed.happened,
            work: Work {
                steps: computed.work.steps,
                rejections: computed.work.rejections,
                iterations: computed.work.iterations,
                evaluations: computed.work.evaluations,
            },
            cost: computed.cost,
            ..info
        },
        case_text,
        history: computed.history,
        shapes: computed.shapes,
        profiles: computed.profiles,
        summary: computed.summary,
        fatigue: computed.fatigue,
    }
}
