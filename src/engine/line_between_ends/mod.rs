//! A line at rest between two held ends as one element of a system: its forces on the ends, and how they change as the ends move.
//!
//! For lines that have no closed form ([`crate::statics::catenary`]): in a current, with bending stiffness, or of a material
//! without a constant EA. The discretised line is solved again and again for other places of its ends, from its last equilibrium; the
//! end stiffness is its tangent condensed onto the end nodes ([`Condensation`]), exact for the discretised line.
//!
//! **Friction of the bed** acts by springs, attached where the line was laid ([`LineBetweenEnds::lay`]): at the ends of the first
//! solution, and not again of itself. The forces are then a function of where the ends are, not of the way they came, and the stiffness is
//! its derivative.
//!
//! ```
//! use seacable_model::case::{Case, Current, End, Ends, Material, OneOrMany, Section};
//! use seacable_engine::line_between_ends::LineBetweenEnds;
//!
//! let ends = Ends {
//!     a: End::fixed("anchor", [0.0, 0.0, -100.0]),
//!     b: End::fixed("buoy", [80.0, 0.0, 0.0]),
//! };
//! let mut case = Case::new("Riser", ends);
//! case.materials.insert("rope".into(), Material::new(0.1, 20.0, 1e7));
//! case.line = vec![Section::new("rope", "rope", 140.0, 40)];
//! case.current = Some(Current {
//!     speed_m_per_s: Some(OneOrMany::One(0.5)),
//!     direction_deg: OneOrMany::One(90.0),
//!     depth_m: None,
//!     file: None,
//! });
//! let mut line = LineBetweenEnds::new(&case)?;
//! let here = line.solve([0.0, 0.0, -100.0], [80.0, 0.0, 0.0])?;
//! let there = line.solve([0.0, 0.0, -100.0], [80.001, 0.0, 0.0])?;
//! let change = there.force_b_n[0] - here.force_b_n[0];
//! let stiffness = here.stiffness_n_per_m[1][1][(0, 0)];
//! assert!((change / 0.001 - stiffness).abs() < 1e-3 * stiffness.abs());
//! # Ok::<(), seacable_engine::line_between_ends::LineError>(())
//! ```

mod error;
mod line_equilibrium;
mod mesh_error;
mod turning_clamps;

pub use error::LineError;
pub use line_equilibrium::LineEquilibrium;
pub use mesh_error::{MeshOrder, mesh_error};
pub use turning_clamps::ClampedEquilibrium;

use crate::case::{Case, End, EndKind};
use crate::numerics::{BlockBand, Condensation, M3, SingularBlock, V3};
use crate::scene::{self, LaidFrom, Scene, straight_between};
use crate::solve::{Kinematics, Newton, Residual, State, StaticSearch};
use crate::statics::equilibrium::{Equilibrium, EquilibriumSearch};
use turning_clamps::{CondensedLine, Turning};

/// Newton iterations of a warm start.
const WARM_ITERATIONS: usize = 15;
/// Change of the vector from end A to end B relative to the length of the line beyond which the last equilibrium is no start.
const FAR: f64 = 0.2;
/// Greatest displacement of a node in an iteration of a warm start, relative to the length of the line.
const LONGEST_ITERATION: f64 = 0.3;
/// Stiffness added to nodes that nothing holds, relative to the stiffest.
const LEAST_STIFFNESS: f64 = 1e-12;

/// A line between two held ends, built once of its case and solved for many places of the ends. Its work arrays are allocated by the first
/// solution.
///
/// Of the case it takes the line, its materials, clumps, environment, current and bed, and of its start the coordinates from which its
/// equilibrium is searched in the place of the closed form, displaced with the ends. Waves, events and loads that vary with time are left out.
#[derive(Debug, Clone)]
pub struct LineBetweenEnds {
    /// Initial shape and friction springs of the cold start.
    scene: Scene,
    /// The initial shape that the case gives, if it does.
    given: Option<Vec<V3>>,
    search: EquilibriumSearch<'static>,
    newton: Newton,
    /// The last equilibrium, if there is one, and the negative pivots of its tangent: its unstable directions in still water.
    last: State,
    unstable: Option<usize>,
    /// Whether the friction springs are attached.
    laid: bool,
    /// The clamps that turn.
    turning: Turning,
    trial: State,
    residual: Vec<V3>,
    tangent: BlockBand,
    condensation: Condensation,
    /// Displacements of a warm start, negative as Newton's.
    displacement: Vec<V3>,
}

impl LineBetweenEnds {
    /// The line of a case, both ends of which are fixed or anchors; where they are does not matter.
    ///
    /// # Errors
    /// [`LineError::NotHeld`] for an end of another kind, [`LineError::Scene`] when the case contradicts itself.
    pub fn new(case: &Case) -> Result<Self, LineError> {
        for (end, key) in [(&case.ends.a, "ends.a"), (&case.ends.b, "ends.b")] {
            if !is_held(end) {
                return Err(LineError::NotHeld { key });
            }
        }
        let scene = scene::build(case, 1)?;
        let is_given = case.start.arc_m.is_some();
        Ok(Self {
            given: is_given.then(|| scene.start.positions.clone()),
            search: EquilibriumSearch::default(),
            newton: Newton::new(0, 0.0, 0),
            unstable: None,
            laid: false,
            turning: Turning::default(),
            trial: State::at_rest(Vec::new()),
            last: scene.initial_state(),
            residual: Vec::new(),
            tangent: BlockBand::new(0),
            condensation: Condensation::new(0),
            displacement: Vec::new(),
            scene,
        })
    }

