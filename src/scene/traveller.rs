//! A body that travels along the line: a cargo hauled over a ropeway, a trolley, a crawler.
//!
//! Its place along the line s(t) is prescribed, and its path X(s, t) is that of the nodes (see [`seat`]): it lies at
//! `X = sum n_k(s) x_k`, and what acts on it goes to them by the same shares. Its acceleration is that of a moving mass (Frýba
//! 1972),
//!
//! `A = sum [ n_k a_k + 2 s' n_k' v_k + (s'' n_k' + s'² n_k'') x_k ]`: that of the line under it, Coriolis's, what it gains along
//! the line, and v²/R where the line bends. These are Lagrange's equations for a mass on the line, so that energy is
//! kept. Drag acts by its own velocity, that along the line included; where it comes and goes all at once, at a start without
//! ramp and at the end of its way, what holds it takes the blow and not the line.

mod path;

use super::{Scene, submergence};
use crate::numerics::{BlockBand, M3, V3};
use crate::solve::{Factors, Kinematics, State};
use path::PathPoint;

/// A body that travels along the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Traveller {
    /// Mass \[kg\].
    pub mass: f64,
    /// Weight \[N\], positive down.
    pub weight: f64,
    /// `1/2 rho C_D A` along x, y, z \[kg/m\].
    pub drag: V3,
    /// Mass of the water displaced \[kg\].
    pub displaced: f64,
    /// Unstretched arc length at which it begins \[m\].
    pub from: f64,
    /// Unstretched arc length at which it stays \[m\].
    pub to: f64,
    /// Speed along the unstretched line \[m/s\], positive.
    pub speed: f64,
    /// Time at which it sets out \[s\].
    pub start: f64,
    /// Time in which it comes to its speed \[s\].
    pub ramp: f64,
}

/// The water past the traveller.
struct Drag {
    /// Its drag \[N\], as far as it is wet, and that by the velocity of the water past it \[N s/m\].
    drag: V3,
    by_velocity: M3,
    /// How drag changes with its place, the velocity past it aside from its own \[N/m\].
    by_place: M3,
}

impl Traveller {
    /// Unstretched arc length \[m\], its rate \[m/s\] and the rate's \[m/s²\] at time t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> (f64, f64, f64) {
        let way = self.to - self.from;
        let since = t - self.start;
        if since <= 0.0 {
            return (self.from, 0.0, 0.0);
        }
        let (gone, speed, gain) = if since < self.ramp {
            // The speed rises as 3 u² - 2 u³.
            let u = since / self.ramp;
            (
                self.speed * self.ramp * u * u * u * (1.0 - 0.5 * u),
                self.speed * u * u * (3.0 - 2.0 * u),
                self.speed / self.ramp * 6.0 * u * (1.0 - u),
            )
        } else {
            (self.speed * (since - 0.5 * self.ramp), self.speed, 0.0)
        };
        if gone >= way.abs() {
            return (self.to, 0.0, 0.0);
        }
        let sign = 1.0_f64.copysign(way);
        (self.from + sign * gone, sign * speed, sign * gain)
    }
}

impl Scene {
    /// Where the traveller sits at time t.
    fn path_point(&self, traveller: &Traveller, t: f64) -> PathPoint {
        PathPoint::new(&self.arc[..self.line_nodes()], traveller.at(t))
    }

    /// Unstretched arc length of the traveller at time t \[m\]; absent: there is none.
    #[must_use]
    pub fn traveller_arc(&self, t: f64) -> Option<f64> {
        self.traveller.as_ref().map(|traveller| traveller.at(t).0)
    }

    /// Position \[m\] and velocity \[m/s\] of the traveller at time t; absent: there is none.
    #[must_use]
    pub fn traveller_at(&self, t: f64, state: &State) -> Option<(V3, V3)> {
        let point = self.path_point(self.traveller.as_ref()?, t);
        Some((point.place(state), point.velocity(state)))
    }

    /// Tension of the segment that the traveller is on \[N\]; absent: there is none.
    #[must_use]
    pub fn traveller_tension(&self, t: f64, state: &State) -> Option<f64> {
        let point = self.path_point(self.traveller.as_ref()?, t);
        let chord = self.chord(point.segment, state);
        Some(self.pull(point.segment, &chord, t, state).value)
    }

    /// Kinetic and potential energy of the traveller \[J\], and the power that its drive and the water past it put into line
    /// and traveller \[W\].
    #[must_use]
    pub fn traveller_energy(&self, t: f64, state: &State) -> Option<(f64, f64)> {
        let traveller = self.traveller.as_ref()?;
        let point = self.path_point(traveller, t);
        let (place, velocity) = (point.place(state), point.velocity(state));
        let drag = self.drag_at(traveller, &point, state).drag;
        let power = self
            .load(traveller, &point, state)
            .dot(&point.path_velocity(state))
            + drag.dot(&velocity);
        let energy = 0.5 * traveller.mass * velocity.norm_squared() + traveller.weight * place.z;
        Some((energy, power))
    }

    /// What the traveller adds to the pull on a held end while it is on the segment there \[N\].
    #[must_use]
    pub fn traveller_force_on(&self, node: usize, t: f64, state: &State) -> V3 {
        let Some(traveller) = &self.traveller else {
            return V3::zeros();
        };
        let point = self.path_point(traveller, t);
        let share: f64 = point
            .nodes()
            .filter(|(near, _)| *near == node)
            .map(|(_, by)| by.share)
            .sum();
        if share == 0.0 {
            return V3::zeros();
        }
        self.load(traveller, &point, state) * -share
    }

