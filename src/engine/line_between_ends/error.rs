//! Why a line between two ends has no solution.

use crate::numerics::SingularBlock;
use crate::scene::SceneError;
use crate::statics::equilibrium::EquilibriumError;

/// Why a line between two ends has no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LineError {
    /// The case contradicts itself.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An end moves or is free.
    #[error(
        "`{key}.kind` must be \"fixed\" or \"anchor\": the place of the end is given with every solution"
    )]
    NotHeld {
        /// The table of the end.
        key: &'static str,
    },
    /// A place is not finite.
    #[error("the places of the ends must be finite numbers")]
    NotFinite,
    /// The line does not come to rest.
    #[error(transparent)]
    NoEquilibrium(#[from] EquilibriumError),
    /// The end stiffness is not finite.
    #[error("the line at rest has no end stiffness: {0}")]
    NoStiffness(#[from] SingularBlock),
}
