//! Bodies and rods.

use super::case_text::{CaseText, number, numbers, text};
use super::context::Context;
use crate::import::mooring::{
    BodyLoad, Given, Hold, MooringBody, MooringPoint, Program, Rod, RodType,
};
use crate::numerics::V3;
use crate::system::pose::Pose;

/// Mass, centre of gravity and inertia about it.
struct MassOf {
    mass: f64,
    centre: V3,
    inertia: nalgebra::Matrix3<f64>,
}

/// Writes the bodies, with the rods on them, and the body that coupled points are on.
pub fn write(case: &mut CaseText<'_>, context: &Context<'_>) {
    if context.has_vessel {
        case.table(&format!("[bodies.{}]", context.names.vessel), None);
        let what = match context.mooring.program {
            Program::Raft | Program::Ontology | Program::FaModel => "The platform",
            _ => "What MoorDyn is coupled to",
        };
        let comment = format!("# {what}, as one rigid body; its origin is that of the file.");
        case.line(&comment, None);
        let kind = kind_of(&Hold::Coupled, context);
        case.line(&format!("kind = {kind}"), None);
        context.motion.write_vessel(case);
    }
    for (number, body) in context.mooring.bodies.iter().enumerate() {
        let header = format!("[bodies.{}]", context.names.bodies[number]);
        case.table(&header, Some(&body.span));
        one_body(case, context, number, body);
    }
}

/// The word for what holds a body or rod.
fn kind_of(hold: &Hold, context: &Context<'_>) -> &'static str {
    match hold {
        Hold::Free => "\"free\"",
        Hold::Pinned(_) => "\"pinned\"",
        Hold::Coupled if context.motion.moves() => "\"moved\"",
        _ => "\"held\"",
    }
}

fn one_body(case: &mut CaseText<'_>, context: &Context<'_>, number_of: usize, body: &MooringBody) {
    let kind = kind_of(&body.hold.value, context);
    case.given("kind", kind, &body.hold.span, "Attachment");
    let place: Vec<f64> = body.place.iter().map(|given| given.value).collect();
    case.given(
        "position_m",
        &numbers(&place),
        &body.place[0].span,
        "X0 Y0 Z0",
    );
    let keys = ["roll_deg", "pitch_deg", "yaw_deg"];
    for ((key, angle), given) in keys.iter().zip(yaw_first(body)).zip(&body.angles) {
        if angle != 0.0 {
            case.given(key, &number(angle), &given.span, "r0 p0 y0");
        }
    }
    if body.hold.value.is_coupled() {
        let is_pinned = body.hold.value != Hold::Coupled;
        context.motion.write_body(case, number_of, is_pinned);
    }
    let rods: Vec<(usize, &Rod)> = rods_on(context, number_of);
    if body.hold.value.turns() {
        let points = points_on(context, number_of);
        inertia(case, context, body, (&rods, &points));
        water(case, context, body, &points);
    }
    for (_, rod) in &rods {
        let header = format!("[[bodies.{}.members]]", context.names.bodies[number_of]);
        case.table(&header, Some(&rod.span));
        case.given(
            "from_m",
            &numbers(&rod.end(0)),
            &rod.ends[0][0].span,
            "Xa Ya Za",
        );
        case.given(
            "to_m",
            &numbers(&rod.end(1)),
            &rod.ends[1][0].span,
            "Xb Yb Zb",
        );
        rod_water(case, &context.mooring.rod_types[rod.of_type.value]);
    }
}

/// The angles of a body \[deg\] in the order of a case: yaw first, where `MoorDyn` has roll first.
fn yaw_first(body: &MooringBody) -> [f64; 3] {
    let given = body.angles.each_ref().map(|angle| angle.value);
    // One angle alone is the same in every order.
    if given.iter().filter(|angle| **angle != 0.0).count() < 2 {
        return given;
    }
    let pose = Pose::of_roll_first(V3::zeros(), given.map(f64::to_radians));
    pose.angles().map(f64::to_degrees)
}

/// The rods on a body that have a length.
fn rods_on<'m>(context: &Context<'m>, body: usize) -> Vec<(usize, &'m Rod)> {
    let rods = context.on_bodies[body].rods.iter();
    rods.map(|rod| (*rod, &context.mooring.rods[*rod]))
        .collect()
}

/// The points on a body, whose mass and volume MoorDyn adds to those of the body.
fn points_on<'m>(context: &Context<'m>, body: usize) -> Vec<&'m MooringPoint> {
    let points = context.on_bodies[body].points.iter();
    points
        .map(|point| &context.mooring.points[*point])
        .collect()
}

/// The place of a point \[m\], of one on a body in the frame of the body.
fn place_of(point: &MooringPoint) -> V3 {
    V3::from(point.place.each_ref().map(|given| given.value))
}

