//! Statistics of channels as tables: moments, greatest values with their intervals, fatigue.

use seacable_base::number::{range as range_text, si, with_error};
use seacable_display::table::{Align, Cell, CellStyle, Table};
use seacable_model::case::ChannelId;
use seacable_statistics::extremes::interval::Interval;
use seacable_statistics::extremes::spectrum::SpectralDensity;
use seacable_studies::study::record_statistics::{
    ExtremeQuestion, GreatestValue, RecordFatigue, RecordStatistics,
};

/// A channel with its statistics.
#[derive(Debug, Clone)]
pub struct ChannelView {
    /// The channel.
    pub id: ChannelId,
    /// Its statistics.
    pub statistics: RecordStatistics,
    /// Numerical error of its greatest value, the largest of the runs, where it is estimated.
    pub numerical: Option<f64>,
    /// Fatigue, where it is asked for, or why there is none.
    pub fatigue: Option<Result<FatigueView, String>>,
}

/// Fatigue of a channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FatigueView {
    /// Damage and its scatter.
    pub found: RecordFatigue,
    /// Numerical error of the damage of a year, by that of the tensions.
    pub numerical: Option<f64>,
}

/// A row of the table of greatest values.
struct GreatestRow<'a> {
    channel: &'a ChannelView,
    method: &'static str,
    found: Result<&'a GreatestValue, String>,
}

impl GreatestRow<'_> {
    /// A figure with its interval in brackets.
    fn figure(&self, read: fn(&GreatestValue) -> Interval) -> Cell {
        let Ok(found) = &self.found else {
            return Cell::none();
        };
        let (of, unit) = (read(found), self.channel.id.quantity.unit());
        let interval = range_text(of.low, of.high, unit);
        Cell::plain(format!("{} ({interval})", si(of.estimate, unit)))
    }
}

/// Mean, deviation and shape of every channel.
#[must_use]
pub fn moments(channels: &[ChannelView]) -> Table {
    let unit = |row: &ChannelView| row.id.quantity.unit();
    let of = |read: fn(&RecordStatistics) -> f64| {
        move |row: &ChannelView| Cell::plain(si(read(&row.statistics), row.id.quantity.unit()))
    };
    let plain = |value: f64| Cell::plain(format!("{value:.3}"));
    let short = channels.iter().any(|row| row.statistics.mean.is_err());
    Table::of_records("Statistics", channels)
        .text("channel", |row| row.id.to_string())
        .cell("mean", Align::Decimal, |row| match &row.statistics.mean {
            Ok(mean) => {
                let error = mean.error.max(mean.batch_error);
                Cell::plain(with_error(mean.mean, Some(error), unit(row)))
            }
            Err(_) => Cell::plain(si(row.statistics.moments.mean, unit(row))),
        })
        .cell("deviation", Align::Decimal, of(|s| s.moments.deviation))
        .cell("skewness", Align::Decimal, |row| plain(row.statistics.moments.skewness))
        .cell("excess kurtosis", Align::Decimal, |row| plain(row.statistics.moments.excess))
        .cell("least", Align::Decimal, of(|s| s.moments.min))
        .cell("greatest", Align::Decimal, of(|s| s.moments.max))
        .cell("crossing period", Align::Decimal, |row| {
            let rate = row.statistics.crossing_rate.as_ref().ok().filter(|rate| **rate > 0.0);
            rate.map_or_else(Cell::none, |rate| Cell::plain(si(1.0 / rate, "s")))
        })
        .cell("spectral peak", Align::Decimal, |row| {
            let spectrum = row.statistics.spectrum.as_ref().ok();
            let peak = spectrum.map(SpectralDensity::peak_frequency).filter(|f| *f > 0.0);
            peak.map_or_else(Cell::none, |peak| Cell::plain(si(1.0 / peak, "s")))
        })
        .cell("independent values", Align::Right, |row| {
            let mean = row.statistics.mean.as_ref().ok();
            mean.map_or_else(Cell::none, |mean| Cell::plain(format!("{:.0}", mean.effective)))
        })
        .build()
        .noted(["The error of a mean is that of the sample: one standard error, by the correlation of the record or the scatter of its parts, the larger one."])
        .noted(short.then_some("Means without an error are of records with fewer than 40 values, or of constant ones."))
}

