//! The lowest modes of a system, with what moves most in each, and their errors from a mesh of half the segments.

use nalgebra::DVector;

use super::super::joints::Role;
use super::super::moving_system::MovingSystem;
use super::super::start::rest;
use super::super::system_state::SystemState;
use super::pencil::SystemPencil;
use crate::modes::{
    Eigenpair, LineModes, MORE, Mode, ModeFrame, ModeLine, modes_of, named, touchdown_share,
};
use crate::numerics::V3;
use crate::numerics::lowest_modes::{LowestModes, lowest_modes};
use crate::system::SolvedSystem;
use crate::system::rest::UnsolvedSystem;

/// Eigenvalues sought beyond those wanted, as the search may end before the last of a cluster.
const BEYOND: usize = 8;
/// Share of a motion from which it is the spin of a rod.
const SPIN: f64 = 0.99;
/// Share of the kinetic energy from which what has it moves alone.
const ALONE: f64 = 0.5;

/// A system at rest on a mesh, and its modes.
pub(super) struct ModesAtRest {
    system: MovingSystem,
    state: SystemState,
    /// The modes, from the lowest frequency up.
    pub(super) modes: Vec<Mode>,
    /// What moves most in each.
    most: Vec<String>,
}

/// The `count` lowest modes of a system about its rest, or all there are: of its lines with their mass, its points and bodies.
///
/// # Errors
/// A system that does not come to rest divided into segments; what has no mass and nothing holds.
pub fn modes_of_system(solved: &SolvedSystem, count: usize) -> Result<LineModes, UnsolvedSystem> {
    let mut fine = lowest_at_rest(solved, 1.0, count)?;
    fine.modes.truncate(count);
    // The estimate needs a different mesh; if it fails, the modes are given without.
    let coarse = lowest_at_rest(solved, 2.0, count + MORE).ok();
    let segments = |of: &MovingSystem| -> usize {
        let scenes = of.scenes.iter();
        scenes.map(|scene| scene.line.segments.len()).sum()
    };
    let coarse = coarse.as_ref().map(|coarse| {
        let ratio = segments(&fine.system) as f64 / segments(&coarse.system) as f64;
        (ratio, coarse.modes.as_slice())
    });
    let coarse = coarse.filter(|(ratio, _)| *ratio > 1.0);
    let lines = fine.system.lines(&fine.state);
    let touchdown = lines.map(|(scene, rest)| touchdown_share(scene, rest));
    let touchdown = touchdown.fold(0.0, f64::max);
    let mut modes = named(fine.modes, coarse, touchdown);
    if !is_line_alone(&fine.system) {
        for (mode, most) in modes.iter_mut().zip(fine.most) {
            mode.most = Some(most);
        }
    }
    let names = fine.system.network.lines.iter().map(|line| &line.name);
    let lines = names.zip(fine.system.lines(&fine.state));
    let lines = lines.map(|(name, (scene, rest))| ModeLine {
        name: name.clone(),
        scene: scene.clone(),
        rest: rest.clone(),
    });
    Ok(LineModes {
        lines: lines.collect(),
        modes,
    })
}

/// Whether a system is a line between ends that are held.
fn is_line_alone(system: &MovingSystem) -> bool {
    system.network.lines.len() == 1 && system.joints.envelope.is_empty()
}

/// The lowest modes of a system with segments so many times as long, some more than are wanted.
///
/// # Errors
/// As [`modes_of_system`].
pub(super) fn lowest_at_rest(
    solved: &SolvedSystem,
    segment: f64,
    wanted: usize,
) -> Result<ModesAtRest, UnsolvedSystem> {
    let (system, mut state) = rest(solved, segment)?;
    // Fibre ropes oscillate at their dynamic stiffness.
    let scenes = system.lines(&state).map(|(scene, _)| scene.clone());
    let scenes: Vec<_> = scenes.collect();
    for (scene, line) in scenes.iter().zip(&mut state.lines) {
        scene.line.remember_ropes(0.0, 0.0, line);
    }
    let pencil = SystemPencil::new(&system, &state);
    let found = lowest(&pencil, wanted + spinning(&system))?;
    let pairs = found.modes.into_iter().map(|(value, unknowns)| Eigenpair {
        value,
        vector: pencil.displacements(&unknowns),
    });
    let pairs = pairs.filter(|pair| !is_spin(&system, &pair.vector));
    let modes = modes_of(&pencil, &frame(&system, &state), pairs.collect());
    let most = modes.iter().map(|mode| most(&system, &pencil, &mode.shape));
    Ok(ModesAtRest {
        most: most.collect(),
        system,
        state,
        modes,
    })
}

