//! A published number of a file that is computed without a run, and its comparison with the computed one.

use super::{ValidationRow, compare, tolerance};
use crate::case::fields::of;
use crate::case::schema::{Key, table};
use crate::case::{Evidence, Finding, Provenance};

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
        /// What an agreement with it is worth.
        kind: Evidence = Evidence::Predicted, "kind";
        /// What else the reader must know: what was fitted to it, which input it repeats.
        note: Option<String>, "note", absent "no note";
        /// Why the tolerance is what it is.
        tolerance_reason: Option<String>, "reason of the tolerance", absent "the one that the file states for all";
        /// It is of the trials that name it, with other inputs or another method than the file: they alone hold it.
        of_trials: bool = false, "of trials";
        /// Why the number is out of reach; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "within reach";
    }
}

impl PublishedNumber {
    /// The row of the validation table for what was found, with its numerical error where that is known, in this unit.
    #[must_use]
    pub fn held(&self, unit: &str, found: Result<(f64, Option<f64>), String>) -> ValidationRow {
        let tolerance = tolerance(self.value, self.tolerance_rel, self.tolerance_abs);
        let row = ValidationRow {
            published: Some(self.value),
            tolerance: Some(tolerance),
            inputs: Some(self.inputs),
            kind: self.kind.into(),
            of_trials: self.of_trials,
            note: self.note.clone(),
            tolerance_reason: self.tolerance_reason.clone(),
            ..ValidationRow::not_run(&self.name, &self.source, unit.to_owned())
        };
        compare(row, self.out_of_reach.as_deref(), found)
    }
}

/// Checks of published numbers: a known quantity, as `unknown` says, a tolerance, and trials where it is of those; `named` are the rows
/// that trials name.
pub fn check(
    list: &[(String, PublishedNumberKeys<'_>)],
    unknown: impl Fn(&Key<'_, String>) -> Option<Finding>,
    named: &[String],
) -> Vec<Finding> {
    let mut found = Vec::new();
    for (name, printed) in list {
        if printed.of_trials.is(&true) && !named.contains(name) {
            let remedy = "name it in the `rows` of a trial, or leave this out";
            found.extend(
                printed
                    .of_trials
                    .if_given("leaves it to trials, and none names it", remedy),
            );
        }
        found.extend(unknown(&printed.quantity));
        if !printed.tolerance_rel.is_given() && !printed.tolerance_abs.is_given() {
            let remedy = "add `tolerance_rel` or `tolerance_abs`";
            found.push(printed.place.finding("has no tolerance", remedy));
        }
    }
    found
}
