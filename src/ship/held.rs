//! A ship's motion held against what its source printed: rows of the validation table.

use super::model::Published;
use super::quantities::{quantity, unit};
use super::rest::Rest;
use crate::reference::{Claim, Row, hold, tolerance};

/// Rows for every published value of a ship, in the order of its file.
#[must_use]
pub fn rows(rest: &Rest) -> Vec<Row> {
    let published = rest.ship.published.iter();
    published.map(|published| row(rest, published)).collect()
}

fn row(rest: &Rest, published: &Published) -> Row {
    let found = match &rest.voyage {
        None => Err("The file has no [motion].".to_owned()),
        Some(Err(why)) => Err(format!("There is no such motion: {why}.")),
        Some(Ok(voyage)) => quantity(voyage, &published.quantity)
            .ok_or_else(|| format!("There is no quantity {}.", published.quantity)),
    };
    let claim = Claim {
        name: &published.name,
        source: &published.source,
        value: published.value,
        tolerance: tolerance(
            published.value,
            published.tolerance_rel,
            published.tolerance_abs,
        ),
        unit: unit(&published.quantity).to_owned(),
        inputs: published.inputs,
        fitted: published.fitted,
        basis: None,
        at: None,
        from: None,
        by: None,
        out_of_reach: published.out_of_reach.as_deref(),
    };
    // A record is summed to rounding.
    hold(claim, found.map(|value| (value, Some(0.0))))
}
