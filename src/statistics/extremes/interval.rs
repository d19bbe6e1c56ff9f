//! Confidence intervals by profile likelihood, with and without Bartlett's correction.

use std::convert::Infallible;

use super::conditional::settled;
use super::error::ExtremesError;
use super::special::normal_quantile;
use crate::numerics::random::Random;
use crate::numerics::roots::false_position;

/// How an interval is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IntervalMethod {
    /// Exact at every number of values, of laws with a location and a scale: given the configuration of the sample (Fisher 1934;
    /// Lawless, Statistical Models and Methods for Lifetime Data, 2003, app. E). The default for the Gumbel and Weibull laws.
    Conditional,
    /// Where the greatest likelihood with the quantity held falls below the greatest of all by half the chi-squared quantile of
    /// one degree of freedom (Coles, An Introduction to Statistical Modeling of Extreme Values, 2001, section 2.6.6):
    /// asymptotic in the number of values.
    ProfileLikelihood,
    /// The same with the cut multiplied by the mean of the likelihood ratio over samples drawn from the fitted law (Bartlett
    /// 1937; Rocke, J. Amer. Statist. Assoc. 84 (1989) 1015, by bootstrap).
    Bartlett {
        /// Samples drawn.
        draws: u32,
        /// Seed of the draws.
        seed: u64,
    },
}

/// A quantity with its confidence interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// At the fit of greatest likelihood.
    pub estimate: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Level of confidence, between 0 and 1.
    pub level: f64,
    /// How it was made.
    pub method: IntervalMethod,
}

impl Interval {
    /// An interval whose numbers are finite.
    pub(super) fn checked(self) -> Result<Self, ExtremesError> {
        let numbers = [self.estimate, self.low, self.high];
        if numbers.iter().all(|v| v.is_finite()) {
            Ok(self)
        } else {
            Err(ExtremesError::Unbounded)
        }
    }

    /// Whether a value lies inside.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }
}

/// A fitted law with one figure of interest.
pub(super) trait Model: Sized {
    /// The figure at the fit.
    fn estimate(&self) -> f64;
    /// About its standard error: the first step of searches.
    fn spread(&self) -> f64;
    /// Twice the fall of the greatest log-likelihood with the figure held at this value; infinite where it is impossible.
    fn deviance(&self, value: f64) -> f64;
    /// The same for as many values drawn from the fitted law; `None` where those have no fit.
    fn redraw(&self, random: &mut Random) -> Option<Self>;
}

/// Both ends by any method but the conditional.
pub(super) fn by_profile<M: Model>(
    model: &M,
    level: f64,
    method: IntervalMethod,
) -> Result<(f64, f64), ExtremesError> {
    let cut = normal_quantile(0.5 * (1.0 + level)).powi(2);
    match method {
        IntervalMethod::Conditional => Err(ExtremesError::NotLocationScale),
        IntervalMethod::ProfileLikelihood => profile(model, cut),
        IntervalMethod::Bartlett { draws, seed } => {
            profile(model, cut * bartlett_factor(model, draws, seed)?)
        }
    }
}

fn profile<M: Model>(model: &M, cut: f64) -> Result<(f64, f64), ExtremesError> {
    Ok((
        profile_end(model, cut, -1.0)?,
        profile_end(model, cut, 1.0)?,
    ))
}

/// Where the deviance reaches the cut on one side of the estimate.
fn profile_end<M: Model>(model: &M, cut: f64, side: f64) -> Result<f64, ExtremesError> {
    let centre = model.estimate();
    let (mut near, mut step) = (centre, side * model.spread());
    for _ in 0..80 {
        let far = centre + step;
        if !far.is_finite() || far == near {
            break;
        }
        if model.deviance(far) >= cut {
            // Impossible values count as far beyond the cut.
            let over =
                |x: f64| Ok::<_, Infallible>(settled(model.deviance(x).min(1e6) - cut, 1e-9));
            let Ok(found) = false_position((near, far), over);
            return found.ok_or(ExtremesError::Unbounded);
        }
        near = far;
        step *= 2.0;
    }
    Err(ExtremesError::Unbounded)
}

/// Mean of the deviance of the true figure over samples of the fitted law; one for many values.
fn bartlett_factor<M: Model>(model: &M, draws: u32, seed: u64) -> Result<f64, ExtremesError> {
    let truth = model.estimate();
    let redrawn = (0..u64::from(draws)).filter_map(|draw| {
        let other = model.redraw(&mut Random::new(seed, draw))?;
        Some(other.deviance(truth)).filter(|w| w.is_finite())
    });
    let (sum, count) = redrawn.fold((0.0, 0.0), |(sum, count), w| (sum + w, count + 1.0));
    if count < 10.0 || 2.0 * count < f64::from(draws) {
        return Err(ExtremesError::Unbounded);
    }
    Ok(sum / count)
}
