//! The rope at the moving ship on the dynamic solver against the quasi-static analysis: the effect of the inertia of rope and
//! cargo on the tension, around the maximum of the record.

use std::fmt::Write;
use std::sync::atomic::AtomicBool;

use crate::case;
use crate::numerics::statistics::{Statistics, rms_difference};
use crate::ropeway::winch::Moment;
use crate::ropeway::{Trouble, Worked, line};
use crate::run::job::{self, Request};
use crate::run::{RunState, Work};

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
    /// [`Trouble`] where the cargo hangs on a support or the dynamic solver fails.
    pub fn new(ropeway: &Worked, fast: &[Moment], step: f64) -> Result<Self, Trouble> {
        let start = ropeway.rest(ropeway.ropeway.cargo.position)?;
        let window = around_maximum(fast, (DURATION / step).round() as usize);
        let count = window.len() - 1;
        let mut table = String::from("time_s,x_m,y_m,z_m\n");
        for (i, moment) in window.iter().enumerate() {
            let (t, ship) = (step * i as f64, &moment.ship);
            // Writing to a text does not fail.
            let _ = writeln!(table, "{t:?},{:?},0.0,{:?}", ship.x_m, ship.z_m);
        }
        let shape = (start.length_m, start.arc_m);
        let duration = step * count as f64;
        let text = line::moving_text(&ropeway.ropeway, shape, &table, (duration, RAMP, step));
        let run = execute(text)?;
        let tension = run.history.channel("tension_n[ship-side|ship]");
        let tension = tension.ok_or(Trouble::NotFound("the run has no tension at the ship"))?;
        let maximum = run
            .summary
            .iter()
            .find(|found| found.name == "tension_n[ship-side|ship].max");
        Ok(Self {
            times: window.iter().map(|m| m.ship.time_s).collect(),
            quasi_static: window.iter().map(|m| m.ship_n).collect(),
            dynamic: tension.values.clone(),
            time_error: maximum.and_then(|found| found.time_error),
            mesh_error: maximum.and_then(|found| found.mesh_error),
            work: run.info.work,
            first: ((FROM / step).round() as usize).min(count),
        })
    }

    /// Statistics of the quasi-static and of the dynamic tension.
    #[must_use]
    pub fn statistics(&self) -> [Statistics; 2] {
        self.counted().map(Statistics::of)
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
fn around_maximum(fast: &[Moment], count: usize) -> &[Moment] {
    let order = |a: &(usize, &Moment), b: &(usize, &Moment)| a.1.ship_n.total_cmp(&b.1.ship_n);
    let at = fast.iter().enumerate().max_by(order).map_or(0, |(i, _)| i);
    let count = count.min(fast.len().saturating_sub(1));
    let from = at.saturating_sub(2 * count / 3).min(fast.len() - 1 - count);
    &fast[from..=from + count]
}

fn execute(text: String) -> Result<crate::run::Run, Trouble> {
    let case = case::parse(&text, "ropeway")
        .map_err(|_| Trouble::NotFound("the ropeway makes no line case"))?;
    let request = Request {
        case,
        text,
        file: "ropeway.toml".to_owned(),
        overrides: Vec::new(),
        id: String::new(),
    };
    let run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
    if run.info.state == RunState::Done {
        Ok(run)
    } else {
        Err(Trouble::NotFound("the march of the rope gave up"))
    }
}
