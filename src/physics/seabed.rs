//! The sea bed: a plane, level or sloping, that pushes back on nodes below it like a bed of springs, with damping across.
//!
//! Normal force `N = k (z_b - z) - c v_z`, never pulling (Zhu, Yin and Shen 2017, Journal of Harbin
//! Engineering University, eq. 8 as rebuilt from its symbols), depth and speed measured along the bed's normal where it
//! slopes: k is the bed's stiffness per area times the diameter and length of line that the node stands for. Along
//! the bed acts [`Friction`], where there is any.

use super::bed_friction::{CurvedContact, Friction};
use super::bed_reaction::BedReaction;
use crate::numerics::lanes::outer;
use std::sync::Arc;

use crate::numerics::{DepthGrid, M3, V3};

/// The bed under the whole line.
#[derive(Debug, Clone, PartialEq)]
pub struct ElasticBed {
    /// Height of the bed above still water at x = y = 0 \[m\], negative below.
    pub z: f64,
    /// Unit normal, upwards; nothing where the bed is level.
    pub slope: Option<V3>,
    /// Depths over places in the place of level and slope.
    pub grid: Option<Arc<DepthGrid>>,
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

    /// Height \[m\] at x = y = 0 and unit normal of a bed of a depth \[m\] at a place in plan \[m\] that rises by a slope towards an azimuth
    /// \[rad\]; nothing where it does not rise.
    #[must_use]
    pub fn plane(
        (depth, [x, y]): (f64, [f64; 2]),
        [slope, azimuth]: [f64; 2],
    ) -> Option<(f64, V3)> {
        let normal = Self::sloping(slope, azimuth)?;
        let rise = slope.tan() * (x * azimuth.cos() + y * azimuth.sin());
        Some((-depth - rise, normal))
    }

    /// Unit normal of the bed below a place.
    #[inline]
    #[must_use]
    pub fn normal(&self, x: &V3) -> V3 {
        match &self.grid {
            None => self.slope.unwrap_or_else(V3::z),
            Some(_) => self.gradient(x).normalize(),
        }
    }

    /// Whether it is a level plane.
    #[inline]
    #[must_use]
    pub const fn is_level(&self) -> bool {
        self.slope.is_none() && self.grid.is_none()
    }

    /// Height of a place above the bed \[m\], along the normal of a plane, vertical over a grid; negative below.
    #[inline]
    #[must_use]
    pub fn height(&self, x: &V3) -> f64 {
        match (&self.slope, &self.grid) {
            (_, Some(grid)) => x.z + grid.at(x.x, x.y).depth,
            (None, None) => x.z - self.z,
            (Some(normal), None) => normal.dot(x) - normal.z * self.z,
        }
    }

    /// Derivative of that height by the place, along which the bed pushes: the normal of a plane, longer over a grid that slopes. The
    /// push is then the gradient of the energy of the springs, so that a line that slides over a bump gets back what it gave.
    #[inline]
    #[must_use]
    pub fn gradient(&self, x: &V3) -> V3 {
        match &self.grid {
            None => self.slope.unwrap_or_else(V3::z),
            Some(grid) => {
                let [by_x, by_y] = grid.at(x.x, x.y).slope;
                V3::new(by_x, by_y, 1.0)
            }
        }
    }

    /// Second derivative of that height \[1/m\]; nothing on a plane.
    #[inline]
    #[must_use]
    pub fn curvature(&self, x: &V3) -> Option<M3> {
        let grid = self.grid.as_ref()?;
        let [xx, xy, yy] = grid.at(x.x, x.y).curvature;
        Some(M3::new(xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.0))
    }

    /// Derivative of the unit normal by the place \[1/m\], with the gradient g, the normal n and the curvature C: `(I - n n') C / |g|`;
    /// nothing on a plane.
    #[must_use]
    pub fn normal_slope(&self, x: &V3) -> Option<M3> {
        let curvature = self.curvature(x)?;
        let gradient = self.gradient(x);
        let (size, normal) = (gradient.norm(), gradient.normalize());
        Some((M3::identity() - outer(&normal, &normal)) * curvature / size)
    }

