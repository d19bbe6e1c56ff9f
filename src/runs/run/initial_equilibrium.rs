//! The initial equilibrium of a line, and warnings about it: that it is unstable, one of several, or that there is none.

use std::sync::atomic::AtomicBool;

use super::Work;
use crate::case::{Case, Method};
use crate::scene::Scene;
use crate::solve::State;
use crate::statics::equilibrium::{EquilibriumSearch, instabilities};

/// A turn between neighbouring segments \[rad\] from which the mesh error is not of second order any more.
const SHARP: f64 = 0.8;

/// Finds the equilibrium where the case asks for one, and warns where it is unstable or not unique.
///
/// # Errors
/// Why there is none, in words, or that it was stopped.
pub(super) fn find_equilibrium(
    case: &Case,
    scene: &Scene,
    state: &mut State,
    cancel: &AtomicBool,
    (work, warnings): (&mut Work, &mut Vec<String>),
) -> Result<(), String> {
    if !scene.start.in_equilibrium && case.solver.method != Method::Static {
        return Ok(());
    }
    search(scene, state, cancel, (work, warnings))?;
    check_equilibrium(scene, state, warnings)
}

/// Finds the equilibrium.
fn search(
    scene: &Scene,
    state: &mut State,
    cancel: &AtomicBool,
    (work, warnings): (&mut Work, &mut Vec<String>),
) -> Result<(), String> {
    let stoppable = EquilibriumSearch {
        stop: Some(cancel),
        ..EquilibriumSearch::default()
    };
    match stoppable.run(scene, 0.0, state) {
        Ok(found) => {
            work.iterations += found.iterations;
            if found.friction_released {
                warnings.push(
                    "the equilibrium found is one of many: none was found for the line with its assumed bed friction; it lies where it \
                     would on a smooth bed, and friction is zero at the start"
                        .to_owned(),
                );
            }
        }
        Err(error) => {
            work.iterations += error.iterations;
            let closed_form = scene.catenary_error();
            let mut words = error.to_string();
            if let Some(why) = closed_form {
                words += &format!(". Without bending, in still water: {why}");
            }
            let slack = scene.untensioned_on_bed(state);
            if slack > 0.0 {
                words += &format!(
                    ". {slack:.1} m of the line lie slack on the bed, where nothing gives them a shape; `seabed.friction` would"
                );
            }
            return Err(words);
        }
    }
    Ok(())
}

/// Warns of an equilibrium that is unstable, not unique, or kinked too sharply for its mesh.
///
/// # Errors
/// The line is slack all along: its shape is undetermined.
fn check_equilibrium(
    scene: &Scene,
    state: &State,
    warnings: &mut Vec<String>,
) -> Result<(), String> {
    // Friction makes the tangent unsymmetric: its pivots then do not show stability.
    let rough = scene
        .elements
        .bed
        .as_ref()
        .is_some_and(|bed| bed.seabed.friction.is_some());
    let ways = instabilities(scene, 0.0, state);
    if ways.is_none() {
        let pulls = |i: usize| {
            scene.line.segments[i]
                .axial
                .tension(&scene.line.chord(i, state))
                .value
                != 0.0
        };
        if !(0..scene.line.segments.len()).any(pulls) {
            return Err(
                "the line is slack all along and nothing holds it in a shape: any other would do as well; give it \
                 weight or bending stiffness, or let a dynamic run begin with start.shape = \"given\""
                    .to_owned(),
            );
        }
        let slack = "the equilibrium found is one of many: part of the line lies slack, and nothing holds it in this shape";
        warnings.push(many_shapes(scene, state).unwrap_or_else(|| slack.to_owned()));
    }
    if !rough && ways.is_some_and(|ways| ways > 0) {
        let unstable = "the equilibrium found is not stable: forces balance, but a line pushed aside a little would leave \
                        this shape for another one; start from another shape to find that";
        warnings.push(unstable.to_owned());
    }
    let (turn, node) = scene.sharpest_turn(state);
    if turn > SHARP {
        warnings.push(format!(
            "the line at rest turns by {:.0} degrees at node {node}: too sharply for segments of that length, and more \
             than the estimated errors show; use more segments there",
            turn.to_degrees()
        ));
    }
    if ways.is_some() {
        warnings.extend(many_shapes(scene, state));
    }
    warnings.extend(other_side(scene, state));
    Ok(())
}

/// Warns that slack line lies in one of many shapes, on the bed or on the surface of the water.
fn many_shapes(scene: &Scene, state: &State) -> Option<String> {
    let places = [
        (scene.untensioned_on_bed(state), "lie on the bed"),
        (
            scene.untensioned_afloat(state),
            "float on the surface of the water",
        ),
    ];
    let (length, how) = places.into_iter().find(|(length, _)| *length > 0.0)?;
    Some(format!(
        "{length:.1} m of the line {how} without tension, where nothing gives them a shape: the one shown is \
         one of many, all with the same forces at the ends"
    ))
}

/// Warns of a second equilibrium of a line that bends, on the other side of its chord.
fn other_side(scene: &Scene, state: &State) -> Option<String> {
    scene.elements.flexure.as_ref()?;
    let (mut other, node) = scene.mirrored(state)?;
    // What takes a long search is no neighbour of the mirror image.
    let short = EquilibriumSearch {
        max_steps: 60,
        ..EquilibriumSearch::default()
    };
    short.run(scene, 0.0, &mut other).ok()?;
    let apart = (other.x[node] - state.x[node]).norm();
    let length = scene.line.arc.last().copied().unwrap_or(1.0);
    if apart < 1e-3 * length {
        return None;
    }
    let stays = instabilities(scene, 0.0, &other)? == 0;
    let [here, there] = [state, &other].map(|s| s.x[node]);
    let more = scene.energy(&other) - scene.energy(state);
    Some(format!(
        "the line has more than one equilibrium: found is the one with node {node} at ({:.3}, {:.3}, {:.3}) m; it may rest \
         with that node at ({:.3}, {:.3}, {:.3}) m as well, with {:.3e} J {} energy{}",
        here.x,
        here.y,
        here.z,
        there.x,
        there.y,
        there.z,
        more.abs(),
        if more < 0.0 { "less" } else { "more" },
        if stays {
            ""
        } else {
            ", though it would not stay there"
        },
    ))
}
