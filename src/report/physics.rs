//! What leaving an effect out changes and costs, as a table.

use super::comparison::result_text;
use super::number::{duration, percent, rounded, si};
use super::table::{Align, Cell, CellStyle, Table};
use seacable_model::case::QuantityId;
use seacable_runs::run::Quantity;
use seacable_studies::study::physics::{Omission, PhysicsStudy, PhysicsVariant};

/// Smaller changes are shown as less than this.
const LEAST: f64 = 1e-4;

/// The table of a study of physics: an effect a row, the change of each result without it in percent of the result (in its unit where that
/// is zero), how many of all results change by more than their error, CPU time and steps by those of the case itself.
#[must_use]
pub fn table(study: &PhysicsStudy, results: &[QuantityId]) -> Table {
    let rows: Vec<(usize, &PhysicsVariant)> = (1..).zip(&study.variants).collect();
    let mut table =
        Table::of_records("", &rows).text("left out, or changed", |(number, variant)| {
            let verdict = verdict(study, variant, results);
            format!("[{number}] {}: {verdict}", variant.part.name)
        });
    for (place, id) in results.iter().enumerate() {
        table = table.cell(
            &format!("R{}", place + 1),
            Align::Right,
            move |(_, variant)| change(study, variant, id),
        );
    }
    table
        .cell("changed", Align::Right, |(_, variant)| {
            match variant.run() {
                Err(_) => Cell::none(),
                Ok(_) => {
                    let (changed, known) = study.changed(variant);
                    Cell::plain(format!("{changed}/{known}"))
                }
            }
        })
        .cell("CPU time", Align::Right, |(_, variant)| {
            let own = study.base.run.info.cost.cpu_s;
            ratio(variant, own, |run| run.info.cost.cpu_s)
        })
        .cell("steps", Align::Right, |(_, variant)| {
            let own = study.base.run.info.work.steps as f64;
            ratio(variant, own, |run| run.info.work.steps as f64)
        })
        .build()
        .noted(notes(study, results))
}

/// The change of a result; in brackets where it is within the error.
fn change(study: &PhysicsStudy, variant: &PhysicsVariant, id: &QuantityId) -> Cell {
    let Some(omission) = study.omission(variant, id) else {
        return Cell::none();
    };
    let text = change_text(&omission, &id.unit());
    match omission.matters {
        Some(true) => Cell::plain(text),
        Some(false) => Cell::new(format!("({text})"), CellStyle::Dim),
        None => Cell::new(format!("{text} ?"), CellStyle::Warn),
    }
}

/// A change in percent of the result, short; in its unit where the result is zero.
fn change_text(omission: &Omission, unit: &str) -> String {
    match omission.relative {
        None => si(omission.change, unit),
        Some(share) if share != 0.0 && share.abs() < LEAST => "<0.01 %".to_owned(),
        Some(share) => percent(share),
    }
}

fn ratio(
    variant: &PhysicsVariant,
    own: f64,
    of: impl Fn(&seacable_studies::study::points::PointRun) -> f64,
) -> Cell {
    match variant.run() {
        Ok(run) if own > 0.0 => Cell::plain(format!("x {}", rounded(of(run) / own, 2))),
        _ => Cell::none(),
    }
}

/// Whether the effect is needed for the results shown.
fn verdict(study: &PhysicsStudy, variant: &PhysicsVariant, results: &[QuantityId]) -> &'static str {
    if variant.run().is_err() {
        return "not computed";
    }
    let omissions = results.iter().filter_map(|id| study.omission(variant, id));
    let known: Vec<Option<bool>> = omissions.map(|omission| omission.matters).collect();
    if known.contains(&Some(true)) {
        "matters"
    } else if known.is_empty() || known.contains(&None) {
        "unknown"
    } else {
        "within error"
    }
}

fn notes(study: &PhysicsStudy, results: &[QuantityId]) -> Vec<String> {
    let info = &study.base.run.info;
    let shown = results.iter().zip(1..).map(|(id, number)| {
        let value = study.base.run.result(id);
        let value = value.map_or_else(|| "missing".to_owned(), result_text);
        format!("R{number} {id} = {value}")
    });
    let mut notes: Vec<String> = shown.collect();
    notes.push(format!(
        "The case itself: {} steps, {} of CPU time without the error estimate. Changes are without the effect less with it, by the \
         result; in brackets within the error bar of the result, with ? where that is not known or the result is not settled. \
         matters: one of these changes by more than its error bar. changed: how many of all results with an error bar do. CPU time and \
         steps are by those of the case itself, of runs computed side by side.",
        info.work.steps,
        duration(info.cost.cpu_s)
    ));
    for (number, variant) in (1..).zip(&study.variants) {
        let why = variant.run().err();
        let why = why.map_or_else(String::new, |why| format!(": not computed, {why}"));
        notes.push(format!(
            "[{number}] {}: {}{why}",
            variant.part.name, variant.part.how
        ));
    }
    if !study.absent.is_empty() {
        notes.push(format!("Not in this case: {}.", study.absent.join(", ")));
    }
    let kept = study
        .kept
        .iter()
        .map(|(name, why)| format!("{name} ({why})"));
    notes.push(format!(
        "Cannot be left out: {}.",
        kept.collect::<Vec<_>>().join("; ")
    ));
    notes
}

/// The same for other programs: a row an effect and result, every digit kept.
#[must_use]
pub fn csv_table(study: &PhysicsStudy, results: &[QuantityId]) -> Table {
    let rows: Vec<(&PhysicsVariant, &QuantityId)> = study
        .variants
        .iter()
        .flat_map(|variant| results.iter().map(move |id| (variant, id)))
        .collect();
    let number =
        |value: Option<f64>| Cell::plain(value.map_or_else(String::new, |value| value.to_string()));
    let base = |id: &QuantityId| study.base.run.result(id);
    Table::of_records("", &rows)
        .text("left out", |(variant, _)| variant.part.name)
        .text("how", |(variant, _)| variant.part.how)
        .text("result", |(_, id)| id.to_string())
        .text("unit", |(_, id)| id.unit())
        .cell("base", Align::Right, |(_, id)| {
            number(base(id).map(|q| q.value))
        })
        .cell("base_error", Align::Right, |(_, id)| {
            number(base(id).and_then(Quantity::error_estimate))
        })
        .cell("value", Align::Right, |(variant, id)| {
            let run = variant.run().ok();
            number(
                run.and_then(|run| run.result(id))
                    .map(|quantity| quantity.value),
            )
        })
        .cell("change", Align::Right, |(variant, id)| {
            number(study.omission(variant, id).map(|omission| omission.change))
        })
        .text("matters", |(variant, id)| {
            let matters = study
                .omission(variant, id)
                .and_then(|omission| omission.matters);
            matters.map_or_else(String::new, |matters| matters.to_string())
        })
        .cell("cpu_s", Align::Right, |(variant, _)| {
            number(variant.run().ok().map(|run| run.info.cost.cpu_s))
        })
        .cell("steps", Align::Right, |(variant, _)| {
            number(variant.run().ok().map(|run| run.info.work.steps as f64))
        })
        .text("reason", |(variant, _)| {
            variant.run().err().unwrap_or_default()
        })
        .build()
}
