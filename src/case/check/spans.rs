//! What a published value or trend is taken over: a statistic that suits it, a window of time, a stretch of the line.

use crate::case::along::AlongLine;
use crate::case::diagnostic::Finding;
use crate::case::fields::{either, quantity};
use crate::case::model::Statistic;
use crate::case::tree::Node;

/// Statistics over time are taken of channels, those over arc length of quantities of the whole line.
pub(super) fn suits(row: &Node, key: &str) -> Option<Finding> {
    let node = row.get("statistic")?;
    let word = node.text()?;
    let statistic = Statistic::ALL.into_iter().find(|s| s.name() == word)?;
    let channel = row.get("channel")?.text()?;
    let along = AlongLine::named(channel).is_some();
    let fits = if along {
        Statistic::along_line
    } else {
        Statistic::over_time
    };
    if fits(statistic) {
        return None;
    }
    let words: Vec<&str> = Statistic::ALL
        .into_iter()
        .filter(|s| fits(*s))
        .map(Statistic::name)
        .collect();
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
                either(&AlongLine::ALL.map(AlongLine::name))
            ),
        )
    };
    Some(Finding::new(&node.span, key.to_owned(), problem, remedy))
}

/// A window runs forward. One that ends after the run is no fault: whoever shortens a run for a
/// first look may do so, and the row is then not computed.
pub(super) fn window(row: &Node, key: &str) -> Option<Finding> {
    let node = row.get("window_s")?;
    if let Some(channel) = row.get("channel").and_then(Node::text)
        && AlongLine::named(channel).is_some()
    {
        let problem = format!("`{channel}` of the whole line is taken over the whole run");
        return Some(Finding::new(
            &node.span,
            key,
            problem,
            "leave the window out",
        ));
    }
    let numbers = node.numbers()?;
    let [from, to] = numbers[..] else {
        return None;
    };
    (from >= to).then(|| {
        let problem = format!(
            "the window is empty: it begins at {} and ends at {}",
            quantity(from, "s"),
            quantity(to, "s")
        );
        Finding::new(&node.span, key, problem, "let it begin before it ends")
    })
}

/// A stretch runs from A towards B, and is one of a quantity of the whole line.
pub(super) fn stretch(row: &Node, which: &str, key: &str) -> Option<Finding> {
    let node = row.get(which)?;
    if let Some(channel) = row.get("channel").and_then(Node::text)
        && AlongLine::named(channel).is_none()
    {
        let problem = format!("`{channel}` is recorded against time, not along the line");
        let remedy = "leave the stretch out, or name a quantity of the whole line";
        return Some(Finding::new(&node.span, key, problem, remedy));
    }
    let numbers = node.numbers()?;
    let [from, to] = numbers[..] else {
        return None;
    };
    (from > to).then(|| {
        let problem = format!(
            "the stretch runs backward: from {} to {}",
            quantity(from, "m"),
            quantity(to, "m")
        );
        let remedy = "let it begin before it ends; both the same for one place";
        Finding::new(&node.span, key, problem, remedy)
    })
}
