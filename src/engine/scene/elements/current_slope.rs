//! Change of the drag on segments with the current along x and y, over a grid of places: a part of the tangent alone. That with
//! the height is in the segment kernel, and the drag of point bodies has all of it.

use crate::numerics::lanes::{self, TwoM3};
use crate::numerics::{BlockBand, M3, V3};
use crate::scene::element::{At, Element};
use crate::solve::Factors;

/// The derivative of drag by a current that changes along x and y.
pub(super) struct CurrentSlope;

impl Element for CurrentSlope {
    fn add_residual(&self, _at: At<'_>, _r: &mut [V3]) {}

    fn linearise(&self, at: At<'_>, c: Factors, _r: &mut [V3], tangent: &mut BlockBand) {
        let At { line, state, .. } = at;
        if !line.current.is_grid() {
            return;
        }
        let level = |node: usize| -> M3 {
            let mut gradient = line.current.flow(&state.x[node]).1;
            gradient.set_column(2, &V3::zeros());
            gradient * c.stiffness
        };
        for i in 0..line.segments.len() {
            let chord = line.chord(i, state);
            let drag = line.drag(i, &chord, state);
            let one = |blocks: &TwoM3, half: usize| lanes::block(blocks, half);
            let by_own = drag.matrix(&lanes::twice(&chord.tangent));
            let level = [level(i), level(i + 1)];
            for half in [0, 1] {
                tangent.diag[i + half] -= one(&by_own, half) * level[half];
            }
            if let Some(by_other) = drag.by_other_velocity() {
                tangent.upper[i] -= one(&by_other, 0) * level[1];
                tangent.lower[i + 1] -= one(&by_other, 1) * level[0];
            }
        }
    }

    fn has_explicit_form(&self) -> bool {
        true
    }
}
