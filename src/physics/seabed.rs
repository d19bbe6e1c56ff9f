//! The sea bed: a flat bed that pushes back on nodes below it, like a bed of springs, with damping across.
//!
//! Normal force `N = k (z_b - z) - c v_z`, never pulling (Zhu, Yin and Shen 2017, Journal of Harbin
//! Engineering University, eq. 8 as rebuilt from its symbols, without its friction of eq. 9): k is the bed's
//! stiffness per area times the diameter and length of line that the node stands for.

/// The bed under the whole line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seabed {
    /// Height of the bed above still water \[m\], negative.
    pub z: f64,
    /// Stiffness per area \[N/m³\].
    pub stiffness: f64,
    /// Damping per area \[N s/m³\].
    pub damping: f64,
}

/// Push of the bed on a node, upwards, and its derivatives.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Push {
    /// Force \[N\].
    pub force: f64,
    /// Derivative by z \[N/m\].
    pub by_z: f64,
    /// Derivative by the speed upwards \[N s/m\].
    pub by_speed: f64,
}

impl Seabed {
    /// Push on a node at height z \[m\] that rises at a speed \[m/s\], on an area \[m²\]. As with the tension of a
    /// segment, damping is held between plus and minus the elastic part, so that the force begins at zero.
    #[inline]
    #[must_use]
    pub fn push(&self, z: f64, speed: f64, area: f64) -> Push {
        let depth = self.z - z;
        if depth <= 0.0 {
            return Push::default();
        }
        let (k, c) = (self.stiffness * area, self.damping * area);
        let (elastic, viscous) = (k * depth, -c * speed);
        if viscous > elastic {
            Push {
                force: 2.0 * elastic,
                by_z: -2.0 * k,
                by_speed: 0.0,
            }
        } else if viscous < -elastic {
            Push::default()
        } else {
            Push {
                force: elastic + viscous,
                by_z: -k,
                by_speed: -c,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pushes_up_below_and_not_above_and_never_pulls() {
        let bed = Seabed {
            z: -10.0,
            stiffness: 100.0,
            damping: 10.0,
        };
        assert_eq!(bed.push(-9.0, 0.0, 2.0), Push::default());
        assert!((bed.push(-10.5, 0.0, 2.0).force - 100.0).abs() < 1e-12);
        assert!(bed.push(-10.5, 100.0, 2.0).force >= 0.0);
        assert!((bed.push(-10.5, -100.0, 2.0).force - 200.0).abs() < 1e-12);
    }
}
