//! Unstretched length of line on the bed.
//!
//! Every node stands for the halves of its segments, and counts by a share between 0 and 1; an end at the bed counts as the node beside it.
//! At rest a node that touches counts in full, so that the length is known to half a segment at every touchdown. Against time a node
//! counts by the share of the weight of its halves that the springs of the bed bear where it is: what leaves the bed at a touchdown does so
//! gradually, the length is continuous there, and at rest an end up from there carries the rest of the line: `V = w (L - length on the bed)`.

use super::{BedContact, Scene};
use crate::numerics::V3;
use crate::solve::State;

/// How far above the bed a node touches it, by the length of the line.
const TOUCHES: f64 = 1e-9;

impl Scene {
    /// Length of the halves of segments at nodes that touch the bed \[m\]: to half a segment at every touchdown; 0 without a bed.
    #[must_use]
    pub fn length_touching_bed(&self, state: &State) -> f64 {
        let (bed, last) = (self.elements.bed.as_ref(), self.line_nodes() - 1);
        let touches = |i: usize| bed.is_some_and(|bed| self.touches_bed(bed, i, state));
        let bears = |i: usize| match i {
            0 => touches(0) && touches(1),
            i if i == last => touches(last) && touches(last - 1),
            i => touches(i),
        };
        let nodes = (0..=last).filter(|i| bears(*i));
        nodes.map(|i| self.halves_at(i)).sum()
    }

    /// Length of line whose weight the bed bears \[m\], continuous as nodes land and leave; none without a bed. Does not allocate.
    #[must_use]
    pub fn length_on_bed(&self, state: &State) -> Option<f64> {
        let bed = self.elements.bed.as_ref()?;
        let (nodes, mut sum, mut node) = (self.line_nodes(), 0.0, 0);
        while node < nodes {
            let first = node;
            while node < nodes && self.touches_bed(bed, node, state) {
                node += 1;
            }
            if node > first {
                let share = |node: usize| self.borne_share(bed, node, state);
                sum += self.stretch_on_bed([first, node - 1], share);
            }
            node += 1;
        }
        Some(sum)
    }

    pub(super) fn touches_bed(&self, bed: &BedContact, node: usize, state: &State) -> bool {
        bed.height(&state.x[node]) <= TOUCHES * self.line.arc[self.line_nodes() - 1]
    }

    /// Length of the halves of the segments at a node \[m\].
    pub(super) fn halves_at(&self, node: usize) -> f64 {
        let (arc, last) = (&self.line.arc, self.line_nodes() - 1);
        0.5 * (arc[(node + 1).min(last)] - arc[node.saturating_sub(1)])
    }

    /// The length of a stretch of nodes that touch, from its first to its last one \[m\]. From either side nodes count by the greatest share so far, up to the node
    /// with the greatest of all or to an end that is held at the bed: what rises and falls between counts as lying.
    fn stretch_on_bed(&self, [first, end]: [usize; 2], share: impl Fn(usize) -> f64) -> f64 {
        let last = self.line_nodes() - 1;
        let peak = match (first == 0, end == last) {
            (true, true) => return self.line.arc[last],
            (true, false) => first,
            (false, true) => end,
            (false, false) => {
                let nodes = (first..=end).map(|i| (i, share(i)));
                let greater = |a: (usize, f64), b: (usize, f64)| if b.1 > a.1 { b } else { a };
                nodes.reduce(greater).map_or(first, |(node, _)| node)
            }
        };
        let flank = |nodes: &mut dyn Iterator<Item = usize>| {
            nodes.fold((0.0, 0.0_f64), |(sum, most), i| {
                let most = most.max(share(i));
                (sum + self.halves_at(i) * most, most)
            })
        };
        let (before, after) = (
            flank(&mut (first..peak)),
            flank(&mut (peak + 1..=end).rev()),
        );
        let at_peak = match peak {
            0 => after.1,
            node if node == last => before.1,
            node => share(node),
        };
        before.0 + after.0 + self.halves_at(peak) * at_peak
    }

    /// The share of the weight of the halves of segments at a node that the springs of the bed bear where it is, at most 1; 1 of what touches
    /// and has no weight. The normal reaction of a slope bears the part of the weight along it.
    fn borne_share(&self, bed: &BedContact, node: usize, state: &State) -> f64 {
        let push = bed
            .seabed
            .push(&state.x[node], &V3::zeros(), bed.footprint[node]);
        let gradient = bed.seabed.gradient(&state.x[node]);
        let (segments, first) = (&self.line.segments, node.saturating_sub(1));
        let halves = segments[first..(node + 1).min(segments.len())].iter();
        let weight: f64 = halves.map(|segment| segment.half_weight).sum();
        let across = weight * gradient.z;
        if across <= 0.0 {
            return f64::from(push.force > 0.0);
        }
        (push.force * gradient.norm_squared() / across).min(1.0)
    }
}
