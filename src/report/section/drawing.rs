//! A section drawn: every unit and wire at its place, to scale.
//!
//! It is a [`Chart`] like any other, so the screen can zoom and pan it. A unit laid at an angle is
//! cut aslant, so its outline is an ellipse, longer around the cable than across.

use std::f64::consts::TAU;

use seacable_display::chart::{Axis, Chart, Outline, Series};
use seacable_model::section::{CableElement, Design, Helix, LaidLayer};

/// Corners of an outline that is drawn as a circle.
const CORNERS: u32 = 72;

/// The section as a chart, in millimetres, equal in both directions.
#[must_use]
pub fn chart(design: &Design) -> Chart {
    let reach = 1.03e3 * design.layout.outer_radius;
    let axis = |name: &str| Axis::new(name, "mm").over((-reach, reach));
    let title = &design.section.about.title;
    Chart {
        equal_scale: true,
        ..Chart::new(title, axis("x"), axis("y"), series(design))
    }
}

fn series(design: &Design) -> Vec<Series> {
    let mut outlines: Vec<(String, Outline)> = Vec::new();
    if let Some(centre) = &design.layout.centre {
        let mut points = unit(&centre.element, 0.0, 0.0, 1.0);
        if centre.radius > centre.element.radius {
            points.extend(ellipse(0.0, 0.0, centre.radius, centre.radius));
        }
        outlines.push((format!("centre: {}", centre.element.name), points));
    }
    for shell in &design.layout.shells {
        match shell {
            LaidLayer::Helix(helix) => outlines.extend(layer(helix)),
            LaidLayer::Tube(tube) => {
                let mut points = ellipse(0.0, 0.0, tube.inner_radius, tube.inner_radius);
                points.extend(ellipse(0.0, 0.0, tube.outer_radius, tube.outer_radius));
                outlines.push((tube.input.name.clone(), points));
            }
        }
    }
    let numbered = outlines.into_iter().enumerate();
    numbered
        .map(|(slot, (label, points))| Series::new(&label, slot, points))
        .collect()
}

/// The outlines of a layer, one set for each kind of unit.
fn layer(helix: &Helix) -> Vec<(String, Outline)> {
    let mut kinds: Vec<(&str, usize, Outline)> = Vec::new();
    let stretch = 1.0 / helix.angle.cos();
    for (element, place) in helix.elements.iter().zip(&helix.places) {
        let points = unit(element, helix.pitch_radius, *place, stretch);
        if let Some(kind) = kinds.iter_mut().find(|kind| kind.0 == element.name) {
            kind.1 += 1;
            kind.2.extend(points);
        } else {
            kinds.push((&element.name, 1, points));
        }
    }
    let named = kinds.into_iter().map(|(name, count, points)| {
        let label = if helix.armour {
            format!("{}: {count} wires", helix.name)
        } else {
            format!("{}: {count} {name}", helix.name)
        };
        (label, points)
    });
    named.collect()
}

/// The outline of a unit at a place of its layer, and that of its bore.
fn unit(element: &CableElement, pitch_radius: f64, place: f64, stretch: f64) -> Outline {
    let mut points = ellipse(
        pitch_radius,
        place,
        element.radius,
        element.radius * stretch,
    );
    if element.bore_radius > 0.0 {
        let bore = element.bore_radius;
        points.extend(ellipse(pitch_radius, place, bore, bore * stretch));
    }
    points
}

/// A closed outline \[mm\] about a point at this distance and angle, so thick across and around;
/// what is not a number ends it.
fn ellipse(distance: f64, place: f64, across: f64, around: f64) -> Outline {
    // The first unit lies at the top.
    let (sin, cos) = (0.25 * TAU - place).sin_cos();
    let corner = |i: u32| {
        let (s, c) = (TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
        let (out, along) = (distance + across * c, around * s);
        (
            1e3 * (out * cos - along * sin),
            1e3 * (out * sin + along * cos),
        )
    };
    let mut points: Outline = (0..=CORNERS).map(corner).collect();
    points.push((f64::NAN, f64::NAN));
    points
}
