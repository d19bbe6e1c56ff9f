//! A body that travels along the line: a cargo hauled over a ropeway, a trolley, a crawler.
//!
//! Its arc length s(t) is prescribed, and its path X(s, t) is interpolated between the nodes (see [`path`]): `X = sum n_k(s) x_k`,
//! and loads on it act on the nodes by the same weights. Its acceleration is that of a moving mass (Frýba 1972),
//!
//! `A = sum [ n_k a_k + 2 s' n_k' v_k + (s'' n_k' + s'² n_k'') x_k ]`: that of the line under it, Coriolis acceleration,
//! acceleration along the line, and v²/R of a curved line. These are Lagrange's equations for a mass on the line, so that energy is
//! conserved. Drag acts by its own velocity, that along the line included. The impulse of a start without ramp and of a stop acts on
//! its drive and not on the line: velocities of the nodes are continuous there, and steps end there.

pub(in crate::scene) mod path;

use crate::case::Case;
use crate::numerics::{BlockBand, M3, V3};
use crate::scene::element::{At, Element};
use crate::scene::vectors::per_axis;
use crate::scene::{LumpedLine, submergence};
use crate::solve::{Factors, State};
use path::PathPoint;

/// A body that travels along the line.
#[derive(Debug, Clone, PartialEq)]
pub struct TravellingBody {
    /// Mass \[kg\].
    pub mass: f64,
    /// Weight \[N\], positive down.
    pub weight: f64,
    /// `1/2 rho C_D A` along x, y, z \[kg/m\].
    pub drag: V3,
    /// Mass of the water displaced \[kg\].
    pub displaced: f64,
    /// Unstretched arc length of its start \[m\].
    pub from: f64,
    /// Unstretched arc length of its stop \[m\].
    pub to: f64,
    /// Speed along the unstretched line \[m/s\], positive.
    pub speed: f64,
    /// Time of its start \[s\].
    pub start: f64,
    /// Duration of its acceleration \[s\].
    pub ramp: f64,
}

/// Drag on the traveller, with derivatives.
struct TravellerDrag {
    /// Drag of the submerged fraction \[N\], and its derivative by the relative velocity \[N s/m\].
    drag: V3,
    by_velocity: M3,
    /// Derivative of drag by the position, through the water \[N/m\].
    by_place: M3,
}

/// Share of a time within which it is that of a kink.
const SAME_TIME: f64 = 1e-9;

impl TravellingBody {
    /// Unstretched arc length \[m\], its rate \[m/s\] and the rate's \[m/s²\] at time t \[s\], when this many kinks of the motion
    /// are passed: at the time of a kink they say on which side of it.
    #[must_use]
    pub fn at(&self, passed: usize, t: f64) -> (f64, f64, f64) {
        let is_after = |kink: usize| {
            let time = self.next_kink(kink);
            passed > kink || t > time * (1.0 + SAME_TIME)
        };
        let is_waiting = if self.is_jerked() {
            !is_after(0)
        } else {
            t < self.start
        };
        if is_waiting {
            return (self.from, 0.0, 0.0);
        }
        if is_after(usize::from(self.is_jerked())) {
            return (self.to, 0.0, 0.0);
        }
        // A kink counts as passed a rounding before its time.
        let since = (t - self.start).max(0.0);
        let (speed, gain) = if since < self.ramp {
            let u = since / self.ramp;
            (
                self.speed * u * u * (3.0 - 2.0 * u),
                self.speed / self.ramp * 6.0 * u * (1.0 - u),
            )
        } else {
            (self.speed, 0.0)
        };
        let way = self.to - self.from;
        let gone = self.gone(since).min(way.abs());
        let sign = 1.0_f64.copysign(way);
        (self.from + sign * gone, sign * speed, sign * gain)
    }

    /// The way it has gone this long after its start, were there no stop \[m\]: its speed rises as `3 u² - 2 u³` along the ramp.
    fn gone(&self, since: f64) -> f64 {
        if since < self.ramp {
            let u = since / self.ramp;
            self.speed * self.ramp * u * u * u * (1.0 - 0.5 * u)
        } else {
            self.speed * (since - 0.5 * self.ramp)
        }
    }

    /// Whether it starts without a ramp.
    fn is_jerked(&self) -> bool {
        self.ramp == 0.0
    }

