//! A system worked out: its equilibrium, how stable it is, the stiffness of its bodies.

use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen};

use super::ageing::SettledAge;
use super::ageing::settled::settle;
use super::analysis::asked::{Analyses, analyses};
use super::analysis::equilibria;
use super::bounds::Contact;
use super::build::{AgedParts, build};
use super::connected::{Loose, loose};
use super::equilibrium::{Equilibrium, SystemError, levers, search};
use super::freedoms::Placement;
use super::line_at_rest::LineAtRest;
use super::model::SystemFile;
use super::network::{Held, Network};
use super::start::start;
use super::stiffness::{of_body, take};
use crate::numerics::envelope::EnvelopeCholesky;

/// A system worked out.
#[derive(Debug, Clone)]
pub struct SolvedSystem {
    /// What the file says.
    pub file: SystemFile,
    /// The same in SI, its lines aged.
    pub network: Network,
    /// How its lines aged, if they did.
    pub age: Option<SettledAge>,
    /// At rest.
    pub rest: Equilibrium,
    /// How it rests.
    pub stability: Stability,
    /// Equilibria that searches from other poses of the free bodies find, and how they rest.
    pub others: Vec<(Equilibrium, Stability)>,
    /// The analyses that the file asks for.
    pub analyses: Analyses,
    /// Error of the end forces of each line \[N\]: by rounding, or by the mesh; nothing where it is not known.
    pub line_errors: Vec<Option<f64>>,
    /// Stiffness of the lines on each body about its origin \[N/m, N, N m\].
    pub stiffness: Vec<Matrix6<f64>>,
}

impl SolvedSystem {
    /// Whether any of its lines is divided into segments.
    #[must_use]
    pub fn is_discretised(&self) -> bool {
        self.network
            .lines
            .iter()
            .any(|line| line.discretised.is_some())
    }
}

/// How a system rests.
#[derive(Debug, Clone, PartialEq)]
pub enum Stability {
    /// It returns from any small displacement.
    Stable,
    /// It stays where it is put along some direction: the unknown that moves most, in words. Where no body is free the
    /// tensions are the same all along.
    Neutral(String),
    /// It leaves: the unknown that moves most, in words.
    Unstable(String),
}

/// Why a system has no answer.
#[derive(Debug, Clone, PartialEq)]
pub struct UnsolvedSystem {
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
    /// The line meant, if it is one.
    pub line: Option<String>,
    /// The point or body meant, if it is one, and its name.
    pub part: Option<(Loose, String)>,
}

/// Eigenvalues below this share of the greatest are none.
const NEUTRAL: f64 = 1e-11;
/// Negative eigenvalues beyond this share of the greatest are no rounding.
const UNSTABLE: f64 = 1e-9;

/// Works out a system that the checks passed.
///
/// # Errors
/// [`UnsolvedSystem`]: a part that nothing holds, a line without a solution, a point that rises out of the water.
pub fn solve(file: SystemFile) -> Result<SolvedSystem, UnsolvedSystem> {
    let new = build(&file, &AgedParts::new()).map_err(not_divided)?;
    let rest_as_new = rest(&new)?;
    let (network, rest, age) = match settle(&file, &new, &rest_as_new)? {
        Some((network, rest, age)) => (network, rest, Some(age)),
        None => (new, rest_as_new, None),
    };
    let stability = stability(&network, &rest);
    let bodies = 0..network.bodies.len();
    let stiffness = bodies.map(|body| of_body(&network, &rest, body));
    let stiffness: Result<Vec<_>, _> = stiffness.collect();
    let stiffness = stiffness.map_err(|error| refused(&network, &SystemError::Line(error)))?;
    let others = equilibria::others(&network, &rest).into_iter();
    let others = others.map(|other| {
        let stability = self::stability(&network, &other);
        (other, stability)
    });
    let errors = rest.balance.lines.iter().map(LineAtRest::error);
    Ok(SolvedSystem {
        analyses: analyses(&file, &network, &rest),
        others: others.collect(),
        line_errors: errors.collect(),
        file,
        stability,
        stiffness,
        rest,
        network,
        age,
    })
}

/// A line that has no element, and why.
pub(super) fn not_divided((line, why): (String, String)) -> UnsolvedSystem {
    UnsolvedSystem {
        problem: format!("line \"{line}\" cannot be divided into segments: {why}"),
        remedy: "check its materials and its sections".to_owned(),
        line: Some(line),
        part: None,
    }
}

/// A system at rest, from a cold start.
///
/// # Errors
/// As [`solve`].
pub fn rest(network: &Network) -> Result<Equilibrium, UnsolvedSystem> {
    if let Some(part) = loose(network) {
        return Err(not_held(network, part));
    }
    rest_from(network, &start(network))
}

