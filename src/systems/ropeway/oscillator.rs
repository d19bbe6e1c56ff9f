//! Vertical motion of the cargo with one degree of freedom: the Tianjin paper, eq. (12).
//!
//! `m y'' + c y' = Q - H (tan aL + tan aR)`, tan aL = y/L0, tan aR = (y + h)/(L - L0), c = 2 zeta w0 m; y is the cargo's
//! depth below the platform's hang point, L0 its distance from there, h the height of the ship's hang point above the
//! platform's. The horizontal tension H is constant, as a winch keeps it; the rope has no weight. The damping is relative
//! to the natural frequency w0 at the position of the cargo.

use super::RopewayError;
use super::roots;
use super::unloaded::SpanGeometry;

/// A cargo on a weightless rope of constant horizontal tension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CargoOscillator {
    /// Mass of the cargo m \[kg\].
    pub mass_kg: f64,
    /// Its weight Q \[N\].
    pub cargo_n: f64,
    /// Horizontal tension H \[N\].
    pub horizontal_n: f64,
    /// Damping ratio ζ \[-\].
    pub damping_ratio: f64,
}

/// Position of the cargo between the supports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CargoPosition {
    /// The supports.
    pub geometry: SpanGeometry,
    /// Distance of the cargo from the platform L0 \[m\].
    pub x_m: f64,
}

/// State of the cargo at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CargoState {
    /// Time \[s\].
    pub time_s: f64,
    /// Its position between the supports.
    pub position: CargoPosition,
    /// Depth y below the platform's hang point \[m\].
    pub depth_m: f64,
    /// Speed downwards \[m/s\].
    pub speed_m_per_s: f64,
    /// Tension on the platform's side \[N\].
    pub platform_n: f64,
    /// Tension on the ship's side \[N\].
    pub ship_n: f64,
}

impl CargoOscillator {
    /// Natural frequency w0 of the cargo at a position \[rad/s\]: `w0² = H/m (1/L0 + 1/(L - L0))`.
    #[must_use]
    pub fn natural_rad_per_s(&self, position: &CargoPosition) -> f64 {
        (self.horizontal_n / self.mass_kg * (1.0 / position.x_m + 1.0 / ship_distance_m(position)))
            .sqrt()
    }

    /// Depth of its equilibrium \[m\].
    #[must_use]
    pub fn equilibrium_depth_m(&self, position: &CargoPosition) -> f64 {
        let stiffness = self.horizontal_n * (1.0 / position.x_m + 1.0 / ship_distance_m(position));
        (self.cargo_n - self.horizontal_n * position.geometry.rise_m / ship_distance_m(position))
            / stiffness
    }

    /// Depth and speed at a time of free decay from rest at a depth, at a fixed position: the closed form for a damping ratio
    /// below one.
    #[must_use]
    pub fn free_decay(&self, position: &CargoPosition, from_m: f64, time_s: f64) -> (f64, f64) {
        let (w, zeta) = (self.natural_rad_per_s(position), self.damping_ratio);
        let settled = self.equilibrium_depth_m(position);
        let damped = w * (1.0 - zeta * zeta).max(0.0).sqrt();
        let (sin, cos) = (damped * time_s).sin_cos();
        let fade = (-zeta * w * time_s).exp() * (from_m - settled);
        let lag = zeta * w / damped;
        (
            settled + fade * (cos + lag * sin),
            -fade * sin * (damped + lag * zeta * w),
        )
    }

    fn acceleration(&self, position: &CargoPosition, depth: f64, speed: f64) -> f64 {
        let tangents =
            depth / position.x_m + (depth + position.geometry.rise_m) / ship_distance_m(position);
        let damping = 2.0 * self.damping_ratio * self.natural_rad_per_s(position) * speed;
        (self.cargo_n - self.horizontal_n * tangents) / self.mass_kg - damping
    }

    fn read(
        &self,
        time_s: f64,
        position: CargoPosition,
        depth_m: f64,
        speed_m_per_s: f64,
    ) -> CargoState {
        let before = depth_m / position.x_m;
        let after = (depth_m + position.geometry.rise_m) / ship_distance_m(&position);
        CargoState {
            time_s,
            position,
            depth_m,
            speed_m_per_s,
            platform_n: self.horizontal_n * before.hypot(1.0),
            ship_n: self.horizontal_n * after.hypot(1.0),
        }
    }

    /// Integrates the motion from equilibrium, by Runge-Kutta of order 4 in steps of at most a fortieth of the natural
    /// period. `position` gives the position at a time; a state is kept every `every_s`.
    ///
    /// # Errors
    /// [`RopewayError::NotFound`] where the cargo reaches a support, at which the equation is singular.
    pub fn simulate(
        &self,
        position: impl Fn(f64) -> CargoPosition,
        duration_s: f64,
        every_s: f64,
    ) -> Result<Vec<CargoState>, RopewayError> {
        let inside =
            |position: &CargoPosition| position.x_m > 0.0 && ship_distance_m(position) > 0.0;
        let first = position(0.0);
        if !inside(&first) {
            return Err(RopewayError::NotFound("the cargo starts on a support"));
        }
        let (mut y, mut v) = (self.equilibrium_depth_m(&first), 0.0);
        let count = (duration_s / every_s).ceil().clamp(1.0, 1e6) as usize;
        let mut kept = Vec::with_capacity(count + 1);
        kept.push(self.read(0.0, first, y, v));
        for i in 0..count {
            let t = every_s * i as f64;
            let quickest = self
                .natural_rad_per_s(&position(t))
                .max(self.natural_rad_per_s(&position(t + every_s)));
            let parts = (every_s * quickest * 40.0 / std::f64::consts::TAU).ceil();
            if !inside(&position(t + every_s)) || !parts.is_finite() {
                return Err(RopewayError::NotFound("the cargo reaches a support"));
            }
            let step = every_s / parts.max(1.0);
            for part in 0..parts.max(1.0) as usize {
                (y, v) = self.step(&position, t + step * part as f64, step, (y, v));
            }
            kept.push(self.read(t + every_s, position(t + every_s), y, v));
        }
        Ok(kept)
    }

