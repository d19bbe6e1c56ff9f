//! `seacable run` on a system of lines: at rest, or in time where its file has a table `[solver]`; as a report or as JSON.

use std::{fs, path::Path, process::ExitCode};

use super::{
    BAD_RESULT, CommandError, args::RunArgs, cases, output, progress::ProgressLine,
    signals::StopFlag,
};
use crate::{
    case::FieldRow,
    files::Target,
    report::system::{self as views, json, motion},
    run::store::{StoreError, write_history},
    system::{
        SolvedSystem, SystemFile,
        analysis::analyses::Analyses,
        model::MotionInputs,
        motion::run::{self, MotionRun},
        validation,
    },
};

pub(super) fn system(args: &RunArgs) -> Result<ExitCode, CommandError> {
    let path = args.case.clone().unwrap_or_default();
    let given = [
        (
            args.solver.is_some(),
            "--solver: a system is solved at rest",
        ),
        (
            args.accuracy.is_some(),
            "--accuracy: lines in closed form have no mesh; give discretised ones `segments`",
        ),
        (
            args.budget.is_some(),
            "--budget: it bounds the search for an accuracy",
        ),
    ];
    if let Some((_, why)) = given.iter().find(|(given, _)| *given) {
        return Err(CommandError::Usage(format!(
            "Systems of lines do not take {why}."
        )));
    }
    let (fields, solved) = cases::load_with::<SystemFile>(&path, &args.set)?;
    if let Some(motion) = &solved.file.solver {
        return in_motion(args, &solved, motion, &fields);
    }
    if args.out.is_some() {
        return Err(CommandError::Usage(
            "Systems of lines do not take --out: one at rest is printed, not kept; redirect the output.".to_owned(),
        ));
    }
    let analyses = Analyses::of(&solved);
    if args.json {
        output::object(&json::object(&solved, &analyses))?;
        return Ok(ExitCode::SUCCESS);
    }
    let rows = validation::rows(&solved, None);
    let text = views::report(
        &solved,
        &analyses,
        &rows,
        &fields,
        output::glyphs(args.ascii),
    );
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// The run in time: report or JSON on standard output, and with `--out` a directory with all of it.
fn in_motion(
    args: &RunArgs,
    solved: &SolvedSystem,
    given: &MotionInputs,
    fields: &[FieldRow],
) -> Result<ExitCode, CommandError> {
    if let Some(dir) = &args.out {
        refuse_if_taken(dir)?;
    }
    let stop = StopFlag::listen()?;
    let mut line = ProgressLine::new();
    let duration = given.duration_s;
    let computed = run::run(solved, given, stop.cancel(), &mut |time| {
        line.part(time / duration, &format!("{time:.1} s of {duration} s"));
    });
    drop(line);
    let computed =
        computed.map_err(|why| CommandError::Usage(format!("{}; {}.", why.problem, why.remedy)))?;
    let glyphs = output::glyphs(args.ascii);
    let rows = validation::rows(solved, Some(&computed));
    let report = motion::report(solved, &computed, &rows, fields, glyphs);
    if args.json || args.out.is_some() {
        let mut object = json::object(solved, &Analyses::of(solved));
        object["motion"] = motion::object(&computed);
        if let Some(dir) = &args.out {
            object["motion"]["directory"] = dir.display().to_string().into();
            keep(args, dir, &computed, &report, &object)?;
        }
        if args.json {
            output::object(&object)?;
        }
    }
    if !args.json {
        output::results(&report, args.ascii)?;
    }
    Ok(match &computed.failure {
        None => ExitCode::SUCCESS,
        Some(why) => {
            output::message(&format!("error: The run ended early: {why}"));
            stop.status().unwrap_or(ExitCode::from(BAD_RESULT))
        }
    })
}

fn refuse_if_taken(dir: &Path) -> Result<(), CommandError> {
    let taken = fs::read_dir(dir).is_ok_and(|mut entries| entries.next().is_some());
    if taken {
        return Err(StoreError::Taken(dir.to_owned()).into());
    }
    Ok(())
}

/// The directory of a run: its input, its history, its report and its results.
fn keep(
    args: &RunArgs,
    dir: &Path,
    run: &MotionRun,
    report: &str,
    object: &serde_json::Value,
) -> Result<(), CommandError> {
    let path = args.case.as_deref().unwrap_or(Path::new(""));
    let text = cases::edited_text::<SystemFile>(path, &args.set)?;
    fs::create_dir_all(dir).map_err(|source| StoreError::Io {
        action: "Making",
        path: dir.to_owned(),
        source,
    })?;
    let files = [
        ("case.toml", text.into_bytes()),
        ("history.csv", write_history(&run.history)?),
        ("report.txt", report.as_bytes().to_vec()),
        ("results.json", format!("{object:#}\n").into_bytes()),
    ];
    for (name, contents) in files {
        Target::new(&dir.join(name))
            .write(&contents)
            .map_err(StoreError::from)?;
    }
    Ok(())
}
