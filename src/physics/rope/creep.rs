//! Fibre ropes that creep: a slow part and a fast part in series, each a spring with a damper beside it.
//!
//! The slow spring bears the mean tension `T_m`, which follows its curve over the mean strain x ([`MeanCurve`]): the strain at which
//! the rope, loaded slowly, rests under `T_m`. The fast spring has the dynamic stiffness `K = a + b T_m` (Falkenberg, Ahjem and Yang
//! 2017, OTC-27761; DNV-RP-E305). With the strain e, the strain z of the slow part, and dots for rates:
//!
//! ```text
//! T = T_m(x) + S z'                            slow part, damper S
//! T = T_m(x) + K (e - x) + F (e' - z')         fast part, damper F
//! z' = w x'    w = 1 - dT_m/dx df/dT_m         f: strain of the fast spring at rest
//! ```
//!
//! so that x relaxes towards e: `(S + F) w x' = K (e - x) + F e'`. With a constant K the two parts are the standard linear solid with two
//! dampers, and `1/EA = 1/k + 1/K` gives the static stiffness EA. A viscoelastic rope has `f = T_m / K(T_m)`, the secant (Hall, Duong and
//! Lozon 2023, doi 10.1115/IOWTC2023-119524, eqs 2 and 10); a Syrope rope the tangent, `df/dT_m = 1/K` (Wei, Bingham and Shao 2026, doi
//! 10.11583/DTU.31408806).
//!
//! The dampers push no rope: with the elastic part `E = T_m + K (e - x)` the tension is held between 0 and 2 E, as that of any
//! segment ([`tension`](crate::tension)), and a slack rope recovers by `S z' = -T_m`.

use serde::{Deserialize, Serialize};

use super::elastic_tension::ElasticTension;
use super::working_curve::{CurvePoint, MeanCurve};
use crate::numerics::roots::Bracket;

/// A fibre rope that creeps.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepingRope {
    /// Mean tension over mean strain.
    pub curve: MeanCurve,
    /// Dynamic stiffness without tension, a \[N\].
    pub dynamic: f64,
    /// Growth of the dynamic stiffness with the mean tension, b \[-\].
    pub per_tension: f64,
    /// Damper of the slow part, S \[N s\].
    pub slow: f64,
    /// Damper of the fast part, F \[N s\].
    pub fast: f64,
    /// Greatest mean strain of the past, at which a working curve begins; 0 of a new rope.
    pub peak: f64,
    /// Mean tension up to which [`CreepingRope::max_stiffness`] holds \[N\].
    pub bound: f64,
    /// Mean tension that a motion begins with \[N\]; that at rest if absent.
    pub initial_mean: Option<f64>,
}

/// What a segment remembers at an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct CreepState {
    /// Mean strain x \[-\].
    pub mean: f64,
    /// Strain e \[-\].
    pub strain: f64,
    /// Greatest mean strain so far \[-\].
    pub peak: f64,
}

/// Tension of a rope that creeps.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CreepTension {
    /// Tension \[N\].
    pub tension: f64,
    /// Derivative by strain \[N\].
    pub by_strain: f64,
    /// Derivative by strain rate \[N s\].
    pub by_rate: f64,
    /// Derivative by mean strain \[N\].
    pub by_mean: f64,
}

/// Energy of a rope that creeps, by unstretched length.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CreepEnergy {
    /// Elastic part of the tension \[N\]: that of immediate unloading.
    pub elastic: f64,
    /// Stored along the mean curve and, from there, along the dynamic stiffness \[N\].
    pub stored: f64,
    /// How the stored energy falls as the mean strain grows at the same strain \[N\].
    pub lost_by_mean: f64,
}

/// The least share of the mean strain that the slow part takes: less means a curve stiffer than the dynamic stiffness.
const LEAST_SHARE: f64 = 0.01;
/// Iterations for the mean strain; four or less are needed where the step is short beside the creep.
const MOST_ITERATIONS: usize = 60;

