//! What a file states and is not modelled: named all at once, or left out where that is asked for.

use std::f64::consts::PI;

use super::super::imported::ImportOptions;
use super::context::Context;
use crate::import::fault::Fault;
use crate::import::mooring::{
    Attachment, Given, Hold, Mass, MooringLine, Rod, Stiffness, Unmodelled,
};
use crate::statics::catenary::{CatenaryLine, EndOffset, SectionProperties};

/// Names by which `--without` leaves out what is not modelled.
pub const NAMES: [&str; 9] = [
    "viv",
    "waves",
    "currents",
    "control",
    "loads",
    "clamps",
    "failure",
    "linear-spring",
    "friction",
];

/// What is left out, in words.
///
/// # Errors
/// What is not modelled and not left out; names that are not known.
pub fn leave_out(
    context: &Context<'_>,
    options: &ImportOptions,
) -> Result<Vec<String>, Vec<Fault>> {
    if let Some(name) = options
        .without
        .iter()
        .find(|name| !NAMES.contains(&name.as_str()))
    {
        return Err(vec![Fault::new(
            0..0,
            "--without",
            format!("`{name}` is nothing that can be left out"),
            format!("it takes {}", NAMES.join(", ")),
        )]);
    }
    let mut all = context.mooring.unmodelled.clone();
    all.extend(pinned(context));
    all.extend(loads(context));
    all.extend(failures(context));
    all.extend(clamps(context));
    all.extend(moved_joints(context));
    all.extend(body_loads(context));
    all.extend(rod_loads(context));
    all.extend(negative_friction(context));
    all.sort_by_key(|one| one.span.start);
    let is_left_out = |one: &Unmodelled| options.without.iter().any(|name| name == one.name);
    let (left_out, faults): (Vec<Unmodelled>, Vec<Unmodelled>) =
        all.into_iter().partition(is_left_out);
    if faults.is_empty() {
        let mut words: Vec<String> = left_out.into_iter().map(|one| one.what).collect();
        words.dedup();
        return Ok(words);
    }
    Err(faults.into_iter().map(fault).collect())
}

fn fault(one: Unmodelled) -> Fault {
    let remedy = match one.name {
        "" => "there is no way around it".to_owned(),
        name => format!("leave it out with `--without {name}`; every report then says so"),
    };
    Fault::new(
        one.span,
        one.key,
        format!("{} not modelled", with_verb(&one.what)),
        remedy,
    )
}

fn with_verb(what: &str) -> String {
    format!("{what}: this is")
}

/// Parts that are pinned to what moves, as far as that is not covered.
fn pinned(context: &Context<'_>) -> Vec<Unmodelled> {
    let mooring = context.mooring;
    let bodies = mooring.bodies.iter().map(|body| (&body.hold, "BODIES"));
    let rods = mooring.rods.iter().map(|rod| (&rod.hold, "RODS"));
    let found = bodies.chain(rods).filter_map(|(hold, table)| {
        let Hold::Pinned(to) = &hold.value else {
            return None;
        };
        let what = match **to {
            Hold::Body(_) if table == "BODIES" => "a body that is pinned to a body",
            Hold::Coupled if table == "RODS" && context.motion.moves() => {
                "a pinned rod whose end follows a motion"
            }
            Hold::Coupled if context.motion.is_of_one_body() => {
                "a pinned body that the motion of the whole carries"
            }
            _ => return None,
        };
        Some(Unmodelled {
            name: "",
            span: hold.span.clone(),
            key: format!("{table}, Attachment"),
            what: what.to_owned(),
        })
    });
    found.collect()
}

/// Loads of points on free bodies: as the body turns, their lever does.
fn loads(context: &Context<'_>) -> Vec<Unmodelled> {
    let mooring = context.mooring;
    let is_on_free_body = |hold: &Hold| match hold {
        Hold::Body(body) => mooring.bodies[*body].hold.value.turns(),
        _ => false,
    };
    let points = mooring.points.iter();
    points
        .filter(|point| is_on_free_body(&point.hold.value))
        .filter_map(|point| point.load.iter().find(|part| part.value != 0.0))
        .map(|load| Unmodelled {
            name: "loads",
            span: load.span.clone(),
            key: "POINTS, FX FY FZ".to_owned(),
            what: "a load on a point of a free body".to_owned(),
        })
        .collect()
}

