//! The error of end forces by the mesh.

use super::line_equilibrium::differences;
use super::{LineBetweenEnds, LineEquilibrium, LineError};
use crate::case::{Case, DragCoefficient};
use crate::numerics::richardson::Refinement;

/// The order of a line's results in the length of its segments.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct MeshOrder(f64);

impl MeshOrder {
    /// Of the lumped-mass line.
    pub const SECOND: Self = Self(2.0);
    /// Where the drag coefficient jumps with the velocity.
    const OF_CRISIS: Self = Self(1.5);

    /// The order of the line of a case.
    #[must_use]
    pub fn of_case(case: &Case) -> Self {
        match has_crisis(case) {
            true => Self::OF_CRISIS,
            false => Self::SECOND,
        }
    }

    /// The lower of two.
    #[must_use]
    pub fn lower(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// Error of the coarser of two results by their difference (Richardson), with a factor of safety of 3 (Roache 1994, doi
    /// 10.1115/1.2910291); `ratio` is that of their segments.
    #[must_use]
    pub fn share_of_coarser(self, ratio: f64) -> f64 {
        let by_mesh = Refinement {
            ratio,
            order: self.0,
        };
        // r^p times that of the finer.
        ratio.powf(self.0) * by_mesh.presumed(1.0, 0.0)
    }
}

/// Estimated error of the force on either end by the mesh \[N\], A first: from the same line with segments half as long
/// (Richardson), of the order of the method, 2 (1.5 with a drag crisis), and with a factor of safety of 3 (Roache 1994,
/// doi 10.1115/1.2910291). The order presumes that segments are short against every length of the solution: the bending length
/// `sqrt(EI/T)` at clamps and touchdowns, the length on the bed. It costs a cold start of twice the nodes: once for a
/// result, not in an iteration. Friction of the bed is that of a line laid for these ends ([`LineBetweenEnds::lay`]).
///
/// # Errors
/// Those of the finer line; see [`LineBetweenEnds::solve`].
pub fn mesh_error(case: &Case, line: &LineEquilibrium) -> Result<[f64; 2], LineError> {
    let mut finer = case.clone();
    for section in &mut finer.line {
        section.segments *= 2;
    }
    let [a, b] = line.ends_m();
    let mut finer = LineBetweenEnds::new(&finer)?;
    finer.lay_from(line.laid_from);
    let fine = finer.solve(a, b)?;
    let share = MeshOrder::of_case(case).share_of_coarser(2.0);
    Ok(differences(line, &fine).map(|d| share * d))
}

/// Whether a coefficient of drag depends on velocity.
fn has_crisis(case: &Case) -> bool {
    let materials = case
        .line
        .iter()
        .filter_map(|section| case.materials.get(&section.material));
    materials
        .into_iter()
        .any(|material| matches!(material.drag_normal, DragCoefficient::Named(_)))
}
