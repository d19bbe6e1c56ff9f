//! The system at rest: Newton's method on free points and bodies.
//!
//! A line that bears no compression, its weight, a level bed below and a surface above have together a potential energy
//! that is convex in the places of the line; with the line at rest it is convex in its ends. With the bodies held, a system has
//! therefore one state of least energy (or a connected set of them, all with the same tensions), and a descent from any start
//! finds it. Friction of the bed, current and wind have no energy: they act in a second search, from the result of the first, as do bending and a bed
//! that is not level, over which the lines of the first search have level beds of their own. Free bodies turn, which is
//! not convex: the search ends at the equilibrium that it comes to first.
//!
//! A step goes along `K d = F`, with a share of the unit matrix added where K is not positive definite, no further than a
//! bound that grows and shrinks with its success. Along d the energy falls as long as `F . d > 0`, by which the length of the step is found: no
//! energy is computed, whose rounding would hide the last digits.

mod relaxation;
mod step;
mod work;

use nalgebra::DVector;

use super::along_bed::{OnSlope, force_along, on_slope};
use super::balance::{Balance, UnsolvedLine, balance};
use super::bed::Bed;
use super::bounds::{Bounds, Contact};
use super::clamps;
use super::freedoms::{Freedoms, Placement, UnknownBodies};
use super::line_physics::LinePhysics;
use super::network::{Body, Held, Line, Network};

/// A system at rest.
#[derive(Debug, Clone)]
pub struct SystemEquilibrium {
    /// Where everything is.
    pub placement: Placement,
    /// The unknowns.
    pub freedoms: Freedoms,
    /// Forces, stiffness, lines.
    pub balance: Balance,
    /// What bears on each unknown.
    pub contacts: Vec<Contact>,
    /// Greatest force out of balance \[N\], moments by the size of the bodies.
    pub residual: f64,
    /// Newton steps and evaluations of all lines.
    pub steps: usize,
    /// See `steps`.
    pub evaluations: usize,
    /// Newton iterations of the divided lines, each by its segments.
    pub work: u64,
    /// The unstable one that the search came to first, and left.
    pub left: Option<Box<SystemEquilibrium>>,
}

impl SystemEquilibrium {
    /// What bears on a free point; nothing on one that is held.
    #[must_use]
    pub fn contact(&self, point: usize) -> Contact {
        let first = self.freedoms.points[point];
        first.map_or(Contact::None, |first| self.contacts[first + 2])
    }
}

/// Why there is no equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub enum SystemError {
    /// A line has no solution where the search stands.
    Line(UnsolvedLine),
    /// A divided line took more work than a search is given.
    TooMuchWork {
        /// Which line.
        line: usize,
        /// Newton iterations by its segments.
        work: u64,
        /// Steps taken.
        steps: usize,
    },
    /// The search did not come to rest.
    NotConverged {
        /// Force out of balance \[N\].
        residual: f64,
        /// On what: `z of buoy`.
        at: String,
        /// Steps taken.
        steps: usize,
    },
}

/// Steps that a search may take.
const MOST_STEPS: usize = 400;
/// Forces out of balance that are rounding, by the greatest tension.
const ROUNDING: f64 = 1e-13;
/// Forces that are none, in a system that carries nothing \[N\].
const NOTHING: f64 = 1e-100;
/// Residual that is accepted where it no longer falls, by the greatest tension.
const ACCEPTED: f64 = 1e-9;
/// How often divided lines are laid on the bed anew, and what that may leave out of balance, by the greatest tension.
const MOST_LAYS: usize = 12;
const LAID: f64 = 1e-8;
/// Units in the last place of the positions, times stiffness, that are accepted as well.
const LAST_PLACES: f64 = 8.0;

/// Finds the equilibrium from a placement.
///
/// # Errors
/// [`SystemError`].
pub fn search(network: &Network, start: &Placement) -> Result<SystemEquilibrium, SystemError> {
    found(network, start, MOST_STEPS, true)
}

/// The same within so many steps, for searches that need not succeed.
///
/// # Errors
/// [`SystemError`].
pub fn search_within(
    network: &Network,
    start: &Placement,
    most_steps: usize,
) -> Result<SystemEquilibrium, SystemError> {
    found(network, start, most_steps, false)
}

