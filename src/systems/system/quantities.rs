//! The results of a system by name: `tension_n[LINE|b]`, `z_m[POINT]`, `stiffness[BODY|11]`.

use super::analysis::bed_clearance::least_height;
use super::analysis::box_tree::BoxTree;
use super::analysis::clearance::{boxed, nearest_line};
use super::analysis::periods::periods;
use super::equilibrium::{SystemEquilibrium, SystemError};
use super::loads;
use super::model::SystemKeys;
use super::motion::channels::{GAUGE, WHOLE};
use super::motion::modes::{id_of_mode, not_asked};
use super::network::Network;
use super::rest::refused;
use super::solved::SolvedSystem;
use super::stiffness::of_body;
use crate::case::schema::{Key, KeyValue};
use crate::case::{Finding, unknown_name};
use crate::numerics::V3;

/// What a result by name is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SystemSubject {
    /// A line and one of its ends.
    LineEnd,
    /// A line.
    Line,
    /// A point.
    Point,
    /// A body and two directions from 1 to 6.
    Stiffness,
    /// A body.
    Body,
    /// A number from 1.
    Period,
}

/// A result of a system.
#[derive(Debug, Clone, Copy)]
struct SystemQuantity {
    name: &'static str,
    unit: &'static str,
    of: SystemSubject,
    meaning: &'static str,
}

const fn quantity(
    name: &'static str,
    unit: &'static str,
    of: SystemSubject,
    meaning: &'static str,
) -> SystemQuantity {
    SystemQuantity {
        name,
        unit,
        of,
        meaning,
    }
}

/// All results.
#[rustfmt::skip] // one a line
static QUANTITIES: [SystemQuantity; 16] = [
    quantity("tension_n", "N", SystemSubject::LineEnd, "tension at an end of a line, or where its sections meet: tension_n[LINE|1], of named sections tension_n[LINE|CHAIN|ROPE]"),
    quantity("horizontal_n", "N", SystemSubject::LineEnd, "horizontal part of the tension at an end of a line"),
    quantity("vertical_n", "N", SystemSubject::LineEnd, "vertical force of a line on its end, upwards"),
    quantity("on_bed_m", "m", SystemSubject::Line, "unstretched length of a line on the bed"),
    quantity("clearance_m", "m", SystemSubject::Line, "least distance of a line from another that shares no point with it"),
    quantity("bed_clearance_m", "m", SystemSubject::Line, "least height of a line above the bed, or of a stretch of it by arc length: bed_clearance_m[LINE|20..60]"),
    quantity("uplift_n", "N", SystemSubject::Point, "upward pull of the lines on a point"),
    quantity("offset_m", "m", SystemSubject::Body, "distance in plan of a free body from the place given"),
    quantity("pin_force_x_n", "N", SystemSubject::Body, "x of the force of its pin on a body"),
    quantity("pin_force_y_n", "N", SystemSubject::Body, "y of the force of its pin on a body"),
    quantity("pin_force_z_n", "N", SystemSubject::Body, "z of the force of its pin on a body"),
    quantity("period_s", "s", SystemSubject::Period, "natural period by its number, the longest first, or longest of one that is mostly of a body and a direction"),
    quantity("x_m", "m", SystemSubject::Point, "x of a point, or of a body on a line: x_m[LINE|CLUMP]"),
    quantity("y_m", "m", SystemSubject::Point, "y of a point, or of a body on a line"),
    quantity("z_m", "m", SystemSubject::Point, "z of a point, or of a body on a line"),
    quantity("stiffness", "N/m, N, N m", SystemSubject::Stiffness, "stiffness of the lines on a body, by row and column from 1 to 6"),
];

/// Components of a place.
const POSITION: [&str; 3] = ["x_m", "y_m", "z_m"];
/// Components of the force of a pin.
const PIN_FORCE: [&str; 3] = ["pin_force_x_n", "pin_force_y_n", "pin_force_z_n"];

/// Name and places of a result: `tension_n[mooring|b]` is `tension_n`, `mooring`, `b`.
fn parts(name: &str) -> Option<(&'static SystemQuantity, &str, &str)> {
    let (quantity, rest) = name.split_once('[')?;
    let of = rest.strip_suffix(']')?;
    let quantity = QUANTITIES.iter().find(|known| known.name == quantity)?;
    let (subject, place) = of.split_once('|').unwrap_or((of, ""));
    Some((quantity, subject, place))
}

