//! A published value held against its run.

use super::{Basis, Outcome, Row};
use crate::{
    case::{AlongLine, At, Published, Standing, Statistic},
    run::{Quantity, Run, RunState, quantity_name},
};

/// A computed number is good evidence when its own error is at most this part of the tolerance.
const ERROR_SHARE: f64 = 0.1;

pub(super) fn row<'r>(
    published: &Published,
    all: &[Published],
    lookup: &dyn Fn(Option<&At>) -> Option<&'r Run>,
) -> Row {
    let tolerance = tolerance(published);
    let found = lookup(published.at.as_ref())
        .ok_or_else(|| "This variant of the case has not been run.".to_owned())
        .and_then(|run| {
            find(
                run,
                &published.channel,
                published.statistic,
                published.window_s,
            )
        });
    let unit = match &found {
        Ok(quantity) => quantity.unit.clone(),
        Err(_) => published.statistic.unit(unit_of(&published.channel)),
    };
    let mut row = Row {
        name: published.name.clone(),
        at: published.at.clone(),
        source: published.source.clone(),
        published: Some(published.value),
        computed: None,
        unit,
        error: None,
        difference: None,
        tolerance: Some(tolerance),
        outcome: Outcome::NotRun,
        inputs: Some(published.inputs),
        fitted: published.fitted,
        basis: basis(published, all),
        reason: None,
        trend: None,
    };
    match found {
        Err(reason) => row.reason = Some(reason),
        Ok(quantity) => judge(&mut row, published, quantity, tolerance),
    }
    row
}

/// What the inputs make of an agreement, in the light of everything the case was fitted to.
fn basis(published: &Published, all: &[Published]) -> Option<Basis> {
    let same = |other: &Published| {
        other.channel == published.channel
            && other.statistic == published.statistic
            && other.window_s == published.window_s
            && other.at == published.at
    };
    if published.fitted {
        Some(Basis::Fitted)
    } else if all.iter().any(|other| other.fitted && same(other)) {
        Some(Basis::FittedNearby)
    } else {
        (published.inputs == Standing::Calibrated).then_some(Basis::Prediction)
    }
}

fn judge(row: &mut Row, published: &Published, quantity: &Quantity, tolerance: f64) {
    let difference = quantity.value - published.value;
    let within = difference.abs() <= tolerance;
    row.computed = Some(quantity.value);
    row.error = quantity.error_estimate();
    row.difference = Some(difference);
    (row.outcome, row.reason) = match (within, &published.out_of_reach) {
        (true, None) => (Outcome::Pass, None),
        (true, Some(_)) => (Outcome::Pass, Some(REACHED.to_owned())),
        (false, None) => (Outcome::Fail, None),
        (false, Some(reason)) => (Outcome::Differs, Some(reason.clone())),
    };
    if row
        .error
        .is_some_and(|error| error > ERROR_SHARE * tolerance)
    {
        let note = "Its estimated numerical error is more than a tenth of the tolerance.";
        row.reason = Some(match row.reason.take() {
            Some(reason) => format!("{reason} {note}"),
            None => note.to_owned(),
        });
    }
}

pub(super) const REACHED: &str =
    "The case declares this out of reach, and yet it is reached: the declaration can go.";

/// The greatest difference that passes; with both tolerances given, the wider one.
fn tolerance(published: &Published) -> f64 {
    let relative = published.tolerance_rel.map(|t| t * published.value.abs());
    let absolute = published.tolerance_abs;
    match (relative, absolute) {
        (Some(r), Some(a)) => r.max(a),
        (r, a) => r.or(a).unwrap_or(0.0),
    }
}

/// The number in a run, or why it is not there.
pub(super) fn find<'r>(
    run: &'r Run,
    channel: &str,
    statistic: Statistic,
    window_s: Option<[f64; 2]>,
) -> Result<&'r Quantity, String> {
    if let Some(why) = unfinished(run) {
        return Err(why);
    }
    let name = quantity_name(channel, statistic, window_s);
    let found = run.summary.iter().find(|q| q.name == name);
    let quantity = found.ok_or_else(|| missing(run, channel, &name))?;
    if quantity.value.is_finite() {
        Ok(quantity)
    } else {
        Err(format!("The run gives no finite value for `{name}`."))
    }
}

fn unfinished(run: &Run) -> Option<String> {
    match run.info.state {
        RunState::Done => None,
        RunState::Failed => {
            let why = run.info.failure.as_deref().unwrap_or("no reason was given");
            Some(format!("The run failed: {why}"))
        }
        RunState::Cancelled => Some("The run was cancelled before its end.".to_owned()),
        RunState::Partial => Some("The run is partial: it never came to its end.".to_owned()),
    }
}

fn missing(run: &Run, channel: &str, name: &str) -> String {
    if AlongLine::named(channel).is_some_and(AlongLine::of_bending) && !run.profile.bends() {
        return format!("Nothing bends in this run, so it has no `{name}`.");
    }
    if run.history.channel(channel).is_some() || AlongLine::named(channel).is_some() {
        return format!("The summary of the run does not hold `{name}`.");
    }
    let known: Vec<&str> = run
        .history
        .channels
        .iter()
        .map(|c| c.name.as_str())
        .collect();
    format!(
        "The run has no channel `{channel}`; it has {}.",
        known.join(", ")
    )
}

/// Unit of a channel by its name, for rows without a run: `tension_n[…]` is in N.
pub(super) fn unit_of(channel: &str) -> &'static str {
    if let Some(quantity) = AlongLine::named(channel) {
        return quantity.unit();
    }
    let quantity = channel.split('[').next().unwrap_or(channel);
    let units = [
        ("_m_per_s", "m/s"),
        ("_n", "N"),
        ("_m", "m"),
        ("_deg", "deg"),
        ("_s", "s"),
    ];
    units
        .into_iter()
        .find(|(end, _)| quantity.ends_with(end))
        .map_or("", |(_, unit)| unit)
}
