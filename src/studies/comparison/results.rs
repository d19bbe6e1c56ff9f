//! Every result of some runs, side by side.

use std::collections::HashMap;

use super::{ResultChange, change};
use crate::case::QuantityId;
use crate::run::{Quantity, Run};

/// A result in each run.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedResult {
    /// What identifies it.
    pub id: QuantityId,
    /// The result in each run; absent where a run has none.
    pub values: Vec<Option<Quantity>>,
    /// Each run's result less that of the first run; absent for the first run itself and where either is missing.
    pub changes: Vec<Option<ResultChange>>,
}

/// Every result that any of the runs has, in the order in which the runs have them.
pub(super) fn compare(runs: &[&Run]) -> Vec<ComparedResult> {
    let named = |run: &&Run| -> HashMap<String, Quantity> {
        let named = run.summary.iter().map(|q| (q.name(), q.clone()));
        named.collect()
    };
    let maps: Vec<HashMap<String, Quantity>> = runs.iter().map(named).collect();
    let mut list = Vec::new();
    for (index, run) in runs.iter().enumerate() {
        for quantity in &run.summary {
            let name = quantity.name();
            if maps[..index]
                .iter()
                .any(|earlier| earlier.contains_key(&name))
            {
                continue;
            }
            let values: Vec<_> = maps.iter().map(|map| map.get(&name).cloned()).collect();
            let first = values[0].as_ref();
            let others = values.iter().skip(1);
            let changes = others.map(|other| Some(change(first?, other.as_ref()?)));
            list.push(ComparedResult {
                id: quantity.id.clone(),
                changes: std::iter::once(None).chain(changes).collect(),
                values,
            });
        }
    }
    list
}
