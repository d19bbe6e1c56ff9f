//! Which variants of a case its published statements need.

use super::StatementsOfCase;
use crate::case::{Case, StudyPoint};

/// The distinct variants that the published values, trends and curves of a case need, `None` being the case without a study; in the order
/// in which the file asks for them.
#[must_use]
pub fn plan(case: &Case) -> Vec<Option<StudyPoint>> {
    StatementsOfCase::new(case).stated().plan()
}
