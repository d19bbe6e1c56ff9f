//! The cargo's own motion with one degree of freedom: the Tianjin paper, eq. (12).
//!
//! `m y'' + c y' = Q - H (tan aL + tan aR)`, tan aL = y/L0, tan aR = (y + h)/(L - L0), c = 2 zeta w0 m; y is the cargo's
//! depth below the platform's hang point, L0 its distance from there, h the height of the ship's hang point above the
//! platform's. The pull H stays as it is, as a winch would keep it, and the rope weighs nothing. The damping goes with
//! the frequency w0 at the place where the cargo is.

use super::Trouble;
use super::bare::Gap;

/// A cargo on a rope with a pull that stays as it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// Mass of the cargo m \[kg\].
    pub mass_kg: f64,
    /// Its weight Q \[N\].
    pub cargo_n: f64,
    /// Horizontal pull H \[N\].
    pub horizontal_n: f64,
    /// Damping ratio ζ \[-\].
    pub damping_ratio: f64,
}

/// What the cargo hangs from at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hang {
    /// The ends.
    pub gap: Gap,
    /// Distance of the cargo from the platform L0 \[m\].
    pub x_m: f64,
}

/// The cargo at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swung {
    /// Time \[s\].
    pub time_s: f64,
    /// Where it is between its ends.
    pub hang: Hang,
    /// Depth y below the platform's hang point \[m\].
    pub depth_m: f64,
    /// Speed downwards \[m/s\].
    pub speed_m_per_s: f64,
    /// Tension on the platform's side \[N\].
    pub platform_n: f64,
    /// Tension on the ship's side \[N\].
    pub ship_n: f64,
}

impl Swing {
    /// Natural frequency w0 of the cargo at a place \[rad/s\]: `w0² = H/m (1/L0 + 1/(L - L0))`.
    #[must_use]
    pub fn natural_rad_per_s(&self, hang: &Hang) -> f64 {
        (self.horizontal_n / self.mass_kg * (1.0 / hang.x_m + 1.0 / behind(hang))).sqrt()
    }

    /// Depth at which it comes to rest \[m\].
    #[must_use]
    pub fn settled_m(&self, hang: &Hang) -> f64 {
        let stiffness = self.horizontal_n * (1.0 / hang.x_m + 1.0 / behind(hang));
        (self.cargo_n - self.horizontal_n * hang.gap.rise_m / behind(hang)) / stiffness
    }

    /// Depth and speed at a time after it was let go at rest from a depth, where it stays at one place: the closed form for a
    /// damping ratio below one.
    #[must_use]
    pub fn let_go(&self, hang: &Hang, from_m: f64, time_s: f64) -> (f64, f64) {
        let (w, zeta) = (self.natural_rad_per_s(hang), self.damping_ratio);
        let settled = self.settled_m(hang);
        let damped = w * (1.0 - zeta * zeta).max(0.0).sqrt();
        let (sin, cos) = (damped * time_s).sin_cos();
        let fade = (-zeta * w * time_s).exp() * (from_m - settled);
        let lag = zeta * w / damped;
        (
            settled + fade * (cos + lag * sin),
            -fade * sin * (damped + lag * zeta * w),
        )
    }

    fn acceleration(&self, hang: &Hang, depth: f64, speed: f64) -> f64 {
        let tangents = depth / hang.x_m + (depth + hang.gap.rise_m) / behind(hang);
        let damping = 2.0 * self.damping_ratio * self.natural_rad_per_s(hang) * speed;
        (self.cargo_n - self.horizontal_n * tangents) / self.mass_kg - damping
    }

    fn read(&self, time_s: f64, hang: Hang, depth_m: f64, speed_m_per_s: f64) -> Swung {
        let before = depth_m / hang.x_m;
        let after = (depth_m + hang.gap.rise_m) / behind(&hang);
        Swung {
            time_s,
            hang,
            depth_m,
            speed_m_per_s,
            platform_n: self.horizontal_n * before.hypot(1.0),
            ship_n: self.horizontal_n * after.hypot(1.0),
        }
    }

    /// Follows the cargo from rest where it would settle, by Runge-Kutta of order 4 in steps of no more than a
    /// fortieth of its quickest period. `hang` says where it hangs at a time; an instant is kept every `every_s`.
    ///
    /// # Errors
    /// [`Trouble::NotFound`] where the cargo comes to a support, at which the equation ends.
    pub fn follow(
        &self,
        hang: impl Fn(f64) -> Hang,
        duration_s: f64,
        every_s: f64,
    ) -> Result<Vec<Swung>, Trouble> {
        let inside = |hang: &Hang| hang.x_m > 0.0 && behind(hang) > 0.0;
        let first = hang(0.0);
        if !inside(&first) {
            return Err(Trouble::NotFound("the cargo begins on a support"));
        }
        let (mut y, mut v) = (self.settled_m(&first), 0.0);
        let count = (duration_s / every_s).ceil().clamp(1.0, 1e6) as usize;
        let mut kept = Vec::with_capacity(count + 1);
        kept.push(self.read(0.0, first, y, v));
        for i in 0..count {
            let t = every_s * i as f64;
            let quickest = self
                .natural_rad_per_s(&hang(t))
                .max(self.natural_rad_per_s(&hang(t + every_s)));
            let parts = (every_s * quickest * 40.0 / std::f64::consts::TAU).ceil();
            if !inside(&hang(t + every_s)) || !parts.is_finite() {
                return Err(Trouble::NotFound("the cargo comes to a support"));
            }
            let step = every_s / parts.max(1.0);
            for part in 0..parts.max(1.0) as usize {
                (y, v) = self.step(&hang, t + step * part as f64, step, (y, v));
            }
            kept.push(self.read(t + every_s, hang(t + every_s), y, v));
        }
        Ok(kept)
    }

