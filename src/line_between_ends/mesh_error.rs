//! The error of end forces by the mesh.

use super::line_equilibrium::differences;
use super::{LineBetweenEnds, LineEquilibrium, LineError};
use crate::case::{Case, DragCoefficient};
use crate::numerics::richardson::Refinement;

/// The lumped-mass line is of second order in the length of its segments, where the drag coefficient jumps with the velocity of
/// order 1.5.
const ORDER: f64 = 2.0;
const ORDER_OF_CRISIS: f64 = 1.5;

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
    let order = if has_crisis(case) {
        ORDER_OF_CRISIS
    } else {
        ORDER
    };
    let by_mesh = Refinement { ratio: 2.0, order };
    // Of the coarser of two results: r^p times that of the finer.
    let share = by_mesh.ratio.powf(order);
    Ok(differences(line, &fine).map(|d| share * by_mesh.presumed(d, 0.0)))
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
