//! The rope at the moving ship on the dynamic solver, beside the equilibria that it is otherwise followed by: what the inertia
//! of rope and cargo makes of the tension, around the greatest of the record.

use crate::case::ChannelQuantity;
use crate::numerics::statistics::Statistics;
use crate::ropeway::line::{self, LineRun};
use crate::ropeway::winch::WinchSample;
use crate::ropeway::{RopewayError, SolvedRopeway};

/// Time that is followed \[s\], of which the motion grows over the first part and statistics count the rest.
const WINDOW: f64 = 120.0;
const RAMP: f64 = 20.0;
const COUNTED: f64 = 40.0;

/// The rope made fast over a stretch of the record, in two ways.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicRope {
    /// Times in the record \[s\].
    pub times: Vec<f64>,
    /// Tension at the ship from equilibrium to equilibrium \[N\].
    pub still: Vec<f64>,
    /// The same on the dynamic solver \[N\].
    pub dynamic: Vec<f64>,
    /// Its estimated error by the step and by the mesh, of the greatest tension \[N\].
    pub errors: (Option<f64>, Option<f64>),
    /// Steps taken and Newton iterations.
    pub work: (u64, u64),
    /// First of the values that statistics count; before, the motion grows from nothing.
    pub counted: usize,
}

impl DynamicRope {
    /// Statistics of the equilibria and of the dynamic solver.
    #[must_use]
    pub fn statistics(&self) -> [Statistics; 2] {
        let of = |values: &[f64]| Statistics::of(values.get(self.counted..).unwrap_or(&[]));
        [of(&self.still), of(&self.dynamic)]
    }

    /// Root mean square difference of the two \[N\].
    #[must_use]
    pub fn apart(&self) -> f64 {
        let pairs = self.still.iter().zip(&self.dynamic).skip(self.counted);
        let squares: Vec<f64> = pairs.map(|(a, b)| (a - b).powi(2)).collect();
        (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
    }
}

/// Follows the rope, made fast, around the greatest tension of its record, whose instants lie a step \[s\] apart.
///
/// # Errors
/// [`RopewayError`] where the cargo hangs on a support or the line is not marched.
pub fn beside(
    worked: &SolvedRopeway,
    fast: &[WinchSample],
    step: f64,
) -> Result<DynamicRope, RopewayError> {
    let start = worked.equilibrium(worked.ropeway.cargo.position)?;
    let most =
        |a: &(usize, &WinchSample), b: &(usize, &WinchSample)| a.1.ship_n.total_cmp(&b.1.ship_n);
    let at = fast.iter().enumerate().max_by(most).map_or(0, |(i, _)| i);
    let count = ((WINDOW / step).round() as usize).min(fast.len().saturating_sub(1));
    let from = at.saturating_sub(2 * count / 3).min(fast.len() - 1 - count);
    let window = &fast[from..=from + count];
    let displacements = window.iter().enumerate();
    let displacements =
        displacements.map(|(i, moment)| (step * i as f64, [moment.ship.x_m, 0.0, moment.ship.z_m]));
    let shape = (start.length_m, start.arc_m);
    let times = (step * count as f64, RAMP, step);
    let case = line::moving_case(&worked.ropeway, shape, displacements, times);
    let line = LineRun::compute(case)?;
    Ok(DynamicRope {
        times: window.iter().map(|m| m.ship.time_s).collect(),
        still: window.iter().map(|m| m.ship_n).collect(),
        dynamic: line.values(ChannelQuantity::Tension, line.ship())?.to_vec(),
        errors: line.errors_of_greatest_tension(),
        work: (line.run.info.work.steps, line.run.info.work.iterations),
        counted: ((COUNTED / step).round() as usize).min(count),
    })
}
