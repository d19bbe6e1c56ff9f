//! Single numbers taken of a channel: means, extremes, times; and which are wanted of a run.

use super::{Channel, History, Profile, along, cycles};
use crate::case::{AlongLine, Case, Statistic};

/// What a number is taken of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// The channel of this index.
    Channel(usize),
    /// A quantity of the whole line.
    Line(AlongLine),
}

/// A number that is wanted of a channel or of the whole line.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// What it is taken of.
    pub of: Of,
    /// What is taken of it.
    pub statistic: Statistic,
    /// Over which window of time \[s\] or, of the whole line, which stretch \[m\]; absent: all of it.
    pub window: Option<[f64; 2]>,
}

/// What a run of this case summarises: the greatest, smallest, mean and last value of every channel, the extremes of
/// the whole line, and every statistic its published values and trends ask for.
#[must_use]
pub fn wanted(case: &Case, channels: &[String]) -> Vec<Wanted> {
    use Statistic::{Final, Max, Mean, Min};
    let whole = |of, statistic| Wanted {
        of,
        statistic,
        window: None,
    };
    let mut list: Vec<Wanted> = (0..channels.len())
        .flat_map(|channel| [Max, Min, Mean, Final].map(|s| whole(Of::Channel(channel), s)))
        .collect();
    list.extend(along::ALWAYS.map(|(quantity, statistic)| whole(Of::Line(quantity), statistic)));
    let published = case
        .published
        .iter()
        .map(|p| (&p.channel, p.statistic, p.within()));
    let trends = case
        .trend
        .iter()
        .map(|t| (&t.channel, t.statistic, t.within()));
    for (name, statistic, window) in published.chain(trends) {
        let channel = channels.iter().position(|c| c == name).map(Of::Channel);
        let Some(of) = channel.or_else(|| AlongLine::named(name).map(Of::Line)) else {
            continue;
        };
        let item = Wanted {
            of,
            statistic,
            window,
        };
        if !list.contains(&item) {
            list.push(item);
        }
    }
    list
}

/// The number wanted; `None` where the window holds no output time, the run ended before the window does, or nothing
/// of the kind was recorded.
#[must_use]
pub fn evaluate(history: &History, profile: &Profile, wanted: &Wanted) -> Option<f64> {
    match wanted.of {
        Of::Channel(index) => over_time(history, history.channels.get(index)?, wanted),
        Of::Line(quantity) => along::evaluate(profile, quantity, wanted.statistic, wanted.window),
    }
}

fn over_time(history: &History, channel: &Channel, wanted: &Wanted) -> Option<f64> {
    let (times, values) = within(&history.time, &channel.values, wanted.window)?;
    let (first, last) = (*values.first()?, *values.last()?);
    let whole = wanted.window.is_none();
    match wanted.statistic {
        Statistic::Mean => Some(mean(times, values)),
        Statistic::Max => Some(greatest(channel, times, values, whole).0),
        Statistic::Min => Some(smallest(channel, times, values, whole).0),
        Statistic::Final => Some(last),
        Statistic::Travel => Some(first - smallest(channel, times, values, whole).0),
        Statistic::TimeOfMax => Some(greatest(channel, times, values, whole).1),
        Statistic::TimeOfMin => Some(smallest(channel, times, values, whole).1),
        Statistic::SettlingTime => settling_time(times, values),
        Statistic::RiseTime => rise_time(times, values),
        Statistic::Rate => {
            let span = times[times.len() - 1] - times[0];
            (span > 0.0).then(|| (last - first).abs() / span)
        }
        Statistic::MeanPeak => cycles::mean(values, f64::max),
        Statistic::MeanTrough => cycles::mean(values, f64::min),
        Statistic::ArcOfMax
        | Statistic::ArcOfMin
        | Statistic::GreatestFall
        | Statistic::Turns
        | Statistic::Peaks => None,
    }
}

/// The samples in a window, its ends included; nothing when the samples do not reach its end.
fn within<'a>(
    time: &'a [f64],
    values: &'a [f64],
    window: Option<[f64; 2]>,
) -> Option<(&'a [f64], &'a [f64])> {
    let Some([from, to]) = window else {
        return Some((time, values));
    };
    // Output times are products of roundings: a window's edge belongs to it.
    let slop = 1e-9 * to.abs().max(1.0);
    if time.last().is_none_or(|end| *end < to - slop) {
        return None;
    }
    let begin = time.partition_point(|t| *t < from - slop);
    let end = time.partition_point(|t| *t <= to + slop);
    (begin < end).then(|| (&time[begin..end], &values[begin..end]))
}

/// Time average by trapezes; a single sample is its own mean.
fn mean(times: &[f64], values: &[f64]) -> f64 {
    let span = times[times.len() - 1] - times[0];
    if span <= 0.0 {
        return values[0];
    }
    let area: f64 = times
        .windows(2)
        .zip(values.windows(2))
        .map(|(t, v)| 0.5 * (t[1] - t[0]) * (v[0] + v[1]))
        .sum();
    area / span
}

/// Greatest value and its time: over every step for a whole run, over the output times in a window.
fn greatest(channel: &Channel, times: &[f64], values: &[f64], whole: bool) -> (f64, f64) {
    if whole {
        channel.peak
    } else {
        extreme(times, values, |new, old| new > old)
    }
}