    fn step(
        &self,
        position: &impl Fn(f64) -> CargoPosition,
        t: f64,
        h: f64,
        (y, v): (f64, f64),
    ) -> (f64, f64) {
        let (now, half, end) = (position(t), position(t + 0.5 * h), position(t + h));
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
fn ship_distance_m(position: &CargoPosition) -> f64 {
    position.geometry.span_m - position.x_m
}

/// Lowest natural frequency in which the cargo moves on a taut string of this mass per length \[rad/s\]. `m w = (H/c) (cot(w L0/c) + cot(w (L - L0)/c))`, c² = H/mu.
///
/// # Errors
/// [`RopewayError::NotFound`] where no root is found.
pub fn taut_string_rad_per_s(
    swing: &CargoOscillator,
    position: &CargoPosition,
    mass_kg_per_m: f64,
) -> Result<f64, RopewayError> {
    let c = (swing.horizontal_n / mass_kg_per_m).sqrt();
    let (a, b) = (position.x_m / c, ship_distance_m(position) / c);
    // Below the first pole of either cotangent the sum falls and the mass term grows.
    let pole = std::f64::consts::PI / a.max(b);
    let off = |w: f64| {
        let restoring = swing.horizontal_n / c * (1.0 / (w * a).tan() + 1.0 / (w * b).tan());
        Ok(restoring - swing.mass_kg * w)
    };
    roots::root(
        (1e-9 * pole, pole * (1.0 - 1e-12)),
        "the string has no frequency",
        off,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const SWING: CargoOscillator = CargoOscillator {
        mass_kg: 50.0,
        cargo_n: 490.0,
        horizontal_n: 3600.0,
        damping_ratio: 0.05,
    };

    fn position(x_m: f64) -> CargoPosition {
        let geometry = SpanGeometry {
            span_m: 80.0,
            rise_m: 2.0,
        };
        CargoPosition { geometry, x_m }
    }

    #[test]
    fn let_go_it_swings_as_the_closed_form_says() {
        let at = position(30.0);
        let (y, v) = SWING.free_decay(&at, 0.0, 0.0);
        assert!(y.abs() < 1e-12 && v.abs() < 1e-12);
        let (h, t) = (1e-4, 1.3);
        let (y, v) = SWING.free_decay(&at, 0.0, t);
        let speed =
            (SWING.free_decay(&at, 0.0, t + h).0 - SWING.free_decay(&at, 0.0, t - h).0) / (2.0 * h);
        assert!((speed - v).abs() < 1e-6);
        let rate =
            (SWING.free_decay(&at, 0.0, t + h).1 - SWING.free_decay(&at, 0.0, t - h).1) / (2.0 * h);
        assert!((rate - SWING.acceleration(&at, y, v)).abs() < 1e-6);
    }

    #[test]
    fn the_march_is_of_order_four_and_meets_the_closed_form() {
        let still = |_| position(30.0);
        let moving = |t: f64| position(30.0 + 0.0 * t);
        let rest = SWING.simulate(moving, 5.0, 0.1).unwrap();
        let settled = SWING.equilibrium_depth_m(&position(30.0));
        assert!(rest.iter().all(|s| (s.depth_m - settled).abs() < 1e-9));
        let run = |steps: usize| {
            let h = 4.0 / steps as f64;
            let mut state = (0.0, 0.0);
            for i in 0..steps {
                state = SWING.step(&still, h * i as f64, h, state);
            }
            (state.0 - SWING.free_decay(&position(30.0), 0.0, 4.0).0).abs()
        };
        let order = (run(40) / run(80)).log2();
        assert!((order - 4.0).abs() < 0.2, "{order}");
    }

    #[test]
    fn a_string_without_mass_swings_as_one_degree_and_without_cargo_as_a_string() {
        let at = position(40.0);
        let light = taut_string_rad_per_s(&SWING, &at, 1e-7).unwrap();
        assert!((light / SWING.natural_rad_per_s(&at) - 1.0).abs() < 1e-4);
        let bare = CargoOscillator {
            mass_kg: 1e-9,
            ..SWING
        };
        let string = taut_string_rad_per_s(&bare, &at, 2.2).unwrap();
        let known = std::f64::consts::PI / 80.0 * (3600.0_f64 / 2.2).sqrt();
        assert!((string / known - 1.0).abs() < 1e-8);
    }

    #[test]
    fn at_a_support_the_equation_ends() {
        assert!(SWING.simulate(|t| position(5.0 - t), 10.0, 0.5).is_err());
        assert!(SWING.simulate(|_| position(0.0), 10.0, 0.5).is_err());
    }
}
