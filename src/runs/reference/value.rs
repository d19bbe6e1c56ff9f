//! The comparison of a published value with its run.

use crate::published::{CalibrationBasis, RowKind, ValidationRow, compare, tolerance};
use crate::{
    case::{ChannelId, Evidence, LineQuantity, Provenance, Published, Statistic, StudyPoint},
    run::{Channel, Profile, Quantity, QuantityId, Run, RunState, Subject, along_line},
};

pub(super) fn row<'r>(
    published: &Published,
    all: &[Published],
    lookup: &dyn Fn(Option<&StudyPoint>) -> Option<&'r Run>,
) -> ValidationRow {
    let found = found(published, lookup);
    let is_ratio = published.ratio_to.is_some() || published.by_stretch_m.is_some();
    let unit = if is_ratio {
        "-".to_owned()
    } else {
        published.statistic.unit(published.channel.unit())
    };
    let basis = basis(published, all);
    let kind = match basis {
        Some(CalibrationBasis::FittedNearby) => RowKind::Fitted,
        _ => published.kind.into(),
    };
    let row = ValidationRow {
        kind,
        note: published.note.clone(),
        tolerance_reason: published.tolerance_reason.clone(),
        at: published.at.clone(),
        from: published.change_from.clone(),
        by: published.ratio_to.clone(),
        published: Some(published.value),
        tolerance: Some(tolerance(
            published.value,
            published.tolerance_rel,
            published.tolerance_abs,
        )),
        inputs: Some(published.inputs),
        basis,
        ..ValidationRow::not_run(&published.name, &published.source, unit)
    };
    let number = found.map(|quantity| (quantity.value, quantity.error_estimate()));
    compare(row, published.out_of_reach.as_deref(), number)
}

/// The number of the row's variant or, of a change, how far it is from that of the variant it is a change from.
fn found<'r>(
    published: &Published,
    lookup: &dyn Fn(Option<&StudyPoint>) -> Option<&'r Run>,
) -> Result<Quantity, String> {
    let number = |at: Option<&StudyPoint>| {
        let run =
            lookup(at).ok_or_else(|| "This variant of the case has not been run.".to_owned())?;
        find(
            run,
            &published.channel,
            published.statistic,
            published.within(),
            published.nth,
        )
    };
    let quantity = number(published.at.as_ref())?.clone();
    if let Some(stretch) = published.by_stretch_m {
        let run = lookup(published.at.as_ref());
        let run = run.ok_or_else(|| "This variant of the case has not been run.".to_owned())?;
        let other = find(
            run,
            &published.channel,
            published.statistic,
            Some(stretch),
            published.nth,
        )?;
        return Ok(ratio(&quantity, other));
    }
    if let Some(other) = &published.ratio_to {
        return Ok(ratio(&quantity, number(Some(other))?));
    }
    let Some(before) = &published.change_from else {
        return Ok(quantity);
    };
    let before = number(Some(before))?;
    let both = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a + b);
    Ok(Quantity {
        value: quantity.value - before.value,
        time_error: both(quantity.time_error, before.time_error),
        mesh_error: both(quantity.mesh_error, before.mesh_error),
        unsettled: None,
        ..quantity
    })
}

/// The ratio of two numbers; its unit is 1. Two variants computed on one mesh by one method have similar errors, most of
/// which cancel: the greater of both relative errors is taken.
fn ratio(quantity: &Quantity, other: &Quantity) -> Quantity {
    let value = quantity.value / other.value;
    let both = |a: Option<f64>, b: Option<f64>| {
        let (a, b) = a.zip(b)?;
        Some(value.abs() * (a / quantity.value.abs()).max(b / other.value.abs()))
    };
    Quantity {
        id: quantity.id.clone(),
        value,
        time_error: both(quantity.time_error, other.time_error),
        mesh_error: both(quantity.mesh_error, other.mesh_error),
        unsettled: None,
    }
}

/// How far an agreement is evidence, given everything the case was fitted to.
fn basis(published: &Published, all: &[Published]) -> Option<CalibrationBasis> {
    let same = |other: &Published| {
        other.channel == published.channel
            && other.statistic == published.statistic
            && other.within() == published.within()
            && other.nth == published.nth
            && other.change_from == published.change_from
            && other.ratio_to == published.ratio_to
            && other.by_stretch_m == published.by_stretch_m
            && other.at == published.at
    };
    if published.kind == Evidence::Fitted {
        Some(CalibrationBasis::Fitted)
    } else if all
        .iter()
        .any(|other| other.kind == Evidence::Fitted && same(other))
    {
        Some(CalibrationBasis::FittedNearby)
    } else {
        (published.inputs == Provenance::Calibrated).then_some(CalibrationBasis::Prediction)
    }
}

/// The number in a run, or why it is not there.
pub(super) fn find<'r>(
    run: &'r Run,
    subject: &Subject,
    statistic: Statistic,
    within: Option<[f64; 2]>,
    nth: Option<usize>,
) -> Result<&'r Quantity, String> {
    if let Some(why) = unfinished(run) {
        return Err(why);
    }
    let id = QuantityId::new(subject.clone(), statistic, within).numbered(nth);
    let found = run.summary.iter().find(|q| q.id == id);
    let quantity = found.ok_or_else(|| missing(run, subject, &id))?;
    if quantity.value.is_finite() {
        Ok(quantity)
    } else {
        Err(format!("The run gives no finite value for `{id}`."))
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

fn missing(run: &Run, subject: &Subject, id: &QuantityId) -> String {
    match subject {
        _ if let Some((quantity, line)) = subject.line_quantity() => {
            along(run, (quantity, line), id)
        }
        Subject::Channel(channel) if run.history.channels.iter().all(|c| c.id != *channel) => {
            no_channel(run, channel)
        }
        _ => format!("The summary of the run does not hold `{id}`."),
    }
}

/// Why a number along a line is missing.
fn along(run: &Run, (quantity, line): (LineQuantity, &str), id: &QuantityId) -> String {
    let none = Profile::default();
    let known = run.profiles.iter().find(|profile| profile.line == line);
    let profile = match known {
        None if !run.profiles.is_empty() => return format!("The run has no line `{line}`."),
        known => known.unwrap_or(&none),
    };
    if quantity.of_bending() && !profile.bends() {
        return format!("Nothing bends in this run, so it has no `{id}`.");
    }
    too_few(profile, quantity, id)
        .unwrap_or_else(|| format!("The summary of the run does not hold `{id}`."))
}

/// Why there is no n-th peak or valley, where there are fewer.
fn too_few(profile: &Profile, quantity: LineQuantity, id: &QuantityId) -> Option<String> {
    let QuantityId::Statistic {
        statistic,
        within,
        nth,
        ..
    } = id
    else {
        return None;
    };
    let name = quantity.name();
    let count = |statistic| along_line(profile, quantity, statistic, *within, None);
    let (count, what) = match statistic {
        Statistic::Peak => (count(Statistic::Peaks)?, "peaks"),
        Statistic::Valley => (
            count(Statistic::Turns)? - count(Statistic::Peaks)?,
            "valleys",
        ),
        _ => return None,
    };
    nth.is_some_and(|nth| nth as f64 > count)
        .then(|| format!("`{name}` has {count} {what} there, so there is no `{id}`."))
}

fn no_channel(run: &Run, channel: &ChannelId) -> String {
    let known: Vec<String> = run.history.channels.iter().map(Channel::name).collect();
    format!(
        "The run has no channel `{channel}`; it has {}.",
        known.join(", ")
    )
}