/// The equilibrium from a placement; `relaxed`: where Newton's method does not come to it, by pseudo-transient continuation.
fn found(
    network: &Network,
    start: &Placement,
    most_steps: usize,
    relaxed: bool,
) -> Result<SystemEquilibrium, SystemError> {
    let freedoms = Freedoms::of_network(network, UnknownBodies::Free);
    let mut search =
        SystemEquilibriumSearch::begin(network, freedoms, start.clone(), LinePhysics::Plain)?;
    let ended = search.run_from_level(most_steps, relaxed);
    search.result(ended)
}

/// Finds the equilibrium near a placement that is one but for small changes, with all physics from the start.
///
/// # Errors
/// [`SystemError`].
pub fn search_near(network: &Network, near: &Placement) -> Result<SystemEquilibrium, SystemError> {
    let freedoms = Freedoms::of_network(network, UnknownBodies::Free);
    let mut search =
        SystemEquilibriumSearch::begin(network, freedoms, near.clone(), LinePhysics::Full)?;
    let ended = search.run_in_full(MOST_STEPS, true);
    search.result(ended)
}

/// Finds the equilibrium that forces with all physics lead to from a placement beside an unstable one, which Newton's method would go back to.
///
/// # Errors
/// [`SystemError`].
pub fn search_downhill(
    network: &Network,
    from: &Placement,
) -> Result<SystemEquilibrium, SystemError> {
    let freedoms = Freedoms::of_network(network, UnknownBodies::Free);
    let mut search =
        SystemEquilibriumSearch::begin(network, freedoms, from.clone(), LinePhysics::Full)?;
    let relaxed = search.relax(MOST_STEPS);
    let ended = relaxed.and_then(|()| search.run_in_full(MOST_STEPS, true));
    search.result(ended)
}

/// A search under way.
struct SystemEquilibriumSearch<'a> {
    network: &'a Network,
    freedoms: Freedoms,
    bounds: Bounds,
    /// Size of the bodies by unknown: turns count by the way they move a fairlead \[m\].
    lever: DVector<f64>,
    physics: LinePhysics,
    placement: Placement,
    here: Balance,
    /// What bears on each unknown where the step begins.
    contacts: Vec<Contact>,
    /// Force that those of bodies are held against beside the tensions \[N\]: see [`weight_of_bodies`].
    weight: f64,
    /// Greatest step \[m\].
    reach: f64,
    steps: usize,
    evaluations: std::cell::Cell<usize>,
    /// Newton iterations of each divided line, by its segments.
    work: std::cell::RefCell<Vec<u64>>,
}

impl<'a> SystemEquilibriumSearch<'a> {
    fn begin(
        network: &'a Network,
        freedoms: Freedoms,
        mut placement: Placement,
        physics: LinePhysics,
    ) -> Result<Self, SystemError> {
        let bounds = Bounds::of_network(network, &freedoms);
        placement.carry(network);
        bounds.keep(network, &freedoms, &mut placement);
        let here =
            balance(network, &freedoms, &placement, physics, None).map_err(SystemError::Line)?;
        let longest = network.lines.iter().map(Line::length);
        let longest = longest.chain(network.bodies.iter().filter_map(size_of_pinned));
        let longest = longest.chain(ways_without_lines(network));
        Ok(Self {
            network,
            lever: levers(network, &freedoms),
            weight: weight_of_bodies(network),
            bounds,
            physics,
            placement,
            here,
            contacts: Vec::new(),
            reach: 0.3 * longest.fold(1e-3, f64::max),
            steps: 0,
            evaluations: std::cell::Cell::new(1),
            work: std::cell::RefCell::new(vec![0; network.lines.len()]),
            freedoms,
        })
    }

    fn evaluate(&self, placement: &Placement) -> Result<Balance, SystemError> {
        if let Some(error) = self.too_much_work() {
            return Err(error);
        }
        self.evaluations.set(self.evaluations.get() + 1);
        let (network, freedoms) = (self.network, &self.freedoms);
        let near = Some(self.here.lines.as_slice());
        let evaluated = balance(network, freedoms, placement, self.physics, near);
        self.count_work(&evaluated);
        evaluated.map_err(SystemError::Line)
    }

