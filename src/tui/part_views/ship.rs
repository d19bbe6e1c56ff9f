//! Plan view, headings and tables of a ship at rest and at sea.

use super::part_view::with_table;
use crate::chart::{Chart, marker};
use crate::number::{digits, si};
use crate::report::ship::{coupled, motion, plan, rope, statics};
use crate::ship::model::MotionSettings;
use crate::ship::rope::RopeAnalysis;
use crate::ship::stability::DynamicStability;
use crate::ship::yaw_equilibria::YawStability;
use crate::ship::{DynamicAnalysis, MooredEquilibrium, MotionAnalysis};
use crate::state::ShipView;
use crate::state::parts::{PartView, ScreenPart};
use crate::state::ship::{AT_SEA, MOTIONS};
use crate::table::{CellStyle, Table};
use crate::wrap::{WideWords, wrap};

/// Columns of the list of headings.
pub const LIST: u16 = 34;

pub(super) fn view(ship: &ShipView, part: ScreenPart) -> PartView {
    let rest = &ship.statics;
    let or = |table: Option<Table>, words: &str| table.unwrap_or_else(|| Table::titled(words));
    with_table(match part {
        ScreenPart::Tab(0) => (Some(statics::moments(rest)), statics::headings(rest)),
        ScreenPart::Tab(tab) if AT_SEA.contains(&tab) => {
            at_sea(ship, tab).unwrap_or_else(|table| (None, table))
        }
        ScreenPart::Tab(7) => {
            let words = "Dynamic stability needs [hull], and [mooring] with a solution.";
            (None, or(statics::eigenvalues(rest), words))
        }
        ScreenPart::Tab(8) => (
            None,
            or(statics::loads(rest), "There is no stable equilibrium."),
        ),
        ScreenPart::Tab(_) => {
            let words = "There is no stable equilibrium, or no [mooring] with a solution.";
            (None, or(statics::mooring(rest), words))
        }
        _ => return drawn(ship),
    })
}

/// The ship seen from above at the chosen equilibrium, and all of them in words.
fn drawn(ship: &ShipView) -> PartView {
    let mut chart = plan::chart(&ship.statics, ship.equilibrium);
    // The list beside it names the ships; every line counts here.
    chart.title.clear();
    chart.legend = false;
    PartView {
        chart: Some(chart),
        words: headings(ship),
        ..PartView::default()
    }
}

/// A part of the dynamic analysis, or why there is none.
fn analysis<'a, T>(
    ship: &'a ShipView,
    of: impl Fn(&'a DynamicAnalysis) -> Option<T>,
    none: &str,
) -> Result<T, Table> {
    let wait = || Table::titled("The dynamic analysis is still running.");
    let dynamic = ship.dynamic.as_deref().ok_or_else(wait)?;
    of(dynamic).ok_or_else(|| Table::titled(none))
}

fn motion_of(ship: &ShipView) -> Result<&MotionAnalysis, Table> {
    let none = "No motion analysis: the file has no [motion].";
    match analysis(ship, |dynamic| dynamic.motion.as_ref(), none)? {
        Ok(motion) => Ok(motion),
        Err(error) => Err(Table::titled(format!(
            "The motion analysis failed: {error}."
        ))),
    }
}

fn rope_of(ship: &ShipView) -> Result<&RopeAnalysis, Table> {
    let none = "No rope analysis: the file has no [rope].";
    match analysis(ship, |dynamic| dynamic.rope.as_ref(), none)? {
        Ok(rope) => Ok(rope),
        Err(error) => Err(Table::titled(format!("The rope analysis failed: {error}."))),
    }
}

