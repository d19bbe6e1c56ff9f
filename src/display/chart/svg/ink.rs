//! Colours, dashes and markers; no meaning is in a colour alone.

use crate::chart::Series;

/// Sizes of words: those of a plot, and its title.
pub(super) const TEXT: f64 = 12.0;
pub(super) const TITLE: f64 = 14.0;

/// Words and axes.
pub(super) const BLACK: &str = "#1a1a1a";
/// Reference lines and their names.
pub(super) const LIMIT: &str = "#555555";
/// An older result.
pub(super) const DIMMED: &str = "#6e6e6e";
/// Lines of the grid, areas of published values: no meaning is read from them alone.
pub(super) const GRID: &str = "#e3e3e3";
pub(super) const AREA: &str = "#dcdcdc";

/// Colours of curves in the order of their slots, each as dark as words have to be on white.
pub(super) const COLOURS: [&str; 6] = [
    "#174a8c", "#a33c00", "#1c6640", "#6a2c91", "#6b5200", "#9c1347",
];

/// Dashes in the order of slots: empty for a line without gaps.
pub(super) const DASHES: [&str; 8] = [
    "",
    "9 4",
    "2 3",
    "9 3 2 3",
    "16 4",
    "5 2 2 2 2 2",
    "5 5",
    "16 3 2 3 2 3",
];

/// The dash of an older result.
pub(super) const DIMMED_DASH: &str = "3 3";

/// Shapes of markers, hollow in the first round of slots and filled in the second.
pub(super) const SHAPES: usize = 8;

/// Half the size of a marker.
const HALF: f64 = 4.0;

/// The colour of a curve.
pub(super) fn colour(series: &Series) -> &'static str {
    match series.dimmed {
        true => DIMMED,
        false => COLOURS[series.slot % COLOURS.len()],
    }
}

/// The dash of a curve.
pub(super) fn dash(series: &Series) -> &'static str {
    match series.dimmed {
        true => DIMMED_DASH,
        false => DASHES[series.slot % DASHES.len()],
    }
}

/// The outline of the marker of a slot about the origin, as commands of a path.
pub(super) fn marker(slot: usize) -> String {
    let h = HALF;
    match slot % SHAPES {
        0 => format!(
            "m-{h} 0a{h} {h} 0 1 0 {d} 0a{h} {h} 0 1 0 -{d} 0z",
            d = 2.0 * h
        ),
        1 => format!("m-{h} -{h}l{d} {d}m0 -{d}l-{d} {d}", d = 2.0 * h),
        2 => format!("m-{h} -{h}h{d}v{d}h-{d}z", d = 2.0 * h),
        3 => format!("m0 -{h}l{h} {d}h-{d}z", d = 2.0 * h),
        4 => format!("m0 -{h}v{d}m-{h} -{h}h{d}", d = 2.0 * h),
        5 => format!("m0 -{h}l{h} {h}l-{h} {h}l-{h} -{h}z"),
        6 => format!("m0 {h}l{h} -{d}h-{d}z", d = 2.0 * h),
        _ => format!(
            "m0 -{h}v{d}m-{h} -{h}h{d}m-{e} -{e}l-{c} {c}m0 -{c}l{c} {c}",
            d = 2.0 * h,
            e = 0.3 * h,
            c = 1.4 * h
        ),
    }
}

/// Whether the marker of a slot is filled.
pub(super) const fn is_filled(slot: usize) -> bool {
    (slot / SHAPES) % 2 == 1
}
