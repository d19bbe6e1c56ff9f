//! What a job computes.

mod request;
mod sweep;

pub use request::JobRequest;
pub(crate) use sweep::on_all_cores_but_one;
pub use sweep::{EndedSweep, SweepEvent, SweepRequest, compute_sweep};
