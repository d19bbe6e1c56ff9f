//! A ship at a single-point mooring.
//!
//! [`model`] declares the keys of a ship file with type, unit, range, default and help.
//!
//! [`StaticAnalysis`]: [`loads`] of wind, current and mean wave drift, with coefficients that are [`periodic_curve`]s of the
//! angle of attack; [`yaw_equilibria`], isolated by [`root_isolation`](crate::numerics::root_isolation); [`mooring`], the catenary at the pull of each; [`stability`] of
//! surge, sway and yaw about each: divergence and fishtailing.
//!
//! [`DynamicAnalysis`], which takes seconds: [`MotionAnalysis`], the six [`motion`]s from published statistics or from
//! response amplitude operators; [`coupled`], ship and anchor line in the time domain with a free-decay check; [`rope`], the
//! rope to a platform that follows the hang-off point.

mod check;
pub mod coupled;
mod dynamic_analysis;
mod file;
pub mod hull;
pub mod loads;
pub mod model;
pub mod mooring;
pub mod motion;
mod motion_analysis;
pub mod periodic_curve;
pub mod quantities;
pub mod rope;
pub mod stability;
mod static_analysis;
pub mod validation;
pub mod yaw_equilibria;

pub use dynamic_analysis::DynamicAnalysis;
pub use file::SHIP;
pub use model::Ship;
pub use motion_analysis::{MotionAnalysis, MotionError, WaveRealisation};
pub use static_analysis::{MooredEquilibrium, StaticAnalysis};