    /// What friction needs to know of a push by the bed over a grid: [`curved_contact`] here. Nothing on a plane.
    #[inline]
    #[must_use]
    pub fn curved(&self, x: &V3, v: &V3, push: &BedReaction) -> Option<CurvedContact> {
        let curvature = self.curvature(x)?;
        Some(curved_contact(&self.gradient(x), &curvature, v, push))
    }

    /// Whether it has depths over a grid, and no friction.
    #[must_use]
    pub fn is_smooth_grid(&self) -> bool {
        self.grid.is_some() && self.friction.is_none()
    }

    /// The direction in which a node is put back onto the bed, a metre higher for a metre of it.
    #[must_use]
    pub fn way_out(&self, x: &V3) -> V3 {
        match &self.grid {
            None => self.normal(x),
            Some(_) => V3::z(),
        }
    }

    /// Derivatives of a push on a node by its position \[N/m\] and velocity \[N s/m\]: [`push_slopes`] here.
    #[inline]
    #[must_use]
    pub fn slopes(&self, x: &V3, v: &V3, push: &BedReaction) -> [M3; 2] {
        push_slopes(&self.gradient(x), self.curvature(x).as_ref(), v, push)
    }

    /// The plane through the bed below two places, sloping along the line between them; the bed itself where it is a plane.
    #[must_use]
    pub fn plane_below(&self, from: &V3, to: &V3) -> Self {
        let Some(grid) = &self.grid else {
            return self.clone();
        };
        let [first, last] = [from, to].map(|place| -grid.at(place.x, place.y).depth);
        let along = V3::new(to.x - from.x, to.y - from.y, 0.0);
        let distance = along.norm();
        let rise = if distance > 0.0 { last - first } else { 0.0 };
        let azimuth = along.y.atan2(along.x);
        let by_metre = rise / distance.max(f64::MIN_POSITIVE);
        Self {
            z: first - by_metre * (from.x * azimuth.cos() + from.y * azimuth.sin()),
            slope: Self::sloping(by_metre.atan(), azimuth),
            grid: None,
            ..self.clone()
        }
    }

    /// Whether only the height of a node matters: a level bed without friction.
    #[inline]
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.slope.is_none() && self.grid.is_none() && self.friction.is_none()
    }

    /// Reaction of the bed on a node at x \[m\] that moves at v \[m/s\], on an area \[m²\].
    #[inline]
    #[must_use]
    pub fn push(&self, x: &V3, v: &V3, area: f64) -> BedReaction {
        let depth = -self.height(x);
        if depth <= 0.0 {
            return BedReaction::default();
        }
        let speed = match (&self.slope, &self.grid) {
            (None, None) => v.z,
            _ => self.gradient(x).dot(v),
        };
        self.push_at(depth, speed, area)
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

/// Derivatives of a push of the bed by the position \[N/m\] and the velocity \[N s/m\] of what it pushes: with the gradient g of the height h
/// above the bed, its curvature C (nothing for a plane) and the push P(h, g.v), the force is P g.
///
/// ```text
/// by position   g (P_h g + P_s C v)' + P C        by velocity   P_s g g'
/// ```
#[inline]
#[must_use]
pub fn push_slopes(gradient: &V3, curvature: Option<&M3>, v: &V3, push: &BedReaction) -> [M3; 2] {
    let across = outer(gradient, gradient);
    let (mut by_position, by_velocity) = (across * push.by_height, across * push.by_speed);
    if let Some(curvature) = curvature {
        by_position += outer(gradient, &(curvature * v * push.by_speed));
        by_position += curvature * push.force;
    }
    [by_position, by_velocity]
}

/// What friction needs to know of a push by a bed that curves: with the gradient g of the height h above it, its curvature C and the
/// push P(h, g.v), the force along the normal is `|g| P`.
#[inline]
#[must_use]
pub fn curved_contact(gradient: &V3, curvature: &M3, v: &V3, push: &BedReaction) -> CurvedContact {
    let (size, normal) = (gradient.norm(), gradient.normalize());
    let by_place = gradient * push.by_height + curvature * v * push.by_speed;
    CurvedContact {
        push: size * push.force,
        push_by_position: by_place * size + curvature * normal * push.force,
        push_by_velocity: gradient * (push.by_speed * size),
        normal_by_position: (M3::identity() - outer(&normal, &normal)) * curvature / size,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BED: ElasticBed = ElasticBed {
        z: -10.0,
        slope: None,
        grid: None,
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
