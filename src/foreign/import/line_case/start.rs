//! Where a line that does not begin at rest begins: its shape, its free ends, its velocity.

use super::copied::copy_keys;
use super::source::{LETTERS, LineSource};
use crate::case::{EndKind, StartShape};
use crate::import::to_case::case_text::{CaseText, text};

/// Keys of the start that the points of the system, or its search for an equilibrium, have in their place.
const OF_POINTS: [&str; 2] = ["azimuth_deg", "elevation_deg"];
const OF_SHAPES: [&str; 5] = ["shape", "arc_m", "x_m", "y_m", "z_m"];

/// Whether the line begins in a shape in the place of an equilibrium.
pub(super) fn is_in_shape(source: &LineSource<'_>) -> bool {
    source.is_in_time() && source.case.start.shape != StartShape::Equilibrium
}

/// Whether it begins with a velocity.
pub(super) fn is_moving(source: &LineSource<'_>) -> bool {
    source.is_in_time() && source.case.start.velocity_m_per_s != [0.0; 3]
}

/// Whether the search for the equilibrium of its system begins at coordinates, which a closed form needs none of.
pub(super) fn is_searched_from(source: &LineSource<'_>) -> bool {
    let start = &source.case.start;
    let is_open = source.bends() || source.case.current.is_some();
    is_open && start.arc_m.is_some() && !is_in_shape(source)
}

/// Writes how the line begins.
pub(super) fn of_line(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let (in_shape, moving) = (is_in_shape(source), is_moving(source));
    let searched = is_searched_from(source);
    let begins = in_shape || moving || searched;
    let Some(node) = source.node(&["start"]).filter(|_| begins) else {
        return;
    };
    let mut without = match follows_from_length(source) {
        true => Vec::new(),
        false => OF_POINTS.to_vec(),
    };
    if searched {
        // Given coordinates begin the search of a case at rest, too.
        without.push("shape");
    } else if !in_shape {
        without.extend(OF_SHAPES);
    }
    if !source.is_in_time() {
        without.push("velocity_m_per_s");
    }
    system.table("[lines.start]", Some(&node.span));
    copy_keys(system, source, node, &without);
}

/// Writes that free ends begin where they are put.
pub(super) fn of_ends(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let ends = [&source.case.ends.a, &source.case.ends.b];
    let free = ends.iter().any(|end| !is_held(end.kind));
    if free && is_in_shape(source) {
        system.table("[start]", source.span(&["start"]));
        system.line(&format!("placement = {}", text("given")), None);
    }
}

/// Whether the line begins straight from a held end to one that is free, whose place follows from the length of the line.
pub(super) fn follows_from_length(source: &LineSource<'_>) -> bool {
    let ends = &source.case.ends;
    let is_straight = source.case.start.shape == StartShape::Straight;
    let is_led = is_held(ends.a.kind) != is_held(ends.b.kind);
    is_in_shape(source) && is_straight && is_led && source.case.traveller.is_none()
}

/// Where a free end of a line in a shape begins \[m\], by its letter.
pub(super) fn place(source: &LineSource<'_>, letter: &str) -> [f64; 3] {
    let (case, start) = (&source.case, &source.case.start);
    if start.shape != StartShape::Straight && start.arc_m.is_some() {
        let end = |list: &Option<Vec<f64>>| {
            let list = list.as_deref().unwrap_or_default();
            let value = if letter == LETTERS[0] {
                list.first()
            } else {
                list.last()
            };
            value.copied().unwrap_or_default()
        };
        return [end(&start.x_m), end(&start.y_m), end(&start.z_m)];
    }
    let length: f64 = case.line.iter().map(|section| section.length_m).sum();
    let (sin, cos) = start.elevation_deg.to_radians().sin_cos();
    let (across, along) = start.azimuth_deg.to_radians().sin_cos();
    let way = [cos * along, cos * across, sin].map(|part| part * length);
    let (a, b) = (&case.ends.a, &case.ends.b);
    let from = |place: Option<[f64; 3]>, sign: f64| {
        let place = place.unwrap_or_default();
        std::array::from_fn(|axis| place[axis] + sign * way[axis])
    };
    match letter == LETTERS[0] {
        // Only a held end B says where a free end A is.
        true if is_held(b.kind) => from(b.position_m, -1.0),
        true => a.position_m.unwrap_or_default(),
        false => from(a.position_m, 1.0),
    }
}

const fn is_held(kind: EndKind) -> bool {
    !matches!(kind, EndKind::Free | EndKind::Payload)
}
