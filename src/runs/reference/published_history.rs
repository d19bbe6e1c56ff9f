//! A published curve over time of a system in motion, and its comparison with a channel of a run.

use crate::case::fields::{of, positive};
use crate::case::schema::table;
use crate::case::{ChannelId, Evidence, Finding, Provenance};
use crate::numerics::interpolation::interval;
use crate::published::{CurveOverlay, ValidationRow, compare};
use crate::run::error_estimate::HistoryPair;
use crate::run::{Channel, History};

table! {
    /// A published curve over time and how a channel of the run in time is held against it: by the root mean square of their
    /// differences at the curve's points, the channel straight between its output times.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PublishedHistory => PublishedHistoryKeys {
        /// What the curve is, in words.
        name: String, "name";
        /// Channel of the history, such as tension_n[mooring|b].
        channel: ChannelId, "channel";
        /// Times of the curve's points, increasing.
        time_s: Vec<f64>, "times", range of(0.0, 1e6);
        /// Values there, in the unit of the channel.
        value: Vec<f64>, "values", unit "";
        /// Greatest root mean square of the differences, in percent of the curve's greatest size.
        tolerance_percent: f64, "tolerance", unit "", range positive(100.0);
        /// Greatest difference at a point, in percent of the curve's range.
        greatest_percent: Option<f64>, "greatest difference", unit "", range positive(100.0), absent "not held";
        /// Where it is printed, or what computed it and how.
        source: String, "source";
        /// Provenance of the inputs behind the computed curve, at worst.
        inputs: Provenance, "inputs";
        /// What an agreement with it is worth.
        kind: Evidence = Evidence::Predicted, "kind";
        /// What else the reader must know: what was fitted to it, which input it repeats.
        note: Option<String>, "note", absent "no note";
        /// Why the tolerance is what it is.
        tolerance_reason: Option<String>, "reason of the tolerance", absent "the one that the file states for all";
        /// Why the curve cannot be reached; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "within reach";
    }
}

/// How far a run is from a curve.
#[derive(Debug, Clone, Copy)]
struct Distance {
    /// Root mean square of the differences \[% of the curve's greatest size\].
    rms: f64,
    /// The greatest difference \[% of the curve's range\].
    greatest: f64,
}

impl PublishedHistory {
    /// The rows of the validation table for a run: of the root mean square and, where the file asks for it, of the greatest
    /// difference. Their errors come from pairs of its companions.
    #[must_use]
    pub fn rows(
        &self,
        run: Result<&History, String>,
        companions: &[HistoryPair],
    ) -> Vec<ValidationRow> {
        let channel = run.and_then(|history| Ok((history, self.channel_of(history)?)));
        let distance = channel.as_ref().map_err(String::clone);
        let distance = distance.and_then(|(history, channel)| self.distance(history, channel));
        let row = |name: String, unit: &str, tolerance: f64, of: fn(&Distance) -> f64| {
            let row = ValidationRow {
                published: Some(0.0),
                tolerance: Some(tolerance),
                inputs: Some(self.inputs),
                kind: self.kind.into(),
                note: self.note.clone(),
                tolerance_reason: self.tolerance_reason.clone(),
                ..ValidationRow::not_run(&name, &self.source, unit.to_owned())
            };
            let found = distance.as_ref().map_err(String::clone);
            let found = found.map(|distance| {
                let percent = of(distance);
                (percent, self.error(of, companions))
            });
            compare(row, self.out_of_reach.as_deref(), found)
        };
        let mut rows = vec![row(
            self.name.clone(),
            "% of peak, rms",
            self.tolerance_percent,
            |distance| distance.rms,
        )];
        rows[0].overlay = Some(self.overlay(channel.as_ref().ok()));
        rows.extend(self.greatest_percent.map(|tolerance| {
            let name = format!("{}, greatest difference", self.name);
            row(name, "% of range", tolerance, |distance| distance.greatest)
        }));
        rows
    }

