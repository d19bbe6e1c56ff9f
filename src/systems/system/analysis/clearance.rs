//! Distances of lines from one another, from members of bodies, from bed and surface.

use super::super::equilibrium::SystemEquilibrium;
use super::super::network::{Held, Network};
use super::box_tree::BoxTree;
use super::boxed_curve::BoxedCurve;
use crate::numerics::V3;

/// Points that a line is divided by; the distance of a curve from its chords falls with their square.
const POINTS: u32 = 200;

/// The least distances of a line \[m\].
#[derive(Debug, Clone, PartialEq)]
pub struct LineDistances {
    /// From the nearest line that shares no point with it, and which.
    pub line: Option<(usize, f64)>,
    /// From the nearest body with members that none of its ends is on, and which.
    pub body: Option<(usize, f64)>,
    /// Above the bed.
    pub above_bed: Option<f64>,
    /// Of its highest point below the surface.
    pub below_surface: f64,
}

/// The least distances of every line.
#[must_use]
pub fn distances(network: &Network, rest: &SystemEquilibrium) -> Vec<LineDistances> {
    let curves = boxed(network, rest);
    let boxes = BoxTree::new(&curves);
    let of = |(line, curve): (usize, &BoxedCurve)| {
        let (above_bed, below_surface) = from_bed_and_surface(network, curve.points());
        LineDistances {
            line: nearest_line(network, (&curves, &boxes), line),
            body: from_bodies(network, rest, line, curve),
            above_bed,
            below_surface,
        }
    };
    curves.iter().enumerate().map(of).collect()
}

/// The curves of all lines, each from its end A.
#[must_use]
pub fn curves(network: &Network, rest: &SystemEquilibrium) -> Vec<Vec<V3>> {
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

/// The same with boxes around their parts.
#[must_use]
pub fn boxed(network: &Network, rest: &SystemEquilibrium) -> Vec<BoxedCurve> {
    let curves = curves(network, rest).into_iter();
    curves.map(BoxedCurve::new).collect()
}

/// The nearest of the lines that share no point with a line, the first of several, and its distance \[m\]; nothing where every line does.
#[must_use]
pub fn nearest_line(
    network: &Network,
    (curves, boxes): (&[BoxedCurve], &BoxTree),
    line: usize,
) -> Option<(usize, f64)> {
    let ends = |line: usize| [network.lines[line].from, network.lines[line].to];
    let own = ends(line);
    let mut best: Option<(usize, f64)> = None;
    boxes.visit(&curves[line], &mut |other| {
        let least = best.map_or(f64::INFINITY, |(_, least)| least);
        let joined = ends(other).iter().any(|end| own.contains(end));
        if joined || curves[line].distance_of_boxes(&curves[other]) > least {
            return least;
        }
        // From the first to the second, whichever is asked for: the digits are the same.
        let (one, two) = (line.min(other), line.max(other));
        let distance = curves[one].distance_within(&curves[two], least.next_up());
        let first = |(known, least): (usize, f64)| (distance, other) < (least, known);
        if distance.is_finite() && best.is_none_or(first) {
            best = Some((other, distance));
        }
        best.map_or(f64::INFINITY, |(_, least)| least)
    });
    best
}

/// The least distance of a line from the members of a body that none of its ends is on \[m\], and that body; nothing where no such body
/// has members. Zero where it runs through one; a cone counts with its greater radius.
fn from_bodies(
    network: &Network,
    rest: &SystemEquilibrium,
    line: usize,
    curve: &BoxedCurve,
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
        let from_axis = curve.distance(&BoxedCurve::new(axis.to_vec()));
        let radius = member.radius.0.max(member.radius.1);
        (body, (from_axis - radius).max(0.0))
    });
    distances.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Least height of a line above the bed \[m\], and depth of its highest point below the surface; the bed only where there is one.
fn from_bed_and_surface(network: &Network, curve: &[V3]) -> (Option<f64>, f64) {
    let above_bed = network.bed.as_ref().map(|bed| {
        let heights = curve.iter().map(|place| bed.height(place));
        heights.fold(f64::INFINITY, f64::min).max(0.0)
    });
    let high = curve.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    (above_bed, -high)
}
