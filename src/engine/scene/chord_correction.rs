//! Chord-length correction of generalized-alpha: see [`crate::solve::MidstepBalance::correct_chord_lengths`].

use super::LumpedLine;
use crate::solve::State;

impl LumpedLine {
    /// Writes the excess of the chord lengths at the end of a step over those of the tensions \[m\], `share` of the state before
    /// in the mix.
    ///
    /// With chords d0 and d1, their change D and the mix d, the mix of the lengths less the length of the mix is
    /// `e = s (1 - s) |D normal to d|² / 2 |d|` up to fourth order of the angle. The balance holds for the length of the mix, so
    /// that the excesses before and after mix to e: `(1 - s) e1 + s e0 = e`. Slack segments have none. The line before is another where it is
    /// paid out: the unstretched lengths mix, too.
    pub fn chord_corrections(&self, share: f64, (line, before): (&Self, &State), end: &mut State) {
        end.chord_correction.resize(self.segments.len(), 0.0);
        for (i, segment) in self.segments.iter().enumerate() {
            let (l0, l1) = (line.segments[i].axial.length, segment.axial.length);
            let unstretched = l1 + (l0 - l1) * share;
            let (d0, d1) = (before.x[i + 1] - before.x[i], end.x[i + 1] - end.x[i]);
            let (turn, mix) = (d1 - d0, d1 * (1.0 - share) + d0 * share);
            let (square, along) = (mix.norm_squared(), mix.dot(&turn));
            let slack = square <= unstretched * unstretched;
            end.chord_correction[i] = if slack && !segment.axial.rod {
                0.0
            } else {
                let across = turn.norm_squared() - along * along / square;
                let short = 0.5 * share * (1.0 - share) * across / square.sqrt();
                let known = before.chord_correction.get(i).copied().unwrap_or(0.0);
                (short - share * known) / (1.0 - share)
            };
        }
    }
}
