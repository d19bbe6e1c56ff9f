//! Work at equal error: what steps of varying length cost beside the best constant step that is as accurate.
//!
//! The error of a single run is partly chance: where a force jumps, a line may come to rest at either of two speeds. So
//! every setting is computed for several variants of the case, gravity a thousandth or two different in each, and its point is
//! the median of their work and errors. Constant steps are interpolated between by the logarithms of work and error, at
//! every spectral radius, and the cheapest counts.

use std::sync::atomic::AtomicBool;

use super::{
    Runner, STEPS, SpeedError, SpeedSetting, TOLERANCES, error, moving, plan, rounded, setting,
};
use crate::case::Method;
use crate::number::digits;
use crate::numerics::interpolation::mix;
use crate::numerics::statistics::median;
use crate::run::accuracy::steps::Steps;
use crate::study::timed::Timed;
use crate::table::{Align, NumberFormat, Table};

/// Spectral radii at which steps are measured.
const RADII: [f64; 3] = [0.0, 0.4, 0.8];

/// What gravity differs by from variant to variant.
const APART: f64 = 1e-3;

/// Work and errors of one setting: medians over the variants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MedianPoint {
    /// Newton iterations.
    pub work: f64,
    /// Errors of the tension as in [`super::SolutionErrors`], root mean square and greatest \[-\].
    pub errors: [f64; 2],
}

/// Steps of varying length at one setting, beside constant ones.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkComparison {
    /// Spectral radius.
    pub rho: f64,
    /// Error allowed in a step.
    pub tolerance: f64,
    /// Its work and errors.
    pub median: MedianPoint,
    /// Iterations that the best constant step needs for the same error, root mean square and greatest; absent where
    /// none of those measured is as good, or as bad.
    pub constant: [Option<f64>; 2],
}

impl WorkComparison {
    /// Iterations by those of the best constant step at the same error.
    #[must_use]
    pub fn ratios(&self) -> [Option<f64>; 2] {
        self.constant
            .map(|constant| constant.map(|work| self.median.work / work))
    }
}

/// Constant steps at one spectral radius, the longest first.
type ConstantSteps = Vec<MedianPoint>;

/// Computes `variants` variants of the case at every setting, reporting each before it begins.
///
/// # Errors
/// As [`super::compute`].
pub fn compare<C: Timed>(
    case: &C,
    variants: usize,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(usize, usize, &str),
) -> Result<Vec<WorkComparison>, SpeedError> {
    let settings = settings(case)?;
    let exact = plan(case)?.reference;
    let mut runner = Runner {
        total: variants * (settings.len() + 1),
        begun: 0,
        cancel,
        progress,
    };
    let mut points = vec![Vec::new(); settings.len()];
    for number in 0..variants {
        let varied = case.heavier(gravity(number)).map_err(SpeedError::Scene)?;
        let of = |setting: &SpeedSetting<C>| varied.stepped(setting.steps).estimating(false);
        let name = format!("variant {number}");
        let reference = runner.reference(&of(&exact), &exact.name, name)?;
        for (setting, points) in settings.iter().zip(&mut points) {
            let run = runner.run(&of(setting), &setting.name, 1)?;
            // What failed is no point of its median.
            if let Some(errors) = error::errors(&run, &reference) {
                points.push((run.info.work.iterations as f64, errors));
            }
        }
    }
    let medians: Vec<Option<MedianPoint>> = points.iter().map(|points| median_of(points)).collect();
    Ok(comparisons(&settings, &medians))
}

/// Varying and constant steps at every radius, the coarsest setting first.
fn settings<C: Timed>(case: &C) -> Result<Vec<SpeedSetting<C>>, SpeedError> {
    let own = moving(case)?;
    let longest = case.bounds().map_err(SpeedError::Scene)?.longest;
    let of_radius = |rho: f64| {
        let of = |length: Option<f64>, tolerance: f64, name: String| {
            let steps = Steps {
                method: Method::Alpha,
                length,
                tolerance,
                rho,
                ..own
            };
            setting(case, &format!("rho {rho}"), name, steps)
        };
        let vary = TOLERANCES.map(|share| {
            let tolerance = rounded(own.tolerance * share);
            of(None, tolerance, format!("tolerance {tolerance:.1e}"))
        });
        let constant = STEPS.map(|share| {
            let step = rounded(longest * share);
            of(Some(step), own.tolerance, format!("step {step:.2e} s"))
        });
        vary.into_iter().chain(constant)
    };
    Ok(RADII.into_iter().flat_map(of_radius).collect())
}

/// Gravity of the variant of this number by that of the case: as it is, a little more, a little less, more than that ...
fn gravity(number: usize) -> f64 {
    let away = number.div_ceil(2) as f64 * APART;
    if number.is_multiple_of(2) {
        1.0 - away
    } else {
        1.0 + away
    }
}

