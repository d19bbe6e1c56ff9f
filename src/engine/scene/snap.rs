//! Segments that snap taut within a step: see [`MidstepBalance`](crate::solve::MidstepBalance).

use super::LumpedLine;
use crate::numerics::V3;
use crate::solve::State;

impl LumpedLine {
    /// The greatest acceleration \[m/s²\] that segments which are slack in a state between and taut at the end give a node there. Between,
    /// the line is another where it is paid out.
    #[must_use]
    pub fn acceleration_by_snaps(&self, (line, between): (&Self, &State), end: &State) -> f64 {
        let mut jolt = 0.0_f64;
        for (i, segment) in self.segments.iter().enumerate() {
            let taut = |line: &Self, s: &State| {
                (s.x[i + 1] - s.x[i]).norm_squared() > line.segments[i].axial.length.powi(2)
            };
            if taut(self, end) && !taut(line, between) && !segment.axial.rod {
                let stretch = (end.x[i + 1] - end.x[i]).norm() - segment.axial.length;
                let pull = segment.axial.ea * stretch / segment.axial.length;
                jolt = jolt.max(pull / self.mass[i].min(self.mass[i + 1]));
            }
        }
        jolt
    }

    /// Whether the displacements `-d` that led to this state, and lengths paid out at the ends with them, turned a segment taut or slack: the
    /// derivative of its tension jumps there.
    #[must_use]
    pub fn turns_taut_or_slack(&self, d: &[V3], out: [f64; 2], state: &State) -> bool {
        let last = self.segments.len() - 1;
        self.segments.iter().enumerate().any(|(i, segment)| {
            let length = segment.axial.length;
            let ends = [(0, out[0]), (last, out[1])].into_iter();
            let longer: f64 = ends.filter(|(end, _)| *end == i).map(|(_, d)| d).sum();
            let chord = state.x[i + 1] - state.x[i];
            let before = chord + (d[i + 1] - d[i]);
            let taut = |chord: &V3, length: f64| chord.norm_squared() > length * length;
            !segment.axial.rod && taut(&chord, length) != taut(&before, length + longer)
        })
    }
}
