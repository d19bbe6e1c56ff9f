//! A component whose fatigue is sought: a curve with what turns a tension into its x.

use super::curve::{CurveError, Law, check};

/// What the range of a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RangeKind {
    /// From trough to crest, as in API RP 2SK and DNV-OS-E301.
    #[default]
    DoubleAmplitude,
    /// Half of it.
    Amplitude,
}

impl RangeKind {
    /// Its part of a double amplitude.
    #[must_use]
    pub fn part(self) -> f64 {
        match self {
            Self::DoubleAmplitude => 1.0,
            Self::Amplitude => 0.5,
        }
    }
}

/// What the x of a curve is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// Tension over the reference strength.
    TensionRatio,
    /// Nominal stress in MPa: tension over this area, m2.
    Stress {
        /// Nominal area, m2.
        nominal_area: f64,
    },
}

/// Nominal area of a chain link of a bar diameter in m: both bars, `2 π d²/4`, m2 (DNV-OS-E301, Ch.2 Sec.2).
#[must_use]
pub fn chain_area(diameter: f64) -> f64 {
    0.5 * std::f64::consts::PI * diameter * diameter
}

/// Nominal area of a rope of a diameter in m: `π d²/4`, m2 (DNV-OS-E301, Ch.2 Sec.2).
#[must_use]
pub fn rope_area(diameter: f64) -> f64 {
    0.25 * std::f64::consts::PI * diameter * diameter
}

/// A curve with what turns a tension into its x: a component whose fatigue is sought.
#[derive(Debug, Clone, PartialEq)]
pub struct FatigueComponent {
    title: String,
    law: Law,
    measure: Measure,
    range_kind: RangeKind,
    strength: Option<f64>,
    /// x of a range of tension of 1 N.
    scale: f64,
}

/// Damage of one cycle, with its slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleDamage {
    /// One over the cycles to failure; zero of a range of zero.
    pub damage: f64,
    /// d ln(damage) / d ln(range): the exponent that holds at the range.
    pub exponent: f64,
    /// d ln(damage) / d(mean), 1/N.
    pub mean_slope: f64,
}

impl FatigueComponent {
    /// Of a curve; `strength` is the reference (breaking) strength in N, which tension ratios and mean loads need.
    ///
    /// # Errors
    /// Numbers of the law outside their bounds; area or strength outside 1e-8 to 1e4 m2 and 1 to 1e12 N; no strength where
    /// one is needed.
    pub fn new(
        title: impl Into<String>,
        law: Law,
        measure: Measure,
        strength: Option<f64>,
    ) -> Result<Self, CurveError> {
        let law = law.checked()?;
        if let Some(strength) = strength {
            check(
                "the reference strength in N",
                strength,
                1.0..=1e12,
                "from 1 to 1e12 N",
            )?;
        }
        let scale = match (measure, strength) {
            (Measure::TensionRatio, Some(strength)) => 1.0 / strength,
            (Measure::TensionRatio, None) => {
                let reason = "its range is a tension over it";
                return Err(CurveError::NoStrength { reason });
            }
            (Measure::Stress { nominal_area }, _) => {
                check(
                    "the nominal area in m2",
                    nominal_area,
                    1e-8..=1e4,
                    "from 1e-8 to 1e4 m2",
                )?;
                1e-6 / nominal_area
            }
        };
        if law.mean_slope > 0.0 && strength.is_none() {
            let reason = "its constant depends on the mean load over it";
            return Err(CurveError::NoStrength { reason });
        }
        Ok(Self {
            title: title.into(),
            law,
            measure,
            range_kind: RangeKind::default(),
            strength,
            scale,
        })
    }

    /// The same for a curve whose range is of another kind.
    #[must_use]
    pub fn with_range_kind(mut self, kind: RangeKind) -> Self {
        self.scale *= kind.part() / self.range_kind.part();
        self.range_kind = kind;
        self
    }

