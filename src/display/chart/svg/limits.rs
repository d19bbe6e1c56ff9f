//! Reference lines and areas with their names, which lie where they cover neither each other nor, if possible, a curve.

use super::curves::{PicturePoint, Polyline};
use super::ink::{AREA, LIMIT};
use super::page::{Anchor, SvgPage, shortened, width};
use super::plan::{SvgPlan, share};
use crate::chart::clip::clip;
use crate::chart::{Chart, LimitLine, ReferenceLine};

/// Size of the names.
const SIZE: f64 = 11.0;
/// Height of a name, and its distance from its line.
const TALL: f64 = 14.0;
const OFF: f64 = 4.0;

/// Rows above and below an area in which its name may lie.
const ROWS: u8 = 5;

/// An area counts as so many pieces of curves where a name lies over it.
const SOLID: usize = 12;

/// Dash of a reference line.
const DASH: &str = "6 4";

/// A rectangle: left and upper edge, width, height.
type Area = (f64, f64, f64, f64);

/// Reference lines and areas, to be drawn before the curves.
pub(super) fn areas(chart: &Chart, plan: &SvgPlan, page: &mut SvgPage) {
    for limit in &chart.limits {
        match limit.line {
            LimitLine::Horizontal(y) | LimitLine::Bound(y) => {
                if let Some(y) = row(plan, y) {
                    page.line((plan.left, y), (plan.right(), y), LIMIT, DASH);
                }
            }
            LimitLine::Vertical(x) => {
                if let Some(x) = column(plan, x) {
                    page.line((x, plan.top), (x, plan.bottom()), LIMIT, DASH);
                }
            }
            LimitLine::Band { x, y } => {
                if let Some((left, top, wide, tall)) = band(plan, x, y) {
                    page.element(
                        "rect",
                        &[
                            ("x", super::page::px(left)),
                            ("y", super::page::px(top)),
                            ("width", super::page::px(wide)),
                            ("height", super::page::px(tall)),
                            ("fill", AREA.to_owned()),
                            ("stroke", LIMIT.to_owned()),
                            ("stroke-width", "0.8".to_owned()),
                        ],
                    );
                }
            }
        }
    }
}

/// Where a y lies, if it is inside the plot.
fn row(plan: &SvgPlan, y: f64) -> Option<f64> {
    let inside = (0.0..=1.0).contains(&share(plan.y, y));
    inside.then(|| plan.y_of(y))
}

/// Where an x lies, if it is inside the plot.
fn column(plan: &SvgPlan, x: f64) -> Option<f64> {
    let inside = (0.0..=1.0).contains(&share(plan.x, x));
    inside.then(|| plan.x_of(x))
}

/// An area as far as it is inside the plot, at least a unit wide and high.
fn band(plan: &SvgPlan, x: (f64, f64), y: (f64, f64)) -> Option<Area> {
    let inside = |(low, high): (f64, f64), (from, to): (f64, f64)| {
        let seen = (low.max(from), high.min(to));
        (seen.0 <= seen.1).then_some(seen)
    };
    let (left, right) = inside(x, plan.x.0)?;
    let (low, high) = inside(y, plan.y.0)?;
    let (left, right) = (plan.x_of(left), plan.x_of(right));
    let (top, bottom) = (plan.y_of(high), plan.y_of(low));
    let finite = [left, right, top, bottom].iter().all(|v| v.is_finite());
    let wide = (right - left).max(1.0);
    finite.then(|| {
        (
            left.min(plan.right() - wide),
            top,
            wide,
            (bottom - top).max(1.0),
        )
    })
}

/// The names of reference lines and areas.
pub(super) fn names(chart: &Chart, plan: &SvgPlan, curves: &[Polyline], page: &mut SvgPage) {
    let bands = chart.limits.iter().filter_map(|limit| match limit.line {
        LimitLine::Band { x, y } => band(plan, x, y),
        _ => None,
    });
    let bands: Vec<Area> = bands.collect();
    let mut taken: Vec<Area> = Vec::new();
    for limit in &chart.limits {
        let label = label(limit, plan);
        if label.is_empty() {
            continue;
        }
        let name = shortened(&label, plan.across - 2.0 * OFF, SIZE);
        let wide = width(&name, SIZE);
        let places = places(limit, plan, wide);
        let free = |area: &&Area| taken.iter().all(|other| !overlap(**area, *other));
        let covered = |area: &&Area| {
            crossings(**area, curves)
                + SOLID * bands.iter().filter(|band| overlap(**area, **band)).count()
        };
        let chosen = places.iter().filter(free).min_by_key(covered);
        if let Some(area) = chosen.copied() {
            taken.push(area);
            lead(limit, plan, area, page);
            let style = format!(" font-size=\"{SIZE}\" fill=\"{LIMIT}\"");
            let at = (area.0, area.1 + 0.8 * TALL);
            page.styled_words(at, Anchor::Start, &name, &style);
        }
    }
}

