//! Scalar results of the ship's motion by name: `surge.displacement.rms`, `pitch.acceleration.max`.

use super::motion_analysis::MotionAnalysis;
use crate::numerics::statistics::Statistics;
use crate::physics::sea::DEGREES;

/// Names of a displacement and its derivatives.
pub const RATES: [&str; 3] = ["displacement", "velocity", "acceleration"];

/// Names of the statistics of a record.
pub const STATISTICS: [&str; 5] = ["mean", "rms", "deviation", "max", "min"];

/// Units of displacement, velocity and acceleration, of translations and of rotations.
pub const UNITS: [[&str; 3]; 2] = [["m", "m/s", "m/s²"], ["deg", "deg/s", "deg/s²"]];

/// Degree of freedom, derivative and statistic of a name.
#[must_use]
pub fn parts(name: &str) -> Option<(usize, usize, &str)> {
    let mut parts = name.split('.');
    let (degree, rate, statistic) = (parts.next()?, parts.next()?, parts.next()?);
    let degree = DEGREES.iter().position(|d| *d == degree)?;
    let rate = RATES.iter().position(|r| *r == rate)?;
    let known = STATISTICS.contains(&statistic) && parts.next().is_none();
    known.then_some((degree, rate, statistic))
}

/// The unit of a quantity; empty for an unknown name.
#[must_use]
pub fn unit(name: &str) -> &'static str {
    parts(name).map_or("", |(degree, rate, _)| UNITS[degree / 3][rate])
}

/// Factor from SI units to the units of a degree of freedom.
#[must_use]
pub fn scale(degree: usize) -> f64 {
    if degree < 3 {
        1.0
    } else {
        1.0_f64.to_degrees()
    }
}

/// The value of a quantity, in its unit.
#[must_use]
pub fn quantity(motion: &MotionAnalysis, name: &str) -> Option<f64> {
    let (degree, rate, statistic) = parts(name)?;
    let of = &motion.statistics[degree][rate];
    Some(scale(degree) * value(of, statistic)?)
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
