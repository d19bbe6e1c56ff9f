//! Where everything lies, from the size of the screen alone.
//!
//! Three designed layouts: one pane at a time below 120 columns; inputs beside one pane from there;
//! everything at once from 180 columns and 45 rows.

use ratatui::layout::{Constraint, Layout, Rect};

use crate::pane::PaneId;
use crate::report::figures::FigureId;
use crate::state::{AppState, LineView};
use crate::tutorial;

/// The smallest screen that is drawn.
pub const SMALLEST: (u16, u16) = (40, 10);

const WIDE: u16 = 120;
const FULL: (u16, u16) = (180, 45);

/// The parts of the screen that are always there.
#[derive(Debug, Clone, Copy)]
pub struct Areas {
    /// Case and progress.
    pub head: Rect,
    /// Tabs of the panes.
    pub tabs: Rect,
    /// The panes.
    pub body: Rect,
    /// The latest message.
    pub note: Rect,
    /// Keys.
    pub foot: Rect,
}

/// Cuts the screen into its parts.
#[must_use]
pub fn areas(screen: Rect) -> Areas {
    let [head, tabs, body, note, foot] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Length(1),
        Constraint::Min(0),
        Constraint::Length(1),
        Constraint::Length(1),
    ])
    .areas(screen);
    Areas {
        head,
        tabs,
        body,
        note,
        foot,
    }
}

/// The screen without the strip of the tutorial, which is at its foot while there is room.
#[must_use]
pub fn screen_of(state: &AppState) -> Rect {
    let (width, height) = state.size;
    let strip = match state.tutorial {
        Some(_) if height >= SMALLEST.1 + tutorial::ROWS => tutorial::ROWS,
        _ => 0,
    };
    Rect::new(0, 0, width, height - strip)
}

/// True when panes have frames with their names, as several are seen at once.
#[must_use]
pub fn framed(screen: Rect) -> bool {
    screen.width >= WIDE
}

/// The panes seen, with their outer areas.
#[must_use]
pub fn panes(screen: Rect, state: &AppState) -> Vec<(PaneId, Rect)> {
    let body = areas(screen).body;
    let (focus, modes) = (
        state.focus(),
        state.modes().is_some_and(|modes| modes.beside),
    );
    if focus == PaneId::Model {
        return vec![(focus, body)];
    }
    if state.line().is_none() {
        return file_panes((screen, body), (focus, modes), state.panes());
    }
    if screen.width < WIDE {
        if focus == PaneId::Inputs && has_room(body, state) {
            return Vec::from(cockpit(body, state));
        }
        return vec![(focus, body)];
    }
    if screen.width < FULL.0 || screen.height < FULL.1 {
        let [left, right] =
            Layout::horizontal([Constraint::Length(58), Constraint::Min(0)]).areas(body);
        let other = match focus {
            PaneId::Inputs if modes => PaneId::Modes,
            PaneId::Inputs => PaneId::Charts,
            focus => focus,
        };
        let mut panes = with_band(left, state);
        panes.push((other, right));
        return panes;
    }
    let [left, right] =
        Layout::horizontal([Constraint::Length(66), Constraint::Min(0)]).areas(body);
    let [inputs, runs, jobs] = Layout::vertical([
        Constraint::Fill(3),
        Constraint::Fill(1),
        Constraint::Length(8),
    ])
    .areas(left);
    let mut panes = with_band(inputs, state);
    panes.extend([(PaneId::Runs, runs), (PaneId::Jobs, jobs)]);
    if matches!(focus, PaneId::Report | PaneId::Sweep) {
        panes.push((focus, right));
    } else if modes {
        panes.push((PaneId::Modes, right));
    } else {
        let [charts, table] =
            Layout::vertical([Constraint::Fill(2), Constraint::Fill(1)]).areas(right);
        panes.push((PaneId::Charts, charts));
        let shown = match focus {
            PaneId::Nodes | PaneId::Results => focus,
            _ => PaneId::Validation,
        };
        panes.push((shown, table));
    }
    panes
}

/// The names of the panes seen.
#[must_use]
pub fn seen(state: &AppState) -> Vec<PaneId> {
    let screen = screen_of(state);
    let panes = panes(screen, state).into_iter();
    panes.map(|(id, _)| id).collect()
}

/// The inputs with the band of results below them; without it where all results are seen.
fn with_band(area: Rect, state: &AppState) -> Vec<(PaneId, Rect)> {
    let height = match state.focus() {
        PaneId::Results => 0,
        _ => state.line().map_or(0, band_height),
    };
    let [inputs, band] =
        Layout::vertical([Constraint::Min(0), Constraint::Length(height)]).areas(area);
    let mut panes = vec![(PaneId::Inputs, inputs)];
    if height > 0 {
        panes.push((PaneId::Results, band));
    }
    panes
}

