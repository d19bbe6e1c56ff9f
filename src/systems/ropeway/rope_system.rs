//! The ropeway as a system in motion: its ropes as one, in two lines between platform and ship, and the cargo as a point between them.

use std::sync::atomic::AtomicBool;

use super::RopewayError;
use super::elastic::RopeEquilibrium;
use super::line::segments_beside_cargo;
use super::model::Ropeway;
use crate::case::Material;
use crate::case::Solver;
use crate::run::History;
use crate::system::SystemFile;
use crate::system::model::{LineInputs, PointInputs, PointKind, SlidingInputs};
use crate::system::motion::run::{MotionRun, run};
use crate::system::rest::UnsolvedSystem;
use crate::system::solved::solve;

/// Names of the points.
const PLATFORM: &str = "platform";
pub(super) const SHIP: &str = "ship";
pub(super) const CARGO: &str = "cargo";

/// Names of the lines, from the platform to the cargo and from there to the ship.
pub(super) const LINES: [&str; 2] = ["platform-side", "ship-side"];

/// The channel of the tension at the ship.
pub const SHIP_TENSION: &str = "tension_n[ship-side|b]";

/// Name of the material.
const ROPE: &str = "rope";

/// Axial damping, of critical of a segment's highest axial mode \[-\].
const AXIAL_DAMPING: f64 = 0.02;

/// Step of the crossing \[s\]: steps that vary are a sixth of it, to see the rope bounce along itself, and change its tension by 0.05 %.
const CROSSING_STEP: f64 = 0.05;

/// Least segments of the crossing: two are left beside the cargo at 5 % of the span.
const CROSSING_SEGMENTS: usize = 50;

/// The cargo hauled along the rope from where it rests to another arc length from the platform \[m\], the ship lying still and the
/// rope made fast.
#[must_use]
pub fn crossing(ropeway: &Ropeway, start: &RopeEquilibrium, to_m: f64) -> SystemFile {
    const RAMP: f64 = 2.0;
    let speed = ropeway.cargo.speed_m_per_s;
    let way = to_m - start.arc_m;
    let segments = ropeway.about.segments.max(CROSSING_SEGMENTS);
    let mut file = at_rest(ropeway, start, segments);
    let rate = speed.copysign(way);
    file.sliding_points = vec![SlidingInputs::hauled(CARGO, LINES, rate, RAMP)];
    file.solver = Some(Solver {
        time_step_s: Some(CROSSING_STEP),
        error_estimate: false,
        // In the ramp it is as far behind as in half of it at rest.
        ..Solver::over(way.abs() / speed + 0.5 * RAMP)
    });
    file
}

/// Step with the ship moving \[s\].
const STEP: f64 = 0.05;

/// The rope made fast with the cargo at its place, the ship's end moved from rest along displacements over time \[s, m\], which grow over a ramp
/// \[s\], with results at an interval \[s\].
#[must_use]
pub fn at_moving_ship(
    ropeway: &Ropeway,
    rest: &RopeEquilibrium,
    displacements: impl IntoIterator<Item = (f64, [f64; 3])>,
    (duration_s, ramp_s, interval_s): (f64, f64, f64),
) -> SystemFile {
    let mut file = at_rest(ropeway, rest, ropeway.about.segments);
    if let Some(ship) = file.points.get_mut(SHIP) {
        ship.kind = PointKind::Moved;
        ship.ramp_s = ramp_s;
        for (time, [x, y, z]) in displacements {
            ship.table_time_s.push(time);
            ship.table_x_m.push(x);
            ship.table_y_m.push(y);
            ship.table_z_m.push(z);
        }
    }
    file.solver = Some(Solver {
        time_step_s: Some(STEP),
        ..Solver::over(duration_s)
    });
    file.output.interval_s = interval_s;
    file
}

/// The ropeway at rest with the cargo at its place on the rope, nowhere near a support, in so many segments.
#[must_use]
pub fn at_rest(ropeway: &Ropeway, rest: &RopeEquilibrium, segments: usize) -> SystemFile {
    let about = &ropeway.about;
    let mut file = SystemFile::new(&about.title);
    file.environment.gravity_m_per_s2 = about.gravity_m_per_s2;
    file.environment.water_density_kg_per_m3 = 0.0;
    file.materials.insert(ROPE.to_owned(), material(ropeway));
    let (platform, ship) = (ropeway.platform.height_m, ropeway.ship.height_m);
    let (x, z) = (rest.cargo_m.0, platform + rest.cargo_m.1);
    let points = [
        (PLATFORM, PointInputs::fixed([0.0, 0.0, platform])),
        (CARGO, PointInputs::free(ropeway.cargo.mass_kg, [x, 0.0, z])),
        (SHIP, PointInputs::fixed([about.span_m, 0.0, ship])),
    ];
    for (name, point) in points {
        file.points.insert(name.to_owned(), point);
    }
    let parts = segments_beside_cargo(segments, rest.length_m, rest.arc_m);
    let ends = [[PLATFORM, CARGO], [CARGO, SHIP]];
    let lines = LINES.into_iter().zip(ends).zip(parts);
    let line =
        |((name, ends), (length, segments))| LineInputs::new(name, ends, ROPE, length, segments);
    file.lines = lines.map(line).collect();
    file
}

/// All ropes as one, of the diameter of a rope of the area of all.
fn material(ropeway: &Ropeway) -> Material {
    let squares = ropeway.ropes.iter().map(|rope| rope.diameter_m.powi(2));
    let mass = ropeway.weight_n_per_m() / ropeway.about.gravity_m_per_s2;
    Material {
        axial_damping_ratio: Some(AXIAL_DAMPING),
        ..Material::new(squares.sum::<f64>().sqrt(), mass, ropeway.ea_n())
    }
}

/// Computes a system in time.
///
/// # Errors
/// [`RopewayError::Motion`] where it does not come to rest, or the solver gives up, with time and node.
pub fn compute(file: SystemFile) -> Result<MotionRun, RopewayError> {
    let refused = |why: UnsolvedSystem| {
        RopewayError::Motion(format!("the divided rope has no start: {}", why.problem))
    };
    let solved = solve(file).map_err(refused)?;
    let given = solved.file.solver.clone().unwrap_or_default();
    let never = AtomicBool::new(false);
    let run = run(&solved, &given, &never, &mut |_| ()).map_err(refused)?;
    match run.failure {
        None => Ok(run),
        Some(why) => Err(RopewayError::Motion(format!(
            "the dynamic solver gave up on the rope {why}"
        ))),
    }
}

/// Values of a channel at the output times, by its name.
///
/// # Errors
/// [`RopewayError::NotFound`] where the run does not record it.
pub fn values<'a>(history: &'a History, channel: &str) -> Result<&'a [f64], RopewayError> {
    let found = history.channel(channel);
    found
        .map(|found| found.values.as_slice())
        .ok_or(RopewayError::NotFound(
            "the run of the rope lacks a channel",
        ))
}
