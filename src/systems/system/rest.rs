//! The equilibrium of a network from a cold start, or why it has none, in words.

use super::bounds::Contact;
use super::connected::{Loose, loose};
use super::equilibrium::{SystemEquilibrium, SystemError, search};
use super::freedoms::Placement;
use super::network::{Held, Network};
use super::start::start;
use super::unstable::leave;
use crate::work_log::{self, Task};

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

/// A line that has no element, and why.
#[must_use]
pub fn not_divided((line, why): (String, String)) -> UnsolvedSystem {
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
/// [`UnsolvedSystem`]: a part that nothing holds, a line without a solution, a point that rises out of the water.
pub fn rest(network: &Network) -> Result<SystemEquilibrium, UnsolvedSystem> {
    if let Some(part) = loose(network) {
        return Err(not_held(network, part));
    }
    rest_from(network, &start(network))
}

/// A system at rest, all of which something holds, from a placement. An equilibrium that is unstable is left for the one that the system comes to
/// when it is let go near it, if there is one.
///
/// # Errors
/// As [`rest`].
pub fn rest_from(
    network: &Network,
    start: &Placement,
) -> Result<SystemEquilibrium, UnsolvedSystem> {
    work_log::log(Task::Rest, format_args!("{} lines", network.lines.len()));
    let rest = search(network, start).map_err(|error| refused(network, &error))?;
    let rest = leave(network, rest);
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
        remedy: "join it by a line to a fixed point or to a held body, or fix it; to let it fall or rise in motion add [start] with `placement = \"given\"`, and its place".to_owned(),
        line: None,
        part: Some((part, name)),
    }
}

/// How far below the bed a place may be by rounding \[m\].
const ROUNDED: f64 = 1e-6;

/// The first place given below a bed of depths over a grid: of points, and of the ends of rods. Those below a level bed are found with the
/// keys.
#[must_use]
pub fn below_bed(network: &Network) -> Option<UnsolvedSystem> {
    let bed = network.bed.as_ref().filter(|bed| !bed.is_level())?;
    let points = network.points.iter().enumerate();
    let given = points.filter_map(|(index, point)| match &point.held {
        Held::At(place) => Some((Loose::Point(index), *place)),
        Held::Free(free) => free.start.map(|place| (Loose::Point(index), place)),
        Held::On(..) => None,
    });
    let bodies = network.bodies.iter().enumerate();
    let rods = bodies.filter(|(_, body)| body.spins_about.is_some());
    let ends = rods.flat_map(|(index, rod)| {
        let ends = rod.members.iter().flat_map(|rod| [rod.from, rod.to]);
        ends.map(move |end| (Loose::Body(index), rod.pose.origin + rod.pose.arm(&end)))
    });
    let mut below = given.chain(ends);
    let (part, place) = below.find(|(_, place)| bed.height(place) < -ROUNDED)?;
    let (name, z) = (part_name(network, part), bed.z_below(&place));
    Some(UnsolvedSystem {
        problem: format!(
            "\"{name}\" lies {:.3} m below the bed, which is {:.3} m deep at x = {:.3} m, y = {:.3} m",
            z - place.z,
            -z,
            place.x,
            place.y
        ),
        remedy: format!("give a z of {:.3} or more there", (z * 1e3).ceil() / 1e3),
        line: None,
        part: Some((part, name)),
    })
}

/// A search without an answer, in words.
#[must_use]
pub fn refused(network: &Network, error: &SystemError) -> UnsolvedSystem {
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
        SystemError::TooMuchWork { line, work, steps } => {
            let line = &network.lines[*line].name;
            UnsolvedSystem {
                problem: format!(
                    "the search for an equilibrium was given up after {steps} steps: line \"{line}\" took {work} iterations by segments, as a line does that has no equilibrium, or many, at most places of its ends"
                ),
                remedy: "give free points a position, and free bodies a pose, near where they should come to rest; check the length of that line".to_owned(),
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
fn out_of_water(network: &Network, rest: &SystemEquilibrium) -> Option<UnsolvedSystem> {
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
