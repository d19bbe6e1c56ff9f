//! The likelihood of the generalized Pareto law as a function of shape over scale alone.

use std::convert::Infallible;

use crate::numerics::roots::false_position;

/// Shapes of a fit; below -1 the likelihood has no bound.
pub(super) const SHAPES: (f64, f64) = (-1.0, 5.0);

/// Mean of `ln(1 + t y)/t`, which is the scale at the ratio `t`, and its derivative.
fn mean_scale(excesses: &[f64], ratio: f64) -> (f64, f64) {
    let n = excesses.len() as f64;
    if ratio.abs() < 1e-4 {
        let (mut value, mut slope) = (0.0, 0.0);
        for y in excesses {
            let t = ratio * y;
            value += y * (1.0 - t * (1.0 / 2.0 - t * (1.0 / 3.0 - t * (0.25 - t * 0.2))));
            slope -= y * y * (0.5 - t * (2.0 / 3.0 - t * (0.75 - t * 0.8)));
        }
        return (value / n, slope / n);
    }
    let (mut logs, mut shares) = (0.0, 0.0);
    for y in excesses {
        logs += (ratio * y).ln_1p();
        shares += y / (1.0 + ratio * y);
    }
    let (logs, shares) = (logs / n, shares / n);
    (logs / ratio, (shares - logs / ratio) / ratio)
}

/// Scale and shape of greatest likelihood of excesses whose greatest is one.
pub(super) fn likely(excesses: &[f64]) -> Option<(f64, f64)> {
    // Log-likelihood over the number, and its derivative, at u = ln(1 + ratio).
    let at = |u: f64| {
        let ratio = u.exp_m1();
        let (scale, slope) = mean_scale(excesses, ratio);
        let shape = ratio * scale;
        let rise = -slope / scale - (scale + ratio * slope);
        (-scale.ln() - shape, rise, ratio, shape)
    };
    const STEP: f64 = 0.25;
    let mut best: Option<(f64, f64, f64)> = None;
    let (mut before, mut rise_before) = (-36.0, at(-36.0).1);
    for i in 1..=240 {
        let u = -36.0 + STEP * f64::from(i);
        let rise = at(u).1;
        if rise_before > 0.0 && rise <= 0.0 {
            let Ok(root) = false_position((before, u), |u| Ok::<_, Infallible>(at(u).1));
            let (likelihood, _, ratio, shape) = at(root?);
            let allowed = shape > SHAPES.0 && shape < SHAPES.1;
            if allowed && best.is_none_or(|(most, ..)| likelihood > most) {
                best = Some((likelihood, ratio, shape));
            }
        }
        (before, rise_before) = (u, rise);
    }
    best.map(|(_, ratio, shape)| (mean_scale(excesses, ratio).0, shape))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_smooth_across_its_series() {
        let excesses = [0.02, 0.3, 0.7, 1.0];
        for ratio in [1e-4, -1e-4] {
            let (inside, slope) = mean_scale(&excesses, ratio * (1.0 - 1e-9));
            let (outside, other) = mean_scale(&excesses, ratio * (1.0 + 1e-9));
            assert!((inside / outside - 1.0).abs() < 1e-11 && (slope / other - 1.0).abs() < 1e-7);
        }
        let h = 1e-5;
        let numeric =
            (mean_scale(&excesses, 0.4 + h).0 - mean_scale(&excesses, 0.4 - h).0) / (2.0 * h);
        assert!((mean_scale(&excesses, 0.4).1 - numeric).abs() < 1e-9);
    }

    /// Uniform excesses have their greatest likelihood at the edge: there is none inside.
    #[test]
    fn no_maximum_at_the_edge() {
        let even: Vec<f64> = (1..=20).map(|k| f64::from(k) / 20.0).collect();
        assert_eq!(likely(&even), None);
    }
}
