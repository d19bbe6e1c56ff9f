//! A published number by the name of its result, and its comparison with the computed one.

use super::{ValidationRow, compare, tolerance};
use crate::case::fields::of;
use crate::case::schema::{Key, table};
use crate::case::{
    Evidence, Finding, Provenance, Published, QuantityId, StudyKeys, StudyPoint, of_study_point,
    two_others,
};

table! {
    /// A published value and its comparison with the computed one.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PublishedNumber => PublishedNumberKeys {
        /// What it is, in words.
        name: String, "name";
        /// The quantity, such as model.max_tension_n or pitch.velocity.rms.
        quantity: String, "quantity";
        /// Another quantity of the same computation that it is divided by.
        divided_by: Option<String>, "divided by", absent "not used";
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
    tables {
        /// The point of a study this row belongs to.
        at: Option<StudyPoint>;
        /// The point of a study from which this row's value is the change.
        change_from: Option<StudyPoint>;
        /// The point of a study by which this row's value is divided.
        ratio_to: Option<StudyPoint>;
    }
}

impl PublishedNumber {
    /// Whether it is the ratio of two numbers.
    #[must_use]
    pub fn is_ratio(&self) -> bool {
        self.divided_by.is_some() || self.ratio_to.is_some()
    }

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
            at: self.at.clone(),
            from: self.change_from.clone(),
            by: self.ratio_to.clone(),
            tolerance_reason: self.tolerance_reason.clone(),
            ..ValidationRow::not_run(&self.name, &self.source, unit.to_owned())
        };
        compare(row, self.out_of_reach.as_deref(), found)
    }
}

impl Published {
    /// The same by the name of its result.
    #[must_use]
    pub fn number(&self) -> PublishedNumber {
        let name = |within| {
            let id = QuantityId::new(self.channel.clone(), self.statistic, within);
            id.numbered(self.nth).to_string()
        };
        PublishedNumber {
            name: self.name.clone(),
            quantity: name(self.within()),
            divided_by: self.by_stretch_m.map(|stretch| name(Some(stretch))),
            value: self.value,
            tolerance_rel: self.tolerance_rel,
            tolerance_abs: self.tolerance_abs,
            source: self.source.clone(),
            inputs: self.inputs,
            kind: self.kind,
            note: self.note.clone(),
            tolerance_reason: self.tolerance_reason.clone(),
            of_trials: false,
            out_of_reach: self.out_of_reach.clone(),
            at: self.at.clone(),
            change_from: self.change_from.clone(),
            ratio_to: self.ratio_to.clone(),
        }
    }
}

/// Checks of published numbers: known quantities, as `unknown` says, a tolerance, points of the studies of the file, and trials where it is
/// of those; `named` are the rows that trials name.
pub fn check(
    list: &[(String, PublishedNumberKeys<'_>)],
    unknown: impl Fn(&Key<'_, String>) -> Option<Finding>,
    studies: &[(String, StudyKeys<'_>)],
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
        found.extend(unknown(&printed.divided_by));
        found.extend(one_other(printed));
        let points = [&printed.at, &printed.change_from, &printed.ratio_to];
        let points = points.into_iter().flatten();
        found.extend(points.filter_map(|at| of_study_point(studies, at)));
        if !printed.tolerance_rel.is_given() && !printed.tolerance_abs.is_given() {
            let remedy = "add `tolerance_rel` or `tolerance_abs`";
            found.push(printed.place.finding("has no tolerance", remedy));
        }
    }
    found
}

/// A row is a change, a ratio to another point, or a ratio to another quantity; no two of them.
fn one_other(row: &PublishedNumberKeys<'_>) -> Option<Finding> {
    two_others(&row.place, ["divided_by", "ratio_to", "change_from"])
}