    /// Time of the kink of its motion after this many others \[s\], at which its velocity jumps: a start without ramp, and the
    /// stop. Infinite after these, and where it stays.
    #[must_use]
    pub fn next_kink(&self, passed: usize) -> f64 {
        let way = (self.to - self.from).abs();
        match passed + usize::from(!self.is_jerked()) {
            _ if way == 0.0 || self.speed == 0.0 => f64::INFINITY,
            0 => self.start,
            1 => self.start + self.time_to(way),
            _ => f64::INFINITY,
        }
    }

    /// How long it takes for a way \[s\].
    fn time_to(&self, way: f64) -> f64 {
        if way >= 0.5 * self.speed * self.ramp {
            return way / self.speed + 0.5 * self.ramp;
        }
        let (mut before, mut after) = (0.0, self.ramp);
        for _ in 0..f64::MANTISSA_DIGITS {
            let half = 0.5 * (before + after);
            if self.gone(half) < way {
                before = half;
            } else {
                after = half;
            }
        }
        after
    }
}

impl Element for TravellingBody {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        let point = self.path_point(at.line, at.t, at.state);
        let load = self.load(&point, at.line, at.state);
        for (node, by) in point.nodes() {
            r[node] += load * by.share;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.add_residual(at, r);
        let point = self.path_point(at.line, at.t, at.state);
        let drag = self.drag_at(&point, at.line, at.state);
        for (j, by) in point.nodes() {
            let carried = c.mass * by.share
                + c.damping * 2.0 * point.rate * by.slope
                + c.stiffness * (point.gain * by.slope + point.rate * point.rate * by.bend);
            let drift = c.damping * by.share + c.stiffness * point.rate * by.slope;
            let column = M3::from_diagonal_element(self.mass * carried) + drag.by_velocity * drift
                - drag.by_place * (c.stiffness * by.share);
            for (i, on) in point.nodes() {
                let block = column * on.share;
                match j as isize - i as isize {
                    0 => tangent.diag[i] += block,
                    1 => tangent.upper[i] += block,
                    -1 => tangent.lower[i] += block,
                    2 => tangent.far_upper[i] += block,
                    _ => tangent.far_lower[i] += block,
                }
            }
        }
    }

    /// Its path rounds the corners at nodes, so that it is on three of them.
    fn is_pentadiagonal(&self) -> bool {
        true
    }

    fn has_explicit_form(&self) -> bool {
        true
    }
}

impl TravellingBody {
    /// The traveller of a case.
    pub(super) fn of_case(case: &Case) -> Option<Self> {
        let (words, water) = (case.traveller.as_ref()?, &case.environment);
        let length: f64 = case.line.iter().map(|section| section.length_m).sum();
        Some(Self {
            mass: words.mass_kg,
            weight: words.wet_mass_kg * water.gravity_m_per_s2,
            drag: per_axis(&words.drag_area_m2) * (0.5 * water.water_density_kg_per_m3),
            displaced: (words.mass_kg - words.wet_mass_kg).max(0.0),
            from: words.from_m.min(length),
            to: words.to_m.unwrap_or(length).min(length),
            speed: words.speed_m_per_s,
            start: words.start_s,
            ramp: words.ramp_s,
        })
    }

    /// Its point on the path of the line at time t.
    pub(in crate::scene) fn path_point(
        &self,
        line: &LumpedLine,
        t: f64,
        state: &State,
    ) -> PathPoint {
        let at = self.at(state.memory.traveller_kinks, t);
        PathPoint::new(&line.arc[..line.line_nodes], at)
    }

    /// Kinetic and potential energy \[J\], and the power that its drive and the water put into line and traveller \[W\].
    pub(in crate::scene) fn energy(&self, at: At<'_>) -> (f64, f64) {
        let At { line, t, state } = at;
        let point = self.path_point(line, t, state);
        let (place, velocity) = (point.place(state), point.velocity(state));
        let drag = self.drag_at(&point, line, state).drag;
        let power = self
            .load(&point, line, state)
            .dot(&point.path_velocity(state))
            + drag.dot(&velocity);
        let energy = 0.5 * self.mass * velocity.norm_squared() + self.weight * place.z;
        (energy, power)
    }

    /// Its load on a prescribed end while it is on the segment there \[N\].
    pub(in crate::scene) fn force_on(&self, node: usize, at: At<'_>) -> V3 {
        let point = self.path_point(at.line, at.t, at.state);
        let on = point.nodes().filter(|(near, _)| *near == node);
        let share: f64 = on.map(|(_, by)| by.share).sum();
        if share == 0.0 {
            return V3::zeros();
        }
        self.load(&point, at.line, at.state) * -share
    }

