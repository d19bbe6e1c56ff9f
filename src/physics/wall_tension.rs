//! Tension in the wall of a pipe from the effective tension of the line.
//!
//! C. P. Sparks, "The influence of tension, pressure and weight on pipe and riser deformations and stresses", J. Energy
//! Resources Technology 106 (1984) 46-54: `T_e = T_w - p_i A_i + p_o A_o`, so that
//!
//! ```text
//! T_w = T_e + p_i A_i - p_o A_o
//! ```
//!
//! Weight in water and effective tension obey the equations of a cable whatever the pressures; the wall bears what is left. At a
//! free end that is closed, `T_e = 0` and the wall bears the pressures on its cap.

use std::f64::consts::FRAC_PI_4;

/// What a pipe wall bears beside the effective tension. Pressures are gauge: over the atmosphere's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PipeWall {
    /// Outer diameter \[m\].
    pub outer_diameter: f64,
    /// Inner diameter \[m\].
    pub inner_diameter: f64,
    /// Weight of the water per volume, `rho g` \[N/m³\].
    pub water_weight: f64,
    /// Weight of the content per volume \[N/m³\].
    pub content_weight: f64,
    /// Inner pressure \[Pa\] at `pressure_height`.
    pub inner_pressure: f64,
    /// Height of that pressure above still water \[m\].
    pub pressure_height: f64,
}

impl PipeWall {
    /// Tension of the wall \[N\] at height z above still water \[m\] under an effective tension \[N\], both pressures
    /// hydrostatic; nothing presses from outside above still water.
    #[must_use]
    pub fn tension(&self, effective: f64, z: f64) -> f64 {
        let inner = self.inner_pressure + self.content_weight * (self.pressure_height - z);
        let outer = self.water_weight * (-z).max(0.0);
        effective + inner * disc(self.inner_diameter) - outer * disc(self.outer_diameter)
    }
}

/// Area of a disc of this diameter.
fn disc(diameter: f64) -> f64 {
    FRAC_PI_4 * diameter * diameter
}
