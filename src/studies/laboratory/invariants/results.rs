//! The results of a system that must not depend on how it is asked for, and where two of them disagree.

use std::collections::BTreeMap;

use super::variant::{NamedLineEnd, SystemVariant};
use crate::numerics::V3;

/// A number and the error that is stated of it, where one is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stated {
    pub(super) value: f64,
    pub(super) error: Option<f64>,
}

/// The same of a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StatedPlace {
    pub(super) place: V3,
    pub(super) error: [Option<f64>; 3],
}

/// Which number of a record: of a system at rest the only one.
pub(super) type Which = &'static str;

/// The results of a system.
#[derive(Debug, Clone, Default)]
pub(super) struct Results {
    /// Tensions at the ends of the lines \[N\].
    pub(super) tensions: BTreeMap<(NamedLineEnd, Which), Stated>,
    /// Places of points and bodies that move \[m\].
    pub(super) places: BTreeMap<(String, Which), StatedPlace>,
    /// Heights of points and bodies \[m\].
    pub(super) heights: BTreeMap<(String, Which), Stated>,
}

/// How far results may be apart that differ by rounding alone: by the greatest tension, and by the extent of the system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tolerance {
    pub(super) relative: f64,
    /// How errors stated count.
    pub(super) errors: Errors,
}

/// How the errors that are stated of two results count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Errors {
    /// Not: both are of the same discretised system.
    Ignored,
    /// They add to what is allowed where they are stated.
    Allowed,
    /// They add to what is allowed; numbers without them are not compared.
    Needed,
}

/// A result that depends on how it is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Violation {
    /// The result: `tension_n[l0|a]`.
    pub name: String,
    /// Its value in the system.
    pub value: f64,
    /// The same asked for otherwise.
    pub other: f64,
    /// How far they may be apart.
    pub allowed: f64,
}

impl Violation {
    /// By how many times what is allowed they are apart.
    #[must_use]
    pub fn excess(&self) -> f64 {
        (self.value - self.other).abs() / self.allowed.max(f64::MIN_POSITIVE)
    }
}

impl Results {
    /// Greatest tension \[N\].
    fn force(&self) -> f64 {
        self.tensions
            .values()
            .map(|t| t.value.abs())
            .fold(1.0, f64::max)
    }

    /// Greatest coordinate \[m\].
    fn extent(&self) -> f64 {
        let places = self.places.values().map(|p| p.place.amax());
        places
            .chain(self.heights.values().map(|h| h.value.abs()))
            .fold(1.0, f64::max)
    }

    /// The result in which those of a variant differ by the greatest multiple of what is allowed, and how many numbers were compared.
    pub(super) fn worst(
        &self,
        other: &Self,
        variant: &SystemVariant,
        tolerance: Tolerance,
    ) -> (usize, Option<Violation>) {
        let (force, extent) = (self.force(), self.extent());
        let mut comparison = ResultComparison {
            tolerance,
            compared: 0,
            worst: None,
        };
        for ((end, which), here) in &self.tensions {
            let there = variant.end(&end.0, end.1);
            if let Some(there) = other.tensions.get(&(there, *which)) {
                let name = || format!("{which} tension_n[{}|{}]", end.0, end.1);
                comparison.compare(name, (here, there), force);
            }
        }
        for ((part, which), here) in &self.heights {
            let there = variant.part(part).to_owned();
            if let Some(there) = other.heights.get(&(there, *which)) {
                comparison.compare(|| format!("{which} z_m[{part}]"), (here, there), extent);
            }
        }
        for ((part, which), here) in &self.places {
            let there = variant.part(part).to_owned();
            let Some(there) = other.places.get(&(there, *which)) else {
                continue;
            };
            let moved = variant.space.place(here.place);
            // Turned, the error along one axis is of both.
            let both = match (here.error[0], here.error[1]) {
                (Some(x), Some(y)) => Some(x + y),
                _ => None,
            };
            for (axis, word) in ["x_m", "y_m", "z_m"].into_iter().enumerate() {
                let of = |value: f64, error: Option<f64>| Stated { value, error };
                let error = if axis < 2 { both } else { here.error[2] };
                let numbers = (
                    &of(moved[axis], error),
                    &of(there.place[axis], there.error[axis]),
                );
                comparison.compare(|| format!("{which} {word}[{part}]"), numbers, extent);
            }
        }
        (comparison.compared, comparison.worst)
    }
}

struct ResultComparison {
    tolerance: Tolerance,
    compared: usize,
    worst: Option<Violation>,
}

impl ResultComparison {
    fn compare(
        &mut self,
        name: impl FnOnce() -> String,
        (here, there): (&Stated, &Stated),
        size: f64,
    ) {
        let rounding = self.tolerance.relative * size;
        let allowed = match (self.tolerance.errors, here.error, there.error) {
            (Errors::Ignored, ..) => rounding,
            (Errors::Allowed, one, other) => rounding + one.unwrap_or(0.0) + other.unwrap_or(0.0),
            (Errors::Needed, Some(one), Some(other)) => rounding + one + other,
            (Errors::Needed, ..) => return,
        };
        self.compared += 1;
        let apart = (here.value - there.value).abs();
        let worst = self.worst.as_ref().map_or(1.0, Violation::excess);
        // Not a number is apart from any.
        if apart.is_nan() || apart > worst * allowed {
            self.worst = Some(Violation {
                name: name(),
                value: here.value,
                other: there.value,
                allowed,
            });
        }
    }
}
