//! Takes the accepted steps of a solver and makes of them channels, shapes and envelopes.

use super::channel_reading::ChannelReading;
use super::channel_statistics::ChannelStatistics;
use super::decimation::{DecimatedRecord, widen};
use super::job::Event;
use super::peak_tension::PeakTension;
use super::response::Response;
use super::step_envelope::StepEnvelope;
use super::store::StoreError;
use super::touchdown_speed::TouchdownSpeed;
use super::{
    Channel, Checkpoint, Frame, LineShape, Profile, Progress, Resume, requested_statistics,
};
use crate::case::{self, Case, ChannelSpec};
use crate::scene::Scene;
use crate::solve::{Instant, Progressing, Sink, State};

/// Records a run. Between output times a step costs it a few tensions and no allocation.
pub(super) struct Recorder<'a> {
    scene: &'a Scene,
    channels: Vec<ChannelSpec>,
    /// What is kept in memory of what was recorded so far.
    pub(super) kept: DecimatedRecord,
    /// The single numbers wanted, taken in row by row.
    pub(super) gather: ChannelStatistics,
    /// What could not be recorded, in words.
    pub(super) troubles: Vec<String>,
    pub(super) profile: Profile,
    envelope: StepEnvelope,
    /// How fast the line lies down on the bed.
    pub(super) front: TouchdownSpeed,
    response: Option<Response>,
    latest: Vec<f64>,
    peaks: PeakTension,
    shape_interval: f64,
    duration: f64,
    clock: std::time::Instant,
    /// Told of every output instant.
    events: &'a mut dyn FnMut(Event),
    stop: &'a dyn Fn() -> bool,
    progress: Progress,
}

impl<'a> Recorder<'a> {
    /// A recorder for one run.
    pub(super) fn new(
        case: &Case,
        scene: &'a Scene,
        events: &'a mut dyn FnMut(Event),
        stop: &'a dyn Fn() -> bool,
    ) -> Self {
        let channels = case::channels(case);
        let kept = DecimatedRecord::new(channels.iter().map(|channel| channel.id.clone()));
        let nodes = scene.line_nodes();
        let bending = if scene.flexure.is_some() { nodes } else { 0 };
        let profile = Profile {
            arc: scene.arc[..nodes].to_vec(),
            nodes: vec![[0.0; 3]; nodes],
            tension: vec![0.0; nodes],
            tension_min: vec![f64::INFINITY; nodes],
            tension_max: vec![f64::NEG_INFINITY; nodes],
            z_min: vec![f64::INFINITY; nodes],
            z_max: vec![f64::NEG_INFINITY; nodes],
            curvature: vec![0.0; bending],
            curvature_max: vec![0.0; bending],
            moment: vec![0.0; bending],
            moment_max: vec![0.0; bending],
            ..Profile::default()
        };
        Self {
            scene,
            response: Response::of(case),
            latest: vec![0.0; channels.len()],
            peaks: PeakTension::of(case, scene),
            gather: ChannelStatistics::new(requested_statistics::requested(case, &channels)),
            channels,
            kept,
            troubles: Vec::new(),
            profile,
            envelope: StepEnvelope::of(case, scene),
            front: TouchdownSpeed::of(scene),
            shape_interval: case.output.shape_interval_s,
            duration: if case.solver.method == case::Method::Static {
                0.0
            } else {
                case.solver.duration_s
            },
            clock: std::time::Instant::now(),
            events,
            stop,
            progress: Progress::default(),
        }
    }

    /// Tells of the run as it stands, for whoever wants to go on from there.
    pub(super) fn tell_checkpoint(&mut self, checkpoint: Checkpoint) {
        (self.events)(Event::Checkpoint(Box::new(checkpoint)));
    }

    /// One extreme of every channel so far, and its time \[s\].
    pub(super) fn extremes(&self, of: impl Fn(&Channel) -> (f64, f64)) -> Vec<(f64, f64)> {
        self.kept.history().channels.iter().map(of).collect()
    }

    /// Squares of the longest that segments with a breaking load were so far \[m²\].
    pub(super) fn longest(&self) -> Vec<f64> {
        self.peaks.longest()
    }

    /// How far the nodes moved so far.
    pub(super) fn response(&self) -> Option<&Response> {
        self.response.as_ref()
    }

    /// Takes up what was recorded before, and tells of it as if it were recorded now.
    ///
    /// # Errors
    /// The record before is not there as it should be.
    pub(super) fn take_up(&mut self, from: &Resume) -> Result<(), StoreError> {
        from.replay(&mut |time, values, shape| {
            self.latest.copy_from_slice(values);
            self.progress = Progress {
                time,
                duration: self.duration,
                ..self.progress
            };
            self.record(time, shape);
        })?;
        let before = &from.checkpoint;
        let known = before.peaks.iter().zip(&before.troughs);
        for (channel, (peak, trough)) in self.kept.channels_mut().iter_mut().zip(known) {
            (channel.peak, channel.trough) = (*peak, *trough);
        }
        // Without the sums of what was recorded before, half a window would be told as a whole one.
        self.response = match before.response.clone() {
            None => self
                .response
                .take()
                .filter(|r| r.begins_after(before.place.time)),
            known => known,
        };
        self.profile.clone_from(&before.profile);
        if let Some(front) = &before.front {
            self.front.clone_from(front);
        }
        self.peaks.take_up(&before.longest, &before.state);
        Ok(())
    }

