//! The records of the runs of a sea: what is read of them, and at which places.

use std::path::Path;

use crate::case::{ChannelId, ChannelQuantity, LineQuantity, QuantityId, Statistic, Subject};
use crate::run::along::FatigueSpot;
use crate::run::store::{ChannelRows, StoreError, channel_extremes, channel_rows, fatigue_spots};
use crate::run::{Channel, Quantity};
use crate::study::record_statistics::ChannelRecord;

/// What is recorded of a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RecordedSeries {
    /// Tension \[N\].
    Tension,
    /// Vertical force of the lines on a fixed point \[N\].
    Uplift,
    /// Horizontal distance from the place at the start \[m\].
    Offset,
    /// Height above still water \[m\].
    Height,
    /// Height of a line at rest above the bed \[m\].
    BedClearance,
}

impl RecordedSeries {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Tension,
        Self::Uplift,
        Self::Offset,
        Self::Height,
        Self::BedClearance,
    ];

    /// The quantities whose channels have the places: of a system, then of a line between two ends.
    const fn quantities(self) -> &'static [ChannelQuantity] {
        match self {
            Self::Tension => &[ChannelQuantity::Tension],
            Self::Uplift => &[ChannelQuantity::Uplift, ChannelQuantity::ForceZ],
            Self::Offset => &[ChannelQuantity::X],
            Self::Height => &[ChannelQuantity::Z],
            // In time it is recorded along the line.
            Self::BedClearance => &[],
        }
    }

    /// The unit as shown.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Tension | Self::Uplift => "N",
            Self::Offset | Self::Height | Self::BedClearance => "m",
        }
    }
}

/// A run of a sea.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaRunRecord {
    /// Its load case, by its place in the list.
    pub load_case: usize,
    rows: ChannelRows,
    summary: Vec<Quantity>,
    /// The channels with the extremes of the whole run and their times.
    extremes: Vec<Channel>,
    /// From when on the record counts \[s\].
    from: f64,
    /// The damage along the lines, where checks count it.
    pub(super) along: Vec<FatigueSpot>,
    /// The horizontal places of points and bodies at time zero \[m\].
    start: Vec<(ChannelId, f64)>,
}

impl SeaRunRecord {
    /// Reads the rows of a stored run from a time on \[s\], of all that checks may need.
    ///
    /// # Errors
    /// A history that cannot be read.
    pub fn read(
        load_case: usize,
        dir: &Path,
        summary: &[Quantity],
        from: f64,
    ) -> Result<Self, StoreError> {
        let wanted = |id: &ChannelId| {
            id.quantity == ChannelQuantity::Y
                || RecordedSeries::ALL
                    .iter()
                    .any(|series| series.quantities().contains(&id.quantity))
        };
        let mut rows = channel_rows(dir, 0.0, wanted)?;
        let first = rows.values.iter().map(|values| values.first().copied());
        let start = rows.ids.iter().cloned().zip(first);
        let start = start.filter_map(|(id, value)| Some((id, value?))).collect();
        let skipped = rows.time.partition_point(|time| *time < from);
        rows.time.drain(..skipped);
        for values in &mut rows.values {
            values.drain(..skipped);
        }
        Ok(Self {
            load_case,
            rows,
            summary: summary.to_vec(),
            extremes: channel_extremes(dir)?,
            along: fatigue_spots(dir)?,
            from,
            start,
        })
    }

    /// The places at which a series is recorded.
    pub fn places(&self, series: RecordedSeries) -> impl Iterator<Item = &str> {
        let quantities = series.quantities();
        let ids = &self.rows.ids;
        let of = move |id: &&ChannelId| quantities.contains(&id.quantity);
        // A place that records both quantities of a series counts once.
        let first = move |id: &&ChannelId| {
            let there = |other: &&ChannelId| of(other) && other.place == id.place;
            ids.iter().find(there) == Some(*id)
        };
        ids.iter()
            .filter(of)
            .filter(first)
            .map(|id| id.place.as_str())
    }

    /// The record of a series at a place; one row stands for itself.
    #[must_use]
    pub fn series(&self, series: RecordedSeries, place: &str) -> Option<ChannelRecord> {
        let values = match series {
            RecordedSeries::Offset => self.offset(place)?,
            _ => {
                let mut quantities = series.quantities().iter();
                quantities.find_map(|of| self.values(*of, place))?.to_vec()
            }
        };
        let least = self.extreme(series, place, Statistic::Min);
        let greatest = self.extreme(series, place, Statistic::Max);
        let extremes = least.zip(greatest).map(|(least, most)| [least.0, most.0]);
        let found = match values.len() {
            1 => Some(ChannelRecord {
                step: 1.0,
                values,
                extremes,
            }),
            _ => ChannelRecord::of_history(&self.rows.time, &values),
        };
        found.map(|record| ChannelRecord { extremes, ..record })
    }

