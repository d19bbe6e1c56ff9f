//! Computation of a case: results, work and cost, estimated errors.
//!
//! [`model`] holds a [`Run`] as plain data; [`store`] keeps it on disk.

mod accuracy;
mod channel_reading;
mod channel_statistics;
mod checkpoint;
mod coarse;
mod companions;
mod compute;
mod cycles;
mod decimation;
mod edited_inputs;
mod energy_balance;
mod error_estimate;
pub mod event;
pub mod index;
mod initial_equilibrium;
pub mod job;
pub mod limits;
mod line_statistics;
pub mod model;
mod natural_modes;
mod observer;
mod observers;
pub mod published_curve;
mod recorder;
mod replay;
pub mod requested_statistics;
pub mod response;
mod result_scale;
mod resume;
mod search_progress;
pub mod settings;
mod simulation;
mod spill_buffer;
mod steady_state;
mod step_envelope;
mod step_interval;
pub mod store;
mod time_march;
mod touchdown_speed;
mod warm_start;
mod wave_decomposition;

pub use crate::case::{ModePlane, QuantityId, Subject};
pub use checkpoint::{Checkpoint, ResumedRun};
pub use coarse::coarse;
pub use decimation::DecimatedRecord;
pub(crate) use edited_inputs::edited_inputs;
pub use line_statistics::evaluate as along_line;
pub use model::*;
pub(crate) use replay::replay_rows;
pub use result_scale::result_scales;
pub(crate) use resume::info_of_ended;
pub use resume::resume_request;
pub use search_progress::SearchProgress;
