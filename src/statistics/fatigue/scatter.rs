//! Damage of many sea states by their share of the time, and life.

use super::damage::{DamageError, positive};

/// Hours of a year of 365.25 days.
pub const HOURS_A_YEAR: f64 = 8766.0;

/// Why a scatter table cannot be summed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ScatterError {
    /// No sea state.
    #[error("the scatter table has no sea state")]
    Empty,
    /// A weight or damage that is none.
    #[error(
        "sea state {index} has the weight {weight} and the damage {per_hour} an hour; both are finite and not negative"
    )]
    State {
        /// Its place, from zero.
        index: usize,
        /// Its weight.
        weight: f64,
        /// Its damage an hour.
        per_hour: f64,
    },
    /// Probabilities that do not add up to one.
    #[error(
        "the probabilities add up to {sum}, not to 1 within {tolerance}; if they are numbers of observations, say so"
    )]
    Probabilities {
        /// Their sum.
        sum: f64,
        /// What was allowed.
        tolerance: f64,
    },
    /// More hours than a year has.
    #[error("the sea states take {sum} hours a year; a year has 8766")]
    Hours {
        /// Their sum.
        sum: f64,
    },
    /// Errors that are not as many as the sea states.
    #[error("{errors} relative errors for {states} sea states; there is one for each")]
    Errors {
        /// Number of errors.
        errors: usize,
        /// Number of sea states.
        states: usize,
    },
    /// Weights without any, or a tolerance that is none.
    #[error(transparent)]
    Number(#[from] DamageError),
}

/// What the weights of sea states are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weights {
    /// Probabilities that add up to one within a tolerance; they are used as they stand.
    Probabilities {
        /// Greatest difference of their sum from one.
        tolerance: f64,
    },
    /// Hours a year; what is missing from 8766 does no damage.
    HoursAYear,
    /// Numbers of observations, or any others: only their ratios count.
    Observations,
}

/// A sea state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaState {
    /// How often it occurs.
    pub weight: f64,
    /// Its damage in an hour.
    pub per_hour: f64,
}

/// Damage of a year.
#[derive(Debug, Clone, PartialEq)]
pub struct AnnualDamage {
    /// Of all sea states.
    pub sum: f64,
    /// Share of each sea state in it, in their order; zero where there is no damage.
    pub shares: Vec<f64>,
}

impl AnnualDamage {
    /// Relative error of the sum to first order, where the damage of each sea state has the relative error at its place, of
    /// either sign: the errors by their shares, added as if all had the same sign.
    ///
    /// # Errors
    /// Errors that are not as many as the sea states, or negative, or not finite.
    pub fn relative_error(&self, errors: &[f64]) -> Result<f64, ScatterError> {
        if errors.len() != self.shares.len() {
            let (errors, states) = (errors.len(), self.shares.len());
            return Err(ScatterError::Errors { errors, states });
        }
        for &value in errors {
            if !(value >= 0.0 && value.is_finite()) {
                let name = "the relative error of a damage";
                return Err(DamageError::NotPositive { name, value }.into());
            }
        }
        let parts = self.shares.iter().zip(errors);
        Ok(parts.map(|(share, error)| share * error).sum())
    }

    /// Life in years with a design factor (1 or more by most rules: API RP 2SK 3, DNV-OS-E301 5 to 8): `1 / (factor sum)`.
    /// `None` where there is no damage.
    ///
    /// # Errors
    /// A factor that is not positive.
    pub fn life(&self, design_factor: f64) -> Result<Option<f64>, DamageError> {
        life(self.sum, design_factor)
    }
}

/// Life in years at a damage a year, with a design factor; `None` where there is no damage or it is too small for a number.
///
/// # Errors
/// A damage that is negative or not finite; a factor that is not positive.
pub fn life(per_year: f64, design_factor: f64) -> Result<Option<f64>, DamageError> {
    positive("the design factor", design_factor)?;
    if per_year == 0.0 {
        return Ok(None);
    }
    let years = 1.0 / positive("the damage a year", per_year)? / design_factor;
    Ok(Some(years).filter(|years| years.is_finite()))
}

/// Damage of a year of sea states.
///
/// # Errors
/// No sea state; a weight or damage that is negative or not finite; weights that do not add up to what they should.
pub fn annual_damage(states: &[SeaState], weights: Weights) -> Result<AnnualDamage, ScatterError> {
    if states.is_empty() {
        return Err(ScatterError::Empty);
    }
    for (index, &SeaState { weight, per_hour }) in states.iter().enumerate() {
        let is_good = |v: f64| v >= 0.0 && v.is_finite();
        if !is_good(weight) || !is_good(per_hour) {
            return Err(ScatterError::State {
                index,
                weight,
                per_hour,
            });
        }
    }
    let hours = hours_per_weight(states.iter().map(|s| s.weight).sum(), weights)?;
    let parts: Vec<f64> = states
        .iter()
        .map(|s| s.weight * hours * s.per_hour)
        .collect();
    let sum: f64 = parts.iter().sum();
    if !sum.is_finite() {
        return Err(DamageError::Overflow.into());
    }
    let share = |part: &f64| if sum > 0.0 { part / sum } else { 0.0 };
    Ok(AnnualDamage {
        sum,
        shares: parts.iter().map(share).collect(),
    })
}

