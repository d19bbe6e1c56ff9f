//! Ship and anchor line in time, and what is recorded of them.

use std::sync::atomic::AtomicBool;

use super::CoupledError;
use super::model::{LINE, SHIP};
use crate::case::{ChannelId, ChannelQuantity};
use crate::numerics::V3;
use crate::run::RunState;
use crate::run::event::JobEvent;
use crate::ship::motion::rigid_displacement;
use crate::system::SystemFile;
use crate::system::motion::run::run;
use crate::system::solved::solve;

/// Names and units of the channels.
pub const CHANNELS: [(&str, &str); 11] = [
    ("surge", "m"),
    ("sway", "m"),
    ("heave", "m"),
    ("roll", "deg"),
    ("pitch", "deg"),
    ("yaw", "deg"),
    ("hang-off surge", "m"),
    ("hang-off sway", "m"),
    ("hang-off heave", "m"),
    ("line at the ship", "N"),
    ("line at the anchor", "N"),
];

/// Work of a time integration, independent of the machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CoupledWork {
    /// Steps.
    pub steps: u64,
    /// Steps halved.
    pub halved: u64,
    /// Newton iterations.
    pub iterations: u64,
}

/// Records of all channels with the work of the integration.
pub(super) struct TimeHistory {
    pub(super) records: Vec<Vec<f64>>,
    pub(super) work: CoupledWork,
}

/// Computes ship and line in time; `hang_off` \[m\] is the rope's point in ship axes.
pub(super) fn integrate(
    file: SystemFile,
    hang_off: &V3,
    stop: &AtomicBool,
) -> Result<TimeHistory, CoupledError> {
    let motion = file.solver.clone().unwrap_or_default();
    let failed = |why: &str, remedy: &str| format!("{why}; {remedy}");
    let solved =
        solve(file).map_err(|why| CoupledError::Rest(failed(&why.problem, &why.remedy)))?;
    let mut rows = CoupledHistory::default();
    let done = run(&solved, &motion, stop, &mut |event| rows.take(event))
        .map_err(|why| CoupledError::Rest(failed(&why.problem, &why.remedy)))?;
    match (done.state, done.failure) {
        (_, Some(why)) => return Err(CoupledError::March(why)),
        (RunState::Done, None) => {}
        _ => return Err(CoupledError::Stopped),
    }
    let mut records = vec![Vec::with_capacity(rows.values.len()); CHANNELS.len()];
    for row in &rows.values {
        for (record, value) in records.iter_mut().zip(channels(row, hang_off)) {
            record.push(value);
        }
    }
    Ok(TimeHistory {
        records,
        work: CoupledWork {
            steps: done.work.steps,
            halved: done.work.rejections,
            iterations: done.work.iterations,
        },
    })
}

/// The rows of a run: position and angles of the ship \[m, deg\], tension of the line at the ship and at its anchor \[N\].
#[derive(Default)]
struct CoupledHistory {
    columns: Vec<usize>,
    values: Vec<[f64; 8]>,
}

impl CoupledHistory {
    fn take(&mut self, event: JobEvent) {
        match event {
            JobEvent::Started { channels, .. } => {
                let pose = ChannelQuantity::POSITION
                    .into_iter()
                    .chain(ChannelQuantity::ANGLES)
                    .map(|quantity| quantity.at(SHIP));
                let ends =
                    ["b", "a"].map(|end| ChannelQuantity::Tension.at(format!("{LINE}|{end}")));
                let column = |id: ChannelId| channels.iter().position(|known| *known == id);
                self.columns = pose.chain(ends).filter_map(column).collect();
            }
            JobEvent::Frame(frame) => {
                let value = |k: usize| self.columns.get(k).map_or(f64::NAN, |c| frame.values[*c]);
                self.values.push(std::array::from_fn(value));
            }
            _ => {}
        }
    }
}

/// The values of [`CHANNELS`] of a row.
fn channels(row: &[f64; 8], hang_off: &V3) -> [f64; CHANNELS.len()] {
    let [x, y, z, roll, pitch, yaw, ship, anchor] = *row;
    let angles = [roll, pitch, yaw].map(f64::to_radians);
    let point = rigid_displacement([x, y, z, angles[0], angles[1], angles[2]], hang_off);
    [
        x, y, z, roll, pitch, yaw, point.x, point.y, point.z, ship, anchor,
    ]
}