    /// Drag on the traveller, by current, waves and its own velocity.
    fn drag_at(&self, point: &PathPoint, line: &LumpedLine, state: &State) -> TravellerDrag {
        let place = point.place(state);
        let (mut water, mut gradient) = line.current.flow(&place);
        let (mut above, mut slope) = (place.z, V3::z());
        for (node, by) in point.nodes() {
            if let Some(flow) = state.wave_flow.get(node) {
                water += flow.velocity_at(&place) * by.share;
                gradient += flow.gradient * by.share;
                above -= flow.elevation_at(&place) * by.share;
                slope -= flow.slope * by.share;
            }
        }
        let (share, steep) = match line.water.as_ref().filter(|water| water.crossed) {
            Some(water) => submergence::sphere(water.radius_of(self.displaced), above),
            None => (1.0, 0.0),
        };
        let u = water - point.velocity(state);
        let speed = u.norm();
        let direction = if speed > 0.0 { u / speed } else { V3::zeros() };
        let drag = self.drag.component_mul(&u) * speed;
        let by_velocity = (M3::from_diagonal(&(self.drag * speed))
            + self.drag.component_mul(&u) * direction.transpose())
            * share;
        TravellerDrag {
            drag: drag * share,
            by_velocity,
            by_place: by_velocity * gradient + drag * (slope * steep).transpose(),
        }
    }

    /// Its load on the line as a residual: m A and weight, less drag \[N\].
    pub(in crate::scene) fn load(&self, point: &PathPoint, line: &LumpedLine, state: &State) -> V3 {
        let drag = self.drag_at(point, line, state).drag;
        point.acceleration(state) * self.mass + V3::z() * self.weight - drag
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn traveller((from, to): (f64, f64), ramp: f64) -> TravellingBody {
        TravellingBody {
            mass: 1.0,
            weight: 1.0,
            drag: V3::zeros(),
            displaced: 0.0,
            from,
            to,
            speed: 1.5,
            start: 2.0,
            ramp,
        }
    }

    #[test]
    fn rates_are_derivatives_and_it_stays_where_it_should() {
        for (from, to) in [(3.0, 20.0), (20.0, 3.0)] {
            let traveller = traveller((from, to), 3.0);
            for t in [1.0, 2.5, 4.9, 5.1, 9.0] {
                let h = 1e-5;
                let (before, now, after) = (
                    traveller.at(0, t - h),
                    traveller.at(0, t),
                    traveller.at(0, t + h),
                );
                assert!(((after.0 - before.0) / (2.0 * h) - now.1).abs() < 1e-8);
                assert!(((after.1 - before.1) / (2.0 * h) - now.2).abs() < 1e-4);
            }
            assert_eq!(traveller.at(1, 100.0), (to, 0.0, 0.0));
            assert_eq!(traveller.at(0, 0.0), (from, 0.0, 0.0));
        }
    }

    #[test]
    fn its_velocity_jumps_at_its_kinks_and_nowhere_else() {
        let speed_at = |one: &TravellingBody, passed, t| one.at(passed, t).1;
        let jerked = traveller((3.0, 18.0), 0.0);
        assert_eq!(
            [0, 1, 2].map(|n| jerked.next_kink(n)),
            [2.0, 12.0, f64::INFINITY]
        );
        assert_eq!([0, 1].map(|n| speed_at(&jerked, n, 2.0)), [0.0, 1.5]);
        assert_eq!(jerked.at(1, 2.0_f64.next_down()), (3.0, 1.5, 0.0));
        assert_eq!([1, 2].map(|n| speed_at(&jerked, n, 12.0)), [1.5, 0.0]);
        assert_eq!([1, 2].map(|n| jerked.at(n, 12.0).0), [18.0, 18.0]);
        // With a ramp it has one: where it stops, on the ramp or after it.
        for (way, ramp) in [(15.0, 3.0), (1.0, 3.0)] {
            let one = traveller((3.0, 3.0 + way), ramp);
            let stop = one.next_kink(0);
            assert_eq!(one.next_kink(1), f64::INFINITY);
            assert!((one.at(0, stop).0 - one.to).abs() < 1e-12);
            assert!(speed_at(&one, 0, stop) > 0.5);
            assert_eq!(one.at(1, stop), (one.to, 0.0, 0.0));
            // A time well after it needs no counting.
            assert_eq!(one.at(0, stop + 1e-3), (one.to, 0.0, 0.0));
        }
        assert_eq!(traveller((3.0, 3.0), 1.0).next_kink(0), f64::INFINITY);
    }
}
