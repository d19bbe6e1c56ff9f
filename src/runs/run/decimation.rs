//! Decimation of a record to a bounded size in memory. Nothing is averaged: of every stretch of time the rows are kept at
//! which a channel is greatest or smallest, so that no peak is lost. A record that fits is kept whole.

use super::step_interval::StepInterval;
use super::{Channel, History, LineShape};
use crate::case::ChannelId;

/// How many numbers the rows kept may hold together.
const NUMBERS: usize = 1 << 19;

/// How many nodes the shapes kept may hold together.
const NODES: usize = 1 << 17;

/// A record decimated to a bounded size.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DecimatedRecord {
    history: History,
    shapes: Vec<LineShape>,
    /// Rows kept of every stretch that is complete, oldest first.
    stretches: Vec<usize>,
    /// Rows of all complete stretches together.
    closed: usize,
    /// Rows recorded a stretch; 0 while all are kept.
    span: u64,
    /// Rows recorded since the last complete stretch.
    open: u64,
    /// Lines that have shapes, times whose shapes were recorded, and every which of these times is kept.
    lines: usize,
    drawn: u64,
    stride: u64,
    /// How many numbers the rows kept may hold, where that is fewer than usual; 0 where it is not.
    numbers: usize,
}

impl DecimatedRecord {
    /// An empty record of these channels.
    #[must_use]
    pub fn new(channels: impl IntoIterator<Item = ChannelId>) -> Self {
        let channels = channels.into_iter().map(Channel::new);
        Self {
            history: History {
                time: Vec::new(),
                channels: channels.collect(),
            },
            stride: 1,
            ..Self::default()
        }
    }

    /// An empty record of these channels whose rows hold about so many numbers at most.
    #[must_use]
    pub fn within(channels: impl IntoIterator<Item = ChannelId>, numbers: usize) -> Self {
        Self {
            numbers,
            ..Self::new(channels)
        }
    }

    /// The same with room for so many rows, or for those that are kept at most.
    pub(super) fn with_room_for(mut self, rows: usize) -> Self {
        let rows = rows.min(self.room() + 1);
        self.history.time.reserve_exact(rows);
        for channel in &mut self.history.channels {
            channel.values.reserve_exact(rows);
        }
        self
    }

    /// The rows kept.
    #[must_use]
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The channels, to widen their extremes.
    pub(super) fn channels_mut(&mut self) -> &mut [Channel] {
        &mut self.history.channels
    }

    /// Widens the extremes of the channels to those between two steps.
    pub(super) fn widen_extremes(&mut self, between: &StepInterval<'_>) {
        for (number, channel) in self.history.channels.iter_mut().enumerate() {
            let arc = between.channel(number);
            for (value, time) in [arc.greatest(), arc.smallest()] {
                widen(channel, value, time);
            }
        }
    }

    /// The shapes kept, oldest first.
    #[must_use]
    pub fn shapes(&self) -> &[LineShape] {
        &self.shapes
    }

    /// Rows and shapes kept.
    #[must_use]
    pub fn into_parts(self) -> (History, Vec<LineShape>) {
        (self.history, self.shapes)
    }

    /// Appends another record of the same channels of a later time.
    pub fn append(&mut self, later: &Self) {
        for (row, time) in later.history.time.iter().enumerate() {
            let values = later.history.channels.iter();
            let values: Vec<f64> = values.filter_map(|c| c.values.get(row)).copied().collect();
            self.row(*time, &values);
        }
        for shapes in later.shapes.chunks(later.lines.max(1)) {
            self.add_shapes(shapes);
        }
    }

    /// Adds a row: a time \[s\] and a value a channel.
    pub fn row(&mut self, time: f64, values: &[f64]) {
        self.history.time.push(time);
        for (channel, value) in self.history.channels.iter_mut().zip(values) {
            channel.values.push(*value);
            widen(channel, *value, time);
        }
        self.open += 1;
        let rows = self.history.time.len();
        if self.span == 0 {
            if rows > self.room() {
                self.begin_decimation();
            }
        } else if self.open == self.span {
            let kept = self.decimate(self.closed);
            self.close(kept);
        } else if rows - self.closed > 2 * self.most() {
            self.decimate(self.closed);
        }
        if self.span > 0 && self.history.time.len() > self.room() {
            self.join_stretches();
        }
    }

