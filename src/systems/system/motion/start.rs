//! The start of a run in time: the divided lines at rest between points and bodies at rest.

use super::along::LinesAlong;
use super::body_flow::FlowLoad;
use super::border::Border;
use super::breaks;
use super::joints::Role;
use super::let_go::{held, let_go, measure};
use super::moving_system::MovingSystem;
use super::payout_border::holding;
use super::surplus::Surplus;
use super::system_state::SystemState;
use super::velocity_history::VelocityHistory;
use nalgebra::UnitQuaternion;

use crate::numerics::V3;
use crate::physics::sea::WaterMotion;
use crate::solve::{Factors, NewtonError, State, StaticSearch};
use crate::system::SolvedSystem;
use crate::system::balance::{UnsolvedLine, line_at_rest};
use crate::system::build::{AgedParts, Divided, build};
use crate::system::discretised::SEGMENTS;
use crate::system::equilibrium::{SystemError, weight_of_bodies};
use crate::system::freedoms::{Freedoms, Placement, UnknownBodies};
use crate::system::line_at_rest::{LineAtRest, LinePhysics};
use crate::system::model::SystemFile;
use crate::system::network::{Held, Line, Network};
use crate::system::pose::Pose;
use crate::system::rest::{UnsolvedSystem, not_divided, refused as refused_at_rest, rest_from};

/// Iterations from the equilibrium of held ends to that of everything on its bed.
const MOST_ITERATIONS: usize = 1500;
/// Greatest displacement of an iteration by the length of the longest line.
const LONGEST_ITERATION: f64 = 0.05;
/// Stiffness that everything has, by that of a pendulum of that length; and how many times that at most.
const LEAST_STIFFNESS: f64 = 1e-4;
const MOST_STIFFNESS: f64 = 1e12;
/// By how much an iteration may leave more out of balance than there was.
const WORSE: f64 = 2.0;
/// Forces out of balance that count as none, by the typical force of a line; and where nothing moves any more.
const BALANCED: f64 = 1e-10;
const ACCEPTED: f64 = 1e-6;
/// Displacement that counts as none, by the same length.
const SETTLED: f64 = 1e-11;
/// Units in the last place of the greatest coordinate that are no displacement at all.
const LAST_PLACES: f64 = 8.0;

/// A system ready to move.
#[derive(Debug, Clone)]
pub struct Start {
    /// The system.
    pub system: MovingSystem,
    /// Its equilibrium.
    pub state: SystemState,
    /// Iterations of the search.
    pub iterations: u64,
    /// What is counted along its lines; nothing of a companion.
    pub along: LinesAlong,
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
    let DividedAtRest {
        network,
        held,
        placement,
        lines,
    } = divided_at_rest(&file, parts, solved)?;
    let (mut system, mut state) = at_rest(held, &placement, &lines);
    drop(lines);
    system.prescribe(0.0, &mut state);
    still(&mut state);
    system.follow(&mut state);
    let iterations = settle(&system, &mut state).map_err(|error| refused(&system, &error))?;
    system.prescribe(0.0, &mut state);
    system.follow(&mut state);
    state.joints.memory.grips = system.anchors(&state.joints);
    for (payout, force) in holding(&system, &state).into_iter().enumerate() {
        system.payouts[payout].holding = Some(force);
    }
    if network.begins_off_rest() {
        let held = std::mem::take(&mut system.payouts);
        (system, state) = let_go(&network, (&system, &state))?;
        for (payout, held) in system.payouts.iter_mut().zip(held) {
            payout.holding = held.holding;
        }
    }
    system.release_current(&mut state);
    Ok(Start {
        system,
        state,
        iterations,
        along: LinesAlong::default(),
    })
}

/// A system whose lines are divided, at rest.
struct DividedAtRest {
    /// The system.
    network: Network,
    /// The same with what begins where the file puts it held there.
    held: Network,
    /// Where everything rests then.
    placement: Placement,
    /// Its lines.
    lines: Vec<LineAtRest>,
}

