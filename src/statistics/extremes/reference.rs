//! Comparison with pyextremes and scipy on a seeded series (`tests/data/extremes.json`, versions and licences in its head).

use serde::Deserialize;

use super::generalized_pareto::ParetoFit;
use super::gumbel::GumbelFit;
use super::peaks::{Peak, block_maxima, over_threshold};
use super::special::{chi_squared_quantile, ln_gamma, ln_incomplete_beta, normal_quantile};
use super::spectrum::welch;
use super::weibull::WeibullFit;

#[derive(Deserialize)]
struct PublishedExtreme {
    times: Vec<f64>,
    values: Vec<f64>,
    block_maxima: Extremes,
    over_threshold: Extremes,
    gumbel: Fit,
    pareto: Fit,
    weibull: Fit,
    special: Special,
    spectra: Vec<Density>,
}

#[derive(Deserialize)]
struct Extremes {
    #[serde(default)]
    block: f64,
    #[serde(default)]
    threshold: f64,
    #[serde(default)]
    separation: f64,
    index: Vec<usize>,
    value: Vec<f64>,
}

#[derive(Deserialize)]
struct Fit {
    /// As pyextremes gives it, to the tolerance of scipy's optimiser: 1e-4.
    program: [f64; 2],
    /// The same likelihood minimised to 1e-13 by scipy.
    tight: [f64; 2],
    log_likelihood: f64,
}

#[derive(Deserialize)]
struct Special {
    ln_gamma: Vec<[f64; 2]>,
    chi_squared: Vec<[f64; 3]>,
    normal: Vec<[f64; 2]>,
    ln_beta_cdf: Vec<[f64; 4]>,
}

#[derive(Deserialize)]
struct Density {
    length: usize,
    frequency: Vec<f64>,
    density: Vec<f64>,
}

fn reference() -> PublishedExtreme {
    serde_json::from_str(include_str!("../../../tests/data/extremes.json")).unwrap()
}

fn same(found: &[Peak], expected: &Extremes) {
    let index: Vec<usize> = found.iter().map(|p| p.index).collect();
    let value: Vec<f64> = found.iter().map(|p| p.value).collect();
    assert_eq!(index, expected.index);
    assert_eq!(value, expected.value);
    assert!(index.len() > 50);
}

fn close(found: [f64; 2], fit: &Fit) {
    for (k, value) in found.into_iter().enumerate() {
        assert!(
            (value / fit.tight[k] - 1.0).abs() < 2e-7,
            "{value} {}",
            fit.tight[k]
        );
        assert!(
            (value / fit.program[k] - 1.0).abs() < 1e-4,
            "{value} {}",
            fit.program[k]
        );
    }
}

#[test]
fn the_extremes_are_those_of_pyextremes() {
    let r = reference();
    same(
        &block_maxima(&r.times, &r.values, r.block_maxima.block).unwrap(),
        &r.block_maxima,
    );
    let (threshold, separation) = (r.over_threshold.threshold, r.over_threshold.separation);
    same(
        &over_threshold(&r.times, &r.values, threshold, separation).unwrap(),
        &r.over_threshold,
    );
}

#[test]
fn the_fits_are_those_of_pyextremes() {
    let r = reference();
    let gumbel = GumbelFit::fit(&r.block_maxima.value).unwrap();
    close([gumbel.mode, gumbel.scale], &r.gumbel);
    let (peaks, threshold) = (&r.over_threshold.value, r.over_threshold.threshold);
    let pareto = ParetoFit::fit(peaks, threshold).unwrap();
    close([pareto.shape, pareto.scale], &r.pareto);
    let weibull = WeibullFit::fit(peaks, threshold).unwrap();
    close([weibull.shape, weibull.scale], &r.weibull);
    for (found, fit) in [
        (gumbel.log_likelihood, &r.gumbel),
        (pareto.log_likelihood, &r.pareto),
        (weibull.log_likelihood, &r.weibull),
    ] {
        assert!((found - fit.log_likelihood).abs() < 1e-10 * found.abs());
    }
}

#[test]
fn the_spectra_are_those_of_scipy() {
    let r = reference();
    for expected in &r.spectra {
        let found = welch(&r.values, 0.25, Some(expected.length)).unwrap();
        assert_eq!(found.density.len(), expected.density.len());
        let most = expected.density.iter().copied().fold(0.0, f64::max);
        for (k, density) in found.density.iter().enumerate() {
            assert!((density - expected.density[k]).abs() < 1e-12 * most, "{k}");
            assert!(
                (density - expected.density[k]).abs() < 1e-12 * density.max(1e-3 * most),
                "{k}"
            );
            assert!((k as f64 * found.frequency_step - expected.frequency[k]).abs() < 1e-12);
        }
    }
}

#[test]
fn special_functions_are_those_of_scipy() {
    let special = reference().special;
    for [x, exact] in special.ln_gamma {
        // Below 15 it is a difference of numbers up to 30, whose rounding is left.
        assert!(
            (ln_gamma(x) - exact).abs() < 1e-14 * exact.abs().max(1.0),
            "{x}"
        );
    }
    for [freedom, p, exact] in special.chi_squared {
        assert!(
            (chi_squared_quantile(freedom, p) / exact - 1.0).abs() < 1e-12,
            "{freedom} {p}"
        );
    }
    for [p, exact] in special.normal {
        assert!((normal_quantile(p) / exact - 1.0).abs() < 1e-12, "{p}");
    }
    for [a, b, x, exact] in special.ln_beta_cdf {
        let off = (ln_incomplete_beta(a, b, x) - exact).abs();
        assert!(off < 1e-12 * exact.abs().max(1e-3), "{a} {b} {x} {off}");
    }
}
