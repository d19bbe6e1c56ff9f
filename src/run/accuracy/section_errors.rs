//! On which sections of the line the mesh error is made, and how fine each is best for the least segments together.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use super::shares::AllowedErrors;
use crate::case::{Case, Method};
use crate::run::RunState;
use crate::run::compute::{Computed, Resolution, compute};

/// What each section has of the mesh error, all together one; none of a line of one section, and where a run is not complete.
///
/// Of every section a run is computed with segments twice as long on it alone, or half as long where it cannot be coarser, in
/// steps four times as long where they may be: its difference is the section's.
pub(super) fn section_errors(
    case: &Case,
    allowed: &AllowedErrors,
    cancel: &AtomicBool,
) -> Option<Vec<f64>> {
    if case.line.len() < 2 {
        return None;
    }
    let all = (0..=case.line.len()).into_par_iter().map(|number| {
        let (case, weight) = number.checked_sub(1).map_or_else(
            || (case.clone(), 0.0),
            |section| with_other_segments(case, section),
        );
        Some((complete(&case, cancel)?, weight))
    });
    let runs: Vec<(Computed, f64)> = all.collect::<Option<_>>()?;
    let (whole, parts) = runs.split_first()?;
    let errors = parts
        .iter()
        .map(|(part, weight)| weight * allowed.difference(part, &whole.0));
    let errors: Vec<f64> = errors.collect();
    let sum: f64 = errors.iter().sum();
    (sum > 0.0 && sum.is_finite()).then(|| errors.iter().map(|error| error / sum).collect())
}

/// The case with a section twice as coarse, or twice as fine where it is one segment or bears clumps. By which its difference counts: the
/// finer mesh has a quarter of the error of this one, the coarser four times as much.
fn with_other_segments(case: &Case, section: usize) -> (Case, f64) {
    let mut case = case.clone();
    let bears = case
        .clumps
        .iter()
        .any(|clump| clump.section == case.line[section].name);
    let segments = &mut case.line[section].segments;
    if bears || *segments == 1 {
        *segments *= 2;
        return (case, 4.0);
    }
    *segments = segments.div_ceil(2);
    (case, 1.0)
}

fn complete(case: &Case, cancel: &AtomicBool) -> Option<Computed> {
    // Explicit steps four times as long are not stable.
    let step_ratio = match case.solver.method {
        Method::Rk4 | Method::Static => 1.0,
        _ => 4.0,
    };
    let resolution = Resolution {
        coarsening: 1,
        step_ratio,
    };
    let run = compute(case, resolution, None, cancel, &mut |_| {});
    (run.outcome.state == RunState::Done).then_some(run)
}

/// By how many times each section has more segments, so that errors which fall by this order add up to one with the least segments:
/// Lagrange's condition, with none coarser and none finer than `most`.
pub(super) fn factors(errors: &[f64], segments: &[usize], order: f64, most: f64) -> Vec<f64> {
    let each = |lambda: f64| {
        let pairs = errors.iter().zip(segments);
        let factor = move |(error, count): (&f64, &usize)| {
            (lambda * (error / *count as f64).powf(1.0 / (order + 1.0))).clamp(1.0, most)
        };
        pairs.map(factor).collect::<Vec<f64>>()
    };
    let left = |factors: &[f64]| -> f64 {
        let pairs = errors.iter().zip(factors);
        pairs
            .map(|(error, factor)| error * factor.powf(-order))
            .sum()
    };
    let (mut low, mut high) = (0.0, 1.0);
    while left(&each(high)) > 1.0 && high < 1e12 {
        high *= 2.0;
    }
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if left(&each(middle)) > 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    each(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_section_without_error_stays_as_it_is() {
        let found = factors(&[4.0, 0.0], &[10, 10], 2.0, 3.0);
        assert!(
            (found[0] - 2.0).abs() < 1e-9 && found[1] == 1.0,
            "{found:?}"
        );
        assert_eq!(factors(&[100.0, 0.1], &[10, 10], 2.0, 3.0)[0], 3.0);
        assert_eq!(factors(&[0.4, 0.5], &[10, 10], 2.0, 3.0), [1.0, 1.0]);
    }

    #[test]
    fn equal_sections_are_equally_fine_and_a_cheap_one_finer() {
        let even = factors(&[2.0, 2.0], &[10, 10], 2.0, 9.0);
        assert!(even.iter().all(|f| (f - 2.0).abs() < 1e-9), "{even:?}");
        let uneven = factors(&[2.0, 2.0], &[10, 100], 2.0, 9.0);
        assert!(uneven[0] > 1.5 * uneven[1], "{uneven:?}");
        let left: f64 = uneven.iter().map(|f| 2.0 / (f * f)).sum();
        assert!((left - 1.0).abs() < 1e-9);
    }
}