/// The divided lines, each at rest between its ends where the system rests, with what is moved, or placed by the file, where it is at time
/// zero. Friction of the bed acts by springs from where a line was laid: for these ends.
fn divided_at_rest(
    file: &SystemFile,
    parts: &AgedParts,
    solved: &SolvedSystem,
) -> Result<DividedAtRest, UnsolvedSystem> {
    let closed = held(&moved_to_start(file, parts, Divided::WhereNeeded)?);
    let mut placement = breaks::placed(solved, &closed);
    let given = placement.clone();
    carried(&closed, &mut placement);
    if placement != given && Freedoms::of(&closed, UnknownBodies::Free).count > 0 {
        placement = rest_from(&closed, &placement)?.placement;
    }
    let mut network = moved_to_start(file, parts, Divided::All)?;
    measure(&mut network, solved, &given);
    let held = held(&network);
    let lines = lines_at_rest(&held, &placement)?;
    Ok(DividedAtRest {
        network,
        held,
        placement,
        lines,
    })
}

/// The lines at rest between points at these places, without what they would be solved again by: of many lines that is most of the memory.
pub(super) fn lines_at_rest(
    network: &Network,
    placement: &Placement,
) -> Result<Vec<LineAtRest>, UnsolvedSystem> {
    let at_rest = |index| {
        let mut line = line_at_rest(network, placement, index, LinePhysics::Full, None)?;
        if let Some(divided) = &mut line.discretised {
            divided.free_work();
        }
        Ok(line)
    };
    let lines = (0..network.lines.len()).map(at_rest);
    let lines: Result<_, UnsolvedLine> = lines.collect();
    lines.map_err(|unsolved| refused_at_rest(network, &SystemError::Line(unsolved)))
}

/// The system with what is moved where it is at time zero.
fn moved_to_start(
    file: &SystemFile,
    parts: &AgedParts,
    divided: Divided,
) -> Result<Network, UnsolvedSystem> {
    let mut network = build(file, parts, divided).map_err(not_divided)?;
    for point in &mut network.points {
        if let Some(motion) = &point.motion {
            point.held = Held::At(motion.at(0.0).0);
        }
    }
    for body in &mut network.bodies {
        if let Some(motion) = &body.motion {
            let at_start = motion.at(0.0).pose;
            body.pose = match body.pinned {
                true => Pose {
                    origin: at_start.origin,
                    ..body.pose
                },
                false => at_start,
            };
        }
    }
    Ok(network)
}

/// Puts what is held where the network has it.
fn carried(network: &Network, placement: &mut Placement) {
    for (point, place) in network.points.iter().zip(&mut placement.points) {
        if let Held::At(at) = &point.held {
            *place = *at;
        }
    }
    for (body, pose) in network.bodies.iter().zip(&mut placement.bodies) {
        if !body.free && body.carrier.is_none() {
            pose.origin = body.pose.origin;
        }
        if !body.turns() {
            pose.rotation = body.pose.rotation;
        }
    }
    placement.carry(network);
}

/// Unstretched length of the longest line, a metre at least \[m\].
fn longest(network: &Network) -> f64 {
    network.lines.iter().map(Line::length).fold(1.0, f64::max)
}

/// The system and its state there.
pub(super) fn at_rest(
    network: Network,
    placement: &Placement,
    lines: &[LineAtRest],
) -> (MovingSystem, SystemState) {
    let found = lines.iter().filter_map(|line| line.discretised.as_ref());
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
    let mut point_of = vec![None; joints.roles.len()];
    for (point, joint) in joints.points.iter().enumerate().rev() {
        point_of[*joint] = Some(point);
    }
    let place = |(joint, role): (usize, &Role)| match role {
        Role::Origin(body) => placement.bodies[*body].origin,
        Role::Rotation(_) | Role::Released(..) | Role::Payout(_) => V3::zeros(),
        _ => point_of[joint].map_or_else(V3::zeros, |point| placement.points[point]),
    };
    let places: Vec<V3> = joints.roles.iter().enumerate().map(place).collect();
    let bases = placement.bodies.iter().map(|pose| pose.rotation);
    let state = state_of(&system, (places, bases.collect()), lines);
    (system, state)
}

