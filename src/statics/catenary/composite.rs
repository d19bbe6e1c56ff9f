//! Lines of several sections: which of them rest on the bed, and the shape that follows.
//!
//! The resting places are found as an active set: solve, look for the deepest point under the bed, let
//! the run of sunk sections around it rest, let go of runs that the bed would have to pull
//! down; again. A sunk run is bent upwards everywhere, so it rests in one piece. A pattern that does
//! not settle is refused.

use super::chain::{Bay, Chain, Run};
use super::descent::{State, lift, settle};
use super::error::CatenaryError;
use super::free;
use super::laid;
use super::line::{Bed, Line};
use super::place::place;
use super::single::ON_BED;
use super::solution::{Frame, Solution};
use super::span::length;

/// A line in the solver's plane.
pub(super) struct Problem {
    pub chain: Chain,
    pub x: f64,
    pub z: f64,
    /// Depth of the bed below A.
    pub bed: Option<f64>,
    pub frame: Frame,
}

/// A solved pattern.
pub(super) struct Pattern {
    pub resting: Vec<Run>,
    pub bays: Vec<Bay>,
    pub state: State,
    pub slack: bool,
    pub looks: u32,
}

/// Solves a line of any number of sections.
pub(super) fn solve(line: &Line<'_>) -> Result<Solution, CatenaryError> {
    let problem = place(line)?;
    if let Some(bed) = line.bed.filter(|bed| bed.slope_rad != 0.0) {
        return over_slope(&problem, bed);
    }
    let pattern = problem.settle()?;
    if let Some(bed) = line.bed.filter(|bed| bed.friction > 0.0)
        && !pattern.slack
        && problem.lying(&pattern) > 0.0
    {
        return over_rough(&problem, bed);
    }
    let solution = problem.finish(&pattern)?;
    if let (Some(_), Some(above)) = (line.bed, line.surface_above_a_m)
        && problem.highest(&solution) > above * (1.0 + 1e-9) + 1e-9
    {
        return Err(CatenaryError::Pattern(
            "a line of several sections comes up to the surface while there is a bed as well; one of the two is solved",
        ));
    }
    Ok(solution)
}

/// On a rough, level bed: as laid from A.
fn over_rough(problem: &Problem, bed: Bed) -> Result<Solution, CatenaryError> {
    if bed.below_a_m > ON_BED * problem.chain.length {
        return Err(CatenaryError::FrictionUndetermined);
    }
    laid::solve(problem, bed)?.ok_or(laid::SEVERAL)
}

/// Over a sloping bed: lying from A, or clear of it.
fn over_slope(problem: &Problem, bed: Bed) -> Result<Solution, CatenaryError> {
    let slip = ON_BED * (problem.chain.length + problem.z.abs());
    if bed.below_a_m <= slip
        && let Some(lies) = laid::solve(problem, bed)?
    {
        return Ok(lies);
    }
    let pattern = problem.settle()?;
    let clear = pattern
        .bays
        .iter()
        .zip(&pattern.state.offsets)
        .all(|(bay, offset)| {
            let parts = problem.chain.parts(bay, *offset);
            let tan = bed.slope_rad.tan();
            !laid::sinks(problem, parts, pattern.state.h, bed.below_a_m, tan)
        });
    if clear {
        return problem.finish(&pattern);
    }
    Err(if bed.below_a_m <= slip {
        laid::SEVERAL
    } else {
        CatenaryError::SlopeBelowA
    })
}

impl Problem {
    pub(super) fn last(&self) -> usize {
        self.chain.elements.len() - 1
    }

