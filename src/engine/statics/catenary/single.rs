//! A line of one section: transformed to the local frame, its regime found, its solution verified.
//!
//! The local frame has A at the origin, B to the right and the weight pulling down: lines to the left
//! are mirrored, buoyant lines turned upside down (the surface above becomes a bed below).

use super::error::CatenaryError;
use super::grounded_solution;
use super::grounded_span::GroundedSpan;
use super::line::{EndOffset, RigidBed, SectionProperties};
use super::planar_line::{ON_BED, PlanarLine, ends_above};
use super::slope::Slope;
use super::solution::{LocalFrame, Solution, StartingUnknown};
use super::suspended;
use super::suspended_solution;
use super::touchdown::{TouchdownLine, TouchdownState};

/// Solves one section; `seed` comes from a neighbouring solution.
pub(super) fn solve(
    ends: EndOffset,
    section: SectionProperties,
    bed: Option<RigidBed>,
    surface_above_a: Option<f64>,
    seed: StartingUnknown,
) -> Result<Solution, CatenaryError> {
    ends.check()?;
    section.check()?;
    if let Some(bed) = bed {
        bed.check()?;
        ends_above(&bed, ends.x_m, ends.z_m, section.length_m)?;
    }
    let line = planar_line(ends, section, bed, surface_above_a)?;
    if let Some(straight) = suspended_solution::straight(&line)? {
        return Ok(straight);
    }
    match (line.bed, seed) {
        (None, _) => suspended_line(&line, seed),
        (Some(bed), StartingUnknown::Suspended(_)) => match suspended_line(&line, seed) {
            Ok(found) if !touches(&line, &bed, &found) => Ok(found),
            _ => over_bed(&line, bed, StartingUnknown::None),
        },
        (Some(bed), _) => over_bed(&line, bed, seed),
    }
}

fn planar_line(
    ends: EndOffset,
    section: SectionProperties,
    bed: Option<RigidBed>,
    surface_above_a: Option<f64>,
) -> Result<PlanarLine, CatenaryError> {
    let floats = section.weight_n_per_m < 0.0;
    let up = if floats { -1.0 } else { 1.0 };
    let bed = if floats {
        surface(surface_above_a, ends.z_m, section.length_m)?
    } else {
        bed
    };
    Ok(PlanarLine {
        x: ends.x_m.abs(),
        z: up * ends.z_m,
        length: section.length_m,
        w: section.weight_n_per_m.abs(),
        ea: section.ea_n,
        bed,
        frame: LocalFrame {
            along: if ends.x_m < 0.0 { -1.0 } else { 1.0 },
            up,
        },
    })
}

/// The surface as the bed of the line turned upside down.
fn surface(above_a: Option<f64>, z: f64, length: f64) -> Result<Option<RigidBed>, CatenaryError> {
    let Some(above) = above_a else {
        return Ok(None);
    };
    let slip = ON_BED * (length + z.abs());
    for (end, over) in [('A', -above), ('B', z - above)] {
        if over.is_nan() || over > slip {
            return Err(CatenaryError::EndAboveSurface { end, above_m: over });
        }
    }
    Ok(Some(RigidBed {
        below_a_m: above.max(0.0),
        ..RigidBed::default()
    }))
}

/// The suspended line, as if there were no bed.
fn suspended_line(line: &PlanarLine, seed: StartingUnknown) -> Result<Solution, CatenaryError> {
    let start = match seed {
        StartingUnknown::Suspended(xi) => Some(xi),
        _ => None,
    };
    let found = suspended::solve(line.x, line.z, line.length, line.w, line.ea, start);
    let found = found.ok_or(CatenaryError::NotVerified {
        error: f64::INFINITY,
        iterations: 200,
    })?;
    suspended_solution::suspended(line, found)
}

/// Whether a suspended line would pass under the bed.
fn touches(line: &PlanarLine, bed: &RigidBed, found: &Solution) -> bool {
    let tan = bed.slope_rad.tan();
    // In the local frame; the line runs along the bed's slope where V = H tan θ.
    let up = line.frame.up;
    let va = if up > 0.0 { found.v_a_n } else { -found.v_a_n };
    let along = found.h_a_n * tan - va;
    let s = along / line.w;
    if !(along > 0.0 && s < line.length) {
        return false;
    }
    let low = found.at(s);
    let height = bed.below_a_m + up * low.z_m - low.x_m.abs() * tan;
    height < -1e-9 * (line.length + line.z.abs())
}

/// A line over a bed.
fn over_bed(
    line: &PlanarLine,
    bed: RigidBed,
    seed: StartingUnknown,
) -> Result<Solution, CatenaryError> {
    // Without friction on a level bed even the shortest leg down from A is a leg.
    let legless = if bed.friction > 0.0 || bed.slope_rad != 0.0 {
        ON_BED * line.length
    } else {
        0.0
    };
    if bed.below_a_m <= legless {
        on_bed_through_a(line, bed, seed)
    } else if bed.slope_rad != 0.0 {
        let found = suspended_line(line, seed)?;
        if touches(line, &bed, &found) {
            return Err(CatenaryError::SlopeBelowA);
        }
        Ok(found)
    } else {
        over_level_bed(line, bed, seed)
    }
}

fn on_bed_through_a(
    line: &PlanarLine,
    bed: RigidBed,
    seed: StartingUnknown,
) -> Result<Solution, CatenaryError> {
    let slope = Slope::new(&bed);
    let height = line.z - line.x * slope.tan;
    let slip = ON_BED * (line.length + line.z.abs());
    let touchdown = TouchdownLine {
        line: *line,
        slope,
        height: if height <= slip && bed.slope_rad != 0.0 {
            0.0
        } else {
            height.max(0.0)
        },
    };
    let start = match seed {
        StartingUnknown::Touchdown(beta) => Some(beta),
        _ => None,
    };
    match touchdown.solve(start)? {
        TouchdownState::Clear => clear_of_bed(line, &bed, seed),
        TouchdownState::Partial(state, iterations) => {
            grounded_solution::partial_contact(&touchdown, state, iterations)
        }
        TouchdownState::Full(tension) => grounded_solution::full_contact(&touchdown, tension),
        TouchdownState::Slack(straight) => grounded_solution::slack_contact(&touchdown, straight),
    }
}

fn over_level_bed(
    line: &PlanarLine,
    bed: RigidBed,
    seed: StartingUnknown,
) -> Result<Solution, CatenaryError> {
    let grounded = GroundedSpan {
        line: *line,
        rise: [bed.below_a_m, (bed.below_a_m + line.z).max(0.0)],
    };
    let start = match seed {
        StartingUnknown::GroundedSpan(h) => Some(h),
        _ => None,
    };
    let Some(forces) = grounded.solve(start) else {
        return clear_of_bed(line, &bed, seed);
    };
    if bed.friction > 0.0 && forces.h > 0.0 {
        return Err(CatenaryError::FrictionUndetermined);
    }
    grounded_solution::grounded_span(&grounded, &forces)
}

/// The line is clear of the bed: the suspended line must confirm that.
fn clear_of_bed(
    line: &PlanarLine,
    bed: &RigidBed,
    seed: StartingUnknown,
) -> Result<Solution, CatenaryError> {
    let found = suspended_line(line, seed)?;
    if touches(line, bed, &found) {
        return Err(CatenaryError::NotVerified {
            error: f64::INFINITY,
            iterations: found.iterations,
        });
    }
    Ok(found)
}