/// Hours a year of a weight of one.
fn hours_per_weight(sum: f64, weights: Weights) -> Result<f64, ScatterError> {
    match weights {
        Weights::Probabilities { tolerance } => {
            positive("the tolerance of the sum of the probabilities", tolerance)?;
            if (sum - 1.0).abs() <= tolerance {
                Ok(HOURS_A_YEAR)
            } else {
                Err(ScatterError::Probabilities { sum, tolerance })
            }
        }
        // Tables are rounded; a full year may come out a little longer.
        Weights::HoursAYear if sum <= HOURS_A_YEAR * (1.0 + 1e-6) => Ok(1.0),
        Weights::HoursAYear => Err(ScatterError::Hours { sum }),
        Weights::Observations => Ok(HOURS_A_YEAR / positive("the sum of the weights", sum)?),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    fn states(rows: &[(f64, f64)]) -> Vec<SeaState> {
        let row = |&(weight, per_hour): &(f64, f64)| SeaState { weight, per_hour };
        rows.iter().map(row).collect()
    }

    #[test]
    fn two_sea_states() {
        let table = states(&[(0.75, 1e-6), (0.25, 5e-6)]);
        let exact = Weights::Probabilities { tolerance: 1e-9 };
        let year = annual_damage(&table, exact).unwrap();
        assert!((year.sum - 2e-6 * 8766.0).abs() < 1e-15);
        assert!((year.shares[1] - 0.625).abs() < 1e-12);
        assert!((year.relative_error(&[0.1, 0.2]).unwrap() - 0.1625).abs() < 1e-12);
        assert!(
            year.relative_error(&[0.1]).is_err() && year.relative_error(&[0.1, f64::NAN]).is_err()
        );
        let life = year.life(5.0).unwrap().unwrap();
        assert!((life - 1.0 / (5.0 * 2e-6 * 8766.0)).abs() < 1e-9);
        let observed = annual_damage(
            &states(&[(30.0, 1e-6), (10.0, 5e-6)]),
            Weights::Observations,
        );
        assert!((observed.unwrap().sum - year.sum).abs() < 1e-15);
        let hours = annual_damage(&states(&[(100.0, 1e-6)]), Weights::HoursAYear).unwrap();
        assert!((hours.sum - 1e-4).abs() < 1e-15);
    }

    #[test]
    fn no_damage_lasts_for_ever() {
        let year = annual_damage(&states(&[(1.0, 0.0)]), Weights::Observations).unwrap();
        assert_eq!((year.life(3.0).unwrap(), year.shares), (None, vec![0.0]));
        assert_eq!(life(1e-320, 1.0).unwrap(), None);
    }

    #[test]
    fn weights_must_add_up() {
        let table = states(&[(0.5, 1e-6), (0.4, 5e-6)]);
        let error = annual_damage(&table, Weights::Probabilities { tolerance: 0.01 }).unwrap_err();
        assert!(error.to_string().contains("add up to 0.9"));
        assert!(
            annual_damage(
                &table,
                Weights::Probabilities {
                    tolerance: f64::NAN
                }
            )
            .is_err()
        );
        assert!(annual_damage(&states(&[(9000.0, 1.0)]), Weights::HoursAYear).is_err());
        assert!(annual_damage(&states(&[(0.0, 1.0)]), Weights::Observations).is_err());
        assert!(annual_damage(&[], Weights::HoursAYear).is_err());
        assert!(annual_damage(&states(&[(-1.0, 1.0)]), Weights::Observations).is_err());
        assert!(
            life(1.0, 0.0).is_err() && life(f64::NAN, 1.0).is_err() && life(-1.0, 1.0).is_err()
        );
    }

    #[test]
    fn whatever_comes_is_finite_or_refused() {
        let mut random = Random::new(16, 0);
        let odd = [0.0, 1.0, 0.5, -1.0, 1e-320, 1e308, f64::NAN, f64::INFINITY];
        for turn in 0..5000 {
            let mut pick = || odd[(odd.len() as f64 * random.uniform()) as usize];
            let table: Vec<SeaState> = (0..turn % 3)
                .map(|_| SeaState {
                    weight: pick(),
                    per_hour: pick(),
                })
                .collect();
            let weights = match turn % 4 {
                0 => Weights::Probabilities { tolerance: pick() },
                1 => Weights::HoursAYear,
                _ => Weights::Observations,
            };
            if let Ok(year) = annual_damage(&table, weights) {
                assert!(year.sum.is_finite() && year.shares.iter().all(|s| s.is_finite()));
                if let Ok(Some(life)) = year.life(pick()) {
                    assert!(life.is_finite());
                }
            }
        }
    }
}