/// Unit of the result of this name; empty where there is none.
#[must_use]
pub fn unit(name: &str) -> &'static str {
    if let Some(mode) = id_of_mode(name) {
        return mode.parts().0.unit();
    }
    let Some((quantity, _, place)) = parts(name) else {
        return "";
    };
    match (quantity.of, direction(place)) {
        (SystemSubject::Stiffness, Some((i, j))) => match (i < 3, j < 3) {
            (true, true) => "N/m",
            (false, false) => "N m",
            _ => "N",
        },
        _ => quantity.unit,
    }
}

/// Row and column from `15`.
fn direction(place: &str) -> Option<(usize, usize)> {
    let digits: Vec<usize> = place
        .chars()
        .map(|c| c.to_digit(10).map_or(0, |d| d as usize))
        .collect();
    match digits[..] {
        [i, j] if (1..=6).contains(&i) && (1..=6).contains(&j) => Some((i - 1, j - 1)),
        _ => None,
    }
}

/// The value of the result of this name.
///
/// # Errors
/// Why there is none, as a sentence.
pub fn value(solved: &SolvedSystem, name: &str) -> Result<f64, String> {
    if let Some(mode) = solved.asked_mode(name) {
        return mode;
    }
    match known_stiffness(solved, name) {
        Some(value) => Ok(value),
        None => value_at(&solved.network, &solved.rest, name),
    }
}

/// A number of the stiffness on a body; nothing for other results.
fn known_stiffness(solved: &SolvedSystem, name: &str) -> Option<f64> {
    let (quantity, subject, place) = parts(name)?;
    let body = (quantity.of == SystemSubject::Stiffness).then(|| solved.network.body(subject))?;
    Some(solved.stiffness[body?][direction(place)?])
}

/// The value of the result of this name where a system rests.
///
/// # Errors
/// Why there is none, as a sentence.
pub fn value_at(network: &Network, rest: &SystemEquilibrium, name: &str) -> Result<f64, String> {
    let missing = || format!("There is no result `{name}` of this system.");
    let (quantity, subject, place) = parts(name).ok_or_else(missing)?;
    match quantity.of {
        SystemSubject::Line | SystemSubject::LineEnd => {
            let index = network.line(subject).ok_or_else(missing)?;
            if quantity.name == "bed_clearance_m" {
                let stretch = stretch(place).ok_or_else(missing)?;
                return least_height((network, rest), index, stretch);
            }
            let line = &rest.balance.lines[index];
            if let Some(tension) =
                between((network, rest), index, place).filter(|_| quantity.name == "tension_n")
            {
                return Ok(tension);
            }
            let force = match place {
                "a" => line.force_a,
                "b" => line.force_b,
                "" if quantity.of == SystemSubject::Line => line.force_a,
                _ => return Err(missing()),
            };
            Ok(match quantity.name {
                "clearance_m" => return clearance((network, rest), index),
                "tension_n" => force.norm(),
                "horizontal_n" => force.xy().norm(),
                "vertical_n" => force.z,
                _ => line.on_bed(),
            })
        }
        SystemSubject::Point => {
            of_point((network, rest), quantity.name, subject, place).ok_or_else(missing)
        }
        SystemSubject::Body => {
            let index = network.body(subject).ok_or_else(missing)?;
            if let Some(axis) = PIN_FORCE.iter().position(|name| *name == quantity.name) {
                let force = loads::of_pin(network, rest, index);
                return force.map(|force| force[axis]).ok_or_else(missing);
            }
            let here = rest.placement.bodies[index].origin;
            Ok((here - network.bodies[index].pose.origin).xy().norm())
        }
        SystemSubject::Period => period((network, rest), subject, place).ok_or_else(missing)?,
        SystemSubject::Stiffness => {
            let index = network.body(subject).ok_or_else(missing)?;
            let at = direction(place).ok_or_else(missing)?;
            let stiffness = of_body(network, rest, index);
            let stiffness = stiffness
                .map_err(|unsolved| refused(network, &SystemError::Line(unsolved)).problem)?;
            Ok(stiffness[at])
        }
    }
}

/// A stretch of a line, `20..60`, or all of it; nothing of other words.
fn stretch(place: &str) -> Option<Option<[f64; 2]>> {
    if place.is_empty() {
        return Some(None);
    }
    let (from, to) = place.split_once("..")?;
    Some(Some([from.parse().ok()?, to.parse().ok()?]))
}

