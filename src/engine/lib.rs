//! Lines in SI: forces as elements, statics, dynamics, modes.

pub mod dynamics;
pub mod line_between_ends;
pub mod modes;
pub mod scene;
pub mod solve;
pub mod statics;
