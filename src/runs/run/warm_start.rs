//! Warm start of a run from the checkpoint of a stored one: positions, velocities, and the memory of bed and ropes.

use super::Checkpoint;
use crate::case::{Case, Method};
use crate::dynamics::{MethodState, WorkCounts};
use crate::numerics::V3;
use crate::numerics::interpolation::{interval_closed_above, share};
use crate::scene::Scene;
use crate::seal;
use crate::solve::{Kinematics, State};

/// How far an end may be from where the run left it, as a share of the line's length: what more is would be a jerk.
const APART: f64 = 1e-6;

/// The initial state from a stored run.
pub(super) struct WarmStart {
    /// The line, at time zero.
    pub(super) state: State,
    /// State of the method, where it is the same one.
    pub(super) method_state: Option<MethodState>,
}

/// The checkpoint of the run that the case starts from, if it does, on the mesh of the scene.
///
/// # Errors
/// Why it cannot start there, in words.
pub(super) fn warm_start(case: &Case, scene: &Scene) -> Result<Option<WarmStart>, String> {
    let Some(name) = &case.start.from_run else {
        return Ok(None);
    };
    let text = case.files.get(name).map_or("", |file| &file.text);
    let (stored, _): (Checkpoint, _) = seal::opened(text)
        .map_err(|reason| format!("the checkpoint of {name} cannot be read: {reason}"))?;
    let there = stored
        .recorded
        .profiles
        .first()
        .map_or(&[][..], |profile| &profile.arc);
    let here = &scene.line.arc[..scene.line_nodes()];
    let beyond = scene.nodes() - here.len();
    let sizes = [stored.state.v.len(), stored.state.a.len()];
    if sizes != [stored.state.x.len(); 2] || there.len() < 2 {
        return Err(format!(
            "the checkpoint of {name} holds no whole state of a line"
        ));
    }
    if stored.state.x.len() != there.len() + beyond {
        return Err(format!(
            "{name} is a run with another payload: only one of the two turns about the end of the line"
        ));
    }
    let same = there.len() == here.len();
    let mut state = if same {
        stored.state
    } else {
        resampled(&stored.state, there, here)
    };
    // Its time begins anew, and with it that of what it remembers.
    state.memory.time = 0.0;
    state.memory.motion_pieces = [0, 0];
    state.memory.traveller_kinks = 0;
    check_ends(&state, scene, here, name)?;
    let method_state =
        Some(stored.method).filter(|c| same && belongs_to(c, case.solver.method, scene));
    let method_state = method_state.map(|known| MethodState {
        work_counts: WorkCounts::default(),
        ..known
    });
    Ok(Some(WarmStart {
        state,
        method_state,
    }))
}

/// Fails if an end of the line begins apart from where the run of this name left it; `arc` is that of the nodes of the line.
fn check_ends(state: &State, scene: &Scene, arc: &[f64], name: &str) -> Result<(), String> {
    let ends = [0, arc.len() - 1];
    let mut held = state.clone();
    scene.prescribe(0.0, &mut held);
    let length = arc.last().copied().unwrap_or(1.0);
    for (node, letter) in ends.into_iter().zip(["a", "b"]) {
        let place = state.x[node];
        let apart = (held.x[node] - place).norm();
        if apart > APART * length {
            return Err(format!(
                "end {letter} begins {apart:.3} m from where {name} left it, which would be a jump; let ends.{letter} begin \
                 at ({:.6}, {:.6}, {:.6}) m",
                place.x, place.y, place.z
            ));
        }
    }
    Ok(())
}

/// Whether a state of a method is that of this method.
fn belongs_to(known: &MethodState, method: Method, scene: &Scene) -> bool {
    let has = |list: &[Vec<V3>]| !list.is_empty();
    let is_of_method = match method {
        Method::Alpha | Method::Auto => has(&known.jerk),
        Method::Quasi => has(&known.displaced),
        Method::Rk4 => !has(&known.jerk) && !has(&known.displaced),
        Method::Static => false,
    };
    is_of_method && known.fits(&[scene.nodes()])
}

/// A state on another mesh of the same line: places and velocities in between, memories of the nearest.
fn resampled(state: &State, there: &[f64], here: &[f64]) -> State {
    let beyond = state.x.get(there.len()..).unwrap_or_default();
    let of = |values: &[V3]| -> Vec<V3> {
        let line = here.iter().map(|s| {
            let i = interval_closed_above(there, *s);
            let share = share(there, i, *s).clamp(0.0, 1.0);
            values[i].lerp(&values[i + 1], share)
        });
        let rest = values[values.len() - beyond.len()..].iter().copied();
        line.chain(rest).collect()
    };
    let mut new = State::at_rest(of(&state.x));
    (new.v, new.a) = (of(&state.v), of(&state.a));
    let nearest = |s: f64| {
        let i = interval_closed_above(there, s);
        if s - there[i] < there[i + 1] - s {
            i
        } else {
            i + 1
        }
    };
    let grips = here
        .iter()
        .filter_map(|s| state.memory.grips.get(nearest(*s)));
    new.memory.grips = grips.cloned().collect();
    new.memory.bodies.clone_from(&state.memory.bodies);
    let segments = here.windows(2).map(|pair| {
        let middle = 0.5 * (pair[0] + pair[1]);
        there.partition_point(|a| *a <= middle).saturating_sub(1)
    });
    let ropes = segments.clone().filter_map(|i| state.memory.ropes.get(i));
    new.memory.ropes = ropes.copied().collect();
    let creep = segments.filter_map(|i| state.memory.creep.get(i));
    new.memory.creep = creep.copied().collect();
    new
}
