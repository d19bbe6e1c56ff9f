//! Drawing and tables of a ropeway with its cargo where the user has put it.

use super::part_view::with_table;
use crate::chart::Chart;
use crate::number::rounded;
use crate::report::ropeway::{cargo, drawing, tables, winch};
use crate::ropeway::elastic::Carrier;
use crate::ropeway::{ModelResults, SolvedRopeway};
use crate::state::RopewayView;
use crate::state::parts::{PartView, ScreenPart};
use crate::table::{CellStyle, Table};

pub(super) fn view(ropeway: &RopewayView, part: ScreenPart) -> PartView {
    let solved = &ropeway.worked;
    with_table(match part {
        ScreenPart::Tab(0) => (None, tables::crossing(solved, 20)),
        ScreenPart::Tab(1) => (Some(winch::hauling_chart(solved)), winch::hauling(solved)),
        ScreenPart::Tab(2) => winch_on_ship(solved),
        ScreenPart::Tab(3) => (Some(cargo::crossing_chart(solved)), cargo::cargo(solved)),
        ScreenPart::Tab(4) => (None, ropes(ropeway)),
        ScreenPart::Tab(_) => {
            let none = || Table::titled("The file has no finite-element check.");
            (None, tables::weight_check(solved).unwrap_or_else(none))
        }
        _ => return drawn(ropeway),
    })
}

fn winch_on_ship(solved: &SolvedRopeway) -> (Option<Chart>, Table) {
    let Some(series) = solved.ship_motion() else {
        return (None, Table::titled("The ship does not move; add [motion]."));
    };
    match solved.run_winch(&series) {
        Ok(followed) => {
            let motion = solved.rope_motion();
            (
                Some(winch::winch_chart(&followed, motion.as_ref())),
                winch::winch(solved, &followed, motion.as_ref()),
            )
        }
        Err(error) => (None, Table::titled(format!("No solution: {error}."))),
    }
}

fn ropes(ropeway: &RopewayView) -> Table {
    match ropeway.results() {
        Ok(results) => tables::ropes(&ropeway.worked, &results),
        Err(error) => Table::titled(format!("No solution: {error}.")),
    }
}

/// The picture, the exact rope in words, and the models side by side.
fn drawn(ropeway: &RopewayView) -> PartView {
    let solved = &ropeway.worked;
    match ropeway.results() {
        Ok(results) => {
            let mut chart = drawing::chart(solved, &results);
            // Its title is beside the tabs; every line counts here.
            chart.title.clear();
            PartView {
                chart: Some(chart),
                table: Table {
                    title: String::new(),
                    notes: Vec::new(),
                    ..tables::models(solved, &results)
                },
                words: readout(solved, &results),
                ..PartView::default()
            }
        }
        Err(error) => {
            let words = format!("No solution with the cargo here: {error}.");
            PartView {
                words: vec![(words, CellStyle::Warn)],
                ..PartView::default()
            }
        }
    }
}

/// The exact rope, and whether the cargo is dry.
fn readout(solved: &SolvedRopeway, results: &ModelResults) -> Vec<(String, CellStyle)> {
    let exact = &results.exact;
    let clear = solved.clearance_m(exact);
    let words = format!(
        "exact: platform {} N  ship {} N  sag {} m  ",
        rounded(exact.platform_n(), 1),
        rounded(exact.ship_n(), 1),
        rounded(exact.sag_m, 2)
    );
    let carried = match exact.carrier {
        Carrier::Rope if clear < 0.0 => (
            format!("IN THE WATER by {} m", rounded(-clear, 2)),
            CellStyle::Bad,
        ),
        Carrier::Rope => (format!("clear by {} m", rounded(clear, 2)), CellStyle::Good),
        Carrier::Platform => ("on the platform".to_owned(), CellStyle::Plain),
        Carrier::Ship => ("on the ship".to_owned(), CellStyle::Plain),
    };
    vec![(words, CellStyle::Plain), carried]
}
