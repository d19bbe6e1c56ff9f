//! The joints of a system: its points and bodies as nodes, those that are prescribed or carried first.

use std::ops::Range;

use crate::numerics::V3;
use crate::numerics::envelope::from_neighbour_to_neighbour;
use crate::system::network::{Held, Network};

/// What a joint does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Role {
    /// A point held or moved: its number in the network.
    Prescribed(usize),
    /// A point at a place of a body.
    OnBody(usize, V3),
    /// Origin of a body.
    Origin(usize),
    /// Rotation of a body.
    Rotation(usize),
    /// A free point: its number in the network.
    Free(usize),
    /// Where an end of a line goes that is let go: the line, and which end.
    Released(usize, usize),
    /// A length of line that passes an end or a point, its first coordinate \[m\]: its number in the network.
    Payout(usize),
}

/// The joints in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Joints {
    /// What each of them does.
    pub roles: Vec<Role>,
    /// The joint of each point of the network.
    pub points: Vec<usize>,
    /// The origin of each body of the network.
    pub bodies: Vec<usize>,
    /// The rotation of each body of the network; of one that is pinned it is free where the origin is not.
    pub rotations: Vec<usize>,
    /// The body that each body of the network is pinned to, and where in its frame.
    carriers: Vec<Option<(usize, V3)>>,
    /// The joint of each end of each line that may be let go.
    pub released: Vec<[Option<usize>; 2]>,
    /// The joint of each payout of the network.
    pub payouts: Vec<usize>,
    /// The joints that follow the equation of motion.
    pub free: Range<usize>,
    /// The row of each joint among the unknowns; the joints before `free` have none.
    rows: Vec<Option<usize>>,
    /// First column of each row of the condensed system.
    pub envelope: Vec<usize>,
}

impl Joints {
    /// The joints of a system.
    #[must_use]
    pub fn new(network: &Network) -> Self {
        let mut list = Roles::default();
        let free = |held: &Held| matches!(held, Held::Free(_));
        let points = || network.points.iter().enumerate();
        for (number, point) in points().filter(|(_, p)| !free(&p.held)) {
            list.points.insert(number, list.roles.len());
            list.roles.push(match point.held {
                Held::On(body, at) => Role::OnBody(body, at),
                Held::At(_) | Held::Free(_) => Role::Prescribed(number),
            });
        }
        let bodies = || network.bodies.iter().enumerate();
        for (number, body) in bodies().filter(|(_, body)| !body.free) {
            list.origin(number);
            if !body.pinned {
                list.rotation(number);
            }
        }
        let mut payouts = vec![0; network.payouts.len()];
        list.payouts(network, false, &mut payouts);
        let held = list.roles.len();
        list.payouts(network, true, &mut payouts);
        for (number, _) in points().filter(|(_, p)| free(&p.held)) {
            list.points.insert(number, list.roles.len());
            list.roles.push(Role::Free(number));
        }
        for (number, body) in bodies().filter(|(_, body)| body.turns()) {
            if body.free {
                list.origin(number);
            }
            list.rotation(number);
        }
        let released = list.releases(network);
        let count = list.roles.len();
        let mut joints = Self {
            roles: list.roles,
            points: list.points.into_values().collect(),
            bodies: list.origins.into_values().collect(),
            rotations: list.rotations.into_values().collect(),
            carriers: network.bodies.iter().map(|body| body.carrier).collect(),
            released,
            payouts,
            free: held..count,
            rows: Vec::new(),
            envelope: Vec::new(),
        };
        joints.number(network);
        joints
    }

