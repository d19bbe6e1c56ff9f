//! Whether the area that bears on the bed follows from what a body displaces.

use super::source::LineSource;
use crate::case::{Clump, Payload};

/// Whether the area on the bed of a payload follows from its volume.
pub(super) fn bears_by_volume(source: &LineSource<'_>, payload: &Payload) -> bool {
    let given = payload.bed_area_m2.is_some() || payload.shape.is_some();
    source.case.seabed.is_some() && !given
}

/// Whether it follows from its shape.
pub(super) fn bears_by_shape(source: &LineSource<'_>, payload: &Payload) -> bool {
    source.case.seabed.is_some() && payload.bed_area_m2.is_none() && payload.shape.is_some()
}

/// Whether the area of a clump on the bed follows from what it displaces.
pub(super) fn bears_by_mass(source: &LineSource<'_>, clump: &Clump) -> bool {
    source.case.seabed.is_some() && clump.bed_area_m2.is_none()
}
