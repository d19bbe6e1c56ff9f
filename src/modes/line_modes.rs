//! The modes of a case: its line brought to rest, its modes found, their errors estimated from half the mesh.

use super::{EigenError, Mode, ModeKind, Pencil, lowest, modes_of};
use crate::case::Case;
use crate::numerics::V3;
use crate::scene::{self, Scene, SceneError};
use crate::solve::State;
use crate::statics::equilibrium;

/// Modes found on the coarse mesh beyond those wanted: its order may differ.
const MORE: usize = 4;

/// Why there are no modes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModesError {
    /// The case is none of a line.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The line does not come to rest.
    #[error("{0}")]
    Rest(#[from] equilibrium::EquilibriumError),
    /// The modes were not found.
    #[error("{0}")]
    Modes(#[from] EigenError),
    /// A payload turns.
    #[error(
        "the payload turns, and modes know only payloads that do not; leave out `payload.rotation`"
    )]
    RigidPayload,
}

/// A mode with its name and its estimated error.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedMode {
    /// The mode.
    pub mode: Mode,
    /// Its number among the modes of its kind, from 1.
    pub of_kind: usize,
    /// Error of its frequency from the mesh \[Hz\]; absent where the coarse mesh has no such mode.
    pub error_hz: Option<f64>,
}

/// The line at rest and its lowest modes.
#[derive(Debug, Clone)]
pub struct LineModes {
    /// The line.
    pub scene: Scene,
    /// Its state at rest.
    pub rest: State,
    /// Its modes, from the lowest frequency up.
    pub modes: Vec<NamedMode>,
}

/// The `count` lowest modes of a case's line about its static shape, or all there are.
///
/// # Errors
/// [`ModesError`].
pub fn of_case(case: &Case, count: usize) -> Result<LineModes, ModesError> {
    let (scene, rest, mut modes) = on_mesh(case, 1, count)?;
    modes.truncate(count);
    // The estimate needs a mesh that differs, and may fail without taking the modes along.
    let coarse = on_mesh(case, 2, count + MORE).ok();
    let coarse =
        coarse.filter(|(coarse, ..)| coarse.line.segments.len() < scene.line.segments.len());
    let ratio = coarse.as_ref().map_or(1.0, |(coarse, ..)| {
        scene.line.segments.len() as f64 / coarse.line.segments.len() as f64
    });
    let touchdown = touchdown_share(&scene, &rest);
    let named = modes.iter().enumerate().map(|(i, mode)| {
        let of_kind = 1 + of_kind(&modes[..i], mode.kind).count();
        let other = coarse
            .as_ref()
            .and_then(|(_, _, modes)| of_kind_at(modes, mode.kind, of_kind));
        // The lumped line is of second order (Richardson), but not where it comes down on the bed.
        let unknown = match mode.kind {
            ModeKind::OutOfPlane => 0.0,
            _ => touchdown * mode.frequency_hz(),
        };
        let by_mesh = |o: &Mode| {
            (mode.frequency_hz() - o.frequency_hz()).abs() / (ratio * ratio - 1.0) + unknown
        };
        NamedMode {
            of_kind,
            error_hz: other.map(by_mesh),
            mode: mode.clone(),
        }
    });
    let modes = named.collect();
    Ok(LineModes { scene, rest, modes })
}

/// The mesh knows the place of a touchdown to half a segment. What the line hangs from there, up to the next touchdown or its
/// end, is as much longer or shorter, and frequencies in its plane go about as the inverse of that: their relative error, at the
/// worst of all touchdowns.
fn touchdown_share(scene: &Scene, rest: &State) -> f64 {
    let Some(bed) = &scene.elements.bed else {
        return 0.0;
    };
    let lies: Vec<bool> = (0..=scene.line.segments.len())
        .map(|i| bed.height(&rest.x[i]) <= 0.0)
        .collect();
    let mut worst = 0.0_f64;
    let mut from = 0;
    // A run of hanging nodes with the lying ones, or the ends, that bound it.
    for run in lies.chunk_by(|a, b| a == b) {
        let to = from + run.len();
        if !run[0] {
            let (first, last) = (from.saturating_sub(1), to.min(lies.len() - 1));
            let length = scene.line.arc[last] - scene.line.arc[first];
            let half = |beside: bool, i: usize| {
                f64::from(u8::from(beside)) * 0.5 * scene.line.segments[i].axial.length
            };
            // The end of the line is no touchdown, even where it lies on the bed.
            let down = half(from > 1, first) + half(to + 1 < lies.len(), last.max(1) - 1);
            worst = worst.max(down / length);
        }
        from = to;
    }
    worst
}

fn of_kind(modes: &[Mode], kind: ModeKind) -> impl Iterator<Item = &Mode> {
    modes.iter().filter(move |mode| mode.kind == kind)
}

fn of_kind_at(modes: &[Mode], kind: ModeKind, number: usize) -> Option<&Mode> {
    of_kind(modes, kind).nth(number - 1)
}

/// The line at rest on a mesh coarsened by `coarsening`, and its modes.
fn on_mesh(
    case: &Case,
    coarsening: usize,
    count: usize,
) -> Result<(Scene, State, Vec<Mode>), ModesError> {
    let scene = scene::build(case, coarsening)?;
    if scene.elements.rigid_payload.is_some() {
        return Err(ModesError::RigidPayload);
    }
    let mut rest = scene.initial_state();
    equilibrium::EquilibriumSearch::default().run(&scene, 0.0, &mut rest)?;
    // Fibre ropes swing at their stiffness in motion.
    scene.line.remember_ropes(0.0, 0.0, &mut rest);
    let mut pencil = Pencil::new(&scene, &rest);
    let pairs = lowest(&mut pencil, count)?;
    let points: Vec<V3> = rest.x.clone();
    let modes = modes_of(&pencil, &points, pairs);
    Ok((scene, rest, modes))
}
