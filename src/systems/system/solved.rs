//! A system worked out: its equilibrium, how stable it is, the stiffness of its bodies.

use nalgebra::Matrix6;

use super::ageing::SettledAge;
use super::ageing::settled::settle;
use super::asked_modes::AskedModes;
use super::bounds::Contact;
use super::build::{AgedParts, build, divide};
use super::connected::{Loose, loose};
use super::damage::without_lost_line;
use super::equilibrium::{SystemEquilibrium, SystemError};
use super::errors_at_rest::ErrorsAtRest;
use super::immersion::Immersion;
use super::model::SystemFile;
use super::network::{Held, Network};
use super::rest::{UnsolvedSystem, below_bed, not_divided, refused, rest};
use super::stability::{Stability, stability};
use super::stiffness::of_bodies;

/// How the lines of a system at rest take part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineForms {
    /// By their closed forms where these are known, else divided into segments.
    ClosedWhereKnown,
    /// All divided into segments.
    Divided,
}

/// A system worked out.
#[derive(Debug, Clone)]
pub struct SolvedSystem {
    /// What the file says.
    pub file: SystemFile,
    /// The same in SI, its lines aged.
    pub network: Network,
    /// Points and bodies that nothing holds: at rest they are held where the file puts them, in motion they fall or rise from there.
    pub dropped: Vec<String>,
    /// How its lines aged, if they did.
    pub age: Option<SettledAge>,
    /// At rest.
    pub rest: SystemEquilibrium,
    /// How it rests.
    pub stability: Stability,
    /// Its numerical errors.
    pub errors: ErrorsAtRest,
    /// Stiffness of the lines on each body about its origin \[N/m, N, N m\].
    pub stiffness: Vec<Matrix6<f64>>,
    /// The numbers of natural modes that its file asks for, once they were found.
    pub modes: AskedModes,
}

impl SolvedSystem {
    /// Whether any of its lines rests divided into segments.
    #[must_use]
    pub fn is_discretised(&self) -> bool {
        let lines = &self.rest.balance.lines;
        lines.iter().any(|line| line.discretised.is_some())
    }

    /// Whether a point is at the surface, part of its volume out of the water.
    #[must_use]
    pub fn is_afloat(&self, point: usize) -> bool {
        let Held::Free(free) = &self.network.points[point].held else {
            return false;
        };
        if !self.network.crossed {
            return self.rest.contact(point) == Contact::Surface;
        }
        let z = self.rest.placement.points[point].z;
        let wet = Immersion::of_point(&self.network, free, z);
        wet.share > 0.0 && wet.share < 1.0
    }
}

/// The network with what nothing holds, and begins a run in time where the file puts it, held there; and its names.
fn held_until_dropped(mut network: Network, ages: bool) -> (Network, Vec<String>) {
    let mut dropped = Vec::new();
    while let Some(part) = loose(&network).filter(|_| !ages) {
        match part {
            Loose::Point(number) => {
                let point = &mut network.points[number];
                let Held::Free(free) = &point.held else { break };
                let Some(place) = free.start.filter(|_| free.initial.placed) else {
                    break;
                };
                point.held = Held::At(place);
                dropped.push(point.name.clone());
            }
            Loose::Body(number) => {
                let body = &mut network.bodies[number];
                if !body.initial.placed {
                    break;
                }
                body.free = false;
                dropped.push(body.name.clone());
            }
        }
    }
    (network, dropped)
}

/// Works out a system that the checks passed, with its errors where its file does not leave them out.
///
/// # Errors
/// [`UnsolvedSystem`]: a part that nothing holds, a line without a solution, a point that rises out of the water.
pub fn solve(file: SystemFile) -> Result<SolvedSystem, UnsolvedSystem> {
    let solver = file.solver.as_ref();
    let is_estimated = solver.is_none_or(|solver| solver.is_in_time() || solver.error_estimate);
    let solved = solve_without_errors(file, LineForms::ClosedWhereKnown)?;
    if !is_estimated {
        return Ok(solved);
    }
    Ok(SolvedSystem {
        errors: ErrorsAtRest::of_equilibrium(&solved.network, &solved.rest),
        ..solved
    })
}

/// The same without its companion, its lines in these forms: no error is known.
///
/// # Errors
/// As [`solve`].
pub fn solve_without_errors(
    file: SystemFile,
    forms: LineForms,
) -> Result<SolvedSystem, UnsolvedSystem> {
    let file = without_lost_line(file);
    let mut new = build(&file, &AgedParts::new()).map_err(not_divided)?;
    let divides = forms == LineForms::Divided;
    if divides && file.ageing.is_none() {
        divide(&mut new, &file, &AgedParts::new()).map_err(not_divided)?;
    }
    let (new, dropped) = held_until_dropped(new, file.ageing.is_some());
    if let Some(buried) = below_bed(&new) {
        return Err(buried);
    }
    let rest_as_new = rest(&new)?;
    let (network, rest, age) = match settle(&file, &new, &rest_as_new)? {
        // Lines age as those of closed form: what they are then is divided.
        Some((mut network, _, age)) if divides => {
            divide(&mut network, &file, &age.parts).map_err(not_divided)?;
            let found = rest(&network)?;
            (network, found, Some(age))
        }
        Some((network, mut rest, age)) => {
            rest.left = rest.left.or(rest_as_new.left);
            (network, rest, Some(age))
        }
        None => (new, rest_as_new, None),
    };
    let stability = stability(&network, &rest);
    let stiffness = of_bodies(&network, &rest);
    let stiffness = stiffness.map_err(|error| refused(&network, &SystemError::Line(error)))?;
    Ok(SolvedSystem {
        errors: ErrorsAtRest::unknown(&network),
        modes: AskedModes::default(),
        file,
        stability,
        stiffness,
        rest,
        network,
        dropped,
        age,
    })
}