    /// Steps by closed forms over level beds, then with all physics, where there is more.
    ///
    /// What is clamped may be held by bending alone, and have no equilibrium without: the search goes on from where that without ends or, if
    /// that leads nowhere, from where it began.
    fn run_from_level(&mut self, most_steps: usize, relaxed: bool) -> Result<(), SystemError> {
        let lines = &self.network.lines;
        let bed = self.network.bed.as_ref();
        let clamped = clamps::any_on_what_turns(self.network);
        let began = clamped.then(|| self.placement.clone());
        let rough = lines.iter().any(Line::is_rough) && bed.is_some();
        let discretised = lines.iter().any(|line| line.discretised.is_some());
        let near = self.run(most_steps);
        // Closed forms over level beds lead near the equilibrium over another one, and need not end anywhere.
        let level = bed.is_none_or(Bed::is_level);
        if level && !clamped {
            near?;
        }
        if rough || !level || discretised || self.network.flows() {
            self.physics = LinePhysics::Full;
            let found = self.run_in_full_from_here(most_steps, relaxed);
            match began.filter(|_| found.is_err()) {
                Some(began) => {
                    self.placement = began;
                    self.run_in_full_from_here(most_steps, relaxed)?;
                }
                None => found?,
            }
        }
        Ok(())
    }

    fn run_in_full_from_here(
        &mut self,
        most_steps: usize,
        relaxed: bool,
    ) -> Result<(), SystemError> {
        self.here = self.evaluate(&self.placement)?;
        self.run_in_full(most_steps, relaxed)
    }

    /// Steps until the forces balance.
    fn run(&mut self, most_steps: usize) -> Result<(), SystemError> {
        let mut best = f64::INFINITY;
        let mut idle = 0;
        for _ in 0..most_steps {
            let force = self.unbalanced(&self.here, &self.placement);
            let residual = self.size(&force);
            if residual <= ROUNDING * self.force_scale() || residual <= NOTHING {
                return Ok(());
            }
            idle = if residual < 0.5 * best { 0 } else { idle + 1 };
            best = best.min(residual);
            if idle > 2 && residual <= self.accepted() {
                return Ok(());
            }
            if !self.step(&force)? {
                break;
            }
            self.steps += 1;
        }
        let force = self.unbalanced(&self.here, &self.placement);
        if self.size(&force) <= self.accepted() {
            return Ok(());
        }
        Err(self.not_converged(&force))
    }

    /// Steps with all physics until the forces balance, with divided lines on a rough bed laid where they come to rest.
    fn run_in_full(&mut self, most_steps: usize, relaxed: bool) -> Result<(), SystemError> {
        match self.run(most_steps) {
            Err(_) if relaxed => self.relax(most_steps)?,
            ended => ended?,
        }
        let lines = &self.network.lines;
        let rough = lines.iter().any(Line::is_rough) && self.network.bed.is_some();
        if rough && lines.iter().any(|line| line.discretised.is_some()) {
            self.lay_again(most_steps, relaxed)?;
        }
        Ok(())
    }

    /// Lays the divided lines on the bed anew where the system has come to rest, and steps until the forces balance, again and again until
    /// laying them changes nothing: friction then opposes the way from where they were laid to their places in the equilibrium.
    fn lay_again(&mut self, most_steps: usize, relaxed: bool) -> Result<(), SystemError> {
        if self.freedoms.count == 0 {
            return Ok(());
        }
        for _ in 0..MOST_LAYS {
            let lines = self.here.lines.iter_mut();
            for line in lines.filter_map(|line| line.discretised.as_mut()) {
                line.lay();
            }
            self.here = self.evaluate(&self.placement)?;
            let left = self.size(&self.unbalanced(&self.here, &self.placement));
            match self.run(most_steps) {
                Err(_) if relaxed => self.relax(most_steps)?,
                ended => ended?,
            }
            if left <= LAID * self.force_scale() {
                break;
            }
        }
        Ok(())
    }

    fn not_converged(&self, force: &DVector<f64>) -> SystemError {
        let scaled = force.component_div(&self.lever);
        SystemError::NotConverged {
            residual: self.size(force),
            at: self.freedoms.name(self.network, scaled.iamax()),
            steps: self.steps,
        }
    }

    /// The typical force: the greatest tension, or the weight of a body.
    fn force_scale(&self) -> f64 {
        self.here.tension.max(self.weight)
    }

    /// Residual that may remain: a share of the tension, or what the rounding of the places makes of the stiffness.
    fn accepted(&self) -> f64 {
        let places = self.placement.points.iter().map(nalgebra::Matrix::amax);
        let size = places.fold(0.0, f64::max);
        let stiffest = self.here.stiffness.diagonal().component_div(&self.lever);
        let stiffest = stiffest.component_div(&self.lever).amax();
        let rounding = LAST_PLACES * f64::EPSILON * size * stiffest;
        // Discretised lines balance no better than their own nodes do.
        let own = self
            .here
            .lines
            .iter()
            .filter_map(|line| line.discretised.as_ref());
        let own: f64 = own.map(|line| line.found.residual_n).sum();
        (ACCEPTED * self.force_scale()).max(rounding).max(2.0 * own)
    }

