//! The charts of runs: one with tabs, or all at once where there is room.

use std::path::PathBuf;

use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::interface::{Pane, PaneInfo, about};
use crate::chart::{self, GridMap, svg::svg};
use crate::command::{self, Command, CommandId, main, other};
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::plot_pane::{PlotPane, PlotVerb};
use crate::report::figures::{FIGURES, FigureAxis, FigureId};
use crate::state::{AppState, Charted, Overlay, RunsView};
use crate::update::export::{self, TEXT_WIDTH};
use crate::update::motion::plot_verb;
use crate::update::notice::info;
use crate::update::{curves, pages};
use crate::view::layout;
use crate::view::paint::right;
use crate::view::painter::Painter;
use crate::{number, plots, visible};

/// Lines of characters in place of which a picture stands.
const PICTURE_LINES: usize = 24;

/// Small and large steps of the instant across the run, on charts without a time axis.
const INSTANTS: (f64, f64) = (60.0, 10.0);

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::NextChart, &["]", "n"], "chart", "Show the next chart"),
    main(CommandId::NextSeries, &["j", "down"], "curve", "Show the next joint or component alone; after the last: all of them"),
    main(CommandId::CursorRight, &["l", "right"], "cursor", "Move the cursor right; on the line's shape: a later instant"),
    main(CommandId::ZoomIn, &["+", "="], "zoom", "Zoom in about the cursor"),
    command::write("Write the chart to a text file, a map also as CSV"),
    other(CommandId::WritePicture, &["P"], "", "Write the chart to a file as a picture of lines and words (SVG)"),
    other(CommandId::Fit, &["0"], "fit", "Show everything again, at the newest instant"),
    other(CommandId::Limits, &["t"], "limits", "Show limits and published values, or leave them out"),
    other(CommandId::Curves, &["c"], "curves", "Show or hide each curve of the chart"),
    other(CommandId::Difference, &["d"], "difference", "Show curves against time less those of the run held against, or as they are"),
    other(CommandId::LogUp, &["g"], "log", "Change between a logarithmic and a linear y axis"),
    other(CommandId::LogAlong, &["G"], "", "Change between a logarithmic and a linear x axis"),
    other(CommandId::Statistics, &["i"], "statistics", "Least, greatest, mean and deviation of each curve over what is shown of the axis"),
    other(CommandId::Freeze, &["f"], "freeze", "Hold the curves still while the job continues, or let them continue"),
    other(CommandId::PreviousChart, &["[", "p"], "", "Show the previous chart"),
    other(CommandId::PreviousSeries, &["k", "up"], "", "Show the previous joint or component alone"),
    other(CommandId::CursorLeft, &["h", "left"], "", "Move the cursor left; on the line's shape: an earlier instant"),
    other(CommandId::LeapRight, &["pgdn", "ctrl+d"], "", "Move the cursor right by a tenth of the chart"),
    other(CommandId::LeapLeft, &["pgup", "ctrl+u"], "", "Move the cursor left by a tenth of the chart"),
    other(CommandId::ZoomOut, &["-"], "", "Zoom out about the cursor"),
    other(CommandId::PanRight, &["L"], "", "Pan right"),
    other(CommandId::PanLeft, &["H"], "", "Pan left"),
    other(CommandId::PanUp, &["}"], "", "Pan up; on the map: read the place above"),
    other(CommandId::PanDown, &["{"], "", "Pan down; on the map: read the place below"),
    other(CommandId::FitHeight, &["z"], "", "Fit the height to what is seen"),
    other(CommandId::Mark, &["m"], "", "Set a mark at the cursor, or remove the mark there"),
    other(CommandId::Copy, &["y"], "", "Copy the values at the cursor to the clipboard of your terminal, and write them to a file"),
];

pub(super) struct ChartsPane;

