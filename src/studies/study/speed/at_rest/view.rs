//! Speed against error at rest as tables and as a chart.

use super::{RestErrors, RestPoint, RestStudy};
use crate::chart::{Axis, Chart, Series};
use crate::number::digits;
use crate::table::{Align, Cell, CellStyle, NumberFormat, Table};

/// Errors within this many times that of the reference are not significant.
const SIGNIFICANT: f64 = 10.0;

/// The table: a row a point, the reference last with its own error. Numbers are bare, their units in the heads, so that
/// the same table serves as CSV.
#[must_use]
pub fn table(study: &RestStudy) -> Table {
    let points: Vec<&RestPoint> = study.points.iter().chain([&study.reference]).collect();
    let is_reference = |point: &RestPoint| std::ptr::eq(point, &raw const study.reference);
    let failed: Vec<&RestPoint> = points
        .iter()
        .copied()
        .filter(|p| p.answer.is_err())
        .collect();
    let error = |point: &RestPoint, of: fn(&RestErrors) -> f64| {
        NumberFormat::Digits(3, "").cell(point.errors.as_ref().map(of))
    };
    let count = |point: &RestPoint, of: fn(&super::RestAnswer) -> u64| {
        point
            .answer
            .as_ref()
            .map_or_else(|_| "-".to_owned(), |answer| of(answer).to_string())
    };
    let table = Table::of_records("", &points)
        .text("way", |point| match is_reference(point) {
            true => format!("reference: {}", point.name.solver),
            false => point.name.solver.clone(),
        })
        .text("mesh", |point| point.name.setting.clone())
        .count("CPU [ms]", |point| {
            let cpu = point
                .answer
                .as_ref()
                .map(|answer| digits(answer.cpu_s * 1e3, 3));
            cpu.unwrap_or_else(|_| "-".to_owned())
        })
        .count("Newton steps", |p| count(p, |answer| answer.steps))
        .count("line solutions", |p| count(p, |answer| answer.solutions))
        .count("iterations x segments", |p| count(p, |answer| answer.work))
        .cell("force [% of greatest]", Align::Right, |p| {
            error(p, |e| 100.0 * e.tension)
        })
        .cell("place [% of line]", Align::Right, |p| {
            error(p, |e| 100.0 * e.place)
        })
        .cell("place [m]", Align::Right, |p| error(p, |e| e.place_m))
        .cell("mark", Align::Left, |point| mark(point, &failed, study));
    let reasons = failed.iter().enumerate().map(|(i, point)| {
        let why = point.answer.as_ref().err().map_or("", String::as_str);
        format!("[{}] {}: {why}", i + 1, point.name)
    });
    table.build().noted(reasons).noted(explanations(study))
}

/// Whether a point failed, is the reference, or is near to it.
fn mark(point: &RestPoint, failed: &[&RestPoint], study: &RestStudy) -> Cell {
    let number = failed.iter().position(|one| std::ptr::eq(*one, point));
    if let Some(number) = number {
        return Cell::new(format!("FAILED [{}]", number + 1), CellStyle::Bad);
    }
    if std::ptr::eq(point, &raw const study.reference) {
        return Cell::plain("own error");
    }
    let own = study.reference.errors.map_or(0.0, |own| own.greatest());
    match point.errors {
        Some(errors) if errors.greatest() < SIGNIFICANT * own => {
            Cell::new("near the reference", CellStyle::Warn)
        }
        _ => Cell::default(),
    }
}

fn explanations(study: &RestStudy) -> Vec<String> {
    let mut notes = vec![
        "Errors are the greatest against the reference: of tensions and other forces by the greatest of them, of places of points, bodies and \
         nodes of lines by the length of the longest line. The reference's own is its distance from half its segments; what is within ten \
         times that is marked."
            .to_owned(),
        "CPU: least of the repeats, one thread, without companions. Work that no machine changes: Newton steps of the system, or of the nodes of a \
         line by itself; solutions of a line between its ends; Newton iterations of lines in segments, each by its segments."
            .to_owned(),
    ];
    if study.rigid_bed {
        let rigid = "Closed forms lie on a bed that does not yield, segments on one of its stiffness: what no mesh takes away is that of the bed.";
        notes.push(rigid.to_owned());
    }
    let left_out = study.left_out.iter();
    notes.extend(left_out.map(|what| format!("Left out: {what}.")));
    notes
}

