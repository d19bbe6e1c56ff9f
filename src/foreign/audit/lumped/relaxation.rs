//! The ways in which `MoorDyn` brings a system to rest before a run, and where they stop.
//!
//! `MoorDyn` 2.7, `MoorDyn2.cpp`: `icStationary`, its default, moves every node by its acceleration alone and stops where the sum of the
//! accelerations hardly changes over dtIC; `icLegacy` (`ICgenDynamic` 1, and the version in `OpenFAST`) runs in time with more drag and stops where no
//! tension at a fairlead changes by more than `threshIC` over nine samples.

use super::LumpedModel;
use super::forces::Loads;
use crate::numerics::V3;

/// Samples of the tensions that are compared with the last.
const SAMPLES: usize = 9;
/// Limits of the factor by which the stationary scheme lengthens its steps, and its growth in a step.
const BOOST: [f64; 3] = [0.1, 50.0, 1.01];
/// Evaluations of nodes that are spent at most: some seconds.
const MOST_WORK: f64 = 2e7;

/// Settings of a relaxation, as the file or the program's defaults have them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelaxationSettings {
    /// Time step \[s\].
    pub step: f64,
    /// Interval of the tests of convergence \[s\].
    pub interval: f64,
    /// Greatest time \[s\].
    pub longest: f64,
    /// Factor of the drag coefficients.
    pub drag_scale: f64,
    /// Change that counts as none.
    pub threshold: f64,
    /// Time step by the shortest natural period of a segment.
    pub courant: f64,
}

/// Why a relaxation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// Its test was passed.
    Converged,
    /// Its time was over.
    OutOfTime,
    /// It grew without bound.
    Diverged,
    /// It takes more steps than are repeated here.
    TooLong,
}

/// What a relaxation left.
#[derive(Debug, Clone, PartialEq)]
pub struct Relaxed {
    /// Places of the nodes \[m\].
    pub x: Vec<V3>,
    /// When it ended \[s\].
    pub time: f64,
    /// Why.
    pub ended: Ended,
}

/// The run in time with more drag; tensions are sampled this often \[s\].
#[must_use]
pub fn dynamic(model: &LumpedModel, settings: &RelaxationSettings, sample: f64) -> Relaxed {
    let mut march = RelaxationMarch::of_model(model, settings.drag_scale);
    let mut past: Vec<Vec<f64>> = Vec::new();
    let mut time = 0.0;
    let samples = whole(settings.longest / sample);
    for _ in 0..samples {
        for step in steps(sample, settings.step) {
            march.midpoint(step);
            if march.work > MOST_WORK {
                return march.ended(time, Ended::TooLong);
            }
        }
        time += sample;
        if !march.is_finite() {
            return march.ended(time, Ended::Diverged);
        }
        let now: Vec<f64> = (0..model.lines.len()).map(|k| march.fairlead(k)).collect();
        let same = past.len() >= SAMPLES
            && past.iter().rev().take(SAMPLES).all(|then| {
                let pairs = now.iter().zip(then);
                pairs
                    .into_iter()
                    .all(|(now, then)| (now / then - 1.0).abs() <= settings.threshold)
            });
        if same {
            return march.ended(time, Ended::Converged);
        }
        past.push(now);
    }
    march.ended(time, Ended::OutOfTime)
}

/// The stationary scheme.
#[must_use]
pub fn stationary(model: &LumpedModel, settings: &RelaxationSettings) -> Relaxed {
    let mut march = RelaxationMarch::of_model(model, 1.0);
    let mut before = march.x.clone();
    let (mut boost, mut error, mut first, mut last) = (1.0, 0.0, None, None);
    let segments = model.lines.iter().map(|line| line.segment);
    let shortest = segments.fold(f64::INFINITY, f64::min);
    let mut time = 0.0;
    for _ in 0..whole(settings.longest / settings.interval) {
        for step in steps(settings.interval, settings.step) {
            let previous = error;
            error = march.accelerations();
            if previous != 0.0 && previous >= error {
                boost *= BOOST[2];
            } else if previous != 0.0 {
                boost /= BOOST[2];
                for (place, before) in march.x.iter_mut().zip(&before) {
                    *place = place.lerp(before, 0.5);
                }
                error = march.accelerations();
            }
            boost = boost.clamp(BOOST[0], BOOST[1]);
            let speed = 0.5 * step * error;
            let longest = settings.courant.min(1.0) * shortest / speed;
            let by = 0.5 * step * longest.min(boost * step);
            before.copy_from_slice(&march.x);
            march.shift(by);
            time += step;
            first = first.or(Some(error));
            if march.work > MOST_WORK {
                return march.ended(time, Ended::TooLong);
            }
        }
        if !march.is_finite() || !error.is_finite() {
            return march.ended(time, Ended::Diverged);
        }
        let of_first = first.map_or(0.0, |first| error / first);
        let change = last.map_or(f64::INFINITY, |last: f64| (last - error).abs() / last);
        if error == 0.0 || of_first < settings.threshold || change < settings.threshold {
            return march.ended(time, Ended::Converged);
        }
        last = Some(error);
    }
    march.ended(time, Ended::OutOfTime)
}

