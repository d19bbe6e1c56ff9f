//! The workbench on the terminal.
//!
//! ```text
//! keys, signals, jobs ──▶ Msg ──▶ update(AppState) ──▶ Effect ──▶ files, threads ──▶ Msg …
//!                                    │
//!                                 draw(&AppState) ──▶ terminal
//! ```
//!
//! [`update()`] is pure and [`draw`] changes nothing; [`app`] does what the effects ask for, and
//! [`terminal`] is the only place that touches the terminal's modes. Each
//! pane lists its commands with their keys in [`panes`].

use seacable_base::{background, crash_log, number, padding, places, strays, visible};
use seacable_display::{chart, plain, table, wrap};
use seacable_engine::modes;
use seacable_foreign::{import, open};
use seacable_jobs as jobs;
use seacable_model::{case, kinds, line_types, section, templates};
use seacable_numerics as numerics;
use seacable_physics as physics;
use seacable_report as report;
use seacable_runs::{reference, run};
use seacable_studies::{comparison, study};
use seacable_systems::{ropeway, ship, system};

pub mod app;
pub mod bindings;
pub mod case_library;
pub mod column_plot;
pub mod command;
pub mod command_line;
pub mod effects;
mod external_editor;
pub mod facade;
mod files;
pub mod fuzzy;
pub mod key;
pub mod line_tables;
mod memory_keeper;
pub mod msg;
pub mod pane;
pub mod panes;
pub mod part_views;
pub mod plot_pane;
pub mod plots;
pub mod recovery;
pub mod result_lines;
pub mod run_cells;
pub mod run_columns;
pub mod run_filter;
pub mod screen_memory;
pub mod settings;
pub mod state;
pub mod table_pane;
pub mod terminal;
pub mod theme;
pub mod tutorial;
pub mod update;
pub mod view;

pub use app::{OpenError, WorkbenchOptions, open};
pub use msg::{Effect, Msg};
pub use state::AppState;
pub use update::update;
pub use view::draw;