/// The least room for inputs, chart and results in one view.
const COCKPIT: (u16, u16) = (70, 16);

/// Whether inputs, chart and results are seen in one view.
fn has_room(body: Rect, state: &AppState) -> bool {
    let open = state
        .document
        .as_ref()
        .is_some_and(|document| document.zoomed);
    !open && body.width >= COCKPIT.0 && body.height >= COCKPIT.1
}

/// Why the inputs cannot be given the whole screen.
#[must_use]
pub fn why_not_zoomed(state: &AppState) -> Option<&'static str> {
    let screen = screen_of(state);
    let (width, body) = (screen.width, areas(screen).body);
    let shares = width < WIDE && body.width >= COCKPIT.0 && body.height >= COCKPIT.1;
    (state.line().is_none() || !shares).then_some("The inputs share their place with nothing here.")
}

/// Inputs and chart beside each other, and the results below.
fn cockpit(body: Rect, state: &AppState) -> [(PaneId, Rect); 3] {
    let height = state.line().map_or(0, band_height);
    let [above, band] =
        Layout::vertical([Constraint::Min(0), Constraint::Length(height)]).areas(body);
    let [given, chart] = Layout::horizontal([Constraint::Fill(21), Constraint::Fill(19)])
        .spacing(1)
        .areas(above);
    [
        (PaneId::Inputs, given),
        (PaneId::Charts, chart),
        (PaneId::Results, band),
    ]
}

/// Whether a pane is the band of results that belongs to the inputs, not the pane of all results.
#[must_use]
pub fn is_band(id: PaneId, state: &AppState) -> bool {
    id == PaneId::Results && state.focus() != PaneId::Results
}

/// The visible panes of a file other than a line case: its inputs, its drawing, and its tables or checks.
fn file_panes(
    (screen, body): (Rect, Rect),
    (focus, modes): (PaneId, bool),
    panes: &'static [PaneId],
) -> Vec<(PaneId, Rect)> {
    if screen.width < WIDE {
        return vec![(focus, body)];
    }
    let drawing = panes.get(1).copied().unwrap_or(PaneId::Inputs);
    let full = screen.width >= FULL.0 && screen.height >= FULL.1;
    let keys = if full { 66 } else { 58 };
    let [left, right] =
        Layout::horizontal([Constraint::Length(keys), Constraint::Min(0)]).areas(body);
    if !full {
        let other = match focus {
            PaneId::Inputs if modes => PaneId::Modes,
            PaneId::Inputs => drawing,
            focus => focus,
        };
        return vec![(PaneId::Inputs, left), (other, right)];
    }
    // A cross-section is round, and needs the height more than its tables do.
    let shares = if drawing == PaneId::Drawing {
        (3, 2)
    } else {
        (1, 1)
    };
    if matches!(
        focus,
        PaneId::Charts | PaneId::Runs | PaneId::Report | PaneId::Jobs | PaneId::Sweep
    ) {
        return run_panes(left, right, focus);
    }
    if modes {
        return vec![(PaneId::Inputs, left), (PaneId::Modes, right)];
    }
    let [upper, lower] =
        Layout::vertical([Constraint::Fill(shares.0), Constraint::Fill(shares.1)]).areas(right);
    let below = match focus {
        PaneId::Validation | PaneId::Results => focus,
        _ => PaneId::Tables,
    };
    vec![(PaneId::Inputs, left), (drawing, upper), (below, lower)]
}

/// The panes of the runs of a system, beside its inputs.
fn run_panes(left: Rect, right: Rect, focus: PaneId) -> Vec<(PaneId, Rect)> {
    if matches!(focus, PaneId::Report | PaneId::Sweep) {
        return vec![(PaneId::Inputs, left), (focus, right)];
    }
    let [charts, list] = Layout::vertical([Constraint::Fill(2), Constraint::Fill(1)]).areas(right);
    let listed = match focus {
        PaneId::Jobs => focus,
        _ => PaneId::Runs,
    };
    vec![
        (PaneId::Inputs, left),
        (PaneId::Charts, charts),
        (listed, list),
    ]
}

/// Where a cross-section is drawn.
#[must_use]
pub fn drawing_area(state: &AppState) -> Rect {
    pane_area(state, PaneId::Drawing).unwrap_or_default()
}

/// The inside of a pane.
#[must_use]
pub fn inside(screen: Rect, pane: Rect) -> Rect {
    if framed(screen) {
        Rect {
            x: pane.x.saturating_add(1),
            y: pane.y.saturating_add(1),
            width: pane.width.saturating_sub(2),
            height: pane.height.saturating_sub(2),
        }
    } else {
        pane
    }
}