    /// The greatest or least value of a series over every step of the run itself after the start that is left out, and its time \[s\]
    /// where that is known; nothing of what is derived from several channels.
    #[must_use]
    pub fn extreme(
        &self,
        series: RecordedSeries,
        place: &str,
        of: Statistic,
    ) -> Option<(f64, Option<f64>)> {
        if series == RecordedSeries::Offset {
            return None;
        }
        let id = |quantity: &ChannelQuantity| quantity.at(place);
        let known = |quantity: &ChannelQuantity| {
            let mut channels = self.extremes.iter();
            channels.find(|channel| channel.id == id(quantity))
        };
        let channel = series.quantities().iter().find_map(known)?;
        let (value, time) = match of {
            Statistic::Min => channel.trough,
            _ => channel.peak,
        };
        // Output times are products of roundings.
        if time >= self.from * (1.0 - 1e-12) && value.is_finite() {
            return Some((value, Some(time)));
        }
        self.settled(&channel.id, of).map(|value| (value.0, None))
    }

    /// A statistic of a channel after the start that is left out, as the run took it, and its numerical error.
    fn settled(&self, channel: &ChannelId, of: Statistic) -> Option<(f64, Option<f64>)> {
        let found = self.summary.iter().find(|quantity| match &quantity.id {
            QuantityId::Statistic {
                of: Subject::Channel(id),
                statistic,
                within: Some([from, _]),
                ..
            } => id == channel && *statistic == of && from.to_bits() == self.from.to_bits(),
            _ => false,
        });
        found.map(|quantity| (quantity.value, quantity.error_estimate()))
    }

    /// How long its record is \[s\].
    #[must_use]
    pub fn length(&self) -> Option<f64> {
        Some(self.rows.time.last()? - self.rows.time.first()?)
    }

    /// The time of a row \[s\].
    #[must_use]
    pub fn time(&self, row: usize) -> Option<f64> {
        self.rows.time.get(row).copied()
    }

    fn column(&self, quantity: ChannelQuantity, place: &str) -> Option<usize> {
        let mut ids = self.rows.ids.iter();
        ids.position(|id| id.quantity == quantity && id.place == place)
    }

    fn values(&self, quantity: ChannelQuantity, place: &str) -> Option<&[f64]> {
        let column = self.column(quantity, place)?;
        self.rows.values.get(column).map(Vec::as_slice)
    }

    fn offset(&self, place: &str) -> Option<Vec<f64>> {
        let [x, y] = [ChannelQuantity::X, ChannelQuantity::Y];
        let start = |quantity| {
            let found = self
                .start
                .iter()
                .find(|(id, _)| id.quantity == quantity && id.place == place);
            found.map(|(_, value)| *value)
        };
        let (x0, y0) = (start(x)?, start(y)?);
        let (xs, ys) = (self.values(x, place)?, self.values(y, place)?);
        Some(
            xs.iter()
                .zip(ys)
                .map(|(x, y)| (x - x0).hypot(y - y0))
                .collect(),
        )
    }

    /// The numerical error of a statistic of a series; nothing where it was not estimated.
    #[must_use]
    pub fn numerical(&self, series: RecordedSeries, place: &str, of: Statistic) -> Option<f64> {
        let of_channel = |quantity: ChannelQuantity, of: Statistic| {
            let id = quantity.at(place);
            let settled = self.settled(&id, of).and_then(|(_, error)| error);
            settled.or_else(|| self.error(Subject::Channel(id), of))
        };
        match series {
            // Of the extremes of both coordinates the least favourable, in both directions.
            RecordedSeries::Offset => {
                let parts = [ChannelQuantity::X, ChannelQuantity::Y].map(|quantity| {
                    let ends = [Statistic::Min, Statistic::Max].map(|of| of_channel(quantity, of));
                    ends[0].zip(ends[1]).map(|(a, b)| f64::max(a, b))
                });
                parts[0].zip(parts[1]).map(|(x, y)| x.hypot(y))
            }
            _ => {
                let mut quantities = series.quantities().iter();
                quantities.find_map(|quantity| of_channel(*quantity, of))
            }
        }
    }

    fn error(&self, of: Subject, statistic: Statistic) -> Option<f64> {
        self.result(&QuantityId::new(of, statistic, None))?.1
    }

    /// The least bend radius along a line, by its name, with its numerical error \[m\].
    #[must_use]
    pub fn least_bend_radius(&self, line: &str) -> Option<(f64, Option<f64>)> {
        let of = Subject::along(LineQuantity::BendRadius, line);
        self.result(&QuantityId::new(of, Statistic::Min, None))
    }

    /// A single number of the run with its numerical error.
    #[must_use]
    pub fn result(&self, id: &QuantityId) -> Option<(f64, Option<f64>)> {
        let found = self.summary.iter().find(|quantity| quantity.id == *id)?;
        Some((found.value, found.error_estimate()))
    }
}
