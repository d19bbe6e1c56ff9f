//! A line between two places: its forces on both ends and their stiffness.

use crate::numerics::{M3, V3};
use crate::scene::LaidFrom;
use crate::statics::catenary::{
    CatenaryError, CatenaryLine, CrossingLine, EndOffset, EndStiffness, RigidBed,
    SectionProperties, Solution,
};

use super::discretised::DiscretisedRest;
use super::laid::end_lies;
use super::network::{Line, Network, weight, weighted};

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
    /// Weight that weightless sections were given \[N\]: see [`weighted`].
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

/// Which part of the physics of the lines counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinePhysics {
    /// Weight and stretch, as in the first search.
    Plain,
    /// Friction of the bed, current, wind and bending as well.
    Full,
}

/// The line between places `a` and `b`; `from` is where it was laid from if it lies on a rough bed from end to end, `before` a
/// solution near by.
///
/// # Errors
/// As [`CatenaryLine::solve`], but for weightless slack lines, which pull on nothing.
pub fn solve(
    network: &Network,
    line: &Line,
    (a, b): (&V3, &V3),
    (physics, from): (LinePhysics, Option<LaidFrom>),
    before: Option<&LineAtRest>,
) -> Result<LineAtRest, CatenaryError> {
    let from_b = match from {
        Some(LaidFrom::Share(share)) => share >= 1.0,
        _ => b.z < a.z,
    };
    let (low, high) = if from_b { (b, a) } else { (a, b) };
    let level = level_below(network, (low, high)).filter(|_| line.bed_contact);
    let lies = level.is_some_and(|z| end_lies(line, low.z - z, low.z));
    let rough = physics == LinePhysics::Full && line.friction > 0.0;
    let rubs = rough && lies && from != Some(LaidFrom::HeldEnds);
    let mu = if rubs { line.friction } else { 0.0 };
    // Friction acts up to an end that lies on the bed: a leg down from it, and a rise down to it, would be of rounding.
    let (level, high_z) = match level {
        Some(_) if rubs => (Some(low.z), high.z.max(low.z)),
        _ => (level, high.z),
    };
    let raised = V3::new(high.x, high.y, high_z);
    let level = level.map(|z| (z, mu));
    let given = closed_form(network, line, (low, &raised), level, from_b);
    if let Some(LaidFrom::Share(share)) = from
        && share > 0.0
        && share < 1.0
        && let Ok((solution, stiffness)) = given.solve_laid_from(share)
    {
        return Ok(placed(solution, (low, high), from_b, &stiffness, None));
    }
    let seed = before.filter(|before| before.from_b == from_b);
    let near = seed.and_then(|before| before.solution.as_ref());
    let crosses = crosses(network, line, high.z);
    let displaced = match from_b {
        true => &line.displaced_reversed,
        false => &line.displaced,
    };
    let solve = |given: &CatenaryLine<'_>, near: Option<&Solution>| {
        if crosses {
            let crossing = CrossingLine {
                line: *given,
                displaced_n_per_m: displaced,
                a_above_m: low.z,
            };
            match crossing.solve() {
                // Near enough to begin with.
                Err(CatenaryError::AtSurface(_)) if physics == LinePhysics::Plain => {}
                found => return found,
            }
        }
        match near {
            Some(near) => given.solve_from(near),
            None => given.solve(),
        }
    };
    let mut solved = solve(&given, near);
    // Friction that depends on how the line was laid.
    let unknown_friction = mu > 0.0 && matches!(solved, Err(CatenaryError::UnsupportedContact(_)));
    let mut added_weight = line.added_weight;
    let (mu, taken) = match unknown_friction {
        true => (0.0, smooth(given)),
        false => (mu, given),
    };
    if unknown_friction {
        solved = solve(&taken, near);
    }
    if let Err(CatenaryError::NotVerified { .. }) = solved {
        let sections = weighted(taken.sections.to_vec(), SLACK_WEIGHT);
        added_weight += weight(&sections) - weight(taken.sections);
        let heavier = CatenaryLine {
            sections: &sections,
            ..taken
        };
        solved = solve(&heavier, None);
    }
    let solution = match solved {
        Ok(solution) => solution,
        Err(CatenaryError::ShapeUndetermined) => return Ok(slack()),
        Err(error @ CatenaryError::AtSurface(_)) => return Err(error),
        Err(error) if line.sections.len() > 1 => {
            return replaced(&taken, (low, high), from_b, error);
        }
        Err(error) => return Err(error),
    };
    let free_of_friction = unknown_friction || (rough && !lies && solution.on_bed_m > 0.0);
    let note = free_of_friction.then_some(LineNote::WithoutFriction);
    let stiffness = solution.end_stiffness(mu);
    Ok(LineAtRest {
        added_weight,
        ..placed(solution, (low, high), from_b, &stiffness, note)
    })
}

/// Whether a line between two places has a closed form: all of it, or where the bed below it is flat or it floats.
#[must_use]
pub fn has_closed_form(network: &Network, line: &Line, (a, b): (&V3, &V3)) -> bool {
    if line.discretised.is_none() || !line.closed_where_known {
        return line.discretised.is_none();
    }
    let bed = network.bed.as_ref().filter(|_| line.bed_contact);
    floats(network, line, a.z.max(b.z)) || bed.is_none_or(|bed| bed.flat_between(a, b).is_some())
}

/// Whether a line with its upper end at this height \[m\] leaves the water, or may do so between its ends.
fn crosses(network: &Network, line: &Line, high: f64) -> bool {
    network.crossed && (high > 0.0 || !line.sinks() && !floats(network, line, high))
}

