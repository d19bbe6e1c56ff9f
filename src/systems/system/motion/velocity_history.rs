//! Past velocities of a body, for the memory of the waves that it radiates.

use nalgebra::Vector6;
use serde::{Deserialize, Serialize};

use crate::numerics::processor::Lanes;
use crate::system::potential_flow::retardation::Retardation;

/// Rows that a history has room for at the start.
const ROOM: usize = 4096;

/// Velocities of a body along the axes that damping acts in at the accepted times, as far back as its memory goes.
#[derive(Debug, Serialize, Deserialize)]
pub struct VelocityHistory {
    rows: Vec<(f64, Vector6<f64>)>,
    /// Slopes from each row to the next, of the velocity of each retardation function side by side; from the rows, where they are asked for.
    #[serde(skip)]
    slopes: Vec<Lanes>,
}

impl Default for VelocityHistory {
    fn default() -> Self {
        Self {
            rows: Vec::with_capacity(ROOM),
            slopes: Vec::new(),
        }
    }
}

impl PartialEq for VelocityHistory {
    fn eq(&self, other: &Self) -> bool {
        self.rows == other.rows
    }
}

impl Clone for VelocityHistory {
    fn clone(&self) -> Self {
        let mut made = Self::default();
        made.clone_from(self);
        made
    }

    /// Histories grow at their ends: one whose last row is at its place in the other has all before it too, so that only what is new is copied.
    fn clone_from(&mut self, other: &Self) {
        let known = self.rows.len();
        let begins = known > 0
            && other.rows.get(known - 1) == self.rows.last()
            && other.rows[0].0 == self.rows[0].0;
        let slopes = self.slopes.len();
        let room = other.slopes.capacity();
        self.slopes.reserve(room.saturating_sub(slopes));
        if begins && slopes <= other.slopes.len() {
            self.rows.extend_from_slice(&other.rows[known..]);
            self.slopes.extend_from_slice(&other.slopes[slopes..]);
        } else {
            self.rows.clone_from(&other.rows);
            self.slopes.clone_from(&other.slopes);
        }
    }
}

impl VelocityHistory {
    /// Adds the velocity at an accepted time \[s\], and forgets what is older than the memory.
    pub(super) fn push(&mut self, t: f64, velocity: Vector6<f64>, retardation: &Retardation) {
        let fours = retardation.fours();
        if let Some(last) = self.rows.last_mut().filter(|last| last.0 >= t) {
            *last = (t, velocity);
            self.slopes
                .truncate(self.rows.len().saturating_sub(2) * fours);
        } else {
            self.rows.push((t, velocity));
        }
        let forgotten = t - retardation.duration();
        let old = self.rows.partition_point(|row| row.0 < forgotten);
        let old = old.saturating_sub(1);
        // Seldom, since what is left has to be moved.
        if old > ROOM / 4 {
            self.complete(retardation);
            self.rows.drain(..old);
            self.slopes.drain(..old * fours);
        }
        self.complete(retardation);
    }

    /// Works out the slopes that are not known yet.
    pub(super) fn complete(&mut self, retardation: &Retardation) {
        let fours = retardation.fours();
        let known = self.slopes.len().checked_div(fours);
        let Some(known) = known.filter(|known| known + 2 <= self.rows.len()) else {
            return;
        };
        if self.slopes.capacity() == 0 {
            self.slopes.reserve(ROOM * fours);
        }
        for pair in self.rows[known..].windows(2) {
            let slope = (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
            self.slopes.extend(retardation.side_by_side(&slope));
        }
    }

    /// The rows from the last one before a time \[s\], and the slopes between them.
    pub(super) fn since(
        &self,
        time: f64,
        retardation: &Retardation,
    ) -> (&[(f64, Vector6<f64>)], &[Lanes]) {
        let older = self.rows.partition_point(|row| row.0 < time);
        let first = older.saturating_sub(1);
        (
            &self.rows[first..],
            self.slopes
                .get(first * retardation.fours()..)
                .unwrap_or_default(),
        )
    }
}
