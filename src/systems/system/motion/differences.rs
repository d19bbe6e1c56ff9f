//! Differences of a channel between a run and its companion, which show its errors.
//!
//! A tension of zero is that of a slack line however slack it is: where the run or the companion rests on such a floor, that both have the
//! same value says nothing. There the greatest difference counts that the channel shows while either is on the floor, and
//! at the output times next to the extremes: how far above the floor one of them is where the other is on it.

use super::channel_result::ChannelSummary;
use crate::case::ChannelId;
use crate::run::{Channel, History};

/// Share of the greatest value of a channel below which it is at its floor: between steps rows are interpolated.
const AT_FLOOR: f64 = 1e-9;

/// Places in the numbers of a summary.
const LEAST: usize = 0;
const GREATEST: usize = 1;
const LAST: usize = 3;

/// Differences of the least, greatest, mean and last value of the channel of this number.
#[must_use]
pub(super) fn differences(
    id: &ChannelId,
    [fine, coarse]: [&ChannelSummary; 2],
    histories: [&History; 2],
    number: usize,
) -> [f64; 4] {
    let numbers = [fine.numbers(), coarse.numbers()];
    let mut differences: [f64; 4] = std::array::from_fn(|k| (numbers[0][k] - numbers[1][k]).abs());
    let floor = AT_FLOOR * size(fine).max(size(coarse));
    let extremes = [fine, coarse].map(|summary| summary.least.1);
    // The mean is none of a single time.
    for k in [LEAST, GREATEST, LAST] {
        let may_rest = id.quantity.rests_at_zero(k == LAST);
        if may_rest && numbers.iter().any(|run| run[k].abs() <= floor) {
            let elsewhere = while_at_floor(histories, number, floor, extremes);
            differences[k] = differences[k].max(elsewhere);
        }
    }
    differences
}

fn size(summary: &ChannelSummary) -> f64 {
    summary.greatest.0.abs().max(summary.least.0.abs())
}

/// The greatest difference of a channel at the output times at which either run is at the floor, and next to these times \[s\].
fn while_at_floor(histories: [&History; 2], number: usize, floor: f64, times: [f64; 2]) -> f64 {
    let [fine, coarse] = histories.map(|history| history.channels.get(number));
    let (Some(fine), Some(coarse)) = (fine, coarse) else {
        return 0.0;
    };
    let rows = common_rows(histories);
    let mut greatest = 0.0_f64;
    for (row, (a, b)) in rows.iter().enumerate() {
        let values = [value(fine, *a), value(coarse, *b)];
        let at_floor = values.iter().any(|value| value.abs() <= floor);
        if at_floor || is_next_to(histories[0], &rows, row, times) {
            greatest = greatest.max((values[0] - values[1]).abs());
        }
    }
    greatest
}

fn value(channel: &Channel, row: usize) -> f64 {
    channel.values.get(row).copied().unwrap_or_default()
}

/// The rows at the same times in both histories: of long runs either keeps some of its rows only.
fn common_rows([fine, coarse]: [&History; 2]) -> Vec<(usize, usize)> {
    let (mut a, mut b) = (0, 0);
    let mut rows = Vec::with_capacity(fine.time.len().min(coarse.time.len()));
    while let (Some(s), Some(t)) = (fine.time.get(a), coarse.time.get(b)) {
        let same = (s - t).abs() <= 1e-9 * s.abs().max(t.abs());
        if same {
            rows.push((a, b));
        }
        a += usize::from(same || s < t);
        b += usize::from(same || s > t);
    }
    rows
}

/// Whether a row is the last before, or the first after, any of the times.
fn is_next_to(history: &History, rows: &[(usize, usize)], row: usize, times: [f64; 2]) -> bool {
    let time = |row: usize| Some(history.time[rows.get(row)?.0]);
    let (before, after) = (row.checked_sub(1).and_then(time), time(row + 1));
    times.into_iter().any(|t| {
        let reaches_back = before.is_none_or(|before| before <= t);
        let reaches_on = after.is_none_or(|after| t <= after);
        reaches_back && reaches_on
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::ChannelQuantity;

    /// A channel at whole seconds, and its summary.
    fn run(quantity: ChannelQuantity, values: &[f64]) -> (History, ChannelSummary) {
        let mut channel = Channel::new(quantity.at("line|a"));
        channel.values = values.to_vec();
        let timed = || values.iter().copied().enumerate();
        let by_value = |a: &(usize, f64), b: &(usize, f64)| a.1.total_cmp(&b.1);
        let at = |found: Option<(usize, f64)>| found.map(|(k, v)| (v, k as f64)).unwrap();
        let summary = ChannelSummary {
            least: at(timed().min_by(by_value)),
            greatest: at(timed().max_by(by_value)),
            mean: 0.0,
            last: *values.last().unwrap(),
        };
        let history = History {
            time: (0..values.len()).map(|k| k as f64).collect(),
            channels: vec![channel],
        };
        (history, summary)
    }

    fn found(quantity: ChannelQuantity, fine: &[f64], coarse: &[f64]) -> [f64; 4] {
        let (one, two) = (run(quantity, fine), run(quantity, coarse));
        let id = quantity.at("line|a");
        differences(&id, [&one.1, &two.1], [&one.0, &two.0], 0)
    }

    #[test]
    fn a_slack_line_has_the_difference_it_shows_while_either_is_slack() {
        let (fine, coarse) = ([9.0, 4.0, 0.0, 3.0, 0.0], [9.5, 0.0, 0.0, 5.0, 0.0]);
        let tension = found(ChannelQuantity::Tension, &fine, &coarse);
        assert_eq!(tension, [4.0, 0.5, 0.0, 4.0]);
        // Zero is a height as any other.
        let height = found(ChannelQuantity::Z, &fine, &coarse);
        assert_eq!(height, [0.0, 0.5, 0.0, 0.0]);
    }

    #[test]
    fn the_rows_next_to_an_extreme_count_where_none_is_on_the_floor() {
        let (mut one, mut two) = (
            run(ChannelQuantity::Tension, &[8.0, 2.0, 5.0]),
            run(ChannelQuantity::Tension, &[8.0, 3.0, 5.5]),
        );
        // Between the rows.
        (one.1.least, two.1.least) = ((0.0, 1.4), (0.0, 1.4));
        let id = ChannelQuantity::Tension.at("line|a");
        let found = differences(&id, [&one.1, &two.1], [&one.0, &two.0], 0);
        assert_eq!(found[0], 1.0);
        assert_eq!(found[3], 0.5);
    }

    #[test]
    fn a_line_that_is_always_slack_has_no_error() {
        assert_eq!(
            found(ChannelQuantity::Tension, &[0.0; 3], &[0.0; 3]),
            [0.0; 4]
        );
    }
}
