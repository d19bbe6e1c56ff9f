//! Which curves of a chart are drawn, and whether as differences.

use super::motion::moved;
use super::notice::info;
use crate::report::figures::{FigureAxis, FigureId};
use crate::tui::key::KeyPress;
use crate::tui::msg::Effect;
use crate::tui::plots;
use crate::tui::state::{AppState, LineView, Overlay};

/// Why there is no choice of curves.
#[must_use]
pub fn why_none(line: &LineView) -> Option<&'static str> {
    let count = plots::chart(line, line.chart).series.len();
    (count < 2).then_some("This chart has no two curves to choose from.")
}

/// Why curves cannot be drawn as differences.
#[must_use]
pub fn why_no_difference(line: &LineView) -> Option<&'static str> {
    if !plots::has_differences(line.chart) {
        return Some("Only curves against time are drawn as differences.");
    }
    line.against
        .is_none()
        .then_some("No run is held yet: `v` beside the inputs or in the runs holds one.")
}

/// Why the axes of the chart stay linear.
#[must_use]
pub fn why_linear(line: &LineView) -> Option<&'static str> {
    let figure = line.chart.figure();
    let linear = figure.axis == FigureAxis::Space || line.chart == FigureId::Map;
    linear.then_some("The axes of this chart are linear: it is drawn to scale, or a map.")
}

/// Draws curves against time less those of the run held against, or as they are.
pub fn difference(state: &mut AppState) -> Vec<Effect> {
    let Some(line) = state.line_mut() else {
        return Vec::new();
    };
    line.differences = !line.differences;
    let words = match (&line.against, line.differences) {
        (Some((name, _)), true) => {
            format!(
                "Curves against time are drawn less those of {name}. `d` draws them as they are."
            )
        }
        _ => "Curves are drawn as they are.".to_owned(),
    };
    info(state, words)
}

/// Keys while the curves are listed.
pub(super) fn key(state: &mut AppState, cursor: usize, key: KeyPress) -> Vec<Effect> {
    let Some(line) = state.line_mut() else {
        return Vec::new();
    };
    let figure = line.chart;
    let series = plots::chart(line, figure).series;
    let cursor = match key {
        KeyPress::Esc | KeyPress::Char('q' | 'c') => return Vec::new(),
        KeyPress::Down | KeyPress::Char('j') => moved(cursor, 1, series.len()),
        KeyPress::Up | KeyPress::Char('k') => moved(cursor, -1, series.len()),
        KeyPress::Char('a') => {
            line.hidden_curves.retain(|(of, _)| *of != figure);
            cursor
        }
        KeyPress::Char(' ') | KeyPress::Enter => {
            if let Some(series) = series.get(cursor) {
                toggle(line, figure, &series.label, series.visible);
            }
            cursor
        }
        _ => cursor,
    };
    state.overlay = Some(Overlay::Curves { cursor });
    Vec::new()
}

/// Hides a curve that is visible, or shows it.
fn toggle(line: &mut LineView, figure: FigureId, name: &str, visible: bool) {
    // A curve that is shown alone is one of all again.
    line.series = None;
    let hidden = &mut line.hidden_curves;
    if visible {
        hidden.push((figure, name.to_owned()));
    } else {
        hidden.retain(|(of, hidden)| *of != figure || !plots::is_named(name, hidden));
    }
}