    /// Drag on the traveller, by current, waves and its own velocity.
    fn drag_at(&self, traveller: &Traveller, point: &PathPoint, state: &State) -> Drag {
        let place = point.place(state);
        let (mut water, shear) = self.current.at(place.z);
        let mut gradient = shear * V3::z().transpose();
        let (mut above, mut slope) = (place.z, V3::z());
        for (node, by) in point.nodes() {
            if let Some(flow) = state.wave_flow.get(node) {
                water += flow.velocity_at(&place) * by.share;
                gradient += flow.gradient * by.share;
                above -= flow.elevation_at(&place) * by.share;
                slope -= flow.slope * by.share;
            }
        }
        let (share, steep) = match self.water.as_ref().filter(|water| water.crossed) {
            Some(water) => submergence::sphere(water.radius_of(traveller.displaced), above),
            None => (1.0, 0.0),
        };
        let u = water - point.velocity(state);
        let speed = u.norm();
        let direction = if speed > 0.0 { u / speed } else { V3::zeros() };
        let drag = traveller.drag.component_mul(&u) * speed;
        let by_velocity = (M3::from_diagonal(&(traveller.drag * speed))
            + traveller.drag.component_mul(&u) * direction.transpose())
            * share;
        Drag {
            drag: drag * share,
            by_velocity,
            by_place: by_velocity * gradient + drag * (slope * steep).transpose(),
        }
    }

    /// What the traveller asks of the line at a seat, as a residual: m A and the weight, which pulls down, less drag \[N\].
    fn load(&self, traveller: &Traveller, point: &PathPoint, state: &State) -> V3 {
        let drag = self.drag_at(traveller, point, state).drag;
        point.acceleration(state) * traveller.mass + V3::z() * traveller.weight - drag
    }

    /// Adds what the traveller asks of the line to the residual.
    pub(super) fn add_traveller(&self, t: f64, state: &State, r: &mut [V3]) {
        if let Some(traveller) = &self.traveller {
            let point = self.path_point(traveller, t);
            let load = self.load(traveller, &point, state);
            for (node, by) in point.nodes() {
                r[node] += load * by.share;
            }
        }
    }

    /// Adds the derivatives of that; those of nodes two apart go to the far blocks.
    pub(super) fn add_traveller_tangent(
        &self,
        t: f64,
        state: &State,
        c: Factors,
        tangent: &mut BlockBand,
    ) {
        let Some(traveller) = &self.traveller else {
            return;
        };
        let point = self.path_point(traveller, t);
        let past = self.drag_at(traveller, &point, state);
        for (j, by) in point.nodes() {
            let carried = c.mass * by.share
                + c.damping * 2.0 * point.rate * by.slope
                + c.stiffness * (point.gain * by.slope + point.rate * point.rate * by.bend);
            let drift = c.damping * by.share + c.stiffness * point.rate * by.slope;
            let column = M3::from_diagonal_element(traveller.mass * carried)
                + past.by_velocity * drift
                - past.by_place * (c.stiffness * by.share);
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

    /// Corrects the accelerations that the line would have without the traveller: its mass couples the nodes beside it.
    pub(super) fn accelerate_traveller(&self, t: f64, state: &mut State) {
        let Some(traveller) = &self.traveller else {
            return;
        };
        let point = self.path_point(traveller, t);
        let held = |node: usize| !self.free().contains(&node);
        let mut give = M3::zeros();
        for (node, by) in point.nodes().filter(|(node, _)| !held(*node)) {
            give += self.inverse_mass(node, state) * (by.share * by.share);
        }
        let system = M3::identity() + give * traveller.mass;
        let Some(load) = system.lu().solve(&self.load(traveller, &point, state)) else {
            return;
        };
        for (node, by) in point.nodes().filter(|(node, _)| !held(*node)) {
            let push = load * by.share;
            // What hangs there and turns is pushed as well.
            if let Some(rigid_payload) =
                self.rigid_payload.as_ref().filter(|body| body.node == node)
            {
                let far = rigid_payload.inverse_mass(self, state)[1];
                state.a[node + 1] -= far * push;
            }
            let near = self.inverse_mass(node, state);
            state.a[node] -= near * push;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_derivatives_and_it_stays_where_it_should() {
        for (from, to) in [(3.0, 20.0), (20.0, 3.0)] {
            let traveller = Traveller {
                mass: 1.0,
                weight: 1.0,
                drag: V3::zeros(),
                displaced: 0.0,
                from,
                to,
                speed: 1.5,
                start: 2.0,
                ramp: 3.0,
            };
            for t in [1.0, 2.5, 4.9, 5.1, 9.0] {
                let h = 1e-5;
                let (before, now, after) =
                    (traveller.at(t - h), traveller.at(t), traveller.at(t + h));
                assert!(((after.0 - before.0) / (2.0 * h) - now.1).abs() < 1e-8);
                assert!(((after.1 - before.1) / (2.0 * h) - now.2).abs() < 1e-4);
            }
            assert_eq!(traveller.at(100.0), (to, 0.0, 0.0));
            assert_eq!(traveller.at(0.0), (from, 0.0, 0.0));
        }
    }
}
