//! The workbench on the terminal.
//!
//! ```text
//! keys, signals, jobs ──▶ Msg ──▶ update(State) ──▶ Effect ──▶ files, threads ──▶ Msg …
//!                                    │
//!                                 draw(&State) ──▶ terminal
//! ```
//!
//! [`update()`] is pure and [`draw`] changes nothing; [`app`] does what the effects ask for, and
//! [`terminal`] is the only place that touches the terminal's modes. All keys stand in one table,
//! [`command::COMMANDS`].

pub mod app;
pub mod backend;
pub mod command;
pub mod drafts;
mod editor;
mod files;
pub mod inks;
pub mod key;
pub mod line_tables;
pub mod msg;
pub mod place;
pub mod plot_pane;
pub mod plots;
pub mod shelf;
pub mod state;
pub mod table_pane;
pub mod terminal;
pub mod update;
pub mod view;
pub mod world;

pub use app::{OpenError, Options, open};
pub use msg::{Effect, Msg};
pub use state::State;
pub use update::update;
pub use view::draw;
