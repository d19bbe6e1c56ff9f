//! Lines at rest.

pub mod catenary;
pub mod equilibrium;
pub mod reconfiguration;
