//! Laws of a location and a scale: Gumbel's, and Weibull's in the logarithm; the likelihood with one figure held.

use std::convert::Infallible;

use super::conditional::settled;
use super::error::ExtremesError;
use super::gumbel::GumbelFit;
use super::interval::Model;
use super::target::ExponentialMaximum;
use crate::numerics::random::Random;
use crate::numerics::roots::false_position;

/// How far a figure lies above the mode of a Gumbel law, as a function of its scale.
#[derive(Debug, Clone)]
pub(super) enum Offset {
    /// This many scales.
    Linear(f64),
    /// Minus the logarithm of the mean of the greatest exponential variable to the power of the scale: the expected greatest
    /// of a Weibull law, in its negative logarithm.
    Expected(ExponentialMaximum),
}

impl Offset {
    /// The offset at a scale, and its derivative.
    pub(super) fn at(&self, scale: f64) -> (f64, f64) {
        match self {
            Self::Linear(scales) => (scales * scale, *scales),
            Self::Expected(greatest) => {
                let (value, slope) = greatest.ln_moment(scale);
                (-value, -slope)
            }
        }
    }
}

/// Values of a Gumbel law with its fit and the figure asked for.
#[derive(Debug, Clone)]
pub(super) struct LocationScale<'a> {
    values: Vec<f64>,
    fit: GumbelFit,
    offset: &'a Offset,
}

impl<'a> LocationScale<'a> {
    pub(super) fn new(values: Vec<f64>, offset: &'a Offset) -> Result<Self, ExtremesError> {
        let fit = GumbelFit::fit(&values)?;
        Ok(Self {
            values,
            fit,
            offset,
        })
    }

    /// The figure at the fit.
    pub(super) fn value(&self) -> f64 {
        self.fit.mode + self.offset.at(self.fit.scale).0
    }

    /// Log-likelihood with the figure held at `value`, and its derivative with respect to the logarithm of the scale.
    fn likelihood(&self, value: f64, scale: f64) -> (f64, f64) {
        let (offset, slope) = self.offset.at(scale);
        let mode = value - offset;
        let n = self.values.len() as f64;
        let (mut log, mut fall) = (-n * scale.ln(), -n);
        for x in &self.values {
            let z = (x - mode) / scale;
            let tail = (-z).exp();
            log -= z + tail;
            fall -= (1.0 - tail) * (slope - z);
        }
        (log, fall)
    }
}

impl Model for LocationScale<'_> {
    fn estimate(&self) -> f64 {
        self.value()
    }

    fn spread(&self) -> f64 {
        // The standard error of the mode is 1.05 scale / root(n), that of the scale 0.78 (Gumbel's information matrix).
        let slope = self.offset.at(self.fit.scale).1;
        self.fit.scale * (1.1 + 0.6 * slope * slope).sqrt() / (self.fit.count as f64).sqrt()
    }

    fn deviance(&self, value: f64) -> f64 {
        // The likelihood of the scale alone rises to one maximum and falls.
        let centre = self.fit.scale.ln();
        // A slope of 1e-9 for each value leaves the likelihood exact to rounding.
        let tolerance = 1e-9 * self.values.len() as f64;
        let slope = |log: f64| settled(self.likelihood(value, log.exp()).1, tolerance);
        let side = if slope(centre) > 0.0 { 1.0 } else { -1.0 };
        let mut reach = 0.25;
        while side * slope(centre + side * reach) > 0.0 && reach < 600.0 {
            reach *= 2.0;
        }
        let bounds = (centre, centre + side * reach);
        let Ok(found) = false_position(bounds, |log| Ok::<_, Infallible>(slope(log)));
        found.map_or(f64::NAN, |log| {
            let most = self.likelihood(value, log.exp()).0;
            (2.0 * (self.fit.log_likelihood - most)).max(0.0)
        })
    }

    fn redraw(&self, random: &mut Random) -> Option<Self> {
        let values = self.values.iter().map(|_| self.fit.draw(random)).collect();
        Self::new(values, self.offset).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_the_likelihood_is_its_derivative() {
        let values: Vec<f64> = [0.3, 1.2, -0.4, 2.5, 0.9].to_vec();
        for offset in [
            Offset::Linear(2.25),
            Offset::Expected(ExponentialMaximum::of_count(40.0)),
        ] {
            let model = LocationScale::new(values.clone(), &offset).unwrap();
            assert!(model.deviance(model.value()) < 1e-12);
            let (q, log, h) = (model.value() + 0.2, -0.3_f64, 1e-6);
            let up = model.likelihood(q, (log + h).exp()).0;
            let down = model.likelihood(q, (log - h).exp()).0;
            let slope = model.likelihood(q, log.exp()).1;
            assert!((slope - (up - down) / (2.0 * h)).abs() < 1e-6 * slope.abs().max(1.0));
        }
    }
}
