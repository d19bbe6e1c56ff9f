//! Channels against time.

use super::profiles::points;
use super::{PlottedRun, body, histories, named, places, series, slots, values};
use seacable_display::chart::{Axis, Chart};
use seacable_model::case::ChannelQuantity;

/// Position of the payload against time \[s, m\]: x along the scene, z up from still water.
#[must_use]
pub fn payload_position(sources: &[PlottedRun]) -> Chart {
    let body = body(sources).unwrap_or("payload");
    let things = [
        (ChannelQuantity::X, body, "x"),
        (ChannelQuantity::Z, body, "z"),
    ];
    let title = format!("Position of the {body}");
    chart(sources, &title, Axis::new("position", "m"), &things)
}

/// One quantity at all the places where it was recorded, against time.
#[must_use]
pub fn against_time(sources: &[PlottedRun], quantity: ChannelQuantity) -> Chart {
    against_time_at(sources, quantity, |_| true)
}

/// One quantity at some of the places where it was recorded, against time.
#[must_use]
pub fn against_time_at(
    sources: &[PlottedRun],
    quantity: ChannelQuantity,
    is_shown: impl Fn(&str) -> bool,
) -> Chart {
    let all = places(histories(sources), quantity);
    let all = all.into_iter().filter(|place| is_shown(place));
    let all: Vec<&str> = all.collect();
    let things: Vec<_> = all.iter().map(|place| (quantity, *place, *place)).collect();
    let unit = match quantity.unit() {
        "-" => "",
        unit => unit,
    };
    let y = Axis::new(quantity.label(), unit);
    chart(sources, quantity.title(), y, &things)
}

/// A series for each run and thing: quantity, place, name in the legend.
fn chart(
    sources: &[PlottedRun],
    title: &str,
    y: Axis,
    things: &[(ChannelQuantity, &str, &str)],
) -> Chart {
    let mut all = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, things.len())) {
        for (slot, (quantity, place, name)) in (slot..).zip(things) {
            if let Some(values) = values(source, *quantity, place) {
                let points = points(&source.history.time, values);
                all.push(series(source, slot, &named(sources, source, name), points));
            }
        }
    }
    let time = Axis::new("time", "s").over(time_range(sources));
    Chart::new(title, time, y, all)
}

/// From the first instant to the end of the longest run, exactly: a time axis is not rounded up.
fn time_range(sources: &[PlottedRun]) -> Option<(f64, f64)> {
    let first = sources.iter().filter_map(|s| s.history.time.first());
    let start = first.copied().fold(0.0, f64::min);
    let end = |s: &PlottedRun| s.duration.or(s.history.time.last().copied());
    let end = sources.iter().filter_map(end).fold(start, f64::max);
    (end > start).then_some((start, end))
}
