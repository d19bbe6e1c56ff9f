//! Free ends of lines that begin straight: where they are follows from the other end, the length of the line and its direction.

use super::model::{BodyInputs, BodyKind, LineInputs, PointInputs, PointKind, SystemFile};
use super::pose::Pose;
use crate::case::StartShape;
use crate::numerics::V3;

/// Puts the free points and bodies without a position that a line which begins straight leads to where its end is.
pub(super) fn put(file: &mut SystemFile) {
    for number in 0..file.lines.len() {
        let Some((end, place)) = free_end(file, &file.lines[number]) else {
            continue;
        };
        let point = &file.points[&end];
        let on_body = point.body.clone().filter(|_| point.kind == PointKind::Body);
        match on_body {
            None => set(&mut file.points, &end, |of| {
                of.position_m = Some(place.into());
            }),
            Some(name) => {
                let at = V3::from(point.position_m.unwrap_or_default());
                set(&mut file.bodies, &name, |body| {
                    let origin = place - turned(body).arm(&at);
                    body.position_m = Some(origin.into());
                });
            }
        }
    }
}

fn set<T>(
    all: &mut std::collections::BTreeMap<String, T>,
    name: &str,
    change: impl FnOnce(&mut T),
) {
    if let Some(one) = all.get_mut(name) {
        change(one);
    }
}

fn turned(body: &BodyInputs) -> Pose {
    let [roll, pitch, yaw] = [body.roll_deg, body.pitch_deg, body.yaw_deg].map(f64::to_radians);
    Pose::new(V3::zeros(), roll, pitch, yaw)
}

/// The point at the end without a place of a line that begins straight, and where that is \[m\].
fn free_end(file: &SystemFile, line: &LineInputs) -> Option<(String, V3)> {
    let start = line.start.as_ref()?;
    if start.shape != StartShape::Straight {
        return None;
    }
    let places = [&line.from, &line.to].map(|name| place_of(file, name));
    let (sin, cos) = start.elevation_deg.to_radians().sin_cos();
    let (across, along) = start.azimuth_deg.to_radians().sin_cos();
    let way = V3::new(cos * along, cos * across, sin) * length(line)?;
    match places {
        [Some(from), None] if waits(file, &line.to) => Some((line.to.clone(), from + way)),
        [None, Some(to)] if waits(file, &line.from) => Some((line.from.clone(), to - way)),
        _ => None,
    }
}

/// Where a point is \[m\]; nothing where no key says it, and of points on bodies.
fn place_of(file: &SystemFile, name: &str) -> Option<V3> {
    let point: &PointInputs = file.points.get(name)?;
    let place = point.position_m.filter(|_| point.kind != PointKind::Body);
    place.map(V3::from)
}

/// Whether a point is free, or on a free body, without a position.
fn waits(file: &SystemFile, name: &str) -> bool {
    let point = file.points.get(name);
    point.is_some_and(|point| match point.kind {
        PointKind::Free => point.position_m.is_none(),
        PointKind::Body => {
            let body = point.body.as_ref().and_then(|name| file.bodies.get(name));
            body.is_some_and(|body| body.kind == BodyKind::Free && body.position_m.is_none())
        }
        PointKind::Fixed | PointKind::Moved => false,
    })
}

/// Unstretched length \[m\].
fn length(line: &LineInputs) -> Option<f64> {
    let sections = line.sections.iter().map(|section| section.length_m);
    let whole = || sections.sum();
    line.length_m
        .or_else(|| (!line.sections.is_empty()).then(whole))
}
