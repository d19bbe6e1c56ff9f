//! The observers of a run, and at which moments each of them acts.

use super::channel_statistics::ChannelStatistics;
use super::decimation::DecimatedRecord;
use super::observer::{Observation, Observer, RecordRow, RunEnd, RunRecord};
use super::peak_tension::PeakTension;
use super::requested_statistics::requested;
use super::response::Response;
use super::step_envelope::StepEnvelope;
use super::touchdown_speed::TouchdownSpeed;
use super::{Checkpoint, Profile, output_envelope, wave_decomposition};
use crate::case::{Case, ChannelSpec};
use crate::scene::Scene;

/// All observers, in the order in which they complete the record: statistics come last, of what the others recorded.
pub(super) fn observers(
    case: &Case,
    scene: &Scene,
    channels: &[ChannelSpec],
) -> Vec<Box<dyn Observer>> {
    let ids = channels.iter().map(|channel| channel.id.clone());
    vec![
        Box::new(PeakTension::of(case, scene)),
        Box::new(StepEnvelope::of(case, scene)),
        Box::new(TouchdownSpeed::of(scene)),
        Box::new(OutputEnvelope),
        Box::new(Response::of(case)),
        Box::new(WaveDecomposition),
        Box::new(DecimatedRecord::new(ids)),
        Box::new(ChannelStatistics::new(requested(case, channels))),
    ]
}

impl Observer for PeakTension {
    fn accepted_step(&mut self, at: &Observation<'_>, profile: &mut Profile) {
        self.update(at.scene, at.state, &mut profile.tension_max);
    }

    fn line_changes(&mut self, before: &Scene, profile: &mut Profile) {
        self.settle(before, &mut profile.tension_max);
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.greatest_lengths = self.greatest_lengths();
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        self.restore(&checkpoint.greatest_lengths, &checkpoint.state);
    }

    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        self.settle(end.last, &mut record.profile.tension_max);
    }
}

impl Observer for StepEnvelope {
    fn accepted_step(&mut self, at: &Observation<'_>, profile: &mut Profile) {
        self.update(at.scene, at.state, profile);
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

/// The line at the last output time, and its envelopes over the output times.
struct OutputEnvelope;

impl Observer for OutputEnvelope {
    fn output(&mut self, at: &Observation<'_>, tension: &[f64], profile: &mut Profile) {
        output_envelope::update(profile, at.scene, at.state, tension);
    }
}

impl Observer for Option<Response> {
    fn output(&mut self, at: &Observation<'_>, tension: &[f64], _: &mut Profile) {
        if let Some(response) = self {
            response.add(at.time, &at.state.x[..tension.len()]);
        }
    }

    fn save(&self, checkpoint: &mut Checkpoint) {
        checkpoint.response.clone_from(self);
    }

    fn restore(&mut self, checkpoint: &Checkpoint) {
        // Without the sums of what was recorded before, half a window would count as a whole one.
        let unbegun = self.take();
        let unbegun = unbegun.filter(|r| r.begins_after(checkpoint.place.time));
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

/// The two waves of opposite direction in the response.
struct WaveDecomposition;

impl Observer for WaveDecomposition {
    fn finish(self: Box<Self>, end: &RunEnd<'_>, record: &mut RunRecord) {
        wave_decomposition::decompose_response(end.case, end.initial, &mut record.profile);
    }
}

impl Observer for DecimatedRecord {
    fn accepted_step(&mut self, at: &Observation<'_>, _: &mut Profile) {
        self.widen_extremes(at.time, at.values);
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
    fn row(&mut self, row: &RecordRow<'_>) {
        self.add(row.time, row.values);
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
