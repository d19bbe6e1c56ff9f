//! Cursors: how far a command moves one in a list, a table or a chart.

use crate::command::CommandId;
use crate::plot_pane::{PlotVerb, Stride};
use crate::state::AppState;
use crate::table_pane::TableVerb;

/// Moves a cursor in a list of so many lines.
#[must_use]
pub fn moved(cursor: usize, by: isize, lines: usize) -> usize {
    cursor
        .saturating_add_signed(by)
        .min(lines.saturating_sub(1))
}

/// By how many lines a command moves a cursor.
#[must_use]
pub fn step(state: &AppState, id: CommandId) -> Option<isize> {
    let page = isize::try_from(state.size.1.saturating_sub(8).max(2) / 2).unwrap_or(8);
    match id {
        CommandId::Down => Some(1),
        CommandId::Up => Some(-1),
        CommandId::PageDown => Some(page),
        CommandId::PageUp => Some(-page),
        CommandId::Top => Some(isize::MIN / 2),
        CommandId::Bottom => Some(isize::MAX / 2),
        _ => None,
    }
}

/// What a command does to a table.
#[must_use]
pub fn table_verb(state: &AppState, id: CommandId) -> Option<TableVerb> {
    Some(match id {
        CommandId::ColumnLeft => TableVerb::Column(-1),
        CommandId::ColumnRight => TableVerb::Column(1),
        CommandId::Sort => TableVerb::Sort,
        CommandId::SortAround => TableVerb::SortAround,
        CommandId::HideColumn => TableVerb::Hide,
        CommandId::ShowColumns => TableVerb::ShowAll,
        _ => TableVerb::Select(step(state, id)?),
    })
}

/// What a command does to a chart.
#[must_use]
pub fn plot_verb(id: CommandId) -> Option<PlotVerb> {
    Some(match id {
        CommandId::CursorRight => PlotVerb::Cursor(1.0, Stride::Fine),
        CommandId::CursorLeft => PlotVerb::Cursor(-1.0, Stride::Fine),
        CommandId::LeapRight => PlotVerb::Cursor(1.0, Stride::Coarse),
        CommandId::LeapLeft => PlotVerb::Cursor(-1.0, Stride::Coarse),
        CommandId::PanRight => PlotVerb::Pan(0.25, 0.0),
        CommandId::PanLeft => PlotVerb::Pan(-0.25, 0.0),
        CommandId::PanUp => PlotVerb::Pan(0.0, 0.25),
        CommandId::PanDown => PlotVerb::Pan(0.0, -0.25),
        CommandId::ZoomIn => PlotVerb::Zoom(0.5),
        CommandId::ZoomOut => PlotVerb::Zoom(2.0),
        CommandId::Fit => PlotVerb::Fit,
        CommandId::FitHeight => PlotVerb::FitUp,
        CommandId::Mark => PlotVerb::Mark,
        CommandId::LogUp => PlotVerb::LogUp,
        CommandId::LogAlong => PlotVerb::LogAlong,
        _ => return None,
    })
}
