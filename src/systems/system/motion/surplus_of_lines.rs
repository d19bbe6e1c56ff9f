//! The surplus of the lines of a system, and its power.

use super::{moving_system::MovingSystem, surplus::Surplus, system_state::SystemState};

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
