//! Unstretched length of line that slides over the bed.
//!
//! A node slides where friction is at its limit and the node moves against it: its anchor is dragged along. Every node stands for the halves of its
//! segments, as for the length on the bed; an end at the bed counts as the node beside it. What rests at the limit, as behind a pull that has turned,
//! does not slide.

use super::{BedContact, Scene};
use crate::solve::State;

impl Scene {
    /// Whether friction of a bed holds the line at rest.
    #[must_use]
    pub fn has_grips(&self) -> bool {
        let bed = self.elements.bed.as_ref();
        bed.is_some_and(BedContact::holds_at_rest)
    }

    /// Length of line that slid over the bed in the last step \[m\]; none without a bed whose friction holds at rest. Does not allocate.
    #[must_use]
    pub fn sliding_length(&self, state: &State) -> Option<f64> {
        let bed = self.elements.bed.as_ref();
        let bed = bed.filter(|bed| bed.holds_at_rest())?;
        let last = self.line_nodes() - 1;
        let grips = &state.memory.grips;
        let fastest = grips.iter().map(|grip| grip.slip).fold(0.0, f64::max);
        let slides = |node: usize| {
            let grip = grips.get(node);
            grip.is_some_and(|grip| grip.slides(&state.x[node], fastest))
        };
        let lies = |bed: &BedContact, node: usize| self.touches_bed(bed, node, state);
        let counts = |node: usize| match node {
            0 => slides(0) || lies(bed, 0) && slides(1),
            node if node == last => slides(last) || lies(bed, last) && slides(last - 1),
            node => slides(node),
        };
        let nodes = (0..=last).filter(|node| counts(*node));
        // The sum of nothing is -0.0.
        Some(nodes.fold(0.0, |sum, node| sum + self.halves_at(node)))
    }
}
