//! Stiffness of a synthetic fibre rope in motion: it grows with the mean tension and falls with the deviation from it.
//!
//! ```text
//! k = EA / MBL = alpha + beta Lm - gamma La
//! ```
//!
//! (Zhu, Yin and Shen 2017, Journal of Harbin Engineering University, eq. 1 as rebuilt from its symbols and numbers):
//! MBL is the breaking load, Lm the mean of the past tension and La the deviation of the tension from that mean, signed
//! and of the instant, both in percent of MBL. La depends on the tension that k gives; where the paper
//! iterates for it, both readings below have a closed form, so that value and slope are exact.
//!
//! **Secant**: `T = k MBL e` with the same unstretched length as at rest under the static stiffness. It is what the
//! paper computes (its tensions with the top held still are greater than the static ones). With `c = 100 gamma`
//! and `A = alpha + (beta + gamma) Lm`: `T = MBL A e / (1 + c e)`. At rest Lm is the tension itself and La is none:
//! `T = MBL alpha e / (1 - 100 beta e)`.
//!
//! **About the mean**: the static stiffness up to the mean tension Tm and its strain e_m, the dynamic one from there:
//! `T = Tm + k MBL (e - e_m)`. With `B = alpha + beta Lm` and `D = e - e_m`: `T = Tm + MBL B D / (1 + c D)`. A line
//! at rest has its static tensions.
//!
//! **Scope.** Each segment has the k of its own tension, as in the paper (sec. 1.3), or all segments of a rope share one
//! (the traditional method, sec. 1.2, against which the paper argues): Lm and La are then those of the tension averaged along
//! the rope, [`FibreRope::shared_stiffness`], and tension is linear in the strain of a segment, [`FibreRope::in_step`].

use super::TensionTable;
use super::elastic_tension::ElasticTension;

/// A fibre rope with dynamic stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct FibreRope {
    /// alpha \[-\].
    pub alpha: f64,
    /// beta, per percent of the breaking load \[-\].
    pub beta: f64,
    /// gamma, per percent of the breaking load \[-\].
    pub gamma: f64,
    /// Breaking load MBL \[N\].
    pub strength: f64,
    /// How the stiffness defines the tension.
    pub reading: StiffnessForm,
    /// Time over which the past tension is averaged \[s\]; infinity: all of the past.
    pub window: f64,
    /// Whether the segments of a rope share one stiffness, instead of each having its own.
    pub shared: bool,
}

/// How the dynamic stiffness defines the tension.
#[derive(Debug, Clone, PartialEq)]
pub enum StiffnessForm {
    /// Through the origin of strain.
    Secant,
    /// About the mean state, up to which this holds.
    AboutTheMean(StaticElasticity),
}

/// Elasticity of a rope that is loaded slowly.
#[derive(Debug, Clone, PartialEq)]
pub enum StaticElasticity {
    /// This stiffness EA \[N\].
    Linear(f64),
    /// A table.
    TensionTable(TensionTable),
}

/// The mean state that a segment swings about.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MeanState {
    /// Mean tension \[N\].
    pub tension: f64,
    /// Strain under that tension, loaded slowly \[-\].
    pub strain: f64,
}

/// What the one stiffness of a rope depends on, at an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RopeAverage {
    /// Mean of the past tension, averaged along the rope \[N\].
    pub tension: f64,
    /// Strain from where the branch of the mean begins, averaged along the rope \[-\].
    pub strain: f64,
}

/// Tension in percent of the breaking load beyond which the curve at rest goes on straight: the rope has parted.
const PARTED: f64 = 100.0;

/// Mean tension in percent of the breaking load up to which [`FibreRope::max_stiffness`] holds.
const WORKING: f64 = 50.0;

impl FibreRope {
    /// A tension in percent of the breaking load.
    #[must_use]
    pub fn percent(&self, tension: f64) -> f64 {
        100.0 * tension / self.strength
    }

    /// k = EA / MBL at a mean and a deviation in percent of the breaking load \[-\].
    #[must_use]
    pub fn stiffness(&self, mean: f64, deviation: f64) -> f64 {
        self.alpha + self.beta * mean - self.gamma * deviation
    }

    /// Tension and slope at rest, the mean being the tension itself.
    #[must_use]
    pub fn at_rest(&self, strain: f64) -> ElasticTension {
        match &self.reading {
            StiffnessForm::AboutTheMean(curve) => curve.at(strain),
            StiffnessForm::Secant => {
                let strain_in = strain.clamp(0.0, self.strain_parted());
                let left = 1.0 - 100.0 * self.beta * strain_in;
                let by_strain = self.strength * self.alpha / (left * left);
                ElasticTension {
                    tension: self.strength * self.alpha * strain_in / left
                        + by_strain * (strain - strain_in),
                    by_strain,
                }
            }
        }
    }

    /// Tension and slope about a mean. A strain at which the rope is slack has the straight continuation.
    #[must_use]
    pub fn in_motion(&self, strain: f64, mean: &MeanState) -> ElasticTension {
        let (from, stiffness, start) = self.branch(mean);
        let c = 100.0 * self.gamma;
        let slack = self.slack(mean);
        let inside = (strain - from).max(slack);
        let left = 1.0 / (1.0 + c * inside);
        let by_strain = stiffness * left * left;
        ElasticTension {
            tension: start + stiffness * inside * left + by_strain * (strain - from - inside),
            by_strain,
        }
    }

