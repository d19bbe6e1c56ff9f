//! Roots and minima of one unknown, between bounds that hold them.

use super::Trouble;
use crate::numerics::golden_section::golden_section;
use crate::numerics::roots::false_position;

/// Where a function crosses zero between two places at which its signs differ.
///
/// # Errors
/// Those of the function, [`Trouble::NotFound`] where the signs do not differ.
pub(super) fn root(
    bounds: (f64, f64),
    what: &'static str,
    f: impl FnMut(f64) -> Result<f64, Trouble>,
) -> Result<f64, Trouble> {
    false_position(bounds, f)?.ok_or(Trouble::NotFound(what))
}

/// The place of the least value between two bounds, of a function that falls and then rises.
///
/// # Errors
/// Those of the function.
pub(super) fn least(
    bounds: (f64, f64),
    f: impl FnMut(f64) -> Result<f64, Trouble>,
) -> Result<f64, Trouble> {
    golden_section(bounds, 1e-10, 300, f)
}
