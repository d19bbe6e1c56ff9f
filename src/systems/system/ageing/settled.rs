//! The depths at which the lines of an aged system rest.
//!
//! A fixed point: the depths give the states of the pieces, these an equilibrium, this the depths. From the depths as new, each round goes
//! on by a share of what the depths moved, by Aitken's rule for vectors (Irons and Tuck 1969; Küttler and Wall, Comput. Mech. 43,
//! 2008), so that growth that lowers a line to where it grows less does not swing to and fro.

use super::material::AgedState;
use super::pieces::{AgeingLine, aged, depths, lines, varying};
use crate::system::build::{AgedParts, build};
use crate::system::equilibrium::SystemEquilibrium;
use crate::system::model::SystemFile;
use crate::system::network::Network;
use crate::system::rest::{UnsolvedSystem, not_divided, rest_from};

/// Rounds that the depths may take.
const MOST_ROUNDS: usize = 60;
/// What the depths may move in the last round, by the greatest depth.
const SETTLED: f64 = 1e-11;
/// The same where they no longer come nearer: discretised lines rest within the tolerance of their solver.
const ACCEPTED: f64 = 1e-6;
/// Rounds in which they came no nearer, after which that is taken for the tolerance.
const STALLED: usize = 3;
/// Shares of what the depths moved that a round goes on by.
const LEAST_SHARE: f64 = 0.02;
const GREATEST_SHARE: f64 = 1.5;

/// How a system aged.
#[derive(Debug, Clone, PartialEq)]
pub struct SettledAge {
    /// Time since the lines were new \[years\].
    pub years: f64,
    /// Thickest growth anywhere \[m\].
    pub growth_m: f64,
    /// Greatest loss of diameter anywhere \[m\].
    pub loss_m: f64,
    /// Rounds that the depths took.
    pub rounds: usize,
    /// What the depths still moved in the last of them \[m\].
    pub moved_m: f64,
    /// The parts of the aged lines.
    pub parts: AgedParts,
}

/// The aged system at rest, from it as new; nothing where nothing ages.
///
/// # Errors
/// As [`solve`](crate::system::solved::solve) for the aged system; depths that do not settle.
pub fn settle(
    file: &SystemFile,
    network: &Network,
    rest: &SystemEquilibrium,
) -> Result<Option<(Network, SystemEquilibrium, SettledAge)>, UnsolvedSystem> {
    let Some(ageing) = &file.ageing else {
        return Ok(None);
    };
    let lines = lines(file, ageing);
    if lines.is_empty() {
        return Ok(None);
    }
    let mut iteration = Iteration::of_depths(&lines, depths(&lines, network, rest));
    let mut start = rest.placement.clone();
    for round in 1..=MOST_ROUNDS {
        let (parts, states) = aged(&lines, &iteration.depths, network.density);
        let network = build(file, &parts).map_err(not_divided)?;
        let rest = rest_from(&network, &start)?;
        start.clone_from(&rest.placement);
        if iteration.is_settled(&depths(&lines, &network, &rest)) {
            let greatest = |of: fn(&AgedState) -> f64| states.iter().map(of).fold(0.0, f64::max);
            let age = SettledAge {
                years: ageing.years,
                growth_m: greatest(|state| state.growth_m),
                loss_m: greatest(|state| state.loss_m),
                rounds: round,
                moved_m: iteration.amount(),
                parts,
            };
            return Ok(Some((network, rest, age)));
        }
    }
    Err(not_settled(&lines, &iteration))
}

fn not_settled(lines: &[AgeingLine<'_>], iteration: &Iteration) -> UnsolvedSystem {
    let names: Vec<&str> = lines.iter().map(|line| line.name.as_str()).collect();
    UnsolvedSystem {
        problem: format!(
            "the depths at which {} age do not settle: after {MOST_ROUNDS} rounds they still move by {:.3e} m",
            names.join(", "),
            iteration.amount()
        ),
        remedy: "let thickness and rate vary over more depth, or use more `ageing.pieces`"
            .to_owned(),
        line: lines.first().map(|line| line.name.clone()),
        part: None,
    }
}

/// The depths, and how they moved.
struct Iteration {
    /// Depths that the states of the places are of \[m\].
    depths: Vec<f64>,
    /// Which of them matter.
    varying: Vec<bool>,
    /// What they moved in the last round \[m\].
    moved: Vec<f64>,
    /// The least that any round moved them at most \[m\], and the rounds since that did not halve it.
    nearest: f64,
    stalled: usize,
    /// Share of it that the next round goes on by.
    share: f64,
    /// Greatest depth \[m\].
    deepest: f64,
}

impl Iteration {
    fn of_depths(lines: &[AgeingLine<'_>], depths: Vec<f64>) -> Self {
        Self {
            varying: varying(lines),
            moved: Vec::new(),
            nearest: f64::INFINITY,
            stalled: 0,
            share: 1.0,
            deepest: depths.iter().fold(1.0, |most, depth| depth.abs().max(most)),
            depths,
        }
    }

    /// The greatest that a depth moved in the last round \[m\].
    fn amount(&self) -> f64 {
        self.moved
            .iter()
            .fold(0.0, |most, moved| moved.abs().max(most))
    }

    /// Whether the system rests at the depths of its states; if not, the depths of the next round.
    fn is_settled(&mut self, found: &[f64]) -> bool {
        let pairs = found.iter().zip(&self.depths).zip(&self.varying);
        let moved: Vec<f64> = pairs
            .map(|((found, depth), varies)| if *varies { found - depth } else { 0.0 })
            .collect();
        self.share = self.next_share(&moved);
        self.moved = moved;
        let amount = self.amount();
        self.stalled = match amount > 0.5 * self.nearest {
            true => self.stalled + 1,
            false => 0,
        };
        self.nearest = self.nearest.min(amount);
        let stalled = amount <= ACCEPTED * self.deepest && self.stalled >= STALLED;
        if amount <= SETTLED * self.deepest || stalled {
            return true;
        }
        for (depth, moved) in self.depths.iter_mut().zip(&self.moved) {
            *depth += self.share * moved;
        }
        false
    }

    /// Aitken's share: by what the last one changed of what the depths move.
    fn next_share(&self, moved: &[f64]) -> f64 {
        if self.moved.is_empty() {
            return 1.0;
        }
        let (mut along, mut squared) = (0.0, 0.0);
        for (now, before) in moved.iter().zip(&self.moved) {
            along += before * (now - before);
            squared += (now - before) * (now - before);
        }
        if squared <= 0.0 {
            return self.share;
        }
        (-self.share * along / squared).clamp(LEAST_SHARE, GREATEST_SHARE)
    }
}
