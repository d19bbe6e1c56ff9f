//! `seacable run` on a system of lines: at rest, as a report or as JSON.

use std::process::ExitCode;

use super::{CommandError, args::RunArgs, cases, output};
use crate::{
    report::system::{self as views, json},
    system::{SystemFile, analysis::analyses::Analyses, validation},
};

pub(super) fn system(args: &RunArgs) -> Result<ExitCode, CommandError> {
    let path = args.case.clone().unwrap_or_default();
    let given = [
        (
            args.out.is_some(),
            "--out: a system at rest is printed, not kept; redirect the output",
        ),
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
    let analyses = Analyses::of(&solved);
    if args.json {
        output::object(&json::object(&solved, &analyses))?;
        return Ok(ExitCode::SUCCESS);
    }
    let rows = validation::rows(&solved);
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