    /// Allocates the work arrays where there are none.
    fn allocate(&mut self) {
        let nodes = self.scene.nodes();
        if self.residual.len() == nodes {
            return;
        }
        self.newton = self.search.newton(&self.scene);
        self.newton.max_iterations = WARM_ITERATIONS;
        self.newton.max_displacement = LONGEST_ITERATION * length(&self.scene);
        self.tangent = BlockBand::new(nodes);
        if self.scene.is_pentadiagonal() {
            self.tangent.widen();
        }
        self.trial = self.last.clone();
        self.residual = vec![V3::zeros(); nodes];
        self.condensation = Condensation::new(nodes);
        if (0..2).any(|end| self.scene.is_clamped(end)) {
            self.condensation = Condensation::new(nodes).with_sides();
        }
        self.displacement = vec![V3::zeros(); nodes];
    }

    /// Frees the work arrays, several times as much as the line itself. The next solution allocates them and starts from the closed form.
    pub fn free_work(&mut self) {
        self.unstable = None;
        self.newton = Newton::new(0, 0.0, 0);
        self.tangent = BlockBand::new(0);
        self.trial = State::at_rest(Vec::new());
        self.residual = Vec::new();
        self.condensation = Condensation::new(0);
        self.displacement = Vec::new();
    }

    /// The equilibrium with its ends at these places \[m\]: by Newton's method from the last one, displaced by its linear response
    /// to the motion of the ends; the first time, far from the last one or if that fails, from the closed form by
    /// [`EquilibriumSearch`]. Allocates the result only, except the first time, from the closed form or where it slides on the bed.
    ///
    /// # Errors
    /// [`LineError::NotFinite`], which changes nothing; [`LineError::NoEquilibrium`] and [`LineError::NoStiffness`], after which
    /// the next solution starts from the closed form.
    pub fn solve(
        &mut self,
        a_m: impl Into<V3>,
        b_m: impl Into<V3>,
    ) -> Result<LineEquilibrium, LineError> {
        let (a, b) = (a_m.into(), b_m.into());
        if a.iter().chain(&b).any(|x: &f64| !x.is_finite()) {
            return Err(LineError::NotFinite);
        }
        self.allocate();
        self.newton.iterations = 0;
        let before = self.unstable;
        let warm = self.warm_start(a, b);
        // Until there is another one: the condensation below overwrites the factors of the last equilibrium.
        self.unstable = None;
        // More unstable directions: Newton has left the branch of the last equilibrium.
        if let Some(found) = warm
            && let Ok(condensed) = self.condense()
            && Some(self.condensation.negative_pivots()) <= before
        {
            return Ok(self.accept(found, &condensed));
        }
        let tried = self.newton.iterations;
        let mut found = self.cold_start(a, b)?;
        found.iterations += tried;
        let condensed = self.condense()?;
        Ok(self.accept(found, &condensed))
    }

    /// Turns the clamps at ends A and B into these directions of the line, from A to B, for its next solution, which then says what they do to
    /// what holds them: see [`ClampedEquilibrium`]. A hinge stays one.
    pub fn turn_clamps(&mut self, directions: &[Option<V3>; 2]) {
        self.scene.turn_clamps(directions);
        self.turning.now = [0, 1].map(|end| directions[end].filter(|_| self.scene.is_clamped(end)));
    }

    /// The line straight between its ends and without forces, as a run may begin in the place of an equilibrium that it does not have.
    pub fn unloaded(&mut self, a: V3, b: V3) -> LineEquilibrium {
        self.unstable = None;
        self.scene.hold_ends(a, b);
        self.last = State::at_rest(straight_between(a, b, &self.scene.line.arc));
        LineEquilibrium::unloaded(&self.last)
    }

    /// Lays the line on the bed anew for its next solution: friction of the bed then acts as on a line laid straight from the end on
    /// the bed and pulled to where its ends are, the assumption of the closed form. Where friction matters, lay a system that has
    /// come to rest again and solve it once more, until its forces no longer change. Without friction, the next solution is only a cold start.
    pub fn lay(&mut self) {
        self.laid = false;
        self.unstable = None;
    }

    /// Where the line was laid from if it lies on the bed from end to end, the next time that it is laid. Between ends that are
    /// held, as those of a line by itself, it has no friction.
    pub fn lay_from(&mut self, from: LaidFrom) {
        self.scene.start.laid_from = from;
    }

    /// The scene of the line with its ends held, and its last equilibrium.
    #[must_use]
    pub fn scene_and_state(&self) -> (&Scene, &State) {
        (&self.scene, &self.last)
    }

