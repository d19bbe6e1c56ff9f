//! A line between two places: its forces on both ends and their stiffness.

use crate::line_between_ends::ClampedEquilibrium;
use crate::numerics::{M3, V3};
use crate::statics::catenary::{CatenaryError, Solution};

use super::discretised::DiscretisedRest;

/// A line at rest between its ends.
#[derive(Debug, Clone)]
pub struct LineAtRest {
    /// Force of the line on its end A \[N\].
    pub force_a: V3,
    /// Force of the line on its end B \[N\].
    pub force_b: V3,
    /// Change of the force on end i as end j moves \[N/m\].
    pub by_ends: [[M3; 2]; 2],
    /// The closed form, in the line's plane; nothing for a weightless line that is slack, of which no shape is determined.
    pub solution: Option<Solution>,
    /// Whether the closed form begins at end B.
    pub from_b: bool,
    /// Where the closed form begins \[m\], and the horizontal direction towards its other end.
    pub origin: V3,
    /// See `origin`.
    pub along: V3,
    /// What was left out, if anything.
    pub note: Option<LineNote>,
    /// Why a line of one section with the same length, weight and stretch stands in its place, as only a search may do.
    pub replaced: Option<CatenaryError>,
    /// Weight that weightless sections were given \[N\]: see [`weighted`](super::network::weighted).
    pub added_weight: f64,
    /// The line in segments, where it has no closed form.
    pub discretised: Option<Box<DiscretisedRest>>,
}

/// What was left out of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineNote {
    /// It lies between two suspended parts: friction there depends on how it was laid.
    WithoutFriction,
    /// Weightless and slack.
    ShapeUndetermined,
    /// It has none between its ends, and begins a run in a shape of its own.
    NoEquilibrium,
}

impl LineAtRest {
    /// Tensions at ends A and B \[N\].
    #[must_use]
    pub fn tensions(&self) -> [f64; 2] {
        [self.force_a.norm(), self.force_b.norm()]
    }

    /// The forces on ends A and B without what the bed bears of an end that lies on it \[N\]: a point there lies on the bed with all of the line
    /// that it holds, and is lifted only by a pull that lifts that too.
    #[must_use]
    pub fn forces_on_points(&self) -> [V3; 2] {
        let whole = [self.force_a, self.force_b];
        let Some(line) = &self.discretised else {
            return whole;
        };
        let borne = line.found.bed_reaction_n;
        [whole[0] - borne[0], whole[1] - borne[1]]
    }

    /// The change of these forces with the places of the ends, along the bed of an end that lies on it \[N/m\].
    #[must_use]
    pub fn stiffness_on_points(&self) -> [[M3; 2]; 2] {
        let mut by_ends = self.by_ends;
        if let Some(line) = &self.discretised {
            let turning = &line.found.bed_reaction_turning_n_per_m;
            for (end, turning) in turning.iter().enumerate() {
                by_ends[end][end] -= turning;
            }
        }
        by_ends
    }

    /// What its clamps do to the bodies that hold them, if any does.
    #[must_use]
    pub fn clamped(&self) -> Option<&ClampedEquilibrium> {
        let line = self.discretised.as_ref()?;
        line.found.clamped.as_deref()
    }

    /// Unstretched length on the bed, or against the surface \[m\].
    #[must_use]
    pub fn on_bed(&self) -> f64 {
        match &self.discretised {
            Some(line) => line.found.on_bed_m,
            None => self.solution.as_ref().map_or(0.0, |line| line.on_bed_m),
        }
    }

    /// Error of the forces on its ends by rounding \[N\]: what its own solution leaves out of balance.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        if let Some(line) = &self.discretised {
            return line.found.residual_n;
        }
        let greatest = self.tensions().into_iter().fold(0.0, f64::max);
        let own = self.solution.as_ref().map_or(0.0, |line| line.residual);
        (own + f64::EPSILON) * greatest + self.added_weight
    }

    /// A place of the line \[m\] and the tension there \[N\], at a share of its unstretched length from A.
    #[must_use]
    pub fn at(&self, share: f64, ends: [&V3; 2]) -> (V3, f64) {
        if let Some(line) = &self.discretised {
            return line.at(share);
        }
        let Some(line) = &self.solution else {
            return (ends[0].lerp(ends[1], share), 0.0);
        };
        let share = if self.from_b { 1.0 - share } else { share };
        let point = line.at(share * line.length_m());
        let place = self.origin + self.along * point.x_m + V3::z() * point.z_m;
        (place, point.tension_n)
    }
}