    /// Numbers the unknowns from neighbour to neighbour.
    fn number(&mut self, network: &Network) {
        let held = self.free.start;
        let mut neighbours = vec![Vec::new(); self.free.len()];
        let mut join = |one: usize, other: usize| {
            if one != other && one >= held && other >= held {
                neighbours[one - held].push(other - held);
                neighbours[other - held].push(one - held);
            }
        };
        for (number, line) in network.lines.iter().enumerate() {
            let ends = [line.from, line.to].map(|point| self.points[point]);
            let mut all: Vec<usize> = ends.iter().flat_map(|j| self.unknowns_of(*j)).collect();
            all.extend(self.released[number].iter().flatten());
            for (k, one) in all.iter().enumerate() {
                for other in &all[k + 1..] {
                    join(*one, *other);
                }
            }
        }
        for (origin, rotation) in self.bodies.iter().zip(&self.rotations) {
            for one in self.unknowns_of(*origin) {
                join(one, *rotation);
            }
        }
        for list in &mut neighbours {
            list.sort_unstable();
            list.dedup();
        }
        let order = from_neighbour_to_neighbour(&neighbours);
        self.rows = vec![None; self.roles.len()];
        for (row, joint) in order.iter().enumerate() {
            self.rows[held + joint] = Some(row);
        }
        self.envelope = (0..order.len()).collect();
        for (row, joint) in order.iter().enumerate() {
            for neighbour in &neighbours[*joint] {
                if let Some(column) = self.rows[held + neighbour] {
                    self.envelope[row] = self.envelope[row].min(column);
                }
            }
        }
    }

    /// The joints that a joint moves with: itself, or origin and rotation of its body, or those of what that is pinned to.
    fn unknowns_of(&self, joint: usize) -> Vec<usize> {
        let body = match self.roles[joint] {
            Role::OnBody(body, _) => Some(body),
            Role::Origin(body) => self.carriers[body].map(|(carrier, _)| carrier),
            _ => None,
        };
        let Some(body) = body else {
            return vec![joint];
        };
        let mut all = self.unknowns_of(self.bodies[body]);
        all.push(self.rotations[body]);
        all
    }

    /// The row of a joint among the unknowns; nothing where it is prescribed or carried.
    #[must_use]
    pub fn row(&self, joint: usize) -> Option<usize> {
        self.rows[joint]
    }

    /// How a joint moves with the unknowns.
    #[must_use]
    pub fn follows(&self, joint: usize) -> Follows {
        let on = match self.roles[joint] {
            Role::OnBody(body, at) => Some((body, at)),
            Role::Origin(body) => self.carriers[body],
            _ => None,
        };
        match on {
            Some((body, at)) => match self.rows[self.rotations[body]] {
                Some(_) => Follows::Body(body, at),
                None => Follows::Nothing,
            },
            None => self.rows[joint].map_or(Follows::Nothing, Follows::Row),
        }
    }
}

/// How a joint moves with the unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Follows {
    /// It is prescribed.
    Nothing,
    /// It is the unknown of this row.
    Row(usize),
    /// It is at a place of a body that is free or pinned.
    Body(usize, V3),
}

/// Joints while they are listed.
#[derive(Default)]
struct Roles {
    roles: Vec<Role>,
    points: std::collections::BTreeMap<usize, usize>,
    origins: std::collections::BTreeMap<usize, usize>,
    rotations: std::collections::BTreeMap<usize, usize>,
}

impl Roles {
    fn origin(&mut self, number: usize) {
        self.origins.insert(number, self.roles.len());
        self.roles.push(Role::Origin(number));
    }

    fn rotation(&mut self, number: usize) {
        self.rotations.insert(number, self.roles.len());
        self.roles.push(Role::Rotation(number));
    }

    /// Adds the payouts that are free, or those that are not, and notes their joints.
    fn payouts(&mut self, network: &Network, free: bool, joints: &mut [usize]) {
        for (number, payout) in network.payouts.iter().enumerate() {
            if payout.drive.is_free() == free {
                joints[number] = self.roles.len();
                self.roles.push(Role::Payout(number));
            }
        }
    }

    /// Adds the ends of lines that may be let go; their joints by line and end.
    fn releases(&mut self, network: &Network) -> Vec<[Option<usize>; 2]> {
        let mut released = vec![[None; 2]; network.lines.len()];
        for (line, ends) in released.iter_mut().enumerate() {
            for (end, joint) in ends.iter_mut().enumerate() {
                if network.lines[line].releases[end].is_given() {
                    *joint = Some(self.roles.len());
                    self.roles.push(Role::Released(line, end));
                }
            }
        }
        released
    }
}
