//! Random systems of lines: whether each is solved or refused with a reason, how exactly, at what cost.
//!
//! Kinds: webs of free points between anchors; a platform on bridled lines; a floating platform; and the nearly singular ones, a
//! free point between two lines in one straight line, weightless points between slack lines, clumps on the bed; buoys whose members come
//! out of the water, and rods, with and without a current.

pub mod divided;
mod in_water;
pub mod refined;

use std::time::{Duration, Instant};

use nalgebra::Matrix6;
use rayon::prelude::*;

use crate::numerics::random::Random;
use crate::numerics::{M3, V3};
use crate::statics::catenary::SectionProperties;
use crate::system::bed::Bed;
use crate::system::network::{
    Body, FreePoint, Held, Line, Network, Point, StatedSection, WEIGHTLESS, reversed, weighted,
};
use crate::system::pose::Pose;
use crate::system::rest::rest;

/// The kinds of random systems, in turn.
pub const KINDS: [&str; 9] = [
    "web of free points",
    "bridled platform",
    "floating platform",
    "two lines in one straight line",
    "weightless points, slack lines",
    "clumps on the bed",
    "shared line between platforms",
    "buoy of members",
    "rods in a row",
];

/// What came of a random system.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomOutcome {
    /// Number of its kind.
    pub kind: usize,
    /// Residual over the greatest tension, and whether it counts as rounding; or why the system is refused.
    pub result: Result<RandomRest, String>,
    /// Wall time.
    pub time: Duration,
}

/// A random system at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RandomRest {
    /// Force out of balance over the greatest tension.
    pub residual: f64,
    /// The same over 8 units in the last place of the positions times the stiffness.
    pub by_rounding: f64,
    /// Newton steps.
    pub steps: usize,
    /// Whether any number of it is not finite.
    pub not_finite: bool,
}

impl RandomRest {
    /// Whether the residual is below 1e-9 of the greatest tension, or that of rounded positions.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        !self.not_finite && (self.residual <= 1e-9 || self.by_rounding <= 1.0)
    }
}

/// Solves so many random systems of a seed, on all cores.
#[must_use]
pub fn run(count: usize, seed: u64) -> Vec<RandomOutcome> {
    let one = |index: usize| {
        let kind = index % KINDS.len();
        let network = network(kind, &mut Random::new(seed, index as u64));
        let begun = Instant::now();
        let result = rest(&network).map_err(|refusal| refusal.problem);
        let time = begun.elapsed();
        let result = result.map(|rest| {
            let balance = &rest.balance;
            let size = rest.placement.points.iter().map(nalgebra::Matrix::amax);
            let size = size.fold(0.0, f64::max);
            let stiffest = balance.stiffness.diagonal().amax();
            let finite = rest.residual.is_finite()
                && rest
                    .placement
                    .points
                    .iter()
                    .all(|p| p.iter().all(|v| v.is_finite()))
                && balance.tension.is_finite();
            // Bodies that float on slack lines balance their weight.
            let weights = network.bodies.iter().map(|body| body.weight);
            let carried = weights.fold(balance.tension, f64::max);
            RandomRest {
                // A system that carries nothing has rounding of nothing.
                residual: if rest.residual <= 1e-100 {
                    0.0
                } else {
                    rest.residual / carried.max(f64::MIN_POSITIVE)
                },
                by_rounding: rest.residual
                    / (8.0 * f64::EPSILON * size * stiffest).max(f64::MIN_POSITIVE),
                steps: rest.steps,
                not_finite: !finite,
            }
        });
        RandomOutcome { kind, result, time }
    };
    (0..count).into_par_iter().map(one).collect()
}

