//! Lines at rest: the closed-form catenary and the discretised equilibrium.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/elastic_catenary.rs"]
mod elastic_catenary;
#[path = "../common/lines.rs"]
mod lines;
#[path = "../common/rest.rs"]
mod rest;

mod aligned_clumps;
mod cantilever;
mod catenary;
mod closed_forms;
mod composite;
mod end_stiffness;
mod equilibrium;
mod grounded_lines;
mod line_between_ends;
mod random_lines;
mod reconfiguration;
mod sections;
mod slender_rod;
mod speed_at_rest;
mod turning_clamps;
mod umbilical;
mod warnings;
