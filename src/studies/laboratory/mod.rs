//! What measures the program rather than a mooring: random systems, error bars and accuracies held against the truth.

pub mod accuracy;
pub mod bars;
pub mod invariants;
pub mod random_motion;
pub mod random_systems;
pub mod varied;
