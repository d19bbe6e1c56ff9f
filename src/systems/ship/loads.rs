//! Wind, current and mean (second-order) wave drift loads on a ship: surge force, sway force and yaw moment, eq. (1) of the
//! paper of the Military Transportation Institute and Tianjin University on a ropeway between ship and platform (about
//! 2016).
//!
//! Ship axes: x forward, y to port, yaw bow to port. Each load is a pressure times an area times a coefficient, a function of
//! the angle of attack, from the bow to the direction that the flow goes to (0: from astern, 180 degrees: from ahead):
//!
//! | | pressure | surge | sway | yaw |
//! |---|---|---|---|---|
//! | wind | ½ ρ V² | frontal area | lateral area | lateral area, length |
//! | current | ½ ρ V² | length, draught | length, draught | length², draught |
//! | drift | ρ g Hs²/16 | length | length | length² |
//!
//! Hs²/16 is the variance of the surface elevation, so a drift coefficient is that of regular waves, `F / (½ ρ g a² L)`,
//! averaged over the spectrum.

use std::f64::consts::TAU;

use super::model::{LoadCoefficients, Particulars, Ship};
use super::periodic_curve::{Parity, PeriodicCurve};

/// One load: direction, magnitude and coefficient curves.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvironmentalLoad {
    /// `wind`, `current` or `drift`.
    pub name: &'static str,
    /// Direction that the flow goes to, from +x towards +y \[rad\].
    pub towards: f64,
    /// Reference loads that the coefficients multiply: surge \[N\], sway \[N\], yaw \[N m\].
    pub reference: [f64; 3],
    /// Coefficients of surge, sway and yaw against the angle of attack \[rad\].
    pub curves: [PeriodicCurve; 3],
    /// Speed of the flow, for loads that depend on the velocity of the flow relative to the ship \[m/s\].
    pub speed: Option<f64>,
}

/// Load on a moving ship and its derivatives, in axes fixed along a reference heading.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LoadLinearisation {
    /// Surge force \[N\], sway force \[N\], yaw moment \[N m\].
    pub load: PlanarLoad,
    /// Derivatives by the yaw angle from that heading \[1/rad\].
    pub by_yaw: PlanarLoad,
    /// Derivatives by the ship's velocity along and across that heading \[s/m\].
    pub by_velocity: [PlanarLoad; 2],
}

/// Surge force \[N\], sway force \[N\], yaw moment about the ship's centre \[N m\].
pub type PlanarLoad = [f64; 3];

impl EnvironmentalLoad {
    /// The load at a heading \[rad\], and its derivative by the heading.
    #[must_use]
    pub fn at(&self, heading: f64) -> (PlanarLoad, PlanarLoad) {
        let angle = self.towards - heading;
        let each = self.coefficients(angle);
        (
            std::array::from_fn(|i| self.reference[i] * each[i].0),
            std::array::from_fn(|i| -self.reference[i] * each[i].1),
        )
    }

    /// The load of the flow towards an angle from the bow \[rad\].
    #[must_use]
    pub fn from_heading(&self, angle: f64) -> PlanarLoad {
        let each = self.coefficients(angle);
        std::array::from_fn(|i| self.reference[i] * each[i].0)
    }

    /// The load on a ship at a yaw angle \[rad\] of any size from a heading \[rad\], with a velocity along and across that
    /// heading \[m/s\]: wind and current by the relative velocity of the flow, drift as on a ship at rest.
    fn linearised(&self, heading: f64, yaw: f64, velocity: [f64; 2]) -> LoadLinearisation {
        let direction = self.towards - heading;
        let Some(speed) = self.speed.filter(|speed| *speed > 0.0) else {
            return self.at_yaw(direction, 1.0, yaw);
        };
        let flow = [
            speed * direction.cos() - velocity[0],
            speed * direction.sin() - velocity[1],
        ];
        let square = flow[0] * flow[0] + flow[1] * flow[1];
        let ratio = square / (speed * speed);
        let relative = flow[1].atan2(flow[0]);
        let mut linearised = self.at_yaw(relative, ratio, yaw);
        // Derivatives by the magnitude and by the direction of the relative flow, over the V² in the reference load.
        let each = self.coefficients(relative - yaw);
        let by = |along: f64, across: f64| -> PlanarLoad {
            let body: PlanarLoad = std::array::from_fn(|i| {
                let (value, slope) = each[i];
                self.reference[i] / (speed * speed) * (-2.0 * along * value + across * slope)
            });
            rotated(&body, yaw)
        };
        linearised.by_velocity = [by(flow[0], flow[1]), by(flow[1], -flow[0])];
        linearised
    }

    /// `ratio` times the load of a flow in a direction \[rad\] on a ship at a yaw angle \[rad\], both from the same heading.
    fn at_yaw(&self, direction: f64, ratio: f64, yaw: f64) -> LoadLinearisation {
        let each = self.coefficients(direction - yaw);
        let body: PlanarLoad = std::array::from_fn(|i| ratio * self.reference[i] * each[i].0);
        // The force rotates with the ship, and the angle of attack falls as the ship yaws.
        let slope: PlanarLoad = std::array::from_fn(|i| -ratio * self.reference[i] * each[i].1);
        let by_yaw = [slope[0] - body[1], slope[1] + body[0], slope[2]];
        LoadLinearisation {
            load: rotated(&body, yaw),
            by_yaw: rotated(&by_yaw, yaw),
            by_velocity: [[0.0; 3]; 2],
        }
    }

