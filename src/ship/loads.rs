//! Wind, current and mean drift on a ship: forces along and across it and the moment in yaw, eq. (1) of the paper of the
//! Military Transportation Institute and Tianjin University on a ropeway between ship and platform (about 2016).
//!
//! Axes of the ship: x forward, y to port, yaw bow to port. Each load is a pressure on an area times a coefficient,
//! which depends on the angle from where the bow points to where the flow goes (0: from astern, 180 degrees: from ahead):
//!
//! | | pressure | surge | sway | yaw |
//! |---|---|---|---|---|
//! | wind | ½ ρ V² | frontal area | lateral area | lateral area, length |
//! | current | ½ ρ V² | length, draught | length, draught | length², draught |
//! | drift | ρ g Hs²/16 | length | length | length² |
//!
//! Hs²/16 is the variance of the sea surface, so a drift coefficient is the one of regular waves, `F / (½ ρ g a² L)`,
//! averaged over the spectrum.

use std::f64::consts::TAU;

use super::model::{Coefficients, Interpolation, Particulars, Ship};
use super::periodic_curve::{Between, Parity, PeriodicCurve};

/// One load: how much, where to, and its curves.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvironmentalLoad {
    /// What it is.
    pub name: &'static str,
    /// Where the flow goes, from +x towards +y \[rad\].
    pub towards: f64,
    /// What the coefficients are multiplied by: force forward \[N\], to port \[N\], moment \[N m\].
    pub scale: [f64; 3],
    /// Coefficients forward, to port, in yaw against the angle from the bow to the flow.
    pub curves: [PeriodicCurve; 3],
    /// Speed of the flow, where the load goes with its square and so with the ship's own velocity \[m/s\].
    pub speed: Option<f64>,
}

/// Loads on a moving ship, in axes along a heading that does not turn with it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LoadLinearisation {
    /// Force forward \[N\], to port \[N\], moment in yaw \[N m\].
    pub load: PlanarLoad,
    /// Their derivatives by the turn from that heading.
    pub by_turn: PlanarLoad,
    /// Their derivatives by the ship's velocity along and across that heading.
    pub by_velocity: [PlanarLoad; 2],
}

/// Force forward \[N\], force to port \[N\], moment in yaw about the ship's centre \[N m\].
pub type PlanarLoad = [f64; 3];

impl EnvironmentalLoad {
    /// The load at a heading \[rad\], and its derivative by the heading.
    #[must_use]
    pub fn at(&self, heading: f64) -> (PlanarLoad, PlanarLoad) {
        let angle = self.towards - heading;
        let each = self.coefficients(angle);
        (
            std::array::from_fn(|i| self.scale[i] * each[i].0),
            std::array::from_fn(|i| -self.scale[i] * each[i].1),
        )
    }
}

impl EnvironmentalLoad {
    /// The load on a ship turned by a small or great angle \[rad\] from a heading \[rad\], that moves with a velocity along and
    /// across that heading \[m/s\]: wind and current by the flow that the ship meets, drift as at rest.
    fn moving(&self, heading: f64, turn: f64, velocity: [f64; 2]) -> LoadLinearisation {
        let toward = self.towards - heading;
        let Some(speed) = self.speed.filter(|speed| *speed > 0.0) else {
            return self.turned(toward, 1.0, turn);
        };
        let flow = [
            speed * toward.cos() - velocity[0],
            speed * toward.sin() - velocity[1],
        ];
        let square = flow[0] * flow[0] + flow[1] * flow[1];
        let share = square / (speed * speed);
        let met = flow[1].atan2(flow[0]);
        let mut moving = self.turned(met, share, turn);
        // By the flow's size and by its direction, both over the square of the speed that the scale holds.
        let each = self.coefficients(met - turn);
        let by = |along: f64, across: f64| -> PlanarLoad {
            let body: PlanarLoad = std::array::from_fn(|i| {
                let (value, slope) = each[i];
                self.scale[i] / (speed * speed) * (-2.0 * along * value + across * slope)
            });
            rotated(&body, turn)
        };
        moving.by_velocity = [by(flow[0], flow[1]), by(flow[1], -flow[0])];
        moving
    }

