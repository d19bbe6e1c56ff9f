//! A case computed, and compared with what is published.

pub mod reference;
pub mod run;
