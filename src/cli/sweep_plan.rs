//! The load cases of a sweep: those of a file and of the options, or of a stored sweep.

use std::path::Path;

use super::{
    CommandError,
    cases::{self, EditedFile},
    sweep_args::SweepArgs,
};

use seacable_base::files::read;
use seacable_base::visible;
use seacable_model::case::load_cases::LoadCaseError;
use seacable_model::kinds::{FileBytes, FileType};
use seacable_studies::study::seas::SeaQuestion;
use seacable_studies::study::sweep::{
    PlanChoices, PlanError, StoredSweep, Sweep, SweepError, SweepFolder, SweepPlan,
};
use seacable_systems::system::SystemFile;

/// A sweep with its folder, what is asked of its seas, and the key whose limiting value is sought.
pub(super) type OpenedSweep = (Sweep, SweepFolder, SeaQuestion, Option<String>);

/// The load cases of a file and of the options.
pub(super) fn planned(args: &SweepArgs) -> Result<SweepPlan, CommandError> {
    let path = args.case.as_deref().unwrap_or(Path::new(""));
    cases::allow_values(&args.vary);
    let mut csv = Vec::with_capacity(args.load_cases.len());
    for file in &args.load_cases {
        let text = read::text(file).map_err(|error| {
            CommandError::Usage(format!("--load-cases {}: {error}.", visible::path(file)))
        })?;
        csv.push((visible::path(file), text));
    }
    let file = FileBytes::read(path);
    let plan = match file.kind() {
        FileType::System => system(args, file, &csv)?,
        FileType::Line => line(args, file, &csv)?,
        other => {
            return Err(CommandError::Usage(format!(
                "A sweep takes cases of lines and systems of lines; {} is {}.",
                visible::path(path),
                other.description().0
            )));
        }
    };
    if plan.sweep.variation.keys.is_empty() {
        let what = "There are no load cases: add [[load_cases]] to the file, or --vary KEY=VALUES, or --load-cases FILE.csv.";
        return Err(CommandError::Usage(what.to_owned()));
    }
    Ok(plan)
}

fn line(
    args: &SweepArgs,
    file: FileBytes,
    csv: &[(String, String)],
) -> Result<SweepPlan, CommandError> {
    let set = args.overrides();
    let loaded = cases::load_set(file, &set)?;
    SweepPlan::of_line(&loaded.text, &loaded.name, &set, choices(args, csv)).map_err(refused)
}

fn system(
    args: &SweepArgs,
    file: FileBytes,
    csv: &[(String, String)],
) -> Result<SweepPlan, CommandError> {
    let name = file.path().display().to_string();
    let set = args.overrides();
    let file = EditedFile::<SystemFile>::read(file, &set, &args.import.options())?;
    let text = file.whole_text();
    let solved = file.compute()?.computed;
    SweepPlan::of_system((&text, &solved), &name, &set, choices(args, csv)).map_err(refused)
}

fn choices<'a>(args: &'a SweepArgs, csv: &'a [(String, String)]) -> PlanChoices<'a> {
    PlanChoices {
        csv,
        varied: &args.vary,
        results: &args.result,
    }
}

/// A sweep that was stopped, as its folder has it.
pub(super) fn resumed(
    opened: Result<(SweepFolder, StoredSweep), SweepError>,
) -> Result<OpenedSweep, CommandError> {
    let (folder, stored) = opened.map_err(|error| CommandError::Usage(error.to_string()))?;
    let window = stored.info.window.clone();
    let SweepPlan { sweep, question } = SweepPlan::of_stored(stored).map_err(refused)?;
    Ok((sweep, folder, question, window))
}

fn refused(error: PlanError) -> CommandError {
    match error {
        PlanError::Invalid(faults) => CommandError::Invalid(faults),
        PlanError::LoadCases(LoadCaseError::Table(fault)) => CommandError::Invalid(vec![*fault]),
        PlanError::Result(why) => CommandError::Usage(format!("--result: {why}.")),
        error => CommandError::Usage(error.to_string()),
    }
}