    fn step(&self, hang: &impl Fn(f64) -> Hang, t: f64, h: f64, (y, v): (f64, f64)) -> (f64, f64) {
        let (now, half, end) = (hang(t), hang(t + 0.5 * h), hang(t + h));
        let a1 = self.acceleration(&now, y, v);
        let v2 = v + 0.5 * h * a1;
        let a2 = self.acceleration(&half, y + 0.5 * h * v, v2);
        let v3 = v + 0.5 * h * a2;
        let a3 = self.acceleration(&half, y + 0.5 * h * v2, v3);
        let v4 = v + h * a3;
        let a4 = self.acceleration(&end, y + h * v3, v4);
        (
            y + h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4),
            v + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4),
        )
    }
}

/// Distance of the cargo from the ship \[m\].
fn behind(hang: &Hang) -> f64 {
    hang.gap.span_m - hang.x_m
}

/// Natural frequencies of the same cargo on a rope that has mass, as a taut string of this mass per length with a mass on
/// it: the first in which the cargo moves \[rad/s\]. `m w = (H/c) (cot(w L0/c) + cot(w (L - L0)/c))`, c² = H/mu.
///
/// # Errors
/// [`Trouble::NotFound`] where the search fails.
pub fn string_rad_per_s(swing: &Swing, hang: &Hang, mass_kg_per_m: f64) -> Result<f64, Trouble> {
    let c = (swing.horizontal_n / mass_kg_per_m).sqrt();
    let (a, b) = (hang.x_m / c, behind(hang) / c);
    // Below the first pole of either cotangent the sum falls and the mass term grows.
    let pole = std::f64::consts::PI / a.max(b);
    let off = |w: f64| {
        let held = swing.horizontal_n / c * (1.0 / (w * a).tan() + 1.0 / (w * b).tan());
        Ok(held - swing.mass_kg * w)
    };
    super::search::root(
        (1e-9 * pole, pole * (1.0 - 1e-12)),
        "the string has no frequency",
        off,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const SWING: Swing = Swing {
        mass_kg: 50.0,
        cargo_n: 490.0,
        horizontal_n: 3600.0,
        damping_ratio: 0.05,
    };

    fn hang(x_m: f64) -> Hang {
        let gap = Gap {
            span_m: 80.0,
            rise_m: 2.0,
        };
        Hang { gap, x_m }
    }

    #[test]
    fn let_go_it_swings_as_the_closed_form_says() {
        let at = hang(30.0);
        let (y, v) = SWING.let_go(&at, 0.0, 0.0);
        assert!(y.abs() < 1e-12 && v.abs() < 1e-12);
        let (h, t) = (1e-4, 1.3);
        let (y, v) = SWING.let_go(&at, 0.0, t);
        let speed = (SWING.let_go(&at, 0.0, t + h).0 - SWING.let_go(&at, 0.0, t - h).0) / (2.0 * h);
        assert!((speed - v).abs() < 1e-6);
        let rate = (SWING.let_go(&at, 0.0, t + h).1 - SWING.let_go(&at, 0.0, t - h).1) / (2.0 * h);
        assert!((rate - SWING.acceleration(&at, y, v)).abs() < 1e-6);
    }

    #[test]
    fn the_march_is_of_order_four_and_meets_the_closed_form() {
        let still = |_| hang(30.0);
        let moving = |t: f64| hang(30.0 + 0.0 * t);
        let rest = SWING.follow(moving, 5.0, 0.1).unwrap();
        let settled = SWING.settled_m(&hang(30.0));
        assert!(rest.iter().all(|s| (s.depth_m - settled).abs() < 1e-9));
        let run = |steps: usize| {
            let h = 4.0 / steps as f64;
            let mut state = (0.0, 0.0);
            for i in 0..steps {
                state = SWING.step(&still, h * i as f64, h, state);
            }
            (state.0 - SWING.let_go(&hang(30.0), 0.0, 4.0).0).abs()
        };
        let order = (run(40) / run(80)).log2();
        assert!((order - 4.0).abs() < 0.2, "{order}");
    }

    #[test]
    fn a_string_without_mass_swings_as_one_degree_and_without_cargo_as_a_string() {
        let at = hang(40.0);
        let light = string_rad_per_s(&SWING, &at, 1e-7).unwrap();
        assert!((light / SWING.natural_rad_per_s(&at) - 1.0).abs() < 1e-4);
        let bare = Swing {
            mass_kg: 1e-9,
            ..SWING
        };
        let string = string_rad_per_s(&bare, &at, 2.2).unwrap();
        let known = std::f64::consts::PI / 80.0 * (3600.0_f64 / 2.2).sqrt();
        assert!((string / known - 1.0).abs() < 1e-8);
    }

    #[test]
    fn at_a_support_the_equation_ends() {
        assert!(SWING.follow(|t| hang(5.0 - t), 10.0, 0.5).is_err());
        assert!(SWING.follow(|_| hang(0.0), 10.0, 0.5).is_err());
    }
}
