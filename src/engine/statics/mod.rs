//! Static equilibrium.

pub mod catenary;
mod continuation;
pub mod equilibrium;
mod sliding;
