//! The latest accepted steps, and what lies between two of them.
//!
//! Between two steps a quantity is the straight line between its values and a parabola on top of it. The curvature of the
//! parabola is taken through the step before and through the step after, and of the two the smaller counts where they have
//! the same sign, none where they have not (essentially non-oscillatory interpolation, Harten, Engquist, Osher and
//! Chakravarthy 1987, doi 10.1016/0021-9991(87)90031-3): third order where the quantity is smooth, without overshoot where
//! its slope jumps, as at a snap. Channels and tensions are interpolated as such, not the state from which they are read:
//! a state in between would stretch segments by what the velocities of axial waves are off.

use serde::{Deserialize, Serialize};

use crate::numerics::V3;
use crate::scene::EnergyRates;

/// What is read of an accepted step.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct StepSample {
    /// Time \[s\].
    pub time: f64,
    /// Values of the channels.
    pub values: Vec<f64>,
    /// Tension of the nodes \[N\], one line after the other.
    pub tension: Vec<f64>,
    /// Positions of the nodes \[m\], likewise.
    pub nodes: Vec<V3>,
    /// Energy and powers; zero where no energy balance is stated.
    #[serde(default)]
    pub energy: EnergyRates,
}

impl StepSample {
    /// Room for this many channels and nodes of the line.
    pub(super) fn new(channels: usize, nodes: usize) -> Self {
        Self {
            time: 0.0,
            values: vec![0.0; channels],
            tension: vec![0.0; nodes],
            nodes: vec![V3::zeros(); nodes],
            energy: EnergyRates::default(),
        }
    }
}

/// The latest four accepted steps since the last event, the oldest first. Allocates when it is made only.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct LatestSteps {
    samples: Vec<StepSample>,
    /// How many of them are known.
    known: usize,
}

/// Two successive steps, with the step before and the step after where there is one.
#[derive(Debug, Clone, Copy)]
pub struct StepInterval<'a> {
    before: Option<&'a StepSample>,
    from: &'a StepSample,
    to: &'a StepSample,
    after: Option<&'a StepSample>,
    /// Channels that are not negative.
    positive: &'a [bool],
    by: InverseTimes,
}

/// One over the times between the steps of an interval \[1/s\]: divided by once for all quantities.
#[derive(Debug, Clone, Copy, Default)]
struct InverseTimes {
    /// Of the interval itself.
    own: f64,
    /// From the step before to the first, and to the second.
    before: [f64; 2],
    /// From the second to the step after, and from the first.
    after: [f64; 2],
}

impl InverseTimes {
    fn between(before: Option<&StepSample>, t: [f64; 2], after: Option<&StepSample>) -> Self {
        let early = before.map(|s| t.map(|t| 1.0 / (t - s.time)));
        let late = after.map(|s| [t[1], t[0]].map(|t| 1.0 / (s.time - t)));
        Self {
            own: 1.0 / (t[1] - t[0]),
            before: early.unwrap_or_default(),
            after: late.unwrap_or_default(),
        }
    }
}

/// A quantity between two steps: `y0 + (y1 - y0) s/h + c s (s - h)` with s the time since the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arc {
    time: [f64; 2],
    value: [f64; 2],
    curvature: f64,
}

/// Samples from which an interval is interpolated.
const SAMPLES: usize = 4;

impl LatestSteps {
    /// For this many channels and nodes of the line.
    pub(super) fn new(channels: usize, nodes: usize) -> Self {
        Self {
            samples: vec![StepSample::new(channels, nodes); SAMPLES],
            known: 0,
        }
    }

    /// Room for the next step, which is from now on the latest.
    pub(super) fn next(&mut self) -> &mut StepSample {
        if self.known < SAMPLES {
            self.known += 1;
        } else {
            self.samples.rotate_left(1);
        }
        &mut self.samples[self.known - 1]
    }

    /// Number of nodes of a step.
    pub(super) fn nodes(&self) -> usize {
        self.samples.first().map_or(0, |sample| sample.nodes.len())
    }

    /// Forgets the latest step.
    pub(super) fn forget_latest(&mut self) {
        self.known = self.known.saturating_sub(1);
    }

    /// Forgets all steps: the next one is the first after an event.
    pub(super) fn clear(&mut self) {
        self.known = 0;
    }

    /// The latest step.
    pub(super) fn latest(&self) -> Option<&StepSample> {
        self.samples.get(..self.known)?.last()
    }

    /// The same, to be completed.
    pub(super) fn latest_mut(&mut self) -> Option<&mut StepSample> {
        self.samples[..self.known].last_mut()
    }

