//! One computation of a case, without companions: scene, settings, simulation, and what follows from its record.

use std::cell::OnceCell;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::event::{JobEvent, Listener};
use super::line_bounds;
use super::line_under_way::{LineUnderWay, phases, plan};
use super::march::MarchResult;
use super::observer::RunRecord;
use super::recorder::Recorder;
use super::response::AskedResponse;
use super::settings::{SceneBounds, damped_modes_warning, set_numerical_damping};
use super::simulation::simulate;
use super::{Cost, Profile, Quantity, ResumedRun, RunState, Settings, Work};
use super::{natural_modes, published_curve, steady_state};
use crate::background::cpu_time;
use crate::case::{self, Case, WaterSurface};
use crate::scene::{self, Scene};

/// The result of one computation.
#[derive(Debug, Clone)]
pub struct Computed {
    /// How it ended.
    pub outcome: MarchResult,
    /// What the user should know.
    pub warnings: Vec<String>,
    /// Settings that it used.
    pub settings: Settings,
    /// What it took.
    pub cost: Cost,
    /// What it recorded.
    pub record: RunRecord,
    /// Natural modes, and the time from which on the response is steady; without errors.
    pub modes: Vec<Quantity>,
    /// Differences from the published curves of the case, without errors.
    pub curves: Vec<Quantity>,
    /// What happened to the lines, in words.
    pub happened: Vec<String>,
}

impl Computed {
    /// A computation that failed before it began.
    #[must_use]
    pub fn failed(failure: String) -> Self {
        Self::without_record(MarchResult::failed(failure, Work::default()))
    }

    /// A computation that was stopped before it began.
    #[must_use]
    pub fn stopped() -> Self {
        Self::without_record(MarchResult::stopped(Work::default()))
    }

    /// Whether it was not stopped before it recorded anything.
    #[must_use]
    pub fn has_record(&self) -> bool {
        self.outcome.state != RunState::Cancelled || !self.record.history.time.is_empty()
    }

    /// Takes the natural modes that the file asks for, or why there are none; with a warning where the steps change them.
    pub fn take_modes(&mut self, found: Result<Vec<Quantity>, String>) {
        let found = found.unwrap_or_else(|why| {
            let why = format!("natural modes are not computed: {why}");
            self.warnings.push(why);
            Vec::new()
        });
        let frequencies = found.iter().filter(|q| q.unit() == "Hz");
        let frequencies: Vec<f64> = frequencies.map(|q| q.value).collect();
        let steps = &self.outcome.lengths;
        let damped = damped_modes_warning(&self.settings, steps, &frequencies);
        self.warnings.extend(damped);
        self.modes.splice(0..0, found);
    }

    fn without_record(outcome: MarchResult) -> Self {
        Self {
            outcome,
            warnings: Vec::new(),
            settings: Settings::default(),
            cost: Cost::default(),
            record: RunRecord::default(),
            modes: Vec::new(),
            curves: Vec::new(),
            happened: Vec::new(),
        }
    }
}

/// Mesh and time step of a computation, by those that the case sets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Resolution {
    /// Segments are this many times as long.
    pub(super) coarsening: usize,
    /// The time error is `r^p` times as large, p the order of the method: r times the step or, where the steps vary,
    /// `r^(p + 1)` times the error in each (which grows with one power more) and r times the longest.
    pub(super) step_ratio: f64,
}

impl Resolution {
    /// As the case sets it.
    pub(super) const AS_SET: Self = Self {
        coarsening: 1,
        step_ratio: 1.0,
    };
}

/// Computes a case, or resumes an earlier run of it.
pub(super) fn compute(
    case: &Case,
    resolution: Resolution,
    from: Option<&ResumedRun>,
    cancel: &AtomicBool,
    events: Listener<'_>,
) -> Computed {
    let scene = match scene::build(case, resolution.coarsening) {
        Ok(scene) => scene,
        Err(error) => return Computed::failed(error.to_string()),
    };
    let bounds = line_bounds::bounds(case, &scene);
    let mut settings = bounds.settings(&case.solver, case.output.interval_s);
    let ratio = resolution.step_ratio;
    settings.time_step_s *= ratio;
    settings.step_tolerance = settings.step_tolerance.map(|t| ratio.powi(3) * t);
    let channels = case::channels(case);
    let events: Listener<'_> = match events {
        Some(events) => {
            events(JobEvent::Started {
                channels: channels.iter().map(|channel| channel.id.clone()).collect(),
                lines: Vec::new(),
            });
            Some(events)
        }
        None => None,
    };
    let (cpu, wall) = (cpu_time(), Instant::now());
    let mut warnings = warnings(&scene, &settings);
    let phases = phases(scene);
    let recorder = Recorder::new(plan(case, &phases[0], &channels), events, cancel);
    let line = LineUnderWay {
        case,
        settings: &settings,
        phases: &phases,
        phase: 0,
        channels: &channels,
        digests: OnceCell::new(),
    };
    let (outcome, record) = simulate(line, recorder, &mut warnings, from);
    let cost = Cost {
        cpu_s: cpu_time() - cpu,
        wall_s: wall.elapsed().as_secs_f64(),
        companions_wall_s: 0.0,
    };
    let computed = Computed {
        outcome,
        warnings,
        settings,
        cost,
        record,
        modes: Vec::new(),
        curves: Vec::new(),
        happened: Vec::new(),
    };
    evaluate(case, (&phases[0], &bounds), computed)
}

/// Adds what follows from the record of a computation and from the line at rest: warnings, natural modes, differences
/// from published curves.
fn evaluate(
    case: &Case,
    (scene, bounds): (&Scene, &SceneBounds),
    mut computed: Computed,
) -> Computed {
    if !computed.has_record() {
        return computed;
    }
    let (warnings, record) = (&mut computed.warnings, &mut computed.record);
    let steps = &computed.outcome.lengths;
    set_numerical_damping(&mut computed.settings, bounds.forced_period, steps);
    warnings.extend(out_of_water(case, record.profile()));
    warnings.append(&mut record.warnings);
    let steady = steady_state::settling_quantity(AskedResponse::of_case(case), &record.shapes);
    computed.modes.extend(steady);
    computed.take_modes(natural_modes::frequencies(case, scene));
    let record = &computed.record;
    let curves = published_curve::of_file_as_it_stands(case, &case.study, &case.published_curve);
    computed.curves = published_curve::differences(&curves, &record.history);
    computed
}

/// Height above still water from which a node counts as out of the water \[m\].
const LITTLE: f64 = 1e-3;

/// That a part of the line was above still water and counted as under water all the same, at output times.
fn out_of_water(case: &Case, profile: &Profile) -> Option<String> {
    let water = &case.environment;
    if water.water_surface == WaterSurface::Crossed || water.water_density_kg_per_m3 <= 0.0 {
        return None;
    }
    let above = profile.z_max.iter().filter(|z| **z > LITTLE).count();
    (above > 0).then(|| {
        format!(
            "{above} of {} nodes came above still water and counted as under water all the same; \
             environment.water_surface = \"crossed\" gives them their weight in air",
            profile.z_max.len()
        )
    })
}

/// The warning of a quasi-static run.
pub const INERTIA_LEFT_OUT: &str =
    "quasi-static: inertia is left out; compare with `alpha` to see whether it matters";

/// Warnings of the scene and the method.
fn warnings(scene: &Scene, settings: &Settings) -> Vec<String> {
    let mut list = scene.labels.remarks.clone();
    if settings.method == "quasi" && scene.line.weight.iter().sum::<f64>() > 0.0 {
        list.push(INERTIA_LEFT_OUT.to_owned());
    }
    list
}