/// The setting recommended for each accuracy: the cheapest that is as accurate, as are all finer meshes of its way.
#[must_use]
pub fn recommended_table(study: &RestStudy, accuracies: &[f64]) -> Table {
    let rows: Vec<(f64, Option<&RestPoint>)> = accuracies
        .iter()
        .map(|accuracy| (*accuracy, study.recommended(*accuracy)))
        .collect();
    let own = study
        .reference
        .errors
        .map_or(f64::INFINITY, |own| own.greatest());
    let none = move |accuracy: f64| match own > super::KNOWN * accuracy {
        true => format!("the reference itself errs by {}", digits(own, 2)),
        false => "none of these is as accurate".to_owned(),
    };
    Table::of_records("Cheapest that is within", &rows)
        .count("accuracy", |row| format!("{:e}", row.0))
        .text("way", move |row| match row.1 {
            Some(point) => point.name.solver.clone(),
            None => none(row.0),
        })
        .text("mesh", |row| row.1.map_or_else(String::new, |p| p.name.setting.clone()))
        .count("CPU [ms]", |row| {
            let answer = row.1.and_then(|point| point.answer.as_ref().ok());
            answer.map_or_else(|| "-".to_owned(), |answer| digits(answer.cpu_s * 1e3, 3))
        })
        .cell("error [% of range]", Align::Right, |row| {
            let errors = row.1.and_then(|point| point.errors);
            NumberFormat::Digits(2, "").cell(errors.map(|errors| 100.0 * errors.greatest()))
        })
        .build()
        .noted([
            "A mesh counts where all finer ones of its way are within too: a coarse one may be by chance.",
        ])
}

/// Every result of the reference, and its error as a share of the range in what is recommended for each accuracy.
#[must_use]
pub fn results_table(study: &RestStudy, accuracies: &[f64]) -> Table {
    let Ok(reference) = &study.reference.answer else {
        return Table::default();
    };
    let mut table = Table::of_records("By result", &reference.results)
        .text("result", |result| result.name.clone())
        .text("unit", |result| result.unit)
        .count("reference", |result| digits(result.value, 6));
    for accuracy in accuracies {
        let found = study.recommended(*accuracy);
        let Some(answer) = found.and_then(|point| point.answer.as_ref().ok()) else {
            continue;
        };
        table = table.cell(
            &format!("error at {accuracy:e} [%]"),
            Align::Right,
            |result| {
                let own = answer.value(&result.name);
                let share =
                    own.map(|own| (own - result.value).abs() / reference.scale(result.unit));
                NumberFormat::Digits(2, "").cell(share.map(|share| 100.0 * share))
            },
        );
    }
    table.build()
}

/// Cost over error, both in powers of ten; a curve a way, a point a mesh. What failed is not on it, nor what is as the reference to the last digit.
#[must_use]
pub fn chart(study: &RestStudy) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for point in &study.points {
        let (Ok(answer), Some(errors)) = (&point.answer, point.errors) else {
            continue;
        };
        let at = (
            (100.0 * errors.greatest()).log10(),
            (answer.cpu_s * 1e3).log10(),
        );
        if !at.0.is_finite() {
            continue;
        }
        let known = series.iter().position(|s| s.label == point.name.solver);
        let slot = known.unwrap_or(series.len());
        if known.is_none() {
            series.push(Series::new(&point.name.solver, slot, Vec::new()));
        }
        series[slot].points.push(at);
    }
    Chart::new(
        "Cost against error: lower left is better",
        Axis::new("log10 of the greatest error, % of range", ""),
        Axis::new("log10 of CPU time, ms", ""),
        series,
    )
}
