//! Layout of a table in a width.
//!
//! Three layouts: *flat*, one line per row with long text wrapped; *stacked*, the first column on a line of its own above
//! the others; *records*, one line per cell with its heading. The shorter of the first two is used, flat where they are
//! equal; records only where neither fits. Numbers are never cut or wrapped.

use unicode_width::UnicodeWidthStr;

use super::{Align, CellStyle, Table};
use crate::wrap::{self, WideWords, narrowest, padded};

/// Blanks between columns.
const GAP: usize = 2;

/// Blanks between columns where the table does not fit otherwise.
const NARROW_GAP: usize = 1;

/// Words up to this width are never broken.
const WORD: usize = 10;

/// A table as lines.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TableLayout {
    /// The lines, from the top.
    pub lines: Vec<TableLine>,
    /// Width of the widest line.
    pub width: usize,
    /// Where the columns are side by side; empty where cells are below each other.
    pub columns: Vec<ColumnPlace>,
}

/// Where a column of a table is in its layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnPlace {
    /// Its number in the table.
    pub number: usize,
    /// The first column of text that it takes.
    pub from: usize,
    /// How many it takes.
    pub width: usize,
}

/// A line of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableLine {
    /// The part of the table it belongs to.
    pub kind: LineKind,
    /// Its text in pieces, blanks included.
    pub pieces: Vec<StyledText>,
}

/// The part of a table that a line belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// The title.
    Title,
    /// The headings of the columns.
    Head,
    /// The rule below the headings.
    Rule,
    /// A row of the table, by its number.
    Row(usize),
    /// A blank line.
    Blank,
    /// A note.
    Note,
}

/// Text of one style.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StyledText {
    /// The text, padded to its column.
    pub text: String,
    /// Its style.
    pub ink: CellStyle,
}

impl Table {
    /// Lays the table out in a width.
    #[must_use]
    pub fn layout(&self, width: usize) -> TableLayout {
        let width = width.max(1);
        let (mut lines, mut columns) = (Vec::new(), Vec::new());
        if !self.title.is_empty() {
            self.add_text(&mut lines, LineKind::Title, &self.title, width);
        }
        if !self.columns.is_empty() {
            columns = self.add_body(&mut lines, width);
        }
        if !self.notes.is_empty() {
            lines.push(blank());
        }
        for note in &self.notes {
            self.add_text(&mut lines, LineKind::Note, note, width);
        }
        let wide = |line: &TableLine| line.pieces.iter().map(|p| p.text.width()).sum();
        let width = lines.iter().map(wide).max().unwrap_or(0);
        TableLayout {
            lines,
            width,
            columns,
        }
    }

    fn add_text(&self, lines: &mut Vec<TableLine>, kind: LineKind, text: &str, width: usize) {
        lines.extend(lines_of(text, width).into_iter().map(|text| TableLine {
            kind,
            pieces: vec![plain(text)],
        }));
    }

    /// Adds heads and rows, and says where the columns are.
    fn add_body(&self, lines: &mut Vec<TableLine>, width: usize) -> Vec<ColumnPlace> {
        let all: Vec<usize> = (0..self.columns.len()).collect();
        let flat =
            ColumnGrid::fit(self, &all, width, GAP).map(|grid| (self.flat(&grid), grid.places(0)));
        let inner = width.saturating_sub(GAP);
        let stacked = || {
            let grid = ColumnGrid::fit(self, &all[1..], inner, GAP)
                .or_else(|| ColumnGrid::fit(self, &all[1..], inner, NARROW_GAP))?;
            let first = ColumnPlace {
                number: 0,
                from: 0,
                width,
            };
            let places = [vec![first], grid.places(GAP)].concat();
            Some((self.stacked(&grid, width), places))
        };
        let rows = |lines: &[TableLine]| lines.iter().filter(|line| line.is_row()).count();
        let (body, places) = match flat {
            // No layout is shorter than one line per row.
            Some((flat, places)) if rows(&flat) == self.rows.len() => (flat, places),
            Some(flat) => stacked()
                .filter(|(stacked, _)| stacked.len() < flat.0.len())
                .unwrap_or(flat),
            None => stacked().unwrap_or_else(|| (self.records(width), Vec::new())),
        };
        lines.extend(body);
        places
    }

    /// One line per row.
    fn flat(&self, grid: &ColumnGrid) -> Vec<TableLine> {
        let mut lines = Vec::new();
        grid.head(self, &mut lines);
        for row in 0..self.rows.len() {
            grid.row(self, row, 0, &mut lines);
        }
        lines
    }