/// Smallest value and its time, likewise.
fn smallest(channel: &Channel, times: &[f64], values: &[f64], whole: bool) -> (f64, f64) {
    if whole {
        channel.trough
    } else {
        extreme(times, values, |new, old| new < old)
    }
}

fn extreme(times: &[f64], values: &[f64], better: impl Fn(f64, f64) -> bool) -> (f64, f64) {
    let mut best = (values[0], times[0]);
    for (t, v) in times.iter().zip(values) {
        if better(*v, best.0) {
            best = (*v, *t);
        }
    }
    best
}

/// First time after which every value stays within 2 % of the whole range from the last one.
fn settling_time(times: &[f64], values: &[f64]) -> Option<f64> {
    let last = *values.last()?;
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let band = 0.02 * (high - low);
    let outside = |v: f64| (v - last).abs() - band;
    match values.iter().rposition(|v| outside(*v) > 0.0) {
        None => times.first().copied(),
        Some(i) => Some(crossing(
            (times[i], outside(values[i])),
            (times[i + 1], outside(values[i + 1])),
        )),
    }
}

/// First time at which nine tenths of the way from the first to the last value are made.
fn rise_time(times: &[f64], values: &[f64]) -> Option<f64> {
    let (first, last) = (*values.first()?, *values.last()?);
    let way = last - first;
    if way == 0.0 {
        return times.first().copied();
    }
    let missing = |v: f64| 0.9 - (v - first) / way;
    let i = values.iter().position(|v| missing(*v) <= 0.0)?;
    if i == 0 {
        return times.first().copied();
    }
    Some(crossing(
        (times[i - 1], missing(values[i - 1])),
        (times[i], missing(values[i])),
    ))
}

/// Where the straight line between two points crosses zero.
fn crossing((t0, y0): (f64, f64), (t1, y1): (f64, f64)) -> f64 {
    if y0 == y1 {
        t1
    } else {
        t0 + (t1 - t0) * y0 / (y0 - y1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn history(values: Vec<f64>) -> History {
        let time = (0..values.len()).map(|i| i as f64).collect();
        let channel = Channel {
            values,
            peak: (9.0, 2.25),
            trough: (-9.0, 3.25),
            ..Channel::default()
        };
        History {
            time,
            channels: vec![channel],
        }
    }

    fn take(values: &[f64], statistic: Statistic, window: Option<[f64; 2]>) -> Option<f64> {
        evaluate(
            &history(values.to_vec()),
            &Profile::default(),
            &Wanted {
                of: Of::Channel(0),
                statistic,
                window,
            },
        )
    }

    #[test]
    fn mean_is_an_integral_and_windows_include_their_ends() {
        assert_eq!(take(&[0.0, 2.0, 4.0], Statistic::Mean, None), Some(2.0));
        assert_eq!(
            take(&[0.0, 2.0, 4.0, 100.0], Statistic::Mean, Some([0.0, 2.0])),
            Some(2.0)
        );
        assert_eq!(take(&[0.0, 2.0], Statistic::Mean, Some([0.0, 5.0])), None);
    }

    #[test]
    fn extremes_of_a_whole_run_are_those_of_every_step() {
        assert_eq!(take(&[1.0, 2.0, 0.0], Statistic::Max, None), Some(9.0));
        assert_eq!(
            take(&[1.0, 2.0, 0.0], Statistic::TimeOfMin, None),
            Some(3.25)
        );
        assert_eq!(
            take(&[1.0, 2.0, 0.0], Statistic::Max, Some([0.0, 2.0])),
            Some(2.0)
        );
        assert_eq!(take(&[1.0, 2.0, 0.0], Statistic::Travel, None), Some(10.0));
    }

    #[test]
    fn peaks_are_those_of_whole_cycles() {
        // Amplitudes 1, 2, 3 and 4; the cycles begun before the record and not ended in it are not whole.
        let swing: Vec<f64> = (0..=70)
            .map(|i| {
                let t = f64::from(i) / 20.0;
                (std::f64::consts::TAU * t).sin() * (1.0 + t.floor())
            })
            .collect();
        let mean = |s| take(&swing, s, None).unwrap();
        assert!(
            (mean(Statistic::MeanPeak) - 2.5).abs() < 1e-9,
            "{}",
            mean(Statistic::MeanPeak)
        );
        assert!((mean(Statistic::MeanTrough) + 2.5).abs() < 1e-9);
        assert_eq!(take(&[0.0, 1.0, 0.0], Statistic::MeanPeak, None), None);
    }

    #[test]
    fn settling_and_rising() {
        let fall: Vec<f64> = (0..200).map(|i| (-f64::from(i) / 10.0).exp()).collect();
        let settled = take(&fall, Statistic::SettlingTime, None).unwrap();
        assert!((settled - 10.0 * 50f64.ln()).abs() < 0.1, "{settled}");
        let risen = take(&fall, Statistic::RiseTime, None).unwrap();
        assert!((risen - 10.0 * 10f64.ln()).abs() < 0.1, "{risen}");
        assert_eq!(take(&[3.0, 0.0, 5.0], Statistic::Rate, None), Some(1.0));
    }
}
