//! Lines at rest.

pub mod equilibrium;
