//! A published number of a file that is computed without a run, and its comparison with the computed one.

use super::{ReferenceValue, ValidationRow, compare, tolerance};
use crate::case::fields::of;
use crate::case::schema::table;
use crate::case::{InvalidValue, Provenance};

table! {
    /// A published value and its comparison with the computed one.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PublishedNumber => PublishedNumberKeys {
        /// What it is, in words.
        name: String, "name";
        /// The quantity, such as model.max_tension_n or pitch.velocity.rms.
        quantity: String, "quantity";
        /// The published value, in the unit of the quantity.
        value: f64, "value", unit "";
        /// Tolerance relative to the value; of two tolerances the wider one counts.
        tolerance_rel: Option<f64>, "tolerance", range of(0.0, 10.0), absent "no relative tolerance";
        /// Tolerance in the unit of the value.
        tolerance_abs: Option<f64>, "tolerance", unit "", range of(0.0, f64::INFINITY), absent "no absolute tolerance";
        /// Where it is printed.
        source: String, "source";
        /// Provenance of the inputs behind the computed value, at worst.
        inputs: Provenance, "inputs";
        /// True when an input was fitted to this very number: agreement is then no evidence.
        fitted: bool = false, "fitted";
        /// Why the number is out of reach; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "within reach";
    }
}

impl PublishedNumber {
    /// The row of the validation table for what was found, with its numerical error where that is known, in this unit.
    #[must_use]
    pub fn held(&self, unit: &str, found: Result<(f64, Option<f64>), String>) -> ValidationRow {
        let reference = ReferenceValue {
            name: &self.name,
            source: &self.source,
            value: self.value,
            tolerance: tolerance(self.value, self.tolerance_rel, self.tolerance_abs),
            unit: unit.to_owned(),
            inputs: self.inputs,
            fitted: self.fitted,
            basis: None,
            at: None,
            from: None,
            by: None,
            out_of_reach: self.out_of_reach.as_deref(),
        };
        compare(reference, found)
    }
}

/// What is wrong with such a list: values without tolerance, and what `unknown` says of their quantities (problem and
/// remedy). Tables of a list go by their name, or by their number where a name is taken.
pub(crate) fn invalid_values(
    list: &[PublishedNumber],
    unknown: impl Fn(&str) -> Option<(String, String)>,
) -> Vec<InvalidValue> {
    let mut wrong = Vec::new();
    for (i, printed) in list.iter().enumerate() {
        let taken = list.iter().take(i).any(|p| p.name == printed.name);
        let name = if taken {
            (i + 1).to_string()
        } else {
            printed.name.clone()
        };
        if let Some((problem, remedy)) = unknown(&printed.quantity) {
            wrong.push(InvalidValue::new(
                &["published", &name, "quantity"],
                problem,
                remedy,
            ));
        }
        if printed.tolerance_rel.is_none() && printed.tolerance_abs.is_none() {
            wrong.push(InvalidValue::new(
                &["published", &name],
                "has no tolerance",
                "add `tolerance_rel` or `tolerance_abs`",
            ));
        }
    }
    wrong
}
