//! A line of one section: brought into the solver's plane, its regime found, its answer verified.
//!
//! The solver's plane has A at the origin, B to the right and the weight pulling down: lines to the left
//! are mirrored, floating lines turned upside down (the surface above becomes a bed below).

use super::build;
use super::build_bed;
use super::error::CatenaryError;
use super::free;
use super::incline::{Incline, Outcome};
use super::line::{Bed, Ends, SectionProps};
use super::solution::{Frame, Seed, Solution};
use super::trough::Trough;

/// A line of one section in the solver's plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    pub x: f64,
    pub z: f64,
    pub length: f64,
    pub w: f64,
    pub ea: f64,
    pub bed: Option<Bed>,
    pub frame: Frame,
}

/// Ends closer to the bed than this part of the line's size count as on it.
pub(super) const ON_BED: f64 = 1e-12;

/// Solves one section; `seed` comes from a neighbouring solution.
pub(super) fn solve(
    ends: Ends,
    section: SectionProps,
    bed: Option<Bed>,
    surface_above_a: Option<f64>,
    seed: Seed,
) -> Result<Solution, CatenaryError> {
    ends.check()?;
    section.check()?;
    if let Some(bed) = bed {
        bed.check()?;
        ends_above(&bed, ends.x_m, ends.z_m, section.length_m)?;
    }
    let plane = plane(ends, section, bed, surface_above_a)?;
    if let Some(straight) = build::straight(&plane)? {
        return Ok(straight);
    }
    match (plane.bed, seed) {
        (None, _) => hanging(&plane, seed),
        (Some(bed), Seed::Free(_)) => match hanging(&plane, seed) {
            Ok(found) if !touches(&plane, &bed, &found) => Ok(found),
            _ => over_bed(&plane, bed, Seed::None),
        },
        (Some(bed), _) => over_bed(&plane, bed, seed),
    }
}

fn plane(
    ends: Ends,
    section: SectionProps,
    bed: Option<Bed>,
    surface_above_a: Option<f64>,
) -> Result<Plane, CatenaryError> {
    let floats = section.weight_n_per_m < 0.0;
    let up = if floats { -1.0 } else { 1.0 };
    let bed = if floats {
        surface(surface_above_a, ends.z_m, section.length_m)?
    } else {
        bed
    };
    Ok(Plane {
        x: ends.x_m.abs(),
        z: up * ends.z_m,
        length: section.length_m,
        w: section.weight_n_per_m.abs(),
        ea: section.ea_n,
        bed,
        frame: Frame {
            along: if ends.x_m < 0.0 { -1.0 } else { 1.0 },
            up,
        },
    })
}

/// The surface as the bed of the line turned upside down.
fn surface(above_a: Option<f64>, z: f64, length: f64) -> Result<Option<Bed>, CatenaryError> {
    let Some(above) = above_a else {
        return Ok(None);
    };
    let slip = ON_BED * (length + z.abs());
    for (end, over) in [('A', -above), ('B', z - above)] {
        if over.is_nan() || over > slip {
            return Err(CatenaryError::EndAboveSurface { end, above_m: over });
        }
    }
    Ok(Some(Bed {
        below_a_m: above.max(0.0),
        ..Bed::default()
    }))
}

/// Both ends must be on the bed or above.
pub(super) fn ends_above(bed: &Bed, x: f64, z: f64, length: f64) -> Result<(), CatenaryError> {
    let rise = x.abs() * bed.slope_rad.tan();
    let slip = ON_BED * (length + z.abs() + rise.abs());
    for (end, height) in [('A', bed.below_a_m), ('B', bed.below_a_m + z - rise)] {
        if height < -slip {
            return Err(CatenaryError::EndBelowBed {
                end,
                below_m: -height,
            });
        }
    }
    Ok(())
}

