//! Cursors: how far a command moves one in a list, a table or a chart.

use crate::tui::command::Id;
use crate::tui::plot_pane::{PlotVerb, Stride};
use crate::tui::state::AppState;
use crate::tui::table_pane::TableVerb;

/// Moves a cursor in a list of so many lines.
#[must_use]
pub fn moved(cursor: usize, by: isize, lines: usize) -> usize {
    cursor
        .saturating_add_signed(by)
        .min(lines.saturating_sub(1))
}

/// By how many lines a command moves a cursor.
#[must_use]
pub fn step(state: &AppState, id: Id) -> Option<isize> {
    let page = isize::try_from(state.size.1.saturating_sub(8).max(2) / 2).unwrap_or(8);
    match id {
        Id::Down => Some(1),
        Id::Up => Some(-1),
        Id::PageDown => Some(page),
        Id::PageUp => Some(-page),
        Id::Top => Some(isize::MIN / 2),
        Id::Bottom => Some(isize::MAX / 2),
        _ => None,
    }
}

/// What a command does to a table.
#[must_use]
pub fn table_verb(state: &AppState, id: Id) -> Option<TableVerb> {
    Some(match id {
        Id::ScrollLeft => TableVerb::Left,
        Id::ScrollRight => TableVerb::Right,
        Id::Sort => TableVerb::SortNext,
        _ => {
            let by = step(state, id)?;
            let rows = by.unsigned_abs();
            if by < 0 {
                TableVerb::PageUp(rows)
            } else {
                TableVerb::PageDown(rows)
            }
        }
    })
}

/// What a command does to a chart.
#[must_use]
pub fn plot_verb(id: Id) -> Option<PlotVerb> {
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
        Id::FitHeight => PlotVerb::FitUp,
        Id::Mark => PlotVerb::Mark,
        _ => return None,
    })
}