    /// The interval before the latest step but one: the latest that has a step after it. Channels that are `positive` are
    /// nowhere negative between two values that are not.
    pub(super) fn complete_interval<'a>(
        &'a self,
        positive: &'a [bool],
    ) -> Option<StepInterval<'a>> {
        self.interval(self.known.checked_sub(3)?, positive)
    }

    /// The interval before the latest step.
    pub(super) fn last_interval<'a>(&'a self, positive: &'a [bool]) -> Option<StepInterval<'a>> {
        self.interval(self.known.checked_sub(2)?, positive)
    }

    fn interval<'a>(&'a self, from: usize, positive: &'a [bool]) -> Option<StepInterval<'a>> {
        let known = &self.samples[..self.known];
        let before = from.checked_sub(1).and_then(|i| known.get(i));
        let (from, to, after) = (known.get(from)?, known.get(from + 1)?, known.get(from + 2));
        Some(StepInterval {
            before,
            from,
            to,
            after,
            positive,
            by: InverseTimes::between(before, [from.time, to.time], after),
        })
    }

    /// Whether it was made for these numbers of channels and nodes, and all times are finite.
    pub(super) fn fits(&self, channels: usize, nodes: usize) -> bool {
        let fits = |s: &StepSample| {
            s.values.len() == channels
                && s.tension.len() == nodes
                && s.nodes.len() == nodes
                && s.time.is_finite()
        };
        self.samples.len() == SAMPLES && self.known <= SAMPLES && self.samples.iter().all(fits)
    }
}

impl StepInterval<'_> {
    /// Beginning and end \[s\].
    pub(super) fn time(&self) -> [f64; 2] {
        [self.from.time, self.to.time]
    }

    /// A quantity between the two steps.
    #[inline]
    pub(super) fn arc(&self, of: impl Fn(&StepSample) -> f64) -> Arc {
        let (y0, y1) = (of(self.from), of(self.to));
        let (t0, t1) = (self.from.time, self.to.time);
        let [before, after] = self.curvatures([y0, y1], of);
        let curvature = match (before, after) {
            (Some(a), Some(b)) if a * b <= 0.0 => 0.0,
            (Some(a), Some(b)) if a.abs() < b.abs() => a,
            (Some(_), Some(b)) => b,
            (one, other) => one.or(other).unwrap_or(0.0),
        };
        Arc {
            time: [t0, t1],
            value: [y0, y1],
            curvature: if curvature.is_finite() {
                curvature
            } else {
                0.0
            },
        }
    }

    /// Curvatures of the parabolas through the step before and through the step after, where there is one.
    #[inline(always)]
    fn curvatures(&self, [y0, y1]: [f64; 2], of: impl Fn(&StepSample) -> f64) -> [Option<f64>; 2] {
        let (slope, by) = ((y1 - y0) * self.by.own, &self.by);
        let before = self.before.map(|s| {
            let other = (y0 - of(s)) * by.before[0];
            (slope - other) * by.before[1]
        });
        let after = self.after.map(|s| {
            let other = (of(s) - y1) * by.after[0];
            (other - slope) * by.after[1]
        });
        [before, after]
    }

    /// Whether a quantity may turn in between. Most do not, and are smallest and greatest at the steps.
    #[inline(always)]
    fn may_turn(&self, of: impl Fn(&StepSample) -> f64) -> bool {
        let (y0, y1) = (of(self.from), of(self.to));
        let h = self.to.time - self.from.time;
        match self.curvatures([y0, y1], of) {
            [Some(a), Some(b)] => {
                let least = a.abs().min(b.abs());
                a * b > 0.0 && least * h * h > (y1 - y0).abs()
            }
            _ => true,
        }
    }

    /// Smallest and greatest value of a quantity between the two steps, of its arc where it may turn.
    #[inline(always)]
    fn range(&self, of: impl Fn(&StepSample) -> f64, arc: impl FnOnce() -> Arc) -> [f64; 2] {
        if self.may_turn(&of) {
            let arc = arc();
            return [arc.smallest().0, arc.greatest().0];
        }
        let (y0, y1) = (of(self.from), of(self.to));
        if y0 < y1 { [y0, y1] } else { [y1, y0] }
    }

    /// Smallest and greatest tension of a node between the two steps \[N\].
    #[inline]
    pub(super) fn tension_range(&self, node: usize) -> [f64; 2] {
        self.range(|sample| sample.tension[node], || self.tension(node))
    }

    /// Smallest and greatest height of a node between the two steps \[m\].
    #[inline]
    pub(super) fn height_range(&self, node: usize) -> [f64; 2] {
        self.range(|sample| sample.nodes[node].z, || self.coordinate(node, 2))
    }

    /// Smallest value between the two steps of what depends on the place of a node alone.
    pub(super) fn least_of_place(&self, node: usize, of: impl Fn(&V3) -> f64) -> f64 {
        let at = |sample: &StepSample| of(&sample.nodes[node]);
        self.range(at, || self.arc(at))[0]
    }

    /// Energy and powers at both steps.
    pub(super) fn energy(&self) -> [&EnergyRates; 2] {
        [&self.from.energy, &self.to.energy]
    }

    /// Integral of a quantity over the interval. Where the curvatures through the step before and the step after differ by less
    /// than a factor of two, the quantity is smooth, and the cubic through all four steps counts: fourth order, otherwise third.
    pub(super) fn integral(&self, of: impl Fn(&StepSample) -> f64) -> f64 {
        let mut arc = self.arc(&of);
        if let (Some(before), Some(after)) = (self.before, self.after)
            && let [Some(a), Some(b)] = self.curvatures(arc.value, of)
            && a * b > 0.0
            && a.abs() < 2.0 * b.abs()
            && b.abs() < 2.0 * a.abs()
        {
            let [t0, t1] = arc.time;
            let share = (t0 - before.time + 0.5 * (t1 - t0)) / (after.time - before.time);
            arc.curvature = a + (b - a) * share;
        }
        arc.integral()
    }

    /// A channel between the two steps.
    pub(super) fn channel(&self, number: usize) -> Arc {
        let arc = self.arc(|sample| sample.values[number]);
        if self.positive.get(number).copied().unwrap_or_default() {
            arc.not_negative()
        } else {
            arc
        }
    }

    /// Number of channels.
    pub(super) fn channels(&self) -> usize {
        self.to.values.len()
    }

    /// The tension of a node between the two steps \[N\].
    pub(super) fn tension(&self, node: usize) -> Arc {
        self.arc(|sample| sample.tension[node]).not_negative()
    }

    /// A coordinate of a node between the two steps \[m\].
    pub(super) fn coordinate(&self, node: usize, axis: usize) -> Arc {
        self.arc(|sample| sample.nodes[node][axis])
    }

    /// The channels at a time \[s\] in the interval.
    pub(super) fn sample_channels(&self, time: f64, out: &mut [f64]) {
        for (number, value) in out.iter_mut().enumerate() {
            *value = self.channel(number).at(time);
        }
    }

    /// Tensions and places of the nodes of the line at a time \[s\] in the interval.
    pub(super) fn sample_line(&self, time: f64, tensions: &mut [f64], nodes: &mut [V3]) {
        for (node, tension) in tensions.iter_mut().enumerate() {
            *tension = self.tension(node).at(time);
        }
        for (node, place) in nodes.iter_mut().enumerate() {
            *place = V3::from_fn(|axis, _| self.coordinate(node, axis).at(time));
        }
    }
}

