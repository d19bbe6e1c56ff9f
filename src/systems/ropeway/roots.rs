//! Roots and minima of one unknown inside a bracket.

use super::RopewayError;
use crate::numerics::golden_section::golden_section;
use crate::numerics::roots::false_position;

/// The root between two bounds at which the function differs in sign.
///
/// # Errors
/// Those of the function, [`RopewayError::NotFound`] where the signs do not differ.
pub(super) fn root(
    bounds: (f64, f64),
    what: &'static str,
    f: impl FnMut(f64) -> Result<f64, RopewayError>,
) -> Result<f64, RopewayError> {
    false_position(bounds, f)?.ok_or(RopewayError::NotFound(what))
}

/// The minimum between two bounds of a function that falls and then rises.
///
/// # Errors
/// Those of the function.
pub(super) fn minimum(
    bounds: (f64, f64),
    f: impl FnMut(f64) -> Result<f64, RopewayError>,
) -> Result<f64, RopewayError> {
    golden_section(bounds, 1e-10, 300, f)
}
