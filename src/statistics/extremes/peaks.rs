//! Peaks of a record: the greatest between mean up-crossings, of clusters over a threshold, of blocks of time.

use super::error::{ExtremesError, check_finite, check_inside};
use super::moments::up_crossings;
use crate::numerics::statistics::mean;

/// A peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Its place in the record, from zero.
    pub index: usize,
    /// Its value, in the unit of the record.
    pub value: f64,
}

/// The greatest value between each two consecutive upward crossings of the mean: the global maxima. Parts before the first and
/// after the last crossing are left out. Empty for fewer than two crossings and for values that are not finite.
#[must_use]
pub fn global_maxima(values: &[f64]) -> Vec<Peak> {
    let centre = mean(values);
    let crossings: Vec<usize> = up_crossings(values, centre).collect();
    let between = crossings.windows(2).filter_map(|pair| match *pair {
        [from, to] => greatest(values, from, to),
        _ => None,
    });
    between.filter(|p| p.value.is_finite()).collect()
}

/// The greatest value of each cluster of values above a threshold. A cluster ends where the next value above the threshold comes
/// more than `separation` seconds later (declustering by runs: Coles 2001, section 5.3.2). Of equal values the first.
///
/// # Errors
/// Where times do not rise or are not as many as the values, a number is not finite, or the separation is negative.
pub fn over_threshold(
    times: &[f64],
    values: &[f64],
    threshold: f64,
    separation: f64,
) -> Result<Vec<Peak>, ExtremesError> {
    check_times(times, values)?;
    check_finite(&[threshold], 1)?;
    let range = (-f64::MIN_POSITIVE, f64::INFINITY);
    check_inside("the separation", separation, range, "of 0 s or more")?;
    let mut peaks: Vec<Peak> = Vec::new();
    let mut last = f64::NEG_INFINITY;
    for (index, (&time, &value)) in times.iter().zip(values).enumerate() {
        if value <= threshold {
            continue;
        }
        match peaks.last_mut() {
            Some(peak) if time - last <= separation => {
                if value > peak.value {
                    *peak = Peak { index, value };
                }
            }
            _ => peaks.push(Peak { index, value }),
        }
        last = time;
    }
    Ok(peaks)
}

/// The greatest value of each block of `block` seconds, the first beginning at the first time and each holding its beginning
/// but not its end. The last block may be short: leave it out where it is. Blocks without values are left out.
///
/// # Errors
/// Where times do not rise or are not as many as the values, a number is not finite, or the block is not above zero.
pub fn block_maxima(times: &[f64], values: &[f64], block: f64) -> Result<Vec<Peak>, ExtremesError> {
    check_times(times, values)?;
    check_inside("the block", block, (0.0, f64::INFINITY), "above 0 s")?;
    let first = times.first().copied().unwrap_or_default();
    let mut peaks: Vec<Peak> = Vec::new();
    let mut number = f64::NEG_INFINITY;
    for (index, (&time, &value)) in times.iter().zip(values).enumerate() {
        let here = ((time - first) / block).floor();
        match peaks.last_mut() {
            Some(peak) if here <= number => {
                if value > peak.value {
                    *peak = Peak { index, value };
                }
            }
            _ => peaks.push(Peak { index, value }),
        }
        number = here;
    }
    Ok(peaks)
}

/// Times that are finite and rise, with a finite value for each.
pub(super) fn check_times(times: &[f64], values: &[f64]) -> Result<(), ExtremesError> {
    check_finite(values, 1)?;
    if times.len() != values.len() {
        return Err(ExtremesError::Times(times.len().min(values.len())));
    }
    let mut before = f64::NEG_INFINITY;
    for (index, time) in times.iter().enumerate() {
        if !time.is_finite() || *time <= before {
            return Err(ExtremesError::Times(index));
        }
        before = *time;
    }
    Ok(())
}

fn greatest(values: &[f64], from: usize, to: usize) -> Option<Peak> {
    let part = values.get(from..to)?.iter().enumerate();
    let best = part.fold(None, |best: Option<(usize, f64)>, (k, v)| match best {
        Some((_, most)) if *v <= most => best,
        _ => Some((k, *v)),
    });
    best.map(|(k, value)| Peak {
        index: from + k,
        value,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    fn of(peaks: &[Peak]) -> Vec<(usize, f64)> {
        peaks.iter().map(|p| (p.index, p.value)).collect()
    }

    #[test]
    fn one_peak_for_each_crossing() {
        // The mean is zero; the first rise and the last are cut off.
        let values = [1.0, -1.0, 2.0, 1.0, 3.0, -4.0, 1.0, -1.5, 2.0, -3.5];
        assert_eq!(of(&global_maxima(&values)), [(4, 3.0), (6, 1.0)]);
        assert!(global_maxima(&[]).is_empty() && global_maxima(&[1.0, 2.0]).is_empty());
    }

    #[test]
    fn clusters_and_blocks() {
        let times: Vec<f64> = (0..10).map(f64::from).collect();
        let values = [0.0, 5.0, 7.0, 0.0, 6.0, 0.0, 0.0, 0.0, 8.0, 8.0];
        let peaks = |separation| of(&over_threshold(&times, &values, 4.0, separation).unwrap());
        assert_eq!(
            peaks(0.0),
            [(1, 5.0), (2, 7.0), (4, 6.0), (8, 8.0), (9, 8.0)]
        );
        assert_eq!(peaks(1.0), [(2, 7.0), (4, 6.0), (8, 8.0)]);
        assert_eq!(peaks(2.0), [(2, 7.0), (8, 8.0)]);
        assert_eq!(
            of(&block_maxima(&times, &values, 4.0).unwrap()),
            [(2, 7.0), (4, 6.0), (8, 8.0)]
        );
    }

    #[test]
    fn bad_records_are_refused() {
        assert_eq!(
            over_threshold(&[0.0, 0.0], &[1.0, 2.0], 0.0, 1.0),
            Err(ExtremesError::Times(1))
        );
        assert!(over_threshold(&[0.0], &[1.0, 2.0], 0.0, 1.0).is_err());
        assert!(over_threshold(&[0.0, 1.0], &[1.0, 2.0], 0.0, -1.0).is_err());
        assert!(block_maxima(&[0.0, 1.0], &[1.0, f64::NAN], 1.0).is_err());
        assert!(block_maxima(&[0.0, 1.0], &[1.0, 2.0], 0.0).is_err());
        assert!(block_maxima(&[], &[], 1.0).is_err());
    }

    /// Peaks are values of the record, in order, above the threshold, and the greatest of all is among them.
    #[test]
    fn of_random_records() {
        for seed in 0..200 {
            let mut random = Random::new(seed, 0);
            let count = 1 + (random.uniform() * 60.0) as usize;
            let values: Vec<f64> = (0..count).map(|_| random.uniform()).collect();
            let times: Vec<f64> = (0..count).map(|k| 0.7 * k as f64).collect();
            let most = values.iter().copied().fold(0.0, f64::max);
            let clusters = over_threshold(&times, &values, 0.5, 2.0).unwrap();
            let blocks = block_maxima(&times, &values, 5.0).unwrap();
            assert!(blocks.iter().any(|p| p.value == most));
            assert!(most <= 0.5 || clusters.iter().any(|p| p.value == most));
            for peaks in [&clusters, &blocks, &global_maxima(&values)] {
                assert!(peaks.iter().all(|p| values[p.index] == p.value));
                assert!(peaks.windows(2).all(|pair| pair[0].index < pair[1].index));
            }
        }
    }
}
