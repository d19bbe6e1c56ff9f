//! `seacable study offsets`, `watch-circle` and `seek`: analyses of a system of lines.

use std::process::ExitCode;

use serde_json::{Value, json};

use super::{
    BAD_RESULT, CommandError,
    cases::EditedFile,
    common_args::CaseArgs,
    output,
    system_args::{OffsetsArgs, SeekArgs, SystemArgs, WatchArgs},
};
use seacable_display::chart::draw;
use seacable_display::table::Table;
use seacable_engine::modes::LineModes;
use seacable_model::kinds::FileBytes;
use seacable_report::run_json;
use seacable_report::system::analysis as views;
use seacable_systems::system::analysis::offset::{HeldAway, OffsetPoint, curve};
use seacable_systems::system::analysis::periods::NaturalModes;
use seacable_systems::system::analysis::{seek, watch_circle};
use seacable_systems::system::quantities::unit;
use seacable_systems::system::{SolvedSystem, SystemFile};

/// Columns of the page, columns and rows of a chart.
const WIDTH: usize = 140;
const PLOT: (usize, usize) = (80, 24);

fn load(args: &SystemArgs) -> Result<SolvedSystem, CommandError> {
    solved(&args.case, FileBytes::read(&args.case.file))
}

/// The system of a file, worked out.
pub(super) fn solved(args: &CaseArgs, file: FileBytes) -> Result<SolvedSystem, CommandError> {
    Ok(read(args, file)?.compute()?.computed)
}

fn read(args: &CaseArgs, file: FileBytes) -> Result<EditedFile<'_, SystemFile>, CommandError> {
    EditedFile::read(file, &args.set, &args.import.options())
}

/// The body named, or the only one.
fn body(solved: &SolvedSystem, name: Option<&str>) -> Result<usize, CommandError> {
    let bodies = &solved.network.bodies;
    let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
    let found = match name {
        Some(name) => names.iter().position(|known| *known == name),
        None => (names.len() == 1).then_some(0),
    };
    found.ok_or_else(|| {
        let known = names.join(", ");
        CommandError::Usage(match (name, names.is_empty()) {
            (_, true) => "The system has no body.".to_owned(),
            (Some(name), _) => format!("There is no body \"{name}\"; the system has {known}."),
            (None, _) => format!("Name the body with --body; the system has {known}."),
        })
    })
}

fn print(
    table: &Table,
    chart: &seacable_display::chart::Chart,
    ascii: bool,
) -> Result<(), CommandError> {
    let drawn = draw(chart, PLOT.0, PLOT.1, output::glyphs(ascii)).to_text();
    output::results(&format!("{}\n{drawn}\n", table.to_text(WIDTH)), ascii)
}

fn point(solved: &SolvedSystem, point: &OffsetPoint) -> Value {
    let name = |line: usize| solved.network.lines.get(line).map(|line| line.name.clone());
    json!({
        "offset_m": point.offset_m,
        "lines_force_n": [point.force_n.x, point.force_n.y, point.force_n.z],
        "greatest_tension_n": point.greatest.1,
        "greatest_in": name(point.greatest.0),
        "share_of_breaking_load": point.weakest.map(|(_, share)| share),
        "uplift_n": point.uplift.map_or(0.0, |(_, z)| z),
    })
}

pub(super) fn offsets(args: &OffsetsArgs) -> Result<ExitCode, CommandError> {
    let solved = load(&args.system)?;
    let body = body(&solved, args.body.as_deref())?;
    let mut held = HeldAway::new(&solved.network, &solved.rest, body);
    let points = curve(&mut held, args.heading.to_radians(), args.to, args.steps);
    if args.system.json {
        let points: Vec<Value> = points.iter().map(|p| point(&solved, p)).collect();
        output::object(&json!({"kind": "offsets", "heading_deg": args.heading, "points": points}))?;
    } else {
        let table = views::offsets(&solved, args.heading, &points);
        print(
            &table,
            &views::offset_chart(args.heading, &points),
            args.system.ascii,
        )?;
    }
    if points.len() <= args.steps as usize {
        output::message("No equilibrium was found beyond the last offset.");
        return Ok(ExitCode::from(BAD_RESULT));
    }
    Ok(ExitCode::SUCCESS)
}