    /// A share of the load by a flow that goes `toward` \[rad\], on a ship turned by `turn`, both from the same heading.
    fn turned(&self, toward: f64, share: f64, turn: f64) -> LoadLinearisation {
        let each = self.coefficients(toward - turn);
        let body: PlanarLoad = std::array::from_fn(|i| share * self.scale[i] * each[i].0);
        // The force turns with the ship, and the angle of the flow falls as the ship turns.
        let slope: PlanarLoad = std::array::from_fn(|i| -share * self.scale[i] * each[i].1);
        let by_turn = [slope[0] - body[1], slope[1] + body[0], slope[2]];
        LoadLinearisation {
            load: rotated(&body, turn),
            by_turn: rotated(&by_turn, turn),
            by_velocity: [[0.0; 3]; 2],
        }
    }

    fn coefficients(&self, angle: f64) -> [(f64, f64); 3] {
        std::array::from_fn(|i| self.curves[i].at(angle))
    }
}

fn rotated(load: &PlanarLoad, turn: f64) -> PlanarLoad {
    let (sin, cos) = turn.sin_cos();
    [
        load[0] * cos - load[1] * sin,
        load[0] * sin + load[1] * cos,
        load[2],
    ]
}

/// All loads on a ship.
#[derive(Debug, Clone, PartialEq)]
pub struct EnvironmentalLoads {
    /// Those that the file names.
    pub each: Vec<EnvironmentalLoad>,
    /// From the ship's centre forward to the mooring point \[m\].
    pub arm: f64,
}

