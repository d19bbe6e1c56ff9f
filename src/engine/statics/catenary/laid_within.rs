//! A line that lies on a level bed with friction from end to end, and is pulled at both ends: tension falls from both towards a place
//! between them.
//!
//! With `U(s)` the weight between that place and s, bodies included, and `T_0` the tension there,
//!
//! ```text
//! T(s) = max(0, T_0 + μ U(s))      x - L = Σ ∫ T/EA ds
//! ```
//!
//! where a negative `T_0` stands for line in the middle that is not pulled. The stretch is a convex function of it that rises, so that
//! Newton's method from above comes down to the root.

use super::candidate::Candidate;
use super::end_stiffness::EndStiffness;
use super::error::CatenaryError;
use super::line::{CatenaryLine, SectionProperties};
use super::profile::{PieceLaw, ProfileBuilder};
use super::solution::{CatenaryShape, LocalFrame, Solution, StartingUnknown};

/// Greatest number of Newton steps.
const MOST_STEPS: u32 = 200;

/// A part of the line, with the tension at its end next to the place that the line was laid from, and what a metre adds.
struct RubbedPart {
    length: f64,
    ea: f64,
    near: f64,
    gain: f64,
}

/// One side of the line under a tension at the place it was laid from.
struct Side {
    /// Its parts in order from that place.
    parts: Vec<RubbedPart>,
    /// Tension at its end \[N\].
    end: f64,
}

impl RubbedPart {
    fn far(&self) -> f64 {
        self.near + self.gain * self.length
    }

    /// Length under tension, which is next to the far end.
    fn taut(&self) -> f64 {
        if self.near >= 0.0 {
            self.length
        } else if self.far() <= 0.0 {
            0.0
        } else {
            self.far() / self.gain
        }
    }

    fn stretch(&self) -> f64 {
        0.5 * self.taut() * (self.near.max(0.0) + self.far().max(0.0)) / self.ea
    }

    /// Derivative of the stretch with respect to the tension.
    fn give(&self) -> f64 {
        self.taut() / self.ea
    }
}

impl Side {
    fn of_sections(sections: &[SectionProperties], friction: f64, at_place: f64) -> Self {
        let mut near = at_place;
        let mut parts = Vec::with_capacity(sections.len());
        for section in sections {
            let part = RubbedPart {
                length: section.length_m,
                ea: section.ea_n,
                near,
                gain: friction * section.weight_n_per_m,
            };
            near = part.far() + friction * section.clump_n;
            parts.push(part);
        }
        Self {
            parts,
            end: near.max(0.0),
        }
    }

    fn sum(&self, of: impl Fn(&RubbedPart) -> f64) -> f64 {
        self.parts.iter().map(of).sum()
    }
}

