//! Records the accepted steps of a system: a row at every output time, extremes and means of every step, the energy balance.

use serde::{Deserialize, Serialize};

use super::along::LinesAlong;
use super::body_equation::MovingBody;
use super::channels::Channels;
use super::energy::{Energy, energy};
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::case::ChannelId;
use crate::fatigue::spot::SpotCounter;
use crate::run::{DecimatedRecord, History};

/// A channel over the whole run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ChannelSummary {
    /// Least value at a step, and its time \[s\].
    pub least: (f64, f64),
    /// Greatest value at a step, and its time \[s\].
    pub greatest: (f64, f64),
    /// Mean over time.
    pub mean: f64,
    /// Last value.
    pub last: f64,
}

/// The energy over the whole run \[J\].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyBalance {
    /// Work of prescribed motion and of the loads on bodies.
    pub put_in: f64,
    /// Lost by drag, damping and bed.
    pub lost: f64,
    /// Stored at the end more than at the start.
    pub stored: f64,
    /// What of that came and went where segments at ends that are paid out were parted and joined.
    #[serde(default)]
    pub remeshed: f64,
    /// All that passed through: work and losses without their signs, a millionth of the greatest energy, and in a run that begins off its
    /// equilibrium the greatest kinetic energy.
    pub passed: f64,
}

/// Share of the energy itself that counts as passed through: in a system at rest rounding is all that does.
const AT_REST: f64 = 1e-6;

impl EnergyBalance {
    /// What does not balance \[J\].
    #[must_use]
    pub fn drift(&self) -> f64 {
        self.stored - self.put_in + self.lost
    }

    /// Whether more than half of it is due to segments parted and joined: to the mesh, which shorter steps leave as it is.
    #[must_use]
    pub fn is_of_mesh(&self) -> bool {
        (self.drift() - self.remeshed).abs() < 0.5 * self.drift().abs()
    }

    /// What does not balance by all that passed through \[-\].
    #[must_use]
    pub fn relative_drift(&self) -> f64 {
        self.drift().abs() / self.passed.max(f64::MIN_POSITIVE)
    }
}

/// An accepted step as it is recorded.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
struct Step {
    time: f64,
    values: Vec<f64>,
}

/// What is recorded so far, but for the rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecorderState {
    /// Rows recorded so far.
    pub rows: u64,
    energy_at_start: f64,
    greatest_energy: f64,
    #[serde(default)]
    greatest_kinetic: f64,
    passed: f64,
    sums: Vec<f64>,
    last_energy: Energy,
    balance: EnergyBalance,
    summaries: Vec<ChannelSummary>,
    /// Least and greatest values after the start; empty where it is not left out.
    #[serde(default)]
    settled: Vec<[f64; 2]>,
    /// Cycles counted along the lines.
    #[serde(default)]
    fatigue: Vec<SpotCounter>,
    steps: Vec<Step>,
}

impl RecorderState {
    /// Time of the last step \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.time)
    }

    /// Whether it is of so many channels.
    #[must_use]
    pub fn fits(&self, channels: usize) -> bool {
        let steps = self.steps.iter().map(|step| step.values.len());
        let mut sizes = steps.chain([self.sums.len(), self.summaries.len()]);
        let settled = [0, channels].contains(&self.settled.len());
        !self.steps.is_empty() && settled && sizes.all(|size| size == channels)
    }
}

/// The record of a run.
#[derive(Debug, Clone)]
pub struct Recorder {
    /// What is recorded.
    channels: Channels,
    interval: f64,
    /// The channels at the output times; of a long run some of them.
    record: DecimatedRecord,
    /// Rows recorded so far, and the latest of them.
    rows: u64,
    row: Vec<f64>,
    /// The last three steps, the oldest first: rows between the last two are written once the next is there.
    steps: Vec<Step>,
    sums: Vec<f64>,
    summaries: Vec<ChannelSummary>,
    /// From when on \[s\] the extremes are kept apart, and these; empty where they are not.
    settled_from: f64,
    settled: Vec<[f64; 2]>,
    /// What is counted along the lines.
    along: LinesAlong,
    last_energy: Energy,
    /// The energy balance so far.
    pub balance: EnergyBalance,
    energy_at_start: f64,
    greatest_energy: f64,
    /// Whether the run begins off its equilibrium, and the greatest kinetic energy of one that does \[J\].
    begins_off_rest: bool,
    greatest_kinetic: f64,
    passed: f64,
    /// The first value that is not finite, in words: what ends the run.
    fault: Option<String>,
}

