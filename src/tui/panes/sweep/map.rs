//! A result over two axes of load cases, in shades and numbers. Only the cells in sight are drawn.

use std::ops::Range;

use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::shade;
use crate::number::{Scale, order, rounded, si, with_error};
use crate::padding::at_right;
use crate::pane::PaneId;
use crate::state::sweeps::OpenSweep;
use crate::study::load_case_table::{HeatCell, LoadCaseAxis, Reduction};
use crate::view::paint::{row, span};
use crate::view::painter::Painter;

/// Lines above the cells: title, axes, heads; and below them: scale, and two of the cell under the cursor.
const AROUND: (u16, u16) = (4, 3);
/// Lower areas have the title, the heads and a line of the cell under the cursor alone.
const LOW: u16 = 12;
const AROUND_LOW: (u16, u16) = (2, 1);
/// The widest label of a row, and the widest and highest cell.
const WIDEST_LABEL: u16 = 18;
const WIDEST_CELL: u16 = 14;
const HIGHEST_CELL: u16 = 3;
/// Columns of a shade beside a number.
const SHADE: u16 = 3;

/// Where cells are drawn.
struct Grid {
    /// The cells.
    area: Rect,
    /// Columns of the labels on the left.
    label: u16,
    /// Size of a cell, with the blank behind it.
    width: u16,
    height: u16,
    /// The cells in sight.
    columns: Range<usize>,
    rows: Range<usize>,
    /// Whether cells have room for their numbers.
    numbers: bool,
    /// How numbers are shown.
    scale: Scale,
    decimals: i32,
}

/// Draws the map with its title, its scale, and the cell under the cursor in words.
pub(super) fn draw(painter: &mut Painter, area: Rect, open: &OpenSweep) {
    let Some(grid) = Grid::new(area, open) else {
        return painter.paragraph(area, "There is no result to show.");
    };
    title(painter, area, open, &grid);
    heads(painter, open, &grid);
    let focused = painter.state.focus() == PaneId::Sweep;
    for row in grid.rows.clone() {
        grid.label(painter, open, row);
        for column in grid.columns.clone() {
            let Some(cell) = open.map.cell(column, row) else {
                continue;
            };
            let at = grid.place(column, row);
            grid.cell(painter, at, cell, open);
            if focused && (column, row) == open.cursor {
                let style = painter.theme.selected();
                painter.buf.set_style(at, style);
            }
        }
    }
    legend(painter, area, open, &grid);
    readout(painter, area, open);
}

impl Grid {
    fn new(area: Rect, open: &OpenSweep) -> Option<Self> {
        let unit = &open.shown()?.unit;
        let (low, high) = open.map.range.unwrap_or((0.0, 0.0));
        let most = f64::max(low.abs(), high.abs());
        let scale = Scale::of_magnitude(most, unit);
        let decimals = match most > 0.0 {
            true => (3 - order(most / scale.factor)).clamp(0, 6),
            false => 0,
        };
        let numbers = [low, high].map(|value| rounded(value / scale.factor, decimals).width());
        // A mark of failed load cases follows the number.
        let number = u16::try_from(numbers[0].max(numbers[1])).unwrap_or(8) + 1;
        let label = labels(open, open.choice.down)
            .map(UnicodeWidthStr::width)
            .max();
        let label = u16::try_from(label.unwrap_or(0))
            .unwrap_or(0)
            .min(WIDEST_LABEL)
            + 2;
        let room = area.width.saturating_sub(label);
        let columns = u16::try_from(open.map.columns).unwrap_or(u16::MAX).max(1);
        let fits = room / columns;
        let has_numbers = fits > number + SHADE;
        let width = match has_numbers {
            true => fits.min(WIDEST_CELL),
            false => fits.clamp(2, WIDEST_CELL),
        };
        let (above, below) = around(area);
        let tall = area.height.saturating_sub(above + below);
        let rows = u16::try_from(open.map.rows).unwrap_or(u16::MAX).max(1);
        let height = (tall / rows).clamp(1, HIGHEST_CELL);
        let seen = |cursor: usize, count: usize, room: u16| {
            let room = usize::from(room.max(1));
            let first = (cursor + 1)
                .saturating_sub(room)
                .min(count.saturating_sub(room));
            first..(first + room).min(count)
        };
        Some(Self {
            area: Rect {
                y: area.y + above.min(area.height),
                height: tall,
                ..area
            },
            label,
            width,
            height,
            columns: seen(open.cursor.0, open.map.columns, room / width),
            rows: seen(open.cursor.1, open.map.rows, tall / height),
            numbers: has_numbers,
            scale,
            decimals,
        })
    }