/// Mass, centre of gravity, moments of inertia of a body and of the rods and points on it.
fn inertia(
    case: &mut CaseText<'_>,
    context: &Context<'_>,
    body: &MooringBody,
    (rods, points): (&[(usize, &Rod)], &[&MooringPoint]),
) {
    let points: Vec<&&MooringPoint> = points
        .iter()
        .filter(|point| point.mass.value > 0.0)
        .collect();
    if rods.is_empty() && points.is_empty() {
        case.given("mass_kg", &number(body.mass.value), &body.mass.span, "Mass");
        if body.centre.value != [0.0; 3] {
            let centre = numbers(&body.centre.value);
            case.given("centre_of_gravity_m", &centre, &body.centre.span, "CG");
        }
        let inertia = numbers(&body.inertia.value);
        case.given("inertia_kg_m2", &inertia, &body.inertia.span, "I");
        return;
    }
    let mut parts = vec![MassOf {
        mass: body.mass.value,
        centre: V3::from(body.centre.value),
        inertia: nalgebra::Matrix3::from_diagonal(&V3::from(body.inertia.value)),
    }];
    for (_, rod) in rods {
        parts.push(mass_of(rod, &context.mooring.rod_types[rod.of_type.value]));
    }
    parts.extend(points.iter().map(|point| MassOf {
        mass: point.mass.value,
        centre: place_of(point),
        inertia: nalgebra::Matrix3::zeros(),
    }));
    let whole = together(&parts);
    let what = match points.is_empty() {
        true => "with the rods on it",
        false => "with the rods and points on it",
    };
    case.given("mass_kg", &number(whole.mass), &body.mass.span, what);
    let centre = numbers(whole.centre.as_slice());
    case.given("centre_of_gravity_m", &centre, &body.centre.span, what);
    let i = whole.inertia;
    let six = [i.m11, i.m22, i.m33, i.m12, i.m13, i.m23];
    case.given("inertia_kg_m2", &numbers(&six), &body.inertia.span, what);
}

/// A rod as an even cylinder.
fn mass_of(rod: &Rod, of: &RodType) -> MassOf {
    let (a, b) = (V3::from(rod.end(0)), V3::from(rod.end(1)));
    let long = rod.length();
    let axis = (b - a) / long;
    let mass = of.mass.value * long;
    let radius2 = 0.25 * of.diameter.value * of.diameter.value;
    let along = 0.5 * mass * radius2;
    let across = mass * (3.0 * radius2 + long * long) / 12.0;
    let outer = axis * axis.transpose();
    MassOf {
        mass,
        centre: 0.5 * (a + b),
        inertia: nalgebra::Matrix3::identity() * across + outer * (along - across),
    }
}

/// Parts as one, by the parallel axis theorem.
fn together(parts: &[MassOf]) -> MassOf {
    let mass: f64 = parts.iter().map(|part| part.mass).sum();
    let moment: V3 = parts.iter().map(|part| part.centre * part.mass).sum();
    let centre = match mass > 0.0 {
        true => moment / mass,
        false => V3::zeros(),
    };
    let mut inertia = nalgebra::Matrix3::zeros();
    for part in parts {
        let arm = part.centre - centre;
        let shift = nalgebra::Matrix3::identity() * arm.norm_squared() - arm * arm.transpose();
        inertia += part.inertia + shift * part.mass;
    }
    MassOf {
        mass,
        centre,
        inertia,
    }
}

/// Volume, added mass and drag of a body and of the points on it. `MoorDyn` lets weight and buoyancy of the body act at the same point;
/// drag and added mass of its points act here at its origin.
fn water(
    case: &mut CaseText<'_>,
    context: &Context<'_>,
    body: &MooringBody,
    points: &[&MooringPoint],
) {
    let of_points: f64 = points.iter().map(|point| point.volume.value).sum();
    let volume = body.volume.value + of_points;
    if volume > 0.0 {
        let with = |what: &str| match of_points > 0.0 {
            true => format!("{what}, with the points on it"),
            false => what.to_owned(),
        };
        case.given(
            "volume_m3",
            &number(volume),
            &body.volume.span,
            &with("Volume"),
        );
        let centre = centre_of_buoyancy(body, points, volume);
        if centre != V3::zeros() {
            case.given(
                "centre_of_buoyancy_m",
                &numbers(centre.as_slice()),
                &body.centre.span,
                &with("CG, as in MoorDyn"),
            );
        }
        let of_points: f64 = points
            .iter()
            .map(|point| point.added_mass.value * point.volume.value)
            .sum();
        let added = body
            .added_mass
            .value
            .map(|ca| (ca * body.volume.value + of_points) * context.sea.density);
        if added != [0.0; 3] {
            let six = [added[0], added[1], added[2], 0.0, 0.0, 0.0];
            case.given(
                "added_mass",
                &numbers(&six),
                &body.added_mass.span,
                &with("Ca on the volume"),
            );
        }
    }
    drag_and_waterplane(case, body, points);
    loads(case, context, body);
}

