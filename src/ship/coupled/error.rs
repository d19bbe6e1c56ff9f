//! Why a coupled analysis fails.

use super::moored_ship::MooredShipError;
use crate::dynamics::MarchError;

/// Why there is no coupled analysis.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CoupledError {
    /// The file lacks an input.
    #[error("{0}")]
    Missing(&'static str),
    /// The anchor line is invalid or has no equilibrium.
    #[error("the anchor line cannot be built: {0}")]
    Line(String),
    /// The line cannot hold a ship.
    #[error(transparent)]
    MooredShip(#[from] MooredShipError),
    /// Time integration failed.
    #[error("the time integration failed {0}")]
    March(#[from] MarchError),
    /// Stopped on request.
    #[error("it was stopped")]
    Stopped,
}