impl CreepingRope {
    /// Tension and slope at rest; a slack rope goes on straight.
    #[must_use]
    pub fn at_rest(&self, strain: f64) -> ElasticTension {
        let slack = self.curve.slack(self.peak);
        if strain <= slack {
            let by_strain = self.curve.slack_stiffness(self.peak);
            return ElasticTension {
                tension: by_strain * (strain - slack),
                by_strain,
            };
        }
        let point = self.curve.at(strain, self.peak);
        ElasticTension {
            tension: point.tension,
            by_strain: point.by_strain,
        }
    }

    /// The strain at a tension \[N\] of a rope at rest.
    #[must_use]
    pub fn strain_at(&self, tension: f64) -> f64 {
        self.curve.strain_at(tension, self.peak)
    }

    /// Energy stored per unstretched length at rest \[N\].
    #[must_use]
    pub fn stored_at_rest(&self, strain: f64) -> f64 {
        self.curve.at(strain, self.peak).stored
    }

    /// What a segment remembers at the start, at a strain at rest.
    #[must_use]
    pub fn begin(&self, strain: f64) -> CreepState {
        let mean = match self.initial_mean {
            Some(tension) => self.strain_at(tension),
            None => strain.max(self.curve.slack(self.peak)),
        };
        CreepState {
            mean,
            strain,
            peak: self.peak.max(mean),
        }
    }

    /// Dynamic stiffness at a mean tension \[N\].
    #[must_use]
    pub fn dynamic_stiffness(&self, mean: f64) -> f64 {
        self.dynamic + self.per_tension * mean.max(0.0)
    }

    /// A slope that tensions do not exceed while their mean is within its bound \[N\].
    #[must_use]
    pub fn max_stiffness(&self) -> f64 {
        self.dynamic_stiffness(self.bound)
    }

    /// The damper that resists a fast motion \[N s\]: both in series.
    #[must_use]
    pub fn damping(&self) -> f64 {
        self.fast * self.slow / (self.fast + self.slow)
    }

    /// Share w of a change of the mean strain that the slow part takes, and its derivative by mean strain.
    fn slow_share(&self, point: &CurvePoint) -> (f64, f64) {
        let (k, b) = (self.dynamic_stiffness(point.tension), self.per_tension);
        let (by_tension, second) = match self.curve {
            MeanCurve::Syrope(..) => (1.0 / k, -b / (k * k)),
            _ => {
                let by_tension = self.dynamic / (k * k);
                (by_tension, -2.0 * b * by_tension / k)
            }
        };
        let slope = point.by_strain;
        let share = 1.0 - slope * by_tension;
        if share < LEAST_SHARE {
            return (LEAST_SHARE, 0.0);
        }
        (share, -point.bent * by_tension - slope * slope * second)
    }

    /// The tension at a strain e, its rate \[1/s\] and a mean strain at which the curve is at this point.
    fn tension_at(
        &self,
        (strain, rate, mean): (f64, f64, f64),
        point: &CurvePoint,
    ) -> CreepTension {
        let (k, d) = (self.dynamic_stiffness(point.tension), strain - mean);
        let elastic = point.tension + k * d;
        if elastic <= 0.0 {
            return CreepTension::default();
        }
        let stiffened = self.per_tension * point.by_strain * d - k;
        let share = self.slow / (self.slow + self.fast);
        let tension = point.tension + share * (k * d + self.fast * rate);
        if tension <= 0.0 {
            return CreepTension::default();
        }
        if tension >= 2.0 * elastic {
            return CreepTension {
                tension: 2.0 * elastic,
                by_strain: 2.0 * k,
                by_rate: 0.0,
                by_mean: 2.0 * (point.by_strain + stiffened),
            };
        }
        CreepTension {
            tension,
            by_strain: share * k,
            by_rate: share * self.fast,
            by_mean: point.by_strain + share * stiffened,
        }
    }

    /// Rate of the mean strain \[1/s\] at a strain that changes at a rate \[1/s\].
    #[must_use]
    pub fn mean_rate(&self, strain: f64, rate: f64, now: &CreepState) -> f64 {
        let point = self.curve.at(now.mean, now.peak);
        let tension = self.tension_at((strain, rate, now.mean), &point).tension;
        (tension - point.tension) / (self.slow * self.slow_share(&point).0)
    }

