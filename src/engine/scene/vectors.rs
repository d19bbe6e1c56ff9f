//! Vectors of a case: by angles, or one number for all axes.

use crate::case::OneOrMany;
use crate::numerics::V3;

/// Unit vector of an azimuth from +x towards +y and an elevation \[rad\].
#[must_use]
pub fn direction(azimuth: f64, elevation: f64) -> V3 {
    V3::new(
        azimuth.cos() * elevation.cos(),
        azimuth.sin() * elevation.cos(),
        elevation.sin(),
    )
}

/// One number for all axes, or one an axis; a list of another length counts by its first numbers.
#[must_use]
pub fn per_axis(value: &OneOrMany) -> V3 {
    match value {
        OneOrMany::One(all) => V3::repeat(*all),
        OneOrMany::Many(list) => V3::from_fn(|i, _| list.get(i).copied().unwrap_or(0.0)),
    }
}
