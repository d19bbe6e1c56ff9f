//! Published values against a run: the table with its notes, and the tally.

use super::layout::{Page, WIDTH};
use crate::reference::{self, ValidationRow};

/// The validation table on 80 columns, a note to every row, and the tally.
#[must_use]
pub fn validation(rows: &[ValidationRow]) -> String {
    let mut page = Page::default();
    page.block(&reference::table(rows).to_text(WIDTH));
    page.line("");
    page.line(&reference::count_outcomes(rows).to_string());
    page.finish()
}

/// Says of a single run that its case has rows for other variants, and why edited inputs are not judged.
pub(super) fn not_judged(page: &mut Page, rows: &[ValidationRow]) {
    let counts = reference::count_outcomes(rows);
    if counts.edited > 0 {
        page.line("");
        page.paragraph(
            "Rows that read EDITED are not judged: their published values are for other inputs than this run has.",
        );
    }
    if counts.not_run > 0 {
        page.line("");
        page.paragraph(
            "Rows that read NOT RUN belong to other variants of the case, or to numbers this run does \
             not hold; `seacable validate` computes them all.",
        );
    }
}
