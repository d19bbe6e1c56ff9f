//! Harmonic motion of the rope's hang point on the ship, by the keys of the file.

use std::f64::consts::TAU;

use super::model::HangPointMotion;
use super::winch::ShipOffset;

/// Steps of a period.
const A_PERIOD: f64 = 40.0;

/// Greatest number of steps of a series.
const MOST: f64 = 20_000.0;

/// Displacement of the hang point at a time, away from the platform and upwards, from zero at t = 0.
#[must_use]
pub fn at(motion: &HangPointMotion, time_s: f64) -> ShipOffset {
    let swing = |period: f64| (TAU * time_s / period).sin();
    ShipOffset {
        time_s,
        x_m: motion.surge_m * swing(motion.surge_period_s),
        z_m: motion.heave_m * swing(motion.heave_period_s),
    }
}

/// The motion at equal steps over a duration, a fixed number of steps in the shorter period of those with an amplitude.
#[must_use]
pub fn series(motion: &HangPointMotion, duration_s: f64) -> Vec<ShipOffset> {
    let moving = [
        (motion.surge_m, motion.surge_period_s),
        (motion.heave_m, motion.heave_period_s),
    ];
    let periods = moving.iter().filter(|part| part.0 > 0.0).map(|part| part.1);
    let shortest = periods.fold(duration_s, f64::min);
    let steps = (duration_s / shortest * A_PERIOD).ceil().clamp(1.0, MOST) as usize;
    let time = |i: usize| duration_s * i as f64 / steps as f64;
    (0..=steps).map(|i| at(motion, time(i))).collect()
}
