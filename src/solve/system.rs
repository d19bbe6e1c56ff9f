//! What a solver may ask of a line.

use std::ops::Range;

use crate::linalg::{BlockBand, V3};

/// Position \[m\], velocity \[m/s\] and acceleration \[m/s²\] of every node, from end A to end B.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Positions.
    pub x: Vec<V3>,
    /// Velocities.
    pub v: Vec<V3>,
    /// Accelerations.
    pub a: Vec<V3>,
    /// What the line remembers from the last accepted step, if anything: see [`System::remember`]. One entry a
    /// segment, or none at all.
    pub memory: Vec<[f64; 2]>,
    /// Tensions of the segments as the iteration before foretold them \[N\], for the stiffness across the line: see
    /// [`System::foretell`]. One entry a segment, or none at all: tensions are then those of the stretch.
    pub foretold: Vec<f64>,
}

impl State {
    /// At rest at the given positions.
    #[must_use]
    pub fn at_rest(x: Vec<V3>) -> Self {
        let n = x.len();
        Self {
            x,
            v: vec![V3::zeros(); n],
            a: vec![V3::zeros(); n],
            memory: Vec::new(),
            foretold: Vec::new(),
        }
    }

    /// Takes over another state of the same size without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.x.copy_from_slice(&other.x);
        self.v.copy_from_slice(&other.v);
        self.a.copy_from_slice(&other.a);
        self.memory.clone_from(&other.memory);
        self.foretold.clone_from(&other.foretold);
    }

    /// Whether every number is finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let finite = |list: &[V3]| list.iter().all(|p| p.iter().all(|c| c.is_finite()));
        finite(&self.x) && finite(&self.v) && finite(&self.a)
    }
}

/// How much of mass, damping and stiffness enters a tangent: statics, quasi-statics and every
/// implicit time step differ in nothing else.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// Change of acceleration per change of position \[1/s²\].
    pub mass: f64,
    /// Change of velocity per change of position \[1/s\].
    pub damping: f64,
    /// Change of position per change of position \[-\]; 1 but for tests.
    pub stiffness: f64,
}

/// A discretised line, as a solver sees it. The residual is `R = M(x) a - f(t, x, v)` \[N\], a vector
/// a node; none of these functions changes the line or allocates.
pub trait System: Sync {
    /// Number of nodes, both ends counted.
    fn nodes(&self) -> usize;

    /// The nodes that move by their equation of motion; the others are prescribed.
    fn free(&self) -> Range<usize>;

    /// Whether nodes two apart are coupled: the tangent then needs its far blocks.
    fn bends(&self) -> bool;

    /// Sets position, velocity and acceleration of the prescribed nodes at time t \[s\].
    fn prescribe(&self, t: f64, state: &mut State);

    /// The residual of every node.
    fn residual(&self, t: f64, state: &State, r: &mut [V3]);

    /// The residual, and its tangent `mass dR/da + damping dR/dv + stiffness dR/dx`.
    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand);

    /// Accelerations of the free nodes from positions and velocities, `a = M(x)^-1 f(t, x, v)`. Those
    /// of the prescribed nodes are left as they are.
    fn accelerate(&self, t: f64, state: &mut State);

    /// The fastest rate at which drag slows a free node that moves as it does \[1/s\], or more, and the node: what an
    /// explicit step must be short for. None unless a line tells one.
    fn fastest_decay(&self, _state: &State) -> (f64, usize) {
        (0.0, 0)
    }

    /// Writes into the state's memory what stays as it is until the next step is accepted: the normal drag
    /// coefficients of both halves of every segment. A method that leaves inertia out needs it where the coefficient
    /// jumps: without inertia nothing carries a node across a force that falls while its speed rises.
    fn remember(&self, state: &mut State);

    /// Writes into the state the tensions to begin with, from its stretch or, where that is nothing a line at rest
    /// could have, from the first guess.
    fn guess_tensions(&self, _state: &mut State) {}

    /// Writes into the state the tensions that displacements `-d` make of it, to first order, before they are made. A
    /// stiff line that turns also stretches, to second order, by a strain that means little and a tension that means a
    /// lot; with foretold tensions in the stiffness across the line, Newton does not see those, and takes
    /// a few iterations to the same answer however stiff the line (the mixed iteration of Magisano, Leonetti and Garcea,
    /// 2017).
    fn foretell(&self, _d: &[V3], _state: &mut State) {}

    /// A node at which the line is folded back on itself, if there is one. Bending forces vanish at such a fold, so
    /// that forces may balance there, but no line stays so: an equilibrium with a fold is none to be told.
    fn folded(&self, _state: &State) -> Option<usize> {
        None
    }

    /// A force typical of this line \[N\]: residuals are measured against it.
    fn force_scale(&self) -> f64;

    /// The force that rounding of positions makes of nothing \[N\]: no residual can be asked to be smaller.
    fn rounding_force(&self) -> f64;

    /// The displacement of a node \[m\] below which no force of the line changes by more than
    /// `relative` times [`System::force_scale`]: what "converged on force" means for positions.
    fn position_tolerance(&self, relative: f64) -> f64;
}