/// Loads of bodies along axes that turn with them, and damping along those of the earth.
fn body_loads(context: &Context<'_>) -> Vec<Unmodelled> {
    let bodies = context.mooring.bodies.iter();
    let free = bodies.filter(|body| body.hold.value.turns());
    let all = free.flat_map(|body| body.loads.iter().map(move |load| (body, load)));
    let found = all.flat_map(|(body, load)| {
        let turning = load.is_local && load.force.value != [0.0; 3];
        let force = turning.then_some((&load.force, "a force that turns with its body"));
        let across = !body.damps_along_own_axes(load);
        let damping = across.then(|| {
            let what = "damping along the axes of the earth of a body that is turned";
            (&load.linear, what)
        });
        [force, damping]
    });
    let found = found.flatten();
    found
        .map(|(given, what)| Unmodelled {
            name: "loads",
            span: given.span.clone(),
            key: "EXTERNAL LOADS".to_owned(),
            what: what.to_owned(),
        })
        .collect()
}

/// Loads at the ends A of rods, and damping of them, as far as they act; the load on a free joint is that of its point.
fn rod_loads(context: &Context<'_>) -> Vec<Unmodelled> {
    let mooring = context.mooring;
    let mut found = Vec::new();
    for (number, rod) in mooring.rods.iter().enumerate() {
        let is_point = rod.is_joint() && !context.joints.is_inside(mooring, number);
        let is_taken = is_point && rod.hold.value == Hold::Free;
        let [moves, turns] = moves_and_turns(context, rod);
        let damping = match rod.is_joint() {
            true => "damping over ground of a rod without length",
            false => "damping of a rod, across it or along it",
        };
        for load in &rod.loads {
            let force = (moves && !is_taken).then_some((
                &load.force,
                "a steady force on end A of a rod that is not held",
            ));
            let damped =
                [&load.linear, &load.quadratic].map(|given| turns.then_some((given, damping)));
            let all = force.into_iter().chain(damped.into_iter().flatten());
            let acting = all.filter(|(given, _)| given.value != [0.0; 3]);
            found.extend(acting.map(|(given, what)| Unmodelled {
                name: "loads",
                span: given.span.clone(),
                key: "EXTERNAL LOADS".to_owned(),
                what: what.to_owned(),
            }));
        }
    }
    found
}

/// Whether end A of a rod moves with unknowns, and whether the rod does: one that is pinned turns about it.
#[must_use]
pub fn moves_and_turns(context: &Context<'_>, rod: &Rod) -> [bool; 2] {
    let hold = &rod.hold.value;
    let moves = match hold.base() {
        Hold::Body(body) => context.mooring.bodies[*body].hold.value.turns(),
        hold => *hold == Hold::Free,
    };
    [moves, moves || hold.turns() && !rod.is_joint()]
}

/// Lines on the bed whose friction is below 0, by which MAP++ has none where nothing lies on the bed.
fn negative_friction(context: &Context<'_>) -> Vec<Unmodelled> {
    let mooring = context.mooring;
    let mut found: Vec<Unmodelled> = Vec::new();
    let types: Vec<Option<&Given<f64>>> = mooring
        .line_types
        .iter()
        .map(|of| of.friction.as_ref().filter(|given| given.value < 0.0))
        .collect();
    for line in &mooring.lines {
        let Some(given) = types[line.of_type.value].filter(|_| line.without_bed.is_none()) else {
            continue;
        };
        let what = match hangs_clear(context, line) {
            Some(true) => continue,
            Some(false) => "friction below 0 of a line that lies on the bed",
            None => "friction below 0 of a line to a free node, which may lie on the bed",
        };
        if found.iter().all(|one| one.span != given.span) {
            found.push(Unmodelled {
                name: "friction",
                span: given.span.clone(),
                key: "LINE TYPES, CB".to_owned(),
                what: what.to_owned(),
            });
        }
    }
    found
}

