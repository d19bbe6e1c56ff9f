//! The ship's motion as the file gives it, as a series of places of the rope's hang point.

use std::f64::consts::TAU;

use super::model::Motion;
use super::winch::HangPoint;

/// Steps that a period is followed in.
const A_PERIOD: f64 = 40.0;

/// Most instants of a series.
const MOST: f64 = 20_000.0;

/// Where the hang point is at a time: it starts from its mean place, away from the platform and upwards.
#[must_use]
pub fn at(motion: &Motion, time_s: f64) -> HangPoint {
    let swing = |period: f64| (TAU * time_s / period).sin();
    HangPoint {
        time_s,
        x_m: motion.surge_m * swing(motion.surge_period_s),
        z_m: motion.heave_m * swing(motion.heave_period_s),
    }
}

/// The motion at equal steps over a time, in steps that follow the shorter period of those that move.
#[must_use]
pub fn series(motion: &Motion, duration_s: f64) -> Vec<HangPoint> {
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