pub(super) fn watch(args: &WatchArgs) -> Result<ExitCode, CommandError> {
    let solved = load(&args.system)?;
    let body = body(&solved, args.body.as_deref())?;
    let each = std::f64::consts::TAU / f64::from(args.headings);
    let headings = (0..args.headings).map(|k| each * f64::from(k)).collect();
    let circle =
        watch_circle::watch_circle(&solved.network, &solved.rest, body, args.load, headings);
    if args.system.json {
        let one = |found: &Result<OffsetPoint, String>| match found {
            Ok(found) => point(&solved, found),
            Err(why) => json!({"refused": why}),
        };
        let lost = circle.damaged.iter().map(|(line, points)| {
            let name = &solved.network.lines[*line].name;
            json!({"line": name, "points": points.iter().map(one).collect::<Vec<_>>()})
        });
        let headings: Vec<f64> = circle.headings.iter().map(|h| h.to_degrees()).collect();
        output::object(&json!({
            "kind": "watch_circle",
            "load_n": circle.load_n,
            "headings_deg": headings,
            "intact": circle.intact.iter().map(one).collect::<Vec<_>>(),
            "line_lost": lost.collect::<Vec<_>>(),
        }))?;
    } else {
        let table = views::watch_circle(&solved, &circle);
        print(
            &table,
            &views::watch_chart(&solved, &circle),
            args.system.ascii,
        )?;
    }
    let held = circle.intact.iter().all(Result::is_ok);
    Ok(if held {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

pub(super) fn goal(args: &SeekArgs) -> Result<ExitCode, CommandError> {
    let file = FileBytes::read(&args.system.case.file);
    let file = read(&args.system.case, file)?;
    let text = file.whole_text();
    let Some((quantity, wanted)) = args
        .want
        .split_once('=')
        .and_then(|(name, value)| Some((name.trim(), value.trim().parse::<f64>().ok()?)))
    else {
        let how = "Write --want RESULT=VALUE, for example --want \"tension_n[mooring|b]=9.5e5\".";
        return Err(CommandError::Usage(how.to_owned()));
    };
    let Some((low, high)) = args.between.split_once("..").and_then(|(low, high)| {
        Some((
            low.trim().parse::<f64>().ok()?,
            high.trim().parse::<f64>().ok()?,
        ))
    }) else {
        return Err(CommandError::Usage(
            "Write --between A..B, for example --between 880..930.".to_owned(),
        ));
    };
    match seek::seek(&text, &args.vary, (low, high), quantity, wanted) {
        Ok(found) if args.system.json => output::object(&json!({
            "kind": "seek",
            "key": args.vary,
            "value": found.value,
            "result": quantity,
            "comes_to": found.result,
            "systems_solved": found.solved,
        }))?,
        Ok(found) => {
            let page = format!(
                "{} = {:?}\n{quantity} = {:?} {}\n{} systems were solved.\n",
                args.vary,
                found.value,
                found.result,
                unit(quantity),
                found.solved
            );
            output::results(&page, args.system.ascii)?;
        }
        Err(why) => {
            // A system that has no equilibrium as it is says so at its key.
            file.compute()?;
            output::message(&format!("error: {why}."));
            return Ok(ExitCode::from(BAD_RESULT));
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// `seacable modes` on a system as an object: its own modes, and those of its bodies and points alone, where these have a mass.
pub(super) fn modes_object(
    solved: &SolvedSystem,
    found: &LineModes,
    bodies: Option<&NaturalModes>,
) -> Value {
    let each = bodies.iter().flat_map(|found| &found.modes).map(|mode| {
        let (part, direction) = mode.names(&solved.network);
        json!({"period_s": mode.period_s, "part": part, "direction": direction})
    });
    let whole = run_json::each_mode(found).into_iter().zip(&found.modes);
    let whole = whole.map(|(mut mode, named)| {
        mode["mostly"] = json!(named.most);
        mode
    });
    json!({
        "kind": "modes",
        "whole": whole.collect::<Vec<_>>(),
        "modes": each.collect::<Vec<_>>(),
        "complete_to_s": bodies.and_then(|found| found.complete_to_s),
    })
}