    /// The strain at a tension \[N\] of a line at rest.
    #[must_use]
    pub fn strain_at(&self, tension: f64) -> f64 {
        match &self.reading {
            StiffnessForm::AboutTheMean(curve) => curve.strain_at(tension),
            StiffnessForm::Secant => {
                let percent = self.percent(tension);
                let inside = percent.clamp(0.0, PARTED);
                let strain = inside / (100.0 * (self.alpha + self.beta * inside));
                let slope = self.at_rest(strain).by_strain;
                strain + (percent - inside) * 0.01 * self.strength / slope
            }
        }
    }

    /// How the strain under a slowly grown tension grows with it \[1/N\], at a strain of the static curve.
    #[must_use]
    pub fn compliance(&self, strain: f64) -> f64 {
        1.0 / self.at_rest(strain).by_strain
    }

    /// Energy stored per unstretched length at rest \[N\].
    #[must_use]
    pub fn stored_at_rest(&self, strain: f64) -> f64 {
        match &self.reading {
            StiffnessForm::AboutTheMean(StaticElasticity::Linear(ea)) => 0.5 * ea * strain * strain,
            StiffnessForm::AboutTheMean(StaticElasticity::TensionTable(table)) => {
                table.stored(strain)
            }
            StiffnessForm::Secant => {
                let inside = strain.clamp(0.0, self.strain_parted());
                let (edge, beyond) = (self.at_rest(inside), strain - inside);
                self.strength * self.alpha * bend(-100.0 * self.beta, inside)
                    + beyond * (edge.tension + 0.5 * edge.by_strain * beyond)
            }
        }
    }

    /// Energy stored per unstretched length about a mean \[N\], and how it grows with the mean tension at the same
    /// strain \[-\]: what the rope takes up or gives back as it forgets.
    #[must_use]
    pub fn stored_in_motion(&self, strain: f64, mean: &MeanState) -> (f64, f64) {
        let (from, stiffness, start) = self.branch(mean);
        let (here, slack) = (strain - from, self.slack(mean));
        if here <= slack {
            return (0.0, 0.0);
        }
        let c = 100.0 * self.gamma;
        let bent = bend(c, here) - bend(c, slack);
        let stored = start * (here - slack) + stiffness * bent;
        let by_mean = match self.reading {
            StiffnessForm::Secant => 100.0 * (self.beta + self.gamma) * bent,
            StiffnessForm::AboutTheMean(_) => {
                here - slack + 100.0 * self.beta * bent
                    - self.compliance(mean.strain) * self.in_motion(strain, mean).tension
            }
        };
        (stored, by_mean)
    }

    /// k of a whole rope in motion \[-\]: La is that of the average tension, which k itself gives, in closed form.
    #[must_use]
    pub fn shared_stiffness(&self, average: &RopeAverage) -> f64 {
        let percent = self.percent(average.tension);
        let full = self.alpha + (self.beta + self.gamma) * percent;
        let base = match self.reading {
            StiffnessForm::Secant => full,
            StiffnessForm::AboutTheMean(_) => self.stiffness(percent, 0.0),
        };
        base / (1.0 + 100.0 * self.gamma * average.strain.max(self.slack_from(percent)))
    }

    /// Rate of [`FibreRope::shared_stiffness`] \[1/s\] by those of the averages.
    #[must_use]
    pub fn shared_stiffness_rate(&self, average: &RopeAverage, rate: &RopeAverage) -> f64 {
        let k = self.shared_stiffness(average);
        let c = 100.0 * self.gamma;
        let by_percent = match self.reading {
            StiffnessForm::Secant => self.beta + self.gamma,
            StiffnessForm::AboutTheMean(_) => self.beta,
        };
        let slack = self.slack_from(self.percent(average.tension));
        let strain_rate = if average.strain > slack {
            rate.strain
        } else {
            0.0
        };
        let bent = 1.0 + c * average.strain.max(slack);
        (by_percent * self.percent(rate.tension) - k * c * strain_rate) / bent
    }

    /// Deviation La of the average tension from its mean, in percent of the breaking load, under a shared k.
    #[must_use]
    pub fn shared_deviation(&self, average: &RopeAverage, k: f64) -> f64 {
        match self.reading {
            StiffnessForm::Secant => 100.0 * k * average.strain - self.percent(average.tension),
            StiffnessForm::AboutTheMean(_) => 100.0 * k * average.strain,
        }
    }

    /// Tension and slope of a segment under a shared k; `mean` is its own mean state, none at rest.
    #[must_use]
    pub fn in_step(&self, strain: f64, mean: Option<&MeanState>, k: f64) -> ElasticTension {
        let by_strain = k * self.strength;
        let (from, start) = match (&self.reading, mean) {
            (StiffnessForm::Secant, _) => (0.0, 0.0),
            (StiffnessForm::AboutTheMean(curve), None) => return curve.at(strain),
            (StiffnessForm::AboutTheMean(_), Some(mean)) => (mean.strain, mean.tension),
        };
        ElasticTension {
            tension: start + by_strain * (strain - from),
            by_strain,
        }
    }

