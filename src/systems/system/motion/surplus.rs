//! What meshing an end anew leaves too much in its segment.
//!
//! Straight segments are shorter than what hangs between: of one segment less a line has a little slack, of one more it lacks a little. In
//! a stiff line that is many times its tension, and it would snap. The end segment is therefore as long as leaves the tension as it was, and
//! comes to the length that is paid out as it runs on by the length of a segment, out or in.

use serde::{Deserialize, Serialize};

use super::moving_system::MovingSystem;
use super::system_state::SystemState;

/// What meshing left too much in an end segment.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Surplus {
    /// Length just after \[m\], negative where it lacks it.
    length: f64,
    /// What was paid out then \[m\].
    since: f64,
}

/// Greatest surplus by the length of the mesh: what was bent further becomes slack.
const MOST: f64 = 0.1;

impl Surplus {
    /// With so much paid out \[m\], at an end with segments of this length \[m\].
    fn new(length: f64, since: f64, mesh: f64) -> Self {
        let most = MOST * mesh;
        Self {
            length: length.clamp(-most, most),
            since,
        }
    }

    /// What is left of it \[m\], its rate and the rate of that, by those of what is paid out.
    fn at(&self, [out, rate, acceleration]: [f64; 3], mesh: f64) -> [f64; 3] {
        let way = out - self.since;
        let run = way.abs() / mesh;
        if run >= 1.0 || self.length == 0.0 {
            return [0.0; 3];
        }
        let left = 1.0 - run.powi(3) * (10.0 - run * (15.0 - 6.0 * run));
        let slope = -30.0 * (run * (1.0 - run)).powi(2) * way.signum() / mesh;
        let curvature = -60.0 * run * (1.0 - run) * (1.0 - 2.0 * run) / (mesh * mesh);
        let rates = [
            left,
            slope * rate,
            slope * acceleration + curvature * rate * rate,
        ];
        rates.map(|part| self.length * part)
    }
}

impl MovingSystem {
    /// What meshing left too much in an end segment \[m\], its rate and the rate of that.
    pub(super) fn surplus(&self, (number, end): (usize, usize), state: &SystemState) -> [f64; 3] {
        let surplus = state.surplus.get(number).map(|ends| ends[end]);
        let Some((payout, sign)) = self.paid[number].ends[end] else {
            return [0.0; 3];
        };
        let (joint, joints) = (self.payouts[payout].joint, &state.joints);
        let out = [&joints.x, &joints.v, &joints.a].map(|list| sign * list[joint].x);
        let mesh = self.mesh_length(number, end);
        surplus.map_or([0.0; 3], |surplus| surplus.at(out, mesh))
    }

    /// Adds to what an end segment has too much.
    pub(super) fn add_surplus(
        &self,
        (number, end): (usize, usize),
        length: f64,
        state: &mut SystemState,
    ) {
        let Some((payout, sign)) = self.paid[number].ends[end] else {
            return;
        };
        let left = self.surplus((number, end), state)[0];
        let out = sign * state.joints.x[self.payouts[payout].joint].x;
        let mesh = self.mesh_length(number, end);
        state.surplus.resize_with(self.paid.len(), Default::default);
        state.surplus[number][end] = Surplus::new(left + length, out, mesh);
    }

    /// Power of the tension on what meshing left too much in all end segments \[W\].
    pub(super) fn surplus_power(&self, state: &SystemState) -> f64 {
        let power = |(number, end): (usize, usize)| {
            let [_, rate, _] = self.surplus((number, end), state);
            if rate == 0.0 {
                return 0.0;
            }
            let (line, own) = (
                &state.paid[number].line,
                &state.lines[self.paid[number].line],
            );
            let i = end * (line.segments.len() - 1);
            -rate * line.tension_now(i, &line.chord(i, own), own).value
        };
        self.paid_ends().map(power).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_runs_off_smoothly_over_a_segment_either_way() {
        let (mesh, since, h) = (2.0, 3.0, 1e-4);
        let surplus = Surplus::new(0.01, since, mesh);
        for way in [-1.0, 1.0] {
            let left = |out: f64| surplus.at([since + way * out, way, 0.0], mesh);
            assert_eq!(left(0.0), [0.01, 0.0, 0.0]);
            assert_eq!(left(mesh), [0.0; 3]);
            for out in [0.3, 1.0, 1.7] {
                let [before, now, after] = [out - h, out, out + h].map(left);
                assert!(((after[0] - before[0]) / (2.0 * h) - now[1]).abs() < 1e-9);
                assert!(((after[1] - before[1]) / (2.0 * h) - now[2]).abs() < 1e-9);
            }
        }
        assert_eq!(
            Surplus::new(1.0, 0.0, mesh).at([0.0; 3], mesh)[0],
            MOST * mesh
        );
    }
}