    /// The first column above the others, which are indented.
    fn stacked(&self, grid: &ColumnGrid, width: usize) -> Vec<TableLine> {
        let mut lines = Vec::new();
        self.add_text(&mut lines, LineKind::Head, &self.columns[0].head, width);
        let start = lines.len();
        grid.head(self, &mut lines);
        for line in &mut lines[start..] {
            line.pieces.insert(0, plain(" ".repeat(GAP)));
        }
        for row in 0..self.rows.len() {
            let first = self.cell(row, 0);
            for text in lines_of(&first.text, width) {
                let ink = first.ink;
                lines.push(TableLine {
                    kind: LineKind::Row(row),
                    pieces: vec![StyledText { text, ink }],
                });
            }
            grid.row(self, row, GAP, &mut lines);
        }
        lines
    }

    /// One line per cell, `heading: text`, a blank line between rows.
    fn records(&self, width: usize) -> Vec<TableLine> {
        let mut lines = Vec::new();
        for row in 0..self.rows.len() {
            if row > 0 {
                lines.push(blank());
            }
            for (number, column) in self.columns.iter().enumerate() {
                let cell = self.cell(row, number);
                let ink = cell.ink;
                for text in lines_of(&format!("{}: {}", column.head, cell.text), width) {
                    lines.push(TableLine {
                        kind: LineKind::Row(row),
                        pieces: vec![StyledText { text, ink }],
                    });
                }
            }
        }
        lines
    }
}

impl TableLine {
    fn is_row(&self) -> bool {
        matches!(self.kind, LineKind::Row(_))
    }
}

/// Columns side by side.
struct ColumnGrid {
    /// Blanks between them.
    gap: usize,
    columns: Vec<GridColumn>,
}

/// A column with its number in the table and its measures.
struct GridColumn {
    number: usize,
    align: Align,
    width: usize,
    /// Columns from the decimal point on.
    after: usize,
}

impl ColumnGrid {
    /// The columns reduced to a width; `None` where they do not fit.
    fn fit(table: &Table, numbers: &[usize], width: usize, gap: usize) -> Option<Self> {
        let mut columns: Vec<GridColumn> = numbers.iter().map(|n| measure(table, *n)).collect();
        let least: Vec<usize> = columns.iter().map(|c| least(table, c)).collect();
        let gaps = gap * columns.len().saturating_sub(1);
        let total = |columns: &[GridColumn]| columns.iter().map(|c| c.width).sum::<usize>() + gaps;
        while total(&columns) > width {
            // Shrinks the widest of those that can.
            let candidates = columns.iter_mut().zip(&least);
            let shrinking = candidates.filter(|(column, least)| column.width > **least);
            let (column, _) = shrinking.max_by_key(|(column, _)| column.width)?;
            column.width -= 1;
        }
        Some(Self { gap, columns })
    }

    /// Where the columns are, behind so many blanks.
    fn places(&self, indent: usize) -> Vec<ColumnPlace> {
        let mut from = indent;
        let each = self.columns.iter().map(|column| {
            let place = ColumnPlace {
                number: column.number,
                from,
                width: column.width,
            };
            from += column.width + self.gap;
            place
        });
        each.collect()
    }

    /// The headings, bottom-aligned, and a rule.
    fn head(&self, table: &Table, lines: &mut Vec<TableLine>) {
        let heads: Vec<Vec<String>> = self
            .columns
            .iter()
            .map(|column| lines_of(&table.columns[column.number].head, column.width))
            .collect();
        let rows = heads.iter().map(Vec::len).max().unwrap_or(0);
        for row in 0..rows {
            let pieces = self.columns.iter().zip(&heads).map(|(column, head)| {
                let skipped = rows - head.len();
                let text = row.checked_sub(skipped).and_then(|i| head.get(i));
                let text = text.map_or("", String::as_str);
                let before = match column.align {
                    Align::Left => 0,
                    Align::Right | Align::Decimal => column.width.saturating_sub(text.width()),
                };
                plain(padded(text, before, column.width))
            });
            lines.push(TableLine {
                kind: LineKind::Head,
                pieces: self.gapped(pieces),
            });
        }
        let rules = self.columns.iter().map(|c| plain("-".repeat(c.width)));
        lines.push(TableLine {
            kind: LineKind::Rule,
            pieces: self.gapped(rules),
        });
    }

