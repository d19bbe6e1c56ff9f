//! The terminal: entered and left in one place, read byte by byte, watched for hang-ups and signals.

pub mod capabilities;
pub mod decode;
pub mod screen;
pub mod signals;
mod synchronized;
pub mod wait;
