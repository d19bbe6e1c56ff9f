//! Which curves of a chart are drawn, and whether as differences.

use super::motion::moved;
use super::notice::info;
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::plots;
use crate::report::figures::{FigureAxis, FigureId};
use crate::state::{AppState, Charted, Overlay, RunsView};

/// Why there is no choice of curves.
#[must_use]
pub fn why_none(on: Charted<'_>) -> Option<&'static str> {
    let count = plots::chart(on, on.view.chart).series.len();
    (count < 2).then_some("This chart has no two curves to choose from.")
}

/// Why curves cannot be drawn as differences.
#[must_use]
pub fn why_no_difference(on: Charted<'_>) -> Option<&'static str> {
    if !plots::has_differences(on.view.chart) {
        return Some("Only curves against time are drawn as differences.");
    }
    on.view.against.is_none().then_some(
        "No run is held yet: `:hold_against` beside the inputs or in the runs holds one.",
    )
}

/// Why the axes of the chart stay linear.
#[must_use]
pub fn why_linear(on: Charted<'_>) -> Option<&'static str> {
    let figure = on.view.chart.figure();
    let linear = figure.axis == FigureAxis::Space || on.view.chart == FigureId::Map;
    linear.then_some("The axes of this chart are linear: it is drawn to scale, or a map.")
}

/// Draws curves against time less those of the run held against, or as they are.
pub fn difference(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    view.differences = !view.differences;
    let words = match (&view.against, view.differences) {
        (Some((name, _)), true) => {
            format!(
                "Curves against time are drawn less those of {name}. `:difference` draws them as they are."
            )
        }
        _ => "Curves are drawn as they are.".to_owned(),
    };
    info(state, words)
}

/// Keys while the curves are listed.
pub(super) fn key(state: &mut AppState, cursor: usize, key: KeyPress) -> Vec<Effect> {
    let Some(on) = state.charted() else {
        return Vec::new();
    };
    let figure = on.view.chart;
    let series = plots::chart(on, figure).series;
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let cursor = match key {
        KeyPress::Esc | KeyPress::Char('q' | 'c') => return Vec::new(),
        KeyPress::Down | KeyPress::Char('j') => moved(cursor, 1, series.len()),
        KeyPress::Up | KeyPress::Char('k') => moved(cursor, -1, series.len()),
        KeyPress::Char('a') => {
            view.hidden_curves.retain(|(of, _)| *of != figure);
            cursor
        }
        KeyPress::Char(' ') | KeyPress::Enter => {
            if let Some(series) = series.get(cursor) {
                toggle(view, figure, &series.label, series.visible);
            }
            cursor
        }
        _ => cursor,
    };
    state.overlay = Some(Overlay::Curves { cursor });
    Vec::new()
}

/// Hides a curve that is visible, or shows it.
fn toggle(view: &mut RunsView, figure: FigureId, name: &str, visible: bool) {
    // A curve that is shown alone is one of all again.
    view.series = None;
    let hidden = &mut view.hidden_curves;
    if visible {
        hidden.push((figure, name.to_owned()));
    } else {
        hidden.retain(|(of, hidden)| *of != figure || !plots::is_named(name, hidden));
    }
}
