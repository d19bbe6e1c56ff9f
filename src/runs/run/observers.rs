//! The observers of a run, and at which moments each of them acts.

use super::channel_statistics::ChannelStatistics;
use super::decimation::DecimatedRecord;
use super::energy_balance::EnergyBalance;
use super::late_samples::LateSamples;
use super::lines_along::LinesAlong;
use super::observer::{LineStep, NodeChange, Observer, OutputSample, RecordRow, RunEnd, RunRecord};
use super::output_times::OutputTimes;
use super::recorder_state::RecorderState;
use super::requested_statistics::{RequestedStatistic, requested};
use super::response::{AskedResponse, ResponseSums};
use super::step_envelope::{self, StepEnvelope};
use super::step_interval::StepInterval;
use super::touchdown_speed::TouchdownSpeed;
use super::wave_decomposition::{at_rest, decompose_response};
use super::{Profile, energy_balance};
use crate::case::{Case, ChannelId, ChannelSpec, Method};
use crate::fatigue::spot::SpotCounter;
use crate::modes::WkbMedium;
use crate::scene::{EnergyRates, Scene};

/// The observers of a line by itself.
pub(super) fn observers(
    case: &Case,
    scene: &Scene,
    channels: &[ChannelSpec],
) -> Vec<Box<dyn Observer>> {
    let rows = match case.solver.method {
        Method::Static => 1,
        _ => OutputTimes::new(case.solver.duration_s, case.output.interval_s).rows(),
    };
    let response = AskedResponse::of_case(case).map(|asked| RecordedResponse {
        asked,
        at_rest: match asked.period {
            Some(_) => vec![at_rest(scene)],
            None => Vec::new(),
        },
    });
    of_lines(ObservedRun {
        channels: channels.iter().map(|channel| channel.id.clone()).collect(),
        scenes: &[scene],
        along: LinesAlong::of_case(case, scene),
        balances: energy_balance::is_stated(case),
        duration: case.solver.duration_s,
        rows,
        statistics: requested(case, channels),
        response,
    })
}

/// The response that is recorded of the lines of a run.
pub struct RecordedResponse {
    /// What is asked for.
    pub asked: AskedResponse,
    /// The lines at rest, where one period drives them; `None` of one that waves do not run along.
    pub at_rest: Vec<Option<WkbMedium>>,
}

/// What the observers of a run are made for.
pub struct ObservedRun<'a> {
    /// The channels.
    pub channels: Vec<ChannelId>,
    /// The lines before the first step.
    pub scenes: &'a [&'a Scene],
    /// The cycles counted along them.
    pub along: LinesAlong,
    /// Whether the energy balance is read.
    pub balances: bool,
    /// The end of the run \[s\].
    pub duration: f64,
    /// Number of rows.
    pub rows: usize,
    /// The statistics that it asks for.
    pub statistics: Vec<RequestedStatistic>,
    /// The response, where it is asked for.
    pub response: Option<RecordedResponse>,
}

/// The observers of every run, in the order in which they complete the record: the first complete the profiles by the last state,
/// before any other reads them, and statistics come last, of what the others recorded.
#[must_use]
pub fn of_lines(run: ObservedRun<'_>) -> Vec<Box<dyn Observer>> {
    let scenes = run.scenes.iter().copied();
    let touchdown: Vec<TouchdownSpeed> = scenes.map(TouchdownSpeed::of_scene).collect();
    let late = LateSamples::of_duration(run.duration, run.channels.len());
    let sums = run.response.as_ref();
    let sums = sums.map(|response| ResponseSums::new(response.asked));
    vec![
        Box::new(StepEnvelope::of_scenes(run.scenes)),
        Box::new(touchdown),
        Box::new(run.along),
        Box::new(sums),
        Box::new(WaveDecomposition(run.response)),
        Box::new(run.balances.then(EnergyBalance::default)),
        Box::new(late),
        Box::new(DecimatedRecord::new(run.channels).with_room_for(run.rows)),
        Box::new(ChannelStatistics::new(run.statistics)),
    ]
}

impl Observer for StepEnvelope {
    fn accepted_step(&mut self, at: &LineStep<'_>, profile: &mut Profile) {
        self.step(at.scene, at.state, profile);
    }

    fn interval(&mut self, between: &StepInterval<'_>, profiles: &mut [Profile]) {
        self.widen(between, profiles);
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        for (line, profile) in end.lines.iter().zip(&mut record.profiles) {
            if let Some(state) = line.state {
                step_envelope::end(line.scene, state, profile);
            }
        }
    }
}

impl Observer for LinesAlong {
    fn accepted_step(&mut self, at: &LineStep<'_>, _: &mut Profile) {
        self.step(at);
    }

    fn save(&self, state: &mut RecorderState) {
        state.fatigue = self.counters().cloned().collect();
    }

    fn fits(&self, state: &RecorderState) -> bool {
        let sound = |counter: &SpotCounter| counter.is_sound();
        state.fatigue.len() == self.counters().count() && state.fatigue.iter().all(sound)
    }

    fn restore(&mut self, state: &RecorderState) {
        self.restore(&state.fatigue);
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        let arc = |number: usize| end.lines[number].scene.line.arc.as_slice();
        let (found, missing) = (*self).finish(arc);
        record.fatigue = found;
        record.warnings.extend(missing);
    }
}

