//! Names of the parts of a case, by the identifiers of a file.

use super::case_text::name;
use std::collections::{HashMap, HashSet};

use crate::import::mooring::Mooring;

/// Names of all parts, each once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// Of the line types.
    pub materials: Vec<String>,
    /// Of the bodies.
    pub bodies: Vec<String>,
    /// Of the rods.
    pub rods: Vec<String>,
    /// Of the points.
    pub points: Vec<String>,
    /// Of the lines.
    pub lines: Vec<String>,
    /// Of the body that coupled parts are on.
    pub vessel: String,
}

impl Names {
    /// The names of a mooring.
    #[must_use]
    pub fn of_mooring(mooring: &Mooring) -> Self {
        let types = mooring.line_types.iter().map(|of| name(&of.name));
        let bodies = distinct(
            mooring.bodies.iter().map(|body| prefixed("body", &body.id)),
            &[],
        );
        let rods = distinct(
            mooring.rods.iter().map(|rod| prefixed("rod", &rod.id)),
            &bodies,
        );
        let taken: Vec<String> = bodies.iter().chain(&rods).cloned().collect();
        let vessel = distinct(std::iter::once("vessel".to_owned()), &taken).swap_remove(0);
        Self {
            materials: distinct(types, &[]),
            points: distinct(
                mooring.points.iter().map(|point| prefixed("p", &point.id)),
                &[],
            ),
            lines: distinct(
                mooring.lines.iter().map(|line| prefixed("line", &line.id)),
                &[],
            ),
            bodies,
            rods,
            vessel,
        }
    }

    /// The point at an end of a rod.
    #[must_use]
    pub fn rod_end(&self, rod: usize, end: usize) -> String {
        format!("{}-{}", self.rods[rod], ["a", "b"][end])
    }
}

/// An identifier that is a number becomes a name: `3` is `p3`.
fn prefixed(prefix: &str, id: &str) -> String {
    match id.starts_with(|letter: char| letter.is_ascii_digit()) {
        true => format!("{prefix}{}", name(id)),
        false => name(id),
    }
}

/// Names that differ from each other and from those taken.
fn distinct(names: impl Iterator<Item = String>, taken: &[String]) -> Vec<String> {
    let mut used: HashSet<String> = taken.iter().cloned().collect();
    // Copies of a name so far.
    let mut copies: HashMap<String, usize> = HashMap::new();
    let unique = names.map(|name| {
        let mut unique = name.clone();
        while !used.insert(unique.clone()) {
            let copy = copies.entry(name.clone()).or_insert(1);
            *copy += 1;
            unique = format!("{name}-{copy}");
        }
        unique
    });
    unique.collect()
}