/// Drag areas along the axes, and the stiffness of the waterplane.
fn drag_and_waterplane(case: &mut CaseText<'_>, body: &MooringBody, points: &[&MooringPoint]) {
    let of_points: f64 = points.iter().map(|point| point.drag_area.value).sum();
    let area = body.drag_area.value;
    let along = [0, 1, 2].map(|axis| area[axis] + of_points);
    if along != [0.0; 3] {
        case.given(
            "drag_area_m2",
            &numbers(&along),
            &body.drag_area.span,
            "CdA",
        );
    }
    if body.waterplane.value != [0.0; 3] {
        let [heave, roll, pitch] = body.waterplane.value;
        let six = numbers(&[0.0, 0.0, heave, roll, pitch, 0.0]);
        let span = &body.waterplane.span;
        case.given("waterplane_stiffness", &six, span, "C33 C44 C55");
    }
}

/// Loads at the origin of a body, and its damping.
fn loads(case: &mut CaseText<'_>, context: &Context<'_>, body: &MooringBody) {
    let sum = |of: &dyn Fn(&BodyLoad) -> [f64; 3]| {
        let mut all = [0.0; 3];
        for load in &body.loads {
            let one = of(load);
            (0..3).for_each(|axis| all[axis] += one[axis]);
        }
        all
    };
    let row = || {
        body.loads
            .first()
            .map_or_else(|| body.span.clone(), |load| load.span.clone())
    };
    let force = sum(&|load| match load.is_local {
        true => [0.0; 3],
        false => load.force.value,
    });
    if force != [0.0; 3] {
        case.given("load_n", &numbers(&force), &row(), "Fext");
    }
    let damping = |load: &BodyLoad, value: [f64; 3]| match body.damps_along_own_axes(load) {
        true => value,
        false => [0.0; 3],
    };
    let [x, y, z] = sum(&|load| damping(load, load.linear.value));
    if [x, y, z] != [0.0; 3] {
        let six = numbers(&[x, y, z, 0.0, 0.0, 0.0]);
        case.given("damping", &six, &row(), "Blin");
    }
    let area = body.drag_area.value;
    let about = |axis: usize| 0.5 * context.sea.density * area[3 + axis];
    let [x, y, z] = sum(&|load| damping(load, load.quadratic.value));
    let six = [x, y, z, about(0), about(1), about(2)];
    if six != [0.0; 6] {
        let (span, what) = match [x, y, z] == [0.0; 3] {
            true => (body.drag_area.span.clone(), "CdA about its axes"),
            false => (row(), "Bquad, and CdA about its axes"),
        };
        case.given("quadratic_damping", &numbers(&six), &span, what);
    }
}

/// Where the buoyancy of a body and of the points on it acts \[m\], in the frame of the body.
fn centre_of_buoyancy(body: &MooringBody, points: &[&MooringPoint], volume: f64) -> V3 {
    let centre = V3::from(body.centre.value);
    let floating = points.iter().filter(|point| point.volume.value > 0.0);
    let moment: V3 = floating
        .map(|point| place_of(point) * point.volume.value)
        .sum();
    match moment == V3::zeros() && volume == body.volume.value {
        true => centre,
        false => (centre * body.volume.value + moment) / volume,
    }
}

fn rod_water(case: &mut CaseText<'_>, of: &RodType) {
    let mut one = |key: &str, given: &Given<f64>, column: &str| {
        case.given(key, &number(given.value), &given.span, column);
    };
    one("diameter_m", &of.diameter, "Diam");
    one("drag_normal", &of.drag_normal, "Cd");
    one("added_mass_normal", &of.added_mass_normal, "Ca");
    one("drag_end", &of.drag_end, "CdEnd");
    one("added_mass_end", &of.added_mass_end, "CaEnd");
}

/// Writes the rods that are no part of a body and no joint.
pub fn write_rods(case: &mut CaseText<'_>, context: &Context<'_>) {
    for (number_of, rod) in context.mooring.rods.iter().enumerate() {
        let on_body = matches!(rod.hold.value, Hold::Body(_));
        if on_body || rod.is_joint() {
            continue;
        }
        let of = &context.mooring.rod_types[rod.of_type.value];
        let header = format!("[rods.{}]", context.names.rods[number_of]);
        case.table(&header, Some(&rod.span));
        let kind = kind_of(&rod.hold.value, context);
        case.given("kind", kind, &rod.hold.span, "Attachment");
        if let Hold::Body(body) = rod.hold.value.base() {
            let name = text(&context.names.bodies[*body]);
            case.given("pinned_to", &name, &rod.hold.span, "Attachment");
        }
        case.given(
            "end_a_m",
            &numbers(&rod.end(0)),
            &rod.ends[0][0].span,
            "Xa Ya Za",
        );
        case.given(
            "end_b_m",
            &numbers(&rod.end(1)),
            &rod.ends[1][0].span,
            "Xb Yb Zb",
        );
        let mass = number(of.mass.value * rod.length());
        case.given("mass_kg", &mass, &of.mass.span, "Mass/m by its length");
        rod_water(case, of);
    }
}
