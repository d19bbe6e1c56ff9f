//! What every floor stands on: files, numbers as text, the way out for text, limits.

pub mod background;
pub mod clock;
pub mod crash_log;
pub mod files;
pub mod grace;
pub mod limits;
pub mod number;
pub mod padding;
pub mod places;
pub mod seal;
pub mod visible;
pub mod work_log;

pub use files::strays;

/// The version of the program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
