//! Systems of lines, at rest and in [`motion`](mod@motion): points, bodies and the lines between them.
//!
//! A [`SystemFile`] says in the user's words what a [`Network`](network::Network) holds in SI. Lines are the closed forms of
//! [`catenary`](crate::statics::catenary), so that only free points and bodies are unknown ([`freedoms`]); in a current, or with
//! bending stiffness, they are [`discretised`]. Forces and exact
//! stiffness are assembled in [`balance`](mod@balance); [`equilibrium`] finds where they balance, from a cold start.
//! Lines gain marine growth and lose steel with years, by [`ageing`](mod@ageing).

pub mod ageing;
pub mod along_bed;
pub mod analysis;
pub mod asked_modes;
pub mod at_rest;
pub mod balance;
pub mod bed;
mod body_in_flow;
pub mod body_loads;
pub mod bounds;
pub mod build;
mod check;
mod check_bed;
mod check_lines;
mod check_matrix;
mod check_start;
pub mod clamps;
pub mod connected;
mod damage;
pub mod discretised;
mod displaced_twice;
pub mod equilibrium;
pub mod errors_at_rest;
mod file;
pub mod freedoms;
mod heading_loads;
pub mod immersion;
pub mod initial;
mod laid;
pub mod line_at_rest;
pub mod line_physics;
pub mod line_solver;
mod load_sum;
pub mod loads;
pub mod loads_without_effect;
mod members;
pub mod model;
pub mod motion;
mod moving_pose;
pub mod network;
pub mod off_nodes;
pub mod parts;
mod point_drag;
mod point_force;
pub mod point_on_bed;
pub mod pose;
pub mod potential_flow;
pub mod quantities;
pub mod rest;
pub mod results_in_time;
pub mod rods;
pub mod section_materials;
pub mod solved;
pub mod stability;
pub mod start;
pub mod stiffness;
mod straight_ends;
pub mod uniform_parts;
mod unstable;
pub mod validated;
pub mod validation;
pub mod warnings;
mod waterplane;

pub use file::SYSTEM;
pub use model::SystemFile;
pub use solved::SolvedSystem;
