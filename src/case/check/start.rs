//! A start shape given by coordinates: as many of each as arc lengths, from end A to end B, no two at one place.

use crate::case::diagnostic::Finding;
use crate::case::fields::quantity;
use crate::case::tree::{Node, element_names};

const LISTS: [&str; 3] = ["x_m", "y_m", "z_m"];

/// Arc lengths may miss the line's end by this share of its length: they are typed, the length is a sum.
const SLOP: f64 = 1e-9;

/// Checks of the start.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let Some(start) = root.get("start") else {
        return Vec::new();
    };
    if start.get("from_run").is_some() {
        return beside_a_run(start);
    }
    let given = start.get("shape").and_then(Node::text) == Some("given");
    let Some(arc) = start.get("arc_m") else {
        let lost = LISTS
            .into_iter()
            .find_map(|key| Some((key, start.get(key)?)));
        let alone = lost.map(|(key, node)| {
            let remedy =
                "add `arc_m = [0.0, ...]`, the arc lengths from end A at which the shape is given";
            Finding::new(
                &node.span,
                format!("start.{key}"),
                "has no effect without arc_m",
                remedy,
            )
        });
        let missing = given.then(|| {
            let remedy =
                "add `arc_m`, `x_m` and `z_m`, lists of equal length in m from end A to end B";
            Finding::new(&start.span, "start.arc_m", "is missing", remedy)
        });
        return alone.into_iter().chain(missing).collect();
    };
    if start.get("shape").and_then(Node::text) == Some("straight") {
        let remedy = "let the shape be \"given\", or \"equilibrium\" to search for one from there";
        let problem = "has no effect: the line starts straight";
        return vec![Finding::new(&arc.span, "start.arc_m", problem, remedy)];
    }
    let Some(lengths) = arc.numbers() else {
        return Vec::new();
    };
    let mut found = lists(start, lengths.len());
    found.extend(steps_back(arc, &lengths));
    found.extend(covers(root, arc, &lengths));
    if found.is_empty() {
        found.extend(coincide(start, &lengths));
    }
    found
}

/// A run says all about the start.
fn beside_a_run(start: &Node) -> Vec<Finding> {
    let others = LISTS
        .into_iter()
        .chain(["shape", "arc_m", "velocity_m_per_s"]);
    let given = others.filter_map(|key| Some((key, start.get(key)?)));
    given
        .map(|(key, node)| {
            let problem = "has no effect: the line starts from a run";
            let remedy = "leave it out, or leave out start.from_run";
            Finding::new(&node.span, format!("start.{key}"), problem, remedy)
        })
        .collect()
}

/// x and z are needed, and every list is as long as that of the arc lengths.
fn lists(start: &Node, count: usize) -> Vec<Finding> {
    let one = |key: &str| {
        let name = format!("start.{key}");
        let Some(node) = start.get(key) else {
            let remedy = format!("add `{key} = [...]` with {count} numbers in m");
            return (key != "y_m").then(|| Finding::new(&start.span, name, "is missing", remedy));
        };
        let held = node.numbers()?.len();
        (held != count).then(|| {
            let problem = format!("has {held} values for {count} arc lengths");
            Finding::new(
                &node.span,
                name,
                problem,
                "give one value for each arc length of arc_m",
            )
        })
    };
    LISTS.into_iter().filter_map(one).collect()
}

fn steps_back(arc: &Node, lengths: &[f64]) -> Option<Finding> {
    let at = lengths.windows(2).position(|pair| pair[1] <= pair[0])?;
    let problem = format!(
        "the arc lengths must increase: {} follows {}",
        quantity(lengths[at + 1], "m"),
        quantity(lengths[at], "m")
    );
    let span = &arc.items().get(at + 1)?.span;
    Some(Finding::new(
        span,
        "start.arc_m",
        problem,
        "list the places from end A to end B, each once",
    ))
}

/// From 0 to the whole line.
fn covers(root: &Node, arc: &Node, lengths: &[f64]) -> Option<Finding> {
    let sections = root.get("line")?.items();
    let each: Option<Vec<f64>> = sections
        .iter()
        .map(|s| s.get("length_m")?.number())
        .collect();
    let whole: f64 = each?.iter().sum();
    let (first, last) = (*lengths.first()?, *lengths.last()?);
    let right = first == 0.0
        && last >= whole * (1.0 - SLOP)
        && element_names(sections).len() == sections.len();
    (!right).then(|| {
        let problem = format!(
            "the shape goes from {} to {}, and the line is {} long",
            quantity(first, "m"),
            quantity(last, "m"),
            quantity(whole, "m")
        );
        Finding::new(
            &arc.span,
            "start.arc_m",
            problem,
            "give the shape from 0 to the end of the line",
        )
    })
}

/// Two places of the line at one point would make a segment without length and direction.
fn coincide(start: &Node, lengths: &[f64]) -> Option<Finding> {
    let list = |key: &str| start.get(key).and_then(Node::numbers);
    let (x, z) = (list("x_m")?, list("z_m")?);
    let y = list("y_m").unwrap_or_else(|| vec![0.0; lengths.len()]);
    let at =
        (1..lengths.len()).find(|&i| x[i] == x[i - 1] && y[i] == y[i - 1] && z[i] == z[i - 1])?;
    let problem = format!(
        "the line is at one point from {} to {} of its length",
        quantity(lengths[at - 1], "m"),
        quantity(lengths[at], "m")
    );
    let remedy = "move one of the two points: a segment without length has no direction";
    let span = &start.get("x_m")?.items().get(at)?.span;
    Some(Finding::new(span, "start.x_m", problem, remedy))
}
