//! Views, tables and analyses of a system of lines.

use super::part_view::with_table;
use crate::chart::Chart;
use crate::report::system::{analysis, tables, views};
use crate::state::SystemView;
use crate::state::parts::{PartView, ScreenPart};
use crate::system::analysis::analyses::OffsetCurve;
use crate::system::analysis::periods::NaturalModes;
use crate::system::analysis::watch_circle::WatchCircle;
use crate::system::warnings::warnings;
use crate::table::Table;

/// Numbers of the tabs of analyses.
const CLEARANCES: usize = 4;
const PERIODS: usize = 5;
const EQUILIBRIA: usize = 6;
const OFFSETS: usize = 7;
const WATCH_CIRCLE: usize = 8;

pub(super) fn view(system: &SystemView, part: ScreenPart) -> PartView {
    let solved = &system.solved;
    with_table(match part {
        ScreenPart::Tab(0) => (None, tables::lines(solved)),
        ScreenPart::Tab(1) => (None, tables::points(solved)),
        ScreenPart::Tab(2 | 3) if solved.network.bodies.is_empty() => {
            (None, Table::titled("The system has no body."))
        }
        ScreenPart::Tab(2) => (None, tables::bodies(solved)),
        ScreenPart::Tab(tab @ CLEARANCES..) => analyses(system, tab),
        ScreenPart::Tab(_) => (None, tables::stiffness(solved, 0)),
        _ => return drawn(system),
    })
}

/// A view of the lines, and the lines in numbers.
fn drawn(system: &SystemView) -> PartView {
    let solved = &system.solved;
    PartView {
        chart: Some(match system.view {
            0 => views::plan(solved),
            1 => views::side(solved),
            _ => views::oblique(solved),
        }),
        table: Table {
            title: warning(&warnings(solved)),
            ..tables::lines_beside(solved)
        },
        ..PartView::default()
    }
}

/// The first of the warnings, and where the others are; nothing without any.
fn warning(all: &[String]) -> String {
    match all {
        [] => String::new(),
        [only] => format!("! {only}"),
        [first, others @ ..] => format!("! {first} ({} more in the report)", others.len()),
    }
}

/// Chart and table of a tab of the analyses, once they are worked out.
fn analyses(system: &SystemView, tab: usize) -> (Option<Chart>, Table) {
    let Some(analyses) = &system.analyses else {
        return (None, Table::titled("Not worked out yet."));
    };
    match tab {
        CLEARANCES => {
            let table = analysis::clearances(&system.solved, &analyses.clearances);
            (None, table)
        }
        PERIODS => (None, periods(system, &analyses.periods)),
        EQUILIBRIA => {
            let table = analysis::equilibria(&system.solved, &analyses.others);
            (None, table)
        }
        OFFSETS => offsets(system, &analyses.offsets),
        WATCH_CIRCLE => watch_circle(system, &analyses.circles),
        _ if analyses.goals.is_empty() => (None, none_asked("[[goals]]")),
        _ => (None, analysis::goals(&analyses.goals)),
    }
}

fn periods(system: &SystemView, periods: &Result<NaturalModes, String>) -> Table {
    match periods {
        Ok(found) if found.modes.is_empty() => Table::titled(
            "No body and no free point of the system has a mass; add `mass_kg` and `inertia_kg_m2`.",
        ),
        Ok(found) => analysis::periods(&system.solved, found),
        Err(why) => Table::titled(format!("No natural periods: {why}.")),
    }
}

fn offsets(system: &SystemView, curves: &[OffsetCurve]) -> (Option<Chart>, Table) {
    let Some(curve) = curves.first() else {
        return (None, none_asked("[[offset_curves]]"));
    };
    let chart = analysis::offset_chart(curve.heading_deg, &curve.points);
    let table = analysis::offset_curve(&system.solved, curve);
    (Some(chart), with_rest_in_report(table, curves.len()))
}

fn watch_circle(system: &SystemView, circles: &[(usize, WatchCircle)]) -> (Option<Chart>, Table) {
    let Some((_, circle)) = circles.first() else {
        return (None, none_asked("[[watch_circles]]"));
    };
    let chart = analysis::watch_chart(&system.solved, circle);
    let table = analysis::watch_circle(&system.solved, circle);
    (Some(chart), with_rest_in_report(table, circles.len()))
}

fn none_asked(table: &str) -> Table {
    Table::titled(format!("The file asks for none; add {table} to it."))
}

/// The tab shows the first of several; the table says where the others are.
fn with_rest_in_report(mut table: Table, count: usize) -> Table {
    if count > 1 {
        let note = format!("The first of {count}; the report has all.");
        table.notes.push(note);
    }
    table
}
