//! What each solver needs of a discretised system, as one small trait each.
//!
//! | trait | used by |
//! |---|---|
//! | [`Kinematics`] | all |
//! | [`Residual`] | Newton: statics and every implicit step |
//! | [`ExplicitRhs`] | Runge-Kutta; the first acceleration of generalized-alpha |
//! | [`Hysteresis`] | the time march, after every accepted step |
//! | [`MidstepBalance`] | generalized-alpha, which balances forces between two steps |
//! | [`StaticSearch`] | the search for an equilibrium |
//!
//! These are of one line. Newton's method, the methods of time integration and the march take any system: see
//! [`Iterated`](super::Iterated), [`Integrated`](super::Integrated) and [`Marched`](super::Marched), which a line has by these.
//!
//! No function of these changes the system. None allocates, except for the memory of a state at its first use.

use std::ops::Range;

use super::State;
use crate::numerics::{BlockBand, V3};

/// Weights of mass, damping and stiffness in a tangent. Statics, quasi-statics and the implicit time steps differ in
/// these only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// Change of acceleration per change of position \[1/s²\].
    pub mass: f64,
    /// Change of velocity per change of position \[1/s\].
    pub damping: f64,
    /// Change of position per change of position \[-\]; 1 but for tests and modes.
    pub stiffness: f64,
}

/// The nodes of a system, and what is prescribed of them.
pub trait Kinematics: Sync {
    /// Number of nodes, both ends counted.
    fn nodes(&self) -> usize;

    /// The nodes that follow the equation of motion; the others are prescribed.
    fn free(&self) -> Range<usize>;

    /// Sets position, velocity and acceleration of the prescribed nodes at time t \[s\].
    fn prescribe(&self, t: f64, state: &mut State);

    /// The next time at which the velocity or acceleration of a prescribed node jumps \[s\], where steps must end; infinite if there
    /// is none. Until it is [passed](Self::pass_kink) the motion before it is prescribed, at any time.
    fn next_kink(&self, _state: &State) -> f64 {
        f64::INFINITY
    }

    /// Passes the next kink at time t \[s\], and prescribes the motion after it. Returns whether a velocity jumps.
    fn pass_kink(&self, _t: f64, _state: &mut State) -> bool {
        false
    }

    /// Writes the wave kinematics at the nodes at time t \[s\] into the state, for all evaluations at and near that
    /// state. A method calls it once for every state at which it evaluates forces, when positions are known or predicted;
    /// statics never does. Allocates at the first call only.
    fn update_wave_kinematics(&self, _t: f64, _state: &mut State) {}

    /// The same from a state in which they were written a time \[s\] before, the nodes close to where they are now: for readings of an accepted
    /// state, whose forces act no more.
    fn extrapolate_wave_kinematics(&self, t: f64, _time: f64, _before: &State, state: &mut State) {
        self.update_wave_kinematics(t, state);
    }
}

/// The residual `R = M(x) a - f(t, x, v)` \[N\], three rows a node, and its tangent.
pub trait Residual: Kinematics {
    /// Whether nodes two apart are coupled: the tangent is then block-pentadiagonal.
    fn is_pentadiagonal(&self) -> bool;

    /// Sets the residual of every node.
    fn residual(&self, t: f64, state: &State, r: &mut [V3]);

    /// Sets the residual, and its tangent `mass dR/da + damping dR/dv + stiffness dR/dx`.
    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand);

    /// Extrapolates the tensions in the state to first order over the displacements `-d`, before these are made.
    ///
    /// A stiff segment that turns stretches at second order: a small strain, but a large tension. With extrapolated
    /// tensions in the geometric stiffness the iteration does not see it, and needs a few iterations however stiff the line
    /// (mixed iteration: Magisano, Leonetti and Garcea 2017).
    fn extrapolate_tensions(&self, _d: &[V3], _state: &mut State) {}

    /// Whether the displacements `-d` that led to this state pass a kink of a force: what was linear so far says nothing of what
    /// follows.
    fn passes_kink(&self, _d: &[V3], _state: &State) -> bool {
        false
    }

    /// The displacement \[m\] of a node along the stiffest part of the line that would change a force as much as the
    /// displacements d do at most, without inertia and drag: Newton's norm of convergence on force. The default counts all
    /// directions alike.
    fn force_norm_displacement(&self, d: &[V3], _state: &State) -> f64 {
        d.iter().map(V3::amax).fold(0.0, f64::max)
    }
}