    /// Goes on with the line as it is after an event.
    pub(super) fn enter(&mut self, scene: &'a Scene) {
        self.peaks.settle(self.scene, &mut self.profile.tension_max);
        self.scene = scene;
    }

    /// Reads all channels off a state; NaN where there is nothing to read.
    fn read(&mut self, time: f64, state: &State) {
        let mut reading = ChannelReading::new(self.scene, time, state);
        for (value, channel) in self.latest.iter_mut().zip(&self.channels) {
            let read = reading.channel(channel.id.quantity, channel.site);
            *value = read.unwrap_or(f64::NAN);
        }
    }

    /// Takes in an output instant.
    fn store(&mut self, instant: &Instant<'_>) {
        let tension = self.scene.tensions(instant.state);
        if let Some(response) = &mut self.response {
            response.take(instant.time, &instant.state.x[..tension.len()]);
        }
        self.widen_envelopes(instant.state, &tension);
        let newest = self.kept.shapes().last();
        let due =
            newest.is_none_or(|s| instant.time >= s.time + self.shape_interval * (1.0 - 1e-9));
        let shape = (due || instant.time >= self.duration * (1.0 - 1e-12)).then(|| {
            let nodes = instant.state.x.iter().map(|p| [p.x, p.y, p.z]);
            let nodes = nodes.take(tension.len()).collect();
            LineShape {
                time: instant.time,
                nodes,
                tension,
            }
        });
        self.progress = Progress {
            time: instant.time,
            duration: self.duration,
            steps: instant.steps,
            wall_s: self.clock.elapsed().as_secs_f64(),
            estimating: false,
        };
        self.record(instant.time, shape);
    }

    /// Records the values read last, and tells of them.
    fn record(&mut self, time: f64, shape: Option<LineShape>) {
        self.kept.row(time, &self.latest);
        self.troubles.extend(self.gather.add(time, &self.latest));
        if let Some(shape) = &shape {
            self.kept.shape(shape.clone());
        }
        let frame = Frame {
            time,
            values: self.latest.clone(),
            shape,
            progress: self.progress,
        };
        (self.events)(Event::Frame(Box::new(frame)));
    }

    /// Completes the profile once the run is over.
    pub(super) fn finish(&mut self) {
        self.peaks.settle(self.scene, &mut self.profile.tension_max);
        let Some(response) = self.response.take() else {
            return;
        };
        let last = self.scene.segments.len() - 1;
        let diameter = |i: usize| self.scene.segments[i.min(last)].diameter;
        let diameters: Vec<f64> = (0..self.profile.arc.len()).map(diameter).collect();
        response.finish(&diameters, &mut self.profile);
    }

    fn widen_envelopes(&mut self, state: &State, tension: &[f64]) {
        let p = &mut self.profile;
        for (i, (x, t)) in state.x.iter().zip(tension).enumerate() {
            p.nodes[i] = [x.x, x.y, x.z];
            p.tension[i] = *t;
            p.tension_min[i] = p.tension_min[i].min(*t);
            p.tension_max[i] = p.tension_max[i].max(*t);
            p.z_min[i] = p.z_min[i].min(x.z);
            p.z_max[i] = p.z_max[i].max(x.z);
        }
        p.ropes.widen(self.scene, state);
        if let Some(flexure) = &self.scene.flexure {
            let (mut curvature, mut moment) = flexure.bent(self.scene, state);
            curvature.truncate(tension.len());
            moment.truncate(tension.len());
            raise(&mut p.curvature_max, &curvature);
            raise(&mut p.moment_max, &moment);
            (p.curvature, p.moment) = (curvature, moment);
        }
    }
}

/// Raises greatest values to the new ones.
fn raise(greatest: &mut [f64], values: &[f64]) {
    for (most, value) in greatest.iter_mut().zip(values) {
        *most = most.max(*value);
    }
}

impl Sink for Recorder<'_> {
    fn accept(&mut self, instant: Instant<'_>) -> Progressing {
        self.read(instant.time, instant.state);
        for (channel, value) in self.kept.channels_mut().iter_mut().zip(&self.latest) {
            widen(channel, *value, instant.time);
        }
        self.peaks
            .widen(self.scene, instant.state, &mut self.profile.tension_max);
        self.envelope
            .widen(self.scene, instant.state, &mut self.profile);
        self.front.watch(self.scene, instant.time, instant.state);
        if instant.output {
            self.store(&instant);
        }
        if (self.stop)() {
            Progressing::Stop
        } else {
            Progressing::Continue
        }
    }
}
