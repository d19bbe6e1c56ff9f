//! Settings of the environmental loads: wind, current and mean wave drift.

use crate::case::fields::of;
use crate::case::schema::{Key, TableNode, table, words};

/// What holds without a table of coefficients, and without Fourier series.
const TABLE: &str = "Fourier series are given instead";
const SERIES: &str = "a table is given instead";

/// Declares a load: its own keys, and the coefficients of all loads with their help.
macro_rules! load {
    (
        $(#[$meta:meta])*
        pub struct $name:ident => $keys:ident { $($own:tt)* }
        angles $angles:literal, surge $surge:literal, sway $sway:literal, yaw $yaw:literal
    ) => {
        table! {
            $(#[$meta])*
            pub struct $name => $keys {
                $($own)*
                #[doc = $angles]
                angle_deg: Vec<f64>, "angles", range of(0.0, 360.0), absent TABLE;
                #[doc = $surge]
                surge: Vec<f64>, "surge", range of(-100.0, 100.0), absent TABLE;
                #[doc = $sway]
                sway: Vec<f64>, "sway", range of(-100.0, 100.0), absent TABLE;
                #[doc = $yaw]
                yaw: Vec<f64>, "yaw", range of(-100.0, 100.0), absent TABLE;
                /// Interpolation of the table: linear, or by the periodic cubic spline.
                interpolation: Interpolation = Interpolation::Cubic, "interpolation";
                /// Amplitudes of cos(0), cos(a), cos(2a), ... of the surge coefficient.
                surge_cosines: Vec<f64>, "surge, cosines", range of(-100.0, 100.0), absent SERIES;
                /// Amplitudes of sin(a), sin(2a), ... of the sway coefficient.
                sway_sines: Vec<f64>, "sway, sines", range of(-100.0, 100.0), absent SERIES;
                /// Amplitudes of sin(a), sin(2a), ... of the yaw coefficient.
                yaw_sines: Vec<f64>, "yaw, sines", range of(-100.0, 100.0), absent SERIES;
            }
        }

        impl $name {
            /// The coefficients against the angle of attack.
            #[must_use]
            pub fn coefficients(&self) -> LoadCoefficients<'_> {
                LoadCoefficients {
                    angle_deg: &self.angle_deg,
                    table: [&self.surge, &self.sway, &self.yaw],
                    interpolation: self.interpolation,
                    series: [&self.surge_cosines, &self.sway_sines, &self.yaw_sines],
                }
            }
        }

        impl<'a> $keys<'a> {
            /// The coefficients as they are read.
            pub(crate) fn coefficients(&self) -> CoefficientKeys<'_, 'a> {
                CoefficientKeys {
                    place: &self.place,
                    angle_deg: &self.angle_deg,
                    table: [&self.surge, &self.sway, &self.yaw],
                    series: [&self.surge_cosines, &self.sway_sines, &self.yaw_sines],
                }
            }
        }
    };
}

load! {
    /// The wind, and the ship's coefficients in it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct WindLoad => WindKeys {
        /// Speed of the wind.
        speed_m_per_s: f64, "speed", range of(0.0, 150.0);
        /// Direction that the wind blows to, from +x towards +y.
        towards_deg: f64, "towards", range of(-360.0, 360.0);
        /// Projected frontal area above water.
        frontal_area_m2: f64, "frontal area", range of(0.0, 1e6);
        /// Projected lateral area above water.
        lateral_area_m2: f64, "lateral area", range of(0.0, 1e6);
    }
    angles "Angles of attack of the table, from the bow to the direction that the wind blows to, ascending from 0 to 180 or to below 360.",
    surge "Surge force coefficients, positive forward, on the frontal area.",
    sway "Sway force coefficients, positive to port, on the lateral area.",
    yaw "Yaw moment coefficients, positive bow to port, on the lateral area and the length."
}

load! {
    /// The current, and the ship's coefficients in it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CurrentLoad => CurrentKeys {
        /// Speed of the current over the draught.
        speed_m_per_s: f64, "speed", range of(0.0, 20.0);
        /// Direction that the current runs to, from +x towards +y.
        towards_deg: f64, "towards", range of(-360.0, 360.0);
    }
    angles "Angles of attack of the table, from the bow to the direction that the current runs to, ascending from 0 to 180 or to below 360.",
    surge "Surge force coefficients, positive forward, on length times draught.",
    sway "Sway force coefficients, positive to port, on length times draught.",
    yaw "Yaw moment coefficients, positive bow to port, on length squared times draught."
}

load! {
    /// Mean wave drift, and the ship's coefficients for it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct DriftLoad => DriftKeys {
        /// Significant wave height.
        significant_height_m: f64, "significant height", range of(0.0, 30.0);
        /// Direction that the waves run to, from +x towards +y.
        towards_deg: f64, "towards", range of(-360.0, 360.0);
    }
    angles "Angles of the table, from the bow to the direction that the waves run to, ascending from 0 to 180 or to below 360.",
    surge "Surge force coefficients, positive forward, on rho g L Hs²/16.",
    sway "Sway force coefficients, positive to port, on rho g L Hs²/16.",
    yaw "Yaw moment coefficients, positive bow to port, on rho g L² Hs²/16."
}

words! {
    /// Interpolation between the points of a table.
    #[derive(Default)]
    pub enum Interpolation {
        /// Linear.
        Linear = "linear",
        /// The cubic spline with periodic first and second derivative.
        #[default]
        Cubic = "cubic",
    }
}

/// Coefficients of a load in surge, sway and yaw against the angle of attack, from the bow to the direction of the flow: a table
/// or Fourier series.
#[derive(Debug, Clone, Copy)]
pub struct LoadCoefficients<'a> {
    /// Angles of the table, ascending from 0: up to 180, the other side by symmetry, or to less than 360 \[deg\].
    pub angle_deg: &'a [f64],
    /// Coefficients at the angles \[-\].
    pub table: [&'a [f64]; 3],
    /// Interpolation of the table.
    pub interpolation: Interpolation,
    /// Amplitudes of the surge cosines from cos(0), of the sway and yaw sines from sin(α) \[-\].
    pub series: [&'a [f64]; 3],
}

/// The same as they are read.
#[derive(Debug)]
pub(crate) struct CoefficientKeys<'k, 'a> {
    pub(crate) place: &'k TableNode<'a>,
    pub(crate) angle_deg: &'k Key<'a, Vec<f64>>,
    pub(crate) table: [&'k Key<'a, Vec<f64>>; 3],
    pub(crate) series: [&'k Key<'a, Vec<f64>>; 3],
}
