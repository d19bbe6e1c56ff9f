//! A smooth ramp from zero to one over a time, without a kink in acceleration.

/// The growth r at time t \[s\] over `ramp` seconds, a quintic from 0 to 1, and its two derivatives by time.
#[must_use]
pub fn smooth_ramp(t: f64, ramp: f64) -> (f64, f64, f64) {
    if t >= ramp {
        return (1.0, 0.0, 0.0);
    }
    let s = (t / ramp).max(0.0);
    let r = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    let r1 = 30.0 * s * s * (1.0 - s) * (1.0 - s) / ramp;
    let r2 = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (ramp * ramp);
    (r, r1, r2)
}