    /// Forgets the last equilibrium: the next solution starts from the closed form. Friction springs stay where they are.
    pub fn forget(&mut self) {
        self.unstable = None;
    }

    /// Newton's method into `trial` from the last equilibrium; none without one, far from it, or if it fails.
    fn warm_start(&mut self, a: V3, b: V3) -> Option<Equilibrium> {
        self.unstable?;
        let end = self.last.x.len() - 1;
        let (from_a, from_b) = (self.last.x[0] - a, self.last.x[end] - b);
        if (from_b - from_a).norm() > FAR * length(&self.scene) {
            return None;
        }
        self.scene.hold_ends(a, b);
        (self.displacement[0], self.displacement[end]) = (from_a, from_b);
        self.turning
            .respond(&self.condensation, &mut self.displacement);
        // First with extrapolated tensions, which suit a taut line, then without, which suits a slack one.
        let found = [true, false]
            .into_iter()
            .find_map(|mixed| self.newton_from_last(mixed));
        found.or_else(|| self.slide_from_last())
    }

    /// Newton's method from the last equilibrium; none where friction does not hold what it finds.
    fn newton_from_last(&mut self, mixed: bool) -> Option<Equilibrium> {
        self.displace_last(mixed);
        let (search, newton) = (&self.search, &mut self.newton);
        let found = search.refine(&self.scene, 0.0, newton, &mut self.trial);
        found
            .ok()
            .filter(|_| self.scene.sliding_node(&self.trial).is_none())
    }

    /// The equilibrium that the line slides to from the last one, if that slid as well.
    fn slide_from_last(&mut self) -> Option<Equilibrium> {
        let grips = &self.last.memory.grips;
        if grips.is_empty() || grips.iter().any(|grip| grip.laid) {
            return None;
        }
        self.displace_last(false);
        let tried = self.newton.iterations;
        let found = (self.search).slide(&self.scene, 0.0, &mut self.trial, tried)?;
        self.newton.iterations = found.iterations;
        Some(found)
    }

    /// The last equilibrium into `trial`, displaced; `mixed` with extrapolated tensions.
    fn displace_last(&mut self, mixed: bool) {
        let trial = &mut self.trial;
        trial.copy_from(&self.last);
        if mixed {
            let segments = self.scene.line.segments.len();
            trial.extrapolated_tension.resize(segments, 0.0);
            self.scene.extrapolate_tensions(&self.displacement, trial);
        }
        for (x, d) in trial.x.iter_mut().zip(&self.displacement) {
            *x -= d;
        }
        self.scene.prescribe(0.0, trial);
    }

    /// The search into `trial` from the closed form, or from the shape given.
    fn cold_start(&mut self, a: V3, b: V3) -> Result<Equilibrium, LineError> {
        match &self.given {
            Some(shape) => self.scene.start_between_in(a, b, shape),
            None => self.scene.start_between(a, b),
        }
        if !self.laid {
            self.scene.lay_start_on_bed();
        }
        self.trial = self.scene.initial_state();
        let found = self.search.run(&self.scene, 0.0, &mut self.trial)?;
        // The search may have attached the friction springs elsewhere.
        let grips = &self.trial.memory.grips;
        self.scene.start.grips.clone_from(grips);
        self.laid = true;
        Ok(found)
    }

    /// The tangent of `trial` condensed onto the ends. Line that nothing holds, slack on a smooth bed, is given a little stiffness: it
    /// has no force, whatever its shape.
    fn condense(&mut self) -> Result<CondensedLine, LineError> {
        let (r, tangent) = (&mut self.residual, &mut self.tangent);
        self.scene.linearise_with_ends(0.0, &self.trial, r, tangent);
        if let Ok(condensed) = self.condense_tangent() {
            return Ok(condensed);
        }
        let tangent = &mut self.tangent;
        let stiffest = tangent.diag.iter().map(M3::amax).fold(0.0, f64::max);
        for i in self.scene.free() {
            for k in 0..3 {
                tangent.diag[i][(k, k)] += LEAST_STIFFNESS * stiffest;
            }
        }
        Ok(self.condense_tangent()?)
    }

    fn condense_tangent(&mut self) -> Result<CondensedLine, SingularBlock> {
        let at = (&self.scene, &self.trial);
        self.turning
            .condense(at, &self.tangent, &mut self.condensation)
    }

    /// Makes `trial` the last equilibrium.
    fn accept(&mut self, found: Equilibrium, condensed: &CondensedLine) -> LineEquilibrium {
        std::mem::swap(&mut self.last, &mut self.trial);
        self.turning.accept();
        let unstable = self.condensation.negative_pivots();
        self.unstable = Some(unstable);
        LineEquilibrium::new(&self.scene, &self.last, &found, (condensed, unstable))
    }
}

fn is_held(end: &End) -> bool {
    matches!(end.kind, EndKind::Fixed | EndKind::Anchor)
}

/// Unstretched length \[m\].
fn length(scene: &Scene) -> f64 {
    scene.line.arc.last().copied().unwrap_or(0.0)
}