impl Arc {
    /// Value at a time \[s\] in the interval; at its ends the values there, to the last digit.
    pub(super) fn at(&self, time: f64) -> f64 {
        let ([t0, t1], [y0, y1]) = (self.time, self.value);
        if time >= t1 {
            return y1;
        }
        let s = time - t0;
        y0 + (y1 - y0) * (s / (t1 - t0)) + self.curvature * s * (time - t1)
    }

    /// The same with so little curvature that it does not turn below zero between two values that are not negative.
    fn not_negative(self) -> Self {
        let [y0, y1] = self.value;
        if self.curvature <= 0.0 || y0.min(y1) < 0.0 || self.smallest().0 >= 0.0 {
            return self;
        }
        let h = self.time[1] - self.time[0];
        Self {
            curvature: (y1 - y0).abs() / (h * h),
            ..self
        }
    }

    /// The part of the interval within a window of time \[s\]; none where they do not meet.
    pub(super) fn within(&self, window: Option<[f64; 2]>) -> Option<Self> {
        let Some([from, to]) = window else {
            return Some(*self);
        };
        let [t0, t1] = self.time;
        let (from, to) = (from.max(t0), to.min(t1));
        (from <= to).then(|| Self {
            time: [from, to],
            value: [self.at(from), self.at(to)],
            curvature: self.curvature,
        })
    }

    /// Value and time at the beginning.
    pub(super) fn first(&self) -> (f64, f64) {
        (self.value[0], self.time[0])
    }

    /// Value and time at the end.
    pub(super) fn last(&self) -> (f64, f64) {
        (self.value[1], self.time[1])
    }

    /// Integral over time.
    pub(super) fn integral(&self) -> f64 {
        let h = self.time[1] - self.time[0];
        0.5 * h * (self.value[0] + self.value[1]) - self.curvature * h.powi(3) / 6.0
    }

    /// The turning point in between and its time, where there is one.
    #[inline]
    fn turn(&self) -> Option<(f64, f64)> {
        let ([t0, t1], [y0, y1]) = (self.time, self.value);
        let h = t1 - t0;
        // The slope changes its sign within the interval.
        if (y1 - y0).abs() >= self.curvature.abs() * h * h {
            return None;
        }
        let s = 0.5 * (h - (y1 - y0) / (h * self.curvature));
        Some((self.at(t0 + s), t0 + s))
    }