    /// Adds the shapes of all lines at a time. The newest are always kept.
    pub fn add_shapes(&mut self, shapes: &[LineShape]) {
        if shapes.is_empty() {
            return;
        }
        let lines = shapes.len();
        self.lines = lines;
        let provisional = self.drawn > 0 && !(self.drawn - 1).is_multiple_of(self.stride);
        if provisional {
            self.shapes.truncate(self.shapes.len() - lines);
        }
        let nodes = if self.numbers == 0 {
            NODES
        } else {
            self.numbers
        };
        let own: usize = shapes.iter().map(|shape| shape.nodes.len()).sum();
        let room = (nodes / own.max(1)).max(16);
        self.shapes.extend_from_slice(shapes);
        self.drawn += 1;
        let times = self.shapes.len() / lines;
        if times > room {
            self.stride *= 2;
            let mut numbers = (0..times * lines).map(|shape| shape / lines);
            self.shapes.retain(|_| {
                numbers
                    .next()
                    .is_some_and(|time| time % 2 == 0 || time == times - 1)
            });
        }
    }

    /// Most rows that a stretch needs: its first, its last, and two a channel.
    fn most(&self) -> usize {
        2 + 2 * self.history.channels.len()
    }

    /// How many rows are kept at most.
    fn room(&self) -> usize {
        let columns = 1 + self.history.channels.len();
        match self.numbers {
            0 => (NUMBERS / columns).max(16 * self.most()),
            fewer => (fewer / columns).max(8 * self.most()),
        }
    }

    /// Divides what was kept whole so far into stretches.
    fn begin_decimation(&mut self) {
        let rows = self.history.time.len();
        let span = 2 * self.most();
        let mut kept = Vec::new();
        for begin in (0..rows / span).map(|i| i * span) {
            let before = kept.len();
            self.extremes(begin..begin + span, &mut kept);
            self.stretches.push(kept.len() - before);
        }
        self.closed = kept.len();
        kept.extend(rows - rows % span..rows);
        self.keep_only(0, &kept);
        self.span = span as u64;
        self.open = (rows % span) as u64;
    }

    /// Makes one stretch of every two.
    fn join_stretches(&mut self) {
        if !self.stretches.len().is_multiple_of(2)
            && let Some(rows) = self.stretches.pop()
        {
            self.closed -= rows;
            self.open += self.span;
        }
        self.span *= 2;
        let (mut kept, mut joined, mut begin) = (Vec::new(), Vec::new(), 0);
        for pair in self.stretches.chunks(2) {
            let (end, before) = (begin + pair.iter().sum::<usize>(), kept.len());
            self.extremes(begin..end, &mut kept);
            joined.push(kept.len() - before);
            begin = end;
        }
        let closed = kept.len();
        kept.extend(begin..self.history.time.len());
        self.keep_only(0, &kept);
        (self.stretches, self.closed) = (joined, closed);
    }

    /// Decimates the rows from this one on; returns how many are left.
    fn decimate(&mut self, from: usize) -> usize {
        let mut kept = Vec::with_capacity(self.most());
        self.extremes(from..self.history.time.len(), &mut kept);
        self.keep_only(from, &kept);
        kept.len()
    }

    fn close(&mut self, rows: usize) {
        self.stretches.push(rows);
        self.closed += rows;
        self.open = 0;
    }

    /// Numbers of the rows to keep of some, in order: the first, the last, and those of the extremes of every channel.
    fn extremes(&self, rows: std::ops::Range<usize>, kept: &mut Vec<usize>) {
        let from = kept.len();
        if rows.is_empty() {
            return;
        }
        kept.extend([rows.start, rows.end - 1]);
        for channel in &self.history.channels {
            let values = rows.clone().zip(&channel.values[rows.clone()]);
            let (mut low, mut high) = (None::<(usize, f64)>, None::<(usize, f64)>);
            for (row, value) in values.filter(|(_, value)| !value.is_nan()) {
                if low.is_none_or(|(_, least)| *value < least) {
                    low = Some((row, *value));
                }
                if high.is_none_or(|(_, most)| *value > most) {
                    high = Some((row, *value));
                }
            }
            kept.extend(low.into_iter().chain(high).map(|(row, _)| row));
        }
        kept[from..].sort_unstable();
        let mut unique = from;
        for i in from..kept.len() {
            if i == from || kept[i] != kept[unique - 1] {
                kept[unique] = kept[i];
                unique += 1;
            }
        }
        kept.truncate(unique);
    }

