//! `seacable sweep --window KEY=VALUES`: the greatest value of a key at which all checks pass, sea by sea, by rounds of sweeps.

use std::process::ExitCode;

use super::{
    BAD_RESULT, CommandError,
    output::{self, OutputFile},
    signals::StopFlag,
    study_page::print,
    sweep_args::SweepArgs,
    sweep_compute::compute,
};
use seacable_base::visible;
use seacable_display::plain;
use seacable_model::case::kind;
use seacable_model::kinds::FileType;
use seacable_report::window::WindowView;
use seacable_studies::study::seas::{SeaQuestion, seas};
use seacable_studies::study::sweep::{Sweep, SweepError, SweepFolder};
use seacable_studies::study::vary::{Variation, VariedKey};
use seacable_studies::study::window::{WindowKey, WindowRow};
use seacable_systems::system::SystemFile;

/// Columns of the report in the folder.
const REPORT_WIDTH: usize = 80;

/// Seeks the limiting values of the seas of a sweep's table, round by round, and prints them.
pub(super) fn window(
    args: &SweepArgs,
    word: &str,
    (sweep, folder, question): (&Sweep, &SweepFolder, &SeaQuestion),
    file: Option<&OutputFile<'_>>,
    stop: &StopFlag,
) -> Result<ExitCode, CommandError> {
    let table = &sweep.variation;
    let (key, mut rows) = begun(word, table, question)?;
    let mut round = 1;
    while let Some(variation) = key.round(table, &rows) {
        let of_round = folder
            .round(round, &variation, sweep.results.names())
            .map_err(|error| failed(&error))?;
        output::message(&format!(
            "Round {round}: {} load cases.",
            variation.points.len()
        ));
        let own = Sweep::new(variation, sweep.results.clone(), question);
        let (outcomes, _) = compute(args, (&own, question), Some(&of_round), stop)?;
        if let Some(status) = stop.status() {
            let dir = visible::argument(folder.dir());
            output::message(&format!(
                "Stopped before all was found; `seacable sweep --resume {dir}` goes on."
            ));
            return Ok(status);
        }
        let results = own.answers(&outcomes, question);
        if let Some(results) = &results {
            key.take(&mut rows, results);
        }
        round += 1;
    }
    show(args, (&key, &rows), folder, file)?;
    let found = rows.iter().all(|row| row.bracket.passes.is_some());
    Ok(if found {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

/// The key that is sought and the rows to fill, before anything is computed.
///
/// # Errors
/// A key or values that cannot be sought, or no checks.
pub(super) fn begun(
    word: &str,
    table: &Variation,
    question: &SeaQuestion,
) -> Result<(WindowKey, Vec<WindowRow>), CommandError> {
    let usage = |why: String| {
        let end = if why.ends_with(['.', '?']) { "" } else { "." };
        CommandError::Usage(format!("--window: {why}{end}"))
    };
    if question.checks.is_empty() {
        return Err(usage("there are no [[checks]] that could pass".to_owned()));
    }
    let key = key(word, &table.base.text).map_err(usage)?;
    let rows = key.rows(table, seas(table, &question.scene));
    Ok((key, rows.map_err(|error| usage(error.to_string()))?))
}

/// The key that is sought, of the file with this text.
fn key(word: &str, text: &str) -> Result<WindowKey, String> {
    let varied = match FileType::of_text(text) {
        FileType::System => VariedKey::parse_by(word, |path| kind::field::<SystemFile>(text, path)),
        _ => VariedKey::parse(word, text),
    };
    let varied = varied.map_err(|error| error.to_string())?;
    WindowKey::of_varied_key(&varied).map_err(|error| error.to_string())
}

fn failed(error: &SweepError) -> CommandError {
    CommandError::Usage(error.to_string())
}

/// Prints the table and its chart, and writes both tables into the folder.
fn show(
    args: &SweepArgs,
    (key, rows): (&WindowKey, &[WindowRow]),
    folder: &SweepFolder,
    file: Option<&OutputFile<'_>>,
) -> Result<(), CommandError> {
    let view = WindowView { key, rows };
    let (mut table, csv) = (view.table(), view.csv_table());
    let report = plain::ascii_table(&table).to_text(REPORT_WIDTH);
    let mut bytes = Vec::new();
    let written = csv.write_csv(&mut bytes).map_err(std::io::Error::other);
    written.map_err(CommandError::Output)?;
    folder
        .write_window(&bytes, &report)
        .map_err(|error| failed(&error))?;
    let dir = visible::argument(folder.dir());
    table.notes.push(format!(
        "The window is {dir}; the sweeps of its rounds stand beside it."
    ));
    let charts: Vec<_> = view.chart().into_iter().collect();
    print("window", &args.page, file, (&[table], &csv), &charts)
}