    fn x(&self, column: usize) -> u16 {
        let across = u16::try_from(column - self.columns.start).unwrap_or(0);
        self.area.x + self.label + across * self.width
    }

    fn y(&self, row: usize) -> u16 {
        let down = u16::try_from(row - self.rows.start).unwrap_or(0);
        self.area.y + down * self.height
    }

    /// A cell without the blank behind it.
    fn place(&self, column: usize, row: usize) -> Rect {
        let (width, height) = (self.width - 1, self.height);
        Rect::new(self.x(column), self.y(row), width, height).intersection(self.area)
    }

    fn label(&self, painter: &mut Painter, open: &OpenSweep, row: usize) {
        let label = labels(open, open.choice.down).nth(row).unwrap_or_default();
        let line = Rect::new(self.area.x, self.y(row), self.label - 1, 1);
        let indent = line
            .width
            .saturating_sub(u16::try_from(label.width()).unwrap_or(0) + 1);
        let plain = painter.theme.plain();
        painter.text(span(line, indent, line.width), label, plain);
    }

    /// The shade of a cell and, where there is room, its number.
    fn cell(&self, painter: &mut Painter, at: Rect, cell: &HeatCell, open: &OpenSweep) {
        let Some(value) = cell.value else {
            return empty(painter, at, cell);
        };
        let shade = shade::of_level(open.map.level(value));
        let style = shade::style(painter, shade);
        let shaded = if self.numbers && self.height == 1 {
            SHADE - 1
        } else {
            at.width
        };
        let bar = shade::bar(painter, shade, shaded);
        for line in 0..at.height {
            painter.text(row(at, line), &bar, style);
        }
        if self.numbers {
            let mark = if cell.failed > 0 { "!" } else { " " };
            let number = rounded(value / self.scale.factor, self.decimals);
            let number = at_right(&number, usize::from(at.width).saturating_sub(1));
            let words = format!("{number}{mark}");
            // In one line the number stands beside its shade, else above it.
            let from = if self.height == 1 { SHADE } else { 0 };
            let words: String = words.chars().skip(from.into()).collect();
            painter.text(span(row(at, 0), from, at.width), &words, style);
        } else if cell.failed > 0 {
            let warning = painter.theme.warning();
            painter.text(
                span(row(at, 0), at.width.saturating_sub(1), 1),
                "!",
                warning,
            );
        }
    }
}

/// A cell without a value: failed, or not computed.
fn empty(painter: &mut Painter, at: Rect, cell: &HeatCell) {
    let (words, style) = match (cell.failed, cell.load_cases.is_empty()) {
        (_, true) => return,
        (0, _) => ("?", painter.theme.faint()),
        _ if at.width > 6 => ("failed", painter.theme.error()),
        _ => ("!", painter.theme.error()),
    };
    painter.text(span(row(at, 0), 0, at.width), words, style);
}

/// The labels along an axis.
fn labels(open: &OpenSweep, axis: Option<usize>) -> impl Iterator<Item = &str> {
    let axis = axis.and_then(|place| open.table.axes.get(place));
    axis.into_iter()
        .flat_map(|axis| axis.values.iter().map(String::as_str))
}

/// The result, its unit, the rule for the axes that are not shown, and the axes that are.
fn title(painter: &mut Painter, area: Rect, open: &OpenSweep, grid: &Grid) {
    let Some(shown) = open.shown() else { return };
    let unit = grid.scale.unit(&shown.unit);
    let unit = if unit.is_empty() {
        "-".to_owned()
    } else {
        unit
    };
    let (strong, plain) = (painter.theme.strong(), painter.theme.plain());
    painter.text(
        row(area, 0),
        &format!("{} [{unit}]{}", shown.name, rule(open)),
        strong,
    );
    let label = |place: Option<usize>| {
        let axis: Option<&LoadCaseAxis> = place.and_then(|place| open.table.axes.get(place));
        axis.map_or("one value", |axis| &axis.label)
    };
    let axes = [("down", open.choice.down), ("across", open.choice.across)];
    for (line, (way, axis)) in (1..around(area).0 - 1).zip(axes) {
        let words = format!("{way}: {}", label(axis));
        painter.text(row(area, line), &words, plain);
    }
}

/// Lines above and below the cells.
const fn around(area: Rect) -> (u16, u16) {
    if area.height < LOW {
        AROUND_LOW
    } else {
        AROUND
    }
}

