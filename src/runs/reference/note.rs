//! The note of a row of the validation table.

use super::{Outcome, TrendLine, ValidationRow};
use crate::{
    case::{Direction, Provenance},
    number::with_error,
};

/// Source, variant, basis and reason of a row.
pub(super) fn note(row: &ValidationRow) -> String {
    let mut words = Vec::new();
    if !row.source.is_empty() {
        words.push(sentence(&row.source));
    }
    if let Some(at) = &row.at {
        words.push(format!("Computed at {} = {}.", at.study, at.value));
    }
    if let Some(from) = &row.from {
        words.push(format!("The change from {} = {}.", from.study, from.value));
    }
    if let Some(by) = &row.by {
        words.push(format!("The ratio to {} = {}.", by.study, by.value));
    }
    if let Some(line) = &row.trend {
        words.push(along(line, &row.unit));
    }
    if let Some(basis) = row.basis {
        words.push(basis.words().to_owned());
    }
    if let Some(standing @ (Provenance::Calibrated | Provenance::Assumed)) = row.inputs {
        words.push(format!("* Inputs: {}.", standing.name()));
    }
    if let Some(note) = &row.note {
        words.push(sentence(note));
    }
    if let Some(reason) = &row.tolerance_reason {
        words.push(format!("Tolerance: {}", sentence(reason)));
    }
    if let Some(reason) = &row.reason {
        let differs = if row.outcome == Outcome::Differs {
            "Why it differs: "
        } else {
            ""
        };
        words.push(format!("{differs}{}", reason.trim()));
    }
    capitalised(&words.join(" "))
}

/// A text with the full stop that it may lack.
fn sentence(text: &str) -> String {
    format!("{}.", text.trim().trim_end_matches('.'))
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters
        .next()
        .map(|c| c.to_uppercase().to_string())
        .unwrap_or_default();
    first + letters.as_str()
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