/// The tension where two sections of a line meet, by their names or its number from end A.
fn between((network, rest): AtRest<'_>, line: usize, place: &str) -> Option<f64> {
    let given = &network.lines[line];
    let meeting = given.meetings().position(|meeting| meeting == place)? + 1;
    let before = given.parts[..meeting].iter();
    let arc: f64 = before.map(|section| section.length_m).sum();
    let places = &rest.placement.points;
    let ends = [&places[given.from], &places[given.to]];
    Some(rest.balance.lines[line].at(arc / given.length(), ends).1)
}

/// A result of a point, or of a body on a line.
fn of_point((network, rest): AtRest<'_>, name: &str, subject: &str, place: &str) -> Option<f64> {
    let axis = POSITION.iter().position(|axis| *axis == name);
    if !place.is_empty() {
        return Some(on_line((network, rest), subject, place)?[axis?]);
    }
    let index = network.point(subject)?;
    Some(match axis {
        Some(axis) => rest.placement.points[index][axis],
        None => loads::pull(network, rest, index).z,
    })
}

/// The place of a body on a line, by the names of both.
fn on_line((network, rest): AtRest<'_>, line: &str, body: &str) -> Option<V3> {
    let index = network.line(line)?;
    let given = &network.lines[index];
    let mut bodies = given.bodies.iter();
    let body = bodies.find(|one| one.name.as_deref() == Some(body))?;
    let places = &rest.placement.points;
    let ends = [&places[given.from], &places[given.to]];
    let share = body.arc_m / given.length();
    Some(rest.balance.lines[index].at(share, ends).0)
}

/// A system and where it rests.
type AtRest<'a> = (&'a Network, &'a SystemEquilibrium);

/// The error of the result of this name, where it is known: by the mesh of all lines, or of closed forms by rounding.
#[must_use]
pub fn error(solved: &SolvedSystem, name: &str) -> Option<f64> {
    let (quantity, subject, place) = parts(name)?;
    let (network, errors) = (&solved.network, &solved.errors);
    let of_ends = quantity.of == SystemSubject::LineEnd;
    if of_ends && (errors.companion.is_none() || matches!(place, "a" | "b")) {
        return errors.lines[network.line(subject)?];
    }
    match (quantity.of, quantity.unit) {
        (SystemSubject::Point, "m") if place.is_empty() => {
            return errors.points[network.point(subject)?];
        }
        (SystemSubject::Body, "m") => return Some(errors.bodies[network.body(subject)?]?[0]),
        _ => {}
    }
    let finer = errors.finer()?;
    let fine = value_at(&finer.network, &finer.rest, name).ok()?;
    let own = finer.error(value(solved, name).ok()? - fine);
    let resolution = match quantity.name {
        "on_bed_m" => bed_resolution(solved, network.line(subject)?),
        _ => 0.0,
    };
    Some(own.max(resolution))
}

/// To what the length on the bed of a divided line that touches it is known \[m\]: half its longest segment.
pub(super) fn bed_resolution(solved: &SolvedSystem, line: usize) -> f64 {
    let at_rest = &solved.rest.balance.lines[line];
    let divided = at_rest.discretised.as_ref();
    let touches = divided.filter(|_| at_rest.on_bed() > 0.0);
    touches.map_or(0.0, |divided| 0.5 * divided.longest_segment_m())
}

/// The results that matter most: the tension of every line at the end where it is greater, the offsets of free bodies, the natural
/// periods.
#[must_use]
pub fn main_results(solved: &SolvedSystem) -> Vec<String> {
    let (network, rest) = (&solved.network, &solved.rest);
    let lines = network.lines.iter().zip(&rest.balance.lines);
    let mut names: Vec<String> = lines
        .map(|(line, at_rest)| {
            let [a, b] = at_rest.tensions();
            format!("tension_n[{}|{}]", line.name, if a > b { "a" } else { "b" })
        })
        .collect();
    let free = network.bodies.iter().filter(|body| body.free);
    names.extend(free.map(|body| format!("offset_m[{}]", body.name)));
    for body in network.bodies.iter().filter(|body| body.pinned) {
        names.extend(PIN_FORCE.map(|name| format!("{name}[{}]", body.name)));
    }
    // By number: as inputs change, modes of a part and a direction may mix.
    let found = periods(network, rest).unwrap_or_default();
    let count = found.numbered().count();
    names.extend((1..=count).map(|number| format!("period_s[{number}]")));
    let asked = solved.asked_modes().unwrap_or_default().iter();
    names.extend(asked.map(|number| number.id.parts().0.to_string()));
    names
}

