//! The observers of a run, and at which moments each of them acts.

use super::along::AlongCount;
use super::channel_statistics::ChannelStatistics;
use super::decimation::DecimatedRecord;
use super::energy_balance::EnergyBalance;
use super::late_samples::LateSamples;
use super::observer::{Observation, Observer, OutputSample, RecordRow, RunEnd, RunRecord};
use super::recorder::OutputTimes;
use super::requested_statistics::requested;
use super::response::ResponseSums;
use super::step_envelope::{self, StepEnvelope};
use super::step_interval::StepInterval;
use super::touchdown_speed::TouchdownSpeed;
use super::{Checkpoint, Profile, energy_balance, wave_decomposition};
use crate::case::{Case, ChannelSpec, Method};
use crate::fatigue::spot::SpotCounter;
use crate::scene::Scene;

/// All observers, in the order in which they complete the record: statistics come last, of what the others recorded.
pub(super) fn observers(
    case: &Case,
    scene: &Scene,
    channels: &[ChannelSpec],
) -> Vec<Box<dyn Observer>> {
    let ids = channels.iter().map(|channel| channel.id.clone());
    let rows = match case.solver.method {
        Method::Static => 1,
        _ => OutputTimes::of(case).rows(),
    };
    vec![
        Box::new(StepEnvelope),
        Box::new(TouchdownSpeed::of(scene)),
        Box::new(AlongCount::of_case(case, scene)),
        Box::new(ResponseSums::of(case)),
        Box::new(WaveDecomposition),
        Box::new(energy_balance::is_stated(case).then(EnergyBalance::default)),
        Box::new(LateSamples::of(case.solver.duration_s, channels.len())),
        Box::new(DecimatedRecord::new(ids).with_room_for(rows)),
        Box::new(ChannelStatistics::new(requested(case, channels))),
    ]
}

impl Observer for StepEnvelope {
    fn accepted_step(&mut self, at: &Observation<'_>, profile: &mut Profile) {
        self.step(at.scene, at.state, profile);
    }

    fn interval(&mut self, between: &StepInterval<'_>, profile: &mut Profile) {
        self.widen(between, profile);
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        if let Some(state) = end.state {
            step_envelope::end(end.last, state, &mut record.profile);
        }
    }
}

impl Observer for Option<AlongCount> {
    fn accepted_step(&mut self, at: &Observation<'_>, _: &mut Profile) {
        if let Some(count) = self {
            count.step(at.scene, at.time, at.state);
        }
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        let counters = self.as_ref().map(AlongCount::counters);
        checkpoint.fatigue = counters.unwrap_or_default().to_vec();
    }

    fn fits(&self, checkpoint: &Checkpoint) -> bool {
        let counters = self.as_ref().map_or(0, |count| count.counters().len());
        let sound = |counter: &SpotCounter| counter.is_sound();
        checkpoint.fatigue.len() == counters && checkpoint.fatigue.iter().all(sound)
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        if let Some(count) = self {
            count.restore(&checkpoint.fatigue);
        }
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        let Some(count) = *self else { return };
        let (found, missing) = count.finish(&end.last.line.arc);
        record.fatigue = found;
        record.warnings.extend(missing);
    }
}

impl Observer for TouchdownSpeed {
    fn accepted_step(&mut self, at: &Observation<'_>, _: &mut Profile) {
        self.update(at.scene, at.time, at.state);
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.touchdown = Some(self.clone());
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        if let Some(known) = &checkpoint.touchdown {
            self.clone_from(known);
        }
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        record.warnings.extend(self.warning());
    }
}

impl Observer for Option<ResponseSums> {
    fn reads_line(&self) -> bool {
        self.is_some()
    }

    fn output(&mut self, sample: &OutputSample<'_>) {
        if let Some(response) = self {
            response.add(sample.time, sample.nodes);
        }
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.response.clone_from(self);
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        // Without the sums of what was recorded before, half a window would count as a whole one.
        let unbegun = self.take();
        let unbegun = unbegun.filter(|r| r.begins_after(checkpoint.time()));
        *self = checkpoint.response.clone().or(unbegun);
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        let Some(response) = *self else { return };
        let segments = &end.last.line.segments;
        let diameter = |i: usize| segments[i.min(segments.len() - 1)].diameter;
        let diameters: Vec<f64> = (0..record.profile.arc.len()).map(diameter).collect();
        response.finish(&diameters, &mut record.profile);
    }
}

impl Observer for Option<EnergyBalance> {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut Profile) {
        if let Some(balance) = self {
            balance.update(between);
        }
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.energy = *self;
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        // Without what passed before, the rest would count as the whole.
        *self = checkpoint.energy;
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        let balance = self.map_or_else(Vec::new, |balance| balance.quantities());
        record.energy = balance;
    }
}

impl Observer for LateSamples {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut Profile) {
        self.update(between);
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.late.clone_from(self);
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        self.restore(&checkpoint.late);
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        record.late = *self;
    }
}

/// The two waves of opposite direction in the response.
struct WaveDecomposition;

impl Observer for WaveDecomposition {
    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        wave_decomposition::decompose_response(end.case, end.initial, &mut record.profile);
    }
}

impl Observer for DecimatedRecord {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut Profile) {
        self.widen_extremes(between);
    }

    fn row(&mut self, row: &RecordRow<'_>) {
        self.row(row.time, row.values);
        if let Some(shape) = row.shape {
            self.shape(shape.clone());
        }
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        let channels = || self.history().channels.iter();
        checkpoint.peaks = channels().map(|c| c.peak).collect();
        checkpoint.troughs = channels().map(|c| c.trough).collect();
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        let known = checkpoint.peaks.iter().zip(&checkpoint.troughs);
        for (channel, (peak, trough)) in self.channels_mut().iter_mut().zip(known) {
            (channel.peak, channel.trough) = (*peak, *trough);
        }
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        (record.history, record.shapes) = self.into_parts();
    }
}

impl Observer for ChannelStatistics {
    fn interval(&mut self, between: &StepInterval<'_>, _: &mut Profile) {
        self.interval(between);
    }

    fn row(&mut self, row: &RecordRow<'_>) {
        self.row(row.time, row.values);
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.summaries = self.summaries();
    }

    fn fits(&self, checkpoint: &Checkpoint) -> bool {
        checkpoint.summaries.len() == self.series()
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        self.restore(&checkpoint.summaries, checkpoint.time());
    }

    fn finish(self: Box<Self>, _: &RunEnd<'_>, record: &mut RunRecord) {
        let RunRecord {
            history, profile, ..
        } = record;
        let (statistics, warnings) = (*self).finish(&history.channels, profile);
        record.statistics = statistics;
        record.warnings.extend(warnings);
    }
}
