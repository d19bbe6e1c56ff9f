//! Where the nodes are at time zero, or a first guess at the equilibrium that the line starts from.

use super::build::SceneError;
use super::line::Segment;
use crate::case::{Case, EndKind, StartShape};
use crate::linalg::V3;
use crate::statics::catenary::{Ends, Line, SectionProps};

/// Positions of the nodes \[m\], and whether they are only a guess at the equilibrium.
pub(super) fn start(
    case: &Case,
    segments: &[Segment],
    weight: &[f64],
    arc: &[f64],
) -> Result<(Vec<V3>, bool), SceneError> {
    let held = |kind| !matches!(kind, EndKind::Payload | EndKind::Free);
    let (a, b) = (&case.ends.a, &case.ends.b);
    let equilibrium = case.start.shape == StartShape::Equilibrium;
    let anchored_at = |position: Option<[f64; 3]>, key: &str| {
        position.map(V3::from).ok_or_else(|| SceneError::Missing {
            key: format!("ends.{key}.position_m"),
            why: "the line must start somewhere",
        })
    };
    let nodes = match (held(a.kind), held(b.kind)) {
        (true, true) => {
            let (from, to) = (
                anchored_at(a.position_m, "a")?,
                anchored_at(b.position_m, "b")?,
            );
            if equilibrium {
                catenary(from, to, segments, arc).unwrap_or_else(|| sagging(from, to, weight, arc))
            } else {
                between(from, to, arc)
            }
        }
        (true, false) if equilibrium => hanging(anchored_at(a.position_m, "a")?, segments, weight),
        (false, true) if equilibrium => {
            let mirrored: Vec<Segment> = segments.iter().rev().copied().collect();
            let loads: Vec<f64> = weight.iter().rev().copied().collect();
            let mut nodes = hanging(anchored_at(b.position_m, "b")?, &mirrored, &loads);
            nodes.reverse();
            nodes
        }
        (false, true) => {
            let to = anchored_at(b.position_m, "b")?;
            let whole = arc[arc.len() - 1];
            arc.iter()
                .map(|s| to - start_direction(case) * (whole - s))
                .collect()
        }
        (_, false) => {
            if equilibrium && !held(a.kind) {
                let key = "start.shape".into();
                let why = "a line that nothing holds has no equilibrium; start it straight";
                return Err(SceneError::Impossible { key, why });
            }
            let from = anchored_at(a.position_m, "a")?;
            arc.iter()
                .map(|s| from + start_direction(case) * *s)
                .collect()
        }
    };
    Ok((nodes, equilibrium))
}

/// Unit vector of a straight start.
fn start_direction(case: &Case) -> V3 {
    direction(
        case.start.azimuth_deg.to_radians(),
        case.start.elevation_deg.to_radians(),
    )
}

/// Unit vector of an azimuth from +x towards +y and an elevation \[rad\].
pub(super) fn direction(azimuth: f64, elevation: f64) -> V3 {
    V3::new(
        azimuth.cos() * elevation.cos(),
        azimuth.sin() * elevation.cos(),
        elevation.sin(),
    )
}

/// On the chord between two held ends, evenly by arc length.
fn between(from: V3, to: V3, arc: &[f64]) -> Vec<V3> {
    let whole = arc[arc.len() - 1];
    arc.iter()
        .map(|s| from + (to - from) * (s / whole))
        .collect()
}

/// The closed-form catenary between two held ends, still water and no bed: a good guess at anything near it.
fn catenary(from: V3, to: V3, segments: &[Segment], arc: &[f64]) -> Option<Vec<V3>> {
    let mut sections: Vec<SectionProps> = Vec::new();
    for segment in segments {
        let length = segment.axial.length;
        let weight = 2.0 * segment.half_weight / length;
        match sections.last_mut() {
            Some(s) if same(s.weight_n_per_m, weight) && same(s.ea_n, segment.axial.ea) => {
                s.length_m += length;
            }
            _ => sections.push(SectionProps::new(length, weight, segment.axial.ea)),
        }
    }
    let ends = Ends::between(from.into(), to.into());
    let line = Line {
        ends,
        sections: &sections,
        bed: None,
        surface_above_a_m: None,
    };
    let solution = line.solve().ok()?;
    let plan = V3::new(to.x - from.x, to.y - from.y, 0.0);
    let along = if ends.x_m > 0.0 {
        plan / ends.x_m
    } else {
        V3::x()
    };
    Some(
        arc.iter()
            .map(|s| {
                let point = solution.at(*s);
                from + along * point.x_m + V3::z() * point.z_m
            })
            .collect(),
    )
}

/// Equal but for rounding: segments of one section come out of the same formulas.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

/// A parabola of about the right length between two held ends, hanging down (up for a buoyant line).
fn sagging(from: V3, to: V3, weight: &[f64], arc: &[f64]) -> Vec<V3> {
    let whole = arc[arc.len() - 1];
    let chord = (to - from).norm();
    let slack = (whole * whole - chord * chord).max(0.0).sqrt();
    // Between the flat parabola's sag, sqrt(3/8 c (L - c)), and that of a line folded double, L/2.
    let sag = 0.43 * slack;
    let down = if weight.iter().sum::<f64>() >= 0.0 {
        -1.0
    } else {
        1.0
    };
    between(from, to, arc)
        .into_iter()
        .zip(arc)
        .map(|(p, s)| {
            let f = s / whole;
            p + V3::z() * (down * sag * 4.0 * f * (1.0 - f))
        })
        .collect()
}

/// Straight down from a held end (up where the load below is buoyant), stretched by the load below.
fn hanging(from: V3, segments: &[Segment], weight: &[f64]) -> Vec<V3> {
    let mut below = vec![0.0; segments.len()];
    let mut load = 0.0;
    for i in (0..segments.len()).rev() {
        load += weight[i + 1];
        below[i] = load;
    }
    let mut nodes = vec![from];
    for (segment, load) in segments.iter().zip(below) {
        let length = segment.axial.length * (1.0 + load.abs() / segment.axial.ea);
        let last = nodes[nodes.len() - 1];
        nodes.push(last - V3::z() * (length * if load >= 0.0 { 1.0 } else { -1.0 }));
    }
    nodes
}
