//! Lines of several sections: which of them rest on the bed, and the shape that follows.
//!
//! The grounded runs are found as an active set: solve, ground the run of sinking sections around the deepest point under
//! the bed, release the runs that the bed would have to pull down, and repeat. A sinking run curves upwards everywhere, so
//! it is grounded in one piece. A pattern that does not converge is an error.

use super::composite_line::{CompositeLine, ContactPattern};
use super::composite_touchdown;
use super::convex_newton::{BayUnknowns, minimise, offset_for_rise};
use super::elements::{Bay, ElementRange};
use super::error::CatenaryError;
use super::line::{CatenaryLine, RigidBed};
use super::local_frame::in_local_frame;
use super::planar_line::ON_BED;
use super::solution::Solution;

/// Solves a line of any number of sections.
pub(super) fn solve(line: &CatenaryLine<'_>) -> Result<Solution, CatenaryError> {
    let problem = in_local_frame(line)?;
    if let Some(bed) = line.bed.filter(|bed| bed.slope_rad != 0.0) {
        return over_slope(&problem, bed);
    }
    let pattern = problem.contact_pattern()?;
    if let Some(bed) = line.bed.filter(|bed| bed.friction > 0.0)
        && !pattern.slack
        && problem.grounded_length(&pattern) > 0.0
    {
        return over_rough_bed(&problem, bed);
    }
    let solution = problem.finish(&pattern)?;
    if let (Some(_), Some(above)) = (line.bed, line.surface_above_a_m)
        && problem.highest(&solution) > above * (1.0 + 1e-9) + 1e-9
    {
        return Err(CatenaryError::UnsupportedContact(
            "a line of several sections comes up to the surface while there is a bed as well; one of the two is solved",
        ));
    }
    Ok(solution)
}

/// On a level bed with friction: as laid from A.
fn over_rough_bed(problem: &CompositeLine, bed: RigidBed) -> Result<Solution, CatenaryError> {
    if bed.below_a_m > ON_BED * problem.chain.length {
        return Err(CatenaryError::FrictionUndetermined);
    }
    composite_touchdown::solve(problem, bed)?.ok_or(composite_touchdown::SEVERAL_TOUCHDOWNS)
}

/// Over a sloping bed: grounded from A, or clear of it.
fn over_slope(problem: &CompositeLine, bed: RigidBed) -> Result<Solution, CatenaryError> {
    let slip = ON_BED * (problem.chain.length + problem.z.abs());
    if bed.below_a_m <= slip
        && let Some(lies) = composite_touchdown::solve(problem, bed)?
    {
        return Ok(lies);
    }
    let pattern = problem.contact_pattern()?;
    let clear = pattern
        .bays
        .iter()
        .zip(&pattern.state.offsets)
        .all(|(bay, offset)| {
            let parts = problem.chain.parts(bay, *offset);
            let tan = bed.slope_rad.tan();
            !composite_touchdown::passes_below_bed(
                problem,
                parts,
                pattern.state.h,
                bed.below_a_m,
                tan,
            )
        });
    if clear {
        return problem.finish(&pattern);
    }
    Err(if bed.below_a_m <= slip {
        composite_touchdown::SEVERAL_TOUCHDOWNS
    } else {
        CatenaryError::SlopeBelowA
    })
}

impl CompositeLine {
    /// The bays between grounded runs.
    fn bays(&self, grounded: &[ElementRange]) -> Vec<Bay> {
        let depth = self.bed.unwrap_or(0.0);
        let n = grounded.len();
        let mut bays = Vec::with_capacity(n + 1);
        for k in 0..=n {
            let from = (k > 0).then(|| grounded[k - 1]);
            let onto = (k < n).then(|| grounded[k]);
            let down = if from.is_none() { depth } else { 0.0 };
            let rise = match (from, onto) {
                (None, None) => self.z,
                (_, Some(_)) => -down,
                (Some(_), None) => depth + self.z,
            };
            // An end that lies on the bed itself begins no bay.
            let lies = rise == 0.0
                && match (from, onto) {
                    (None, Some((first, _))) => first == 0,
                    (Some((_, last)), None) => last == self.last(),
                    _ => false,
                };
            if !lies {
                bays.push(Bay {
                    over: (
                        from.map_or(0, |run| run.0),
                        onto.map_or(self.last(), |run| run.1),
                    ),
                    from,
                    onto,
                    rise,
                });
            }
        }
        bays
    }

    /// Finds the grounded runs.
    fn contact_pattern(&self) -> Result<ContactPattern, CatenaryError> {
        let mut grounded = Vec::new();
        let (h, offset) = self.guess();
        if self.bed == Some(0.0) && self.chain.elements[0].total() > 0.0 {
            grounded.push(self.run(0));
        }
        let bays = self.bays(&grounded);
        let mut state = BayUnknowns {
            h,
            offsets: vec![offset; bays.len()],
        };
        let mut evaluations = 0;
        for _ in 0..4 * self.chain.elements.len() + 8 {
            let pattern = self.equilibrium(grounded.clone(), state, &mut evaluations)?;
            if let Some(released) = self.held_down(&pattern) {
                (grounded, state) = without(&pattern, released);
                continue;
            }
            let Some((at, offset, bay)) = self.deepest(&pattern) else {
                return Ok(pattern);
            };
            let run = self.run(at);
            if pattern.grounded.contains(&run) {
                break;
            }
            (grounded, state) = with(&pattern, run, bay, offset);
            // Bays of ends that now lie on the bed fall away.
            let bays = self.bays(&grounded).len();
            if state.offsets.len() > bays && self.z + self.bed.unwrap_or(0.0) == 0.0 {
                state.offsets.truncate(bays);
            }
            state.offsets.resize(bays, offset);
        }
        Err(CatenaryError::UnsupportedContact(
            "which sections rest on the bed could not be settled for this line",
        ))
    }

