//! Cursor, zoom, pan and freeze of the charts.

use super::info;
use crate::report::chart::{self, AxisRange};
use crate::report::number;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::plot_pane::{PlotPane, PlotVerb, Stride};
use crate::tui::plots;
use crate::tui::state::{AppState, ChartKind, OpenCase};
use crate::tui::view::layout;

/// Small and large steps of the instant across the run, on charts without a time axis.
const INSTANTS: (f64, f64) = (60.0, 10.0);

pub(super) fn command(state: &mut AppState, id: Id) -> Vec<Effect> {
    let glyphs = state.capabilities.glyphs;
    let area = layout::chart_area(state);
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    match id {
        Id::NextChart => open.chart = open.chart.beside(&ChartKind::of(&open.case), true),
        Id::PreviousChart => open.chart = open.chart.beside(&ChartKind::of(&open.case), false),
        Id::NextSeries => tab(open, true),
        Id::PreviousSeries => tab(open, false),
        Id::Freeze => return freeze(state),
        Id::Copy => return copy(state),
        _ => {
            let moves_instant = open.chart.in_space();
            match (verb(id), moves_instant, step(id)) {
                (_, true, Some((way, parts))) => move_instant(open, way, parts),
                (Some(verb), ..) => {
                    act(open, &verb, (area.width.into(), area.height.into()), glyphs);
                }
                _ => {}
            }
        }
    }
    Vec::new()
}

/// All, then one series after the other, then all again.
fn tab(open: &mut OpenCase, forward: bool) {
    let count = plots::series_names(open, open.chart).len();
    open.series = match (open.series, forward) {
        (None, true) => (count > 0).then_some(0),
        (None, false) => count.checked_sub(1),
        (Some(i), true) => (i + 1 < count).then_some(i + 1),
        (Some(i), false) => i.checked_sub(1),
    };
}

pub(super) fn verb(id: Id) -> Option<PlotVerb> {
    Some(match id {
        Id::CursorRight => PlotVerb::CursorRight(Stride::Fine),
        Id::CursorLeft => PlotVerb::CursorLeft(Stride::Fine),
        Id::LeapRight => PlotVerb::CursorRight(Stride::Coarse),
        Id::LeapLeft => PlotVerb::CursorLeft(Stride::Coarse),
        Id::PanRight => PlotVerb::PanRight,
        Id::PanLeft => PlotVerb::PanLeft,
        Id::PanUp => PlotVerb::PanUp,
        Id::PanDown => PlotVerb::PanDown,
        Id::ZoomIn => PlotVerb::ZoomIn,
        Id::ZoomOut => PlotVerb::ZoomOut,
        Id::Fit => PlotVerb::Fit,
        Id::FitUp => PlotVerb::FitUp,
        Id::Mark => PlotVerb::Mark,
        _ => return None,
    })
}

fn step(id: Id) -> Option<(f64, f64)> {
    Some(match id {
        Id::CursorRight => (1.0, INSTANTS.0),
        Id::CursorLeft => (-1.0, INSTANTS.0),
        Id::LeapRight => (1.0, INSTANTS.1),
        Id::LeapLeft => (-1.0, INSTANTS.1),
        _ => return None,
    })
}

/// True for charts against time, whose cursor is the instant that all charts share.
fn against_time(kind: ChartKind) -> bool {
    matches!(
        kind,
        ChartKind::Tensions
            | ChartKind::Payload
            | ChartKind::Speed
            | ChartKind::Tilt
            | ChartKind::MeanLoad
            | ChartKind::Deviation
            | ChartKind::Stiffness
            | ChartKind::Map
            | ChartKind::Elevation
    )
}

fn act(open: &mut OpenCase, verb: &PlotVerb, size: (usize, usize), glyphs: chart::Glyphs) {
    let base = plots::chart(open, open.chart);
    let mut view = std::mem::take(&mut open.views[open.chart.index()]);
    if against_time(open.chart) {
        view.set_cursor(open.instant);
    }
    let frame = chart::frame(&view.chart(&base), size.0, size.1, glyphs);
    view.act(verb, &base, frame);
    if against_time(open.chart) {
        open.instant = view.cursor();
    }
    if *verb == PlotVerb::Fit {
        open.instant = None;
        view.set_cursor(None);
    }
    open.views[open.chart.index()] = view;
    share_instant(open);
}

/// The views of the charts against time all show the same instant.
fn share_instant(open: &mut OpenCase) {
    for kind in ChartKind::ALL.into_iter().filter(|k| against_time(*k)) {
        open.views[kind.index()].set_cursor(open.instant);
    }
}

fn move_instant(open: &mut OpenCase, way: f64, parts: f64) {
    let Some((low, high)): Option<AxisRange> = plots::time_range(open) else {
        return;
    };
    let from = open.instant.unwrap_or(if way > 0.0 { low } else { high });
    let high = high.max(low);
    open.instant = Some((from + way * (high - low) / parts).clamp(low, high));
    share_instant(open);
}

/// All charts are held still together, so that they go on telling of the same instant.
fn freeze(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let frozen = open.views.iter().any(PlotPane::is_frozen);
    for kind in ChartKind::ALL {
        let base = plots::chart(open, kind);
        let frame = chart::PlotFrame::default();
        let view = &mut open.views[kind.index()];
        if view.is_frozen() == frozen {
            view.act(&PlotVerb::Freeze, &base, frame);
        }
    }
    info(
        state,
        if frozen {
            "The curves go on."
        } else {
            "The curves are held still. `f` lets them go on."
        },
    )
}

/// What the cursor reads, one entry a series.
#[must_use]
pub(in crate::tui) fn readout_words(open: &OpenCase, kind: ChartKind) -> Vec<String> {
    let base = plots::chart(open, kind);
    let read = open.views[kind.index()].readout(&base);
    read.into_iter().map(|r| r.words(&base.x.unit)).collect()
}

fn copy(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &state.open else {
        return Vec::new();
    };
    let words = readout_words(open, open.chart);
    let chart = plots::viewed(open, open.chart);
    match chart.cursor {
        Some(at) if !words.is_empty() => {
            let head = format!(
                "{}: {} = {}",
                chart.title,
                chart.x.label,
                number::si(at, &chart.x.unit)
            );
            vec![Effect::Copy(format!("{head}\n{}\n", words.join("\n")))]
        }
        _ => info(
            state,
            "There is no cursor on this chart yet; `h` and `l` move it on charts with an axis of time or length.",
        ),
    }
}
