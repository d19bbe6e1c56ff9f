//! What the writers of all parts of a case read.

use super::{
    super::mooring::{Attachment, Hold, Mooring},
    joints::LineJoints,
    motion::CoupledMotion,
    names::Names,
    sea::SeaOfCase,
};

/// What the writers of the parts have in common.
#[derive(Debug)]
pub struct Context<'m> {
    /// The mooring.
    pub mooring: &'m Mooring,
    /// Names of its parts in the case.
    pub names: Names,
    /// Its sea.
    pub sea: SeaOfCase,
    /// How coupled parts move.
    pub motion: CoupledMotion,
    /// Whether coupled points are on one body.
    pub has_vessel: bool,
    /// The ends of its lines.
    pub joints: LineJoints,
    /// The points and rods on each body.
    pub on_bodies: Vec<OnBody>,
}

/// Points, and rods with a length, on a body, by their places in the lists.
#[derive(Debug, Clone, Default)]
pub struct OnBody {
    /// The points.
    pub points: Vec<usize>,
    /// The rods.
    pub rods: Vec<usize>,
}

impl OnBody {
    /// Those on each body of a mooring.
    #[must_use]
    pub fn all(mooring: &Mooring) -> Vec<Self> {
        let mut all = vec![Self::default(); mooring.bodies.len()];
        for (number, point) in mooring.points.iter().enumerate() {
            if let Hold::Body(body) = point.hold.value {
                all[body].points.push(number);
            }
        }
        for (number, rod) in mooring.rods.iter().enumerate() {
            if let Hold::Body(body) = rod.hold.value
                && !rod.is_joint()
            {
                all[body].rods.push(number);
            }
        }
        all
    }
}

impl Context<'_> {
    /// Whether a line ends there.
    #[must_use]
    pub fn is_used(&self, at: Attachment) -> bool {
        match at {
            Attachment::Point(point) => self.joints.is_used_point(point),
            Attachment::Rod(rod, end) => {
                let mut ends = self.joints.at_rod(rod).iter();
                ends.any(|(line, of)| {
                    self.mooring.lines[*line].ends[*of].value == Attachment::Rod(rod, end)
                })
            }
            Attachment::Inside(_) => true,
        }
    }

    /// Whether a line ends at a rod.
    #[must_use]
    pub fn is_used_rod(&self, rod: usize) -> bool {
        !self.joints.at_rod(rod).is_empty()
    }
}

/// Whether all points and ends of rods are above still water.
#[must_use]
pub fn is_in_air(mooring: &Mooring) -> bool {
    let held = |hold: &Hold| !matches!(hold.base(), Hold::Body(_));
    let points = mooring
        .points
        .iter()
        .filter(|point| held(&point.hold.value));
    let points = points.map(|point| point.place[2].value);
    let rods = mooring.rods.iter().filter(|rod| held(&rod.hold.value));
    let rods = rods.flat_map(|rod| [rod.ends[0][2].value, rod.ends[1][2].value]);
    let heights: Vec<f64> = points.chain(rods).collect();
    mooring.bodies.is_empty() && !heights.is_empty() && heights.iter().all(|z| *z > 0.0)
}
