//! A start shape given by coordinates: as many of each as arc lengths, from end A to end B, no two at one place.

use super::line::length;
use super::loads::increasing;
use crate::case::diagnostic::Finding;
use crate::case::fields::quantity;
use crate::case::model::{CaseKeys, StartKeys, StartShape};
use crate::case::schema::Key;

/// Arc lengths may miss the line's end by this share of its length: they are typed, the length is a sum.
const SLOP: f64 = 1e-9;

/// Checks of the start.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let Some(start) = &case.start else {
        return Vec::new();
    };
    if start.from_run.is_given() {
        return beside_a_run(start);
    }
    let whole = length(case).filter(|_| !case.line.is_empty());
    of_shape(start, whole)
}

/// Checks of the start of a line between two points of a system, of this length \[m\] where that is known; straight it may lead to one that
/// has no place by itself.
#[must_use]
pub fn of_line_start(start: &StartKeys<'_>, whole: Option<f64>, leads: bool) -> Vec<Finding> {
    let by_ends = "has no effect: the line goes from one of its points to the other";
    let by_itself = "is of a line by itself";
    let place = "leave it out, or with a straight shape the position of its free end";
    let shape = "give its shape";
    let mut found: Vec<Finding> = [
        start
            .azimuth_deg
            .if_given(by_ends, place)
            .filter(|_| !leads),
        start
            .elevation_deg
            .if_given(by_ends, place)
            .filter(|_| !leads),
        start.from_run.if_given(by_itself, shape),
    ]
    .into_iter()
    .flatten()
    .collect();
    found.extend(of_shape(start, whole));
    found
}

/// A shape given by coordinates, of a line of this length \[m\] where that is known.
fn of_shape(start: &StartKeys<'_>, whole: Option<f64>) -> Vec<Finding> {
    if !start.arc_m.is_given() {
        return without_arc_lengths(start);
    }
    if start.shape.given() == Some(&StartShape::Straight) {
        let remedy = "let the shape be \"given\", or \"equilibrium\" to search for one from there";
        return vec![
            start
                .arc_m
                .finding("has no effect: the line starts straight", remedy),
        ];
    }
    let Some(lengths) = start.arc_m.get() else {
        return Vec::new();
    };
    let mut found = lists(start, lengths.len());
    let remedy = "list the places from end A to end B, each once";
    found.extend(increasing(&start.arc_m, "arc lengths", remedy));
    found.extend(whole.and_then(|whole| covers(start, lengths, whole)));
    if found.is_empty() {
        found.extend(coincide(start, lengths));
    }
    found
}

fn coordinates<'k, 'a>(start: &'k StartKeys<'a>) -> [&'k Key<'a, Vec<f64>>; 3] {
    [&start.x_m, &start.y_m, &start.z_m]
}

/// A run says all about the start.
fn beside_a_run(start: &StartKeys<'_>) -> Vec<Finding> {
    let problem = "has no effect: the line starts from a run";
    let remedy = "leave it out, or leave out start.from_run";
    let lists = coordinates(start).into_iter().chain([&start.arc_m]);
    let others = [
        start.shape.if_given(problem, remedy),
        start.velocity_m_per_s.if_given(problem, remedy),
    ];
    let found = lists.map(|key| key.if_given(problem, remedy)).chain(others);
    found.flatten().collect()
}

fn without_arc_lengths(start: &StartKeys<'_>) -> Vec<Finding> {
    let alone = coordinates(start).into_iter().find_map(|key| {
        let remedy =
            "add `arc_m = [0.0, ...]`, the arc lengths from end A at which the shape is given";
        key.if_given("has no effect without arc_m", remedy)
    });
    let given = start.shape.given() == Some(&StartShape::Given);
    let missing = given.then(|| {
        start
            .arc_m
            .missing("add `arc_m`, `x_m` and `z_m`, lists of equal length in m from end A to end B")
    });
    alone.into_iter().chain(missing).collect()
}

/// x and z are needed, and every list is as long as that of the arc lengths.
fn lists(start: &StartKeys<'_>, count: usize) -> Vec<Finding> {
    let one = |key: &Key<'_, Vec<f64>>| {
        if !key.is_given() {
            let name = key.name();
            let remedy = format!("add `{name} = [...]` with {count} numbers in m");
            return (name != "y_m").then(|| key.missing(remedy));
        }
        let held = key.get()?.len();
        (held != count).then(|| {
            let problem = format!("has {held} values for {count} arc lengths");
            key.finding(problem, "give one value for each arc length of arc_m")
        })
    };
    coordinates(start).into_iter().filter_map(one).collect()
}

/// From 0 to the whole line.
fn covers(start: &StartKeys<'_>, lengths: &[f64], whole: f64) -> Option<Finding> {
    let (first, last) = (*lengths.first()?, *lengths.last()?);
    let right = first == 0.0 && last >= whole * (1.0 - SLOP);
    (!right).then(|| {
        let problem = format!(
            "the shape goes from {} to {}, and the line is {} long",
            quantity(first, "m"),
            quantity(last, "m"),
            quantity(whole, "m")
        );
        start
            .arc_m
            .finding(problem, "give the shape from 0 to the end of the line")
    })
}

/// Two places of the line at one point would make a segment without length and direction.
fn coincide(start: &StartKeys<'_>, lengths: &[f64]) -> Option<Finding> {
    let (x, z) = (start.x_m.get()?, start.z_m.get()?);
    let level = vec![0.0; lengths.len()];
    let y = start.y_m.get().unwrap_or(&level);
    let at =
        (1..lengths.len()).find(|&i| x[i] == x[i - 1] && y[i] == y[i - 1] && z[i] == z[i - 1])?;
    let problem = format!(
        "the line is at one point from {} to {} of its length",
        quantity(lengths[at - 1], "m"),
        quantity(lengths[at], "m")
    );
    let remedy = "move one of the two points: a segment without length has no direction";
    Some(start.x_m.finding_at_item(at, problem, remedy))
}