/// A thin line from a name to its area, where it is not beside it.
fn lead(limit: &ReferenceLine, plan: &SvgPlan, (left, top, wide, _): Area, page: &mut SvgPage) {
    let LimitLine::Band { x, y } = limit.line else {
        return;
    };
    let Some(area) = band(plan, x, y) else {
        return;
    };
    let middle = (area.0 + 0.5 * area.2).clamp(left, left + wide);
    let at = middle.clamp(area.0, area.0 + area.2);
    let (from, to) = match top > area.1 {
        true => (top + 2.0, area.1 + area.3),
        false => (top + TALL, area.1),
    };
    if (from - to).abs() > 0.5 * TALL {
        page.line((middle, from), (at, to), LIMIT, "1 2");
    }
}

/// What is written; of a bound beyond the plot with the way to it.
fn label(limit: &ReferenceLine, plan: &SvgPlan) -> String {
    match limit.line {
        LimitLine::Bound(y) if row(plan, y).is_none() && !limit.label.is_empty() => {
            let way = if share(plan.y, y) > 1.0 { '↑' } else { '↓' };
            format!("{way} {}", limit.label)
        }
        _ => limit.label.clone(),
    }
}

/// Where the name of a limit may lie, the best place first.
fn places(limit: &ReferenceLine, plan: &SvgPlan, wide: f64) -> Vec<Area> {
    let tops: Vec<f64> = match limit.line {
        LimitLine::Horizontal(y) => row(plan, y).map_or_else(Vec::new, beside),
        LimitLine::Bound(y) => row(plan, y).map_or_else(|| at_edge(plan, y), beside),
        LimitLine::Band { x, y } => band(plan, x, y).map_or_else(Vec::new, |(_, top, _, tall)| {
            let away = (0..ROWS).map(|row| TALL * f64::from(row) + 1.0);
            away.flat_map(|away| [top - TALL - away, top + tall + away])
                .collect()
        }),
        LimitLine::Vertical(_) => (0..)
            .map(|i| plan.top + 2.0 + TALL * f64::from(i))
            .take_while(|top| top + TALL <= plan.bottom())
            .collect(),
    };
    let last = plan.right() - wide - OFF;
    let lefts: Vec<f64> = match limit.line {
        LimitLine::Vertical(x) => {
            column(plan, x).map_or_else(Vec::new, |x| vec![x + OFF, x - wide - OFF])
        }
        LimitLine::Band { x, y } => {
            let area = band(plan, x, y);
            area.map_or_else(Vec::new, |(left, _, across, _)| {
                vec![left + across - wide, left, left + 0.5 * (across - wide)]
            })
        }
        _ => (0..6)
            .map(|i| last - 0.2 * f64::from(i) * (last - plan.left - OFF))
            .collect(),
    };
    let all = tops.iter().flat_map(|top| {
        lefts.iter().map(|left| {
            let left = left.clamp(plan.left + OFF, last.max(plan.left + OFF));
            (left, *top, wide, TALL)
        })
    });
    all.filter(|area| area.1 >= plan.top - 1.0 && area.1 + TALL <= plan.bottom() + 1.0)
        .collect()
}

/// Above a line, and below it; further rows where several lines are close together.
fn beside(y: f64) -> Vec<f64> {
    vec![y - TALL - 1.0, y + 2.0, y - 2.0 * TALL, y + TALL + 2.0]
}

/// Rows at the edge beyond which a bound lies.
fn at_edge(plan: &SvgPlan, y: f64) -> Vec<f64> {
    let above = share(plan.y, y) > 1.0;
    let rows = (0..4).map(|i| TALL * f64::from(i));
    rows.map(|down| match above {
        true => plan.top + 2.0 + down,
        false => plan.bottom() - TALL - 2.0 - down,
    })
    .collect()
}

fn overlap(a: Area, b: Area) -> bool {
    a.0 < b.0 + b.2 && b.0 < a.0 + a.2 && a.1 < b.1 + b.3 && b.1 < a.1 + a.3
}

/// How many pieces of curves cross an area.
fn crossings((left, top, wide, tall): Area, curves: &[Polyline]) -> usize {
    let within = |(x, y): PicturePoint| (x - left, y - top);
    let pieces = curves.iter().flat_map(|line| line.windows(2));
    pieces
        .filter(|pair| clip(within(pair[0]), within(pair[1]), 0.0, (wide, tall)).is_some())
        .count()
}