impl Recorder {
    /// For a system, with rows at this interval \[s\].
    #[must_use]
    pub fn new(system: &MovingSystem, interval: f64) -> Self {
        let channels = Channels::of(system);
        let n = channels.ids.len();
        let nothing = ChannelSummary {
            least: (f64::INFINITY, 0.0),
            greatest: (f64::NEG_INFINITY, 0.0),
            mean: 0.0,
            last: 0.0,
        };
        Self {
            record: DecimatedRecord::new(channels.ids.iter().cloned()),
            rows: 0,
            row: Vec::new(),
            channels,
            interval,
            steps: Vec::new(),
            sums: vec![0.0; n],
            summaries: vec![nothing; n],
            settled_from: f64::INFINITY,
            settled: Vec::new(),
            along: LinesAlong::default(),
            last_energy: Energy::default(),
            balance: EnergyBalance::default(),
            energy_at_start: 0.0,
            greatest_energy: 0.0,
            begins_off_rest: system.network.begins_off_rest(),
            greatest_kinetic: 0.0,
            passed: 0.0,
            fault: None,
        }
    }

    /// The same, which keeps the extremes from a time on \[s\] apart where one is given.
    #[must_use]
    pub fn settled_from(mut self, from: Option<f64>) -> Self {
        // Nothing is seen yet: not infinite numbers, since a checkpoint is finite.
        let nothing = from.map(|_| vec![[f64::MAX, f64::MIN]; self.sums.len()]);
        self.settled = nothing.unwrap_or_default();
        self.settled_from = from.unwrap_or(f64::INFINITY);
        self
    }

    /// The same, which counts cycles along the lines.
    #[must_use]
    pub fn counting(mut self, along: LinesAlong) -> Self {
        self.along = along;
        self
    }

    /// What is counted along the lines, at the end of the run.
    #[must_use]
    pub fn take_along(&mut self) -> LinesAlong {
        std::mem::take(&mut self.along)
    }

    /// Whether what was recorded so far is of this run.
    #[must_use]
    pub fn fits(&self, stored: &RecorderState) -> bool {
        let sound = |counter: &SpotCounter| counter.is_sound();
        stored.fits(self.channels.ids.len())
            && stored.settled.len() == self.settled.len()
            && stored.fatigue.len() == self.along.counters()
            && stored.fatigue.iter().all(sound)
    }

    /// Least and greatest value of a channel at the steps from that time on; nothing where there are none.
    #[must_use]
    pub fn settled(&self, channel: usize) -> Option<[f64; 2]> {
        let found = self.settled.get(channel).copied();
        found.filter(|[least, greatest]| least <= greatest)
    }

    /// Why the run cannot go on: the first value that is not finite, with its time.
    #[must_use]
    pub fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// What is recorded so far, but for the rows.
    #[must_use]
    pub fn state(&self) -> RecorderState {
        RecorderState {
            rows: self.rows,
            energy_at_start: self.energy_at_start,
            greatest_energy: self.greatest_energy,
            greatest_kinetic: self.greatest_kinetic,
            passed: self.passed,
            sums: self.sums.clone(),
            last_energy: self.last_energy,
            balance: self.balance,
            summaries: self.summaries.clone(),
            settled: self.settled.clone(),
            fatigue: self.along.state(),
            steps: self.steps.clone(),
        }
    }

    /// Continues from what was recorded so far.
    pub fn restore(&mut self, stored: &RecorderState) {
        self.rows = stored.rows;
        self.energy_at_start = stored.energy_at_start;
        self.greatest_energy = stored.greatest_energy;
        self.greatest_kinetic = stored.greatest_kinetic;
        self.passed = stored.passed;
        self.sums.clone_from(&stored.sums);
        self.last_energy = stored.last_energy;
        self.balance = stored.balance;
        self.summaries.clone_from(&stored.summaries);
        self.settled.clone_from(&stored.settled);
        self.along.restore(&stored.fatigue);
        self.steps.clone_from(&stored.steps);
    }