/// Steps of a length that fill an interval, the last as long as is left.
fn steps(interval: f64, step: f64) -> impl Iterator<Item = f64> {
    let count = whole((interval / step - 1e-9).ceil()).max(1);
    (0..count).map(move |k| step.min(interval - k as f64 * step))
}

/// A count of intervals or steps, at most 1e9.
fn whole(count: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive, and bounded"
    )]
    let count = count.round().clamp(0.0, 1e9) as usize;
    count
}

/// Nodes that move.
struct RelaxationMarch<'m> {
    model: &'m LumpedModel,
    drag_scale: f64,
    x: Vec<V3>,
    v: Vec<V3>,
    half: [Vec<V3>; 2],
    loads: Loads,
    /// Evaluations of nodes so far.
    work: f64,
}

impl<'m> RelaxationMarch<'m> {
    fn of_model(model: &'m LumpedModel, drag_scale: f64) -> Self {
        let still = vec![V3::zeros(); model.start.len()];
        Self {
            model,
            drag_scale,
            x: model.start.clone(),
            half: [model.start.clone(), still.clone()],
            v: still,
            loads: Loads::of_model(model),
            work: 0.0,
        }
    }

    /// A step of the midpoint rule, which `MoorDyn` calls RK2.
    fn midpoint(&mut self, step: f64) {
        self.work += 2.0 * self.x.len() as f64;
        let Self { model, loads, .. } = self;
        model.evaluate(&self.x, &self.v, self.drag_scale, loads);
        let [x, v] = &mut self.half;
        for node in (0..x.len()).filter(|node| model.free[*node]) {
            x[node] = self.x[node] + 0.5 * step * self.v[node];
            v[node] = self.v[node] + 0.5 * step * loads.acceleration(node);
        }
        model.evaluate(x, v, self.drag_scale, loads);
        for node in (0..x.len()).filter(|node| model.free[*node]) {
            self.x[node] += step * v[node];
            self.v[node] += step * loads.acceleration(node);
        }
    }

    /// Evaluates the forces at rest; the sum of all accelerations \[m/s²\].
    fn accelerations(&mut self) -> f64 {
        self.work += self.x.len() as f64;
        let Self { model, loads, .. } = self;
        model.evaluate(&self.x, &self.v, self.drag_scale, loads);
        let free = (0..self.x.len()).filter(|node| model.free[*node]);
        free.map(|node| loads.acceleration(node).norm()).sum()
    }

    /// Moves every free node by its acceleration times this \[s²\].
    fn shift(&mut self, by: f64) {
        for node in (0..self.x.len()).filter(|node| self.model.free[*node]) {
            self.x[node] += self.loads.acceleration(node) * by;
        }
    }

    /// Tension at end B of a line with its internal damping \[N\].
    fn fairlead(&self, line: usize) -> f64 {
        let lumped = &self.model.lines[line];
        let last = lumped.nodes.len() - 1;
        let [a, b] = [lumped.nodes[last - 1], lumped.nodes[last]];
        let along = (self.x[b] - self.x[a]).normalize();
        let rate = (self.v[b] - self.v[a]).dot(&along) / lumped.segment;
        (self.model.end_tension(line, &self.x) + lumped.damping * rate).abs()
    }

    fn is_finite(&self) -> bool {
        let finite = |all: &[V3]| {
            all.iter()
                .all(|p| p.iter().all(|c| c.is_finite() && c.abs() < 1e7))
        };
        finite(&self.x) && finite(&self.v)
    }

    fn ended(self, time: f64, ended: Ended) -> Relaxed {
        Relaxed {
            x: self.x,
            time,
            ended,
        }
    }
}
