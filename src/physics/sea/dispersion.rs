//! Wave number of a regular wave: `omega² = g k tanh(k h)` (Airy).

/// Wave number k \[1/m\] at an angular frequency \[rad/s\], gravity \[m/s²\] and depth \[m\], infinite for deep water. To
/// rounding: Newton's method from Eckart's formula, which is within a few per cent at every depth.
#[must_use]
pub fn wave_number(omega: f64, gravity: f64, depth: f64) -> f64 {
    let deep = omega * omega / gravity;
    let y = deep * depth;
    // tanh(20) is 1 to the last digit; NaN and infinity fall in here too.
    if y.is_nan() || y > 20.0 || y <= 0.0 {
        return deep;
    }
    let mut x = y / y.tanh().sqrt();
    for _ in 0..20 {
        let t = x.tanh();
        let step = (x * t - y) / (t + x * (1.0 - t * t));
        x -= step;
        if step.abs() <= 2.0 * f64::EPSILON * x {
            break;
        }
    }
    x / depth
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn to_rounding_from_shallow_to_deep() {
        let g = 9.81;
        for depth in [0.01, 0.5, 5.0, 50.0, 500.0, 5000.0] {
            for omega in [0.05, 0.3, 1.0, 3.0] {
                let k = wave_number(omega, g, depth);
                let back = g * k * (k * depth).tanh();
                assert!(
                    (back / (omega * omega) - 1.0).abs() < 1e-14,
                    "{depth} {omega}"
                );
            }
        }
    }

    #[test]
    fn tends_to_the_two_limits() {
        assert_eq!(wave_number(1.0, 9.81, f64::INFINITY), 1.0 / 9.81);
        let shallow = wave_number(1e-4, 9.81, 10.0);
        assert!((shallow / (1e-4 / 98.1_f64.sqrt()) - 1.0).abs() < 1e-7);
    }
}