    /// The same with all ranges times a factor: stress concentration, thickness.
    ///
    /// # Errors
    /// A factor outside 0.01 to 100.
    pub fn with_range_factor(mut self, factor: f64) -> Result<Self, CurveError> {
        self.scale *= check(
            "the factor of the range",
            factor,
            0.01..=100.0,
            "from 0.01 to 100",
        )?;
        Ok(self)
    }

    /// The same for stresses in Pa in the place of tensions in N: a curve of stress over an area of 1 m2. Nothing of a curve of tension
    /// or of one whose constant depends on the mean load.
    #[must_use]
    pub fn of_stress(&self) -> Option<Self> {
        let Measure::Stress { nominal_area } = self.measure else {
            return None;
        };
        (self.law.mean_slope == 0.0).then(|| Self {
            measure: Measure::Stress { nominal_area: 1.0 },
            scale: self.scale * nominal_area,
            ..self.clone()
        })
    }

    /// The same under another title.
    #[must_use]
    pub fn with_title(mut self, title: &str) -> Self {
        title.clone_into(&mut self.title);
        self
    }

    /// What it is called.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Its law.
    #[must_use]
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// What its x is.
    #[must_use]
    pub fn measure(&self) -> Measure {
        self.measure
    }

    /// What its range is.
    #[must_use]
    pub fn range_kind(&self) -> RangeKind {
        self.range_kind
    }

    /// Its reference strength, N.
    #[must_use]
    pub fn strength(&self) -> Option<f64> {
        self.strength
    }

    /// The x of a double amplitude of tension in N.
    #[must_use]
    pub fn x(&self, range: f64) -> f64 {
        range * self.scale
    }

    /// Mean load over the reference strength; a mean below zero counts as zero, and so does any where it has no influence.
    ///
    /// # Errors
    /// A mean that is not finite, or not below the strength where it has an influence.
    pub fn mean_ratio(&self, mean: f64) -> Result<f64, CurveError> {
        check("the mean tension in N", mean, f64::MIN..=f64::MAX, "finite")?;
        match self.strength {
            Some(strength) if self.law.mean_slope > 0.0 => {
                if mean >= strength {
                    return Err(CurveError::MeanAboveStrength { mean, strength });
                }
                Ok((mean / strength).max(0.0))
            }
            _ => Ok(0.0),
        }
    }

    /// Damage of one cycle of a double amplitude and a mean of tension, N.
    ///
    /// # Errors
    /// A range that is negative or not finite, a mean as [`FatigueComponent::mean_ratio`] refuses, a damage above 1e300.
    pub fn cycle_damage(&self, range: f64, mean: f64) -> Result<CycleDamage, CurveError> {
        check(
            "the range of tension in N",
            range,
            0.0..=f64::MAX,
            "finite and not negative",
        )?;
        let ratio = self.mean_ratio(mean)?;
        let log10_x = self.x(range).log10();
        let (exponent, constant) = self.law.parts(ratio).at(log10_x);
        let log10_damage = exponent * log10_x - constant;
        if log10_damage > 300.0 {
            return Err(CurveError::Overflow { range });
        }
        let per_strength = if ratio > 0.0 {
            self.law.mean_slope
        } else {
            0.0
        };
        let by_mean = std::f64::consts::LN_10 * per_strength * exponent / self.law.exponent;
        Ok(CycleDamage {
            damage: 10.0_f64.powf(log10_damage),
            exponent,
            mean_slope: self.strength.map_or(0.0, |strength| by_mean / strength),
        })
    }

    /// Cycles to failure at a double amplitude and a mean of tension, N; infinite at a range of zero.
    ///
    /// # Errors
    /// Those of [`FatigueComponent::cycle_damage`].
    pub fn cycles_to_failure(&self, range: f64, mean: f64) -> Result<f64, CurveError> {
        Ok(1.0 / self.cycle_damage(range, mean)?.damage)
    }
}

#[cfg(test)]
mod tests;
