//! Statistics of a record and its extremes: how often, how great, and how sure.
//!
//! ```text
//! record ──▶ spectrum, moments ──▶ rayleigh      closed forms of a narrow-band Gaussian process
//!        ──▶ peaks ──▶ greatest ──▶ weibull,     the greatest of so many hours from one record
//!                      threshold    generalized_pareto
//! greatest values of seeds ──▶ gumbel            the same from many records
//!                          ──▶ sequential        whether to draw more
//! ```
//!
//! * [`spectrum`], [`spectral_moments`], [`moments`]: Welch's spectral density, periods and bandwidth, crossing rates.
//! * [`peaks`], [`threshold`]: peaks between crossings, of clusters, of blocks; the threshold from which on they are Pareto.
//! * [`gumbel`], [`weibull`], [`generalized_pareto`]: fits of greatest likelihood, with intervals of any [`target`].
//! * [`interval`]: exact, by profile likelihood; [`coverage`]: how often they hold the truth, measured.
//! * [`greatest`], [`rayleigh`]: the greatest of so many hours, by fits and in closed form.
//! * [`convergence`]: the standard error of the mean of a correlated record.
//! * [`sequential`], [`fractile_rule`], [`gumbel_rule`]: verdicts that stay valid however often one looks;
//!   [`sequential_study`]: how often they err, and how many seeds they take, measured.
//!
//! Which interval: for the Gumbel and Weibull laws the exact conditional one at every number of values. Measured over 2,000
//! samples, 95 % intervals of the 90 % quantile and of the greatest of n or 100 hold the truth in
//!
//! | method | 5 values | 10 | 20 | 30 to 100 |
//! |---|---|---|---|---|
//! | conditional | 94.8 to 95.7 % | 94.5 to 95.9 % | 94.5 to 96.0 % | 93.7 to 95.2 % |
//! | profile likelihood | 89.6 to 91.3 % | 92.8 to 94.9 % | 94.1 to 94.9 % | 93.7 to 94.9 % |
//! | the same, Bartlett (Gumbel) | 95.3 to 95.7 % | | | 94.7 to 95.0 % |
//! | bootstrap, bias corrected (Gumbel) | 89.0 to 89.5 % | | | 93.9 to 94.2 % |
//! | bootstrap, percentile (Gumbel) | 76.9 to 81.5 % | | | 92.3 to 93.2 % |
//!
//! (standard error 0.5 %). The profile misses on the low side two to four times as often as on the high, the conditional on both
//! alike. Of the generalized Pareto law of shape -0.1, profile likelihood holds it in 92 % of samples of 30 and 94 % of 100;
//! with Bartlett's correction in 95 % of 400 samples of 30 (standard error 1.1 %). The bootstrap, measured once, is
//! left out for that.

mod anderson_darling;
#[cfg(test)]
mod any_input;
mod conditional;
pub mod convergence;
pub mod coverage;
mod error;
pub mod fractile_rule;
pub mod generalized_pareto;
pub mod greatest;
pub mod gumbel;
pub mod gumbel_rule;
pub mod interval;
mod location_scale;
pub mod moments;
mod pareto_likelihood;
mod pareto_profile;
mod pareto_sums;
pub mod peaks;
pub mod rayleigh;
#[cfg(test)]
mod reference;
pub mod sequential;
pub mod sequential_study;
mod special;
pub mod spectral_moments;
pub mod spectrum;
pub mod target;
pub mod threshold;
pub mod weibull;

pub use coverage::{Coverage, CoverageStudy, Distribution};
pub use error::ExtremesError;
pub use interval::{Interval, IntervalMethod};
pub use target::{ExtremesTarget, Statistic};