/// The line as if there were no bed.
fn hanging(plane: &Plane, seed: Seed) -> Result<Solution, CatenaryError> {
    let start = match seed {
        Seed::Free(xi) => Some(xi),
        _ => None,
    };
    let found = free::solve(plane.x, plane.z, plane.length, plane.w, plane.ea, start);
    let found = found.ok_or(CatenaryError::NotVerified {
        error: f64::INFINITY,
        iterations: 200,
    })?;
    build::hanging(plane, found)
}

/// Whether a free line would pass under the bed.
fn touches(plane: &Plane, bed: &Bed, found: &Solution) -> bool {
    let tan = bed.slope_rad.tan();
    // In the solver's plane; the line runs along the bed's slope where V = H tan θ.
    let up = plane.frame.up;
    let va = if up > 0.0 { found.v_a_n } else { -found.v_a_n };
    let along = found.h_a_n * tan - va;
    let s = along / plane.w;
    if !(along > 0.0 && s < plane.length) {
        return false;
    }
    let low = found.at(s);
    let height = bed.below_a_m + up * low.z_m - low.x_m.abs() * tan;
    height < -1e-9 * (plane.length + plane.z.abs())
}

/// A line over a bed.
fn over_bed(plane: &Plane, bed: Bed, seed: Seed) -> Result<Solution, CatenaryError> {
    // Without friction on a level bed even the shortest leg down from A is a leg.
    let legless = if bed.friction > 0.0 || bed.slope_rad != 0.0 {
        ON_BED * plane.length
    } else {
        0.0
    };
    if bed.below_a_m <= legless {
        on_incline(plane, bed, seed)
    } else if bed.slope_rad != 0.0 {
        let found = hanging(plane, seed)?;
        if touches(plane, &bed, &found) {
            return Err(CatenaryError::SlopeBelowA);
        }
        Ok(found)
    } else {
        over_trough(plane, bed, seed)
    }
}

fn on_incline(plane: &Plane, bed: Bed, seed: Seed) -> Result<Solution, CatenaryError> {
    let (sin, cos) = bed.slope_rad.sin_cos();
    let tan = bed.slope_rad.tan();
    let height = plane.z - plane.x * tan;
    let slip = ON_BED * (plane.length + plane.z.abs());
    let incline = Incline {
        x: plane.x,
        z: plane.z,
        length: plane.length,
        w: plane.w,
        ea: plane.ea,
        sin,
        cos,
        tan,
        friction: bed.friction,
        height: if height <= slip && bed.slope_rad != 0.0 {
            0.0
        } else {
            height.max(0.0)
        },
    };
    let start = match seed {
        Seed::Leg(beta) => Some(beta),
        _ => None,
    };
    match incline.solve(start)? {
        Outcome::Lifted => lifted(plane, &bed, seed),
        Outcome::Partly(state, iterations) => build_bed::partly(plane, &incline, state, iterations),
        Outcome::Wholly(tension) => build_bed::wholly(plane, &incline, tension),
        Outcome::Slack(straight) => build_bed::slack(plane, &incline, straight),
    }
}

fn over_trough(plane: &Plane, bed: Bed, seed: Seed) -> Result<Solution, CatenaryError> {
    let trough = Trough {
        x: plane.x,
        length: plane.length,
        w: plane.w,
        ea: plane.ea,
        rise: [bed.below_a_m, (bed.below_a_m + plane.z).max(0.0)],
    };
    let start = match seed {
        Seed::Trough(h) => Some(h),
        _ => None,
    };
    let Some(lying) = trough.solve(start) else {
        return lifted(plane, &bed, seed);
    };
    if bed.friction > 0.0 && lying.h > 0.0 {
        return Err(CatenaryError::FrictionUndetermined);
    }
    build_bed::trough(plane, &trough, &lying)
}

/// The bed said "not reached": the free line must agree.
fn lifted(plane: &Plane, bed: &Bed, seed: Seed) -> Result<Solution, CatenaryError> {
    let found = hanging(plane, seed)?;
    if touches(plane, bed, &found) {
        return Err(CatenaryError::NotVerified {
            error: f64::INFINITY,
            iterations: found.iterations,
        });
    }
    Ok(found)
}
