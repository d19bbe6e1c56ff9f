//! The charts of a run, or of several laid over each other: the same for screen and report.
//!
//! ```
//! use seacable_model::case::ChannelQuantity;
//! use seacable_report::figures::{PlottedRun, against_time};
//! use seacable_runs::run::History;
//!
//! let history = History::default();
//! let runs = [PlottedRun::streamed(&history, &[], "this run")];
//! let chart = against_time(&runs, ChannelQuantity::Tension);
//! assert_eq!(chart.y.unit, "N");
//! ```

mod contents;
mod profiles;
mod published;
mod registry;
mod response;
mod shapes;
mod stated;
mod study;
mod time_histories;

pub use profiles::{curvature_profile, moment_profile, stiffness_profile, tension_profile};
pub use published::published_curves;
pub use registry::{
    FIGURES, Figure, FigureAxis, FigureData, FigureId, SystemContents, report_figures,
};
pub use response::{ResponseMapKind, response_map, rms_profile, wave_amplitudes, wavelengths};
pub use shapes::{line_from_above, line_from_ahead, line_shape, trajectory};
pub use study::along_studies;
pub use time_histories::{against_time, against_time_at, payload_position};

use seacable_display::chart::Series;
use seacable_model::case::ChannelQuantity;
use seacable_runs::run::{History, LineShape, Profile, Run};

/// A run to be drawn, complete or still running.
#[derive(Debug, Clone, Copy)]
pub struct PlottedRun<'a> {
    /// Channels against time.
    pub history: &'a History,
    /// Shapes of the lines, oldest first.
    pub shapes: &'a [LineShape],
    /// The lines at the end; none while the run is incomplete.
    pub profiles: &'a [Profile],
    /// Name, where several runs are drawn together.
    pub label: &'a str,
    /// An older result: drawn broken, below the others.
    pub dimmed: bool,
    /// Simulated time at the end \[s\], so that the time axis stays fixed during the run;
    /// absent: as far as the history goes.
    pub duration: Option<f64>,
}

impl<'a> PlottedRun<'a> {
    /// A complete run.
    #[must_use]
    pub fn whole(run: &'a Run, label: &'a str) -> Self {
        let duration = run.info.settings.duration_s;
        Self {
            profiles: match run.profile().nodes.is_empty() {
                true => &[],
                false => &run.profiles,
            },
            duration: (duration > 0.0 && run.history.time.len() > 1).then_some(duration),
            ..Self::streamed(&run.history, &run.shapes, label)
        }
    }

    /// An incomplete run.
    #[must_use]
    pub fn streamed(history: &'a History, shapes: &'a [LineShape], label: &'a str) -> Self {
        Self {
            history,
            shapes,
            profiles: &[],
            label,
            dimmed: false,
            duration: None,
        }
    }

    /// The same, drawn as an older result.
    #[must_use]
    pub fn dimmed(self) -> Self {
        Self {
            dimmed: true,
            ..self
        }
    }

    /// True for lines at rest: there are profiles, and nothing changed with time.
    #[must_use]
    pub fn at_rest(&self) -> bool {
        !self.profiles.is_empty() && self.history.time.len() <= 1
    }

    /// The line at the end, of a run of one.
    #[must_use]
    pub fn profile(&self) -> Option<&'a Profile> {
        match self.profiles {
            [only] => Some(only),
            _ => None,
        }
    }

    /// The same, with the time axis up to this time \[s\].
    #[must_use]
    pub fn until(self, duration: f64) -> Self {
        Self {
            duration: (duration > 0.0).then_some(duration),
            ..self
        }
    }
}

/// A colour and marker for each thing drawn of each run. A dimmed run shares them with the run in
/// full ink that takes its place.
fn slots(sources: &[PlottedRun], things: usize) -> Vec<usize> {
    let (mut full, mut dimmed) = (0, 0);
    let mut next = |is_dimmed: bool| {
        let count = if is_dimmed { &mut dimmed } else { &mut full };
        *count += 1;
        (*count - 1) * things
    };
    sources.iter().map(|source| next(source.dimmed)).collect()
}

/// The name of a thing in the legend, with the name of its run where there are several.
fn named(sources: &[PlottedRun], source: &PlottedRun, thing: &str) -> String {
    match (sources.len() > 1 && !source.label.is_empty(), thing) {
        (false, _) => thing.to_owned(),
        (true, "") => source.label.to_owned(),
        (true, _) => format!("{thing}, {}", source.label),
    }
}

/// A title that speaks of the line, of as many as there are.
fn of_lines(title: &str, sources: &[PlottedRun]) -> String {
    match sources.iter().any(|source| source.profiles.len() > 1) {
        true => title.replace(" line", " lines"),
        false => title.to_owned(),
    }
}

/// A curve of a run.
fn series(source: &PlottedRun, slot: usize, label: &str, points: Vec<(f64, f64)>) -> Series {
    Series {
        dimmed: source.dimmed,
        ..Series::new(label, slot, points)
    }
}

/// The places at which any of these histories has a quantity, in the order of their channels.
pub fn places<'n>(
    histories: impl IntoIterator<Item = &'n History>,
    quantity: ChannelQuantity,
) -> Vec<&'n str> {
    let mut all: Vec<&str> = Vec::new();
    for channel in histories.into_iter().flat_map(|h| &h.channels) {
        let place = channel.id.place.as_str();
        if channel.id.quantity == quantity && !all.contains(&place) {
            all.push(place);
        }
    }
    all
}

fn histories<'n>(sources: &[PlottedRun<'n>]) -> impl Iterator<Item = &'n History> {
    sources.iter().map(|source| source.history)
}

/// The body whose path is drawn: the payload, or else the first loose end, which has a speed of its
/// own, or else the first end that moves at all.
fn body<'n>(sources: &[PlottedRun<'n>]) -> Option<&'n str> {
    let all = places(histories(sources), ChannelQuantity::Z);
    let loose = places(histories(sources), ChannelQuantity::Speed);
    let payload = all.iter().find(|place| **place == "payload");
    let payload = payload.or(all.iter().find(|place| loose.contains(place)));
    payload.or(all.first()).copied()
}

/// The values of a channel, by quantity and place.
fn values<'a>(
    source: &PlottedRun<'a>,
    quantity: ChannelQuantity,
    place: &str,
) -> Option<&'a [f64]> {
    Some(&source.history.at(quantity, place)?.values)
}

#[cfg(test)]
mod tests;
