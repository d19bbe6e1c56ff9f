//! The files that are of no paper: a line each, and the rows of theirs that differ.

use super::{JudgedPaper, is_of_a_paper};
use crate::document::Block;
use seacable_display::table::{Align, Cell, CellStyle, Table};
use seacable_runs::reference::papers::FileRows;
use seacable_runs::reference::{Outcome, ValidationRow, table};

pub(super) fn blocks(files: &[FileRows<'_>], papers: &[JudgedPaper<'_>]) -> Vec<Block> {
    let beside: Vec<&FileRows<'_>> = files
        .iter()
        .filter(|file| !is_of_a_paper(file.file, papers) && !file.rows.is_empty())
        .collect();
    if beside.is_empty() {
        return Vec::new();
    }
    let table = Table::of_records("", &beside)
        .text("file", |file| file.file.to_owned())
        .cell("rows", Align::Right, |file| {
            Cell::plain(file.rows.len().to_string())
        })
        .cell("PASS", Align::Right, |file| {
            let passed = file
                .rows
                .iter()
                .filter(|row| row.outcome == Outcome::Pass)
                .count();
            let ink = if passed == file.rows.len() {
                CellStyle::Good
            } else {
                CellStyle::Warn
            };
            Cell::new(passed.to_string(), ink)
        })
        .cell("farthest off, in tolerances", Align::Right, |file| {
            let off = file.rows.iter().filter_map(ValidationRow::in_tolerances);
            off.reduce(f64::max)
                .map_or_else(Cell::none, |off| Cell::plain(format!("{off:.2}")))
        })
        .text("kinds", |file| kinds(file.rows))
        .build();
    let mut blocks = vec![
        Block::Heading("Other programs, measurements, closed forms".to_owned()),
        Block::Table(table),
    ];
    blocks.extend(differing(&beside));
    blocks
}

fn kinds(rows: &[ValidationRow]) -> String {
    let mut words: Vec<&str> = rows.iter().map(|row| row.kind.word()).collect();
    words.sort_unstable();
    words.dedup();
    words.join(", ")
}

fn differing(files: &[&FileRows<'_>]) -> Option<Block> {
    let rows = files
        .iter()
        .flat_map(|file| file.rows.iter().map(|row| (file.file, row)));
    let off: Vec<(usize, (&str, &ValidationRow))> = (1..)
        .zip(rows.filter(|(_, row)| row.outcome != Outcome::Pass))
        .collect();
    if off.is_empty() {
        return None;
    }
    let notes = off.iter().filter_map(|(number, (_, row))| {
        let reason = row.reason.as_ref()?;
        Some(format!("[{number}] {}", reason.trim()))
    });
    let table = Table::of_records("Rows of these that are outside their tolerance", &off)
        .text("row", |(number, (file, row))| {
            format!("[{number}] {file}: {}", row.name)
        })
        .cell("outcome", Align::Left, |(_, (_, row))| {
            Cell::plain(row.outcome.word())
        })
        .cell("computed", Align::Right, |(_, (_, row))| {
            table::computed(row)
        })
        .cell("% off", Align::Right, |(_, (_, row))| table::percent(row))
        .build()
        .noted(notes);
    Some(Block::Table(table))
}