    /// The bays between resting places.
    fn bays(&self, resting: &[Run]) -> Vec<Bay> {
        let depth = self.bed.unwrap_or(0.0);
        let n = resting.len();
        let mut bays = Vec::with_capacity(n + 1);
        for k in 0..=n {
            let from = (k > 0).then(|| resting[k - 1]);
            let onto = (k < n).then(|| resting[k]);
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

    /// The maximal run of sunk elements around one, if that one is sunk.
    pub(super) fn run(&self, at: usize) -> Run {
        let sunk = |i: &usize| self.chain.elements[*i].total() >= 0.0;
        let first = (0..=at).rev().take_while(sunk).last().unwrap_or(at);
        let last = (at..=self.last()).take_while(sunk).last().unwrap_or(at);
        (first, last)
    }

    /// Finds the resting places.
    fn settle(&self) -> Result<Pattern, CatenaryError> {
        let mut resting = Vec::new();
        let (h, offset) = self.guess();
        if self.bed == Some(0.0) && self.chain.elements[0].total() > 0.0 {
            resting.push(self.run(0));
        }
        let bays = self.bays(&resting);
        let mut state = State {
            h,
            offsets: vec![offset; bays.len()],
        };
        let mut looks = 0;
        for _ in 0..4 * self.chain.elements.len() + 8 {
            let pattern = self.rest(resting.clone(), state, &mut looks)?;
            if let Some(idle) = self.pulled_down(&pattern) {
                (resting, state) = without(&pattern, idle);
                continue;
            }
            let Some((at, offset, bay)) = self.deepest(&pattern) else {
                return Ok(pattern);
            };
            let run = self.run(at);
            if pattern.resting.contains(&run) {
                break;
            }
            (resting, state) = with(&pattern, run, bay, offset);
            // Bays of ends that now lie on the bed fall away.
            let bays = self.bays(&resting).len();
            if state.offsets.len() > bays && self.z + self.bed.unwrap_or(0.0) == 0.0 {
                state.offsets.truncate(bays);
            }
            state.offsets.resize(bays, offset);
        }
        Err(CatenaryError::Pattern(
            "which sections rest on the bed could not be settled for this line",
        ))
    }

    /// A start: a uniform line of the same weight and give.
    pub(super) fn guess(&self) -> (f64, f64) {
        let chain = &self.chain;
        let all: f64 = chain.elements.iter().map(|e| e.total().abs()).sum();
        let w = (chain.weight.abs().max(0.05 * all) / chain.length).max(1e-200);
        let ea = chain.length / chain.give.max(1e-200);
        let up = if chain.weight < 0.0 { -1.0 } else { 1.0 };
        let free = free::solve(self.x, up * self.z, chain.length, w, ea, None);
        let (h, v) = free.map_or((all, 0.0), |f| (f.h, up * f.v_mean));
        (h.max(1e-3 * all).max(1e-200), v - 0.5 * chain.weight)
    }

    /// Equilibrium for given resting places.
    fn rest(
        &self,
        resting: Vec<Run>,
        start: State,
        looks: &mut u32,
    ) -> Result<Pattern, CatenaryError> {
        let bays = self.bays(&resting);
        if let Some(state) = self.slack(&resting, &bays, &start) {
            return Ok(Pattern {
                resting,
                bays,
                state,
                slack: true,
                looks: *looks,
            });
        }
        let start = self.off_the_bed(&bays, start);
        let (state, spent) = settle(&self.chain, &bays, start, self.x, |s| self.top(&bays, s));
        *looks += spent;
        Ok(Pattern {
            resting,
            bays,
            state,
            slack: false,
            looks: *looks,
        })
    }

    /// A start in which no bay lies flat: there its rise would not answer to its offset.
    fn off_the_bed(&self, bays: &[Bay], mut start: State) -> State {
        for (bay, offset) in bays.iter().zip(&mut start.offsets) {
            if self.chain.parts(bay, *offset).next().is_none()
                && let Some(better) = lift(&self.chain, bay, start.h, *offset)
            {
                *offset = better;
            }
        }
        start
    }

    /// Everything hanging straight, if that leaves enough length on the bed (or needs none).
    fn slack(&self, resting: &[Run], bays: &[Bay], start: &State) -> Option<State> {
        if resting.is_empty() && self.x > 1e-120 * self.chain.length {
            return None;
        }
        let mut offsets = Vec::with_capacity(bays.len());
        let mut room = self.chain.length - self.x;
        for (bay, guess) in bays.iter().zip(&start.offsets) {
            let offset = lift(&self.chain, bay, 0.0, *guess)?;
            room -= self
                .chain
                .parts(bay, offset)
                .map(|part| part.length)
                .sum::<f64>();
            offsets.push(offset);
        }
        let loose = resting.is_empty() || room >= 0.0;
        loose.then_some(State { h: 0.0, offsets })
    }

    /// Largest tension anywhere.
    pub(super) fn top(&self, bays: &[Bay], state: &State) -> f64 {
        let v = bays
            .iter()
            .zip(&state.offsets)
            .flat_map(|(bay, offset)| self.chain.parts(bay, *offset))
            .map(|part| {
                let span = self.chain.part_span(&part);
                part.va
                    .abs()
                    .max((part.va + span.weight * span.length).abs())
            })
            .fold(0.0, f64::max);
        length(state.h, v)
    }

    /// A resting place that the bed would have to hold down: the offset may only fall across it.
    fn pulled_down(&self, pattern: &Pattern) -> Option<usize> {
        let slip = 1e-12 * self.top(&pattern.bays, &pattern.state);
        pattern.resting.iter().position(|run| {
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
    fn deepest(&self, pattern: &Pattern) -> Option<(usize, f64, usize)> {
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

    /// Unstretched length on the bed.
    pub(super) fn lying(&self, pattern: &Pattern) -> f64 {
        let off: f64 = pattern
            .bays
            .iter()
            .zip(&pattern.state.offsets)
            .flat_map(|(bay, offset)| self.chain.parts(bay, *offset))
            .map(|part| part.length)
            .sum();
        if pattern.resting.is_empty() {
            return 0.0;
        }
        let lying = self.chain.length - off;
        if lying > 1e-12 * self.chain.length {
            lying
        } else {
            0.0
        }
    }

    fn highest(&self, solution: &Solution) -> f64 {
        (0..=1000)
            .map(|i| solution.at(self.chain.length * f64::from(i) / 1000.0).z_m)
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The pattern with one resting place more, cutting `bay` in two at its lowest point.
fn with(pattern: &Pattern, run: Run, bay: usize, offset: f64) -> (Vec<Run>, State) {
    let mut resting = pattern.resting.clone();
    let place = resting.partition_point(|other| other.0 < run.0);
    resting.insert(place, run);
    let mut state = pattern.state.clone();
    state.offsets.insert(bay, offset);
    state.h = state.h.max(1e-3 * offset.abs()).max(1e-200);
    (resting, state)
}

/// The pattern with one resting place less, joining the bays on its sides.
fn without(pattern: &Pattern, idle: usize) -> (Vec<Run>, State) {
    let run = pattern.resting[idle];
    let mut resting = pattern.resting.clone();
    resting.remove(idle);
    let mut state = pattern.state.clone();
    if let Some(bay) = pattern.bays.iter().position(|bay| bay.from == Some(run)) {
        state.offsets.remove(bay);
    }
    state.h = state.h.max(1e-200);
    (resting, state)
}
