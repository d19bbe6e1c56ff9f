//! How many numbers a matrix has.

use crate::case::{Finding, schema::Key};

pub(super) fn matrix(key: &Key<'_, Vec<f64>>, lengths: &[usize], wanted: &str) -> Option<Finding> {
    let numbers = key.given()?;
    (!lengths.contains(&numbers.len())).then(|| {
        let problem = format!("has {} numbers", numbers.len());
        key.finding(problem, format!("give {wanted}"))
    })
}