impl EnvironmentalLoads {
    /// The loads of a ship. The file is taken as checked.
    #[must_use]
    pub fn new(ship: &Ship) -> Self {
        let particulars = &ship.particulars;
        let (l, t) = (particulars.length_m, particulars.draft_m);
        let mut each = Vec::new();
        if let Some(wind) = &ship.wind {
            let q = 0.5 * particulars.air_density_kg_per_m3 * wind.speed_m_per_s.powi(2);
            let side = q * wind.lateral_area_m2;
            let scale = [q * wind.frontal_area_m2, side, side * l];
            let load = load("wind", wind.towards_deg, scale, &wind.coefficients);
            each.push(load.by_flow(wind.speed_m_per_s));
        }
        if let Some(current) = &ship.current {
            let q = 0.5 * particulars.water_density_kg_per_m3 * current.speed_m_per_s.powi(2);
            let scale = [q * l * t, q * l * t, q * l * l * t];
            let settings = &current.coefficients;
            let load = load("current", current.towards_deg, scale, settings);
            each.push(load.by_flow(current.speed_m_per_s));
        }
        if let Some(drift) = &ship.drift {
            let q = weight_density(particulars) * drift.significant_height_m.powi(2) / 16.0;
            let scale = [q * l, q * l, q * l * l];
            each.push(load("drift", drift.towards_deg, scale, &drift.coefficients));
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

    /// Eq. (1) on a moving ship, in axes along a heading \[rad\] that does not turn with it: turned from there by `turn`
    /// \[rad\], with a velocity along and across that heading \[m/s\]. What turning alone makes of the flow is left out.
    #[must_use]
    pub fn moving(&self, heading: f64, turn: f64, velocity: [f64; 2]) -> LoadLinearisation {
        let mut sum = LoadLinearisation::default();
        for load in &self.each {
            let one = load.moving(heading, turn, velocity);
            for i in 0..3 {
                sum.load[i] += one.load[i];
                sum.by_turn[i] += one.by_turn[i];
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

    /// A bound of the size of the moment about the mooring point \[N m\].
    #[must_use]
    pub fn moment_bound(&self) -> f64 {
        let of = |load: &EnvironmentalLoad| {
            let side = load.scale[1] * load.curves[1].size() * self.arm;
            side.abs() + load.scale[2] * load.curves[2].size()
        };
        self.each.iter().map(of).sum()
    }

    /// A bound of the second derivative of the moment about the mooring point, on the smooth piece that holds a heading.
    #[must_use]
    pub fn second_derivative_bound(&self, heading: f64) -> f64 {
        let of = |load: &EnvironmentalLoad| {
            let angle = load.towards - heading;
            let side =
                load.scale[1] * self.arm.abs() * load.curves[1].second_derivative_bound(angle);
            side + load.scale[2] * load.curves[2].second_derivative_bound(angle)
        };
        self.each.iter().map(of).sum()
    }

    /// Headings between which the moment is smooth, rising from -π to π \[rad\].
    #[must_use]
    pub fn cuts(&self) -> Vec<f64> {
        use std::f64::consts::PI;
        // Some more, so that bounds that hold over a piece are not too wide.
        let mut cuts: Vec<f64> = (0..=16).map(|i| -PI + TAU * f64::from(i) / 16.0).collect();
        for load in &self.each {
            for curve in &load.curves[1..] {
                let kinks = curve.knots().iter();
                cuts.extend(kinks.map(|k| (load.towards - k + PI).rem_euclid(TAU) - PI));
            }
        }
        cuts.sort_by(f64::total_cmp);
        // Two cuts that rounding alone tells apart are one.
        cuts.dedup_by(|next, kept| *next - *kept < 1e-12);
        cuts
    }
}

fn weight_density(particulars: &Particulars) -> f64 {
    particulars.water_density_kg_per_m3 * particulars.gravity_m_per_s2
}

fn load(
    name: &'static str,
    towards_deg: f64,
    scale: PlanarLoad,
    settings: &Coefficients,
) -> EnvironmentalLoad {
    EnvironmentalLoad {
        name,
        towards: towards_deg.to_radians(),
        scale,
        curves: curves(settings),
        speed: None,
    }
}

impl EnvironmentalLoad {
    /// The same, going with the square of the speed of a flow.
    fn by_flow(self, speed: f64) -> Self {
        Self {
            speed: Some(speed),
            ..self
        }
    }
}

/// The curves of the coefficients, from their table or from their series.
fn curves(settings: &Coefficients) -> [PeriodicCurve; 3] {
    if settings.angle_deg.is_empty() {
        let sines = |list: &[f64]| PeriodicCurve::Fourier {
            cos: Vec::new(),
            sin: std::iter::once(0.0).chain(list.iter().copied()).collect(),
        };
        let forward = PeriodicCurve::Fourier {
            cos: settings.surge_cosines.clone(),
            sin: Vec::new(),
        };
        return [
            forward,
            sines(&settings.sway_sines),
            sines(&settings.yaw_sines),
        ];
    }
    let angles: Vec<f64> = settings.angle_deg.iter().map(|a| a.to_radians()).collect();
    let between = match settings.interpolation {
        Interpolation::Linear => Between::Linear,
        Interpolation::Cubic => Between::Cubic,
    };
    let through = |values: &[f64], parity| PeriodicCurve::through(&angles, values, parity, between);
    [
        through(&settings.surge, Parity::Even),
        through(&settings.sway, Parity::Odd),
        through(&settings.yaw, Parity::Odd),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every load of the ship that comes with the program.
    fn loads() -> EnvironmentalLoads {
        let text = include_str!("../../cases/ship/anchored.toml");
        crate::ship::parse(text, "ship.toml").unwrap().loads
    }

    #[test]
    fn at_rest_it_is_the_load_of_the_heading() {
        let loads = loads();
        for heading in [-2.0, 0.3, 1.4] {
            let (statics, _) = loads.total(heading);
            let moving = loads.moving(heading, 0.0, [0.0; 2]);
            // Turned to the heading from another one it is the same load in other axes.
            let turned = loads.moving(heading - 0.7, 0.7, [0.0; 2]);
            let back = rotated(&turned.load, -0.7);
            for i in 0..3 {
                assert!((moving.load[i] - statics[i]).abs() < 1e-9 * (1.0 + statics[i].abs()));
                assert!((back[i] - statics[i]).abs() < 1e-9 * (1.0 + statics[i].abs()));
            }
        }
    }

    #[test]
    fn derivatives_on_a_moving_ship_are_the_differences() {
        let loads = loads();
        let h = 1e-6;
        for (heading, turn, v) in [
            (0.5, 0.0, [0.0; 2]),
            (-1.0, 0.4, [0.3, -0.8]),
            (2.0, -0.2, [-1.0, 0.1]),
        ] {
            let at = loads.moving(heading, turn, v);
            let load =
                |t: f64, a: f64, b: f64| loads.moving(heading, turn + t, [v[0] + a, v[1] + b]).load;
            let slope =
                |plus: PlanarLoad, minus: PlanarLoad, i: usize| (plus[i] - minus[i]) / (2.0 * h);
            for i in 0..3 {
                let scale = 1.0 + at.by_turn[i].abs() + at.load[i].abs();
                let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * scale;
                assert!(near(
                    at.by_turn[i],
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
