//! Files of other programs: read, written, audited.

pub mod audit;
pub mod export;
pub mod import;
pub mod open;