/// How the axes that are not shown are reduced.
fn rule(open: &OpenSweep) -> String {
    let (mut over, mut held) = (Vec::new(), Vec::new());
    for place in open.choice.others() {
        let axis = &open.table.axes[place];
        match open.choice.held[place] {
            Some(value) => held.push(axis.words(value)),
            None => over.push(format!("{} values of {}", axis.values.len(), axis.label)),
        }
    }
    let mut words = String::new();
    if !over.is_empty() {
        let weighted = open.table.probability.is_some() && open.choice.reduction == Reduction::Mean;
        let by = if weighted { " by probability" } else { "" };
        let rule = open.choice.reduction.word();
        words.push_str(&format!(", {rule}{by} of {}", over.join(" and ")));
    }
    if !held.is_empty() {
        words.push_str(&format!(", at {}", held.join(", ")));
    }
    words
}

/// The values of the axis across, those that have room.
fn heads(painter: &mut Painter, open: &OpenSweep, grid: &Grid) {
    let line = Rect::new(
        grid.area.x,
        grid.area.y.saturating_sub(1),
        grid.area.width,
        1,
    );
    let strong = painter.theme.strong();
    let mut free = 0;
    for (column, label) in labels(open, open.choice.across).enumerate() {
        if !grid.columns.contains(&column) {
            continue;
        }
        let width = u16::try_from(label.width()).unwrap_or(u16::MAX);
        // Numbers are at the right of their cells.
        let indent = match grid.numbers {
            true => grid.width.saturating_sub(width + 2),
            false => 0,
        };
        let from = (grid.x(column) - line.x).saturating_add(indent);
        if from < free {
            continue;
        }
        let room = if grid.numbers { grid.width - 1 } else { width };
        painter.text(span(line, from, room), label, strong);
        free = from + width.min(room) + 1;
    }
}

/// What shades and marks mean.
fn legend(painter: &mut Painter, area: Rect, open: &OpenSweep, grid: &Grid) {
    let Some((low, high)) = open.map.range else {
        return;
    };
    let unit = open.shown().map_or("", |of| &of.unit);
    let Some(place) = area
        .height
        .checked_sub(AROUND.1)
        .filter(|_| area.height >= LOW)
    else {
        return;
    };
    let line = row(area, place);
    let plain = painter.theme.plain();
    let mut rest = painter.text(line, &format!("{} ", si(low, unit)), plain);
    for shade in 0..shade::COUNT {
        let bar = shade::bar(painter, shade, 3);
        let style = shade::style(painter, shade);
        rest = painter.text(rest, &bar, style);
    }
    let marks = "   ! with failed load cases   ? not computed";
    let more = match (
        grid.columns.len() < open.map.columns,
        grid.rows.len() < open.map.rows,
    ) {
        (false, false) => "",
        _ => "   more beyond the edges",
    };
    painter.text(rest, &format!(" {}{marks}{more}", si(high, unit)), plain);
}

/// The cell under the cursor: where it is, its value with its error, and its load cases.
fn readout(painter: &mut Painter, area: Rect, open: &OpenSweep) {
    let Some(cell) = open.current() else { return };
    let axes = [
        (open.choice.down, open.cursor.1),
        (open.choice.across, open.cursor.0),
    ];
    let places = axes.into_iter().filter_map(|(axis, place)| {
        let axis = open.table.axes.get(axis?)?;
        Some(axis.words(place))
    });
    let places = places.collect::<Vec<_>>().join(", ");
    let unit = open.shown().map_or("", |of| &of.unit);
    let value = cell.value.map_or_else(
        || "no value".to_owned(),
        |value| with_error(value, cell.error, unit),
    );
    let governing = cell.governing.map_or_else(String::new, |case| {
        let error = if cell.error_of_other {
            ", error of another"
        } else {
            ""
        };
        format!("load case {}{error}; ", case + 1)
    });
    let failed = match cell.failed {
        0 => String::new(),
        failed => format!(", {failed} failed"),
    };
    let (known, count) = (cell.known, cell.load_cases.len());
    let strong = painter.theme.strong();
    let lines = [
        format!("{places}: {value}"),
        format!("{governing}{known} of {count} load cases have it{failed}; Enter lists them"),
    ];
    let first = area.height.saturating_sub(around(area).1.min(2));
    for (line, words) in (first..area.height).zip(lines) {
        painter.text(row(area, line), &words, strong);
    }
}