/// Line by line.
impl Observer for Vec<TouchdownSpeed> {
    fn accepted_step(&mut self, at: &LineStep<'_>, _: &mut Profile) {
        if let Some(line) = self.get_mut(at.number) {
            line.update(at.scene, at.time, at.state);
        }
    }

    fn node_change(&mut self, change: NodeChange) {
        if let Some(line) = self.get_mut(change.line) {
            line.change_node(change.node, change.comes);
        }
    }

    fn save(&self, state: &mut RecorderState) {
        state.touchdown.clone_from(self);
    }

    fn fits(&self, state: &RecorderState) -> bool {
        state.touchdown.len() == self.len()
    }

    fn restore(&mut self, state: &RecorderState) {
        self.clone_from(&state.touchdown);
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        let lines = self.iter().zip(&record.profiles);
        let warnings = lines.filter_map(|(touchdown, profile)| touchdown.warning(&profile.line));
        record.warnings.extend(warnings);
    }
}

impl Observer for Option<ResponseSums> {
    fn reads_lines(&self) -> bool {
        self.is_some()
    }

    fn output(&mut self, sample: &OutputSample<'_>) {
        if let Some(response) = self {
            response.add(sample.time, sample.nodes);
        }
    }

    fn save(&self, state: &mut RecorderState) {
        state.response.clone_from(self);
    }

    fn restore(&mut self, state: &RecorderState) {
        // Without the sums of what was recorded before, half a window would count as a whole one.
        let unbegun = self.take();
        let unbegun = unbegun.filter(|r| r.begins_after(state.time().unwrap_or_default()));
        *self = state.response.clone().or(unbegun);
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        let Some(response) = *self else {
            return;
        };
        let mut first = 0;
        for (line, profile) in end.lines.iter().zip(&mut record.profiles) {
            let segments = &line.scene.line.segments;
            let diameter = |i: usize| segments[i.min(segments.len() - 1)].diameter;
            let nodes = first..first + line.scene.line_nodes();
            let diameters: Vec<f64> = (0..profile.arc.len()).map(diameter).collect();
            first = nodes.end;
            response.finish(nodes, &diameters, profile);
        }
    }
}

impl Observer for Option<EnergyBalance> {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut [Profile]) {
        if let Some(balance) = self {
            balance.update(between);
        }
    }

    fn energy_jump(&mut self, before: &EnergyRates, after: &EnergyRates) {
        if let Some(balance) = self {
            balance.jump(after.energy - before.energy);
        }
    }

    fn save(&self, state: &mut RecorderState) {
        state.energy = *self;
    }

    fn restore(&mut self, state: &RecorderState) {
        // Without what passed before, the rest would count as the whole.
        *self = state.energy;
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        record.energy = self.map_or_else(Vec::new, |balance| balance.quantities());
        record.balance = *self;
    }
}

impl Observer for LateSamples {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut [Profile]) {
        self.update(between);
    }

    fn save(&self, state: &mut RecorderState) {
        state.late.clone_from(self);
    }

    fn restore(&mut self, state: &RecorderState) {
        self.restore(&state.late);
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        record.late = *self;
    }
}

/// The two waves of opposite direction in the response.
struct WaveDecomposition(Option<RecordedResponse>);

impl Observer for WaveDecomposition {
    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        let Some(response) = self.0 else {
            return;
        };
        let Some(period) = response.asked.period else {
            return;
        };
        for (medium, profile) in response.at_rest.iter().zip(&mut record.profiles) {
            if let Some(medium) = medium {
                decompose_response(medium, period, profile);
            }
        }
    }
}

impl Observer for DecimatedRecord {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut [Profile]) {
        self.widen_extremes(between);
    }

    fn row(&mut self, row: &RecordRow<'_>) {
        self.row(row.time, row.values);
        self.add_shapes(row.shapes);
    }

    fn save(&self, state: &mut RecorderState) {
        let channels = || self.history().channels.iter();
        state.peaks = channels().map(|c| c.peak).collect();
        state.troughs = channels().map(|c| c.trough).collect();
    }

    fn restore(&mut self, state: &RecorderState) {
        let known = state.peaks.iter().zip(&state.troughs);
        for (channel, (peak, trough)) in self.channels_mut().iter_mut().zip(known) {
            (channel.peak, channel.trough) = (*peak, *trough);
        }
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        (record.history, record.shapes) = self.into_parts();
    }
}

impl Observer for ChannelStatistics {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut [Profile]) {
        self.interval(between);
    }

    fn row(&mut self, row: &RecordRow<'_>) {
        self.row(row.time, row.values);
    }

    fn save(&self, state: &mut RecorderState) {
        state.summaries = self.summaries();
    }

    fn fits(&self, state: &RecorderState) -> bool {
        state.summaries.len() == self.series()
    }

    fn restore(&mut self, state: &RecorderState) {
        self.restore(&state.summaries, state.time().unwrap_or_default());
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        let RunRecord {
            history, profiles, ..
        } = record;
        let (statistics, warnings) = (*self).finish(&history.channels, profiles);
        record.statistics = statistics;
        record.warnings.extend(warnings);
    }
}
