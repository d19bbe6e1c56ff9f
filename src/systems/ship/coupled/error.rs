//! Why a coupled analysis fails.

/// Why there is no coupled analysis.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CoupledError {
    /// The file lacks an input.
    #[error("{0}")]
    Missing(&'static str),
    /// Ship and line do not come to rest.
    #[error("ship and line do not come to rest: {0}")]
    Rest(String),
    /// Time integration failed.
    #[error("the time integration failed: {0}")]
    March(String),
    /// Stopped on request.
    #[error("it was stopped")]
    Stopped,
}