/// Whether a line with its upper end at this height \[m\] floats below the surface.
fn floats(network: &Network, line: &Line, high: f64) -> bool {
    network.density > 0.0 && line.is_buoyant() && high <= 0.0
}

/// Height of the level bed that a closed form lies on \[m\]. Where the bed is not flat between the ends, that below the lower one: near the
/// equilibrium, which divided lines then have.
fn level_below(network: &Network, (low, high): (&V3, &V3)) -> Option<f64> {
    let bed = network.bed.as_ref()?;
    let flat = bed.flat_between(low, high);
    Some(flat.unwrap_or_else(|| bed.z_below(low).min(low.z)))
}

/// The closed form of a line from its lower end, on a level bed of this height \[m\] and friction.
fn closed_form<'a>(
    network: &Network,
    line: &'a Line,
    (low, high): (&V3, &V3),
    level: Option<(f64, f64)>,
    from_b: bool,
) -> CatenaryLine<'a> {
    let afloat = floats(network, line, high.z);
    CatenaryLine {
        ends: EndOffset::between([low.x, low.y, low.z], [high.x, high.y, high.z]),
        sections: if from_b {
            &line.reversed
        } else {
            &line.sections
        },
        bed: level.filter(|_| !afloat).map(|(z, friction)| RigidBed {
            below_a_m: low.z - z,
            slope_rad: 0.0,
            friction,
        }),
        surface_above_a_m: afloat.then_some(-low.z),
    }
}

/// Weight by the others' of a weightless section where the line is slack, which hangs by it: the less there is of it, the fewer
/// digits it leaves.
const SLACK_WEIGHT: f64 = 1e-7;

/// The line on a bed without friction.
fn smooth(line: CatenaryLine<'_>) -> CatenaryLine<'_> {
    let bed = line.bed.map(|bed| RigidBed {
        friction: 0.0,
        ..bed
    });
    CatenaryLine { bed, ..line }
}

/// The line with one section in the place of several that have no solution.
fn replaced(
    line: &CatenaryLine<'_>,
    ends: (&V3, &V3),
    from_b: bool,
    error: CatenaryError,
) -> Result<LineAtRest, CatenaryError> {
    let one = [equivalent(line.sections)];
    let solved = smooth(CatenaryLine {
        sections: &one,
        ..*line
    })
    .solve();
    let mut found = match solved {
        Ok(solution) => {
            let stiffness = solution.end_stiffness(0.0);
            placed(solution, ends, from_b, &stiffness, None)
        }
        Err(CatenaryError::ShapeUndetermined) => slack(),
        Err(error) => return Err(error),
    };
    found.replaced = Some(error);
    Ok(found)
}

/// One section of the same length, weight and stretch: close enough to search on where the sections have no solution.
fn equivalent(sections: &[SectionProperties]) -> SectionProperties {
    let sum = |of: fn(&SectionProperties) -> f64| sections.iter().map(of).sum::<f64>();
    let length = sum(|section| section.length_m);
    let weight = sum(|section| section.length_m * section.weight_n_per_m + section.clump_n);
    let stretch = sum(|section| section.length_m / section.ea_n);
    SectionProperties::new(length, weight / length, length / stretch)
}

/// A weightless line longer than the distance between its ends.
fn slack() -> LineAtRest {
    LineAtRest {
        force_a: V3::zeros(),
        force_b: V3::zeros(),
        by_ends: [[M3::zeros(); 2]; 2],
        solution: None,
        from_b: false,
        origin: V3::zeros(),
        along: V3::x(),
        note: Some(LineNote::ShapeUndetermined),
        replaced: None,
        added_weight: 0.0,
        discretised: None,
    }
}

/// The solution in its vertical plane as forces in space.
fn placed(
    solution: Solution,
    (low, high): (&V3, &V3),
    from_b: bool,
    k: &EndStiffness,
    note: Option<LineNote>,
) -> LineAtRest {
    let step = V3::new(high.x - low.x, high.y - low.y, 0.0);
    let distance = step.norm();
    let along = if distance > 0.0 {
        step / distance
    } else {
        V3::x()
    };
    let across = V3::new(-along.y, along.x, 0.0);
    let on_low = along * solution.h_a_n + V3::z() * solution.v_a_n;
    let on_high = -(along * solution.h_b_n) - V3::z() * solution.v_b_n;
    // Out of its plane the line turns with its ends; straight above each other it resists as in its plane.
    let sideways = |h: f64, by_distance: f64| {
        if distance > 0.0 {
            h / distance
        } else {
            by_distance
        }
    };
    let block = |h: &[f64; 3], v: &[f64; 3], h_now: f64| {
        let force = |column: usize| along * h[column] + V3::z() * v[column];
        let turning = across * across.transpose() * sideways(h_now, h[0]);
        let by_high = force(0) * along.transpose() + turning + force(2) * V3::z().transpose();
        let by_low = force(1) * V3::z().transpose() - force(0) * along.transpose() - turning;
        [by_low, by_high]
    };
    let low_row = block(&k.h_a, &k.v_a, solution.h_a_n);
    let high_row = block(&k.h_b, &k.v_b, solution.h_b_n).map(|block| -block);
    let (force_a, force_b, by_ends) = if from_b {
        let swap = |row: [M3; 2]| [row[1], row[0]];
        (on_high, on_low, [swap(high_row), swap(low_row)])
    } else {
        (on_low, on_high, [low_row, high_row])
    };
    LineAtRest {
        force_a,
        force_b,
        by_ends,
        solution: Some(solution),
        from_b,
        origin: *low,
        along,
        note,
        replaced: None,
        added_weight: 0.0,
        discretised: None,
    }
}
