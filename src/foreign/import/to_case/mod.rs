//! The text of a case, as a person would write it, from a mooring that was read.

pub mod bodies;
pub mod case_text;
pub mod columns;
mod context;
pub mod joints;
pub mod lines;
pub mod materials;
pub mod motion;
pub mod names;
pub mod passed_over;
pub mod points;
pub mod sea;
pub mod start;
pub mod unmodelled;

use self::case_text::{CaseText, text};
use self::joints::LineJoints;
use self::motion::CoupledMotion;
use self::names::Names;
use self::sea::sea_of;
use super::fault::Fault;
use super::imported::{ImportOptions, Imported};
use super::mooring::{Hold, Mooring};
use std::collections::BTreeMap;

pub use context::{Context, OnBody, is_in_air};

/// The case of a mooring. `source` is the text it was read from, `file` its name.
///
/// # Errors
/// All that it states and is not modelled here, unless the options leave it out; what the options do not say.
pub fn case_of(
    mooring: &Mooring,
    source: &str,
    file: &str,
    options: &ImportOptions,
) -> Result<Imported, Vec<Fault>> {
    let sea = sea_of(mooring, options)?;
    let motion = motion_of(mooring, options)?;
    let coupled = coupled_parts(mooring);
    let context = Context {
        has_vessel: coupled > 1 && !motion.is_of_each() || coupled > 0 && motion.is_of_one_body(),
        names: Names::of_mooring(mooring),
        joints: LineJoints::of_mooring(mooring),
        on_bodies: OnBody::all(mooring),
        mooring,
        sea,
        motion,
    };
    let left_out = unmodelled::leave_out(&context, options)?;
    let mut case = CaseText::of_mooring(source, mooring);
    head(&mut case, &context, file, (&left_out, &options.without));
    let in_air = is_in_air(mooring);
    sea::write(&mut case, mooring, options, &context.sea, in_air);
    let acts = |name: &str| !in_air && !options.without.iter().any(|one| one == name);
    if let Some(profile) = mooring.sea.current.as_ref().filter(|_| acts("currents")) {
        sea::write_current(&mut case, profile);
    }
    let current_file = mooring.sea.current_file.as_ref();
    let current_file = current_file.filter(|_| acts("currents"));
    if let Some(file) = current_file {
        case.table("[current]", Some(&file.span));
        case.given("file", &text(file.value.name), &file.span, "Currents");
    }
    if let Some(waves) = mooring.sea.waves.as_ref().filter(|_| acts("waves")) {
        sea::write_waves(&mut case, waves);
    }
    if let Some(waves) = mooring.sea.elevation.as_ref().filter(|_| acts("waves")) {
        sea::write_elevation(&mut case, waves);
    }
    materials::write(&mut case, mooring, &context.names);
    bodies::write(&mut case, &context);
    bodies::write_rods(&mut case, &context);
    points::write(&mut case, &context);
    lines::write(&mut case, &context);
    start::write(&mut case, &context);
    context.motion.write_run(&mut case);
    sea::write_depths(&mut case, mooring);
    if let Some(file) = current_file {
        sea::write_current_file(&mut case, file);
    }
    Ok(Imported {
        text: case.text,
        from: case.from,
        beside: mooring.beside.clone(),
        keys: BTreeMap::new(),
    })
}

/// Coupled points and joints: what is coupled and no body or rod of its own.
fn coupled_parts(mooring: &Mooring) -> usize {
    let points = mooring.points.iter();
    let points = points.filter(|point| point.hold.value == Hold::Coupled);
    let joints = mooring.rods.iter();
    let joints = joints.filter(|rod| rod.is_joint() && rod.hold.value == Hold::Coupled);
    let copies = 1 + mooring.repeats.len();
    (points.count() + joints.count()) * copies
}

fn motion_of(mooring: &Mooring, options: &ImportOptions) -> Result<CoupledMotion, Vec<Fault>> {
    let Some(path) = &options.motion else {
        return Ok(CoupledMotion::none());
    };
    CoupledMotion::read(path, mooring).map_err(|why| {
        vec![Fault::new(
            0..0,
            "",
            format!("the motion cannot be used: {why}"),
            "give a table of the time and of every coupled coordinate with `--motion`",
        )]
    })
}

/// The table `[system]`: what the file is, and what was put down that it does not say.
fn head(
    case: &mut CaseText<'_>,
    context: &Context<'_>,
    file: &str,
    (left_out, without): (&[String], &[String]),
) {
    let mooring = context.mooring;
    case.table("[system]", None);
    let title = match mooring.title.is_empty() {
        true => file.to_owned(),
        false => mooring.title.clone(),
    };
    case.line(&format!("title = {}", text(&title)), None);
    let program = mooring.program.name();
    let source = format!("{file}, a file of {program}");
    case.line(&format!("source = {}", text(&source)), None);
    let mut notes = Vec::new();
    if !left_out.is_empty() {
        notes.push(format!("LEFT OUT, as asked for: {}.", left_out.join("; ")));
    }
    notes.extend(mooring.remarks.iter().cloned());
    notes.extend(context.motion.remarks.iter().cloned());
    notes.extend(start::remarks(context));
    let is_pinned = |hold: &Hold| *hold == Hold::Pinned(Box::new(Hold::Fixed));
    if mooring
        .bodies
        .iter()
        .any(|body| is_pinned(&body.hold.value))
    {
        notes.push("MoorDyn takes a body that is `Pinned` as free; here it is pinned.".to_owned());
    }
    let sea = &mooring.sea;
    let is_left_out = |name: &str| without.iter().any(|one| one == name);
    let current_file = sea.current_file.as_ref();
    let current_file = current_file.filter(|_| !is_left_out("currents"));
    notes.extend(current_file.map(|file| sea::remark_on_current(&file.value)));
    let elevation = sea.elevation.as_ref().filter(|_| !is_left_out("waves"));
    notes.extend(elevation.map(|waves| sea::remark_on_elevation(&waves.value)));
    let has_waves = sea.waves.is_some() || elevation.is_some();
    if (has_waves || !mooring.failures.is_empty()) && !context.motion.moves() {
        notes.push(
            "Waves and lines that come off act in motion: give --motion, or --set solver.duration_s=60."
                .to_owned(),
        );
    } else if current_file.is_some_and(|file| file.value.varies) && !context.motion.moves() {
        notes.push(
            "The current changes in motion, and is that of time zero at rest: give --motion, or --set solver.duration_s=60."
                .to_owned(),
        );
    }
    notes.extend(passed_over::notes(context));
    if !notes.is_empty() {
        case.line(&format!("notes = {}", text(&notes.join(" "))), None);
    }
}
