//! The dynamic stiffness of fibre ropes: along the line, and against time at the ends of their sections.

use super::profiles::over_arc;
use super::{PlottedRun, against_time, named, slots};
use crate::case::ChannelQuantity;
use crate::report::chart::{Axis, Chart, Series};

/// Stiffness k = EA by breaking load along the ropes at the end, with its smallest and greatest values over time where
/// they differ from it.
#[must_use]
pub fn stiffness_profile(sources: &[PlottedRun]) -> Chart {
    let mut series = Vec::new();
    for (source, slot) in sources.iter().zip(slots(sources, 3)) {
        let Some(ropes) = source.profile.map(|p| &p.ropes) else {
            continue;
        };
        let curves = [
            ("at the end", &ropes.stiffness),
            ("smallest", &ropes.stiffness_min),
            ("greatest", &ropes.stiffness_max),
        ];
        let shown = if source.at_rest() { 1 } else { curves.len() };
        for (number, (name, values)) in curves.into_iter().take(shown).enumerate() {
            if values.is_empty() {
                continue;
            }
            let name = match (source.at_rest(), sources.len()) {
                (false, _) => name,
                (true, 1) => "at rest",
                (true, _) => "",
            };
            let points = ropes.arc.iter().copied().zip(values.iter().copied());
            series.push(Series {
                dimmed: source.dimmed,
                ..Series::new(
                    &named(sources, source, name),
                    slot + number,
                    points.collect(),
                )
            });
        }
    }
    over_arc(
        sources,
        "Dynamic stiffness along the line",
        Axis::new("EA by breaking load", ""),
        series,
    )
}

/// Stiffness k = EA by breaking load against time, at the ends of the sections of rope.
#[must_use]
pub fn stiffness_in_time(sources: &[PlottedRun]) -> Chart {
    against_time(sources, ChannelQuantity::Stiffness)
}

/// Mean of the past tension Lm against time, in percent of the breaking load, at the ends of the sections of rope.
#[must_use]
pub fn mean_load_in_time(sources: &[PlottedRun]) -> Chart {
    against_time(sources, ChannelQuantity::MeanLoad)
}

/// Deviation of the tension from its mean La against time, in percent of the breaking load, likewise.
#[must_use]
pub fn deviation_in_time(sources: &[PlottedRun]) -> Chart {
    against_time(sources, ChannelQuantity::LoadDeviation)
}
