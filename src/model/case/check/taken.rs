//! What a published value or trend is taken over: a statistic that suits it, a window of time, a stretch of the line.

use crate::case::diagnostic::Finding;
use crate::case::fields::{either, quantity};
use crate::case::model::Statistic;
use crate::case::schema::Key;
use crate::case::{LineQuantity, QuantityId, Subject};

/// What is wrong, and what would be right.
type ProblemAndRemedy = (String, String);

/// A statistic that suits what it is taken of.
pub(super) fn suits(statistic: &Key<'_, Statistic>, channel: &Key<'_, Subject>) -> Option<Finding> {
    let (problem, remedy) = unsuited(statistic.value()?, channel.get()?)?;
    Some(statistic.finding(problem, remedy))
}

/// Checks of a result by its whole name, `tension_n[mooring|b].max(0..20)`.
#[must_use]
pub fn of_result(key: &Key<'_, String>, id: &QuantityId) -> Option<Finding> {
    let QuantityId::Statistic {
        of,
        statistic,
        within,
        nth,
    } = id
    else {
        return None;
    };
    let window = within.and_then(|within| match of.line_quantity() {
        Some(_) => backward(within),
        None => empty(within),
    });
    let number = match (statistic.is_numbered(), nth) {
        (true, None) => Some(unnumbered(
            *statistic,
            &format!("end its name in a number: `{}_1`", statistic.name()),
        )),
        _ => None,
    };
    let (problem, remedy) = unsuited(*statistic, of).or(window).or(number)?;
    Some(key.finding(problem, remedy))
}

/// Statistics over time are taken of channels, those over arc length of quantities of the whole line.
fn unsuited(taken: Statistic, channel: &Subject) -> Option<ProblemAndRemedy> {
    let along = channel.line_quantity().is_some();
    let fits = if along {
        Statistic::along_line
    } else {
        Statistic::over_time
    };
    if fits(taken) {
        return None;
    }
    let word = taken.name();
    let fitting = Statistic::ALL.into_iter().filter(|s| fits(*s));
    let words: Vec<&str> = fitting.map(Statistic::name).collect();
    Some(if along {
        (
            format!("`{word}` goes over time, and `{channel}` over the length of the line"),
            format!("take {}", either(&words)),
        )
    } else {
        (
            format!("`{word}` goes over the length of the line, and a channel over time"),
            format!(
                "take {}, or name a quantity of the whole line: {}",
                either(&words),
                either(&LineQuantity::ALL.map(LineQuantity::name))
            ),
        )
    })
}

/// A window runs forward. One that ends after the run is no fault: whoever shortens a run for a
/// first look may do so, and the row is then not computed.
pub(super) fn window(window: &Key<'_, [f64; 2]>, channel: Option<&Subject>) -> Option<Finding> {
    if let Some((quantity, _)) = channel.and_then(Subject::line_quantity) {
        let name = quantity.name();
        let problem = format!("`{name}` of the whole line is taken over the whole run");
        return window.if_given(problem, "leave the window out");
    }
    of_window(window)
}

/// A window of time that does not run forward.
#[must_use]
pub fn of_window(window: &Key<'_, [f64; 2]>) -> Option<Finding> {
    let (problem, remedy) = empty(window.value()?)?;
    Some(window.finding(problem, remedy))
}

fn empty([from, to]: [f64; 2]) -> Option<ProblemAndRemedy> {
    (from >= to).then(|| {
        let (from, to) = (quantity(from, "s"), quantity(to, "s"));
        let problem = format!("the window is empty: it begins at {from} and ends at {to}");
        (problem, "let it begin before it ends".to_owned())
    })
}

/// A stretch runs from A towards B, and is one of a quantity of the whole line.
pub(super) fn stretch(stretch: &Key<'_, [f64; 2]>, channel: &Key<'_, Subject>) -> Option<Finding> {
    let over_time = |subject: &&Subject| subject.line_quantity().is_none();
    if let Some(channel) = channel.get().filter(over_time) {
        let problem = format!("`{channel}` is recorded against time, not along the line");
        let remedy = "leave the stretch out, or name a quantity of the whole line";
        return stretch.if_given(problem, remedy);
    }
    forward(stretch)
}

/// A stretch runs from A towards B.
pub(super) fn forward(stretch: &Key<'_, [f64; 2]>) -> Option<Finding> {
    let (problem, remedy) = backward(stretch.value()?)?;
    Some(stretch.finding(problem, remedy))
}

fn backward([from, to]: [f64; 2]) -> Option<ProblemAndRemedy> {
    (from > to).then(|| {
        let (from, to) = (quantity(from, "m"), quantity(to, "m"));
        let problem = format!("the stretch runs backward: from {from} to {to}");
        let remedy = "let it begin before it ends; both the same for one place";
        (problem, remedy.to_owned())
    })
}

/// A peak or a valley has a number, and nothing else has one.
pub(super) fn number(nth: &Key<'_, usize>, statistic: &Key<'_, Statistic>) -> Option<Finding> {
    let taken = statistic.value()?;
    let word = taken.name();
    if !taken.is_numbered() {
        let problem = format!("`{word}` has no number: only `peak` and `valley` have one");
        return nth.if_given(problem, "leave `nth` out, or take `peak` or `valley`");
    }
    (!nth.is_given()).then(|| {
        let remedy = "add `nth = 1` for the first from end A, 2 for the next";
        let (problem, remedy) = unnumbered(taken, remedy);
        statistic.finding(problem, remedy)
    })
}

fn unnumbered(taken: Statistic, remedy: &str) -> ProblemAndRemedy {
    let problem = format!("which {} is meant is not stated", taken.name());
    (problem, remedy.to_owned())
}
