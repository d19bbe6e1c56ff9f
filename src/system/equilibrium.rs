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

use nalgebra::DVector;

use super::along_bed::{OnSlope, force_along, on_slope, stiffness_along};
use super::balance::{Balance, UnsolvedLine, balance};
use super::bed::Bed;
use super::bounds::{Bounds, Contact};
use super::freedoms::{Freedoms, Placement, UnknownBodies};
use super::line_at_rest::LinePhysics;
use super::network::{Body, Held, Network};
use crate::numerics::envelope::{EnvelopeCholesky, EnvelopeMatrix};

/// A system at rest.
#[derive(Debug, Clone)]
pub struct Equilibrium {
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
    /// The unstable one that the search came to first, and left.
    pub left: Option<Box<Equilibrium>>,
}

impl Equilibrium {
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

/// Halvings of a Newton step before another way is tried.
const HALVINGS: usize = 8;
/// Steps that a search may take.
const MOST_STEPS: usize = 400;
/// Newton iterations of a divided line, by its segments, that a search may take: seconds. Without an equilibrium near by, a line takes
/// thousands of iterations for every place that its ends are tried at.
const MOST_WORK: u64 = 15_000_000;
/// Stiffness that holds the unknowns back where they are relaxed, by the greatest of the system: at first and at most.
const HELD_BACK: f64 = 1e-2;
const MOST_HELD_BACK: f64 = 1e6;
/// By how much a relaxed step may leave more out of balance than there was.
const WORSE: f64 = 2.0;
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
pub fn search(network: &Network, start: &Placement) -> Result<Equilibrium, SystemError> {
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
) -> Result<Equilibrium, SystemError> {
    found(network, start, most_steps, false)
}

/// The equilibrium from a placement; `relaxed`: where Newton's method does not come to it, by pseudo-transient continuation.
fn found(
    network: &Network,
    start: &Placement,
    most_steps: usize,
    relaxed: bool,
) -> Result<Equilibrium, SystemError> {
    let freedoms = Freedoms::of(network, UnknownBodies::Free);
    let mut search = Search::begin(network, freedoms, start.clone(), LinePhysics::Plain)?;
    search
        .run_from_level(most_steps, relaxed)
        .map_err(|error| search.too_much_work().unwrap_or(error))?;
    search.result()
}

/// Finds the equilibrium near a placement that is one but for small changes, with all physics from the start.
///
/// # Errors
/// [`SystemError`].
pub fn search_near(network: &Network, near: &Placement) -> Result<Equilibrium, SystemError> {
    let freedoms = Freedoms::of(network, UnknownBodies::Free);
    let mut search = Search::begin(network, freedoms, near.clone(), LinePhysics::Full)?;
    search
        .run_in_full(MOST_STEPS, true)
        .map_err(|error| search.too_much_work().unwrap_or(error))?;
    search.result()
}

/// Finds the equilibrium that forces with all physics lead to from a placement beside an unstable one, which Newton's method would go back to.
///
/// # Errors
/// [`SystemError`].
pub fn search_downhill(network: &Network, from: &Placement) -> Result<Equilibrium, SystemError> {
    let freedoms = Freedoms::of(network, UnknownBodies::Free);
    let mut search = Search::begin(network, freedoms, from.clone(), LinePhysics::Full)?;
    search
        .relax(MOST_STEPS)
        .and_then(|()| search.run_in_full(MOST_STEPS, true))
        .map_err(|error| search.too_much_work().unwrap_or(error))?;
    search.result()
}

/// A search under way.
struct Search<'a> {
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

/// A direction and what it does.
struct Direction {
    step: DVector<f64>,
    /// Force along it \[N m\].
    slope: f64,
}

impl<'a> Search<'a> {
    fn begin(
        network: &'a Network,
        freedoms: Freedoms,
        mut placement: Placement,
        physics: LinePhysics,
    ) -> Result<Self, SystemError> {
        let bounds = Bounds::of(network, &freedoms);
        placement.carry(network);
        bounds.keep(network, &freedoms, &mut placement);
        let here =
            balance(network, &freedoms, &placement, physics, None).map_err(SystemError::Line)?;
        let longest = network.lines.iter().map(super::network::Line::length);
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
    fn run_from_level(&mut self, most_steps: usize, relaxed: bool) -> Result<(), SystemError> {
        let lines = &self.network.lines;
        let bed = self.network.bed.as_ref();
        let rough = lines.iter().any(|line| line.friction > 0.0) && bed.is_some();
        let discretised = lines.iter().any(|line| line.discretised.is_some());
        let near = self.run(most_steps);
        // Closed forms over level beds lead near the equilibrium over another one, and need not end anywhere.
        let level = bed.is_none_or(Bed::is_level);
        if level {
            near?;
        }
        if rough || !level || discretised || self.network.flows() {
            self.physics = LinePhysics::Full;
            self.here = self.evaluate(&self.placement)?;
            self.run_in_full(most_steps, relaxed)?;
        }
        Ok(())
    }

    /// The line that took more work than the search is given, if one has.
    fn too_much_work(&self) -> Option<SystemError> {
        let work = self.work.borrow();
        let line = work.iter().position(|work| *work > MOST_WORK)?;
        Some(SystemError::TooMuchWork {
            line,
            work: work[line],
            steps: self.steps,
        })
    }

    /// Counts the work of the divided lines of an evaluation.
    fn count_work(&self, evaluated: &Result<Balance, UnsolvedLine>) {
        let segments = |line: usize| {
            let divided = self.network.lines[line].discretised.as_ref();
            divided.map_or(0, |divided| divided.segments() as u64)
        };
        let mut work = self.work.borrow_mut();
        match evaluated {
            Ok(balance) => {
                for (index, line) in balance.lines.iter().enumerate() {
                    let divided = line.discretised.as_ref();
                    let iterations = divided.map_or(0, |divided| divided.found.iterations);
                    work[index] += iterations * segments(index);
                }
            }
            Err(UnsolvedLine {
                line, iterations, ..
            }) => work[*line] += iterations * segments(*line),
        }
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

    /// Pseudo-transient continuation (Kelley and Keyes 1998, doi 10.1137/S0036142996304796): steps `(K + m) d = F` of a system whose unknowns are
    /// held back by m, which grows where a step leaves more out of balance than there was and falls with the forces out of balance. Newton's method
    /// with a search along the step ends where the forces have a kink, at a node that touches down or a segment that slackens.
    fn relax(&mut self, most_steps: usize) -> Result<(), SystemError> {
        let stiffest = self.here.stiffness.diagonal().component_div(&self.lever);
        let stiffest = stiffest.component_div(&self.lever).amax();
        let (mut held_back, most) = (HELD_BACK * stiffest, MOST_HELD_BACK * stiffest);
        for _ in 0..most_steps {
            let force = self.unbalanced(&self.here, &self.placement);
            if self.size(&force) <= self.accepted() {
                return self.run(most_steps);
            }
            if held_back > most {
                break;
            }
            self.steps += 1;
            let before = force.component_div(&self.lever).norm();
            let after = self.relaxed_step(&force, held_back);
            held_back *= match after {
                Some((place, balance, after)) if after <= WORSE * before => {
                    (self.placement, self.here) = (place, balance);
                    (after / before).clamp(0.1, 1.0)
                }
                _ => 10.0,
            };
        }
        let force = self.unbalanced(&self.here, &self.placement);
        Err(self.not_converged(&force))
    }

    /// Where a step of [`Self::relax`] leads, and what is out of balance there \[N\].
    fn relaxed_step(
        &mut self,
        force: &DVector<f64>,
        held_back: f64,
    ) -> Option<(Placement, Balance, f64)> {
        self.contacts = self
            .bounds
            .contacts(&self.freedoms, &self.placement, &self.here.force);
        let contacts = self.contacts.iter();
        let held: Vec<bool> = contacts.map(|on| *on != Contact::None).collect();
        let mut stiffness = self.stiffness(&held);
        for (unknown, lever) in self.lever.iter().enumerate() {
            stiffness.add(unknown, unknown, held_back * lever * lever);
        }
        let step = solved(&stiffness, force)?;
        let far = step.component_mul(&self.lever).amax();
        let share = (self.reach / far).min(1.0);
        let (place, _, balance) = self.probe(&step, share).ok()?;
        let after = self.unbalanced(&balance, &place);
        let after = after.component_div(&self.lever).norm();
        (place != self.placement).then_some((place, balance, after))
    }

    /// Steps with all physics until the forces balance, with divided lines on a rough bed laid where they come to rest.
    fn run_in_full(&mut self, most_steps: usize, relaxed: bool) -> Result<(), SystemError> {
        match self.run(most_steps) {
            Err(_) if relaxed => self.relax(most_steps)?,
            ended => ended?,
        }
        let lines = &self.network.lines;
        let rough = lines.iter().any(|line| line.friction > 0.0) && self.network.bed.is_some();
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

    /// One step; whether anything moved.
    fn step(&mut self, force: &DVector<f64>) -> Result<bool, SystemError> {
        self.contacts = self
            .bounds
            .contacts(&self.freedoms, &self.placement, &self.here.force);
        let held: Vec<bool> = self
            .contacts
            .iter()
            .map(|contact| *contact != Contact::None)
            .collect();
        if self.physics == LinePhysics::Full && self.newton_step(force, &held) {
            return Ok(true);
        }
        let mut direction = self.direction(force, &held);
        let far = direction.step.component_mul(&self.lever).amax();
        let clipped = far > self.reach;
        if clipped {
            direction.step *= self.reach / far;
            direction.slope *= self.reach / far;
        }
        self.move_along(&direction, clipped)
    }

    /// Newton's step for forces without energy, halved until less is out of balance; whether one was taken. A ship turns into
    /// the wind along a way that the energy of its lines does not fall on.
    fn newton_step(&mut self, force: &DVector<f64>, held: &[bool]) -> bool {
        let stiffness = self.stiffness(held);
        let newton = is_oblique(&stiffness).then(|| solved(&stiffness, force));
        let newton = newton.flatten();
        let Some(step) = newton.filter(|step| step.iter().all(|part| part.is_finite())) else {
            return false;
        };
        let far = step.component_mul(&self.lever).amax();
        let mut share = (self.reach / far).min(1.0);
        let before = force.component_div(&self.lever).norm();
        for _ in 0..HALVINGS {
            if let Ok((place, _, balance)) = self.probe(&step, share) {
                let after = self.unbalanced(&balance, &place);
                let after = after.component_div(&self.lever).norm();
                if after < (1.0 - 0.1 * share) * before && place != self.placement {
                    (self.placement, self.here) = (place, balance);
                    return true;
                }
            }
            share *= 0.5;
        }
        false
    }

    /// The stiffness with the unknowns that are held standing for themselves.
    fn stiffness(&self, held: &[bool]) -> EnvelopeMatrix {
        let mut stiffness = self.here.stiffness.clone();
        let lying = self.on_slope(&self.placement, &self.contacts);
        let bed = self.network.bed.as_ref();
        stiffness_along(bed, &lying, &self.here.force, &mut stiffness);
        stiffness.hold(held, 1.0);
        stiffness
    }

    /// Newton's direction, or the nearest one in which the energy falls.
    fn direction(&self, force: &DVector<f64>, held: &[bool]) -> Direction {
        let stiffness = self.stiffness(held);
        let most = stiffness.diagonal().component_div(&self.lever);
        let most = most
            .component_div(&self.lever)
            .amax()
            .max(1e-9 * self.force_scale());
        // Friction, and moments out of balance, make it oblique.
        let oblique = is_oblique(&stiffness);
        let mut added = 0.0;
        for _ in 0..40 {
            let diagonal = self.lever.component_mul(&self.lever) * added;
            if let Some(factors) = EnvelopeCholesky::new(&stiffness, &diagonal) {
                let plain = factors.solve(force);
                let newton = (added == 0.0 && oblique)
                    .then(|| solved(&stiffness, force))
                    .flatten();
                let downhill =
                    |step: &DVector<f64>| force.dot(step) > 0.0 && step.amax().is_finite();
                if let Some(step) = newton.filter(downhill) {
                    let slope = force.dot(&step);
                    return Direction { step, slope };
                }
                // What was barely made positive definite leads far along the one direction that it was not in.
                let far = plain.component_mul(&self.lever).amax();
                let within = added == 0.0 || far <= 2.0 * self.reach;
                if within && downhill(&plain) {
                    let slope = force.dot(&plain);
                    return Direction { step: plain, slope };
                }
            }
            added = if added == 0.0 {
                1e-12 * most
            } else {
                10.0 * added
            };
        }
        let step = force.component_div(&self.lever).component_div(&self.lever);
        let slope = force.dot(&step);
        Direction { step, slope }
    }

    /// Moves along a direction as far as the forces still point along it.
    fn move_along(&mut self, direction: &Direction, clipped: bool) -> Result<bool, SystemError> {
        let (mut low, mut high) = (0.0_f64, f64::INFINITY);
        let mut slopes = (direction.slope, f64::NAN);
        let mut share = 1.0_f64;
        let mut reached: Option<(f64, Placement, Balance)> = None;
        let mut failure = None;
        for _ in 0..60 {
            let (place, slope, balance) = match self.probe(&direction.step, share) {
                Ok(found) => found,
                Err(error) => {
                    failure = Some(error);
                    (high, slopes.1) = (share, f64::NAN);
                    share = 0.5 * (low + share);
                    continue;
                }
            };
            let enough = slope.abs() <= 0.5 * direction.slope;
            let undershot = slope > 0.5 * direction.slope;
            if !undershot {
                (high, slopes.1) = (share, slope);
            } else {
                (low, slopes.0) = (share, slope);
            }
            if slope >= -0.5 * direction.slope {
                reached = Some((share, place, balance));
            }
            let may_grow = clipped && undershot && high.is_infinite() && share < 64.0;
            if enough || (undershot && high.is_infinite() && !may_grow) || high - low < 1e-12 * high
            {
                break;
            }
            share = next_share((low, slopes.0), (high, slopes.1));
        }
        let Some((share, place, balance)) = reached else {
            return failure.map_or(Ok(false), Err);
        };
        if clipped {
            self.reach *= share.max(0.25);
        } else {
            let far = direction.step.component_mul(&self.lever).amax() * share;
            self.reach = self.reach.max(2.0 * far);
        }
        let moved = place != self.placement;
        (self.placement, self.here) = (place, balance);
        Ok(moved)
    }

    /// The system a share of a step further, and the force along the step there; unknowns that came to a bound count no more.
    fn probe(
        &self,
        step: &DVector<f64>,
        share: f64,
    ) -> Result<(Placement, f64, Balance), SystemError> {
        let mut place = self
            .placement
            .moved(self.network, &self.freedoms, &(step * share));
        self.bounds
            .follow_bed(&self.freedoms, &self.contacts, &mut place);
        self.bounds.keep(self.network, &self.freedoms, &mut place);
        let balance = self.evaluate(&place)?;
        let force = self.unbalanced(&balance, &place);
        let slope = force.dot(step);
        if !slope.is_finite() {
            return Err(SystemError::NotConverged {
                residual: f64::NAN,
                at: String::new(),
                steps: self.steps,
            });
        }
        Ok((place, slope, balance))
    }

    /// The equilibrium; none where a line has only another in its place.
    fn result(self) -> Result<Equilibrium, SystemError> {
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

    fn finish(self) -> Equilibrium {
        let force = self.unbalanced(&self.here, &self.placement);
        let residual = self.size(&force);
        let contacts = self
            .bounds
            .contacts(&self.freedoms, &self.placement, &self.here.force);
        Equilibrium {
            residual,
            contacts,
            steps: self.steps,
            evaluations: self.evaluations.get(),
            left: None,
            placement: self.placement,
            freedoms: self.freedoms,
            balance: self.here,
        }
    }
}

/// Where to look next between two shares of a step: the secant, kept off both ends; twice as far where there is no upper one.
fn next_share((low, at_low): (f64, f64), (high, at_high): (f64, f64)) -> f64 {
    if high.is_infinite() {
        return 2.0 * low;
    }
    let width = high - low;
    let secant = low + width * at_low / (at_low - at_high);
    if secant.is_finite() {
        secant.clamp(low + 0.1 * width, high - 0.1 * width)
    } else {
        low + 0.5 * width
    }
}

/// Whether a stiffness is not symmetric by more than rounding.
fn is_oblique(stiffness: &EnvelopeMatrix) -> bool {
    stiffness.asymmetry() > 1e-9
}

fn solved(stiffness: &EnvelopeMatrix, force: &DVector<f64>) -> Option<DVector<f64>> {
    stiffness.solve(std::slice::from_ref(force))?.pop()
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