impl CatenaryLine<'_> {
    /// The line on a level bed from end to end, laid from a share of its length from A and pulled at both ends, and the change of the
    /// forces at its ends with their places.
    ///
    /// # Errors
    /// [`CatenaryError::UnsupportedContact`] for a line that does not lie so, or is slack; see [`CatenaryLine::solve`].
    pub fn solve_laid_from(&self, share: f64) -> Result<(Solution, EndStiffness), CatenaryError> {
        self.ends.check()?;
        for section in self.sections {
            section.check()?;
        }
        let bed = self.bed.filter(|bed| bed.slope_rad == 0.0);
        let sinks =
            |section: &SectionProperties| section.weight_n_per_m > 0.0 && section.clump_n >= 0.0;
        let whole: f64 = self.sections.iter().map(|section| section.length_m).sum();
        let wanted = self.ends.x_m.abs() - whole;
        let (Some(bed), true) = (bed, self.sections.iter().all(sinks) && wanted > 0.0) else {
            return Err(CatenaryError::UnsupportedContact(
                "a line is laid from within where it sinks all along, and lies stretched on a level bed",
            ));
        };
        let sides = self.sides(share * whole);
        let compliance: f64 = self
            .sections
            .iter()
            .map(|section| section.length_m / section.ea_n)
            .sum();
        let sides_at =
            |at_place: f64| [0, 1].map(|i| Side::of_sections(&sides[i], bed.friction, at_place));
        let (found, steps) = stretched_to(wanted, wanted / compliance, sides_at);
        let k = 1.0 / both(&found, RubbedPart::give);
        let miss = (both(&found, RubbedPart::stretch) - wanted).abs();
        let by_distance = |side: &Side| {
            if side.end > 0.0 {
                [k, 0.0, 0.0]
            } else {
                [0.0; 3]
            }
        };
        let stiffness = EndStiffness {
            h_a: by_distance(&found[0]),
            h_b: by_distance(&found[1]),
            ..EndStiffness::default()
        };
        let candidate = Candidate {
            ends: [(found[0].end, 0.0), (found[1].end, 0.0)],
            on_bed: whole,
            shape: CatenaryShape::WhollyOnBed,
            iterations: steps,
            residual: (k * (miss - 4.0 * f64::EPSILON * whole)).max(0.0)
                / found[0].end.max(found[1].end),
            stiffness: [[stiffness.h_b[0], 0.0], [0.0, 0.0]],
            seed: StartingUnknown::None,
        };
        let frame = LocalFrame {
            along: if self.ends.x_m < 0.0 { -1.0 } else { 1.0 },
            up: 1.0,
        };
        let profile = profile_over(&found);
        Ok((candidate.verified(frame, profile.pieces())?, stiffness))
    }

    /// The sections on both sides of an arc length from A \[m\], each in order away from there, with the bodies at their far ends.
    fn sides(&self, arc: f64) -> [Vec<SectionProperties>; 2] {
        let (mut before, mut after) = (Vec::new(), Vec::new());
        let mut begin = 0.0;
        // Weight of the body between the section before and this one.
        let mut body = 0.0;
        for section in self.sections {
            let inside = (arc - begin).clamp(0.0, section.length_m);
            if inside > 0.0 {
                before.push(SectionProperties {
                    length_m: inside,
                    clump_n: body,
                    ..*section
                });
            }
            if inside < section.length_m {
                after.push(SectionProperties {
                    length_m: section.length_m - inside,
                    ..*section
                });
            }
            begin += section.length_m;
            body = section.clump_n;
        }
        before.reverse();
        [before, after]
    }
}

/// A sum over the parts of both sides.
fn both(sides: &[Side; 2], of: fn(&RubbedPart) -> f64) -> f64 {
    sides[0].sum(of) + sides[1].sum(of)
}

/// Both sides under the tension at the place by which they stretch as far as wanted, by Newton's method from a tension above it, and its
/// steps.
fn stretched_to(wanted: f64, above: f64, sides_at: impl Fn(f64) -> [Side; 2]) -> ([Side; 2], u32) {
    let mut at_place = above;
    let mut steps = 0;
    loop {
        let here = sides_at(at_place);
        let step = (both(&here, RubbedPart::stretch) - wanted) / both(&here, RubbedPart::give);
        let size = here[0].end.max(here[1].end);
        steps += 1;
        if !step.is_finite() || step <= 4.0 * f64::EPSILON * size || steps >= MOST_STEPS {
            return (here, steps);
        }
        at_place -= step;
    }
}

/// The profile over both sides, from A.
fn profile_over(sides: &[Side; 2]) -> ProfileBuilder {
    let mut profile = ProfileBuilder::default();
    for part in sides[0].parts.iter().rev() {
        push_part(&mut profile, part, true);
    }
    for part in &sides[1].parts {
        push_part(&mut profile, part, false);
    }
    profile
}

/// Adds a part to the profile from A: one between A and the place that the line was laid from (`towards`) loses tension along it.
fn push_part(profile: &mut ProfileBuilder, part: &RubbedPart, towards: bool) {
    let taut = part.taut();
    let slack = (part.length - taut, 0.0, 0.0);
    let (near, far) = (part.near.max(0.0), part.far().max(0.0));
    let pulled = match towards {
        true => (taut, near, -part.gain),
        false => (taut, far, part.gain),
    };
    let ordered = if towards {
        [pulled, slack]
    } else {
        [slack, pulled]
    };
    for (length, end, loss) in ordered {
        if length > 0.0 {
            let law = PieceLaw::Grounded {
                end,
                loss,
                cos: 1.0,
                sin: 0.0,
                ea: part.ea,
            };
            let stretch = length * (end - 0.5 * loss * length) / part.ea;
            profile.push(length, law, (length + stretch, 0.0));
        }
    }
}
