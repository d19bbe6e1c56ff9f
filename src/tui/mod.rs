//! tui

pub mod inks;
pub mod plot_pane;