    /// Drops all rows from one on but those of these numbers.
    fn keep_only(&mut self, from: usize, rows: &[usize]) {
        let columns = self.history.channels.iter_mut().map(|c| &mut c.values);
        for column in columns.chain([&mut self.history.time]) {
            for (to, row) in (from..).zip(rows) {
                column[to] = column[*row];
            }
            column.truncate(from + rows.len());
        }
    }
}

/// Widens the extremes of a channel.
fn widen(channel: &mut Channel, value: f64, time: f64) {
    if value > channel.peak.0 {
        channel.peak = (value, time);
    }
    if value < channel.trough.0 {
        channel.trough = (value, time);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two swings of different periods and a ramp, with one spike.
    fn value(row: u64, channel: usize) -> f64 {
        let t = row as f64;
        match channel {
            0 if row == 777_777 => 55.0,
            0 => (t * 0.37).sin(),
            1 => (t * 1e-4).cos() * 3.0,
            _ => t,
        }
    }

    fn recorded(rows: u64) -> DecimatedRecord {
        let names = ["a", "b", "c"].map(|place| crate::case::ChannelQuantity::X.at(place));
        let mut record = DecimatedRecord::new(names);
        for row in 0..rows {
            record.row(row as f64, &[0, 1, 2].map(|c| value(row, c)));
        }
        record
    }

    #[test]
    fn what_fits_is_kept_whole() {
        let record = recorded(100_000);
        assert_eq!(record.history.time.len(), 100_000);
    }

    #[test]
    fn ten_times_the_rows_take_no_more_room_and_all_are_true() {
        let record = recorded(3_000_000);
        let history = record.history();
        assert!(history.time.len() <= record.room());
        assert!(
            history.time.len() > record.room() / 4,
            "{}",
            history.time.len()
        );
        assert!(record.stretches.len() < record.room());
        assert!(history.time.windows(2).all(|t| t[0] < t[1]));
        for (c, channel) in history.channels.iter().enumerate() {
            assert_eq!(channel.values.len(), history.time.len());
            for (t, v) in history.time.iter().zip(&channel.values) {
                assert_eq!(*v, value(*t as u64, c));
            }
        }
        assert_eq!(
            (history.time[0], history.time.last()),
            (0.0, Some(&2_999_999.0))
        );
    }

    #[test]
    fn no_peak_is_lost_and_stretches_are_even() {
        let record = recorded(3_000_000);
        let swing = &record.history().channels[0];
        assert_eq!(swing.peak, (55.0, 777_777.0));
        assert!(swing.values.contains(&55.0));
        // Both extremes of the fast swing are there in every stretch.
        let times = &record.history().time;
        for begin in (0..59).map(|i| f64::from(i) * 50_000.0) {
            let rows = times.partition_point(|t| *t < begin)
                ..times.partition_point(|t| *t < begin + 50_000.0);
            let of = &swing.values[rows];
            assert!(of.iter().any(|v| *v > 0.999) && of.iter().any(|v| *v < -0.999));
        }
    }

    #[test]
    fn shapes_are_decimated_evenly_and_the_newest_stays() {
        let mut record = DecimatedRecord::new([]);
        for i in 0..5000 {
            record.add_shapes(&[LineShape {
                time: f64::from(i),
                line: 0,
                nodes: vec![[0.0; 3]; 1000],
                tension: vec![0.0; 1000],
                ..LineShape::default()
            }]);
            assert_eq!(record.shapes.last().map(|s| s.time), Some(f64::from(i)));
            assert!(record.shapes.len() <= 131);
        }
        let steps: Vec<f64> = record
            .shapes
            .windows(2)
            .map(|s| s[1].time - s[0].time)
            .collect();
        let (last, even) = steps.split_last().unwrap();
        assert!(
            even.iter().all(|s| *s == 64.0) && *last <= 64.0,
            "{steps:?}"
        );
    }
}
