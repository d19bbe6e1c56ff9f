//! Points, and the ends of rods that lines are attached to.

use super::case_text::{CaseText, number, numbers, text};
use super::context::{Context, is_in_air};
use super::start::is_dropped;
use crate::import::mooring::{Attachment, Given, Hold, MooringPoint, Rod};

/// The name of what an end of a line is attached to.
#[must_use]
pub fn name_of(context: &Context<'_>, end: Attachment) -> String {
    match end {
        Attachment::Point(point) => context.names.points[point].clone(),
        Attachment::Rod(rod, _) if context.mooring.rods[rod].is_joint() => {
            context.names.rods[rod].clone()
        }
        Attachment::Rod(rod, end) => context.names.rod_end(rod, end),
        // Its lines are one, which does not end here.
        Attachment::Inside(_) => String::new(),
    }
}

/// Writes the points that lines end at.
pub fn write(case: &mut CaseText<'_>, context: &Context<'_>) {
    for (number_of, point) in context.mooring.points.iter().enumerate() {
        // Without lines points say where places of bodies are.
        let is_place =
            context.mooring.lines.is_empty() && matches!(point.hold.value, Hold::Body(_));
        let is_written = is_place || is_dropped(context, number_of);
        if is_written || context.is_used(Attachment::Point(number_of)) {
            let header = format!("[points.{}]", context.names.points[number_of]);
            case.table(&header, Some(&point.span));
            one_point(case, context, number_of, point);
        }
    }
    for (number_of, rod) in context.mooring.rods.iter().enumerate() {
        let is_point = rod.is_joint() && !context.joints.is_inside(context.mooring, number_of);
        if is_point && context.is_used_rod(number_of) {
            let header = format!("[points.{}]", context.names.rods[number_of]);
            case.table(&header, Some(&rod.span));
            let place = rod.ends[0].clone();
            held(case, context, &rod.hold, &place, None);
            load(case, rod);
        } else if let Hold::Body(body) = rod.hold.value {
            on_body(case, context, number_of, rod, body);
        }
    }
}

/// The steady loads on a joint that nothing holds.
fn load(case: &mut CaseText<'_>, rod: &Rod) {
    let whole = rod.load();
    if let Some(load) = rod.loads.first()
        && rod.hold.value == Hold::Free
        && whole != [0.0; 3]
    {
        case.given("load_n", &numbers(&whole), &load.span, "Fext");
    }
}

/// The ends of a rod on a body.
fn on_body(
    case: &mut CaseText<'_>,
    context: &Context<'_>,
    number_of: usize,
    rod: &Rod,
    body: usize,
) {
    for end in 0..2 {
        if !context.is_used(Attachment::Rod(number_of, end)) {
            continue;
        }
        let header = format!("[points.{}]", context.names.rod_end(number_of, end));
        case.table(&header, Some(&rod.span));
        case.line("kind = \"body\"", None);
        let name = text(&context.names.bodies[body]);
        case.given("body", &name, &rod.hold.span, "Attachment");
        let place = numbers(&rod.end(end));
        case.given("position_m", &place, &rod.ends[end][0].span, "");
    }
}

fn one_point(
    case: &mut CaseText<'_>,
    context: &Context<'_>,
    number_of: usize,
    point: &MooringPoint,
) {
    held(case, context, &point.hold, &point.place, Some(number_of));
    if point.hold.value != Hold::Free {
        return;
    }
    let mut one = |key: &str, given: &Given<f64>, column: &str| {
        if given.value != 0.0 {
            case.given(key, &number(given.value), &given.span, column);
        }
    };
    one("mass_kg", &point.mass, "Mass");
    one("volume_m3", &point.volume, "Volume");
    let added = point.added_mass.value * point.volume.value * context.sea.density;
    let added = Given::new(added, point.added_mass.span.clone());
    one("added_mass_kg", &added, "Ca on the volume");
    one("drag_area_m2", &point.drag_area, "CdA");
    let load: Vec<f64> = point.load.iter().map(|given| given.value).collect();
    if load.iter().any(|part| *part != 0.0) {
        case.given("load_n", &numbers(&load), &point.load[0].span, "FX FY FZ");
    }
}

/// What holds a point, and where it is.
fn held(
    case: &mut CaseText<'_>,
    context: &Context<'_>,
    hold: &Given<Hold>,
    place: &[Given<f64>; 3],
    number_of: Option<usize>,
) {
    let mut here: Vec<f64> = place.iter().map(|given| given.value).collect();
    if here[2] == f64::NEG_INFINITY {
        // MAP++: on the bed.
        here[2] = -context.sea.depth.unwrap_or(0.0);
    }
    let leaves = hold.value == Hold::Free && here[2] > 0.0 && !is_in_air(context.mooring);
    if leaves {
        here[2] = 0.0;
    }
    let vessel = context.has_vessel && hold.value == Hold::Coupled;
    let on_body = matches!(hold.value.base(), Hold::Body(_));
    let (kind, body) = match if on_body {
        hold.value.base()
    } else {
        &hold.value
    } {
        Hold::Free => ("free", None),
        Hold::Body(body) => ("body", Some(&context.names.bodies[*body])),
        Hold::Coupled if vessel => ("body", Some(&context.names.vessel)),
        // Without a motion it stays where it is.
        Hold::Coupled => ("moved", None),
        Hold::Fixed | Hold::Pinned(_) => ("fixed", None),
    };
    case.given("kind", &text(kind), &hold.span, "Attachment");
    if let Some(body) = body {
        case.given("body", &text(body), &hold.span, "");
    }
    let what = match leaves {
        true => "X Y Z; its search begins at the surface",
        false => "X Y Z",
    };
    // Most that can be wrong with a place is its height.
    case.given("position_m", &numbers(&here), &place[2].span, what);
    if kind == "moved"
        && context.motion.moves()
        && let Some(number_of) = number_of
    {
        context.motion.write_point(case, number_of);
    }
}