    /// A row, of as many lines as its tallest cell.
    fn row(&self, table: &Table, row: usize, indent: usize, lines: &mut Vec<TableLine>) {
        let cells: Vec<(Vec<String>, CellStyle)> = self
            .columns
            .iter()
            .map(|column| {
                let cell = table.cell(row, column.number);
                (column.set(&cell.text), cell.ink)
            })
            .collect();
        let height = cells.iter().map(|(set, _)| set.len()).max().unwrap_or(0);
        for line in 0..height {
            let pieces = self.columns.iter().zip(&cells).map(|(column, (set, ink))| {
                let empty = || " ".repeat(column.width);
                StyledText {
                    text: set.get(line).cloned().unwrap_or_else(empty),
                    ink: *ink,
                }
            });
            let mut pieces = self.gapped(pieces);
            if indent > 0 {
                pieces.insert(0, plain(" ".repeat(indent)));
            }
            lines.push(TableLine {
                kind: LineKind::Row(row),
                pieces,
            });
        }
    }

    fn gapped(&self, pieces: impl Iterator<Item = StyledText>) -> Vec<StyledText> {
        let mut row = Vec::new();
        for piece in pieces {
            if !row.is_empty() {
                row.push(plain(" ".repeat(self.gap)));
            }
            row.push(piece);
        }
        row
    }
}

impl GridColumn {
    /// A cell's text in lines of the column's width.
    fn set(&self, text: &str) -> Vec<String> {
        match self.align {
            Align::Left => lines_of(text, self.width)
                .iter()
                .map(|line| padded(line, 0, self.width))
                .collect(),
            Align::Right => vec![padded(
                text,
                self.width.saturating_sub(text.width()),
                self.width,
            )],
            Align::Decimal => {
                let room = self.width.saturating_sub(text.width());
                let at = self.width.saturating_sub(self.after);
                // Words among numbers are right-aligned.
                let before = point(text).map_or(room, |point| at.saturating_sub(point));
                vec![padded(text, before.min(room), self.width)]
            }
        }
    }
}

/// A column at its width without wrapping.
fn measure(table: &Table, number: usize) -> GridColumn {
    let column = &table.columns[number];
    let texts = CellTexts::of_column(table, number);
    let body = match column.align {
        Align::Decimal => texts.words.max(texts.before + texts.after),
        Align::Left | Align::Right => texts.widest,
    };
    GridColumn {
        number,
        align: column.align,
        width: body.max(column.head.width()),
        after: texts.after,
    }
}

/// Least width of a column: text and headings wrap, numbers do not.
fn least(table: &Table, column: &GridColumn) -> usize {
    let texts = CellTexts::of_column(table, column.number);
    let body = match column.align {
        Align::Left => texts.least,
        Align::Right => texts.widest,
        Align::Decimal => texts.words.max(texts.before + texts.after),
    };
    let head = narrowest(&table.columns[column.number].head, WORD);
    head.max(body).max(1)
}

/// Measures of the cells of a column.
#[derive(Default)]
struct CellTexts {
    /// Widest cell.
    widest: usize,
    /// Widest part that is never broken.
    least: usize,
    /// Widest part before a decimal point.
    before: usize,
    /// Widest part from a decimal point on.
    after: usize,
    /// Widest cell without a number.
    words: usize,
}

impl CellTexts {
    fn of_column(table: &Table, number: usize) -> Self {
        let mut all = Self::default();
        for row in 0..table.rows.len() {
            let text = table.cell(row, number).text;
            let wide = text.width();
            all.widest = all.widest.max(wide);
            all.least = all.least.max(narrowest(&text, WORD));
            match point(&text) {
                Some(point) => {
                    all.before = all.before.max(point);
                    all.after = all.after.max(wide - point);
                }
                None => all.words = all.words.max(wide),
            }
        }
        all
    }
}

/// Columns before the decimal point (or the end) of the first number of a text.
fn point(text: &str) -> Option<usize> {
    let first = text.find(|c: char| c.is_ascii_digit())?;
    let digits = text[first..].find(|c: char| !c.is_ascii_digit());
    let end = digits.map_or(text.len(), |digits| first + digits);
    Some(text[..end].width())
}

fn plain(text: String) -> StyledText {
    StyledText {
        text,
        ink: CellStyle::Plain,
    }
}

fn blank() -> TableLine {
    TableLine {
        kind: LineKind::Blank,
        pieces: Vec::new(),
    }
}

fn lines_of(text: &str, width: usize) -> Vec<String> {
    wrap::wrap(text, width, WideWords::BrokenUnlessNumbers)
}
