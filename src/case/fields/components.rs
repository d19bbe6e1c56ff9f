//! Coordinates that key paths may name one by one, so that a study or `--set` can move an end along one axis.

use super::Absent::Required;
use super::{Field, Kind, Range};

/// One number of a field that takes three.
const fn coordinate(path: &'static str, label: &'static str) -> Field {
    Field {
        path,
        label,
        kind: Kind::Number,
        unit: "m",
        range: Range::of(-1e6, 1e6),
        absent: Required,
        help: "Coordinate of the position.",
        only_if: None,
    }
}

/// The coordinates of the ends.
pub(super) static COMPONENTS: &[Field] = &[
    coordinate("ends.*.position_m.x", "position x"),
    coordinate("ends.*.position_m.y", "position y"),
    coordinate("ends.*.position_m.z", "position z"),
];
