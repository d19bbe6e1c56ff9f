//! Lines in motion: time integration, convergence, natural modes.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../common/drawn_lines.rs"]
mod drawn_lines;
#[path = "../common/elastic_catenary.rs"]
mod elastic_catenary;
#[path = "../common/lines.rs"]
mod lines;
#[path = "../common/march.rs"]
mod march;
#[path = "../common/period.rs"]
mod period;
#[path = "../common/reseal.rs"]
mod reseal;
#[path = "../common/rest.rs"]
mod rest;

mod accuracy;
mod agreement;
mod bead_on_string;
mod closed_forms;
mod convergence_orders;
mod energy_balance;
mod envelopes;
mod examples;
mod independent_program;
mod invariance;
mod modes;
mod modes_continuous;
mod motion_tables;
mod random_lines;
mod resume;
mod step_limits;
mod swinging_tension;
mod waves;
