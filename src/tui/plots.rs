//! The charts of the open case: which runs are on them, and which of their curves.

use super::state::line::CoarseAnswer;
use super::state::{LineView, RunCurves};
use crate::report::chart::{AxisRange, Chart};
use crate::report::figures::{FigureData, FigureId, PlottedRun};

/// A run on the charts.
struct Shown<'a> {
    label: &'a str,
    curves: &'a RunCurves,
    dimmed: bool,
}

impl<'a> Shown<'a> {
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
fn has_landed(line: &LineView) -> bool {
    let going = line.live.going.as_ref();
    going.is_some_and(|going| going.progress.estimating)
}

/// The coarse answer, as long as it is on the charts.
fn coarse_shown(line: &LineView) -> Option<&CoarseAnswer> {
    let coarse = line.live.coarse.as_ref();
    coarse.filter(|_| !line.live.hidden && !has_landed(line))
}

/// The runs on the charts, older results first.
fn shown(line: &LineView) -> Vec<Shown<'_>> {
    let mut list = Vec::new();
    let live = &line.live;
    if !live.hidden {
        // The old curve stays, dimmed, until the new one is complete.
        let landed = has_landed(line);
        let coarse = coarse_shown(line);
        list.extend(coarse.map(|coarse| Shown {
            label: "coarse",
            curves: &coarse.curves,
            dimmed: live.going.is_some(),
        }));
        let done = live.done.as_ref();
        let done = done.filter(|_| !landed && coarse.is_none());
        list.extend(done.map(|curves| Shown {
            label: if live.going.is_some() {
                "before"
            } else {
                "live"
            },
            curves,
            dimmed: live.going.is_some(),
        }));
        list.extend(live.going.as_ref().map(|curves| Shown {
            label: "live",
            curves,
            dimmed: false,
        }));
    }
    list.extend(line.runs.on_charts().map(|slot| Shown {
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
pub fn runs_shown(line: &LineView) -> usize {
    shown(line).iter().filter(|s| !s.dimmed).count()
}

/// Whether the runs shown have anything to draw.
#[must_use]
pub fn has_curves(line: &LineView) -> bool {
    let drawn =
        |run: &Shown| !run.curves.history().time.is_empty() || !run.curves.shapes().is_empty();
    shown(line).iter().any(drawn)
}

/// The figure of this name as the user has it: with zoom, cursor and marks.
#[must_use]
pub fn viewed(line: &LineView, id: FigureId) -> Chart {
    line.views[id.index()].chart(&chart(line, id))
}

/// What the figures of the case are drawn from.
fn with_data<T>(line: &LineView, make: impl FnOnce(&FigureData) -> T) -> T {
    let runs: Vec<PlottedRun> = shown(line).iter().map(Shown::source).collect();
    make(&FigureData {
        case: &line.case,
        runs: &runs,
        checks: &line.checks,
        instant: line.instant,
        chosen: line.series,
        limits: !line.without_limits,
    })
}

/// The figure of this name, without zoom and cursor.
#[must_use]
pub fn chart(line: &LineView, id: FigureId) -> Chart {
    let figure = id.figure();
    let (mut chart, names) = with_data(line, |data| (figure.draw(data), figure.curve_names(data)));
    let only = match line.series {
        _ if figure.has_variants() => None,
        Some(i) => names.get(i.min(names.len().saturating_sub(1))),
        // Every curve of every run would be too many to tell apart.
        None if runs_shown(line) > 1 => names.last(),
        None => None,
    };
    if let Some(only) = only {
        keep_only(&mut chart, only);
    }
    if coarse_shown(line).is_some() {
        chart.title.push_str(" (coarse)");
    }
    chart
}

/// How many curves or variants of a figure can be shown alone.
#[must_use]
pub fn curve_count(line: &LineView, id: FigureId) -> usize {
    with_data(line, |data| id.figure().curve_names(data).len())
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
pub fn time_range(line: &LineView) -> Option<AxisRange> {
    let runs = shown(line);
    let ends = runs.iter().filter_map(|s| {
        let time = &s.curves.history().time;
        Some((*time.first()?, *time.last()?))
    });
    ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}
