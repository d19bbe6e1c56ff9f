//! What bounds the steps of a line.

use super::Settings;
use super::settings::{STEPS_A_PERIOD, SceneBounds, motion_scale};
use crate::case::Case;
use crate::numerics::V3;
use crate::physics::EndMotion;
use crate::scene::{EndCondition, Scene};
use crate::solve::{Kinematics, StaticSearch};

/// The settings of a run of this case.
#[must_use]
pub fn settings(case: &Case, scene: &Scene) -> Settings {
    bounds(case, scene).settings(&case.solver, case.output.interval_s)
}

/// What bounds the steps of a line.
#[must_use]
pub fn bounds(case: &Case, scene: &Scene) -> SceneBounds {
    let (limit, segment) = scene.explicit_limit();
    let bounce = bounce_period(scene);
    let ends = motions(scene).filter_map(|motion| motion.longest_step(STEPS_A_PERIOD));
    let periods = motions(scene).filter_map(EndMotion::period);
    let at = || format!("segment {segment} ({})", section_of(case, scene, segment));
    SceneBounds {
        longest_step: ends.fold(bounce / STEPS_A_PERIOD, f64::min),
        forced_period: periods.fold(bounce, f64::min),
        stability: Some((limit, at())),
        explicit_limit: limit,
        position_tolerance: scene.position_tolerance(1e-4),
        nodes: scene.nodes(),
    }
}

/// The motions of the ends that are held.
fn motions(scene: &Scene) -> impl Iterator<Item = &EndMotion> {
    scene.line.ends.iter().filter_map(|end| match end {
        EndCondition::Prescribed(motion) => Some(motion),
        EndCondition::Free => None,
    })
}

/// Period of the line and its payload bouncing along themselves, `2 pi sqrt(m / k)` with k the line's axial stiffness \[s\].
#[must_use]
pub fn bounce_period(scene: &Scene) -> f64 {
    let line = &scene.line;
    let compliance = line.segments.iter().map(|s| s.axial.length / s.axial.ea);
    let added = line.bodies.iter().map(|b| b.body.greatest_added_mass());
    let mass = line.mass.iter().sum::<f64>() + added.sum::<f64>();
    std::f64::consts::TAU * (mass * compliance.sum::<f64>()).sqrt()
}

/// Distance \[m\] and speed \[m/s\] that the errors of a step are measured by: of the whole line and of its fall by its own length
/// or, where ends that move disturb a line at rest and nothing else does, of their motion.
pub(super) fn scale_of_motion(case: &Case, scene: &Scene) -> (f64, f64) {
    let length = scene.line.arc.last().copied().unwrap_or(1.0);
    let speed = (case.environment.gravity_m_per_s2 * length).sqrt();
    let disturbed = !scene.start.in_equilibrium
        || scene.start.velocity != V3::zeros()
        || case.start.from_run.is_some()
        || case.traveller.is_some()
        || case.waves.is_some()
        || !scene.events.is_empty();
    if disturbed {
        return (length, speed);
    }
    let duration = case.solver.duration_s;
    let moved = motions(scene).map(|motion| motion.extent(duration));
    let moved = moved.fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    motion_scale((length, speed), moved)
}

/// Name of the section that a segment belongs to.
fn section_of(case: &Case, scene: &Scene, segment: usize) -> String {
    let index = scene
        .labels
        .joints
        .iter()
        .take_while(|j| j.node <= segment)
        .count();
    index
        .checked_sub(1)
        .and_then(|i| case.line.get(i))
        .map_or_else(|| "rod of the payload".to_owned(), |s| s.name.clone())
}
