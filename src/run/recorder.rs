//! Takes the accepted steps of a solver and makes of them channels, shapes and envelopes.

use super::job::Event;
use super::{Channel, Frame, History, LineShape, Profile, Progress};
use crate::case::{self, Case, LineEnd, Source};
use crate::scene::Scene;
use crate::solve::{Instant, Progressing, Sink, State, System};

/// Records a run. Between output times a step costs it a few tensions and no allocation.
pub(super) struct Recorder<'a> {
    scene: &'a Scene,
    sources: Vec<Source>,
    /// What is recorded so far.
    pub(super) history: History,
    pub(super) shapes: Vec<LineShape>,
    pub(super) profile: Profile,
    latest: Vec<f64>,
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
        let history = History {
            time: Vec::new(),
            channels: channels
                .iter()
                .map(|c| Channel {
                    name: c.name.clone(),
                    unit: c.unit.to_owned(),
                    values: Vec::new(),
                    peak: (f64::NEG_INFINITY, 0.0),
                    trough: (f64::INFINITY, 0.0),
                })
                .collect(),
        };
        let nodes = scene.nodes();
        let bending = if scene.flexure.is_some() { nodes } else { 0 };
        let profile = Profile {
            arc: scene.arc.clone(),
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
        };
        Self {
            scene,
            latest: vec![0.0; channels.len()],
            sources: channels.into_iter().map(|c| c.source).collect(),
            history,
            shapes: Vec::new(),
            profile,
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

    /// Reads all channels off a state.
    fn read(&mut self, state: &State) {
        // The three components of an end's force come from one reading.
        let mut forces = [None; 2];
        for (value, source) in self.latest.iter_mut().zip(&self.sources) {
            let node = |end: LineEnd| {
                if end == LineEnd::A {
                    0
                } else {
                    self.scene.nodes() - 1
                }
            };
            *value = match *source {
                Source::Joint(joint) => self.scene.tension_at(self.scene.joints[joint].node, state),
                Source::Coordinate(end, axis) => state.x[node(end)][axis],
                Source::Body(body, axis) => state.x[self.scene.clumps[body]][axis],
                Source::Force(end, axis) => {
                    let force = || self.scene.end_force(node(end), state);
                    forces[usize::from(end == LineEnd::B)].get_or_insert_with(force)[axis]
                }
                Source::Speed(end) => state.v[node(end)].norm(),
            };
        }
    }

    /// Stores an output instant, and tells of it.
    fn store(&mut self, instant: &Instant<'_>) {
        self.history.time.push(instant.time);
        for (channel, value) in self.history.channels.iter_mut().zip(&self.latest) {
            channel.values.push(*value);
        }
        let tension = self.scene.tensions(instant.state);
        self.widen_envelopes(instant.state, &tension);
        let due = self
            .shapes
            .last()
            .is_none_or(|s| instant.time >= s.time + self.shape_interval * (1.0 - 1e-9));
        let shape = (due || instant.time >= self.duration * (1.0 - 1e-12)).then(|| {
            let nodes = instant.state.x.iter().map(|p| [p.x, p.y, p.z]).collect();
            LineShape {
                time: instant.time,
                nodes,
                tension,
            }
        });
        self.shapes.extend(shape.clone());
        self.progress = Progress {
            time: instant.time,
            duration: self.duration,
            steps: instant.steps,
            wall_s: self.clock.elapsed().as_secs_f64(),
            estimating: false,
        };
        let frame = Frame {
            time: instant.time,
            values: self.latest.clone(),
            shape,
            progress: self.progress,
        };
        (self.events)(Event::Frame(Box::new(frame)));
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
        if let Some(flexure) = &self.scene.flexure {
            let (curvature, moment) = flexure.bent(self.scene, state);
            widen(&mut p.curvature_max, &curvature);
            widen(&mut p.moment_max, &moment);
            (p.curvature, p.moment) = (curvature, moment);
        }
    }
}

/// Raises greatest values to the new ones.
fn widen(greatest: &mut [f64], values: &[f64]) {
    for (most, value) in greatest.iter_mut().zip(values) {
        *most = most.max(*value);
    }
}

impl Sink for Recorder<'_> {
    fn accept(&mut self, instant: Instant<'_>) -> Progressing {
        self.read(instant.state);
        for (channel, value) in self.history.channels.iter_mut().zip(&self.latest) {
            if *value > channel.peak.0 {
                channel.peak = (*value, instant.time);
            }
            if *value < channel.trough.0 {
                channel.trough = (*value, instant.time);
            }
        }
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
