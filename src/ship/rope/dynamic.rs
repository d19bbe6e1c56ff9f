//! The rope at the moving ship on the dynamic solver, beside the equilibria that it is otherwise followed by: what the inertia
//! of rope and cargo makes of the tension, around the greatest of the record.

use std::fmt::Write;
use std::sync::atomic::AtomicBool;

use crate::case;
use crate::numerics::statistics::Statistics;
use crate::ropeway::winch::Moment;
use crate::ropeway::{Trouble, Worked, line};
use crate::run::RunState;
use crate::run::job::{self, Request};

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
/// [`Trouble`] where the cargo hangs on a support or the line is not marched.
pub fn beside(worked: &Worked, fast: &[Moment], step: f64) -> Result<DynamicRope, Trouble> {
    let start = worked.rest(worked.ropeway.cargo.position)?;
    let most = |a: &(usize, &Moment), b: &(usize, &Moment)| a.1.ship_n.total_cmp(&b.1.ship_n);
    let at = fast.iter().enumerate().max_by(most).map_or(0, |(i, _)| i);
    let count = ((WINDOW / step).round() as usize).min(fast.len().saturating_sub(1));
    let from = at.saturating_sub(2 * count / 3).min(fast.len() - 1 - count);
    let window = &fast[from..=from + count];
    let mut table = String::from("time_s,x_m,y_m,z_m\n");
    for (i, moment) in window.iter().enumerate() {
        let (t, ship) = (step * i as f64, &moment.ship);
        // Writing to a text does not fail.
        let _ = writeln!(table, "{t:?},{:?},0.0,{:?}", ship.x_m, ship.z_m);
    }
    let shape = (start.length_m, start.arc_m);
    let duration = step * count as f64;
    let text = line::moving_text(&worked.ropeway, shape, &table, (duration, RAMP, step));
    let run = execute(text)?;
    let tension = run.history.channel("tension_n[ship-side|ship]");
    let tension = tension.ok_or(Trouble::NotFound("the run has no tension at the ship"))?;
    let greatest = run.quantity("tension_n[ship-side|ship].max");
    Ok(DynamicRope {
        times: window.iter().map(|m| m.ship.time_s).collect(),
        still: window.iter().map(|m| m.ship_n).collect(),
        dynamic: tension.values.clone(),
        errors: (
            greatest.and_then(|found| found.time_error),
            greatest.and_then(|found| found.mesh_error),
        ),
        work: (run.info.work.steps, run.info.work.iterations),
        counted: ((COUNTED / step).round() as usize).min(count),
    })
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