    fn coefficients(&self, angle: f64) -> [(f64, f64); 3] {
        std::array::from_fn(|i| self.curves[i].at(angle))
    }
}

fn rotated(load: &PlanarLoad, yaw: f64) -> PlanarLoad {
    let (sin, cos) = yaw.sin_cos();
    [
        load[0] * cos - load[1] * sin,
        load[0] * sin + load[1] * cos,
        load[2],
    ]
}

/// All environmental loads on a ship.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvironmentalLoads {
    /// Those given in the file.
    pub each: Vec<EnvironmentalLoad>,
    /// From the ship's centre forward to the mooring point \[m\].
    pub arm: f64,
}

impl EnvironmentalLoads {
    /// The loads of a ship that has passed validation.
    #[must_use]
    pub fn new(ship: &Ship) -> Self {
        let particulars = &ship.ship;
        let (l, t) = (particulars.length_m, particulars.draft_m);
        let mut each = Vec::new();
        if let Some(wind) = &ship.wind {
            let q = 0.5 * particulars.air_density_kg_per_m3 * wind.speed_m_per_s.powi(2);
            let side = q * wind.lateral_area_m2;
            let reference = [q * wind.frontal_area_m2, side, side * l];
            let load = load("wind", wind.towards_deg, reference, &wind.coefficients());
            each.push(load.with_speed(wind.speed_m_per_s));
        }
        if let Some(current) = &ship.current {
            let q = 0.5 * particulars.water_density_kg_per_m3 * current.speed_m_per_s.powi(2);
            let reference = [q * l * t, q * l * t, q * l * l * t];
            let load = load(
                "current",
                current.towards_deg,
                reference,
                &current.coefficients(),
            );
            each.push(load.with_speed(current.speed_m_per_s));
        }
        if let Some(drift) = &ship.drift {
            let q = weight_density(particulars) * drift.significant_height_m.powi(2) / 16.0;
            let reference = [q * l, q * l, q * l * l];
            each.push(load(
                "drift",
                drift.towards_deg,
                reference,
                &drift.coefficients(),
            ));
        }
        Self {
            each,
            arm: particulars.arm(),
        }
    }

    /// Eq. (1): the sum of all loads at a heading \[rad\], and its derivative.
    #[must_use]
    pub fn total(&self, heading: f64) -> (PlanarLoad, PlanarLoad) {
        let mut sum = ([0.0; 3], [0.0; 3]);
        for load in &self.each {
            let (value, slope) = load.at(heading);
            for i in 0..3 {
                sum.0[i] += value[i];
                sum.1[i] += slope[i];
            }
        }
        sum
    }

    /// Eq. (1) on a moving ship, in axes fixed along a heading \[rad\]: at a yaw angle \[rad\] from it, with a velocity along
    /// and across it \[m/s\]. The effect of the yaw rate on the flow is neglected.
    #[must_use]
    pub fn linearised(&self, heading: f64, yaw: f64, velocity: [f64; 2]) -> LoadLinearisation {
        let mut sum = LoadLinearisation::default();
        for load in &self.each {
            let one = load.linearised(heading, yaw, velocity);
            for i in 0..3 {
                sum.load[i] += one.load[i];
                sum.by_yaw[i] += one.by_yaw[i];
                sum.by_velocity[0][i] += one.by_velocity[0][i];
                sum.by_velocity[1][i] += one.by_velocity[1][i];
            }
        }
        sum
    }

    /// Eq. (2): the moment about the mooring point, `M - F_Y ARM` \[N m\], and its derivative by the heading.
    #[must_use]
    pub fn moment(&self, heading: f64) -> (f64, f64) {
        let (value, slope) = self.total(heading);
        (
            value[2] - value[1] * self.arm,
            slope[2] - slope[1] * self.arm,
        )
    }

    /// Upper bound of the magnitude of the moment about the mooring point \[N m\].
    #[must_use]
    pub fn moment_bound(&self) -> f64 {
        let of = |load: &EnvironmentalLoad| {
            let side = load.reference[1] * load.curves[1].bound() * self.arm;
            side.abs() + load.reference[2] * load.curves[2].bound()
        };
        self.each.iter().map(of).sum()
    }

    /// Upper bound of the second derivative of the moment about the mooring point, on the smooth interval around a heading.
    #[must_use]
    pub fn second_derivative_bound(&self, heading: f64) -> f64 {
        let of = |load: &EnvironmentalLoad| {
            let angle = load.towards - heading;
            let side =
                load.reference[1] * self.arm.abs() * load.curves[1].second_derivative_bound(angle);
            side + load.reference[2] * load.curves[2].second_derivative_bound(angle)
        };
        self.each.iter().map(of).sum()
    }

