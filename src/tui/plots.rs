//! The charts of the open case: which runs are on them, and which of their curves.

use std::sync::Arc;

use super::state::RunCurves;
use super::state::runs_view::{Charted, CoarseAnswer};
use crate::chart::{AxisRange, Chart, LimitLine, ReferenceLine};
use crate::comparison::points_less;
use crate::report::figures::{FigureAxis, FigureData, FigureId, PlottedRun};
use crate::run::Run;

/// A run on the charts.
struct ShownRun<'a> {
    label: &'a str,
    curves: &'a RunCurves,
    dimmed: bool,
}

impl<'a> ShownRun<'a> {
    fn source(&self) -> PlottedRun<'a> {
        let source = match &self.curves.run {
            Some(run) => PlottedRun::whole(run, self.label),
            None => PlottedRun::streamed(self.curves.history(), self.curves.shapes(), self.label)
                .until(self.curves.progress.duration),
        };
        if self.dimmed { source.dimmed() } else { source }
    }
}

/// Whether the curves of the live solve are complete, and only their errors are left to estimate.
fn has_landed(on: Charted<'_>) -> bool {
    let going = on.view.live.going.as_ref();
    going.is_some_and(|going| going.progress.estimating)
}

/// The coarse answer, as long as it is on the charts.
fn coarse_shown(on: Charted<'_>) -> Option<&CoarseAnswer> {
    let coarse = on.view.live.coarse.as_ref();
    // What is coarse is compared with nothing.
    let subtracted = on.view.differences && on.view.against.is_some();
    coarse.filter(|_| !on.view.live.hidden && !has_landed(on) && !subtracted)
}

