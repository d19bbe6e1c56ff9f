//! What a place is of.

/// The line, point or body of a place: `mooring@120` of `mooring@120|b`.
pub(super) fn subject(place: &str) -> &str {
    place.split('|').next().unwrap_or(place)
}
