//! The start of a run in time: the divided lines at rest between points and bodies at rest.

use super::border::Border;
use super::breaks;
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::numerics::V3;
use crate::solve::{Convergence, Factors, NewtonError, State};
use crate::system::SolvedSystem;
use crate::system::build::{AgedParts, Divided, build};
use crate::system::discretised::SEGMENTS;
use crate::system::equilibrium::Equilibrium;
use crate::system::network::{Held, Network};
use crate::system::rest::{UnsolvedSystem, not_divided, rest_from};

/// Iterations from the equilibrium of the closed forms to that of the divided lines on their bed.
const MOST_ITERATIONS: usize = 60;
/// Greatest displacement of an iteration by the length of the longest line.
const LONGEST_ITERATION: f64 = 0.05;
/// Stiffness that everything has, by that of a pendulum of that length.
const LEAST_STIFFNESS: f64 = 1e-8;
/// Displacement that counts as none, by the same length.
const SETTLED: f64 = 1e-11;
/// The same where the iteration no longer comes nearer: rounding.
const ACCEPTED: f64 = 1e-8;

/// A system ready to move.
#[derive(Debug, Clone)]
pub struct Start {
    /// The system.
    pub system: MovingSystem,
    /// Its equilibrium.
    pub state: SystemState,
    /// Iterations of the search.
    pub iterations: u64,
}

/// The equilibrium of a system whose lines have `1 / coarsening` of their segments: 1 for the run itself.
///
/// # Errors
/// [`UnsolvedSystem`], as for a system at rest; divided lines on their bed that do not come to rest.
pub fn start(solved: &SolvedSystem, coarsening: usize) -> Result<Start, UnsolvedSystem> {
    let mut file = solved.file.clone();
    for line in &mut file.lines {
        let segments = line.segments.unwrap_or(SEGMENTS);
        line.segments = Some(segments.div_ceil(coarsening));
    }
    let file = breaks::written_out(&file);
    let none = AgedParts::new();
    let parts = solved.age.as_ref().map_or(&none, |age| &age.parts);
    let mut network = build(&file, parts, Divided::All).map_err(not_divided)?;
    let mut placement = breaks::placed(solved, &network);
    for (point, place) in network.points.iter_mut().zip(&mut placement.points) {
        if let Some(motion) = &point.motion {
            *place = motion.at(0.0).0;
            point.held = Held::At(*place);
        }
    }
    for (body, pose) in network.bodies.iter_mut().zip(&mut placement.bodies) {
        if let Some(motion) = &body.motion {
            body.pose = motion.at(0.0).pose;
            *pose = body.pose;
        }
    }
    placement.carry(&network);
    let rest = rest_from(&network, &placement)?;
    let (system, mut state) = at_rest(network, &rest);
    system.prescribe(0.0, &mut state);
    still(&mut state);
    system.follow(&mut state);
    let iterations = settle(&system, &mut state).map_err(|error| refused(&system, &error))?;
    system.prescribe(0.0, &mut state);
    system.follow(&mut state);
    Ok(Start {
        system,
        state,
        iterations,
    })
}

/// The system and its state as the equilibrium found it.
fn at_rest(network: Network, rest: &Equilibrium) -> (MovingSystem, SystemState) {
    let lines = rest.balance.lines.iter();
    let found = lines.filter_map(|line| line.discretised.as_ref());
    let (scenes, lines): (Vec<_>, Vec<_>) = found
        .map(|line| {
            let (scene, state) = line.scene_and_state();
            let mut state = state.clone();
            state.extrapolated_tension.clear();
            (scene.clone(), state)
        })
        .unzip();
    let system = MovingSystem::new(network, scenes);
    let joints = &system.joints;
    let place = |(joint, role): (usize, &Role)| match role {
        Role::Origin(body) => rest.placement.bodies[*body].origin,
        Role::Rotation(_) | Role::LetGo(..) => V3::zeros(),
        _ => {
            let point = joints.points.iter().position(|known| *known == joint);
            point.map_or_else(V3::zeros, |point| rest.placement.points[point])
        }
    };
    let places = joints.roles.iter().enumerate().map(place).collect();
    let bases = rest.placement.bodies.iter().map(|pose| pose.rotation);
    let ends = |line: &crate::system::network::Line| {
        [line.from, line.to].map(|point| joints.points[point])
    };
    let state = SystemState {
        lines,
        joints: State::at_rest(places),
        bases: bases.collect(),
        attached: system.network.lines.iter().map(ends).collect(),
    };
    (system, state)
}

/// Takes all velocities and accelerations out.
fn still(state: &mut SystemState) {
    for part in state.parts_mut() {
        part.v.fill(V3::zeros());
        part.a.fill(V3::zeros());
    }
}

/// Newton's method at rest.
fn settle(system: &MovingSystem, state: &mut SystemState) -> Result<u64, NewtonError> {
    let lengths = system.network.lines.iter().map(|line| line.length());
    let size = lengths.fold(1.0, f64::max);
    // What nothing holds, as the spin of a buoy on one line, stays where it is.
    let statics = Factors {
        mass: LEAST_STIFFNESS * system.network.gravity.max(1.0) / size,
        damping: 0.0,
        stiffness: 1.0,
    };
    let mut border = Border::new(system, state);
    let mut convergence = Convergence::new(SETTLED * size, None);
    let mut last = (0, f64::INFINITY);
    for made in 1..=MOST_ITERATIONS {
        border.solve(system, 0.0, state, statics)?;
        last = border.greatest(system)?;
        let share = (LONGEST_ITERATION * size / last.1).min(1.0);
        for (number, part) in state.parts_mut().enumerate() {
            let d = border.displacements(number);
            for i in system.free(number) {
                part.x[i] -= d[i] * share;
            }
        }
        system.follow(state);
        still(state);
        turn_bases(system, state);
        let reached = convergence.is_reached(last.1);
        if reached || (convergence.idle() > 2 && last.1 <= ACCEPTED * size) {
            return Ok(made as u64);
        }
    }
    Err(NewtonError::NotConverged {
        iterations: MOST_ITERATIONS,
        node: last.0,
        moved: last.1,
    })
}

/// Turns the bases of the free bodies by their rotation vectors, which start anew.
pub(super) fn turn_bases(system: &MovingSystem, state: &mut SystemState) {
    for (number, body) in system.network.bodies.iter().enumerate() {
        if body.free {
            let mut rotation = system.body(state, number).pose.rotation;
            rotation.renormalize();
            state.bases[number] = rotation;
            state.joints.x[system.joints.bodies[number] + 1] = V3::zeros();
        }
    }
}

/// A search that failed, in words.
fn refused(system: &MovingSystem, error: &NewtonError) -> UnsolvedSystem {
    let node = system.node_name(error.node());
    UnsolvedSystem {
        problem: format!("the divided lines do not come to rest on their bed: {error}, {node}"),
        remedy: "give the lines more segments, or the bed less stiffness".to_owned(),
        line: None,
        part: None,
    }
}
