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

use super::curve::{Between, Curve, Parity};
use super::model::{About, Coefficients, Interpolation, Ship};

/// One load: how much, where to, and its curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What it is.
    pub name: &'static str,
    /// Where the flow goes, from +x towards +y \[rad\].
    pub towards: f64,
    /// What the coefficients are multiplied by: force forward \[N\], to port \[N\], moment \[N m\].
    pub scale: [f64; 3],
    /// Coefficients forward, to port, in yaw against the angle from the bow to the flow.
    pub curves: [Curve; 3],
}

/// Force forward \[N\], force to port \[N\], moment in yaw about the ship's centre \[N m\].
pub type Planar = [f64; 3];

impl Load {
    /// The load at a heading \[rad\], and its derivative by the heading.
    #[must_use]
    pub fn at(&self, heading: f64) -> (Planar, Planar) {
        let angle = self.towards - heading;
        let each: [(f64, f64); 3] = std::array::from_fn(|i| self.curves[i].at(angle));
        (
            std::array::from_fn(|i| self.scale[i] * each[i].0),
            std::array::from_fn(|i| -self.scale[i] * each[i].1),
        )
    }
}

/// All loads on a ship.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    /// Those that the file names.
    pub each: Vec<Load>,
    /// From the ship's centre forward to the mooring point \[m\].
    pub arm: f64,
}

impl Loads {
    /// The loads of a ship. The file is taken as checked.
    #[must_use]
    pub fn new(ship: &Ship) -> Self {
        let about = &ship.about;
        let (l, t) = (about.length_m, about.draft_m);
        let mut each = Vec::new();
        if let Some(wind) = &ship.wind {
            let q = 0.5 * about.air_density_kg_per_m3 * wind.speed_m_per_s.powi(2);
            let side = q * wind.lateral_area_m2;
            let scale = [q * wind.frontal_area_m2, side, side * l];
            each.push(load("wind", wind.towards_deg, scale, &wind.coefficients));
        }
        if let Some(current) = &ship.current {
            let q = 0.5 * about.water_density_kg_per_m3 * current.speed_m_per_s.powi(2);
            let scale = [q * l * t, q * l * t, q * l * l * t];
            let words = &current.coefficients;
            each.push(load("current", current.towards_deg, scale, words));
        }
        if let Some(drift) = &ship.drift {
            let q = weight_density(about) * drift.significant_height_m.powi(2) / 16.0;
            let scale = [q * l, q * l, q * l * l];
            each.push(load("drift", drift.towards_deg, scale, &drift.coefficients));
        }
        Self {
            each,
            arm: about.arm(),
        }
    }

    /// Eq. (1): the sum of all loads at a heading \[rad\], and its derivative.
    #[must_use]
    pub fn total(&self, heading: f64) -> (Planar, Planar) {
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
    pub fn moment_at_most(&self) -> f64 {
        let of = |load: &Load| {
            let side = load.scale[1] * load.curves[1].size() * self.arm;
            side.abs() + load.scale[2] * load.curves[2].size()
        };
        self.each.iter().map(of).sum()
    }

    /// A bound of the second derivative of the moment about the mooring point, on the smooth piece that holds a heading.
    #[must_use]
    pub fn bend_at_most(&self, heading: f64) -> f64 {
        let of = |load: &Load| {
            let angle = load.towards - heading;
            let side = load.scale[1] * self.arm.abs() * load.curves[1].bend_at_most(angle);
            side + load.scale[2] * load.curves[2].bend_at_most(angle)
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

fn weight_density(about: &About) -> f64 {
    about.water_density_kg_per_m3 * about.gravity_m_per_s2
}

fn load(name: &'static str, towards_deg: f64, scale: Planar, words: &Coefficients) -> Load {
    Load {
        name,
        towards: towards_deg.to_radians(),
        scale,
        curves: curves(words),
    }
}

/// The curves of the coefficients, from their table or from their series.
fn curves(words: &Coefficients) -> [Curve; 3] {
    if words.angle_deg.is_empty() {
        let sines = |list: &[f64]| Curve::Fourier {
            cos: Vec::new(),
            sin: std::iter::once(0.0).chain(list.iter().copied()).collect(),
        };
        let forward = Curve::Fourier {
            cos: words.surge_cosines.clone(),
            sin: Vec::new(),
        };
        return [forward, sines(&words.sway_sines), sines(&words.yaw_sines)];
    }
    let angles: Vec<f64> = words.angle_deg.iter().map(|a| a.to_radians()).collect();
    let between = match words.interpolation {
        Interpolation::Linear => Between::Linear,
        Interpolation::Cubic => Between::Cubic,
    };
    let through = |values: &[f64], parity| Curve::through(&angles, values, parity, between);
    [
        through(&words.surge, Parity::Even),
        through(&words.sway, Parity::Odd),
        through(&words.yaw, Parity::Odd),
    ]
}
