//! Formats of lengths and angles in messages about a section.

use crate::number::digits;

/// A length in millimetres: `23.12 mm`.
pub(super) fn mm(metres: f64) -> String {
    format!("{} mm", digits(metres * 1e3, 4))
}

/// An angle in degrees: `10 deg`.
pub(super) fn degrees(radians: f64) -> String {
    format!("{} deg", digits(radians.to_degrees(), 4))
}

/// A length in metres rounded up for the file: `0.02312`.
pub(super) fn at_least(metres: f64) -> String {
    let step = 1e-5_f64;
    digits((metres / step - 1e-6).ceil() * step, 9)
}

/// A length in metres rounded down for the file.
pub(super) fn at_most(metres: f64) -> String {
    let step = 1e-5_f64;
    digits((metres / step + 1e-6).floor() * step, 9)
}
