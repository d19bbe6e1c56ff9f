//! What is asked of a system at rest beside its forces: offsets and watch circles of a body, natural periods, clearances, the
//! input that gives a wanted result.

pub mod analyses;
pub mod bed_clearance;
pub mod box_tree;
pub mod boxed_curve;
pub mod clearance;
pub mod equilibria;
pub mod masses;
pub mod offset;
pub mod periods;
pub mod seek;
pub mod watch_circle;