/// A random system of a kind.
#[must_use]
pub fn network(kind: usize, random: &mut Random) -> Network {
    let mut maker = RandomNetworkBuilder {
        random,
        network: Network {
            gravity: 9.806_65,
            density: 1025.0,
            ..Network::default()
        },
        depth: 0.0,
    };
    maker.depth = maker.random.between(20.0, 600.0);
    if kind == 5 || maker.random.uniform() < 0.7 {
        maker.network.bed = Some(Bed::Level(-maker.depth));
    }
    match kind {
        0 => maker.web(),
        1 => maker.platform(false),
        2 => maker.platform(true),
        3 => maker.straight(),
        4 => maker.slack(),
        5 => maker.clumps(),
        6 => maker.shared(),
        7 => maker.buoy(),
        _ => maker.rods(),
    }
    maker.network
}

struct RandomNetworkBuilder<'a> {
    random: &'a mut Random,
    network: Network,
    depth: f64,
}

impl RandomNetworkBuilder<'_> {
    fn point(&mut self, held: Held) -> usize {
        let name = format!("p{}", self.network.points.len());
        self.network.points.push(Point {
            name,
            held,
            motion: None,
        });
        self.network.points.len() - 1
    }

    fn place(&mut self, radius: f64) -> V3 {
        let (x, y) = (
            self.random.between(-radius, radius),
            self.random.between(-radius, radius),
        );
        V3::new(x, y, -self.random.between(0.02, 0.98) * self.depth)
    }

    fn free(&mut self, mass: f64, volume: f64) -> usize {
        let (gravity, density) = (self.network.gravity, self.network.density);
        self.point(Held::Free(FreePoint {
            weight: mass * gravity,
            buoyancy: volume * density * gravity,
            ..FreePoint::default()
        }))
    }

    /// A free point with nothing, a clump or a buoy.
    fn junction(&mut self) -> usize {
        match self.random.whole(0, 3) {
            0 | 1 => self.free(0.0, 0.0),
            2 => {
                let mass = 10_f64.powf(self.random.between(1.0, 5.0));
                self.free(mass, 0.2 * mass / 1025.0)
            }
            _ => {
                let mass = 10_f64.powf(self.random.between(1.0, 4.5));
                let more = self.random.between(1.5, 8.0);
                self.free(mass, more * mass / 1025.0)
            }
        }
    }

    /// Chain, rope, or something buoyant, of this length.
    fn section(&mut self, length: f64) -> SectionProperties {
        let strength = 10_f64.powf(self.random.between(5.5, 9.3));
        let weight = match self.random.whole(0, 5) {
            0 => -self.random.between(1.0, 300.0),
            1 => 0.0,
            2 | 3 => self.random.between(5.0, 200.0),
            _ => self.random.between(200.0, 4000.0),
        };
        SectionProperties::new(length, weight, strength)
    }

    fn line(&mut self, from: usize, to: usize, sections: Vec<SectionProperties>) {
        let stated = |section: &SectionProperties| StatedSection {
            length_m: section.length_m,
            ..StatedSection::default()
        };
        let name = format!("l{}", self.network.lines.len());
        let sections = weighted(sections, WEIGHTLESS);
        let rough = self.random.whole(0, 2) == 0;
        let friction = if rough {
            self.random.between(0.0, 1.0)
        } else {
            0.0
        };
        self.network.lines.push(Line {
            closed_where_known: false,
            displaced: Vec::new(),
            displaced_reversed: Vec::new(),
            name,
            from,
            to,
            reversed: reversed(&sections),
            added_weight: 0.0,
            parts: sections.iter().map(stated).collect(),
            bodies: Vec::new(),
            sections,
            clamps: [None; 2],
            still_water: false,
            bed_contact: true,
            friction,
            friction_lateral: friction,
            releases: Default::default(),
            start: None,
            discretised: None,
        });
    }

    /// A line of one to three sections between points that are so far apart.
    fn between_points(&mut self, from: usize, to: usize, distance: f64) {
        let length = distance.max(1.0) * self.random.between(0.97, 1.5);
        let n = [1, 1, 1, 2, 3][self.random.whole(0, 4)];
        let mut sections: Vec<SectionProperties> =
            (0..n).map(|_| self.section(length / n as f64)).collect();
        for section in sections.iter_mut().take(n - 1) {
            if self.random.uniform() < 0.2 {
                section.clump_n = self.random.between(-2e4, 4e4);
            }
        }
        self.line(from, to, sections);
    }

    /// Anchors and free points joined at random, every free point twice or more.
    fn web(&mut self) {
        let radius = self.random.between(0.3, 2.0) * self.depth;
        let (held, free) = (self.random.whole(2, 5), self.random.whole(1, 6));
        let mut places = Vec::new();
        for _ in 0..held {
            let place = self.place(radius);
            places.push(place);
            self.point(Held::At(place));
        }
        for index in held..held + free {
            places.push(self.place(radius));
            let point = self.junction();
            for _ in 0..self.random.whole(2, 3) {
                let other = self.random.whole(0, index - 1);
                let distance = (places[other] - places[index]).norm();
                self.between_points(other, point, distance);
            }
        }
    }

    fn body(&mut self, name: &str, origin: V3, free: bool) -> usize {
        let mass = 10_f64.powf(self.random.between(5.5, 7.5));
        let g = self.network.gravity;
        let area = self.random.between(50.0, 800.0);
        let spring = 1025.0 * g * area;
        let roll = spring * self.random.between(5.0, 400.0);
        let body = Body {
            name: name.to_owned(),
            pose: Pose::new(origin, 0.0, 0.0, self.random.uniform()),
            free,
            mass,
            weight: mass * g,
            centre_of_gravity: V3::new(0.0, 0.0, -self.random.uniform() * 10.0),
            inertia: M3::identity() * mass * 100.0,
            buoyancy: mass * g * self.random.between(1.0, 1.1),
            centre_of_buoyancy: V3::new(0.0, 0.0, -self.random.uniform() * 5.0),
            waterplane: Matrix6::from_diagonal(&nalgebra::vector![
                0.0, 0.0, spring, roll, roll, 0.0
            ]),
            added_mass: Matrix6::zeros(),
            load: if free {
                V3::new(
                    self.random.between(-1e6, 1e6),
                    self.random.between(-1e6, 1e6),
                    0.0,
                )
            } else {
                V3::zeros()
            },
            ..Body::default()
        };
        self.network.bodies.push(body);
        self.network.bodies.len() - 1
    }

    /// A platform on three to six lines, some of them split in two.
    fn platform(&mut self, free: bool) {
        let body = self.body("platform", V3::zeros(), free);
        let (count, far) = (
            self.random.whole(3, 6),
            self.random.between(1.5, 5.0) * self.depth,
        );
        let (near, deep) = (
            self.random.between(3.0, 40.0),
            -self.random.between(2.0, 15.0),
        );
        for k in 0..count {
            let angle =
                std::f64::consts::TAU * (k as f64 + 0.3 * self.random.uniform()) / count as f64;
            let towards = V3::new(angle.cos(), angle.sin(), 0.0);
            let anchor = self.point(Held::At(towards * far - V3::z() * self.depth));
            let distance = (far - near).hypot(self.depth + deep);
            if self.random.uniform() < 0.3 {
                let junction = self.junction();
                self.between_points(anchor, junction, 0.8 * distance);
                for side in [-1.0, 1.0] {
                    let place =
                        towards * near + V3::new(-towards.y, towards.x, 0.0) * side * 0.5 * near;
                    let fairlead = self.point(Held::On(body, place + V3::z() * deep));
                    self.between_points(junction, fairlead, 0.22 * distance);
                }
            } else {
                let fairlead = self.point(Held::On(body, towards * near + V3::z() * deep));
                self.between_points(anchor, fairlead, distance);
            }
        }
    }

    /// A free point between two taut lines in one straight line, with or without anything on it.
    fn straight(&mut self) {
        let (a, b) = (self.place(100.0), self.place(100.0));
        let share = self.random.between(0.1, 0.9);
        let stretch = 1.0 - 10_f64.powf(self.random.between(-6.0, -2.0));
        let (from, to) = (self.point(Held::At(a)), self.point(Held::At(b)));
        let middle = if self.random.uniform() < 0.5 {
            self.free(0.0, 0.0)
        } else {
            self.junction()
        };
        let weightless = self.random.uniform() < 0.5;
        for (one, two, part) in [(from, middle, share), (middle, to, 1.0 - share)] {
            let mut section = self.section((b - a).norm() * part * stretch);
            if weightless {
                section.weight_n_per_m = 0.0;
            }
            self.line(one, two, vec![section]);
        }
    }

    /// Points without weight in a row of slack lines.
    fn slack(&mut self) {
        let (a, b) = (self.place(100.0), self.place(100.0));
        let count = self.random.whole(1, 4);
        let mut before = self.point(Held::At(a));
        let end = self.point(Held::At(b));
        let each = (b - a).norm() / (count + 1) as f64;
        for _ in 0..count {
            let next = self.free(0.0, 0.0);
            let more = self.random.between(1.0, 2.0);
            let mut section = self.section(each * more);
            if self.random.uniform() < 0.4 {
                section.weight_n_per_m = 0.0;
            }
            self.line(before, next, vec![section]);
            before = next;
        }
        let more = self.random.between(1.0, 2.0);
        let section = self.section(each * more);
        self.line(before, end, vec![section]);
    }

    /// Heavy points that come down to the bed.
    fn clumps(&mut self) {
        let radius = self.random.between(0.5, 3.0) * self.depth;
        let below = V3::new(0.0, 0.0, -self.random.uniform());
        let top = self.point(Held::At(below));
        for _ in 0..self.random.whole(1, 3) {
            let angle = std::f64::consts::TAU * self.random.uniform();
            let away = V3::new(angle.cos(), angle.sin(), 0.0) * radius;
            let anchor = self.point(Held::At(away - V3::z() * self.depth));
            let mass = 10_f64.powf(self.random.between(3.0, 6.0));
            let clump = self.free(mass, 0.3 * mass / 1025.0);
            self.between_points(anchor, clump, 0.5 * radius);
            self.between_points(clump, top, (0.5 * radius).hypot(self.depth));
        }
    }

    /// Two platforms with lines of their own and one between them.
    fn shared(&mut self) {
        let apart = self.random.between(1.0, 4.0) * self.depth;
        let free = self.random.uniform() < 0.5;
        let bodies = [-0.5, 0.5].map(|side| {
            let name = if side < 0.0 { "west" } else { "east" };
            self.body(name, V3::new(side * apart, 0.0, 0.0), free)
        });
        for (body, side) in bodies.into_iter().zip([-1.0, 1.0]) {
            self.network.bodies[body].pose =
                Pose::new(V3::new(0.5 * side * apart, 0.0, 0.0), 0.0, 0.0, 0.0);
            for across in [-1.0, 1.0] {
                let out = V3::new(side, across, 0.0) * self.depth;
                let origin = V3::new(0.5 * side * apart, 0.0, 0.0);
                let anchor = self.point(Held::At(origin + out - V3::z() * self.depth));
                let place = V3::new(side, across, 0.0) * 8.0 - V3::z() * 10.0;
                let fairlead = self.point(Held::On(body, place));
                let distance = (out - V3::z() * (self.depth - 10.0)).norm();
                self.between_points(anchor, fairlead, distance);
            }
        }
        let ends = [(bodies[0], 8.0), (bodies[1], -8.0)]
            .map(|(body, x)| self.point(Held::On(body, V3::new(x, 0.0, -10.0))));
        self.between_points(ends[0], ends[1], apart - 16.0);
    }
}
