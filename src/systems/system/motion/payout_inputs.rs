//! The payouts that a file states.

use super::{
    super::{
        model::{PayoutInputs, SlidingInputs, SystemFile},
        network::Network,
    },
    payout::{Drive, LEAST_RATE, PaidEnd, Payout, PointFriction, RateCourse, SLIP, Winch},
};
use crate::{
    numerics::{V3, spline::Spline},
    physics::{EndMotion, motion::MotionPath},
};

/// The payouts that a file states; what they lack was refused with the file.
#[must_use]
pub fn payouts(file: &SystemFile, network: &Network) -> Vec<Payout> {
    let paid = file.payouts.iter().filter_map(|given| {
        let line = network.line(&given.line)?;
        let end = PaidEnd {
            line,
            end: given.end.index(),
            sign: 1.0,
        };
        Some(Payout {
            ends: vec![end],
            drive: drive(given)?,
            heave: given.heave_compensation.unwrap_or(0.0),
        })
    });
    let slid = file.sliding_points.iter().filter_map(|given| {
        Some(Payout {
            ends: sliding_ends(given, network)?,
            drive: sliding_drive(given)?,
            heave: 0.0,
        })
    });
    paid.chain(slid).collect()
}

/// What drives a point along a line: a rate, a table, or nothing but the line.
fn sliding_drive(given: &SlidingInputs) -> Option<Drive> {
    if let Some(rate) = given.rate_m_per_s {
        let span = (given.start_s, given.stop_s);
        return Some(rate_drive(rate, span, given.ramp_s));
    }
    if !given.table_time_s.is_empty() {
        return table_drive(&given.table_time_s, &given.table_m, given.ramp_s);
    }
    Some(Drive::Slide(PointFriction {
        constant: given.friction_n,
        coefficient: given.friction,
        ramp: given.ramp_s,
    }))
}

/// The ends of both lines at a point that slides; hauled, `line` grows by what it is hauled along.
fn sliding_ends(given: &SlidingInputs, network: &Network) -> Option<Vec<PaidEnd>> {
    let point = network.point(&given.point)?;
    let end = |name: &str, sign: f64| {
        let line = network.line(name)?;
        let ends = [network.lines[line].from, network.lines[line].to];
        let end = ends.iter().position(|known| *known == point)?;
        Some(PaidEnd { line, end, sign })
    };
    let hauled = given.rate_m_per_s.is_some() || !given.table_time_s.is_empty();
    let sign = if hauled { 1.0 } else { -1.0 };
    Some(vec![end(&given.line, sign)?, end(&given.other, -sign)?])
}

pub(super) fn drive(given: &PayoutInputs) -> Option<Drive> {
    if let Some(tension) = given.tension_n {
        return Some(Drive::Winch(Winch {
            mass: given.drum_mass_kg,
            limits: [tension; 2],
            rate: 0.0,
            slope: 0.0,
            fastest: given.greatest_rate_m_per_s,
            ramp: given.ramp_s,
        }));
    }
    if let Some(rate) = given.rate_m_per_s {
        if let Some(tension) = given.greatest_tension_n {
            let slip = SLIP * rate.abs().max(LEAST_RATE);
            return Some(Drive::Winch(Winch {
                mass: given.drum_mass_kg,
                limits: [0.0, tension],
                rate: rate - slip,
                slope: tension / slip,
                fastest: None,
                ramp: given.ramp_s,
            }));
        }
        let span = (given.start_s, given.stop_s);
        return Some(rate_drive(rate, span, given.ramp_s));
    }
    if given.table_time_s.is_empty() {
        // The heave alone.
        return Some(rate_drive(0.0, (0.0, None), given.ramp_s));
    }
    table_drive(&given.table_time_s, &given.table_m, given.ramp_s)
}

/// A rate \[m/s\] from a time \[s\], to another if there is one, with its ramp \[s\].
fn rate_drive(rate: f64, (start, stop): (f64, Option<f64>), ramp: f64) -> Drive {
    Drive::Rate(RateCourse {
        rate,
        start,
        stop: stop.unwrap_or(f64::INFINITY),
        ramp,
    })
}

/// Lengths \[m\] at these times \[s\], with the ramp \[s\].
fn table_drive(times: &[f64], lengths: &[f64], ramp: f64) -> Option<Drive> {
    let row = |(time, out): (&f64, &f64)| (*time, V3::new(*out, 0.0, 0.0));
    let rows: Vec<(f64, V3)> = times.iter().zip(lengths).map(row).collect();
    Some(Drive::Table(EndMotion {
        position: V3::zeros(),
        course: MotionPath::Table(Spline::through(&rows).ok()?),
        ramp,
    }))
}
