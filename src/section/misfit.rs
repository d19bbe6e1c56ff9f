//! How what does not fit in a section is worded.

use crate::report::number::digits;

pub use crate::case::Misfit;

/// A length in millimetres, for people: `23.12 mm`.
pub(super) fn mm(metres: f64) -> String {
    format!("{} mm", digits(metres * 1e3, 4))
}

/// An angle in degrees, for people: `10 deg`.
pub(super) fn degrees(radians: f64) -> String {
    format!("{} deg", digits(radians.to_degrees(), 4))
}

/// A length as a number for the file that is not smaller than it: `0.02312`.
pub(super) fn at_least(metres: f64) -> String {
    let step = 1e-5_f64;
    digits((metres / step - 1e-6).ceil() * step, 9)
}

/// A length as a number for the file that is not greater than it.
pub(super) fn at_most(metres: f64) -> String {
    let step = 1e-5_f64;
    digits((metres / step + 1e-6).floor() * step, 9)
}