/// The greatest value of so many hours of every channel, by every method.
#[must_use]
pub fn greatest(channels: &[ChannelView], question: ExtremeQuestion) -> Table {
    let rows = channels.iter().flat_map(|channel| {
        let methods = channel.statistics.greatest.iter();
        methods.map(move |(method, found)| GreatestRow {
            channel,
            method: method.name(),
            found: found.as_ref().map_err(ToString::to_string),
        })
    });
    let rows: Vec<GreatestRow<'_>> = rows.collect();
    let notes = rows.iter().enumerate().filter_map(|(number, row)| {
        let why = row.found.as_ref().err()?;
        Some(format!(
            "[{}] {} of {}: {why}.",
            number + 1,
            row.method,
            row.channel.id
        ))
    });
    let notes: Vec<String> = notes.collect();
    let numbered: Vec<(usize, &GreatestRow<'_>)> = rows.iter().enumerate().collect();
    let percent = 100.0 * question.level;
    Table::of_records(format!("Greatest of {} h", question.hours), &numbered)
        .text("channel", |(_, row)| row.channel.id.to_string())
        .text("method", |(_, row)| row.method)
        .cell("sample", Align::Right, |(_, row)| {
            let found = row.found.as_ref().ok();
            found.map_or_else(Cell::none, |found| Cell::plain(found.sample.to_string()))
        })
        .cell("most probable", Align::Decimal, |(_, row)| row.figure(|f| f.most_probable))
        .cell("expected", Align::Decimal, |(_, row)| row.figure(|f| f.expected))
        .cell("numerical error", Align::Decimal, |(_, row)| {
            let unit = row.channel.id.quantity.unit();
            let error = row.channel.numerical.filter(|_| row.found.is_ok());
            error.map_or_else(Cell::none, |error| Cell::plain(si(error, unit)))
        })
        .cell("remark", Align::Left, |(number, row)| match &row.found {
            Ok(found) => Cell::plain(found.remark.unwrap_or("")),
            Err(_) => Cell::new(format!("none [{}]", number + 1), CellStyle::Warn),
        })
        .build()
        .noted([format!(
            "In brackets the interval of the sample at {percent} %. The numerical error is that of the greatest value of the runs; it is not in the interval."
        )])
        .noted(notes)
}

/// Fatigue of every channel by a curve.
#[must_use]
pub fn fatigue(channels: &[ChannelView], curve: &str, design_factor: f64) -> Table {
    let found = |row: &ChannelView| row.fatigue.as_ref()?.as_ref().ok().copied();
    let cell = |row: &ChannelView, text: fn(FatigueView) -> String| {
        found(row).map_or_else(Cell::none, |found| Cell::plain(text(found)))
    };
    let notes = channels.iter().filter_map(|row| {
        let why = row.fatigue.as_ref()?.as_ref().err()?;
        Some(format!("{}: {why}.", row.id))
    });
    let notes: Vec<String> = notes.collect();
    let life = move |found: FatigueView| 1.0 / (design_factor * found.found.per_year);
    Table::of_records(format!("Fatigue: {curve}"), channels)
        .text("channel", |row| row.id.to_string())
        .cell("cycles", Align::Right, |row| cell(row, |f| format!("{}", f.found.damage.cycles)))
        .cell("greatest range", Align::Decimal, |row| cell(row, |f| si(f.found.damage.greatest_range, "N")))
        .cell("damage a year", Align::Decimal, |row| {
            cell(row, |f| with_error(f.found.per_year, f.numerical, ""))
        })
        .cell("error of the sample", Align::Decimal, |row| {
            let error = found(row).and_then(|found| found.found.sample_error);
            error.map_or_else(Cell::none, |error| Cell::plain(si(error, "")))
        })
        .cell("life", Align::Decimal, move |row| {
            let years = found(row).map(life).filter(|years| years.is_finite());
            years.map_or_else(Cell::none, |years| Cell::plain(format!("{} years", si(years, ""))))
        })
        .build()
        .noted([format!(
            "Rainflow cycles (ASTM E1049-85, three points, the residue as half cycles), Miner's sum, as if the records went on for a year; the life has a design \
             factor of {design_factor}. The error beside the damage is numerical, by those of the greatest and least tension; that of the sample is one standard error, by the scatter of three runs or more."
        )])
        .noted(notes)
}
