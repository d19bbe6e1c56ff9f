//! A force on the line as an element: everything that the solvers and the outputs ask of it, in one place.

use super::LumpedLine;
use crate::numerics::{BlockBand, V3};
use crate::solve::{Factors, State};

/// Where an element is evaluated: a state of the line at a time.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    /// The line on which it acts.
    pub(super) line: &'a LumpedLine,
    /// Time \[s\].
    pub(super) t: f64,
    /// State of the nodes.
    pub(super) state: &'a State,
}

/// A force on the line. It holds the handles of its nodes, and gives of the following what it has.
///
/// All sums are accumulated in place, in the order of [`Elements::iter`](super::elements::Elements::iter): results do not
/// depend on how the forces are grouped.
pub(super) trait Element {
    /// Adds its part of the residual `R = M a - f` \[N\]: its force counts negative, the inertia it adds positive.
    fn add_residual(&self, at: At<'_>, r: &mut [V3]);

    /// Adds the same, and `mass dR/da + damping dR/dv + stiffness dR/dx` of it to the tangent.
    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand);

    /// Whether it couples nodes two apart.
    fn is_pentadiagonal(&self) -> bool {
        false
    }

    /// Whether the explicit right-hand side (`scene/explicit.rs`) has a form of its own for it, since it has mass or is summed
    /// node by node. That of all others is their residual, which must then not depend on accelerations.
    fn has_explicit_form(&self) -> bool {
        false
    }

    /// Rate at which it slows a node \[1/s\], for the explicit step.
    fn decay_rate(&self, _at: At<'_>, _node: usize) -> f64 {
        0.0
    }

    /// Stiffness that it adds to segment i in its highest mode \[N/m\], for the explicit step.
    fn segment_stiffness(&self, _line: &LumpedLine, _i: usize) -> f64 {
        0.0
    }

    /// Stiffness that it adds to a node by itself \[N/m\], for the explicit step.
    fn node_stiffness(&self, _node: usize) -> f64 {
        0.0
    }

    /// The displacement along a spring of stiffness `stiffest` \[N/m\] that changes a force as much as the displacements d do:
    /// its part of Newton's convergence norm.
    fn equivalent_displacement(&self, _at: At<'_>, _d: &[V3], _stiffest: f64) -> f64 {
        0.0
    }

    /// Adds its energy \[J\].
    fn add_energy(&self, _at: At<'_>, _energy: &mut f64) {}

    /// Adds the power that it dissipates \[W\].
    fn add_dissipation(&self, _at: At<'_>, _power: &mut f64) {}

    /// Adds the power that waves put into it \[W\], beyond what its potential gains in still water.
    fn add_wave_power(&self, _at: At<'_>, _power: &mut f64) {}

    /// Adds the power that moving water puts into it by drag \[W\]: drag times the velocity of the water.
    fn add_water_drag_power(&self, _at: At<'_>, _power: &mut f64) {}

    /// Adds the rate `v' (dM/dt) v / 2` of the kinetic energy of its added mass as that grows \[W\], which is the power of no
    /// force, and the energy that comes in with material that is paid out.
    fn add_growth(&self, _at: At<'_>, _power: &mut f64) {}

    /// Adds its force on the first or last node, less the inertia it adds there \[N\].
    fn add_end_force(&self, _at: At<'_>, _node: usize, _force: &mut V3) {}

    /// Updates its history by an accepted state.
    fn commit(&self, _line: &LumpedLine, _state: &mut State) {}
}
