//! The sea bed: a plane, level or sloping, that pushes back on nodes below it like a bed of springs, with damping across.
//!
//! Normal force `N = k (z_b - z) - c v_z`, never pulling (Zhu, Yin and Shen 2017, Journal of Harbin
//! Engineering University, eq. 8 as rebuilt from its symbols), depth and speed measured along the bed's normal where it
//! slopes: k is the bed's stiffness per area times the diameter and length of line that the node stands for. Along
//! the bed acts [`Friction`], where there is any.

use super::bed_friction::Friction;
use super::bed_reaction::BedReaction;
use crate::numerics::V3;

/// The bed under the whole line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticBed {
    /// Height of the bed above still water at x = y = 0 \[m\], negative below.
    pub z: f64,
    /// Unit normal, upwards; nothing where the bed is level.
    pub slope: Option<V3>,
    /// Stiffness per area \[N/m³\].
    pub stiffness: f64,
    /// Damping per area \[N s/m³\].
    pub damping: f64,
    /// What holds the line along the bed, if anything.
    pub friction: Option<Friction>,
}

impl ElasticBed {
    /// The normal of a bed that rises by `slope` \[rad\] towards an azimuth \[rad\] from +x towards +y; nothing where it
    /// does not rise.
    #[must_use]
    pub fn sloping(slope: f64, azimuth: f64) -> Option<V3> {
        let (sin, cos) = slope.sin_cos();
        (slope != 0.0).then(|| V3::new(-sin * azimuth.cos(), -sin * azimuth.sin(), cos))
    }

    /// Unit normal of the bed below a place.
    #[inline]
    #[must_use]
    pub fn normal(&self, _: &V3) -> V3 {
        self.slope.unwrap_or_else(V3::z)
    }

    /// Height of a place above the bed \[m\], along its normal; negative below.
    #[inline]
    #[must_use]
    pub fn height(&self, x: &V3) -> f64 {
        match &self.slope {
            None => x.z - self.z,
            Some(normal) => normal.dot(x) - normal.z * self.z,
        }
    }

    /// Whether only the height of a node matters: a level bed without friction.
    #[inline]
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.slope.is_none() && self.friction.is_none()
    }

    /// Reaction of the bed on a node at x \[m\] that moves at v \[m/s\], on an area \[m²\].
    #[inline]
    #[must_use]
    pub fn push(&self, x: &V3, v: &V3, area: f64) -> BedReaction {
        let speed = self.slope.map_or(v.z, |normal| normal.dot(v));
        self.push_at(-self.height(x), speed, area)
    }

    /// Reaction of the bed on a node at a depth below the bed \[m\] that leaves it at a speed \[m/s\]. As with the tension of a
    /// segment, damping is held between plus and minus the elastic part, so that the force begins at zero.
    #[inline]
    #[must_use]
    pub fn push_at(&self, depth: f64, speed: f64, area: f64) -> BedReaction {
        if depth <= 0.0 {
            return BedReaction::default();
        }
        let (k, c) = (self.stiffness * area, self.damping * area);
        let (elastic, viscous) = (k * depth, -c * speed);
        if viscous > elastic {
            BedReaction {
                force: 2.0 * elastic,
                by_height: -2.0 * k,
                by_speed: 0.0,
            }
        } else if viscous < -elastic {
            BedReaction::default()
        } else {
            BedReaction {
                force: elastic + viscous,
                by_height: -k,
                by_speed: -c,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BED: ElasticBed = ElasticBed {
        z: -10.0,
        slope: None,
        stiffness: 100.0,
        damping: 10.0,
        friction: None,
    };

    #[test]
    fn pushes_up_below_and_not_above_and_never_pulls() {
        let push = |z: f64, speed: f64| BED.push(&(V3::z() * z), &(V3::z() * speed), 2.0);
        assert_eq!(push(-9.0, 0.0), BedReaction::default());
        assert!((push(-10.5, 0.0).force - 100.0).abs() < 1e-12);
        assert!(push(-10.5, 100.0).force >= 0.0);
        assert!((push(-10.5, -100.0).force - 200.0).abs() < 1e-12);
    }

    #[test]
    fn a_slope_rises_towards_its_azimuth() {
        let (slope, azimuth) = (0.3_f64, 1.2_f64);
        let bed = ElasticBed {
            slope: ElasticBed::sloping(slope, azimuth),
            ..BED
        };
        let uphill = V3::new(azimuth.cos(), azimuth.sin(), slope.tan());
        assert!(bed.height(&(uphill * 7.0 - V3::z() * 10.0)).abs() < 1e-12);
        assert!((bed.height(&V3::zeros()) - 10.0 * slope.cos()).abs() < 1e-12);
        assert!((bed.normal(&uphill).norm() - 1.0).abs() < 1e-15);
    }
}
