//! The charts of the open case: which runs are on them, and which of their curves.

use super::state::{ChartKind, Curves, LineView};
use crate::case::ChannelQuantity;
use crate::report::chart::{AxisRange, Chart};
use crate::report::figures::{
    self, PlottedRun, ResponseMapKind, along_studies, curvature_profile, deviation_in_time,
    elevation, line_from_above, line_from_ahead, line_shape, mean_load_in_time, moment_profile,
    payload_position, published_curves, response_map, rms_profile, speed, stiffness_in_time,
    stiffness_profile, tension_profile, tensions, tilt, trajectory, wave_amplitudes, wavelengths,
};

/// A run on the charts.
struct Shown<'a> {
    label: &'a str,
    curves: &'a Curves,
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

/// The runs on the charts, older results first.
fn shown(line: &LineView) -> Vec<Shown<'_>> {
    let mut list = Vec::new();
    let live = &line.live;
    if !live.hidden {
        // The old curve stays, dimmed, until the new one is complete.
        let landed = live.going.as_ref().is_some_and(|g| g.progress.estimating);
        let done = live.done.as_ref().filter(|_| !landed);
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
    list.extend(line.runs.iter().filter(|s| s.shown).map(|slot| Shown {
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

/// The chart of this kind as the user has it: with zoom, cursor and marks.
#[must_use]
pub fn viewed(line: &LineView, kind: ChartKind) -> Chart {
    line.views[kind.index()].chart(&chart(line, kind))
}

/// The chart of this kind as the case stands.
#[must_use]
pub fn chart(line: &LineView, kind: ChartKind) -> Chart {
    if kind == ChartKind::Study {
        return study(line);
    }
    let sources: Vec<PlottedRun> = shown(line).iter().map(Shown::source).collect();
    let newest = time_range(line).map_or(0.0, |(_, last)| last);
    let instant = line.instant.unwrap_or(newest);
    let mut chart = match kind {
        ChartKind::Tensions => tensions(&sources),
        ChartKind::Payload => payload_position(&sources),
        ChartKind::Path => trajectory(&sources, line.instant),
        ChartKind::Shape => line_shape(&sources, instant),
        ChartKind::Plan => line_from_above(&sources, instant),
        ChartKind::Front => line_from_ahead(&sources, instant),
        ChartKind::Profile => tension_profile(&sources),
        ChartKind::Curvature => curvature_profile(&sources),
        ChartKind::Moment => moment_profile(&sources),
        ChartKind::Speed => speed(&sources),
        ChartKind::Tilt => tilt(&sources),
        ChartKind::Study => Chart::default(),
        ChartKind::MeanLoad => mean_load_in_time(&sources),
        ChartKind::Deviation => deviation_in_time(&sources),
        ChartKind::Stiffness => stiffness_in_time(&sources),
        ChartKind::StiffnessAlong => stiffness_profile(&sources),
        ChartKind::Rms => rms_profile(&sources),
        ChartKind::Elevation => elevation(&sources),
        ChartKind::Amplitudes => wave_amplitudes(&sources),
        ChartKind::Wavelengths => wavelengths(&sources),
        ChartKind::Map => {
            let of = line.series.and_then(|i| ResponseMapKind::ALL.get(i + 1));
            let from = line.case.output.response_from_s;
            return response_map(
                &sources,
                from,
                of.copied().unwrap_or(ResponseMapKind::Steady),
            );
        }
    };
    let names = series_names(line, kind);
    let only = match line.series {
        Some(i) => names.get(i.min(names.len().saturating_sub(1))),
        // Every curve of every run would be too many to tell apart.
        None if runs_shown(line) > 1 => names.last(),
        None => None,
    };
    if let Some(only) = only {
        keep_only(&mut chart, only);
    }
    chart
}

/// The charts of what the case states: along its studies, then its published curves.
fn stated(line: &LineView) -> Vec<Chart> {
    let mut charts = along_studies(&line.case, &line.checks);
    charts.extend(published_curves(&line.checks));
    charts
}

/// The chosen one of the charts of what the case states, the first when none is.
fn study(line: &LineView) -> Chart {
    let mut charts = stated(line);
    let chosen = line.series.unwrap_or(0).min(charts.len().max(1) - 1);
    if charts.is_empty() {
        return Chart {
            title: "Along the studies".to_owned(),
            ..Chart::default()
        };
    }
    charts.swap_remove(chosen)
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

/// Names of the curves of one run, among which the user leafs.
#[must_use]
pub fn series_names(line: &LineView, kind: ChartKind) -> Vec<String> {
    let fixed = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect();
    match kind {
        ChartKind::Tensions => places(line, ChannelQuantity::Tension),
        ChartKind::Speed => places(line, ChannelQuantity::Speed),
        ChartKind::Tilt => places(line, ChannelQuantity::Tilt),
        ChartKind::Study => {
            let charts = stated(line);
            charts.into_iter().map(|chart| chart.title).collect()
        }
        ChartKind::MeanLoad => places(line, ChannelQuantity::MeanLoad),
        ChartKind::Deviation => places(line, ChannelQuantity::LoadDeviation),
        ChartKind::Stiffness => places(line, ChannelQuantity::Stiffness),
        ChartKind::Payload => fixed(&["x", "z"]),
        ChartKind::Amplitudes => fixed(&["motion", "towards A", "towards B", "WKB, no drag"]),
        ChartKind::Wavelengths => fixed(&["computed", "WKB"]),
        ChartKind::Map => ResponseMapKind::ALL[1..]
            .iter()
            .map(|of| of.name().to_owned())
            .collect(),
        // Lines at rest have one curve each, whose legend names the run.
        _ if shown(line).iter().all(|run| run.source().at_rest()) => Vec::new(),
        ChartKind::Profile | ChartKind::StiffnessAlong => {
            fixed(&["at the end", "smallest", "greatest"])
        }
        ChartKind::Curvature | ChartKind::Moment => fixed(&["at the end", "greatest"]),
        ChartKind::Path
        | ChartKind::Shape
        | ChartKind::Plan
        | ChartKind::Front
        | ChartKind::Elevation
        | ChartKind::Rms => Vec::new(),
    }
}

/// Where the runs shown recorded a quantity.
fn places(line: &LineView, quantity: ChannelQuantity) -> Vec<String> {
    let runs = shown(line);
    let histories = runs.iter().map(|run| run.curves.history());
    let names = figures::places(histories, quantity);
    names.into_iter().map(str::to_owned).collect()
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
