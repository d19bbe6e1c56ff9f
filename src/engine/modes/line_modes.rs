//! Modes of a case: static equilibrium, modes about it, and their errors estimated from a mesh of half the segments.

use super::{EigenError, Mode, ModeFrame, ModeKind, ModePencil, lowest, modes_of};
use crate::case::Case;
use crate::scene::{self, Scene, SceneError};
use crate::solve::State;
use crate::statics::equilibrium;

/// Additional modes on the coarse mesh, where their order may differ.
pub const MORE: usize = 4;

/// Why the modes of a case were not computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModesError {
    /// The scene could not be built.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// No equilibrium was found.
    #[error("{0}")]
    Rest(#[from] equilibrium::EquilibriumError),
    /// The eigenproblem was not solved.
    #[error("{0}")]
    Modes(#[from] EigenError),
    /// The payload rotates.
    #[error(
        "modes of a line with a payload that rotates are not computed; leave out `payload.rotation`"
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
    /// Error of its frequency from the mesh \[Hz\]; absent if the coarse mesh has no such mode.
    pub error_hz: Option<f64>,
    /// What moves most by kinetic energy; nothing of a line by itself.
    pub most: Option<String>,
}

/// A line at rest.
#[derive(Debug, Clone)]
pub struct ModeLine {
    /// Its name; empty of a line by itself.
    pub name: String,
    /// The line.
    pub scene: Scene,
    /// Its state at rest.
    pub rest: State,
}

/// Lines at rest, and the lowest modes of them and what they hang on.
#[derive(Debug, Clone)]
pub struct LineModes {
    /// The lines, in the order of the shapes of modes.
    pub lines: Vec<ModeLine>,
    /// The modes, from the lowest frequency up.
    pub modes: Vec<NamedMode>,
}

/// The `count` lowest modes of a case's line about its static shape, or all there are.
///
/// # Errors
/// [`ModesError`].
pub fn of_case(case: &Case, count: usize) -> Result<LineModes, ModesError> {
    let (scene, rest, mut modes) = on_mesh(case, 1, count)?;
    modes.truncate(count);
    // The estimate needs a different mesh; if it fails, the modes are given without.
    let coarse = on_mesh(case, 2, count + MORE).ok();
    let segments = scene.line.segments.len() as f64;
    let coarse = coarse.map(|(coarse, _, modes)| {
        let ratio = segments / coarse.line.segments.len() as f64;
        (ratio, modes)
    });
    let coarse = coarse.as_ref().filter(|(ratio, _)| *ratio > 1.0);
    let coarse = coarse.map(|(ratio, modes)| (*ratio, modes.as_slice()));
    let modes = named(modes, coarse, touchdown_share(&scene, &rest));
    let line = ModeLine {
        name: String::new(),
        scene,
        rest,
    };
    Ok(LineModes {
        lines: vec![line],
        modes,
    })
}

/// Modes with their numbers among those of their kinds, and their errors from a mesh with so many times fewer segments that has the modes
/// given; `touchdown` is the share of [`touchdown_share`].
#[must_use]
pub fn named(modes: Vec<Mode>, coarse: Option<(f64, &[Mode])>, touchdown: f64) -> Vec<NamedMode> {
    let numbers: Vec<usize> = modes
        .iter()
        .enumerate()
        .map(|(i, mode)| 1 + of_kind(&modes[..i], mode.kind).count())
        .collect();
    let named = modes.into_iter().zip(numbers).map(|(mode, number)| {
        // The lumped line is of second order (Richardson extrapolation), but not at a touchdown.
        let unknown = match mode.kind {
            ModeKind::OutOfPlane => 0.0,
            _ => touchdown * mode.frequency_hz(),
        };
        let error_hz = coarse.and_then(|(ratio, modes)| {
            let other = of_kind_at(modes, mode.kind, number)?;
            let by_mesh = (mode.frequency_hz() - other.frequency_hz()).abs();
            Some(by_mesh / (ratio * ratio - 1.0) + unknown)
        });
        NamedMode {
            of_kind: number,
            error_hz,
            most: None,
            mode,
        }
    });
    named.collect()
}

/// Relative error of in-plane frequencies by the touchdown, which the mesh resolves to half a segment: the suspended length is
/// uncertain by as much, and frequencies vary about as its inverse. The greatest over all touchdowns.
#[must_use]
pub fn touchdown_share(scene: &Scene, rest: &State) -> f64 {
    let Some(bed) = &scene.elements.bed else {
        return 0.0;
    };
    let lies: Vec<bool> = (0..=scene.line.segments.len())
        .map(|i| bed.height(&rest.x[i]) <= 0.0)
        .collect();
    let mut worst = 0.0_f64;
    let mut from = 0;
    // A run of suspended nodes, with the nodes on the bed or the ends that bound it.
    for run in lies.chunk_by(|a, b| a == b) {
        let to = from + run.len();
        if !run[0] {
            let (first, last) = (from.saturating_sub(1), to.min(lies.len() - 1));
            let length = scene.line.arc[last] - scene.line.arc[first];
            let half = |beside: bool, i: usize| {
                f64::from(u8::from(beside)) * 0.5 * scene.line.segments[i].axial.length
            };
            // The end of the line is no touchdown, even on the bed.
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
    let (rest, modes) = of_scene_at_rest(&scene, count)?;
    Ok((scene, rest, modes))
}

/// The state of a line at rest, and the lowest modes about it, possibly a few more.
///
/// # Errors
/// [`ModesError`].
pub fn of_scene_at_rest(scene: &Scene, count: usize) -> Result<(State, Vec<Mode>), ModesError> {
    if scene.elements.rigid_payload.is_some() {
        return Err(ModesError::RigidPayload);
    }
    let mut rest = scene.initial_state();
    equilibrium::EquilibriumSearch::default().run(scene, 0.0, &mut rest)?;
    // Fibre ropes oscillate at their dynamic stiffness.
    scene.line.remember_ropes(0.0, 0.0, &mut rest);
    let mut pencil = ModePencil::new(scene, &rest);
    let pairs = lowest(&mut pencil, count)?;
    let modes = modes_of(&pencil, &ModeFrame::of_lines(&[&rest.x]), pairs);
    Ok((rest, modes))
}
