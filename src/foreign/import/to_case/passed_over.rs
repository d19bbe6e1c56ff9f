//! What of a file is read and has no effect here: said once, by the names of the file.

use std::collections::HashSet;

use super::context::Context;
use super::start::is_given;
use super::unmodelled::moves_and_turns;
use crate::import::listing::listed;
use crate::import::mooring::{Attachment, BodyLoad, Hold, Mooring, Program, ProgramSetting};

/// Options that are taken, by their names here; all others are passed over.
const TAKEN: [&str; 11] = [
    "g",
    "wtrdnsty",
    "wtrdpth",
    "kbot",
    "cbot",
    "wavekin",
    "currents",
    "waterkin",
    "frictioncoefficient",
    "mu_ka",
    "seafloorfile",
];

/// Options by which `MoorDyn` has other forces.
const PHYSICS: [&str; 8] = [
    "fricdamp",
    "statdynfricscale",
    "unifycurrentgrid",
    "inertialf",
    "inertialf_rampt",
    "visco_mod",
    "rampt",
    "wavedirection",
];

/// What is said of it, in sentences.
#[must_use]
pub fn notes(context: &Context<'_>) -> Vec<String> {
    let mooring = context.mooring;
    let mut notes = Vec::new();
    let (physics, others) = options(mooring, is_given(context));
    let mut put = |what: &str, names: &[String]| {
        if !names.is_empty() {
            notes.push(format!("{what}: {}.", names.join(", ")));
        }
    };
    let program = mooring.program.name();
    put(
        &format!("Passed over, though {program} has other forces by it"),
        &physics,
    );
    put("Passed over, as of a solver or of outputs", &others);
    if !mooring.not_known.is_empty() {
        let names = listed(&mooring.not_known);
        notes.push(format!(
            "Options that are not known have no effect: {names}."
        ));
    }
    notes.extend(parts(context));
    notes
}

/// Names of the options, flags and columns that are passed over: those of forces, and others.
fn options(mooring: &Mooring, is_started: bool) -> (Vec<String>, Vec<String>) {
    let wave_step = mooring.sea.elevation.is_some();
    let is_taken = |name: &str| match name {
        "dtwave" => wave_step,
        "tmaxic" => is_started,
        name => TAKEN.contains(&name),
    };
    let settings: Vec<_> = match mooring.program {
        Program::MoorDyn | Program::MoorDyn1 => mooring.settings.iter().collect(),
        _ => Vec::new(),
    };
    let settings = settings.into_iter().filter(|one| !is_taken(&one.name));
    let (physics, others): (Vec<_>, Vec<_>) =
        settings.partition(|one| PHYSICS.contains(&one.name.as_str()));
    let names = |all: Vec<&ProgramSetting>| -> Vec<String> {
        all.iter().map(|one| one.written.clone()).collect()
    };
    let mut others = names(others);
    others.extend(mooring.passed_over.iter().cloned());
    (unrepeated(names(physics)), unrepeated(others))
}

/// Names without those that were before.
fn unrepeated(names: Vec<String>) -> Vec<String> {
    let mut seen = HashSet::new();
    let is_new = |name: &String| seen.insert(name.to_lowercase());
    names.into_iter().filter(is_new).collect()
}

/// Columns of parts that act on nothing, and parts that nothing is attached to.
fn parts(context: &Context<'_>) -> Vec<String> {
    [
        columns_of_held_points(context),
        loads_on_held_bodies(context),
        loads_on_held_rods(context),
        damping_along_bodies(context),
        unused_points(context),
        unused_line_types(context),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// What is said of parts, and why, if there are any.
fn note(what: &str, ids: &[&str], why: &str) -> Option<String> {
    (!ids.is_empty()).then(|| format!("{what} {}: {why}.", listed(ids)))
}

/// Whether what is held so does not move.
fn is_held(mooring: &Mooring, hold: &Hold) -> bool {
    match hold.base() {
        Hold::Body(body) => !mooring.bodies[*body].hold.value.turns(),
        hold => *hold != Hold::Free,
    }
}

fn columns_of_held_points(context: &Context<'_>) -> Option<String> {
    let mooring = context.mooring;
    let points = mooring.points.iter();
    let held = points.filter(|point| is_held(mooring, &point.hold.value));
    let with_columns = held.filter(|point| {
        let all = [
            &point.mass,
            &point.volume,
            &point.drag_area,
            &point.added_mass,
        ];
        all.into_iter()
            .chain(&point.load)
            .any(|given| given.value != 0.0)
    });
    let ids: Vec<&str> = with_columns.map(|point| point.id.as_str()).collect();
    note(
        "Mass, volume, drag, added mass and loads act on nothing at the points",
        &ids,
        "they are held",
    )
}

fn loads_on_held_bodies(context: &Context<'_>) -> Option<String> {
    let mooring = context.mooring;
    let bodies = mooring.bodies.iter();
    let held = bodies.filter(|body| is_held(mooring, &body.hold.value));
    let loaded = held.filter(|body| !body.loads.is_empty());
    let ids: Vec<&str> = loaded.map(|body| body.id.as_str()).collect();
    note(
        "EXTERNAL LOADS act on nothing at the bodies",
        &ids,
        "they are held",
    )
}

fn loads_on_held_rods(context: &Context<'_>) -> Option<String> {
    let idle = context.mooring.rods.iter().filter(|rod| {
        let [moves, turns] = moves_and_turns(context, rod);
        rod.loads.iter().any(|load| {
            let damps = load.linear.value != [0.0; 3] || load.quadratic.value != [0.0; 3];
            !moves && load.force.value != [0.0; 3] || !turns && damps
        })
    });
    let ids: Vec<&str> = idle.map(|rod| rod.id.as_str()).collect();
    note(
        "EXTERNAL LOADS act on nothing at end A of the rods",
        &ids,
        "it is held",
    )
}

fn damping_along_bodies(context: &Context<'_>) -> Option<String> {
    let along = context.mooring.bodies.iter().filter(|body| {
        let damps = |one: &BodyLoad| {
            !one.is_local && (one.linear.value != [0.0; 3] || one.quadratic.value != [0.0; 3])
        };
        body.hold.value.turns() && body.loads.iter().any(damps)
    });
    let ids: Vec<&str> = along.map(|body| body.id.as_str()).collect();
    note(
        "Damping acts along the axes of the bodies",
        &ids,
        "along those of the earth in MoorDyn, the same while they are not turned",
    )
}

/// Points that no line ends at. Of free ones it is said where they are left out or fall.
fn unused_points(context: &Context<'_>) -> Option<String> {
    let points = context.mooring.points.iter().enumerate();
    let unused = points.filter(|(number, point)| {
        let is_elsewhere = matches!(point.hold.value, Hold::Body(_) | Hold::Free);
        !is_elsewhere && !context.is_used(Attachment::Point(*number))
    });
    let ids: Vec<&str> = unused.map(|(_, point)| point.id.as_str()).collect();
    note("Left out are the points", &ids, "no line ends there")
}

fn unused_line_types(context: &Context<'_>) -> Option<String> {
    let mooring = context.mooring;
    let lines = mooring.lines.iter();
    let used: HashSet<usize> = lines.map(|line| line.of_type.value).collect();
    let types = mooring.line_types.iter().enumerate();
    let unused = types.filter(|(number, _)| !used.contains(number));
    let ids: Vec<&str> = unused.map(|(_, of)| of.name.as_str()).collect();
    note("Left out are the line types", &ids, "no line is of them")
}
