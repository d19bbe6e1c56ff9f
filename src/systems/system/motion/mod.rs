//! Systems of lines in motion: all lines, points and bodies in one Newton iteration.
//!
//! The unknowns are the inner nodes of the lines, the free points, and of every free body its origin and a rotation vector from where it
//! was at the last accepted step, in its own axes ([`SystemState`]). All are vectors of three numbers, so that generalized-alpha
//! treats them alike ([`Integrated`](crate::solve::Integrated)); the order is kept since the velocity that belongs to the rotation vector is the angular
//! velocity along the body's axes to second order (Brüls and Cardona 2010, doi 10.1115/1.4001370).
//!
//! The tangent is an arrowhead: the band of each line, bordered by the joints at its ends. Each line is condensed onto its end
//! nodes ([`Condensation`](crate::numerics::Condensation)), the joints are solved for together ([`border`]), and the lines follow. A line
//! between prescribed ends has no border and costs what it costs alone.

pub mod along;
mod bed_reach;
mod body_damping;
pub mod body_equation;
pub mod body_flow;
pub mod border;

pub mod breaks;
pub mod broken_names;
mod channel_result;
mod channel_values;
pub mod channels;
pub(in crate::system) mod check;
pub(in crate::system) mod check_payout;
pub mod checkpoint;
mod chosen_method;
pub mod driving_period;
pub mod energy;
mod explicit_clamps;
mod explicit_decay;
mod flow_load;
pub mod foot;
pub mod frequency;
pub mod inputs;
mod integrated_system;
pub mod job;
pub mod job_request;
mod joint_place;
pub mod joints;
mod kinks;
mod landing;
mod let_go;
mod line_ends;
mod line_start;
mod mesh_of_ends;
pub mod modes;
pub mod motion_plan;
pub mod moving_system;
mod new_node;
mod paid_line;
pub mod payout;
mod payout_border;
pub mod payout_inputs;
pub mod pins;
mod point_loads;
pub mod pose_motion;
mod recorded_system;
mod refinable_system;
pub mod release;
pub mod responses;
mod rest_state;
pub mod run;
mod searchable_system;
pub mod start;
pub mod surplus;
mod surplus_of_lines;
mod system_bounds;
pub mod system_in_time;
pub mod system_state;
mod system_under_way;
pub mod velocity_history;
mod wave_stations;

pub use moving_system::MovingSystem;
pub use pose_motion::{BodyMotion, PoseMotion};
pub use system_state::SystemState;
