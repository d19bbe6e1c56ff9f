//! What every floor stands on: files, numbers as text, the way out for text, limits.

pub mod background;
pub mod clock;
pub mod crash_log;
pub mod files;
pub(crate) mod grace;
pub mod limits;
pub mod number;
pub(crate) mod padding;
pub mod places;
pub(crate) mod seal;
pub(crate) mod strays;
pub mod visible;

/// The version of the program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
