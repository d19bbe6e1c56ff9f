//! The results of the live run as the cockpit shows them: each with its error, its difference from the run held against, and
//! its share of a limit.

use std::sync::Arc;

use super::state::{Document, DocumentContent, LineView, RunsView, SystemView};
use crate::case::{
    Case, ChannelQuantity, LineQuantity, QuantityId, Statistic, Subject, TextDigest,
};
use crate::number;
use crate::run::{Quantity, Run, limits};

/// A result in words.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ResultLine {
    /// Its name.
    pub name: String,
    /// Its value with unit and error.
    pub value: String,
    /// Its difference from the run held against; empty where there is none.
    pub difference: String,
    /// Its share of a limit; empty where there is none.
    pub share: String,
    /// True where the share is above one.
    pub exceeded: bool,
    /// Whether the cockpit shows it.
    pub chosen: bool,
}

/// The run solved last, with which others are compared.
#[must_use]
pub fn solved_run(view: &RunsView) -> Option<&Arc<Run>> {
    view.live.done.as_ref()?.run.as_ref()
}

/// The run whose results are shown: the coarse one until the full one is complete.
#[must_use]
pub fn shown_run(line: &LineView) -> Option<&Arc<Run>> {
    match &line.runs_view.live.coarse {
        Some(coarse) => coarse.curves.run.as_ref(),
        None => solved_run(&line.runs_view),
    }
}

/// The results that the cockpit shows.
#[must_use]
pub fn chosen(line: &LineView) -> Vec<ResultLine> {
    let Some(run) = shown_run(line) else {
        return Vec::new();
    };
    let found = line
        .results
        .iter()
        .filter_map(|id| run.summary.iter().find(|q| q.id == *id));
    found.map(|quantity| one(line, run, quantity)).collect()
}

/// The results that the pane of results lists: of a line case those of its live solve, of a system those of the newest run of its
/// text, else those that it has at rest or will have.
#[must_use]
pub fn listed(document: &Document) -> Vec<QuantityId> {
    let of_run = |run: &Arc<Run>| run.summary.iter().map(|q| q.id.clone()).collect();
    match &document.content {
        DocumentContent::Line(line) => shown_run(line).map_or_else(Vec::new, of_run),
        DocumentContent::System(system) => match system_run(document, system) {
            Some(run) => of_run(run),
            None => system.expected.iter().map(|e| e.id.clone()).collect(),
        },
        _ => Vec::new(),
    }
}

/// The same as the pane shows them.
#[must_use]
pub fn all(document: &Document) -> Vec<ResultLine> {
    match &document.content {
        DocumentContent::Line(line) => shown_run(line).map_or_else(Vec::new, |run| {
            let results = run.summary.iter();
            results.map(|quantity| one(line, run, quantity)).collect()
        }),
        DocumentContent::System(system) => of_system(document, system),
        _ => Vec::new(),
    }
}

/// The newest complete run of the text of a system.
#[must_use]
pub fn system_run<'v>(document: &Document, system: &'v SystemView) -> Option<&'v Arc<Run>> {
    let text = TextDigest::of_text(&document.editor.text);
    system.runs_view.complete_run(text)
}

fn of_system(document: &Document, system: &SystemView) -> Vec<ResultLine> {
    let against = system.runs_view.against.as_ref();
    let line = |id: &QuantityId, found: Option<&Quantity>| {
        let other = against.and_then(|(_, run)| run.summary.iter().find(|other| other.id == *id));
        let compared = found.zip(other);
        ResultLine {
            name: id.to_string(),
            value: found.map_or_else(String::new, |quantity| value(quantity, false)),
            difference: compared.map_or_else(String::new, |(one, other)| difference(one, other)),
            ..ResultLine::default()
        }
    };
    match system_run(document, system) {
        Some(run) => run.summary.iter().map(|q| line(&q.id, Some(q))).collect(),
        None => {
            let expected = system.expected.iter();
            expected.map(|e| line(&e.id, e.at_rest.as_ref())).collect()
        }
    }
}

fn one(line: &LineView, run: &Run, quantity: &Quantity) -> ResultLine {
    let coarse = line.runs_view.live.coarse.is_some();
    // What differs from a coarse result may be nothing but its error.
    let against = line
        .runs_view
        .against
        .as_ref()
        .filter(|_| !coarse)
        .and_then(|(_, against)| against.summary.iter().find(|other| other.id == quantity.id));
    let share = share(&line.case, run, quantity);
    ResultLine {
        name: quantity.name(),
        value: value(quantity, coarse),
        difference: against.map_or_else(String::new, |other| difference(quantity, other)),
        exceeded: share.as_ref().is_some_and(|(share, _)| *share > 1.0),
        share: share.map_or_else(String::new, |(share, of)| {
            format!("{} {of}", number::percent(share))
        }),
        chosen: line.results.contains(&quantity.id),
    }
}

fn value(quantity: &Quantity, coarse: bool) -> String {
    if coarse {
        return number::coarse(quantity.value, &quantity.unit());
    }
    match quantity.unsettled {
        Some([least, greatest]) => format!(
            "not settled: {}",
            number::range(least, greatest, &quantity.unit())
        ),
        None => number::with_error(quantity.value, quantity.error_estimate(), &quantity.unit()),
    }
}

/// The difference from another run: in per cent of it for forces and the like, in units for lengths, times and angles.
fn difference(quantity: &Quantity, other: &Quantity) -> String {
    let by = quantity.value - other.value;
    if by == 0.0 {
        return "same".to_owned();
    }
    let error = |q: &Quantity| q.error_estimate().unwrap_or(0.0);
    if by.abs() <= error(quantity) + error(other) {
        return "within \u{b1}".to_owned();
    }
    let sign = if by > 0.0 { "+" } else { "-" };
    let in_units = matches!(quantity.unit().as_str(), "m" | "s" | "deg" | "%");
    if in_units || other.value == 0.0 {
        return format!("{sign}{}", number::si(by.abs(), &quantity.unit()));
    }
    format!("{sign}{}", number::percent((by / other.value).abs()))
}

/// The share of a limit: of the breaking load, or of the bending radius allowed.
fn share(case: &Case, run: &Run, quantity: &Quantity) -> Option<(f64, &'static str)> {
    let of_break = "break";
    let QuantityId::Statistic { of, statistic, .. } = &quantity.id else {
        return None;
    };
    match (of, statistic) {
        (Subject::Line(LineQuantity::Tension), Statistic::Max) => {
            let checks = limits::check(case, run.profile());
            let shares = checks
                .iter()
                .filter_map(limits::LimitCheck::tension_utilisation);
            Some((shares.reduce(f64::max)?, of_break))
        }
        (Subject::Line(LineQuantity::BendRadius), Statistic::Min) => {
            let checks = limits::check(case, run.profile());
            let shares = checks
                .iter()
                .filter_map(limits::LimitCheck::bending_utilisation);
            Some((shares.reduce(f64::max)?, "bending"))
        }
        (Subject::Channel(channel), Statistic::Max | Statistic::Final | Statistic::Mean)
            if channel.quantity == ChannelQuantity::Tension =>
        {
            Some((quantity.value / weakest(case, &channel.place)?, of_break))
        }
        _ => None,
    }
}

/// The smallest breaking load of the sections that meet at a place.
fn weakest(case: &Case, place: &str) -> Option<f64> {
    let named = |name: &str| case.line.iter().find(|section| section.name == name);
    let loads = place.split('|').filter_map(named).filter_map(|section| {
        let material = case.materials.get(&section.material)?;
        material.break_load_n.filter(|load| *load > 0.0)
    });
    loads.reduce(f64::min)
}