/// A system at rest, all of which something holds, from a placement.
///
/// # Errors
/// As [`solve`].
pub(super) fn rest_from(
    network: &Network,
    start: &Placement,
) -> Result<Equilibrium, UnsolvedSystem> {
    let rest = search(network, start).map_err(|error| refused(network, &error))?;
    match out_of_water(network, &rest) {
        Some(refusal) => Err(refusal),
        None => Ok(rest),
    }
}

fn part_name(network: &Network, part: Loose) -> String {
    match part {
        Loose::Point(index) => network.points[index].name.clone(),
        Loose::Body(index) => network.bodies[index].name.clone(),
    }
}

fn not_held(network: &Network, part: Loose) -> UnsolvedSystem {
    let name = part_name(network, part);
    UnsolvedSystem {
        problem: format!(
            "nothing holds \"{name}\": no line joins it, directly or over others, to anything fixed"
        ),
        remedy: "join it by a line to a fixed point or to a held body, or fix it".to_owned(),
        line: None,
        part: Some((part, name)),
    }
}

fn refused(network: &Network, error: &SystemError) -> UnsolvedSystem {
    match error {
        SystemError::Line(unsolved) => {
            let line = &network.lines[unsolved.line].name;
            UnsolvedSystem {
                problem: format!(
                    "line \"{line}\" has no equilibrium between its ends: {}",
                    unsolved.why
                ),
                remedy: "check its length and the places of its ends".to_owned(),
                line: Some(line.clone()),
                part: None,
            }
        }
        SystemError::NotConverged {
            residual,
            at,
            steps,
        } => UnsolvedSystem {
            problem: format!(
                "the search for an equilibrium did not come to rest: after {steps} steps {residual:.3e} N are out of balance, most in {at}"
            ),
            remedy: "give free points a position, and free bodies a pose, near where they should come to rest".to_owned(),
            line: None,
            part: None,
        },
    }
}

/// A point at the surface whose buoyancy does not suffice to hold it down there.
fn out_of_water(network: &Network, rest: &Equilibrium) -> Option<UnsolvedSystem> {
    for (index, point) in network.points.iter().enumerate() {
        let (Held::Free(free), Some(first)) = (&point.held, rest.freedoms.points[index]) else {
            continue;
        };
        let pushed = rest.balance.force[first + 2];
        if rest.contact(index) == Contact::Surface
            && pushed > free.buoyancy + 1e-9 * rest.balance.tension
        {
            return Some(UnsolvedSystem {
                problem: format!(
                    "\"{}\" would be pulled out of the water by {:.6} N more than its buoyancy",
                    point.name,
                    pushed - free.buoyancy
                ),
                remedy: "give it more mass, or its lines more length; for lines in air set environment.water_density_kg_per_m3 = 0".to_owned(),
                line: None,
                part: Some((Loose::Point(index), point.name.clone())),
            });
        }
    }
    None
}

/// The least eigenvalue of the stiffness of what may move.
fn stability(network: &Network, rest: &Equilibrium) -> Stability {
    let moving: Vec<usize> = (0..rest.freedoms.count)
        .filter(|&k| rest.contacts[k] == Contact::None)
        .collect();
    if moving.is_empty() {
        return Stability::Stable;
    }
    // Turns count by the way they move a fairlead, or N m would be held against N/m.
    let lever = levers(network, &rest.freedoms);
    let mut stiffness: DMatrix<f64> = take(&rest.balance.symmetric(), &moving, &moving);
    for (row, i) in moving.iter().enumerate() {
        for (column, j) in moving.iter().enumerate() {
            stiffness[(row, column)] /= lever[*i] * lever[*j];
        }
    }
    let most = stiffness.diagonal().amax();
    // As many positive pivots as unknowns, as many positive eigenvalues (Sylvester): most systems need no more.
    let floor = DVector::from_element(moving.len(), -NEUTRAL * most);
    let order: Vec<usize> = (0..moving.len()).collect();
    if EnvelopeCholesky::new(&stiffness, &floor, &order).is_some() {
        return Stability::Stable;
    }
    let eigen = SymmetricEigen::new(stiffness);
    let least = eigen.eigenvalues.imin();
    let value = eigen.eigenvalues[least];
    if value > NEUTRAL * most {
        return Stability::Stable;
    }
    let unknown = moving[eigen.eigenvectors.column(least).iamax()];
    let name = rest.freedoms.name(network, unknown);
    if value < -UNSTABLE * most {
        Stability::Unstable(name)
    } else {
        Stability::Neutral(name)
    }
}