    /// Headings between which the moment is smooth, ascending from -π to π \[rad\].
    #[must_use]
    pub fn breakpoints(&self) -> Vec<f64> {
        use std::f64::consts::PI;
        // Some more, to tighten the bounds of each interval.
        let mut breakpoints: Vec<f64> = (0..=16).map(|i| -PI + TAU * f64::from(i) / 16.0).collect();
        for load in &self.each {
            for curve in &load.curves[1..] {
                let knots = curve.knots().iter();
                breakpoints.extend(knots.map(|k| (load.towards - k + PI).rem_euclid(TAU) - PI));
            }
        }
        breakpoints.sort_by(f64::total_cmp);
        // Breakpoints that differ by rounding alone are one.
        breakpoints.dedup_by(|next, kept| *next - *kept < 1e-12);
        breakpoints
    }
}

fn weight_density(particulars: &Particulars) -> f64 {
    particulars.water_density_kg_per_m3 * particulars.gravity_m_per_s2
}

fn load(
    name: &'static str,
    towards_deg: f64,
    reference: PlanarLoad,
    coefficients: &LoadCoefficients<'_>,
) -> EnvironmentalLoad {
    EnvironmentalLoad {
        name,
        towards: towards_deg.to_radians(),
        reference,
        curves: curves(coefficients),
        speed: None,
    }
}

impl EnvironmentalLoad {
    /// The same, proportional to the square of the relative speed.
    fn with_speed(self, speed: f64) -> Self {
        Self {
            speed: Some(speed),
            ..self
        }
    }
}

/// Coefficient curves, from a table or from Fourier series.
fn curves(coefficients: &LoadCoefficients<'_>) -> [PeriodicCurve; 3] {
    if coefficients.angle_deg.is_empty() {
        let [surge, sway, yaw] = coefficients.series;
        let sines = |list: &[f64]| PeriodicCurve::Fourier {
            cos: Vec::new(),
            sin: std::iter::once(0.0).chain(list.iter().copied()).collect(),
        };
        let cosines = PeriodicCurve::Fourier {
            cos: surge.to_vec(),
            sin: Vec::new(),
        };
        return [cosines, sines(sway), sines(yaw)];
    }
    let angles: Vec<f64> = coefficients
        .angle_deg
        .iter()
        .map(|a| a.to_radians())
        .collect();
    let through = |values: &[f64], parity| {
        PeriodicCurve::through(&angles, values, parity, coefficients.interpolation)
    };
    let [surge, sway, yaw] = coefficients.table;
    [
        through(surge, Parity::Even),
        through(sway, Parity::Odd),
        through(yaw, Parity::Odd),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The loads of a shipped case.
    fn loads() -> EnvironmentalLoads {
        let text = include_str!("../../../cases/ship/anchored.toml");
        crate::case::kind::parse::<Ship>(text, "ship.toml")
            .unwrap()
            .loads
    }

    #[test]
    fn at_zero_velocity_it_is_the_load_at_rest() {
        let loads = loads();
        for heading in [-2.0, 0.3, 1.4] {
            let (static_load, _) = loads.total(heading);
            let moving = loads.linearised(heading, 0.0, [0.0; 2]);
            // Yawed to the heading from another one it is the same load in other axes.
            let yawed = loads.linearised(heading - 0.7, 0.7, [0.0; 2]);
            let back = rotated(&yawed.load, -0.7);
            for i in 0..3 {
                assert!(
                    (moving.load[i] - static_load[i]).abs() < 1e-9 * (1.0 + static_load[i].abs())
                );
                assert!((back[i] - static_load[i]).abs() < 1e-9 * (1.0 + static_load[i].abs()));
            }
        }
    }

    #[test]
    fn derivatives_on_a_moving_ship_are_the_differences() {
        let loads = loads();
        let h = 1e-6;
        for (heading, yaw, v) in [
            (0.5, 0.0, [0.0; 2]),
            (-1.0, 0.4, [0.3, -0.8]),
            (2.0, -0.2, [-1.0, 0.1]),
        ] {
            let at = loads.linearised(heading, yaw, v);
            let load = |t: f64, a: f64, b: f64| {
                loads
                    .linearised(heading, yaw + t, [v[0] + a, v[1] + b])
                    .load
            };
            let slope =
                |plus: PlanarLoad, minus: PlanarLoad, i: usize| (plus[i] - minus[i]) / (2.0 * h);
            for i in 0..3 {
                let scale = 1.0 + at.by_yaw[i].abs() + at.load[i].abs();
                let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * scale;
                assert!(near(
                    at.by_yaw[i],
                    slope(load(h, 0.0, 0.0), load(-h, 0.0, 0.0), i)
                ));
                assert!(near(
                    at.by_velocity[0][i],
                    slope(load(0.0, h, 0.0), load(0.0, -h, 0.0), i)
                ));
                assert!(near(
                    at.by_velocity[1][i],
                    slope(load(0.0, 0.0, h), load(0.0, 0.0, -h), i)
                ));
            }
        }
    }
}
