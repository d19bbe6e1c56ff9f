//! A system computed in time as a [`Run`]: what the run store, reports, comparisons and the screen know.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::checkpoint::ResumedSystem;
use super::march::Stored;
use super::run::{ChannelResult, MotionRun, run_stored};
use crate::case::attachments::with_files;
use crate::case::{ChannelQuantity, QuantityId, Statistic, Subject};
use crate::run::event::JobEvent;
use crate::run::store::{now, rfc3339};
use crate::run::{
    Cost, History, Quantity, Run, RunInfo, RunState, Settings, VERSION, Work, refuse_not_finite,
};
use crate::system::SolvedSystem;
use crate::system::model::{MotionInputs, MotionMethod};

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
            let mut run = of_result(info, case_text, &request.motion, computed);
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
fn of_result(info: RunInfo, case_text: String, given: &MotionInputs, computed: MotionRun) -> Run {
    let mut summary: Vec<Quantity> = computed.channels.iter().flat_map(statistics).collect();
    let used = &computed.settings;
    let window = used.settled_from_s.map(|from| [from, used.duration_s]);
    let settled = |channel| settled(channel, window);
    summary.extend(computed.channels.iter().flat_map(settled));
    summary.extend(computed.along.iter().cloned());
    summary.extend(computed.energy.iter().cloned());
    Run {
        info: RunInfo {
            state: computed.state,
            settings: settings(given, &computed),
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
        summary,
        fatigue: computed.fatigue,
    }
}

/// The settings, as those of a run of a line.
fn settings(given: &MotionInputs, computed: &MotionRun) -> Settings {
    let used = &computed.settings;
    let implicit = used.method == MotionMethod::Alpha;
    let estimated = computed.channels.iter().any(|c| c.time_error.is_some());
    let error_method = match estimated {
        true => {
            "companion runs with steps about twice as long and with half the segments, each by 3 times Richardson, order 2"
        }
        false => "not estimated",
    };
    Settings {
        method: used.method.name().to_owned(),
        duration_s: used.duration_s,
        time_step_s: used.time_step_s,
        step_tolerance: used.step_tolerance,
        time_step_automatic: given.time_step_s.is_none(),
        rho_inf: implicit.then_some(used.rho_inf),
        position_tolerance_m: implicit.then_some(used.position_tolerance_m),
        nodes: computed.work.nodes,
        output_interval_s: used.interval_s,
        error_method: error_method.to_owned(),
        ..Settings::default()
    }
}

/// Statistics of a channel: least, greatest, mean and last value.
pub const STATISTICS: [Statistic; 4] = [
    Statistic::Min,
    Statistic::Max,
    Statistic::Mean,
    Statistic::Final,
];

fn statistics(channel: &ChannelResult) -> impl Iterator<Item = Quantity> {
    let numbers = channel.summary.numbers();
    STATISTICS
        .into_iter()
        .enumerate()
        .map(move |(k, statistic)| {
            let of = Subject::Channel(channel.id.clone());
            Quantity {
                time_error: channel.time_error.map(|errors| errors[k]),
                mesh_error: channel.mesh_error.map(|errors| errors[k]),
                ..Quantity::new(QuantityId::new(of, statistic, None), numbers[k])
            }
        })
}

/// The extremes of what checks compare after the start that they leave out. Their errors are those of the whole run.
fn settled(
    channel: &ChannelResult,
    window: Option<[f64; 2]>,
) -> impl Iterator<Item = Quantity> + use<> {
    let checked = ChannelQuantity::CHECKED.contains(&channel.id.quantity);
    let found = channel.settled.filter(|_| checked && window.is_some());
    let id = channel.id.clone();
    let statistics = found.map(|ends| [Statistic::Min, Statistic::Max].into_iter().zip(ends));
    statistics.into_iter().flatten().map(move |(of, value)| {
        let subject = Subject::Channel(id.clone());
        Quantity::new(QuantityId::new(subject, of, window), value)
    })
}
