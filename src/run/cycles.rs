//! What is taken of every cycle of something that goes up and down.

/// How far beyond the mean a value must come to have gone through it, as a share of the whole range: ripples about the mean
/// are no cycles.
const BAND: f64 = 0.1;

/// Mean, over all whole cycles, of the extreme that `pick` takes of each. A cycle goes from one rise through the mean to the
/// next; nothing where there is no whole one.
pub(super) fn mean(values: &[f64], pick: fn(f64, f64) -> f64) -> Option<f64> {
    let level = values.iter().sum::<f64>() / values.len().max(1) as f64;
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let band = BAND * (high - low);
    let mut below = false;
    let mut extreme: Option<f64> = None;
    let (mut sum, mut cycles) = (0.0, 0_u32);
    for value in values {
        if *value < level - band {
            below = true;
        } else if below && *value > level + band {
            below = false;
            if let Some(whole) = extreme {
                sum += whole;
                cycles += 1;
            }
            extreme = Some(*value);
        }
        extreme = extreme.map(|e| pick(e, *value));
    }
    (cycles > 0).then(|| sum / f64::from(cycles))
}
