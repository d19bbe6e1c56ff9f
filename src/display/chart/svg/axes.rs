//! Axes with their ticks, numbers and names, and the grid.

use super::ink::{BLACK, GRID, TEXT};
use super::page::{Anchor, SvgPage, shortened, width};
use super::plan::{ROW, SvgPlan};
use crate::chart::draw::axis_name;
use crate::chart::{Chart, ticks};

/// Length of a tick.
const TICK: f64 = 5.0;

/// Thin lines at the ticks, below everything else.
pub(super) fn grid(plan: &SvgPlan, page: &mut SvgPage) {
    for tick in &plan.up {
        let y = plan.y_of(tick.value);
        page.line((plan.left, y), (plan.right(), y), GRID, "");
    }
    for tick in &plan.along {
        let x = plan.x_of(tick.value);
        page.line((x, plan.top), (x, plan.bottom()), GRID, "");
    }
}

/// Both axes.
pub(super) fn draw(chart: &Chart, plan: &SvgPlan, page: &mut SvgPage) {
    let (left, bottom) = (plan.left, plan.bottom());
    page.line((left, plan.top), (left, bottom), BLACK, "");
    page.line((left, bottom), (plan.right(), bottom), BLACK, "");
    for tick in &plan.up {
        let y = plan.y_of(tick.value);
        page.line((left - TICK, y), (left, y), BLACK, "");
        page.words(
            (left - TICK - 3.0, y + 0.35 * TEXT),
            Anchor::End,
            &tick.label,
        );
    }
    for tick in &plan.along {
        let x = plan.x_of(tick.value);
        page.line((x, bottom), (x, bottom + TICK), BLACK, "");
        // Numbers at the edges stay inside the picture.
        let half = 0.5 * width(&tick.label, TEXT);
        let x = x.max(half).min(super::page::WIDTH - half);
        page.words((x, bottom + TICK + TEXT), Anchor::Middle, &tick.label);
    }
    let (range, scale) = plan.x;
    let unit = ticks::scale(range, &chart.x.unit).unit(&chart.x.unit);
    let name = axis_name(&chart.x.label, &unit, scale, usize::MAX);
    let name = shortened(&name, plan.across, TEXT);
    let middle = plan.left + 0.5 * plan.across;
    page.words((middle, bottom + TEXT + ROW + 7.0), Anchor::Middle, &name);
}
