//! The damage of a hot spot, counted value by value: rainflow cycles and Miner's sum in the memory of the cycles that are still open.
//!
//! Values come step by step, and crests lie between steps: a turning point is the vertex of the parabola through the value and its
//! neighbours. It is the value itself where equal values follow each other, as those of a slack line do.

use super::component::FatigueComponent;
use super::damage::DamageError;
use super::rainflow::{Cycle, ThreePointCounter};
use super::turning_points::{Reversal, SeriesError};
use serde::{Deserialize, Serialize};

/// Why the damage of a hot spot cannot be counted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpotError {
    /// A curve with a knee whose constant falls with the mean load, which is known at the end only.
    #[error(
        "the constant of the curve falls with the mean load and the curve has a knee; count at recorded places, or take a curve with one of both"
    )]
    MeanAndKnee,
    /// A value that is none.
    #[error(transparent)]
    Series(#[from] SeriesError),
    /// A cycle that the curve refuses.
    #[error(transparent)]
    Damage(#[from] DamageError),
}

/// The damage of a hot spot over the time counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpotDamage {
    /// Miner's sum.
    pub sum: f64,
    /// Number of cycles, halves as 0.5.
    pub cycles: f64,
    /// Greatest range, in the unit of the values.
    pub greatest_range: f64,
    /// d(sum) / d(range), where all ranges grow by the same number.
    pub range_slope: f64,
}

/// Counts the cycles of a hot spot. It can be stored, and go on to the same bits.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpotCounter {
    cycles: ThreePointCounter,
    /// The latest value, and the one before it that differs.
    latest: Option<Reversal>,
    before: Option<Reversal>,
    /// Whether the latest value has come several times.
    is_level: bool,
    began: f64,
    until: f64,
    /// Integral of the value over time.
    area: f64,
    damage: SpotDamage,
}

impl SpotCounter {
    /// Whether a curve can be counted by: a mean load enters at the end, by one factor for all ranges.
    ///
    /// # Errors
    /// A curve that has a knee and a constant that falls with the mean load.
    pub fn check(component: &FatigueComponent) -> Result<(), SpotError> {
        let law = component.law();
        match law.mean_slope > 0.0 && law.knee.is_some() {
            true => Err(SpotError::MeanAndKnee),
            false => Ok(()),
        }
    }

    /// Takes the next value at its time \[s\]; does not allocate while no more than 64 cycles are open.
    ///
    /// # Errors
    /// A value that is not finite, or a cycle that the curve refuses.
    pub fn push(
        &mut self,
        component: &FatigueComponent,
        time: f64,
        value: f64,
    ) -> Result<(), SpotError> {
        let Some(last) = self.latest else {
            (self.began, self.until) = (time, time);
            self.latest = Some(Reversal { time, value });
            return self.take(component, time, value);
        };
        if time <= self.until {
            return Ok(());
        }
        self.area += 0.5 * (time - self.until) * (last.value + value);
        self.until = time;
        if value == last.value {
            // The neighbour of what follows is the last of equal values.
            self.latest = Some(Reversal { time, value });
            self.is_level = true;
            return Ok(());
        }
        let next = Reversal { time, value };
        if let Some(before) = self.before
            && (last.value > before.value) != (value > last.value)
        {
            let turn = match self.is_level {
                true => last.value,
                false => vertex(before, last, next),
            };
            self.take(component, last.time, turn)?;
        }
        (self.before, self.latest) = (self.latest, Some(next));
        self.is_level = false;
        Ok(())
    }

    fn take(
        &mut self,
        component: &FatigueComponent,
        time: f64,
        value: f64,
    ) -> Result<(), SpotError> {
        let damage = &mut self.damage;
        let mut refused = None;
        self.cycles.push(time, value, |cycle| {
            if let Err(why) = damage.add(component, &cycle) {
                refused.get_or_insert(why);
            }
        })?;
        refused.map_or(Ok(()), |why| Err(why.into()))
    }

    /// Ends the count: the damage, and the length of the time counted \[s\]. A constant that falls with the mean load takes that of the
    /// whole time, as API RP 2SK does.
    ///
    /// # Errors
    /// A cycle or a mean load that the curve refuses.
    pub fn finish(mut self, component: &FatigueComponent) -> Result<(SpotDamage, f64), SpotError> {
        if let (Some(last), true) = (self.latest, self.until > self.began) {
            let time = last.time;
            if time > self.began {
                self.take(component, time, last.value)?;
            }
        }
        let mut damage = self.damage;
        let mut refused = None;
        self.cycles.finish(|cycle| {
            if let Err(why) = damage.add(component, &cycle) {
                refused.get_or_insert(why);
            }
        });
        if let Some(why) = refused {
            return Err(why.into());
        }
        let duration = self.until - self.began;
        if component.law().mean_slope > 0.0 && damage.sum > 0.0 && duration > 0.0 {
            let of = |mean: f64| component.cycle_damage(damage.greatest_range, mean);
            let mean = of(self.area / duration).map_err(DamageError::from)?;
            let none = of(0.0).map_err(DamageError::from)?;
            let factor = mean.damage / none.damage;
            damage.sum *= factor;
            damage.range_slope *= factor;
        }
        Ok((damage, duration))
    }

