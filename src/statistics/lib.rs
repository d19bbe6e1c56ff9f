//! Extremes and fatigue of records and spectra; no cable.

pub mod extremes;
pub mod fatigue;
