//! The numbers of a ship's motion by name: `surge.displacement.rms`, `pitch.acceleration.max`.

use super::motion_analysis::MotionAnalysis;
use crate::numerics::statistics::Statistics;
use crate::physics::sea::DEGREES;

/// Names of the rates of a degree of freedom, in their order.
pub const RATES: [&str; 3] = ["displacement", "velocity", "acceleration"];

/// Names of the statistics of a record.
pub const STATISTICS: [&str; 5] = ["mean", "rms", "deviation", "max", "min"];

/// Degree of freedom, rate and statistic of a name.
#[must_use]
pub fn parts(name: &str) -> Option<(usize, usize, &str)> {
    let mut settings = name.split('.');
    let (degree, rate, statistic) = (settings.next()?, settings.next()?, settings.next()?);
    let degree = DEGREES.iter().position(|d| *d == degree)?;
    let rate = RATES.iter().position(|r| *r == rate)?;
    let known = STATISTICS.contains(&statistic) && settings.next().is_none();
    known.then_some((degree, rate, statistic))
}

/// The unit of a name's number; empty for a name that is none.
#[must_use]
pub fn unit(name: &str) -> &'static str {
    const UNITS: [[&str; 3]; 2] = [["m", "m/s", "m/s²"], ["deg", "deg/s", "deg/s²"]];
    parts(name).map_or("", |(degree, rate, _)| UNITS[degree / 3][rate])
}

/// The number of a name, in its unit.
#[must_use]
pub fn quantity(motion: &MotionAnalysis, name: &str) -> Option<f64> {
    let (degree, rate, statistic) = parts(name)?;
    let of = &motion.statistics[degree][rate];
    let scale = if degree < 3 {
        1.0
    } else {
        1.0_f64.to_degrees()
    };
    Some(scale * value(of, statistic)?)
}

fn value(of: &Statistics, statistic: &str) -> Option<f64> {
    Some(match statistic {
        "mean" => of.mean,
        "rms" => of.rms,
        "deviation" => of.deviation,
        "max" => of.max,
        "min" => of.min,
        _ => return None,
    })
}
