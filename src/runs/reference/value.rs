//! The comparison of a published number with the results of its file.

use super::stated::ResultsAt;
use crate::case::{Evidence, Provenance};
use crate::published::{CalibrationBasis, ComputedNumber, PublishedNumber, RowKind, ValidationRow};

/// The row of a number, one of all that its file states.
pub(super) fn row(
    printed: &PublishedNumber,
    all: &[PublishedNumber],
    results: &dyn ResultsAt,
) -> ValidationRow {
    let found = found(printed, results).map(|number| (number.value, number.error));
    let unit = match printed.is_ratio() {
        true => "-".to_owned(),
        false => results.unit(&printed.quantity),
    };
    let basis = basis(printed, all);
    let kind = match basis {
        Some(CalibrationBasis::FittedNearby) => RowKind::Fitted,
        _ => printed.kind.into(),
    };
    ValidationRow {
        kind,
        basis,
        ..printed.held(&unit, found)
    }
}

/// The number at the row's point or, of a change or a ratio, what it is against the other.
fn found(printed: &PublishedNumber, results: &dyn ResultsAt) -> Result<ComputedNumber, String> {
    let here = printed.at.as_ref();
    let number = results.number(here, &printed.quantity)?;
    if let Some(other) = &printed.divided_by {
        return Ok(number.ratio_to(&results.number(here, other)?));
    }
    if let Some(point) = &printed.ratio_to {
        let other = results.number(Some(point), &printed.quantity)?;
        return Ok(number.ratio_to(&other));
    }
    match &printed.change_from {
        None => Ok(number),
        Some(point) => {
            let before = results.number(Some(point), &printed.quantity)?;
            Ok(number.change_from(&before))
        }
    }
}

/// How far an agreement is evidence, given everything the file was fitted to.
fn basis(printed: &PublishedNumber, all: &[PublishedNumber]) -> Option<CalibrationBasis> {
    let same = |other: &PublishedNumber| {
        other.quantity == printed.quantity
            && other.divided_by == printed.divided_by
            && other.change_from == printed.change_from
            && other.ratio_to == printed.ratio_to
            && other.at == printed.at
    };
    if printed.kind == Evidence::Fitted {
        Some(CalibrationBasis::Fitted)
    } else if all
        .iter()
        .any(|other| other.kind == Evidence::Fitted && same(other))
    {
        Some(CalibrationBasis::FittedNearby)
    } else {
        (printed.inputs == Provenance::Calibrated).then_some(CalibrationBasis::Prediction)
    }
}
