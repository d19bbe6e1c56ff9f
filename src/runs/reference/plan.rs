//! Which variants of a case its published statements need, and how one is made.

use crate::case::{Case, StudyPoint};

/// The distinct variants that the published values and trends of a case need, `None` being the case
/// without a study; in the order in which the file asks for them.
#[must_use]
pub fn plan(case: &Case) -> Vec<Option<StudyPoint>> {
    let mut variants: Vec<Option<StudyPoint>> = Vec::new();
    let mut need = |at: Option<StudyPoint>| {
        if !variants.contains(&at) {
            variants.push(at);
        }
    };
    for published in &case.published {
        need(published.at.clone());
        for other in [&published.change_from, &published.ratio_to] {
            if other.is_some() {
                need(other.clone());
            }
        }
    }
    for curve in &case.published_curve {
        need(curve.at.clone());
    }
    for trend in &case.trend {
        let study = case.study.iter().find(|s| s.name == trend.study);
        for value in study.map_or(&[][..], |s| &s.values) {
            need(Some(StudyPoint {
                study: trend.study.clone(),
                value: value.clone(),
            }));
        }
    }
    variants
}
