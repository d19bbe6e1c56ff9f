//! The start of a run in time: the divided lines at rest between points and bodies at rest.

use super::border::Border;
use super::breaks;
use super::let_go::{held, let_go, measure};
use super::line_start;
use super::moving_system::{MovingSystem, turn_bases};
use super::payout_border::holding;
use super::system_state::SystemState;

use super::rest_state::{at_rest, carried, lines_at_rest, longest, still};
use crate::physics::motion::MotionPath;
use crate::run::lines_along::LinesAlong;
use crate::solve::{Factors, Iterated, NewtonError, Parted, StaticSearch};
use crate::system::SolvedSystem;
use crate::system::build::{AgedParts, build, divide};
use crate::system::equilibrium::weight_of_bodies;
use crate::system::freedoms::{Freedoms, Placement, UnknownBodies};
use crate::system::initial::{BodyInitial, PointInitial};
use crate::system::line_at_rest::LineAtRest;
use crate::system::model::SystemFile;
use crate::system::network::{Held, Network};
use crate::system::pose::Pose;
use crate::system::rest::{UnsolvedSystem, not_divided, rest_from};

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

/// The equilibrium of a system whose segments are so many times as long: 1 for the run itself.
///
/// # Errors
/// [`UnsolvedSystem`], as for a system at rest; divided lines on their bed that do not come to rest.
pub fn start(solved: &SolvedSystem, segment: f64) -> Result<Start, UnsolvedSystem> {
    let divided = divided_at_rest(solved, segment, Begin::AsTheFileHasIt)?;
    let network = divided.network.clone();
    let (mut system, mut state, iterations) = settled(divided)?;
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
    line_start::begin(&system, &mut state);
    system.release_current(&mut state);
    Ok(Start {
        system,
        state,
        iterations,
        along: LinesAlong::default(),
    })
}

/// The equilibrium of a system whose segments are so many times as long, of what begins a run off it too.
///
/// # Errors
/// As [`start`].
pub(super) fn rest(
    solved: &SolvedSystem,
    segment: f64,
) -> Result<(MovingSystem, SystemState), UnsolvedSystem> {
    let (system, mut state, _) = settled(divided_at_rest(solved, segment, Begin::AtRest)?)?;
    // What is moved from the start on at full speed is at rest too.
    still(&mut state);
    system.follow(&mut state);
    Ok((system, state))
}

/// Divided lines with points and bodies at rest together, and the iterations that took.
fn settled(divided: DividedAtRest) -> Result<(MovingSystem, SystemState, u64), UnsolvedSystem> {
    let DividedAtRest {
        held,
        placement,
        lines,
        ..
    } = divided;
    let (system, mut state) = at_rest(held, &placement, &lines);
    drop(lines);
    system.prescribe(0.0, &mut state);
    still(&mut state);
    system.follow(&mut state);
    let iterations = settle(&system, &mut state).map_err(|error| refused(&system, &error))?;
    system.prescribe(0.0, &mut state);
    system.follow(&mut state);
    system.begin_contacts(&mut state.joints);
    Ok((system, state, iterations))
}

/// Where what a file displaces, places or sets moving at the start begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begin {
    /// There.
    AsTheFileHasIt,
    /// At rest with everything else, unless nothing but its place at the start holds it.
    AtRest,
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
    solved: &SolvedSystem,
    segment: f64,
    begin: Begin,
) -> Result<DividedAtRest, UnsolvedSystem> {
    let none = AgedParts::new();
    let parts = solved.age.as_ref().map_or(&none, |age| &age.parts);
    let (file, mut network) = of_mesh(solved, parts, segment)?;
    if file.is_run_at_rest() {
        leave_motion_out(&mut network);
    }
    if begin == Begin::AtRest {
        leave_start_out(&mut network, &solved.dropped);
    }
    move_to_start(&mut network);
    let closed = held(&network);
    let mut placement = breaks::placed(solved, &closed);
    let given = placement.clone();
    carried(&closed, &mut placement);
    if placement != given && Freedoms::of_network(&closed, UnknownBodies::Free).count > 0 {
        placement = rest_from(&closed, &placement)?.placement;
    }
    drop(closed);
    divide(&mut network, &file, parts).map_err(not_divided)?;
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

/// The file and the system of a mesh: the system at rest itself, unless lines have other segments or may break, or parts of it were held to
/// come to rest.
fn of_mesh(
    solved: &SolvedSystem,
    parts: &AgedParts,
    segment: f64,
) -> Result<(SystemFile, Network), UnsolvedSystem> {
    let mut file = solved.file.clone();
    for line in &mut file.lines {
        let segments = line.wanted_segments();
        line.segments = Some((segments as f64 / segment).ceil() as usize);
    }
    let whole = breaks::written_out(&file);
    let is_own = segment == 1.0 && whole.lines.len() == file.lines.len();
    let network = match is_own && solved.dropped.is_empty() {
        true => solved.network.clone(),
        false => build(&whole, parts).map_err(not_divided)?,
    };
    Ok((whole, network))
}

/// Leaves out what only a run in time begins with or is moved by.
fn leave_motion_out(network: &mut Network) {
    for point in &mut network.points {
        if let Some(motion) = &mut point.motion {
            motion.course = MotionPath::Still;
        }
    }
    for body in &mut network.bodies {
        body.motion = None;
    }
    leave_start_out(network, &[]);
}

/// Leaves out how what is free begins a run in time off its equilibrium, but for what is named: nothing else holds that.
fn leave_start_out(network: &mut Network, kept: &[String]) {
    for point in &mut network.points {
        if let Held::Free(free) = &mut point.held
            && !kept.contains(&point.name)
        {
            free.initial = PointInitial::default();
        }
    }
    let bodies = network.bodies.iter_mut();
    for body in bodies.filter(|body| !kept.contains(&body.name)) {
        body.initial = BodyInitial::default();
    }
    for line in &mut network.lines {
        line.start = None;
    }
}

/// Puts what is moved where it is at time zero.
fn move_to_start(network: &mut Network) {
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
        let places_alone = Factors {
            mass: 0.0,
            damping: 0.0,
            stiffness: 1.0,
        };
        system.apply(&border, state, places_alone, share);
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