    /// Energy stored per unstretched length under a shared k \[N\], and its rate at the same strain \[N/s\], by the rates
    /// of k and of the segment's mean state.
    #[must_use]
    pub fn stored_in_step(
        &self,
        strain: f64,
        mean: Option<(&MeanState, &MeanState)>,
        (k, k_rate): (f64, f64),
    ) -> (f64, f64) {
        if let (StiffnessForm::AboutTheMean(_), None) = (&self.reading, mean) {
            return (self.stored_at_rest(strain), 0.0);
        }
        let ElasticTension { tension, by_strain } = self.in_step(strain, mean.map(|(m, _)| m), k);
        if tension <= 0.0 {
            return (0.0, 0.0);
        }
        let stiffness_rate = k_rate * self.strength;
        let tension_rate = match (&self.reading, mean) {
            (StiffnessForm::AboutTheMean(_), Some((mean, rate))) => {
                rate.tension + stiffness_rate * (strain - mean.strain) - by_strain * rate.strain
            }
            _ => stiffness_rate * strain,
        };
        let stretch = tension / by_strain;
        let rate = stretch * (tension_rate - 0.5 * stretch * stiffness_rate);
        (0.5 * tension * stretch, rate)
    }

    /// A slope that tensions do not exceed while the mean stays below half the breaking load \[N\].
    #[must_use]
    pub fn max_stiffness(&self) -> f64 {
        let full = self.alpha + (self.beta + self.gamma) * WORKING;
        let about = self.stiffness(WORKING, 0.0);
        match &self.reading {
            StiffnessForm::Secant => self.strength * full,
            StiffnessForm::AboutTheMean(curve) => curve
                .max_stiffness()
                .max(self.strength * full * full / about),
        }
    }

    /// A representative stiffness of the rope at rest \[N\].
    #[must_use]
    pub fn representative_stiffness(&self) -> f64 {
        match &self.reading {
            StiffnessForm::Secant => self.strength * self.stiffness(15.0, 0.0),
            StiffnessForm::AboutTheMean(StaticElasticity::Linear(ea)) => *ea,
            StiffnessForm::AboutTheMean(StaticElasticity::TensionTable(table)) => {
                table.representative_stiffness()
            }
        }
    }

    /// Where the branch of a mean begins, its stiffness there \[N\] and its tension there \[N\].
    fn branch(&self, mean: &MeanState) -> (f64, f64, f64) {
        let percent = self.percent(mean.tension);
        match self.reading {
            StiffnessForm::Secant => {
                let stiffness = self.alpha + (self.beta + self.gamma) * percent;
                (0.0, self.strength * stiffness, 0.0)
            }
            StiffnessForm::AboutTheMean(_) => {
                let stiffness = self.strength * self.stiffness(percent, 0.0);
                (mean.strain, stiffness, mean.tension)
            }
        }
    }

    /// The strain, from where the branch begins, at which the rope goes slack.
    fn slack(&self, mean: &MeanState) -> f64 {
        self.slack_from(self.percent(mean.tension))
    }

    /// The same by the mean tension in percent of the breaking load.
    fn slack_from(&self, percent: f64) -> f64 {
        match self.reading {
            StiffnessForm::Secant => 0.0,
            StiffnessForm::AboutTheMean(_) => {
                let full = self.alpha + (self.beta + self.gamma) * percent;
                -0.01 * percent / full
            }
        }
    }

    /// The strain at rest under the breaking load.
    fn strain_parted(&self) -> f64 {
        0.01 * PARTED / (self.alpha + self.beta * PARTED)
    }
}

impl StaticElasticity {
    /// Tension and slope at a strain.
    #[must_use]
    pub fn at(&self, strain: f64) -> ElasticTension {
        match self {
            Self::Linear(ea) => ElasticTension {
                tension: ea * strain,
                by_strain: *ea,
            },
            Self::TensionTable(table) => table.at(strain),
        }
    }

    /// The strain at a tension \[N\].
    #[must_use]
    pub fn strain_at(&self, tension: f64) -> f64 {
        match self {
            Self::Linear(ea) => tension / ea,
            Self::TensionTable(table) => table.strain_at(tension),
        }
    }

    fn max_stiffness(&self) -> f64 {
        match self {
            Self::Linear(ea) => *ea,
            Self::TensionTable(table) => table.max_stiffness(),
        }
    }
}

/// The integral of `e / (1 + c e)` from zero: `(c e - ln(1 + c e)) / c²`, by its series where c e is small.
fn bend(c: f64, e: f64) -> f64 {
    let x = c * e;
    if x.abs() < 1e-2 {
        let series = 0.5 - x * (1.0 / 3.0 - x * (0.25 - x * (0.2 - x * (1.0 / 6.0 - x / 7.0))));
        e * e * series
    } else {
        (x - x.ln_1p()) / (c * c)
    }
}

#[cfg(test)]
mod tests;
