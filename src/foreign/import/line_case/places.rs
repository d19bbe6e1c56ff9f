//! Where clumps hang.

use super::source::{LETTERS, LineSource};
use crate::case::{Case, Clump, EndKind, OnSection, Section};

/// The letter of the end of the line that a clump hangs at; nothing between the ends.
pub(super) fn end_of(case: &Case, clump: &Clump) -> Option<&'static str> {
    let number = case
        .line
        .iter()
        .position(|one| clump.is_on(Some(&one.name)))?;
    let section = &case.line[number];
    match nearest(section, clump) {
        0 if number == 0 => Some(LETTERS[0]),
        node if node == section.segments && number + 1 == case.line.len() => Some(LETTERS[1]),
        _ => None,
    }
}

/// The clumps at an end, by its letter.
pub(super) fn at_end<'c>(
    source: &'c LineSource<'_>,
    letter: &'static str,
) -> impl Iterator<Item = &'c Clump> {
    let case = &source.case;
    let clumps = case.clumps.iter();
    clumps.filter(move |clump| end_of(case, clump) == Some(letter))
}

/// The clump that is the body of a free end.
pub(super) fn on_free_end<'c>(source: &'c LineSource<'_>, letter: &str) -> Option<&'c Clump> {
    let ends = &source.case.ends;
    let (letter, end) = match letter == LETTERS[0] {
        true => (LETTERS[0], &ends.a),
        false => (LETTERS[1], &ends.b),
    };
    at_end(source, letter)
        .next()
        .filter(|_| end.kind == EndKind::Free)
}

/// The node that a clump hangs at: the nearest.
fn nearest(section: &Section, clump: &Clump) -> usize {
    whole(
        (clump.at_m / section.length_m * section.segments as f64).round(),
        section,
    )
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of a node, between 0 and the segments of its section"
)]
fn whole(node: f64, section: &Section) -> usize {
    (node.max(0.0) as usize).min(section.segments)
}
