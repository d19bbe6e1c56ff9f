//! Kinks of what is prescribed, at which steps end: rows of a current over time, and of tables of motion.

use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::physics::EndMotion;

/// How near a time is to a kink that it has passed, by the time.
const SAME_TIME: f64 = 1e-9;

impl MovingSystem {
    /// The first time after this one \[s\] at which the current has a row, and its rate may jump; infinite where there is none.
    pub(super) fn next_row_of_current(&self, time: f64) -> f64 {
        let current = self.network.current_over_time.as_ref();
        let rows = current.map_or(&[][..], |current| current.times());
        let passed = rows.partition_point(|row| *row <= time + SAME_TIME * (1.0 + time.abs()));
        rows.get(passed).copied().unwrap_or(f64::INFINITY)
    }

    /// The motions that are prescribed, of points and of the origins and angles of bodies.
    pub(super) fn motions(&self) -> impl Iterator<Item = &EndMotion> {
        let points = self.network.points.iter();
        let points = points.filter_map(|point| point.motion.as_ref());
        let bodies = self.network.bodies.iter();
        let bodies = bodies.filter_map(|body| body.motion.as_ref());
        points.chain(bodies.flat_map(|motion| [&motion.place, &motion.angles]))
    }

    /// The next time at which a motion has a kink that is not passed \[s\]; infinite where there is none.
    pub(super) fn next_kink_of_motions(&self, state: &SystemState) -> f64 {
        let passed = state.kinks_passed_s;
        let kinks = self
            .motions()
            .map(|motion| motion.next_kink(motion.piece_at(passed)));
        kinks.fold(f64::INFINITY, f64::min)
    }

    /// Passes the next kink of the motions by time t \[s\], if there is one. Returns whether a velocity jumps there.
    pub(super) fn pass_kink_of_motions(&self, t: f64, state: &mut SystemState) -> bool {
        let kink = self.next_kink_of_motions(state);
        if kink > t + SAME_TIME * (1.0 + t.abs()) {
            return false;
        }
        let passed = state.kinks_passed_s;
        let jumps = |motion: &EndMotion| {
            let piece = motion.piece_at(passed);
            motion.next_kink(piece) == kink && motion.velocity_jumps(piece)
        };
        let jumps = self.motions().any(jumps);
        state.kinks_passed_s = kink;
        self.prescribe(t, state);
        self.follow(state);
        jumps
    }
}
