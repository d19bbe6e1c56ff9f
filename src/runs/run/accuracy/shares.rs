//! Estimated errors of results as shares of what is asked of them.

use crate::numerics::richardson::OBSERVED;
use crate::run::compute::Computed;
use crate::run::result_scale::ResultScales;
use crate::run::{Quantity, QuantityId};

/// Share of the results that must be as accurate as asked.
const WITHIN: f64 = 0.95;

/// What every result that counts may err by.
pub(super) struct AllowedErrors(Vec<(QuantityId, f64)>);

impl AllowedErrors {
    /// Of a run over this time \[s\].
    pub(super) fn of_run(
        duration_s: f64,
        run: &Computed,
        summary: &[Quantity],
        accuracy: f64,
    ) -> Self {
        let scales = ResultScales {
            duration_s,
            summary,
            history: &run.record.history,
        };
        let allowed = summary
            .iter()
            .filter_map(|q| Some((q.id.clone(), accuracy * scales.scale_of_result(q)?)));
        Self(allowed.collect())
    }
}

/// Errors of results by what is asked of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shares {
    /// Of the results that count, from the smallest to the greatest.
    pub(super) all: Vec<(f64, String)>,
    pub(super) time: f64,
    pub(super) mesh: f64,
}

impl Shares {
    /// Of results that have so many errors, of steps and of mesh: each may be as large a part of what is asked.
    pub(super) fn of_results(parts: f64, allowed: &AllowedErrors, summary: &[Quantity]) -> Self {
        let counted = allowed.0.iter().filter_map(|(id, allowed)| {
            let q = summary.iter().find(|q| q.id == *id)?;
            Some((q, *allowed, q.expected_error()? / allowed))
        });
        let counted: Vec<_> = counted.filter(|(.., share)| share.is_finite()).collect();
        let mut all: Vec<_> = counted
            .iter()
            .map(|(q, _, share)| (*share, q.name()))
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let part = |error: fn(&Quantity) -> Option<f64>| {
            let shares = counted
                .iter()
                .filter_map(|(q, allowed, _)| Some(parts * error(q)? / (OBSERVED * allowed)));
            let mut shares: Vec<f64> = shares.collect();
            shares.sort_by(f64::total_cmp);
            quantile(&shares)
        };
        Self {
            time: part(|q| q.time_error),
            mesh: part(|q| q.mesh_error),
            all,
        }
    }

    /// The share that [`WITHIN`] of the results reach.
    pub(super) fn reached(&self) -> f64 {
        let shares: Vec<f64> = self.all.iter().map(|(share, _)| *share).collect();
        quantile(&shares)
    }

    /// Results that are not as accurate as asked, the worst first.
    pub(super) fn missed(&self) -> impl Iterator<Item = &(f64, String)> {
        self.all.iter().rev().take_while(|(share, _)| *share > 1.0)
    }
}

/// The least of these sorted numbers that [`WITHIN`] of them do not exceed; zero of none.
pub(super) fn quantile(sorted: &[f64]) -> f64 {
    let count = (WITHIN * sorted.len() as f64).ceil() as usize;
    count.checked_sub(1).map_or(0.0, |last| sorted[last])
}
