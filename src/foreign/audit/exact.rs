//! The lines of a file in the system at rest: where they are and what they bear.

use crate::import::mooring::Mooring;
use crate::import::to_case::joints::{LineJoints, chains};
use crate::numerics::V3;
use crate::system::SolvedSystem;
use crate::system::line_at_rest::LineAtRest;

/// A line of the file as a part of a line of the case, which may be several joined.
#[derive(Debug, Clone)]
pub struct ExactLine<'s> {
    at_rest: &'s LineAtRest,
    ends: [V3; 2],
    /// Shares of the whole where its ends A and B are.
    shares: [f64; 2],
    /// Error of its end forces \[N\], where it is known.
    pub error: Option<f64>,
    /// Length on the bed of the whole \[m\].
    pub on_bed: f64,
}

impl<'s> ExactLine<'s> {
    /// The lines of a mooring without repeats, in their order; `solved` is its system at rest.
    #[must_use]
    pub fn all(mooring: &Mooring, solved: &'s SolvedSystem) -> Vec<Option<Self>> {
        let mut all = vec![None; mooring.lines.len()];
        let whole = solved.rest.balance.lines.iter().zip(&solved.network.lines);
        let chains = chains(mooring, &LineJoints::of_mooring(mooring));
        for (number, (chain, (at_rest, line))) in chains.iter().zip(whole).enumerate() {
            let ends = [line.from, line.to].map(|p| solved.rest.placement.points[p]);
            let lengths = chain.pieces.iter();
            let length: f64 = lengths.map(|(k, _)| mooring.lines[*k].length.value).sum();
            let mut before = 0.0;
            for (piece, backwards) in &chain.pieces {
                let from = before / length;
                before += mooring.lines[*piece].length.value;
                let to = before / length;
                all[*piece] = Some(Self {
                    at_rest,
                    ends,
                    shares: if *backwards { [to, from] } else { [from, to] },
                    error: solved.errors.lines[number],
                    on_bed: at_rest.on_bed(),
                });
            }
        }
        all
    }

    /// Place \[m\] and tension \[N\] at a share of the line from its end A.
    #[must_use]
    pub fn at(&self, share: f64) -> (V3, f64) {
        let [a, b] = self.shares;
        let whole = a + (b - a) * share;
        self.at_rest.at(whole, [&self.ends[0], &self.ends[1]])
    }
}
