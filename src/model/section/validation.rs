//! A cross-section compared with its published values: rows of the validation table.

use super::design::Design;
use super::quantities::find;
use crate::published::ValidationRow;

/// A row for every published value, in the order of the file. What is computed is a closed form, exact to rounding.
#[must_use]
pub fn rows(design: &Design) -> Vec<ValidationRow> {
    let computed = |name: &str| {
        let quantity = find(name).ok_or_else(|| format!("There is no quantity `{name}`."))?;
        let value = quantity.value(design);
        let value =
            value.ok_or_else(|| format!("The section has no `{name}`: no strength is known."))?;
        Ok((value, Some(0.0)))
    };
    let common = design.section.about.tolerance_reason.as_deref();
    let published = design.section.published.iter();
    published
        .map(|printed| {
            let unit = find(&printed.quantity).map_or("", |quantity| quantity.unit);
            printed.held(unit, computed(&printed.quantity))
        })
        .map(|row| row.with_common_reason(common))
        .collect()
}