    /// Equilibrium for given grounded runs.
    fn equilibrium(
        &self,
        grounded: Vec<ElementRange>,
        start: BayUnknowns,
        evaluations: &mut u32,
    ) -> Result<ContactPattern, CatenaryError> {
        let bays = self.bays(&grounded);
        if let Some(state) = self.slack(&grounded, &bays, &start) {
            return Ok(ContactPattern {
                grounded,
                bays,
                state,
                slack: true,
                evaluations: *evaluations,
            });
        }
        let start = self.off_the_bed(&bays, start);
        let (state, spent) = minimise(&self.chain, &bays, start, self.x, |s| self.top(&bays, s));
        *evaluations += spent;
        Ok(ContactPattern {
            grounded,
            bays,
            state,
            slack: false,
            evaluations: *evaluations,
        })
    }

    /// A start in which no bay lies flat: its rise would not depend on its offset there.
    fn off_the_bed(&self, bays: &[Bay], mut start: BayUnknowns) -> BayUnknowns {
        for (bay, offset) in bays.iter().zip(&mut start.offsets) {
            if self.chain.parts(bay, *offset).next().is_none()
                && let Some(better) = offset_for_rise(&self.chain, bay, start.h, *offset)
            {
                *offset = better;
            }
        }
        start
    }

    /// Everything suspended vertically, if that leaves enough length on the bed (or needs none).
    fn slack(
        &self,
        grounded: &[ElementRange],
        bays: &[Bay],
        start: &BayUnknowns,
    ) -> Option<BayUnknowns> {
        if grounded.is_empty() && self.x > 1e-120 * self.chain.length {
            return None;
        }
        let mut offsets = Vec::with_capacity(bays.len());
        let mut room = self.chain.length - self.x;
        for (bay, guess) in bays.iter().zip(&start.offsets) {
            let offset = offset_for_rise(&self.chain, bay, 0.0, *guess)?;
            room -= self
                .chain
                .parts(bay, offset)
                .map(|part| part.length)
                .sum::<f64>();
            offsets.push(offset);
        }
        let loose = grounded.is_empty() || room >= 0.0;
        loose.then_some(BayUnknowns { h: 0.0, offsets })
    }

    /// A grounded run that the bed would have to hold down: the offset may only fall across it.
    fn held_down(&self, pattern: &ContactPattern) -> Option<usize> {
        let slip = 1e-12 * self.top(&pattern.bays, &pattern.state);
        pattern.grounded.iter().position(|run| {
            let offset = |pick: &dyn Fn(&Bay) -> bool| {
                let bay = pattern.bays.iter().position(pick)?;
                pattern.state.offsets.get(bay).copied()
            };
            let before = offset(&|bay| bay.onto == Some(*run));
            let after = offset(&|bay| bay.from == Some(*run));
            matches!((before, after), (Some(before), Some(after)) if after > before + slip)
        })
    }

    /// The deepest point under the bed: its element, the offset there, and its bay.
    fn deepest(&self, pattern: &ContactPattern) -> Option<(usize, f64, usize)> {
        let bed = self.bed?;
        let mut worst = -1e-9 * (self.chain.length + self.z.abs());
        let mut found = None;
        for (k, (bay, offset)) in pattern.bays.iter().zip(&pattern.state.offsets).enumerate() {
            let mut z = if bay.from.is_none() { bed } else { 0.0 };
            let mut v = f64::INFINITY;
            for part in self.chain.parts(bay, *offset) {
                let span = self.chain.part_span(&part);
                // At a body: V turns from down to up across it.
                if v < 0.0 && part.va > 0.0 && z < worst {
                    worst = z;
                    found = Some((part.element - 1, *offset, k));
                }
                v = part.va + span.weight * span.length;
                if part.va < 0.0 && v >= 0.0 {
                    let mut low = span;
                    low.length = (-part.va / span.weight).min(span.length);
                    let depth = z + low.reach(pattern.state.h, part.va).1;
                    if depth < worst {
                        worst = depth;
                        found = Some((part.element, *offset, k));
                    }
                }
                z += span.reach(pattern.state.h, part.va).1;
            }
        }
        found
    }

    fn highest(&self, solution: &Solution) -> f64 {
        (0..=1000)
            .map(|i| solution.at(self.chain.length * f64::from(i) / 1000.0).z_m)
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The pattern with one grounded run more, cutting `bay` in two at its lowest point.
fn with(
    pattern: &ContactPattern,
    run: ElementRange,
    bay: usize,
    offset: f64,
) -> (Vec<ElementRange>, BayUnknowns) {
    let mut grounded = pattern.grounded.clone();
    let place = grounded.partition_point(|other| other.0 < run.0);
    grounded.insert(place, run);
    let mut state = pattern.state.clone();
    state.offsets.insert(bay, offset);
    state.h = state.h.max(1e-3 * offset.abs()).max(1e-200);
    (grounded, state)
}

/// The pattern with one grounded run less, joining the bays on its sides.
fn without(pattern: &ContactPattern, released: usize) -> (Vec<ElementRange>, BayUnknowns) {
    let run = pattern.grounded[released];
    let mut grounded = pattern.grounded.clone();
    grounded.remove(released);
    let mut state = pattern.state.clone();
    if let Some(bay) = pattern.bays.iter().position(|bay| bay.from == Some(run)) {
        state.offsets.remove(bay);
    }
    state.h = state.h.max(1e-200);
    (grounded, state)
}