/// The lowest eigenvalues, at least as many as are wanted unless there are fewer.
fn lowest(pencil: &SystemPencil, wanted: usize) -> Result<LowestModes, UnsolvedSystem> {
    let refused = |problem: &str, remedy: &str| UnsolvedSystem {
        problem: problem.to_owned(),
        remedy: remedy.to_owned(),
        line: None,
        part: None,
    };
    if pencil.size() == 0 {
        return Err(refused(
            "nothing of the system moves",
            "give its lines more `segments`",
        ));
    }
    let mut sought = wanted + BEYOND;
    loop {
        let found = lowest_modes(&pencil.stiffness, &pencil.mass, sought);
        let is_last = sought >= pencil.size();
        match found {
            Some(found) if is_last || found.modes.len() >= wanted => return Ok(found),
            // More eigenvalues at one place than were sought, or fewer in all.
            _ if !is_last => sought *= 2,
            _ => {
                return Err(refused(
                    "something without mass is held by nothing, or bodies have no inertia",
                    "give each body its `mass_kg` and `inertia_kg_m2`",
                ));
            }
        }
    }
}

/// By what the modes of a system are told apart.
fn frame(system: &MovingSystem, state: &SystemState) -> ModeFrame {
    let nodes: Vec<&[V3]> = state.lines.iter().map(|line| line.x.as_slice()).collect();
    let mut frame = ModeFrame::of_lines(&nodes);
    let mut begin = 0;
    // A point at the end of one line moves along that.
    let mut along: Vec<Vec<V3>> = vec![Vec::new(); system.joints.roles.len()];
    for (nodes, ends) in nodes.iter().zip(&state.attached) {
        let last = begin + nodes.len() - 1;
        for (joint, node) in ends.iter().zip([begin, last]) {
            along[*joint].push(frame.tangent(node));
        }
        begin = last + 1;
    }
    for joint in joints_by_row(system) {
        let single = joint.and_then(|joint| match along[joint].as_slice() {
            [tangent] => Some(*tangent),
            _ => None,
        });
        let turns = joint.and_then(|joint| match system.joints.roles[joint] {
            Role::Rotation(body) => Some(*system.body(state, body).pose.matrix().matrix()),
            _ => None,
        });
        frame.push(turns, single);
    }
    frame
}

/// The joint of each row.
fn joints_by_row(system: &MovingSystem) -> Vec<Option<usize>> {
    let mut joints = vec![None; system.joints.envelope.len()];
    for joint in system.joints.free.clone() {
        if let Some(row) = system.joints.row(joint) {
            joints[row] = Some(joint);
        }
    }
    joints
}

/// What moves most in a mode, by kinetic energy.
fn most(system: &MovingSystem, pencil: &SystemPencil, shape: &[V3]) -> String {
    let (lines, joints) = pencil.energies(shape);
    let mut parts: Vec<(f64, &str)> = system
        .network
        .lines
        .iter()
        .zip(&lines)
        .map(|(line, energy)| (*energy, line.name.as_str()))
        .collect();
    let mut bodies = vec![0.0; system.network.bodies.len()];
    for (joint, energy) in joints_by_row(system).into_iter().zip(joints) {
        match joint.map(|joint| system.joints.roles[joint]) {
            Some(Role::Origin(body) | Role::Rotation(body)) => bodies[body] += energy,
            Some(Role::Free(point)) => parts.push((energy, &system.network.points[point].name)),
            _ => {}
        }
    }
    let names = system.network.bodies.iter().map(|body| body.name.as_str());
    parts.extend(bodies.into_iter().zip(names));
    let whole: f64 = parts.iter().map(|(energy, _)| energy).sum();
    let most = parts
        .into_iter()
        .reduce(|most, part| match part.0 > most.0 {
            true => part,
            false => most,
        });
    match most {
        Some((energy, name)) if energy >= ALONE * whole => name.to_owned(),
        Some((_, name)) => format!("{name} and others"),
        None => String::new(),
    }
}

/// How many rods there are, whose spin is no mode.
fn spinning(system: &MovingSystem) -> usize {
    let bodies = system.network.bodies.iter();
    let rods = bodies.filter(|body| body.turns() && body.spins_about.is_some());
    rods.count()
}

/// Whether a motion is the spin of a rod, which what keeps it in place makes up.
fn is_spin(system: &MovingSystem, shape: &[V3]) -> bool {
    let whole = DVector::from_iterator(shape.len(), shape.iter().map(V3::norm)).norm_squared();
    let first = shape.len() - system.joints.envelope.len();
    let bodies = system.network.bodies.iter().enumerate();
    let mut rods = bodies.filter_map(|(body, of)| Some((body, of.spins_about?)));
    rods.any(|(body, axis)| {
        let rotation = system.joints.rotations[body];
        let Some(row) = system.joints.row(rotation) else {
            return false;
        };
        // Rotation vectors count along the axes of their body.
        let spin = axis.dot(&shape[first + row]);
        spin * spin > SPIN * whole
    })
}
