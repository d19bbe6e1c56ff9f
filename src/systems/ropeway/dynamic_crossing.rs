//! The crossing on the dynamic solver: the cargo hauled along the rope between platform and ship, and the natural frequency of the line
//! with the cargo on it.
//!
//! The cargo is a point between two lines, one of which grows as the other shrinks. A load that travels over the nodes of one line hangs on
//! chords instead, too high by 2 % of its sag with 80 segments, and converges with the length of a segment only.

use super::RopewayError;
use super::cargo_motion::MARGIN;
use super::line;
use super::rope_system::{self, CARGO, LINES, SHIP_TENSION};
use super::solve::SolvedRopeway;
use crate::modes::{self, ModeKind};
use crate::numerics::V3;
use crate::system::motion::run::MotionRun;

/// Longest duration of a crossing that is computed \[s\].
const LONGEST: f64 = 900.0;

/// State of the crossing at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingState {
    /// Time \[s\].
    pub time_s: f64,
    /// Distance of the cargo from the platform \[m\].
    pub x_m: f64,
    /// Height of the cargo above still water \[m\].
    pub z_m: f64,
    /// Tension at the platform \[N\].
    pub platform_n: f64,
    /// Tension at the ship \[N\].
    pub ship_n: f64,
}

impl SolvedRopeway {
    /// Computes the crossing from the ship to the platform, the ship lying still and the rope made fast.
    ///
    /// # Errors
    /// [`RopewayError::NotFound`] where the crossing is too long or the solver gives up.
    pub fn dynamic_crossing(&self) -> Result<Vec<CrossingState>, RopewayError> {
        let from = self.equilibrium(1.0 - MARGIN)?.arc_m;
        let to = self.equilibrium(MARGIN)?.arc_m;
        if from - to > LONGEST * self.ropeway.cargo.speed_m_per_s {
            return Err(RopewayError::NotFound(
                "the crossing takes longer than 900 s",
            ));
        }
        let start = self.rope.with_cargo_at(self.length_m, from)?;
        let file = rope_system::crossing(&self.ropeway, &start, to);
        states(&rope_system::compute(file)?)
    }

    /// Natural frequency of the lowest in-plane mode of the line that moves the cargo vertically, with the cargo at a
    /// position \[Hz\].
    ///
    /// # Errors
    /// [`RopewayError::NotFound`] where the line has no modes.
    pub fn line_frequency_hz(&self, position: f64) -> Result<f64, RopewayError> {
        let rest = self.equilibrium(position)?;
        let case = line::static_case(&self.ropeway, rest.length_m, rest.arc_m);
        let found = modes::of_case(&case, 8)
            .map_err(|_| RopewayError::NotFound("the modes of the line were not found"))?;
        let clumps = found
            .lines
            .iter()
            .flat_map(|line| &line.scene.labels.clumps);
        let cargo = clumps.copied().next().unwrap_or(0);
        // The lowest in-plane mode moves the cargo horizontally; the first with a vertical motion of it compares to eq. (12).
        let lifts = |mode: &modes::Mode| {
            let most = mode.shape.iter().map(V3::norm).fold(0.0, f64::max);
            let up = mode.shape.get(cargo).map_or(0.0, |u| u.z.abs());
            mode.kind != ModeKind::OutOfPlane && up > 0.3 * most
        };
        let named = found.modes.iter().find(|named| lifts(&named.mode));
        named
            .map(|named| named.mode.frequency_hz())
            .ok_or(RopewayError::NotFound(
                "no mode of the line moves the cargo vertically",
            ))
    }
}

fn states(run: &MotionRun) -> Result<Vec<CrossingState>, RopewayError> {
    let values = |channel: String| rope_system::values(&run.history, &channel);
    let (x, z) = (
        values(format!("x_m[{CARGO}]"))?,
        values(format!("z_m[{CARGO}]"))?,
    );
    let platform = values(format!("tension_n[{}|a]", LINES[0]))?;
    let ship = values(SHIP_TENSION.to_owned())?;
    let cargo = x.iter().zip(z);
    let ends = platform.iter().zip(ship);
    let instants = run.history.time.iter().zip(cargo).zip(ends);
    let read = instants.map(
        |((time_s, (x_m, z_m)), (platform_n, ship_n))| CrossingState {
            time_s: *time_s,
            x_m: *x_m,
            z_m: *z_m,
            platform_n: *platform_n,
            ship_n: *ship_n,
        },
    );
    Ok(read.collect())
}