/// Accelerations from positions and velocities.
pub trait ExplicitRhs: Kinematics {
    /// Sets the accelerations of the free nodes, `a = M(x)^-1 f(t, x, v)`; those of prescribed nodes stay.
    fn accelerate(&self, t: f64, state: &mut State);

    /// An upper bound of the rate at which damping slows a free node \[1/s\], and the node: it limits the explicit step.
    fn fastest_decay(&self, _state: &State) -> (f64, usize) {
        (0.0, 0)
    }
}

/// History variables: friction of the bed, mean tension of ropes, drag coefficients frozen over a step.
pub trait Hysteresis: Kinematics {
    /// Updates the history by an accepted state at time t \[s\], `dt` after the one before: at the start with `dt` 0,
    /// then after every accepted step. Allocates at the start only.
    fn commit(&self, _t: f64, _dt: f64, _state: &mut State) {}

    /// Freezes the normal drag coefficients at the velocities of the state until the next step is accepted. A method
    /// without inertia needs this where the coefficient jumps: nothing else carries a node across a force that falls while
    /// its speed rises.
    fn freeze_drag_coefficients(&self, _state: &mut State) {}
}

/// Corrections for a method that balances forces at a mix of the states before and after a step.
pub trait MidstepBalance: Residual {
    /// Writes into the state at the end of a step by how much its chords exceed the lengths that belong to the tensions.
    /// `fraction` is that of the state before in the mix. The chord of a segment that turns is shorter in the mix than before
    /// and after, so that the balance makes both too long, and the tension read at the end of the step too high by
    /// `EA fraction (1 - fraction) (omega h)² / 2`. Allocates at the first call only.
    fn correct_chord_lengths(&self, _fraction: f64, _before: &State, _end: &mut State) {}

    /// The greatest acceleration \[m/s²\] of a node by segments that are slack at `between` and taut at `end`: the balance
    /// has not seen their pull.
    fn snap_acceleration(&self, _between: &State, _end: &State) -> f64 {
        0.0
    }
}

/// Scales and auxiliary systems for the search for an equilibrium.
pub trait StaticSearch: Residual + Sized {
    /// A force typical of the system \[N\], to which residuals are relative.
    fn force_scale(&self) -> f64;

    /// The force that the rounding of positions makes \[N\]: no residual can be smaller.
    fn rounding_force(&self) -> f64;

    /// The displacement of a node \[m\] below which no force changes by more than `relative` times
    /// [`force_scale`](Self::force_scale).
    fn position_tolerance(&self, relative: f64) -> f64;

    /// Writes the tensions from which the mixed iteration starts into the state: those of its strain or, where these are
    /// out of all proportion, those of the initial guess.
    fn initialise_tensions(&self, _state: &mut State) {}

    /// Brings the one stiffness of ropes whose segments share it up to date with the state at rest; returns by how much it
    /// changes at most, relative to itself.
    fn share_stiffness(&self, _state: &mut State) -> f64 {
        0.0
    }

    /// A node at which the line folds back on itself, if there is one. The bending moment vanishes at a fold, so that forces
    /// may balance there, but no such equilibrium is stable.
    fn kinked_node(&self, _state: &State) -> Option<usize> {
        None
    }

    /// The system with its clamps turned by a fraction of the angle from the direction of the line in `start` to their
    /// own; none without clamps.
    fn with_clamps(&self, _start: &State, _fraction: f64) -> Option<Self> {
        None
    }

    /// The system on a bed without friction; none if there is no friction.
    fn without_friction(&self) -> Option<Self> {
        None
    }

    /// Attaches the friction springs at the present positions, without force.
    fn reset_friction(&self, _state: &mut State) {}

    /// A node on the bed that bears more than the friction there is, as one that was laid may ([`crate::physics::FrictionAnchor::laid`]): it slides.
    fn sliding_node(&self, _state: &State) -> Option<usize> {
        None
    }

    /// Whether that node is slack on a slope steeper than friction bears, down which it slides away.
    fn slides_slack(&self, _state: &State) -> bool {
        false
    }

    /// Whether line on the bed has tension, which friction there takes part in.
    fn pulls_on_bed(&self, _state: &State) -> bool {
        false
    }

    /// Whether a current may move line that lies on a rough bed.
    fn flows_over_rough_bed(&self) -> bool {
        false
    }

    /// The system with the secant of friction in the place of its derivative; none if there is no friction.
    fn with_secant_friction(&self) -> Option<Self> {
        None
    }
}
