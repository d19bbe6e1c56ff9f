//! Forces and bodies: tangents, energy, closed forms and balances of one element at a time.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/lines.rs"]
mod lines;
#[path = "../common/march.rs"]
mod march;
#[path = "../common/period.rs"]
mod period;
#[path = "../common/rest.rs"]
mod rest;

mod body_on_bed;
mod convergence_norm;
mod drag_length;
mod energy;
mod mass_damping;
mod rigid_body;
mod rods;
mod rope;
mod sea;
mod seabed;
mod seabed_grid;
mod tangents;
mod traveller;
mod wall_tension;