/// The runs on the charts, older results first.
fn shown(on: Charted<'_>) -> Vec<ShownRun<'_>> {
    let mut list = Vec::new();
    let live = &on.view.live;
    if !live.hidden {
        // The old curve stays, dimmed, until the new one is complete.
        let landed = has_landed(on);
        let coarse = coarse_shown(on);
        list.extend(coarse.map(|coarse| ShownRun {
            label: "coarse",
            curves: &coarse.curves,
            dimmed: live.going.is_some(),
        }));
        let done = live.done.as_ref();
        let done = done.filter(|_| !landed && coarse.is_none());
        list.extend(done.map(|curves| ShownRun {
            label: if live.going.is_some() {
                "before"
            } else {
                "live"
            },
            curves,
            dimmed: live.going.is_some(),
        }));
        list.extend(live.going.as_ref().map(|curves| ShownRun {
            label: "live",
            curves,
            dimmed: false,
        }));
    }
    list.extend(on.view.runs.on_charts().map(|slot| ShownRun {
        label: if slot.label.is_empty() {
            &slot.id
        } else {
            &slot.label
        },
        curves: &slot.curves,
        dimmed: false,
    }));
    list
}

/// How many runs are on the charts in full ink.
#[must_use]
pub fn runs_shown(on: Charted<'_>) -> usize {
    shown(on).iter().filter(|s| !s.dimmed).count()
}

/// Whether the runs shown have anything to draw.
#[must_use]
pub fn has_curves(on: Charted<'_>) -> bool {
    let drawn =
        |run: &ShownRun| !run.curves.history().time.is_empty() || !run.curves.shapes().is_empty();
    shown(on).iter().any(drawn)
}

/// The figure of this name as the user has it: with zoom, cursor and marks.
#[must_use]
pub fn viewed(on: Charted<'_>, id: FigureId) -> Chart {
    on.view.views[id.index()].chart(&chart(on, id))
}

/// What the figures of the case are drawn from.
fn with_data<T>(on: Charted<'_>, make: impl FnOnce(&FigureData) -> T) -> T {
    let runs: Vec<PlottedRun> = shown(on).iter().map(ShownRun::source).collect();
    make(&FigureData {
        case: on.case,
        runs: &runs,
        checks: on.checks,
        instant: on.view.instant,
        chosen: on.view.series,
        limits: !on.view.without_limits,
    })
}

/// The figure of this name, without zoom and cursor.
#[must_use]
pub fn chart(on: Charted<'_>, id: FigureId) -> Chart {
    let figure = id.figure();
    let (mut chart, names) = with_data(on, |data| (figure.draw(data), figure.curve_names(data)));
    let only = match on.view.series {
        _ if figure.has_variants() => None,
        Some(i) => names.get(i.min(names.len().saturating_sub(1))),
        // Every curve of every run would be too many to tell apart.
        None if runs_shown(on) > 1 => names.last(),
        None => None,
    };
    if let Some(held) = held(on, id) {
        let base = with_held(on, &held.1, |data| figure.draw(data));
        subtract(&mut chart, &base, &held.0);
    }
    if let Some(only) = only {
        keep_only(&mut chart, only);
    }
    if on.view.series.is_none() {
        hide(&mut chart, on, id);
    }
    if coarse_shown(on).is_some() {
        chart.title.push_str(" (coarse)");
    }
    chart
}

/// Whether a figure can be drawn as differences: of curves against time.
#[must_use]
pub fn has_differences(id: FigureId) -> bool {
    let figure = id.figure();
    figure.axis == FigureAxis::Time && !figure.has_variants()
}

/// The run whose curves are subtracted from those of a figure, and its name.
fn held(on: Charted<'_>, id: FigureId) -> Option<&(String, Arc<Run>)> {
    let held = on.view.against.as_ref();
    held.filter(|_| on.view.differences && has_differences(id))
}

/// What a figure is drawn from, with the run held alone.
fn with_held<T>(on: Charted<'_>, held: &Run, make: impl FnOnce(&FigureData) -> T) -> T {
    with_data(on, |data| {
        make(&FigureData {
            runs: &[PlottedRun::whole(held, "")],
            ..*data
        })
    })
}

/// Subtracts the curve of the same name from each.
fn subtract(chart: &mut Chart, held: &Chart, name: &str) {
    for series in &mut chart.series {
        let mut others = held.series.iter();
        let other = others.find(|other| is_named(&series.label, &other.label));
        series.points =
            other.map_or_else(Vec::new, |other| points_less(&series.points, &other.points));
    }
    chart.series.retain(|series| !series.points.is_empty());
    chart.title = format!("{}, less {name}", chart.title);
    chart.y.label = "difference".to_owned();
    chart.y.range = None;
    chart.limits = vec![ReferenceLine::new("", LimitLine::Horizontal(0.0))];
}

/// Whether a label is this name, or this name of some run.
#[must_use]
pub fn is_named(label: &str, name: &str) -> bool {
    let rest = label.strip_prefix(name);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(", "))
}

/// Hides the curves that the user has taken off.
fn hide(chart: &mut Chart, on: Charted<'_>, id: FigureId) {
    let hidden = || {
        on.view
            .hidden_curves
            .iter()
            .filter(|(figure, _)| *figure == id)
    };
    for series in &mut chart.series {
        if hidden().any(|(_, name)| is_named(&series.label, name)) {
            series.visible = false;
        }
    }
}

/// How many curves or variants of a figure can be shown alone.
#[must_use]
pub fn curve_count(on: Charted<'_>, id: FigureId) -> usize {
    with_data(on, |data| id.figure().curve_names(data).len())
}

/// Leaves one curve of each run on the chart, named after the run, each with a marker and colour of
/// its own; an older result shares those of the curve that takes its place.
fn keep_only(chart: &mut Chart, name: &str) {
    let with_run = format!("{name}, ");
    chart
        .series
        .retain(|s| s.label == name || s.label.starts_with(&with_run));
    chart.title = format!("{}: {name}", chart.title);
    let mut slot = 0;
    for series in &mut chart.series {
        if let Some(run) = series.label.strip_prefix(&with_run) {
            series.label = run.to_owned();
        }
        series.slot = slot;
        slot += usize::from(!series.dimmed);
    }
}

/// First and last instant of the runs shown.
#[must_use]
pub fn time_range(on: Charted<'_>) -> Option<AxisRange> {
    let runs = shown(on);
    let ends = runs.iter().filter_map(|s| {
        let time = &s.curves.history().time;
        Some((*time.first()?, *time.last()?))
    });
    ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}
