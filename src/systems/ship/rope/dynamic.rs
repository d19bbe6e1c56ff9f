//! The rope at the moving ship on the dynamic solver against the quasi-static analysis: the effect of the inertia of rope and
//! cargo on the tension, around the maximum of the record.

use crate::numerics::statistics::{Statistics, rms_difference};
use crate::ropeway::rope_system::{self, SHIP_TENSION};
use crate::ropeway::winch::WinchSample;
use crate::ropeway::{RopewayError, SolvedRopeway};
use crate::run::Work;

/// Simulated time \[s\], the time over which the motion grows, and that from which statistics count.
const DURATION: f64 = 120.0;
const RAMP: f64 = 20.0;
const FROM: f64 = 40.0;

/// Tension of the rope made fast over part of the record, quasi-static and dynamic.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicRope {
    /// Times in the record \[s\].
    pub times: Vec<f64>,
    /// Tension at the ship in equilibrium at every instant \[N\].
    pub quasi_static: Vec<f64>,
    /// Tension at the ship by the dynamic solver \[N\].
    pub dynamic: Vec<f64>,
    /// Estimated time error of the maximum tension \[N\].
    pub time_error: Option<f64>,
    /// Estimated mesh error of the maximum tension \[N\].
    pub mesh_error: Option<f64>,
    /// Work of the dynamic solver.
    pub work: Work,
    /// First value of the statistics, after the motion has grown.
    pub first: usize,
}

impl DynamicRope {
    /// Simulates the rope, made fast, around the maximum tension of its record with this step \[s\].
    ///
    /// # Errors
    /// [`RopewayError`] where the cargo hangs on a support or the dynamic solver fails.
    pub fn new(
        ropeway: &SolvedRopeway,
        fast: &[WinchSample],
        step: f64,
    ) -> Result<Self, RopewayError> {
        let start = ropeway.equilibrium(ropeway.ropeway.cargo.position)?;
        let window = around_maximum(fast, (DURATION / step).round() as usize);
        let count = window.len() - 1;
        let displacements = window.iter().enumerate().map(|(i, sample)| {
            let ship = &sample.ship;
            (step * i as f64, [ship.x_m, 0.0, ship.z_m])
        });
        let times = (step * count as f64, RAMP, step);
        let file = rope_system::at_moving_ship(&ropeway.ropeway, &start, displacements, times);
        let run = rope_system::compute(file)?;
        let mut channels = run.channels.iter();
        let tension = channels.find(|channel| channel.id.to_string() == SHIP_TENSION);
        let of_maximum = |errors: [f64; 4]| errors[1];
        Ok(Self {
            times: window.iter().map(|sample| sample.ship.time_s).collect(),
            quasi_static: window.iter().map(|sample| sample.ship_n).collect(),
            dynamic: rope_system::values(&run.history, SHIP_TENSION)?.to_vec(),
            time_error: tension.and_then(|found| found.time_error).map(of_maximum),
            mesh_error: tension.and_then(|found| found.mesh_error).map(of_maximum),
            work: run.work,
            first: ((FROM / step).round() as usize).min(count),
        })
    }

    /// Statistics of the quasi-static and of the dynamic tension.
    #[must_use]
    pub fn statistics(&self) -> [Statistics; 2] {
        self.counted().map(Statistics::of_values)
    }

    /// Root mean square difference of dynamic and quasi-static tension \[N\].
    #[must_use]
    pub fn rms_difference(&self) -> f64 {
        let [quasi_static, dynamic] = self.counted();
        rms_difference(quasi_static, dynamic)
    }

    /// Quasi-static and dynamic tension from the beginning of the statistics.
    fn counted(&self) -> [&[f64]; 2] {
        [&self.quasi_static, &self.dynamic].map(|values| values.get(self.first..).unwrap_or(&[]))
    }
}

/// At most `count` steps of a record, two thirds of them before its maximum tension.
fn around_maximum(fast: &[WinchSample], count: usize) -> &[WinchSample] {
    let order =
        |a: &(usize, &WinchSample), b: &(usize, &WinchSample)| a.1.ship_n.total_cmp(&b.1.ship_n);
    let at = fast.iter().enumerate().max_by(order).map_or(0, |(i, _)| i);
    let count = count.min(fast.len().saturating_sub(1));
    let from = at.saturating_sub(2 * count / 3).min(fast.len() - 1 - count);
    &fast[from..=from + count]
}
