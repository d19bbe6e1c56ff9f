//! Published values against a run: the table with its notes, and the tally.

use super::WIDTH;
use crate::document::Report;
use seacable_display::chart::Glyphs;
use seacable_runs::reference::{self, ValidationRow};

/// The validation table on 80 columns, a note to every row, and the tally.
#[must_use]
pub fn validation(rows: &[ValidationRow]) -> String {
    let mut page = Report::default();
    add_validation(&mut page, rows);
    page.to_text(WIDTH, Glyphs::Braille)
}

/// Adds the validation table, a note to every row, and the tally.
pub fn add_validation(page: &mut Report, rows: &[ValidationRow]) {
    page.close_table(reference::table(rows));
    page.gap();
    page.paragraph(&reference::count_outcomes(rows).to_string());
}

/// Says of a single run that its case has rows for other variants, and why edited inputs are not judged.
pub(super) fn not_judged(page: &mut Report, rows: &[ValidationRow]) {
    let counts = reference::count_outcomes(rows);
    if counts.edited > 0 {
        page.gap();
        page.paragraph(
            "Rows that read EDITED are not judged: their published values are for other inputs than this run has.",
        );
    }
    if counts.not_run > 0 {
        page.gap();
        page.paragraph(
            "Rows that read NOT RUN belong to other variants of the case, or to numbers this run does \
             not hold; `seacable validate` computes them all.",
        );
    }
}