/// The parts of the chart pane: tabs, the charts with their areas, the readout.
#[derive(Debug, Clone)]
pub struct ChartAreas {
    /// Names of the charts; empty when all are seen.
    pub tabs: Rect,
    /// The charts seen.
    pub charts: Vec<(FigureId, Rect)>,
    /// Values at the cursor.
    pub readout: Rect,
}

/// Cuts the inside of the chart pane.
#[must_use]
pub fn charts(inside: Rect, kinds: &[FigureId], chosen: FigureId) -> ChartAreas {
    let page = kinds.chunks(TOGETHER).find(|page| page.contains(&chosen));
    let page = page.unwrap_or_default();
    // A chart that is alone on its page has the tabs of the others above it.
    let all = inside.width >= 110 && inside.height >= 24 && page.len() > 1;
    // Four joints with their units need more than one line of 80 columns.
    let lines = if inside.height >= 12 { 2 } else { 1 };
    let [tabs, middle, readout] = Layout::vertical([
        Constraint::Length(u16::from(!all)),
        Constraint::Min(0),
        Constraint::Length(lines),
    ])
    .areas(inside);
    let charts = if all {
        together(middle, page)
    } else {
        vec![(chosen, middle)]
    };
    ChartAreas {
        tabs,
        charts,
        readout,
    }
}

/// The most charts that are seen at once.
const TOGETHER: usize = 6;

/// A page of charts in two rows, the lower the longer.
fn together(area: Rect, page: &[FigureId]) -> Vec<(FigureId, Rect)> {
    let [upper, lower] = Layout::vertical([Constraint::Fill(1), Constraint::Fill(1)]).areas(area);
    let (above, below) = page.split_at(page.len() / 2);
    let row = |kinds: &[FigureId], area: Rect| {
        let places = Layout::horizontal(vec![Constraint::Fill(1); kinds.len()])
            .spacing(1)
            .split(area);
        let places: Vec<Rect> = places.iter().copied().collect();
        kinds.iter().copied().zip(places).collect::<Vec<_>>()
    };
    [row(above, upper), row(below, lower)].concat()
}

/// The inside of a pane, where it is seen.
#[must_use]
pub fn pane_area(state: &AppState, id: PaneId) -> Option<Rect> {
    let screen = screen_of(state);
    let mut seen = panes(screen, state).into_iter();
    let (_, area) = seen.find(|(place, _)| *place == id)?;
    Some(inside(screen, area))
}

/// The parts of the pane of load cases.
#[derive(Debug, Clone, Copy)]
pub struct SweepAreas {
    /// Names of its views, and how far the sweep is.
    pub head: Rect,
    /// The view.
    pub view: Rect,
    /// The load cases under the cursor, where there is room for them.
    pub cell: Option<Rect>,
    /// The verdict, where there is room for it.
    pub verdict: Option<Rect>,
}

/// Cuts the inside of the pane of load cases.
#[must_use]
pub fn sweep(inside: Rect) -> SweepAreas {
    let [head, below] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(inside);
    if inside.height < ROOM_FOR_ALL.1 || inside.width < ROOM_FOR_ALL.0 {
        return SweepAreas {
            head,
            view: below,
            cell: None,
            verdict: None,
        };
    }
    let [view, cell, verdict] = Layout::vertical([
        Constraint::Fill(5),
        Constraint::Fill(3),
        Constraint::Fill(3),
    ])
    .spacing(1)
    .areas(below);
    SweepAreas {
        head,
        view,
        cell: Some(cell),
        verdict: Some(verdict),
    }
}

/// The least room for map, load cases and verdict at once.
const ROOM_FOR_ALL: (u16, u16) = (100, 40);

/// Whether the verdict of the checks is seen beside the map.
#[must_use]
pub fn shows_verdict(state: &AppState) -> bool {
    let area = pane_area(state, PaneId::Sweep);
    area.is_some_and(|area| sweep(area).verdict.is_some())
}

/// Where the chosen chart is drawn.
#[must_use]
pub fn chart_area(state: &AppState) -> Rect {
    let (Some(view), Some(pane)) = (state.runs_view(), pane_area(state, PaneId::Charts)) else {
        return Rect::default();
    };
    let mut charts = charts(pane, &view.figures, view.chart).charts.into_iter();
    charts
        .find(|(kind, _)| *kind == view.chart)
        .map_or_else(Rect::default, |(_, area)| area)
}

/// How many lines the band takes, its title included; none where the case is not solved yet.
#[must_use]
pub fn band_height(line: &LineView) -> u16 {
    u16::try_from(line.results.len()).map_or(0, |count| count.min(5) + 1)
}
