//! The equilibrium of a line between two places, by its closed form where it has one, else in segments.

use super::{
    laid::end_lies,
    line_at_rest::{LineAtRest, LineNote},
    line_physics::LinePhysics,
    network::{Line, Network, weight, weighted},
};
use crate::{
    numerics::{M3, V3},
    scene::LaidFrom,
    statics::catenary::{
        CatenaryError, CatenaryLine, CrossingLine, EndOffset, EndStiffness, RigidBed,
        SectionProperties, Solution,
    },
};

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
    // In the plane of its ends it rubs along itself alone.
    let from = from.filter(|_| line.friction > 0.0);
    let CatenaryOnBed {
        form: given,
        ends: (low, high),
        from_b,
        surface,
        lies,
        rough,
        mu,
    } = on_its_bed(network, line, (a, b), (physics, from));
    if let Some(LaidFrom::Share(share)) = from
        && share > 0.0
        && share < 1.0
        && let Ok((solution, stiffness)) = given.solve_laid_from(share)
    {
        return Ok(placed(solution, (low, high), from_b, &stiffness, None));
    }
    let seed = before.filter(|before| before.from_b == from_b);
    let near = seed.and_then(|before| before.solution.as_ref());
    let solve = |given: &CatenaryLine<'_>, near| solve_closed_form(given, near, surface, physics);
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
        Err(error) => return without_solution(&taken, (low, high), from_b, error),
    };
    let free_of_friction = unknown_friction || (rough && !lies && solution.on_bed_m > 0.0);
    let note = free_of_friction.then_some(LineNote::WithoutFriction);
    let stiffness = solution.end_stiffness(mu);
    Ok(LineAtRest {
        added_weight,
        ..placed(solution, (low, high), from_b, &stiffness, note)
    })
}

/// The closed form of a line between its ends.
struct CatenaryOnBed<'a> {
    form: CatenaryLine<'a>,
    /// The end that the form begins at, and the other.
    ends: (&'a V3, &'a V3),
    from_b: bool,
    /// The weight of displaced water along the line \[N/m\] and the height of its first end above the surface \[m\], where it may cross it.
    surface: Option<(&'a [f64], f64)>,
    /// Whether the first end lies on the bed.
    lies: bool,
    /// Whether the bed is rough.
    rough: bool,
    /// The friction that acts on what lies.
    mu: f64,
}

/// The closed form of a line between two places on the bed below them.
fn on_its_bed<'a>(
    network: &Network,
    line: &'a Line,
    (a, b): (&'a V3, &'a V3),
    (physics, from): (LinePhysics, Option<LaidFrom>),
) -> CatenaryOnBed<'a> {
    let from_b = match from {
        Some(LaidFrom::Share(share)) => share >= 1.0,
        _ => b.z < a.z,
    };
    let (low, high) = if from_b { (b, a) } else { (a, b) };
    let level = level_below(network, line, (low, high)).filter(|_| line.bed_contact);
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
    let displaced: &[f64] = match from_b {
        true => &line.displaced_reversed,
        false => &line.displaced,
    };
    CatenaryOnBed {
        form: closed_form(network, line, (low, &raised), level, from_b),
        ends: (low, high),
        from_b,
        surface: crosses(network, line, high.z).then_some((displaced, low.z)),
        lies,
        rough,
        mu,
    }
}

/// Solves a closed form, near a solution where there is one; `surface` as in [`CatenaryOnBed`].
fn solve_closed_form(
    given: &CatenaryLine<'_>,
    near: Option<&Solution>,
    surface: Option<(&[f64], f64)>,
    physics: LinePhysics,
) -> Result<Solution, CatenaryError> {
    if let Some((displaced_n_per_m, a_above_m)) = surface {
        let crossing = CrossingLine {
            line: *given,
            displaced_n_per_m,
            a_above_m,
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
pub(super) fn floats(network: &Network, line: &Line, high: f64) -> bool {
    network.density > 0.0 && line.is_buoyant() && high <= 0.0
}

/// Height of the level bed that a closed form lies on \[m\]. Where the bed is not flat between the ends, that below the lower one: near the
/// equilibrium, which divided lines then have; as low as an end that has sunk into it.
fn level_below(network: &Network, line: &Line, (low, high): (&V3, &V3)) -> Option<f64> {
    let bed = network.bed.as_ref()?;
    let flat = bed.flat_between(low, high);
    let sinks = [line.from, line.to].map(|end| network.sinks_into_bed(end));
    match flat.filter(|level| sinks == [false; 2] && low.z >= *level) {
        Some(level) => Some(level),
        None => Some(flat.unwrap_or_else(|| bed.z_below(low)).min(low.z)),
    }
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

/// What stands for a line whose closed form has no solution.
fn without_solution(
    line: &CatenaryLine<'_>,
    ends: (&V3, &V3),
    from_b: bool,
    error: CatenaryError,
) -> Result<LineAtRest, CatenaryError> {
    match error {
        CatenaryError::ShapeUndetermined => Ok(slack()),
        CatenaryError::AtSurface(_) => Err(error),
        error if line.sections.len() > 1 => replaced(line, ends, from_b, error),
        error => Err(error),
    }
}

/// The line with one section in the place of several that have no solution.
pub(super) fn replaced(
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
pub(super) fn slack() -> LineAtRest {
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