    /// The greatest value and its time.
    #[inline]
    pub(super) fn greatest(&self) -> (f64, f64) {
        self.best(|new, old| new > old)
    }

    /// The smallest value and its time.
    #[inline]
    pub(super) fn smallest(&self) -> (f64, f64) {
        self.best(|new, old| new < old)
    }

    #[inline]
    fn best(&self, better: impl Fn(f64, f64) -> bool) -> (f64, f64) {
        let mut best = self.first();
        for other in [Some(self.last()), self.turn()].into_iter().flatten() {
            if better(other.0, best.0) {
                best = other;
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps at these times, a function as the one channel.
    fn steps(times: &[f64], y: impl Fn(f64) -> f64) -> LatestSteps {
        let mut latest = LatestSteps::new(1, 0);
        for time in times {
            let sample = latest.next();
            (sample.time, sample.values[0]) = (*time, y(*time));
        }
        latest
    }

    #[test]
    fn a_parabola_is_exact_and_so_are_its_peak_and_mean() {
        let y = |t: f64| 3.0 + 2.0 * t - 4.0 * t * t;
        let latest = steps(&[-0.5, 0.0, 0.7, 1.0], y);
        let arc = latest.complete_interval(&[]).unwrap().channel(0);
        for t in [0.0, 0.1, 0.33, 0.7] {
            assert!((arc.at(t) - y(t)).abs() < 1e-14);
        }
        let (value, time) = arc.greatest();
        assert!((time - 0.25).abs() < 1e-14 && (value - y(0.25)).abs() < 1e-14);
        let whole = |t: f64| 3.0 * t + t * t - 4.0 / 3.0 * t.powi(3);
        assert!((arc.integral() - whole(0.7)).abs() < 1e-14);
        let part = arc.within(Some([0.2, 0.5])).unwrap();
        assert!((part.integral() - whole(0.5) + whole(0.2)).abs() < 1e-14);
        assert_eq!(arc.within(Some([0.8, 2.0])), None);
    }

    #[test]
    fn smooth_quantities_are_interpolated_to_third_order() {
        let worst = |h: f64| {
            let mut worst = 0.0_f64;
            for start in 0..200 {
                let t0 = f64::from(start) * 0.0314;
                let latest = steps(&[t0 - h, t0, t0 + h, t0 + 2.0 * h], f64::sin);
                let arc = latest.complete_interval(&[]).unwrap().channel(0);
                for share in [0.25, 0.5, 0.75] {
                    let t = t0 + share * h;
                    worst = worst.max((arc.at(t) - t.sin()).abs());
                }
            }
            worst
        };
        let order = (worst(0.1) / worst(0.05)).log2();
        assert!((2.8..3.3).contains(&order), "{order}");
    }

    #[test]
    fn nothing_overshoots_where_the_slope_jumps() {
        let snap = |t: f64| if t < 0.0 { 0.0 } else { 10.0 - t };
        for shift in [0.2, 0.5, 0.9, 1.4] {
            let times = [-1.0, 0.0, 1.0, 2.0].map(|t| t - shift);
            let arc = steps(&times, snap)
                .complete_interval(&[])
                .unwrap()
                .channel(0);
            assert!(
                arc.greatest().0 <= 10.0 && arc.smallest().0 >= 0.0,
                "{shift}"
            );
        }
    }

    #[test]
    fn a_tension_is_nowhere_negative() {
        let latest = steps(&[0.0, 1.0, 2.0, 3.0], |t| (t - 1.4).powi(2) - 0.15);
        let free = latest.complete_interval(&[]).unwrap().channel(0);
        let bounded = latest.complete_interval(&[true]).unwrap().channel(0);
        assert!(free.smallest().0 < -0.03 && bounded.smallest().0 >= 0.0);
        assert_eq!(bounded.greatest(), free.greatest());
    }

    #[test]
    fn the_first_and_the_last_interval_have_one_neighbour() {
        let latest = steps(&[0.0, 1.0, 2.0], |t| t * t);
        assert!((latest.complete_interval(&[]).unwrap().channel(0).at(0.5) - 0.25).abs() < 1e-15);
        assert!((latest.last_interval(&[]).unwrap().channel(0).at(1.5) - 2.25).abs() < 1e-15);
        assert!(steps(&[0.0], |t| t).last_interval(&[]).is_none());
        let two = steps(&[0.0, 1.0], |t| t * t);
        assert_eq!(two.last_interval(&[]).unwrap().channel(0).at(0.5), 0.5);
    }
}