fn median_of(points: &[(f64, error::SolutionErrors)]) -> Option<MedianPoint> {
    let of = |pick: &dyn Fn(&(f64, error::SolutionErrors)) -> f64| {
        median(points.iter().map(pick).collect())
    };
    Some(MedianPoint {
        work: of(&|p| p.0)?,
        errors: [of(&|p| p.1.tension_rms)?, of(&|p| p.1.tension_max)?],
    })
}

/// Every point of varying steps, beside the cheapest constant ones.
fn comparisons<C>(
    settings: &[SpeedSetting<C>],
    medians: &[Option<MedianPoint>],
) -> Vec<WorkComparison> {
    let constant = |rho: f64| -> ConstantSteps {
        let all = settings.iter().zip(medians);
        let of = all.filter(|(s, _)| s.steps.rho == rho && s.steps.length.is_some());
        of.filter_map(|(_, median)| *median).collect()
    };
    let curves = RADII.map(constant);
    let vary = settings.iter().zip(medians);
    let vary = vary.filter(|(s, _)| s.steps.length.is_none());
    vary.filter_map(|(setting, median)| {
        let median = (*median)?;
        let cheapest = |which: usize| {
            let works = curves.iter();
            let works = works.filter_map(|c| work_at(c, which, median.errors[which]));
            works.reduce(f64::min)
        };
        Some(WorkComparison {
            rho: setting.steps.rho,
            tolerance: setting.steps.tolerance,
            median,
            constant: [cheapest(0), cheapest(1)],
        })
    })
    .collect()
}

/// Work along a curve where its error is this, between neighbours by their logarithms; the least where there are several.
fn work_at(curve: &[MedianPoint], which: usize, error: f64) -> Option<f64> {
    let between = |pair: &[MedianPoint]| {
        let ((a, w), (b, v)) = (
            (pair[0].errors[which].ln(), pair[0].work.ln()),
            (pair[1].errors[which].ln(), pair[1].work.ln()),
        );
        let share = (error.ln() - a) / (b - a);
        (0.0..=1.0).contains(&share).then(|| mix(w, v, share).exp())
    };
    curve.windows(2).filter_map(between).reduce(f64::min)
}

/// The middle ratio over all settings of a radius, of root mean square and greatest error together.
fn middle(rows: &[WorkComparison], rho: f64) -> Option<f64> {
    let of = rows.iter().filter(|row| row.rho == rho);
    median(of.flat_map(WorkComparison::ratios).flatten().collect())
}

/// The table: a row a setting, bare numbers with their units in the heads.
#[must_use]
pub fn comparison_table(rows: &[WorkComparison], variants: usize) -> Table {
    let title = "Steps of varying length beside the best constant step of the same error";
    let mut table = Table::of_records(title, rows)
        .count("rho", |row| row.rho)
        .count("tolerance", |row| format!("{:.1e}", row.tolerance))
        .count("iterations", |row| format!("{:.0}", row.median.work));
    let errors = ["tension rms [% of peak]", "tension max [% of peak]"];
    for (which, head) in errors.into_iter().enumerate() {
        table = table
            .count(head, |row| digits(100.0 * row.median.errors[which], 3))
            .cell("best constant [iterations]", Align::Right, |row| {
                NumberFormat::Digits(5, "").cell(row.constant[which].map(f64::round))
            })
            .cell("ratio", Align::Right, |row| {
                NumberFormat::Digits(2, "").cell(row.ratios()[which])
            });
    }
    let medians = RADII.iter().filter_map(|rho| {
        let middle = middle(rows, *rho)?;
        Some(format!(
            "Median of the ratios at rho {rho}: {}.",
            digits(middle, 2)
        ))
    });
    table.build().noted(medians).noted([format!(
        "Iterations and errors are medians over {variants} variants of the case, gravity a thousandth different in each: the \
         error of a single run is partly chance. The best constant step is the cheapest at any rho of {RADII:?} that has the \
         same error, interpolated by logarithms; a dash where none measured has."
    )])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(work: f64, error: f64) -> MedianPoint {
        MedianPoint {
            work,
            errors: [error, error],
        }
    }

    #[test]
    fn work_at_an_error_is_found_between_two_points() {
        let curve = [point(100.0, 1e-2), point(400.0, 1e-4), point(800.0, 1e-3)];
        assert!((work_at(&curve, 0, 1e-3).unwrap_or_default() - 200.0).abs() < 1e-9);
        assert_eq!(work_at(&curve, 1, 1e-5), None);
        assert_eq!(work_at(&curve, 1, 1.0), None);
    }
}
