//! Segments that snap taut within a step: see [`MidstepBalance`](crate::solve::MidstepBalance).

use super::LumpedLine;
use crate::numerics::V3;
use crate::solve::State;

impl LumpedLine {
    /// The greatest acceleration \[m/s²\] that segments which are slack at `between` and taut at `end` give a node there.
    pub(super) fn acceleration_by_snaps(&self, between: &State, end: &State) -> f64 {
        let mut jolt = 0.0_f64;
        for (i, segment) in self.segments.iter().enumerate() {
            let unstretched = segment.axial.length * segment.axial.length;
            let taut = |s: &State| (s.x[i + 1] - s.x[i]).norm_squared() > unstretched;
            if taut(end) && !taut(between) && !segment.axial.rod {
                let stretch = (end.x[i + 1] - end.x[i]).norm() - segment.axial.length;
                let pull = segment.axial.ea * stretch / segment.axial.length;
                jolt = jolt.max(pull / self.mass[i].min(self.mass[i + 1]));
            }
        }
        jolt
    }

    /// Whether the displacements `-d` that led to this state turned a segment taut or slack: the derivative of its tension jumps there.
    #[must_use]
    pub(crate) fn turns_taut_or_slack(&self, d: &[V3], state: &State) -> bool {
        self.segments.iter().enumerate().any(|(i, segment)| {
            let unstretched = segment.axial.length * segment.axial.length;
            let chord = state.x[i + 1] - state.x[i];
            let before = chord + (d[i + 1] - d[i]);
            !segment.axial.rod
                && (chord.norm_squared() > unstretched) != (before.norm_squared() > unstretched)
        })
    }
}