/// Whether a line hangs clear of the bed, by its catenary; nothing where an end of it is free.
fn hangs_clear(context: &Context<'_>, line: &MooringLine) -> Option<bool> {
    let mooring = context.mooring;
    let depth = context.sea.depth.unwrap_or(0.0);
    let place = |end: usize| {
        let Attachment::Point(point) = line.ends[end].value else {
            return None;
        };
        let point = &mooring.points[point];
        let [x, y, z] = point.place.each_ref().map(|given| given.value);
        let held = matches!(point.hold.value, Hold::Fixed | Hold::Coupled);
        // On the bed, by the word `depth`.
        held.then_some([x, y, z.max(-depth)])
    };
    let (a, b) = (place(0)?, place(1)?);
    let (low, high) = if b[2] < a[2] { (b, a) } else { (a, b) };
    let of = &mooring.line_types[line.of_type.value];
    let (Mass::InAir(mass), Stiffness::Constant(ea)) = (of.mass.value, &of.stiffness.value) else {
        return None;
    };
    let area = 0.25 * PI * of.diameter.value.powi(2);
    let weight = (mass - context.sea.density * area) * context.sea.gravity;
    let section = [SectionProperties::new(line.length.value, weight, *ea)];
    let hanging = CatenaryLine {
        ends: EndOffset::between(low, high),
        sections: &section,
        bed: None,
        surface_above_a_m: None,
    };
    let solution = hanging.solve().ok()?;
    // The bed of MAP++ is at the lower end: a line lies where it would go on downwards from there.
    Some(weight <= 0.0 || solution.v_a_n >= 0.0)
}

/// Several lines that come off together, as one joint.
fn failures(context: &Context<'_>) -> Vec<Unmodelled> {
    let failures = context.mooring.failures.iter();
    failures
        .filter(|failure| failure.lines.len() > 1)
        .map(|failure| Unmodelled {
            name: "failure",
            span: failure.span.clone(),
            key: "FAILURE, Lines".to_owned(),
            what: "several lines that come off and stay joined to each other".to_owned(),
        })
        .collect()
}

/// Lines that bend and end at a rod that holds their direction and is no body here: a pinned one without length, which joins several.
fn clamps(context: &Context<'_>) -> Vec<Unmodelled> {
    let mooring = context.mooring;
    let mut found = Vec::new();
    for line in &mooring.lines {
        let bends = mooring.line_types[line.of_type.value].bending.value > 0.0;
        for end in line.ends.iter().filter(|_| bends) {
            let Attachment::Rod(rod, _) = end.value else {
                continue;
            };
            let joint = &mooring.rods[rod];
            let joins = joint.is_joint() && joint.hold.value.turns();
            if !joins || context.joints.is_inside(mooring, rod) || is_hinge(context, rod) {
                continue;
            }
            found.push(Unmodelled {
                name: "clamps",
                span: end.span.clone(),
                key: "LINES, Attach".to_owned(),
                what: "a pinned rod without length that joins lines that bend (a hinge without it)"
                    .to_owned(),
            });
        }
    }
    found
}

/// Rods without length that lines end at and that follow a motion of their own: they are points here, which do not turn.
fn moved_joints(context: &Context<'_>) -> Vec<Unmodelled> {
    let rods = context.mooring.rods.iter().enumerate();
    let moved = rods.filter(|(number, rod)| {
        let moves = context.motion.is_of_each() && rod.hold.value == Hold::Coupled;
        moves && rod.is_joint() && context.is_used_rod(*number)
    });
    moved
        .map(|(_, rod)| Unmodelled {
            name: "",
            span: rod.hold.span.clone(),
            key: "RODS, Attachment".to_owned(),
            what: "a rod without length that follows a motion of its own".to_owned(),
        })
        .collect()
}

/// A joint at which a line ends that nothing but other lines hold the direction of: a free one, or a pinned one of a single line.
fn is_hinge(context: &Context<'_>, rod: usize) -> bool {
    let joint = &context.mooring.rods[rod];
    let here = context.joints.at_rod(rod);
    let is_free = match joint.hold.value {
        Hold::Free => true,
        Hold::Pinned(_) => here.len() == 1,
        _ => false,
    };
    joint.is_joint() && is_free
}
