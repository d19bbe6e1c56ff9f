//! What is known of a line at rest between two ends.

use super::turning_clamps::{ClampedEquilibrium, CondensedLine};
use crate::numerics::{EndBlocks, M3, V3};
use crate::scene::{LaidFrom, Scene};
use crate::solve::State;
use crate::statics::equilibrium::Equilibrium;

/// A line at rest between two ends.
#[derive(Debug, Clone, PartialEq)]
pub struct LineEquilibrium {
    /// Force of the line on its end A \[N\], which the line pulls: the tension of the segment there with weight and drag of the
    /// half segment at the node, so that it is of second order in the length of the segments, and both end forces add up to
    /// all loads on the line. Where the end is on the bed it contains what the bed bears of the line there.
    pub force_a_n: V3,
    /// The same on end B.
    pub force_b_n: V3,
    /// What the bed bears along its normal of the half segments at ends that lie on it \[N\], A first: part of the end forces. Where something
    /// else holds the end up, it bears that.
    pub bed_reaction_n: [V3; 2],
    /// Change of `bed_reaction_n` as its end moves along the bed, which turns its normal \[N/m\]; nothing on a plane.
    pub bed_reaction_turning_n_per_m: [M3; 2],
    /// Change of the force on end i as end j moves \[N/m\], `[i][j]`, rows and columns x, y, z: exact for the discretised line
    /// with the friction springs of the bed where they are; negative on its diagonal for a line that resists. Symmetric
    /// without current and friction. At a kink (a node about to touch the bed, a segment about to slacken) those on one side.
    /// For an end held on the bed those of an end that stays on it: raised, it has the line's weight to carry at once. Where
    /// line lies slack in a heap, its shape is known no better than its residual, and so is the stiffness there.
    pub stiffness_n_per_m: EndBlocks,
    /// What its clamps that turn do to what holds them; nothing without any.
    pub clamped: Option<Box<ClampedEquilibrium>>,
    /// Positions of the nodes from A to B \[m\].
    pub position_m: Vec<V3>,
    /// Effective tensions at the nodes \[N\].
    pub tension_n: Vec<f64>,
    /// Unstretched length of line on the bed \[m\], to half a segment at every touchdown.
    pub on_bed_m: f64,
    /// Least radius of curvature \[m\] where the line has bending stiffness; none if it is straight or has none.
    pub min_bend_radius_m: Option<f64>,
    /// Largest force left at a node \[N\].
    pub residual_n: f64,
    /// Newton iterations, all tries counted.
    pub iterations: u64,
    /// Directions in which the equilibrium is unstable, exact without current and friction; 0 if it is stable.
    pub unstable_directions: usize,
    /// Whether the equilibrium is that of a bed without friction, since none was found with it.
    pub friction_released: bool,
    /// Where it was laid from, if it lies on the bed from end to end.
    pub laid_from: LaidFrom,
}

impl LineEquilibrium {
    /// A line that bears on nothing, where it is.
    pub(super) fn unloaded(state: &State) -> Self {
        Self {
            force_a_n: V3::zeros(),
            force_b_n: V3::zeros(),
            bed_reaction_n: [V3::zeros(); 2],
            bed_reaction_turning_n_per_m: [M3::zeros(); 2],
            stiffness_n_per_m: [[M3::zeros(); 2]; 2],
            clamped: None,
            position_m: state.x.clone(),
            tension_n: vec![0.0; state.x.len()],
            on_bed_m: 0.0,
            min_bend_radius_m: None,
            residual_n: 0.0,
            iterations: 0,
            unstable_directions: 0,
            friction_released: false,
            laid_from: LaidFrom::default(),
        }
    }

    pub(super) fn new(
        scene: &Scene,
        state: &State,
        found: &Equilibrium,
        (condensed, unstable_directions): (&CondensedLine, usize),
    ) -> Self {
        let last = scene.line_nodes() - 1;
        Self {
            force_a_n: scene.end_force(0, state),
            force_b_n: scene.end_force(last, state),
            bed_reaction_n: [0, last].map(|node| scene.bed_reaction_on_end(node, state)),
            bed_reaction_turning_n_per_m: [0, last]
                .map(|node| scene.bed_reaction_turning(node, state)),
            stiffness_n_per_m: condensed.ends.map(|row| row.map(|block: M3| -block)),
            clamped: ClampedEquilibrium::of_condensed_line(scene, state, condensed),
            position_m: state.x.clone(),
            tension_n: scene.tensions(state),
            on_bed_m: scene.length_touching_bed(state),
            min_bend_radius_m: min_bend_radius(scene, state),
            residual_n: found.residual,
            iterations: found.iterations,
            unstable_directions,
            friction_released: found.friction_released,
            laid_from: scene.start.laid_from,
        }
    }

    /// Both end forces \[N\], that on A first.
    #[must_use]
    pub fn forces_n(&self) -> [V3; 2] {
        [self.force_a_n, self.force_b_n]
    }

    /// Where the ends are, A first \[m\].
    #[must_use]
    pub fn ends_m(&self) -> [V3; 2] {
        let nodes = self.position_m.as_slice();
        [nodes.first(), nodes.last()].map(|end| end.copied().unwrap_or_default())
    }
}

fn min_bend_radius(scene: &Scene, state: &State) -> Option<f64> {
    let flexure = scene.elements.flexure.as_ref()?;
    let nodes = 0..=scene.line.segments.len();
    let curvature = nodes
        .map(|i| flexure.bent_at(i, &scene.line, state).0)
        .fold(0.0, f64::max);
    (curvature > 0.0).then(|| 1.0 / curvature)
}

/// Greatest change of either end force between two solutions, each by its norm \[N\].
pub(super) fn differences(one: &LineEquilibrium, other: &LineEquilibrium) -> [f64; 2] {
    let (one, other) = (one.forces_n(), other.forces_n());
    [0, 1].map(|i| (one[i] - other[i]).norm())
}