    /// Whether a state read from a file could be that of a hot spot.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let SpotDamage {
            sum,
            cycles,
            greatest_range,
            range_slope,
        } = self.damage;
        let numbers = [
            self.began,
            self.until,
            self.area,
            sum,
            cycles,
            greatest_range,
            range_slope,
        ];
        let reversals = [self.latest, self.before];
        self.cycles.is_sound()
            && numbers.iter().all(|number| number.is_finite())
            && reversals.iter().flatten().all(Reversal::is_sound)
    }
}

impl SpotDamage {
    /// Adds a cycle at no mean load.
    fn add(&mut self, component: &FatigueComponent, cycle: &Cycle) -> Result<(), DamageError> {
        let one = component.cycle_damage(cycle.range, 0.0)?;
        let damage = cycle.count * one.damage;
        let sum = self.sum + damage;
        if !sum.is_finite() {
            return Err(DamageError::Overflow);
        }
        self.sum = sum;
        self.cycles += cycle.count;
        self.greatest_range = self.greatest_range.max(cycle.range);
        if cycle.range > 0.0 {
            self.range_slope += damage * one.exponent / cycle.range;
        }
        Ok(())
    }
}

/// The extreme of the parabola through a value that turns and its neighbours.
fn vertex(before: Reversal, turn: Reversal, after: Reversal) -> f64 {
    let (early, late) = (turn.time - before.time, after.time - turn.time);
    let rise = (turn.value - before.value) / early;
    let fall = (after.value - turn.value) / late;
    let curvature = (fall - rise) / (early + late);
    let slope = (rise * late + fall * early) / (early + late);
    turn.value - slope * slope / (4.0 * curvature)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::fatigue::component::Measure;
    use crate::fatigue::curve::Law;

    fn component(law: Law) -> FatigueComponent {
        let measure = Measure::Stress { nominal_area: 1.0 };
        FatigueComponent::new("wire", law, measure, Some(1e9)).unwrap()
    }

    fn counted(
        component: &FatigueComponent,
        values: impl Iterator<Item = (f64, f64)>,
    ) -> SpotDamage {
        let mut counter = SpotCounter::default();
        for (time, value) in values {
            counter.push(component, time, value).unwrap();
        }
        assert!(counter.is_sound());
        counter.finish(component).unwrap().0
    }

    /// A hundred periods of an amplitude in MPa, so many values each, off phase.
    fn harmonic(amplitude: f64, values: u32) -> impl Iterator<Item = (f64, f64)> {
        (0..=100 * values).map(move |k| {
            let time = (f64::from(k) + 0.37) / f64::from(values);
            (time, 1e6 * amplitude * (TAU * time).cos())
        })
    }

    #[test]
    fn a_harmonic_of_known_amplitude_has_the_damage_by_hand() {
        // n (2 A)^m / K, with crests between the values.
        let law = Law::new(3.0, 12.0);
        let by_hand = 100.0 * 80.0_f64.powi(3) / 1e12;
        for (values, off) in [(40, 1e-3), (20, 4e-3), (12, 2e-2)] {
            let found = counted(&component(law), harmonic(40.0, values));
            assert!(
                (found.sum / by_hand - 1.0).abs() < off,
                "{values}: {found:?}"
            );
            assert!((found.greatest_range / 80e6 - 1.0).abs() < off);
            let slope = 3.0 * found.sum / 80e6;
            assert!((found.range_slope / slope - 1.0).abs() < 0.02);
        }
        let none = counted(&component(law), [(0.0, 5.0), (1.0, 5.0)].into_iter());
        assert_eq!((none.sum, none.greatest_range), (0.0, 0.0));
    }

    #[test]
    fn a_slack_line_does_not_turn_below_what_it_holds() {
        let values = [5.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 5.0];
        let times = (0..).map(f64::from);
        let found = counted(&component(Law::new(1.0, 6.0)), times.zip(values));
        assert_eq!(found.greatest_range, 5.0);
    }

    #[test]
    fn a_mean_load_enters_by_one_factor_for_all_ranges() {
        let law = Law::new(4.0, 12.0).falling_with_mean(3.0);
        let (plain, falling) = (component(Law::new(4.0, 12.0)), component(law));
        let raised = |time: f64| (time, 2e8 + 1e7 * (TAU * time).sin());
        let times = || (0..=400).map(|k| raised(f64::from(k) / 40.0));
        let ratio = counted(&falling, times()).sum / counted(&plain, times()).sum;
        // The mean is a fifth of the strength.
        assert!(
            (ratio / 10.0_f64.powf(3.0 * 0.2) - 1.0).abs() < 1e-9,
            "{ratio}"
        );
        let both = component(law.with_knee(1e6, 5.0));
        assert_eq!(SpotCounter::check(&both), Err(SpotError::MeanAndKnee));
    }

    #[test]
    fn it_goes_on_from_what_is_stored() {
        let component = component(Law::new(3.0, 12.0));
        let (mut whole, mut stored) = (SpotCounter::default(), SpotCounter::default());
        for (number, (time, value)) in harmonic(30.0, 7).enumerate() {
            whole.push(&component, time, value).unwrap();
            stored.push(&component, time, value).unwrap();
            if number % 50 == 3 {
                let text = toml::to_string(&stored).unwrap();
                stored = toml::from_str(&text).unwrap();
            }
        }
        assert_eq!(whole.finish(&component), stored.finish(&component));
    }
}