/// The state of a system without motion: its joints at these places, its bodies in these rotations, its lines.
pub(super) fn state_of(
    system: &MovingSystem,
    (places, bases): (Vec<V3>, Vec<UnitQuaternion<f64>>),
    lines: Vec<State>,
) -> SystemState {
    let ends = |line: &Line| [line.from, line.to].map(|point| system.joints.points[point]);
    let stations = system.stations.last().map_or(0, |range| range.end);
    SystemState {
        body_flow: vec![WaterMotion::default(); stations],
        flow_loads: vec![FlowLoad::default(); system.flows.len()],
        velocities: vec![VelocityHistory::default(); system.flows.len()],
        lines,
        joints: State::at_rest(places),
        bases,
        attached: system.network.lines.iter().map(ends).collect(),
        paid: system
            .paid
            .iter()
            .map(|paid| system.scenes[paid.line].clone())
            .collect(),
        added: vec![[0; 2]; system.paid.len()],
        surplus: vec![[Surplus::default(); 2]; system.paid.len()],
        drive_excess: vec![0.0; system.payouts.len()],
    }
}

/// Takes all velocities and accelerations out.
pub(super) fn still(state: &mut SystemState) {
    for part in state.parts_mut() {
        part.v.fill(V3::zeros());
        part.a.fill(V3::zeros());
    }
}

/// Newton's method at rest, damped by a little mass, and by more where a step leaves more out of balance than there was: slack line on a
/// bed, and the spin of a buoy on one line, have no stiffness of their own.
pub(super) fn settle(system: &MovingSystem, state: &mut SystemState) -> Result<u64, NewtonError> {
    let size = longest(&system.network);
    let least = LEAST_STIFFNESS * system.network.gravity.max(1.0) / size;
    let force = system
        .scenes
        .iter()
        .map(StaticSearch::force_scale)
        .fold(weight_of_bodies(&system.network), f64::max);
    let mut border = Border::new(system, state);
    let (mut mass, mut before, mut last) = (least, f64::INFINITY, (0, f64::INFINITY));
    let mut kept = state.clone();
    for made in 1..=MOST_ITERATIONS {
        let factors = Factors {
            mass,
            damping: 0.0,
            stiffness: 1.0,
        };
        let solved = border.solve(system, 0.0, state, factors);
        let residual = border.residual(system);
        if solved.is_err() || residual > WORSE * before {
            state.copy_from(&kept);
            before = f64::INFINITY;
            mass *= 100.0;
            if mass > MOST_STIFFNESS * least {
                solved?;
                break;
            }
            continue;
        }
        if residual <= BALANCED * force {
            return Ok(made as u64);
        }
        last = border.greatest(system)?;
        if last.1 <= SETTLED * size && residual <= ACCEPTED * force {
            return Ok(made as u64);
        }
        // No place that can be written is nearer to balance: what is left is rounding of the forces, as of a body whose weight is far above the
        // forces of its lines.
        if mass <= least && last.1 <= LAST_PLACES * f64::EPSILON * extent(state).max(size) {
            return Ok(made as u64);
        }
        kept.copy_from(state);
        before = residual;
        mass = (mass / 10.0).max(least);
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
    }
    Err(NewtonError::NotConverged {
        iterations: MOST_ITERATIONS,
        node: last.0,
        moved: last.1,
    })
}

/// The greatest coordinate of a node or joint \[m\].
fn extent(state: &SystemState) -> f64 {
    let lines = state.lines.iter().flat_map(|line| &line.x);
    let places = lines.chain(&state.joints.x).map(nalgebra::Matrix::amax);
    places.fold(0.0, f64::max)
}

/// Turns the bases of the bodies that turn by their rotation vectors, which start anew.
pub(super) fn turn_bases(system: &MovingSystem, state: &mut SystemState) {
    for (number, body) in system.network.bodies.iter().enumerate() {
        if body.turns() {
            let mut rotation = system.body(state, number).pose.rotation;
            rotation.renormalize();
            state.bases[number] = rotation;
            state.joints.x[system.joints.rotations[number]] = V3::zeros();
        }
    }
}

/// A search that failed, in words.
fn refused(system: &MovingSystem, error: &NewtonError) -> UnsolvedSystem {
    let node = system.node_name(error.node());
    let why = match error {
        NewtonError::NotConverged {
            iterations, moved, ..
        } => format!("after {iterations} iterations {node} still moves by {moved:.3e} m"),
        NewtonError::NotFinite { .. } => format!("a force is not finite at {node}"),
        _ => format!("nothing holds {node}"),
    };
    UnsolvedSystem {
        problem: format!("divided into segments the system does not come to rest: {why}"),
        remedy: "give the lines more `segments`, or the bed less `stiffness_n_per_m3`".to_owned(),
        line: None,
        part: None,
    }
}
