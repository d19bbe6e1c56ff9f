//! What a file states and is not modelled: named all at once, or left out where that is asked for.

use super::Context;
use super::joints::is_inside;
use crate::import::ImportOptions;
use crate::import::fault::Fault;
use crate::import::mooring::{Attachment, Hold, Unmodelled};

/// Names by which `--without` leaves out what is not modelled.
pub const NAMES: [&str; 8] = [
    "viv",
    "waves",
    "currents",
    "control",
    "loads",
    "clamps",
    "failure",
    "linear-spring",
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

/// Lines that bend and end at rods, which hold their direction.
fn clamps(context: &Context<'_>) -> Vec<Unmodelled> {
    let mooring = context.mooring;
    let mut found = Vec::new();
    for line in &mooring.lines {
        let bends = mooring.line_types[line.of_type.value].bending.value > 0.0;
        for end in line.ends.iter().filter(|_| bends) {
            let Attachment::Rod(rod, _) = end.value else {
                continue;
            };
            let hold = &mooring.rods[rod].hold.value;
            let holds = !hold.turns() && !matches!(hold, Hold::Body(_));
            if is_inside(mooring, rod)
                || is_hinge(context, rod)
                || holds && !context.motion.is_of_one_body()
            {
                continue;
            }
            found.push(Unmodelled {
                name: "clamps",
                span: end.span.clone(),
                key: "LINES, Attach".to_owned(),
                what: "a rod that turns and holds the direction of a line that bends (a hinge without it)"
                    .to_owned(),
            });
        }
    }
    found
}

/// A joint at which a line ends that nothing but other lines hold the direction of: a free one, or a pinned one of a single line.
fn is_hinge(context: &Context<'_>, rod: usize) -> bool {
    let joint = &context.mooring.rods[rod];
    let ends = context.mooring.lines.iter().flat_map(|line| &line.ends);
    let here = ends.filter(|end| matches!(end.value, Attachment::Rod(at, _) if at == rod));
    let is_free = match joint.hold.value {
        Hold::Free => true,
        Hold::Pinned(_) => here.count() == 1,
        _ => false,
    };
    joint.is_joint() && is_free
}
