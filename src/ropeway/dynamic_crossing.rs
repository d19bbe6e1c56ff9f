//! The crossing on the dynamic solver: the cargo hauled over the discretised line, and the natural frequency of the line
//! with the cargo on it.

use super::RopewayError;
use super::cargo_motion::MARGIN;
use super::line::{self, LineRun};
use super::solve::SolvedRopeway;
use crate::case::{ChannelLocation, ChannelQuantity};
use crate::modes::{self, ModeKind};
use crate::numerics::V3;

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
        let way = (
            self.equilibrium(1.0 - MARGIN)?.arc_m,
            self.equilibrium(MARGIN)?.arc_m,
        );
        if way.0 - way.1 > LONGEST * self.ropeway.cargo.speed_m_per_s {
            return Err(RopewayError::NotFound(
                "the crossing takes longer than 900 s",
            ));
        }
        let duration = (way.0 - way.1) / self.ropeway.cargo.speed_m_per_s + 1.0;
        let case = line::crossing_case(&self.ropeway, self.length_m, way, duration);
        states(&LineRun::compute(case)?)
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
        let cargo = found.scene.labels.clumps.first().copied().unwrap_or(0);
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

fn states(line: &LineRun) -> Result<Vec<CrossingState>, RopewayError> {
    let x = line.values(ChannelQuantity::X, ChannelLocation::Traveller)?;
    let z = line.values(ChannelQuantity::Z, ChannelLocation::Traveller)?;
    let platform = line.values(ChannelQuantity::Tension, ChannelLocation::Joint(0))?;
    let ship = line.values(ChannelQuantity::Tension, line.ship())?;
    let cargo = x.iter().zip(z);
    let ends = platform.iter().zip(ship);
    let instants = line.run.history.time.iter().zip(cargo).zip(ends);
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
