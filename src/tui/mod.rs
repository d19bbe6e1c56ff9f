//! tui

pub mod inks;
pub mod plot_pane;
pub mod table_pane;
