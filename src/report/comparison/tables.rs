//! Inputs, settings, channels, published values and cost of compared runs.

use seacable_base::number::si;
use seacable_display::table::{Align, Cell, CellStyle, Table};
use seacable_runs::reference::Outcome;
use seacable_studies::comparison::{
    ComparedInput, ComparedSetting, Comparison, InputValue, letter,
};

/// Inputs that differ, a column a run.
#[must_use]
pub fn inputs_table(comparison: &Comparison) -> Table {
    let mut table =
        Table::of_records("", &comparison.inputs).text("input", |row| row.path.as_str());
    for run in 0..comparison.runs.len() {
        table = table.cell(&letter(run), Align::Left, move |row| input(row, run));
    }
    table.build()
}

fn input(row: &ComparedInput, run: usize) -> Cell {
    let Some(InputValue { text, given }) = &row.values[run] else {
        return Cell::new("not given", CellStyle::Dim);
    };
    let unit = if row.unit == "-" { "" } else { row.unit };
    let default = if *given { "" } else { "(default)" };
    let words = [text.as_str(), unit, default];
    let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
    Cell::plain(words.join(" "))
}

/// Version, file and settings that differ, a column a run.
#[must_use]
pub fn settings_table(comparison: &Comparison) -> Table {
    settings(
        &comparison.settings,
        comparison.runs.len(),
        "setting",
        Align::Left,
    )
}

/// Work and cost, a column a run.
#[must_use]
pub fn cost_table(comparison: &Comparison) -> Table {
    settings(&comparison.cost, comparison.runs.len(), "", Align::Right)
}

fn settings(rows: &[ComparedSetting], runs: usize, head: &str, align: Align) -> Table {
    let mut table = Table::of_records("", rows).text(head, |row| row.name);
    for run in 0..runs {
        table = table.cell(&letter(run), align, move |row| {
            match row.values[run].as_str() {
                "" => Cell::none(),
                text => Cell::plain(text),
            }
        });
    }
    table.build()
}

/// When every channel is greatest and smallest, and how far its history is from that of the first run; a row a run. Its extremes and
/// their errors are among the results.
#[must_use]
pub fn channels_table(comparison: &Comparison) -> Table {
    let runs = comparison.runs.len();
    let channels = comparison.channels.iter();
    let rows: Vec<_> = channels
        .flat_map(|channel| (0..runs).map(move |run| (channel, run)))
        .collect();
    let cell = |text: Option<String>| text.map_or_else(Cell::none, Cell::plain);
    Table::of_records("", &rows)
        .text("channel", |(channel, run)| match run {
            0 => channel.id.to_string(),
            _ => String::new(),
        })
        .text("run", |(_, run)| letter(*run))
        .cell("time of max", Align::Right, |(channel, run)| {
            cell(channel.extremes[*run].map(|extremes| si(extremes.max.1, "s")))
        })
        .cell("time of min", Align::Right, |(channel, run)| {
            cell(channel.extremes[*run].map(|extremes| si(extremes.min.1, "s")))
        })
        .cell("rms of difference from A", Align::Right, |(channel, run)| {
            let unit = channel.id.quantity.unit();
            let curve = channel.differences[*run].as_ref();
            cell(curve.map(|curve| si(curve.rms, unit)))
        })
        .cell("greatest difference", Align::Right, |(channel, run)| {
            let unit = channel.id.quantity.unit();
            let words = |(value, time)| format!("{} at {}", si(value, unit), si(time, "s"));
            let curve = channel.differences[*run].as_ref();
            cell(curve.map(|curve| words(curve.greatest)))
        })
        .build()
        .noted((!rows.is_empty()).then_some(
            "Differences are between the stored histories; the errors of both are those of the results above.",
        ))
}

/// Published values with the computed value and verdict of each run.
#[must_use]
pub fn validation_table(comparison: &Comparison) -> Table {
    let rows = &comparison.validation;
    let mut table = Table::of_records("", rows)
        .text("published value", |row| match &row.at {
            Some(at) => format!("{} ({} = {})", row.name, at.study, at.value),
            None => row.name.clone(),
        })
        .cell("published", Align::Right, |row| {
            let known = row.rows.iter().flatten().next();
            let number = known.and_then(|known| Some(si(known.published?, &known.unit)));
            number.map_or_else(Cell::none, Cell::plain)
        });
    for run in 0..comparison.runs.len() {
        table = table
            .cell(&letter(run), Align::Right, move |row| {
                let Some(known) = &row.rows[run] else {
                    return Cell::none();
                };
                let number = known.computed.map(|value| match known.error {
                    Some(error) if error > 0.0 => {
                        seacable_base::number::with_error(value, Some(error), &known.unit)
                    }
                    Some(_) => format!("{} ± 0", si(value, &known.unit)),
                    None => format!("{} ± ?", si(value, &known.unit)),
                });
                number.map_or_else(Cell::none, Cell::plain)
            })
            .cell("", Align::Left, move |row| {
                let outcome = row.rows[run].as_ref().map(|known| known.outcome);
                outcome.map_or_else(Cell::none, verdict)
            });
    }
    table.build()
}

fn verdict(outcome: Outcome) -> Cell {
    let style = match outcome {
        Outcome::Pass => CellStyle::Good,
        Outcome::Fail => CellStyle::Bad,
        Outcome::Differs => CellStyle::Warn,
        Outcome::NotRun | Outcome::Edited => CellStyle::Dim,
    };
    Cell::new(outcome.word(), style)
}
