//! Lines at rest.

pub mod catenary;
mod eased;
pub mod equilibrium;
pub mod reconfiguration;
