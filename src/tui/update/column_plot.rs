//! The chart of a column of the table of runs against another.

use std::path::PathBuf;

use super::export::{self, TEXT_WIDTH};
use crate::column_plot::ColumnPair;
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::state::{AppState, Overlay, RunList};

/// Shows the first result against the first input that differs.
pub fn open(state: &mut AppState) -> Vec<Effect> {
    let pair = state
        .runs_view()
        .and_then(|view| ColumnPair::first(&view.runs));
    state.overlay = pair.map(Overlay::Columns);
    Vec::new()
}

/// Why there is nothing to plot.
#[must_use]
pub fn why_not(runs: &RunList) -> Option<&'static str> {
    let none = ColumnPair::first(runs).is_none();
    none.then_some(
        "The runs of the table have no two columns of numbers yet. `:run` runs the case.",
    )
}

/// Keys while the chart is shown.
pub(super) fn key(state: &mut AppState, pair: ColumnPair, key: KeyPress) -> Vec<Effect> {
    let Some(view) = state.runs_view() else {
        return Vec::new();
    };
    let runs = &view.runs;
    let mut effects = Vec::new();
    let pair = match key {
        KeyPress::Esc | KeyPress::Char('q' | 'p') => return effects,
        KeyPress::Char(']') => pair.stepped(runs, false, true),
        KeyPress::Char('[') => pair.stepped(runs, false, false),
        KeyPress::Char('}') => pair.stepped(runs, true, true),
        KeyPress::Char('{') => pair.stepped(runs, true, false),
        KeyPress::Char('g') => pair.with_other_scale(false),
        KeyPress::Char('G') => pair.with_other_scale(true),
        KeyPress::Char('w') => {
            let text = pair.text(runs, TEXT_WIDTH, state.capabilities.glyphs);
            let stem = state.editor().map_or("case", |editor| editor.stem());
            let path = PathBuf::from(format!("{stem}-runs.txt"));
            effects = export::write(path, Some(text), "The chart");
            pair
        }
        _ => pair,
    };
    state.overlay = Some(Overlay::Columns(pair));
    effects
}