    /// The tension at a strain that changes at a rate \[1/s\], `dt` seconds after an instant.
    ///
    /// The mean strain follows by the implicit midpoint rule, whose strain rate is the quotient of the strains, so that it depends on the strain
    /// alone; its change with the strain is part of the derivative.
    #[must_use]
    pub fn tension(&self, strain: f64, rate: f64, before: &CreepState, dt: f64) -> CreepTension {
        let (mean, mean_by_strain) = self.mean_after(strain, before, dt);
        let point = self.curve.at(mean, before.peak);
        let found = self.tension_at((strain, rate, mean), &point);
        CreepTension {
            by_strain: found.by_strain + found.by_mean * mean_by_strain,
            ..found
        }
    }

    /// What a segment remembers `dt` seconds later at this strain.
    #[must_use]
    pub fn after(&self, strain: f64, before: &CreepState, dt: f64) -> CreepState {
        let (mean, _) = self.mean_after(strain, before, dt);
        CreepState {
            mean,
            strain,
            peak: before.peak.max(mean),
        }
    }

    /// The mean strain `dt` seconds after an instant, and its derivative by the strain there.
    fn mean_after(&self, strain: f64, before: &CreepState, dt: f64) -> (f64, f64) {
        if dt <= 0.0 {
            return (before.mean, 0.0);
        }
        let slack = self.curve.slack(before.peak);
        let rate = (strain - before.strain) / dt;
        let middle = 0.5 * (strain + before.strain);
        let pushed = dt * self.fast / (self.slow + self.fast) * rate.max(0.0) / LEAST_SHARE;
        let mut bracket = Bracket {
            low: 2.0 * slack.min(before.mean) - before.mean,
            high: (2.0 * middle - before.mean).max(before.mean) + pushed,
        };
        let mut mean = before.mean;
        let mut derivative = 0.0;
        for _ in 0..MOST_ITERATIONS {
            let (value, slope, by_strain) = self.missed(mean, (middle, rate), before, dt);
            if !(slope > 0.0 && value.is_finite()) {
                break;
            }
            derivative = -by_strain / slope;
            let step = value / slope;
            if step.abs() <= 8.0 * f64::EPSILON * (mean.abs() + strain.abs()) {
                mean -= step;
                break;
            }
            bracket.shrink(mean, value);
            mean = bracket.newton(mean, value, slope);
        }
        (mean.max(slack), derivative)
    }

    /// By how much a mean strain misses that of the midpoint rule, and its derivatives by mean strain and by strain.
    fn missed(
        &self,
        mean: f64,
        (middle, rate): (f64, f64),
        before: &CreepState,
        dt: f64,
    ) -> (f64, f64, f64) {
        let (half, step) = (0.5 * (mean + before.mean), mean - before.mean);
        let point = self.curve.at(half, before.peak);
        let (share, bent) = self.slow_share(&point);
        let found = self.tension_at((middle, rate, half), &point);
        let weight = dt / self.slow;
        (
            share * step - weight * (found.tension - point.tension),
            share + 0.5 * bent * step - 0.5 * weight * (found.by_mean - point.by_strain),
            -weight * (0.5 * found.by_strain + found.by_rate / dt),
        )
    }

    /// Energy at a strain.
    #[must_use]
    pub fn energy(&self, strain: f64, now: &CreepState) -> CreepEnergy {
        let point = self.curve.at(now.mean, now.peak);
        let (k, d) = (self.dynamic_stiffness(point.tension), strain - now.mean);
        let elastic = point.tension + k * d;
        let stiffened = self.per_tension * point.by_strain;
        if elastic <= 0.0 {
            let within = 0.5 * point.tension * point.tension / k;
            let by_mean = point.tension * point.by_strain / k - within * stiffened / k;
            return CreepEnergy {
                elastic: 0.0,
                stored: point.stored - within,
                lost_by_mean: by_mean - point.stored_by_strain,
            };
        }
        let by_mean = point.stored_by_strain + (point.by_strain - k) * d - point.tension
            + 0.5 * stiffened * d * d;
        CreepEnergy {
            elastic,
            stored: point.stored + d * (point.tension + 0.5 * k * d),
            lost_by_mean: -by_mean,
        }
    }
}