    fn channel_of<'h>(&self, history: &'h History) -> Result<&'h Channel, String> {
        let mut channels = history.channels.iter();
        let found = channels.find(|channel| channel.id == self.channel);
        found.ok_or_else(|| {
            let known: Vec<String> = history.channels.iter().map(Channel::name).collect();
            let (channel, known) = (&self.channel, known.join(", "));
            format!("The run has no channel `{channel}`; it has {known}.")
        })
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.time_s.iter().copied().zip(self.value.iter().copied())
    }

    fn distance(&self, history: &History, channel: &Channel) -> Result<Distance, String> {
        let last = history.time.last().copied().unwrap_or(0.0);
        let reached = self.points().filter(|(time, _)| *time <= last);
        let differences: Vec<f64> = reached
            .map(|(time, value)| at(history, channel, time) - value)
            .collect();
        let squares: f64 = differences.iter().map(|d| d * d).sum();
        let most =
            |of: fn(f64) -> f64, list: &[f64]| list.iter().map(|v| of(*v)).fold(0.0, f64::max);
        let extremes = self
            .value
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
                (a.min(*v), b.max(*v))
            });
        let range = extremes.1 - extremes.0;
        if differences.is_empty() || range <= 0.0 {
            return Err("The curve has no points during the run, or no range.".to_owned());
        }
        Ok(Distance {
            rms: 100.0 * (squares / differences.len() as f64).sqrt() / most(f64::abs, &self.value),
            greatest: 100.0 * most(f64::abs, &differences) / range,
        })
    }

    fn error(&self, of: fn(&Distance) -> f64, companions: &[HistoryPair]) -> Option<f64> {
        let taken = |history: &History| {
            let channel = self.channel_of(history).ok()?;
            Some(of(&self.distance(history, channel).ok()?))
        };
        let errors = companions.iter().map(|pair| pair.error(taken));
        (!companions.is_empty()).then(|| errors.sum())?
    }

    fn overlay(&self, run: Option<&(&History, &Channel)>) -> CurveOverlay {
        let unit = run.map_or("", |_| self.channel.quantity.unit());
        let computed = run.map(|(history, channel)| {
            let values = channel.values.iter().copied();
            history.time.iter().copied().zip(values).collect()
        });
        CurveOverlay {
            channel: self.channel.clone(),
            unit,
            published: self.points().collect(),
            computed: computed.unwrap_or_default(),
        }
    }
}

/// A channel at a time within its run, straight between its output times.
fn at(history: &History, channel: &Channel, time: f64) -> f64 {
    let (times, values) = (&history.time, &channel.values);
    if times.len() < 2 {
        return values.first().copied().unwrap_or(0.0);
    }
    let i = interval(times, time);
    let share = (time - times[i]) / (times[i + 1] - times[i]);
    values[i] + share * (values[i + 1] - values[i])
}

/// Checks of published curves: as many values as times, two or more, the times increasing.
pub fn check(list: &[(String, PublishedHistoryKeys<'_>)]) -> Vec<Finding> {
    let points = |(_, curve): &(String, PublishedHistoryKeys<'_>)| {
        let (times, values) = (curve.time_s.value()?, curve.value.value()?);
        let problem = if times.len() != values.len() {
            format!("has {} times and {} values", times.len(), values.len())
        } else if times.len() < 2 {
            "needs two points or more".to_owned()
        } else if !times.is_sorted_by(|a, b| a < b) {
            "has times that do not increase".to_owned()
        } else {
            return None;
        };
        let remedy = "give as many values as times, the times increasing";
        Some(curve.time_s.finding(problem, remedy))
    };
    list.iter().filter_map(points).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::ChannelQuantity;
    use crate::reference::Outcome;

    fn history(interval: f64, off: f64) -> History {
        let time: Vec<f64> = (0..=20).map(|k| interval * f64::from(k)).collect();
        let values = time.iter().map(|t| 100.0 + t + off).collect();
        History {
            channels: vec![Channel {
                values,
                ..Channel::new(ChannelQuantity::Tension.at("line|b"))
            }],
            time,
        }
    }

    fn curve(place: &str) -> PublishedHistory {
        PublishedHistory {
            name: "tension".to_owned(),
            channel: ChannelQuantity::Tension.at(place),
            time_s: vec![0.0, 0.35, 1.3, 100.0],
            value: vec![100.0, 100.35, 101.3, 200.0],
            tolerance_percent: 1.0,
            greatest_percent: Some(1.5),
            source: "by hand".to_owned(),
            inputs: Provenance::Assumed,
            kind: Evidence::Predicted,
            note: None,
            tolerance_reason: None,
            out_of_reach: None,
        }
    }

    #[test]
    fn a_channel_is_held_against_the_points_that_the_run_reaches() {
        let held = |off: f64, place: &str| {
            let pair = HistoryPair::new([history(0.1, off), history(0.1, off + 0.3)], 1.0);
            curve(place).rows(Ok(&history(0.1, off)), &[pair])
        };
        let [rms, greatest] = &held(1.0, "line|b")[..] else {
            panic!("two rows");
        };
        assert!((rms.computed.unwrap() - 0.5).abs() < 1e-9, "{rms:?}");
        assert!((greatest.computed.unwrap() - 1.0).abs() < 1e-9);
        assert_eq!(
            (rms.outcome, greatest.outcome),
            (Outcome::Pass, Outcome::Pass)
        );
        assert!(rms.error.is_some_and(|error| error > 0.0));
        assert_eq!(rms.overlay.as_ref().unwrap().computed.len(), 21);
        let far = held(3.0, "line|b");
        assert!(far.iter().all(|row| row.outcome == Outcome::Fail));
        let missing = held(0.0, "line|a");
        assert_eq!(missing[0].outcome, Outcome::NotRun);
        assert!(missing[0].reason.as_ref().unwrap().contains("no channel"));
    }
}
