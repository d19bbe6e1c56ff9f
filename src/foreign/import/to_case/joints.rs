//! Places where lines of the file are one line of the case: rods without length at which lines that bend are joined, and places inside a
//! line whose sections are lines of the mooring.

use std::collections::{HashMap, VecDeque};

use crate::import::mooring::{Attachment, Hold, Mooring};

/// A line of the case: lines of the file one behind the other, each with whether it runs from its end B to its end A.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chain {
    /// The lines.
    pub pieces: Vec<(usize, bool)>,
    /// What its ends are attached to.
    pub ends: [Attachment; 2],
}

/// A line and which of its ends.
type LineWithEnd = (usize, usize);

/// The ends of lines by what they are attached to.
#[derive(Debug, Clone, Default)]
pub struct LineJoints {
    at_rods: HashMap<usize, Vec<LineWithEnd>>,
    inside: HashMap<usize, Vec<LineWithEnd>>,
    points: HashMap<usize, usize>,
}

impl LineJoints {
    /// Those of a mooring.
    #[must_use]
    pub fn of_mooring(mooring: &Mooring) -> Self {
        let mut joints = Self::default();
        for (number, line) in mooring.lines.iter().enumerate() {
            for (end, attached) in line.ends.iter().enumerate() {
                let list = match attached.value {
                    Attachment::Rod(rod, _) => joints.at_rods.entry(rod).or_default(),
                    Attachment::Inside(place) => joints.inside.entry(place).or_default(),
                    Attachment::Point(point) => {
                        *joints.points.entry(point).or_default() += 1;
                        continue;
                    }
                };
                list.push((number, end));
            }
        }
        joints
    }

    /// Ends of lines at a rod.
    #[must_use]
    pub fn at_rod(&self, rod: usize) -> &[LineWithEnd] {
        self.at_rods.get(&rod).map_or(&[], Vec::as_slice)
    }

    /// Whether a line ends at a point.
    #[must_use]
    pub fn is_used_point(&self, point: usize) -> bool {
        self.points.contains_key(&point)
    }

    /// Whether a joint is inside a line of the case: it is no point of its own.
    #[must_use]
    pub fn is_inside(&self, mooring: &Mooring, rod: usize) -> bool {
        mooring.rods[rod].is_joint() && self.joined_by(mooring, rod).is_some()
    }

    /// The two lines that are one line of the case across this place, each with the end that is at it.
    fn joined_at(&self, mooring: &Mooring, at: Attachment) -> Option<[LineWithEnd; 2]> {
        match at {
            Attachment::Point(_) => None,
            Attachment::Rod(rod, _) => self.joined_by(mooring, rod),
            Attachment::Inside(place) => match self.inside.get(&place)?.as_slice() {
                &[one, other] => Some([one, other]),
                _ => None,
            },
        }
    }

    /// The same of a free joint, which joins two lines that bend.
    fn joined_by(&self, mooring: &Mooring, rod: usize) -> Option<[LineWithEnd; 2]> {
        let joint = &mooring.rods[rod];
        if !joint.is_joint() || joint.hold.value != Hold::Free {
            return None;
        }
        let bends = |line: usize| {
            let of_type = mooring.lines[line].of_type.value;
            mooring.line_types[of_type].bending.value > 0.0
        };
        match self.at_rod(rod) {
            &[one, other] if one.0 != other.0 && bends(one.0) && bends(other.0) => {
                Some([one, other])
            }
            _ => None,
        }
    }
}

/// The lines of the case.
#[must_use]
pub fn chains(mooring: &Mooring, joints: &LineJoints) -> Vec<Chain> {
    let mut used = vec![false; mooring.lines.len()];
    let mut chains = Vec::new();
    for first in 0..mooring.lines.len() {
        if used[first] {
            continue;
        }
        used[first] = true;
        let line = &mooring.lines[first];
        let mut growing = Growing {
            pieces: VecDeque::from([(first, false)]),
            ends: [line.ends[0].value, line.ends[1].value],
        };
        growing.extend(mooring, joints, &mut used, 1);
        growing.extend(mooring, joints, &mut used, 0);
        chains.push(Chain {
            pieces: growing.pieces.into(),
            ends: growing.ends,
        });
    }
    chains
}

/// A line of the case as it is put together.
struct Growing {
    pieces: VecDeque<(usize, bool)>,
    ends: [Attachment; 2],
}

impl Growing {
    /// Lengthens it at one of its ends by all lines that are joined there.
    fn extend(&mut self, mooring: &Mooring, joints: &LineJoints, used: &mut [bool], at: usize) {
        while let Some(joined) = joints.joined_at(mooring, self.ends[at]) {
            let Some(&(next, end)) = joined.iter().find(|(line, _)| !used[*line]) else {
                return;
            };
            used[next] = true;
            // Its far end is the new end; it runs backwards where it meets the others with the wrong end.
            let backwards = (end == 0) == (at == 0);
            let far = mooring.lines[next].ends[1 - end].value;
            match at {
                0 => self.pieces.push_front((next, backwards)),
                _ => self.pieces.push_back((next, backwards)),
            }
            self.ends[at] = far;
        }
    }
}