    /// What lies on a bed that slopes.
    fn on_slope(&self, placement: &Placement, contacts: &[Contact]) -> Vec<OnSlope> {
        let bed = self.network.bed.as_ref();
        on_slope(bed, (&self.freedoms, placement), contacts)
    }

    fn size(&self, force: &DVector<f64>) -> f64 {
        force.component_div(&self.lever).amax()
    }

    /// The forces that bed and surface do not bear.
    fn unbalanced(&self, balance: &Balance, placement: &Placement) -> DVector<f64> {
        let contacts = self
            .bounds
            .contacts(&self.freedoms, placement, &balance.force);
        let mut force = balance.force.clone();
        force_along(&self.on_slope(placement, &contacts), &mut force);
        for (unknown, contact) in contacts.iter().enumerate() {
            if *contact != Contact::None {
                force[unknown] = 0.0;
            }
        }
        force
    }

    /// The equilibrium of a search that has ended; none where a line has only another in its place.
    fn result(self, ended: Result<(), SystemError>) -> Result<SystemEquilibrium, SystemError> {
        ended.map_err(|error| self.too_much_work().unwrap_or(error))?;
        let mut lines = self.here.lines.iter().enumerate();
        match lines.find_map(|(line, at_rest)| Some((line, at_rest.replaced.as_ref()?))) {
            Some((line, why)) => Err(SystemError::Line(UnsolvedLine {
                line,
                why: why.to_string(),
                iterations: 0,
            })),
            None => Ok(self.finish()),
        }
    }

    fn finish(self) -> SystemEquilibrium {
        let force = self.unbalanced(&self.here, &self.placement);
        let residual = self.size(&force);
        let contacts = self
            .bounds
            .contacts(&self.freedoms, &self.placement, &self.here.force);
        SystemEquilibrium {
            residual,
            contacts,
            steps: self.steps,
            evaluations: self.evaluations.get(),
            work: self.work.borrow().iter().sum(),
            left: None,
            placement: self.placement,
            freedoms: self.freedoms,
            balance: self.here,
        }
    }
}

/// Size of a body that is pinned, which turns under its own weight \[m\]; nothing of others, which lines hold.
fn size_of_pinned(body: &Body) -> Option<f64> {
    body.pinned.then(|| body.size())
}

/// How far bodies may go where no line gives a measure \[m\]: by their size, and to the surface.
fn ways_without_lines(network: &Network) -> impl Iterator<Item = f64> {
    let alone = network.lines.is_empty();
    let bodies = network.bodies.iter().filter(move |_| alone);
    bodies.map(|body| body.size().max(body.pose.origin.z.abs()))
}

/// Greatest weight or buoyancy of a body that is in balance by itself \[N\]: one that is pinned, or any where there are no lines.
pub(super) fn weight_of_bodies(network: &Network) -> f64 {
    let alone = network.lines.is_empty();
    let bodies = network.bodies.iter().filter(|body| body.pinned || alone);
    let greatest = bodies.map(|body| body.weight.max(body.buoyancy));
    greatest.fold(0.0, f64::max)
}

/// 1 for steps; for turns the greatest arm of a point on the body \[m\].
pub(super) fn levers(network: &Network, freedoms: &Freedoms) -> DVector<f64> {
    let mut arms = vec![0.0_f64; network.bodies.len()];
    for point in &network.points {
        if let Held::On(body, at) = &point.held {
            arms[*body] = arms[*body].max(at.norm());
        }
    }
    for (arm, body) in arms.iter_mut().zip(&network.bodies) {
        *arm = arm.max(size_of_pinned(body).unwrap_or(0.0));
        // Of a body that nothing is on, that of its centres and members.
        if *arm == 0.0 {
            *arm = body.size();
        }
    }
    let mut levers = DVector::from_element(freedoms.count, 1.0);
    for (first, arm) in freedoms.bodies.iter().zip(arms) {
        if let Some(first) = first.filter(|_| arm > 0.0) {
            levers.rows_mut(first + 3, 3).fill(arm);
        }
    }
    levers
}
