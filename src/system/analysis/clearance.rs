//! Distances of lines from one another, from members of bodies, from bed and surface.

use super::super::equilibrium::Equilibrium;
use super::super::network::{Held, Network};
use crate::numerics::V3;

/// Points that a line is divided by; the distance of a curve from its chords falls with their square.
const POINTS: u32 = 200;

/// Two lines where they are nearest.
#[derive(Debug, Clone, PartialEq)]
pub struct LineClearance {
    /// Numbers of the lines.
    pub lines: (usize, usize),
    /// Least distance of their axes \[m\].
    pub distance_m: f64,
    /// Where on the first and on the second \[m\].
    pub at: (V3, V3),
}

/// The least distances of a line \[m\].
#[derive(Debug, Clone, PartialEq)]
pub struct LineDistances {
    /// From the nearest line that shares no point with it, and which.
    pub line: Option<(usize, f64)>,
    /// From the nearest body with members that none of its ends is on, and which.
    pub body: Option<(usize, f64)>,
    /// Of its lowest point above the bed.
    pub above_bed: Option<f64>,
    /// Of its highest point below the surface.
    pub below_surface: f64,
}

/// The least distances of every line.
#[must_use]
pub fn distances(network: &Network, rest: &Equilibrium) -> Vec<LineDistances> {
    let pairs = between_lines(network, rest);
    let curves = curves(network, rest);
    let of = |(line, curve): (usize, &Vec<V3>)| {
        let mut with = pairs
            .iter()
            .filter(|pair| pair.lines.0 == line || pair.lines.1 == line);
        let nearest = with.next().map(|pair| {
            let other = if pair.lines.0 == line {
                pair.lines.1
            } else {
                pair.lines.0
            };
            (other, pair.distance_m)
        });
        let (above_bed, below_surface) = from_bed_and_surface(network, curve);
        LineDistances {
            line: nearest,
            body: from_bodies(network, rest, line, curve),
            above_bed,
            below_surface,
        }
    };
    curves.iter().enumerate().map(of).collect()
}

/// The curves of all lines, each from its end A.
#[must_use]
pub fn curves(network: &Network, rest: &Equilibrium) -> Vec<Vec<V3>> {
    let places = &rest.placement.points;
    let lines = network.lines.iter().zip(&rest.balance.lines);
    lines
        .map(|(line, at_rest)| {
            let ends = [&places[line.from], &places[line.to]];
            (0..=POINTS)
                .map(|k| at_rest.at(f64::from(k) / f64::from(POINTS), ends).0)
                .collect()
        })
        .collect()
}

/// The least distance of every two lines that share no point, the nearest first.
#[must_use]
pub fn between_lines(network: &Network, rest: &Equilibrium) -> Vec<LineClearance> {
    let curves = curves(network, rest);
    let mut found = Vec::new();
    for (i, one) in network.lines.iter().enumerate() {
        for (j, two) in network.lines.iter().enumerate().skip(i + 1) {
            let joined = [one.from, one.to]
                .iter()
                .any(|end| [two.from, two.to].contains(end));
            if !joined {
                let (distance_m, at) = least(&curves[i], &curves[j]);
                found.push(LineClearance {
                    lines: (i, j),
                    distance_m,
                    at,
                });
            }
        }
    }
    found.sort_by(|a, b| a.distance_m.total_cmp(&b.distance_m));
    found
}

/// The least distance of two polylines and where.
fn least(one: &[V3], two: &[V3]) -> (f64, (V3, V3)) {
    let mut best = (f64::INFINITY, (V3::zeros(), V3::zeros()));
    for a in one.windows(2) {
        let half = 0.5 * (a[1] - a[0]).norm();
        let middle = 0.5 * (a[0] + a[1]);
        for b in two.windows(2) {
            let apart = (0.5 * (b[0] + b[1]) - middle).norm() - half - 0.5 * (b[1] - b[0]).norm();
            if apart >= best.0 {
                continue;
            }
            let (p, q) = nearest(a, b);
            let distance = (p - q).norm();
            if distance < best.0 {
                best = (distance, (p, q));
            }
        }
    }
    best
}

/// The nearest points of two straight segments (Ericson, *Real-Time Collision Detection*, 2005, sec. 5.1.9).
fn nearest(a: &[V3], b: &[V3]) -> (V3, V3) {
    let (d1, d2, r) = (a[1] - a[0], b[1] - b[0], a[0] - b[0]);
    let (aa, e, f) = (d1.norm_squared(), d2.norm_squared(), d2.dot(&r));
    let tiny = f64::MIN_POSITIVE;
    let (mut s, t);
    if aa <= tiny {
        s = 0.0;
        t = if e > tiny {
            (f / e).clamp(0.0, 1.0)
        } else {
            0.0
        };
    } else {
        let c = d1.dot(&r);
        let (cross, free) = (d1.dot(&d2), if e > tiny { f / e } else { 0.0 });
        let det = aa * e - cross * cross;
        s = if det > tiny {
            ((cross * f - c * e) / det).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let along = if e > tiny { (cross * s + f) / e } else { free };
        t = along.clamp(0.0, 1.0);
        if t != along {
            s = ((t * cross - c) / aa).clamp(0.0, 1.0);
        }
    }
    (a[0] + d1 * s, b[0] + d2 * t)
}

/// The least distance of a line from the members of a body that none of its ends is on \[m\], and that body; nothing where no such body
/// has members. Zero where it runs through one; a cone counts with its greater radius.
fn from_bodies(
    network: &Network,
    rest: &Equilibrium,
    line: usize,
    curve: &[V3],
) -> Option<(usize, f64)> {
    let ends = [network.lines[line].from, network.lines[line].to];
    let is_on = |body: usize| {
        ends.iter()
            .any(|end| matches!(network.points[*end].held, Held::On(on, _) if on == body))
    };
    let others = network.bodies.iter().enumerate();
    let others = others.filter(|(body, _)| !is_on(*body));
    let members = others.flat_map(|(body, given)| given.members.iter().map(move |m| (body, m)));
    let distances = members.map(|(body, member)| {
        let pose = &rest.placement.bodies[body];
        let axis = [member.from, member.to].map(|end| pose.origin + pose.arm(&end));
        let (from_axis, _) = least(curve, &axis);
        let radius = member.radius.0.max(member.radius.1);
        (body, (from_axis - radius).max(0.0))
    });
    distances.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Height of the lowest point of a line above the bed \[m\], and depth of its highest below the surface; the bed only where there is one.
fn from_bed_and_surface(network: &Network, curve: &[V3]) -> (Option<f64>, f64) {
    let low = curve.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
    let high = curve.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    (network.bed_z.map(|bed| (low - bed).max(0.0)), -high)
}
