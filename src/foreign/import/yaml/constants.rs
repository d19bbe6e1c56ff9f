//! Gravity and density where a design states none.

/// Gravity \[m/s²\] that MoorPy takes where none is given, also for RAFT and WISDEM.
pub const GRAVITY: f64 = 9.81;

/// Density \[kg/m³\] that MoorPy takes where none is given, also for RAFT and WISDEM.
pub const DENSITY: f64 = 1025.0;