impl Pane for ChartsPane {
    fn about(&self) -> PaneInfo {
        about("Charts", "Go to the charts", &[COMMANDS])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let on = state.charted()?;
        let of_curves = matches!(
            id,
            CommandId::NextSeries
                | CommandId::PreviousSeries
                | CommandId::CursorRight
                | CommandId::CursorLeft
                | CommandId::ZoomIn
                | CommandId::Freeze
                | CommandId::Curves
                | CommandId::Difference
                | CommandId::LogUp
                | CommandId::LogAlong
                | CommandId::Write
                | CommandId::WritePicture
        );
        if of_curves && !plots::has_curves(on) {
            return Some("There are no curves yet. `:run` runs the case.");
        }
        let alone = matches!(id, CommandId::NextSeries | CommandId::PreviousSeries);
        if alone && plots::curve_count(on, on.view.chart) == 0 {
            return Some("This chart has no curves to show one by one.");
        }
        match id {
            CommandId::Curves => return curves::why_none(on),
            CommandId::Difference => return curves::why_no_difference(on),
            CommandId::LogUp | CommandId::LogAlong => return curves::why_linear(on),
            _ => {}
        }
        let fitted = on.view.instant.is_none() && on.view.views[on.view.chart.index()].is_fitted();
        (id == CommandId::Fit && fitted).then_some("Everything is shown already.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let glyphs = state.capabilities.glyphs;
        let area = layout::chart_area(state);
        let stem = state.editor()?.stem().to_owned();
        let view = state.runs_view_mut()?;
        match id {
            CommandId::NextChart => view.chart = view.chart.beside(&view.figures, true),
            CommandId::PreviousChart => view.chart = view.chart.beside(&view.figures, false),
            CommandId::NextSeries => next_series(state, true),
            CommandId::PreviousSeries => next_series(state, false),
            CommandId::Freeze => return Some(freeze(state)),
            CommandId::Limits => return Some(limits(state)),
            CommandId::Curves => state.overlay = Some(Overlay::Curves { cursor: 0 }),
            CommandId::Difference => return Some(curves::difference(state)),
            CommandId::Copy => return Some(copy(state)),
            CommandId::Statistics => {
                let on = state.charted()?;
                let table = chart::statistics::table(&plots::viewed(on, on.view.chart));
                return Some(pages::open_table(state, "statistics", &table));
            }
            CommandId::Write => return Some(write(state.charted()?, &stem, glyphs)),
            CommandId::WritePicture => return Some(write_picture(state.charted()?, &stem)),
            _ => match (instant_step(id), plot_verb(id)) {
                (Some((way, parts)), _) if view.chart.figure().axis == FigureAxis::Space => {
                    move_instant(state, way, parts);
                }
                (_, verb) => {
                    let size = (area.width.into(), area.height.into());
                    act(state, verb?, size, glyphs);
                }
            },
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let state = painter.state;
        let Some(on) = state.charted() else {
            return;
        };
        let parts = layout::charts(area, &on.view.figures, on.view.chart);
        let all = parts.charts.len() > 1;
        if !all {
            chart_tabs(painter, parts.tabs, on);
        }
        for (id, place) in &parts.charts {
            let mut chart = plots::viewed(on, *id);
            chart.ends = true;
            if all && *id == on.view.chart && state.focus() == PaneId::Charts {
                chart.title = format!("> {} <", chart.title);
            }
            if !chart.is_empty() {
                let (glyphs, theme) = (painter.glyphs(), painter.theme);
                on.view.views[id.index()].draw(&chart, *place, painter.buf, glyphs, theme);
            } else if *id == FigureId::Study {
                let words = "`:validate` computes what the case states along its studies.";
                painter.titled(*place, &chart.title, words);
            } else {
                painter.titled(
                    *place,
                    &chart.title,
                    &nothing_yet(on, state.number_of(PaneId::Runs)),
                );
            }
        }
        readout(painter, parts.readout, on);
    }
}

/// All, then one series after the other, then all again.
fn next_series(state: &mut AppState, forward: bool) {
    let count = state
        .charted()
        .map_or(0, |on| plots::curve_count(on, on.view.chart));
    let Some(view) = state.runs_view_mut() else {
        return;
    };
    view.series = match (view.series, forward) {
        (None, true) => (count > 0).then_some(0),
        (None, false) => count.checked_sub(1),
        (Some(i), true) => (i + 1 < count).then_some(i + 1),
        (Some(i), false) => i.checked_sub(1),
    };
}

fn instant_step(id: CommandId) -> Option<(f64, f64)> {
    Some(match id {
        CommandId::CursorRight => (1.0, INSTANTS.0),
        CommandId::CursorLeft => (-1.0, INSTANTS.0),
        CommandId::LeapRight => (1.0, INSTANTS.1),
        CommandId::LeapLeft => (-1.0, INSTANTS.1),
        _ => return None,
    })
}

/// Whether the cursor of a figure is the instant that all charts share.
fn against_time(id: FigureId) -> bool {
    id.figure().axis == FigureAxis::Time
}

fn act(state: &mut AppState, verb: PlotVerb, size: (usize, usize), glyphs: chart::Glyphs) {
    let Some(base) = state.charted().map(|on| plots::chart(on, on.view.chart)) else {
        return;
    };
    let Some(view) = state.runs_view_mut() else {
        return;
    };
    let mut plot = std::mem::take(&mut view.views[view.chart.index()]);
    if against_time(view.chart) {
        plot.set_cursor(view.instant);
    }
    let frame = chart::frame(&plot.chart(&base), size.0, size.1, glyphs);
    plot.act(verb, &base, frame);
    if against_time(view.chart) {
        view.instant = plot.cursor();
    }
    if verb == PlotVerb::Fit {
        view.instant = None;
        plot.set_cursor(None);
    }
    view.views[view.chart.index()] = plot;
    share_instant(view);
}

/// The views of the charts against time all show the same instant.
fn share_instant(view: &mut RunsView) {
    for figure in FIGURES.iter().filter(|f| f.axis == FigureAxis::Time) {
        view.views[figure.id.index()].set_cursor(view.instant);
    }
}

fn move_instant(state: &mut AppState, way: f64, parts: f64) {
    let range: Option<chart::AxisRange> = state.charted().and_then(plots::time_range);
    let (Some((low, high)), Some(view)) = (range, state.runs_view_mut()) else {
        return;
    };
    let from = view.instant.unwrap_or(if way > 0.0 { low } else { high });
    let high = high.max(low);
    view.instant = Some((from + way * (high - low) / parts).clamp(low, high));
    share_instant(view);
}

/// All charts are held still together, so that they show the same instant.
fn freeze(state: &mut AppState) -> Vec<Effect> {
    let Some(on) = state.charted() else {
        return Vec::new();
    };
    let frozen = on.view.views.iter().any(PlotPane::is_frozen);
    let bases = FIGURES.map(|figure| plots::chart(on, figure.id));
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    for (plot, base) in view.views.iter_mut().zip(&bases) {
        if plot.is_frozen() == frozen {
            plot.act(PlotVerb::Freeze, base, chart::PlotFrame::default());
        }
    }
    info(
        state,
        if frozen {
            "The curves continue."
        } else {
            "The curves are held still. `:freeze` lets them continue."
        },
    )
}

/// What the cursor reads, one entry a series.
fn readout_words(on: Charted<'_>, id: FigureId) -> Vec<String> {
    let base = plots::chart(on, id);
    let read = on.view.views[id.index()].readout(&base);
    read.into_iter().map(|r| r.words(&base.x.unit)).collect()
}

fn copy(state: &mut AppState) -> Vec<Effect> {
    let Some(on) = state.charted() else {
        return Vec::new();
    };
    let words = readout_words(on, on.view.chart);
    let chart = plots::viewed(on, on.view.chart);
    match chart.cursor {
        Some(at) if !words.is_empty() => {
            let head = format!(
                "{}: {} = {}",
                chart.title,
                chart.x.label,
                number::si(at, &chart.x.unit)
            );
            let text = format!("{head}\n{}\n", words.join("\n"));
            vec![Effect::Copy(visible::text(&text).into_owned())]
        }
        _ => info(
            state,
            "There is no cursor on this chart yet; `:cursor_left` and `:cursor_right` move it on charts with an axis of time or length.",
        ),
    }
}

/// The chart as text, and a map also as numbers.
fn write(on: Charted<'_>, stem: &str, glyphs: chart::Glyphs) -> Vec<Effect> {
    let shown = plots::viewed(on, on.view.chart);
    let text = chart::draw(&shown, TEXT_WIDTH, 30, glyphs).to_text();
    let name = on.view.chart.figure().title.to_lowercase();
    let path = |end: &str| PathBuf::from(format!("{stem}-{name}.{end}"));
    let mut effects = export::write(path("txt"), Some(text), "The chart");
    let csv = shown.map.as_ref().map(GridMap::csv);
    effects.extend(export::write(path("csv"), csv, "The map"));
    effects
}

/// The chart as a picture.
fn write_picture(on: Charted<'_>, stem: &str) -> Vec<Effect> {
    let shown = plots::viewed(on, on.view.chart);
    let name = on.view.chart.figure().title.to_lowercase();
    let path = PathBuf::from(format!("{stem}-{name}.svg"));
    export::write(path, Some(svg(&shown, PICTURE_LINES)), "The picture")
}

/// Shows limits and published values, or leaves them out.
fn limits(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    view.without_limits = !view.without_limits;
    let words = match view.without_limits {
        true => "Limits and published values are left out. `:limits` shows them.",
        false => "Limits and published values are shown where the case states them.",
    };
    info(state, words)
}

fn chart_tabs(painter: &mut Painter, tabs: Rect, on: Charted<'_>) {
    let figures = &on.view.figures;
    let selected = figures.iter().position(|id| *id == on.view.chart);
    let titles = figures.iter().map(|id| id.figure().title);
    let rest = painter.tabs(tabs, titles, selected);
    if on.view.views.iter().any(PlotPane::is_frozen) {
        right(painter.buf, rest, "frozen", painter.theme.warning());
    }
}

fn nothing_yet(on: Charted<'_>, runs: usize) -> String {
    match (&on.view.live.failure, plots::runs_shown(on)) {
        (Some(why), _) => format!("The last solve gave nothing: {why}"),
        (None, 0) if on.view.runs.is_empty() => {
            "There is no run yet. `:run` computes one.".to_owned()
        }
        (None, 0) => format!("No run is shown. `{runs}` goes to the runs, space shows one."),
        (None, _) => "Nothing to draw yet.".to_owned(),
    }
}

/// The position of the cursor and every value there, as many lines as the area has.
fn readout(painter: &mut Painter, area: Rect, on: Charted<'_>) {
    let mut words = Vec::new();
    let mut at = on.view.instant.map(|t| format!("t = {t:.1} s"));
    // Without a cursor there is nothing to read, and no chart to make for it.
    if on.view.views[on.view.chart.index()].cursor().is_some() {
        let chart = plots::viewed(on, on.view.chart);
        words = readout_words(on, on.view.chart);
        let read = chart.cursor.filter(|_| !words.is_empty());
        at = read.map(|x| number::si(x, &chart.x.unit)).or(at);
    }
    if let Some(at) = at {
        words.insert(0, at);
    }
    let plain = painter.theme.plain();
    let lines = wrapped(&words, usize::from(area.width));
    painter.lines(area, lines.into_iter().map(|line| (line, plain)));
}

/// Words on lines of this width, three spaces apart, none broken.
fn wrapped(words: &[String], width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if line.width() + 3 + word.width() <= width => {
                line.push_str("   ");
                line.push_str(word);
            }
            _ => lines.push(word.clone()),
        }
    }
    lines
}