/// Chart and table of the dynamic analysis, or why there are none.
fn at_sea(ship: &ShipView, tab: usize) -> Result<(Option<Chart>, Table), Table> {
    let settings = ship.statics.ship.motion.as_ref();
    let seed = settings.map_or(0, MotionSettings::seed);
    Ok(match tab {
        MOTIONS => {
            let analysis = motion_of(ship)?;
            let table = motion::statistics(analysis, seed);
            (Some(motion::motions(analysis, ship.trace)), table)
        }
        2 => (None, motion::spectra(motion_of(ship)?)),
        3 => {
            let rope = rope_of(ship)?;
            (Some(rope::chart(rope)), rope::table(rope))
        }
        4 => {
            let rope = rope_of(ship)?;
            let none = || Table::titled("The rope made fast has no solution.");
            let table = rope::dynamic_table(rope).unwrap_or_else(none);
            (rope::dynamic_chart(rope), table)
        }
        _ => {
            let none = "No coupled analysis: the file has no [coupled].";
            match analysis(ship, |dynamic| dynamic.coupled.as_ref(), none)? {
                Ok(coupled) if tab == 5 => (
                    Some(coupled::motions(coupled)),
                    coupled::statistics(coupled),
                ),
                Ok(coupled) => (Some(coupled::tension(coupled)), coupled::decay(coupled)),
                Err(error) => {
                    return Err(Table::titled(format!(
                        "The coupled analysis failed: {error}."
                    )));
                }
            }
        }
    })
}

/// Every equilibrium heading, and the directions of anchor and loads.
fn headings(ship: &ShipView) -> Vec<(String, CellStyle)> {
    let mut lines = Vec::new();
    match &ship.statics.equilibria {
        Ok(equilibria) => {
            for (i, equilibrium) in equilibria.iter().enumerate() {
                lines.extend(equilibrium_lines(i, equilibrium, i == ship.equilibrium));
            }
        }
        Err(error) => {
            let words = wrap(
                &format!("No equilibrium heading: {error}."),
                LIST.into(),
                WideWords::Broken,
            );
            lines.extend(words.into_iter().map(|line| (line, CellStyle::Bad)));
        }
    }
    lines.push((String::new(), CellStyle::Plain));
    let count = ship.statics.equilibria.as_ref().map_or(0, Vec::len);
    let names = ["anchor"].into_iter().map(str::to_owned);
    let flows = ship.statics.loads.each.iter().map(|load| {
        let name = plan::name(load);
        format!(
            "{name} towards {} deg",
            digits(load.towards.to_degrees(), 4)
        )
    });
    for (i, name) in names.chain(flows).enumerate() {
        lines.push((format!("{} {name}", marker(count + i)), CellStyle::Plain));
    }
    lines
}

/// Lines on an equilibrium: heading and stability, and of the chosen one mooring and dynamics.
fn equilibrium_lines(
    i: usize,
    equilibrium: &MooredEquilibrium,
    chosen: bool,
) -> Vec<(String, CellStyle)> {
    let yaw = &equilibrium.yaw;
    let style = match (yaw.stability, equilibrium.dynamic_stability()) {
        (YawStability::Stable, None | Some(DynamicStability::Stable { .. })) => CellStyle::Good,
        (
            YawStability::Stable,
            Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. }),
        ) => CellStyle::Bad,
        _ => CellStyle::Plain,
    };
    let head = if chosen { ">" } else { " " };
    let mut lines = vec![(
        format!(
            "{head}{} {} {} deg {}",
            i + 1,
            marker(i),
            digits(yaw.heading.to_degrees(), 5),
            plan::stability(equilibrium)
        ),
        style,
    )];
    if !chosen {
        return lines;
    }
    let mut say = |words: String| lines.push((format!("    {words}"), CellStyle::Plain));
    say(format!("statically {}", yaw.stability.label()));
    say(format!("pull {}", si(yaw.pull, "N")));
    match &equilibrium.line {
        Some(Ok(line)) => {
            say(format!("bow {} from anchor", si(line.distance, "m")));
            if line.anchor_uplift > 0.0 {
                say(format!("ANCHOR UPLIFT {}", si(line.anchor_uplift, "N")));
            }
        }
        Some(Err(_)) => say("no mooring solution".to_owned()),
        None => say("no mooring line given".to_owned()),
    }
    match equilibrium.dynamic_stability().map(DynamicStability::times) {
        Some((period, time)) => {
            let seconds = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| si(v, "s"));
            let grows = matches!(
                equilibrium.dynamic_stability(),
                Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. })
            );
            let name = if grows { "doubling time" } else { "half-life" };
            say(format!("period {}", seconds(period)));
            say(format!("{name} {}", seconds(time)));
        }
        None => say("dynamic stability: give [hull]".to_owned()),
    }
    lines
}
