//! Rods without length: lines are joined at them, and where they bend, the two are one line of sections.

use crate::import::mooring::{Attachment, Hold, Mooring};

/// A line of the case: lines of the file one behind the other, each with whether it runs from its end B to its end A.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chain {
    /// The lines.
    pub pieces: Vec<(usize, bool)>,
    /// What its ends are attached to.
    pub ends: [Attachment; 2],
}

/// The lines of the case.
#[must_use]
pub fn chains(mooring: &Mooring) -> Vec<Chain> {
    let mut used = vec![false; mooring.lines.len()];
    let mut chains = Vec::new();
    for first in 0..mooring.lines.len() {
        if used[first] {
            continue;
        }
        used[first] = true;
        let line = &mooring.lines[first];
        let mut chain = Chain {
            pieces: vec![(first, false)],
            ends: [line.ends[0].value, line.ends[1].value],
        };
        extend(mooring, &mut chain, &mut used, 1);
        extend(mooring, &mut chain, &mut used, 0);
        chains.push(chain);
    }
    chains
}

/// Whether a joint is inside a line of the case: it is no point of its own.
#[must_use]
pub fn is_inside(mooring: &Mooring, rod: usize) -> bool {
    mooring.rods[rod].is_joint() && joins(mooring, rod).is_some()
}

/// The two lines that a free joint joins as one, each with the end that is at it.
fn joins(mooring: &Mooring, rod: usize) -> Option<[(usize, usize); 2]> {
    let joint = &mooring.rods[rod];
    if !joint.is_joint() || joint.hold.value != Hold::Free {
        return None;
    }
    let mut at_it = Vec::new();
    for (number, line) in mooring.lines.iter().enumerate() {
        for (end, attached) in line.ends.iter().enumerate() {
            if matches!(attached.value, Attachment::Rod(of, _) if of == rod) {
                at_it.push((number, end));
            }
        }
    }
    let bends = |line: usize| {
        let of_type = mooring.lines[line].of_type.value;
        mooring.line_types[of_type].bending.value > 0.0
    };
    match at_it.as_slice() {
        &[one, other] if one.0 != other.0 && bends(one.0) && bends(other.0) => Some([one, other]),
        _ => None,
    }
}

/// Lengthens a chain at one of its ends by all lines that are joined there.
fn extend(mooring: &Mooring, chain: &mut Chain, used: &mut [bool], at: usize) {
    while let Attachment::Rod(rod, _) = chain.ends[at] {
        let Some(joined) = joins(mooring, rod) else {
            return;
        };
        let Some(&(next, end)) = joined.iter().find(|(line, _)| !used[*line]) else {
            return;
        };
        used[next] = true;
        // Its far end is the new end of the chain; it runs backwards where it meets the chain with the wrong end.
        let backwards = (end == 0) == (at == 0);
        let far = mooring.lines[next].ends[1 - end].value;
        match at {
            0 => chain.pieces.insert(0, (next, backwards)),
            _ => chain.pieces.push((next, backwards)),
        }
        chain.ends[at] = far;
    }
}
