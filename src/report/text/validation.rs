//! Published values against a run: the table, and below it what no column has room for.

use super::layout::{Page, WIDTH};
use crate::{
    case::{Direction, Standing},
    reference::{self, Outcome, Row, TrendLine},
    report::number::with_error,
};

/// The validation table on 80 columns, notes to every row, and the tally.
#[must_use]
pub fn validation(rows: &[Row]) -> String {
    let mut page = Page::default();
    page.block(&reference::table(rows).to_text(WIDTH));
    page.line("");
    for (i, row) in rows.iter().enumerate() {
        page.hanging(&format!("[{}] ", i + 1), &note(row));
    }
    page.line("");
    page.line(&reference::tally(rows).to_string());
    page.finish()
}

/// Where a row is printed, what stands behind it, why it is as it is.
fn note(row: &Row) -> String {
    let mut words = format!("{}.", row.name.trim_end_matches('.'));
    if let Some(at) = &row.at {
        words.push_str(&format!(" At {} = {}.", at.study, at.value));
    }
    if !row.source.is_empty() {
        words.push_str(&format!(
            " Printed in {}.",
            row.source.trim_end_matches('.')
        ));
    }
    if let Some(line) = &row.trend {
        words.push_str(&format!(" {}", along(line, &row.unit)));
    }
    words.push_str(match (row.fitted, row.inputs) {
        (true, _) => " An input was fitted to this very number: agreement is no evidence.",
        (false, Some(Standing::Calibrated)) => {
            " Inputs are calibrated on other numbers; this one is a prediction."
        }
        (false, _) => "",
    });
    if let Some(reason) = &row.reason {
        let colon = if row.outcome == Outcome::Differs {
            " It differs because:"
        } else {
            ""
        };
        words.push_str(&format!("{colon} {}", reason.trim()));
    }
    words
}

/// The numbers along a study.
fn along(line: &TrendLine, unit: &str) -> String {
    let expect = match line.expect {
        Direction::Rises => "Should rise",
        Direction::Falls => "Should fall",
    };
    let points: Vec<String> = line
        .points
        .iter()
        .map(|p| match p.computed {
            Some(computed) => format!("{}: {}", p.value, with_error(computed, p.error, unit)),
            None => format!("{}: not run", p.value),
        })
        .collect();
    format!("{expect} along {}: {}.", line.key, points.join("; "))
}

/// Says of a single run that its case has rows for other variants.
pub(super) fn unrun(page: &mut Page, rows: &[Row]) {
    let count = reference::tally(rows).not_run;
    if count > 0 {
        page.line("");
        page.paragraph(
            "Rows that read NOT RUN belong to other variants of the case, or to numbers this run does \
             not hold; `seacable validate` computes them all.",
        );
    }
}
