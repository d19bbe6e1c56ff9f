//! A field over both axes: the darker a place, the greater the value there, so that it reads the same without colour.

use super::ink::{BLACK, TEXT};
use super::page::{Anchor, SvgPage, px, width};
use super::plan::SvgPlan;
use crate::chart::{AxisRange, AxisScale, Chart, GridMap, extent};
use crate::number;

/// Places across and up at which the field is read.
const ACROSS: usize = 160;
const UP: usize = 80;

/// Shades from the least value to the greatest, each darker than the one before.
pub(super) const SHADES: [&str; 9] = [
    "#fcfdff", "#e6eef7", "#cddcec", "#aec6df", "#86a9cd", "#5f89b6", "#3d6899", "#254a78",
    "#0f2c52",
];

/// Width of the scale beside the plot, and the room around it.
const SCALE: f64 = 14.0;
const GAP: f64 = 12.0;

/// Room for the scale to the right of the plot; none without a map.
pub(super) fn right(chart: &Chart) -> f64 {
    let Some(map) = &chart.map else { return 0.0 };
    let widths = ends(map).map(|words| width(&words, TEXT));
    SCALE + 2.5 * GAP + widths.into_iter().fold(0.0, f64::max)
}

/// What the darkest, the middle and the lightest shade mean.
fn ends(map: &GridMap) -> [String; 3] {
    let (low, high) = span(map);
    [high, 0.5 * (low + high), low].map(|value| number::si(value, &map.of.unit))
}

/// The values of the lightest and the darkest shade: of one size where there are both signs, else from the least value to the greatest.
fn span(map: &GridMap) -> AxisRange {
    let (low, high) = extent(map.values.iter().copied()).unwrap_or_default();
    let whole = map.greatest();
    match map.of.range.is_some() || (low < 0.0 && high > 0.0) {
        true => (-whole, whole),
        false => (low, high),
    }
}

/// Shades the plot, and draws the scale beside it.
pub(super) fn draw(map: &GridMap, plan: &SvgPlan, page: &mut SvgPage) {
    let levels = levels(map, plan);
    for (shade, colour) in SHADES.iter().enumerate() {
        let d = rectangles(&levels, shade, plan);
        fill(page, d, colour);
    }
    scale(map, plan, page);
}

/// The shade at every place that is read, row by row from below; none where the field has no value.
fn levels(map: &GridMap, plan: &SvgPlan) -> Vec<Option<usize>> {
    let along = spread(plan.x, ACROSS);
    let up = spread(plan.y, UP);
    let (low, high) = span(map);
    let at = |x: f64, y: f64| {
        let value = map.at((x, plan.x.1), (y, plan.y.1))?;
        let level = match high > low {
            true => ((value - low) / (high - low)).clamp(0.0, 1.0),
            false => 0.5,
        };
        Some(((level * SHADES.len() as f64) as usize).min(SHADES.len() - 1))
    };
    let rows = up.iter().flat_map(|y| along.iter().map(|x| at(*x, *y)));
    rows.collect()
}

/// Values in the middles of so many equal parts of an axis.
fn spread((range, scale): (AxisRange, AxisScale), parts: usize) -> Vec<f64> {
    let (from, to) = scale.places(range);
    let middle = |part: usize| from + (to - from) * (part as f64 + 0.5) / parts as f64;
    (0..parts).map(|part| scale.value(middle(part))).collect()
}

/// All places of a shade as rectangles, neighbours in a row as one.
fn rectangles(levels: &[Option<usize>], shade: usize, plan: &SvgPlan) -> String {
    let (wide, tall) = (plan.across / ACROSS as f64, plan.down / UP as f64);
    let mut d = String::new();
    for (row, levels) in levels.chunks(ACROSS).enumerate() {
        let top = plan.bottom() - tall * (row + 1) as f64;
        let mut column = 0;
        for run in levels.chunk_by(|a, b| a == b) {
            if run[0] == Some(shade) {
                let (left, wide) = (plan.left + wide * column as f64, wide * run.len() as f64);
                d.push_str(&format!(
                    "M{} {}h{}v{}h-{}z",
                    px(left),
                    px(top),
                    px(wide),
                    px(tall),
                    px(wide)
                ));
            }
            column += run.len();
        }
    }
    d
}

/// The scale: a box for each shade, the darkest at the top, with what the ends and the middle mean.
fn scale(map: &GridMap, plan: &SvgPlan, page: &mut SvgPage) {
    let left = plan.right() + GAP;
    let tall = plan.down / SHADES.len() as f64;
    for (shade, colour) in SHADES.iter().enumerate() {
        let top = plan.bottom() - tall * (shade + 1) as f64;
        let d = format!("M{} {}h{SCALE}v{}h-{SCALE}z", px(left), px(top), px(tall));
        fill(page, d, colour);
    }
    let outline = format!(
        "M{} {}h{SCALE}v{}h-{SCALE}z",
        px(left),
        px(plan.top),
        px(plan.down)
    );
    page.path(&outline, BLACK, 1.0, "");
    for (place, words) in [0.0, 0.5, 1.0].iter().zip(ends(map)) {
        let y = plan.top + plan.down * place + 0.35 * TEXT;
        page.words((left + SCALE + 5.0, y), Anchor::Start, &words);
    }
    page.words((plan.right(), plan.top - 8.0), Anchor::End, &map.of.label);
}

/// An area without an edge; neighbours meet without a seam.
fn fill(page: &mut SvgPage, d: String, colour: &str) {
    if !d.is_empty() {
        page.element(
            "path",
            &[
                ("d", d),
                ("fill", colour.to_owned()),
                ("shape-rendering", "crispEdges".to_owned()),
            ],
        );
    }
}