fn clearance((network, rest): AtRest<'_>, line: usize) -> Result<f64, String> {
    let curves = boxed(network, rest);
    let nearest = nearest_line(network, (&curves, &BoxTree::new(&curves)), line);
    let alone = || "Every other line shares a point with it.".to_owned();
    nearest.map(|(_, distance)| distance).ok_or_else(alone)
}

/// The period of this number, those that do not end left out, or the longest that is mostly of a part and a direction; nothing
/// where there is no such subject.
fn period(
    (network, rest): AtRest<'_>,
    subject: &str,
    direction: &str,
) -> Option<Result<f64, String>> {
    let number: Option<usize> = subject.parse().ok().filter(|_| direction.is_empty());
    if number.is_none() && direction.is_empty() {
        return None;
    }
    let found = match periods(network, rest) {
        Ok(found) => found,
        Err(why) => return Some(Err(format!("There are no natural periods: {why}."))),
    };
    let mut modes = found.modes.iter();
    let period = match number {
        Some(number) => found.numbered().nth(number.wrapping_sub(1)),
        None => modes
            .find(|mode| {
                let is_finite = mode.period_s.is_some_and(f64::is_finite);
                is_finite && mode.names(network) == (subject, direction)
            })
            .and_then(|mode| mode.period_s),
    };
    Some(period.ok_or_else(|| match (number, found.complete_to_s) {
        (Some(_), Some(shortest)) => format!(
            "There are {} natural periods above {shortest:.4} s; below it not all are computed.",
            found.numbered().count()
        ),
        (Some(_), None) => format!("There are {} natural periods.", found.numbered().count()),
        (None, _) => format!("No natural mode is mostly {direction} of {subject}."),
    }))
}

/// A result of a part that the system does not have. Copies and halves of a part begin with its name.
pub(super) fn unknown_part<T: KeyValue>(
    key: &Key<'_, T>,
    part: &str,
    keys: &SystemKeys<'_>,
) -> Option<Finding> {
    let known = parts_of(keys);
    if part == WHOLE && !known.contains(&WHOLE) {
        let remedy = "add `energy = true` to [output]";
        return Some(key.finding("is of the energy, which is not recorded", remedy));
    }
    if known.iter().any(|name| part.starts_with(name)) {
        return None;
    }
    let (problem, remedy) = unknown_name(part, &known, "line, point, body or rod", "system")?;
    Some(key.finding(problem, remedy))
}

/// The names of what a system has channels of.
fn parts_of<'k>(keys: &'k SystemKeys<'_>) -> Vec<&'k str> {
    let lines = keys.lines.iter().filter_map(|(_, line)| line.name.get());
    let lines = lines.map(String::as_str);
    let points = keys.points.iter().map(|(name, _)| name.as_str());
    let bodies = keys.bodies.iter().map(|(name, _)| name.as_str());
    let rods = keys.rods.iter().map(|(name, _)| name.as_str());
    let all = lines.chain(points).chain(bodies).chain(rods);
    let energy = keys.output.as_ref().map(|output| &output.energy);
    let whole = energy.is_some_and(|energy| energy.is(&true));
    all.chain([GAUGE]).chain(whole.then_some(WHOLE)).collect()
}

/// A result that does not exist.
pub(super) fn unknown(key: &Key<'_, String>, keys: &SystemKeys<'_>) -> Option<Finding> {
    let name = key.get()?;
    if id_of_mode(name).is_some() {
        return not_asked(key, keys);
    }
    if let Some((quantity, part, _)) = parts(name) {
        let of_part = quantity.of != SystemSubject::Period;
        return unknown_part(key, part, keys).filter(|_| of_part);
    }
    let known: Vec<String> = QUANTITIES
        .iter()
        .map(|known| format!("{}[...] ({})", known.name, known.meaning))
        .collect();
    let problem = format!("there is no result \"{}\"", name.escape_default());
    Some(key.finding(problem, format!("give one of {}", known.join(", "))))
}
