//! A line between two ends as a system of one line, ready for a quick look.

use super::super::rest_state::state_of;
use super::look::unsolved;
use crate::case::{Case, Method};
use crate::numerics::V3;
use crate::physics::EndMotion;
use crate::physics::motion::MotionPath;
use crate::scene::{EndCondition, Scene, build};
use crate::statics::equilibrium::EquilibriumSearch;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::start::Start;
use crate::system::network::{FreePoint, Held, Line, Network, Point};
use crate::system::rest::UnsolvedSystem;

/// The line of a case with `1 / coarsening` of its segments, at rest between its ends: points that are held, moved, or free with what hangs
/// on them.
///
/// # Errors
/// What has no quick look, or no equilibrium.
pub(super) fn of_case(case: &Case, coarsening: usize) -> Result<Start, UnsolvedSystem> {
    let scene = build(case, coarsening).map_err(|why| unsolved(why.to_string(), "see the case"))?;
    refuse(case, &scene)?;
    let mut state = scene.initial_state();
    let found = EquilibriumSearch::default().run(&scene, 0.0, &mut state);
    let found = found.map_err(|why| unsolved(why.to_string(), "run it in time"))?;
    let network = network(&scene);
    let ends = [0, state.x.len() - 1].map(|node| state.x[node]);
    let system = MovingSystem::new(network, vec![scene]);
    let places = system.joints.points.iter();
    let mut joints = vec![V3::zeros(); system.joints.roles.len()];
    for (joint, place) in places.zip(ends) {
        joints[*joint] = place;
    }
    state.extrapolated_tension.clear();
    let state = state_of(&system, (joints, Vec::new()), vec![state]);
    Ok(Start {
        system,
        state,
        iterations: found.iterations,
        along: Default::default(),
    })
}

/// Its ends as points, in the water of the line.
fn network(scene: &Scene) -> Network {
    let water = scene.line.water.as_ref();
    let point = |end: usize| {
        let (held, motion) = match &scene.line.ends[end] {
            EndCondition::Prescribed(motion) => (Held::At(motion.position), moves(motion)),
            EndCondition::Free => (Held::Free(FreePoint::default()), None),
        };
        Point {
            name: scene.labels.end_names[end].clone(),
            held,
            motion,
        }
    };
    Network {
        sea: water.and_then(|water| water.waves.clone()),
        gauge: water.map_or_else(V3::zeros, |water| water.gauge),
        density: water.map_or(0.0, |water| water.density),
        gravity: water.map_or(0.0, |water| water.gravity),
        points: vec![point(0), point(1)],
        lines: vec![Line {
            name: "line".to_owned(),
            from: 0,
            to: 1,
            sections: Vec::new(),
            reversed: Vec::new(),
            parts: Vec::new(),
            bodies: Vec::new(),
            added_weight: 0.0,
            friction: 0.0,
            friction_lateral: 0.0,
            clamps: [None; 2],
            still_water: water.is_none(),
            bed_contact: true,
            releases: Default::default(),
            start: None,
            discretised: None,
            closed_where_known: false,
            displaced: Vec::new(),
            displaced_reversed: Vec::new(),
        }],
        ..Network::default()
    }
}

fn moves(motion: &EndMotion) -> Option<EndMotion> {
    (motion.course != MotionPath::Still).then(|| motion.clone())
}

fn refuse(case: &Case, scene: &Scene) -> Result<(), UnsolvedSystem> {
    let ends = [&case.ends.a, &case.ends.b];
    let what = if matches!(case.solver.method, Method::Static | Method::Quasi) {
        "nothing of this case moves with inertia"
    } else if scene.elements.traveller.is_some() {
        "a body travels along the line"
    } else if scene.elements.rigid_payload.is_some() {
        "the payload turns as a rigid body"
    } else if ends.iter().any(|end| end.release_s.is_some()) {
        "an end is let go"
    } else {
        return Ok(());
    };
    Err(unsolved(
        format!("a quick look in the frequency domain takes steady waves alone, but {what}"),
        "run it in time",
    ))
}