    /// Interval of the rows \[s\].
    #[must_use]
    pub const fn interval(&self) -> f64 {
        self.interval
    }

    /// Takes a row of an earlier history.
    pub fn take_row(&mut self, t: f64, values: &[f64]) {
        self.record.row(t, values);
    }

    /// What is recorded, in the order of the rows.
    #[must_use]
    pub fn channels(&self) -> &[ChannelId] {
        &self.channels.ids
    }

    /// Records an accepted step at time t \[s\], and sends the rows that are complete with it.
    pub fn accept(
        &mut self,
        system: &MovingSystem,
        bodies: &[MovingBody],
        (t, state): (f64, &SystemState),
        rows: &mut dyn FnMut(f64, &[f64]),
    ) {
        let mut step = if self.steps.len() == 3 {
            self.steps.remove(0)
        } else {
            Step::default()
        };
        step.time = t;
        self.channels
            .read((system, bodies), t, state, &mut step.values);
        if let Some(wild) = step.values.iter().position(|value| !value.is_finite()) {
            // Nothing is recorded of such a step.
            let channel = &self.channels.ids[wild];
            self.fault
                .get_or_insert_with(|| format!("{channel} is not finite at t = {t:.6} s"));
            return;
        }
        self.summarise(&step);
        self.along.step(system, t, state);
        self.add_energy(&energy(system, bodies, t, state), t);
        self.steps.push(step);
        match self.steps.len() {
            1 => {
                self.row.clone_from(&self.steps[0].values);
                self.add_row(t, rows);
            }
            2 => {}
            _ => self.write_rows(1, rows),
        }
    }

    /// Ends a stretch of smooth motion: what follows begins anew, from the state after a jump.
    pub fn jump(
        &mut self,
        system: &MovingSystem,
        bodies: &[MovingBody],
        (t, state): (f64, &SystemState),
        rows: &mut dyn FnMut(f64, &[f64]),
    ) {
        self.end(rows);
        let mut step = Step {
            time: t,
            values: Vec::new(),
        };
        self.channels
            .read((system, bodies), t, state, &mut step.values);
        self.summarise(&step);
        self.along.step(system, t, state);
        let now = energy(system, bodies, t, state);
        self.balance.remeshed += now.stored - self.last_energy.stored;
        self.last_energy = now;
        self.steps = vec![step];
    }

    /// Records the rows between the last two steps.
    pub fn end(&mut self, rows: &mut dyn FnMut(f64, &[f64])) {
        if self.steps.len() > 1 {
            self.write_rows(self.steps.len() - 1, rows);
        }
    }

    /// The rows, with the extremes over every step.
    #[must_use]
    pub fn into_history(self) -> History {
        let (mut history, _) = self.record.into_parts();
        for (channel, summary) in history.channels.iter_mut().zip(&self.summaries) {
            (channel.peak, channel.trough) = (summary.greatest, summary.least);
        }
        history
    }

    /// Rows at output times after step `to - 1`, up to step `to`, on cubics with the slopes of the steps around.
    fn write_rows(&mut self, to: usize, rows: &mut dyn FnMut(f64, &[f64])) {
        let (from, until) = (self.steps[to - 1].time, self.steps[to].time);
        loop {
            let t = self.rows as f64 * self.interval;
            if t > until * (1.0 + 1e-12) || t <= from * (1.0 - 1e-12) {
                break;
            }
            self.row.clear();
            let values = (0..self.sums.len()).map(|number| between(&self.steps, to, number, t));
            self.row.extend(values);
            self.add_row(t, rows);
        }
    }

    /// Adds the row of an output time, and sends it.
    fn add_row(&mut self, t: f64, rows: &mut dyn FnMut(f64, &[f64])) {
        self.record.row(t, &self.row);
        self.rows += 1;
        rows(t, &self.row);
    }

