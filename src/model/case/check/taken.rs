//! What a published value or trend is taken over: a statistic that suits it, a window of time, a stretch of the line.

use crate::case::diagnostic::Finding;
use crate::case::fields::{either, quantity};
use crate::case::model::Statistic;
use crate::case::schema::Key;
use crate::case::{LineQuantity, Subject};

/// Statistics over time are taken of channels, those over arc length of quantities of the whole line.
pub(super) fn suits(statistic: &Key<'_, Statistic>, channel: &Key<'_, Subject>) -> Option<Finding> {
    let (taken, channel) = (statistic.value()?, channel.get()?);
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
    let (problem, remedy) = if along {
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
    };
    Some(statistic.finding(problem, remedy))
}

/// A window runs forward. One that ends after the run is no fault: whoever shortens a run for a
/// first look may do so, and the row is then not computed.
pub(super) fn window(window: &Key<'_, [f64; 2]>, channel: Option<&Subject>) -> Option<Finding> {
    if let Some((quantity, _)) = channel.and_then(Subject::line_quantity) {
        let name = quantity.name();
        let problem = format!("`{name}` of the whole line is taken over the whole run");
        return window.if_given(problem, "leave the window out");
    }
    let [from, to] = window.value()?;
    (from >= to).then(|| {
        let problem = format!(
            "the window is empty: it begins at {} and ends at {}",
            quantity(from, "s"),
            quantity(to, "s")
        );
        window.finding(problem, "let it begin before it ends")
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
    let [from, to] = stretch.value()?;
    (from > to).then(|| {
        let problem = format!(
            "the stretch runs backward: from {} to {}",
            quantity(from, "m"),
            quantity(to, "m")
        );
        stretch.finding(
            problem,
            "let it begin before it ends; both the same for one place",
        )
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
        let problem = format!("which {word} is meant is not stated");
        statistic.finding(
            problem,
            "add `nth = 1` for the first from end A, 2 for the next",
        )
    })
}