    fn summarise(&mut self, step: &Step) {
        let before = self.steps.last();
        let before = before.filter(|before| step.time > before.time);
        let is_settled = step.time >= self.settled_from * (1.0 - 1e-12);
        for (k, value) in step.values.iter().enumerate() {
            let summary = &mut self.summaries[k];
            if *value < summary.least.0 {
                summary.least = (*value, step.time);
            }
            if *value > summary.greatest.0 {
                summary.greatest = (*value, step.time);
            }
            summary.last = *value;
            if let Some([least, greatest]) = self.settled.get_mut(k).filter(|_| is_settled) {
                (*least, *greatest) = (least.min(*value), greatest.max(*value));
            }
            if let Some(before) = before {
                self.sums[k] += 0.5 * (value + before.values[k]) * (step.time - before.time);
            }
        }
    }

    /// The work between two steps by the trapezium rule.
    fn add_energy(&mut self, now: &Energy, t: f64) {
        match self.steps.last() {
            None => self.energy_at_start = now.stored,
            Some(before) => {
                let half = 0.5 * (t - before.time);
                let size = |energy: &Energy| energy.power_in.abs() + energy.lost.abs();
                self.passed += half * (size(now) + size(&self.last_energy));
                self.balance.put_in += half * (now.power_in + self.last_energy.power_in);
                self.balance.remeshed += half * (now.remeshed + self.last_energy.remeshed);
                self.balance.lost += half * (now.lost + self.last_energy.lost);
                self.balance.stored = now.stored - self.energy_at_start;
            }
        }
        self.greatest_energy = self.greatest_energy.max(now.stored.abs());
        if self.begins_off_rest {
            self.greatest_kinetic = self.greatest_kinetic.max(now.kinetic);
        }
        self.balance.passed = self.passed + self.greatest_kinetic + AT_REST * self.greatest_energy;
        self.last_energy = *now;
    }

    /// Time of the last step \[s\].
    #[must_use]
    pub fn reached(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.time)
    }

    /// The channels over the whole run.
    #[must_use]
    pub fn summaries(&self) -> Vec<ChannelSummary> {
        let duration = self.reached();
        let with_mean = |(summary, sum): (&ChannelSummary, &f64)| ChannelSummary {
            mean: if duration > 0.0 {
                sum / duration
            } else {
                summary.last
            },
            ..*summary
        };
        self.summaries
            .iter()
            .zip(&self.sums)
            .map(with_mean)
            .collect()
    }
}

/// The value of a channel between steps `to - 1` and `to`: a cubic with the slopes of the parabolas through three steps, and the
/// chord's where there is none.
fn between(steps: &[Step], to: usize, channel: usize, t: f64) -> f64 {
    let at = |k: usize| (steps[k].time, steps[k].values[channel]);
    let chord = |a: usize, b: usize| {
        let ((ta, ya), (tb, yb)) = (at(a), at(b));
        (yb - ya) / (tb - ta)
    };
    let slope = |k: usize| -> f64 {
        if k == 0 || k + 1 >= steps.len() {
            return f64::NAN;
        }
        let (before, after) = (at(k).0 - at(k - 1).0, at(k + 1).0 - at(k).0);
        (chord(k - 1, k) * after + chord(k, k + 1) * before) / (before + after)
    };
    let ((t0, y0), (t1, y1)) = (at(to - 1), at(to));
    let (h, straight) = (t1 - t0, chord(to - 1, to));
    let s = (t - t0) / h;
    let (mut m0, mut m1) = (slope(to - 1), slope(to));
    // A parabola through the value and slope at one side and the value at the other.
    match (m0.is_nan(), m1.is_nan()) {
        (true, true) => (m0, m1) = (straight, straight),
        (true, false) => m0 = 2.0 * straight - m1,
        (false, true) => m1 = 2.0 * straight - m0,
        (false, false) => {}
    }
    let (s2, s3) = (s * s, s * s * s);
    y0 * (2.0 * s3 - 3.0 * s2 + 1.0)
        + y1 * (3.0 * s2 - 2.0 * s3)
        + h * (m0 * (s3 - 2.0 * s2 + s) + m1 * (s3 - s2))
}
